"""A drum's lists fit together, and a jump knows its step (click-facts [drum.inputs, drum.lists])."""

from __future__ import annotations

from clickgen.facts.facts import Facts
from clickgen.instructions.drums import OUTPUTS_MAX, STEPS_MAX
from clickgen.ir.operands import Cell, Integer
from clickgen.ir.program import Action, Operands, Pattern
from clickgen.problems.diagnostics import Label
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding
from clickgen.text.wording import counted


def find(facts: Facts) -> Findings:
    for placed in facts.actions:
        if isinstance(placed.action.args.get("pattern"), Pattern):
            yield from _check_lists(placed.action)
            yield from _check_outputs(placed.action)
            yield from _check_jump(placed.action)


def _steps(action: Action) -> Operands:
    """What ends each step: the events of an event drum, the presets of a time drum."""
    steps = action.args["events" if "events" in action.args else "presets"]
    assert isinstance(steps, Operands)
    return steps


def _check_lists(action: Action) -> Findings:
    outputs, steps, pattern = action.args["outputs"], _steps(action), action.args["pattern"]
    assert isinstance(outputs, Operands)
    assert isinstance(pattern, Pattern)
    is_wrong = False
    for items, most, what in ((outputs, OUTPUTS_MAX, "output"), (steps, STEPS_MAX, "step")):
        if not 1 <= len(items.items) <= most:
            is_wrong = True
            yield finding(
                "CG316",
                items.span,
                f"this {action.spec.name} has {counted(len(items.items), what)}; CLICK takes 1 to {most}",
                "divide it over two drums" if items.items else "write them into the list",
            )
    if is_wrong:
        return
    if len(pattern.rows) != len(steps.items):
        yield finding(
            "CG316",
            pattern.span,
            f"the pattern has {counted(len(pattern.rows), 'row')} for {counted(len(steps.items), 'step')}",
            "write one row for each step",
        )
    wrong = next((n for n, row in enumerate(pattern.rows, 1) if len(row) != len(outputs.items)), None)
    if wrong is not None:
        places = counted(len(pattern.rows[wrong - 1]), "place")
        yield finding(
            "CG316",
            pattern.span,
            f"row {wrong} of the pattern has {places} for {counted(len(outputs.items), 'output')}",
            "write one 0 or 1 for each output into every row",
        )


def _check_outputs(action: Action) -> Findings:
    """Two columns of the pattern cannot drive one bit."""
    outputs = action.args["outputs"]
    assert isinstance(outputs, Operands)
    seen: dict[object, Cell] = {}
    for output in outputs.items:
        if not isinstance(output, Cell):
            continue
        earlier = seen.setdefault(output.address, output)
        if earlier is not output:
            yield finding(
                "CG316",
                output.span,
                f"{output.address} is an output of this {action.spec.name} twice",
                "leave one of them out, with its column of the pattern",
                (Label(earlier.span, "here first"),),
            )


def _check_jump(action: Action) -> Findings:
    step = action.args.get("jump_step")
    steps = len(_steps(action).items)
    if isinstance(step, Integer) and 1 <= steps < step.value <= STEPS_MAX:
        yield finding(
            "CG316", step.span, f"the jump goes to step {step.value} and the drum has {steps}", "name one of its steps"
        )


ABOUT = Code(
    "CG316",
    Severity.ERROR,
    "the lists of a drum do not fit together",
    """
A drum has 1 to 16 steps and 1 to 16 outputs, each output once. Its pattern has one row for each event or
preset, with a 0 or 1 for each output. A jump must go to a step that the drum has.
""",
    wrong=(
        Wrong(
            """
if x[1]:
    event_drum(
        outputs=[y[1], y[2]],
        events=[x[1], x[2], x[3]],
        pattern=[[1, 0], [0, 1]],  # <-
        current_step=ds.Step,
        completion_flag=c.Done,
    ).reset(c.Restart)
""",
        ),
    ),
    right=(
        """
if x[1]:
    event_drum(
        outputs=[y[1], y[2]],
        events=[x[1], x[2], x[3]],
        pattern=[[1, 0], [0, 1], [0, 0]],
        current_step=ds.Step,
        completion_flag=c.Done,
    ).reset(c.Restart)
""",
    ),
)

RULE = Rule(find, (ABOUT,), holds_in_parts=True)
