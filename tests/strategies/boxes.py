"""Boxes with inputs: timers, counters, shift registers, drums; every input in each spelling."""

from __future__ import annotations

from dataclasses import dataclass, replace

from hypothesis import strategies as st

from strategies.arguments import Given, Shown, bit_list, called, cell, given, sequence
from strategies.conditions import Condition, ladder_name, weighted
from strategies.programs import WAYS, Act, Pin


@dataclass(frozen=True)
class Input:
    """An input that a box can have: the meaning of leaving it out, and the ladder's text for the step of a jump."""

    name: str
    left_out: str = "never"
    """"never": the never-contact is there; "absent": the box does not have it; "": it cannot be left out."""
    step: str = ""


@dataclass(frozen=True)
class Box:
    """A box without its inputs; ``{}`` in its texts is the number of a timer or counter."""

    act: Act
    inputs: tuple[Input, ...]

    @property
    def bottom(self) -> Input:
        """The only input with room for legs below it."""
        return self.inputs[-1]


RESET, DOWN = Input("reset"), Input("count_down", "")
MUST_RESET = Input("reset", "")
CLOCKED = (Input("clock"), RESET)

PINNED = (
    Box(Act("rton(t[{}], 32767, unit=Td)", "on_delay(T{0},TD{0},preset=32767,unit=Td)", 2), (MUST_RESET,)),
    Box(Act("ctu(ct[{}], 5)", "count_up(CT{0},CTD{0},preset=5)", 3), (RESET,)),
    Box(Act("ctd(ct[{}], dd[5])", "count_down(CT{0},CTD{0},preset=DD5)", 3), (RESET,)),
    Box(Act("ctud(ct[{}], ds[5])", "count_up(CT{0},CTD{0},preset=DS5)", 3), (DOWN, RESET)),
    Box(Act("shift(c[1:9])", "shift(C1..C8)", 3), CLOCKED),
    Box(Act("shift(c[8:0:-1])", "shift(C8..C1)", 3), CLOCKED),
)


def pinned(box: Box, pins: tuple[Pin, ...], backwards: bool = False) -> Act:
    return replace(box.act, pins=pins, backwards=backwards)


ways = st.sampled_from(WAYS)


def pins_of(
    draw: st.DrawFn, box: Box, tree: st.SearchStrategy[Condition], short: st.SearchStrategy[Condition]
) -> tuple[Pin, ...]:
    """Some of the inputs that a box can have; ``short`` conditions have no legs."""
    pins: list[Pin] = []
    for one in box.inputs:
        if one.left_out and draw(st.integers(0, 3)) == 0:
            if one.left_out == "never":
                pins.append(Pin(one.name, None))
            continue
        condition = draw(tree if one is box.bottom else short)
        pins.append(Pin(one.name, condition, one.step, draw(ways)))
    return tuple(pins)


def with_inputs(box: Box, tree: st.SearchStrategy[Condition]) -> st.SearchStrategy[Act]:
    """A box with some of its inputs, each with any condition."""
    inputs: list[st.SearchStrategy[Pin | None]] = []
    for one in box.inputs:
        some: st.SearchStrategy[Pin | None] = st.builds(Pin, st.just(one.name), tree, st.just(one.step), ways)
        left: Pin | None = Pin(one.name, None) if one.left_out == "never" else None
        inputs.append(weighted((5, some), (1, st.just(left))) if one.left_out else some)
    return st.builds(
        lambda pins, backwards: pinned(box, tuple(pin for pin in pins if pin is not None), backwards),
        st.tuples(*inputs),
        st.booleans(),
    )


# ---------------------------------------------------------------------------------------------------- drums

_OUTPUTS = [("Y", 1), ("Y", 2), ("Y", 3), ("Y", 16), ("Y", 21), ("Y", 816), ("C", 300), ("C", 301), ("C", 302)]
_OUTPUTS += [("C", 303), ("C", 1), ("C", 2), ("C", 2000), ("C", 400), ("C", 401), ("C", 500), ("C", 501), ("C", 502)]
_EVENTS = [("X", 1), ("X", 2), ("X", 16), ("X", 21), ("Y", 1), ("C", 1), ("C", 2), ("C", 3), ("C", 2000), ("T", 1)]
_EVENTS += [("T", 500), ("CT", 1), ("CT", 250), ("SC", 1), ("SC", 2), ("SC", 1000)]


@dataclass(frozen=True)
class DrumCells:
    """The cells that a drum may use."""

    outputs: tuple[tuple[str, int], ...] = tuple(_OUTPUTS)
    events: tuple[tuple[str, int], ...] = tuple(_EVENTS)
    steps: tuple[int, ...] = (1, 5, 600, 4500)
    """Numbers of DS registers for the current step, and for the step of a jump."""
    flags: tuple[int, ...] = (1, 9, 1999)
    presets: tuple[int, ...] = (1, 10, 4500)
    """Numbers of DS registers for presets."""
    constant_steps: bool = True
    longest: int = 16


def _pattern(draw: st.DrawFn, height: int, width: int) -> Shown:
    rows = draw(st.lists(st.lists(st.booleans(), min_size=width, max_size=width), min_size=height, max_size=height))
    words = draw(st.sampled_from((("0", "1"), ("0", "1"), ("False", "True"))))
    texts = [sequence(draw, [words[bit] for bit in row]) for row in rows]
    return sequence(draw, texts), ",".join(f"[{','.join('1' if bit else '0' for bit in row)}]" for row in rows)


def _presets(draw: st.DrawFn, count: int, registers: tuple[int, ...]) -> Shown:
    shown: list[Shown] = []
    for _ in range(count):
        if draw(st.integers(0, 2)) == 2:
            shown.append(cell("DS", draw(st.sampled_from(registers))))
        else:
            number = str(draw(st.sampled_from((1, 2, 3, 0, 32767))))
            shown.append((number, number))
    return sequence(draw, [text for text, _ in shown]), ",".join(token for _, token in shown)


def _unit(draw: st.DrawFn) -> tuple[str | None, str]:
    unit = draw(st.sampled_from(("", "Tms", "Ts", "Tm", "Th", "Td")))
    return unit or None, unit or "Tms"


@st.composite
def drums(draw: st.DrawFn, cells: DrumCells | None = None) -> Box:
    """Drums of 1 to 16 steps and outputs; the accumulator's number stays open."""
    over = cells or DrumCells()
    lengths = st.one_of(st.integers(1, min(4, over.longest)), st.sampled_from((1, over.longest)))
    steps, count = draw(lengths), min(draw(lengths), len(over.outputs))
    outputs = bit_list(draw, draw(st.lists(st.sampled_from(over.outputs), min_size=count, max_size=count, unique=True)))
    pattern = _pattern(draw, steps, count)
    step = cell("DS", draw(st.sampled_from(over.steps)))
    flag = cell("C", draw(st.sampled_from(over.flags)))
    head, ending = f"outputs=[{outputs[1]}]", f"pattern=[{pattern[1]}],current_step={step[1]}"
    arguments: list[Given]
    if draw(st.booleans()):
        events = bit_list(draw, draw(st.lists(st.sampled_from(over.events), min_size=steps, max_size=steps)))
        arguments = [given("outputs", outputs[0]), given("events", events[0]), given("pattern", pattern[0])]
        arguments += [given("current_step", step[0]), given("completion_flag", flag[0])]
        token = f"event_drum({head},events=[{events[1]}],{ending},completion_flag={flag[1]})"
        call = called(draw, "event_drum", arguments)
    else:
        presets, (unit, unit_token) = _presets(draw, steps, over.presets), _unit(draw)
        arguments = [given("outputs", outputs[0]), given("presets", presets[0]), given("unit", unit)]
        arguments += [given("pattern", pattern[0]), given("current_step", step[0]), given("accumulator", "td[{}]")]
        call = called(draw, "time_drum", [*arguments, given("completion_flag", flag[0])])
        token = f"time_drum({head},presets=[{presets[1]}],unit={unit_token},{ending},accumulator=TD{{}},"
        token += f"completion_flag={flag[1]})"
    jump = ladder_name("DS", draw(st.sampled_from(over.steps)))
    if over.constant_steps and draw(st.booleans()):
        jump = str(draw(st.integers(1, steps)))
    inputs = (MUST_RESET, Input("jump", "absent", jump), Input("jog", "absent"))
    return Box(Act(call, token, 4), inputs)
