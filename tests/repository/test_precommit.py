"""The hooks of ``.pre-commit-hooks.yaml``, installed and run by pre-commit itself in a repository of a user."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

from clickgen.cli.parser import parse

PROJECT = Path(__file__).parents[2]
HOOKS = PROJECT / ".pre-commit-hooks.yaml"
PACKAGE = ("pyproject.toml", "README.md", "LICENSE", ".pre-commit-hooks.yaml", "clickgen", "grammar", "docs")
"""The files that installing from a clone needs."""

GOOD = """\
nickname(y.Door, y[1])


def main():
    if c.Open:
        out(y.Door)

    if True:
        end()
"""
TWICE = GOOD.replace("    if True:", "    if c.Bell:\n        out(y.Door)\n\n    if True:")
TABLE = """\
Address,Data Type,Nickname,Initial Value,Retentive,Address Comment
Y001,BIT,"Door",0,No,""
C1,BIT,"Open",0,No,""
C2,BIT,"Bell",0,No,""
"""
SETTINGS = """\
programs = ["plc/doors.py"]

[check]
exclude = ["plc/old"]
"""
CONFIG = """\
repos:
  - repo: {repo}
    rev: {rev}
    hooks:
      - id: clickgen-check
        files: ^plc/
      - id: clickgen-build
"""


def test_the_manifest_is_one() -> None:
    done = subprocess.run(
        [sys.executable, "-m", "pre_commit", "validate-manifest", HOOKS], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stdout


@pytest.mark.parametrize("hook", yaml.safe_load(HOOKS.read_text("utf-8")), ids=lambda hook: hook["id"])
def test_a_hook_runs_a_command_that_there_is(hook: dict[str, str], capsys: pytest.CaptureFixture[str]) -> None:
    command, *arguments = hook["entry"].split()
    assert command == "clickgen"
    with pytest.raises(SystemExit) as stop:
        parse([*arguments, "--help"])
    assert stop.value.code == 0
    assert set(arguments[1:]) <= set(re.findall(r"--[a-z-]+", capsys.readouterr().out))


class Repository:
    """A git repository in a folder, and pre-commit in it with a home of its own."""

    def __init__(self, folder: Path, home: Path) -> None:
        folder.mkdir(parents=True, exist_ok=True)
        self.folder = folder
        kept = {key: value for key, value in os.environ.items() if not key.startswith(("GIT_", "PRE_COMMIT", "PYTHON"))}
        self._environ = kept | {
            "PRE_COMMIT_HOME": str(home),
            "PIP_NO_COMPILE": "1",
            "GIT_CONFIG_GLOBAL": os.devnull,
            "GIT_CONFIG_NOSYSTEM": "1",
            "GIT_AUTHOR_NAME": "test",
            "GIT_AUTHOR_EMAIL": "test@example.org",
            "GIT_COMMITTER_NAME": "test",
            "GIT_COMMITTER_EMAIL": "test@example.org",
        }
        self.git("init", "--quiet")

    def git(self, *arguments: str) -> str:
        done = self._run("git", *arguments)
        assert done.returncode == 0, done.stdout
        return done.stdout.strip()

    def write(self, name: str, text: str) -> None:
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, "utf-8")
        self.git("add", name)

    def pre_commit(self, hook: str) -> subprocess.CompletedProcess[str]:
        return self._run(sys.executable, "-m", "pre_commit", "run", hook, "--all-files", "--verbose", "--color=never")

    def _run(self, *command: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            command,
            cwd=self.folder,
            env=self._environ,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            encoding="utf-8",
        )


@pytest.mark.skipif(not shutil.which("git"), reason="pre-commit works on git repositories, and there is no git")
def test_the_hooks_run_in_a_repository_of_a_user(tmp_path: Path) -> None:
    """One test, because installing the hooks takes most of its time."""
    home = tmp_path / "home"
    hooks = Repository(tmp_path / "clickgen", home)
    for name in PACKAGE:
        source = PROJECT / name
        if source.is_dir():
            shutil.copytree(source, hooks.folder / name, ignore=shutil.ignore_patterns("__pycache__"))
        else:
            shutil.copy(source, hooks.folder / name)
    hooks.git("add", ".")
    hooks.git("commit", "--quiet", "-m", "hooks")

    user = Repository(tmp_path / "user", home)
    repo = yaml.safe_dump(str(hooks.folder)).splitlines()[0]
    user.write(".pre-commit-config.yaml", CONFIG.format(repo=repo, rev=hooks.git("rev-parse", "HEAD")))
    user.write("clickgen.toml", SETTINGS)
    user.write("plc/doors.py", GOOD)
    user.write("plc/old/doors.py", TWICE)
    user.write("tools/other.py", "print('no CLICK program')\n")

    check = user.pre_commit("clickgen-check")
    assert check.returncode == 0, check.stdout
    assert "1 file checked" in check.stdout, "an excluded file is left out though it is named"

    frozen = user.pre_commit("clickgen-build")
    assert frozen.returncode == 1, frozen.stdout
    assert "CG209" in frozen.stdout
    assert not (user.folder / "build").exists()

    user.write("plc/nicknames.csv", TABLE)
    built = user.pre_commit("clickgen-build")
    assert built.returncode == 0, built.stdout
    assert (user.folder / "build" / "doors" / "main.csv").is_file()

    user.write("plc/doors.py", TWICE)
    again = user.pre_commit("clickgen-check")
    assert again.returncode == 1, again.stdout
    assert "plc/doors.py:9:9: warning[CG501]" in again.stdout.replace("\\", "/")
