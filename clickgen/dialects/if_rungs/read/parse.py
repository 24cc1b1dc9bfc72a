"""Bytes to text, and what Python's own parser says of a text. A program is read and never run.

libcst reads programs (`statements.py`). Python's parser says first whether a text is Python, in its own words if not,
and where its statements are. What is nested so deeply or has so many terms that a walk over its tree could fail is
refused here.
"""

from __future__ import annotations

import ast
import io
import re
import tokenize
import warnings
from collections.abc import Callable, Iterator
from contextlib import suppress

from clickgen.device.project_file import no_program
from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.source import FORM_FEED, SourceFile, Span

SPLIT = "split it into several rungs"
MAX_DEPTH = 100
"""How deep the syntax tree may be: far beyond any rung, and safe for every recursive walk."""
_TERMS_MAX = 500
"""Terms of one ``and`` or ``or``, and pieces of one string: level for Python and nested for libcst.

libcst's parser takes about 1.3 kilobytes of the stack for each; where it has none left, the process ends.
"""
TOO_DEEP = f"this is nested more than {MAX_DEPTH} levels deep, or has more than {_TERMS_MAX} terms"
_BITS_MAX = 64
"""CLICK's largest integers have 32 bits (click-facts [value.integers]). Past some thousand digits Python cannot even
print one."""
_LARGEST = "DD holds -2147483648..2147483647; DF holds larger numbers, written 1.0E+12"
_LONG_NUMBER = re.compile(r"[0-9A-Fa-f_]{17,}")
"""No literal of more than 64 bits is shorter than this in hexadecimal, the densest notation."""


def decode(path: str, data: bytes, problems: Diagnostics) -> SourceFile | None:
    """The source file behind these bytes (UTF-8, with or without a byte order mark), or None with a problem."""
    foreign = no_program(data, path)
    if foreign is not None:
        kind, way = foreign
        problems.add("CG101", Span(path, 1, 1, 1, 2), f"this is {kind}, and no program", way)
        return None
    data = data.removeprefix(b"\xef\xbb\xbf")
    try:
        text = _lines(data.decode())
    except UnicodeDecodeError as error:
        if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
            problems.add("CG101", Span(path, 1, 1, 1, 2), "the file is UTF-16, not UTF-8", "save it as UTF-8")
            return None
        before = _lines(data[: error.start].decode())
        line = before.count("\n") + 1
        col = len(before) - before.rfind("\n")
        problems.add(
            "CG101",
            Span(path, line, col, line, col + 1),
            f"the file is not UTF-8 text: byte 0x{data[error.start]:02X} here",
            "save the file as UTF-8 in your editor",
        )
        return None
    # For Python a form feed begins its line anew; without them a line is what an editor shows.
    return SourceFile(path, FORM_FEED.sub("", text))


def _lines(text: str) -> str:
    """Text with one kind of line end."""
    return text.replace("\r\n", "\n").replace("\r", "\n")


def parse_tree(source: SourceFile, problems: Diagnostics) -> ast.Module | None:
    """The syntax tree of a source file, or None with a CG101 or CG118 problem."""
    if "\0" in source.text:
        before = source.text[: source.text.index("\0")]
        line, col = before.count("\n") + 1, len(before) - before.rfind("\n")
        span = source.span(line, col, line, col + 1)
        problems.add("CG101", span, "the file holds a NUL character", "save the file as plain UTF-8 text")
        return None
    try:
        tree = _parsed(source.text)
    except SyntaxError as error:
        _syntax_problem(source, error, problems)
        return None
    except (RecursionError, MemoryError):
        problems.add("CG118", source.span(1, 1, 1, 2), "the program is nested too deeply to be read", SPLIT)
        return None
    deep = _too_deep(tree, source.lines)
    if deep is not None:
        line = getattr(deep, "lineno", 1)
        col = source.column(line, getattr(deep, "col_offset", 0))
        problems.add("CG118", source.span(line, col, line, col + 1), TOO_DEEP, SPLIT)
        return None
    return None if _report_huge(source, tree, problems) else tree


def sound_tree(source: SourceFile) -> ast.Module | None:
    """Python's tree of a file that libcst may read; None for any other."""
    try:
        tree = _parsed(source.text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None
    return tree if _too_deep(tree, source.lines) is None else None


def soundness(source: SourceFile) -> Callable[[ast.Module], bool]:
    """Tells of a part of the file whether every walk can go down its tree, and every number in it can be shown."""
    may_be_endless = _LONG_NUMBER.search(source.text) is not None
    return lambda tree: _too_deep(tree, source.lines) is None and not (may_be_endless and any(_endless_numbers(tree)))


def is_statement(text: str) -> bool:
    """True for the text of one statement that libcst may read."""
    try:
        tree = _parsed(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return False
    return len(tree.body) == 1 and _too_deep(tree, text.split("\n")) is None and deep_bracket(text) is None


def _parsed(text: str) -> ast.Module:
    with warnings.catch_warnings():
        # Of escapes in strings, for one.
        warnings.simplefilter("ignore")
        return ast.parse(text)


def _report_huge(source: SourceFile, tree: ast.Module, problems: Diagnostics) -> bool:
    """Report every integer that no register can hold and no message can show; True when there is one."""
    numbers = list(_endless_numbers(tree)) if _LONG_NUMBER.search(source.text) else []
    for node, bits in numbers:
        start, end = (source.column(node.lineno, offset) for offset in (node.col_offset, node.end_col_offset or 0))
        fault = f"this number has {bits} bits; CLICK's largest integers have 32"
        problems.add("CG113", source.span(node.lineno, start, node.lineno, end), fault, _LARGEST)
    return bool(numbers)


def _endless_numbers(tree: ast.Module) -> Iterator[tuple[ast.Constant, int]]:
    """The integers that are too large, and how many bits they have."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and type(node.value) is int and node.value.bit_length() > _BITS_MAX:
            yield node, node.value.bit_length()


def _syntax_problem(source: SourceFile, error: SyntaxError, problems: Diagnostics) -> None:
    line = min(max(error.lineno or 1, 1), len(source.lines))
    col = min(max(error.offset or 1, 1), len(source.line(line)) + 1)
    end_line, end_col = error.end_lineno or line, error.end_offset or col + 1
    if (end_line, end_col) <= (line, col) or end_line != line:
        end_line, end_col = line, col + 1
    if "too many" in error.msg:  # levels of indentation, nested parentheses
        problems.add("CG118", source.span(line, col, line, col + 1), f"this is nested too deeply: {error.msg}", SPLIT)
        return
    if error.msg.startswith("Exceeds the limit"):  # of digits
        fault = "this number is too long: CLICK's largest integers have 32 bits"
        problems.add("CG113", source.span(line, col, end_line, end_col), fault, _LARGEST)
        return
    # Heavy, and needed for a file with a fault alone.
    from clickgen.dialects.if_rungs.ways_out.slips import said_otherwise, slip

    known = slip(source, line, error.msg)
    if known is not None:
        message, span, help, fix = known
        problems.add("CG101", span, message, help, fix=fix)
        return
    general = (
        f"Python cannot read this: {error.msg}",
        "a program has Python's syntax: look at this line and the one above",
    )
    problems.add("CG101", source.span(line, col, end_line, end_col), *(said_otherwise(error.msg) or general))


def _too_deep(tree: ast.Module, lines: list[str]) -> ast.AST | None:
    """The first node below the depth limit, or with too much on one level, found without recursion.

    Each level of an expression takes at least one character, so short ones need no walk.
    """
    waiting: list[tuple[ast.AST, int]] = [(tree, 0)]
    while waiting:
        node, depth = waiting.pop()
        if depth > MAX_DEPTH or (node.__class__ in _LONG and _is_long(node, lines)):
            return node
        if isinstance(node, ast.expr) and _is_short(node, MAX_DEPTH - depth):
            continue
        for value in node.__dict__.values():
            if value.__class__ is list:
                waiting += [(item, depth + 1) for item in value if isinstance(item, ast.AST)]
            elif isinstance(value, _NESTED):
                waiting.append((value, depth + 1))
    return None


def _is_short(node: ast.expr, characters: int) -> bool:
    return node.lineno == node.end_lineno and (node.end_col_offset or 0) - node.col_offset < characters


_NESTED = (ast.expr, ast.arguments, ast.pattern)
_COMPREHENSIONS = (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)
_LONG = frozenset((ast.BoolOp, ast.Constant, ast.JoinedStr, ast.Import, ast.ImportFrom, *_COMPREHENSIONS))


def _is_long(node: ast.AST, lines: list[str]) -> bool:
    """True for what is level for Python, nested for libcst, and longer than anybody writes it."""
    if isinstance(node, ast.BoolOp):
        return len(node.values) > _TERMS_MAX
    if isinstance(node, _COMPREHENSIONS):
        return len(node.generators) > MAX_DEPTH
    if isinstance(node, ast.Import | ast.ImportFrom):
        dots = [getattr(node, "module", None) or "", *(alias.name for alias in node.names)]
        return any(name.count(".") > MAX_DEPTH for name in dots)
    if isinstance(node, ast.JoinedStr) or (isinstance(node, ast.Constant) and isinstance(node.value, str | bytes)):
        text = "\n".join(lines[node.lineno - 1 : node.end_lineno])
        return min(len(text), text.count('"') + text.count("'")) > 2 * _TERMS_MAX and _strings(text) > _TERMS_MAX
    return False


def deep_bracket(text: str) -> tuple[int, int] | None:
    """The line and column of the first bracket below the depth limit; None without one.

    Parentheses alone make no level in Python's tree.
    """
    if text.count("(") + text.count("[") + text.count("{") <= MAX_DEPTH:
        return None
    depth = 0
    for token in _tokens(text):
        depth += (token.string in _OPENING) - (token.string in _CLOSING)
        if depth > MAX_DEPTH:
            return token.start[0], token.start[1] + 1
    return None


_OPENING = frozenset("([{")
_CLOSING = frozenset(")]}")


def _strings(text: str) -> int:
    """How many strings there are on these lines, which may begin and end inside brackets."""
    return sum(
        token.type == tokenize.STRING or tokenize.tok_name[token.type] == "FSTRING_START" for token in _tokens(text)
    )


def _tokens(text: str) -> Iterator[tokenize.TokenInfo]:
    """The tokens of a text, as far as it is whole."""
    with suppress(tokenize.TokenError, SyntaxError):
        yield from tokenize.generate_tokens(io.StringIO(text).readline)
