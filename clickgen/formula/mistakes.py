"""The syntax errors that people make, each with examples that the tests replay: each must be told by its own entry."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from clickgen.formula.words import ALL_FUNCTIONS

Situation = Literal["value", "operator", "index"]
"""What lark would have taken: a value; an operator or the end of a value; the rest of an address in brackets."""

Place = Literal["found", "before", "open"]
"""Where the problem is shown: at what was found, at what comes before it, at the bracket that is still open."""


@dataclass(frozen=True, slots=True)
class Mistake:
    """One kind of syntax error. Its texts may speak of ``{found}`` and ``{before}``."""

    situation: Situation
    found: tuple[str, ...]
    """Terminals, ``$END`` for the end; none for any."""
    message: str
    help: str
    examples: tuple[str, ...]
    place: Place = "found"
    before: str = ""
    """A pattern for what comes before; empty for anything."""
    touching: bool = False
    """True if nothing may come between the two."""


@dataclass(frozen=True, slots=True)
class Spelling:
    """A sign of another language; ``operator`` is CLICK's own for it, if there is one."""

    message: str
    examples: tuple[str, ...]
    operator: str = ""
    help: str = ""


_STORE = "write the calculation alone: its result goes to the destination of the instruction"
_COMPARE = "a comparison is a condition of the rung, and has no place in a calculation"

SPELLINGS: dict[str, Spelling] = {
    "**": Spelling("`**` is Python", ("ds.A ** 2",), "^"),
    "//": Spelling("`//` is Python", ("ds.A // 2",), "/"),
    "%": Spelling("`%` is Python", ("ds.A % 2",), "MOD"),
    "&&": Spelling("`&&` is not known here", ("dh.A && dh.B",), "AND"),
    "&": Spelling("`&` is Python", ("dh.A & 0x00FF",), "AND"),
    "||": Spelling("`||` is not known here", ("dh.A || dh.B",), "OR"),
    "|": Spelling("`|` is Python", ("dh.A | 1",), "OR"),
    "~": Spelling("`~` is Python", ("~dh.A", "dh.A + ~dh.B"), "NOT"),
    "<<": Spelling("`<<` is Python", ("dh.A << 2",), "SHL"),
    ">>": Spelling("`>>` is Python", ("dh.A >> 2",), "SHR"),
    "==": Spelling("a formula does not compare", ("ds.A == 2",), help=_COMPARE),
    "!=": Spelling("a formula does not compare", ("ds.A != 2",), help=_COMPARE),
    "<>": Spelling("a formula does not compare", ("ds.A <> 2",), help=_COMPARE),
    "<=": Spelling("a formula does not compare", ("ds.A <= 2",), help=_COMPARE),
    ">=": Spelling("a formula does not compare", ("ds.A >= 2",), help=_COMPARE),
    "<": Spelling("a formula does not compare", ("ds.A < 2",), help=_COMPARE),
    ">": Spelling("a formula does not compare", ("ds.A > 2",), help=_COMPARE),
    ":=": Spelling("a formula does not assign", ("ds.A := 2",), help=_STORE),
    "=": Spelling("a formula does not assign", ("ds.A = ds.B + 1", "= ds.B"), help=_STORE),
    "!": Spelling("`!` is not known here", ("!dh.A",), "NOT"),
    "{": Spelling("formulas have round parentheses only", ("{ds.A + 1}",), help="write ( and )"),
    "}": Spelling("formulas have round parentheses only", ("ds.A}",), help="write ( and )"),
    '"': Spelling("this quote is never closed", ('ds["My Name] + 1',), help='write ds["My Name"]'),
    "'": Spelling("this quote is never closed", ("ds['My Name] + 1",), help='write ds["My Name"]'),
    "#": Spelling("`#` has no place in a formula", ("ds.A # twice", "16#FF"), help="hexadecimal is 0x00FF or 00FFh"),
    "$": Spelling("`$` has no place in a formula", ("$00FF",), help="hexadecimal is 0x00FF or 00FFh"),
    "\N{MULTIPLICATION SIGN}": Spelling("this sign is not known here", ("ds.A \N{MULTIPLICATION SIGN} 2",), "*"),
    "\N{DIVISION SIGN}": Spelling("this sign is not known here", ("ds.A \N{DIVISION SIGN} 2",), "/"),
    "\N{MINUS SIGN}": Spelling("this sign is not known here", ("ds.A \N{MINUS SIGN} 2",), "-"),
    "\N{EN DASH}": Spelling("this sign is not known here", ("ds.A \N{EN DASH} 2",), "-"),
    "\N{SUPERSCRIPT TWO}": Spelling("a power is written out", ("ds.A + 2\N{SUPERSCRIPT TWO}",), "^"),
    "\N{SQUARE ROOT}": Spelling("a square root is written out", ("\N{SQUARE ROOT}ds.A",), help="write SQRT(x)"),
}
"""By the sign as written; the longest that fits at the place of the error applies."""

_BINARY = ("STAR", "SLASH", "CARET", "MOD", "AND", "OR", "XOR", "SHIFT")
_VALUES = ("WORD", "NUMBER", "HEX", "STRING", "LPAR", "NOT")
_OPERATOR_BEFORE = r"[-+*/^]|(?i:MOD|AND|OR|XOR|NOT|SH[LR]|[LR]SH|LRO|RRO)"
_SHIFT_BEFORE = r"(?i:SH[LR]|[LR]SH|LRO|RRO)"
_FUNCTION_BEFORE = rf"(?i:{'|'.join(sorted(ALL_FUNCTIONS))})"

MISTAKES: tuple[Mistake, ...] = (
    # -- where a value should be
    Mistake(
        "value", ("$END",), "the formula is empty", 'write what to calculate: "ds.Speed * 2"', ("", "  "), before="$"
    ),
    Mistake(
        "value",
        ("$END", "RPAR", "RSQB"),
        "something is missing after `{before}`",
        "an address, a number or an opening parenthesis follows an operator",
        ("ds.A +", "(ds.A * ) + 1", "dh.A AND", "-", "NOT", "dh.A shl", "2 ^"),
        "before",
        before=_OPERATOR_BEFORE,
    ),
    Mistake(
        "value",
        ("$END",),
        "this parenthesis is never closed",
        "close it with `)`",
        ("(", "SIN(", "ds.A + (", "LSH(dh.A,"),
        "open",
    ),
    Mistake(
        "value",
        ("RPAR",),
        "there is nothing between the parentheses",
        "write a value there, or take them away",
        ("()", "SIN()", "ds.A + ()"),
        before=r"\(",
    ),
    Mistake(
        "value", ("RPAR",), "something is missing after `{before}`", "write LSH(x, n)", ("LSH(dh.A, )",), before=","
    ),
    Mistake(
        "value",
        ("RPAR", "RSQB"),
        "nothing was opened for this to close",
        "take it away, or open one before",
        (") + 1", "] + 1", "(]"),
    ),
    Mistake(
        "value",
        (*_BINARY,),
        "`{found}` cannot follow `{before}`",
        "write one operator between two values",
        ("ds.A + * ds.B", "ds.A * / 2", "dh.A AND OR dh.B", "ds.A MOD MOD 2", "2 ^ * 2"),
        before=_OPERATOR_BEFORE,
    ),
    Mistake(
        "value",
        (*_BINARY,),
        "`{found}` has no value on its left",
        "it goes between two values: x {found} y",
        ("* ds.A", "AND dh.A", "MOD(ds.A, 2)", "(/ 2)", "^ 2", "XOR(dh.A, dh.B)", "OR"),
    ),
    Mistake("value", ("MEMBER",), "`{found}` lacks its bank", "write ds{found}", (".A", "ds.A + .B")),
    Mistake(
        "value", ("LSQB",), "`[` lacks its bank", "write ds[5]; parentheses are round", ("[5]", "ds.A * [ds.B + 1]")
    ),
    Mistake("value", ("COMMA",), "there is nothing before the comma", "write LSH(x, n)", ("LSH(, 2)", ", 2")),
    Mistake("value", ("COLON",), "a colon has no place here", "a range is written SUM(ds[1:11])", (": 5", "SUM(:)")),
    Mistake("value", (), "`{found}` has no place here", "a formula needs a value here", ()),
    # -- after a value
    Mistake(
        "operator",
        (),
        "`{before}` lacks its values",
        "write LSH(x, n), or x LSH n between two values",
        ("SHL dh.A", "ds.A + (shr", "LRO", "LSH, 2"),
        "before",
        before=_SHIFT_BEFORE,
    ),
    Mistake(
        "operator",
        ("$END",),
        "this parenthesis is never closed",
        "close it with `)`",
        ("(ds.A + 1", "SIN(ds.A", "LSH(dh.A, 2", "((ds.A)", "SQRT((ds.A + 1) * 2"),
        "open",
    ),
    Mistake(
        "operator",
        ("RPAR", "RSQB"),
        "nothing was opened for this to close",
        "take it away, or open one before",
        ("ds.A)", "(ds.A + 1)) * 2", "ds.A]", "(ds.A]", "SIN(ds.A))"),
    ),
    Mistake(
        "operator",
        ("WORD", "NUMBER", "HEX", "STRING", "NOT"),
        "{before} lacks its value in parentheses",
        "write {before}(x)",
        ("SQRT ds.A", "sin 5", "LOG ds[5] + 1", "2 * ln pi"),
        "before",
        before=_FUNCTION_BEFORE,
    ),
    Mistake(
        "operator",
        ("WORD", "NUMBER"),
        "an operator is missing before `{found}`",
        'write one of + - * / between two values; a nickname with spaces is written ds["Any name"]',
        ("ds.My Name", "ds.A ds.B", "ds.A 2"),
        before=r"[^\W\d]\w*\.\w+",
    ),
    Mistake(
        "operator",
        ("WORD",),
        "`{before}{found}` is not a number",
        "write 1000 without separators, hexadecimal as 0x00FF or 00FFh, and an operator between two values",
        ("1_000", "0xFFh", "0xZZ", "2ds.A", "12AB + 1"),
        before=r"[0-9.]+",
        touching=True,
    ),
    Mistake(
        "operator",
        _VALUES,
        "an operator is missing before `{found}`",
        "write one of + - * / between two values",
        (
            "2 3",
            "2 ds.A",
            "(ds.A)(ds.B)",
            "(ds.A) 5",
            "ds[5] ds[6]",
            "dh.A NOT dh.B",
            "2 (ds.A)",
            "5h 5h",
            "ds.A (2)",
            'ds.A "x"',
        ),
    ),
    Mistake(
        "operator",
        ("MEMBER",),
        "nothing can follow the address here",
        "write one nickname after one bank: ds.Name",
        ("ds.A.B", "ds[1].B", "(ds.A).B", "x[1].immediate", "1.5.A"),
    ),
    Mistake(
        "operator",
        ("LSQB",),
        "`[` has no place here",
        "write ds[5]; parentheses are round",
        ("5[1]", "ds.A[1][2]", "(ds.A)[2]"),
    ),
    Mistake(
        "operator",
        ("COMMA",),
        "a comma has no place here",
        "fractions have a point: 1.5; arguments a comma: LSH(x, 2)",
        ("1,5 + 2", "ds.A, ds.B", "(1,5)", "SIN((1,5))"),
    ),
    Mistake(
        "operator",
        ("COLON",),
        "a colon has no place here",
        "a range is written SUM(ds[1:11]), which is DS1 to DS10",
        ("SUM(DS1:DS10)", "ds.A : ds.B", "1:2", "SUM ( DS301 : DS350 )"),
    ),
    Mistake("operator", (), "`{found}` has no place here", "an operator or the end of the formula comes here", ()),
    # -- in brackets
    Mistake(
        "index",
        ("$END", "RPAR"),
        "this bracket is never closed",
        "close it with `]`",
        ("ds[5", "ds[", "ds[1:", "ds[1:2", 'ds["A"', "ds[ds.A", "ds[5)", "SUM(ds[1:5)", "ds[ds[5]", "ds[-", "ds[ds"),
        "open",
    ),
    Mistake("index", ("RSQB",), "there is nothing between the brackets", "write ds[5]", ("ds[]",), before=r"\["),
    Mistake(
        "index",
        ("WORD",),
        "`{before}{found}` is not a number",
        'the word XD0u is written xd["0u"]',
        ("xd[0u]", "ds[5a]"),
        before=r"[0-9]+",
        touching=True,
    ),
    Mistake(
        "index",
        (),
        "`{found}` has no place in brackets",
        "write ds[5], ds.Name or ds[ds.Pointer]",
        ("ds[5 6]", "ds[NOT 1]", "ds[1:2:3:4]", "ds[5h 2]", 'ds["a" "b"]', "ds[A +"),
    ),
)
"""In order; the first that fits applies."""
