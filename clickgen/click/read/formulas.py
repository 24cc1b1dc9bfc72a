"""Turns a formula as CLICK shows it, ``SUM ( DS1 : DS10 ) + DS100 * 2``, into the formula of a program."""

from __future__ import annotations

import re

from clickgen.click.draw.tokens import formula_text
from clickgen.click.read.operands import ADDRESS, embedded
from clickgen.device.banks import parse_address
from clickgen.formula import Mode, parse_formula
from clickgen.formula.spelling import SPELL
from clickgen.ir.operands import Cell, Range
from clickgen.ir.program import FormulaText
from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.source import Span

_WORDS = re.compile(
    rf"(?P<range>(?P<first>{ADDRESS})\s*:\s*(?P<last>{ADDRESS}))"
    rf"|(?P<hex>[0-9A-Fa-f]+h)\b"
    rf"|(?P<cell>{ADDRESS})\b"
    r"|(?P<other>[A-Za-z]+|(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?|[-+*/^(),])"
    r"|(?P<space>\s+)"
    r"|(?P<unknown>.)",
    re.DOTALL,
)


def formula_of(text: str, mode: Mode, span: Span) -> FormulaText | None:
    """Return the formula that CLICK would show the same, token by token; None if a program cannot write it."""
    written: list[str] = []
    shown: list[str] = []
    for match in _WORDS.finditer(text):
        if match["space"]:
            continue
        source = _source(match, span)
        if source is None:
            return None
        written.append(source)
        shown.append(f"{match['first']} : {match['last']}" if match["range"] else match[0])
    formula = parse_formula(embedded(" ".join(written), span), mode, Diagnostics())
    if formula is None:
        return None
    found = FormulaText(formula, span)
    return found if formula_text(found) == " ".join(shown) else None


def _source(match: re.Match[str], span: Span) -> str | None:
    """One token in the words of a program."""
    if match["range"]:
        first, last = parse_address(match["first"]), parse_address(match["last"])
        if first is None or last is None or first.bank != last.bank or first.number > last.number:
            return None
        return SPELL.reference(Range(first.bank, first.number, last.number, span))
    if match["cell"]:
        address = parse_address(match["cell"])
        return SPELL.reference(Cell(address, span)) if address else None
    return None if match["unknown"] else match[0]
