"""The sheet that shows how full each bank is."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping

from clickgen.click.draw.tokens import operand_token
from clickgen.device.banks import BANKS, CURRENT_VALUE_OF, WORD_TWINS, Bank
from clickgen.emit.workbook.project import Project
from clickgen.emit.workbook.sheet import Cells, Column, Sheet
from clickgen.emit.workbook.states import GIVEN, State
from clickgen.ir.operands import Pointer

_POINTERS_MAX = 6
"""This many pointers are named at a bank."""


def memory(project: Project) -> Sheet:
    counts = tuple(Column(state.words.capitalize(), 10) for state in State)
    return Sheet(
        "Memory",
        "How full each bank is. Each cell is counted once.",
        (
            Column("Bank", 7),
            Column("Holds", 24),
            Column("Numbers", 28, wraps=True),
            Column("Cells", 8),
            *counts,
            Column("Longest free stretch", 22),
            Column("Remarks", 44, wraps=True),
        ),
        _summary(project),
    )


def _summary(project: Project) -> Iterator[Cells]:
    pointed = pointers(project)
    for bank in BANKS.values():
        head = (bank.name, bank.title, bank.describe_range().replace("..", "-"))
        remarks = "; ".join((*_nature(bank), *pointed.get(bank.name, ())))
        if bank in GIVEN:
            counted = project.states.count(bank)
            numbers = (sum(counted.values()), *(counted[state] for state in State))
            yield *head, *numbers, _longest_free(project, bank), remarks
        else:
            words = 1 if bank.name in ("XD", "YD") else 0
            total = sum(last - first + 1 for first, last in bank.ranges) + words
            yield *head, total, *(None for _ in State), None, remarks


def _nature(bank: Bank) -> Iterator[str]:
    if bank.name in CURRENT_VALUE_OF:
        yield f"the current values of {CURRENT_VALUE_OF[bank.name]}, same numbers"
    elif bank not in GIVEN and bank.name in WORD_TWINS:
        yield f"the points of {WORD_TWINS[bank.name]} as words; also {bank.name}0u"
    elif bank not in GIVEN:
        yield "CLICK's own"


def _longest_free(project: Project, bank: Bank) -> str:
    free = [stretch for stretch in project.states.stretches(bank) if stretch.state is State.FREE]
    longest = max(free, key=lambda stretch: stretch.length, default=None)
    return f"{longest.first}-{longest.last}" if longest else "none"


def pointers(project: Project) -> Mapping[str, list[str]]:
    """The notes on banks that pointers lead into: this sheet cannot know which of their cells."""
    found: dict[tuple[str, bool], dict[str, None]] = defaultdict(dict)
    for use in project.built.uses.every:
        if isinstance(use.operand, Pointer):
            bank = use.operand.bank
            for name in (bank, WORD_TWINS.get(bank) or CURRENT_VALUE_OF.get(bank)):
                if name:
                    found[name, use.is_written][operand_token(use.operand)] = None
    remarks: dict[str, list[str]] = defaultdict(list)
    for (bank, is_written), tokens in sorted(found.items()):
        shown = ", ".join(list(tokens)[:_POINTERS_MAX]) + (" and others" if len(tokens) > _POINTERS_MAX else "")
        remarks[bank].append(f"pointers {'write' if is_written else 'read'} any of its cells: {shown}")
    return remarks
