"""An address that is written and never read: wasted work, or for a panel."""

from __future__ import annotations

from clickgen.device.banks import Address
from clickgen.facts.facts import Facts
from clickgen.facts.uses import addresses_of, extents_of
from clickgen.ir.operands import form_of
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

CODE = "CG505"

_BANKS = ("C", "DS", "DD", "DH", "DF", "TXT")
"""Outputs and system points act by themselves; a timer's or counter's value belongs to its instruction."""


def find(facts: Facts) -> Findings:
    judged: set[tuple[str, int, int]] = set()
    said = _by_the_way(facts)
    for use in facts.uses.every:
        if not use.is_written or form_of(use.operand) not in _BANKS:
            continue
        extents = extents_of(use.operand)
        if judged.issuperset(extents):
            continue
        judged.update(extents)
        addresses = addresses_of(use.operand)
        if said.issuperset(addresses) or facts.uses.may_be_read(use.operand):
            continue
        said.update(addresses)
        one = len(addresses) == 1
        yield finding(
            CODE,
            use.operand.span,
            f"{facts.listed(addresses)} {'is' if one else 'are'} written here and nothing in the program reads "
            f"{'it' if one else 'them'}",
            f"correct the name, remove what writes it, or write {facts.spell.ignore(CODE)} where a panel or another "
            "device reads it",
        )


def _by_the_way(facts: Facts) -> set[Address]:
    """The addresses that an instruction needs on the side, or reads itself: a drum's step, a search's result."""
    found: set[Address] = set()
    for placed in facts.actions:
        reports = {name: addresses_of(placed.action.args.get(name)) for name in placed.effects.reports}
        read = {name for name, own in reports.items() if any(map(facts.uses.reads, own))}
        finds = placed.effects.finds
        for name, own in reports.items():
            # One answer of a search is enough, and one that goes on reads its result itself.
            goes_on = finds is not None and name == finds.result and placed.action.flag(finds.goes_on)
            if finds is None or goes_on or read - {name}:
                found.update(own)
    return found


ABOUT = Code(
    CODE,
    Severity.INFO,
    "an address is written and never read",
    """
The program writes an address that it never looks at. It may be for a panel; otherwise it is a leftover, or the name is
misspelled where it should be read.

The rule is off by default, because a program does not say what panels show.
""",
    wrong=(
        Wrong(
            """
if x.Part:
    calc("sd[1] * 10", ds.Weigth)  # <-

if ds.Weight > 500:
    out(y.Reject)
"""
        ),
        Wrong(
            """
if x.Clear:
    copy_fill(0, ds[101:111])  # <-
"""
        ),
    ),
    right=(
        """
if x.Part:
    calc("sd[1] * 10", ds.Weight)

if ds.Weight > 500:
    out(y.Reject)
""",
        """
if x.Clear:
    copy_fill(0, ds[101:111])

if x.Show:
    copy(ds[ds.Row], sd[31])
""",
        """
if x.Find:
    search(sd[1:10] == 5, result=ds.FoundAt, found=c.Found)

if c.Found:
    copy(4, dh.Code)
    send(ModbusTcpTarget(ip="192.168.1.10"), "DH1", dh.Code)
""",
    ),
    is_on=False,
)

RULE = Rule(find, (ABOUT,))
