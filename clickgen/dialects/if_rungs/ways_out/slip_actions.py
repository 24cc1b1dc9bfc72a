"""Slips in actions: assignments, and calls without parentheses or commas."""

from __future__ import annotations

import re

from clickgen.dialects.if_rungs.read.calls import fits_action
from clickgen.dialects.if_rungs.trade import ACTIONS, advice
from clickgen.dialects.if_rungs.ways_out.assigned import STATES
from clickgen.dialects.if_rungs.ways_out.misplaced import way_out
from clickgen.dialects.if_rungs.ways_out.slip_line import HEAD, Line, Told, after_head, condition_of, without
from clickgen.instructions import INSTRUCTIONS

_STORED = "to store a value write copy(5, ds.A)"


def assigned(line: Line, match: re.Match[str]) -> Told | None:
    """``ds.A := 5;``"""
    if HEAD.match(line.text):
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
