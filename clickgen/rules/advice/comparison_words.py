"""A search whose comparison is a word: ``"eq"`` instead of ``"=="``."""

from __future__ import annotations

import re

from clickgen.facts.facts import Facts
from clickgen.ir.program import Word
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding
from clickgen.text.edits import Edit, Fix
from clickgen.text.source import Span

CODE = "CG524"

_LITERAL = re.compile(r"""(["']{1,3})(eq|ne|lt|le|gt|ge)\1""")


def find(facts: Facts) -> Findings:
    for placed in facts.actions:
        finds = placed.effects.finds
        condition = placed.action.args.get(finds.comparison) if finds is not None else None
        if not isinstance(condition, Word):
            continue
        match = _LITERAL.fullmatch(facts.text(condition.span))
        if match:
            path, line, col, *_ = condition.span
            word = Span(path, line, col + match.start(2), line, col + match.end(2))
            yield finding(
                CODE,
                condition.span,
                f'this search compares with "{match[2]}"; conditions and CLICK write {condition.value}',
                f'write "{condition.value}"',
                fix=Fix((Edit(word, str(condition.value)),)),
            )


ABOUT = Code(
    CODE,
    Severity.INFO,
    "a comparison is written as a word",
    """
Conditions, CLICK's own window for a search and the listing all write a comparison as a sign. One way to write it is
easier to read and to look for.
""",
    wrong=(
        Wrong(
            """
if c.Find:
    search("eq", ds.Wanted, ds[100], ds[200], ds.FoundAt, c.Found)  # <-
    search(condition="ge", value=5, start=ds[1], end=ds[9], result=ds.At, flag=c.Seen)  # <-
""",
            """
if c.Find:
    search("==", ds.Wanted, ds[100], ds[200], ds.FoundAt, c.Found)  # <-
    search(condition=">=", value=5, start=ds[1], end=ds[9], result=ds.At, flag=c.Seen)  # <-
""",
        ),
    ),
    right=(
        """
if c.Find:
    search("==", ds.Wanted, ds[100], ds[200], ds.FoundAt, c.Found)
    search(ds[1:10] >= 5, result=ds.At, found=c.Seen)
    search(txt[1:10] == "e", result=ds.At, found=c.Seen)
""",
    ),
)

RULE = Rule(find, (ABOUT,), holds_in_parts=True)
