"""``clickgen nicknames rename``: rename in the table and in every source file."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from pathlib import Path

from clickgen.cli import OK, tell
from clickgen.cli.jobs import Run, near
from clickgen.cli.nicknames.shared import add_programs, jobs_of
from clickgen.commands.nicknames.rename import Rename, rename
from clickgen.text.wording import counted
from clickgen.text.write import put_in_place

HELP = "rename in the table and in every source file"
DESCRIPTION = (
    "Rename a nickname or a block in the address table and in every program that uses the table, all or nothing. "
    "The ladder stays the same, which is tried before anything is written, and what changes is said first."
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    add = parser.add_argument
    add("old", metavar="OLD", help="the nickname or block as it is")
    add("new", metavar="NEW", help="the name as it should be")
    add_programs(parser)
    add("--dry-run", action="store_true", help="say what would be renamed, and write nothing")


def _adoption_lines(result: Rename, is_dry: bool) -> Iterator[str]:
    """The result of a rename that somebody had begun in the programs."""
    assert result.adoption is not None
    programs = ", ".join(str(near(Path(program))) for program in result.programs)
    address, is_now = result.adoption.row.address, "would be" if is_dry else "is"
    yield f"{address} {is_now} {result.new} and no longer {result.old}, as {programs} said already"
    for row in result.adoption.freed:
        had = f"{row.address}, which a build had given to {result.new}"
        yield f"{had}, {is_now} free: build again and load that into CLICK"


def run(options: argparse.Namespace) -> int:
    """Rename a nickname or a block everywhere, after the proof that the ladder stays; return the exit code."""
    this = Run(options.config)
    found = jobs_of(this, options)
    if not options.dry_run:
        this.settle(found)
    result = rename(options.old, options.new, found, this.settings, this.files)
    programs = ", ".join(str(near(Path(program))) for program in result.programs)
    becomes, stays = ("would become", "would be") if options.dry_run else ("becomes", "stays")
    tell(f"{result.old} {becomes} {result.new}; the ladder of {programs} {stays} the same:")
    for path, count in sorted((near(path), count) for path, count in result.counts.items()):
        tell(f"  {path}: {counted(count, 'time')}")
    for path, count in sorted((near(path), count) for path, count in result.comments.items()):
        tell(f"  {path}: {counted(count, 'comment')} still {'say' if count > 1 else 'says'} {result.old}")
    for span in result.left:
        place = f"{near(Path(span.path))}:{span.line}"
        tell(f"  {place} says {result.old} too, in a file that no program imports: it stays as it is")
    if options.dry_run:
        if result.adoption is not None:
            tell(*_adoption_lines(result, options.dry_run))
        return OK
    sys.stdout.flush()
    put_in_place(result.writes, (), result.unchanged)
    tell(*(_adoption_lines(result, False) if result.adoption is not None else [f"{result.old} is {result.new} now"]))
    return OK
