"""What a line means that Python cannot read: signs and words of other languages, and slips, each with its way out.

The table is looked at only when Python's parser has failed, and only at the line where it failed. Every pattern takes
time in proportion to the line.
"""

from __future__ import annotations

import ast
import keyword
import re
from collections.abc import Callable
from fractions import Fraction
from typing import NamedTuple

from clickgen.diagnostics import Diagnostics, Edit, Fix
from clickgen.instructions import INSTRUCTIONS
from clickgen.instructions.durations import in_units
from clickgen.source import SourceFile, Span
from clickgen.syntax.calls import fits_action
from clickgen.syntax.conditions import as_condition, condition_fault
from clickgen.syntax.context import Context
from clickgen.syntax.hints import BANK_NAMES, bit_of_word
from clickgen.syntax.misplaced import way_out
from clickgen.trade import ACTIONS, UNITS, advice, bank_hint

_LINE_MAX = 2000
"""A longer line is left to Python's own message."""


class Told(NamedTuple):
    """What is wrong with a line and the way out. ``at`` is the stretch of the line that is marked, from 0."""

    message: str
    help: str
    at: tuple[int, int]
    edits: tuple[tuple[int, int, str], ...] = ()
    """Stretches of the line and the text for each: a fix, where the meaning is certain."""


class Line(NamedTuple):
    """A line, and the same with blanks for its comment and for what stands in quotes."""

    text: str
    code: str
    plain: str
    """The line with blanks for what stands in quotes alone."""
    context: Context
    fault: str
    """What Python says."""


class Slip(NamedTuple):
    """One kind of slip: a pattern for the code of the line, and what to say."""

    pattern: re.Pattern[str]
    tell: Callable[[Line, re.Match[str]], Told | None]
    examples: tuple[str, ...]
    with_comment: bool = False
    """True for a pattern that a # belongs to."""


def slip(source: SourceFile, number: int, fault: str) -> tuple[str, Span, str, Fix | None] | None:
    """The message, place, way out and fix for the line where Python failed; None where nothing is known of it."""
    text = source.line(number)
    if len(text) > _LINE_MAX:
        return None
    line = Line(
        text, _blanked(text, True), _blanked(text, False), Context(SourceFile(source.path, text), Diagnostics()), fault
    )
    for kind in SLIPS:
        match = kind.pattern.search(line.plain if kind.with_comment else line.code)
        told = kind.tell(line, match) if match else None
        if told is None:
            continue
        start, end = told.at
        span = Span(source.path, number, start + 1, number, max(end, start + 1) + 1)
        edits = tuple(Edit(Span(source.path, number, a + 1, number, b + 1), new) for a, b, new in told.edits)
        return told.message, span, told.help, Fix(edits) if edits else None
    return None


_QUOTED = re.compile(r"""("(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*')|(#.*)""")


def _blanked(text: str, with_comment: bool) -> str:
    """The line with blanks in the place of what stands between quotes, and of its comment."""

    def blank(found: re.Match[str]) -> str:
        if found[1]:
            return f'"{" " * (len(found[0]) - 2)}"'
        return " " * len(found[0]) if with_comment else found[0]

    return _QUOTED.sub(blank, text)


# -- conditions -------------------------------------------------------------------------------------------------------

_HEAD = re.compile(r"\s*(?:if|elif|while)\b\s*", re.IGNORECASE)


def _condition(line: Line, text: str) -> str:
    """``write if all(...):`` for the text of an if without its slip; what is wrong with it then, or ""."""
    expression = text.strip().rstrip(":;").strip()
    try:
        node = ast.parse(expression, mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return ""
    context = Context(SourceFile(line.context.source.path, expression), Diagnostics())
    written = as_condition(context, node)
    if written:
        return f"write if {written}:"
    fault = condition_fault(context, expression)
    return fault.help if fault else ""


def _without(line: Line, edits: list[tuple[int, int, str]]) -> str:
    """The text of the line after these edits."""
    parts, done = [], 0
    for start, end, new in edits:
        parts += [line.text[done:start], new]
        done = end
    return "".join([*parts, line.text[done:]])


def _after_head(text: str) -> str:
    head = _HEAD.match(text)
    rest = text[head.end() :] if head else ""
    comment = re.search(r":\s*#", rest)
    return rest[: comment.start() + 1] if comment else rest


_LOGIC = re.compile(r"&&|\|\||\b(?:AND|OR|NOT|And|Or|Not)\b|!(?!=)")
_PYTHON = {"&&": "and", "||": "or", "!": "not"}


def _logic(line: Line, match: re.Match[str]) -> Told:
    """``AND``, ``&&``, ``!``: read as and, or, not, which are rewritten as all, any, nc."""
    edits: list[tuple[int, int, str]] = []
    for found in _LOGIC.finditer(line.code):
        word = _PYTHON.get(found[0], found[0].lower())
        before = line.code[: found.start()][-1:]
        after = line.code[found.end() :][:1]
        spaced = (" " if before and not before.isspace() and before != "(" else "") + word
        spaced += "" if after.isspace() else " "
        edits.append((*found.span(), spaced))
    help = _condition(line, _after_head(_without(line, edits)))
    general = "in series write all(c.A, c.B), in parallel any(c.A, c.B), for the opposite nc(c.A)"
    return Told(f"{match[0]} is not part of the language", help or general, match.span(), tuple(edits))


def _signs(*pairs: tuple[str, str]) -> Callable[[Line, re.Match[str]], Told]:
    """Signs of comparison that other languages have."""
    table = dict(pairs)

    def tell(line: Line, match: re.Match[str]) -> Told:
        sign = table[match[0]]
        edit = (*match.span(), sign)
        help = _condition(line, _after_head(_without(line, [edit])))
        return Told(f"{match[0]} is no comparison here", help or f"write {sign}", match.span(), (edit,))

    return tell


def _equals(line: Line, match: re.Match[str]) -> Told | None:
    """``if ds.A = 5:``"""
    start = match.start("sign")
    if _depth(line.code[:start]) > 0 and not re.search(r"\w\[|\(\s*$", line.code[:start]):
        return None
    edit = (start, match.end("sign"), "==")
    help = _condition(line, _after_head(_without(line, [edit])))
    return Told("a comparison is written with two equals signs", help or "write ==", edit[:2], (edit,))


def _then(line: Line, match: re.Match[str]) -> Told:
    start = match.start("word")
    edit = (len(line.code[:start].rstrip()), match.end("word"), ":")
    help = _condition(line, _after_head(line.text[:start]))
    is_last = not line.code[match.end("word") :].strip(" ;")
    edits = (edit,) if is_last and not line.code[:start].rstrip().endswith(":") else ()
    return Told("an if ends with a colon, not with then", help or "write if c.A:", match.span("word"), edits)


def _elif(_: Line, match: re.Match[str]) -> Told:
    """``else if``: elif in Python; that a rung has none is told when it can be read."""
    help = "a rung has no else: write another rung with the opposite condition in series, if all(nc(c.A), c.B):"
    return Told(
        f"{' '.join(match['word'].split())} is not part of the language",
        help,
        match.span("word"),
        ((*match.span("word"), "elif"),),
    )


def _capitals(line: Line, match: re.Match[str]) -> Told | None:
    word = match["word"]
    if word == word.lower():
        return None
    edit = (*match.span("word"), word.lower())
    shown = _without(line, [edit]).strip()
    return Told(f"{word.lower()} is written in small letters", f"write {shown}", match.span("word"), (edit,))


def _no_colon(line: Line, match: re.Match[str]) -> Told | None:
    code = line.code.rstrip()
    if code.endswith(("\\", ",")) or _depth(code) != 0 or ":" in re.sub(r"\[[^\[\]]*\]|lambda[^:]*:", "", code):
        return None
    is_semicolon = code.endswith(";")
    edit = (len(code) - is_semicolon, len(code), ":")
    shown = line.text[: edit[0]].strip()
    if match["word"] in ("if", "elif", "while"):
        help = _condition(line, _after_head(line.text[: edit[0]])) or f"write {shown}:"
    else:
        help = "write def main():" if match["word"] == "def" and "(" not in code else f"write {shown}:"
    edits = () if match["word"] == "def" and "(" not in code else (edit,)
    return Told("the colon at the end of the line is missing", help, (edit[0], edit[0] + 1), edits)


def _series(line: Line, match: re.Match[str]) -> Told | None:
    """``if c.A, c.B:``"""
    try:
        node = ast.parse(_after_head(line.text).strip().rstrip(":"), mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None
    if not isinstance(node, ast.Tuple):
        return None
    decimal = re.search(r"\b(\d+),(\d+)\b", line.code)
    if decimal:
        return Told("decimals are written with a point", f"write {decimal[1]}.{decimal[2]}", decimal.span())
    text = f"all({', '.join(ast.unparse(one) for one in node.elts)})"
    help = _condition(line, text) or "in series write all(c.A, c.B), in parallel any(c.A, c.B)"
    return Told("a comma joins no conditions", help, match.span("sign"))


def _depth(code: str) -> int:
    return sum(code.count(sign) for sign in "([{") - sum(code.count(sign) for sign in ")]}")


# -- addresses --------------------------------------------------------------------------------------------------------

_BANK = rf"\b(?P<bank>{'|'.join(sorted(BANK_NAMES, key=len, reverse=True))})"


def _dotted(_: Line, match: re.Match[str]) -> Told:
    """``x.1``"""
    bank, number = BANK_NAMES[match["bank"]], int(match["number"])
    text = f"{bank.dsl}[{number if bank.has(number) else bank.first}]"
    edits = ((*match.span(), text),) if bank.has(number) else ()
    return Told("a number stands in brackets", f"write {text}", match.span(), edits)


def _bit(line: Line, match: re.Match[str]) -> Told | None:
    """``ds[1].3`` and ``ds.A.3``"""
    bank = BANK_NAMES[match["bank"]]
    word = line.text[match.start("bank") : match.end("index")]
    if bank.is_bit:
        return Told("an address has no bits", f"write {word}", match.span())
    return Told("CLICK has no bits of words", bit_of_word(word, bank, int(match["number"])), match.span())


def _quoted_name(_: Line, match: re.Match[str]) -> Told | None:
    """``c.1st``, ``c.My Name``, ``c.if``: nicknames that are no word of Python's."""
    words = match["name"].split()
    if len(words) > 1 and (keyword.iskeyword(words[1]) or words[1].lower() in _WORDS):
        return None
    text = f'{match["bank"]}["{match["name"]}"]'
    is_word = len(words) == 1
    return Told(
        "a nickname that is no plain word stands in quotes",
        f"write {text}",
        match.span(),
        ((*match.span(), text),) if is_word else (),
    )


_WORDS = frozenset(("and", "or", "not", "then", "xor", "nand", "nor", "is", "in", "if", "else", "do", "mod"))


def _zeros(line: Line, match: re.Match[str]) -> Told:
    number = match["number"]
    bank = re.search(r"(\w+\[)\s*$", line.code[: match.start()])
    shown = f"{bank[1]}{number}]" if bank else number
    return Told("a number begins with no 0", f"write {shown}", match.span("zeros"), ((*match.span("zeros"), ""),))


def _range(_: Line, match: re.Match[str]) -> Told:
    first, last = int(match["first"]), int(match["last"])
    text = f"{match['bank']}[{first}:{last + 1}]"
    return Told("a range has a colon, and its end is not included", f"write {text}", match.span())


def _foreign(_: Line, match: re.Match[str]) -> Told | None:
    """Addresses of other machines: ``%I0.1``, ``N7:0``, ``I:0/1``."""
    letter, size = match["letter"].upper(), (match["size"] or "").upper()
    word = {"W": {"I": "iw", "Q": "qw", "M": "n"}, "D": {"M": "dint"}}.get(size, {}).get(letter, letter)
    help = bank_hint({"T": "tim", "C": "cnt", "R": "cr", "S": "sp"}.get(word, word))
    return Told("this is an address of another machine", help, match.span()) if help else None


# -- numbers ----------------------------------------------------------------------------------------------------------


def _hex(line: Line, match: re.Match[str]) -> Told:
    two = match["two"]
    number = int((two or match["digits"]).replace("_", "") or "0", 2 if two else 16)
    is_word = re.search(r"\b(?:dh|xd|yd|math_hex)\b", line.code) is not None
    help = f"write 0x{number:04X}" if is_word else f"write {number}, or 0x{number:04X} beside a word in DH"
    return Told("a hexadecimal number begins with 0x", help, match.span())


def _time(_: Line, match: re.Match[str]) -> Told | None:
    unit = UNITS.get(match["unit"].lower())
    help = in_units(Fraction(match["number"]), unit) if unit else ""
    return Told("a time is a whole number and its unit", help, match.span()) if help else None


# -- actions ----------------------------------------------------------------------------------------------------------


def _assigned(line: Line, match: re.Match[str]) -> Told | None:
    """``ds.A := 5;``"""
    if _HEAD.match(line.text):
        return _equals_sign(line, match)
    text = f"{line.text[: match.start()].strip()} = {line.text[match.end() :].strip().rstrip(';')}"
    try:
        (node,) = ast.parse(text).body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return Told(":= is not part of the language", "to store a value write copy(5, ds.A)", match.span())
    help = way_out(Context(SourceFile(line.context.source.path, text), Diagnostics()), node).help
    return Told(":= is not part of the language", help, match.span(), ((*match.span(), "="),))


def _equals_sign(line: Line, match: re.Match[str]) -> Told:
    edit = (*match.span(), "==")
    help = _condition(line, _after_head(_without(line, [edit])))
    return Told("a comparison is written with two equals signs", help or "write ==", match.span(), (edit,))


def _counted(line: Line, match: re.Match[str]) -> Told:
    target = line.text[match.start("target") : match.end("target")].strip()
    quote = "'" if '"' in target else '"'
    text = f"calc({quote}{target} {match['sign'][0]} 1{quote}, {target})"
    help = text if fits_action(line.context, text) else 'calc("ds.A + 1", ds.A)'
    return Told(f"{match['sign']} is not part of the language", f"write {help}", match.span("sign"))


def _bare_call(line: Line, match: re.Match[str]) -> Told | None:
    """``out y[1]``"""
    name, argument = match["name"].lower(), line.text[match.start("argument") : match.end("argument")].strip(" ;")
    found = advice(name, ACTIONS)
    text = f"{name}({argument})" if name in INSTRUCTIONS else (found.written([argument]) if found else "")
    if name not in INSTRUCTIONS and found is None:
        return None
    if not text or not fits_action(line.context, text):
        text = INSTRUCTIONS[name].example if name in INSTRUCTIONS else found.code[0] if found and found.code else ""
    return Told("an instruction has its arguments in parentheses", f"write {text}", match.span("name"))


def _arrow(_: Line, match: re.Match[str]) -> Told:
    return Told("an arrow stores nothing here", "the target is the last argument: copy(5, ds.A)", match.span())


def _says(message: str, help: str, group: str = "") -> Callable[[Line, re.Match[str]], Told]:
    def tell(_: Line, match: re.Match[str]) -> Told:
        return Told(message, help, match.span(group) if group else match.span())

    return tell


# -- signs ------------------------------------------------------------------------------------------------------------

_SIGNS = {
    "\N{LEFT DOUBLE QUOTATION MARK}": '"',
    "\N{RIGHT DOUBLE QUOTATION MARK}": '"',
    "\N{DOUBLE LOW-9 QUOTATION MARK}": '"',
    "\N{LEFT-POINTING DOUBLE ANGLE QUOTATION MARK}": '"',
    "\N{RIGHT-POINTING DOUBLE ANGLE QUOTATION MARK}": '"',
    "\N{LEFT SINGLE QUOTATION MARK}": "'",
    "\N{RIGHT SINGLE QUOTATION MARK}": "'",
    "\N{SINGLE LOW-9 QUOTATION MARK}": "'",
    "\N{GREATER-THAN OR EQUAL TO}": ">=",
    "\N{LESS-THAN OR EQUAL TO}": "<=",
    "\N{NOT EQUAL TO}": "!=",
    "\N{MINUS SIGN}": "-",
    "\N{EN DASH}": "-",
    "\N{EM DASH}": "-",
    "\N{NO-BREAK SPACE}": " ",
    "\N{ZERO WIDTH SPACE}": "",
    "\N{ZERO WIDTH NO-BREAK SPACE}": "",
    "\N{FULLWIDTH LEFT PARENTHESIS}": "(",
    "\N{FULLWIDTH RIGHT PARENTHESIS}": ")",
    "\N{FULLWIDTH COMMA}": ",",
    "\N{FULLWIDTH COLON}": ":",
    "\N{FULLWIDTH EQUALS SIGN}": "=",
}
"""Signs that word processors and web pages put in, and the plain ones."""
_SIGN = re.compile(f"[{''.join(_SIGNS)}]")


def _typographic(line: Line, match: re.Match[str]) -> Told:
    edits = tuple((*found.span(), _SIGNS[found[0]]) for found in _SIGN.finditer(line.code))
    plain = _SIGNS[match[0]]
    what = "quotes" if plain in ('"', "'") else "a blank" if not plain.strip() else plain
    message = "these quotes come from a word processor" if what == "quotes" else f"this sign is not {plain or 'needed'}"
    if what == "a blank":
        message = "this blank comes from a word processor"
    return Told(
        message, f"write straight quotes, {plain}" if what == "quotes" else f"write {what}", match.span(), edits
    )


def _comment(line: Line, match: re.Match[str]) -> Told:
    edits: tuple[tuple[int, int, str], ...] = ()
    if match["sign"] == "//" and _depth(line.code[: match.start("sign")]) == 0:
        edits = ((*match.span("sign"), "#"),)
    shown = line.text[match.end("sign") :].strip().removesuffix("*/").removesuffix("*)").strip()
    return Told("a comment begins with #", f"write # {shown}".rstrip(), match.span("sign"), edits)


def _old_comment(line: Line, match: re.Match[str]) -> Told | None:
    """A comment that begins with --, ;, ' or REM."""
    if match["sign"] == "'" and "unterminated" not in line.fault:
        return None
    return Told("a comment begins with #", "write # at its beginning", match.span("sign"))


def _second_half(_: Line, match: re.Match[str]) -> Told:
    help = "a rung has no else: write another rung with the opposite condition, if nc(c.A):"
    return Told("else stands on a line of its own, and a rung has none", help, match.span("word"))


def _semicolon(line: Line, match: re.Match[str]) -> Told:
    edit = (*match.span("sign"), ",")
    text = _without(line, [edit]).strip().rstrip(";")
    is_right = fits_action(line.context, text)
    help = f"write {text}" if is_right else "write copy(5, ds.A)"
    return Told("arguments are separated by commas", help, match.span("sign"), (edit,) if is_right else ())


def _re(pattern: str, flags: int = 0) -> re.Pattern[str]:
    return re.compile(pattern, flags)


_ENDS = r"end\s*_?if|end\s*_?while|end\s*_?for|end\s*_?var|end\s*_?program|end\s*_?sub|next\s+\w+|wend|begin|done"
_START = r"IF|If|ELIF|Elif|ELSE|Else|DEF|Def|FOR|For|WHILE|While|RETURN|Return|PASS|Pass|IMPORT|Import|FROM|From"

SLIPS: tuple[Slip, ...] = (
    Slip(_SIGN, _typographic, ("if “A”:", "if ds.A ≥ 5:", "if c.A – c.B:")),
    Slip(
        _re(r"^(?:<{7}|={7}|>{7})(?:\s|$)"),
        _says("this is the mark of a merge conflict", "keep one of the two versions, and take the marks away"),
        ("<<<<<<< HEAD", "=======", ">>>>>>> branch"),
    ),
    Slip(
        _re(r"(?:^|\s|;)(?P<sign>//)|(?P<other>/\*|\(\*|^\s*\*/)"),
        lambda line, match: (
            _comment(line, match)
            if match["sign"]
            else Told(
                "a comment begins with #", "write # at the beginning of each line of a comment", match.span("other")
            )
        ),
        ("// comment", "out(y[1])  // the motor is on", "/* comment */", "(* comment *)"),
    ),
    Slip(
        _re(r"^\s*(?P<sign>--|;|'|REM\b|rem\b|%(?!\s*[IQMiqm]))"),
        _old_comment,
        ("-- comment here", "; comment", "' comment", "REM comment"),
        with_comment=True,
    ),
    # Addresses and numbers of other machines
    Slip(
        _re(r"%(?P<letter>[IQMiqm])(?P<size>[XBWDLxbwdl]?)\d+(?:\.\d+)?"),
        _foreign,
        ("if %I0.1:", "copy(%MW10, ds.A)", "if %QX0.0:"),
    ),
    Slip(
        _re(r"(?<![\w.\])])(?P<letter>[IOBNFTCSRiobnftcsr])\d{0,3}:\d+(?:[./]\w+)?(?P<size>)"),
        _foreign,
        ("if I:0/1:", "if N7:0 > 5:", "if T4:0.DN:", "if B3:0/1:"),
    ),
    Slip(_re(r"\b(?P<letter>[IQMiqm])(?P<size>[XBWDxbwd]?)\d+\.\d+\b"), _foreign, ("if I0.1:", "if M10.3:")),
    Slip(
        _re(r"\b16#(?P<digits>[0-9A-Fa-f_]{1,9})\b|\b2#(?P<two>[01_]{1,32})\b"),
        _hex,
        ("if dh.A == 16#FF:", "copy(16#00FF, dh.A)", "copy(2#1010, dh.A)"),
        with_comment=True,
    ),
    Slip(
        _re(r"(?:\$|&[Hh]|(?<=[(,=])\s?#)(?P<digits>[0-9A-Fa-f]{1,8})\b(?P<two>)"),
        _hex,
        ("if dh.A == $FF:", "copy(&HFF, dh.A)", "copy(#FF, dh.A)"),
        with_comment=True,
    ),
    Slip(
        _re(r"(?<![\w.#\"'])(?P<digits>[0-9][0-9A-Fa-f]{0,7})[hH]\b(?P<two>)"),
        _hex,
        ("if dh.A == 0FFh:", "copy(00FFh, dh.A)"),
    ),
    Slip(
        _re(r"\b(?:T|TIME|t|time)#(?P<number>[0-9]{1,9}(?:\.[0-9]{1,9})?)(?P<unit>[A-Za-z]{1,12})"),
        _time,
        ("ton(t.A, T#5s)",),
        with_comment=True,
    ),
    Slip(
        _re(r"(?<![\w.])(?P<number>[0-9]{1,9}(?:\.[0-9]{1,9})?)(?P<unit>[A-Za-z]{1,12})\b"),
        _time,
        ("ton(t.A, 5s)", "ton(t.A, setpoint=500ms)", "ton(t.A, 5.5s)"),
    ),
    Slip(_re(r"(?P<zeros>(?<![\w.])0+)(?P<number>[1-9][0-9]*)\b(?!\.)"), _zeros, ("if x[001]:", "if x[01]:")),
    Slip(
        _re(rf"{_BANK}\[\s*(?P<first>[0-9]{{1,6}})\s*\.\.\.?\s*(?P<last>[0-9]{{1,6}})\s*\]"),
        _range,
        ("if x[1..4]:",),
    ),
    Slip(
        _re(rf"{_BANK}\[(?P<first>[0-9]{{1,6}})\]\s*\.\.\.?\s*(?P=bank)\[(?P<last>[0-9]{{1,6}})\]"),
        _range,
        ("if x[1]..x[2]:",),
    ),
    Slip(_re(rf"{_BANK}\.(?P<number>[0-9]{{1,6}})\b(?!\.)"), _dotted, ("if x.1:", 'copy("a", txt.1)')),
    Slip(
        _re(rf"{_BANK}(?P<index>\[[^\[\]]{{0,60}}\]|\.[A-Za-z_]\w{{0,60}})\.(?P<number>[0-9]{{1,4}})\b"),
        _bit,
        ("if ds[1].3:", "if ds.A.3:", "if xd[0].3:"),
    ),
    Slip(
        _re(rf"{_BANK}\.(?P<name>[0-9]\w{{0,30}}|(?:{'|'.join(keyword.kwlist)})\b)"),
        _quoted_name,
        ("if c.1st:", "if c.if:"),
    ),
    Slip(
        _re(rf"{_BANK}\.(?P<name>[A-Za-z_]\w{{0,30}} [A-Za-z0-9_]\w{{0,30}})\b(?!\s*[(=])"),
        _quoted_name,
        ("if c.My Name:",),
    ),
    Slip(
        _re(rf"{_BANK}\{{"),
        lambda _, match: Told("an address has square brackets", f"write {match['bank']}[1]", match.span()),
        ("if x{1}:",),
    ),
    # Conditions
    Slip(
        _re(r"^\s*(?P<word>else\s+if|elseif|elsif|elseif|ELSE\s+IF|ELSEIF|ELSIF|ELIF|Else\s+If|ElseIf|Elseif)\b"),
        _elif,
        ("elseif c.B:", "else if c.B:", "ELSIF c.B THEN"),
    ),
    Slip(_re(rf"^\s*(?P<word>{_START})\b"), _capitals, ("If c.A:", "ELSE:", "DEF main():", "IF c.A THEN")),
    Slip(_re(r"\b(?P<word>then|THEN|Then|do|DO)\b\s*[:;]?\s*$"), _then, ("if c.A then", "if c.A then:")),
    Slip(
        _re(r"\b(?P<word>xor|XOR|Xor|nand|NAND|nor|NOR)\b"),
        _says(
            "CLICK has no such contact", "write any(all(c.A, nc(c.B)), all(nc(c.A), c.B)) for one of two, but not both"
        ),
        ("if c.A xor c.B:",),
    ),
    Slip(
        _re(r"=>|=<|<>|===|!=="),
        _signs(("=>", ">="), ("=<", "<="), ("<>", "!="), ("===", "=="), ("!==", "!=")),
        (
            "if ds.A => 5:",
            "if ds.A =< 5:",
            "if ds.A <> 5:",
            "if ds.A === 5:",
        ),
    ),
    Slip(_re(r":="), _assigned, ("ds.A := 5", "if ds.A := 5:", "c.A := TRUE;")),
    Slip(_LOGIC, _logic, ("if x[1] AND x[2]:", "if x[1] && x[2]:", "if x[1]||x[2]:", "if !x[1]:", "if NOT x[1]:")),
    Slip(_re(r"^\s*(?:if|elif|while)\b.*?[^=!<>:+*/%&|^-](?P<sign>=)(?!=)"), _equals, ("if x[1] = 1:", "if ds.A = 5:")),
    Slip(
        _re(r"^\s*(?:search)\s*\([^()=,]{0,80}[^=!<>](?P<sign>=)(?!=)[^()]*"), _equals, ("search(ds[1:5] = 5, ds.A)",)
    ),
    Slip(
        _re(r"\blambda(?P<gap>\s+)(?=[a-z]+[\[(.])"),
        lambda _, match: Told(
            "lambda has a colon",
            "write lambda: in front of the condition",
            match.span(),
            ((match.start("gap"), match.end("gap"), ": "),),
        ),
        ("rton(t.A, 5, reset=lambda x[2])",),
    ),
    Slip(
        _re(r"(?P<word>\b(?:and|or|not)|==|!=|<=|>=|<|>)\s*:?\s*$"),
        lambda _, match: Told(
            f"something is missing after {match['word']}", "a condition or a value follows it", match.span("word")
        ),
        ("if c.A and:", "if x[1] == :"),
    ),
    Slip(_re(r"^\s*if\b.*?(?P<sign>,)"), _series, ("if c.A, c.B:", "if ds.A == 1,5:")),
    Slip(
        _re(r"^\s*(?P<name>[A-Za-z_]\w*)\{"),
        lambda _, match: (
            Told("an instruction has round parentheses", f"write {INSTRUCTIONS[match['name']].example}", match.span())
            if match["name"] in INSTRUCTIONS
            else None
        ),
        ("ton{t.A, 5}",),
    ),
    Slip(
        _re(r":\s.*\S\s+(?P<word>else|elif)\b.*:"),
        _second_half,
        ("if c.A: out(y[1]) else: out(y[2])",),
    ),
    # Blocks
    Slip(
        _re(r"[{}]\s*;?\s*$"),
        _says("braces make no block here", "end the line of the if with a colon, and indent what stands under it"),
        ("if c.A {", "}"),
    ),
    Slip(
        _re(rf"^\s*(?P<word>{_ENDS})\b", re.IGNORECASE),
        _says("a block has no closing word", "it ends where its lines stop being indented: leave this out", "word"),
        ("end if", "END_IF;", "end_if x"),
    ),
    Slip(
        _re(r"^\s*(?P<word>VAR\w*|PROGRAM|FUNCTION\w*|SUB|function|void|int|bool|var|let|const)\b(?=\s)"),
        _says(
            "declarations of other languages are not read",
            "the rungs stand in def main():, and a name gets its address with nickname(x.Start, x[1])",
            "word",
        ),
        ("PROGRAM main", "var a;", "int main"),
    ),
    Slip(
        _re(
            r"^\s*(?P<word>LD[NIPF]?|STR[N]?|ANDN?|ORN?|ANI|ORI|ANB|ORB|MPS|MRD|MPP|OUT|SET|RST|TON|CTU|ST)\s+[%A-Za-z_]"
        ),
        _says(
            "an instruction list is no program here",
            "a rung is an if with its actions under it: if x[1]: out(y[1])",
            "word",
        ),
        ("LD X1", "OUT Y1", "STR X1"),
    ),
    Slip(
        _re(r"^\s*(?P<word>main\s*\(\s*\)\s*:)"),
        _says("a routine begins with def", "write def main():", "word"),
        ("main():",),
    ),
    Slip(
        _re(r"^\s*(?P<word>if|elif|else|def|for|while|with)\b"), _no_colon, ("if c.A", "def main()", "else", "if c.A;")
    ),
    # Actions
    Slip(
        _re(r"(?P<target>[A-Za-z_]\w*(?:\.\w+|\[[^\[\]]{0,60}\]))\s*(?P<sign>\+\+|--)"),
        _counted,
        ("ds.A++", "ds[1]--"),
    ),
    Slip(_re(r"->|\N{RIGHTWARDS ARROW}"), _arrow, ("copy(5 -> ds.A)", "5 → ds.A")),
    Slip(
        _re(r"[\])]\s+(?P<second>[A-Za-z_]\w*\s*\()"),
        _says("there are two actions on one line", "write each action on a line of its own", "second"),
        ("out(y[1]) out(y[2])",),
    ),
    Slip(
        _re(r"^\s*(?P<name>[A-Za-z_]\w*)\s+(?P<argument>[A-Za-z_\"][^=]*)$"),
        _bare_call,
        ("out y[1]", "call fill", "set y[1]"),
    ),
    Slip(
        _re(r"\((?:[^()]|\([^()]*\))*?(?P<sign>;)"),
        _semicolon,
        ("ton(t.A; 5)", "copy(5; ds.A)"),
    ),
    Slip(
        _re(r"\b(?P<name>[a-z_]+)\s*(?P<sign>:|(?<= ))\s*[0-9]+\s*[,)]"),
        lambda _, match: (
            Told(
                "an argument is given by its name and =",
                f"write {match['name']}=5" if match["name"] in _ARGUMENTS else "write setpoint=5",
                match.span("name"),
            )
            if match["name"] in _ARGUMENTS
            else None
        ),
        ("ton(t.A, setpoint:5)", "ton(t.A, setpoint 5)"),
    ),
)
"""In order; the first that knows the line tells."""

_ARGUMENTS = frozenset(param.name for spec in INSTRUCTIONS.values() for param in spec.params)


# -- what Python says -------------------------------------------------------------------------------------------------

FAULTS: tuple[tuple[str, str, str], ...] = (
    (
        "inconsistent use of tabs",
        "tabs and spaces are mixed",
        "indent with four spaces; an editor can turn tabs into spaces",
    ),
    (
        "unindent does not match",
        "this line is indented like none above it",
        "indent the lines of one block alike, by four spaces",
    ),
    ("unexpected indent", "this line is indented and stands under nothing", "begin it where the line above begins"),
    (
        "expected an indented block",
        "nothing is indented under the line above",
        "indent what belongs to it by four spaces; pass alone makes a rung that does nothing",
    ),
    ("was never closed", "this bracket is never closed", "close it in this line or in one below"),
    ("unmatched", "nothing was opened for this bracket to close", "take it away, or open one before it"),
    ("does not match opening", "this bracket closes one of another kind", "close ( with ), [ with ] and { with }"),
    ("unterminated string", "this quote is never closed", "close it in the same line"),
    ("unterminated triple-quoted", "this text is never closed", 'close it with """'),
    ("keyword argument repeated", "an argument is given twice", "give each argument once"),
    ("positional argument follows", "an argument without a name follows one with a name", "give this one its name too"),
    ("Perhaps you forgot a comma", "a comma is missing here", "separate arguments and conditions by commas"),
)
"""What Python's parser says, and the same in words that help."""


def said_otherwise(fault: str) -> tuple[str, str] | None:
    """A message and a way out for what Python's parser says; None for what says too little."""
    return next(((message, help) for start, message, help in FAULTS if start in fault), None)
