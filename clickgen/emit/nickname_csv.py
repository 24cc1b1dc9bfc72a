"""The nickname CSV for CLICK's File > Import, pure text from the rows of the address table."""

from __future__ import annotations

from collections.abc import Iterable

from clickgen.table.rows import HEADER, Row, format_row


def nickname_csv(rows: Iterable[Row]) -> str:
    """CLICK's import file: every row that says something, in CLICK's row order, ``\\n`` line ends
    (click-facts [nickname-file.line-ends, nickname-file.order]).

    Without SC and SD: what CLICK does with such rows on import is unknown (click-facts [nickname-file.system-rows]).
    """
    ours = [row for row in rows if row.address.bank not in ("SC", "SD") and not row.is_default]
    ours.sort(key=lambda row: row.address.sort_key)
    return "".join(f"{line}\n" for line in (HEADER, *map(format_row, ours)))
