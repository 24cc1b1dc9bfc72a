"""The file of a workbook, made harmless before openpyxl sees it.

A workbook is a zip archive of XML parts. A small file can unpack to gigabytes, and XML can cost far more than its
length. So every part that matters is unpacked once, in bounded memory, judged as bytes, and repacked without
compression: openpyxl reads the copy, which holds nothing that was not measured. Cells that have only a format, and rows
without cells, are left out of the copy: a sheet may have hundreds of thousands of them.

The following are refused: files over 32 MB; parts of more than 64 MB together; more than 500,000 XML elements in what
is read, or 100,000 in one row of a sheet or in a part without rows; rows out of order, since openpyxl leaves some of
them out; and anything that no spreadsheet program writes: entities and document types, comments and instructions in the
XML, single tags of 250,000 bytes, encodings other than UTF-8, two parts of one name.
Pictures, charts, macros, pivot tables, links to other files and other parts without cells are never unpacked.
"""

from __future__ import annotations

import io
import re
import zipfile
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

from clickgen.table.read import TableUnreadable
from clickgen.workspace import NoRegularFile, Workspace

FILE_MAX = 32 * 2**20
PARTS_MAX = 64 * 2**20
ELEMENTS_MAX = 500_000
RUN_MAX = 100_000
"""Elements from the beginning of one row, or one shared text, to the next."""

_SAVE_AGAIN = "open it in a spreadsheet program and save it as .xlsx"
_SMALLER = "copy the lists alone into a new workbook"
_WITHOUT_CELLS = frozenset((
    "charts", "chartsheets", "comments", "ctrlProps", "customXml", "dialogsheets", "docProps", "drawings", "embeddings",
    "externalLinks", "macrosheets", "media", "pivotCache", "pivotTables", "printerSettings", "queryTables", "richData",
    "slicerCaches", "slicers", "tables", "theme", "threadedComments", "timelines",
))  # fmt: skip
"""Folders of an archive that hold no cells."""
_FILES_WITHOUT_CELLS = re.compile(r"(calcChain|comments\d*|connections|metadata)\.xml")
_RUN = re.compile(rb"<(?:\w+:)?(?:row|si)\b")
_ROW_NUMBER = re.compile(rb"<(?:\w+:)?row\b[^>]*?\sr=[\"'](\d+)")
_UNNUMBERED = re.compile(rb"<(?:\w+:)?(?:row|c)(?=[\s/>])(?![^<>]*\sr=)")
_BLANK_CELL = re.compile(rb"""<((?:\w+:)?)c(?:\s+[rst]=(?:"\w*"|'\w*'))+\s*(?:/>|>\s*</\1c\s*>)""")
_BLANK_ROW = re.compile(rb"""<((?:\w+:)?)row(?:\s+[\w:]+=(?:"[^"<>]*"|'[^'<>]*'))+\s*(?:/>|>\s*</\1row\s*>)""")
_CELLS = re.compile(rb"<((?:\w+:)?)sheetData[\s/>]")
_STRICT = b"http://purl.oclc.org/ooxml/spreadsheetml/main"
_UNHEARD_OF = re.compile(rb"\0|<!(?!\[CDATA\[)|<\?(?!xml\s[^<>]{0,200}\?>)|<[^<]{250000}")


def bytes_of_workbook(path: Path, shown: str, workspace: Workspace | None = None) -> bytes:
    """Return the file's bytes; if it is too large, only the first. Raises TableUnreadable if it cannot be read."""
    try:
        return (workspace or Workspace()).start(path, FILE_MAX + 1)
    except FileNotFoundError:
        raise TableUnreadable(f"there is no workbook at {shown}") from None
    except NoRegularFile:
        raise TableUnreadable(f"{shown} is a pipe or a device; name a file") from None
    except OSError as error:
        reason = "it is a folder" if path.is_dir() else error.strerror or error
        raise TableUnreadable(f"{shown} cannot be read: {reason}") from None


def harmless_copy(data: bytes, shown: str) -> io.BytesIO:
    """Return the parts of a workbook that hold cells, uncompressed; raise TableUnreadable for anything else."""
    _refuse_other_files(data, shown)
    copy = io.BytesIO()
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive, zipfile.ZipFile(copy, "w") as safe:
            _refuse_other_archives(archive, shown)
            for name, part in _parts(archive, shown):
                safe.writestr(zipfile.ZipInfo(name), part)
    except Exception as error:
        # zipfile and zlib raise whatever a broken archive happens to lead them to.
        raise broken(shown, error) from None
    return _Metered(copy.getvalue(), shown)


def broken(shown: str, error: Exception) -> TableUnreadable:
    """The error for a file that a library stumbles over, unless that has been reported already."""
    if isinstance(error, TableUnreadable):
        return error
    error = error.__cause__ if isinstance(error.__cause__, Exception) else error
    reason = " ".join(str(error).split()) or type(error).__name__
    reason = reason if len(reason) <= 120 else reason[:120] + "..."
    if not reason.isprintable():
        reason = ascii(reason)
    return TableUnreadable(f"{shown} is no sound workbook ({reason}); {_SAVE_AGAIN}")


class _Metered(io.BytesIO):
    """The copy: reading from it costs bytes and elements, and both can run out.

    A sheet that is not read to its end costs little, however large it is; a part that serves many sheets costs
    as much as all of them.
    """

    def __init__(self, data: bytes, shown: str) -> None:
        super().__init__(data)
        self._shown = shown
        self._bytes_left = 3 * len(data) + 2**20
        self._elements_left = ELEMENTS_MAX

    def read(self, size: int | None = -1) -> bytes:
        data = super().read(size)
        self._bytes_left -= len(data)
        self._elements_left -= _elements(data)
        if self._bytes_left < 0 or self._elements_left < 0:
            raise _too_many_cells(self._shown)
        return data


def _too_many_cells(shown: str) -> TableUnreadable:
    return TableUnreadable(f"{shown} holds far too many cells or styles, perhaps empty ones; {_SMALLER}")


def _refuse_other_files(data: bytes, shown: str) -> None:
    if len(data) > FILE_MAX:
        raise TableUnreadable(f"{shown} has more than {FILE_MAX >> 20} MB; {_SMALLER}, without pictures")
    if data.startswith(b"\xd0\xcf\x11\xe0"):
        raise TableUnreadable(f"{shown} is protected by a password, or an old .xls; {_SAVE_AGAIN} without a password")
    if not data.startswith(b"PK"):
        reason = "it is empty" if not data else "it does not begin as one"
        raise TableUnreadable(f"{shown} is no workbook: {reason}; {_SAVE_AGAIN}")


def _refuse_other_archives(archive: zipfile.ZipFile, shown: str) -> None:
    names = archive.namelist()
    if "mimetype" in names:
        raise TableUnreadable(f"{shown} is an OpenDocument spreadsheet (.ods); {_SAVE_AGAIN}")
    if "xl/workbook.bin" in names:
        raise TableUnreadable(f"{shown} is a binary workbook (.xlsb); {_SAVE_AGAIN}")
    if "[Content_Types].xml" not in names:
        raise TableUnreadable(f"{shown} is a zip archive and no workbook; {_SAVE_AGAIN}")


def _parts(archive: zipfile.ZipFile, shown: str) -> Iterator[tuple[str, bytes]]:
    """Yield the name and content of every part that openpyxl needs."""
    seen: set[str] = set()
    left = PARTS_MAX
    for info in archive.infolist():
        name = info.filename
        if not _has_cells(name):
            continue
        part = _unpacked(archive, info, left + 1)
        left -= len(part)
        if left < 0:
            raise TableUnreadable(f"{shown} unpacks to more than {PARTS_MAX >> 20} MB; {_SMALLER}")
        part = _without_blanks(part)
        if max(map(_elements, _RUN.split(part))) > RUN_MAX:
            raise _too_many_cells(shown)
        if name in seen or _UNHEARD_OF.search(part):
            raise TableUnreadable(
                f"{shown} holds, in its part {ascii(name)[1:-1]}, what no spreadsheet program writes "
                f"(entities, comments, endless tags, or not UTF-8); {_SAVE_AGAIN}"
            )
        if _STRICT in part:
            raise TableUnreadable(f"{shown} is a Strict Open XML workbook; {_SAVE_AGAIN} of the usual kind")
        if not _in_order(part):
            raise TableUnreadable(f"{shown} is no sound workbook (its rows are out of order); {_SAVE_AGAIN}")
        seen.add(name)
        yield name, _with_dimension(part)


def _without_blanks(part: bytes) -> bytes:
    """A sheet without its empty cells and rows, if each of the others gives its own place."""
    if not _CELLS.search(part) or b"<![CDATA[" in part or _UNNUMBERED.search(part):
        return part
    return _BLANK_ROW.sub(b"", _BLANK_CELL.sub(b"", part))


def _with_dimension(part: bytes) -> bytes:
    """A sheet that states its size, true or not: without one, openpyxl reads the whole sheet to find it out."""
    cells = _CELLS.search(part)
    if cells is None or b"<![CDATA[" in part or b"dimension" in part[: cells.start()]:
        return part
    return part[: cells.start()] + b'<%sdimension ref="A1"/>' % cells[1] + part[cells.start() :]


def _has_cells(name: str) -> bool:
    *folders, file = name.split("/")
    return (
        file.endswith((".xml", ".rels"))
        and _WITHOUT_CELLS.isdisjoint(folders)
        and not _FILES_WITHOUT_CELLS.fullmatch(file)
        and folders[-2:] != ["worksheets", "_rels"]
    )


def _unpacked(archive: zipfile.ZipFile, info: zipfile.ZipInfo, limit: int) -> bytes:
    """Return the first bytes of a part, up to the limit, whatever size the archive gives."""
    if info.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        raise ValueError("its parts are packed in a way of their own")
    with archive.open(info) as part:
        return part.read(limit)


def _in_order(part: bytes) -> bool:
    return all(one < other for one, other in pairwise(map(int, _ROW_NUMBER.findall(part))))


def _elements(part: bytes) -> int:
    """The number of XML elements that begin here, or a few more."""
    return part.count(b"<") - part.count(b"</")
