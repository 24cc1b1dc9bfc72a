"""The workbook as a file: the same bytes for the same contents, and a mark that names the writer."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from io import BytesIO
from zipfile import ZIP_DEFLATED, BadZipFile, ZipFile, ZipInfo

_PROPERTIES, _APPLICATION = "docProps/core.xml", "docProps/app.xml"
_OURS = b"<Application>clickgen</Application>"
"""Excel and every other program writes its own name here when it saves."""
_XML = b'<?xml version="1.0" encoding="UTF-8" standalone="yes"?>\n'
_FIXED = {
    _PROPERTIES: _XML
    + b"<cp:coreProperties"
    + b' xmlns:cp="http://schemas.openxmlformats.org/package/2006/metadata/core-properties"'
    + b' xmlns:dc="http://purl.org/dc/elements/1.1/"><dc:creator>clickgen</dc:creator></cp:coreProperties>',
    _APPLICATION: _XML
    + b'<Properties xmlns="http://schemas.openxmlformats.org/officeDocument/2006/extended-properties">'
    + _OURS
    + b"</Properties>",
}
"""Author and time: no real time, so that the same project gives the same bytes."""
_APPLICATION_MAX = 100_000
_SHEET = re.compile(r"xl/worksheets/sheet([0-9]+)\.xml")
_EMPTY = b"<sheetData></sheetData>"
"""How openpyxl writes a sheet without rows."""


class PinnedZip(ZipFile):
    """A zip file in which nothing depends on the time or the machine; ``rows`` are those of each sheet, as XML."""

    def __init__(self, file: BytesIO, rows: Sequence[str]) -> None:
        super().__init__(file, "w", ZIP_DEFLATED)
        self._rows = rows

    def writestr(self, name: str | ZipInfo, data: object, *_: object) -> None:
        entry = ZipInfo(name if isinstance(name, str) else name.filename)
        entry.compress_type = ZIP_DEFLATED
        entry.create_system = 3
        # openpyxl writes text or bytes; its own stubs do not say which.
        super().writestr(entry, _FIXED.get(entry.filename, data))  # type: ignore[arg-type]

    def write(self, path: str | os.PathLike[str], name: str | os.PathLike[str] | None = None, *_: object) -> None:
        with open(path, "rb") as file:
            data = file.read()
        sheet = _SHEET.fullmatch(str(name))
        if sheet:
            before, empty, after = data.partition(_EMPTY)
            assert empty, name
            rows = self._rows[int(sheet[1]) - 1].encode()
            data = b"".join((before, b"<sheetData>", rows, b"</sheetData>", after))
        self.writestr(str(name), data)


def is_ours(data: bytes) -> bool:
    """True for a workbook that clickgen wrote and nobody has saved since."""
    try:
        with ZipFile(BytesIO(data)) as archive:
            entry = archive.getinfo(_APPLICATION)
            return entry.file_size <= _APPLICATION_MAX and _OURS in archive.read(entry)
    # Everything that zipfile raises for a file that is not an archive, or a damaged or encrypted one.
    except (BadZipFile, KeyError, OSError, ValueError, RuntimeError, NotImplementedError, EOFError):
        return False
