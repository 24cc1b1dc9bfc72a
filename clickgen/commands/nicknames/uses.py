"""The names that a source file uses or declares, and where each is written."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property

from clickgen.device.banks import Address, points_of
from clickgen.dialects.base import Dialect, NamePlaces, Place
from clickgen.dialects.registry import dialect_of
from clickgen.ir.operands import Cell, Immediate, Named, Operand, Range
from clickgen.ir.program import BlockDeclaration, Declaration, FormulaText, Routine, actions_in, rungs_in
from clickgen.ir.walk import rung_operands
from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.source import SourceFile


@dataclass(frozen=True)
class FileNames:
    """Every name that a source file uses or declares, in the order of the text. Members of blocks are separate."""

    source: SourceFile
    dialect: Dialect
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
        return self._places.place(named)

    def comments_with(self, word: str) -> int:
        """How many comments of the file hold this word, in any case."""
        return self.dialect.comments_with(self.source, word)

    def takes(self, named: Named, name: str) -> bool:
        """True where another name can be written in the place of one."""
        return self._places.takes(named, name)

    @cached_property
    def _places(self) -> NamePlaces:
        return self.dialect.places(self.source, self.formulas)


def read_names(source: SourceFile, problems: Diagnostics) -> FileNames | None:
    """The names in a file, also in routines that no program imports; None when it cannot be read."""
    dialect = dialect_of(source.path, source.text)
    items = dialect.read_file(source, problems)
    if items is None:
        return None
    named: list[Named] = []
    formulas: list[FormulaText] = []
    blocks: list[Named] = []
    cells: list[Cell | Range] = []
    for item in items:
        if isinstance(item, Routine):
            targets = [*_targets(item)]
            named += (target for target in targets if isinstance(target, Named))
            cells += (target for target in targets if isinstance(target, Cell | Range))
            formulas += _formulas(item)
        elif isinstance(item, Declaration):
            named.append(item.named)
        elif isinstance(item, BlockDeclaration):
            blocks.append(item.named)
    blocks += (name for name in named if name.part is not None)
    plain = {name.span: name for name in named if name.part is None}
    in_order = sorted(plain.values(), key=lambda name: name.span[1:3])
    declarations = (item for item in items if isinstance(item, Declaration | BlockDeclaration))
    return FileNames(
        source, dialect, tuple(in_order), tuple(blocks), tuple(formulas), tuple(declarations), tuple(cells)
    )


def _targets(routine: Routine) -> Iterator[Operand]:
    for rung in routine.rungs:
        for operand in rung_operands(rung):
            yield operand.target if isinstance(operand, Immediate) else operand


def _formulas(routine: Routine) -> Iterator[FormulaText]:
    for rung in rungs_in(routine.rungs):
        for action in actions_in(rung.items):
            yield from (value for value in action.args.values() if isinstance(value, FormulaText))


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
        self._dialects: dict[str, Dialect] = {}
        self._by_number: dict[Address, dict[str, None]] = {}
        for file in {id(file): file for file in files}.values():
            self._add(file)

    def place_of(self, declaration: Declaration | BlockDeclaration) -> str:
        """A declaration with its place: ``nickname(...) at prog.py:12``."""
        span = declaration.span
        return f"{self._dialects[span.path].spell.declaration()} at {span.path}:{span.line}"

    def by_number(self, address: Address) -> list[str]:
        """The places where an address is used by its number, alone or in a range: ``prog.py:12``."""
        return list(self._by_number.get(address, ()))

    def _add(self, file: FileNames) -> None:
        self._dialects[file.source.path] = file.dialect
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
