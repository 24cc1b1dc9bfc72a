"""The comment of a rung: the lines directly above it, also in a file that is read statement by statement."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator
from pathlib import Path

import libcst
import pytest
from hypothesis import given
from hypothesis import strategies as st

from clickgen.dialects.if_rungs.read.nodes import statements
from clickgen.dialects.if_rungs.read.program import read_file
from clickgen.ir.program import Routine, rungs_in
from clickgen.problems.diagnostics import Diagnostics
from clickgen.problems.silence import DIRECTIVE
from clickgen.text.source import SourceFile

FIXTURES = sorted((Path(__file__).parents[3] / "fixtures").rglob("*.py"))


def ours(text: str) -> list[str]:
    """The comments of all rungs of a file, in its order."""
    content = read_file(SourceFile("prog.py", text), Diagnostics())
    assert content is not None
    routines = (item for item in content.items if isinstance(item, Routine))
    return [rung.comment for routine in routines for rung in rungs_in(routine.rungs)]


def of_block(text: str) -> list[str]:
    """The comments of the rungs of a block."""
    return ours(f"def main():\n{textwrap.indent(text, '    ', lambda line: line.strip() != '')}")


def whole(text: str) -> list[str]:
    """The same from libcst's tree of the whole file."""
    module = libcst.parse_module(text)
    routines = (node for node in module.body if isinstance(node, libcst.FunctionDef))
    return [theirs(rung) for routine in routines for rung in rungs_of(routine.body)]


def rungs_of(block: libcst.BaseSuite) -> Iterator[libcst.If]:
    """The rungs of a routine or a loop, each followed by those of the loops in it."""
    for node in statements(block):
        if isinstance(node, libcst.If):
            yield node
            yield from in_branches(node)


def in_branches(node: libcst.If) -> Iterator[libcst.If]:
    for inner in statements(node.body):
        if isinstance(inner, libcst.If):
            yield from in_branches(inner)
        elif isinstance(inner, libcst.For):
            yield from rungs_of(inner.body)


def theirs(node: libcst.If) -> str:
    lines: list[str] = []
    for empty in reversed(node.leading_lines):
        if empty.comment is None:
            break
        text = empty.comment.value[1:]
        text = text[1:] if text.startswith(" ") else text
        if not text.strip().startswith(DIRECTIVE):
            lines.append(text.rstrip())
    return "\n".join(reversed(lines))


@pytest.mark.parametrize("path", FIXTURES, ids=lambda path: f"{path.parent.name}/{path.stem}")
def test_the_comments_of_the_fixtures(path: Path) -> None:
    text = path.read_text("utf-8", errors="ignore").replace("\r\n", "\n").replace("\r", "\n")
    if read_file(SourceFile("prog.py", text), Diagnostics()) is None:
        return
    assert ours(text) == whole(text)


@pytest.mark.parametrize(
    ("text", "comments"),
    [
        ('"""doc\n# foo"""\nif a:\n    pass\n', [""]),
        ("# one\n# two\nif a:\n    pass\n# x\n\n# y\nif b:\n    pass\n", ["one\ntwo", "y"]),
        ("if a:\n    pass\n    # inner\n# outer\nif b:\n    pass\n", ["", "outer"]),
        ("if a:\n    pass\n# outer\n    # inner\nif b:\n    pass\n", ["", ""]),
        ("if a:\n    pass\n  # between\nif b:\n    pass\n", ["", "between"]),
        (
            "if a:\n    pass\nelse:\n        pass\n    # inner\n        # more\n# outer\nif b:\n    pass\n",
            ["", "outer"],
        ),
        ("if a:\n    pass\nelif b:\n    pass\n# outer\nif b:\n    pass\n", ["", "outer"]),
        ("if a: pass\n    # deeper\nif b:\n    pass\n", ["", "deeper"]),
        ("a; b\n# c\nif c:\n    pass\n", ["c"]),
        ('if """\n#""":\n    # c\n    if b:\n        pass\n', [""]),
        (
            "if a:\n    for _ in range(\n        # c\n        3\n    ):\n        # d\n        if b: pass\n",
            ["", "d"],
        ),
        (
            "pass\n# first\nif a:\n    pass\n#\n#  two spaces\n#no space\nif b:\n    pass\n",
            ["first", "\n two spaces\nno space"],
        ),
        ("if a:\n    pass\n# clickgen: ignore[CG501]\n# said\nif b:\n    pass\n", ["", "said"]),
        ("if a:\n    pass\n# ends with a \\\nif b:\n    pass\n", ["", "ends with a \\"]),
    ],
)
def test_odd_places(text: str, comments: list[str]) -> None:
    assert of_block(text) == comments


def test_tabs() -> None:
    text = "def main():\n\t# tab\n\tif a:\n\t\tpass\n\t# tab\n        # spaces\n\tif b:\n\t\tpass\n"
    assert ours(text) == ["tab", "tab\nspaces"]


def test_a_comment_at_the_margin() -> None:
    assert ours("def main():\n# margin\n    if a:\n        pass\n# and\n    # more\n    if b:\n        pass\n") == [
        "margin",
        "and\nmore",
    ]


COMMENTS = st.lists(
    st.tuples(
        st.sampled_from((0, 1, 2, 4, 6, 8, 12)), st.sampled_from(("# a", "#b", "#", "", "#  c ", "# clickgen: x"))
    ),
    max_size=4,
)


@st.composite
def blocks(draw: st.DrawFn, depth: int = 1) -> list[str]:
    """The lines of a block: ifs, loops and plain statements with comments of any indentation between them."""
    indent = "    " * depth
    lines: list[str] = []
    for _ in range(draw(st.integers(1, 3))):
        lines += [" " * width + text for width, text in draw(COMMENTS)]
        kind = draw(
            st.sampled_from(("if", "if", "for", "pass", "oneline", "string") if depth < 4 else ("pass", "oneline"))
        )
        if kind in ("if", "for"):
            lines.append(f"{indent}{'if a:' if kind == 'if' else 'for _ in range(3):'}")
            lines += draw(blocks(depth + 1))
            if kind == "if" and draw(st.booleans()):
                lines += [f"{indent}else:", *draw(blocks(depth + 1))]
        elif kind == "oneline":
            lines.append(f"{indent}if a: pass")
        else:
            lines += [f"{indent}pass"] if kind == "pass" else [f'{indent}"""text', '# text"""']
    return lines


@given(blocks())
def test_a_comment_is_what_libcst_takes_for_one(lines: list[str]) -> None:
    text = "\n".join(("def main():", *lines, ""))
    assert ours(text) == whole(text)
