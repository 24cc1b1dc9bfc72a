"""The comment of a rung is what libcst, an outside reader, holds for the comment lines that lead to it."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Sequence
from pathlib import Path

import libcst
import pytest
from hypothesis import given
from hypothesis import strategies as st

from clickgen.dialects.if_rungs.read.comments import DIRECTIVE, rung_comment
from clickgen.text.source import SourceFile

FIXTURES = sorted((Path(__file__).parents[1] / "fixtures").rglob("*.py"))


def in_step(body: Sequence[libcst.CSTNode], nodes: Sequence[ast.stmt]) -> Iterator[tuple[libcst.CSTNode, ast.stmt]]:
    """libcst's statements with ast's, which has one for each small statement of a line."""
    remaining = iter(nodes)
    for cst_node in body:
        small = getattr(cst_node, "body", None)
        for _ in range(len(small) if isinstance(small, Sequence) else 1):
            yield cst_node, next(remaining)


def theirs(node: libcst.CSTNode) -> str:
    lines: list[str] = []
    for empty in reversed(getattr(node, "leading_lines", ())):
        if empty.comment is None:
            break
        text = empty.comment.value[1:]
        text = text[1:] if text.startswith(" ") else text
        if not text.strip().startswith(DIRECTIVE):
            lines.append(text.rstrip())
    return "\n".join(reversed(lines))


def compare(source: SourceFile, body: Sequence[libcst.CSTNode], nodes: Sequence[ast.stmt], header: int) -> int:
    """Compare every ``if`` of a block and of the blocks in it; returns how many there are."""
    count = 0
    before: ast.stmt | None = None
    for cst_node, node in in_step(body, nodes):
        if isinstance(node, ast.If):
            assert rung_comment(source, node, before, header) == theirs(cst_node), source.text
            count += 1
        block = getattr(cst_node, "body", None)
        inner = getattr(node, "body", None)
        if isinstance(block, libcst.IndentedBlock) and isinstance(inner, list):
            head = node.test if isinstance(node, ast.If) else node.iter if isinstance(node, ast.For) else None
            count += compare(source, block.body, inner, (head and head.end_lineno) or node.lineno)
        before = node
    return count


def compare_text(text: str) -> int:
    source = SourceFile("prog.py", text)
    return compare(source, libcst.parse_module(text).body, ast.parse(text).body, 0)


@pytest.mark.parametrize("path", FIXTURES, ids=lambda path: f"{path.parent.name}/{path.stem}")
def test_the_comments_of_the_fixtures(path: Path) -> None:
    text = path.read_text("utf-8", errors="ignore").replace("\r\n", "\n").replace("\r", "\n")
    try:
        ast.parse(text)
        libcst.parse_module(text)
    except (SyntaxError, ValueError, libcst.ParserSyntaxError, RecursionError):
        return
    if "\f" not in text:
        compare_text(text)


@pytest.mark.parametrize(
    "text",
    [
        '"""doc\n# foo"""\nif a:\n    pass\n',
        'def main():\n    """doc\n    # foo"""\n    if a:\n        pass\n',
        "def main():\n    # one\n    # two\n    if a:\n        pass\n    # x\n\n    # y\n    if b:\n        pass\n",
        "if a:\n    pass\n    # inner\n# outer\nif b:\n    pass\n",
        "if a:\n    pass\n# outer\n    # inner\nif b:\n    pass\n",
        "if a:\n    pass\n  # between\nif b:\n    pass\n",
        "if a:\n    pass\nelse:\n        pass\n    # inner\n        # more\n# outer\nif b:\n    pass\n",
        "if a: pass\n    # deeper\nif b:\n    pass\n",
        "a; b\n# c\nif c:\n    pass\n",
        'if """\n#""":\n    # c\n    if b:\n        pass\n',
        "for _ in range(\n    # c\n    3\n):\n    # d\n    if b:\n        pass\n",
        "def main():\n\t# tab\n\tif a:\n\t\tpass\n\t# tab\n        # spaces\n\tif b:\n\t\tpass\n",
        "pass\n# first\nif a:\n    pass\n#\n#  two spaces\n#no space\nif b:\n    pass\n",
        "if a:\n    pass\n# clickgen: ignore[CG501]\n# said\nif b:\n    pass\n",
    ],
)
def test_odd_places(text: str) -> None:
    assert compare_text(text)


COMMENTS = st.lists(
    st.tuples(
        st.sampled_from((0, 1, 2, 4, 6, 8, 12)), st.sampled_from(("# a", "#b", "#", "", "#  c ", "# clickgen: x"))
    ),
    max_size=4,
)


@st.composite
def blocks(draw: st.DrawFn, depth: int = 0) -> list[str]:
    """The lines of a block: ifs, loops and plain statements with comments of any indentation between them."""
    indent = "    " * depth
    lines: list[str] = []
    for _ in range(draw(st.integers(1, 3))):
        lines += [" " * width + text for width, text in draw(COMMENTS)]
        kind = draw(
            st.sampled_from(("if", "if", "for", "pass", "oneline", "string") if depth < 3 else ("pass", "oneline"))
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
    # What stands above a module's first statement libcst keeps for the module.
    compare_text("\n".join(("pass", *lines, "")))
