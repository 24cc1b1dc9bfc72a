"""Routines to the text of a program, laid out as ``ruff format`` does it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from clickgen.importing.layout import INDENT, Brackets, Keyword, Piece, lines
from clickgen.importing.pieces import Names, WithNames, action_piece, condition_piece, value_piece
from clickgen.ir.program import Action, Branch, Item, Loop, Routine, Rung

NO_NAMES: Names = {}


def write_source(routines: Iterable[Routine], names: Names = NO_NAMES, header: str = "") -> str:
    """The text of a file with these routines; ``names`` are the nicknames to write in place of addresses.

    ``header`` stands above: a docstring, imports, declarations.
    """
    parts = [header.rstrip("\n")] if header else []
    parts += ["\n".join(routine_lines(routine, names)) for routine in routines]
    return "\n\n\n".join(parts) + "\n"


def routine_lines(routine: Routine, names: Names = NO_NAMES) -> list[str]:
    """A routine, blank lines between its rungs."""
    head = [f"def {routine.name}():"] if routine.is_main else ["@sub", f"def {routine.name}():"]
    named = WithNames(names).rungs(routine.rungs)
    return [*head, *(_rungs(named, 1) or [f"{INDENT}pass"])]


def comment_lines(comment: str, depth: int = 0) -> list[str]:
    """A rung comment as the block that is read as the same comment, but for spaces at the ends of lines."""
    if not comment:
        return []
    shown = (line.rstrip() for line in comment.split("\n"))
    return [f"{INDENT * depth}# {line}".rstrip() for line in shown]


def _rungs(rungs: Sequence[Rung], depth: int) -> list[str]:
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
        body = _rungs(item.body, depth + 1) if item.body else [f"{INDENT * (depth + 1)}pass"]
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
