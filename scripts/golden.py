"""Write the build of every case of ``fixtures/cases`` into its ``expected`` folder. Read the diff before you commit it.

Without arguments every case; else the named ones.
"""

from __future__ import annotations

import shutil
import sys
import tempfile
from pathlib import Path

import clickgen
from clickgen.problems.diagnostics import Diagnostic

CASES = Path(__file__).parents[1] / "fixtures" / "cases"
PROGRAM, TABLE, EXPECTED = "prog.py", "nicknames.csv", "expected"


def names() -> list[str]:
    """Every case by the name of its folder."""
    return sorted(path.name for path in CASES.iterdir() if path.is_dir())


def lay_out(case: Path, folder: Path) -> Path:
    """Copy a program, its sibling files and its address table into ``folder``; return the program there."""
    for path in case.iterdir():
        if path.is_file():
            shutil.copyfile(path, folder / path.name)
    return folder / PROGRAM


def outputs(case: Path) -> dict[str, bytes]:
    """Return the build of a case, by the path in its ``expected`` folder: the files, the extended table, the messages.

    Raises ValueError if the program has errors.
    """
    with tempfile.TemporaryDirectory() as folder:
        result = clickgen.build(lay_out(case, Path(folder)))
    said = "".join(f"{_line(problem)}\n" for problem in result.diagnostics)
    if not result.ok:
        raise ValueError(f"{case.name} does not build:\n{said}")
    made = {name: text.encode() for name, text in result.files.items()}
    made[f"table/{TABLE}"] = result.table
    if said:
        made["diagnostics.txt"] = said.encode()
    return made


def _line(problem: Diagnostic) -> str:
    place = f"{problem.span.line}:{problem.span.col}" if problem.span else "-"
    return f"{problem.code} {place} {problem.message}"


def expected(case: Path) -> dict[str, bytes]:
    """The golden files of a case, by their path in its ``expected`` folder."""
    folder = case / EXPECTED
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def regenerate(case: Path) -> list[str]:
    """Rewrite the golden files of a case; return the names of those that changed."""
    new, old = outputs(case), expected(case)
    folder = case / EXPECTED
    for name in old.keys() - new.keys():
        (folder / name).unlink()
    for name, data in new.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data)
    for path in sorted(folder.rglob("*"), reverse=True):
        if path.is_dir() and not any(path.iterdir()):
            path.rmdir()
    return sorted(name for name in new.keys() | old.keys() if new.get(name) != old.get(name))


def main(arguments: list[str]) -> int:
    failed = 0
    for name in arguments or names():
        try:
            changed = regenerate(CASES / name)
        except (ValueError, OSError) as error:
            print(error, file=sys.stderr)
            failed += 1
            continue
        if changed:
            print(f"{name}: {', '.join(changed)}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
