"""``clickgen build``: a program into the folder that goes into CLICK."""

from __future__ import annotations

import sys
from pathlib import Path

from clickgen.cli import COULD_NOT_RUN, OK, PROBLEMS
from clickgen.cli.render import printable, summary, write_problems
from clickgen.emit.write import ChangedMeanwhile
from clickgen.pipeline import BuildResult, CouldNotRun, build
from clickgen.wording import counted


def run(program: str, output: str | None, nicknames: str | None, frozen: bool) -> int:
    """Build and write; returns the exit code."""
    folder = Path("build") / Path(program).stem if output is None else Path(output)
    try:
        if output == "":
            raise CouldNotRun("the output folder after -o is empty")
        result = build(program, nicknames=nicknames, frozen=frozen)
        write_problems(result.diagnostics, result.sources, sys.stderr)
        if not result.ok:
            print(f"clickgen: {summary(result.diagnostics)}; nothing was written", file=sys.stderr)
            return PROBLEMS
        result.write(folder)
    except (CouldNotRun, ChangedMeanwhile) as error:
        print(f"clickgen: {printable(str(error))}", file=sys.stderr)
        return COULD_NOT_RUN
    except OSError as error:
        place = f"{error.filename}: " if error.filename else ""
        print(f"clickgen: {printable(place)}{error.strerror or error}; nothing was written", file=sys.stderr)
        return COULD_NOT_RUN
    print(_report(result, folder))
    return OK


def _report(result: BuildResult, folder: Path) -> str:
    main, subroutines = result.main, result.subroutines
    counts = [f"{counted(len(main.rungs), 'rung')} in main"]
    if subroutines:
        rungs = sum(len(routine.rungs) for routine in subroutines)
        counts.append(f"{counted(rungs, 'rung')} in {counted(len(subroutines), 'subroutine')}")
    new = result.new_rows
    lines = [f"Built {result.program.name}: {', '.join(counts)}."]
    if new:
        lines.append(f"{counted(len(new), 'new address', 'new addresses')} in {result.table_path}: commit it.")
    noted = summary(result.diagnostics)
    if noted:
        lines.append(f"{noted[0].upper() + noted[1:]} above.")
    lines += [f"Files: {folder}", "Next:"]
    steps = [f"in CLICK: File > Import > Nicknames, {folder / 'nicknames.csv'}"]
    if subroutines:
        names = ", ".join(routine.name for routine in subroutines)
        steps.append(f"in CLICK: create {counted(len(subroutines), 'subroutine')} by hand, named {names}")
    steps.append(f"in ClickNick: Ladder > Open in Guided Paste, {folder}")
    lines += [f"  {number}. {step}" for number, step in enumerate(steps, 1)]
    return "\n".join(lines)
