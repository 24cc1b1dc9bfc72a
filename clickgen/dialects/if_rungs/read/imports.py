"""A program in several files: what is imported from sibling files, read as text and never run."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import NamedTuple

from clickgen.dialects.if_rungs.read.content import FileContent
from clickgen.dialects.if_rungs.read.parse import decode
from clickgen.dialects.if_rungs.read.remembered import read_content
from clickgen.ir.imports import Import
from clickgen.ir.program import BlockDeclaration, Declaration, Offer, Program, Routine
from clickgen.ir.proposals import Proposal
from clickgen.problems.diagnostics import Diagnostics, did_you_mean
from clickgen.text.source import SourceFile, Span
from clickgen.workspace.memory import Memory

ReadBytes = Callable[[str], bytes]
"""The bytes of a file by its path as shown; raises OSError."""


def read_program(
    source: SourceFile, read_bytes: ReadBytes, problems: Diagnostics, memory: Memory | None = None
) -> tuple[Program | None, tuple[SourceFile, ...]]:
    """The program that begins in this file, and every file it is made of. ``memory`` knows what was read before.

    None when this file is not Python. Everything else that is wrong is in ``problems``.
    """
    memory = memory or Memory()
    files = _Files(read_bytes, problems, memory, [source])
    content = read_content(source, problems, memory)
    if content is None:
        return None, tuple(files.sources)
    files.enter(content)
    # A routine that two files import is one routine.
    routines = {id(routine): routine for routine in files.routines(content)}
    wanted = {name for item in content.items if isinstance(item, Import) for name, _ in item.names}
    misimported = wanted - {routine.function for routine in routines.values()}
    program = Program(
        source,
        tuple(routines.values()),
        tuple(files.declarations),
        tuple(files.blocks),
        frozenset(misimported),
        files.offered(content),
        tuple(files.proposals),
        files.is_declared,
    )
    return program, tuple(files.sources)


class _Visit(NamedTuple):
    """A file that is being taken in, and the imports that are left."""

    content: FileContent
    imports: Iterator[Import]


_CHAIN_SHOWN = 12
"""The files of a circle that a message names."""


@dataclass
class _Files:
    """Every file that was read, each once, and the path from the program to the one being read."""

    read_bytes: ReadBytes
    problems: Diagnostics
    memory: Memory
    sources: list[SourceFile]
    declarations: list[Declaration] = field(default_factory=list)
    blocks: list[BlockDeclaration] = field(default_factory=list)
    proposals: list[Proposal] = field(default_factory=list)
    is_declared: bool = True
    _contents: dict[str, FileContent | None] = field(default_factory=dict)
    _open: dict[str, None] = field(default_factory=dict)
    """The files from the program to the one being taken in, in this order."""

    def enter(self, content: FileContent) -> None:
        """Take in a file and, before it, everything that it imports, however long that chain is."""
        waiting = [self._visit(content)]
        while waiting:
            visit = waiting[-1]
            item = next(visit.imports, None)
            if item is None:
                waiting.pop()
                self._open.pop(_key(visit.content.path))
                self.declarations += (one for one in visit.content.items if isinstance(one, Declaration))
                self.blocks += (one for one in visit.content.items if isinstance(one, BlockDeclaration))
                continue
            imported = self._import(visit.content.path, item)
            if imported is not None:
                waiting.append(self._visit(imported))

    def _visit(self, content: FileContent) -> _Visit:
        key = _key(content.path)
        self._contents[key] = content
        self.proposals += content.proposals
        self.is_declared &= content.is_declared
        self._open[key] = None
        return _Visit(content, (item for item in content.items if isinstance(item, Import) and item.module))

    def routines(self, content: FileContent) -> Iterator[Routine]:
        """The routines of the program: those of its own file, then those that it imports, in the order of the text."""
        yield from (item for item in content.items if isinstance(item, Routine))
        for item in content.items:
            if isinstance(item, Import):
                subroutines = self._subroutines(_sibling(content.path, item.module))
                # Two of one name are both brought: that is for the rule about names.
                yield from (one for name, _ in item.names for one in subroutines if one.function == name)

    def offered(self, content: FileContent) -> dict[str, Offer]:
        """The subroutines of the files that the program imports, by their functions."""
        return {
            routine.function: Offer(routine.name, item.module)
            for item in content.items
            if isinstance(item, Import)
            for routine in self._subroutines(_sibling(content.path, item.module))
        }

    def _import(self, importer: str, item: Import) -> FileContent | None:
        """The file that an import brings in, when this is the first time."""
        path = _sibling(importer, item.module)
        key = _key(path)
        if key in self._open:
            opened = list(self._open)
            chain = [os.path.basename(file) for file in (*opened[opened.index(key) :], key)]
            if len(chain) > _CHAIN_SHOWN:
                chain[_CHAIN_SHOWN // 2 : -_CHAIN_SHOWN // 2] = ["..."]
            self.problems.add(
                "CG122",
                item.span,
                f"files import each other in a circle: {' -> '.join(chain)}",
                "put what both need into a third file",
            )
            return None
        is_new = key not in self._contents
        content = self._contents[key] = self._read(path, item.span) if is_new else self._contents[key]
        self._check_names(path, item)
        return content if is_new else None

    def _read(self, path: str, span: Span) -> FileContent | None:
        """The content of an imported file; None, with a problem, where it cannot be read."""
        try:
            data = self.read_bytes(path)
        except OSError as error:
            self.is_declared = False
            missing = isinstance(error, FileNotFoundError)
            fault = f"there is no file {path}" if missing else f"{path} cannot be read: {error.strerror or error}"
            self.problems.add("CG121", span, fault, self._hint(path) if missing else "make it a readable file")
            return None
        source = decode(path, data, self.problems)
        if source is not None:
            self.sources.append(source)
        content = read_content(source, self.problems, self.memory) if source is not None else None
        self.is_declared &= content is not None
        return content

    def _hint(self, path: str) -> str:
        name = os.path.basename(path)
        others = [
            other for other in _siblings(path) if _key(os.path.join(os.path.dirname(path), other)) not in self._open
        ]
        if name.removesuffix(".py") in sys.stdlib_module_names:
            return "a program is never run as Python, so Python's own modules have no place in it"
        return did_you_mean(name, others) or "an imported file stands beside the file that imports it"

    def _check_names(self, path: str, item: Import) -> None:
        content = self._contents[_key(path)]
        if content is None:
            return
        subroutines = {routine.function: routine.name for routine in self._subroutines(path)}
        mains = {other.name for other in content.items if isinstance(other, Routine) and other.is_main}
        for name, span in item.names:
            if name in mains:
                fault, help = f"{name} of {path} is a main program, not a subroutine", "import its subroutines"
            elif name not in subroutines:
                titled = next((function for function, title in subroutines.items() if title == name), "")
                hint = f"an import names the function: {titled}" if titled else did_you_mean(name, subroutines)
                fault, help = f"{path} has no subroutine {name!r}", hint
            else:
                continue
            self.problems.add("CG123", span, fault, help or f"it has {', '.join(subroutines) or 'none'}")

    def _subroutines(self, path: str) -> list[Routine]:
        content = self._contents.get(_key(path))
        routines = (item for item in content.items if isinstance(item, Routine)) if content else ()
        return [routine for routine in routines if not routine.is_main]


def _sibling(importer: str, module: str) -> str:
    return os.path.join(os.path.dirname(importer), f"{module}.py")


def _siblings(path: str) -> list[str]:
    try:
        return sorted(name for name in os.listdir(os.path.dirname(path) or ".") if name.endswith(".py"))
    except OSError:
        return []


def _key(path: str) -> str:
    return os.path.realpath(path)
