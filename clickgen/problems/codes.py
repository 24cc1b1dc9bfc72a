"""Every problem code with its severity and title. Codes are stable; a retired one is never used again.

A rule declares its codes in its own file; each other code has a page in ``explanations``. The table here is made from
both, so that a report loads neither.

CG1xx syntax, CG2xx names and addresses, CG3xx operands and types, CG4xx program structure and hardware limits,
CG5xx logic worth a second look, CG6xx the address table, CG7xx bringing a project in.
"""

from __future__ import annotations

from enum import Enum
from typing import NamedTuple

from clickgen.problems.table import TABLE


class Severity(Enum):
    """ERROR stops the build; WARNING and INFO are said and the build goes on."""

    ERROR = "error"
    WARNING = "warning"
    INFO = "info"


class Entry(NamedTuple):
    """The row of a code in the table: what a report needs of it."""

    severity: Severity
    title: str
    is_on: bool
    """False for a rule that says something only when it is asked for."""
    home: str
    """The module of the rule that declares the code; "" for one that has a page in ``explanations``."""


def entry_of(line: str) -> tuple[str, Entry]:
    """The code and the entry that a line of the table holds."""
    code, severity, on, home, title = line.split(None, 4)
    return code, Entry(Severity(severity), title, on == "on", home.removeprefix("-"))


CODES: dict[str, Entry] = dict(map(entry_of, TABLE.splitlines()))
"""Every code, in order."""

LEFT = "CG541"
"""The code of a name that left its program: only a look at the other programs of its table settles it."""

_LATE = ("advice.", "lowered.")
"""The folders of the rules that judge only programs without errors."""
_LATE_CODES = (LEFT, "CG424")
"""The codes that later stages report: what left the program, and how main is divided into files."""


def waits_for_errors(code: str) -> bool:
    """True if nothing can report this code while the program has an error."""
    return CODES[code].home.startswith(_LATE) or code in _LATE_CODES
