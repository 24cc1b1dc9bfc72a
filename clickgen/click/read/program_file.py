"""CLICK's program files (``Scr*.tmp``) read byte by byte, and each rung compared with laddercodec's reading.

laddercodec 0.2.2 reads these files but does not write them, so its reading is compared with the file instruction by
instruction, in the fields of the clipboard's form. CLICK leaves out fields with their usual value
(click-facts [click-file.program]).
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from clickgen.click.draw.grid import COLUMNS
from clickgen.click.ladder_csv import HEADER
from clickgen.click.read.blobs import UNINDEXED, Blob, Field, Head, read_blob
from clickgen.click.read.fields import told
from clickgen.click.read.harmless import DRAWN_TALLER, SWITCHES, WIRED_LATER, reason_for

if TYPE_CHECKING:
    from laddercodec import Rung
    from laddercodec.instructions import AfInstruction, AfToken, ConditionInstruction, ConditionToken

_ENTRY = struct.Struct("<BBBBI")
_NAME_AT = 0x42
_MAIN = 1
"""The prog_idx of a main program, whose file has two more bytes at its end."""
_INDEXED_END = 0xFFFF


class ProgramFault(Exception):
    """Bytes that are not a program file of the known form."""


@dataclass(frozen=True)
class Placed:
    """An instruction and its place, from 0."""

    row: int
    column: int
    span: int
    blob: Blob


@dataclass(frozen=True)
class FileRung:
    """A rung of the file: its wires to the right and down, by rows, and its instructions."""

    comment: bytes
    rights: tuple[frozenset[int], ...]
    downs: Mapping[int, frozenset[int]]
    placed: tuple[Placed, ...]

    @property
    def is_empty(self) -> bool:
        """True for one of the rungs that CLICK keeps below the last one; some have a wire."""
        return not self.placed and not self.comment


def read_rungs(data: bytes) -> list[FileRung]:
    """Return every rung of a program file. Raises ProgramFault."""
    try:
        return _Reader(data).rungs()
    except (struct.error, IndexError, UnicodeDecodeError) as error:
        raise ProgramFault("the file breaks off, or holds something that is not known") from error


class _Reader:
    def __init__(self, data: bytes) -> None:
        self.data = data
        self.at = 0

    def rungs(self) -> list[FileRung]:
        [index] = struct.unpack_from("<H", self.data, 0x40)
        self.at = _NAME_AT
        self._take(self._byte())
        self._take(2 * self._word())  # the width of the columns on the screen
        self._byte()  # CLICK's view
        found = [self._rung(number) for number in range(self._word())]
        if self.at != len(self.data) - (2 if index == _MAIN else 0):
            raise ProgramFault("the file goes on after its last rung")
        return found

    def _rung(self, number: int) -> FileRung:
        if self._word() != number:
            raise ProgramFault(f"rung {number + 1} has another number")
        comment = self._take(self._long())
        _, *rights = [self._row() for _ in range(self._word())]
        downs = {column: self._take(self._word()) for column in range(self._word())}
        if any(0 in rows for rows in downs.values()):
            raise ProgramFault(f"a wire leads down from the comment of rung {number + 1}")
        count = self._word()
        if count:
            self._long()  # the same number in all rungs of a file; nobody knows what it means
        placed = tuple(self._instruction(order) for order in range(count))
        wires = {column: frozenset(row - 1 for row in rows) for column, rows in downs.items() if rows}
        return FileRung(comment, tuple(rights), wires, placed)

    def _row(self) -> frozenset[int]:
        """The columns that have a wire to the right; the order in which they were drawn does not count."""
        self._byte()
        pairs = [self._take(2) for _ in range(self._word())]
        if any(segment > 1 for segment, _ in pairs):
            raise ProgramFault("a wire is marked in a way that is not known")
        return frozenset(column for _, column in pairs)

    def _instruction(self, order: int) -> Placed:
        row, column, span, _, number = _ENTRY.unpack(self._take(_ENTRY.size))
        name = self._text()
        kind = self._word()
        unknown, _step, unknown_too = struct.unpack("<HHH", self._take(6))
        parts = self._byte()
        self._take(parts)  # the rows of the parts, which begin with the row of the box
        end = self._long()
        if number != order or unknown or unknown_too:
            raise ProgramFault(f"the instruction {name} is not of the form that is known")
        fields = list(self._fields(end))
        if self.at != end:
            raise ProgramFault(f"the fields of {name} do not end where they should")
        switches = self._switches()
        blob = Blob(Head(name, kind, parts, b""), tuple(_with_switches(name, fields, switches)))
        if len(blob.values) != len(blob.fields):
            raise ProgramFault(f"{name} has a field twice")
        return Placed(row - 1, column, span, blob)

    def _fields(self, end: int) -> Iterator[Field]:
        while self.at < end:
            tag = self._word()
            if tag == 0:
                return
            yield from self._values(tag)

    def _values(self, tag: int) -> Iterator[Field]:
        """Read the values of a tag, whose upper byte gives their kind."""
        kind = tag >> 8
        if kind in SWITCHES:
            yield Field(tag, UNINDEXED, "")
        elif kind in (0x20, 0x21, 0x22):
            yield Field(tag, UNINDEXED, str(self._byte()))
        elif kind == 0x32:
            yield Field(tag, UNINDEXED, str(self._word()))
        elif kind in (0x3A, 0x68):
            while (index := self._word()) != _INDEXED_END:
                yield Field(tag, index, str(self._word()) if kind == 0x3A else self._text())
        else:
            yield Field(tag, UNINDEXED, self._text())

    def _switches(self) -> int:
        """The values of the switches, a bit for each in the order of the fields, after them."""
        count, zero = self._take(2)
        if zero or count > 8:
            raise ProgramFault("the switches of an instruction are not of the form that is known")
        return int.from_bytes(self._take(count), "little")

    def _text(self) -> str:
        """A text with its length before it and a NUL of one byte after it."""
        data = self._take(self._byte())
        if data and (len(data) % 2 == 0 or data[-1]):
            raise ProgramFault("a text has no end")
        return data[:-1].decode("utf-16-le", "surrogatepass")

    def _take(self, count: int) -> bytes:
        part = self.data[self.at : self.at + count]
        if len(part) < count:
            raise ProgramFault("the file breaks off")
        self.at += count
        return part

    def _byte(self) -> int:
        return self._take(1)[0]

    def _word(self) -> int:
        return int.from_bytes(self._take(2), "little")

    def _long(self) -> int:
        return int.from_bytes(self._take(4), "little")


def _with_switches(name: str, fields: Sequence[Field], bits: int) -> Iterator[Field]:
    place = 0
    for field in fields:
        if field.tag >> 8 in SWITCHES:
            field = field._replace(value=str(bits >> place & 1))
            place += 1
        yield field
    if bits >> place:
        raise ProgramFault(f"{name} has more switches than fields for them")


# -- comparing --------------------------------------------------------------------------------------------------------

_USUAL: Mapping[tuple[str, int], str | tuple[str, ...]] = {
    ("Out", 0x3218): "8193",
    ("Tmr", 0x3A05): ("8717",),
    ("Cnt", 0x3A05): ("8710", "0", "8711"),
    ("SR", 0x3A05): ("8448", "8449", "8450"),
    ("Drum", 0x3A05): ("8455", "8456"),
    ("Drum", 0x3203): "1",
    ("Drum", 0x3204): "1",
    ("Drum", 0x20CA): "2",
    ("Email", 0x20CA): "2",
    ("Position", 0x222F): "2",
    ("Velocity", 0x222F): "2",
    **{("RD", tag): "1" for tag in (0x1209, 0x120A, 0x120B, 0x121A, 0x121B, 0x121E, 0x121F, 0x320E, 0x60B2)},
    ("SD", 0x60B2): "0",
    ("RD", 0x608D): "SD50",
    ("RD", 0x608E): "SD60",
    **{(name, tag): value for name in ("RD", "SD") for tag, value in ((0x221C, "1"), (0x3210, "1"), (0x322C, "502"))},
}
"""The contents of fields that CLICK leaves out, if neither 0 nor empty, by class and tag."""

_DERIVED = 0x3218
"""CLICK's code of an instruction: program files have it only for coils, as it follows from the other fields."""


def differences(rung: FileRung, read: Rung) -> Iterator[str]:
    """Yield the differences between a rung of the file and laddercodec's reading of it."""
    if len(rung.rights) != read.logical_rows:
        yield f"it has {len(rung.rights)} rows, and {read.logical_rows} are read"
        return
    tokens = {
        (row, column): token
        for row, tokens in enumerate(read.conditions)
        for column, token in enumerate((*tokens, read.instructions[row]))
    }
    yield from _wires(rung, tokens)
    instructions = {place for place, token in tokens.items() if not isinstance(token, str)}
    for placed in rung.placed:
        place = placed.row, placed.column
        if place not in instructions:
            yield f"{placed.blob.head.name} in row {placed.row + 1} is not read"
            continue
        instructions.remove(place)
        what = _difference(placed, tokens[place])
        if what:
            yield f"row {placed.row + 1}, column {HEADER[placed.column + 1]}: {what}"
    if instructions:
        yield "something is read that the file does not hold"


def _wires(rung: FileRung, tokens: Mapping[tuple[int, int], ConditionToken | AfToken]) -> Iterator[str]:
    spans = {placed.row: placed.span for placed in rung.placed if placed.column == COLUMNS}
    for row, rights in enumerate(rung.rights):
        read = {column for column in range(COLUMNS) if tokens[row, column] not in ("", "|")}
        if rights - {COLUMNS} != read:
            yield f"row {row + 1}: its wires are not those that are read"
        token = tokens[row, COLUMNS]
        box = next((one for one in rung.placed if (one.row, one.column) == (row, COLUMNS)), None)
        is_later = box is not None and box.blob.head.name in WIRED_LATER
        is_covered = any(above < row < above + span for above, span in spans.items())
        if (COLUMNS in rights) != (token != "") and not is_later and not (is_covered and token == ""):
            yield f"row {row + 1}: the wire to its output is not read"
    downs: dict[int, set[int]] = {}
    for (row, column), token in tokens.items():
        if token in ("T", "|") if isinstance(token, str) else getattr(token, "wire_down", False):
            downs.setdefault(column, set()).add(row)
    if downs != rung.downs:
        yield "its wires down are not those that are read"


def _difference(placed: Placed, token: ConditionInstruction | AfInstruction) -> str:
    said = placed.blob
    made, _ = read_blob(token.build_blob(), 0)
    name = said.head.name
    if (name, said.head.type, said.head.parts) != (made.head.name, made.head.type, made.head.parts):
        return f"{name} is read as {made.head.name}, or is of another type"
    span = token.cell_params().get("visual_rows", 1)
    if placed.span != span and not (name in DRAWN_TALLER and (placed.span, span) == (3, 1)):
        return f"{name} spans {placed.span} rows, and {span} are read"
    whole = Blob(said.head, tuple(_filled_in(said, made)))
    for field in whole.fields:
        value = _switched(field.tag, made.values.get((field.tag, field.slot), _usual(name, field)))
        other = field._replace(value=value)
        if field.value != value and not reason_for(field, other, whole, made):
            return told(name, field, value)
    return ""


def _filled_in(said: Blob, made: Blob) -> Iterator[Field]:
    """Yield the fields of the file, and those that CLICK leaves out, with their usual contents."""
    for field in said.fields:
        is_signed = field.tag >> 8 == 0x3A and made.values.get((field.tag, field.slot), "").startswith("-")
        yield field._replace(value=str(int(field.value) - 0x10000)) if is_signed else field
    for field in dict.fromkeys(field._replace(value="") for field in made.fields):
        if field.tag and (field.tag, field.slot) not in said.values:
            is_derived = field.tag == _DERIVED and (said.head.name, _DERIVED) not in _USUAL
            value = made.value(_DERIVED) if is_derived else _usual(said.head.name, field)
            yield field._replace(value=value)


def _usual(name: str, field: Field) -> str:
    usual = _USUAL.get((name, field.tag))
    if isinstance(usual, tuple):
        return usual[field.slot] if field.slot < len(usual) else "0"
    return usual or ("" if field.tag >> 8 in (0x60, 0x61, 0x62, 0x68) else "0")


def _switched(tag: int, value: str) -> str:
    return "1" if tag >> 8 in SWITCHES and value == "-1" else value
