"""The dialect in which a rung is an ``if``: what reads and writes it is loaded when it is asked for."""

from __future__ import annotations

import re
from functools import cached_property
from typing import TYPE_CHECKING

from clickgen.dialects.base import Dialect
from clickgen.dialects.if_rungs.look import FileLook

if TYPE_CHECKING:
    from collections.abc import Collection, Iterable, Mapping, Sequence

    from clickgen.device.banks import Address
    from clickgen.dialects.base import Look, Mender, NamePlaces, Spelling
    from clickgen.ir.program import FormulaText, Program, Routine
    from clickgen.problems.diagnostics import Diagnostic, Diagnostics
    from clickgen.problems.silence import Directive
    from clickgen.table.rows import Row
    from clickgen.text.edits import Edit, Fix
    from clickgen.text.source import SourceFile
    from clickgen.workspace import Workspace


_ROUTINE = re.compile(r"^def (\w+)", re.MULTILINE)


class IfRungs(Dialect):
    """``if c.Run: out(y[1])``"""

    name = "if_rungs"
    suffix = ".py"

    @cached_property
    def spell(self) -> Spelling:
        from clickgen.dialects.if_rungs.spelling import IfRungsSpelling

        return IfRungsSpelling()

    def look(self, path: str, text: str) -> Look:  # noqa: ARG002
        return FileLook(text)

    # -- reading ------------------------------------------------------------------------------------------------------

    def decode(self, path: str, data: bytes, problems: Diagnostics) -> SourceFile | None:
        from clickgen.dialects.if_rungs.read.parse import decode

        return decode(path, data, problems)

    def read(
        self, source: SourceFile, files: Workspace, problems: Diagnostics
    ) -> tuple[Program | None, tuple[SourceFile, ...]]:
        from clickgen.dialects.if_rungs.read.imports import read_program

        return read_program(source, files.read, problems, files.memory)

    def read_file(self, source: SourceFile, problems: Diagnostics) -> Sequence[object] | None:
        from clickgen.dialects.if_rungs.read.program import read_file

        content = read_file(source, problems)
        return None if content is None else content.items

    def routines_in(self, source: SourceFile) -> list[str]:
        return _ROUTINE.findall(source.text)

    def places(self, source: SourceFile, formulas: Sequence[FormulaText]) -> NamePlaces:
        from clickgen.dialects.if_rungs.fix.names import FilePlaces

        return FilePlaces(source, formulas)

    def comments_with(self, source: SourceFile, word: str) -> int:
        from clickgen.dialects.if_rungs.fix.names import comments_with

        return comments_with(source, word)

    # -- fixes --------------------------------------------------------------------------------------------------------

    def mender(self, source: SourceFile) -> Mender:
        from clickgen.dialects.if_rungs.fix.proposed import IfRungsMender

        return IfRungsMender(source)

    # -- comments that silence findings -------------------------------------------------------------------------------

    def directives(self, source: SourceFile, problems: Diagnostics) -> list[Directive]:
        from clickgen.dialects.if_rungs.suppress import read_directives

        return read_directives(source, problems)

    def ignoring(self, source: SourceFile, findings: Iterable[Diagnostic]) -> Fix | None:
        from clickgen.dialects.if_rungs.suppress import ignoring

        return ignoring(source, findings)

    def without(self, source: SourceFile, directive: Directive, codes: Sequence[str]) -> Edit:
        from clickgen.dialects.if_rungs.suppress import without

        return without(source, directive, codes)

    # -- writing ------------------------------------------------------------------------------------------------------

    def write(self, routines: Sequence[Routine], names: Mapping[Address, str], declared: Sequence[Row] = ()) -> str:
        from clickgen.dialects.if_rungs.write.declarations import declarations
        from clickgen.dialects.if_rungs.write.routine import write_source

        return write_source(routines, names, declarations(declared))

    def write_files(self, routines: Sequence[Routine], names: Mapping[Address, str]) -> dict[str, str]:
        from clickgen.dialects.if_rungs.write.files import a_file_each

        return a_file_each(routines, names)

    def function_name(self, name: str, taken: Collection[str]) -> str:
        from clickgen.dialects.if_rungs.write.functions import function_name

        return function_name(name, taken)

    def idle(self, line: str) -> str:
        code = line.strip()
        indent = line[: len(line) - len(line.lstrip())]
        instead = "if True:" if code.partition("#")[0].rstrip().endswith(":") else "pass"
        # Without an indent it may declare something.
        return f"{indent}{instead}\n" if indent and code != instead else ""

    # -- help ---------------------------------------------------------------------------------------------------------

    def system_point_hint(self, word: str) -> str:
        from clickgen.dialects.if_rungs.trade import CONDITIONS, advice

        found = advice(word, CONDITIONS)
        is_point = found is not None and found.code and found.code[0].startswith(("sc", "nc(sc"))
        return found.shown if found is not None and is_point else ""

    def explain_word(self, word: str) -> list[str]:
        from clickgen.dialects.if_rungs.trade import ACTIONS, CONDITIONS, FORMULAS, bank_hint

        tables = (("In a condition", CONDITIONS), ("As an action", ACTIONS), ("In a formula", FORMULAS))
        lines = [f"{place}: {table[word].shown}" for place, table in tables if word in table]
        hint = bank_hint(word)
        return [*lines, *([f"As a bank: {hint}"] if hint else [])]
