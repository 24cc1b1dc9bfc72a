"""An edge in a subroutine that does not run in every scan: the change may happen while nobody looks."""

from __future__ import annotations

from clickgen.device.banks import Address
from clickgen.facts.facts import Facts
from clickgen.ir.conditions import Any, Contact, Edge
from clickgen.ir.operands import Cell
from clickgen.ir.walk import leaves
from clickgen.logic.conditions import implies
from clickgen.problems.diagnostics import Label
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

# click-facts [scan.edges]
CODE = "CG514"

_CLOCKS = frozenset(Address("SC", number) for number in range(3, 10))
"""CLICK's clocks: a tick that nobody saw is not missed (click-facts [system.clocks])."""


def find(facts: Facts) -> Findings:
    sometimes = {
        routine.name: condition for routine in facts.program.subroutines if (condition := facts.sometimes(routine))
    }
    edges: dict[tuple[str, Address, Edge], list[Contact]] = {}
    for site in facts.sites:
        if site.routine.name in sometimes:
            for leaf in leaves(site.condition):
                if isinstance(leaf, Contact) and leaf.edge and isinstance(leaf.operand, Cell):
                    edges.setdefault((site.routine.name, leaf.operand.address, leaf.edge), []).append(leaf)
    for (name, address, edge), contacts in edges.items():
        if address in _CLOCKS or not _changes_without(facts, address, name, sometimes):
            continue
        call = facts.calls[name][0].action.span
        went = "on" if edge is Edge.RISE else "off"
        yield finding(
            CODE,
            contacts[0].span,
            f"{name} does not run in every scan: when {facts.shown(address)} goes {went} in between, this edge "
            f"comes late, with the next call, or never",
            f"take the edge in main, in a rung that every scan looks at: set a bit there that {name} resets",
            (
                Label(call, "called under a condition"),
                *(Label(contact.span, "the same edge") for contact in contacts[1:]),
            ),
        )


def _changes_without(facts: Facts, address: Address, name: str, sometimes: dict[str, Any]) -> bool:
    """True if a bit may change in a scan in which the subroutine does not run."""
    uses = facts.uses.writes(address)
    writers = {use.routine.name for use in uses}
    if not writers or facts.uses.is_pointed(address.bank, True):
        return True
    if any(use.action and use.action.effects.is_late for use in uses):
        return True  # A message ends in its own time.
    return not all(
        writer == name or (writer in sometimes and implies(sometimes[writer], sometimes[name])) for writer in writers
    )


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "an edge may be missed in a subroutine that does not always run",
    """
An edge contact compares a bit with what it was when CLICK last looked at this contact. In a subroutine that is not
called, nobody looks. A button that is pressed and released meanwhile is missed; one that is pressed and held makes its
edge as soon as the subroutine runs again, so that a machine starts when somebody only switches the mode.

Take the edge in main, where every scan sees it. `set` a bit there when the press must not be lost, and let the
subroutine reset it; `out` a bit there when a press in another mode must count for nothing.

Bits that change only while the subroutine runs too, and the ticks of CLICK's clocks, are left alone. What `send` and
`receive` report changes in its own time, so it may change in between wherever they are. A conditional `end()` or
`return` in front is not seen.
""",
    wrong=(
        Wrong(
            """
def main():
    if ds.Mode == 2:
        call(manual)
    if True:
        end()


@sub
def manual():
    if re(x.Jog):  # <-
        set(y.Motor)
    if fe(x.Jog):  # <-
        reset(y.Motor)
    if re(x.Jog):
        set(y.Horn)
    if re(x.Part):  # <-
        ctu(ct.Parts, 10, reset=lambda: fe(c.Hold))  # <-
    if True:
        return
"""
        ),
        Wrong(
            """
def main():
    if c.Online:
        call(talk)
    if True:
        end()


@sub
def talk():
    if sc._1sec_Clock:
        receive(ModbusTcpTarget(ip="192.168.1.10"), "DS1", ds[1:5], success=c.Received)
    if re(c.Received):  # <-
        set(c.New)
    if True:
        return
"""
        ),
    ),
    right=(
        """
def main():
    if re(x.Jog):
        set(c.JogSeen)
    if ds.Mode == 2:
        call(manual)
    if True:
        call(auto)
    if sc._Always_ON:
        call(lamps)
    if True:
        end()


@sub
def manual():
    if c.JogSeen:
        set(y.Motor)
        reset(c.JogSeen)
    if x.There:
        out(c.Ready)
        ton(t.Waited, 5)
    if any(re(c.Ready), re(t.Waited), re(sc._1sec_Clock)):
        set(y.Lamp)
    if True:
        return


@sub
def auto():
    if re(x.Start):
        set(y.Motor)
    if True:
        return


@sub
def lamps():
    if re(x.Start):
        set(y.Lamp)
    if True:
        return
""",
        """
def main():
    if c.Auto:
        call(work)
    if nc(c.Auto):
        call(work)
    if all(c.Auto, c.Fast):
        call(steps)
    if c.Auto:
        call(lamps)
    if True:
        end()


@sub
def work():
    if re(x.Start):
        set(y.Motor)
    if True:
        return


@sub
def steps():
    if x.Here:
        out(c.Step)
    if True:
        return


@sub
def lamps():
    if re(c.Step):
        set(y.Lamp)
    if True:
        return
""",
    ),
)

RULE = Rule(find, (ABOUT,))
