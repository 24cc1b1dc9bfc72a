"""Reads CLICK's own files as drawn rungs, by laddercodec: captures of the clipboard, and program files (``Scr*.tmp``).

laddercodec takes codes that it does not know for others: a port for ``cpu2`` (click-facts [message.ports]), a unit
for milliseconds. So every rung is compared with its bytes, and one that was read differently is refused
(capture.py, program_file.py).
"""

from __future__ import annotations

import csv
import io
import re
import struct
import warnings
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, TypeVar

from clickgen.click.draw.grid import COLUMNS
from clickgen.click.ladder_csv import HEADER
from clickgen.click.read.grid import DrawnRung, Ladder, read_ladder
from clickgen.click.read.problem import LadderProblem
from clickgen.click.read.rtf import left_out
from clickgen.device.banks import Kind, parse_address
from clickgen.device.project_file import PROGRAM_MAGIC

if TYPE_CHECKING:
    from laddercodec import Rung
    from laddercodec.instructions import AfToken

    from clickgen.click.read.capture import Cut, CutRung

_T = TypeVar("_T")
_INDEX_AT = 0x40
_NAME_AT = 0x43
"""Where a program file has its prog_idx and its name, after the name's length (laddercodec, decode_program)."""
_ROWS_AT = 0x0254
_ROWS_UNIT = 32
_BLOCK = 4096
"""Where a capture has its number of rows, the count for each there, and the block that divides its size (encode)."""
_RUNG = re.compile(r"\(rung (\d+)\)")


@dataclass(frozen=True)
class ProgramHeader:
    """The header of a program file: CLICK's number of the routine, and its name."""

    index: int
    name: str


def program_header(data: bytes) -> ProgramHeader | None:
    """Return the header of a program file; None if it is not such a file, or is cut off inside the header.

    It needs no laddercodec, which returns nothing for a file that is damaged anywhere.
    """
    if not data.startswith(PROGRAM_MAGIC) or len(data) < _NAME_AT:
        return None
    [index] = struct.unpack_from("<H", data, _INDEX_AT)
    length = data[_NAME_AT - 1]
    name = data[_NAME_AT : _NAME_AT + length]
    if len(name) < length:
        return None
    # The NUL after the name has one byte.
    return ProgramHeader(index, name[: length // 2 * 2].decode("utf-16-le", "replace").rstrip("\0"))


def read_program(data: bytes, file: str) -> Ladder:
    """Return the rungs of a program file. Never raises."""
    from laddercodec import decode_program

    from clickgen.click.read.program_file import ProgramFault, differences, read_rungs

    try:
        rungs = _guarded(decode_program, data, file).rungs
    except LadderProblem as problem:
        return Ladder((), (problem,))
    try:
        said = read_rungs(data)
    except ProgramFault as fault:
        why = _unproven(str(fault))
        return _ladder(rungs, file, lambda _number, _rung: why, [b""] * len(rungs))
    ladder = _ladder(
        rungs, file, lambda number, rung: _first(differences(said[number], rung)), [rung.comment for rung in said]
    )
    if len(said) < len(rungs) or not all(rung.is_empty for rung in said[len(rungs) :]):
        return _with_problem(ladder, "there are more rungs in the file than are read", file)
    return ladder


def read_clipboard(data: bytes, file: str) -> Ladder:
    """Return the rungs of a capture of the clipboard. Never raises."""
    from laddercodec import decode

    from clickgen.click.read.capture import cut

    try:
        decoded = _guarded(decode, data, file)
        rungs = decoded if isinstance(decoded, list) else [decoded]
        is_whole = _guarded(lambda whole: _is_whole(whole, rungs), data, file)
    except LadderProblem as problem:
        return Ladder((), (_too_wide(cut(data), file) or problem,))
    said = cut(data)
    comments = [rung.comment for rung in said.rungs] + [b""] * len(rungs)

    def proof(number: int, rung: Rung) -> str:
        if number >= len(said.rungs):
            return _unproven(said.fault or "the capture has fewer rungs")
        return _difference(said.rungs[number], rung)

    ladder = _ladder(rungs, file, proof, comments)
    if not is_whole:
        return _with_problem(ladder, "the capture is cut off", file)
    if len(said.rungs) > len(rungs):
        return _with_problem(ladder, "there are more rungs in the capture than are read", file)
    return ladder


def _too_wide(said: Cut, file: str) -> LadderProblem | None:
    """Find a rung that laddercodec 0.2.2 encodes but cannot decode (findings/laddercodec-31-contacts.sh).

    It expects another filler after a box of two rows or more that has a contact in the last column before it.
    """
    for number, rung in enumerate(said.rungs if not said.fault else (), 1):
        if any(row[-2].blob is not None and row[-1].header.height > 1 for row in rung.rows):
            limit = "laddercodec 0.2.2 cannot decode 31 contacts before a box of two rows or more"
            return LadderProblem(f"rung {number} is not damaged, but {limit}", file, 0, number, "CG710")
    return None


def _with_problem(ladder: Ladder, message: str, file: str) -> Ladder:
    return Ladder(ladder.rungs, (*ladder.problems, LadderProblem(message, file)))


def _difference(said: CutRung, rung: Rung) -> str:
    """The difference between the bytes of a rung and those that laddercodec writes for what it read; "" if none."""
    from laddercodec import encode

    from clickgen.click.read.capture import cut, differences

    try:
        # Each alone: a file of them has limits, and laddercodec does not report all (click-facts [limit.rows]).
        written = cut(encode(replace(rung, comment=None, comment_rtf=None)))
    except Exception as error:
        return _unproven(_words(error))
    return _unproven(written.fault) if written.fault else _first(differences(said, written.rungs[0]))


def _first(differences: Iterator[str]) -> str:
    return next(differences, "")


def _unproven(why: str) -> str:
    return f"its bytes cannot be compared with what is read of them ({why})"


def _is_whole(data: bytes, rungs: list[Rung]) -> bool:
    """True for a complete capture: laddercodec takes a cut one for a shorter one, and trailing NULs for empty cells.

    So check its size, the number of rows in its header (those of the rungs and one more for each), and the
    column that its last cell gives as its own. All native captures pass.
    """
    from laddercodec.decode import inspect_cells

    [rows] = struct.unpack_from("<H", data, _ROWS_AT)
    if len(data) % _BLOCK or rows != _ROWS_UNIT * sum(rung.logical_rows + 1 for rung in rungs):
        return False
    [last] = inspect_cells(data, [(len(rungs) - 1, rungs[-1].logical_rows - 1, HEADER[-1])])
    return bool(last.raw[1] == COLUMNS)


def _guarded(call: Callable[[bytes], _T], data: bytes, file: str) -> _T:
    """Return laddercodec's reading of a file. Raises LadderProblem for any exception: damage shows in many ways."""
    try:
        return call(data)
    except Exception as error:
        match = _RUNG.search(str(error))
        rung = int(match[1]) + 1 if match else 0
        message = f"the file is damaged, or of a form that is not known ({_words(error)})"
        raise LadderProblem(message, file, 0, rung) from error


def _ladder(rungs: list[Rung], file: str, proof: Callable[[int, Rung], str], comments: Sequence[bytes]) -> Ladder:
    """Return the rungs as drawn; ``proof`` gives, by the number from 0, what differs between the bytes and the rung."""
    drawn = []
    for number, rung in enumerate(rungs):
        rung.instructions = [_named(token) for token in rung.instructions]
        one = _drawn(rung, number + 1, file)
        if not one.problems:
            what = _guarded_proof(proof, number, rung)
            problems = (LadderProblem(what, file, 0, number + 1, "CG708"),) if what else ()
            # The reading is not what the rung is, so nothing of it is shown.
            one = replace(one, rows=(), boxes=(), problems=problems) if problems else one
        marks = left_out(comments[number])
        note = f"its comment has marks that are left out: {' '.join(marks)}"
        drawn.append(replace(one, notes=(note,)) if marks else one)
    return Ladder(tuple(drawn), ())


def _guarded_proof(proof: Callable[[int, Rung], str], number: int, rung: Rung) -> str:
    try:
        return proof(number, rung)
    except Exception as error:  # damage shows in many ways, here as in laddercodec
        return _unproven(_words(error))


def _named(token: AfToken) -> AfToken:
    """Rename a pack or unpack according to its banks.

    The bytes do not distinguish bits from words; laddercodec goes by the letter C, and takes X001 to X016 for words
    (click-facts [copy.pack-names]).
    """
    from laddercodec.instructions import Pack, Unpack

    if isinstance(token, Pack) and token.pack_type != "text":
        return replace(token, pack_type=_kind_of_pack(token.source_start, token.pack_type))
    if isinstance(token, Unpack):
        return replace(token, unpack_type=_kind_of_pack(token.dest_start, token.unpack_type))
    return token


def _kind_of_pack(address: str, otherwise: str) -> str:
    found = parse_address(address)
    return otherwise if found is None else "bits" if found.kind is Kind.BIT else "words"


def _drawn(rung: Rung, number: int, file: str) -> DrawnRung:
    """Return a decoded rung, through the rows that laddercodec would write for it. The comment is unchanged."""
    from laddercodec.csv.writer import decoded_rung_to_rows

    comment = rung.comment or ""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of empty rows at the end, which it leaves out
            rows = decoded_rung_to_rows(replace(rung, comment=None))
    except Exception as error:
        problem = LadderProblem(
            f"the rung is damaged, or holds something that is not known ({_words(error)})", file, 0, number
        )
        return DrawnRung(number, file, 0, comment, (), (), (problem,))
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows([HEADER, *rows])
    [drawn] = read_ladder(text.getvalue(), file).rungs
    problems = [LadderProblem(problem.message, file, 0, number) for problem in drawn.problems]
    if rung.comment is None and rung.comment_rtf:
        problems.append(LadderProblem("the comment cannot be read", file, 0, number))
    rows = tuple(replace(row, line=0) for row in drawn.rows)
    written = drawn.written._replace(rows=rows) if drawn.written is not None else None
    return DrawnRung(number, file, 0, comment, rows, drawn.boxes, tuple(problems), written=written)


def _words(error: Exception) -> str:
    return f"{type(error).__name__}: {error}" if str(error) else type(error).__name__
