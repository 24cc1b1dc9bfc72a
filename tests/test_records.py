"""The records are what Python's own decorator makes, in all that clickgen can see of them."""

from __future__ import annotations

import copy
import dataclasses
import inspect
import pickle
from collections.abc import Callable
from typing import Any

import pytest

from clickgen.ir import conditions, formula_nodes, imports, modbus, operands, program, proposals
from clickgen.records import dataclass
from clickgen.text.source import Span


def ours() -> list[type]:
    found = [
        one
        for room in (conditions, formula_nodes, imports, modbus, operands, program, proposals)
        for one in vars(room).values()
        if isinstance(one, type) and dataclasses.is_dataclass(one) and one.__module__ == room.__name__
    ]
    return [one for one in found if one is not program.Program]


def theirs(cls: Any) -> Any:
    """The class as Python's decorator makes it of the same text."""
    names = [field.name for field in dataclasses.fields(cls)]
    own = {name: value for name, value in vars(cls).items() if name not in (*names, *_MADE)}
    own |= {field.name: field.default for field in dataclasses.fields(cls) if field.default is not dataclasses.MISSING}
    return dataclasses.dataclass(frozen=True, slots=True)(type(cls.__name__, (), own))


_MADE = {
    *("__slots__", "__dict__", "__weakref__", "__init__", "__eq__", "__hash__", "__repr__", "__setattr__"),
    *("__delattr__", "__reduce__", "__dataclass_fields__", "__dataclass_params__", "__match_args__"),
}


def values(cls: Any, first: int) -> list[object]:
    return [f"value {number}" for number in range(first, first + len(dataclasses.fields(cls)))]


@pytest.mark.parametrize("cls", ours(), ids=lambda cls: cls.__qualname__)
def test_a_record_is_what_python_makes(cls: Any) -> None:
    other = theirs(cls)
    one, same, else_ = cls(*values(cls, 0)), cls(*values(cls, 0)), cls(*values(cls, 1))
    assert _parameters(cls) == _parameters(other)
    assert repr(one) == repr(other(*values(cls, 0)))
    assert one == same != else_
    assert (hash(one) == hash(same)) is True
    assert one != other(*values(cls, 0))
    assert cls.__match_args__ == other.__match_args__
    assert cls.__slots__ == other.__slots__
    assert [f.name for f in dataclasses.fields(cls)] == [f.name for f in dataclasses.fields(other)]
    required = [field for field in dataclasses.fields(cls) if field.default is dataclasses.MISSING]
    few = values(cls, 0)[: len(required)]
    assert repr(cls(*few)) == repr(other(*few))
    name = dataclasses.fields(cls)[0].name
    assert getattr(dataclasses.replace(one, **{name: 5}), name) == 5
    for act in _CHANGES:
        with pytest.raises(dataclasses.FrozenInstanceError):
            act(one, name)
    with pytest.raises((dataclasses.FrozenInstanceError, AttributeError, TypeError)):
        one.no_such_field = 1
    assert pickle.loads(pickle.dumps(one)) == copy.copy(one) == copy.deepcopy(one) == one


_CHANGES: tuple[Callable[[Any, str], None], ...] = (lambda one, name: setattr(one, name, 5), delattr)


def _parameters(cls: Any) -> list[tuple[str, object]]:
    return [(parameter.name, parameter.default) for parameter in inspect.signature(cls).parameters.values()]


def test_a_record_with_one_field_has_its_hash_and_its_pickle() -> None:
    one = conditions.Always(Span("p.py", 1, 1, 1, 2))
    assert pickle.loads(pickle.dumps(one)) == one
    assert len({one, conditions.Always(Span("p.py", 1, 1, 1, 2))}) == 1


@pytest.mark.parametrize(("frozen", "slots"), [(False, True), (True, False)])
def test_other_kinds_are_for_pythons_decorator(frozen: bool, slots: bool) -> None:
    with pytest.raises(AssertionError):
        dataclass(frozen=frozen, slots=slots)
