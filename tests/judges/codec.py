"""laddercodec as outside reader: it must read, encode, decode and write back just what our CSV says."""

from __future__ import annotations

import csv
import io
import re
import tempfile
import warnings
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import laddercodec
from laddercodec import Rung as CodecRung
from laddercodec.csv.writer import decoded_rung_to_rows

from .power import (
    HEADER,
    NOP,
    LadderRung,
    Output,
    Pin,
    Row,
    Terminal,
    check_limits,
    power,
    read_ladder,
)


@dataclass(frozen=True)
class Difference:
    """A spelling that changes on the way through laddercodec without changing what CLICK does."""

    pattern: str
    common: str
    reason: str


# Applied to the tokens of both sides before they are compared.
TOKEN_DIFFERENCES: tuple[Difference, ...] = (
    Difference(r"(X\d{3})\.immediate", r"immediate(\1)", "it writes the suffix form and reads both"),
    Difference(r"^for\((.*),oneshot=0\)$", r"for(\1)", "it writes out the default"),
    Difference(
        r"termination_code=\$0(?=[0-9A-F]\b)", "termination_code=$", "it drops the leading zero of a code below $10"
    ),
    Difference(
        r"^pack_words\((?=(?:[XYT]|SC)\d)", "pack_bits(", "bits or words is not stored: it guesses bits from a C only"
    ),
    Difference(
        r"^unpack_to_words\((\w+),(?=[XY]\d)", r"unpack_to_bits(\1,", "the same guess from the destination's letter"
    ),
    Difference(r"\.\.([XY])0+(?=\d)", r"..\1", "it computes the end of a sent or received range without its zeros"),
    Difference(
        r'Modbus(Tcp|Rtu)Target\(name="(?:[^"]|"")*"', r'Modbus\1Target(name=""', "the target's name is not stored"
    ),
)

# Applied to the comments of both sides; a character outside ASCII then matches up to four others.
COMMENT_DIFFERENCES: tuple[Difference, ...] = (
    Difference(r"[*_]", "", "emphasis becomes RTF styling, and _x_ comes back as *x*"),
)


@lru_cache(maxsize=4096)
def normalise(token: str) -> str:
    """A cell or AF token in the spelling common to both sides."""
    for difference in TOKEN_DIFFERENCES:
        token = re.sub(difference.pattern, difference.common, token)
    return token


def comments_agree(ours: Sequence[str], theirs: Sequence[str]) -> bool:
    """True if two comments differ only in styling and down-converted characters; a lone empty line is no comment."""

    def plain(lines: Sequence[str]) -> str:
        text = "\n".join(lines)
        for difference in COMMENT_DIFFERENCES:
            text = re.sub(difference.pattern, difference.common, text)
        return text

    pattern = "".join(re.escape(char) if char.isascii() else ".{0,4}" for char in plain(ours))
    return re.fullmatch(pattern, plain(theirs), re.DOTALL) is not None


# ---------------------------------------------------------------------------------------------------- their grid


def ladder_of_codec_rung(rung: CodecRung) -> LadderRung:
    """Return laddercodec's hydrated, expanded grid as a rung of ours; the tokens are in the common spelling."""
    rows = tuple(
        Row(tuple(normalise(_text(cell)) for cell in cells), normalise(_text(af)))
        for cells, af in zip(rung.conditions, rung.instructions, strict=True)
    )
    assert rung.logical_rows == len(rows), f"laddercodec says {rung.logical_rows} rows and has {len(rows)}"
    outputs: list[Output] = []
    bridge = -1  # the NOP that marks the own input of a down counter is part of the counter
    for number, (row, af) in enumerate(zip(rows, rung.instructions, strict=True)):
        if not row.af or number == bridge:
            continue
        own = number
        if row.af.startswith("count_down("):
            own = bridge = number + 1
            assert rows[own].af == NOP, "laddercodec has a down counter without its NOP row"
        pins = tuple(Pin(token, number + slot) for slot, token in _pins(af))
        outputs.append(Output(row.af, own, pins))
    comment = () if rung.comment is None else tuple(rung.comment.split("\n"))
    return LadderRung(comment, (), rows, tuple(outputs))


def _text(token: object) -> str:
    """A laddercodec cell in CSV spelling: wires are strings, instructions know their own."""
    if isinstance(token, str):
        return token
    write = getattr(token, "to_csv", None)
    assert write is not None, f"laddercodec does not know the cell {token!r}"
    return str(write())


def _pins(af: object) -> list[tuple[int, str]]:
    """Box row and token of the pins that laddercodec keeps as fields of the instruction."""
    pins: list[tuple[int, str]] = []
    kind = type(af).__name__
    if getattr(af, "retained", False):
        pins.append((1, ".reset()"))
    if kind == "Shift":
        pins += [(1, ".clock()"), (2, ".reset()")]
    if getattr(af, "down_enabled", False):
        pins.append((1, ".down()"))
    if getattr(af, "reset_enabled", False):
        pins.append((2, ".reset()"))
    if kind == "Drum":
        pins.append((1, ".reset()"))
    if getattr(af, "jump_enabled", False):
        pins.append((2, f".jump({getattr(af, 'jump_target', '')})"))
    if getattr(af, "jog_enabled", False):
        pins.append((3, ".jog()"))
    return pins


def power_of_codec_rung(
    rung: CodecRung, values: Callable[[str], bool], bidirectional: bool = False
) -> dict[Terminal, bool]:
    """Power on laddercodec's own grid, by the same rules and with the same keys as `power`."""
    return power(ladder_of_codec_rung(rung), values, bidirectional)


# ---------------------------------------------------------------------------------------------------- the judge


def assert_codec_reads(text: str) -> list[CodecRung]:
    """laddercodec reads, encodes and decodes the file without loss and would write it the same way.

    Returns the rungs decoded from the clipboard buffer of the whole file. AssertionError names the first difference.
    """
    ours = read_ladder(text)
    check_limits(ours)
    if not ours:
        return []
    with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("error")
        path = Path(folder) / "main.csv"
        path.write_bytes(text.encode("utf-8"))
        try:
            read = laddercodec.read_csv(path)
            singles = [laddercodec.decode(laddercodec.encode(rung)) for rung in read]
            decoded = laddercodec.decode(laddercodec.encode(read))
            multi = decoded if isinstance(decoded, list) else [decoded]
            written = [(number, decoded_rung_to_rows(rung)) for number, rung in _different(multi, singles)]
            laddercodec.write_csv(path, multi, index=any(row[0] == "R1" for row in _records(text)))
        except Exception as error:  # whatever laddercodec raises, the file is at fault
            raise AssertionError(f"laddercodec: {type(error).__name__}: {error}") from error
        rewritten = path.read_bytes().decode("utf-8")

    for stage, rungs in {"read": read, "single": singles, "whole file": multi}.items():
        assert len(rungs) == len(ours), f"laddercodec ({stage}): {len(rungs)} rungs, ours {len(ours)}"
    for number, theirs in _different(read, singles, multi):
        one = ours[number]
        _compare(f"rung at line {one.written[0].line}", one, ladder_of_codec_rung(theirs))
    for number, rows in written:
        _compare_rows(ours[number], rows)
    _compare_files(text, rewritten)
    return list(multi)


def _different(*stages: Sequence[CodecRung]) -> Iterator[tuple[int, CodecRung]]:
    """Yield each rung with its number: after the first stage, and again after those that change it."""
    seen: dict[int, list[CodecRung]] = {}
    for rungs in stages:
        for number, rung in enumerate(rungs):
            known = seen.setdefault(number, [])
            if rung not in known:
                known.append(rung)
                yield number, rung


def _compare(where: str, ours: LadderRung, theirs: LadderRung) -> None:
    """Check for the same grid, outputs, pins and comment, from which the same power follows."""
    assert comments_agree(ours.comment, theirs.comment), f"{where}: comment {theirs.comment!r}, ours {ours.comment!r}"
    assert len(theirs.rows) == len(ours.rows), f"{where}: {len(theirs.rows)} expanded rows, ours {len(ours.rows)}"
    for number, (our_row, their_row) in enumerate(zip(ours.rows, theirs.rows, strict=True), 1):
        for column, mine, other in zip(HEADER[1:], our_row.cells, their_row.cells, strict=False):
            assert normalise(mine) == other, f"{where}: {column} on row {number} is {other!r}, ours {mine!r}"
    mine_out = [(normalise(one.token), one.row, one.pins) for one in ours.outputs()]
    their_out = [(one.token, one.row, one.pins) for one in theirs.outputs()]
    assert mine_out == their_out, f"{where}: outputs {their_out}, ours {mine_out}"


def _compare_rows(ours: LadderRung, theirs: Sequence[Sequence[str]]) -> None:
    """Check that our rows are in the canonical form: they leave out and write just what laddercodec does."""
    where = f"rung at line {ours.written[0].line} (written back)"
    comment = tuple(row[1] for row in theirs if row[0] == "#")
    assert comments_agree(ours.comment, comment), f"{where}: comment {comment!r}, ours {ours.comment!r}"
    rows = [row for row in theirs if row[0] != "#"]
    assert [row[0] for row in rows] == ["R"] + [""] * (len(rows) - 1), f"{where}: unexpected markers"
    for number, (mine, other) in enumerate(zip(ours.written, rows, strict=False), 1):
        for column, our_cell, their_cell in zip(HEADER[1:], (*mine.cells, mine.af), other[1:], strict=True):
            assert normalise(our_cell) == normalise(their_cell), (
                f"{where}: {column} on row {number} is {their_cell!r}, ours {our_cell!r}"
            )
    assert len(rows) == len(ours.written), f"{where}: {len(rows)} rows, ours {len(ours.written)}"


def _compare_files(ours: str, theirs: str) -> None:
    """Compare with the file as laddercodec writes it: the same rows, markers and quoting, except line ends."""
    mine, other = (
        [[normalise(cell) for cell in row] for row in _records(text) if row[0] != "#"] for text in (ours, theirs)
    )
    assert mine == other, "laddercodec writes other rows or markers for the whole file"
    assert all(len(row) == 2 for row in _records(ours) if row[0] == "#"), "a comment row has two columns, no more"
    again = io.StringIO(newline="")
    csv.writer(again, lineterminator="\n").writerows(_records(ours))
    assert again.getvalue() == ours.replace("\r\n", "\n"), "quotes belong only where a comma or a quote needs them"


def _records(text: str) -> list[list[str]]:
    return list(csv.reader(io.StringIO(text, newline="")))
