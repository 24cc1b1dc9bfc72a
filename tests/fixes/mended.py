"""Programs and their fixes, for the tests of both: the findings, the result of a fix, and its meaning."""

from __future__ import annotations

import ast
import operator
from collections.abc import Mapping
from itertools import product
from pathlib import Path

import clickgen
from clickgen.api import check
from clickgen.config import Settings
from clickgen.problems.diagnostics import Diagnostic
from clickgen.text.edits import apply_fixes


def found(data: bytes, code: str, folder: Path) -> list[Diagnostic]:
    """The problems of a code, errors or findings of the rule about logic."""
    path = folder / "prog.py"
    path.write_bytes(data)
    result = check(path, Settings(wants=lambda wanted: wanted == code))
    return [problem for problem in result.diagnostics if problem.code == code]


def fixed(data: bytes, code: str, folder: Path) -> bytes:
    """The program after all fixes of a code at once."""
    fixes = [problem.fix for problem in found(data, code, folder) if problem.fix]
    text, count = apply_fixes(data.decode(), fixes)
    assert count == len(fixes)
    return text.encode()


def assert_builds(data: bytes, folder: Path) -> None:
    path = folder / "prog.py"
    path.write_bytes(data)
    result = clickgen.build(path)
    assert result.ok, result.diagnostics


def rung(condition: str) -> bytes:
    return f"def main():\n    if {condition}:\n        set(c.Q)\n    if True:\n        end()\n".encode()


def body(text: str) -> bytes:
    return f"def main():\n{text}\n    if True:\n        end()\n".encode()


def chain(*arms: str, line: str = "    ") -> str:
    """Arms such as ``if c.A: set(c.B)``, each on two lines."""
    return "\n".join(f"{line}{head}:\n{line}    {action}" for head, _, action in (arm.partition(": ") for arm in arms))


# -- meaning ----------------------------------------------------------------------------------------------------------

NAMES = "ABCD"
COMPARISONS = {ast.Eq: operator.eq, ast.NotEq: operator.ne, ast.LtE: operator.le, ast.Gt: operator.gt}


def holds(node: ast.expr, bits: Mapping[str, bool], value: int) -> bool:
    """The meaning of a condition of these tests, in Python's words or in the language's."""
    if isinstance(node, ast.BoolOp):
        terms = (holds(term, bits, value) for term in node.values)
        return all(terms) if isinstance(node.op, ast.And) else any(terms)
    if isinstance(node, ast.BinOp):
        terms = (holds(term, bits, value) for term in (node.left, node.right))
        return all(terms) if isinstance(node.op, ast.BitAnd) else any(terms)
    if isinstance(node, ast.UnaryOp):
        return not holds(node.operand, bits, value)
    if isinstance(node, ast.Call):
        terms = (holds(term, bits, value) for term in node.args)
        name = ast.unparse(node.func)
        return any(terms) if name == "any" else all(terms) is (name == "all")
    if isinstance(node, ast.Compare):
        left, right = (5 if isinstance(side, ast.Constant) else value for side in (node.left, node.comparators[0]))
        return bool(COMPARISONS[type(node.ops[0])](left, right))
    assert isinstance(node, ast.Attribute)
    return bits[node.attr]


def truth_table(condition: str) -> list[bool]:
    """The value of a condition in every state of four bits and three values of the register, compared with 5."""
    node = ast.parse(f"({condition})", mode="eval").body
    states = product((False, True), repeat=len(NAMES))
    return [holds(node, dict(zip(NAMES, bits, strict=True)), value) for bits in states for value in (4, 5, 6)]
