"""The names that the other programs around a table use: a name that one of them uses has not left."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from clickgen.api import build_all
from clickgen.config import Config
from clickgen.facts.uses import addresses_of
from clickgen.results import BuildResult
from clickgen.workspace import CouldNotRun, Workspace

if TYPE_CHECKING:
    from clickgen.commands.nicknames.programs import Job


def build_among(jobs: Sequence[Job], config: Callable[[], Config], files: Workspace) -> list[BuildResult]:
    """Build programs one after the other; if a name left one, taking into account the names that others around it use.

    ``config`` gives the settings, if they are needed.
    """
    results = build_all(((job.program, job.settings) for job in jobs), files)
    if not any(result.left for result in results):
        return results
    settings = config()
    known = [
        named_elsewhere(job, settings, files, jobs) if result.left else frozenset()
        for job, result in zip(jobs, results, strict=True)
    ]
    informed = [job.settings._replace(named_elsewhere=names) for job, names in zip(jobs, known, strict=True)]
    return build_all(((job.program, settings) for job, settings in zip(jobs, informed, strict=True)), files)


def named_elsewhere(job: Job, config: Config, files: Workspace, others: Sequence[Job] = ()) -> frozenset[str]:
    """The names, in lower case, and the addresses of its table that programs beside this one use.

    Looks at the programs around the table, at those of the settings and at ``others``. A program that cannot be read
    may use any name: nobody knows, and nothing is reported.
    """
    from clickgen.commands.nicknames.programs import programs_around  # It loads libcst.

    table = os.path.realpath(job.settings.table_of(job.program))
    own = os.path.realpath(job.program)
    try:
        around = programs_around([job, *others], config, files)
    except CouldNotRun:
        return frozenset()
    found: set[str] = set()
    for program in around:
        if os.path.realpath(program.path) == own or program.table_key != table:
            continue
        for file in program.names:
            found.update(named.name.lower() for named in (*file.named, *file.blocks))
            found.update(str(address) for cell in file.cells for address in addresses_of(cell))
    return frozenset(found)
