"""Short answers about libcst's nodes: literals, names, arguments, operators, each as the language means it."""

from __future__ import annotations

import re
import unicodedata
import warnings
from collections.abc import Callable, Iterator, Sequence
from typing import Any

import libcst as cst
from libcst._nodes.internal import CodegenState

Node = cst.CSTNode
Elements = Sequence[cst.SubscriptElement]
"""What is between the brackets of a subscript with a comma in them."""
Small = cst.BaseSmallStatement
Statement = cst.BaseSmallStatement | cst.BaseCompoundStatement

ADDRESSES: frozenset[type[Node]] = frozenset((cst.Attribute, cst.Subscript))
LISTS: frozenset[type[Node]] = frozenset((cst.Tuple, cst.List))
_STARRED: frozenset[type[Node]] = frozenset((cst.Arg, cst.StarredElement))
NO_LITERAL = type("NoLiteral", (), {"__repr__": lambda _: "NO_LITERAL"})()
"""In the place of a value, for what is no literal: None is one."""

_WORDS = {"True": True, "False": False, "None": None}
_PLAIN_TEXT = re.compile(r"""[uUrR]?(?:'''(?P<a>.*)'''|\"\"\"(?P<b>.*)\"\"\"|'(?P<c>.*)'|"(?P<d>.*)")""", re.DOTALL)

# -- literals and names -----------------------------------------------------------------------------------------------


def literal(node: object) -> object:
    """The value of a number, a string, True, False, None or ``...``; NO_LITERAL for anything else."""
    read = _LITERALS.get(node.__class__)
    return NO_LITERAL if read is None else read(node)


def _number(node: Any) -> int:
    return int(node.value, 0)


def is_literal(node: object) -> bool:
    """True for a number, a string, True, False, None or ``...``."""
    return literal(node) is not NO_LITERAL


def text_value(node: object) -> str | None:
    """The value of a string literal; None for anything else, also for bytes and f-strings."""
    if node.__class__ is cst.SimpleString or node.__class__ is cst.ConcatenatedString:
        value = literal(node)
        return value if isinstance(value, str) else None
    return None


def whole_number(node: object) -> int | None:
    """The value of an integer literal without a sign; None for anything else."""
    return _number(node) if node.__class__ is cst.Integer else None


def string_pieces(node: Node) -> list[Node]:
    """The strings that are written one after another: one of them in a plain literal."""
    pieces: list[Node] = []
    while isinstance(node, cst.ConcatenatedString):
        pieces.append(node.left)
        node = node.right
    return [*pieces, node]


def has_placeholders(node: Node) -> bool:
    """True for an f-string, also as one of several pieces."""
    return isinstance(node, cst.FormattedString) or (
        isinstance(node, cst.ConcatenatedString)
        and any(isinstance(piece, cst.FormattedString) for piece in string_pieces(node))
    )


def _string(node: cst.SimpleString) -> str | bytes:
    raw = node.value
    if "\\" not in raw:
        plain = _PLAIN_TEXT.fullmatch(raw)
        if plain is not None:
            return str(plain[plain.lastgroup or 0])
    with warnings.catch_warnings():
        # Python warns of escapes that it does not know.
        warnings.simplefilter("ignore")
        return node.evaluated_value


def _concatenated(node: cst.ConcatenatedString) -> object:
    values = [literal(piece) for piece in string_pieces(node)]
    if all(isinstance(value, str) for value in values):
        return "".join(value for value in values if isinstance(value, str))
    if all(isinstance(value, bytes) for value in values):
        return b"".join(value for value in values if isinstance(value, bytes))
    return NO_LITERAL


_LITERALS: dict[type, Callable[[Any], object]] = {
    cst.Name: lambda node: _WORDS.get(node.value, NO_LITERAL),
    cst.Integer: _number,
    cst.Float: lambda node: float(node.value),
    cst.SimpleString: _string,
    cst.ConcatenatedString: _concatenated,
    cst.Imaginary: lambda node: complex(node.value.replace("_", "")),
    cst.Ellipsis: lambda _: ...,
}


def word(node: cst.Name) -> str:
    """A name as Python compares it: letters of one kind, however they are encoded."""
    value = node.value
    return value if value.isascii() else unicodedata.normalize("NFKC", value)


def name_of(node: object) -> str:
    """The identifier that an expression is; "" for anything else, also for True, False and None."""
    # To ask for the class is faster than isinstance, which asks libcst's abstract classes first.
    if node.__class__ is not cst.Name:
        return ""
    assert isinstance(node, cst.Name)
    value = node.value
    return "" if value in _WORDS else value if value.isascii() else word(node)


def is_name(node: object) -> bool:
    """True for an identifier."""
    return node.__class__ is cst.Name and name_of(node) != ""


def dotted(node: Node | None) -> str:
    """``a.b.c`` as a text; "" for None."""
    words: list[str] = []
    while isinstance(node, cst.Attribute):
        words.append(word(node.attr))
        node = node.value
    return ".".join(reversed([*words, name_of(node)]))


# -- parts of expressions ---------------------------------------------------------------------------------------------


def called(node: object) -> str:
    """The name of the function that a call calls; "" for anything else."""
    if node.__class__ is not cst.Call:
        return ""
    assert isinstance(node, cst.Call)
    return name_of(node.func)


def arguments(node: cst.Call) -> list[Node]:
    """The arguments without a name; one with a star in front is given as its whole Arg."""
    return [arg if arg.star else arg.value for arg in node.args if arg.keyword is None and arg.star != "**"]


def values(node: cst.Call) -> list[cst.BaseExpression]:
    """The values of the arguments without a name."""
    return [arg.value for arg in node.args if arg.keyword is None and arg.star != "**"]


def keywords(node: cst.Call) -> list[cst.Arg]:
    """The arguments with a name, and those behind ``**``, whose name is ""."""
    return [arg for arg in node.args if arg.keyword is not None or arg.star == "**"]


def keyword_name(arg: cst.Arg) -> str:
    """The name of an argument; "" for one without."""
    return word(arg.keyword) if arg.keyword is not None else ""


def is_starred(node: Node) -> bool:
    """True for an argument or an element with a star in front."""
    return node.__class__ in _STARRED


def elements(node: Node) -> list[cst.BaseExpression]:
    """The elements of a tuple, a list or a set."""
    if not isinstance(node, cst.Tuple | cst.List | cst.Set):
        return []
    return [one if isinstance(one, cst.StarredElement) else one.value for one in node.elements]


def index_of(node: cst.Subscript) -> Node | Elements:
    """What is between the brackets: an expression, a slice, or the elements with commas between them."""
    only = node.slice[0]
    if len(node.slice) > 1 or only.comma.__class__ is cst.Comma:
        return node.slice
    inner = only.slice
    if isinstance(inner, cst.Slice):
        return inner
    assert isinstance(inner, cst.Index)
    return node.slice if inner.star else inner.value


def comparison(node: cst.Comparison) -> tuple[list[cst.BaseCompOp], list[cst.BaseExpression]]:
    """The operators of a comparison, and what they compare."""
    targets = node.comparisons
    return [target.operator for target in targets], [node.left, *(target.comparator for target in targets)]


def terms(node: cst.BooleanOperation) -> list[cst.BaseExpression]:
    """The terms of ``a and b and c``, which libcst nests; those in parentheses stay together."""
    kind = node.operator.__class__
    found: list[cst.BaseExpression] = []
    left: cst.BaseExpression = node
    while isinstance(left, cst.BooleanOperation) and left.operator.__class__ is kind and not (found and left.lpar):
        found.append(left.right)
        left = left.left
    return [left, *reversed(found)]


_NAMES = {
    cst.Attribute: "attr",
    cst.Arg: "keyword",
    cst.Param: "name",
    cst.FunctionDef: "name",
    cst.ClassDef: "name",
    cst.NameItem: "name",
    cst.ImportAlias: "name",
}
"""Where a Name is a word and no expression."""


def every(node: Node) -> Iterator[Node]:
    """A node and all below it, in no particular order; words that are no expressions are left out."""
    waiting = [node]
    while waiting:
        one = waiting.pop()
        yield one
        name = _NAMES.get(one.__class__)
        skipped = getattr(one, name) if name else None
        waiting += (child for child in one.children if child is not skipped)


# -- statements -------------------------------------------------------------------------------------------------------


def statements(block: cst.BaseSuite) -> list[Statement]:
    """The statements of a block; each of those that share a line."""
    if isinstance(block, cst.SimpleStatementSuite):
        return list(block.body)
    assert isinstance(block, cst.IndentedBlock)
    return in_lines(block.body)


def in_lines(body: Sequence[cst.BaseStatement]) -> list[Statement]:
    """The statements of these lines."""
    found: list[Statement] = []
    for line in body:
        if line.__class__ is cst.SimpleStatementLine:
            assert isinstance(line, cst.SimpleStatementLine)
            found += line.body
        else:
            assert isinstance(line, cst.BaseCompoundStatement)
            found.append(line)
    return found


def on_one_line(node: Node) -> str:
    """An expression as it is written, without the line breaks and comments in it."""
    shown, gap = "", ""
    for token in _tokens(node):
        if token.startswith("#") or not token.strip(" \t\f\n\\"):
            gap = " " if token else gap
            continue
        if token in (")", "]"):
            shown, gap = shown.removesuffix(","), ""
        shown += token if shown.endswith(("(", "[")) else gap + token
        gap = ""
    return shown


def code(node: cst.BaseExpression) -> tuple[str, ...]:
    """What an expression consists of, without the blanks and comments in it and the parentheses around it."""
    tokens = [token for token in _tokens(node) if not token.startswith("#") and token.strip(" \t\f\n\\")]
    return tuple(tokens[len(node.lpar) : len(tokens) - len(node.rpar)])


def _tokens(node: Node) -> list[str]:
    state = CodegenState(default_indent="    ", default_newline="\n")
    node._codegen(state)
    return state.tokens
