"""The shape of a rule: it takes facts and returns findings, and declares its codes."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

from clickgen.facts.facts import Facts
from clickgen.problems.codes import Severity
from clickgen.problems.declared import Code, Wrong
from clickgen.problems.diagnostics import Diagnostic, Label
from clickgen.text.edits import Fix
from clickgen.text.source import Span

__all__ = ["Code", "Findings", "Rule", "Severity", "Wrong", "finding"]

Findings = Iterator[Diagnostic]


@dataclass(frozen=True)
class Rule:
    """A rule sees the facts alone: no finding of another rule, so the order of rules does not matter.

    Most rules have one code. A rule has several where one walk over the program finds all of them.
    """

    find: Callable[[Facts], Iterable[Diagnostic]]
    codes: tuple[Code, ...]
    also: tuple[str, ...] = ()
    """Codes that the rule reports and that another rule, or a page of ``problems/explanations``, declares."""
    holds_in_parts: bool = False
    """True when a finding in one file stays one, whatever other files bring."""

    def is_wanted(self, wants: Callable[[str], bool]) -> bool:
        """True when one of its codes is wanted."""
        return any(wants(code) for code in (*(code.name for code in self.codes), *self.also))


def finding(
    code: str,
    span: Span | None,
    message: str,
    help: str = "",
    labels: tuple[Label, ...] = (),
    fix: Fix | None = None,
) -> Diagnostic:
    """Something that a rule found, with its place and the way out."""
    return Diagnostic(code, message, span, help, labels, fix)
