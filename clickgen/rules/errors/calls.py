"""Every called subroutine exists; only main calls (click-facts [control.call])."""

from __future__ import annotations

from clickgen.facts.facts import Facts
from clickgen.instructions.effects import Flow
from clickgen.ir.program import Program, Routine, Word
from clickgen.problems.diagnostics import Diagnostics, Suggestions
from clickgen.text.wording import quoted


def check(facts: Facts, problems: Diagnostics) -> None:
    called = _Called(facts.program)
    for placed in facts.actions:
        word = placed.action.callee
        if placed.effects.flow is not Flow.CALL or word is None:
            continue
        if not placed.routine.is_main:
            problems.add(
                "CG406",
                placed.action.span,
                f"{placed.routine.name} is a subroutine and cannot call another",
                "call it from main; set a bit here that main's call stands on",
            )
        if word.value in called.names and not word.is_function:
            continue
        # What is a function's name until now is that of none.
        if word.value == "main":
            problems.add("CG405", word.span, "main is not a subroutine", "a subroutine stands under @sub")
        elif not called.is_misimported(word):
            problems.add("CG405", word.span, *called.fault(word))


class _Called:
    """The subroutines that a program has, and what is to be said of a call of another."""

    def __init__(self, program: Program) -> None:
        self._program = program
        self._near = Suggestions()
        self.names = {routine.name for routine in program.subroutines}
        self._titles: dict[str, str] = {}
        """CLICK's names of the subroutines by their functions."""
        self._titled: dict[str, Routine] = {}
        """The subroutines by CLICK's names in small letters."""
        for routine in program.subroutines:
            self._titles.setdefault(routine.function, routine.name)
            self._titled.setdefault(routine.name.lower(), routine)

    def is_misimported(self, word: Word) -> bool:
        """True where the import has the problem; what CLICK calls that subroutine, nobody knows."""
        misimported = self._program.misimported
        if word.is_function:
            return word.value in misimported
        return bool(misimported) and word.value not in self._titles

    def fault(self, word: Word) -> tuple[str, str]:
        """What is wrong with a call of an unknown subroutine, and the way out."""
        name = str(word.value)
        if word.is_function:
            return f"there is no subroutine {name!r}", self._help_for_function(name)
        fault = f"CLICK has no subroutine {name!r}" if name in self._titles else f"there is no subroutine {name!r}"
        return fault, self._help_for_title(name)

    def _help_for_function(self, name: str) -> str:
        offered = self._program.offered
        if name in offered:
            return f"write from {offered[name].module} import {name} at the top"
        titled = self._titled.get(name.lower())
        if titled is not None and titled.function != titled.name:
            return f"its function is {titled.function}: write call({titled.function}), or call({quoted(titled.name)})"
        return self._near(name, self._titles) or f"add @sub def {name}():"

    def _help_for_title(self, name: str) -> str:
        title, offered = self._titles.get(name, ""), self._program.offered
        if title:
            return f"quotes are for CLICK's name: write call({name}), or call({quoted(title)})"
        for function, offer in offered.items():
            if offer.name == name:
                return f"write from {offer.module} import {function} at the top"
        if name in offered:
            return f"write from {offered[name].module} import {name} at the top, and call({name}) without quotes"
        hint = self._near(name, sorted(self.names))
        is_plain = name.isascii() and name.isidentifier()
        return hint or (f"add @sub def {name}():" if is_plain else f"add a subroutine under @sub({quoted(name)})")
