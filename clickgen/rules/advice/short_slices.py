"""A slice of 15 or 31 bits into or out of a word: its end looks as if it was meant to be included."""

from __future__ import annotations

import re

from clickgen.device.banks import BANKS, Address
from clickgen.facts.facts import Facts, Placed
from clickgen.instructions.effects import Shape
from clickgen.instructions.spec import BITS
from clickgen.ir.operands import Range
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding
from clickgen.text.edits import Edit, Fix
from clickgen.text.source import Span

# click-facts [copy.pack-bits, copy.pack-high-bits]
CODE = "CG519"

_SHORT = (15, 31)


def find(facts: Facts) -> Findings:
    for placed in facts.actions:
        bits = _short_bits(placed)
        if bits is None:
            continue
        behind = Address(bits.bank, bits.last + 1)
        if not BANKS[bits.bank].has(behind.number) or _has_neighbour(facts, bits):
            continue
        first = Address(bits.bank, bits.first)
        yield finding(
            CODE,
            bits.span,
            f"these are {len(bits)} bits, {first} to {Address(bits.bank, bits.last)}: "
            f"{f'{facts.spell.range_end}, so ' if facts.spell.range_end else ''}{facts.shown(behind)} stays out",
            f"for {first} to {behind} write {facts.spell.range(bits.bank, bits.first, behind.number)}",
            fix=_fix(facts, bits),
        )


def _short_bits(placed: Placed) -> Range | None:
    if placed.effects.shape not in (Shape.PACK, Shape.UNPACK):
        return None
    bits = placed.action.moved if placed.effects.shape is Shape.PACK else placed.action.moved_to
    if isinstance(bits, Range) and bits.bank in BITS and len(bits) in _SHORT and not bits.is_reversed:
        return bits
    return None


def _has_neighbour(facts: Facts, bits: Range) -> bool:
    """True if another slice begins where this one ends, or ends where it begins: they are counted on purpose."""
    before = facts.uses.at(Address(bits.bank, bits.first - 1))
    behind = facts.uses.at(Address(bits.bank, bits.last + 1))
    return any(isinstance(use.operand, Range) and use.operand.last == bits.first - 1 for use in before) or any(
        isinstance(use.operand, Range) and use.operand.first == bits.last + 1 for use in behind
    )


def _fix(facts: Facts, bits: Range) -> Fix | None:
    # On one line: then the number is where its text says.
    match = re.fullmatch(r"[^\n]*:[^\S\n]*([1-9][0-9]*)[^\S\n]*\]", facts.text(bits.span))
    if match is None or int(match[1]) != bits.last + 1:
        return None
    path, line, col, *_ = bits.span
    place = Span(path, line, col + match.start(1), line, col + match.end(1))
    return Fix((Edit(place, str(bits.last + 2)),), is_safe=False)


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a range looks one address short",
    """
The end of a slice is not included: `c[1:16]` is C1 to C15, fifteen bits. Whoever packs a status word means sixteen, and
the highest bit of the word then stays 0 without a word from CLICK.

The rule speaks of 15 and 31 bits that go into a word or come out of one. It is quiet where another slice adjoins this
one without a gap, and where the bank has no next address.

The fix makes the slice one address longer. It is not safe: the instruction then moves one bit more, and where fifteen
bits were meant, that bit belongs to something else.
""",
    wrong=(
        Wrong(
            """
if True:
    copy_pack(c[1:16], dh.Status)  # <-
    copy_unpack(dd.Options, c[101:132])  # <-
    copy_pack(x[1:16], dh.Inputs)  # <-
""",
            """
if True:
    copy_pack(c[1:17], dh.Status)  # <-
    copy_unpack(dd.Options, c[101:133])  # <-
    copy_pack(x[1:17], dh.Inputs)  # <-
""",
        ),
    ),
    right=(
        """
if True:
    copy_pack(c[1:17], dh.Status)
    copy_unpack(dd.Options, c[101:133])
    copy_pack(c[201:209], dh.Half)
    copy_block(ds[1:16], ds[101])
""",
        """
if True:
    copy_pack(c[1:16], dh.Low)
    copy_pack(c[16:31], dh.High)
    copy_pack(c[1986:2001], dh.Last)
""",
        """
if True:
    copy_pack(x[2:17], dh.AllButFirst)
""",
    ),
)

RULE = Rule(find, (ABOUT,), holds_in_parts=True)
