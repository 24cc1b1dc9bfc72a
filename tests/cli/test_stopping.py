"""A command that is stopped, or that nobody listens to: its exit code, its messages, and what is left."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

from clickgen.cli import main
from clickgen.cli.jobs import Job
from clickgen.commands.nicknames.elsewhere import build_among
from clickgen.config import Config
from clickgen.results import BuildResult
from clickgen.workspace import CouldNotRun, Workspace

pytestmark = pytest.mark.skipif(os.name != "posix", reason="about signals and pipes of POSIX")

GOOD = "def main():\n    if c.Start:\n        out(y[1])\n    if True:\n        end()\n"
COMMAND = [sys.executable, "-m", "clickgen"]


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    Path("prog.py").write_text(GOOD)
    return tmp_path


def stopping(folder: Path, where: str, number: int) -> subprocess.CompletedProcess[str]:
    """A build that gets a signal when a function is called for the first time."""
    module = where.rpartition(".")[0]
    program = folder / "run.py"
    program.write_text(
        f"import os, sys, {module}\n"
        f"really = {where}\n"
        "def stopped(*arguments, **named):\n"
        f"    {where} = really\n"
        f"    os.kill(os.getpid(), {number})\n"
        "    return really(*arguments, **named)\n"
        f"{where} = stopped\n"
        "from clickgen.cli import run\n"
        "sys.argv = ['clickgen', 'build', 'prog.py']\n"
        "run()\n"
    )
    return subprocess.run([sys.executable, str(program)], capture_output=True, encoding="utf-8", timeout=120)


SIGNALS = [(signal.SIGINT, 130, "interrupted"), (signal.SIGTERM, 143, "terminated")]


@pytest.mark.parametrize(("number", "code", "word"), SIGNALS, ids=["Ctrl-C", "SIGTERM"])
@pytest.mark.parametrize(
    ("where", "said"),
    [
        ("gc.disable", "nothing was written"),
        ("clickgen.cli.parser.parse", "nothing was written"),
        ("clickgen.pipeline.resolve", "nothing was written"),
        ("clickgen.text.write._write", "nothing was written"),
        ("os.link", "already written: "),
        ("clickgen.cli.build._report", "already written: "),
    ],
)
def test_what_is_said_of_an_interrupt_is_true(
    where: str, said: str, number: int, code: int, word: str, folder: Path
) -> None:
    if where == "os.link":
        assert main(["build", "prog.py"]) == 0
        Path("prog.py").write_text(GOOD.replace("y[1]", "y[2]"))
    before = Path("build/prog/main.csv").read_text() if where == "os.link" else ""
    done = stopping(folder, where, number)
    assert done.returncode == code, done.stderr
    assert done.stderr.startswith(f"clickgen: {word}; {said}")
    assert "Traceback" not in done.stderr
    if said == "nothing was written":
        assert sorted(path.name for path in folder.iterdir()) == ["prog.py", "run.py"]
    else:
        assert Path("build/prog/main.csv").read_text() != before
        assert Path("build/prog/sources.json").is_file()
    assert not list(folder.rglob(".clickgen-*"))


@pytest.mark.parametrize(("number", "code", "word"), SIGNALS, ids=["Ctrl-C", "SIGTERM"])
def test_an_interrupt_while_modules_are_loaded_shows_no_traceback(number: int, code: int, word: str) -> None:
    program = (
        "import builtins, os\n"
        "really = builtins.__import__\n"
        "def loading(name, *arguments):\n"
        "    if name == 'clickgen.cli':\n"
        f"        os.kill(os.getpid(), {number})\n"
        "    return really(name, *arguments)\n"
        "builtins.__import__ = loading\n"
        "import clickgen.start\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, encoding="utf-8")
    assert (done.returncode, done.stderr) == (code, f"clickgen: {word}; nothing was written\n")


def test_an_interrupt_after_all_is_written_says_so(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("clickgen.text.write.written", [])
    monkeypatch.setattr("clickgen.cli.build._report", interrupted)
    assert main(["build", "prog.py"]) == 130
    assert capsys.readouterr().err.startswith("clickgen: interrupted; already written: build/prog/main.csv, ")


@pytest.mark.parametrize("program", ["prog.py", "none.py"])
@pytest.mark.parametrize("unbuffered", ["", "1"])
def test_a_reader_that_goes_away_changes_no_exit_code(program: str, unbuffered: str) -> None:
    read, write = os.pipe()
    os.close(read)
    environment = {**os.environ, "PYTHONUNBUFFERED": unbuffered}
    done = subprocess.run([*COMMAND, "build", program], stdout=write, stderr=subprocess.PIPE, env=environment)
    os.close(write)
    assert done.returncode == (0 if program == "prog.py" else 2)
    assert done.stderr == (b"" if program == "prog.py" else b"clickgen: there is no file none.py\n")


@pytest.mark.parametrize("command", ["build prog.py", "check", "check -", "import x.csv -o x.py", "diff a b"])
def test_a_working_folder_that_is_gone_is_named(
    command: str, folder: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (folder / "gone").mkdir()
    monkeypatch.chdir(folder / "gone")
    (folder / "gone").rmdir()
    assert main(command.split()) == 2
    assert capsys.readouterr().err == "clickgen: the working folder is not there any more; nothing was written\n"


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="there is no full disk here")
def test_a_standard_error_that_takes_nothing_changes_no_exit_code() -> None:
    Path("bad.py").write_text("def main():\n    if c.A and c.B:\n        out(c.C)\n")
    with open("/dev/full", "w") as full:
        for arguments, code in (
            (["build", "prog.py"], 0),
            (["build", "bad.py"], 1),
            (["build", "none.py"], 2),
            ([], 2),
        ):
            done = subprocess.run([*COMMAND, *arguments], stderr=full, stdout=subprocess.PIPE)
            assert done.returncode == code
        done = subprocess.run([*COMMAND, "check", "prog.py"], stdout=full, stderr=subprocess.PIPE)
    assert done.returncode == 2
    assert done.stderr.startswith(b"clickgen: the output could not be shown: ")


def test_no_word_of_a_signal_that_is_ignored() -> None:
    """A shell that starts a command in the background lets it ignore Ctrl-C."""
    program = (
        "import signal\n"
        "signal.signal(signal.SIGINT, signal.SIG_IGN)\n"
        "import clickgen.start\n"
        "from clickgen.cli import _signals\n"
        "_signals.take()\n"
        "assert signal.getsignal(signal.SIGINT) == signal.SIG_IGN\n"
        "assert signal.getsignal(signal.SIGTERM) == _signals._stop\n"
    )
    subprocess.run([sys.executable, "-c", program], check=True)


# -- several processes ------------------------------------------------------------------------------------------------


def busy(folder: Path, what: str) -> list[str]:
    """A check whose two processes do something other than judge."""
    for number in range(6):
        Path(f"p{number}.py").write_text(GOOD)
    program = folder / "run.py"
    program.write_text(
        "import os, signal, sys, time\n"
        "os.cpu_count = lambda: 2\n"
        "import clickgen.commands.check.judging as module\n"
        "def judge(*_):\n"
        f"    {what}\n"
        "module.judge = judge\n"
        "if __name__ == '__main__':\n"
        "    import multiprocessing\n"
        "    multiprocessing.set_start_method('fork')\n"
        "    from clickgen.cli import run\n"
        "    sys.argv = ['clickgen', 'check', '--no-cache', *(f'p{n}.py' for n in range(6))]\n"
        "    run()\n"
    )
    return [sys.executable, str(program)]


@pytest.mark.parametrize(
    ("number", "code"), [(signal.SIGTERM, 143), (signal.SIGINT, 130), (signal.SIGKILL, -9)], ids=["TERM", "INT", "KILL"]
)
def test_no_process_outlives_the_one_that_started_it(number: int, code: int, folder: Path) -> None:
    command = busy(folder, "open(f'{os.getpid()}.pid', 'w').close(); time.sleep(60)")
    with subprocess.Popen(command, stderr=subprocess.PIPE) as process:
        _wait_for(folder, 2)
        process.send_signal(number)
        assert process.wait(60) == code
        assert process.stderr is not None
        # The pipe ends with the last process that holds it.
        said = process.stderr.read().decode()
    assert "Traceback" not in said
    if number != signal.SIGKILL:
        assert said.startswith("clickgen: ")


def _wait_for(folder: Path, count: int) -> None:
    for _ in range(6000):
        if len(list(folder.glob("*.pid"))) >= count:
            return
        time.sleep(0.01)
    raise AssertionError("the processes did not come")


def test_a_process_that_is_killed_is_told(folder: Path) -> None:
    done = subprocess.run(
        busy(folder, "os.kill(os.getpid(), signal.SIGKILL)"), capture_output=True, encoding="utf-8", timeout=120
    )
    assert done.returncode == 2
    assert done.stderr.startswith("clickgen: a process of the check was killed")


# -- builds at the same time ------------------------------------------------------------------------------------------


def test_builds_at_the_same_time_lose_nothing(folder: Path) -> None:
    processes = []
    for number in range(6):
        Path(f"p{number}.py").write_text(GOOD.replace("Start", f"Start{number}"))
        processes.append(subprocess.Popen([*COMMAND, "build", f"p{number}.py"], stdout=subprocess.DEVNULL))
    assert [process.wait() for process in processes] == [0] * 6
    table = Path("nicknames.csv").read_text()
    assert [number for number in range(6) if f'"Start{number}"' not in table] == []
    assert not list(folder.rglob(".clickgen-*"))


def test_a_table_that_changes_during_a_build_is_read_again(monkeypatch: pytest.MonkeyPatch) -> None:
    assert main(["build", "prog.py"]) == 0
    calls = 0

    def changing(jobs: Sequence[Job], config: Callable[[], Config], files: Workspace) -> list[BuildResult]:
        nonlocal calls
        calls += 1
        results = build_among(jobs, config, files)
        if calls <= 2:
            with open("nicknames.csv", "a") as table:
                table.write(f'C{100 + calls},BIT,"Mine{calls}",0,No,""\n')
        return results

    monkeypatch.setattr("clickgen.cli.build.build_among", changing)
    Path("prog.py").write_text(GOOD.replace("Start", "Begin"))
    assert main(["build", "prog.py"]) == 0
    assert calls == 3
    table = Path("nicknames.csv").read_text()
    assert all(name in table for name in ("Begin", "Mine1", "Mine2"))


def test_a_table_that_changes_all_the_time_is_told(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from clickgen.text.write import ChangedMeanwhile

    def changed(_: object) -> None:
        raise ChangedMeanwhile(Path("nicknames.csv"))

    monkeypatch.setattr("clickgen.cli.build.write_all", changed)
    assert main(["build", "prog.py"]) == 2
    assert capsys.readouterr().err == "clickgen: nicknames.csv was changed by someone else in the meantime; run again\n"
    assert issubclass(ChangedMeanwhile, CouldNotRun)


@pytest.mark.parametrize(
    ("moment", "how"), [("link", "in place"), ("link", "by renaming"), ("replace", "in place")], ids=" ".join
)
def test_what_an_editor_saves_while_files_are_replaced_stays(
    moment: str, how: str, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The only gap is a rename between the last look and the replacement."""
    from clickgen.text.write import ChangedMeanwhile, put_in_place

    table = folder / "nicknames.csv"
    table.write_bytes(b"read")
    really, is_saved = getattr(os, moment), False

    def saved(*arguments: str) -> None:
        nonlocal is_saved
        if not is_saved and how == "in place":
            table.write_bytes(b"saved")
        elif not is_saved:
            (folder / "new").write_bytes(b"saved")
            os.rename(folder / "new", table)
        is_saved = True
        really(*arguments)

    monkeypatch.setattr(os, moment, saved)
    with pytest.raises(ChangedMeanwhile):
        put_in_place({table: b"built", folder / "other": b"new"}, (), {table: b"read"})
    assert table.read_bytes() == b"saved"
    assert not (folder / "other").exists()


# -- a rename that was killed -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("at", [1, 2, 3])
def test_a_rename_that_was_killed_can_be_run_again(at: int, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["build", "prog.py"]) == 0
    before = {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()}
    child = os.fork()
    if not child:
        calls = 0
        really = os.replace

        def replace(*arguments: str) -> None:
            nonlocal calls
            really(*arguments)
            calls += 1
            if calls == at:
                os._exit(9)

        setattr(os, "replace", replace)  # noqa: B010 - it is another function for mypy
        main(["nicknames", "rename", "Start", "Begin", "prog.py"])
        os._exit(0)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 9
    assert before != {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()}
    capsys.readouterr()
    assert main(["nicknames", "rename", "Start", "Begin", "prog.py"]) == 0
    assert "is again as it was before a command that was stopped" in capsys.readouterr().err
    for name in ("prog.py", "nicknames.csv", "nicknames.placed"):
        assert "Begin" in Path(name).read_text()
        assert "Start" not in Path(name).read_text()
    assert not list(folder.rglob(".clickgen-*"))
