"""Renames a nickname or a block in the address table and in every source file, all or nothing: the ladder stays."""

from __future__ import annotations

import os
import shlex
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from clickgen.commands.nicknames.adopt import Adoption, adopt, adopt_block
from clickgen.commands.nicknames.programs import Job, Program, programs_around
from clickgen.commands.nicknames.prove import Side, errors_of, prove_same
from clickgen.commands.nicknames.tables import Table, read_tables
from clickgen.commands.nicknames.uses import FileNames, read_names
from clickgen.config import Config, find_config
from clickgen.device.nicknames import nickname_fault
from clickgen.device.system import addresses_of_system_name
from clickgen.ir.operands import Named
from clickgen.ir.program import Declaration
from clickgen.problems.diagnostics import Diagnostic, Diagnostics, did_you_mean
from clickgen.table.record import read_record
from clickgen.table.rows import is_scratch, looks_like_scratch
from clickgen.text.edits import Edit, Fix, apply_fixes
from clickgen.text.source import Span
from clickgen.text.wording import counted, word_pattern
from clickgen.workspace import CouldNotRun, Workspace

__all__ = ["Rename", "rename"]


@dataclass(frozen=True)
class Rename:
    """The changes of a rename. It writes nothing: ``put_in_place(writes, (), unchanged)`` does that."""

    old: str
    new: str
    writes: Mapping[Path, bytes]
    unchanged: Mapping[Path, bytes | None]
    """Every file that it was made from, with the bytes that it must still have; None for one that must not exist."""
    counts: Mapping[Path, int]
    """How often each file gets the new name; the record of what clickgen placed is not counted."""
    comments: Mapping[Path, int]
    """How many comments of each source file hold the old name; they stay unchanged."""
    programs: tuple[str, ...]
    """The programs that were built before and after, and whose ladder is the same."""
    left: tuple[Span, ...] = ()
    """The places of the old name that stay, in parts beside the programs that no program imports."""
    adoption: Adoption | None = None
    """The result of finishing a rename that somebody had begun in the sources."""


def rename(
    old: str, new: str, jobs: Sequence[Job], config: Config | None = None, files: Workspace | None = None
) -> Rename:
    """Rename a nickname or a block in the tables of these programs and in every source file of those that share them.

    Programs that are not named and share a table are found around it (``config`` holds the working folder's settings).
    If the table has the new name already and only the sources have the old one, the sources follow; if the
    sources have the new name already and only the table has the old one, the table follows. Raises
    CouldNotRun if the new name is not free or not legal, or if a program would change.
    """
    _check_names(old, new)
    # The files that the rename reads must be unchanged when it writes; the settings may change.
    files = Workspace() if files is None else files.apart()
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
    adoption = adopt(old, new, members, tables, files, _edited_as)
    if adoption is not None:
        _refuse_strangers((each for each in programs if each.table_key not in tables), adoption.edited, old)
        return _adopted(members, files, adoption, _Wanted(old, new, False))
    wanted = _Wanted(old, new, _is_block(tables.values(), sources.values(), old, new))
    if wanted.is_block and not any(character.isalpha() for character in new):
        raise CouldNotRun(f"{new!r} cannot be the name of a block: it has no letter")
    _check_tables(tables.values(), wanted, _ways_back(sources.values(), jobs, old, new))
    adoption = adopt_block(old, new, members, tables, files, _block_edited_as) if wanted.is_block else None
    if adoption is not None:
        return _adopted(members, files, adoption, wanted)
    _check_sources(sources.values(), wanted)
    places = {key: found for key, file in sources.items() if (found := wanted.places(file))}
    using = {key: sources[key] for key in places}
    _refuse_strangers((program for program in programs if program.table_key not in tables), using, old)

    changed = {key: _edited(file, wanted, files) for key, file in using.items()}
    marked = {key: len(table.marks_of(old)) if wanted.is_block else 1 for key, table in tables.items()}
    if wanted.is_block:
        changed.update((key, table.with_block_renamed(old, new)) for key, table in tables.items() if marked[key])
        records = {}
    else:
        changed.update((key, table.renamed(old, new)) for key, table in tables.items() if table.row(old))
        records = _records(tables.values(), old, new, files)
    written = {key: data for key, data in changed.items() if files.on_disk(key) != data}
    stand_ins = {key: stand_in for key, table in tables.items() if (stand_in := table.stand_in(*wanted))}
    earlier = {os.path.realpath(path): data for path, data in stand_ins.values()}
    before = Side(files.apart(earlier), {key: path for key, (path, _) in stand_ins.items()})
    proven = _proven(members, before, Side(files.apart(written), {}), wanted)
    return Rename(
        old,
        new,
        {Path(files.shown(key)): data for key, data in {**written, **records}.items()},
        {Path(path): data for path, data in files.found.items()},
        {Path(files.shown(key)): len(places[key]) if key in places else marked[key] for key in written},
        _comments(sources.values(), old),
        proven,
        _left(programs, members, old),
    )


def _comments(files: Iterable[FileNames], word: str) -> dict[Path, int]:
    """How many comments of each file hold a word; files without any are left out."""
    counts = {Path(file.source.path): file.comments_with(word) for file in files}
    return {path: count for path, count in counts.items() if count}


def _adopted(members: Sequence[Program], files: Workspace, adoption: Adoption, wanted: _Wanted) -> Rename:
    """Finish a rename that somebody began in the sources: the table follows, and the sources that lag behind."""
    old, new, is_block = wanted
    after = Side(files.apart(adoption.writes), {})
    proven = _proven(members, adoption.before, after, _Wanted(adoption.old, new, is_block))
    writes = {Path(files.shown(key)): data for key, data in adoption.writes.items()}
    unchanged = {Path(path): data for path, data in files.found.items()}
    counts = {path: 1 for path in writes if path.suffix == ".csv"}
    edited = adoption.edited.items()
    counts.update((Path(files.shown(key)), len(file.of(old))) for key, file in edited)
    comments = _comments((file for _, file in edited), old)
    return Rename(old, new, writes, unchanged, counts, comments, proven, adoption=adoption)


class _Wanted(NamedTuple):
    """The name as it is and as it should be; that of a block, or a nickname."""

    old: str
    new: str
    is_block: bool

    def places(self, file: FileNames) -> list[Named]:
        """The places of the old name in a file."""
        return file.every(self.old) if self.is_block else file.of(self.old)

    def renamed(self, name: str) -> str:
        return self.new if name.lower() == self.old.lower() else name


def _is_block(tables: Iterable[Table], files: Iterable[FileNames], old: str, new: str) -> bool:
    """True if a name is a block's: in the table, or in the sources, or in sources whose table has the new one."""
    tables, files = [*tables], [*files]
    declared = (declaration for file in files for declaration in file.declarations)
    is_nickname = any(isinstance(each, Declaration) and each.named.name.lower() == old.lower() for each in declared)
    if is_nickname or any(table.row(old) for table in tables):
        return False
    if any(table.marks_of(old) for table in tables) or any(file.blocks_of(old) for file in files):
        return True
    block = next((table.blocks[new.lower()] for table in tables if new.lower() in table.blocks), None)
    uses = [named for file in files for named in file.of(old)]
    return block is not None and bool(uses) and all(block.is_seen_as(named.bank) for named in uses)


def _knows(table: Table, programs: Iterable[Program], name: str) -> bool:
    files = (file for program in programs if program.table_key == table.key for file in program.names)
    return bool(table.row(name) or table.marks_of(name)) or any(file.every(name) for file in files)


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
    known |= {block.name for table in listed for block in table.blocks.values()}
    known |= {each.name for program in programs for file in program.names for each in (*file.named, *file.blocks)}
    hint = did_you_mean(old, sorted(known))
    places = " and ".join(str(table.path) for table in listed)
    return f"there is no nickname or block {old} in {places} or in the programs{f'; {hint}' if hint else ''}"


def _ways_back(files: Iterable[FileNames], jobs: Sequence[Job], old: str, new: str) -> str:
    """The steps, in order, if a build gave another address to the former old name and nothing recorded that."""
    places = [str(named.span) for file in files for named in file.of(new)]
    more = f" and {counted(len(places) - _PLACES, 'more place')}" if len(places) > _PLACES else ""
    table = next((job.settings.nicknames for job in jobs if job.settings.nicknames is not None), None)
    words = [*(job.program for job in jobs), *(["--nicknames", os.fspath(table)] if table is not None else [])]
    prune = shlex.join(["clickgen", "nicknames", "sync", "--prune", *words])
    again = shlex.join(["clickgen", "nicknames", "rename", old, new, *words])
    write = f"write {old} again at {', '.join(places[:_PLACES])}{more}, " if places else ""
    return f"where a build gave it to what was {old}, {write}run {prune}, and then {again}"


_PLACES = 5
"""At most this many places are listed."""


def _check_tables(tables: Iterable[Table], wanted: _Wanted, ways_back: str) -> None:
    old, new, is_block = wanted
    for table in tables:
        row, other = table.row(old), table.row(new)
        marks = table.marks_of(old) if is_block else []
        if new.lower() in table.blocks and new.lower() != old.lower() and (marks or not is_block):
            raise _taken(new, f"it is a block ({table.blocks[new.lower()].said_by})")
        if is_block and other is not None:
            raise _taken(new, f"it is {other.address} ({table.place(other)})")
        if row is not None and is_scratch(row):
            raise CouldNotRun(f"{row.nickname} is a cell that clickgen uses for itself ({table.place(row)})")
        fixed = next((each for each in (row, *(row for row, _ in marks)) if each is not None and each.cell), None)
        if fixed is not None:
            raise CouldNotRun(
                f"{marks[0].mark.name if marks else fixed.nickname} stands in the row of {table.place(fixed)}, and "
                f"clickgen writes into no workbook: write {new} there and run this again, then it renames in the "
                "programs"
            )
        if row is not None and other is not None and other.address != row.address:
            raise _taken(new, f"it is {other.address} ({table.place(other)})", ways_back)


def _taken(new: str, reason: str, again: str = "") -> CouldNotRun:
    return CouldNotRun(f"{new} is taken: {reason}; choose another name" + (f"; {again}" if again else ""))


def _refuse_unread(programs: Iterable[Program], old: str) -> None:
    """Refuse a rename if a file that mentions the name cannot be read, so that none is left out."""
    for program in programs:
        for source, _, problems in program.sources:
            errors = [problem for problem in problems if problem.is_error]
            if errors and (program.is_job or word_pattern(old).search(source.text)):
                raise CouldNotRun(_does_not_build(source.path, errors))


def _check_sources(files: Iterable[FileNames], wanted: _Wanted) -> None:
    old, new, _ = wanted
    for file in files:
        taken = [] if old.lower() == new.lower() else [*file.of(new), *file.blocks_of(new)]
        if taken:
            again = f"where it already means {old}, write {old} there again: then this renames every place"
            raise _taken(new, f"{taken[0].span} uses it", again)
        for named in wanted.places(file):
            if not file.takes(named, new):
                way = file.dialect.spell.in_quotes(named.bank, named.name)
                raise CouldNotRun(
                    f"{new!r} cannot stand behind a dot, as {named.name} does at {named.span}: choose a plain word, or "
                    f"write {way} there first"
                )


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
    way = f"; its way out: {first.help}" if first.code == "CG205" else ""
    said = f"{first.span}: {first.message}{more}"
    return f"{path} has errors, and only programs that build are renamed in: {said}{way}"


# -- what is changed --------------------------------------------------------------------------------------------------


def _records(tables: Iterable[Table], old: str, new: str, files: Workspace) -> dict[str, bytes]:
    """The records of names that clickgen placed, by their real paths, if this name is in them."""
    renamed: dict[str, bytes] = {}
    for table in tables:
        if table.row(old) is not None:
            data = table.record_renamed(files.look(str(table.record)), old, new)
            if data is not None:
                read_record(table.record, files)  # refuses a file that is not clickgen's
                renamed[os.path.realpath(table.record)] = data
    return renamed


def _left(programs: Iterable[Program], members: Sequence[Program], old: str) -> tuple[Span, ...]:
    """The places of the name in parts that belong to no program: those beside the programs, or without a table."""
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


def _edited(file: FileNames, wanted: _Wanted, files: Workspace) -> bytes:
    """The file with the new name and every other byte unchanged; it reads as before, renamed."""
    old, new, _ = wanted
    edits: list[Edit] = [edit for named in wanted.places(file) for edit in file.place(named).edits(new)]
    text, _ = apply_fixes(files.read(file.source.path).decode("utf-8"), [Fix(tuple(edits))])
    data = text.encode("utf-8")
    source = file.dialect.decode(file.source.path, data, Diagnostics())
    again = read_names(source, Diagnostics()) if source else None
    if again is None or _said(again, wanted._replace(old=new)) != _said(file, wanted):
        raise CouldNotRun(f"{old} cannot become {new} in {file.source.path}: the file would be read differently")
    return data


def _edited_as(file: FileNames, old: str, new: str, files: Workspace) -> bytes:
    return _edited(file, _Wanted(old, new, False), files)


def _block_edited_as(file: FileNames, old: str, new: str, files: Workspace) -> bytes:
    return _edited(file, _Wanted(old, new, True), files)


def _said(file: FileNames, wanted: _Wanted) -> list[tuple[str, str, object]]:
    """The names in a file, with the new name for the old one; blocks keep theirs if a nickname is renamed."""
    blocks = (
        (block.bank, wanted.renamed(block.name) if wanted.is_block else block.name, block.part) for block in file.blocks
    )
    return [*((name.bank, wanted.renamed(name.name), None) for name in file.named), *blocks]


def _proven(members: Iterable[Program], before: Side, after: Side, wanted: _Wanted) -> tuple[str, ...]:
    """The programs that were built before and after; one that was only found and never uses the name may be broken."""
    old, new, is_block = wanted
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
        prove_same(first, second, old, new, is_block)
        proven.append(program.path)
    return tuple(proven)
