"""Finds the names in a source file, to the character, also inside the strings of formulas."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import libcst as cst

from clickgen.device.banks import Address, points_of
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.nodes import ADDRESSES, Node, index_of, text_value
from clickgen.dialects.if_rungs.read.program import read_file
from clickgen.dialects.if_rungs.read.statements import Layout, Part, layout_of
from clickgen.ir.imports import Import
from clickgen.ir.operands import Cell, Immediate, Named, Operand, Range
from clickgen.ir.program import BlockDeclaration, Declaration, FormulaText, Routine, actions_in, rungs_in
from clickgen.ir.walk import rung_operands
from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.edits import Edit
from clickgen.text.source import EmbeddedText, SourceFile, Span

_LAST_WORD = re.compile(r"(?<!\w)\w+$")
_IN_FORMULA = re.compile(r"""\w++\s*+(?:\.\s*(?P<plain>\w+)|\[\s*(?:"(?P<double>[^"\n]*)"|'(?P<single>[^'\n]*)'))""")
_ESCAPE = re.compile(r"\\(?:[0-7]{1,3}|x[0-9a-fA-F]{2}|u[0-9a-fA-F]{4}|U[0-9a-fA-F]{8}|N\{[^}]*\}|.)")


class Place(NamedTuple):
    """Where a name is written: the stretches with its characters; more than one if a string is in pieces."""

    stretches: tuple[Span, ...]
    is_plain: bool
    """True after a dot, where only a plain word is possible."""
    in_formula: bool

    def edits(self, name: str) -> tuple[Edit, ...]:
        """Put another name in its place: in the first stretch, the others become empty."""
        return tuple(Edit(span, "" if index else name) for index, span in enumerate(self.stretches))


@dataclass(frozen=True)
class FileNames:
    """Every name that a source file uses or declares, in the order of the text. Members of blocks are separate."""

    source: SourceFile
    named: tuple[Named, ...]
    blocks: tuple[Named, ...]
    """Names with an index or a section after them, and declared blocks."""
    formulas: tuple[FormulaText, ...]
    declarations: tuple[Declaration | BlockDeclaration, ...] = ()
    cells: tuple[Cell | Range, ...] = ()
    """The cells and ranges that routines use by number."""

    def of(self, name: str) -> list[Named]:
        """The uses of a name, in any bank and any case."""
        return [named for named in self.named if named.name.lower() == name.lower()]

    def blocks_of(self, name: str) -> list[Named]:
        """The uses of a name for a block or a part of one."""
        return [block for block in self.blocks if block.name.lower() == name.lower()]

    def every(self, name: str) -> list[Named]:
        """Every place of a name, a nickname's or a block's, each once and in the order of the text."""
        found = {(named.span.line, named.span.col): named for named in (*self.of(name), *self.blocks_of(name))}
        return [found[place] for place in sorted(found)]

    def place(self, named: Named) -> Place:
        """The place of the name of one of ``named`` or ``blocks``."""
        node = self._node(named.span)
        if isinstance(node, cst.Subscript) and named.part is not None:
            # ds.Recipe[3] and ds["Door alarms"][0:4]: the name comes before the index.
            node = node.value
        if node is None:
            text, start = self._characters(named.span)
            match = _IN_FORMULA.match(text.value, start)
            assert match is not None
            group = next(group for group, name in match.groupdict().items() if name is not None)
            return Place(_stretches(text, *match.span(group)), group == "plain", True)
        index = index_of(node) if isinstance(node, cst.Subscript) else None
        if isinstance(index, Node) and text_value(index) is not None:
            text = self._context.embedded(index)
            return Place(_stretches(text, 0, len(text.value)), False, False)
        _, _, _, line, end, _ = self._context.span(node)
        word = _LAST_WORD.search(self.source.line(line)[: end - 1])
        assert word is not None
        return Place((self.source.span(line, word.start() + 1, line, end),), True, False)

    @cached_property
    def _layout(self) -> Layout:
        layout = layout_of(self.source)
        assert layout is not None
        return layout

    @cached_property
    def _context(self) -> Context:
        return Context(self.source, Diagnostics(), places=self._layout.places)

    @cached_property
    def _starts(self) -> list[int]:
        return [part.start for part in self._layout.parts]

    @cached_property
    def _read_last(self) -> dict[Part, dict[Span, Node]]:
        """The addresses and texts of the part that was looked at last, by their spans."""
        return {}

    def _node(self, span: Span) -> Node | None:
        """The address or the text with this span; None for anything inside a text."""
        part = self._layout.parts[bisect_left(self._starts, span.line) - 1]
        if part not in self._read_last:
            self._read_last.clear()
            self._read_last[part] = {
                self._context.span(node): node
                for node in self._layout.nodes(part)
                if node.__class__ in ADDRESSES or text_value(node) is not None
            }
        return self._read_last[part].get(span)

    @cached_property
    def _formulas_by_line(self) -> dict[int, list[FormulaText]]:
        found: dict[int, list[FormulaText]] = {}
        for formula in self.formulas:
            for line in range(formula.span.line, formula.span.end_line + 1):
                found.setdefault(line, []).append(formula)
        return found

    def _characters(self, span: Span) -> tuple[EmbeddedText, int]:
        """The text of the formula that has a name at this place, and the character with which the name begins."""
        for formula in self._formulas_by_line[span.line]:
            node = self._node(formula.span)
            assert node is not None
            text = self._context.embedded(node)
            if (span.line, span.col) in text.positions[:-1]:
                return text, text.positions.index((span.line, span.col))
        raise LookupError(span)


def read_names(source: SourceFile, problems: Diagnostics) -> FileNames | None:
    """Return the names in a file, also in routines that no program imports; None if it is not Python."""
    content = read_file(source, problems)
    if content is None:
        return None
    named: list[Named] = []
    formulas: list[FormulaText] = []
    blocks: list[Named] = []
    cells: list[Cell | Range] = []
    for item in content.items:
        if isinstance(item, Routine):
            targets = [*_targets(item)]
            named += (target for target in targets if isinstance(target, Named))
            cells += (target for target in targets if isinstance(target, Cell | Range))
            formulas += _formulas(item)
        elif isinstance(item, Declaration):
            named.append(item.named)
        elif not isinstance(item, Import):
            blocks.append(item.named)
    blocks += (name for name in named if name.part is not None)
    plain = {name.span: name for name in named if name.part is None}
    in_order = sorted(plain.values(), key=lambda name: name.span[1:3])
    declarations = (item for item in content.items if isinstance(item, Declaration | BlockDeclaration))
    return FileNames(source, tuple(in_order), tuple(blocks), tuple(formulas), tuple(declarations), tuple(cells))


def _targets(routine: Routine) -> Iterator[Operand]:
    for rung in routine.rungs:
        for operand in rung_operands(rung):
            yield operand.target if isinstance(operand, Immediate) else operand


def _formulas(routine: Routine) -> Iterator[FormulaText]:
    for rung in rungs_in(routine.rungs):
        for action in actions_in(rung.items):
            yield from (value for value in action.args.values() if isinstance(value, FormulaText))


def _stretches(text: EmbeddedText, start: int, end: int) -> tuple[Span, ...]:
    """The place of ``value[start:end]`` in the file, without the quotes and line ends between its pieces."""
    source = text.source
    stretches: list[Span] = []
    for line, col in text.positions[start:end]:
        raw = source.line(line)
        escape = _ESCAPE.match(raw, col - 1)
        stop = col + (len(escape[0]) if escape else 1)
        if stretches and stretches[-1][3:5] == (line, col):
            stretches[-1] = stretches[-1]._replace(end_col=stop)
        else:
            stretches.append(source.span(line, col, line, stop))
    return tuple(stretches)


def comments_with(source: SourceFile, word: str) -> int:
    """How many comments of a file hold this word, in any case."""
    wanted = word_pattern(word)
    if not wanted.search(source.text):
        return 0
    layout = layout_of(source)
    if layout is None:
        return 0
    parts = (part for part in layout.parts if wanted.search(layout.text(part)))
    return sum(wanted.search(comment.text) is not None for part in parts for comment in layout.comments(part))


def word_pattern(word: str) -> re.Pattern[str]:
    """A whole word in any case."""
    return re.compile(rf"(?<!\w){re.escape(word)}(?!\w)", re.IGNORECASE)


def places_in(files: Iterable[FileNames]) -> Callable[[str], list[str]]:
    """The places where these files use or declare a name: ``prog.py:12``. Each file counts once, each line too."""
    places: dict[str, dict[str, None]] = {}
    for file in files:
        for named in file.named:
            place = f"{file.source.path}:{named.span.line}"
            places.setdefault(named.name.lower(), {})[place] = None
    return lambda name: list(places.get(name.lower(), ()))


class ProgramsSay:
    """What programs say of addresses, besides the names that they use. Each file counts once."""

    def __init__(self, files: Iterable[FileNames] = ()) -> None:
        self.declared: dict[str, Declaration] = {}
        """The declarations by their lowercase names."""
        self.declared_at: dict[Address, Declaration] = {}
        self.blocks: dict[str, BlockDeclaration] = {}
        """The declared blocks by their lowercase names."""
        self._by_number: dict[Address, dict[str, None]] = {}
        for file in {id(file): file for file in files}.values():
            self._add(file)

    def by_number(self, address: Address) -> list[str]:
        """The places where an address is used by its number, alone or in a range: ``prog.py:12``."""
        return list(self._by_number.get(address, ()))

    def _add(self, file: FileNames) -> None:
        for declaration in file.declarations:
            name = declaration.named.name.lower()
            if isinstance(declaration, BlockDeclaration):
                self.blocks.setdefault(name, declaration)
            else:
                self.declared.setdefault(name, declaration)
                self.declared_at.setdefault(declaration.cell.address, declaration)
        for cell in file.cells:
            for address in cell.addresses() if isinstance(cell, Range) else [cell.address]:
                for each in (address, *points_of(address)):
                    self._by_number.setdefault(each, {})[f"{file.source.path}:{cell.span.line}"] = None
