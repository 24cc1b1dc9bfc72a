"""Programs: instructions with their inputs, branches, loops, rungs, routines in one file or several; their text."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace

from strategies.conditions import Condition, Group, ladder_name, written
from strategies.shown import ShownAsText

PIN_TOKENS = {
    "reset": ".reset()",
    "count_down": ".down()",
    "clock": ".clock()",
    "jump": ".jump({step})",
    "jog": ".jog()",
}
METHODS = {"count_down": "down"}
"""The name of an input in a chain, if it is not the keyword."""
WAYS = ("keyword", "chain", "apart", "tuple", "list", "nested")
"""How an input is written: as a keyword, or after the call with its conditions in one of these forms."""


@dataclass(frozen=True)
class Pin:
    """An input of a box: its keyword, its condition, the ladder's text for the step of a jump, and how it is written.

    An input without a condition is left out, and the ladder has the never-contact there.
    """

    name: str
    condition: Condition | None
    step: str = ""
    way: str = "keyword"

    @property
    def token(self) -> str:
        return PIN_TOKENS[self.name].format(step=self.step)

    @property
    def step_text(self) -> str:
        return written(self.step) if self.step[:1].isalpha() else self.step

    @property
    def keyword(self) -> str:
        """The text among the arguments, or ""."""
        if self.condition is None or self.way != "keyword":
            return ""
        text = f"{self.name}=lambda: {self.condition.text}"
        return f"{text}, {self.name}_step={self.step_text}" if self.step else text

    @property
    def link(self) -> str:
        """The text after the call, or "". The terms of an ``all`` may be given one by one there."""
        if self.condition is None or self.way == "keyword":
            return ""
        whole = self.condition
        terms = [term.text for term in whole.terms] if isinstance(whole, Group) and whole.word == "all" else []
        first, *more = terms if terms and self.way != "chain" else [whole.text]
        conditions = {
            "tuple": f"({', '.join((first, *more))},)",
            "list": f"[{', '.join((first, *more))}]",
            "nested": f"{first}, ([{', '.join(more)}],)" if more else f"({first},)",
        }.get(self.way, ", ".join((first, *more)))
        step = f", step={self.step_text}" if self.step else ""
        return f".{METHODS.get(self.name, self.name)}({conditions}{step})"


@dataclass(frozen=True)
class Act:
    """One instruction: ``call`` as the program writes it, up to its inputs, and its ladder token."""

    call: str
    token: str
    height: int = 1
    pins: tuple[Pin, ...] = ()
    """In the order of the box. An input that the box then does not have is not included."""
    backwards: bool = False
    """The inputs are written from the last to the first."""

    @property
    def text(self) -> str:
        pins = self.pins[::-1] if self.backwards else self.pins
        given = [pin.keyword for pin in pins if pin.keyword]
        call = self.call if not given else f"{self.call[:-1]}, {', '.join(given)})"
        return call + "".join(pin.link for pin in pins)

    @property
    def tokens(self) -> list[str]:
        """The tokens in the output column: a one-shot range is one coil for each bit."""
        match = re.fullmatch(r"out\(([A-Z]+)(\d+)\.\.[A-Z]+(\d+),oneshot=1\)", self.token)
        if not match:
            return [self.token]
        bits = range(int(match[2]), int(match[3]) + 1)
        return [f"out({ladder_name(match[1], number)},oneshot=1)" for number in bits]

    @property
    def constant_step(self) -> str:
        """The step of a jump that CLICK needs in a register; "" if there is none."""
        return next((pin.step for pin in self.pins if pin.step.isdigit()), "")

    def numbered(self, number: int) -> Act:
        """Return the instruction with the number of its timer, counter or accumulator filled in."""
        return replace(self, call=self.call.format(number), token=self.token.format(number))


@dataclass(frozen=True)
class Arm:
    """An elif of a rung or a branch; without a condition its else."""

    condition: Condition | None
    items: tuple[Item, ...]


@dataclass(frozen=True)
class Branch:
    condition: Condition
    items: tuple[Item, ...]
    others: tuple[Arm, ...] = ()
    """Arms that the language does not have."""


@dataclass(frozen=True)
class Loop:
    """``for _ in range(count):`` around rungs; an open one is last in its rung and ends at ``next_loop()``."""

    count: int
    body: tuple[Rung, ...]
    is_open: bool = False


Item = Act | Branch | Loop


@dataclass(frozen=True)
class Rung:
    condition: Condition
    items: tuple[Item, ...]
    others: tuple[Arm, ...] = ()
    """Arms that the language does not have."""


PROGRAM = "prog.py"
"""The file of main."""
DECLARATIONS = 'nickname(c.Wired, c[1234], comment="in a file of its own")\n'


@dataclass(frozen=True)
class Program(ShownAsText):
    """``main`` and ``subroutines`` without their last rungs, the unconditional ``end()`` and ``return``.

    ``modules`` names the file beside the program for each subroutine, "" for the program's own;
    ``wiring`` puts a declaration into one more file.
    """

    main: tuple[Rung, ...]
    subroutines: tuple[tuple[str, tuple[Rung, ...]], ...] = ()
    modules: tuple[str, ...] = ()
    wiring: bool = False
    _cache: dict[str, dict[str, str]] = field(default_factory=dict, compare=False, repr=False)

    @property
    def texts(self) -> dict[str, str]:
        """The text of each file, that of main first."""
        if "texts" not in self._cache:
            self._cache["texts"] = self._written()
        return self._cache["texts"]

    def _written(self) -> dict[str, str]:
        bodies: dict[str, list[str]] = {PROGRAM: ["def main():", *_rung_lines(self.main, 1), "    if True:"]}
        bodies[PROGRAM].append("        end()")
        imports = ["import wiring"] if self.wiring else []
        modules = (*self.modules, *[""] * (len(self.subroutines) - len(self.modules)))
        for (name, rungs), module in zip(self.subroutines, modules, strict=True):
            body = bodies.setdefault(f"{module}.py" if module else PROGRAM, [])
            body += [*(["", ""] if body else []), "@sub", f"def {name}():", *_rung_lines(rungs, 1)]
            body += ["    if True:", "        return"]
            if module:
                imports.append(f"from {module} import {name}")
        if imports:
            bodies[PROGRAM] = [*imports, "", "", *bodies[PROGRAM]]
        texts = {name: "\n".join(lines) + "\n" for name, lines in bodies.items()}
        return {**texts, "wiring.py": DECLARATIONS} if self.wiring else texts

    @property
    def text(self) -> str:
        """All files one after the other, for people."""
        (_, first), *more = self.texts.items()
        return first + "".join(f"\n# ---- {name}\n{text}" for name, text in more)


def _rung_lines(rungs: Sequence[Rung], depth: int) -> Iterator[str]:
    for rung in rungs:
        yield "    " * depth + f"if {rung.condition.text}:"
        yield from _item_lines(rung.items, depth + 1)
        yield from _arm_lines(rung.others, depth)
        last = rung.items[-1] if rung.items else None
        if isinstance(last, Loop) and last.is_open:
            yield from _rung_lines(last.body, depth)
            yield from (f"{'    ' * depth}if True:", f"{'    ' * depth}    next_loop()")


def _item_lines(items: Sequence[Item], depth: int) -> Iterator[str]:
    indent = "    " * depth
    for item in items:
        if isinstance(item, Act):
            yield indent + item.text
        elif isinstance(item, Branch):
            yield f"{indent}if {item.condition.text}:"
            yield from _item_lines(item.items, depth + 1)
            yield from _arm_lines(item.others, depth)
        else:
            yield f"{indent}for _ in range({item.count}):"
            yield from [indent + "    pass"] if item.is_open else _rung_lines(item.body, depth + 1)


def _arm_lines(arms: Sequence[Arm], depth: int) -> Iterator[str]:
    for arm in arms:
        yield "    " * depth + (f"elif {arm.condition.text}:" if arm.condition else "else:")
        yield from _item_lines(arm.items, depth + 1)


class Numbers:
    """Timer and counter numbers: each has one owner. Low ones are left for contacts."""

    def __init__(self, start: int = 10) -> None:
        self.last = start

    def next(self) -> int:
        self.last += 1
        return self.last
