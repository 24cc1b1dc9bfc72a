"""nicknames.csv for CLICK's File > Import, made from the rows of the address table."""

from __future__ import annotations

from clickgen.emit.built import BuiltProgram
from clickgen.emit.writer import first_line, one_file
from clickgen.table.rows import HEADER, format_row


def nickname_csv(built: BuiltProgram) -> str:
    """CLICK's import file: every row that says something, in CLICK's row order, with ``\\n`` at line ends
    (click-facts [nickname-file.line-ends, nickname-file.order]).

    Rows of SC and SD are left out: what CLICK does with them on import is unknown
    (click-facts [nickname-file.system-rows]).
    """
    ours = [row for row in built.rows if row.address.bank not in ("SC", "SD") and not row.is_default]
    ours.sort(key=lambda row: row.address.sort_key)
    return "".join(f"{line}\n" for line in (HEADER, *map(format_row, ours)))


WRITER = one_file("nicknames.csv", nickname_csv, lambda data: first_line(data) == HEADER, rank=20)
