"""The trees of the IR as plain data, and back: lists, texts, numbers, truth values and None, so JSON can hold them.

Places are noted relative to a line, so that a rung that moves stays the same data. An object is a list that begins with
the number of its class; whatever is no list is itself.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields
from operator import attrgetter
from typing import Any

from clickgen.device.banks import Address
from clickgen.instructions import INSTRUCTIONS, control
from clickgen.instructions.spec import Spec
from clickgen.ir import conditions, formula_nodes, modbus, operands, program
from clickgen.ir.imports import Import
from clickgen.ir.operands import Section
from clickgen.text.source import EmbeddedText, SourceFile, Span

Data = Any
"""What JSON can hold."""

_TUPLE, _SPAN, _ADDRESS, _SPEC, _ARGS, _TEXT, _SECTION, _EDGE = range(8)

_CLASSES: tuple[type, ...] = (
    *(conditions.Contact, conditions.Compare, conditions.All, conditions.Any, conditions.Always),
    *(operands.Named, operands.Cell, operands.Range, operands.Pointer, operands.Immediate),
    *(operands.Integer, operands.Hex, operands.Real, operands.Text, operands.CharCode),
    *(formula_nodes.Number, formula_nodes.HexNumber, formula_nodes.Pi, formula_nodes.Operand, formula_nodes.Sum),
    *(formula_nodes.Unary, formula_nodes.Binary, formula_nodes.Call, formula_nodes.Group, formula_nodes.Formula),
    *(modbus.TcpTarget, modbus.RtuTarget, modbus.RemoteCell, modbus.RemoteModbus),
    *(program.FormulaText, program.Options, program.Word, program.Operands, program.Pattern, program.KeptToken),
    *(program.Action, program.Branch, program.Loop, program.Rung, program.Routine),
    *(program.Declaration, program.BlockDeclaration, Import),
)
_FIRST = 10
"""The number of the first of these classes."""


_SPECS = {**INSTRUCTIONS, **{spec.name: spec for spec in control.SYNTAX}}


class NotData(Exception):
    """Something that has no form as data."""


# -- to data ----------------------------------------------------------------------------------------------------------


def to_data(value: object, source: SourceFile, base: int) -> Data:
    """A tree as data, its lines counted from ``base``. Raises NotData, also for what is in another file."""
    write = _WRITERS.get(value.__class__)
    if write is None:
        raise NotData(value.__class__.__name__)
    return write(value, source, base)


def _from_tuple(value: tuple[object, ...], source: SourceFile, base: int) -> Data:
    return [_TUPLE, *(to_data(item, source, base) for item in value)]


def _from_span(value: Span, source: SourceFile, base: int) -> Data:
    path, line, col, end_line, end_col, sheet = value
    if path != source.path or sheet:
        raise NotData(value)
    return [_SPAN, line - base, col, end_line - base, end_col]


def _from_spec(value: Spec, _: SourceFile, __: int) -> Data:
    if _SPECS.get(value.name) is not value:
        raise NotData(value.name)
    return [_SPEC, value.name]


def _from_args(value: dict[str, object], source: SourceFile, base: int) -> Data:
    return [_ARGS, *(one for name, item in value.items() for one in (name, to_data(item, source, base)))]


def _from_text(value: EmbeddedText, source: SourceFile, base: int) -> Data:
    """The first place stands for all where the text is on one line, without escapes."""
    if value.source is not source:
        raise NotData(value)
    line, col = value.positions[0]
    if value.positions == tuple((line, col + n) for n in range(len(value.value) + 1)):
        return [_TEXT, value.value, line - base, col]
    return [_TEXT, value.value, *(one for line, col in value.positions for one in (line - base, col))]


def _from_node(number: int, cls: type) -> Callable[[Any, SourceFile, int], Data]:
    values = attrgetter(*(field.name for field in fields(cls)))

    def write(node: object, source: SourceFile, base: int) -> Data:
        found = values(node)
        items = found if found.__class__ is tuple else (found,)
        return [number, *[one if one.__class__ in _PLAIN else to_data(one, source, base) for one in items]]

    return write


_PLAIN: frozenset[type] = frozenset((str, int, float, bool, type(None)))


_WRITERS: dict[type, Callable[[Any, SourceFile, int], Data]] = {
    **dict.fromkeys(_PLAIN, lambda value, _, __: value),
    tuple: _from_tuple,
    Span: _from_span,
    Address: lambda value, _, __: [_ADDRESS, *value],
    Section: lambda value, _, __: [_SECTION, *value],
    conditions.Edge: lambda value, _, __: [_EDGE, value.value],
    Spec: _from_spec,
    dict: _from_args,
    EmbeddedText: _from_text,
    **{cls: _from_node(number, cls) for number, cls in enumerate(_CLASSES, _FIRST)},
}


# -- from data --------------------------------------------------------------------------------------------------------


class FromData:
    """Makes trees of data, for one file. What is no such data raises ValueError, LookupError or TypeError."""

    def __init__(self, source: SourceFile) -> None:
        self._source = source
        self._path = source.path
        self._base = 0
        makers: list[Callable[[list[Data]], object]] = [
            self._tuple,
            self._span,
            lambda data: Address(*data[1:]),
            lambda data: _SPECS[data[1]],
            self._args,
            self._text,
            lambda data: Section(*data[1:]),
            lambda data: conditions.Edge(data[1]),
            *(self._no_class for _ in range(_EDGE + 1, _FIRST)),
        ]

        def maker(cls: type) -> Callable[[list[Data]], object]:
            return lambda data: cls(*[x if x.__class__ is not list else makers[x[0]](x) for x in data[1:]])

        makers += map(maker, _CLASSES)
        self._makers = makers

    def __call__(self, data: Data, base: int) -> Any:
        """The tree, with its lines counted from ``base``."""
        self._base = base
        return self._makers[data[0]](data)

    def _items(self, data: list[Data]) -> list[Any]:
        makers = self._makers
        return [x if x.__class__ is not list else makers[x[0]](x) for x in data]

    def _tuple(self, data: list[Data]) -> tuple[object, ...]:
        return tuple(self._items(data[1:]))

    def _span(self, data: list[Data]) -> Span:
        base = self._base
        return Span(self._path, data[1] + base, data[2], data[3] + base, data[4])

    def _args(self, data: list[Data]) -> dict[str, object]:
        return dict(zip(data[1::2], self._items(data[2::2]), strict=True))

    def _text(self, data: list[Data]) -> EmbeddedText:
        value, lines, cols = data[1], data[2::2], data[3::2]
        if len(lines) == 1:
            line, col = lines[0] + self._base, cols[0]
            return EmbeddedText(self._source, value, tuple((line, col + n) for n in range(len(value) + 1)))
        places = tuple((line + self._base, col) for line, col in zip(lines, cols, strict=True))
        return EmbeddedText(self._source, value, places)

    def _no_class(self, data: list[Data]) -> object:
        raise ValueError(data[0])
