"""A rename reaches every place of a name, changes nothing else, and happens completely or not at all."""

from __future__ import annotations

from pathlib import Path

import openpyxl
import pytest
from renaming import EVERYWHERE, OLD_ROW, Job, _here, again, done, main, place, refused, table, text

from clickgen.api import build
from clickgen.cli import main as run
from clickgen.commands.nicknames.rename import rename
from clickgen.config import Config, Settings
from clickgen.table.rows import HEADER
from clickgen.text.write import ChangedMeanwhile, put_in_place
from clickgen.workspace import CouldNotRun

__all__ = ["_here"]


# -- the places of a name ---------------------------------------------------------------------------------------------


def test_every_place_of_a_name() -> None:
    source = EVERYWHERE.replace("§", "Old")
    place({"prog.py": source, "nicknames.csv": table('DS1,INT,"Old",0,Yes,"Old words"')})
    before = build("prog.py")
    assert before.ok, before.diagnostics
    change = done("old", "NewName")
    assert text() == EVERYWHERE.replace("§", "NewName")
    assert text("nicknames.csv") == table('DS1,INT,"NewName",0,Yes,"Old words"')
    assert change.counts == {Path("prog.py"): EVERYWHERE.count("§"), Path("nicknames.csv"): 1}
    assert change.comments == {Path("prog.py"): 3}
    assert change.programs == ("prog.py",)
    assert build("prog.py").files["main.csv"] == before.files["main.csv"]
    done("NewName", "Old")
    assert (text(), text("nicknames.csv")) == (source, table('DS1,INT,"Old",0,Yes,"Old words"'))


def test_strings_in_pieces() -> None:
    lines = ('calc("ds.O" \'ld + 1 + \' "ds.\\x4fld", ds["O" "ld"])', 'calc("""ds.Ol\\\nd + 1""", ds.OLD)')
    place({"prog.py": main("if c.Bit:", *(f"    {line}" for line in lines)), "nicknames.csv": table()})
    done("Old", "New")
    lines = ('calc("ds.New" \' + 1 + \' "ds.New", ds["New" ""])', 'calc("""ds.New\\\n + 1""", ds.New)')
    assert text() == main("if c.Bit:", *(f"    {line}" for line in lines))


@pytest.mark.parametrize(
    ("bank", "rung"),
    [
        ("T", "if t.Old:\n        ton(t.Old, setpoint=5)\n        copy(td.Old, ds[1])"),
        ("CT", "if all(ct.old, ctd.OLD > 5):\n        ctu(ct.Old, setpoint=5).reset(ct.Old)"),
        ("X", "if all(x.Old.immediate, nc(x[\"Old\"].immediate)):\n        out(y[1])"),
        ("Y", "if re(y.Old):\n        out(y.Old.immediate)"),
        ("DH", "if dh.Old == 0xFF:\n        math_hex(\"dh.Old AND 0FFh\", dh.Old)"),
        ("TXT", "if txt.Old == \"A\":\n        copy(txt.Old.as_value(), ds[1])"),
        ("C", "if c.Old:\n        shift(c[1:9]).clock(c.Old).reset(c[\"Old\"])"),
    ],
)  # fmt: skip
def test_every_bank(bank: str, rung: str) -> None:
    first = {"T": "BIT", "CT": "BIT", "X": "BIT", "Y": "BIT", "C": "BIT", "DH": "HEX", "TXT": "TEXT"}[bank]
    number = {"X": "X007", "Y": "Y007"}.get(bank, f"{bank}77")
    place({"prog.py": main(rung), "nicknames.csv": table(f"{number},{first},Old,{'' if bank == 'TXT' else 0},No,")})
    assert build("prog.py").ok, build("prog.py").diagnostics
    done("Old", "Fresh")
    assert "old" not in text().lower()
    assert text("nicknames.csv").splitlines()[1].split(",")[2] == "Fresh"


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
@pytest.mark.parametrize("mark", ["", "\ufeff"])
def test_every_other_byte_stays(end: str, mark: str) -> None:
    source = 'def main():\n\tif c.Old: # ä\n\t\tout(c["Old"]);  calc("ds.Größe+ 1", ds.Gr)  \n\n\tif True:\n\t\tend()'
    source = (mark + source.replace("Größe", "Gr")).replace("\n", end)
    rows = f"{mark}{HEADER}\r\nC9,BIT,Z,0,No,\r\n\r\nC5,BIT,Old,0,No,x\r\nC1,BIT,A,0,No,"
    place({"prog.py": source, "nicknames.csv": rows})
    done("Old", "Name")
    assert text() == source.replace("Old", "Name")
    assert text("nicknames.csv") == rows.replace("Old", "Name")


def test_names_with_spaces() -> None:
    place({"prog.py": main('if c["Old one"]:\n        calc("ds[\'Old two\'] + 1", ds[1])'), "nicknames.csv": table()})
    assert refused("Old one", "c.d").startswith("CLICK does not take the nickname 'c.d': it holds .")
    done("Old one", "New one")
    done("old two", "class")
    assert 'c["New one"]' in text()
    assert "ds['class'] + 1" in text()


def test_a_plain_word_stays_one() -> None:
    place({"prog.py": main('if c.Old:\n        calc("ds.Other + 1", ds[1])'), "nicknames.csv": table(OLD_ROW)})
    said = 'cannot stand behind a dot, as Old does at prog.py:2:8: choose a plain word, or write c["Old"] there first'
    for new in ("Two words", "class", "2nd"):
        assert refused("Old", new) == f"{new!r} {said}"
    done("Other", "class")
    assert '"ds.class + 1"' in text()


# -- where the name comes from -----------------------------------------------------------------------------------------


def test_a_declared_name() -> None:
    place({"prog.py": 'nickname(c.Old, c[7], comment="Old")\n' + main("if c.Old:\n        out(y[1])")})
    assert done("Old", "New").writes.keys() == {Path("prog.py")}
    assert text().startswith('nickname(c.New, c[7], comment="Old")\n')
    place({"nicknames.csv": table('C7,BIT,"New",0,No,"Old"')})
    assert done("New", "Newer").counts == {Path("prog.py"): 2, Path("nicknames.csv"): 1}


def test_a_name_without_an_address_yet() -> None:
    place({"prog.py": main("if c.Old:\n        out(c.Second)")})
    assert done("Old", "Zz").unchanged == {
        Path("prog.py"): main("if c.Old:\n        out(c.Second)").encode(), Path("nicknames.csv"): None
    }  # fmt: skip
    assert not Path("nicknames.csv").exists()


def test_a_name_that_only_the_table_knows() -> None:
    place({"prog.py": main(), "nicknames.csv": table(OLD_ROW)})
    assert done("Old", "New").writes.keys() == {Path("nicknames.csv")}


def test_capital_letters_alone() -> None:
    place({"prog.py": main("if c.old:\n        out(c.OLD)"), "nicknames.csv": table(OLD_ROW)})
    assert done("Old", "OLD").counts == {Path("prog.py"): 2, Path("nicknames.csv"): 1}
    assert text() == main("if c.OLD:\n        out(c.OLD)")
    assert refused("OLD", "OLD") == "OLD is called that already"
    assert rename("old", "OLD", [Job("prog.py")], Config(Path())).writes == {}


def test_sources_follow_a_table_that_was_renamed_before() -> None:
    """A name that was changed in CLICK and taken in with the next export."""
    source = "nickname(c.Old, c[5])\n" + main("if c.Old:\n        out(c.Other)")
    place({"prog.py": source, "nicknames.csv": table('C5,BIT,"New",0,No,""', 'C6,BIT,"Other",0,No,""')})
    assert not build("prog.py").ok
    assert done("Old", "New").writes.keys() == {Path("prog.py")}
    assert text() == source.replace("Old", "New")
    # Not if both are in use, or if the table means something else.
    place({"prog.py": main("if c.Old:\n        out(c.New)")})
    assert refused("Old", "New") == "New is taken: prog.py:3:13 uses it; choose another name" + again("Old")
    place({"prog.py": main("if ds.Old:\n        out(c.Other)")})
    assert "so it cannot be ds.Old" in refused("Old", "New")


def _list(nickname: str) -> None:
    """A workbook with one name."""
    book = openpyxl.Workbook()
    sheet = book.active
    assert sheet is not None
    sheet.title = "IO"
    for row in (("Address", "Tag"), ("C5", nickname)):
        sheet.append(row)
    book.save("plant.xlsx")


def test_a_workbook_is_not_written() -> None:
    source = main("if c.Old:\n        out(c.Other)")
    place({"prog.py": source, "nicknames.csv": table('C1,BIT,"Other",0,No,""')})
    _list("Old")
    job, here = Job("prog.py", Settings("plant.xlsx")), Config(Path.cwd())
    with pytest.raises(CouldNotRun) as caught:
        rename("Old", "New", [job], here)
    assert str(caught.value) == (
        "Old stands in the row of IO!A2 of plant.xlsx, and clickgen writes into no workbook: write New there and run "
        "this again, then it renames in the programs"
    )
    # If the workbook has the new name, the programs follow, and a name of the table beside it is renamed there.
    _list("New")
    workbook = Path("plant.xlsx").read_bytes()
    change = rename("Old", "New", [job], here)
    put_in_place(change.writes, (), change.unchanged)
    assert text() == source.replace("Old", "New")
    change = rename("Other", "Lamp", [job], here)
    put_in_place(change.writes, (), change.unchanged)
    assert text() == source.replace("Old", "New").replace("Other", "Lamp")
    assert Path("nicknames.csv").read_text("utf-8") == table('C1,BIT,"Lamp",0,No,""')
    assert Path("plant.xlsx").read_bytes() == workbook


def test_the_record_of_what_clickgen_placed_follows(capsys: pytest.CaptureFixture[str]) -> None:
    place({"prog.py": main("if c.Old:\n        out(c.Other)")})
    assert run(["nicknames", "sync", "prog.py"]) == 0
    before = text("nicknames.placed")
    change = done("old", "New")
    assert change.counts == {Path("prog.py"): 1, Path("nicknames.csv"): 1}
    assert text("nicknames.placed") == before.replace("C1 Old", "C1 New") != before
    place({"prog.py": main("if c.Other:\n        out(y[1])")})
    assert run(["nicknames", "sync", "prog.py", "--prune"]) == 0
    assert "  - C1 New\n" in capsys.readouterr().out
    assert "New" not in text("nicknames.csv") + text("nicknames.placed")


def test_the_record_of_a_name_that_a_person_placed_stays() -> None:
    record = "# Names\nC9 Old\nC5 Other\n"
    place({"prog.py": main("if c.Old:\n        out(y[1])"), "nicknames.csv": table(OLD_ROW)})
    place({"nicknames.placed": record})
    change = done("Old", "New")
    assert text("nicknames.placed") == record
    place({"nicknames.placed": "C5 New\n"})
    change = rename("New", "Newer", [Job("prog.py")], Config(Path.cwd()))
    place({"nicknames.placed": record})
    with pytest.raises(ChangedMeanwhile):
        put_in_place(change.writes, (), change.unchanged)
