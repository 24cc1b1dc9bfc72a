"""Differences between CLICK's bytes and laddercodec's that do not change the instruction, each with the reason
(click-facts [click-file.harmless]).

Found in the captures and program files that laddercodec 0.2.2 carries as fixtures: 192 captures and 41 program files
of CLICK, 1889 and 1558 instructions. Any other difference is reported, and its rung refused.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import NamedTuple

from clickgen.click.read.blobs import UNINDEXED, Blob, Field
from clickgen.device.banks import Address

SWITCHES = (0x11, 0x12)
"""The upper bytes of tags that are on or off; CLICK writes on as 1 and as -1."""


class Harmless(NamedTuple):
    """A field of some classes, when it may differ, and why that changes nothing.

    ``holds`` takes the field as CLICK has it and as laddercodec writes it, and the whole instruction of each.
    """

    classes: tuple[str, ...]
    tag: int
    holds: Callable[[Field, Field, Blob, Blob], bool]
    reason: str


def reason_for(said: Field, made: Field, file: Blob, written: Blob) -> str:
    """The reason why a field may differ from what laddercodec writes; "" if it may not."""
    if said.tag != made.tag:
        return ""
    if said.slot == made.slot and said.tag >> 8 in SWITCHES and {said.value, made.value} == {"1", "-1"}:
        return "CLICK writes a switch that is on as 1 and as -1"
    for entry in HARMLESS:
        if said.tag == entry.tag and file.head.name in entry.classes and entry.holds(said, made, file, written):
            return entry.reason
    return ""


def _is_number(said: Field, _made: Field, _file: Blob, _written: Blob) -> bool:
    return said.value.isascii() and said.value.isdigit()


def _is_switch(said: Field, _made: Field, _file: Blob, _written: Blob) -> bool:
    return said.value in ("0", "1")


_NAME = re.compile(r"<[^<>]*>")
_ADDRESS = re.compile(r"\b(?:CTD|CT|TD|TXT|SC|SD|DS|DD|DH|DF|X|Y|C|T)[0-9]+\b")
_SHOWS_NICKNAMES, _TEMPLATE, _FORMULA = 0x2224, 0x61FF, 0x6228


def _is_same_formula(said: Field, _made: Field, file: Blob, written: Blob) -> bool:
    shown = _ADDRESS.sub("@", _NAME.sub("@", said.value))
    return file.value(_SHOWS_NICKNAMES) == "1" and shown == written.value(_TEMPLATE)


_SUM = re.compile(r"SUM \( ([A-Z]+)([0-9]+) : \1([0-9]+) \)")


def _is_inside_sum(said: Field, _made: Field, _file: Blob, written: Blob) -> bool:
    inside: list[str] = []
    for bank, first, last in _SUM.findall(written.value(_FORMULA)):
        inside += (str(Address(bank, number)) for number in range(int(first) + 1, int(last)))
    return said.slot < len(inside) and said.value == inside[said.slot]


_JUMP = 0x1202


def _is_jog_without_jump(said: Field, made: Field, _file: Blob, written: Blob) -> bool:
    is_jog = said.slot == made.slot == 3 and written.value(_JUMP) == "0"
    return is_jog and made.value != "0" and said.value == str(int(made.value) - 1)


def _is_empty_array(said: Field, made: Field, _file: Blob, _written: Blob) -> bool:
    return said.value == made.value == "" and made.slot == UNINDEXED and said.slot != UNINDEXED


HARMLESS = (
    Harmless(("Call",), 0x3219, _is_number, "CLICK's number of the subroutine, which its name says as well"),
    Harmless(("Drum",), 0x3A05, _is_jog_without_jump, "CLICK counts the jog of a drum without a jump as its third pin"),
    Harmless(("Math",), _SHOWS_NICKNAMES, _is_switch, "whether CLICK shows nicknames in the formula"),
    Harmless(("Math",), _FORMULA, _is_same_formula, "the formula once more, with nicknames in the place of addresses"),
    Harmless(("Math",), 0x688C, _is_inside_sum, "the addresses inside the ranges of SUM, which its ends say as well"),
    Harmless(("RD", "SD"), 0x688F, _is_empty_array, "an empty array, which CLICK numbers"),
    Harmless(("SD",), 0x6889, _is_empty_array, "an empty array, which CLICK numbers"),
)

DRAWN_TALLER = ("Email", "Home", "Position", "Velocity")
"""Boxes that CLICK draws three rows tall and laddercodec writes as one; their rows hold nothing else
(click-facts [grid.heights])."""

WIRED_LATER = ("Cnt", "Drum", "SR")
"""Boxes whose wire into the first row CLICK keeps apart: it is off if a row was inserted above the wired one."""

MEANINGS = {
    0x11F5: "immediate",
    0x11F8: "one-shot",
    0x11FE: "hexadecimal or decimal",
    0x1201: "an option that is on or off",
    0x2211: "the Modbus function",
    0x220C: "the port",
    0x21F7: "the comparison",
    0x21F9: "the unit of time",
    0x2206: "the form of the text",
    0x2223: "the kind of copy",
    0x2227: "the conversion",
    0x3210: "how many",
    0x3218: "CLICK's code of the instruction",
    0x3A05: "CLICK's code of an input",
}
"""The meanings of some fields, for a message."""
