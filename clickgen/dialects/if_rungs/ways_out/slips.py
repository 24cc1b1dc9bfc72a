"""The meaning of a line that Python cannot read: signs and words of other languages, and slips, each with its way out.

The table is used only if Python's parser has failed, and only for the line where it failed. Every pattern takes
time in proportion to the line.
"""

from __future__ import annotations

import keyword
import re
from collections.abc import Callable
from typing import NamedTuple

from clickgen.dialects.if_rungs.ways_out import slip_actions as actions
from clickgen.dialects.if_rungs.ways_out import slip_addresses as addresses
from clickgen.dialects.if_rungs.ways_out import slip_conditions as conditions
from clickgen.dialects.if_rungs.ways_out import slip_signs as signs
from clickgen.dialects.if_rungs.ways_out import slip_words as words
from clickgen.dialects.if_rungs.ways_out.slip_line import Line, Told, line_of, says
from clickgen.instructions import INSTRUCTIONS, of_instructions
from clickgen.text.edits import Edit, Fix
from clickgen.text.source import SourceFile, Span

_LINE_MAX = 2000
"""A longer line is left to Python's own message."""


class Slip(NamedTuple):
    """One kind of slip: a pattern for the code of the line, and what to say."""

    pattern: re.Pattern[str]
    tell: Callable[[Line, re.Match[str]], Told | None]
    examples: tuple[str, ...]
    with_comment: bool = False
    """True for a pattern that includes a #."""


def slip(source: SourceFile, number: int, fault: str) -> tuple[str, Span, str, Fix | None] | None:
    """The message, place, way out and fix for the line where Python failed; None if nothing is known of it."""
    if len(source.line(number)) > _LINE_MAX:
        return None
    line = line_of(source, number, fault)
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


def _re(pattern: str, flags: int = 0) -> re.Pattern[str]:
    return re.compile(pattern, flags)


_ENDS = r"end\s*_?if|end\s*_?while|end\s*_?for|end\s*_?var|end\s*_?program|end\s*_?sub|next\s+\w+|wend|begin|done"
_START = r"IF|If|ELIF|Elif|ELSE|Else|DEF|Def|FOR|For|WHILE|While|RETURN|Return|PASS|Pass|IMPORT|Import|FROM|From"


@of_instructions
def _arguments() -> frozenset[str]:
    return frozenset(param.name for spec in INSTRUCTIONS.values() for param in spec.params)


SLIPS: tuple[Slip, ...] = (
    Slip(
        signs.SIGN,
        signs.typographic,
        ("if \N{LEFT DOUBLE QUOTATION MARK}A:", "if ds.A \N{GREATER-THAN OR EQUAL TO} 5:", "if c.A \N{EN DASH} c.B:"),
    ),
    Slip(
        _re(r"^(?:<{7}|={7}|>{7})(?:\s|$)"),
        says("this is the mark of a merge conflict", "keep one of the two versions, and take the marks away"),
        ("<<<<<<< HEAD", "=======", ">>>>>>> branch"),
    ),
    Slip(words.ACTED, words.acted, ("out(y[1]) if x[1]", "if x[1] then out(y[1])", "x[1] -> out(y[1])")),
    Slip(words.BETWEEN, words.between, ("if ds.A between 1 and 5:", "if ds.A not between 1 and 5 and x[1]:")),
    Slip(words.COMPARED, words.compared, ("if ds.A greater than 5:", "if ds.A is at least 5:", "if ds.A equals 5:")),
    Slip(words.STATE, words.state, ("if x[1] on:", "if x[1] is off and x[2] on:")),
    Slip(words.HALF, words.half, ("if ds.A > 5 and < 10:",)),
    Slip(words.LISTED, words.listed, ("if ds.A in 1, 2, 3:",)),
    Slip(words.HEAD, words.missing_word, ("if x[1] x[2]:", "if nc(x[1]) c.A:", "if c.A c.B:")),
    Slip(
        _re(r"(?:^|\s|;)(?P<sign>//)|(?P<other>/\*|\(\*|^\s*\*/)"),
        lambda line, match: (
            signs.comment(line, match)
            if match["sign"]
            else Told(
                "a comment begins with #", "write # at the beginning of each line of a comment", match.span("other")
            )
        ),
        ("// comment", "out(y[1])  // the motor is on", "/* comment */", "(* comment *)"),
    ),
    Slip(
        _re(r"^\s*(?P<sign>--|;|'|REM\b|rem\b|%(?!\s*[IQMiqm]))"),
        signs.old_comment,
        ("-- comment here", "; comment", "' comment", "REM comment"),
        with_comment=True,
    ),
    # Addresses and numbers of other machines
    Slip(
        _re(r"%(?P<letter>[IQMiqm])(?P<size>[XBWDLxbwdl]?)\d+(?:\.\d+)?"),
        addresses.foreign,
        ("if %I0.1:", "copy(%MW10, ds.A)", "if %QX0.0:"),
    ),
    Slip(
        _re(r"(?<![\w.\])])(?P<letter>[IOBNFTCSRiobnftcsr])\d{0,3}:\d+(?:[./]\w+)?(?P<size>)"),
        addresses.foreign,
        ("if I:0/1:", "if N7:0 > 5:", "if T4:0.DN:", "if B3:0/1:"),
    ),
    Slip(_re(r"\b(?P<letter>[IQMiqm])(?P<size>[XBWDxbwd]?)\d+\.\d+\b"), addresses.foreign, ("if I0.1:", "if M10.3:")),
    Slip(
        _re(r"\b16#(?P<digits>[0-9A-Fa-f_]{1,9})\b|\b2#(?P<two>[01_]{1,32})\b"),
        addresses.hexadecimal,
        ("if dh.A == 16#FF:", "copy(16#00FF, dh.A)", "copy(2#1010, dh.A)"),
        with_comment=True,
    ),
    Slip(
        _re(r"(?:\$|&[Hh]|(?<=[(,=])\s?#)(?P<digits>[0-9A-Fa-f]{1,8})\b(?P<two>)"),
        addresses.hexadecimal,
        ("if dh.A == $FF:", "copy(&HFF, dh.A)", "copy(#FF, dh.A)"),
        with_comment=True,
    ),
    Slip(
        _re(r"(?<![\w.#\"'])(?P<digits>[0-9][0-9A-Fa-f]{0,7})[hH]\b(?P<two>)"),
        addresses.hexadecimal,
        ("if dh.A == 0FFh:", "copy(00FFh, dh.A)"),
    ),
    Slip(
        _re(r"\b(?:T|TIME|t|time)#(?P<number>[0-9]{1,9}(?:\.[0-9]{1,9})?)(?P<unit>[A-Za-z]{1,12})"),
        addresses.duration,
        ("ton(t.A, T#5s)",),
        with_comment=True,
    ),
    Slip(
        _re(r"(?<![\w.])(?P<number>[0-9]{1,9}(?:\.[0-9]{1,9})?)(?P<unit>[A-Za-z]{1,12})\b"),
        addresses.duration,
        ("ton(t.A, 5s)", "ton(t.A, setpoint=500ms)", "ton(t.A, 5.5s)"),
    ),
    Slip(_re(r"(?P<zeros>(?<![\w.])0+)(?P<number>[1-9][0-9]*)\b(?!\.)"), addresses.zeros, ("if x[001]:", "if x[01]:")),
    Slip(
        _re(rf"{addresses.BANK}\[\s*(?P<first>[0-9]{{1,6}})\s*\.\.\.?\s*(?P<last>[0-9]{{1,6}})\s*\]"),
        addresses.dotted_range,
        ("if x[1..4]:",),
    ),
    Slip(
        _re(rf"{addresses.BANK}\[(?P<first>[0-9]{{1,6}})\]\s*\.\.\.?\s*(?P=bank)\[(?P<last>[0-9]{{1,6}})\]"),
        addresses.dotted_range,
        ("if x[1]..x[2]:",),
    ),
    Slip(
        _re(rf"{addresses.BANK}\.(?P<number>[0-9]{{1,6}})\b(?!\.)"), addresses.dotted, ("if x.1:", 'copy("a", txt.1)')
    ),
    Slip(
        _re(rf"{addresses.BANK}(?P<index>\[[^\[\]]{{0,60}}\]|\.[A-Za-z_]\w{{0,60}})\.(?P<number>[0-9]{{1,4}})\b"),
        addresses.bit_of,
        ("if ds[1].3:", "if ds.A.3:", "if xd[0].3:"),
    ),
    Slip(
        _re(rf"{addresses.BANK}\.(?P<name>[0-9]\w{{0,30}}|(?:{'|'.join(keyword.kwlist)})\b)"),
        addresses.quoted_name,
        ("if c.1st:", "if c.if:"),
    ),
    Slip(
        _re(r"^\s*(?P<name>[A-Za-z_]\w*)\s*(?P<open>\(|\s)(?=.*[\w\])\"']\s+[\w\"'-])"),
        actions.missing_comma,
        ("copy(5 ds.A)", "copy(ds.A ds.B)", "ton(t.A 5)", "copy 5 ds.A", "copy ds.A ds.B", "out(y[1] oneshot=True)"),
    ),
    Slip(
        _re(r"^\s*(?P<name>out|set|reset)\s*\((?P<address>[^=()]{1,120}?)\s*(?P<sign>:?=)\s*(?P<value>\w{1,8})\s*\)"),
        actions.coil_value,
        ("out(y[1] = True)", "set(c.A = 0)"),
    ),
    Slip(
        _re(rf"{addresses.BANK}\.(?P<name>[A-Za-z_]\w{{0,30}} [A-Za-z0-9_]\w{{0,30}})\b(?!\s*[(=.\[])"),
        addresses.quoted_name,
        ("if c.My Name:",),
    ),
    Slip(
        _re(rf"{addresses.BANK}\{{"),
        lambda _, match: Told("an address has square brackets", f"write {match['bank']}[1]", match.span()),
        ("if x{1}:",),
    ),
    # Conditions
    Slip(
        _re(r"^\s*(?P<word>else\s+if|elseif|elsif|elseif|ELSE\s+IF|ELSEIF|ELSIF|ELIF|Else\s+If|ElseIf|Elseif)\b"),
        conditions.else_if,
        ("elseif c.B:", "else if c.B:", "ELSIF c.B THEN"),
    ),
    Slip(_re(rf"^\s*(?P<word>{_START})\b"), conditions.capitals, ("If c.A:", "ELSE:", "DEF main():", "IF c.A THEN")),
    Slip(
        _re(r"\b(?P<word>then|THEN|Then|do|DO)\b\s*(?:[:;]\s*)?$"),
        conditions.then_word,
        ("if c.A then", "if c.A then:"),
    ),
    Slip(
        _re(r"\b(?P<word>xor|XOR|Xor)\b"),
        says(
            "CLICK has no such contact", "write any(all(c.A, nc(c.B)), all(nc(c.A), c.B)) for one of two, but not both"
        ),
        ("if c.A xor c.B:",),
    ),
    Slip(
        _re(r"\b(?P<word>nand|NAND|Nand)\b"),
        says("CLICK has no such contact", "write any(nc(c.A), nc(c.B)) for not both"),
        ("if c.A nand c.B:",),
    ),
    Slip(
        _re(r"\b(?P<word>nor|NOR|Nor)\b"),
        says("CLICK has no such contact", "write all(nc(c.A), nc(c.B)) for none of them"),
        ("if c.A nor c.B:",),
    ),
    Slip(
        _re(r"=>|=<|<>|===|!=="),
        conditions.comparison(("=>", ">="), ("=<", "<="), ("<>", "!="), ("===", "=="), ("!==", "!=")),
        (
            "if ds.A => 5:",
            "if ds.A =< 5:",
            "if ds.A <> 5:",
            "if ds.A === 5:",
        ),
    ),
    Slip(_re(r":="), actions.assigned, ("ds.A := 5", "if ds.A := 5:", "c.A := TRUE;")),
    Slip(
        conditions.LOGIC,
        conditions.logic,
        ("if x[1] AND x[2]:", "if x[1] && x[2]:", "if x[1]||x[2]:", "if !x[1]:", "if NOT x[1]:"),
    ),
    Slip(
        _re(r"^\s*(?:if|elif|while)\b.*?[^=!<>:+*/%&|^-](?P<sign>=)(?!=)"),
        conditions.equals,
        ("if x[1] = 1:", "if ds.A = 5:"),
    ),
    Slip(
        _re(r"^\s*(?:search)\s*\([^()=,]{0,80}[^=!<>](?P<sign>=)(?!=)[^()]*"),
        conditions.equals,
        ("search(ds[1:5] = 5, ds.A)",),
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
        _re(r"(?P<word>\b(?:and|or|not)|==|!=|<=|>=|<|>)\s*(?::\s*)?$"),
        lambda _, match: Told(
            f"something is missing after {match['word']}", "a condition or a value follows it", match.span("word")
        ),
        ("if c.A and:", "if x[1] == :"),
    ),
    Slip(_re(r"^\s*if\b.*?(?P<sign>,)"), conditions.comma, ("if c.A, c.B:", "if ds.A == 1,5:")),
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
        _re(r"^[^:]*:\s.*?\S\s(?P<word>else|elif)\b"),
        signs.second_half,
        ("if c.A: out(y[1]) else: out(y[2])",),
    ),
    # Blocks
    Slip(
        _re(r"[{}]\s*(?:;\s*)?$"),
        says("braces make no block here", "end the line of the if with a colon, and indent what is under it"),
        ("if c.A {", "}"),
    ),
    Slip(
        _re(rf"^\s*(?P<word>{_ENDS})\b", re.IGNORECASE),
        says("a block has no closing word", "it ends where its lines stop being indented: leave this out", "word"),
        ("end if", "END_IF;", "end_if x"),
    ),
    Slip(
        _re(r"^\s*(?P<word>VAR\w*|PROGRAM|FUNCTION\w*|SUB|function|void|int|bool|var|let|const)\b(?=\s)"),
        says(
            "declarations of other languages are not read",
            "the rungs belong in def main():, and a name gets its address with nickname(x.Start, x[1])",
            "word",
        ),
        ("PROGRAM main", "var a;", "int main"),
    ),
    Slip(
        _re(
            r"^\s*(?P<word>LD[NIPF]?|LDNOT|STR(?:N|PD|ND)?|AND(?:N|P|F|PD|ND|NOT)?|OR(?:N|P|F|PD|ND|NOT)?|ANI|ORI|ANB|ORB"
            r"|X?NOR|XORN?|MPS|MRD|MPP|OUT|SET|RST|TON|CTU|ST|A|AN|O|ON|X|XN|FP|FN|S|R)\s+[%A-Za-z_]"
        ),
        says(
            "an instruction list is no program here",
            "a rung is an if with its actions under it: if x[1]: out(y[1])",
            "word",
        ),
        ("LD X1", "OUT Y1", "STR X1"),
    ),
    Slip(
        _re(r"^\s*(?P<word>main\s*\(\s*\)\s*:)"),
        says("a routine begins with def", "write def main():", "word"),
        ("main():",),
    ),
    Slip(
        _re(r"^\s*(?P<word>if|elif|else|def|for|while|with)\b"),
        conditions.no_colon,
        ("if c.A", "def main()", "else", "if c.A;"),
    ),
    # Actions
    Slip(
        _re(r"\b(?P<target>[A-Za-z_]\w*(?:\.\w+|\[[^\[\]]{0,60}\]))\s*(?P<sign>\+\+|--)"),
        actions.counted,
        ("ds.A++", "ds[1]--"),
    ),
    Slip(_re(r"->|\N{RIGHTWARDS ARROW}"), actions.arrow, ("copy(5 -> ds.A)", "5 → ds.A")),
    Slip(
        _re(r"[\])]\s+(?P<second>[A-Za-z_]\w*\s*\()"),
        says("there are two actions on one line", "write each action on a line of its own", "second"),
        ("out(y[1]) out(y[2])",),
    ),
    Slip(
        _re(r"^\s*(?P<name>[A-Za-z_]\w*)\s+(?P<argument>[A-Za-z_\"'0-9-][^=]*)$"),
        actions.bare_call,
        ("out y[1]", "call fill", "set y[1]", "copy 5, ds.A", "copy -1, ds.A"),
    ),
    Slip(
        _re(r"\(.*;"),
        signs.semicolon,
        ("ton(t.A; 5)", "copy(5; ds.A)"),
    ),
    Slip(
        _re(r"\b(?P<name>[a-z_]+)\s*(?P<sign>:|(?<= ))\s*[0-9]+\s*[,)]"),
        lambda _, match: (
            Told(
                "an argument is given by its name and =",
                f"write {match['name']}=5" if match["name"] in _arguments() else "write setpoint=5",
                match.span("name"),
            )
            if match["name"] in _arguments()
            else None
        ),
        ("ton(t.A, setpoint:5)", "ton(t.A, setpoint 5)"),
    ),
)
"""In order; the first that knows the line applies."""

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
    ("unexpected indent", "this line is indented but belongs to nothing", "begin it where the line above begins"),
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
"""The messages of Python's parser, and the same in words that help."""


def said_otherwise(fault: str) -> tuple[str, str] | None:
    """A message and a way out for a message of Python's parser; None for one that says too little."""
    return next(((message, help) for start, message, help in FAULTS if start in fault), None)
