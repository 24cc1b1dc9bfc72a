"""Slips in conditions: words and signs of other languages, a missing colon, a superfluous comma."""

from __future__ import annotations

import re
from collections.abc import Callable

import libcst as cst

from clickgen.dialects.if_rungs.read.nodes import elements
from clickgen.dialects.if_rungs.ways_out.slip_line import HEAD, Line, Told, after_head, condition_of, depth, without

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
        tuple(edits) if HEAD.match(line.code) else (),
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
    if depth(line.code[:start]) > 0 and not re.search(r"\w\[|\(\s*$", line.code[:start]):
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
    if code.endswith(("\\", ",")) or depth(code) != 0 or ":" in re.sub(r"\[[^\[\]]*\]|lambda[^:]*:", "", code):
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
