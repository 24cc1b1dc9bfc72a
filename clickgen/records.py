"""``@dataclass(frozen=True, slots=True)``, made in a third of the time and filled in less.

Python's own decorator compiles six functions for each class. A command makes some sixty classes before it begins, and a
build millions of objects. Here one function is compiled, which writes each slot directly; the others are shared. What a
class then does is what Python's decorator would make it do (`tests/test_records.py`).
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from operator import attrgetter
from typing import TYPE_CHECKING, Any, NoReturn, TypeVar, cast

if TYPE_CHECKING:
    from dataclasses import dataclass
else:

    def dataclass(*, frozen: bool, slots: bool) -> Callable[[type[T]], type[T]]:
        """A class of frozen records with slots; other kinds are for Python's own decorator."""
        assert frozen
        assert slots
        return _made


__all__ = ["dataclass"]

T = TypeVar("T")


def _made(cls: type[T]) -> type[T]:
    # What is left to Python's decorator are the fields, the slots and the arguments of patterns: no code is compiled.
    made: Any = dataclasses.dataclass(init=False, repr=False, eq=False, slots=True)(cls)
    names = tuple(field.name for field in dataclasses.fields(made))
    one_or_all = attrgetter(*names)
    values = one_or_all if len(names) > 1 else lambda self: (one_or_all(self),)

    def is_equal(self: object, other: object) -> Any:
        if other.__class__ is self.__class__:
            return bool(values(self) == values(other))
        return NotImplemented

    made.__init__ = _initializer(made)
    made.__eq__ = is_equal
    made.__hash__ = lambda self: hash(values(self))
    made.__repr__ = _shown
    made.__setattr__ = _refuse
    made.__delattr__ = _refuse
    made.__reduce__ = lambda self: (made, values(self))
    return cast("type[T]", made)


def _initializer(made: Any) -> Callable[..., None]:
    """A function that takes a value for each field, in their order, and puts it into its slot."""
    known: dict[str, object] = {}
    parameters: list[str] = []
    lines: list[str] = []
    for field in dataclasses.fields(made):
        assert field.default_factory is dataclasses.MISSING
        known[f"_set_{field.name}"] = made.__dict__[field.name].__set__
        known[f"_default_{field.name}"] = field.default
        has_default = field.default is not dataclasses.MISSING
        parameters.append(f"{field.name}=_default_{field.name}" if has_default else field.name)
        lines.append(f"    _set_{field.name}(self, {field.name})\n")
    if hasattr(made, "__post_init__"):
        lines.append("    self.__post_init__()\n")
    exec(f"def __init__(self, {', '.join(parameters)}):\n{''.join(lines)}", known)
    initializer: Any = known["__init__"]
    initializer.__qualname__ = f"{made.__qualname__}.__init__"
    return cast("Callable[..., None]", initializer)


def _shown(self: Any) -> str:
    values = ", ".join(f"{field.name}={getattr(self, field.name)!r}" for field in dataclasses.fields(self))
    return f"{type(self).__qualname__}({values})"


def _refuse(self: object, name: str, *_: object) -> NoReturn:  # noqa: ARG001
    raise dataclasses.FrozenInstanceError(f"cannot assign to field {name!r}")
