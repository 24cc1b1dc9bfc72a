"""A repository that somebody else has laid out cannot make clickgen write, read or run what it should not."""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from multiprocessing import get_all_start_methods
from pathlib import Path

import pytest

from clickgen.cli import main
from clickgen.commands.check import secret
from clickgen.config import OWN_FILE
from clickgen.dialects.if_rungs.discover import Target
from clickgen.workspace import leads_elsewhere, read_file

posix_only = pytest.mark.skipif(os.name != "posix", reason="about POSIX links, pipes and devices")

GOOD = """\
def main():
    if c.Start:
        out(y[1])
    if True:
        call(wash)
    if True:
        end()


@sub
def wash():
    if c.Start:
        out(y[2])
    if True:
        return
"""
DOUBLE = "def main():\n    if c.A:\n        out(y[1])\n    if c.B:\n        out(y[1])\n    if True:\n        end()\n"
MENDED = "def main():\n    if c.A and c.B:\n        out(y[1])\n    if True:\n        end()\n"
HEAD = "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment\n"
MINE = "mine, and no business of a build\n"


@pytest.fixture(autouse=True)
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A repository to work in, beside a folder that is no part of it."""
    (tmp_path / "repository").mkdir()
    (tmp_path / "outside").mkdir()
    monkeypatch.chdir(tmp_path / "repository")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setenv("LOCALAPPDATA", str(tmp_path / "cache"))
    Path("prog.py").write_text(GOOD)
    return tmp_path


def outside(place: Path) -> dict[str, str]:
    return {path.name: path.read_text() for path in (place / "outside").iterdir()}


# -- the cache --------------------------------------------------------------------------------------------------------


def entries() -> list[Path]:
    return sorted(Path(".clickgen_cache").glob("*.json"))


def check(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str]:
    code = main(["check", "--output-format", "concise", *arguments])
    return code, capsys.readouterr().out


def test_findings_that_somebody_took_out_of_the_cache_are_found_again(capsys: pytest.CaptureFixture[str]) -> None:
    Path("prog.py").write_text(DOUBLE)
    told = check(capsys, "prog.py")
    assert told[0] == 1
    (entry,) = entries()
    forged = {**json.loads(entry.read_text()), "findings": []}
    entry.write_text(json.dumps(forged))
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
    from clickgen.commands.check.cache import _mark

    Path("prog.py").write_text(MENDED)
    (place / "outside" / "other.py").write_text(MINE)
    Path("other.py").write_text(MINE)
    main(["check", "prog.py"])
    (entry,) = entries()
    tree = json.loads(entry.read_text())
    key = secret.user_secret(Path.cwd())
    assert key is not None
    for other in (str(place / "outside" / "other.py"), "other.py"):
        finding = next(finding for finding in tree["findings"] if finding[5])
        for edit in finding[5][0]:
            edit[0][0] = other
        del tree["mark"]
        tree["mark"] = _mark({name: value for name, value in tree.items() if name != "mark"}, key)
        entry.write_text(json.dumps(tree))
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


# -- links ------------------------------------------------------------------------------------------------------------


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


# -- what is not ours -------------------------------------------------------------------------------------------------


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
    """Not even where the map knows a routine of its name with as many rungs."""
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
    """Git changes them on Windows."""
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


# -- reading ----------------------------------------------------------------------------------------------------------


def test_a_file_is_read_up_to_a_limit(tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes(b"12345")
    assert read_file(tmp_path / "file", 5) == b"12345"
    with pytest.raises(OSError, match="more than 0 MB") as caught:
        read_file(tmp_path / "file", 4)
    assert caught.value.filename == str(tmp_path / "file")
    with pytest.raises(IsADirectoryError):
        read_file(tmp_path)
    with pytest.raises(FileNotFoundError):
        read_file(tmp_path / "none")


def endless(path: Path) -> None:
    path.symlink_to("/dev/zero")


def silent(path: Path) -> None:
    os.mkfifo(path)


@posix_only
@pytest.mark.parametrize("kind", [endless, silent])
@pytest.mark.parametrize(
    ("name", "command"),
    [
        ("trap.py", "build trap.py"),
        ("trap.py", "check trap.py"),
        ("part.py", "build user.py"),
        ("part.py", "check user.py"),
        ("part.py", "check ."),
        ("nicknames.csv", "build prog.py"),
        ("nicknames.csv", "check prog.py"),
        ("nicknames.csv", "nicknames sync prog.py"),
        ("nicknames.csv", "stubs prog.py"),
        ("nicknames.placed", "build prog.py"),
        ("nicknames.placed", "nicknames rename Start Begin prog.py"),
        ("trap.xlsx", "build prog.py --nicknames trap.xlsx"),
        (OWN_FILE, "check prog.py --config clickgen.toml"),
        ("known.json", "check prog.py --baseline known.json"),
        ("export.csv", "nicknames merge export.csv"),
        ("build/prog/sources.json", "build prog.py"),
        ("build/prog/main.csv", "build prog.py"),
        ("build/prog/main.csv", "diff prog.py build/prog"),
        ("build/prog/subroutines/wash.csv", "import build/prog -o new.py"),
        ("build/prog/sources.json", "import build/prog -o new.py"),
        ("build/prog/prog.xlsx", "workbook prog.py"),
        ("__builtins__.pyi", "stubs prog.py"),
        ("trap.tmp", "diff trap.tmp prog.py"),
    ],
)
def test_devices_and_pipes_are_not_read(
    name: str, command: str, kind: Callable[[Path], None], capfd: pytest.CaptureFixture[str]
) -> None:
    """Every command comes to its end; whether it refuses or does without is its own affair."""
    Path("user.py").write_text(f"from part import fill\n\n\n{GOOD}")
    Path("build/prog").mkdir(parents=True)
    if name != "build/prog/main.csv":
        main(["build", "prog.py"])
    path = Path(name)
    path.parent.mkdir(exist_ok=True)
    path.unlink(missing_ok=True)
    kind(path)
    with ends():
        code = main(command.split())
    said = capfd.readouterr().err
    assert code in (0, 1, 2)
    assert "internal error" not in said
    assert "Traceback" not in said


@contextlib.contextmanager
def ends() -> Iterator[None]:
    """Break off what waits for a pipe for ever, so that the test fails instead of never ending."""

    def alarmed(*_: object) -> None:
        raise AssertionError("it waits for ever")

    before = signal.signal(signal.SIGALRM, alarmed)
    signal.alarm(120)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


@posix_only
@pytest.mark.parametrize(
    ("name", "command"),
    [
        (OWN_FILE, "build prog.py"),
        (OWN_FILE, "check"),
        ("pyproject.toml", "build prog.py"),
        ("nicknames.csv", "build prog.py"),
        ("nicknames.csv", "check prog.py"),
        ("nicknames.csv", "import drawn/main.csv -o prog2.py"),
        ("scr/Scr1.tmp", "import scr -o new.py"),
        ("drawn/nicknames.csv", "import drawn -o new.py"),
        ("drawn/subroutines/one.csv", "import drawn -o new.py"),
    ],
)
def test_a_pipe_in_the_place_of_a_file_is_named(name: str, command: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["build", "prog.py", "-o", "drawn"]) == 0
    Path(name).parent.mkdir(parents=True, exist_ok=True)
    Path(name).unlink(missing_ok=True)
    silent(Path(name))
    capsys.readouterr()
    assert main(command.split()) == 2
    said = capsys.readouterr().err
    assert name in said
    assert "a pipe or a device" in said


@pytest.mark.parametrize("words", [["build", "\0"], ["check", "a\0.py"], ["build", "prog.py", "-o", "\0"], ["\0"]])
def test_a_nul_in_an_argument_is_a_mistake_of_use(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(words) == 2
    assert capsys.readouterr().err == "clickgen: an argument holds a NUL character, which no file name can have\n"


@posix_only
def test_a_link_is_told_from_what_is_reached_by_one(tmp_path: Path) -> None:
    (tmp_path / "real").mkdir()
    (tmp_path / "real" / "file").write_text("")
    (tmp_path / "way").symlink_to("real")
    (tmp_path / "file").symlink_to("real/file")
    assert leads_elsewhere(tmp_path / "file")
    assert leads_elsewhere(tmp_path / "way")
    assert not leads_elsewhere(tmp_path / "way" / "file")
    assert not leads_elsewhere(tmp_path / "way" / "none")
    assert not leads_elsewhere(tmp_path / "way" / "..")


# -- git --------------------------------------------------------------------------------------------------------------


def git(*words: str) -> str:
    if not shutil.which("git"):
        pytest.skip("there is no git")
    who = ("-c", "user.name=a", "-c", "user.email=a@example.com")
    return subprocess.run(["git", *who, *words], check=True, capture_output=True, encoding="utf-8").stdout.strip()


@pytest.fixture
def marker(place: Path) -> Path:
    """A program that leaves a trace when it is started."""
    program = place / "program"
    program.write_text(f"#!/bin/sh\ntouch {place}/started\nexit 1\n")
    program.chmod(0o755)
    git("init", "--quiet")
    git("add", "prog.py")
    git("commit", "--quiet", "-m", "first")
    return program


@posix_only
@pytest.mark.parametrize("side", [":prog.py", "HEAD:prog.py"])
def test_git_starts_no_monitor_pager_or_hook(side: str, marker: Path, place: Path) -> None:
    for name in ("core.fsmonitor", "core.pager", "pager.ls-files", "diff.external", "core.editor"):
        git("config", name, str(marker))
    hooks = place / "hooks"
    hooks.mkdir()
    for name in ("post-index-change", "post-checkout", "reference-transaction", "fsmonitor-watchman"):
        (hooks / name).symlink_to(marker)
    git("config", "core.hooksPath", str(hooks))
    (place / "started").unlink(missing_ok=True)
    assert main(["diff", side, "prog.py"]) == 0
    assert not (place / "started").exists()


@posix_only
@pytest.mark.parametrize("way", ["ext", "ssh", "upload", "helper", "credential"])
def test_git_fetches_nothing(way: str, marker: Path, place: Path, capsys: pytest.CaptureFixture[str]) -> None:
    blob = git("rev-parse", "HEAD:prog.py")
    Path(".git/objects", blob[:2], blob[2:]).unlink()
    urls = {"ext": f"ext::{marker}", "ssh": "ssh://localhost/r", "helper": "x", "credential": "https://localhost:1/r"}
    for name, value in {
        "core.repositoryFormatVersion": "1",
        "extensions.partialClone": "origin",
        "remote.origin.promisor": "true",
        "remote.origin.url": urls.get(way, str(place / "repository")),
        "remote.origin.uploadpack": str(marker),
        "protocol.ext.allow": "always",
        "protocol.ssh.allow": "always",
        "protocol.file.allow": "always",
        "core.sshCommand": str(marker),
        "credential.helper": str(marker),
    }.items():
        git("config", name, value)
    assert main(["diff", "HEAD:prog.py", "prog.py"]) == 2
    assert "clickgen downloads nothing" in capsys.readouterr().err
    assert not (place / "started").exists()


@posix_only
def test_git_is_not_taken_from_the_working_folder(marker: Path, place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    Path("git").symlink_to(marker)
    monkeypatch.setenv("PATH", os.pathsep.join(("", ".", os.environ["PATH"])))
    assert main(["diff", "HEAD:prog.py", "prog.py"]) == 0
    assert not (place / "started").exists()


# -- modules of the repository ----------------------------------------------------------------------------------------

SHADOWS = ("argparse", "json", "queue", "pickle", "concurrent", "multiprocessing", "regex", "lxml", "numpy")


@pytest.fixture
def shadowed(place: Path) -> list[str]:
    """Files with the names of modules, which leave a trace when they are run; and programs for several processes."""
    for name in SHADOWS:
        Path(f"{name}.py").write_text(f"open({str(place / 'started')!r}, 'w')\n")
    names = [f"p{number}.py" for number in range(5)]
    for name in names:
        Path(name).write_text(
            'def main():\n    if x[1]:\n        calc("ds.A + 1", ds.A)\n    if True:\n        end()\n'
        )
    return names


@pytest.mark.parametrize("flags", [("-I", "-m"), ("-P", "-m"), ("-m",)], ids=" ".join)
def test_no_module_of_the_working_folder_is_run(flags: tuple[str, ...], shadowed: list[str], place: Path) -> None:
    done = subprocess.run(
        [sys.executable, *flags, "clickgen", "check", "--no-cache", *shadowed], capture_output=True, encoding="utf-8"
    )
    assert done.returncode == 0, done.stderr
    assert not (place / "started").exists()


@pytest.mark.parametrize("method", get_all_start_methods())
def test_no_process_of_a_check_runs_a_module_of_the_working_folder(
    method: str, shadowed: list[str], place: Path
) -> None:
    program = place / "outside" / "run.py"
    program.write_text(
        "import multiprocessing, os, sys\n"
        "if __name__ == '__main__':\n"
        "    multiprocessing.set_start_method(sys.argv.pop(1))\n"
        "    os.cpu_count = lambda: 2\n"
        "    from clickgen.cli import run\n"
        "    run()\n"
    )
    done = subprocess.run(
        [sys.executable, str(program), method, "check", "--no-cache", *shadowed], capture_output=True, encoding="utf-8"
    )
    assert done.returncode == 0, done.stderr
    assert not (place / "started").exists()


# -- names ------------------------------------------------------------------------------------------------------------

FORGED = "p\n::error::forged\r\n::add-mask::x\x1b[31m\u202e\x9b.py"


@posix_only
@pytest.mark.parametrize("content", [DOUBLE, MENDED, GOOD], ids=["a warning", "an error", "nothing"])
@pytest.mark.parametrize(
    "arguments",
    [
        ("check",),
        ("check", "--diff"),
        ("check", "--statistics"),
        *(
            ("check", "--output-format", name)
            for name in ("text", "concise", "json", "junit", "gitlab", "sarif", "github")
        ),
        ("build",),
        ("build", "-o"),
        ("workbook",),
        ("import", "-o", "new.py"),
        ("nicknames", "sync"),
        ("nicknames", "check"),
        ("nicknames", "why", "A"),
        ("nicknames", "rename", "A", "Other"),
        ("nicknames", "rename", "Nothing", "Other"),
        ("stubs",),
        ("diff", "prog.py"),
        ("diff", "--output-format", "json", "prog.py"),
        ("check", "--config"),
        ("check", "--baseline"),
        ("check", "--output-format"),
    ],
    ids=" ".join,
)
def test_a_file_name_forges_no_line(
    arguments: tuple[str, ...], content: str, capfd: pytest.CaptureFixture[str]
) -> None:
    Path(FORGED).write_text(content)
    with contextlib.suppress(SystemExit):
        main([*arguments, FORGED])
    out, err = capfd.readouterr()
    for line in (out + err).replace("\r", "\n").split("\n"):
        start = line.strip()
        if not ("github" in arguments and start.startswith("::warning file=")):
            assert not start.startswith(("::add-mask", "::error::forged"))
    if "github" not in arguments:
        assert not {"\x1b", "\x9b", "\u202e"} & {*out, *err}


def test_a_missing_file_forges_no_line(capsys: pytest.CaptureFixture[str]) -> None:
    for command in ("build", "check", "diff prog.py", "import -o new.py", "nicknames sync", "nicknames merge"):
        assert main([*command.split(), "none\n::error::x\x1b"]) == 2
        assert "\n::" not in capsys.readouterr().err


def test_a_log_command_in_a_line_of_source_is_none(capsys: pytest.CaptureFixture[str]) -> None:
    Path("prog.py").write_text(MENDED.replace("c.B:", "c.B:  # ##[add-mask]x ##vso[task.complete]"))
    assert main(["check", "prog.py"]) == 1
    said = capsys.readouterr().out
    assert "##[" not in said
    assert "##vso[" not in said
