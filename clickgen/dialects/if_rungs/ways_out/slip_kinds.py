"""What is told of each kind of slip, with the line as the person meant it."""

from __future__ import annotations

import keyword
import re
from collections.abc import Callable
from fractions import Fraction
from itertools import accumulate
from typing import NamedTuple

import libcst as cst

from clickgen.device.elsewhere import UNITS
from clickgen.dialects.if_rungs.read.calls import fits_action
from clickgen.dialects.if_rungs.read.conditions import as_condition, condition_fault
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.nodes import elements
from clickgen.dialects.if_rungs.trade import ACTIONS, advice, bank_hint
from clickgen.dialects.if_rungs.ways_out.hints import bit_of_word
from clickgen.dialects.if_rungs.ways_out.misplaced import STATES, way_out
from clickgen.instructions import INSTRUCTIONS
from clickgen.instructions.durations import in_units
from clickgen.ir.addresses import BANK_NAMES

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


# -- conditions -------------------------------------------------------------------------------------------------------

_HEAD = re.compile(r"\s*(?:if|elif|while)\b\s*", re.IGNORECASE)


def condition_of(line: Line, text: str) -> str:
    """``write if all(...):`` for the text of an if without its slip; what is wrong with it then, or ""."""
    expression = text.strip().rstrip(":;").strip()
    context = line.context.of_text(expression, is_trial=False)
    node = context.expression()
    if node is None:
        return ""
    written = as_condition(context, node)
    if written:
        return f"write if {written}:"
    fault = condition_fault(context, expression)
    return fault.help if fault else ""


def without(line: Line, edits: list[tuple[int, int, str]]) -> str:
    """The text of the line after these edits."""
    parts, done = [], 0
    for start, end, new in edits:
        parts += [line.text[done:start], new]
        done = end
    return "".join([*parts, line.text[done:]])


def after_head(text: str) -> str:
    head = _HEAD.match(text)
    rest = text[head.end() :] if head else ""
    comment = re.search(r":\s*#", rest)
    return rest[: comment.start() + 1] if comment else rest


LOGIC = re.compile(r"&&|\|\||(?<![\w.])(?:AND|OR|NOT|And|Or|Not)\b|!(?=\s?[A-Za-z_(])")
_SINGLE = re.compile(r"[&|^~]")
_COMPARED = re.compile(r"[<>]|[=!]=")
_PYTHON = {"&&": "and", "||": "or", "!": "not"}


def logic(line: Line, match: re.Match[str]) -> Told:
    """``AND``, ``&&``, ``!``: read as and, or, not, which are rewritten as all, any, nc."""
    edits: list[tuple[int, int, str]] = []
    for found in LOGIC.finditer(line.code):
        word = _PYTHON.get(found[0], found[0].lower())
        before = line.code[: found.start()][-1:]
        after = line.code[found.end() :][:1]
        spaced = (" " if before and not before.isspace() and before != "(" else "") + word
        spaced += "" if after.isspace() else " "
        edits.append((*found.span(), spaced))
    if _binds_otherwise(line.code):
        way = "write what belongs together with all(...) in series, any(...) in parallel and nc(...) for the opposite"
        return Told(f"{match[0]} is not part of the language", way, match.span())
    help = condition_of(line, after_head(without(line, edits)))
    general = "in series write all(c.A, c.B), in parallel any(c.A, c.B), for the opposite nc(c.A)"
    return Told(
        f"{match[0]} is not part of the language",
        help or general,
        match.span(),
        tuple(edits) if _HEAD.match(line.code) else (),
    )


def _binds_otherwise(code: str) -> bool:
    """True where Python's words would take other things together than the signs of the line do.

    ``!`` and NOT of other languages belong to the next term; Python's not takes a comparison, and ``&`` and ``|`` too.
    """
    rest = LOGIC.sub(" ", code)
    is_negated = any(found[0].lower() in ("!", "not") for found in LOGIC.finditer(code))
    return _SINGLE.search(rest) is not None or (is_negated and _COMPARED.search(rest) is not None)


def comparison(*pairs: tuple[str, str]) -> Callable[[Line, re.Match[str]], Told]:
    """Signs of comparison that other languages have."""
    table = dict(pairs)

    def tell(line: Line, match: re.Match[str]) -> Told:
        sign = table[match[0]]
        edit = (*match.span(), sign)
        help = condition_of(line, after_head(without(line, [edit])))
        return Told(f"{match[0]} is no comparison here", help or f"write {sign}", match.span(), (edit,))

    return tell


def equals(line: Line, match: re.Match[str]) -> Told | None:
    """``if ds.A = 5:``"""
    start = match.start("sign")
    if _depth(line.code[:start]) > 0 and not re.search(r"\w\[|\(\s*$", line.code[:start]):
        return None
    edit = (start, match.end("sign"), "==")
    help = condition_of(line, after_head(without(line, [edit])))
    return Told("a comparison is written with two equals signs", help or "write ==", edit[:2], (edit,))


def then_word(line: Line, match: re.Match[str]) -> Told:
    start = match.start("word")
    edit = (len(line.code[:start].rstrip()), match.end("word"), ":")
    help = condition_of(line, after_head(line.text[:start]))
    is_last = not line.code[match.end("word") :].strip(" ;")
    edits = (edit,) if is_last and not line.code[:start].rstrip().endswith(":") else ()
    return Told("an if ends with a colon, not with then", help or "write if c.A:", match.span("word"), edits)


def else_if(_: Line, match: re.Match[str]) -> Told:
    """``else if``: elif in Python; that a rung has none is told when it can be read."""
    help = "a rung has no else: write another rung with the opposite condition in series, if all(nc(c.A), c.B):"
    return Told(
        f"{' '.join(match['word'].split())} is not part of the language",
        help,
        match.span("word"),
        ((*match.span("word"), "elif"),),
    )


def capitals(line: Line, match: re.Match[str]) -> Told | None:
    word = match["word"]
    if word == word.lower():
        return None
    edit = (*match.span("word"), word.lower())
    shown = without(line, [edit]).strip()
    return Told(f"{word.lower()} is written in small letters", f"write {shown}", match.span("word"), (edit,))


def no_colon(line: Line, match: re.Match[str]) -> Told | None:
    code = line.code.rstrip()
    if code.endswith(("\\", ",")) or _depth(code) != 0 or ":" in re.sub(r"\[[^\[\]]*\]|lambda[^:]*:", "", code):
        return None
    is_semicolon = code.endswith(";")
    edit = (len(code) - is_semicolon, len(code), ":")
    shown = line.text[: edit[0]].strip()
    if match["word"] in ("if", "elif", "while"):
        help = condition_of(line, after_head(line.text[: edit[0]])) or f"write {shown}:"
    else:
        help = "write def main():" if match["word"] == "def" and "(" not in code else f"write {shown}:"
    edits = () if match["word"] == "def" and "(" not in code else (edit,)
    return Told("the colon at the end of the line is missing", help, (edit[0], edit[0] + 1), edits)


def comma(line: Line, match: re.Match[str]) -> Told | None:
    """``if c.A, c.B:``"""
    context = line.context.of_text(after_head(line.text).strip().rstrip(":"))
    node = context.expression()
    if not isinstance(node, cst.Tuple):
        return None
    decimal = re.search(r"\b(\d+),(\d+)\b", line.code)
    if decimal:
        return Told("decimals are written with a point", f"write {decimal[1]}.{decimal[2]}", decimal.span())
    text = f"all({', '.join(context.text(one) for one in elements(node))})"
    help = condition_of(line, text) or "in series write all(c.A, c.B), in parallel any(c.A, c.B)"
    return Told("a comma joins no conditions", help, match.span("sign"))


def _depth(code: str) -> int:
    return sum(code.count(sign) for sign in "([{") - sum(code.count(sign) for sign in ")]}")


# -- addresses --------------------------------------------------------------------------------------------------------

BANK = rf"\b(?P<bank>{'|'.join(sorted(BANK_NAMES, key=len, reverse=True))})"


def dotted(_: Line, match: re.Match[str]) -> Told:
    """``x.1``"""
    bank, number = BANK_NAMES[match["bank"]], int(match["number"])
    text = f"{bank.dsl}[{number if bank.has(number) else bank.first}]"
    edits = ((*match.span(), text),) if bank.has(number) else ()
    return Told("a number stands in brackets", f"write {text}", match.span(), edits)


def bit_of(line: Line, match: re.Match[str]) -> Told | None:
    """``ds[1].3`` and ``ds.A.3``"""
    bank = BANK_NAMES[match["bank"]]
    word = line.text[match.start("bank") : match.end("index")]
    if bank.is_bit:
        return Told("an address has no bits", f"write {word}", match.span())
    # click-facts [contact.forms]
    return Told("CLICK has no bits of words", bit_of_word(word, bank, int(match["number"])), match.span())


def quoted_name(_: Line, match: re.Match[str]) -> Told | None:
    """``c.1st``, ``c.My Name``, ``c.if``: nicknames that are no word of Python's."""
    words = match["name"].split()
    if len(words) > 1 and (keyword.iskeyword(words[1]) or words[1].lower() in _WORDS | _RELATIONS):
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
_RELATIONS = frozenset(("between", "equals", "equal", "than", "to", "greater", "less", "within"))
"""Words that follow an address in other languages, and begin no nickname of two words."""


def zeros(line: Line, match: re.Match[str]) -> Told:
    number = match["number"]
    bank = re.search(r"(\w+\[)\s*$", line.code[: match.start()])
    if bank is None:
        # CLICK shows hexadecimal values with four digits.
        way = f"write {number}, or 0x{match['zeros']}{number} where it is hexadecimal"
        return Told("a number begins with no 0", way, match.span("zeros"))
    return Told(
        "a number begins with no 0", f"write {bank[1]}{number}]", match.span("zeros"), ((*match.span("zeros"), ""),)
    )


def dotted_range(_: Line, match: re.Match[str]) -> Told:
    first, last = int(match["first"]), int(match["last"])
    text = f"{match['bank']}[{first}:{last + 1}]"
    return Told("a range has a colon, and its end is not included", f"write {text}", match.span())


def foreign(_: Line, match: re.Match[str]) -> Told | None:
    """Addresses of other machines: ``%I0.1``, ``N7:0``, ``I:0/1``."""
    letter, size = match["letter"].upper(), (match["size"] or "").upper()
    word = {"W": {"I": "iw", "Q": "qw", "M": "n"}, "D": {"M": "dint"}}.get(size, {}).get(letter, letter)
    help = bank_hint({"T": "tim", "C": "cnt", "R": "cr", "S": "sp"}.get(word, word))
    return Told("this is an address of another machine", help, match.span()) if help else None


# -- numbers ----------------------------------------------------------------------------------------------------------


def hexadecimal(line: Line, match: re.Match[str]) -> Told:
    two = match["two"]
    number = int((two or match["digits"]).replace("_", "") or "0", 2 if two else 16)
    is_word = re.search(r"\b(?:dh|xd|yd|math_hex)\b", line.code) is not None
    help = f"write 0x{number:04X}" if is_word else f"write {number}, or 0x{number:04X} beside a word in DH"
    return Told("a hexadecimal number begins with 0x", help, match.span())


def duration(_: Line, match: re.Match[str]) -> Told | None:
    unit = UNITS.get(match["unit"].lower())
    help = in_units(Fraction(match["number"]), unit) if unit else ""
    return Told("a time is a whole number and its unit", help, match.span()) if help else None


# -- actions ----------------------------------------------------------------------------------------------------------


_STORED = "to store a value write copy(5, ds.A)"


def assigned(line: Line, match: re.Match[str]) -> Told | None:
    """``ds.A := 5;``"""
    if _HEAD.match(line.text):
        return _equals_sign(line, match)
    text = f"{line.text[: match.start()].strip()} = {line.text[match.end() :].strip().rstrip(';')}"
    context = line.context.of_text(text, is_trial=False)
    node = context.statement()
    if node is None:
        return Told(":= is not part of the language", _STORED, match.span())
    help = way_out(context, node).help or _STORED
    return Told(":= is not part of the language", help, match.span(), ((*match.span(), "="),))


def _equals_sign(line: Line, match: re.Match[str]) -> Told:
    edit = (*match.span(), "==")
    help = condition_of(line, after_head(without(line, [edit])))
    return Told("a comparison is written with two equals signs", help or "write ==", match.span(), (edit,))


def counted(line: Line, match: re.Match[str]) -> Told:
    target = line.text[match.start("target") : match.end("target")].strip()
    quote = "'" if '"' in target else '"'
    text = f"calc({quote}{target} {match['sign'][0]} 1{quote}, {target})"
    help = text if fits_action(line.context, text) else 'calc("ds.A + 1", ds.A)'
    return Told(f"{match['sign']} is not part of the language", f"write {help}", match.span("sign"))


def bare_call(line: Line, match: re.Match[str]) -> Told | None:
    """``out y[1]``"""
    name, argument = match["name"].lower(), line.text[match.start("argument") : match.end("argument")].strip(" ;")
    found = advice(name, ACTIONS)
    text = f"{name}({argument})" if name in INSTRUCTIONS else (found.written([argument]) if found else "")
    if name not in INSTRUCTIONS and found is None:
        return None
    if not text or not fits_action(line.context, text):
        text = INSTRUCTIONS[name].example if name in INSTRUCTIONS else found.code[0] if found and found.code else ""
    return Told("an instruction has its arguments in parentheses", f"write {text}", match.span("name"))


_GAP = re.compile(r"(?<=[\w\])\"'])\s+(?=[\w\"'-])")
_GAPS_MAX = 6
"""A line with more gaps is no call whose commas are missing."""


def missing_comma(line: Line, match: re.Match[str]) -> Told | None:
    """``copy(5 ds.A)`` and ``copy 5 ds.A``: commas in some of the gaps make an action of it."""
    name, is_open = match["name"].lower(), match["open"] == "("
    if name not in INSTRUCTIONS:
        return None
    code = re.sub(r'"( *)"', lambda text: f'"{"x" * len(text[1])}"', line.code)
    gaps = [gap for gap in _GAP.finditer(code) if gap.start() >= match.end("name") and gap.end() > match.end()]
    if not gaps or len(gaps) > _GAPS_MAX:
        return None
    edits = [(gap.start(), gap.end(), ", ") for gap in gaps]
    start = line.plain.find("#")
    bare = line if start < 0 else line._replace(text=line.text[:start])
    text = without(bare, [edit for edit in edits if start < 0 or edit[1] <= start]).strip().rstrip(" ;")
    if not is_open:
        text = f"{name}({text[len(name) :].strip()})"
    if not fits_action(line.context, text):
        return None
    fixed = tuple(edits) if is_open and match["name"] == name else ()
    return Told("a comma is missing here", f"write {text}", gaps[0].span(), fixed)


def coil_value(line: Line, match: re.Match[str]) -> Told | None:
    """``out(y[1] = True)``"""
    address = line.text[match.start("address") : match.end("address")].strip()
    action = {**STATES, "true": match["name"], "1": match["name"], "on": match["name"]}.get(match["value"].lower())
    if action is None or not fits_action(line.context, f"{action}({address})"):
        return None
    return Told(f"{match['name']} takes no value", f"write {action}({address})", match.span("sign"))


def arrow(_: Line, match: re.Match[str]) -> Told:
    return Told("an arrow stores nothing here", "the target is the last argument: copy(5, ds.A)", match.span())


def says(message: str, help: str, group: str = "") -> Callable[[Line, re.Match[str]], Told]:
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
SIGN = re.compile(f"[{''.join(_SIGNS)}]")


def _plain(text: str) -> tuple[tuple[int, int, str], ...]:
    """The plain signs in the place of the others, outside of texts and comments: what stands in quotes stays as it is.

    Nothing where a text would end elsewhere than the person sees it end.
    """
    edits: list[tuple[int, int, str]] = []
    at = 0
    while at < len(text) and text[at] != "#":
        quote = text[at] if text[at] in ("'", '"') else _SIGNS.get(text[at], "")
        if quote not in ("'", '"'):
            if text[at] in _SIGNS:
                edits.append((at, at + 1, quote))
            at += 1
            continue
        end = _end_of_text(text, at, quote)
        if end is None or quote in text[at + 1 : end] or "\\" in text[at + 1 : end]:
            return ()
        edits += [(place, place + 1, quote) for place in (at, end) if text[place] != quote]
        at = end + 1
    return tuple(edits)


def _end_of_text(text: str, start: int, quote: str) -> int | None:
    """Where a text in quotes of any kind ends: at the same plain quote, or at the next one that closes."""
    if text[start] == quote and (plain := text.find(quote, start + 1)) >= 0:
        return plain
    closing = (at for at in range(start + 1, len(text)) if quote in (text[at], _SIGNS.get(text[at])))
    return next(closing, None)


def typographic(line: Line, match: re.Match[str]) -> Told:
    edits = _plain(line.text)
    plain = _SIGNS[match[0]]
    if plain in ('"', "'"):
        help = f"write straight quotes, {plain}"
        return Told("these quotes come from a word processor", help, match.span(), edits)
    if not plain.strip():
        return Told("this blank comes from a word processor", "write a plain blank", match.span(), edits)
    meant = condition_of(line, after_head(without(line, list(edits))))
    return Told("this sign is not on a keyboard", meant or f"write {plain}", match.span(), edits)


def comment(line: Line, match: re.Match[str]) -> Told:
    """``// comment``, which is one for certain on a line of its own, after a call and after a colon."""
    before = line.code[: match.start("sign")].strip()
    is_sure = not before or (_depth(before) == 0 and (before.endswith(":") or _CALL.fullmatch(before) is not None))
    edits = ((*match.span("sign"), "#"),) if is_sure else ()
    shown = line.text[match.end("sign") :].strip()
    return Told("a comment begins with #", f"write # {shown}".rstrip(), match.span("sign"), edits)


_CALL = re.compile(r"[a-z_]+\(.*\)")


def old_comment(line: Line, match: re.Match[str]) -> Told | None:
    """A comment that begins with --, ;, ' or REM."""
    if match["sign"] == "'" and "unterminated" not in line.fault:
        return None
    return Told("a comment begins with #", "write # at its beginning", match.span("sign"))


def second_half(_: Line, match: re.Match[str]) -> Told:
    help = "a rung has no else: write another rung with the opposite condition, if nc(c.A):"
    return Told("else stands on a line of its own, and a rung has none", help, match.span("word"))


def semicolon(line: Line, _: re.Match[str]) -> Told | None:
    """``copy(5; ds.A)``"""
    depths = accumulate((sign in "([{") - (sign in ")]}") for sign in line.code)
    place = next(
        (at for at, (sign, depth) in enumerate(zip(line.code, depths, strict=True)) if sign == ";" and depth > 0), None
    )
    if place is None:
        return None
    edit = (place, place + 1, ",")
    text = without(line, [edit]).strip().rstrip(";")
    is_right = fits_action(line.context, text)
    help = f"write {text}" if is_right else "write copy(5, ds.A)"
    return Told("arguments are separated by commas", help, edit[:2], (edit,) if is_right else ())
