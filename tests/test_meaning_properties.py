"""Splitting keeps the meaning: the source and the emitted ladder do the same, scan by scan.

Two small interpreters share what an instruction does and what a contact reads; they differ in where conditions come
from. The source evaluates every condition of a rung, inputs of boxes included, and then runs its instructions. The
ladder does the same for each CLICK rung, with the power that ``judges.power`` finds in the drawing.
"""

from __future__ import annotations

import operator
import random
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cache
from typing import ClassVar

import pytest
from hypothesis import given, note, settings
from judges.power import LadderRung, Terminal, condition_tokens, power, read_ladder
from strategies import (
    ALWAYS,
    PIN_TOKENS,
    Act,
    Branch,
    Condition,
    Contact,
    Item,
    Loop,
    Program,
    Rung,
    leaves,
    meaning_programs,
    solve,
)
from test_power_properties import ladder_files

Place = tuple[object, ...]
OPERATORS: Mapping[str, Callable[[int, int], bool]] = {
    "==": operator.eq, "!=": operator.ne, "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge,
}  # fmt: skip
SCANS, SEEDS = 24, 3
HIDDEN = "~"
"""Marks the bit of the on-delay timer inside an rtof; its number is the retentive off-delay's own in the source."""


class Leave(Exception):
    """A return() or an end() that had power."""


@dataclass
class Machine:
    """The memory of a PLC and what its instructions do to it, simplified alike for source and ladder."""

    seed: int
    edges_by_bit: bool
    inputs_move: bool
    memory: dict[str, int] = field(default_factory=dict)
    scan: int = 0
    clock: int = 0
    """Counts what was written in this scan: immediate inputs may change with it."""
    seen: list[tuple[object, ...]] = field(default_factory=list)
    """Each box that ran, with the power on its inputs."""
    before: dict[str, int] = field(default_factory=dict)
    edges: dict[Place, int] = field(default_factory=dict)
    once: dict[Place, bool] = field(default_factory=dict)
    off_delays: set[str] = field(default_factory=set)
    """Retentive off-delay timers that the source has run."""

    def __post_init__(self) -> None:
        draw = random.Random(self.seed)
        for bank, count in (("C", 8), ("Y", 3), ("CT", 20)):
            for number in range(1, count + 1):
                self.memory[f"{bank}{number:03d}" if bank == "Y" else f"{bank}{number}"] = draw.randrange(2)
        for name in ("DS1", "DS2", "DS3", "DD1", "DH1"):
            self.memory[name] = draw.randrange(4)
        self.before = dict(self.memory)

    def begin_scan(self) -> None:
        self.scan += 1
        self.clock = 0
        draw = random.Random(f"{self.seed} {self.scan}")
        for number in range(1, 17):
            self.memory[f"X{number:03d}"] = draw.randrange(2)

    def end_scan(self) -> None:
        self.before = dict(self.memory)

    # -- reading

    def bit(self, name: str) -> int:
        return 1 if name == "SC1" else self.memory.get(name, 0)

    def value(self, name: str) -> int:
        if not name[0].isalpha():
            return int(name[:-1], 16) if name.endswith("h") else int(name)
        if name in ("XD0", "YD0"):
            return sum(self.bit(f"{name[0]}{number:03d}") << number - 1 for number in range(1, 17))
        return self.memory.get(self.pointed(name), 0)

    def pointed(self, name: str) -> str:
        """The cell itself, or the one that a pointer leads to: one of the first four, whatever the register holds."""
        bank, _, register = name.partition("[")
        return f"{bank}{1 + abs(self.value(register[:-1])) % 4}" if register else name

    def leaf(self, token: str, place: Place) -> int:
        kind, name, other = parsed_leaf(token)
        if kind in OPERATORS:
            return int(OPERATORS[kind](self.value(name), self.value(other)))
        if not kind:
            return self.bit(name)
        if kind == "immediate":
            moment = self.clock if self.inputs_move else 0
            return random.Random(f"{self.seed} {self.scan} {name} {moment}").randrange(2)
        now, key = self.bit(name), (place, token)
        before = self.before.get(name, 0) if self.edges_by_bit else self.edges.get(key, 0)
        self.edges[key] = now
        return int(now > before if kind == "rise" else now < before)

    def look(self, tokens: Sequence[str], place: Place) -> dict[str, int]:
        """Every contact of a rung at one moment."""
        return {token: self.leaf(token, place) for token in tokens}

    # -- writing

    def store(self, name: str, value: int) -> None:
        name = self.pointed(name)
        if name in ("XD0", "YD0"):
            for number in range(1, 17):
                self.store(f"{name[0]}{number:03d}", value >> number - 1 & 1)
            return
        self.memory[name] = value
        self.clock += is_users(name)

    def run(self, token: str, place: Place, enable: bool, pins: Mapping[str, bool]) -> None:
        name, _, rest = token.partition("(")
        inner = rest[:-1]
        if inner.endswith(",oneshot=1"):
            inner, last = inner[:-10], self.once.get(place, False)
            self.once[place] = enable
            enable = enable and not last
        if name == "out":
            for bit in cells(inner):
                self.store(bit, int(enable))
        elif name in ("on_delay", "off_delay", "count_up", "count_down", "shift"):
            self.box(name, inner, enable, pins)
        elif enable:
            self.instructions[name](self, inner)

    def box(self, name: str, inner: str, enable: bool, pins: Mapping[str, bool]) -> None:
        own, _, rest = inner.partition(",")
        retentive_off = name == "off_delay" and bool(pins)
        self.seen.append((own, enable != retentive_off, *sorted(pins.items())))
        reset = pins.get(".reset()", False)
        if name == "shift":
            bits = cells(inner)
            if reset or pins[".clock()"]:
                moved = [0] * len(bits) if reset else [int(enable), *(self.bit(bit) for bit in bits[:-1])]
                for bit, value in zip(bits, moved, strict=True):
                    self.store(bit, value)
            return
        count, preset = rest.split(",")[0], self.value(rest.split(",")[1].removeprefix("preset="))
        done = HIDDEN + own if retentive_off else own
        so_far = self.memory.get(count, 0)
        if name == "off_delay" and not pins:
            on = enable or (bool(self.bit(own)) and so_far + 1 < preset)
            self.store(count, so_far + 1 if on and not enable else 0)
            self.store(own, int(on))
            return
        running = enable != retentive_off
        if reset or (name == "on_delay" and not pins and not running):
            so_far, on = 0, False
        else:
            down = name == "count_down"
            so_far += running * (-1 if down else 1) - pins.get(".down()", False)
            on = so_far <= -preset if down else so_far >= preset
            if name == "on_delay" and not running:
                on = bool(self.bit(done))
        self.store(count, so_far)
        self.store(done, int(on))
        if retentive_off:
            self.off_delays.add(own)
            # decisions.md: Q is on when E, or when Q and not T.
            self.memory[own] = int(enable or (bool(self.bit(own)) and not on))

    def latch(self, inner: str) -> None:
        for bit in cells(inner):
            self.store(bit, 1)

    def unlatch(self, inner: str) -> None:
        for bit in cells(inner):
            self.store(bit, 0)

    def copy(self, inner: str) -> None:
        source, target = inner.split(",")
        value = self.value(source)
        self.store(target, value)
        if not is_users(target):
            return  # a copy that clickgen adds; programs that look at the flags make it add none
        self.memory["SC43"] = int(value > 2)
        self.memory["SC44"] = int("[" in inner and value == 0)

    def fill(self, inner: str) -> None:
        source, target = inner.split(",")
        for cell in cells(target):
            self.store(cell, self.value(source))

    def blockcopy(self, inner: str) -> None:
        source, target = map(cells, inner.split(","))
        for value, cell in zip([self.value(cell) for cell in source], target, strict=True):
            self.store(cell, value)

    def pack(self, inner: str) -> None:
        source, target = inner.split(",")
        self.store(target, sum(self.bit(bit) << place for place, bit in enumerate(cells(source))))

    def unpack(self, inner: str) -> None:
        source, target = inner.split(",")
        for place, bit in enumerate(cells(target)):
            self.store(bit, self.value(source) >> place & 1)

    def math(self, inner: str) -> None:
        formula, target, _ = inner.split(",")
        left, right = formula.split(" + ")
        total = self.value(left) + self.value(right)
        self.store(target, total % 5)
        self.memory["SC40"], self.memory["SC43"] = int(total == 1), int(total >= 5)

    def search(self, inner: str) -> None:
        where, result, flag = inner.split(",")
        found, _, value = where.split(" ")
        hits = [cell for cell in cells(found) if self.value(cell) == int(value)]
        self.store(result.removeprefix("result="), int(hits[0][2:]) if hits else -1)
        self.store(flag.removeprefix("found="), int(bool(hits)))

    instructions: ClassVar[dict[str, Callable[[Machine, str], None]]] = {
        "latch": latch, "reset": unlatch, "copy": copy, "fill": fill, "blockcopy": blockcopy, "math": math,
        "pack_bits": pack, "unpack_to_bits": unpack, "search": search,
    }  # fmt: skip


@cache
def parsed_leaf(token: str) -> tuple[str, str, str]:
    """``DS1==5`` as its operator and sides, ``rise(C1)`` as its word and bit."""
    compare = re.fullmatch(r"(.+?)(==|!=|<=|>=|<|>)(.+)", token)
    if compare:
        return compare[2], compare[1], compare[3]
    word, _, bit = token.rpartition("(")
    return word, bit.rstrip(")"), ""


@cache
def cells(text: str) -> Sequence[str]:
    """``C1..C3`` and ``immediate(Y001)`` as single names; ``C3..C1`` runs backwards."""
    match = re.fullmatch(r"(?:immediate\()?([A-Z]+)(\d+)(?:\.\.[A-Z]+(\d+))?\)?", text)
    assert match, text
    bank, first = match[1], int(match[2])
    last = int(match[3] or first)
    digits = 3 if bank in ("X", "Y") else 1
    return [f"{bank}{n:0{digits}d}" for n in range(first, last + 1)] or [
        f"{bank}{n:0{digits}d}" for n in range(first, last - 1, -1)
    ]


@cache
def is_users(name: str) -> bool:
    """False for scratch cells, which stand at the top of their banks."""
    match = re.fullmatch(r"(C|DS|DD|DH|DF)(\d+)", name)
    return not match or int(match[2]) <= 100


# ---------------------------------------------------------------------------------------------------- the source


@dataclass(frozen=True)
class Step:
    """An instruction of the source that waits for its turn, with the power that it got."""

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
                pins = {PIN_TOKENS[name]: pin is not None and bool(solve(pin, sets, 1)) for name, pin in item.pins}
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
    """All that a rung looks at before its first instruction; the rungs of a loop's body look for themselves."""
    yield condition
    for item in items:
        if isinstance(item, Branch):
            yield from _conditions(item.condition, item.items)
        elif isinstance(item, Act):
            yield from (pin for _, pin in item.pins if pin is not None)


# ---------------------------------------------------------------------------------------------------- the ladder


class Drawing:
    """One CLICK rung: which contacts it looks at, and where they send power."""

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
    """The CLICK rungs of every routine; the parts of main one behind the other."""
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
    """Source and ladder leave the same memory and show the same power to each box, scan by scan."""
    routines = drawings(ladder_files(program.text))
    for edges_by_bit in (False, True):
        for seed in range(seeds):
            source = SourceForm(program, Machine(seed, edges_by_bit, inputs_move))
            ladder = LadderForm(routines, Machine(seed, edges_by_bit, inputs_move))
            for scan in range(SCANS):
                for form in (source, ladder):
                    form.machine.begin_scan()
                    form.scan()
                    form.machine.end_scan()
                where = f"scan {scan + 1}, seed {seed}, edges {'by bit' if edges_by_bit else 'by contact'}"
                assert source.machine.seen == ladder.machine.seen, f"{where}: the boxes saw other power"
                assert visible(source.machine) == visible(ladder.machine), f"{where}: the memory differs"


def visible(machine: Machine) -> dict[str, int]:
    """The memory as a person may look at it: no scratch, no flags, and of an rtof the timer inside."""
    found = {name: value for name, value in machine.memory.items() if value and is_users(name) and name[:2] != "SC"}
    for name in machine.off_delays:
        found.pop(name, None)
        if HIDDEN + name in found:
            found[name] = found.pop(HIDDEN + name)
    return found


@given(meaning_programs())
@settings(max_examples=200, deadline=None, print_blob=True)
def test_the_ladder_does_what_the_source_says(program: Program) -> None:
    note(program.text)
    check_meaning(program)


@given(meaning_programs(immediate_places="rungs"))
@settings(max_examples=80, deadline=None, print_blob=True)
def test_a_rung_looks_at_a_moving_input_once(program: Program) -> None:
    """An immediate contact of a rung's own condition is the same for all of its instructions."""
    note(program.text)
    check_meaning(program, inputs_move=True)


def _out(number: int) -> Act:
    return Act(f"out(c[{number}])", f"out(C{number})")


def _ctu(number: int, reset: Condition) -> Act:
    return Act(f"ctu(ct[{number}], 2)", f"count_up(CT{number},CTD{number},preset=2)", 3, (("reset", reset),))


def _program(*main: Rung, other: tuple[Rung, ...] = ()) -> Program:
    return Program(main, (("other", other),))


X1, X2, X3, RISE = Contact("X001"), Contact("X002"), Contact("X003"), Contact("X003", "re")
END, RETURN, CALL = Act("end()", "end()"), Act("return", "return()"), Act("call(other)", 'call("other")')
RTOF = Act("rtof(t[11], 2)", "off_delay(T11,TD11,preset=2,unit=Tms)", 2, (("reset", X3),))
CALLS = Rung(ALWAYS, (CALL,))
TIMED = Branch(Contact("T11"), (_out(5),))

FOUND: dict[str, Program] = {
    "an edge on an input behind an end": _program(Rung(X1, (Branch(X2, (END,)), _ctu(13, RISE)))),
    "an edge on an input behind a return": _program(CALLS, other=(Rung(X1, (Branch(X2, (RETURN,)), _ctu(13, RISE))),)),
    "an edge behind a loop that returns": _program(
        CALLS, other=(Rung(RISE, (Loop(1, (Rung(X2, (RETURN,)),)), _out(1))),)
    ),
    "an edge behind a loop that ends": _program(Rung(X1, (Loop(1, (Rung(X2, (END,)),)), Branch(RISE, (_out(1),))))),
    "the bit of an rtof behind a loop with it": _program(Rung(X1, (Loop(1, (Rung(X2, (RTOF,)),)), TIMED))),
    "the bit of an rtof behind a call of it": _program(
        Rung(X1, (CALL, _ctu(13, X3), TIMED)), other=(Rung(X2, (RTOF,)),)
    ),
    "an input behind a pointer": _program(
        Rung(X1, (Act("copy(x[2], c[ds[1]])", "copy(X002,C[DS1])", 2), _ctu(13, Contact("C2"))))
    ),
    "an input behind its word": _program(
        Rung(X1, (Act("copy(dh[1], yd[0])", "copy(DH1,YD0)", 2), _ctu(13, Contact("Y001")))),
        Rung(X2, (Act('math_hex("dh[1] + dh[1]", dh[1])', "math(DH1 + DH1,DH1,mode=hex)"),)),
    ),
    "a one-shot formula with a pointer": _program(
        Rung(X2, (Act("copy(1, ds[1])", "copy(1,DS1)", 2),)),
        Rung(X1, (Act('calc("ds[ds[1]] + 1", ds[1], oneshot=True)', "math(DS[DS1] + 1,DS1,mode=decimal,oneshot=1)"),)),
    ),
    "True in True": _program(Rung(ALWAYS, (Branch(ALWAYS, (_out(1), _ctu(13, X3))),))),
}
"""Programs that went wrong once, or that random ones seldom come near."""


@pytest.mark.parametrize("name", FOUND)
def test_what_was_found(name: str) -> None:
    check_meaning(FOUND[name], seeds=20)
    check_meaning(FOUND[name], inputs_move=True, seeds=20)


MEANING = {
    "meaning": (meaning_programs(), check_meaning),
    "moving inputs": (meaning_programs("rungs"), lambda one: check_meaning(one, inputs_move=True)),
}
"""Each property with its examples, for ``fuzz.py``."""
