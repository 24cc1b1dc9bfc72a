"""A repository laid out by somebody else cannot make clickgen write where it should not."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from hostile import DOUBLE, GOOD, MENDED, check, outside, place, posix_only

from clickgen.cli import main
from clickgen.commands.check.cache import NAME
from clickgen.dialects.discover import Target
from clickgen.workspace import secret
from clickgen.workspace.memory import Memory

__all__ = ["place"]


HEAD = "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment\n"


MINE = "mine, and no business of a build\n"


# -- the cache ---------------------------------------------------------------------------------------------------------


def entries() -> list[Path]:
    return sorted(Path(".clickgen_cache").glob("checked.json"))


def test_findings_that_somebody_took_out_of_the_cache_are_found_again(capsys: pytest.CaptureFixture[str]) -> None:
    Path("prog.py").write_text(DOUBLE)
    told = check(capsys, "prog.py")
    assert told[0] == 1
    (entry,) = entries()
    mark, body = entry.read_text().split("\n", 1)
    forged = {key: {**known, "findings": []} for key, known in json.loads(body).items()}
    entry.write_text(f"{mark}\n{json.dumps(forged)}")
    assert check(capsys, "prog.py") == told


def test_a_cache_of_another_user_counts_for_nothing(
    capsys: pytest.CaptureFixture[str], place: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    Path("prog.py").write_text(DOUBLE)
    told = check(capsys, "prog.py")
    judged: list[Target] = []

    def judging(_: object, targets: list[Target], **_more: object) -> list[object]:
        judged.extend(targets)
        return []

    monkeypatch.setattr("clickgen.commands.check.programs.Judge._judged", judging)
    main(["check", "prog.py"])
    assert judged == []
    (place / "cache" / "clickgen" / "cache.key").unlink()
    main(["check", "prog.py"])
    assert [target.path for target in judged] == ["prog.py"]
    assert told[0] == 1


def test_a_fix_out_of_the_cache_changes_no_other_file(place: Path) -> None:
    """Not even with the mark of this user."""
    Path("prog.py").write_text(MENDED)
    (place / "outside" / "other.py").write_text(MINE)
    Path("other.py").write_text(MINE)
    main(["check", "prog.py"])
    memory = Memory(Path.cwd())
    tree = memory.get(NAME)
    assert isinstance(tree, dict)
    (entry,) = tree.values()
    for other in (str(place / "outside" / "other.py"), "other.py"):
        finding = next(finding for finding in entry["findings"] if finding[5])
        for edit in finding[5][0]:
            edit[0][0] = other
        memory.put(NAME, tree)
        memory.save()
        main(["check", "prog.py", "--fix"])
        assert outside(place) == {"other.py": MINE}
        assert Path("other.py").read_text() == MINE


@posix_only
@pytest.mark.parametrize("kind", ["open", "link", "folder", "short"])
def test_a_secret_that_is_not_this_users_alone_is_none(kind: str, place: Path) -> None:
    key = place / "cache" / "clickgen" / "cache.key"
    found = secret.user_secret(Path.cwd())
    assert found is not None
    assert key.stat().st_mode & 0o777 == 0o600
    assert secret.user_secret(Path.cwd()) == found
    if kind == "open":
        key.chmod(0o640)
    elif kind == "link":
        key.rename(place / "outside" / "key")
        key.symlink_to(place / "outside" / "key")
    elif kind == "folder":
        key.unlink()
        key.mkdir()
    else:
        key.write_bytes(b"short")
    assert secret.user_secret(Path.cwd()) is None
    Path("prog.py").write_text(DOUBLE)
    assert main(["check", "prog.py"]) == 1
    assert entries() == []


@posix_only
@pytest.mark.parametrize("variable", [None, "relative", "inside"])
def test_without_a_place_for_the_secret_nothing_is_cached(
    variable: str | None, place: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("HOME", raising=False)
    monkeypatch.delenv("XDG_CACHE_HOME")
    if variable:
        inside = place / "repository" / ".cache"
        monkeypatch.setenv("XDG_CACHE_HOME", ".cache" if variable == "relative" else str(inside))
    assert main(["check", "prog.py"]) == 0
    assert entries() == []


@posix_only
@pytest.mark.parametrize("target", ["", "new"])
def test_a_cache_that_is_a_link_is_not_written_through(target: str, place: Path) -> None:
    Path(".clickgen_cache").symlink_to(place / "outside" / target)
    assert main(["check", "prog.py"]) == 0
    assert outside(place) == {}
    Path(".clickgen_cache").unlink()
    Path(".clickgen_cache").mkdir()
    Path(".clickgen_cache", ".gitignore").symlink_to(place / "outside" / "ignore")
    assert main(["check", "prog.py"]) == 0
    assert outside(place) == {}
    assert len(entries()) == 1


# -- links -------------------------------------------------------------------------------------------------------------


@posix_only
@pytest.mark.parametrize("is_there", [True, False], ids=["to a file", "to nothing"])
@pytest.mark.parametrize("name", ["main.csv", "nicknames.csv", "listing.txt", "sources.json", "subroutines/wash.csv"])
def test_an_output_that_is_a_link_is_refused(
    name: str, is_there: bool, place: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    if is_there:
        (place / "outside" / "file").write_text(MINE)
    before = outside(place)
    assert main(["build", "prog.py"]) == 0
    path = Path("build/prog", name)
    path.unlink()
    path.symlink_to(place / "outside" / "file")
    Path("prog.py").write_text(GOOD.replace("y[1]", "y[3]"))
    assert main(["build", "prog.py"]) == 2
    assert str(path) in capsys.readouterr().err.replace("holds files", str(path))
    assert outside(place) == before


@posix_only
def test_a_folder_of_subroutines_that_is_a_link_is_refused(place: Path, capsys: pytest.CaptureFixture[str]) -> None:
    Path("build/prog").mkdir(parents=True)
    Path("build/prog/subroutines").symlink_to(place / "outside")
    assert main(["build", "prog.py"]) == 2
    assert "subroutines is a link to another place" in capsys.readouterr().err
    assert outside(place) == {}
    assert not Path("nicknames.csv").exists()


@posix_only
@pytest.mark.parametrize("arguments", [(), ("-o", "build/prog"), ("-o", "build/prog/")])
def test_the_output_folder_itself_may_be_a_link(place: Path, arguments: tuple[str, ...]) -> None:
    Path("build").mkdir()
    Path("build/prog").symlink_to(place / "outside")
    assert main(["build", "prog.py", *arguments]) == 0
    assert main(["build", "prog.py", *arguments]) == 0
    assert (place / "outside" / "subroutines" / "wash.csv").is_file()


@posix_only
def test_an_address_table_may_be_a_link(place: Path) -> None:
    (place / "outside" / "nicknames.csv").write_text(HEAD)
    Path("nicknames.csv").symlink_to(place / "outside" / "nicknames.csv")
    assert main(["build", "prog.py"]) == 0
    assert Path("nicknames.csv").is_symlink()
    assert sorted(outside(place)) == ["nicknames.csv", "nicknames.placed"]


@posix_only
@pytest.mark.parametrize("is_there", [True, False], ids=["to a file", "to nothing"])
@pytest.mark.parametrize("command", ["build prog.py", "nicknames sync prog.py"])
def test_a_record_that_is_a_link_is_refused(
    command: str, is_there: bool, place: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    if is_there:
        (place / "outside" / "file").write_text("DS1 Mine\n")
    before = outside(place)
    Path("nicknames.placed").symlink_to(place / "outside" / "file")
    assert main(command.split()) == 2
    assert "nicknames.placed is a link to another place" in capsys.readouterr().err
    assert outside(place) == before
    assert not Path("nicknames.csv").exists()


@posix_only
@pytest.mark.parametrize(
    ("name", "command"),
    [
        ("build/prog/prog.xlsx", "workbook prog.py"),
        ("book.xlsx", "workbook prog.py -o book.xlsx"),
        ("__builtins__.pyi", "stubs prog.py"),
        ("report.txt", "check prog.py -o report.txt"),
        ("known.json", "check prog.py --baseline known.json"),
        ("new.py", "import build/prog -o new.py"),
    ],
)
def test_what_a_command_writes_is_no_link_to_nowhere(name: str, command: str, place: Path) -> None:
    assert main(["build", "prog.py"]) == 0
    Path(name).symlink_to(place / "outside" / "file")
    assert main(command.split()) == 2
    assert outside(place) == {}


# -- what is not ours --------------------------------------------------------------------------------------------------


def forge(folder: Path, *names: str, routines: object = None) -> None:
    noted = {"format": 1, "generator": "clickgen", "files": [*names, "sources.json"], "routines": routines or {}}
    (folder / "sources.json").write_text(json.dumps(noted))


@pytest.mark.parametrize(
    "name", ["mine.csv", "main.csv", "main_2.csv", "nicknames.csv", "listing.txt", "subroutines/a.csv"]
)
@pytest.mark.parametrize("routines", [None, {"main": [], "a": []}, [], {"main": [1], "a": [1]}], ids=repr)
def test_a_forged_source_map_takes_no_file_of_a_person(name: str, routines: object) -> None:
    path = Path("out", name)
    path.parent.mkdir(parents=True)
    path.write_text(MINE)
    forge(Path("out"), name, routines=routines)
    assert main(["build", "prog.py", "-o", "out"]) == 2
    assert path.read_text() == MINE
    assert not Path("nicknames.csv").exists()


def test_ladder_that_no_build_made_is_not_removed_for_its_form_alone() -> None:
    """Not even if the map knows a routine of its name with as many rungs."""
    assert main(["build", "prog.py", "-o", "other"]) == 0
    ladder = Path("other/subroutines/wash.csv").read_bytes()
    Path("out/subroutines").mkdir(parents=True)
    path = Path("out/subroutines/theirs.csv")
    path.write_bytes(ladder)
    for rungs in (1, 2):
        forge(Path("out"), "subroutines/theirs.csv", routines={"theirs": [{}] * rungs})
        assert main(["build", "prog.py", "-o", "out"]) == 2
        assert path.read_bytes() == ladder


def test_a_leftover_that_somebody_has_drawn_on_stays(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["build", "prog.py"]) == 0
    path = Path("build/prog/subroutines/wash.csv")
    drawn = path.read_bytes().replace(b"Y002", b"Y003")
    path.write_bytes(drawn)
    Path("prog.py").write_text(GOOD.replace("wash", "rinse"))
    assert main(["build", "prog.py"]) == 2
    assert "holds files that clickgen did not make" in capsys.readouterr().err
    assert path.read_bytes() == drawn


def test_a_leftover_with_other_ends_of_lines_goes() -> None:
    """Git changes line ends on Windows."""
    assert main(["build", "prog.py"]) == 0
    path = Path("build/prog/subroutines/wash.csv")
    path.write_bytes(path.read_bytes().replace(b"\r\n", b"\n").replace(b"\n", b"\r\n"))
    Path("prog.py").write_text(GOOD.replace("wash", "rinse"))
    assert main(["build", "prog.py"]) == 0
    assert not path.exists()


@posix_only
def test_a_link_that_a_forged_map_names_is_left_alone(place: Path) -> None:
    (place / "outside" / "a.csv").write_text(MINE)
    Path("out").mkdir()
    Path("out/main_2.csv").symlink_to(place / "outside" / "a.csv")
    forge(Path("out"), "main_2.csv")
    assert main(["build", "prog.py", "-o", "out"]) == 2
    assert Path("out/main_2.csv").is_symlink()


def test_leftovers_of_a_real_build_go() -> None:
    assert main(["build", "prog.py"]) == 0
    Path("prog.py").write_text(GOOD.replace("wash", "rinse"))
    assert main(["build", "prog.py"]) == 0
    assert [path.name for path in Path("build/prog/subroutines").iterdir()] == ["rinse.csv"]


@pytest.mark.parametrize("command", ["build prog.py", "nicknames sync prog.py"])
def test_a_record_with_foreign_text_is_refused(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    Path("nicknames.placed").write_text(MINE)
    assert main(command.split()) == 2
    assert "is not the record of clickgen" in capsys.readouterr().err
    assert Path("nicknames.placed").read_text() == MINE


def test_what_a_person_wrote_into_a_record_stays() -> None:
    assert main(["build", "prog.py"]) == 0
    record = Path("nicknames.placed")
    record.write_text(f"{record.read_text()}# the panel needs these\nand these\n")
    Path("prog.py").write_text(GOOD.replace("c.Start", "c.Begin"))
    assert main(["build", "prog.py"]) == 0
    text = record.read_text()
    assert "\n# the panel needs these\nand these\n" in text
    assert "Begin" in text
    assert main(["build", "prog.py"]) == 0
    assert record.read_text() == text


@pytest.mark.parametrize(
    "name", ["prog.py", "PROG.PY", "other.py", "nicknames.csv", "nicknames.placed", "io.xlsx", "clickgen.toml"]
)
def test_a_report_takes_the_place_of_no_input(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["build", "prog.py"]) == 0
    before = {path.name: path.read_bytes() for path in Path().iterdir() if path.is_file()}
    assert main(["check", "prog.py", "-o", name]) == 2
    assert "a report would take its place" in capsys.readouterr().err
    assert before == {path.name: path.read_bytes() for path in Path().iterdir() if path.is_file()}


def test_a_report_takes_the_place_of_no_input_whatever_its_name() -> None:
    Path("settings").write_text('programs = ["prog.py"]\n')
    Path("part").write_text(GOOD)
    assert main(["check", "prog.py", "--config", "settings", "-o", "settings"]) == 2
    assert main(["check", "part", "-o", "./part"]) == 2
    assert main(["check", "prog.py", "-o", "known", "--baseline", "known"]) == 2
    assert Path("part").read_text() == GOOD
