"""Projects to rename in, for the tests of ``clickgen nicknames rename``."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

import pytest

from clickgen.commands.nicknames.rename import Rename, rename
from clickgen.config import Config, Settings
from clickgen.table.rows import HEADER
from clickgen.text.write import put_in_place
from clickgen.workspace import CouldNotRun


class Job(NamedTuple):
    program: str
    settings: Settings = Settings()


@pytest.fixture(autouse=True)
def _here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def again(old: str) -> str:
    """The other way out, for a new name that a program uses already."""
    return f"; where it already means {old}, write {old} there again: then this renames every place"


def place(files: Mapping[str, str | bytes]) -> None:
    for name, content in files.items():
        Path(name).parent.mkdir(parents=True, exist_ok=True)
        Path(name).write_bytes(content.encode() if isinstance(content, str) else content)


def table(*rows: str) -> str:
    return "".join(f"{line}\n" for line in (HEADER, *rows))


def main(*rungs: str) -> str:
    """A program of these rungs, each an ``if`` with one action after it."""
    return "def main():\n" + "".join(f"    {rung}\n" for rung in rungs) + "    if True:\n        end()\n"


def done(old: str, new: str, *programs: str, config: Config | None = None) -> Rename:
    """Rename and write."""
    change = rename(old, new, [Job(program) for program in programs or ("prog.py",)], config or Config(Path.cwd()))
    put_in_place(change.writes, (), change.unchanged)
    return change


def refused(old: str, new: str, *programs: str, config: Config | None = None) -> str:
    """The reason why a rename is refused; every file is unchanged."""
    before = {path: path.read_bytes() for path in Path().rglob("*") if path.is_file()}
    with pytest.raises(CouldNotRun) as caught:
        done(old, new, *programs, config=config)
    assert {path: path.read_bytes() for path in Path().rglob("*") if path.is_file()} == before
    return str(caught.value)


def text(name: str = "prog.py") -> str:
    return Path(name).read_bytes().decode()


OLD_ROW = 'C5,BIT,"Old",0,No,"Old words"'


EVERYWHERE = '''\
# Old: a comment, and oldest.
nickname(ds.Other, ds[9], comment="Old stays")


@sub
def Old():
    """Old"""
    if ds.§ == 3:  # Old
        copy(ds[ds.§], dd[ds.§])
        copy(5, ds [ "§" ])
    if all(ds . § > 1, ds.Older == 1, any(ds["§"] < 4, 5 == ds[r'§'])):
        calc("ds.§ + ds.§ * ds[ds.§] - ds['§']", ds.§)
        calc('SUM(ds[1:4]) + ds["§"] + ds . § + ds.Older', ds.Result)
        calc("ds.§"  # Old
             ' + 1 + ' "ds.§ - 1", ds["§" ""])
        copy("Old", txt[1])
        for _ in range(ds.§):
            if nc(c.Bit):
                out(c.Oldest)
    if True:
        return


def main():
    if c.Bit:
        call(Old)
    if c.Bit2:
        call("Old")
        ctu(ct.Count, setpoint=ds.§, reset=lambda: ds.§ == 4)
        search(">=", ds.§, ds[100], ds[200], ds.§, c.Found)
    if True:
        event_drum(outputs=[y[1]], events=[c.Bit], pattern=[[1]], current_step=ds.§,
                   completion_flag=c.Flag).reset(ds.§ == 1).jump(c.Skip, step=ds.§)
        end()
'''
