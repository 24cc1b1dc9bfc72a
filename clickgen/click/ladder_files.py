"""The ladder files that routines go into, each within CLICK's limits."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from clickgen.device.limits import ROWS_AND_RUNGS_MAX, RUNGS_MAX
from clickgen.problems.diagnostics import Diagnostics

if TYPE_CHECKING:
    from clickgen.lower.split import ClickRoutine, ClickRung


def ladder_files(routines: Iterable[ClickRoutine], problems: Diagnostics) -> dict[str, tuple[ClickRung, ...]]:
    """The rungs of each file, by its path in the output folder. Main may take several files, a subroutine one."""
    files: dict[str, tuple[ClickRung, ...]] = {}
    for routine in routines:
        parts = list(_within_limits(routine.rungs))
        if len(parts) > 1 and not routine.is_main:
            problems.add(
                "CG415",
                routine.span,
                f"{routine.name} has {len(routine.rungs)} CLICK rungs; one file holds {RUNGS_MAX} rungs and "
                f"{ROWS_AND_RUNGS_MAX} rows with rungs counted in",
                "divide it into two subroutines and call both",
            )
        elif len(parts) > 1:
            problems.add(
                "CG424",
                routine.span,
                f"main has {len(routine.rungs)} CLICK rungs and goes into {len(parts)} ladder files",
                "paste them one after the other, in the order of their names",
            )
        # ClickNick pastes main's parts sorted by name (click-facts [ladder-file.guided]): all numbers have as many
        # digits.
        digits = len(str(len(parts)))
        for number, part in enumerate(parts, 1):
            stem = "main" if routine.is_main else f"subroutines/{routine.name}"
            files[f"{stem}_{number:0{digits}}.csv" if number > 1 else f"{stem}.csv"] = part
    return files


def _within_limits(rungs: tuple[ClickRung, ...]) -> Iterator[tuple[ClickRung, ...]]:
    """Stretches of rungs that one clipboard buffer takes (click-facts [limit.file, limit.rows])."""
    start = size = 0
    for index, rung in enumerate(rungs):
        cost = len(rung.grid) + 1
        if index - start == RUNGS_MAX or size + cost > ROWS_AND_RUNGS_MAX:
            yield rungs[start:index]
            start, size = index, 0
        size += cost
    yield rungs[start:]
