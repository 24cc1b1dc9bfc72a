"""The instructions of the language, one file per family, each declared once as a Spec."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from typing import TypeVar

from clickgen.instructions import coils, communication, control, copies, counters, data, drums, maths, raw, timers
from clickgen.instructions.effects import Shape
from clickgen.instructions.spec import Spec

FAMILIES = (coils, timers, counters, copies, data, maths, drums, communication, control, raw)

INSTRUCTIONS: dict[str, Spec] = {spec.name: spec for family in FAMILIES for spec in family.SPECS}
"""Every instruction that a program calls by name."""
SYNTAX: dict[str, Spec] = {spec.name: spec for spec in control.SYNTAX}
"""Every instruction that a program does not call: ``return``, ``for`` and ``pass``."""

_Table = TypeVar("_Table")
_DERIVED: list[Callable[[], None]] = []


def every() -> Iterator[Spec]:
    """Every instruction of the language."""
    yield from INSTRUCTIONS.values()
    yield from SYNTAX.values()


def moving(shape: Shape) -> Spec:
    """The instruction of the language that takes a value from one operand to another in this way."""
    return next(spec for spec in INSTRUCTIONS.values() if spec.effects.shape is shape and all(spec.matrix))


def of_instructions(make: Callable[[], _Table]) -> Callable[[], _Table]:
    """A table that is made from the instructions, once for as long as they stay the same."""
    made = cache(make)
    _DERIVED.append(made.cache_clear)
    return made


@contextmanager
def added(*specs: Spec) -> Iterator[None]:
    """The language with further instructions, for a while."""
    before = dict(INSTRUCTIONS)
    try:
        INSTRUCTIONS.update((spec.name, spec) for spec in specs)
        _forget_tables()
        yield
    finally:
        INSTRUCTIONS.clear()
        INSTRUCTIONS.update(before)
        _forget_tables()


def _forget_tables() -> None:
    for forget in _DERIVED:
        forget()
