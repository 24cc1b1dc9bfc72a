"""CLICK's own files to drawn rungs, by laddercodec: captures of the clipboard, and program files (``Scr*.tmp``)."""

from __future__ import annotations

import csv
import io
import re
import struct
import warnings
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, TypeVar

from clickgen.emit.ladder_csv import HEADER
from clickgen.ladder.grid import DrawnRung, Ladder, read_ladder
from clickgen.ladder.kinds import PROGRAM_MAGIC
from clickgen.ladder.problem import LadderProblem
from clickgen.lower.grid import COLUMNS

if TYPE_CHECKING:
    from laddercodec import Rung

_T = TypeVar("_T")
_INDEX_AT = 0x40
_NAME_AT = 0x43
"""Where a program file has its prog_idx and its name, the bytes of the name before it (laddercodec, decode_program)."""
_ROWS_AT = 0x0254
_ROWS_UNIT = 32
_BLOCK = 4096
"""Where a capture has its number of rows, what each counts there, and what its size is a multiple of (encode)."""
_RUNG = re.compile(r"\(rung (\d+)\)")


@dataclass(frozen=True)
class ProgramHeader:
    """What a program file says of itself: CLICK's number of the routine, and its name."""

    index: int
    name: str


def program_header(data: bytes) -> ProgramHeader | None:
    """The header of a program file; None when it is no such file, or cut off inside of it.

    Readable without laddercodec, which gives nothing of a file that is damaged anywhere.
    """
    if not data.startswith(PROGRAM_MAGIC) or len(data) < _NAME_AT:
        return None
    [index] = struct.unpack_from("<H", data, _INDEX_AT)
    length = data[_NAME_AT - 1]
    name = data[_NAME_AT : _NAME_AT + length]
    if len(name) < length:
        return None
    # The NUL behind the name has one byte.
    return ProgramHeader(index, name[: length // 2 * 2].decode("utf-16-le", "replace").rstrip("\0"))


def read_program(data: bytes, file: str) -> Ladder:
    """The rungs of a program file. Never raises."""
    from laddercodec import decode_program

    try:
        return _ladder(_guarded(decode_program, data, file).rungs, file)
    except LadderProblem as problem:
        return Ladder((), (problem,))


def read_clipboard(data: bytes, file: str) -> Ladder:
    """The rungs of a capture of the clipboard. Never raises."""
    from laddercodec import decode

    try:
        decoded = _guarded(decode, data, file)
        rungs = decoded if isinstance(decoded, list) else [decoded]
        is_whole = _guarded(lambda whole: _is_whole(whole, rungs), data, file)
    except LadderProblem as problem:
        return Ladder((), (problem,))
    ladder = _ladder(rungs, file)
    return ladder if is_whole else Ladder(ladder.rungs, (LadderProblem("the capture is cut off", file),))


def _is_whole(data: bytes, rungs: list[Rung]) -> bool:
    """laddercodec takes a capture that is cut off for a shorter one, and one that goes on with NULs for empty cells.

    So look at its size, at the number of rows in its header (those of the rungs and one more for each), and at the
    column that its last cell says it stands in. All native captures pass.
    """
    from laddercodec.decode import inspect_cells

    [rows] = struct.unpack_from("<H", data, _ROWS_AT)
    if len(data) % _BLOCK or rows != _ROWS_UNIT * sum(rung.logical_rows + 1 for rung in rungs):
        return False
    [last] = inspect_cells(data, [(len(rungs) - 1, rungs[-1].logical_rows - 1, HEADER[-1])])
    return bool(last.raw[1] == COLUMNS)


def _guarded(call: Callable[[bytes], _T], data: bytes, file: str) -> _T:
    """What laddercodec makes of a file. Raises LadderProblem for whatever it raises: damage shows in many ways."""
    try:
        return call(data)
    except Exception as error:
        match = _RUNG.search(str(error))
        rung = int(match[1]) + 1 if match else 0
        message = f"the file is damaged, or of a form that is not known ({_words(error)})"
        raise LadderProblem(message, file, 0, rung) from error


def _ladder(rungs: list[Rung], file: str) -> Ladder:
    return Ladder(tuple(_drawn(rung, number, file) for number, rung in enumerate(rungs, 1)), ())


def _drawn(rung: Rung, number: int, file: str) -> DrawnRung:
    """A decoded rung, by way of the rows that laddercodec would write of it. The comment is kept as it is."""
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
    return DrawnRung(
        number,
        file,
        0,
        comment,
        tuple(replace(row, line=0) for row in drawn.rows),
        drawn.boxes,
        tuple(problems),
    )


def _words(error: Exception) -> str:
    return f"{type(error).__name__}: {error}" if str(error) else type(error).__name__
