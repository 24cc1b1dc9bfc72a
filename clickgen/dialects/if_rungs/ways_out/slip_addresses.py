"""Slips in addresses, names and numbers."""

from __future__ import annotations

import keyword
import re
from fractions import Fraction

from clickgen.device.elsewhere import UNITS
from clickgen.dialects.if_rungs.trade import bank_hint
from clickgen.dialects.if_rungs.ways_out.hints import bit_of_word
from clickgen.dialects.if_rungs.ways_out.slip_line import Line, Told
from clickgen.instructions.durations import in_units
from clickgen.ir.addresses import BANK_NAMES

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
