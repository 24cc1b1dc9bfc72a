"""Checks that the source and the emitted ladder do the same, scan by scan.

Two small interpreters share what an instruction does and what a contact reads (``judges.machine``); they get their
conditions from different places. The source evaluates every condition of a rung, inputs of boxes included, and then
runs its instructions. The ladder does the same for each CLICK rung, with the power that ``judges.power`` finds in the
drawing.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass

from strategies.conditions import Condition, leaves, solve
from strategies.programs import Act, Branch, Item, Loop, Program, Rung

from .builds import ladder_files
from .machine import HIDDEN, Machine, Place, is_users
from .power import LadderRung, Terminal, condition_tokens, power, read_ladder

SCANS, SEEDS = 24, 3


class Leave(Exception):
    """A return() or an end() that had power."""


# ---------------------------------------------------------------------------------------------------- the source


@dataclass(frozen=True)
class Step:
    """An instruction of the source waiting for its turn, with the power that it got."""

    item: Act | Loop
    place: Place
    enable: bool
    pins: Mapping[str, bool]


class SourceForm:
    def __init__(self, program: Program, machine: Machine) -> None:
        self.machine = machine
        self.routines = {"main": program.main, **dict(program.subroutines)}
        self.tokens: dict[Place, list[str]] = {}

    def scan(self) -> None:
        with suppress(Leave):
            self.rungs(self.routines["main"], ("main",))

    def rungs(self, rungs: Sequence[Rung], place: Place) -> None:
        for number, rung in enumerate(rungs):
            self.rung(rung, (*place, number))

    def rung(self, rung: Rung, place: Place) -> None:
        if place not in self.tokens:
            found = (leaf.leaf for one in _conditions(rung.condition, rung.items) for leaf in leaves(one))
            self.tokens[place] = list(dict.fromkeys(found))
        sets = self.machine.look(self.tokens[place], place)
        for step in list(self.steps(rung.condition, rung.items, place, True, sets)):
            if isinstance(step.item, Loop):
                for _ in range(step.item.count if step.enable else 0):
                    self.rungs(step.item.body, step.place)
            else:
                self.act(step, step.item)

    def steps(
        self, condition: Condition, items: Sequence[Item], place: Place, enable: bool, sets: Mapping[str, int]
    ) -> Iterator[Step]:
        enable = enable and bool(solve(condition, sets, 1))
        for number, item in enumerate(items):
            where = (*place, number)
            if isinstance(item, Branch):
                yield from self.steps(item.condition, item.items, where, enable, sets)
            elif isinstance(item, Loop):
                yield Step(item, where, enable, {})
            else:
                pins = {
                    pin.token: pin.condition is not None and bool(solve(pin.condition, sets, 1)) for pin in item.pins
                }
                yield Step(item, where, enable, pins)

    def act(self, step: Step, act: Act) -> None:
        if act.token in ("return()", "end()"):
            if step.enable:
                raise Leave
        elif act.token.startswith("call("):
            if step.enable:
                name = act.token[6:-2]
                with suppress(Leave):
                    self.rungs(self.routines[name], (name,))
        else:
            self.machine.run(act.token, step.place, step.enable, step.pins)


def _conditions(condition: Condition, items: Sequence[Item]) -> Iterator[Condition]:
    """Everything that a rung looks at before its first instruction; the rungs of a loop's body look for themselves."""
    yield condition
    for item in items:
        if isinstance(item, Branch):
            yield from _conditions(item.condition, item.items)
        elif isinstance(item, Act):
            yield from (pin.condition for pin in item.pins if pin.condition is not None)


# ---------------------------------------------------------------------------------------------------- the ladder


class Drawing:
    """One CLICK rung: the contacts that it looks at, and where they send power."""

    def __init__(self, rung: LadderRung) -> None:
        self.rung = rung
        self.tokens = condition_tokens(rung)
        self.outputs = rung.outputs()
        self.known: dict[tuple[int, ...], dict[Terminal, bool]] = {}

    def power(self, values: Mapping[str, int]) -> dict[Terminal, bool]:
        key = tuple(values.values())
        if key not in self.known:
            self.known[key] = power(self.rung, lambda token: bool(values[token]))
        return self.known[key]


def drawings(files: Mapping[str, str]) -> dict[str, list[Drawing]]:
    """The CLICK rungs of every routine; the parts of main one after the other."""
    routines: dict[str, list[Drawing]] = {"main": []}
    for name, text in files.items():
        routine = "main" if name.startswith("main") else name.removeprefix("subroutines/").removesuffix(".csv")
        routines.setdefault(routine, []).extend(map(Drawing, read_ladder(text)))
    return routines


class LadderForm:
    def __init__(self, routines: Mapping[str, list[Drawing]], machine: Machine) -> None:
        self.machine = machine
        self.routines = routines

    def scan(self) -> None:
        with suppress(Leave):
            self.rungs("main", 0, len(self.routines["main"]))

    def rungs(self, routine: str, start: int, stop: int) -> None:
        at = start
        while at < stop:
            drawing = self.routines[routine][at]
            power = drawing.power(self.machine.look(drawing.tokens, (routine, at)))
            at += 1
            for number, output in enumerate(drawing.outputs):
                enable = power[Terminal(number, "")]
                name = output.token.partition("(")[0]
                if name == "for":
                    end = next(n for n in range(at, stop) if self.routines[routine][n].outputs[0].token == "next()")
                    for _ in range(int(output.token[4:-1]) if enable else 0):
                        self.rungs(routine, at, end)
                    at = end + 1
                elif name in ("return", "end"):
                    if enable:
                        raise Leave
                elif name == "call":
                    if enable:
                        callee = output.token[6:-2]
                        with suppress(Leave):
                            self.rungs(callee, 0, len(self.routines[callee]))
                elif name not in ("next", "NOP"):
                    pins = {pin.token: power[Terminal(number, pin.token)] for pin in output.pins}
                    self.machine.run(output.token, (routine, at, number), enable, pins)


# ---------------------------------------------------------------------------------------------------- the comparison


def check_meaning(program: Program, inputs_move: bool = False, seeds: int = SEEDS) -> None:
    """Check that source and ladder leave the same memory and show the same power to each box, scan by scan."""
    check_same(program, ladder_files(program.texts), inputs_move, seeds)


def check_same(program: Program, files: Mapping[str, str], inputs_move: bool = False, seeds: int = SEEDS) -> None:
    """Check that a source and the ladder of these files leave the same memory and show the same power to each box."""
    routines = drawings(files)
    hidden = frozenset(_off_delays(program))
    for edges_by_bit in (False, True):
        for seed in range(seeds):
            bits_follow = seed % 2 == 0
            source = SourceForm(program, Machine(seed, edges_by_bit, inputs_move, bits_follow, hidden))
            ladder = LadderForm(routines, Machine(seed, edges_by_bit, inputs_move, bits_follow))
            for scan in range(SCANS):
                for form in (source, ladder):
                    form.machine.begin_scan()
                    form.scan()
                    form.machine.end_scan()
                where = f"scan {scan + 1}, seed {seed}, edges {'by bit' if edges_by_bit else 'by contact'}"
                assert source.machine.seen == ladder.machine.seen, f"{where}: the boxes saw other power"
                assert visible(source.machine) == visible(ladder.machine), f"{where}: the memory differs"


def _off_delays(program: Program) -> Iterator[str]:
    """The timers of the source that CLICK does not have."""

    def acts(items: Sequence[Item]) -> Iterator[Act]:
        for item in items:
            if isinstance(item, Act):
                yield item
            elif isinstance(item, Branch):
                yield from acts(item.items)
            else:
                for rung in item.body:
                    yield from acts(rung.items)

    for rung in (*program.main, *(rung for _, rungs in program.subroutines for rung in rungs)):
        for act in acts(rung.items):
            if act.token.startswith("off_delay(") and act.pins:
                yield act.token[len("off_delay(") :].partition(",")[0]


def visible(machine: Machine) -> dict[str, int]:
    """The memory that a person may look at: no scratch, no flags, and for an rtof the timer inside."""
    found = {name: value for name, value in machine.memory.items() if value and is_users(name) and name[:2] != "SC"}
    for name in machine.hidden:
        found.pop(name, None)
        if HIDDEN + name in found:
            found[name] = found.pop(HIDDEN + name)
    return found
