"""Writes routines as the text of a program, laid out as ``ruff format`` does."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from clickgen.dialects.if_rungs.write.expressions import (
    Names,
    WithNames,
    action_piece,
    condition_piece,
    quoted,
    value_piece,
)
from clickgen.dialects.if_rungs.write.layout import INDENT, Brackets, Keyword, Piece, lines
from clickgen.instructions.effects import Flow
from clickgen.ir.program import Action, Branch, Item, Loop, Routine, Rung, Value, Word
from clickgen.ir.walk import Rewriter

Functions = Mapping[str, str]
"""The functions of subroutines by CLICK's names; one that is missing is called by its name in quotes."""

NO_NAMES: Names = {}
NO_FUNCTIONS: Functions = {}


def write_source(
    routines: Iterable[Routine], names: Names = NO_NAMES, header: str = "", functions: Functions = NO_FUNCTIONS
) -> str:
    """Return the text of a file with these routines; ``names`` are the nicknames to write in place of addresses.

    ``header`` goes above: a docstring, imports, declarations. ``functions`` are those that it imports.
    """
    routines = tuple(routines)
    functions = {**functions, **functions_of(routines)}
    parts = [header.rstrip("\n")] if header else []
    parts += ["\n".join(routine_lines(routine, names, functions)) for routine in routines]
    return "\n\n\n".join(parts) + "\n"


def functions_of(routines: Iterable[Routine]) -> Functions:
    """The functions of these routines in the source, by CLICK's names."""
    return {routine.name: routine.function for routine in routines if not routine.is_main}


def routine_lines(routine: Routine, names: Names = NO_NAMES, functions: Functions = NO_FUNCTIONS) -> list[str]:
    """Return the lines of a routine, with blank lines between its rungs."""
    title = "" if routine.function == routine.name else f"({quoted(routine.name)})"
    head = [f"def {routine.function}():"]
    rungs = _WithFunctions(functions).rungs(WithNames(names).rungs(routine.rungs))
    return [*([] if routine.is_main else [f"@sub{title}"]), *head, *(rung_lines(rungs, 1) or [f"{INDENT}pass"])]


class _WithFunctions(Rewriter):
    """A program that calls subroutines by their functions."""

    def __init__(self, functions: Functions) -> None:
        self._functions = functions

    def action(self, action: Action) -> Action:
        if action.effects.flow is not Flow.CALL:
            return action
        return Action(action.spec, {name: self.value(value) for name, value in action.args.items()}, action.span)

    def value(self, value: Value) -> Value:
        function = self._functions.get(str(value.value)) if isinstance(value, Word) else None
        return value if function is None else Word(function, value.span, is_function=True)


def comment_lines(comment: str, depth: int = 0) -> list[str]:
    """Return a rung comment as the block that reads as the same comment, except for spaces at the ends of lines."""
    shown = [line.rstrip() for line in comment.split("\n")]
    if shown == [""]:
        return []
    return [f"{INDENT * depth}# {line}".rstrip() for line in shown]


def rung_lines(rungs: Sequence[Rung], depth: int = 0) -> list[str]:
    """Return rungs with blank lines between them; addresses are written as they are in the rungs."""
    written: list[str] = []
    for rung in rungs:
        written += [""] if written else []
        written += comment_lines(rung.comment, depth)
        written += _if(condition_piece(rung.condition), rung.items, depth)
    return written


def _if(condition: Piece, items: Sequence[Item], depth: int) -> list[str]:
    head = lines(condition, depth, "if ", ":")
    return [*head, *(line for item in items for line in _item(item, depth + 1))]


def _item(item: Item, depth: int) -> list[str]:
    if isinstance(item, Branch):
        return _if(condition_piece(item.condition), item.items, depth)
    if isinstance(item, Loop):
        body = rung_lines(item.body, depth + 1) if item.body else [f"{INDENT * (depth + 1)}pass"]
        return [*lines(_counted(item.action), depth, after=":"), *body]
    return lines(action_piece(item), depth)


def _counted(action: Action) -> Piece:
    """``for _ in range(ds.Count, oneshot=True)``"""
    parts: list[Piece] = []
    for param in action.spec.params:
        if param.name in action.args:
            piece = value_piece(action, param)
            parts.append(piece if param.name == "count" else Keyword(f"{param.name}=", piece))
    return Brackets("for _ in range(", tuple(parts), ")")
