"""Every called subroutine exists; only main calls (click-facts [control.call])."""

from __future__ import annotations

from clickgen.dialects.base import Spelling
from clickgen.facts.facts import Facts
from clickgen.instructions.effects import Flow
from clickgen.instructions.offered import CALL
from clickgen.ir.program import Program, Routine, Word
from clickgen.problems.diagnostics import Suggestions
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding


def find(facts: Facts) -> Findings:
    called = _Called(facts.program, facts.spell)
    for placed in facts.actions:
        word = placed.action.callee
        if placed.effects.flow is not Flow.CALL or word is None:
            continue
        if not placed.routine.is_main:
            yield finding(
                "CG406",
                placed.action.span,
                f"{placed.routine.name} is a subroutine and cannot call another",
                "call it from main; set a bit here that main's call stands on",
            )
        if word.value in called.names and not word.is_function:
            continue
        # What is a function's name until now is that of none.
        if word.value == "main":
            yield finding("CG405", word.span, "main is not a subroutine", called.mark)
        elif not called.is_misimported(word):
            yield finding("CG405", word.span, *called.fault(word))


class _Called:
    """The subroutines that a program has, and what is to be said of a call of another."""

    def __init__(self, program: Program, spell: Spelling) -> None:
        self._spell = spell
        self.mark = f"a subroutine begins with {spell.subroutine_mark()}"
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
            return f"write {self._spell.imported(offered[name].module, name)} at the top"
        titled = self._titled.get(name.lower())
        if titled is not None and titled.function != titled.name:
            return f"its function is {titled.function}: write {self._calls(titled.function, titled.name)}"
        return self._near(name, self._titles) or f"add {self._spell.routine(name)}"

    def _help_for_title(self, name: str) -> str:
        title, offered = self._titles.get(name, ""), self._program.offered
        if title:
            return f"quotes are for CLICK's name: write {self._calls(name, title)}"
        for function, offer in offered.items():
            if offer.name == name:
                return f"write {self._spell.imported(offer.module, function)} at the top"
        if name in offered:
            line = self._spell.imported(offered[name].module, name)
            return f"write {line} at the top, and {self._spell.call(CALL, name)} without quotes"
        hint = self._near(name, sorted(self.names))
        is_plain = name.isascii() and name.isidentifier()
        added = self._spell.routine(name) if is_plain else f"a subroutine under {self._spell.subroutine_mark(name)}"
        return hint or f"add {added}"

    def _calls(self, function: str, title: str) -> str:
        """The call of a subroutine by its function, and by CLICK's name."""
        call = self._spell.call
        return f"{call(CALL, function)}, or {call(CALL, self._spell.quoted(title))}"


CODES = (
    Code(
        "CG405",
        Severity.ERROR,
        "no such subroutine",
        """
No `@sub` routine in the program has this name. If the routine is in another file, import it.

Write the function's name without quotes, or the subroutine's name in CLICK in quotes. With `@sub("Auto Mode")` these
differ.
""",
        wrong=(
            Wrong(
                """
if x[1]:
    call(alarms)  # <-
""",
            ),
            Wrong(
                """
@sub("Auto Mode")
def auto_mode():
    if True:
        return


def main():
    if True:
        call("auto_mode")  # <-
        end()
""",
            ),
        ),
        right=(
            """
@sub("Auto Mode")
def auto_mode():
    if True:
        return


def main():
    if c.Start:
        call(auto_mode)
        call("Auto Mode")
    if True:
        end()
""",
        ),
    ),
    Code(
        "CG406",
        Severity.ERROR,
        "a subroutine calls a subroutine",
        """
Only main can call a subroutine. Let this subroutine set a bit, and let main call the other one on that
bit.
""",
        wrong=(
            Wrong(
                """
@sub
def inner():
    if True:
        return


@sub
def outer():
    if True:
        call(inner)  # <-
        return


def main():
    if True:
        call(outer)
        end()
""",
            ),
        ),
        right=(
            """
@sub
def inner():
    if True:
        return


@sub
def outer():
    if True:
        set(c.InnerWanted)
    if True:
        return


def main():
    if True:
        call(outer)
    if c.InnerWanted:
        call(inner)
    if True:
        end()
""",
        ),
    ),
)

RULE = Rule(find, CODES, holds_in_parts=True)
