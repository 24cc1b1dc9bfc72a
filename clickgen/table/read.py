"""Reads an address table and reports everything that is wrong with it at once."""

from __future__ import annotations

import csv
import io
import re
from pathlib import Path

from clickgen.device.banks import BANKS, Address, parse_address
from clickgen.device.project_file import is_click_project
from clickgen.problems.diagnostics import Diagnostics, Label
from clickgen.table.address_table import BOM, AddressTable, Entry
from clickgen.table.form import PLAIN, TableForm, form_of, is_upper_word, settled, without_marks
from clickgen.table.judge_row import (
    Fault,
    address_comment_fault,
    address_nickname_fault,
    initial_value_fault,
    may_share_a_name,
    no_address,
    retention_fault,
    short,
)
from clickgen.table.rows import HEADER, Row, text_span
from clickgen.text.source import Span
from clickgen.workspace import NoRegularFile, Workspace

_ADDRESS, _TYPE, _NICKNAME, _INITIAL, _RETENTIVE, _COMMENT = range(6)
_MODBUS = 2
"""The column of the Modbus number, in a table that has one."""
FILE_MAX = 32 * 2**20
LINES_MAX = 200_000
PROBLEMS_MAX = 1_000
"""After this many problems, the rest of a table is not read."""
_SAVE_AS_XLSX = "open it in a spreadsheet program and save it as .xlsx"
# The longest address is CTD250; a field of thousands of digits is no business of int().
_ADDRESS_MAX = 16


class TableUnreadable(Exception):
    """The file cannot be read as an address table at all; the message says why and what to do."""


def read_table(path: Path, shown: str, problems: Diagnostics, data: bytes | None = None) -> AddressTable:
    """Read an address table. ``shown`` is the path as the user knows it, ``data`` what to read instead of the file.

    Raises TableUnreadable if the file is not an address table. Everything wrong with single rows goes to ``problems``,
    all at once; a row with a readable address is in the table all the same, so that its name is known.
    """
    text, bom = _decoded(bytes_of_table(path, shown) if data is None else data, shown)
    # Only \n ends a line, as in SourceFile; the \r of \r\n stays on the line, and the csv module handles it.
    lines = io.StringIO(text, newline="\n").readlines()
    if len(lines) > LINES_MAX:
        raise TableUnreadable(f"{shown} has more than {LINES_MAX:,} lines, far more than CLICK has addresses")
    reader = _Reader(shown, problems, _form_of(lines[0] if lines else "", shown))
    reader.read(lines)
    return AddressTable(shown, tuple(reader.entries), reader.entries[0].end or "\n", bom, form=reader.form)


def bytes_of_table(path: Path, shown: str, workspace: Workspace | None = None) -> bytes:
    """Return the bytes of an address table; if it is too large, only the first ones.

    Raises TableUnreadable if it cannot be read.
    """
    try:
        return (workspace or Workspace()).start(path, FILE_MAX + 1)
    except FileNotFoundError:
        raise TableUnreadable(
            f"there is no address table at {shown}; clickgen begins one where the settings name it: "
            f'programs = [{{ path = "prog.py", nicknames = "{Path(shown).as_posix()}" }}] in clickgen.toml'
        ) from None
    except NoRegularFile:
        raise TableUnreadable(f"{shown} is a pipe or a device; name a file") from None
    except OSError as error:
        if path.is_dir():  # Windows answers a folder with PermissionError.
            raise TableUnreadable(f"{shown} is a folder; name the nickname CSV in it") from None
        raise TableUnreadable(f"{shown} cannot be read: {error.strerror or error}") from error


def _decoded(data: bytes, shown: str) -> tuple[str, bool]:
    if is_click_project(data[:FILE_MAX], shown):
        raise TableUnreadable(
            f"{shown} is a project of CLICK, which only CLICK opens: open it there, export its "
            "nicknames, and name that file"
        )
    if data.startswith((b"PK\x03\x04", b"\xd0\xcf\x11\xe0")):
        raise TableUnreadable(_workbook_in_its_place(data, shown))
    if len(data) > FILE_MAX:
        raise TableUnreadable(f"{shown} has more than {FILE_MAX >> 20} MB, far more than CLICK has addresses")
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        raise TableUnreadable(f"{shown} is UTF-16 (Excel's Unicode text); save it as CSV UTF-8")
    bom = data.startswith(BOM)
    try:
        return data[len(BOM) if bom else 0 :].decode("utf-8"), bom
    except UnicodeDecodeError as error:
        line = error.object.count(b"\n", 0, error.start) + 1
        byte = error.object[error.start]
        message = f"{shown} is not UTF-8: line {line} holds the byte {byte:02X}; save it as CSV UTF-8"
        raise TableUnreadable(message) from None


def _workbook_in_its_place(data: bytes, shown: str) -> str:
    """The message for a spreadsheet program's own file that is not read as a workbook."""
    if shown.lower().endswith((".xlsx", ".xlsm")):
        return f"{shown} is an Excel workbook, and a nickname CSV as CLICK exports it is needed here"
    if data.startswith(b"\xd0\xcf"):
        return f"{shown} is an old Excel workbook (.xls), or protected by a password: {_SAVE_AS_XLSX}"
    if data[30:38] == b"mimetype":
        return f"{shown} is an OpenDocument spreadsheet (.ods): {_SAVE_AS_XLSX}"
    if b"xl/workbook.bin" in data:
        return f"{shown} is a binary Excel workbook (.xlsb): {_SAVE_AS_XLSX}"
    if b"xl/workbook.xml" in data:
        return f"{shown} is an Excel workbook: give it a name that ends in .xlsx"
    return f"{shown} is a zip archive and no nickname CSV; if it is a spreadsheet, {_SAVE_AS_XLSX}"


def _form_of(line: str, shown: str) -> TableForm:
    """The form that the header gives. Raises TableUnreadable if it is not the header of a nickname CSV."""
    # The names need no quotes; a spreadsheet may have added some.
    fields = without_marks(line.rstrip("\r\n")).split(",")
    form = form_of([re.sub(r'^"(.*)"$', r"\1", field) for field in fields])
    if form is not None:
        return form
    if not line:
        reason = "it is empty"
    elif not line.strip():
        reason = "its first line is empty"
    elif "\r" in line.rstrip("\r\n"):
        reason = "its lines end in a lone carriage return"
    elif "\0" in line:
        reason = "it holds binary data"
    elif line.count(";") >= 5 or line.count("\t") >= 5:
        reason = f"its columns are separated by {'semicolons' if ';' in line else 'tabs'}; save it with commas"
    else:
        start = line.strip()
        reason = f"it begins with {start if len(start) <= 60 else start[:60] + '...'}"
    raise TableUnreadable(f"{shown} is not a CLICK nickname CSV: {reason}. The first line must be {HEADER}")


class _Reader:
    """Turns the lines of a table into entries, and reports what is wrong with each row."""

    def __init__(self, shown: str, problems: Diagnostics, form: TableForm = PLAIN) -> None:
        self.shown = shown
        self.problems = problems
        self.form = form
        self.entries: list[Entry] = []
        self._by_address: dict[Address, Row] = {}
        self._by_name: dict[str, Row] = {}
        self._count = 0

    @property
    def is_full(self) -> bool:
        """True when enough has been reported."""
        return self._count >= PROBLEMS_MAX

    def read(self, lines: list[str]) -> None:
        self._keep(None, *_cut(lines[0]))
        start = self._read_rows(lines)
        if start < len(lines):
            self._keep(None, *_cut("".join(lines[start:])))

    def _read_rows(self, lines: list[str]) -> int:
        """Read rows until there are too many problems; return the first line that was not read."""
        start = 1
        while start < len(lines) and not self.is_full:
            # A new reader after each fault: the csv module would go on after the text that the open quote swallowed.
            reader = csv.reader(map(lines.__getitem__, range(start, len(lines))), strict=True)
            base = start
            try:
                for fields in reader:
                    end = base + reader.line_num
                    text, line_end = _cut(lines[start] if end - start == 1 else "".join(lines[start:end]))
                    row = self._row(fields, text, start + 1) if any(fields) else None
                    self._keep(row, text, line_end)
                    start = end
                    if self.is_full:
                        break
            except csv.Error as error:
                text, line_end = _cut(lines[start])
                self._unsplittable(str(error), text, start + 1)
                self._keep(None, text, line_end)
                start += 1
        return start

    def _keep(self, row: Row | None, text: str, line_end: str) -> None:
        self.entries.append(Entry(row, text, line_end))

    def _row(self, fields: list[str], raw: str, line: int) -> Row | None:
        if len(fields) != self.form.width:
            self._malformed(
                text_span(self.shown, line, raw, 0, len(raw)),
                Fault(
                    f"this row has {len(fields)} field{'s' * (len(fields) != 1)} where {self.form.width} are expected",
                    f"write {self.form.header}, with a nickname or comment that holds a comma between double quotes",
                ),
            )
            return None
        shown_address, word, nickname, initial, retentive, comment = self.form.fields(fields)
        if not shown_address and is_upper_word(self.form, fields):
            return None
        address = parse_address(shown_address) if len(shown_address) <= _ADDRESS_MAX else None
        if address is None:
            self._malformed(self._field(line, raw, _ADDRESS), no_address(shown_address))
            return None
        row = Row(address, nickname, initial, retentive == "Yes", comment, line, raw)
        for field, fault in (
            (_TYPE, _type_fault(address, word)),
            (_INITIAL, None if initial == "0" else initial_value_fault(address, initial)),
            (_RETENTIVE, _retentive_fault(address, retentive)),
            (_COMMENT, address_comment_fault(address, comment) if comment else None),
        ):
            if fault:
                self._malformed(self._field(line, raw, field), fault)
        if self.form.has_modbus:
            self._modbus(row, fields)
        return self._placed(row)

    def _modbus(self, row: Row, fields: list[str]) -> None:
        """Learn how the table writes its numbers, and report a number that is not that of its address."""
        self.form = settled(self.form, fields, row.raw)
        if not self.form.has_number(fields, row.address):
            number = self.form.number(row.address)
            self._add(
                "CG607",
                _field_span(self.shown, row.line, row.raw, _MODBUS),
                Fault(
                    f"{row.address} is given the Modbus number {short(fields[_MODBUS])}, and CLICK has it at {number}",
                    f"write {number}, or look whether the row was meant for another address",
                ),
            )

    def _field(self, line: int, raw: str, field: int) -> Span:
        return _field_span(self.shown, line, raw, self.form.column(field))

    def _placed(self, row: Row) -> Row | None:
        """Return the row, unless its address is taken; report that, and judge the nickname."""
        stands = self._by_address.setdefault(row.address, row)
        if stands is not row:
            self._twice(
                row, _ADDRESS, stands, f"{row.address} stands twice: on line {stands.line} and here", "delete one row"
            )
            return None
        name = row.nickname
        if not name:
            return row
        fault = address_nickname_fault(row.address, name)
        if fault:
            self._add("CG603", self._field(row.line, row.raw, _NICKNAME), fault)
        holder = self._by_name.setdefault(name.lower(), row)
        if holder is not row and not may_share_a_name(holder.address, row.address):
            spelled = "" if holder.nickname == name else f", there spelled {short(holder.nickname)}"
            self._twice(
                row,
                _NICKNAME,
                holder,
                f"the nickname {short(name)} of {row.address} already belongs to {holder.address} "
                f"on line {holder.line}{spelled}",
                "give one of the two another nickname; CLICK does not tell capitals from small letters",
            )
        return row

    def _twice(self, row: Row, field: int, earlier: Row, message: str, way_out: str) -> None:
        there = self._field(earlier.line, earlier.raw, field)
        here = self._field(row.line, row.raw, field)
        self._add("CG602", here, Fault(message, way_out), (Label(there, f"the earlier row, {earlier.address}"),))

    def _unsplittable(self, reason: str, raw: str, line: int) -> None:
        if "field limit" in reason:
            message, way_out = "this row is far too long for a row of nicknames", "look for a quote that is not closed"
        elif "new-line" in reason:
            message, way_out = "a lone carriage return stands in this row", "delete it, or put a line break there"
        else:
            message = "the double quotes of this row do not pair up"
            way_out = 'put nickname and comment between double quotes, and write "" for a quote inside them'
        self._malformed(text_span(self.shown, line, raw, 0, len(raw)), Fault(message, way_out))

    def _malformed(self, span: Span, fault: Fault) -> None:
        self._add("CG601", span, fault)

    def _add(self, code: str, span: Span, fault: Fault, labels: tuple[Label, ...] = ()) -> None:
        self._count += 1
        if self._count <= PROBLEMS_MAX:
            more = "; and more: nothing below is read" if self.is_full else ""
            self.problems.add(code, span, fault.message + more, fault.way_out, labels)


def _type_fault(address: Address, word: str) -> Fault | None:
    bank = BANKS[address.bank]
    if word == bank.kind.value:
        return None
    return Fault(
        f"{address} is given the data type {short(word)}",
        f"write {bank.kind.value}: {bank.name} holds {bank.title}",
    )


def _retentive_fault(address: Address, word: str) -> Fault | None:
    if word == "Yes" or word == "No":
        return retention_fault(address, word == "Yes")
    return Fault(f"the Retentive field of {address} reads {short(word)}", "write Yes or No")


def _cut(text: str) -> tuple[str, str]:
    """Split a row into its text and its line end."""
    if text.endswith("\r\n"):
        return text[:-2], "\r\n"
    if text.endswith(("\n", "\r")):
        return text[:-1], text[-1]
    return text, ""


def _field_span(shown: str, line: int, raw: str, field: int) -> Span:
    """The span of a field of a row, its quotes included."""
    start = 0
    for index in range(field + 1):
        if raw.startswith('"', start):
            close = raw.find('"', start + 1)
            while close >= 0 and raw.startswith('"', close + 1):
                close = raw.find('"', close + 2)
            end = close + 1 if close >= 0 else len(raw)
        else:
            comma = raw.find(",", start)
            end = comma if comma >= 0 else len(raw)
        if index < field:
            start = end + 1
    return text_span(shown, line, raw, start, end)
