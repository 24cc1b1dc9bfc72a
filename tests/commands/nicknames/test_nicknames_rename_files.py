"""The files that a rename goes through, the renames that it refuses, and its effect on blocks."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from budget import examples
from hypothesis import given
from hypothesis import strategies as st
from renaming import EVERYWHERE, OLD_ROW, Job, _here, again, done, main, place, refused, table, text

from clickgen.api import build
from clickgen.cli import main as run
from clickgen.commands.nicknames.rename import rename
from clickgen.commands.nicknames.uses import places_in, read_names
from clickgen.config import Config, ProgramSettings, Settings
from clickgen.dialects.if_rungs.fix.names import comments_with
from clickgen.dialects.if_rungs.read.parse import decode
from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.write import ChangedMeanwhile, put_in_place
from clickgen.workspace import CouldNotRun

__all__ = ["_here"]


# -- which files -------------------------------------------------------------------------------------------------------


def test_imported_files_and_their_unused_routines() -> None:
    unused = "@sub\ndef unused():\n    if c.old:\n        out(y[1])\n    if True:\n        return\n"
    files = {
        "prog.py": "import wiring\n\n\n" + main("if c.Old:\n        out(y[2])"),
        "other.py": "import wiring\n\n\n" + main("if c.Old:\n        out(y[3])"),
        "wiring.py": f"nickname(c.Old, c[5])\n\n\n{unused}",
        "spare.py": "@sub\ndef spare():\n    if c.Old:\n        return\n    if True:\n        return\n",
        "deep/far.py": main("if c.Old:\n        out(y[2])"),
        "unrelated.py": "def old():\n    return c.Old\n",
    }
    place({**files, "nicknames.csv": table(OLD_ROW)})
    change = done("Old", "New")
    assert change.counts == {
        Path("prog.py"): 1, Path("other.py"): 1, Path("wiring.py"): 2, Path("spare.py"): 1, Path("nicknames.csv"): 1
    }  # fmt: skip
    assert sorted(change.programs) == ["other.py", "prog.py"]
    # Its table is the one beside it.
    assert text("deep/far.py") == files["deep/far.py"]
    assert text("unrelated.py") == files["unrelated.py"]


def test_a_part_of_no_program_is_mentioned_where_its_table_is_another(capsys: pytest.CaptureFixture[str]) -> None:
    part = "@sub\ndef spare():\n    if c.Old:\n        return\n    if True:\n        return\n"
    place(
        {
            "prog.py": main("if c.Old:\n        out(y[2])"),
            "spare.py": part,
            "plant.csv": table(OLD_ROW),
            # A program with a table of its own is another matter.
            "deep/far.py": part,
            "deep/nicknames.csv": table(OLD_ROW),
        }
    )
    place({"clickgen.toml": 'programs = [{ path = "prog.py", nicknames = "plant.csv" }]\n'})
    assert run(["nicknames", "rename", "Old", "New"]) == 0
    assert capsys.readouterr().out == (
        "Old becomes New; the ladder of prog.py stays the same:\n  plant.csv: 1 time\n  prog.py: 1 time\n"
        "  spare.py:3 says Old too, in a file that no program imports: it stays as it is\n"
        "Old is New now\n"
    )
    assert text("spare.py") == part


def test_what_the_command_says_is_seen_from_the_working_folder(capsys: pytest.CaptureFixture[str]) -> None:
    place(
        {"one.py": main("if c.Old:  # Old\n        out(y[1])"), "two.py": main("if c.Old:  # Old\n        out(y[2])")}
    )
    place({"clickgen.toml": 'programs = ["one.py", "two.py"]\n', "nicknames.csv": table(OLD_ROW)})
    assert run(["nicknames", "rename", "Old", "New", "one.py", "--dry-run"]) == 0
    assert capsys.readouterr().out == (
        "Old would become New; the ladder of one.py, two.py would be the same:\n"
        "  nicknames.csv: 1 time\n  one.py: 1 time\n  two.py: 1 time\n"
        "  one.py: 1 comment still says Old\n  two.py: 1 comment still says Old\n"
    )
    assert "Old" in text("one.py")


def test_a_table_that_is_a_pipe_is_refused() -> None:
    place({"prog.py": main("if c.Old:\n        out(y[1])")})
    os.mkfifo("nicknames.csv")
    with pytest.raises(CouldNotRun, match=r"nicknames\.csv is a pipe or a device"):
        rename("Old", "New", [Job("prog.py")], Config(Path.cwd()))


def test_configured_programs_share_a_table() -> None:
    place(
        {
            "a/one.py": main("if c.Old:\n        out(y[1])"),
            "b/two.py": main("if c.Old:\n        out(y[2])"),
            "b/three.py": main("if c.Old:\n        out(y[2])"),
            "shared/names.csv": table(OLD_ROW),
        }
    )
    names = Path("shared/names.csv")
    config = Config(Path(), None, (ProgramSettings(Path("a/one.py"), names), ProgramSettings(Path("b/two.py"), names)))
    change = rename("Old", "New", [Job("a/one.py", Settings(names))], config)
    assert change.writes.keys() == {Path("a/one.py"), Path("b/two.py"), names}
    assert change.programs == ("a/one.py", "b/two.py")


def test_a_file_of_programs_with_different_tables() -> None:
    place(
        {
            "wiring.py": "nickname(c.Old, c[5])\n",
            "one.py": "import wiring\n\n\n" + main("if c.Old:\n        out(y[1])"),
            "two.py": "import wiring\n\n\n" + main("if c.Old:\n        out(y[1])"),
            "one.csv": table(OLD_ROW),
            "two.csv": table(OLD_ROW.replace('"Old"', "old")),
        }
    )
    both = tuple(ProgramSettings(Path(f"{name}.py"), Path(f"{name}.csv")) for name in ("one", "two"))
    config = Config(Path(), None, both)
    jobs = [Job(str(program.path), Settings(program.nicknames)) for program in both]
    with pytest.raises(
        CouldNotRun, match=r"belongs to two\.py, which has an address table of its own \(two\.csv\): name"
    ):
        rename("Old", "New", jobs[:1], config)
    change = rename("Old", "New", jobs, config)
    assert change.counts == dict.fromkeys(map(Path, ("wiring.py", "one.py", "two.py", "one.csv", "two.csv")), 1)


def test_a_broken_program_beside_it() -> None:
    place({"prog.py": main("if c.Old:\n        out(y[1])"), "nicknames.csv": table(OLD_ROW)})
    place({"broken.py": main("if c.Unknown:\n        ton(c.A)")})
    assert done("Old", "New").programs == ("prog.py",)
    place({"broken.py": main("if c.New:\n        ton(c.A)")})
    assert refused("New", "Newer").startswith(
        "broken.py has errors, and only programs that build are renamed in: broken.py:3:9: ton needs 'setpoint'"
    )
    place({"broken.py": "def main():\n    if c.New\n        out(c.A)\n"})
    assert refused("New", "Newer").startswith("broken.py has errors")


# -- what is refused ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("Odl", "New", "there is no nickname or block Odl in nicknames.csv or in the programs; did you mean Old?"),
        ("Nothing", "New", "there is no nickname or block Nothing in nicknames.csv or in the programs"),
        ("Old", "sum", "CLICK does not take the nickname 'sum': sum is a word of CLICK's formulas"),
        ("Old", "", "CLICK does not take the nickname '': it is empty"),
        ("Old", "scratch_c7", "clickgen keeps names like scratch_c7 for its own cells; choose another name"),
        (
            "Old",
            "other",
            "other is taken: it is C6 (line 3 of nicknames.csv); choose another name; where a build gave it to what "
            "was Old, run clickgen nicknames sync --prune prog.py, "
            "and then clickgen nicknames rename Old other prog.py",
        ),
        ("Old", "Used", "Used is taken: prog.py:4:13 uses it; choose another name" + again("Old")),
        ("Old", "Declared", "Declared is taken: prog.py:1:10 uses it; choose another name" + again("Old")),
        ("_Always_ON", "Always", "_Always_ON is CLICK's own name of SC1"),
        ("Scratch_C2000", "Mine", "Scratch_C2000 is a cell that clickgen uses for itself (line 4 of nicknames.csv)"),
    ],
)
def test_what_is_refused(old: str, new: str, said: str) -> None:
    place(
        {
            "prog.py": "nickname(c.Declared, c[50])\n" + main("if c.Old:\n        out(c.Used)"),
            "nicknames.csv": table(
                OLD_ROW, 'C6,BIT,"Other",0,No,""', 'C2000,BIT,"Scratch_C2000",0,No,"condition of main rung 12"'
            ),
        }
    )
    assert refused(old, new) == said


def test_errors_are_mended_first() -> None:
    place({"prog.py": main("if c.Old:\n        ton(c.A)"), "nicknames.csv": table(OLD_ROW)})
    assert refused("Old", "New") == (
        "prog.py has errors, and only programs that build are renamed in: prog.py:3:9: ton needs 'setpoint'"
    )
    place({"prog.py": main("if c.Old:\n        out(y[1])"), "nicknames.csv": table(OLD_ROW, "C5,BIT,Twice,0,No,")})
    assert refused("Old", "New").startswith("the address table has errors: nicknames.csv:3:1: C5 stands twice")
    assert "gone.py cannot be read: there is no such file" in refused("Old", "New", "gone.py")


def test_blocks_are_left_alone_where_a_nickname_is_renamed() -> None:
    source = "nickname(ds.Recipe, ds[10:20])\n" + main("if c.Old:\n        copy(ds.Recipe[3], ds.Plain)")
    place({"prog.py": source, "nicknames.csv": table(OLD_ROW)})
    assert refused("Plain", "recipe").startswith("recipe is taken: prog.py:1:10 uses it")
    done("Old", "New")
    done("Plain", "Simple")
    assert text() == source.replace("Old", "New").replace("Plain", "Simple")
    place({"nicknames.csv": table(OLD_ROW, *MARKS)})
    assert refused("Old", "Recipe") == "Recipe is taken: it is a block (line 3 of nicknames.csv); choose another name"


# -- blocks ------------------------------------------------------------------------------------------------------------


MARKS = ('DS10,INT,"",0,Yes,"before <Recipe bg=""Red""> behind"', 'DS19,INT,"Last",0,Yes,"</Recipe>"')


BLOCKS = """\
nickname(ds.§, ds[10:20], comment=" of Recipe")
nickname(ds.Recipe2, ds[30:40])


def main():
    # Recipe
    if re(c.Go):
        copy_block(ds.§[0:5], ds.Running)
        copy(ds["§"][9], ds . § [2])
        copy_fill(0, ds["§"])
        search("==", ds.§[0], ds.§[1], ds[ '§' ][4], ds.Found, c.IsFound)

    if all(ds.§[3] > 100, ds.Recipe2[3] > ds["§"][ 2 ]):
        calc("SUM(ds.§) + SUM(ds.§[0:4]) - SUM(ds['§']) * ds.Recipe2[1]" " + ds.§[2]", ds.Total)

    if True:
        end()
"""


def test_a_block_is_renamed_everywhere() -> None:
    source = BLOCKS.replace("§", "Recipe")
    place({"prog.py": source, "nicknames.csv": table(*MARKS).replace("\n", "\r\n")})
    before = build("prog.py")
    assert before.ok, before.diagnostics
    change = done("recipe", "Formula")
    assert text() == BLOCKS.replace("§", "Formula")
    after = text("nicknames.csv")
    assert after == table(*MARKS).replace("Recipe", "Formula").replace("\n", "\r\n")
    assert change.counts == {Path("prog.py"): BLOCKS.count("§"), Path("nicknames.csv"): 2}
    assert change.comments == {Path("prog.py"): 1}
    built = build("prog.py")
    assert {name: built.files[name] for name in ("main.csv", "sources.json")} == {
        name: before.files[name] for name in ("main.csv", "sources.json")
    }
    done("Formula", "Recipe")
    assert (text(), text("nicknames.csv")) == (source, table(*MARKS).replace("\n", "\r\n"))
    # A name that is not a plain word is possible only in brackets.
    assert 'choose a plain word, or write ds["Recipe"] there first' in refused("Recipe", "Door alarms")


def test_a_block_with_a_space_in_its_name() -> None:
    source = main('if c["Door alarms"][2]:\n        reset(c["Door alarms"])\n        out(c["Door alarms"][0:3])')
    marks = ('C10,BIT,"",0,No,<Door alarms>', 'C19,BIT,"",0,No,"</Door alarms>"')
    place({"prog.py": source, "nicknames.csv": table(*marks)})
    done("Door alarms", "Gate alarms")
    assert text() == source.replace("Door", "Gate")
    assert text("nicknames.csv") == table(*marks).replace("Door", "Gate")


def test_a_block_of_one_and_a_block_that_no_program_names() -> None:
    marks = ('C10,BIT,"",0,No,"<One /> x"', 'DS1,INT,"",0,Yes,<Two>', 'DS5,INT,"",0,Yes,</Two>')
    place({"prog.py": main("if c.One:\n        out(y[1])"), "nicknames.csv": table(*marks)})
    assert build("prog.py").ok
    done("One", "Single")
    assert "if c.Single:" in text()
    assert done("Two", "Pair").counts == {Path("nicknames.csv"): 2}
    assert text("nicknames.csv") == table(*marks).replace("One", "Single").replace("Two", "Pair")


def test_a_block_that_no_table_marks_yet() -> None:
    source = "nickname(y.Lamps, y[1:5])\n" + main("if c.Go:\n        out(y.Lamps.immediate)\n        set(y.Lamps[2])")
    place({"prog.py": source})
    done("Lamps", "Lights")
    assert text() == source.replace("Lamps", "Lights")
    assert not Path("nicknames.csv").exists()


def test_sources_follow_the_marks_of_a_table() -> None:
    """ClickNick has given the block its new name already."""
    for rung in ("copy_fill(0, ds.Recipe)", "copy_fill(0, ds.Recipe[2:4])"):
        source = main(f"if c.Go:\n        {rung}")
        marks = table(*(row.replace("Recipe", "Formula") for row in MARKS))
        place({"prog.py": source, "nicknames.csv": marks})
        assert done("Recipe", "Formula").counts == {Path("prog.py"): 1}
        assert text() == source.replace("Recipe", "Formula")
        assert text("nicknames.csv") == marks


@pytest.mark.parametrize(
    ("new", "said"),
    [
        ("Go", "Go is taken: it is C1 (line 4 of nicknames.csv); choose another name"),
        ("Other", "Other is taken: it is a block (line 5 of nicknames.csv); choose another name"),
        ("Total", "Total is taken: prog.py:3:28 uses it; choose another name" + again("Recipe")),
        ("a/b", "CLICK does not take the nickname 'a/b': it holds /, which CLICK forbids in a nickname"),
        ("12", "'12' cannot be the name of a block: it has no letter"),
    ],
)
def test_names_that_a_block_cannot_have(new: str, said: str) -> None:
    rows = (*MARKS, 'C1,BIT,"Go",0,No,""', 'DD1,INT2,"",0,Yes,"<Other>"', 'DD5,INT2,"",0,Yes,"</Other>"')
    place({"prog.py": main("if c.X:\n        copy(ds.Recipe[0], ds.Total)"), "nicknames.csv": table(*rows)})
    assert refused("Recipe", new) == said


def test_what_clickgen_says_of_its_own_cells_follows() -> None:
    source = main(
        "if all(c.Go, nc(c.Done)):", "    set(c.Done)", "    ton(t.Old, 5)", "    ctu(ct.Old2, 5, reset=lambda: c.Go)"
    )
    place({"prog.py": source})
    assert run(["build", "prog.py"]) == 0
    assert "of main: ton T1 Old" in text("nicknames.csv")
    before = text("nicknames.csv")
    done("Old", "Run")
    after = before.replace("T1 Old", "T1 Run").replace('"Old"', '"Run"')
    assert text("nicknames.csv") == after
    assert run(["build", "prog.py"]) == 0
    assert text("nicknames.csv") == after


def test_nothing_is_written_where_a_file_changed_meanwhile() -> None:
    place({"prog.py": main("if c.Old:\n        out(y[1])"), "nicknames.csv": table(OLD_ROW)})
    for name in ("prog.py", "nicknames.csv"):
        change = rename("Old", "New", [Job("prog.py")], Config(Path.cwd()))
        before = text("nicknames.csv"), text()
        place({name: text(name) + "\n"})
        with pytest.raises(ChangedMeanwhile):
            put_in_place(change.writes, (), change.unchanged)
        place({name: text(name)[:-1]})
        assert (text("nicknames.csv"), text()) == before


# -- places ------------------------------------------------------------------------------------------------------------


def test_places_and_comments() -> None:
    source = decode("prog.py", EVERYWHERE.replace("§", "Old").encode(), Diagnostics())
    assert source is not None
    names = read_names(source, Diagnostics())
    assert names is not None
    assert places_in([names])("older") == ["prog.py:11", "prog.py:13"]
    assert places_in([names, names])("Other") == ["prog.py:2"]
    assert (comments_with(source, "old"), comments_with(source, "oldest"), comments_with(source, "ol")) == (3, 1, 0)


PIECES = st.lists(
    st.sampled_from(["ds.Old", "ds['Old']", "ds[ds.Old]", "td.Old", "ds.Older", "1", "ds . Old"]),
    min_size=1,
    max_size=6,
)


@st.composite
def literals(draw: st.DrawFn) -> str:
    """A formula as a string of some pieces, plain, raw or escaped."""
    value = " + ".join(piece for piece in draw(PIECES) if piece != "td.Old") or "1"
    cuts = sorted(draw(st.lists(st.integers(0, len(value)), max_size=3)))
    pieces = [value[start:end] for start, end in zip([0, *cuts], [*cuts, len(value)], strict=True)]
    written = []
    for piece in pieces:
        kind = draw(st.sampled_from(["", "r", "escaped", "long", "continued"]))
        if kind == "escaped":
            inner = "".join(
                draw(st.sampled_from([c, f"\\x{ord(c):02x}", f"\\{ord(c):03o}", f"\\u{ord(c):04x}"])) for c in piece
            )
            written.append(f'"{inner}"')
        elif kind == "continued" and piece:
            written.append(f'"{piece[:1]}\\\n{piece[1:]}"')
        else:
            written.append(f'"""{piece}"""' if kind == "long" else f'{"r" * (kind == "r")}"{piece}"')
    return draw(st.sampled_from([" ", "\n            ", "  # Old\n     "])).join(written)


@given(literals(), st.sampled_from(["N", "MuchLonger", "dh"]))
@examples(20)
def test_formulas_in_any_spelling(literal: str, new: str) -> None:
    source = main(f"if c.Bit:\n        calc({literal}, ds[1])")
    place({"prog.py": source, "nicknames.csv": table("DS5,INT,Old,0,Yes,")})
    before = build("prog.py")
    assert before.ok, before.diagnostics
    done("Old", new)
    assert build("prog.py").files["main.csv"] == before.files["main.csv"]
    parsed = decode("prog.py", text().encode(), Diagnostics())
    assert parsed is not None
    names = read_names(parsed, Diagnostics())
    assert names is not None
    assert names.of("Old") == []
    # The text around the formula is untouched.
    assert text().count("# Old") == source.count("# Old")
    assert len(text().splitlines()) == len(source.splitlines())


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such file names")
def test_the_name_of_the_program_may_be_anything() -> None:
    place({"a\x1b.py": main("if c.Old: out(y[1])")})
    assert run(["nicknames", "rename", "Old", "New", "a\x1b.py"]) == 0
    assert "c.New" in text("a\x1b.py")
