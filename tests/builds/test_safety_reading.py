"""A repository laid out by somebody else cannot make clickgen read or run what it should not."""

from __future__ import annotations

import contextlib
import os
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from multiprocessing import get_all_start_methods
from pathlib import Path

import pytest
from hostile import DOUBLE, GOOD, MENDED, place, posix_only

from clickgen.cli import main
from clickgen.config import OWN_FILE
from clickgen.workspace import leads_elsewhere, read_file

__all__ = ["place"]


# -- reading -----------------------------------------------------------------------------------------------------------


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
    """Every command ends; it may refuse or do without."""
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
    """Break off a command that waits for a pipe for ever, so that the test fails instead of hanging."""

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


# -- git ---------------------------------------------------------------------------------------------------------------


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


# -- modules of the repository -----------------------------------------------------------------------------------------


SHADOWS = ("argparse", "json", "queue", "pickle", "concurrent", "multiprocessing", "regex", "lxml", "numpy")


@pytest.fixture
def shadowed(place: Path) -> list[str]:
    """Files with the names of modules, which leave a trace when run; and programs for several processes."""
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


# -- names -------------------------------------------------------------------------------------------------------------


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
