"""Reads an I/O list, a workbook that a person made, as rows of the address table.

**Lists.** A row with the titles of an address and of a nickname begins a list (``workbook_titles.TITLES`` has the
words; case, spaces, line breaks, punctuation, accents and text in brackets do not count). It is in the
first 50 rows of a sheet; more lists may follow below or beside it. Columns come in any order, and others are ignored.
A sheet without such a row is not a list. Hidden sheets, rows and columns are read like others: a filter hides rows, and
a name that is left out would get another address.

**Rows.** An empty cell says nothing; nor does a dash, or a word such as N/A, except in a comment. A nickname such
as SPARE, TBD or "not used" is none; its address is given to no name, and a note says how many such rows there are.
Words that may also be names, such as x or Open, are skipped only if two addresses have them; so is every such word in
a list with the titles Nickname and Data Type, which is CLICK's own table. Addresses may have
any case, with or without spaces and leading zeros (``x 1``, ``DS 0100``). A row that says something of an address
needs one that CLICK has. A row without any address is a caption or a remark; if it has a name, a warning says that it
is left out. Several rows may describe one address, on one sheet or on many: they are put together, and if
two contradict each other both cells are named. An address with nothing said of it has no row.

**Cells.** Nicknames are trimmed and otherwise taken as they are, never shortened; a number is not one, since nobody
knows how it is meant to be written. Initial values are numbers, numbers stored as text, ON and OFF for bits,
hexadecimal text with or without ``h`` or ``0x``; a plain number over 9 for a hexadecimal word may be meant decimal, and
is refused. Retentive is yes, x, true, 1 or no, false, 0, and the like; empty is CLICK's default for the bank. Comments,
and the one character of a TXT, are taken exactly, spaces and line breaks included. A formula is refused as
an address, a nickname, an initial value or retention, because its stored result may be stale, and so
are dates and errors; a comment that is one of these is left out, with a warning.
"""

from __future__ import annotations

import warnings
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from clickgen.device.banks import BANKS, Address
from clickgen.device.nicknames import nickname_fault
from clickgen.problems.diagnostics import Diagnostics, Label
from clickgen.table.judge_row import (
    Fault,
    address_nickname_fault,
    may_share_a_name,
    no_address,
    short,
)
from clickgen.table.read import TableUnreadable
from clickgen.table.rows import Row, default_row
from clickgen.table.workbook.archive import bytes_of_workbook
from clickgen.table.workbook.cells import Cell, Line, Sheet, sheets_of
from clickgen.table.workbook.fields import agree, in_words, is_blank_value, says_something, value_of
from clickgen.table.workbook.titles import HEADER_ROWS, AddressList, Field, lists_of
from clickgen.table.workbook.values import (
    address_of,
    addresses_in,
    is_spare,
    looks_like_address,
    name_of,
    spare_where_twice,
)
from clickgen.text.source import Span
from clickgen.text.wording import counted

_SAID = (Field.NICKNAME, Field.INITIAL, Field.RETENTIVE, Field.COMMENT)
_WORDS_SHOWN = 4
_WAYS_OUT = {
    "a formula": "copy the cells and paste them as values; what a formula gave when it was saved may be stale",
    "a date": "format the cell as text and write it again",
}


def read_workbook(path: Path, shown: str, problems: Diagnostics, data: bytes | None = None) -> tuple[Row, ...]:
    """Read the lists of a workbook. ``shown`` is the path as the user knows it, ``data`` what to read instead of it.

    Raises TableUnreadable if the file is not a workbook, is broken or hostile, or holds no list. Everything wrong with
    single rows goes to ``problems``, all at once. Rows come in the order in which the workbook first mentions their
    addresses; ``cell`` of each is where its address is first given.
    """
    data = bytes_of_workbook(path, shown) if data is None else data
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # openpyxl warns of styles and rules that it leaves out.
        sheets = sheets_of(data, shown)
        lists = [(sheet, each) for sheet in sheets for each in lists_of(sheet.lines())]
    if not lists:
        raise _no_list(shown, sheets)
    doubtful = _doubtful_spares(each for _, each in lists)
    reader = _Reader(problems, {sheet.title for sheet in sheets if sheet.is_hidden}, doubtful)
    for sheet, each in lists:
        reader.read(sheet, each)
    return reader.rows()


def _no_list(shown: str, sheets: list[Sheet]) -> TableUnreadable:
    titles = [short(sheet.title) for sheet in sheets[:10]] + ["..."] * (len(sheets) > 10)
    return TableUnreadable(
        f"{shown} holds no list of addresses: no row has the titles Address and Nickname (or Tag, Name, Symbol) "
        f"among the first {HEADER_ROWS} of a sheet (the sheets are: {', '.join(titles) or 'none'})"
    )


class _Fact(NamedTuple):
    """Something that a cell says of an address."""

    value: str | bool
    span: Span


@dataclass(slots=True)
class _Said:
    """Everything that the workbook says of an address. ``cell`` is where it first says something."""

    cell: Span
    facts: dict[Field, _Fact] = field(default_factory=dict)
    spare: str = ""


class _Reader:
    """Combines what the lists say, and reports what is wrong with it."""

    def __init__(self, problems: Diagnostics, hidden: set[str], spares: set[str]) -> None:
        self.problems = problems
        self._hidden = hidden
        self._doubtful_spares = spares
        """The words that two addresses have in place of a nickname."""
        self._said: dict[Address, _Said] = {}
        self._by_name: dict[str, tuple[Address, _Fact]] = {}

    def read(self, sheet: Sheet, listed: AddressList) -> None:
        stranger = _first_stranger(listed)
        if stranger:
            self._strange_list(sheet, *stranger)
            return
        no_values: dict[tuple[Field, str], list[Span]] = {}
        self._spares: list[_Fact] = []
        for line in listed.lines:
            for what, cell in self._line(sheet, listed, line):
                no_values.setdefault((what, cell.fault), []).append(sheet.span(line, cell.column))
        for (what, fault), spans in no_values.items():
            self._no_values(what, fault, spans)
        self._passed_over()
        self._two_addresses(sheet, listed)

    def rows(self) -> tuple[Row, ...]:
        return tuple(_row(address, said) for address, said in self._said.items())

    def _line(self, sheet: Sheet, listed: AddressList, line: Line) -> list[tuple[Field, Cell]]:
        """Take in a line; return the cells that should say something but hold no plain value."""
        cells = {what: cell for what in _SAID if (cell := listed.cell(line, what)) and says_something(what, cell)}
        name = cells.get(Field.NICKNAME)
        is_spare = name is not None and self._is_spare(name, listed)
        if is_spare:
            del cells[Field.NICKNAME]
        at = listed.cell(line, Field.ADDRESS)
        if at is None or not says_something(Field.ADDRESS, at):
            if not is_spare:
                self._without_address(sheet, listed, line)
            return []
        if at.fault:
            return [(Field.ADDRESS, at)] if cells else []
        place = sheet.span(line, at.column)
        address = address_of(at.text)
        if address is None and (several := addresses_in(at.text)):
            self._add("CG601", place, _several_addresses(at, several))
            return []
        if address is None:
            if Field.NICKNAME in cells or (cells and looks_like_address(at.text)):
                self._add("CG601", place, _no_address(at))
            return []
        if name is not None and is_spare:
            self._said.setdefault(address, _Said(place)).spare = name.text
            self._spares.append(_Fact(name.text, sheet.span(line, name.column)))
        for what, cell in cells.items():
            if not cell.fault and not is_blank_value(address, what, cell):
                self._take(address, what, cell, place, sheet.span(line, cell.column))
        if name is None:
            self._without_nickname(sheet, listed, line, address)
        return [(what, cell) for what, cell in cells.items() if cell.fault]

    def _is_spare(self, name: Cell, listed: AddressList) -> bool:
        """True for a nickname that is none. In CLICK's own table Spare is one, as long as it occurs once."""
        if spare_where_twice(name.text) in self._doubtful_spares:
            return True
        return is_spare(name.text) and not (listed.is_table and nickname_fault(name.text) is None)

    def _passed_over(self) -> None:
        """Report once for a list which rows have no nickname, and what they have instead."""
        if not self._spares:
            return
        counts = Counter(str(each.value) for each in self._spares)
        shown = counts.most_common(_WORDS_SHOWN)
        words = [f"{short(word)} in {count}" for word, count in shown]
        rest = len(self._spares) - sum(count for _, count in shown)
        words += [f"others in {rest}"] if rest else []
        self._add(
            "CG618",
            self._spares[0].span,
            Fault(
                f"{counted(len(self._spares), 'row')} of this list {'has' if len(self._spares) == 1 else 'have'} no "
                f"nickname: {', '.join(words)}",
                "clickgen gives these addresses to no name; write a nickname there when the point is used",
            ),
        )

    def _two_addresses(self, sheet: Sheet, listed: AddressList) -> None:
        """Report once for a list that rows have an internal address and an external one."""
        both = [
            (at, other, line)
            for line in listed.lines
            if (other := listed.other_address(line)) is not None
            and (at := listed.cell(line, Field.ADDRESS)) is not None
            and address_of(at.text) not in (None, address_of(other.text))
        ]
        if both:
            at, other, line = both[0]
            more = f", and so in {counted(len(both) - 1, 'row')} below" if len(both) > 1 else ""
            message = (
                f"{short(other.text)} is left out: the internal address of the row, {short(at.text)}, counts{more}"
            )
            way_out = "give the external address a row of its own if it has a nickname too"
            self._add("CG604", sheet.span(line, other.column), Fault(message, way_out))

    def _take(self, address: Address, what: Field, cell: Cell, place: Span, span: Span) -> None:
        """Take in what a cell says of an address in ``place``, unless CLICK cannot hold it."""
        value = value_of(address, what, cell)
        if isinstance(value, Fault):
            self._add("CG603" if what is Field.NICKNAME else "CG601", span, value)
            return
        fact = _Fact(value, span)
        said = self._said.setdefault(address, _Said(place))
        earlier = said.facts.setdefault(what, fact)
        if earlier is fact:
            if what is Field.NICKNAME:
                self._take_name(address, fact)
        elif what is Field.COMMENT and not str(earlier.value).strip():
            said.facts[what] = fact
        elif not agree(address, what, fact.value, earlier.value):
            self._contradiction(address, what, fact, earlier)

    def _take_name(self, address: Address, fact: _Fact) -> None:
        name = str(fact.value)
        fault = address_nickname_fault(address, name)
        if fault:
            self._add("CG603", fact.span, fault)
        holder, earlier = self._by_name.setdefault(name.lower(), (address, fact))
        if holder != address and not may_share_a_name(holder, address):
            spelled = "" if earlier.value == name else f", there spelled {short(str(earlier.value))}"
            self._twice(
                fact,
                earlier,
                f"the nickname {short(name)} of {address} already belongs to {holder} "
                f"in {earlier.span.seen_from(fact.span)}{spelled}",
                "give one of the two another nickname, or none to a spare point; "
                "CLICK does not tell capitals from small letters",
            )

    # -- what is wrong ------------------------------------------------------------------------------------------------

    def _contradiction(self, address: Address, what: Field, fact: _Fact, earlier: _Fact) -> None:
        here, there = (in_words(each.value) for each in (fact, earlier))
        self._twice(
            fact,
            earlier,
            f"the {what.value} of {address} is {here} here and {there} in {earlier.span.seen_from(fact.span)}",
            "make the two cells say the same, or empty one of them",
        )

    def _twice(self, fact: _Fact, earlier: _Fact, message: str, way_out: str) -> None:
        hidden = sorted({fact.span.sheet, earlier.span.sheet} & self._hidden)
        if hidden:
            way_out += f" (hidden: {', '.join(map(short, hidden))})"
        self.problems.add("CG602", fact.span, message, way_out, (Label(earlier.span, "the earlier cell"),))

    def _without_address(self, sheet: Sheet, listed: AddressList, line: Line) -> None:
        cell = listed.cell(line, Field.NICKNAME)
        if cell is None or not name_of(cell):
            return
        place = sheet.span(line, listed.columns[Field.ADDRESS])
        self._add(
            "CG604",
            sheet.span(line, cell.column),
            Fault(f"{short(cell.text)} has no address and is left out", f"write its address into {place.cell}"),
        )

    def _without_nickname(self, sheet: Sheet, listed: AddressList, line: Line, address: Address) -> None:
        cell = listed.untitled_neighbour(line, Field.NICKNAME)
        if cell is None or not name_of(cell):
            return
        place = sheet.span(line, listed.columns[Field.NICKNAME])
        self._add(
            "CG604",
            sheet.span(line, cell.column),
            Fault(
                f"{address} has no nickname; {short(cell.text)}, in a column without a title, is left out",
                f"move it into {place.cell}, or give its column a title",
            ),
        )

    def _no_values(self, what: Field, fault: str, spans: list[Span]) -> None:
        """Report once the cells of one column that hold a formula, or anything else that is not a plain value."""
        more = len(spans) - 1
        others = f", and so {'are' if more > 1 else 'is'} {more} more below" if more else ""
        is_comment = what is Field.COMMENT
        left_out = " and is left out" if is_comment else ""
        message = f"the {what.value} in {spans[0].cell} is {fault}{left_out}{others}"
        way_out = _WAYS_OUT.get(fault, "write what it should say as plain text")
        if fault.startswith("an error"):
            way_out += ", or clear the cell; a point without a nickname is SPARE"
        self._add("CG604" if is_comment else "CG601", spans[0], Fault(message, way_out))

    def _strange_list(self, sheet: Sheet, line: Line, cell: Cell) -> None:
        self._add(
            "CG601",
            sheet.span(line, cell.column),
            Fault(
                f"no row of this list has an address of CLICK; the first reads {short(cell.shown)}",
                "write addresses such as X001 or DS100, or give the column another title if it holds other addresses",
            ),
        )

    def _add(self, code: str, span: Span, fault: Fault) -> None:
        self.problems.add(code, span, *fault)


def _doubtful_spares(lists: Iterable[AddressList]) -> set[str]:
    """The words for spare points that two addresses have."""
    holders: dict[str, set[Address]] = {}
    for listed in lists:
        for line in listed.lines:
            at, name = listed.cell(line, Field.ADDRESS), listed.cell(line, Field.NICKNAME)
            word = spare_where_twice(name.text) if name else ""
            address = address_of(at.text) if at and word else None
            if address:
                holders.setdefault(word, set()).add(address)
    return {word for word, addresses in holders.items() if len(addresses) > 1}


def _first_stranger(listed: AddressList) -> tuple[Line, Cell] | None:
    """The first row with a name and an unknown address, in a list that has no other addresses; else None."""
    first = None
    for line in listed.lines:
        at, name = listed.cell(line, Field.ADDRESS), listed.cell(line, Field.NICKNAME)
        if at and (at.fault or looks_like_address(at.text)):
            return None
        if not first and at and says_something(Field.ADDRESS, at) and name and says_something(Field.NICKNAME, name):
            first = (line, at)
    return first


def _several_addresses(cell: Cell, named: tuple[str, ...]) -> Fault:
    return Fault(
        f"{short(cell.shown)} are several addresses, and a row of a list is one",
        f"write a row for each of them, {named[0]} and so on to {named[-1]}, with a nickname of its own or SPARE",
    )


def _no_address(cell: Cell) -> Fault:
    fault = no_address(cell.shown)
    if looks_like_address(cell.text):
        return fault
    return Fault(fault.message, f"{fault.way_out}; a remark belongs outside the columns of the list")


def _row(address: Address, said: _Said) -> Row:
    values = {what: fact.value for what, fact in said.facts.items()}
    nickname, comment = str(values.get(Field.NICKNAME, "")), str(values.get(Field.COMMENT, ""))
    initial = str(values.get(Field.INITIAL, default_row(address, "").initial))
    retentive = bool(values.get(Field.RETENTIVE, BANKS[address.bank].retentive))
    spare = "" if nickname else said.spare
    return Row(address, nickname, initial, retentive, comment, cell=said.cell, spare=spare)
