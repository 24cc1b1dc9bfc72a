"""No workbook brings the reader down, however large, broken or hostile."""

from __future__ import annotations

import contextlib
import datetime
import io
import os
import random
import re
import tracemalloc
import warnings
import zipfile
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

import budget
import openpyxl
import pytest
from budget import examples
from hypothesis import given
from hypothesis import strategies as st
from io_lists import START, TITLE, at, in_words, judged, listed, rows_of, said, unreadable, workbook
from judges.work import calls_in

from clickgen.device.banks import BANKS, Address
from clickgen.problems.diagnostics import Diagnostics
from clickgen.table.read import TableUnreadable
from clickgen.table.rows import Row, default_row
from clickgen.table.workbook import archive as limits
from clickgen.table.workbook.read import read_workbook

T = TypeVar("T")


def little(work: Callable[[], T], calls: int = 4_000_000) -> T:
    """The result of the work, which may take this many calls of functions: endless files are cut off."""
    found: list[T] = []
    count = calls_in(lambda: found.append(work()))
    assert count < calls
    return found[0]


# -- size --------------------------------------------------------------------------------------------------------------


def large(count: int) -> bytes:
    rows = [
        (str(Address(bank.name, number)), f"{bank.name} name {number}", None, None, f"what {number} is for")
        for bank in BANKS.values()
        if not bank.settings_fixed
        for number in bank.numbers()
    ]
    return listed(*rows[:count])


def test_a_large_list_reads_in_linear_time() -> None:
    assert len(rows_of(large(5_000))) == 5_000
    small, great = (calls_in(partial(rows_of, large(count))) for count in (200, 800))
    assert great < 4.5 * small


# -- hostile and broken files ------------------------------------------------------------------------------------------


SHEET, STRINGS = "xl/worksheets/sheet1.xml", "xl/sharedStrings.xml"


MAIN = 'xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"'


def repacked(data: bytes, parts: dict[str, str | bytes | None], **how: Any) -> bytes:
    """A workbook with these parts instead of its own, or without those that are None."""
    file = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(data)) as old, zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as new:
        for name in dict.fromkeys((*old.namelist(), *parts)):
            part = parts.get(name, old.read(name) if name in old.namelist() else None)
            if part is not None:
                new.writestr(name, part, **how)
    return file.getvalue()


def with_sheet(content: str) -> bytes:
    """A workbook whose sheet has the usual titles and then these rows, as XML."""
    titles = "".join(f'<c t="inlineStr"><is><t>{title}</t></is></c>' for title in TITLE)
    xml = f'<worksheet {MAIN}><sheetData><row r="1">{titles}</row>{content}</sheetData></worksheet>'
    return repacked(listed(), {SHEET: xml})


def test_openpyxl_reads_xml_with_defusedxml() -> None:
    assert openpyxl.DEFUSEDXML


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (b"", "it is empty"),
        (b"Address,Data Type,Nickname\n", "is no workbook"),
        (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + b"\0" * 600, "protected by a password, or an old .xls"),
        (b"PK", "is no sound workbook"),
        (b"PK\x03\x04" + b"\0" * 200, "is no sound workbook"),
        (listed(("X001", "S"))[:3000], "is no sound workbook"),
        (b"\0" * (32 * 2**20 + 1), "has more than 32 MB"),
    ],
)
def test_other_files(data: bytes, why: str) -> None:
    assert why in unreadable(data)


@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("mimetype", "OpenDocument spreadsheet (.ods)"),
        ("xl/workbook.bin", "binary workbook (.xlsb)"),
        ("readme.txt", "zip archive and no workbook"),
        ("[Content_Types].xml", "is no sound workbook"),
    ],
)
def test_other_archives(name: str, why: str) -> None:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr(name, "<Types xmlns='http://schemas.openxmlformats.org/package/2006/content-types'/>")
    assert why in unreadable(file.getvalue())


@pytest.mark.parametrize("name", ["[Content_Types].xml", "xl/workbook.xml", "xl/_rels/workbook.xml.rels", SHEET])
@pytest.mark.parametrize("part", [None, "", "<", "<a/>", b"\xff\xfe<\0", "<a>&b;</a>", "\x01"], ids=repr)
def test_a_part_that_is_missing_or_wrong(name: str, part: str | bytes | None) -> None:
    unreadable(repacked(listed(("X001", "S")), {name: part}))


@pytest.mark.parametrize("kind", ["<!DOCTYPE a [{}]>", "<!-- {} -->", "<?a {}?>"])
@pytest.mark.parametrize("name", [STRINGS, SHEET, "xl/workbook.xml", "xl/styles.xml", "[Content_Types].xml"])
def test_entities_never_expand(name: str, kind: str) -> None:
    entities = '<!ENTITY a0 "haha">' + "".join(
        f'<!ENTITY a{n + 1} "{f"&a{n};" * 10}">' for n in range(10)
    )  # fmt: skip
    xml = '<?xml version="1.0"?>' + kind.format(entities) + f"<sst {MAIN}><si><t>&a9;</t></si></sst>"
    assert f"{name}, what no spreadsheet program writes" in unreadable(repacked(listed(), {name: xml}))


def test_a_zip_bomb() -> None:
    bomb = repacked(listed(("X001", "S")), {SHEET: b" " * (150 * 2**20)})
    assert len(bomb) < 2**20
    tracemalloc.start()
    try:
        assert "unpacks to more than 64 MB" in unreadable(bomb)
        assert tracemalloc.get_traced_memory()[1] < 150 * 2**20
    finally:
        tracemalloc.stop()


@pytest.mark.parametrize(
    "name", ["xl/media/image1.xml", "xl/calcChain.xml", "xl/comments12.xml", "xl/worksheets/_rels/sheet1.xml.rels"]
)
def test_what_holds_no_cells_is_never_unpacked(name: str) -> None:
    assert len(rows_of(repacked(listed(("X001", "S")), {name: b"<" * (65 * 2**20)}))) == 1


def test_an_archive_that_lies_about_the_size_of_a_part() -> None:
    data = bytearray(repacked(listed(("X001", "S")), {"xl/worksheets/more.xml": b"<" * (65 * 2**20)}))
    at = data.rindex(b"PK\x01\x02", 0, data.rindex(b"xl/worksheets/more.xml"))
    data[at + 24 : at + 28] = (100).to_bytes(4, "little")
    unreadable(bytes(data))


@pytest.mark.parametrize(
    "content",
    [
        '<row r="2">' + '<c s="0"/>' * 200_000 + "</row>",
        '<row r="2">' + '<c s="0"/>' * 16_384 + "</row>" + '<row><c s="0"/></row>' * 60_000,
        "<a/>" * 200_000,
        "<a>" * 200_000 + "</a>" * 200_000,
        '</sheetData><mergeCells>' + '<mergeCell ref="A1:XFD1048576"/>' * 200_000 + "</mergeCells><sheetData>",
    ],
    ids=["a wide row", "many rows", "other elements", "nested", "merged"],
)  # fmt: skip
def test_far_too_many_cells(content: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(limits, "ELEMENTS_MAX", 120_000)
    assert "far too many cells" in unreadable(with_sheet(content))


@pytest.mark.parametrize("width", [1, 25])
@pytest.mark.parametrize("empty", ["/>", "></c>"])
def test_a_million_cells_that_are_only_formatted_cost_little(
    width: int, empty: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A tenth of a million, and a tenth of the limit."""
    monkeypatch.setattr(limits, "ELEMENTS_MAX", limits.ELEMENTS_MAX // 10)
    rows = "".join(
        f'<row r="{number}" ht="15" s="1">'
        + "".join(f'<c r="{chr(65 + column)}{number}" s="1"{empty}' for column in range(width))
        + "</row>"
        for number in range(3, 100_000 // width + 3)
    )
    titles = "".join(
        f'<c r="{chr(65 + n)}1" t="inlineStr"><is><t>{title}</t></is></c>' for n, title in enumerate(TITLE)
    )
    xml = f'<worksheet {MAIN}><sheetData><row r="1">{titles}</row>{START}{rows}</sheetData></worksheet>'
    assert [row.nickname for row in little(lambda: rows_of(repacked(listed(), {SHEET: xml})), 400_000)] == ["S"]


def test_blank_cells_that_do_not_say_where_they_stand_keep_their_place() -> None:
    assert [
        in_words(row)
        for row in rows_of(with_sheet(START.replace("</row>", "<c s='1'/><c/><c t='str'><v>c</v></c></row>")))
    ] == ["X001 S|0|No|c IO!A2"]


def test_a_pipe_and_a_device(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "io.xlsx")
    (tmp_path / "zero.xlsx").symlink_to("/dev/zero")
    for name in ("io.xlsx", "zero.xlsx"):
        with pytest.raises(TableUnreadable, match=f"{name} is a pipe or a device; name a file"):
            read_workbook(tmp_path / name, name, Diagnostics())


def test_one_endless_tag() -> None:
    assert "endless tags" in unreadable(with_sheet('<row a="' + "x>" * 10_000_000 + '"/>'))


def test_huge_dimensions_and_far_cells() -> None:
    far = '<row r="1048576"><c r="XFD1048576"><v>1</v></c></row>'
    xml = with_sheet(START + '<row r="3">' + '<c s="0"/>' * 16_384 + "</row>" + far)
    assert [row.nickname for row in little(lambda: rows_of(xml))] == ["S"]
    with zipfile.ZipFile(io.BytesIO(xml)) as archive:
        sheet = archive.read(SHEET).decode()
    sheet = sheet.replace("<sheetData>", '<dimension ref="A1:XFD1048576"/><sheetData>')
    assert [row.nickname for row in rows_of(repacked(xml, {SHEET: sheet}))] == ["S"]
    # A size that is too small hides nothing either.
    for size in ("A1", "C5:D9"):
        assert len(rows_of(repacked(xml, {SHEET: sheet.replace("A1:XFD1048576", size)}))) == 1
    endless = with_sheet(START + '<row r="99999999999"><c><v>1</v></c></row>')
    assert len(rows_of(endless)) == 1


def test_a_hundred_sheets_that_share_one_large_part(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(limits, "ELEMENTS_MAX", limits.ELEMENTS_MAX // 10)
    data = workbook(**{f"S{number}": [("nothing",)] for number in range(90)})
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        rels = archive.read("xl/_rels/workbook.xml.rels").decode()
    rels = re.sub(r"/xl/worksheets/sheet\d+\.xml", "/" + SHEET, rels)
    large = with_sheet(START + '<row><c s="0"/></row>' * 10_000)
    with zipfile.ZipFile(io.BytesIO(large)) as archive:
        data = repacked(data, {SHEET: archive.read(SHEET), "xl/_rels/workbook.xml.rels": rels})
    assert "far too many cells" in unreadable(data)


def test_a_huge_sheet_without_a_list_does_no_harm(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(limits, "ELEMENTS_MAX", limits.ELEMENTS_MAX // 10)
    log = "".join(f'<row r="{number}"><c><v>{number}</v></c></row>' for number in range(1, 40_000))
    data = workbook(Log=[("Time",)], IO=[TITLE, ("X001", "S")])
    data = repacked(data, {SHEET: f'<worksheet {MAIN}><dimension ref="A1"/><sheetData>{log}</sheetData></worksheet>'})
    assert len(little(lambda: rows_of(data), 400_000)) == 1


def test_too_many_sheets() -> None:
    assert "has 101 sheets" in unreadable(workbook(**{f"S{number}": [("a",)] for number in range(101)}))


def test_an_archive_in_another_packing_and_one_with_a_part_twice() -> None:
    assert "packed in a way of their own" in unreadable(repacked(listed(), {}, compress_type=zipfile.ZIP_LZMA))
    file = io.BytesIO(listed(("X001", "S")))
    with warnings.catch_warnings(), zipfile.ZipFile(file, "a") as archive:
        warnings.simplefilter("ignore")
        archive.writestr(SHEET, "<worksheet/>")
    assert "no spreadsheet program writes" in unreadable(file.getvalue())


def test_rows_out_of_order_are_not_left_out_silently() -> None:
    assert "rows are out of order" in unreadable(with_sheet('<row r="3"><c><v>1</v></c></row>' + START))


def test_a_strict_workbook() -> None:
    sheet = '<worksheet xmlns="http://purl.oclc.org/ooxml/spreadsheetml/main"/>'
    assert "is a Strict Open XML workbook" in unreadable(repacked(listed(), {SHEET: sheet}))


def test_shared_texts_formatted_in_parts() -> None:
    kind = "application/vnd.openxmlformats-officedocument.spreadsheetml.sharedStrings+xml"
    data = with_sheet('<row r="2"><c t="s"><v>1</v></c><c t="s"><v>0</v></c><c t="str"><v>1</v></c></row>')
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        types = archive.read("[Content_Types].xml").decode()
    types = types.replace("</Types>", f'<Override PartName="/{STRINGS}" ContentType="{kind}"/></Types>')
    rich = "<si><r><rPr><b/></rPr><t>St</t></r><r><t>art</t></r></si>"
    texts = f"<sst {MAIN}>{rich}<si><t>X001</t></si></sst>"
    assert [in_words(row) for row in rows_of(repacked(data, {STRINGS: texts, "[Content_Types].xml": types}))] == [
        "X001 Start|1|No| IO!A2"
    ]


@pytest.mark.parametrize(
    "cell",
    [
        '<c r="B2" t="s"><v>99</v></c>',
        '<c r="B2" t="s"><v>x</v></c>',
        '<c r="B2"><v>1e</v></c>',
        '<c r="B2" t="b"><v>maybe</v></c>',
        '<c r="B2" t="d"><v>never</v></c>',
        '<c r="??"><v>1</v></c>',
        '<c r="B2" s="x"><v>1</v></c>',
        f'<c r="B2"><v>{"1" * 5000}</v></c>',
    ],
)
def test_cells_of_wrong_types(cell: str) -> None:
    assert "is no sound workbook" in unreadable(with_sheet(f'<row r="2">{cell}</row>'))


def test_odd_cells_that_can_be_read() -> None:
    infinite = '<row r="3"><c t="inlineStr"><is><t>C1</t></is></c><c><v>1e999</v></c></row>'
    nameless = '<row r="4"><c/><c t="zz"><v>5</v></c></row>'
    assert said(with_sheet(START + infinite + nameless)) == [
        "CG604 IO!B4 5 has no address and is left out",
        "CG601 IO!B3 the nickname in IO!B3 is no number",
    ]


def survives(data: bytes) -> None:
    def read() -> None:
        with contextlib.suppress(TableUnreadable):
            read_workbook(Path("nowhere.xlsx"), "io.xlsx", Diagnostics(), data)

    little(read)


def broken_by(chance: random.Random, data: bytes) -> bytes:
    changed = bytearray(data)
    start = chance.randrange(len(data))
    how = chance.randrange(4)
    if how == 0:
        return data[:start]
    if how == 1:
        del changed[start : start + chance.randrange(1, 50)]
    else:
        for _ in range(how):
            changed[chance.randrange(len(data))] ^= 1 << chance.randrange(8)
    return bytes(changed)


@pytest.mark.property
@pytest.mark.parametrize("packed", [True, False])
def test_no_broken_file_brings_it_down(packed: bool) -> None:
    """Unpacked, the damage is in the XML itself, since its checksums are computed again."""
    chance = random.Random(4711)
    whole = listed(("X001", "Start", 0, "No", "c"), ("DS1", "Speed", 5, True, datetime.date(2024, 1, 1)), ("=A1", "B"))
    with zipfile.ZipFile(io.BytesIO(whole)) as archive:
        parts = {name: archive.read(name) for name in archive.namelist()}
    for _ in budget.rounds(40):
        if packed:
            survives(broken_by(chance, whole))
        else:
            name = chance.choice(list(parts))
            survives(repacked(whole, {name: broken_by(chance, parts[name])}))


@given(st.binary(max_size=300))
def test_no_content_is_too_strange(content: bytes) -> None:
    for data in (content, b"PK\x03\x04" + content):
        with pytest.raises(TableUnreadable):
            judged(data)


WORDS = (
    "X001",
    "x 2",
    "DS1",
    "C1",
    "DH1",
    "TXT1",
    "XD1",
    "Start",
    "Stop",
    "yes",
    "0",
    "1",
    "00FFh",
    "-",
    " ",
    "=A1",
    "\u00e4",
)


CELLS = st.none() | st.booleans() | st.integers() | st.floats() | st.sampled_from([*WORDS, *TITLE])


@given(st.lists(st.lists(CELLS, max_size=6), max_size=8))
@examples(20)
def test_no_list_is_too_strange(lines: list[list[Any]]) -> None:
    rows, problems = judged(listed(*lines))
    assert len({row.address for row in rows}) == len(rows)
    names = [row.nickname.lower() for row in rows if row.nickname and row.address.bank not in ("SC", "SD")]
    assert len(set(names)) == len(names) or any(problem.code == "CG602" for problem in problems)
    assert all(row.cell and row.cell.sheet == "IO" for row in rows)


def test_what_is_read_again_is_the_same() -> None:
    """A sheet with all columns, and another that repeats part of it, give the same rows."""
    rows = [
        Row(at("X001"), "Start", "0", False, "a, b"),
        Row(at("DF1"), "Speed", "-3.4028235E+38", True, "two\nlines"),
        Row(at("DH1"), "Mask", "00FF", False, ""),
        Row(at("C2"), "", "1", True, ""),
        Row(at("TXT1"), "", " ", True, " "),
        default_row(at("DS9"), "Nine"),
    ]
    word = {True: "Yes", False: "No"}
    data = workbook(
        Tags=[
            ("Address", "Data type", "Nickname", "Initial value", "Retentive", "Comment"),
            *(
                (str(r.address), r.address.kind.value, r.nickname, r.initial, word[r.retentive], r.comment)
                for r in rows
            ),
        ],
        Slot=[("Address", "Nickname"), *((str(row.address), row.nickname) for row in rows)],
    )
    assert [row.content for row in rows_of(data)] == [row.content for row in rows]
