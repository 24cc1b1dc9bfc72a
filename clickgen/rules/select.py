"""Which codes are wanted: the most specific of ``select``, ``extend_select`` and ``ignore`` wins."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

from clickgen.problems.codes import CODES, Severity


class Selection(NamedTuple):
    """Codes may be prefixes: ``CG5`` is a whole group. ``select`` None is every rule that is on by default."""

    select: tuple[str, ...] | None = None
    extend_select: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()

    def wants(self, code: str) -> bool:
        """True when a finding of this code is to be shown. An error always is: it stops a build."""
        return CODES[code].severity is Severity.ERROR or _wants(self, code)


@cache
def _wants(selection: Selection, code: str) -> bool:
    by_default = 0 if CODES[code].is_on else -1
    chosen = by_default if selection.select is None else _closest(code, selection.select)
    return max(chosen, _closest(code, selection.extend_select)) > _closest(code, selection.ignore)


def _closest(code: str, prefixes: tuple[str, ...]) -> int:
    """The length of the longest of these prefixes that the code has; -1 for none."""
    return max((len(prefix) for prefix in prefixes if code.startswith(prefix)), default=-1)
