"""The memory of a PLC and what its instructions do to it, simplified: the same for a source and for its ladder.

What an instruction reads and writes, and when, is true to CLICK. The rest, how a drum steps or what a partner answers,
is made up, as long as it depends on everything that the instruction looks at.
"""

from __future__ import annotations

import operator
import random
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache, lru_cache
from typing import ClassVar

Place = tuple[object, ...]
OPERATORS: Mapping[str, Callable[[int, int], bool]] = {
    "==": operator.eq, "!=": operator.ne, "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge,
}  # fmt: skip
MOVING = ("SC4", "SC7", "SD26")
"""System points that change by themselves."""
HIDDEN = "~"
"""Marks the bit of the on-delay timer inside an rtof; in the source its number is that of the retentive off-delay."""
BOXES = ("on_delay", "off_delay", "count_up", "count_down", "shift", "event_drum", "time_drum")


@dataclass
class DrumState:
    """A drum's memory of the previous scan: its events and its edge inputs."""

    events: list[int]
    jump: bool = False
    jog: bool = False


@dataclass
class Machine:
    seed: int
    edges_by_bit: bool
    inputs_move: bool
    """Immediate inputs, system bits, and cells that messages fill change between two instructions."""
    bits_follow: bool = False
    """The bit of a timer or counter follows at once when another instruction writes its current value."""
    hidden: frozenset[str] = frozenset()
    """The timers of the source that are an rtof, ``T11``: their current value belongs to the timer inside."""
    memory: dict[str, int] = field(default_factory=dict)
    scan: int = 0
    clock: int = 0
    """Counts the writes in this scan: immediate inputs may change with it."""
    seen: list[tuple[object, ...]] = field(default_factory=list)
    """Each box that ran, with the power on its inputs."""
    before: dict[str, int] = field(default_factory=dict)
    edges: dict[Place, int] = field(default_factory=dict)
    once: dict[Place, bool] = field(default_factory=dict)
    drums: dict[Place, DrumState] = field(default_factory=dict)
    arriving: dict[str, int] = field(default_factory=dict)
    """The cells that executed messages write, each with its number of possible values: they may also arrive later."""

    def __post_init__(self) -> None:
        draw = random.Random(self.seed)
        for bank, count in (("C", 8), ("Y", 3), ("CT", 20)):
            for number in range(1, count + 1):
                self.memory[f"{bank}{number:03d}" if bank == "Y" else f"{bank}{number}"] = draw.randrange(2)
        for name in ("DS1", "DS2", "DS3", "DD1", "DH1"):
            self.memory[name] = draw.randrange(4)
        for name in ("TXT1", "TXT2", "TXT3"):
            self.memory[name] = ord("0") + draw.randrange(3)
        self.before = dict(self.memory)

    def begin_scan(self) -> None:
        self.scan += 1
        self.clock = 0
        self.memory.update(inputs(self.seed, self.scan))

    def end_scan(self) -> None:
        self.before = dict(self.memory)

    # -- reading

    def bit(self, name: str) -> int:
        if name == "SC1":
            return 1
        return self.moving(name) if name in MOVING else self.memory.get(name, 0)

    def moving(self, name: str, values: int = 2) -> int:
        """The value of a cell that changes by itself: it stays until the next instruction writes."""
        moment = self.clock if self.inputs_move else 0
        return drawn(f"{self.seed} {self.scan} {name} {moment}", values)

    def value(self, name: str) -> int:
        if name.startswith('"'):
            return ord(name[1])
        if not name[0].isalpha():
            return int(name[:-1], 16) if name.endswith("h") else int(name)
        if name in MOVING:
            return self.moving(name, 4)
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
            return self.moving(name)
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
        bit = name.replace("TD", "T")
        if self.bits_follow and bit != name:
            self.memory[HIDDEN + bit if bit in self.hidden else bit] = int(value >= 2)
        if is_users(name):
            self.clock += 1
            self.arrive()

    def arrive(self) -> None:
        """Let another device answer now."""
        draw = random.Random(f"{self.seed} {self.scan} {self.clock} arrives")
        if self.inputs_move and self.arriving and draw.randrange(2):
            name = draw.choice(sorted(self.arriving))
            self.memory[name] = draw.randrange(self.arriving[name])

    def run(self, token: str, place: Place, enable: bool, pins: Mapping[str, bool]) -> None:
        name, _, rest = token.partition("(")
        inner = rest[:-1]
        if ",oneshot=1" in inner:
            inner, last = inner.replace(",oneshot=1", ""), self.once.get(place, False)
            self.once[place] = enable
            enable = enable and not last
        if name == "out":
            for bit in cells(inner):
                self.store(bit, int(enable))
        elif name in BOXES:
            self.box(name, inner, place, enable, pins)
        elif enable:
            self.instructions[name](self, inner)

    # -- boxes

    def box(self, name: str, inner: str, place: Place, enable: bool, pins: Mapping[str, bool]) -> None:
        if name.endswith("drum"):
            self.drum(inner, place, enable, pins)
            return
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
            if name in ("on_delay", "off_delay") and not running:
                on = bool(self.bit(done))
        self.store(count, so_far)
        self.store(done, int(on))
        if retentive_off:
            # Q is on when E, or when Q and not T (click-facts [timer.no-rtof]).
            self.memory[own] = int(enable or (bool(self.bit(own)) and not on))

    def drum(self, inner: str, place: Place, enable: bool, pins: Mapping[str, bool]) -> None:
        """Step on with the event or the time of the step, with jog, or to where a jump leads; reset comes first."""
        given = arguments(inner)
        events, presets = listed(given.get("events", "")), listed(given.get("presets", ""))
        rows = given["pattern"].strip("[]").split("],[")
        jump = next((token for token in pins if token.startswith(".jump(")), "")
        target = self.value(jump[6:-1]) if jump else 0
        power = {"reset": pins[".reset()"], "jump": pins.get(jump, False), "jog": pins.get(".jog()", False)}
        now = [self.bit(event) for event in events]
        # Except the events, for which the ladder may name another bit: an rtof's is a scratch bit there.
        own = {name: text for name, text in given.items() if name != "events"}
        self.seen.append((*own.items(), *now, enable, target, *power.items()))

        state = self.drums.setdefault(place, DrumState(now))
        at, time = (self.value(given["current_step"]) - 1) % len(rows), 1
        done = bool(self.bit(given["completion_flag"]))
        if presets:
            time = self.value(given["accumulator"]) + 1
        is_over = time >= self.value(presets[at]) if presets else now[at] > state.events[at]
        if power["reset"]:
            at, time, done = 0, 0, False
        elif power["jump"] and not state.jump:
            at, time = (target - 1) % len(rows), 0
        elif enable and (is_over or (power["jog"] and not state.jog)):
            at, time, done = min(at + 1, len(rows) - 1), 0, done or at + 1 == len(rows)
        elif not enable:
            time -= 1
        self.drums[place] = DrumState(now, power["jump"], power["jog"])
        for output, bit in zip(listed(given["outputs"]), rows[at].split(","), strict=True):
            self.store(output, int(bit) if enable else 0)
        self.store(given["current_step"], at + 1)
        self.store(given["completion_flag"], int(done))
        if presets:
            self.store(given["accumulator"], time)

    # -- instructions that do something only with power

    def latch(self, inner: str) -> None:
        for bit in cells(inner):
            self.store(bit, 1)

    def unlatch(self, inner: str) -> None:
        for bit in cells(inner):
            self.store(bit, 0)

    def copy(self, inner: str) -> None:
        what, _, option = inner.partition(",convert=")
        source, target = what.split(",")
        if source.startswith('"') or option.startswith("to_text"):
            self.copy_text(source, target, option)
            return
        value = self.value(source)
        self.store(target, value % 10 if option == "to_value" else value)
        if not is_users(target):
            return  # a copy that clickgen adds; programs that look at the flags make it add none
        self.memory["SC43"] = int(value > 2)
        self.memory["SC44"] = int("[" in inner and value == 0)

    def copy_text(self, source: str, target: str, option: str) -> None:
        """Copy characters one after the other, from the target on."""
        text = source.strip('"') if source.startswith('"') else str(self.value(source))
        if "suppress_zero=0" in option:
            text = text.zfill(5)
        code = re.search(r"termination_code=\$(\w\w)", option)
        text += chr(int(code[1], 16)) if code else ""
        for place, character in enumerate(text):
            self.store(f"TXT{int(target[3:]) + place}", ord(character))
        self.memory["SC43"] = int(len(text) > 1)

    def fill(self, inner: str) -> None:
        source, target = inner.split(",")
        for cell in cells(target):
            self.store(cell, self.value(source))

    def blockcopy(self, inner: str) -> None:
        what, _, option = inner.partition(",convert=")
        source, target = map(cells, what.split(","))
        for value, cell in zip([self.value(cell) for cell in source], target, strict=True):
            self.store(cell, value % 10 if option else value)

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
        where, _, more = inner.partition(",")
        found, sign, value = where.split(" ")
        given = arguments(more)
        searched, last = cells(found), self.value(given["result"])
        if given.get("continuous") == "1" and last:
            searched = [cell for cell in searched if int(cell[2:]) > last > 0]
        hits = [cell for cell in searched if OPERATORS[sign](self.value(cell), self.value(value))]
        self.store(given["result"], int(hits[0][2:]) if hits else -1)
        self.store(given["found"], int(bool(hits)))

    def message(self, inner: str) -> None:
        """Receive the partner's answer, which depends on what was sent and on the scan."""
        given = arguments(inner)
        sent = [self.value(cell) for cell in cells(given.get("source", ""))]
        draw = random.Random(f"{self.seed} {self.scan} {inner} {sent}")
        for cell in cells(given.get("dest", "")):
            values = 2 if cell[0] in "CY" and cell[1] != "T" else 4
            self.store(cell, draw.randrange(values))
            self.arriving[cell] = values
        well = draw.randrange(2)
        answers = {"sending": 1, "receiving": 1, "success": well, "error": 1 - well}
        answers["exception_response"] = draw.randrange(4)
        for name, value in answers.items():
            if name in given:
                self.store(given[name], value)
                self.arriving[given[name]] = 4 if name == "exception_response" else 2

    instructions: ClassVar[dict[str, Callable[[Machine, str], None]]] = {
        "latch": latch, "reset": unlatch, "copy": copy, "fill": fill, "blockcopy": blockcopy, "math": math,
        "pack_bits": pack, "unpack_to_bits": unpack, "search": search, "send": message, "receive": message,
    }  # fmt: skip


@lru_cache(maxsize=65536)
def drawn(moment: str, values: int) -> int:
    """Return a number below ``values``, always the same for the same moment."""
    return random.Random(moment).randrange(values)


@cache
def inputs(seed: int, scan: int) -> Mapping[str, int]:
    """The terminals of one scan."""
    draw = random.Random(f"{seed} {scan}")
    return {f"X{number:03d}": draw.randrange(2) for number in range(1, 17)}


# -- reading tokens


@cache
def parsed_leaf(token: str) -> tuple[str, str, str]:
    """``DS1==5`` as its operator and sides, ``rise(C1)`` as its word and bit."""
    compare = re.fullmatch(r"(.+?)(==|!=|<=|>=|<|>)(.+)", token)
    if compare:
        return compare[2], compare[1], compare[3]
    word, _, bit = token.rpartition("(")
    return word, bit.rstrip(")"), ""


@cache
def arguments(inner: str) -> Mapping[str, str]:
    """``a=1,b=[C1,C2],c=X(d=2)`` by name."""
    pattern = r"(\w+)=((?:\w+\([^()]*\))|\[\[.*?\]\]|\[[^\[\]]*\]|\"[^\"]*\"|[^,\[\]\"]+)(?:,|$)"
    return dict(re.findall(pattern, inner))


def listed(text: str) -> Sequence[str]:
    return text.strip("[]").split(",") if text else ()


@cache
def cells(text: str) -> Sequence[str]:
    """``C1..C3`` and ``immediate(Y001)`` as single names; ``C3..C1`` runs backwards; none for an empty text."""
    if not text:
        return ()
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
    """False for scratch cells, which are at the top of their banks."""
    match = re.fullmatch(r"(C|DS|DD|DH|DF)(\d+)", name)
    return not match or int(match[2]) <= 100
