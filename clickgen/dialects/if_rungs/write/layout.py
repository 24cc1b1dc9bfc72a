"""Lays out source text as ``ruff format`` does: on one line if it fits, else inside its brackets."""

from __future__ import annotations

from dataclasses import dataclass

WIDTH = 88
INDENT = "    "


@dataclass(frozen=True, slots=True)
class Atom:
    """A piece that is never divided."""

    text: str


@dataclass(frozen=True, slots=True)
class Brackets:
    """``all(...)`` or ``[...]``: parts between an opening, with the text before it, and a closing."""

    opening: str
    parts: tuple[Piece, ...]
    closing: str


@dataclass(frozen=True, slots=True)
class Keyword:
    """``reset=`` or ``lambda: `` before a piece."""

    text: str
    piece: Piece


@dataclass(frozen=True, slots=True)
class Comparison:
    """``ds.Level >= ds.High``, which may be divided before its operator."""

    left: str
    op: str
    right: str


Piece = Atom | Brackets | Keyword | Comparison


def flat(piece: Piece) -> str:
    """Return a piece on one line."""
    if isinstance(piece, Atom):
        return piece.text
    if isinstance(piece, Keyword):
        return piece.text + flat(piece.piece)
    if isinstance(piece, Comparison):
        return f"{piece.left} {piece.op} {piece.right}"
    return f"{piece.opening}{', '.join(map(flat, piece.parts))}{piece.closing}"


def lines(piece: Piece, depth: int, before: str = "", after: str = "") -> list[str]:
    """Return the lines of a piece at a depth of indentation, with the text before and after it."""
    indent = INDENT * depth
    whole = f"{indent}{before}{flat(piece)}{after}"
    if len(whole) <= WIDTH or isinstance(piece, Atom):
        return [whole]
    if isinstance(piece, Keyword):
        return lines(piece.piece, depth, before + piece.text, after)
    if isinstance(piece, Comparison):
        return _divided(piece, depth, before, after)
    return [f"{indent}{before}{piece.opening}", *_inside(piece, depth + 1), f"{indent}{piece.closing}{after}"]


def _inside(piece: Brackets, depth: int) -> list[str]:
    """Return the parts of brackets that do not fit on one line: the arguments of a call on one line, or on one each.

    A single argument that cannot be divided has no comma after it.
    """
    together = f"{INDENT * depth}{', '.join(map(flat, piece.parts))}"
    is_only_atom = len(piece.parts) == 1 and isinstance(piece.parts[0], Atom)
    if piece.closing == ")" and (len(together) <= WIDTH or is_only_atom):
        return [together]
    return [line for part in piece.parts for line in lines(part, depth, after=",")]


def _divided(piece: Comparison, depth: int, before: str, after: str) -> list[str]:
    """Return a comparison in two lines: as an argument without brackets, after ``if`` and ``lambda:`` with them."""
    indent = INDENT * depth
    if not before:
        return [f"{indent}{piece.left}", f"{indent}{piece.op} {piece.right}{after}"]
    inner = INDENT * (depth + 1)
    whole = f"{inner}{flat(piece)}"
    parts = [whole] if len(whole) <= WIDTH else [f"{inner}{piece.left}", f"{inner}{piece.op} {piece.right}"]
    return [f"{indent}{before}(", *parts, f"{indent}){after}"]
