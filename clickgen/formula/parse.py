"""Parses the string of ``calc`` and ``math_hex`` into a formula.

The order of operators, the loosest first: ``OR``, ``XOR``, ``AND``, ``+ -``, ``* / MOD`` and infix shifts, the signs
``-`` and ``NOT``, ``^``. All but ``^`` group from the left: ``2 ^ 3 ^ 2`` is ``2 ^ (3 ^ 2)``, and ``-x ^ 2`` is
``-(x ^ 2)``. Where no source says that CLICK does the same, the printer writes parentheses (click-facts
[math.grouping]).
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from threading import Lock
from typing import TYPE_CHECKING, NamedTuple

import clickgen
from clickgen.formula.printer import print_formula
from clickgen.formula.report import Foreign, Report, unknown
from clickgen.ir.formula_nodes import Formula, Mode
from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.source import EmbeddedText

if TYPE_CHECKING:
    from lark import Lark

    from clickgen.formula.build import Builder

# click-facts [math.nesting, math.operands]
MAX_NESTING = 8
MAX_OPERANDS = 68

# Far above CLICK's limit; they bound the work on a hopeless formula.
_MAX_CHARACTERS = 4000
_MAX_WRITTEN_NESTING = 64

_PARENTHESIS = re.compile(r"\"[^\"\n]*\"|'[^'\n]*'|[()]")
_SPLIT = "calculate a part into a register with a line of its own, and use that register here"

_one_at_a_time = Lock()


class Reader(NamedTuple):
    """lark's parser and its builder."""

    lark: Lark
    builder: Builder


def parse_formula(
    text: EmbeddedText, mode: Mode, problems: Diagnostics, target: str = "", foreign: Foreign = unknown
) -> Formula | None:
    """Read a formula, or add its faults to ``problems`` and return None. Never raises.

    Names have the bank's upper-case name (``DS``), like addresses; ranges include both ends. ``target`` is where the
    result goes, as the person wrote it, and ``foreign`` knows functions of other machines, for ways out.
    """
    report = Report(text, target, foreign)
    formula = _parse(text.value, mode, report)
    problems.found.extend(report.problems.found)
    return None if report.problems.has_errors else formula


def _parse(value: str, mode: Mode, report: Report) -> Formula | None:
    if len(value) > _MAX_CHARACTERS:
        report.add("CG116", 0, len(value), f"the formula has more than {_MAX_CHARACTERS} characters", _SPLIT)
        return None
    deepest = _check_written_nesting(value, report)
    if deepest > _MAX_WRITTEN_NESTING:
        return None
    from lark import UnexpectedInput

    lark, builder = reader()
    with _one_at_a_time:
        builder.begin(report, mode)
        try:
            root = lark.parse(value)
        except UnexpectedInput as error:
            from clickgen.formula.explain import explain

            explain(error, mode, report)
            return None
        builder.finish()
        operands = builder.operands
    if len(operands) > MAX_OPERANDS:
        message = f"the formula has {len(operands)} operands, and CLICK takes {MAX_OPERANDS}"
        report.add("CG311", *operands[MAX_OPERANDS], message, _SPLIT)
    if report.problems.has_errors:
        return None
    formula = Formula(root, mode)  # type: ignore[arg-type]  # The builder gives a Node when nothing is wrong.
    if deepest + len(operands) > MAX_NESTING:
        _check_printed_nesting(formula, report)
    return formula


def _check_written_nesting(value: str, report: Report) -> int:
    """Return the deepest level of written parentheses; report those beyond CLICK's limit."""
    if value.count("(") <= MAX_NESTING:
        return value.count("(")
    depth = deepest = place = 0
    for match in _PARENTHESIS.finditer(value):
        if match.group() == "(":
            depth += 1
            if depth > deepest:
                deepest = depth
                if depth == MAX_NESTING + 1:
                    place = match.start()
        elif match.group() == ")":
            depth -= 1
    if deepest > MAX_NESTING:
        message = f"parentheses are nested {deepest} deep, and CLICK takes {MAX_NESTING}"
        report.add("CG310", place, place + 1, message, _SPLIT)
    return deepest


def _check_printed_nesting(formula: Formula, report: Report) -> None:
    depth = deepest = 0
    for character in print_formula(formula, lambda _: "0"):
        if character == "(":
            depth += 1
            deepest = max(deepest, depth)
        elif character == ")":
            depth -= 1
    if deepest > MAX_NESTING:
        message = f"in CLICK the formula needs parentheses {deepest} deep, and {MAX_NESTING} are possible"
        help = f"NOT, shifts, a minus sign and mixed operators bring some of their own; {_SPLIT}"
        report.add("CG310", formula.root.start, formula.root.end, message, help)


@cache
def reader() -> Reader:
    """Return lark's parser for ``formula.lark``, made once: about 20 ms, and importing lark is 50 to 100 ms."""
    from lark import Lark

    from clickgen.formula.build import Builder, tell_word

    builder = Builder()
    lark = Lark(
        grammar_text(),
        parser="lalr",
        lexer="basic",
        transformer=builder,  # lark only looks up methods by the names of rules.
        lexer_callbacks={"WORD": tell_word},
        propagate_positions=False,
        maybe_placeholders=True,
    )
    return Reader(lark, builder)


def grammar_text() -> str:
    """Return the grammar: package data in a wheel, a folder beside the package in a checkout."""
    package = Path(clickgen.__file__).parent
    inside = package / "grammar" / "formula.lark"
    path = inside if inside.is_file() else package.parent / "grammar" / "formula.lark"
    return path.read_text(encoding="utf-8")
