"""The address table: CLICK's nickname CSV, kept beside the program like a lock file.

A PLC keeps its data by address, so a name that once has an address keeps it. Reading and writing the table leaves
every row that nobody changed as it stands, byte for byte.
"""

from __future__ import annotations

import csv
import io
import math
import re
import struct
from bisect import bisect_left
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import accumulate
from pathlib import Path
from typing import NamedTuple

from clickgen.device.banks import BANKS, ORDER, Address, Kind, parse_address
from clickgen.device.nicknames import comment_fault, is_click_owned, nickname_fault
from clickgen.diagnostics import Diagnostics, Label
from clickgen.source import Span

COLUMNS = ("Address", "Data Type", "Nickname", "Initial Value", "Retentive", "Address Comment")
HEADER = ",".join(COLUMNS)

_ADDRESS, _TYPE, _NICKNAME, _INITIAL, _RETENTIVE, _COMMENT = range(6)
_BOM = b"\xef\xbb\xbf"
_FLOAT_MAX = 3.4028235e38
_INTEGER_RANGE = {Kind.INT16: (-32768, 32767), Kind.INT32: (-(2**31), 2**31 - 1)}
# The longest address is CTD250; a field of thousands of digits is no business of int().
_ADDRESS_MAX = 16


@dataclass(frozen=True, slots=True)
class Row:
    """One row: an address and what CLICK knows of it. ``initial`` is as written in the file.

    ``line`` counts from 1 and is 0 for a new row; ``raw`` is the row as it stands in the file without its line end.
    """

    address: Address
    nickname: str
    initial: str
    retentive: bool
    comment: str
    line: int = 0
    raw: str = ""

    @property
    def content(self) -> tuple[Address, str, str, bool, str]:
        """What the row says, wherever and however it is written."""
        return (self.address, self.nickname, self.initial, self.retentive, self.comment)

    @property
    def is_default(self) -> bool:
        """True when the row says nothing that CLICK would not assume without it."""
        bank = BANKS[self.address.bank]
        return (
            not self.nickname
            and not self.comment
            and self.initial in ("", _default_initial(bank.kind))
            and self.retentive == bank.retentive
        )


class TableUnreadable(Exception):
    """The file cannot be read as an address table at all; the message says why and what to do."""


class _Entry(NamedTuple):
    """A stretch of the file: a row, or text that is none (the header, a blank line, a malformed row)."""

    row: Row | None
    text: str
    end: str


@dataclass(frozen=True)
class AddressTable:
    """The rows of an address table and the exact text around them."""

    path: str
    _entries: tuple[_Entry, ...]
    newline: str = "\n"
    """The line end of the header, which new rows take too."""
    bom: bool = False

    @staticmethod
    def empty(path: str) -> AddressTable:
        """A table without rows: the header alone."""
        return AddressTable(path, (_Entry(None, HEADER, "\n"),))

    @cached_property
    def rows(self) -> tuple[Row, ...]:
        """Every row in file order."""
        return tuple(entry.row for entry in self._entries if entry.row is not None)

    @cached_property
    def by_nickname(self) -> dict[str, Row]:
        """The rows that have a nickname, by its lowercase form. The first counts where SC and SD rows share one."""
        names: dict[str, Row] = {}
        for row in self.rows:
            if row.nickname:
                names.setdefault(row.nickname.lower(), row)
        return names

    @cached_property
    def by_address(self) -> dict[Address, Row]:
        return {row.address: row for row in self.rows}

    @property
    def foreign(self) -> tuple[Row, ...]:
        """The rows of CLICK's own points (SC, SD), which are kept in the file but not ours to give."""
        return tuple(row for row in self.rows if row.address.bank in ("SC", "SD"))

    @property
    def final_newline(self) -> bool:
        return self._entries[-1].end != ""

    def span(self, row: Row) -> Span | None:
        """Where a row stands in the file, or None for a new one."""
        return _span(self.path, row.line, row.raw, 0, len(row.raw)) if row.line else None

    def named(self, address: Address, nickname: str, comment: str = "") -> Row:
        """A row that gives an address its nickname and keeps what an unnamed row there already says."""
        stands = self.by_address.get(address)
        if stands is None or stands.nickname:
            return default_row(address, nickname, comment)
        return replace(stands, nickname=nickname, comment=comment or stands.comment, line=0, raw="")

    def extended(self, rows: Iterable[Row]) -> AddressTable:
        """The table with these rows in it, in CLICK's row order among rows that stay where they are.

        A row whose address stands already takes that row's place if it has no nickname or the same one; a row that
        says what is there changes nothing. Raises ValueError where a name or an address would move.
        """
        added: list[Row] = []
        replaced: dict[Address, Row] = {}
        names = {name: row.address for name, row in self.by_nickname.items()}
        given: dict[Address, Row] = {}
        for row in sorted(rows, key=lambda row: row.address.sort_key):
            stands = self.by_address.get(row.address)
            if stands is not None and stands.nickname and stands.nickname != row.nickname:
                raise ValueError(f"{row.address} is {stands.nickname} and cannot become {row.nickname}")
            if row.nickname and names.setdefault(row.nickname.lower(), row.address) != row.address:
                raise ValueError(f"{row.nickname} is {names[row.nickname.lower()]} and cannot move to {row.address}")
            first = given.setdefault(row.address, row)
            if first.content != row.content:
                raise ValueError(f"{row.address} is given twice: {first.nickname} and {row.nickname}")
            if first is not row:
                continue
            if stands is None:
                added.append(replace(row, line=0, raw=""))
            elif stands.content != row.content:
                replaced[row.address] = replace(row, line=0, raw="")
        if not added and not replaced:
            return self

        places = _places(self._entries)
        at: dict[int, list[Row]] = {}
        for row in added:
            at.setdefault(places(row.address), []).append(row)
        entries: list[_Entry] = []
        for index, entry in enumerate((*self._entries, None)):
            entries += [_Entry(row, format_row(row), self.newline) for row in at.get(index, ())]
            if entry is not None:
                new = replaced.get(entry.row.address) if entry.row else None
                entries.append(_Entry(new, format_row(new), entry.end) if new else entry)
        if not self.final_newline:
            entries = [entry if entry.end else entry._replace(end=self.newline) for entry in entries]
            entries[-1] = entries[-1]._replace(end="")
        return AddressTable(self.path, tuple(entries), self.newline, self.bom)

    def text(self) -> str:
        """The file's text, without a byte order mark."""
        return "".join(entry.text + entry.end for entry in self._entries)

    def to_bytes(self) -> bytes:
        """The file."""
        return (_BOM if self.bom else b"") + self.text().encode("utf-8")


def _places(entries: tuple[_Entry, ...]) -> Callable[[Address], int]:
    """Where a new row goes: before which entry.

    After the last row of its bank with a smaller number, else before the first row of its bank, else after the last
    row of the nearest bank before it, else first of all. In a table in CLICK's order that is the one place in order.
    """
    banks: dict[int, list[tuple[int, bool, int]]] = {}
    for index, (row, _, _) in enumerate(entries):
        if row is not None:
            banks.setdefault(ORDER[row.address.bank], []).append((row.address.number, row.address.upper, index))
    first = {bank: min(item[2] for item in items) for bank, items in banks.items()}
    last = {bank: max(item[2] for item in items) for bank, items in banks.items()}
    furthest: dict[int, list[int]] = {}
    for bank, items in banks.items():
        items.sort()
        furthest[bank] = list(accumulate((item[2] for item in items), max))

    def place(address: Address) -> int:
        bank = ORDER[address.bank]
        if bank in banks:
            smaller = bisect_left(banks[bank], (address.number, address.upper, -1))
            return furthest[bank][smaller - 1] + 1 if smaller else first[bank]
        before = max((other for other in banks if other < bank), default=None)
        # Entry 0 is the header.
        return 1 if before is None else last[before] + 1

    return place


# -- rows and values ------------------------------------------------------------------------------------------------


def format_row(row: Row) -> str:
    """A row in CLICK's form: nickname and comment quoted, always, and nothing else (click-facts, section 1)."""
    kind = row.address.kind
    initial = row.initial or _default_initial(kind)
    # How CLICK writes a comma or a quote as the initial value of a TXT is unknown; unquoted it would not be a CSV.
    if kind is Kind.TEXT and initial in (",", '"', "\n", "\r"):
        initial = _quoted(initial)
    retentive = "Yes" if row.retentive else "No"
    return f"{row.address},{kind.value},{_quoted(row.nickname)},{initial},{retentive},{_quoted(row.comment)}"


SCRATCH = "Scratch_"
"""How the nicknames begin that clickgen gives to cells it needs for itself."""


def scratch_name(address: Address) -> str:
    return f"{SCRATCH}{address}"


_SCRATCH_NAME = re.compile(rf"{SCRATCH}[A-Z]+[0-9]+", re.IGNORECASE)
_SCRATCH_REASON = re.compile(r".+ of \w+ rung [0-9]+(: .+)?|rtof T[0-9]+: .+")


def looks_like_scratch(name: str) -> bool:
    """True for a name of the kind that clickgen keeps for its own cells."""
    return _SCRATCH_NAME.fullmatch(name) is not None


def is_scratch(row: Row) -> bool:
    """True for a row that clickgen itself wrote for a scratch use: its name and its reason say so."""
    return row.nickname == scratch_name(row.address) and _SCRATCH_REASON.fullmatch(row.comment) is not None


def default_row(address: Address, nickname: str, comment: str = "") -> Row:
    """A new row with CLICK's own initial value and retention for the bank."""
    bank = BANKS[address.bank]
    return Row(address, nickname, _default_initial(bank.kind), bank.retentive, comment)


def format_initial(kind: Kind, value: object) -> str | None:
    """An initial value as CLICK writes it, or None when a cell of this kind cannot hold the value.

    Takes bool, 0 or 1 for a bit; int; float or int for FLOAT; int or text such as ``"00FFh"`` for HEX; one ASCII
    character or nothing for TEXT.
    """
    if kind is Kind.TEXT:
        return value if isinstance(value, str) and _initial_fault(kind, value) is None else None
    if kind is Kind.HEX and isinstance(value, str):
        digits = re.fullmatch(r"([0-9A-Fa-f]{1,4})[hH]?", value)
        return _hex(int(digits[1], 16)) if digits else None
    if kind is Kind.BIT and isinstance(value, bool):
        return str(int(value))
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return None
    if kind is Kind.FLOAT:
        return _float(value)
    if not isinstance(value, int):
        return None
    if kind is Kind.HEX:
        return _hex(value) if 0 <= value <= 0xFFFF else None
    low, high = (0, 1) if kind is Kind.BIT else _INTEGER_RANGE[kind]
    return str(value) if low <= value <= high else None


def _default_initial(kind: Kind) -> str:
    return "" if kind is Kind.TEXT else "0"


def _quoted(text: str) -> str:
    return '"' + text.replace('"', '""') + '"'


def _hex(value: int) -> str:
    return f"{value:04X}" if value else "0"


def _float(value: float) -> str | None:
    """The shortest digits that give the same 32-bit float, with CLICK's exponent (``-3.4028235E+38``)."""
    if not -_FLOAT_MAX <= value <= _FLOAT_MAX:  # also false for NaN
        return None
    single = _single(float(value))
    if single == 0:
        return "0"
    digits = next(text for text in (f"{single:.{n}e}" for n in range(9)) if _single(float(text)) == single)
    mantissa, _, exponent = digits.partition("e")
    power = int(exponent)
    if -5 <= power < 7:
        places = len(mantissa.partition(".")[2])
        return f"{float(digits):.{max(places - power, 0)}f}"
    return f"{mantissa}E{power:+03d}"


def _single(value: float) -> float:
    try:
        number: float = struct.unpack("<f", struct.pack("<f", value))[0]
    except OverflowError:
        return math.inf
    return number


_BIT_FORM = re.compile(r"[01]")
_INTEGER_FORM = re.compile(r"-?[0-9]{1,10}")
_HEX_FORM = re.compile(r"[0-9A-Fa-f]{1,4}")
_FLOAT_FORM = re.compile(r"-?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")


def _initial_fault(kind: Kind, text: str) -> str | None:
    """What CLICK takes instead, when it does not take this initial value for this kind of cell."""
    if kind is Kind.BIT:
        return None if _BIT_FORM.fullmatch(text) else "0 or 1"
    if kind is Kind.HEX:
        return None if _HEX_FORM.fullmatch(text) else "up to four hexadecimal digits without h, such as 00FF"
    if kind is Kind.TEXT:
        return None if len(text) <= 1 and text.isascii() and text != "\0" else "one ASCII character, or nothing"
    if kind is Kind.FLOAT:
        # Long digit strings are legal for float(), and cheap.
        legal = _FLOAT_FORM.fullmatch(text) and abs(float(text)) <= _FLOAT_MAX
        return None if legal else "a number from -3.4028235E+38 to 3.4028235E+38"
    low, high = _INTEGER_RANGE[kind]
    legal = _INTEGER_FORM.fullmatch(text) and low <= int(text) <= high
    return None if legal else f"a whole number from {low} to {high}"


# -- reading --------------------------------------------------------------------------------------------------------


def read_table(path: Path, shown: str, problems: Diagnostics) -> AddressTable:
    """Read an address table. ``shown`` is the path as the user knows it.

    Raises TableUnreadable when the file is no address table. Everything wrong with single rows goes to ``problems``,
    all at once; a row whose address can be read is in the table all the same, so that its name is known.
    """
    text, bom = _decoded(path, shown)
    # Only \n ends a line, as in SourceFile; the \r of \r\n stays on the line, and the csv module knows it.
    lines = io.StringIO(text, newline="\n").readlines()
    _check_header(lines[0] if lines else "", shown)
    reader = _Reader(shown, problems)
    reader.read(lines)
    return AddressTable(shown, tuple(reader.entries), reader.entries[0].end or "\n", bom)


def _decoded(path: Path, shown: str) -> tuple[str, bool]:
    try:
        data = path.read_bytes()
    except FileNotFoundError:
        raise TableUnreadable(f"there is no address table at {shown}") from None
    except IsADirectoryError:
        raise TableUnreadable(f"{shown} is a folder; name the nickname CSV in it") from None
    except OSError as error:
        if path.is_dir():  # Windows answers a folder with PermissionError.
            raise TableUnreadable(f"{shown} is a folder; name the nickname CSV in it") from None
        raise TableUnreadable(f"{shown} cannot be read: {error.strerror or error}") from error
    if data.startswith((b"PK\x03\x04", b"\xd0\xcf\x11\xe0")):
        raise TableUnreadable(f"{shown} is an Excel workbook; save its table as CSV UTF-8 and name that")
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        raise TableUnreadable(f"{shown} is UTF-16 (Excel's Unicode text); save it as CSV UTF-8")
    bom = data.startswith(_BOM)
    try:
        return data[len(_BOM) if bom else 0 :].decode("utf-8"), bom
    except UnicodeDecodeError as error:
        line = error.object.count(b"\n", 0, error.start) + 1
        byte = error.object[error.start]
        message = f"{shown} is not UTF-8: line {line} holds the byte {byte:02X}; save it as CSV UTF-8"
        raise TableUnreadable(message) from None


def _check_header(line: str, shown: str) -> None:
    # The names need no quotes; a spreadsheet may have given them some.
    fields = line.rstrip("\r\n").split(",")
    if [re.sub(r'^"(.*)"$', r"\1", field) for field in fields] == list(COLUMNS):
        return
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
    """Turns the lines of a table into entries, saying what is wrong with each row."""

    def __init__(self, shown: str, problems: Diagnostics) -> None:
        self.shown = shown
        self.problems = problems
        self.entries: list[_Entry] = []
        self._by_address: dict[Address, Row] = {}
        self._by_name: dict[str, Row] = {}

    def read(self, lines: list[str]) -> None:
        self._keep(None, *_cut(lines[0]))
        start = 1
        while start < len(lines):
            # A reader of its own after each fault: the csv module would go on behind what the open quote swallowed.
            reader = csv.reader(map(lines.__getitem__, range(start, len(lines))), strict=True)
            base = start
            try:
                for fields in reader:
                    end = base + reader.line_num
                    text, line_end = _cut(lines[start] if end - start == 1 else "".join(lines[start:end]))
                    row = self._row(fields, text, start + 1) if any(fields) else None
                    self._keep(row, text, line_end)
                    start = end
            except csv.Error as error:
                text, line_end = _cut(lines[start])
                self._unsplittable(str(error), text, start + 1)
                self._keep(None, text, line_end)
                start += 1

    def _keep(self, row: Row | None, text: str, line_end: str) -> None:
        self.entries.append(_Entry(row, text, line_end))

    def _row(self, fields: list[str], raw: str, line: int) -> Row | None:
        if len(fields) != len(COLUMNS):
            self._malformed(
                _span(self.shown, line, raw, 0, len(raw)),
                f"this row has {len(fields)} field{'s' * (len(fields) != 1)} where {len(COLUMNS)} are expected",
                f"write {HEADER}, with a nickname or comment that holds a comma between double quotes",
            )
            return None
        shown_address, word, nickname, initial, retentive, comment = fields
        address = parse_address(shown_address) if len(shown_address) <= _ADDRESS_MAX else None
        if address is None:
            self._malformed(
                _field_span(self.shown, line, raw, _ADDRESS),
                f"CLICK has no address {_short(shown_address)}",
                _way_to_an_address(shown_address),
            )
            return None

        bank = BANKS[address.bank]
        kind = bank.kind
        row = Row(address, nickname, initial, retentive == "Yes", comment, line, raw)

        if word != kind.value:
            self._malformed(
                _field_span(self.shown, line, raw, _TYPE),
                f"{address} is given the data type {_short(word)}",
                f"write {kind.value}: {bank.name} holds {bank.title}",
            )
        if initial != "0" or kind is Kind.TEXT:
            expected = _initial_fault(kind, initial)
            if expected is not None:
                self._malformed(
                    _field_span(self.shown, line, raw, _INITIAL),
                    f"{address} cannot start with the value {_short(initial)}",
                    f"write {expected}",
                )
            elif bank.name in ("XD", "YD") and int(initial, 16):
                self._fixed(row, _INITIAL, "0")
        if retentive != "Yes" and retentive != "No":
            self._malformed(
                _field_span(self.shown, line, raw, _RETENTIVE),
                f"the Retentive field of {address} reads {_short(retentive)}",
                "write Yes or No",
            )
        elif row.retentive and bank.name in ("XD", "YD"):
            self._fixed(row, _RETENTIVE, "No")
        if comment:
            fault = comment_fault(comment)
            if fault:
                self._malformed(
                    _field_span(self.shown, line, raw, _COMMENT),
                    f"CLICK does not take the comment of {address}: {fault}",
                    "shorten the comment" if "takes" in fault else "take the character out of the comment",
                )
        return self._placed(row)

    def _placed(self, row: Row) -> Row | None:
        """The row, unless its address is taken; says so, and judges the nickname."""
        stands = self._by_address.setdefault(row.address, row)
        if stands is not row:
            self._twice(
                row, _ADDRESS, stands, f"{row.address} stands twice: on line {stands.line} and here", "delete one row"
            )
            return None
        name = row.nickname
        if not name:
            return row
        fault = nickname_fault(name)
        if fault and is_click_owned(row.address, name):
            fault = nickname_fault(name, system=True)
        if fault:
            self.problems.add(
                "CG603",
                _field_span(self.shown, row.line, row.raw, _NICKNAME),
                f"CLICK does not take the nickname {_short(name)} of {row.address}: {fault}",
                "rename it in CLICK and export again, or rename it here and in the program",
            )
        holder = self._by_name.setdefault(name.lower(), row)
        # CLICK itself gives one name to two of its own points now and then (pyclickplc, read_csv).
        if holder is not row and {holder.address.bank, row.address.bank} - {"SC", "SD"}:
            spelled = "" if holder.nickname == name else f", there spelled {_short(holder.nickname)}"
            self._twice(
                row,
                _NICKNAME,
                holder,
                f"the nickname {_short(name)} of {row.address} already belongs to {holder.address} "
                f"on line {holder.line}{spelled}",
                "give one of the two another nickname; CLICK does not tell capitals from small letters",
            )
        return row

    def _twice(self, row: Row, field: int, earlier: Row, message: str, way_out: str) -> None:
        there = _field_span(self.shown, earlier.line, earlier.raw, field)
        here = _field_span(self.shown, row.line, row.raw, field)
        self.problems.add("CG602", here, message, way_out, (Label(there, f"the earlier row, {earlier.address}"),))

    def _fixed(self, row: Row, field: int, expected: str) -> None:
        self._malformed(
            _field_span(self.shown, row.line, row.raw, field),
            f"CLICK lets nobody change the {COLUMNS[field].lower()} setting of {row.address}",
            f"write {expected}",
        )

    def _unsplittable(self, reason: str, raw: str, line: int) -> None:
        if "field limit" in reason:
            message, way_out = "this row is far too long for a row of nicknames", "look for a quote that is not closed"
        elif "new-line" in reason:
            message, way_out = "a lone carriage return stands in this row", "delete it, or put a line break there"
        else:
            message = "the double quotes of this row do not pair up"
            way_out = 'put nickname and comment between double quotes, and write "" for a quote inside them'
        self._malformed(_span(self.shown, line, raw, 0, len(raw)), message, way_out)

    def _malformed(self, span: Span, message: str, way_out: str) -> None:
        self.problems.add("CG601", span, message, way_out)


def _cut(text: str) -> tuple[str, str]:
    """A row's text and its line end."""
    if text.endswith("\r\n"):
        return text[:-2], "\r\n"
    if text.endswith(("\n", "\r")):
        return text[:-1], text[-1]
    return text, ""


def _short(text: str) -> str:
    """A field for a message: on one line, and not endless."""
    if not text:
        return '""'
    if len(text) > 40:
        text = text[:40] + "..."
    return text if text.isprintable() else ascii(text)


def _way_to_an_address(text: str) -> str:
    name = re.match(r"[A-Za-z]{0,4}", text.strip())
    bank = BANKS.get(name[0].upper()) if name else None
    if bank is None:
        return f"the banks are {' '.join(BANKS)}"
    return f"{bank.name} has {bank.describe_range()}"


def _span(shown: str, line: int, raw: str, start: int, end: int) -> Span:
    """The span of ``raw[start:end]`` of a row that begins on ``line``; an empty stretch is widened to one column."""
    first, last = _position(raw, start), _position(raw, max(end, start))
    if first == last:
        last = (last[0], last[1] + 1)
    return Span(shown, line + first[0], first[1], line + last[0], last[1])


def _position(raw: str, offset: int) -> tuple[int, int]:
    """Lines below the row's first, and the column from 1."""
    return raw.count("\n", 0, offset), offset - raw.rfind("\n", 0, offset)


def _field_span(shown: str, line: int, raw: str, field: int) -> Span:
    """Where a field of a row stands, its quotes included."""
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
    return _span(shown, line, raw, start, end)
