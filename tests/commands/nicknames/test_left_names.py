"""A rename in the text abandons the value: build and check say so, and the commands that they print fix it."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from clickgen.cli import main as run
from clickgen.device.banks import Address
from clickgen.table.record import left_in, placed_in


@pytest.fixture(autouse=True)
def _here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def program(name: str = "Speed", other: str = "Level", bank: str = "ds") -> str:
    used = _of(bank, name)
    rungs = (
        f"if c[1]:\n        copy(5, {used})",
        f"if {used} > 3:\n        out(y[1])",
        f"if ds.{other} > 3:\n        out(y[2])",
    )
    return "def main():\n" + "".join(f"    {rung}\n" for rung in (*rungs, "if True:\n        end()"))


def _of(bank: str, name: str) -> str:
    return f"{bank}.{name}" if name.isidentifier() else f'{bank}["{name}"]'


def write(text: str, path: str = "prog.py") -> None:
    Path(path).parent.mkdir(parents=True, exist_ok=True)
    Path(path).write_text(text)


def build(*words: str) -> None:
    assert run(["build", *(words or ("prog.py",))]) == 0


def build_all() -> None:
    assert run(["build"]) == 0


def rows(table: str = "nicknames.csv") -> dict[str, str]:
    lines = Path(table).read_text().splitlines()[1:]
    return {line.split(",")[0]: line.split('"')[1] for line in lines}


def told(capsys: pytest.CaptureFixture[str], *words: str) -> list[str]:
    """The rename commands that a check prints."""
    capsys.readouterr()
    run(["check", "--no-cache", "--select", "CG541", *(words or ("prog.py",))])
    return re.findall(r"clickgen (nicknames rename [^;]+);", capsys.readouterr().out)


def steps(text: str) -> list[str]:
    """Every command that a message prints, in order."""
    return [command.strip() for command in re.findall(r"clickgen (nicknames (?:sync|rename)[^;,\n]+)", text)]


def follow(command: str) -> None:
    assert run(shlex.split(command)) == 0


@pytest.mark.parametrize("is_built", [False, True], ids=["before the build", "after the build"])
@pytest.mark.parametrize(
    ("old", "new"), [("Speed", "Rate"), ("Speed", "Speed_2"), ("Belt speed", "BeltSpeed"), ("Speed", "Belt speed")]
)
def test_the_printed_command_gives_the_value_back(
    old: str, new: str, is_built: bool, capsys: pytest.CaptureFixture[str]
) -> None:
    write(program(old))
    build()
    before = (Path("build/prog/main.csv").read_bytes(), rows())
    write(program(new))
    if is_built:
        build()
        assert "CG541" in capsys.readouterr().err
        assert rows()["DS3"] == new
    (command,) = told(capsys)
    follow(command)
    build()
    assert Path("build/prog/main.csv").read_bytes() == before[0]
    assert rows() == {**before[1], "DS1": new}
    assert placed_in(Path("nicknames.placed").read_bytes()) == {Address("DS", 1): new, Address("DS", 2): "Level"}
    assert told(capsys) == []


def test_a_build_says_it_while_the_address_is_chosen_and_afterwards(capsys: pytest.CaptureFixture[str]) -> None:
    write(program())
    build()
    write(program("Rate"))
    for _ in range(3):
        capsys.readouterr()
        build()
        assert "clickgen nicknames rename Speed Rate prog.py" in capsys.readouterr().err


def test_the_old_name_can_be_removed_instead(capsys: pytest.CaptureFixture[str]) -> None:
    write(program())
    build()
    write(program("Rate"))
    build()
    assert "left DS1 for DS3" in Path("nicknames.placed").read_text()
    follow("nicknames sync --prune prog.py")
    assert rows() == {"DS2": "Level", "DS3": "Rate"}
    assert left_in(Path("nicknames.placed").read_bytes()) == {}
    assert told(capsys) == []


def test_a_name_that_came_back_has_not_left(capsys: pytest.CaptureFixture[str]) -> None:
    write(program())
    build()
    write(program("Rate"))
    build()
    write(program("Rate", "Speed"))
    assert told(capsys) == []


@pytest.mark.parametrize(
    "after",
    [
        program("Level"),  # Nothing came.
        program("Rate", bank="dd"),  # The new name is of another kind.
        program("Rate").replace("copy(5, ds.Rate)", "copy(5, ds[1])"),  # The address is still used.
        "nickname(ds.Rate, ds[40])\n" + program("Rate"),  # Somebody chose another address.
    ],
)
def test_no_rename(after: str, capsys: pytest.CaptureFixture[str]) -> None:
    write(program())
    build()
    write(after)
    assert told(capsys) == []
    build()
    assert told(capsys) == []


def test_only_what_clickgen_placed_and_what_keeps_a_value(capsys: pytest.CaptureFixture[str]) -> None:
    write(program())
    build()
    Path("nicknames.placed").unlink()
    write(program("Rate"))
    assert told(capsys) == []
    write("def main():\n    if c.Old:\n        out(y[1])\n    if True:\n        end()\n", "bits.py")
    build("bits.py")
    write("def main():\n    if c.New:\n        out(y[1])\n    if True:\n        end()\n", "bits.py")
    assert told(capsys, "bits.py") == []


def test_several_names_find_their_partners(capsys: pytest.CaptureFixture[str]) -> None:
    write(program("FillTime", "CapTime"))
    build()
    write(program("Time_Fill", "Time_Cap"))
    commands = told(capsys)
    assert commands == [
        "nicknames rename FillTime Time_Fill prog.py",
        "nicknames rename CapTime Time_Cap prog.py",
    ]
    build()
    for command in commands:
        follow(command)
    assert rows() == {"DS1": "Time_Fill", "DS2": "Time_Cap"}


def test_a_name_that_another_program_uses_has_not_left(capsys: pytest.CaptureFixture[str]) -> None:
    write(program())
    write(program(other="Height"), "other.py")
    build()
    build("other.py")
    write(program("Rate"))
    assert told(capsys) == []
    build()
    assert "CG541" not in capsys.readouterr().err
    assert left_in(Path("nicknames.placed").read_bytes()) == {}
    # By its number too.
    write(program("Height").replace("Height > 3", "Height > 3").replace("ds.Level", "ds[1]"), "other.py")
    assert told(capsys) == []


@pytest.mark.parametrize("is_built", [False, True], ids=["before the build", "after the build"])
def test_programs_that_share_a_table(is_built: bool, capsys: pytest.CaptureFixture[str]) -> None:
    write('programs = ["a/one.py", { path = "b/two.py", nicknames = "a/nicknames.csv" }]\n', "clickgen.toml")
    write(program(), "a/one.py")
    write(program(other="Height"), "b/two.py")
    build_all()
    ladders = [Path(f"build/{name}/main.csv").read_bytes() for name in ("one", "two")]
    write(program("Rate"), "a/one.py")
    assert told(capsys, "a/one.py") == []
    write(program("Rate", "Height"), "b/two.py")
    if is_built:
        build_all()
    (command,) = told(capsys, "a/one.py")
    assert command == "nicknames rename Speed Rate a/one.py"
    assert told(capsys, "b/two.py") == ["nicknames rename Speed Rate b/two.py --nicknames a/nicknames.csv"]
    follow(command)
    build_all()
    assert [Path(f"build/{name}/main.csv").read_bytes() for name in ("one", "two")] == ladders
    assert rows("a/nicknames.csv") == {"DS1": "Rate", "DS2": "Level", "DS3": "Height"}


def test_a_table_that_is_named(capsys: pytest.CaptureFixture[str]) -> None:
    write('programs = [{ path = "prog.py", nicknames = "my plant.csv" }]\n', "clickgen.toml")
    write(program())
    build()
    write(program("Rate"))
    (command,) = told(capsys)
    Path("clickgen.toml").unlink()
    follow(command)
    assert rows("my plant.csv")["DS1"] == "Rate"


def test_a_name_that_is_established_is_not_taken_over(capsys: pytest.CaptureFixture[str]) -> None:
    write(program())
    build()
    write(program("Level", "Level"))
    build()
    assert run(["nicknames", "rename", "Speed", "Level", "prog.py"]) == 2
    assert "Level is taken" in capsys.readouterr().err
    assert rows() == {"DS1": "Speed", "DS2": "Level"}


def test_an_address_stays_in_its_bank(capsys: pytest.CaptureFixture[str]) -> None:
    write(program())
    build()
    write(program("Rate", bank="dd"))
    assert run(["nicknames", "rename", "Speed", "Rate", "prog.py"]) == 2
    assert "so write ds.Rate there" in capsys.readouterr().err


def test_a_dry_run_writes_nothing(capsys: pytest.CaptureFixture[str]) -> None:
    write(program())
    build()
    write(program("Rate"))
    build()
    before = {path: path.read_bytes() for path in Path().rglob("*") if path.is_file()}
    capsys.readouterr()
    assert run(["nicknames", "rename", "Speed", "Rate", "prog.py", "--dry-run"]) == 0
    assert "DS1 would be Rate" in capsys.readouterr().out
    assert {path: path.read_bytes() for path in Path().rglob("*") if path.is_file()} == before


def test_a_finding_out_of_the_cache_is_looked_at_again(capsys: pytest.CaptureFixture[str]) -> None:
    write(program())
    build()
    write(program("Rate"))
    for _ in range(2):
        assert run(["check", "prog.py"]) == 1
    write(program(other="Height"), "other.py")
    capsys.readouterr()
    run(["check", "prog.py"])
    assert "CG541" not in capsys.readouterr().out


def test_sync_remembers_what_left(capsys: pytest.CaptureFixture[str]) -> None:
    write(program())
    build()
    write(program("Rate"))
    follow("nicknames sync prog.py")
    (command,) = told(capsys)
    follow(command)
    assert rows() == {"DS1": "Rate", "DS2": "Level"}


# -- half done --------------------------------------------------------------------------------------------------------


def whole(name: str) -> str:
    """The program, with a rung that writes its other name: then the rename is not half done."""
    return program(name).replace("    if True:", "    if c[2]:\n        copy(7, ds.Level)\n    if True:")


def half(old: str = "Speed", new: str = "Rate", where: int = 1) -> str:
    """The program with the new name in one of the two places of the old one."""
    parts = whole(old).split(_of("ds", old))
    return (
        parts[0]
        + (_of("ds", new), _of("ds", old))[where]
        + parts[1]
        + (_of("ds", old), _of("ds", new))[where]
        + parts[2]
    )


@pytest.mark.parametrize("where", [0, 1], ids=["written", "read"])
@pytest.mark.parametrize("is_built", [False, True], ids=["before the build", "after the build"])
@pytest.mark.parametrize(
    ("old", "new"), [("Speed", "Rate"), ("Speed", "Speed_2"), ("Belt speed", "BeltRate"), ("Speed", "Belt speed")]
)
def test_a_half_done_rename_is_told_and_finished(
    old: str, new: str, is_built: bool, where: int, capsys: pytest.CaptureFixture[str]
) -> None:
    write(whole(old))
    build()
    before = (Path("build/prog/main.csv").read_bytes(), rows())
    write(half(old, new, where))
    if is_built:
        build()
        assert "CG541" in capsys.readouterr().err
        assert rows()["DS3"] == new
    run(["check", "--no-cache", "--select", "CG541", "prog.py"])
    said = capsys.readouterr().out
    assert f"{old} (DS1) and {new} (DS3) are both in the program" in said
    commands = steps(said)
    assert [command.split()[1] for command in commands] == (["rename"] if is_built else ["sync", "rename"])
    if not new.isidentifier() and not where:
        # The old name still follows a dot, where no such name is possible.
        return
    for command in commands:
        if not new.isidentifier():
            Path("prog.py").write_text(Path("prog.py").read_text().replace(f"ds.{old}", f'ds["{old}"]'))
        follow(command)
    # A place in brackets keeps them.
    assert Path("prog.py").read_text().replace(f'ds["{new}"]', _of("ds", new)) == whole(new)
    build()
    assert Path("build/prog/main.csv").read_bytes() == before[0]
    assert rows() == {**before[1], "DS1": new}
    assert told(capsys) == []


def test_the_half_of_another_program_is_renamed_too(capsys: pytest.CaptureFixture[str]) -> None:
    write(program())
    write(program(other="Height"), "other.py")
    build()
    build("other.py")
    ladder = Path("build/other/main.csv").read_bytes()
    write(half())
    build()
    for command in steps(capsys.readouterr().err):
        follow(command)
    assert Path("other.py").read_text() == program("Rate", "Height")
    build("other.py")
    assert Path("build/other/main.csv").read_bytes() == ladder


@pytest.mark.parametrize("is_built", [False, True], ids=["before the build", "after the build"])
def test_the_refusal_of_a_half_done_rename_prints_what_works(
    is_built: bool, capsys: pytest.CaptureFixture[str]
) -> None:
    """If both names are read, nothing shows that they are one; whoever knows it is told what to do."""
    both = program() + "    if ds.Speed > 4:\n        out(y[3])\n"
    both = both.replace("    if True:\n        end()\n", "") + "    if True:\n        end()\n"
    write(both)
    build()
    ladder = Path("build/prog/main.csv").read_bytes()
    write(both.replace("ds.Speed > 4", "ds.Rate > 4"))
    if is_built:
        build()
    assert told(capsys) == []
    assert run(["nicknames", "rename", "Speed", "Rate", "prog.py"]) == 2
    said = capsys.readouterr().err
    assert "write Speed" in said
    assert "prog.py:8:8" in said
    write(both)
    for command in steps(said) if is_built else ["nicknames rename Speed Rate prog.py"]:
        follow(command)
    build()
    assert Path("build/prog/main.csv").read_bytes() == ladder
    assert rows() == {"DS1": "Rate", "DS2": "Level"}


def test_two_names_that_are_one_sided_and_not_alone_are_left_alone(capsys: pytest.CaptureFixture[str]) -> None:
    """A panel writes setpoints and reads results: names that a program only reads, or only writes, are common."""
    rungs = "".join(
        f"    if ds.{name} > 3:\n        out(y[{n}])\n" for n, name in enumerate(("Low", "High", "Stop"), 1)
    )
    end = "    if True:\n        end()\n"
    write(f"def main():\n{rungs}{end}")
    build()
    write(f"def main():\n{rungs}    if c[1]:\n        copy(5, ds.Total)\n{end}")
    assert told(capsys) == []
    build()
    assert told(capsys) == []


def test_a_name_that_may_be_one_of_two_is_asked_for_while_it_is_new(capsys: pytest.CaptureFixture[str]) -> None:
    write(program())
    build()
    before = Path("build/prog/main.csv").read_bytes()
    write(program().replace("copy(5, ds.Speed)", "copy(5, ds.Rate)"))
    run(["check", "--no-cache", "--select", "CG541", "prog.py"])
    said = capsys.readouterr().out
    assert "Speed (DS1) and Rate (DS3) are both" in said
    assert "Level (DS2) and Rate (DS3) are both" in said
    build()
    said = capsys.readouterr().err
    assert "write Speed again at prog.py:3:17" in said
    assert told(capsys) == []
    write(program())
    for command in [one for one in steps(said) if "Level" not in one]:
        follow(command)
    build()
    assert Path("build/prog/main.csv").read_bytes() == before
    assert rows() == {"DS1": "Rate", "DS2": "Level"}


# -- declarations -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("nickname(ds.Recipe, ds[100:110])", "nickname(ds.Mix, ds[100:110])"),
        ('nickname(ds["My recipe"], ds[100:110])', 'nickname(ds["A mix"], ds[100:110])'),
        ("nickname(ds.Total, ds[5])", "nickname(ds.Sum_1, ds[5])"),
    ],
)
def test_a_declaration_with_another_name_names_the_rename(
    before: str, after: str, capsys: pytest.CaptureFixture[str]
) -> None:
    old, new = before.split(", ")[0].removeprefix("nickname("), after.split(", ")[0].removeprefix("nickname(")
    member = "[2]" if ":" in before else ""
    text = "{}\n\n\ndef main():\n    if c[1]:\n        copy(5, {}{})\n    if True:\n        end()\n"
    write(text.format(before, old, member))
    build()
    ladder = Path("build/prog/main.csv").read_bytes()
    write(text.format(after, new, member))
    capsys.readouterr()
    assert run(["build", "prog.py"]) == 1
    (command,) = steps(capsys.readouterr().err)
    assert command.endswith(" prog.py")
    follow(command)
    build()
    assert Path("build/prog/main.csv").read_bytes() == ladder


def test_the_command_of_a_declaration_names_the_table(capsys: pytest.CaptureFixture[str]) -> None:
    write("nickname(ds.Total, ds[5])\n" + program())
    write("", "plant.csv")
    Path("plant.csv").unlink()
    build()
    Path("nicknames.csv").rename("my plant.csv")
    write("nickname(ds.Sum_1, ds[5])\n" + program())
    assert run(["build", "prog.py", "--nicknames", "my plant.csv"]) == 1
    (command,) = steps(capsys.readouterr().err)
    assert command == "nicknames rename Total Sum_1 prog.py --nicknames 'my plant.csv'"
    follow(command)
    build("prog.py", "--nicknames", "my plant.csv")
