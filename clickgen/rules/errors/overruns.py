"""Copies that write further than the address they name: texts past the end of TXT, and over what follows
(click-facts [text.cell])."""

from __future__ import annotations

import re
from collections.abc import Iterator

from clickgen.device.banks import BANKS, Address
from clickgen.dialects.base import Spelling
from clickgen.facts.copied import put_in
from clickgen.facts.facts import Facts, Placed
from clickgen.facts.written import Asked
from clickgen.instructions.spec import Access, Param
from clickgen.ir.operands import Cell, Constant, Integer, Pointer, Text
from clickgen.ir.program import Action
from clickgen.ir.reach import characters, length_of
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding
from clickgen.table.blocks import Block

_NUMBER = re.compile(r"[ _]*[0-9]*$")


def find(facts: Facts) -> Findings:
    for placed in facts.actions:
        for cell, param, length in _long_writes(placed):
            yield from _judge(facts, placed, cell, param, length)
        for pointer in _long_pointers(placed):
            yield from _judge_pointer(facts, placed, pointer, characters(placed.action))


def _judge(facts: Facts, placed: Placed, cell: Cell, param: Param, length: int) -> Findings:
    """A write that begins at this cell and can reach too far."""
    last = Address(cell.bank, cell.address.number + length - 1)
    is_text = not param.extends_over
    if not BANKS[last.bank].has(last.number):
        yield from _past_the_end(facts, placed.action, cell, last, length)
        return
    block = _block_of(facts, cell.address)
    reason = ""
    if block is not None:
        named = _first_named(facts, Address(cell.bank, block.last + 1), last)
        over = f" and over {facts.shown(named)}" if named else ""
        if last.number > block.last:
            reason = f"runs past the block {block.name} ({block}){over}"
    elif is_text:
        # Which registers a block copy writes, the person said by its source.
        named = _first_named(facts, Address(cell.bank, cell.address.number + 1), last, cell.address)
        reason = f"runs over {facts.shown(named)}" if named else ""
    if reason:
        what = _said(placed.action, length) if is_text else f"this copy of {length} addresses"
        yield finding(
            "CG431",
            cell.span,
            f"{what} {reason}, to {last}",
            f"{_option(facts.spell, placed.action)}begin it earlier, shorten it, or make room for it: a block of "
            f"{length} addresses, or other addresses for what follows",
        )


def _long_writes(placed: Placed) -> Iterator[tuple[Cell, Param, int]]:
    """The operands that stand for more addresses than their own and are written."""
    for param in placed.spec.params:
        operand = placed.action.args.get(param.name)
        if isinstance(operand, Cell) and param.slot.access is Access.WRITE:
            length = length_of(placed.action, param)
            if length > 1:
                yield operand, param, length


def _past_the_end(facts: Facts, action: Action, cell: Cell, last: Address, length: int) -> Findings:
    """A text that surely reaches too far is refused (CG306), unless a pointer leads to where it begins."""
    target = action.args.get(action.spec.matrix[1])
    if cell.bank != "TXT" or (_is_sure_text(action) and not isinstance(target, Pointer)):
        return
    end = BANKS["TXT"].last
    yield finding(
        "CG430",
        cell.span,
        f"{_said(action, length)} reaches {last}: TXT ends at TXT{end}",
        f"{_option(facts.spell, action)}begin it at {facts.spell.cell(Address('TXT', end + 1 - length))} or earlier",
    )


def _said(action: Action, length: int) -> str:
    if _is_sure_text(action):
        return f"this text of {length} characters"
    if "options" in action.args:
        return f"this number can take {length} characters as text, and then"
    return (
        "what CLICK makes of a number in TXT without an option, no source says; "
        f"as text it can take {length} characters, and then"
    )


def _option(spell: Spelling, action: Action) -> str:
    """The beginning of the way out for a number that goes to TXT without an option."""
    source = action.args.get(action.spec.matrix[0])
    if isinstance(source, Text) or "to_text" not in action.spec.conversions or "options" in action.args:
        return ""
    if isinstance(source, Integer):
        return f"write its digits as a text, {spell.quoted(str(source.value))}; or "
    if isinstance(source, Constant):
        return "write its digits as a text in quotes; or "
    one, text = spell.setting("options", "to_binary"), spell.setting("options", "to_text")
    return f"say what is meant, {one} for one character or {text}; or "


def _is_sure_text(action: Action) -> bool:
    return isinstance(action.args.get(action.spec.matrix[0]), Text)


# -- through a pointer ------------------------------------------------------------------------------------------------


def _long_pointers(placed: Placed) -> Iterator[Pointer]:
    """The pointers into TXT that a text of several characters goes through."""
    target = placed.action.args.get(placed.spec.matrix[1])
    if isinstance(target, Pointer) and target.bank == "TXT" and characters(placed.action) > 1:
        yield target


def _judge_pointer(facts: Facts, placed: Placed, pointer: Pointer, length: int) -> Findings:
    """Where the text begins, the numbers say that the program gives the pointer; else anything that is not asked."""
    register = pointer.register
    if not isinstance(register, Cell):
        return
    param = next(param for param in placed.spec.params if param.name == placed.spec.matrix[1])
    asked, bank = Asked(facts, placed, register.address), BANKS[pointer.bank]
    numbers = _numbers(facts, register.address)
    if numbers is not None:
        for number in sorted(numbers):
            if not bank.has(number) or not asked.may_be(number):
                continue
            found = list(_judge(facts, placed, Cell(Address(bank.name, number), pointer.span), param, length))
            yield from found
            if found:
                return
        return
    looked_at = (side for leaf in facts.comparisons for side in (leaf.left, leaf.right))
    if any(isinstance(side, Cell) and side.address == register.address for side in looked_at):
        return  # How far the program lets it go, a comparison says.
    highest = bank.last + 1 - length
    test = facts.spell.compared(facts.text(register.span), "<=", str(highest))
    yield finding(
        "CG430",
        pointer.span,
        f"{_said(placed.action, length)} can reach past TXT{bank.last}: nothing keeps "
        f"{facts.shown(register.address)} at {highest} or below",
        f"{_option(facts.spell, placed.action)}test the pointer in this rung: "
        f"{facts.spell.rung(facts.with_test(placed, test))}",
    )


def _numbers(facts: Facts, register: Address) -> set[int] | None:
    """All numbers that the program gives a register; None where it is not known."""
    writers = facts.writers(register)
    if not writers or facts.uses.is_pointed("DS", is_written=True):
        return None
    numbers = {put.value if isinstance(put := put_in(writer, register), Integer) else None for writer in writers}
    begins = facts.initial(register)
    known = {number for number in numbers if number is not None}
    if None in numbers:
        return None
    return known | ({int(begins)} if begins.isdecimal() else set())


# -- what lies there --------------------------------------------------------------------------------------------------


def _block_of(facts: Facts, address: Address) -> Block | None:
    """The innermost block around an address."""
    around = [
        block for block in facts.blocks if block.bank == address.bank and block.first <= address.number <= block.last
    ]
    return min(around, key=lambda block: block.size, default=None)


def _first_named(facts: Facts, first: Address, last: Address, own: Address | None = None) -> Address | None:
    """The first address of a stretch that is another name's; cells named alike but for a number are one thing."""
    stem = _stem(facts.nickname(own)) if own else ""
    for number in range(first.number, last.number + 1):
        address = Address(first.bank, number)
        nickname = facts.nickname(address)
        if nickname and not (stem and _stem(nickname) == stem):
            return address
        if any(block.bank == address.bank and block.first == number for block in facts.blocks):
            return address
    return None


def _stem(nickname: str) -> str:
    return _NUMBER.sub("", nickname).lower()


CODES = (
    Code(
        "CG430",
        Severity.WARNING,
        "a text can run past the last TXT address",
        """
A number that is copied as text takes one TXT address per character: up to 6 from DS, TD and SD,
including a sign, 11 from DD and CTD, 4 from DH, 15 from DF, and one more with a termination code. If the text starts
here, the longest one goes past TXT1000. No source says what CLICK does with the rest. Start the text earlier.

What CLICK makes of a number that goes to TXT without an option, no source says either: one character, or its digits.
The warning comes where the digits would not fit. Say which you mean: `options=to_binary` fills one address,
`options=to_text()` writes digits.

A text of several characters that goes through a pointer gets the warning when nothing keeps the pointer low enough.
Test its register in the rung, or give it constants alone.
""",
        wrong=(
            Wrong(
                """
if x[1]:
    copy(ds.Weight, txt[998], options=to_text())  # <-
    copy(ds.Weight, txt[998])  # <-
    copy("FINISHED", txt[ds.Place])  # <-
""",
            ),
        ),
        right=(
            """
if x[1]:
    copy(ds.Weight, txt[991], options=to_text())
    copy(ds.Weight, txt[999], options=to_binary)
if ds.Place <= 993:
    copy("FINISHED", txt[ds.Place])
""",
        ),
    ),
    Code(
        "CG431",
        Severity.WARNING,
        "a copy can run past its block or over another name",
        """
Some copies write past the address that they name. A text of 8 characters fills 8 TXT addresses, a number as text
fills one per character, including its sign, and a block copy fills as many addresses as its source has. This
copy can run past the end of the block that it begins in, or over an address with a name of its own: a rung that reads
that address finds a piece of this text. Start the copy earlier, shorten it, or give it a larger block. A number that
goes to TXT without an option counts as text, because no source says that CLICK does not make it one.

Names that differ only in a number, such as `Msg1` and `Msg2`, count as one thing.
""",
        wrong=(
            Wrong(
                """
nickname(txt.Message, txt[1:6])
nickname(txt.Mode, txt[6])


def main():
    if c.Done:
        copy("FINISHED", txt.Message[0])  # <-
    if True:
        end()
""",
            ),
        ),
        right=(
            """
nickname(txt.Message, txt[1:9])
nickname(txt.Mode, txt[9])


def main():
    if c.Done:
        copy("FINISHED", txt.Message[0])
    if True:
        end()
""",
        ),
    ),
)

RULE = Rule(find, CODES, holds_in_parts=True)
