"""Statements read one by one are as in the whole file; and cases in which libcst and Python disagree."""

from __future__ import annotations

import ast

import libcst as cst
import pytest

from clickgen.dialects.if_rungs.read.program import read_file
from clickgen.dialects.if_rungs.read.statements import Layout, layout_of
from clickgen.ir.program import Action, Routine, Word
from clickgen.problems.diagnostics import Diagnostic, Diagnostics
from clickgen.text.source import SourceFile

END = "    if True:\n        end()\n"


def problems_of(text: str) -> list[Diagnostic]:
    problems = Diagnostics()
    read_file(SourceFile("p.py", text), problems)
    return list(problems.in_order())


def routines_of(text: str) -> list[Routine]:
    problems = Diagnostics()
    content = read_file(SourceFile("p.py", text), problems)
    assert content is not None
    assert not problems.found
    return [item for item in content.items if isinstance(item, Routine)]


def layout(text: str) -> Layout:
    found = layout_of(SourceFile("p.py", text))
    assert found is not None
    return found


# -- layout -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "body",
    [
        "    if x[1]:\n        out(y[1])\n",
        "  if x[1]:\n     out(y[1])\n",
        "\tif x[1]:\n\t\tout(y[1])\n",
        "    if x[1]: out(y[1])\n",
        "    if x[1]: out(y[1]);\n",
        "    if x[1]:\n        out(y[1]); out(y[2])\n",
        "    if x[1]: \\\n        out(y[1])\n",
        "    if x[1]:\n        out(y[1]) \\\n\n",
        "    if (\n  x[1]\n# margin\n            ):\n        out(y[1])\n",
        "    if x[1]:\n        out(\n  y[1],\n)\n",
        "    if x[1]:\n        pass;\n",
    ],
)
def test_layouts_of_rungs(body: str) -> None:
    [routine] = routines_of(f"def main():\n{body}{body}")
    one, other = routine.rungs
    lines = body.count("\n")
    assert other.span.line - one.span.line == lines
    assert other.span._replace(line=one.span.line, end_line=one.span.end_line) == one.span
    assert type(one.condition) is type(other.condition)


def test_the_text_in_quotes_keeps_its_indentation() -> None:
    text = 'def main():\n    if x[1]:\n        not_imported("""a\n            b\n\tc""")\n' + END
    [routine] = routines_of(text)
    [action] = routine.rungs[0].items
    assert isinstance(action, Action)
    [word] = action.args.values()
    assert isinstance(word, Word)
    assert word.value == "a\n            b\n\tc"


@pytest.mark.parametrize(
    "text",
    [
        "def main(): pass\n",
        'def main(): """Nothing."""\n',
        "def main(): pass; pass\n",
        "def main(): \\\n  pass\n",
        "def main():  # note\n    # and\n\n    pass\n",
        '"""A text."""; nickname(x.A, x[1])\n\n\ndef main():\n' + END,
        "nickname(x.A, x[1]); nickname(x.B, x[2])  # both\ndef main():\n" + END,
        "nickname(x.A, x[1])\n# C:\\\nnickname(x.B, x[2])\ndef main():\n" + END,
        "nickname(\n    x.A,  # a\n    x[1],\n)\n@sub\n# note\n\ndef a():\n    if True: return\ndef main():\n" + END,
        "@sub(\n    'Auto'\n)\ndef a(\n):\n    # note\n    if True:\n        return\ndef main():\n" + END,
        "def main():\n" + END + "    # below\n# and at the margin\n",
        "def main():\n    '''A text.\n# no comment\n'''\n" + END.rstrip("\n"),
        "# only\n",
        "",
    ],
)  # fmt: skip
def test_every_line_is_in_one_part(text: str) -> None:
    assert not problems_of(text)
    found = layout(text)
    assert "".join(found.text(part) for part in found.parts).rstrip("\n") == text.rstrip("\n")
    ends = [(part.start, part.last) for part in found.parts]
    assert [start for start, _ in ends[1:]] == [last for _, last in ends[:-1]]
    comments = [comment.text for part in found.parts for comment in found.comments(part)]
    module = cst.parse_module(text)
    assert sorted(comments) == sorted(node.value for node in _below(module) if isinstance(node, cst.Comment))


def _below(node: cst.CSTNode) -> list[cst.CSTNode]:
    return [node, *(inner for child in node.children for inner in _below(child))]


def test_where_comments_are() -> None:
    text = 'x = """\n# no\n"""  # one\nif (  # two\n    # three\n    a\n):\n    b  # fünf é\n    # six\n'
    found = layout(text)
    comments = [comment for part in found.parts for comment in found.comments(part)]
    assert [(one.line, one.col, one.stands_alone) for one in comments] == [
        (3, 6, False),
        (4, 7, False),
        (5, 5, True),
        (8, 8, False),
        (9, 5, True),
    ]


# -- where libcst and Python disagree ---------------------------------------------------------------------------------

REFUSED_BY_PYTHON = {
    "bytes beyond ASCII": "b'é'",
    "an unknown name of a character": "'\\N{foo}'",
    "half an escape": "'\\x1'",
}
"""Python's parser comes first, so a text that only libcst takes is not a program."""


@pytest.mark.parametrize("name", REFUSED_BY_PYTHON)
def test_what_only_libcst_takes(name: str) -> None:
    text = REFUSED_BY_PYTHON[name]
    cst.parse_statement(text)
    with pytest.raises(SyntaxError):
        ast.parse(text)
    [problem] = problems_of(f"{text}\n")
    assert problem.code == "CG101"


ONLY_PYTHON = {
    "a tab after a block indented by blanks": "def main():\n    if c.A:\n\t        out(c.B)\n\n" + END,
    "a backslash before the first line of a block": "def main():\n    if c.A:\n        \\\n      out(c.B)\n" + END,
}


@pytest.mark.parametrize("name", ONLY_PYTHON)
def test_what_only_python_takes(name: str) -> None:
    """It is refused with a message where libcst 1.9 cannot read it."""
    text = ONLY_PYTHON[name]
    ast.parse(text)
    [problem] = problems_of(text)
    assert problem.code == "CG101"
    assert problem.message.startswith(("this cannot be read: ", "tabs and spaces are mixed"))
    assert problem.help


def test_brackets_that_are_too_deep() -> None:
    """Python's tree has no levels for parentheses, but libcst's parser recurses with each."""
    deep = f"def main():\n    if {'(' * 101}c.A{')' * 101}:\n        out(c.B)\n{END}"
    [problem] = problems_of(deep)
    assert (problem.code, problem.span) == ("CG118", SourceFile("p.py", deep).span(2, 108, 2, 109))
    assert not problems_of(deep.replace("(" * 101, "(" * 99).replace(")" * 101, ")" * 99))


def test_names_are_compared_as_python_compares_them() -> None:
    """Python's tree has one form of each letter; libcst's has the written one."""
    text = "def main():\n    if c.ﬁll:\n        out(c.Ⅳ)\n" + END
    [routine] = routines_of(text)
    assert "name='fill'" in repr(routine.rungs[0].condition)
    assert "name='IV'" in repr(routine.rungs[0].items)


def test_indentation_is_lost_in_a_single_statement() -> None:
    """parse_statement has no indentation of its own: None means that of the first block, whatever that is."""
    tree = cst.parse_statement("if a:\n  b\n")
    assert isinstance(tree, cst.If)
    assert isinstance(tree.body, cst.IndentedBlock)
    assert tree.body.indent is None
    assert cst.Module([]).code_for_node(tree) == "if a:\n    b\n"
