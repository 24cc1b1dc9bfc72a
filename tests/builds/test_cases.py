"""Every case builds its golden files, again and again, and the outside readers take them."""

from __future__ import annotations

import csv
import io
from functools import cache
from pathlib import Path

import golden
import pytest
from judges.codec import assert_codec_reads
from judges.power import check_limits, check_no_backfeed, read_ladder
from pyclickplc import read_csv

import clickgen

each_case = pytest.mark.parametrize("name", golden.names())


@cache
def built_of(name: str) -> dict[str, bytes]:
    """The outputs of a case, built once for all tests."""
    return golden.outputs(golden.CASES / name)


def test_there_are_cases() -> None:
    assert "demo" in golden.names()


@each_case
def test_a_case_builds_its_golden_files(name: str) -> None:
    case = golden.CASES / name
    built, expected = built_of(name), golden.expected(case)
    assert expected, f"{name} has no golden files: run make golden and read them"
    assert sorted(built) == sorted(expected)
    for path, data in expected.items():
        assert built[path] == data, f"{name}: {path} differs"


@each_case
def test_a_case_folder_holds_nothing_else(name: str) -> None:
    there = {path.name for path in (golden.CASES / name).iterdir()}
    siblings = {file for file in there if file.endswith(".py")} - {golden.PROGRAM}
    assert there - {golden.TABLE} - siblings == {golden.PROGRAM, golden.EXPECTED}


@each_case
def test_a_case_says_what_it_shows(name: str) -> None:
    first = (golden.CASES / name / golden.PROGRAM).read_text("utf-8").splitlines()[0]
    assert first.startswith('"""')
    assert first.endswith('."""')


@each_case
def test_a_second_build_changes_nothing(name: str, tmp_path: Path) -> None:
    program = golden.lay_out(golden.CASES / name, tmp_path)
    first = clickgen.build(program)
    first.write(tmp_path / "out")
    for frozen in (False, True):
        again = clickgen.build(program, frozen=frozen)
        assert again.ok, again.diagnostics
        assert again.files == first.files
        assert again.table == first.table
        assert again.new_rows == ()
        assert again.write(tmp_path / "out") == []


@each_case
def test_outside_readers_take_the_ladder(name: str) -> None:
    built = built_of(name)
    for path, data in built.items():
        if not path.endswith(".csv") or path.endswith(golden.TABLE):
            continue
        text = data.decode()
        rungs = read_ladder(text)
        check_limits(rungs)
        for rung in rungs:
            check_no_backfeed(rung)
        assert_codec_reads(text)


@each_case
def test_pyclickplc_reads_the_nicknames(name: str, tmp_path: Path) -> None:
    built = built_of(name)
    for written in (golden.TABLE, f"table/{golden.TABLE}"):
        path = tmp_path / golden.TABLE
        path.write_bytes(built[written])
        theirs = {record.display_address: record.nickname for record in read_csv(path).values()}
        assert theirs == _nicknames(built[written])
    imported = _nicknames(built[golden.TABLE])
    table = _nicknames(built[f"table/{golden.TABLE}"])
    assert imported == {address: nickname for address, nickname in table.items() if address[:2] not in ("SC", "SD")}


def _nicknames(data: bytes) -> dict[str, str]:
    """Address to nickname."""
    rows = csv.reader(io.StringIO(data.decode("utf-8-sig"), newline=""))
    return {address: nickname for address, _, nickname, *_ in list(rows)[1:]}
