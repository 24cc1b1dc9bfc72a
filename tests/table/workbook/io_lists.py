"""Workbooks to read, and the results of reading them."""

from __future__ import annotations

import io
import warnings
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import openpyxl
import pytest
from openpyxl.worksheet.worksheet import Worksheet

from clickgen.device.banks import Address, parse_address
from clickgen.problems.diagnostics import Diagnostic, Diagnostics
from clickgen.table.read import TableUnreadable
from clickgen.table.rows import Row
from clickgen.table.workbook.read import read_workbook

Lines = Iterable[Iterable[Any]]


TITLE = ("Address", "Nickname", "Initial Value", "Retentive", "Comment")


def at(text: str) -> Address:
    address = parse_address(text)
    assert address is not None
    return address


def workbook(**sheets: Lines | Callable[[Worksheet], None]) -> bytes:
    """A workbook with these sheets: rows from the top, or a function that fills the sheet."""
    book = openpyxl.Workbook()
    assert book.active is not None
    book.remove(book.active)
    for title, content in sheets.items():
        sheet = book.create_sheet(title)
        if callable(content):
            content(sheet)
        else:
            for row in content:
                sheet.append(list(row))
    return saved(book)


def saved(book: openpyxl.Workbook) -> bytes:
    file = io.BytesIO()
    book.save(file)
    return file.getvalue()


def judged(data: bytes) -> tuple[tuple[Row, ...], tuple[Diagnostic, ...]]:
    problems = Diagnostics()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        rows = read_workbook(Path("nowhere.xlsx"), "io.xlsx", problems, data)
    for problem in problems.found:
        assert problem.help
        assert problem.span is not None
        assert problem.span.path == "io.xlsx"
        assert problem.span.sheet
    return rows, tuple(problems.found)


def rows_of(data: bytes) -> tuple[Row, ...]:
    rows, problems = judged(data)
    assert problems == ()
    return rows


def said(data: bytes) -> list[str]:
    """``CG601 IO!B7 message (labels)`` of everything wrong."""
    _, problems = judged(data)
    return [
        f"{problem.code} {problem.span.cell if problem.span else ''} {problem.message}"
        + "".join(f" ({label.span.cell})" for label in problem.labels)
        for problem in problems
    ]


def in_words(row: Row) -> str:
    cell = row.cell.cell if row.cell else ""
    return f"{row.address} {row.nickname}|{row.initial}|{'Yes' if row.retentive else 'No'}|{row.comment} {cell}"


def listed(*rows: Iterable[Any]) -> bytes:
    """A workbook with one list of the usual titles; the first of the rows is row 2."""
    return workbook(IO=[TITLE, *rows])


def unreadable(data: bytes) -> str:
    """The reason why these bytes cannot be read."""
    with pytest.raises(TableUnreadable) as caught:
        judged(data)
    message = str(caught.value)
    assert message.startswith("io.xlsx ")
    assert message.isprintable()
    assert len(message) < 500
    return message


START = '<row r="2"><c r="A2" t="inlineStr"><is><t>X001</t></is></c><c r="B2" t="inlineStr"><is><t>S</t></is></c></row>'
"""A row that gives X001 the name S."""
