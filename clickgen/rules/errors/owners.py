"""One timer or counter number has one instruction (C010A, C010B; click-facts [timer.owner])."""

from __future__ import annotations

from clickgen.device.banks import CURRENT_VALUE_OF, Address
from clickgen.facts.facts import Facts
from clickgen.instructions.spec import Access
from clickgen.ir.operands import Cell
from clickgen.ir.program import Action
from clickgen.problems.diagnostics import Label
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding


def find(facts: Facts) -> Findings:
    owners: dict[Address, Action] = {}
    for placed in facts.actions:
        for param in placed.spec.params:
            operand = placed.action.args.get(param.name)
            if param.slot.access is not Access.OWN or not isinstance(operand, Cell):
                continue
            if operand.bank not in param.slot.cells:
                continue
            number = Address(CURRENT_VALUE_OF.get(operand.bank, operand.bank), operand.address.number)
            earlier = owners.setdefault(number, placed.action)
            if earlier is not placed.action:
                kind = "counter" if number.bank == "CT" else "timer"
                yield finding(
                    "CG412",
                    operand.span,
                    f"{operand.address} belongs to the {earlier.spec.name} of "
                    f"{earlier.span.seen_from(operand.span)} already",
                    f"give this {kind} another name",
                    (Label(earlier.span, "its first owner"),),
                )


ABOUT = Code(
    "CG412",
    Severity.ERROR,
    "a timer or counter has two owners",
    """
Each timer or counter number belongs to one instruction in the whole program (C010A, C010B), and the
accumulator of a time drum uses the number of a timer. Give each instruction its own name, and combine their bits in a
rung.
""",
    wrong=(
        Wrong(
            """
if c.Fast:
    ton(t.Delay, 5, Ts)
if c.Slow:
    ton(t.Delay, 50, Ts)  # <-
""",
        ),
    ),
    right=(
        """
if c.Fast:
    copy(5, ds.DelayTime)
if c.Slow:
    copy(50, ds.DelayTime)
if any(c.Fast, c.Slow):
    ton(t.Delay, ds.DelayTime, Ts)
""",
    ),
)

RULE = Rule(find, (ABOUT,), holds_in_parts=True)
