"""A long file in pieces: Python's syntax tree of a whole file takes a hundred times the memory of its text.

A piece ends before a line that begins a rung: ``if`` at the indentation of the routine's other rungs. What follows is
read as the body of a function of its own. That gives the same statements wherever every piece can be read by itself: a
line inside brackets, inside a string or after a backslash leaves the piece before it broken. A file with a broken piece
is read as a whole, which also says what is wrong with it.
"""

from __future__ import annotations

import ast
import re
import warnings
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from typing import NamedTuple

from clickgen.text.source import SourceFile

LINES = 2000
"""A piece has about so many lines. For each, Python passes the lines before it once more."""
_RUNG = re.compile(r"([ \t]+)if\b")
_HEAD = "def _():\n"

RoutineNode = ast.FunctionDef | ast.AsyncFunctionDef


class Broken(Exception):
    """A piece cannot be read by itself."""


class Statement(NamedTuple):
    """A statement at the top level. ``body`` has the statements of a routine, to be used up before the next one."""

    node: ast.stmt
    body: Iterable[ast.stmt] = ()


def statements_of(tree: ast.Module) -> Iterator[Statement]:
    """The statements of a file that was read as a whole."""
    return (Statement(node, node.body if isinstance(node, RoutineNode) else ()) for node in tree.body)


def statements_in_pieces(source: SourceFile, is_sound: Callable[[ast.Module], bool]) -> Iterator[Statement]:
    """The statements of a long file, read as they are asked for; ``is_sound`` judges the tree of each piece.

    Raises Broken, also while the body of a routine is used up.
    """
    return _Pieces(source, is_sound).statements()


class _Pieces:
    def __init__(self, source: SourceFile, is_sound: Callable[[ast.Module], bool]) -> None:
        self._lines = source.lines
        self._is_sound = is_sound
        self._next = 0
        """The first line that was not read, from 0."""
        self._following: deque[ast.stmt] = deque()
        """Statements of the top level that were read and not asked for."""

    def statements(self) -> Iterator[Statement]:
        self._following.extend(self._read("", ""))
        while self._following:
            node = self._following.popleft()
            if not isinstance(node, RoutineNode):
                yield Statement(node)
                continue
            body = self._body(node)
            yield Statement(node, body)
            deque(body, maxlen=0)
        if self._next < len(self._lines):
            raise Broken

    def _body(self, node: RoutineNode) -> Iterator[ast.stmt]:
        """The statements of a routine; the last of a piece goes on in the next."""
        indent = self._indent_of(node.body[0])
        own, node.body = deque(node.body), []
        while own:
            yield own.popleft()
            if not own and not self._following and self._next < len(self._lines):
                rest, *following = self._read(_HEAD, indent)
                assert isinstance(rest, ast.FunctionDef)
                own.extend(rest.body)
                self._following.extend(following)

    def _indent_of(self, node: ast.stmt) -> str:
        line = self._lines[node.lineno - 1]
        return line[: len(line) - len(line.lstrip())]

    def _read(self, head: str, indent: str) -> list[ast.stmt]:
        """The statements of the next piece, which goes on in a routine with this indentation below its ``head``."""
        start = self._next
        if indent and not self._lines[start].startswith(f"{indent}if"):
            raise Broken
        self._next = self._cut(start, indent)
        text = "\n".join(self._lines[start : self._next])
        before = "\n" * (start - 1) if head else ""
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                tree = ast.parse(f"{before}{head}{text}\n")
        except (SyntaxError, ValueError, RecursionError, MemoryError):
            raise Broken from None
        if not self._is_sound(tree):
            raise Broken
        return tree.body

    def _cut(self, start: int, indent: str) -> int:
        """The line before which the piece ends: that of a rung of the routine that is open there."""
        is_head = False
        for number in range(start, len(self._lines)):
            line = self._lines[number]
            text = line.lstrip(" \t")
            if not text or text.startswith("#"):
                continue
            if text == line:
                indent, is_head = "", text.startswith(("def ", "async def "))
            elif is_head:
                indent, is_head = line[: len(line) - len(text)], False
            match = _RUNG.match(line) if indent and number >= start + LINES else None
            if match and match[1] == indent:
                return number
        return len(self._lines)
