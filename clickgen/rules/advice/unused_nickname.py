"""A nickname that the program declares and never uses."""

from __future__ import annotations

import re

from clickgen.device.banks import CURRENT_VALUE_OF, VALUE_BANK, Address
from clickgen.facts.facts import Facts
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

CODE = "CG506"

_SPARE = re.compile(r"spare|reserve|unused|not_used", re.IGNORECASE)
"""Nicknames that say themselves that nothing uses them."""


def find(facts: Facts) -> Findings:
    whole: dict[str, bool] = {}
    for declaration in facts.program.declarations:
        path, name = declaration.span.path, declaration.named.name
        if path not in whole:
            whole[path] = _is_whole(facts, path)
        # An initial value is for whatever uses the address besides the program.
        is_set = declaration.initial is not None or declaration.retentive is not None
        if whole[path] and not is_set and not _SPARE.search(name) and not _is_used(facts, declaration.cell.address):
            yield finding(
                CODE,
                declaration.named.span,
                f"{facts.shown(declaration.cell.address)} is declared here and the program does not use it",
                "remove the declaration, correct the name where it should be used, or write "
                f"{facts.spell.ignore(CODE)} where a panel or another device uses it",
            )


def _is_whole(facts: Facts, path: str) -> bool:
    """True if every routine of the file is in the program, and there is one.

    A file that several programs share, for its declarations or for some subroutines each, is not judged by any of them.
    """
    here = {routine.name for routine in facts.program.routines if routine.span.path == path}
    return bool(here) and here.issuperset(facts.dialect.routines_in(facts.sources[path]))


def _is_used(facts: Facts, address: Address) -> bool:
    banks = (address.bank, VALUE_BANK.get(address.bank), CURRENT_VALUE_OF.get(address.bank))
    twins = [address._replace(bank=bank) for bank in banks if bank]
    pointed = (facts.uses.is_pointed(twin.bank, is_written) for twin in twins for is_written in (True, False))
    return any(facts.uses.at(twin) for twin in twins) or any(pointed)


ABOUT = Code(
    CODE,
    Severity.INFO,
    "a declared nickname is never used",
    """
The program gives an address a name and then uses the address nowhere, by name, by number, or in a range. Often a wire
was moved or a name changed, and the old line stayed; who reads the list later looks for what it does.

Names with "spare" or "reserve" in them may stay, and declarations with an initial value. Files that only declare, and
are imported by several programs, are not judged, and neither is a bank that pointers go into.
""",
    wrong=(
        Wrong(
            """
nickname(x.Start, x[1])
nickname(x.OldStart, x[2])  # <-


def main():
    if x.Start:
        out(y[1])

    if True:
        end()
"""
        ),
    ),
    right=(
        """
nickname(x.Start, x[1])
nickname(x.SpareButton, x[2])
nickname(y.Lamp, y[3])
nickname(t.Delay, t[7])
nickname(ds.Brightness, ds[9], initial=80, retentive=False, comment="of the panel")


def main():
    if all(x.Start, td.Delay < 100):
        ton(t[7], setpoint=500)
        out(y[1:5])

    if True:
        end()
""",
    ),
)

RULE = Rule(find, (ABOUT,))
