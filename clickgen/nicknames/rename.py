"""Renaming a nickname in the address table and in every source file, all or nothing: the ladder stays what it is."""

from __future__ import annotations

import keyword
import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from clickgen.config import Config, find_config
from clickgen.device.nicknames import nickname_fault
from clickgen.device.system import addresses_of_system_name
from clickgen.diagnostics import CouldNotRun, Diagnostic, Diagnostics, Edit, Fix, did_you_mean
from clickgen.fixing import apply_fixes
from clickgen.nicknames.adopt import Adoption, adopt
from clickgen.nicknames.programs import Files, Job, Program, programs_around
from clickgen.nicknames.prove import Side, errors_of, prove_same
from clickgen.nicknames.tables import Table, read_tables
from clickgen.nicknames.uses import FileNames, comments_with, read_names, word_pattern
from clickgen.resolve.rows import is_scratch, looks_like_scratch
from clickgen.source import Span
from clickgen.syntax.parse import decode
from clickgen.wording import counted

__all__ = ["Rename", "rename"]


@dataclass(frozen=True)
class Rename:
    """What a rename changes. Nothing is written by it: ``put_in_place(writes, (), unchanged)`` does that."""

    old: str
    new: str
    writes: Mapping[Path, bytes]
    unchanged: Mapping[Path, bytes | None]
    """Every file that it was made from, with the bytes that it must still have; None for one that must not be there."""
    counts: Mapping[Path, int]
    """How often the name is written anew in each file; the record of what clickgen placed is not counted."""
    comments: Mapping[Path, int]
    """How many comments of each source file hold the old name; they stay as they are."""
    programs: tuple[str, ...]
    """The programs that were built before and after, and whose ladder is the same."""
    left: tuple[Span, ...] = ()
    """Where the old name stays in parts beside the programs that no program imports."""
    adoption: Adoption | None = None
    """What became of a rename that somebody had begun in the sources."""


def rename(old: str, new: str, jobs: Sequence[Job], config: Config | None = None) -> Rename:
    """Rename a nickname in the tables of these programs and in every source file of the programs that share them.

    Programs that are not named and share a table are found around it (``config`` is what holds in the working folder).
    Where the table has the new name already and the old one stands in sources alone, the sources follow; where the
    sources have the new name already and the old one stands in the table alone, the table follows. Raises
    CouldNotRun when the new name is not free or not legal, or when a program would not stay what it is.
    """
    _check_names(old, new)
    files = Files()
    programs = programs_around(jobs, find_config(Path.cwd()) if config is None else config, files)
    keys = {program.table_key for program in programs if program.is_job}
    sharing = [program for program in programs if program.table_key in keys]
    known = read_tables(sharing, files)
    tables = {key: table for key, table in known.items() if _knows(table, sharing, old)}
    if not tables:
        raise CouldNotRun(_unknown(old, sharing, known.values()))
    members = [program for program in sharing if program.table_key in tables]
    sources = {os.path.realpath(file.source.path): file for program in members for file in program.names}
    _refuse_unread(members, old)
    adoption = adopt(old, new, members, tables, files, _edited)
    if adoption is not None:
        return _adopted(old, new, members, files, adoption)
    _check_tables(tables.values(), old, new)
    _check_sources(sources.values(), tables.values(), old, new)
    using = {key: file for key, file in sources.items() if file.of(old)}
    _refuse_strangers((program for program in programs if program.table_key not in tables), using, old)

    changed = {key: _edited(file, old, new, files) for key, file in using.items()}
    changed.update((key, table.renamed(old, new)) for key, table in tables.items() if table.row(old))
    records = _records(tables.values(), old, new, files)
    written = {key: data for key, data in changed.items() if files.contents[key] != data}
    stand_ins = {key: found for key, table in tables.items() if (found := table.stand_in(old, new))}
    earlier = {os.path.realpath(path): data for path, data in stand_ins.values()}
    before = Side({**files.overlay, **earlier}, {key: path for key, (path, _) in stand_ins.items()})
    proven = _proven(members, before, Side({**files.overlay, **written}, {}), old, new)
    return Rename(
        old,
        new,
        {Path(files.shown[key]): data for key, data in {**written, **records}.items()},
        {Path(files.shown[key]): data for key, data in files.contents.items()},
        {Path(files.shown[key]): len(using[key].of(old)) if key in using else 1 for key in written},
        {Path(file.source.path): count for file in sources.values() if (count := comments_with(file.source, old))},
        proven,
        _left(programs, members, old),
    )


def _adopted(old: str, new: str, members: Sequence[Program], files: Files, adoption: Adoption) -> Rename:
    """The end of a rename that somebody began in the sources: the table follows, no source changes."""
    after = Side({**files.overlay, **adoption.writes}, {})
    proven = _proven(members, adoption.before, after, adoption.old, new)
    writes = {Path(files.shown[key]): data for key, data in adoption.writes.items()}
    unchanged = {Path(files.shown[key]): data for key, data in files.contents.items()}
    counts = {path: 1 for path in writes if path.suffix == ".csv"}
    return Rename(old, new, writes, unchanged, counts, {}, proven, adoption=adoption)


def _knows(table: Table, programs: Iterable[Program], name: str) -> bool:
    files = (file for program in programs if program.table_key == table.key for file in program.names)
    return table.row(name) is not None or any(file.of(name) or file.blocks_of(name) for file in files)


# -- what is refused --------------------------------------------------------------------------------------------------


def _check_names(old: str, new: str) -> None:
    if old == new:
        raise CouldNotRun(f"{old} is called that already")
    fault = nickname_fault(new)
    if fault:
        raise CouldNotRun(f"CLICK does not take the nickname {new!r}: {fault}")
    if looks_like_scratch(new):
        raise CouldNotRun(f"clickgen keeps names like {new} for its own cells; choose another name")
    for name in (old, new):
        points = addresses_of_system_name(name)
        if points:
            raise CouldNotRun(f"{name} is CLICK's own name of {' or '.join(map(str, points))}")


def _unknown(old: str, programs: Iterable[Program], tables: Iterable[Table]) -> str:
    listed = [*tables]
    known = {row.nickname for table in listed for row in table.rows if row.nickname}
    known |= {named.name for program in programs for file in program.names for named in file.named}
    hint = did_you_mean(old, sorted(known))
    places = " and ".join(str(table.path) for table in listed)
    return f"there is no nickname {old} in {places} or in the programs{f'; {hint}' if hint else ''}"


def _check_tables(tables: Iterable[Table], old: str, new: str) -> None:
    for table in tables:
        row, other = table.row(old), table.row(new)
        if row is None and old.lower() in table.blocks:
            raise CouldNotRun(_is_block(old, table.blocks[old.lower()].said_by))
        if new.lower() in table.blocks:
            raise _taken(new, f"it is a block ({table.blocks[new.lower()].said_by})")
        if row is not None and is_scratch(row):
            raise CouldNotRun(f"{row.nickname} is a cell that clickgen uses for itself ({table.place(row)})")
        if row is not None and row.cell is not None:
            raise CouldNotRun(
                f"{row.nickname} stands in the row of {table.place(row)}, and clickgen writes into no workbook: "
                f"write {new} there and run this again, then it renames in the programs"
            )
        if row is not None and other is not None and other.address != row.address:
            raise _taken(new, f"it is {other.address} ({table.place(other)})")


def _is_block(name: str, place: str) -> str:
    return f"{name} is a block ({place}), and only nicknames are renamed"


def _taken(new: str, reason: str) -> CouldNotRun:
    return CouldNotRun(f"{new} is taken: {reason}; choose another name")


def _refuse_unread(programs: Iterable[Program], old: str) -> None:
    """A file that speaks of the name and cannot be read is not left behind."""
    for program in programs:
        for source, _, problems in program.sources:
            errors = [problem for problem in problems if problem.is_error]
            if errors and (program.is_job or word_pattern(old).search(source.text)):
                raise CouldNotRun(_does_not_build(source.path, errors))


def _check_sources(files: Iterable[FileNames], tables: Iterable[Table], old: str, new: str) -> None:
    is_nickname = any(table.row(old) for table in tables)
    for file in files:
        taken = [] if old.lower() == new.lower() else [*file.of(new), *file.blocks_of(new)]
        if taken:
            raise _taken(new, f"{taken[0].span} uses it")
        blocks = file.blocks_of(old)
        if blocks and not is_nickname:
            raise CouldNotRun(_is_block(old, str(blocks[0].span)))
        for named in file.of(old):
            place = file.place(named)
            if place.is_plain and not _is_plain(new, place.in_formula):
                way = f'{named.bank.lower()}["{named.name}"]'
                raise CouldNotRun(
                    f"{new!r} cannot stand behind a dot, as {named.name} does at {named.span}: choose a plain word, or "
                    f"write {way} there first"
                )


def _is_plain(name: str, in_formula: bool) -> bool:
    return name.isidentifier() and (in_formula or not keyword.iskeyword(name))


def _refuse_strangers(others: Iterable[Program], edited: Mapping[str, FileNames], old: str) -> None:
    for program in others:
        for source in program.sources:
            if os.path.realpath(source.source.path) in edited:
                raise CouldNotRun(
                    f"{source.source.path} uses {old} and also belongs to {program.path}, which has an address table "
                    f"of its own ({program.table}): name both programs"
                )


def _does_not_build(path: str, errors: Sequence[Diagnostic]) -> str:
    first = errors[0]
    more = f" (and {counted(len(errors) - 1, 'more error')})" if len(errors) > 1 else ""
    return f"{path} has errors, and only programs that build are renamed in: {first.span}: {first.message}{more}"


# -- what is changed --------------------------------------------------------------------------------------------------


def _records(tables: Iterable[Table], old: str, new: str, files: Files) -> dict[str, bytes]:
    """The records of names that clickgen placed, by their real paths, where this name is in them."""
    renamed: dict[str, bytes] = {}
    for table in tables:
        if table.row(old) is not None:
            data = table.record_renamed(files.look(str(table.record)), old, new)
            if data is not None:
                renamed[os.path.realpath(table.record)] = data
    return renamed


def _left(programs: Iterable[Program], members: Sequence[Program], old: str) -> tuple[Span, ...]:
    """Where the name stands in parts that belong to no program: those beside the programs, or without a table."""
    folders = {os.path.dirname(os.path.realpath(program.path)) for program in members}
    keys = {program.table_key for program in members}
    loose = (
        program
        for program in programs
        if program.is_part
        and program.table_key not in keys
        and (os.path.dirname(os.path.realpath(program.path)) in folders or not program.table.exists())
    )
    files = {file.source.path: file for program in loose for file in program.names}
    done = {file.source.path for program in members for file in program.names}
    return tuple(named.span for path, file in files.items() if path not in done for named in file.of(old))


def _edited(file: FileNames, old: str, new: str, files: Files) -> bytes:
    """The file with the new name, every other byte kept; what is read there now is what was read, renamed."""
    edits: list[Edit] = [edit for named in file.of(old) for edit in file.place(named).edits(new)]
    text, _ = apply_fixes(files.read(file.source.path).decode("utf-8"), [Fix(tuple(edits))])
    data = text.encode("utf-8")
    source = decode(file.source.path, data, Diagnostics())
    again = read_names(source, Diagnostics()) if source else None
    if again is None or _said(again, new, new) != _said(file, old, new):
        raise CouldNotRun(f"{old} cannot become {new} in {file.source.path}: the file would be read differently")
    return data


def _said(file: FileNames, old: str, new: str) -> list[tuple[str, str, object]]:
    """What a file names, with the new name for the old one; blocks stay as they are."""
    names = ((name, new if name.name.lower() == old.lower() else name.name) for name in file.named)
    return [*((name.bank, said, None) for name, said in names), *((b.bank, b.name, b.part) for b in file.blocks)]


def _proven(members: Iterable[Program], before: Side, after: Side, old: str, new: str) -> tuple[str, ...]:
    """The programs that were built before and after; one that was only found and never says the name may be broken."""
    proven: list[str] = []
    for program in members:
        if program.is_part:
            continue
        first = before.build(program)
        errors = errors_of(first)
        if errors:
            if program.is_job or any(word_pattern(old).search(source.source.text) for source in program.sources):
                raise CouldNotRun(_does_not_build(program.path, errors))
            continue
        second = after.build(program)
        errors = errors_of(second)
        if errors:
            raise CouldNotRun(f"with {new} {program.path} would not build: {errors[0].span}: {errors[0].message}")
        prove_same(first, second, old, new)
        proven.append(program.path)
    return tuple(proven)
