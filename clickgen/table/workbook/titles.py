"""Finds lists in a sheet by the titles of their columns."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass, field
from enum import Enum
from functools import cached_property

from clickgen.table.workbook.cells import Cell, Line
from clickgen.table.workbook.values import address_of, is_spare, name_of

HEADER_ROWS = 50
"""A sheet whose first list begins further down has none."""


class Field(Enum):
    """The property of an address that a column of a list gives; the value is its name in messages."""

    ADDRESS = "address"
    NICKNAME = "nickname"
    INITIAL = "initial value"
    RETENTIVE = "retentive setting"
    COMMENT = "comment"


TITLES = {
    Field.ADDRESS: (
        "Address, PLC Address, CLICK Address, I/O Address, Address Internal, Internal Address, Address PLC, "
        "Address CLICK, Address I/O, Tag Address, Signal Address, Point Address, Device Address, Data Address, "
        "Bit Address, Input Address, Output Address, Memory Address, Absolute Address, Operand Address, Addr, "
        "PLC Addr, I/O Addr, Adr, Adresse, SPS-Adresse, E/A-Adresse, Interne Adresse, Adresse intern, Absolutadresse, "
        "Adresse interne, Adresse API, Adresse automate, Adresse E/S, Dirección, Dirección PLC, Dirección interna, "
        "Dirección E/S, I/O Point, I/O, Point, Register, Operand, "
        "Address Internal/External, Address External, External Address, Externe Adresse, Adresse extern, "
        "Adresse externe, Dirección externa"
    ),
    Field.NICKNAME: (
        "Nickname, Nick Name, CLICK Nickname, Tag Name, Tag, Device Tag, PLC Tag, PLC Tag Name, PLC Name, I/O Tag, "
        "I/O Name, Point Name, Symbol Name, Symbolic Name, Symbol, Signal Name, Signal, Signal Tag, Variable Name, "
        "Variable, Mnemonic, Label, Name, Tag ID, Tag No, Tag Number, Device Name, Device, Signalname, Symbolname, "
        "Variablenname, Symbolik, Bezeichner, Betriebsmittel, BMK, Nom, Nom de variable, Nom du signal, Mnémonique, "
        "Symbole, Repère, Étiquette, Nombre, Símbolo, Etiqueta, Señal, Nombre de señal, Nombre de variable"
    ),
    Field.INITIAL: (
        "Initial Value, Initial, Init Value, Init, Start Value, Default Value, Default, Initial State, "
        "Anfangswert, Startwert, Initialwert, Valeur initiale, Valor inicial"
    ),
    Field.RETENTIVE: (
        "Retentive, Retain, Retained, Retention, Retentivity, Keep, Remanent, Remanenz, Rémanent, Rémanence, "
        "Remanente, Retentivo"
    ),
    Field.COMMENT: (
        "Address Comment, Comment, Comments, Description, Desc, Signal Description, Point Description, "
        "I/O Description, Tag Description, Service, Service Description, Function, Function Description, Purpose, "
        "Usage, Text, Remark, "
        "Remarks, Note, Notes, Kommentar, Beschreibung, Signalbeschreibung, Bezeichnung, Klartext, Funktionstext, "
        "Funktion, Bemerkung, Bemerkungen, Commentaire, Commentaires, Désignation, Libellé, Fonction, Remarque, "
        "Remarques, Comentario, Descripción, Descripción de señal, Función, Observaciones"
    ),
}
"""The titles of each column; if a list has several for one field, the first of them in this table counts.

Terminal is not among them: that column often holds numbers of wires and clamps, where C1 is no control relay.
"""


def _plain(title: str) -> str:
    """A title without case, spaces, line breaks, punctuation and accents."""
    letters = unicodedata.normalize("NFKD", title.casefold())
    return "".join(letter for letter in letters if letter.isalnum())


_FIELDS = {
    _plain(title): (rank, kind) for kind, titles in TITLES.items() for rank, title in enumerate(titles.split(", "))
}
_EXTERNAL = TITLES[Field.ADDRESS].split(", ").index("Address External")
"""Titles from this rank on are of addresses that count only if there is no internal one."""
_LONGEST = 60
_BETWEEN_LANGUAGES = re.compile(r"[/|\n]| - ")
_IN_BRACKETS = re.compile(r"\([^()]*\)|\[[^\[\]]*\]")


@dataclass(frozen=True)
class AddressList:
    """A list: the line of its titles, the column of each field, and the lines below it."""

    header: Line
    columns: dict[Field, int]
    titled: frozenset[int]
    """The columns that have a title, whatever it says."""
    external: int = 0
    """The column of external addresses, if there is one of internal addresses too; else 0."""
    lines: list[Line] = field(default_factory=list)

    @cached_property
    def is_table(self) -> bool:
        """True for a list in the form of CLICK's own table, in which every nickname is one."""
        titles = {_plain(cell.text) for cell in self.header.cells.values()}
        return {"nickname", "datatype"} <= titles

    def cell(self, line: Line, what: Field) -> Cell | None:
        """The cell of a line for one field."""
        cell = line.cells.get(self.columns.get(what, 0))
        if what is Field.ADDRESS and self.external:
            other = self.other_address(line)
            is_blank = cell is None or (not cell.fault and (not name_of(cell) or is_spare(cell.text)))
            return other if other and is_blank else cell
        return cell

    def other_address(self, line: Line) -> Cell | None:
        """The cell of a line with an external address, if CLICK has that address."""
        other = line.cells.get(self.external) if self.external else None
        return other if other and address_of(other.text) else None

    def untitled_neighbour(self, line: Line, what: Field) -> Cell | None:
        """The cell to the right of a field, if its column has no title."""
        column = self.columns[what] + 1
        return None if column in self.titled else line.cells.get(column)


def lists_of(lines: Iterator[Line]) -> list[AddressList]:
    """Return the lists of a sheet, from the top; if none begins in its first rows, no further row is read.

    A row with the titles of an address and a nickname begins a list, and ends those before it; a row with its address
    in the column of an earlier list belongs to that list, whatever else it says. Titles may take two rows, and
    lists with the same titles may be side by side.
    """
    found: list[AddressList] = []
    current: list[AddressList] = []
    above: Line | None = None
    for line in lines:
        if not found and line.number > HEADER_ROWS:
            break
        is_data = any(_has_address(each, line) for each in current)
        begun = [] if is_data else _begun_by(above, line)
        if begun:
            _drop_caption(current)
            found += begun
            current = begun
        else:
            for each in current:
                each.lines.append(line)
        above = None if is_data else line
    return found


def _has_address(listed: AddressList, line: Line) -> bool:
    """True for a row of the list, whatever else is in it."""
    cell = listed.cell(line, Field.ADDRESS)
    return cell is not None and address_of(cell.text) is not None


def _begun_by(above: Line | None, line: Line) -> list[AddressList]:
    """Return the lists whose titles end with this line."""
    own = _titles(line)
    if not own:
        return []
    over = _titles(above) if above and above.number + 1 == line.number else {}
    # The cell below a title is empty, or a title: it is merged with the one below, or over several beside it.
    if above and over and all(column in own or column not in line.cells for column in over):
        lists = _side_by_side({**over, **own}, above, frozenset({*above.cells, *line.cells}))
        if lists:
            return lists
    return _side_by_side(own, line, frozenset(line.cells))


def _titles(line: Line) -> dict[int, tuple[int, Field]]:
    """The fields that the titles in a line name, with the rank of the title, by column."""
    found = {}
    for column, cell in line.cells.items():
        if cell.text and len(cell.text) <= _LONGEST:
            title = _title(cell.text) or _title(_IN_BRACKETS.sub("", cell.text))
            if title:
                found[column] = title
    return found


def _title(text: str) -> tuple[int, Field] | None:
    """The field that a title names, with its rank; a title in two languages counts if both name that field."""
    title = _FIELDS.get(_plain(text))
    parts = [_FIELDS.get(_plain(part)) for part in _BETWEEN_LANGUAGES.split(text)]
    known = [part for part in parts if part]
    if title or len(known) < len(parts) or len({field for _, field in known}) > 1:
        return title
    return min(known, key=lambda part: part[0])


def _side_by_side(titles: dict[int, tuple[int, Field]], header: Line, titled: frozenset[int]) -> list[AddressList]:
    """The lists that a row of titles begins: a title that comes again begins the next one."""
    groups: list[dict[tuple[int, Field], int]] = [{}]
    for column, title in sorted(titles.items()):
        if title in groups[-1]:
            groups.append({})
        groups[-1][title] = column
    lists = []
    for group in groups:
        # The best title of a field comes last, and stays.
        best = sorted(group.items(), key=lambda item: item[0][0], reverse=True)
        columns = {kind: column for (_, kind), column in best}
        if Field.ADDRESS in columns and Field.NICKNAME in columns:
            external = [column for (rank, kind), column in group.items() if kind is Field.ADDRESS and rank >= _EXTERNAL]
            other = next((column for column in external if column != columns[Field.ADDRESS]), 0)
            lists.append(AddressList(header, columns, titled, other))
    return lists


def _drop_caption(lists: list[AddressList]) -> None:
    """Remove a single cell in the last rows above the next titles, such as ``Slot 2 inputs``."""
    for each in lists:
        while each.lines and len(each.lines[-1].cells) == 1:
            each.lines.pop()
