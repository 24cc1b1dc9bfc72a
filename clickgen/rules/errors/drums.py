"""A drum's lists fit together, and a jump knows its step (click-facts [drum.inputs, drum.lists])."""

from __future__ import annotations

from clickgen.facts.facts import Facts
from clickgen.instructions.drums import OUTPUTS_MAX, STEPS_MAX
from clickgen.ir.operands import Cell, Integer
from clickgen.ir.program import Action, Operands, Pattern
from clickgen.problems.diagnostics import Diagnostics, Label
from clickgen.text.wording import counted


def check(facts: Facts, problems: Diagnostics) -> None:
    for placed in facts.actions:
        if isinstance(placed.action.args.get("pattern"), Pattern):
            _check_lists(placed.action, problems)
            _check_outputs(placed.action, problems)
            _check_jump(placed.action, problems)


def _steps(action: Action) -> Operands:
    """What ends each step: the events of an event drum, the presets of a time drum."""
    steps = action.args["events" if "events" in action.args else "presets"]
    assert isinstance(steps, Operands)
    return steps


def _check_lists(action: Action, problems: Diagnostics) -> None:
    outputs, steps, pattern = action.args["outputs"], _steps(action), action.args["pattern"]
    assert isinstance(outputs, Operands)
    assert isinstance(pattern, Pattern)
    before = len(problems.found)
    for items, most, what in ((outputs, OUTPUTS_MAX, "output"), (steps, STEPS_MAX, "step")):
        if not 1 <= len(items.items) <= most:
            problems.add(
                "CG316",
                items.span,
                f"this {action.spec.name} has {counted(len(items.items), what)}; CLICK takes 1 to {most}",
                "divide it over two drums" if items.items else "write them into the list",
            )
    if len(problems.found) > before:
        return
    if len(pattern.rows) != len(steps.items):
        problems.add(
            "CG316",
            pattern.span,
            f"the pattern has {counted(len(pattern.rows), 'row')} for {counted(len(steps.items), 'step')}",
            "write one row for each step",
        )
    wrong = next((n for n, row in enumerate(pattern.rows, 1) if len(row) != len(outputs.items)), None)
    if wrong is not None:
        places = counted(len(pattern.rows[wrong - 1]), "place")
        problems.add(
            "CG316",
            pattern.span,
            f"row {wrong} of the pattern has {places} for {counted(len(outputs.items), 'output')}",
            "write one 0 or 1 for each output into every row",
        )


def _check_outputs(action: Action, problems: Diagnostics) -> None:
    """Two columns of the pattern cannot drive one bit."""
    outputs = action.args["outputs"]
    assert isinstance(outputs, Operands)
    seen: dict[object, Cell] = {}
    for output in outputs.items:
        if not isinstance(output, Cell):
            continue
        earlier = seen.setdefault(output.address, output)
        if earlier is not output:
            problems.add(
                "CG316",
                output.span,
                f"{output.address} is an output of this {action.spec.name} twice",
                "leave one of them out, with its column of the pattern",
                (Label(earlier.span, "here first"),),
            )


def _check_jump(action: Action, problems: Diagnostics) -> None:
    step = action.args.get("jump_step")
    steps = len(_steps(action).items)
    if isinstance(step, Integer) and 1 <= steps < step.value <= STEPS_MAX:
        problems.add(
            "CG316", step.span, f"the jump goes to step {step.value} and the drum has {steps}", "name one of its steps"
        )
