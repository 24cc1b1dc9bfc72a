"""The cross-reference of the listing: everything that writes or reads an address is at its line."""

from __future__ import annotations

from pathlib import Path

import pytest

import clickgen

HEAD = """\
nickname(c.Stages, c[101:109])
nickname(ds.Recipe, ds[100:110])
nickname(txt.Msg, txt[1:9])
nickname(y.Lamp, y[3])
"""
END = "    if True:\n        end()\n"


def cross_reference(folder: Path, rungs: str, table: str = "") -> dict[str, str]:
    """The lines of the cross-reference by address: the text after the nickname."""
    program = folder / "prog.py"
    program.write_text(f"{HEAD}\n\ndef main():\n{rungs}\n{END}", "utf-8")
    if table:
        header = "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment\n"
        (folder / "nicknames.csv").write_text(header + table, "utf-8")
    result = clickgen.build(program)
    assert result.ok, result.diagnostics
    lines = result.files["listing.txt"].partition("Address ")[2].splitlines()[1:]
    return {line.split()[0]: line[line.index("  ") :].strip() for line in lines}


RUNGS = {
    "shift": ("shift(c.Stages, clock=lambda: x[2], reset=lambda: x[3])", "c[102]", "C102"),
    "shift backwards": ("shift(c[108:101:-1], clock=lambda: x[2], reset=lambda: x[3])", "c[102]", "C102"),
    "out": ("out(c.Stages)", "c[102]", "C102"),
    "set": ("set(c.Stages)", "c[102]", "C102"),
    "reset": ("reset(c.Stages)", "c[102]", "C102"),
    "copy_block": ("copy_block(ds[1:11], ds.Recipe[0])", "ds[103] == 1", "DS103"),
    "copy_fill": ("copy_fill(0, ds.Recipe)", "ds[103] == 1", "DS103"),
    "copy_unpack": ("copy_unpack(dh[1], c.Stages)", "c[102]", "C102"),
    "copy_unpack words": ("copy_unpack(dd[1], ds.Recipe[2:4])", "ds[103] == 1", "DS103"),
    "copy of a text": ('copy("READY", txt.Msg[0])', 'txt[2] == "E"', "TXT2"),
    "copy of a word": ("copy(dh[1], yd[0])", "y[2]", "Y002"),
    "copy of a word, named": ("copy(dh[1], yd[0])", "y.Lamp", "Y003"),
    "receive": (
        'receive(target=ModbusTcpTarget(name="tcp", ip="192.168.1.10", port=502, device_id=1), remote_start="DS1", '
        "dest=ds.Recipe, receiving=c[1], success=c[2], error=c[3], exception_response=ds[1])",
        "ds[103] == 1",
        "DS103",
    ),
    "event_drum": (
        "event_drum(outputs=[c.Stages[0], c.Stages[1]], events=[c[11], c[12]], pattern=[[1, 0], [0, 1]], "
        "current_step=ds.Recipe[3], completion_flag=c[9], reset=lambda: x[2])",
        "ds[103] == 1",
        "DS103",
    ),
    "a drum's block": (
        "event_drum(outputs=c.Stages[0:2], events=[c[11], c[12]], pattern=[[1, 0], [0, 1]], "
        "current_step=ds[1], completion_flag=c[9], reset=lambda: x[2])",
        "c[102]",
        "C102",
    ),
    "search": (
        'search("==", value=5, start=ds[1], end=ds[9], result=ds.Recipe[3], flag=c[9])',
        "ds[103] == 1",
        "DS103",
    ),
}


@pytest.mark.parametrize("kind", RUNGS)
def test_a_member_that_is_written_through_a_block_or_a_range_is_written(tmp_path: Path, kind: str) -> None:
    action, condition, address = RUNGS[kind]
    found = cross_reference(
        tmp_path, f"    if re(x[1]):\n        {action}\n\n    if {condition}:\n        out(y[16])\n"
    )
    assert found[address].endswith("main 1 | main 2")


READS = {
    "range contact": ("out(y[1])", "c.Stages", "c[102]", "C102"),
    "sum": ('calc("SUM(ds.Recipe)", ds[1])', "x[1]", "ds[103] == 1", "DS103"),
    "copy_block": ("copy_block(ds.Recipe, ds[1])", "x[1]", "ds[103] == 1", "DS103"),
    "copy_pack": ("copy_pack(c.Stages, dh[1])", "x[1]", "c[102]", "C102"),
    "copy_pack text": ("copy_pack(txt.Msg[0:4], ds[1])", "x[1]", 'txt[2] == "E"', "TXT2"),
    "search": (
        'search("==", value=5, start=ds[100], end=ds[109], result=ds[1], flag=c[9])',
        "x[1]",
        "ds[103] == 1",
        "DS103",
    ),
    "word": ("copy(xd[0], dh[1])", "x[1]", "x[7]", "X007"),
}


@pytest.mark.parametrize("kind", READS)
def test_a_member_that_is_read_through_a_block_or_a_range_is_read(tmp_path: Path, kind: str) -> None:
    action, first, second, address = READS[kind]
    found = cross_reference(tmp_path, f"    if {first}:\n        {action}\n\n    if {second}:\n        out(y[16])\n")
    assert found[address].endswith("- | main 1, 2")


def test_a_cell_that_nothing_names_has_no_line_of_its_own(tmp_path: Path) -> None:
    found = cross_reference(tmp_path, "    if x[1]:\n        copy_fill(0, ds.Recipe)\n", 'DS105,INT,"Sixth",0,Yes,""\n')
    assert "DS103" not in found
    assert found["DS105"].endswith("main 1 | -")
    assert found["DS100..DS109"].endswith("main 1 | -")


def test_the_upper_byte_is_not_the_word_of_the_same_number(tmp_path: Path) -> None:
    rungs = '    if x[1]:\n        copy(xd["0u"], dh[1])\n        copy(xd[1], dh[11])\n'
    found = cross_reference(tmp_path, rungs)
    assert found["XD0u"].endswith("- | main 1")
    assert "XD0" not in found
