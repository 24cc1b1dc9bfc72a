"""``clickgen stubs``: the language and the names of programs, in files that editors look for."""

from __future__ import annotations

import argparse
import os
import shlex
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

from clickgen.api import known_names
from clickgen.cli import OK, PROBLEMS, complain, tell
from clickgen.cli.jobs import Job, Run, near
from clickgen.commands.stubs.stub import MARK, builtins_stub
from clickgen.dialects.discover import targets
from clickgen.results import KnownNames
from clickgen.text.wording import counted
from clickgen.text.write import put_in_place
from clickgen.workspace import CouldNotRun, Workspace

STUB_NAME = "__builtins__.pyi"
"""Pyright takes this file for names that are known everywhere in its folder."""

DESCRIPTION = (
    "Write __builtins__.pyi beside programs: the language and their nicknames, for editors with pyright in them."
)
EXAMPLES = """\
examples:
  clickgen stubs                      for every program that the settings name
  clickgen stubs prog.py
  clickgen stubs --check              in CI: fail where a stub file is stale

exit codes: 0 written, or nothing to do; 1 stale; 2 could not run
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("programs", metavar="PROG.py", nargs="*", help="the programs (default: every configured one)")
    add("--nicknames", metavar="TABLE", help="the address table (default: nicknames.csv beside the program)")
    add("--frozen", action="store_true", help="only names that have an address: a new one may be a misspelling")
    add("--check", action="store_true", help="write nothing; fail where a file is stale")
    add("--config", metavar="FILE", help="the settings: clickgen.toml or pyproject.toml")


def run(options: argparse.Namespace) -> int:
    """Write the stub file of every folder with a program, or say which are stale; return the exit code."""
    programs, nicknames, frozen, config = options.programs, options.nicknames, options.frozen, options.config
    this = Run(config)
    named = this.jobs(programs, nicknames, frozen)
    if not options.check:
        this.settle(named)
    names = _names([*named, *_beside(named, frozen, this)], this.files)
    stubs = {near(folder / STUB_NAME): _stub(found) for folder, found in names.items()}
    stale = {path: text for path, text in stubs.items() if _is_stale(path, text, this.files)}
    if options.check:
        return _say_stale(stale, _command(programs, nicknames, frozen, config))
    put_in_place(stale, no_links=stale)
    for path in stubs:
        tell(f"{path}: {'written' if path in stale else 'nothing has changed'}")
    return OK


def _beside(found: Sequence[Job], frozen: bool, this: Run) -> list[Job]:
    """The other programs of the same folders: they share the file."""
    folders = sorted({os.path.dirname(os.path.abspath(job.program)) for job in found})
    known = {os.path.realpath(job.program) for job in found}
    others = [
        target.path
        for target in targets([str(near(Path(folder))) for folder in folders], this.settings, workspace=this.files)
        if os.path.dirname(os.path.abspath(target.path)) in folders and os.path.realpath(target.path) not in known
        if not target.is_part
    ]
    return this.jobs(others, None, frozen) if others else []


def _names(found: Sequence[Job], files: Workspace) -> dict[Path, list[KnownNames]]:
    """The names of every program by its folder; each is resolved with the table that those before it leave."""
    names: dict[Path, list[KnownNames]] = {}
    tables: dict[str, bytes] = {}
    for job in found:
        known = known_names(job.program, job.settings, files.apart(tables))
        tables[os.path.realpath(known.table_path)] = known.table
        names.setdefault(Path(job.program).parent.absolute(), []).append(known)
        _say_errors(job.program, known)
    return names


def _say_errors(program: str, known: KnownNames) -> None:
    errors = sum(problem.is_error for problem in known.diagnostics)
    if errors:
        said = f"{program} has {counted(errors, 'error')}, so some of its names may be missing"
        complain(f"{said}; see clickgen check {program}")


def _stub(names: Sequence[KnownNames]) -> bytes:
    rows = [row for known in names for row in known.rows]
    return builtins_stub(rows, [block for known in names for block in known.blocks]).encode()


def _is_stale(path: Path, text: bytes, files: Workspace) -> bool:
    """True if a file is missing or differs. Raises CouldNotRun if it is not clickgen's."""
    try:
        stands = files.read(path).replace(b"\r\n", b"\n")
    except FileNotFoundError:
        return True
    if not stands.startswith(MARK.encode()):
        raise CouldNotRun(f"{path} was not made by clickgen stubs: move it away, then run again")
    return stands != text


def _say_stale(stale: Mapping[Path, bytes], command: str) -> int:
    for path in stale:
        tell(f"{path} is {'stale' if path.exists() else 'missing'}", file=sys.stderr)
    if not stale:
        return OK
    complain(f"run {command} and commit what it writes")
    return PROBLEMS


def _command(programs: Sequence[str], nicknames: str | None, frozen: bool, config: str | None) -> str:
    """The command that writes the checked files."""
    words = ["clickgen", "stubs", *programs]
    words += ["--nicknames", nicknames] if nicknames else []
    words += ["--frozen"] if frozen else []
    words += ["--config", config] if config else []
    return shlex.join(words)
