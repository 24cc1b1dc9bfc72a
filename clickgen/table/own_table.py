"""The help for two programs that share an address table because nobody named one."""

from __future__ import annotations

from pathlib import Path

from clickgen.problems.diagnostics import Diagnostics


def own_table_setting(program: Path) -> str:
    """The line in the settings of the working folder that gives a program its own address table."""
    path = Path(program.name) if program.is_absolute() else program
    return f'programs = [{{ path = "{path.as_posix()}", nicknames = "{path.with_suffix(".csv").as_posix()}" }}]'


def tell_of_own_table(program: Path, table: Path, problems: Diagnostics) -> None:
    """Add to the first problem in which program and table disagree how the program gets its own table.

    The table beside the program may belong to another PLC.
    """
    for index, problem in enumerate(problems.found):
        in_table = any(label.span.path == str(table) for label in problem.labels)
        if problem.code in ("CG204", "CG205") and in_table:
            own = f"give it a table of its own in clickgen.toml: {own_table_setting(program)}"
            help = f"{problem.help}; if this program is for another PLC, {own}"
            problems.found[index] = problem._replace(help=help)
            return
