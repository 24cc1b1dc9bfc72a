"""An address that is read and never written: it keeps its initial value."""

from __future__ import annotations

from clickgen.device.banks import Address
from clickgen.facts.facts import Facts
from clickgen.facts.uses import addresses_of, extents_of
from clickgen.ir.operands import form_of
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

CODE = "CG504"

_BANKS = ("Y", "C", "DS", "DD", "DH", "DF", "TXT")
"""Inputs and system points come from outside; CG521 reports timers and counters without their instruction."""


def find(facts: Facts) -> Findings:
    judged: set[tuple[str, int, int]] = set()
    said: set[Address] = set()
    for use in facts.uses.every:
        if use.is_written or form_of(use.operand) not in _BANKS:
            continue
        extents = extents_of(use.operand)
        if judged.issuperset(extents):
            continue
        judged.update(extents)
        addresses = addresses_of(use.operand)
        if said.issuperset(addresses) or facts.uses.may_be_written(use.operand):
            continue
        if any(map(facts.is_set_up, addresses)):
            continue
        said.update(addresses)
        one = len(addresses) == 1
        declared = facts.spell.declaration("...", initial="...", retentive="False")
        yield finding(
            CODE,
            use.operand.span,
            f"{facts.listed(addresses)} {'is' if one else 'are'} read here and nothing in the program writes "
            f"{'it' if one else 'them'}",
            f"correct the name, declare a value with {declared}, or write {facts.spell.ignore(CODE)} where a panel or "
            "another device writes it",
        )


ABOUT = Code(
    CODE,
    Severity.INFO,
    "an address is read and never written",
    """
Nothing in the program gives this address a value. Either a panel or another device does, or its name is misspelled and
the program works with 0 for ever. A declaration with an initial value or a retentive setting tells that it is meant.

The rule is off by default, because a program does not say what panels write. Switch it on where the panel's addresses
are declared.
""",
    wrong=(
        Wrong(
            """
if ds.Pressure > ds.PressureLimit:  # <- # <-
    out(y.Valve)
"""
        ),
        Wrong(
            """
if x.Load:
    copy_block(ds[101:104], ds[1])  # <-
"""
        ),
    ),
    right=(
        """
nickname(ds.PressureLimit, ds[10], initial=60, retentive=False)


def main():
    if True:
        calc("sd[1] * 10", ds.Pressure)

    if ds.Pressure > ds.PressureLimit:
        out(y.Valve)

    if True:
        end()
""",
        """
if x.Store:
    copy(5, ds[ds.Row])

if x.Next:
    calc("ds.Row + 1", ds.Row)

if ds[105] == 5:
    out(y.Lamp)
""",
    ),
    is_on=False,
)

RULE = Rule(find, (ABOUT,))
