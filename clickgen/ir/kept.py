"""Ladder tokens that are kept unchanged, and the addresses in them.

Nobody knows what their instructions do, so everything that may be an address counts as one, in quotes too.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from clickgen.device.banks import BANKS, POINTED, Address, parse_address
from clickgen.ir.operands import Cell, Pointer, Range
from clickgen.ir.program import KeptToken
from clickgen.text.source import EmbeddedText, Span

_TAG = re.compile(r"(?<=,)[0-9a-f]{4}(?=(?:\[\d+\]|:[0-9a-f]{8})?=)")
"""The number of a field in ``raw(...)``: ``c123=`` is no C123."""
_BANK = "|".join(sorted(BANKS, key=len, reverse=True))
_ADDRESS = rf"(?:{_BANK})\d{{1,9}}u?(?![A-Za-z0-9])"
_START = r"(?<![A-Za-z0-9])"
_NAMED = re.compile(
    rf"{_START}(?P<pointed>{_BANK})\s*(?=\[\s*(?P<register>DS\d{{1,9}})\s*\])"
    rf"|{_START}(?P<first>{_ADDRESS})(?:\s*(?P<joiner>\.\.|[:~-])\s*(?P<last>{_ADDRESS}))?",
    re.IGNORECASE,
)


def kept_token(text: EmbeddedText, span: Span) -> KeptToken:
    """A token with its addresses, each at its own place inside the quotes."""
    return KeptToken(text.value, tuple(_operands(text)), span)


def _operands(text: EmbeddedText) -> Iterator[Cell | Range | Pointer]:
    is_formula = not text.value.startswith("raw(")
    for match in _NAMED.finditer(_TAG.sub("    ", text.value)):
        if match["pointed"]:
            yield from _pointer(text, match)
            continue
        span = text.span(*match.span())
        first, last = (parse_address(match[end] or "") for end in ("first", "last"))
        # In a formula it is a minus.
        is_range = not (is_formula and match["joiner"] == "-")
        if first and last and is_range and first.bank == last.bank and not (first.upper or last.upper):
            yield from _between(first, last, span)
        else:
            yield from (Cell(address, span) for address in (first, last) if address)


def _pointer(text: EmbeddedText, match: re.Match[str]) -> Iterator[Pointer]:
    """A pointer; its register is a separate address of the token."""
    bank, register = match["pointed"].upper(), parse_address(match["register"])
    if register and bank in POINTED:
        span = text.span(*match.span())
        yield Pointer(bank, Cell(register, span), span)


def _between(first: Address, last: Address, span: Span) -> Iterator[Range]:
    """A range; one that spans a gap of X or Y comes in pieces."""
    low, high = sorted((first.number, last.number))
    for start, stop in BANKS[first.bank].ranges:
        if start <= high and low <= stop:
            yield Range(first.bank, max(low, start), min(high, stop), span)
