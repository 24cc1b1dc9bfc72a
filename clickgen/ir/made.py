"""The actions that clickgen itself makes: for the syntax of a program, for lowering, and for imported rungs."""

from __future__ import annotations

from collections.abc import Mapping

from clickgen.instructions.coils import OUT
from clickgen.instructions.control import END, FOR, NEXT, NOP, RETURN
from clickgen.instructions.copies import COPY
from clickgen.instructions.raw import NOT_IMPORTED, RAW
from clickgen.ir.operands import Cell, Single
from clickgen.ir.program import Action, KeptToken, Value, Word
from clickgen.text.source import Span

NOP_TOKEN = NOP.variants[0].token
"""The one ladder token that is no call."""
KEPT_EXAMPLE = RAW.example
"""An instruction that the language has no word for, as a program keeps it."""


def coil(bit: Cell, span: Span) -> Action:
    """``out``: the bit follows its rung."""
    return Action(OUT, {"address": bit}, span)


def copy(source: Single, destination: Cell, span: Span, oneshot: Value | None = None) -> Action:
    """A single copy, in one scan alone where there is a ``oneshot``."""
    args: dict[str, Value] = {"source": source, "destination": destination}
    return Action(COPY, args if oneshot is None else {**args, "oneshot": oneshot}, span)


def nothing(span: Span) -> Action:
    """What keeps a rung without outputs legal."""
    return Action(NOP, {}, span)


def ending(is_main: bool, span: Span) -> Action:
    """How a routine ends: ``end()`` in main, ``return`` in a subroutine."""
    return Action(END if is_main else RETURN, {}, span)


def loop_opening(args: Mapping[str, Value], span: Span) -> Action:
    """The ``for`` of a loop."""
    return Action(FOR, args, span)


def loop_closing(span: Span) -> Action:
    """What CLICK needs at the end of a loop's body."""
    return Action(NEXT, {}, span)


def kept(token: KeptToken) -> Action:
    """An instruction that the language has no word for."""
    return Action(RAW, {"token": token}, token.span)


def left_out(reason: str, span: Span) -> Action:
    """The place of a rung that could not be imported."""
    return Action(NOT_IMPORTED, {"reason": Word(reason, span)}, span)
