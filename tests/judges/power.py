"""Reads 33-column ladder CSV and finds where power goes, by the grid rules alone.

click-facts [grid.columns, grid.power, grid.wires]

Nodes are (row, boundary 0..31); boundary c is the left edge of column c and boundary 31 is the AF input. Column A's
left edge is the power rail on every row. Contacts, compares, ``-`` and ``T`` join boundary c to c+1; ``T``, ``|`` and
the ``T:`` prefix tie the left edge of their cell to the left edge of the cell below.
"""

from __future__ import annotations

import csv
import io
import random
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from typing import NamedTuple

CONDITION_COLUMNS = 31
COLUMNS = (*"ABCDEFGHIJKLMNOPQRSTUVWXYZ", "AA", "AB", "AC", "AD", "AE")
HEADER = ("marker", *COLUMNS, "AF")

MAX_ROWS = 32  # expanded rows of one rung
MAX_RUNGS = 256  # rungs of one file
MAX_GRID_ROWS = 2047  # expanded rows plus rungs of one file

# Grid height by instruction (click-facts [grid.heights]); every other instruction is one row high.
HEIGHTS: Mapping[str, int] = {
    **dict.fromkeys(("on_delay", "off_delay"), 2),
    **dict.fromkeys(("count_up", "count_down"), 3),
    **dict.fromkeys(("copy", "blockcopy", "fill", "search"), 2),
    **dict.fromkeys(("pack_bits", "pack_words", "pack_text", "unpack_to_bits", "unpack_to_words"), 2),
    "shift": 3,
    **dict.fromkeys(("event_drum", "time_drum"), 4),
    **dict.fromkeys(("send", "receive"), 3),
    **dict.fromkeys(("out", "latch", "reset", "math", "call", "return", "for", "next", "end"), 1),
    "raw": 1,  # or as many as it states
}
NOP = "NOP"

# Row of each pin inside its box, counted from the box's top row.
PIN_SLOTS: Mapping[str, Mapping[str, int]] = {
    "on_delay": {".reset": 1},
    "count_up": {".down": 1, ".reset": 2},
    "count_down": {".reset": 2},
    "shift": {".clock": 1, ".reset": 2},
    "event_drum": {".reset": 1, ".jump": 2, ".jog": 3},
    "time_drum": {".reset": 1, ".jump": 2, ".jog": 3},
}
REQUIRED_PINS: Mapping[str, tuple[str, ...]] = {
    "count_up": (".reset",),
    "count_down": (".reset",),
    "shift": (".clock", ".reset"),
    "event_drum": (".reset",),
    "time_drum": (".reset",),
}
# A down counter's own input is the middle input of its three-row box (click-facts [grid.down-counter]): its row is
# second.
OWN_SLOT: Mapping[str, int] = {"count_down": 1}

_BIT = r"(?:[XY]\d{3}|(?:C|T|CT|SC)\d{1,4})"
_REGISTER = r"(?:(?:DS|DD|DH|DF|TD|CTD|SD|TXT)\d{1,4}|[XY]D\d(?:u)?)"
_NUMBER = r"[+-]?\d+(?:\.\d+)?(?:[eE][+-]?\d+)?"
_CONSTANT = rf'(?:{_NUMBER}|[0-9A-Fa-f]{{1,8}}h|"(?:[^"]|"")*"|\$[0-9A-Fa-f]{{2}})'
_OPERAND = rf"(?:{_REGISTER}|{_CONSTANT})"
_CONTACT = re.compile(rf"~?(?:{_BIT}|immediate\(X\d{{3}}\)|X\d{{3}}\.immediate)")
_EDGE = re.compile(rf"(?:rise|fall)\({_BIT}\)")
_COMPARE = re.compile(rf"{_OPERAND}(?:==|!=|<=|>=|<|>){_OPERAND}")
_MARKER = re.compile(r"R\d*")
_CALL = re.compile(r"(\.?[a-z_]+)\(.*\)", re.DOTALL)
_RAW_HEIGHT = re.compile(r"raw\(\w+,0x[0-9a-f]{4},(\d+)")


class Terminal(NamedTuple):
    """One input that power can reach: an output's ordinal, top to bottom, and its pin ("" for its own row)."""

    output: int
    pin: str


@dataclass(frozen=True)
class Pin:
    """A box's secondary input such as ``.reset()``, and its expanded row."""

    token: str
    row: int


@dataclass(frozen=True)
class Output:
    """An instruction of the AF column, its expanded row, and its pins from top to bottom."""

    token: str
    row: int
    pins: tuple[Pin, ...] = ()


@dataclass(frozen=True)
class Row:
    """One grid row; ``line`` is its line in the CSV, or 0 for a continuation row that the CSV leaves out."""

    cells: tuple[str, ...]
    af: str = ""
    line: int = 0


@dataclass(frozen=True)
class LadderRung:
    """One rung: its comment lines, its rows as the CSV writes them, and the same rows expanded to full height."""

    comment: tuple[str, ...]
    written: tuple[Row, ...]
    rows: tuple[Row, ...]
    found: tuple[Output, ...]

    def outputs(self) -> list[Output]:
        return list(self.found)

    def terminals(self) -> dict[Terminal, int]:
        """Every place power can arrive, with its row."""
        places: dict[Terminal, int] = {}
        for number, output in enumerate(self.found):
            places[Terminal(number, "")] = output.row
            for pin in output.pins:
                places[Terminal(number, pin.token)] = pin.row
        return places


# ---------------------------------------------------------------------------------------------------- cells


@cache
def goes_down(cell: str) -> bool:
    """Whether the cell carries a downward wire at its left edge."""
    return cell in ("T", "|") or cell.startswith("T:")


@cache
def goes_right(cell: str) -> bool:
    """Whether the cell joins its left edge to its right edge, by wire or through a condition."""
    return cell not in ("", "|")


@cache
def condition_of(cell: str) -> str | None:
    """The cell's condition token without its ``T:`` prefix, or None for wires and blanks."""
    token = cell.removeprefix("T:")
    return None if token in ("", "-", "T", "|") else token


@cache
def leaf_of(token: str) -> tuple[str, bool]:
    """A condition token without its ``~``, and whether it had one."""
    return (token[1:], True) if token.startswith("~") else (token, False)


def name_of(af: str) -> str:
    """The instruction or pin name of an AF token: ``copy(DS1,DS2)`` is ``copy``."""
    return af.partition("(")[0]


@cache
def _is_known_cell(cell: str) -> bool:
    token = condition_of(cell)
    if token is None:
        return cell in ("", "-", "T", "|")
    return any(form.fullmatch(token) for form in (_CONTACT, _EDGE, _COMPARE))


# ---------------------------------------------------------------------------------------------------- reading


def read_ladder(text: str) -> list[LadderRung]:
    """Parse and expand a ladder CSV; AssertionError says what is malformed and on which line."""
    rungs: list[LadderRung] = []
    comment: list[str] = []
    rows: list[Row] = []

    def close() -> None:
        nonlocal comment, rows
        if rows:
            rungs.append(_finish(tuple(comment), tuple(rows)))
            comment, rows = [], []

    for line, marker, fields in _records(text):
        if marker == "#":
            close()
            comment.append(fields[0])
            continue
        cells, af = tuple(fields[:-1]), fields[-1]
        for column, cell in zip(COLUMNS, cells, strict=True):
            assert _is_known_cell(cell), f"line {line}: unknown cell {cell!r} in column {column}"
        if marker.startswith("R"):
            close()
        else:
            assert rows, f"line {line}: continuation row without a rung above it"
        rows.append(Row(cells, af, line))
    close()
    assert not comment, "comment at the end of the file belongs to no rung"
    return rungs


def _records(text: str) -> Iterator[tuple[int, str, list[str]]]:
    """Line number, marker and the other fields of each row below the header."""
    reader = csv.reader(io.StringIO(text, newline=""), strict=True)
    header = next(reader, [])
    assert tuple(header) == HEADER, f"line 1: wrong header {','.join(header)!r}"
    for fields in reader:
        line = reader.line_num
        assert fields, f"line {line}: empty line"
        marker, rest = fields[0], fields[1:]
        assert not any("\n" in field or "\r" in field for field in rest), f"line {line}: line break inside a cell"
        assert marker in ("", "#") or _MARKER.fullmatch(marker), f"line {line}: unknown marker {marker!r}"
        if marker == "#":
            assert len(fields) in (2, len(HEADER)), f"line {line}: comment row has {len(fields)} columns"
            assert not any(rest[1:]), f"line {line}: comment row has text outside column A"
        else:
            assert len(fields) == len(HEADER), f"line {line}: {len(fields)} columns, expected {len(HEADER)}"
        yield line, marker, rest


def _finish(comment: tuple[str, ...], written: tuple[Row, ...]) -> LadderRung:
    """Expand one rung and make every structural check on it."""
    rows, outputs = _expand(written)
    rung = LadderRung(comment, written, rows, outputs)
    where = f"rung at line {written[0].line}"
    assert outputs, f"{where}: no output"
    assert sum(output.token == NOP for output in outputs) <= 1, f"{where}: more than one NOP"
    assert len(rows) <= MAX_ROWS, f"{where}: {len(rows)} expanded rows, at most {MAX_ROWS}"
    for place, row in ((written, written[-1]), (rows, rows[-1])):
        for column, cell in zip(COLUMNS, row.cells, strict=True):
            assert not goes_down(cell), f"{where}: downward wire {cell!r} in {column} on row {len(place)}, its last"
    for number, row in enumerate(rows, 1):
        assert not goes_down(row.cells[0]), f"{where}: downward wire {row.cells[0]!r} in column A on row {number}"
    _check_wires(where, rung)
    return rung


@dataclass
class _Box:
    """The box being filled while expanding: its own row in the grid, and which row of the box comes next."""

    token: str
    row: int
    next_slot: int
    pins: list[Pin]

    @property
    def name(self) -> str:
        return name_of(self.token)

    @property
    def height(self) -> int:
        own = _RAW_HEIGHT.match(self.token)
        return int(own[1]) if own else HEIGHTS.get(self.name, 1)


def _expand(written: Sequence[Row]) -> tuple[tuple[Row, ...], tuple[Output, ...]]:
    """Give every box its full height, adding the blank continuation rows that the CSV leaves out."""
    rows: list[Row] = []
    boxes: list[_Box] = []
    box: _Box | None = None
    loose = False  # the row above has no output and belongs to no box
    pin_fits = False  # only padding is between this row and the instruction or pin above it

    def pad(count: int) -> None:
        rows.extend([Row(("",) * CONDITION_COLUMNS)] * count)

    for row in written:
        name = name_of(row.af)
        if not row.af:
            pin_fits = pin_fits and not any(goes_right(cell) for cell in row.cells)  # a written-out padding row
            if box and box.next_slot < box.height:
                box.next_slot += 1
            else:
                loose = True
            rows.append(row)
            continue
        if row.af.startswith("."):
            assert _CALL.fullmatch(row.af), f"line {row.line}: malformed pin {row.af!r}"
            assert box is not None, f"line {row.line}: {row.af} is not directly below its instruction"
            assert pin_fits, f"line {row.line}: {row.af} is not directly below its instruction"
            slot = PIN_SLOTS.get(box.name, {}).get(name)
            assert slot is not None, f"line {row.line}: {box.name} has no {row.af}"
            assert slot >= box.next_slot, f"line {row.line}: {row.af} out of order in {box.name}"
            pad(slot - box.next_slot)
            box.pins.append(Pin(row.af, len(rows)))
            box.next_slot = slot + 1
            rows.append(row)
            continue
        known = row.af == NOP or (name in HEIGHTS and _CALL.fullmatch(row.af))
        assert known, f"line {row.line}: unknown output {row.af!r}"
        if box:
            pad(box.height - box.next_slot)
        own = OWN_SLOT.get(name, 0)
        if own and not loose:
            pad(own)
        box = _Box(row.af, len(rows), own + 1, [])
        boxes.append(box)
        rows.append(row)
        loose, pin_fits = False, True
    if box:
        pad(box.height - box.next_slot)
    for one in boxes:
        present = [name_of(pin.token) for pin in one.pins]
        missing = [pin for pin in REQUIRED_PINS.get(one.name, ()) if pin not in present]
        assert not missing, f"line {rows[one.row].line}: {one.name} without {', '.join(missing)}"
    outputs = tuple(Output(one.token, one.row, tuple(one.pins)) for one in boxes)
    return _hydrate(rows), outputs


def _hydrate(rows: Sequence[Row]) -> tuple[Row, ...]:
    """Carry downward wires on through the rows that the CSV leaves out; a last row carries none."""
    full: list[Row] = []
    for number, row in enumerate(rows):
        if not row.line and full and number + 1 < len(rows):
            row = Row(tuple("|" if goes_down(above) else "" for above in full[-1].cells))
        full.append(row)
    return tuple(full)


def _check_wires(where: str, rung: LadderRung) -> None:
    """Check that nothing floats, nothing leads nowhere, no wire end is loose, and every pin has a condition."""
    cells = [row.cells for row in rung.rows]

    def at(row: int, column: int) -> str:
        return cells[row][column] if 0 <= row < len(cells) and 0 <= column < CONDITION_COLUMNS else ""

    for row, line in enumerate(cells):
        for column, cell in enumerate(line):
            if not goes_down(cell):
                continue
            upper = goes_right(cell) or goes_right(at(row, column - 1)) or goes_down(at(row - 1, column))
            lower = (
                goes_right(at(row + 1, column)) or goes_right(at(row + 1, column - 1)) or goes_down(at(row + 1, column))
            )
            place = f"{where}: downward wire {cell!r} in {COLUMNS[column]} on row {row + 1}"
            assert upper, f"{place} has nothing at its upper end"
            assert lower, f"{place} has nothing at its lower end"

    fed = flow(cells, lambda _: 1, 1)
    useful = _useful(cells, set(rung.terminals().values()))
    for row, line in enumerate(cells):
        for column, cell in enumerate(line):
            if goes_right(cell):
                place = f"{where}: {cell!r} in {COLUMNS[column]} on row {row + 1}"
                assert fed[row][column], f"{place} floats: it is not connected to the power rail"
                assert useful[row][column + 1], f"{place} leads to no output"

    bare = flow(cells, lambda _: 0, 1)
    for (number, pin), row in rung.terminals().items():
        token = pin or rung.found[number].token
        assert token == NOP or fed[row][-1], f"{where}: {token} on row {row + 1} is not connected to anything"
        assert not pin or not bare[row][-1], f"{where}: {token} on row {row + 1} has no condition (C0205..C0214)"


def _useful(cells: Sequence[Sequence[str]], ends: set[int]) -> list[list[bool]]:
    """For every node, whether power could go on from it to one of the ends (rows of the AF column)."""
    useful = [[False] * (CONDITION_COLUMNS + 1) for _ in cells]
    for row in ends:
        useful[row][-1] = True
    for column in reversed(range(CONDITION_COLUMNS)):
        for row, line in enumerate(cells):
            useful[row][column] = goes_right(line[column]) and useful[row][column + 1]
        for group in _tied(cells, column):
            shared = any(useful[row][column] for row in group)
            for row in group:
                useful[row][column] = shared
    return useful


# ---------------------------------------------------------------------------------------------------- power


def _tied(cells: Sequence[Sequence[str]], column: int) -> Iterator[range]:
    """Runs of rows whose left edges in this column are one node."""
    start = 0
    for row, line in enumerate(cells):
        if row + 1 == len(cells) or not goes_down(line[column]):
            yield range(start, row + 1)
            start = row + 1


def flow(
    cells: Sequence[Sequence[str]], mask: Callable[[str], int], full: int, bidirectional: bool = False
) -> list[list[int]]:
    """Power at every node as a bit set over situations.

    ``mask(token)`` gives the situations in which a condition conducts, ``full`` is the set of all of them. Power goes
    from left to right and along vertical wires both ways; with ``bidirectional`` every cell conducts both ways.
    """
    masks = {"": 0, "|": 0, "-": full, "T": full}

    def conducts(cell: str) -> int:
        if cell not in masks:
            token = condition_of(cell)
            masks[cell] = full if token is None else mask(token)
        return masks[cell]

    through = [list(map(conducts, line)) for line in cells]
    # A row that is tied to no other settles by itself.
    groups = [[group for group in _tied(cells, column) if len(group) > 1] for column in range(CONDITION_COLUMNS)]
    groups.append([])
    level = [[full] + [0] * CONDITION_COLUMNS for _ in cells]

    def settle(boundary: int) -> None:
        for group in groups[boundary]:
            shared = 0
            for row in group:
                shared |= level[row][boundary]
            for row in group:
                level[row][boundary] = shared

    while True:
        before = [list(line) for line in level]
        for boundary, after in pairwise(range(CONDITION_COLUMNS + 1)):
            settle(boundary)
            for row, line in enumerate(level):
                line[after] |= line[boundary] & through[row][boundary]
        if not bidirectional:
            return level
        for after, boundary in pairwise(reversed(range(CONDITION_COLUMNS + 1))):
            for row, line in enumerate(level):
                line[boundary] |= line[after] & through[row][boundary]
            settle(boundary)
        if level == before:
            return level


def power_sets(
    rung: LadderRung, sets: Mapping[str, int], full: int, bidirectional: bool = False
) -> dict[Terminal, int]:
    """The situations in which each terminal has power; ``sets`` gives those in which each leaf is true."""

    def mask(token: str) -> int:
        leaf, negated = leaf_of(token)
        return full & ~sets[leaf] if negated else sets[leaf]

    level = flow([row.cells for row in rung.rows], mask, full, bidirectional)
    return {terminal: level[row][-1] for terminal, row in rung.terminals().items()}


def power(rung: LadderRung, values: Callable[[str], bool], bidirectional: bool = False) -> dict[Terminal, bool]:
    """Whether power arrives at each output and pin.

    ``values`` is called with leaf tokens only (``X001``, ``rise(C1)``, ``DS1==5``): ``~X001`` is not values("X001").
    """
    sets = {leaf: int(values(leaf)) for leaf in condition_tokens(rung)}
    return {terminal: bool(bit) for terminal, bit in power_sets(rung, sets, 1, bidirectional).items()}


def condition_tokens(rung: LadderRung) -> list[str]:
    """The rung's distinct leaf tokens, ``~`` and ``T:`` removed, in reading order."""
    found: dict[str, None] = {}
    for row in rung.rows:
        for cell in row.cells:
            token = condition_of(cell)
            if token is not None:
                found.setdefault(leaf_of(token)[0])
    return list(found)


# ---------------------------------------------------------------------------------------------------- truth tables


class Truth(NamedTuple):
    """One situation: which leaves are true, and where power arrives."""

    values: Mapping[str, bool]
    power: Mapping[Terminal, bool]


def situations(leaves: Sequence[str], max_vars: int = 12, seed: int = 0) -> tuple[dict[str, int], int]:
    """Leaf sets and the full set for all combinations of up to ``max_vars`` leaves, else for 2**max_vars samples.

    The samples hold all-false, all-true, one-true and one-false situations first; the rest are drawn with ``seed``.
    """
    if len(leaves) <= max_vars:
        codes: Sequence[int] = range(2 ** len(leaves))
    else:
        draw = random.Random(seed)
        every = 2 ** len(leaves) - 1
        corners = [0, every, *(1 << n for n in range(len(leaves))), *(every ^ (1 << n) for n in range(len(leaves)))]
        codes = corners + [draw.getrandbits(len(leaves)) for _ in range(2**max_vars - len(corners))]
    sets = dict.fromkeys(leaves, 0)
    for number, code in enumerate(codes):
        for bit, leaf in enumerate(leaves):
            if code >> bit & 1:
                sets[leaf] |= 1 << number
    return sets, (1 << len(codes)) - 1


def truth_table(rung: LadderRung, max_vars: int = 12, seed: int = 0, bidirectional: bool = False) -> list[Truth]:
    """Power in every combination of up to ``max_vars`` leaves, or in 2**max_vars seeded samples of more."""
    sets, full = situations(condition_tokens(rung), max_vars, seed)
    reached = power_sets(rung, sets, full, bidirectional)
    return [
        Truth(
            {leaf: bool(one >> number & 1) for leaf, one in sets.items()},
            {terminal: bool(one >> number & 1) for terminal, one in reached.items()},
        )
        for number in range(full.bit_length())
    ]


def check_no_backfeed(rung: LadderRung, max_vars: int = 12, seed: int = 0) -> None:
    """Check that a series-parallel drawing gives the same outputs when everything conducts both ways."""
    sets, full = situations(condition_tokens(rung), max_vars, seed)
    one_way, both_ways = power_sets(rung, sets, full), power_sets(rung, sets, full, bidirectional=True)
    for (number, pin), reached in one_way.items():
        extra = both_ways[Terminal(number, pin)] & ~reached
        if extra:
            case = extra.bit_length() - 1
            true = [leaf for leaf, one in sets.items() if one >> case & 1]
            token = pin or rung.found[number].token
            raise AssertionError(f"backfeed: {token} is fed from the right when only {', '.join(true)} are true")


# ---------------------------------------------------------------------------------------------------- whole files


def check_limits(rungs: Iterable[LadderRung]) -> None:
    """The two limits of one ladder file (click-facts [limit.file, limit.rows])."""
    heights = [len(rung.rows) for rung in rungs]
    assert len(heights) <= MAX_RUNGS, f"{len(heights)} rungs, at most {MAX_RUNGS} in one file"
    total = sum(heights) + len(heights)
    assert total <= MAX_GRID_ROWS, f"expanded rows plus rungs are {total}, at most {MAX_GRID_ROWS} in one file"
