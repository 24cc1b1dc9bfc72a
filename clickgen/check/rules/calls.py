"""Every called subroutine exists; only main calls (click-facts, section 5)."""

from __future__ import annotations

from clickgen.check.facts import Facts
from clickgen.diagnostics import Diagnostics, did_you_mean
from clickgen.instructions.control import CALL
from clickgen.ir.program import Program, Word
from clickgen.wording import quoted


def check(facts: Facts, problems: Diagnostics) -> None:
    names = {routine.name for routine in facts.program.subroutines}
    for placed in facts.actions:
        word = placed.action.args.get("subroutine")
        if placed.spec is not CALL or not isinstance(word, Word):
            continue
        if not placed.routine.is_main:
            problems.add(
                "CG406",
                placed.action.span,
                f"{placed.routine.name} is a subroutine and cannot call another",
                "call it from main; set a bit here that main's call stands on",
            )
        if word.value in names and not word.is_function:
            continue
        # What is a function's name until now is that of none.
        if word.value == "main":
            problems.add("CG405", word.span, "main is not a subroutine", "a subroutine stands under @sub")
        elif not _is_misimported(facts.program, word):
            _refuse(facts.program, word, problems)


def _is_misimported(program: Program, word: Word) -> bool:
    """True where the import has the problem; what CLICK calls that subroutine, nobody knows."""
    if word.is_function:
        return word.value in program.misimported
    is_function = any(routine.function == word.value for routine in program.subroutines)
    return bool(program.misimported) and not is_function


def _refuse(program: Program, word: Word, problems: Diagnostics) -> None:
    name = str(word.value)
    if word.is_function:
        problems.add("CG405", word.span, f"there is no subroutine {name!r}", _help_for_function(program, name))
    else:
        fault = f"CLICK has no subroutine {name!r}" if _function(program, name) else f"there is no subroutine {name!r}"
        problems.add("CG405", word.span, fault, _help_for_title(program, name))


def _function(program: Program, name: str) -> str:
    """CLICK's name for the subroutine with this function; "" for none."""
    return next((routine.name for routine in program.subroutines if routine.function == name), "")


def _help_for_function(program: Program, name: str) -> str:
    if name in program.offered:
        return f"write from {program.offered[name].module} import {name} at the top"
    titled = next((routine for routine in program.subroutines if routine.name.lower() == name.lower()), None)
    if titled is not None and titled.function != titled.name:
        return f"its function is {titled.function}: write call({titled.function}), or call({quoted(titled.name)})"
    return did_you_mean(name, [routine.function for routine in program.subroutines]) or f"add @sub def {name}():"


def _help_for_title(program: Program, name: str) -> str:
    title = _function(program, name)
    if title:
        return f"quotes are for CLICK's name: write call({name}), or call({quoted(title)})"
    for function, offer in program.offered.items():
        if offer.name == name:
            return f"write from {offer.module} import {function} at the top"
    if name in program.offered:
        return f"write from {program.offered[name].module} import {name} at the top, and call({name}) without quotes"
    hint = did_you_mean(name, [routine.name for routine in program.subroutines])
    is_plain = name.isascii() and name.isidentifier()
    return hint or (f"add @sub def {name}():" if is_plain else f"add a subroutine under @sub({quoted(name)})")
