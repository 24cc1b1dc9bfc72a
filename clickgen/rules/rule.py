"""What a rule about logic is: its code, why it matters, examples that have the problem and examples that do not."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from clickgen.facts.facts import Facts
from clickgen.problems.diagnostics import Diagnostics


@dataclass(frozen=True)
class Wrong:
    """An example with the problem: rungs of main, or a whole program. ``# <-`` ends each line that has a finding.

    ``fixed`` is the example after its fix; "" when the rule has none.
    """

    text: str
    fixed: str = ""


@dataclass(frozen=True)
class Rule:
    """One rule. Severity and title stand in ``codes.py``; the file of the rule holds all the rest.

    ``why`` is Markdown for the person who got the finding: what can go wrong on the machine, and what to do. Tests and
    the documentation page are made from the examples.
    """

    code: str
    check: Callable[[Facts, Diagnostics], None]
    why: str
    wrong: tuple[Wrong, ...]
    right: tuple[str, ...]
    holds_in_parts: bool = False
    """True when a finding in one file stays one, whatever other files bring."""
