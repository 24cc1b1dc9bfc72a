"""The program as an Excel workbook: for the cabinet, the commissioning and the shelf."""

from __future__ import annotations

import re

from clickgen.emit.built import BuiltProgram
from clickgen.emit.writer import Writer


def _workbook(built: BuiltProgram, _: str) -> bytes:
    # A build makes no workbook and must not load the code that writes one.
    from clickgen.emit.workbook.sheets import workbook

    return workbook(built)


def _is_own(data: bytes) -> bool:
    from clickgen.emit.workbook.archive import is_ours

    return is_ours(data)


WRITER = Writer(
    paths=lambda built: (f"{built.name}.xlsx",),
    write=_workbook,
    owns=re.compile(r"[^/]+\.xlsx"),
    is_own=_is_own,
    on_request=True,
)
