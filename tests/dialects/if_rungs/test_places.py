"""The places of libcst's nodes match those of its own provider, and those of Python's parser."""

from __future__ import annotations

import ast
import re
import warnings
from itertools import accumulate
from pathlib import Path

import libcst as cst
import pytest
from budget import examples
from hypothesis import given, note
from hypothesis import strategies as st
from libcst.metadata import MetadataWrapper, PositionProvider
from mended import found, rung
from strategies.broken import broken_programs, mutants
from strategies.given import Given

from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.nodes import every, literal, terms, text_value
from clickgen.dialects.if_rungs.read.parse import is_statement
from clickgen.dialects.if_rungs.read.places import Places
from clickgen.dialects.if_rungs.read.program import read_file
from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.source import SourceFile

ROOT = Path(__file__).parents[3]
PLACED = (
    cst.BaseExpression,
    cst.Arg,
    cst.BaseSmallStatement,
    cst.BaseCompoundStatement,
    cst.BaseElement,
    cst.BaseSuite,
    cst.Comment,
    cst.SubscriptElement,
)
"""Kinds of nodes that all have a place."""


def offsets(text: str) -> list[int]:
    return [0, *accumulate(len(line) + 1 for line in text.split("\n"))]


def hold_to_the_provider(text: str) -> int:
    """Compare the places of all nodes of a file with the provider's; returns how many there are."""
    module = cst.parse_module(text)
    provided = MetadataWrapper(module, unsafe_skip_copy=True).resolve(PositionProvider)
    starts = offsets(text)
    places = Places()
    head = sum(len(module.code_for_node(line)) for line in module.header)
    end = places.read(module.body, head, "", module.default_indent)
    rest = text[end:]
    assert not rest or re.fullmatch(r"(?:[ \t\f]*(?:#[^\n]*)?\n?)*", rest), rest
    count = 0
    inside = {id(node) for statement in module.body for node in [statement, *_all_below(statement)]}
    for node, position in provided.items():
        if id(node) not in inside:
            continue
        try:
            place = places.of(node)
        except KeyError:
            assert not isinstance(node, PLACED), node
            continue
        start, stop = position.start, position.end
        assert place == (starts[start.line - 1] + start.column, starts[stop.line - 1] + stop.column), node
        count += 1
    return count


def _all_below(node: cst.CSTNode) -> list[cst.CSTNode]:
    found = list(node.children)
    for child in found:
        found += child.children
    return found


@pytest.mark.parametrize("folder", ["fixtures", "clickgen/dialects", "tests/strategies"])
def test_the_files_of_this_project(folder: str) -> None:
    count = 0
    for path in (ROOT / folder).rglob("*.py"):
        text = path.read_text("utf-8", errors="ignore")
        if "\f" in text:
            continue
        try:
            cst.parse_module(text)
        except cst.ParserSyntaxError:
            continue
        count += hold_to_the_provider(text)
    assert count > 1000


ODD = (
    "x = a, b, \n",
    "f( x for x in y )\n",
    "f((x for x in y), *a, k = (1), **b,)\n",
    "x[1,  2 , ]\n",
    "x[(a) : b, *c]\n",
    "( (a) )\n",
    "(a # c\n  . b (\n\n # d\n c, # e\n ) [ 1 ] )\n",
    "if (a): b; c ; # d\nelse: e\n",
    "if a:\n\tb\n\t# c\n# d\nelif b :\n\t\tc ;\nelse :\n\tpass # e\n",
    "f'{a+1:>{w}}x' 'b' f\"{c}\"\n",
    "'a' (\n) if 'b' 'c' else ('d'\n 'e')\n",
    "lambda x, *y, z=1: (yield)\n",
    "lambda : a\n",
    "[*a, (b), ]\n",
    "not  a and ( not b ) or - c not  in d is  not e\n",
    "a < b <= (c) != d\n",
    "a and b and (c and d) and e or f\n",
    "async def f(a, /, b: int = 1, *, c) -> d:\n  async for x in y: pass\n  else: pass\n",
    "@a\n# c\n@b(1)\n\ndef f(): return (x)\n",
    "try:\n  a\nexcept* (b, c) as d:\n  pass\nfinally:\n  pass\n",
    "match a:\n  case [b, *_] if c: pass\n",
    "with (a as b, c): pass\n",
    "from .. a . b import (c as d, e,)\n",
    "x \\\n  = \\\n 1\n",
    '"""a\n  b"""; ü = "é" + ö . ä\n',
    "1_000 + 0x_f + 1.5e3 + 2j + ...\n",
)


@pytest.mark.parametrize("text", ODD)
def test_odd_texts(text: str) -> None:
    assert hold_to_the_provider(text)


@pytest.mark.parametrize("text", ODD)
def test_what_python_says(text: str) -> None:
    """Every expression of Python's tree has the place of one of libcst's nodes."""
    source = SourceFile("p.py", text.rstrip("\n"))
    context = Context(source, Diagnostics())
    assert context.statement() is not None or ";" in text
    if ";" in text and not text.startswith("if"):
        return
    ours = {context.span(node) for root in context.places.roots for node in every(root) if isinstance(node, PLACED)}
    tree = ast.parse(text)
    for node in ast.walk(tree):
        if isinstance(node, ast.expr) and not _is_inside_string(node, tree) and not isinstance(node, ast.Slice):
            start, end = (
                source.column(node.lineno, node.col_offset),
                source.column(node.end_lineno or 0, node.end_col_offset or 0),
            )
            span = source.span(node.lineno, start, node.end_lineno or 0, end)
            if (
                not isinstance(node, ast.Tuple)
                or span in ours
                or text[offsets(text)[span.line - 1] + span.col - 2] != "["
            ):
                assert span in ours, ast.dump(node)


def _is_inside_string(node: ast.expr, tree: ast.Module) -> bool:
    """True for a node in an f-string, whose places differ between Python versions."""
    return any(
        inner is node
        for string in ast.walk(tree)
        if isinstance(string, ast.JoinedStr)
        for inner in ast.walk(string)
        if inner is not string
    )


@given(st.one_of(mutants, broken_programs))
@examples(20)
def test_random_programs(files: Given) -> None:
    note(files.text)
    text = files.text
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            ast.parse(text)
        cst.parse_module(text)
    except (SyntaxError, ValueError, cst.ParserSyntaxError, cst.CSTValidationError):
        return
    if "\f" not in text and "\r" not in text:
        hold_to_the_provider(text)


@pytest.mark.parametrize("operator", ["and", "or"])
def test_long_chains(operator: str) -> None:
    """libcst nests their terms; nothing here recurses as deep."""
    context = Context(SourceFile("p.py", f" {operator} ".join(["x[1]"] * 500)), Diagnostics())
    node = context.expression()
    assert isinstance(node, cst.BooleanOperation)
    found = terms(node)
    assert len(found) == 500
    assert [context.span(term).col for term in found[:3]] == [1, 7 + len(operator), 13 + 2 * len(operator)]


def test_terms_in_parentheses_stay_together() -> None:
    context = Context(SourceFile("p.py", "a and (b and c) and d or e"), Diagnostics())
    node = context.expression()
    assert isinstance(node, cst.BooleanOperation)
    assert [context.text(term) for term in terms(node)] == ["a and (b and c) and d", "e"]
    first = terms(node)[0]
    assert isinstance(first, cst.BooleanOperation)
    assert [context.text(term) for term in terms(first)] == ["a", "b and c", "d"]
    grouped = Context(SourceFile("p.py", "(a and b) and c"), Diagnostics())
    node = grouped.expression()
    assert isinstance(node, cst.BooleanOperation)
    assert [grouped.text(term) for term in terms(node)] == ["a and b", "c"]


@pytest.mark.parametrize(
    "text",
    [
        "1", "0x1F", "0b1_0", "0o7", "00", "1_000", "1.5", "1e3", ".5", "2j", "True", "False", "None", "...",
        '"a"', "'a'", '"""a\nb"""', "r'\\n'", "u'a'", "b'a'", "'\\n\\x41\\N{BULLET}'", "'\\d'", "'a' \"b\" '''c'''",
        "''", "b'a' b'b'", "'it''s'", 'R"""a"b"""', "'\\\n'",
    ],
)  # fmt: skip
def test_the_values_of_literals(text: str) -> None:
    context = Context(SourceFile("p.py", f"({text})"), Diagnostics())
    node = context.expression()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        value = ast.literal_eval(text)
    assert literal(node) == value
    assert type(literal(node)) is type(value)
    if isinstance(value, str):
        assert text_value(node) == value
        assert context.embedded(node).value == value if node is not None else False


@pytest.mark.parametrize("text", ["a", "f'a'", "'a' f'{b}'", "-1", "a.b", "(1, 2)", "__debug__"])
def test_what_is_no_literal(text: str) -> None:
    assert repr(literal(Context(SourceFile("p.py", text), Diagnostics()).expression())) == "NO_LITERAL"


DEEP = {
    "terms": " and ".join(["a"] * 501),
    "strings": " ".join(["'a'"] * 501),
    "strings on lines": "(" + "\n".join(["'a'"] * 501) + ")",
    "parentheses in an index": "a[" * 101 + "b" + "]" * 101,
    "loops of a comprehension": "[a " + "for a in b " * 101 + "]",
    "points": ".".join(["a"] * 102),
    "points of an import": "import " + ".".join(["a"] * 102),
    "signs": "-" * 101 + "1",
    "parentheses": "(" * 101 + "a" + ")" * 101,
    "parentheses around calls": "f((" * 60 + "a" + "))" * 60,
    "an f-string": "f'a' " + " ".join(["'a'"] * 501),
}


@pytest.mark.parametrize("name", DEEP)
def test_what_libcst_may_not_read(name: str) -> None:
    """Its parser recurses with every level, and ends the process if that is too deep."""
    assert not is_statement(DEEP[name])


@pytest.mark.parametrize("name", ["terms", "strings", "strings on lines", "loops of a comprehension"])
def test_one_less_is_read(name: str) -> None:
    less = (
        DEEP[name].replace(" and a", "", 1).replace("'a' ", "", 1).replace("'a'\n", "", 1).replace("for a in b ", "", 1)
    )
    assert is_statement(less)
    assert Context(SourceFile("p.py", less), Diagnostics()).expression() is not None


# libcst 1.9.0 asks in vain whether these may be directly beside a word.
@pytest.mark.parametrize("condition", ["not(lambda: x[1])", "not(x[1] if x[2] else x[3])", "x[1] and(lambda: x[2])"])
def test_a_word_directly_beside_a_parenthesis(condition: str, tmp_path: Path) -> None:
    (refused,) = found(rung(condition), "CG101", tmp_path)
    assert refused.help == "put a blank between the word and the parenthesis beside it"
    assert not found(rung(condition.replace("(", " (")), "CG101", tmp_path)


@pytest.mark.parametrize("index", ["*a, b", "a, b", "a,", "1:2, b"])
def test_several_things_between_brackets_have_a_place_in_every_statement(index: str) -> None:
    """libcst writes out the statements of a loop itself, and its elements of a subscript are not one node together."""
    spans = []
    for head in ("    if x[2]:\n", "    for _ in range(2):\n        if x[2]:\n"):
        indent = " " * (4 * head.count("\n") + 4)
        source = SourceFile("p.py", f"def main():\n  if x[1]:\n{head}{indent}ton(t[{index}], 5)\n")
        problems = Diagnostics()
        read_file(source, problems)
        (problem,) = [one for one in problems.found if one.code == "CG113"]
        assert problem.span is not None
        text = source.line(problem.span.line)
        spans.append(text[problem.span.col - 1 : problem.span.end_col - 1])
    assert spans == [index, index]
