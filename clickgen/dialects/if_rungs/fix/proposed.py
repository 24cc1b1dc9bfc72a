"""Writes the fix that the reader proposed, once the resolved program supports it."""

from __future__ import annotations

from collections.abc import Sequence

import libcst as cst

from clickgen.dialects.base import Mender, Written
from clickgen.dialects.if_rungs.fix.logic import in_language
from clickgen.dialects.if_rungs.fix.repeats import without_terms
from clickgen.dialects.if_rungs.fix.statement import Statements
from clickgen.dialects.if_rungs.read.nodes import called, on_one_line
from clickgen.dialects.if_rungs.write.expressions import EDGE_FUNCTIONS
from clickgen.ir.conditions import All, Any, Compare, Condition, Contact
from clickgen.ir.proposals import Alternative, Proposal, Rewrite
from clickgen.ir.walk import condition_operands
from clickgen.logic.conditions import terms_of
from clickgen.text.edits import Edit
from clickgen.text.source import SourceFile, Span


class IfRungsMender(Mender):
    """Reads a statement again for each fix in it."""

    def __init__(self, source: SourceFile) -> None:
        self._statements = Statements(source)

    def proposed(self, proposal: Proposal) -> Written | None:
        return written(self._statements, proposal)

    def without_terms(self, terms: Sequence[Span]) -> tuple[Edit, ...] | None:
        return without_terms(self._statements, terms)


def written(statements: Statements, proposal: Proposal) -> Written | None:
    """The fix of a proposal as the reader left it, with names; None where there is none to write."""
    if proposal.rewrite is not None:
        return _rewritten(statements, proposal.rewrite)
    edits: list[Edit] = []
    for arm in proposal.arms[1:] if proposal.is_written else ():
        own = _alone(statements, arm)
        if own is None:
            return None
        edits += own
    return Written(tuple(edits)) if edits else None


def _rewritten(statements: Statements, rewrite: Rewrite) -> Written | None:
    if rewrite.text:
        return Written((Edit(rewrite.span, rewrite.text),), rewrite.text)
    old, meaning = statements.node(rewrite.span), statements.node(rewrite.meaning)
    new = None if meaning is None else in_language(meaning, rewrite.is_wanted)
    edit = statements.edit(old, new) if old is not None and new is not None else None
    return None if new is None or edit is None else Written((edit,), on_one_line(new))


# -- if, elif and else ------------------------------------------------------------------------------------------------


def _alone(statements: Statements, arm: Alternative) -> list[Edit] | None:
    """The edits that make an elif or an else an if of its own; what it asks itself is left as it is written."""
    source, terms = statements.source, [*terms_of(arm.alone)]
    head = statements.head(arm.word)
    if not isinstance(head, cst.If):
        text = _text(source, arm.alone)
        return None if text is None else [Edit(arm.word, f"if {text}")]
    own = [*terms_of(arm.test)]
    if not own or terms[-len(own) :] != own:
        text = None if "#" in statements.context.text(head.test) else _text(source, arm.alone)
        return None if text is None else [Edit(arm.word, "if"), Edit(statements.context.span(head.test), text)]
    texts = [_text(source, term) for term in terms[: -len(own)]]
    if None in texts:
        return None
    if not texts:
        return [Edit(arm.word, "if")]
    start, end = statements.extent(head.test)
    text = statements.text(_in_series([cst.parse_expression(text) for text in texts if text], head.test), start)
    blank = " " if source.text[start - 1].isalpha() else ""
    return None if text is None else [Edit(arm.word, "if"), Edit(statements.context.stretch(start, end), blank + text)]


def _in_series(terms: list[cst.BaseExpression], test: cst.BaseExpression) -> cst.BaseExpression:
    """Terms in series in front of a condition, which keeps its lines."""
    comma = cst.Comma(whitespace_after=cst.SimpleWhitespace(" "))
    args = [cst.Arg(term, comma=comma) for term in terms]
    if not isinstance(test, cst.Call) or called(test) != "all":
        return cst.Call(cst.Name("all"), [*args, cst.Arg(test)])
    before = test.whitespace_before_args
    if not isinstance(before, cst.ParenthesizedWhitespace):
        return test.with_changes(args=[*args, *test.args])
    args[-1] = args[-1].with_changes(comma=cst.Comma(whitespace_after=before))
    return test.with_changes(args=[*args, *test.args], whitespace_before_args=before.first_line.whitespace)


def _text(source: SourceFile, condition: Condition) -> str | None:
    """A condition on one line, every address and constant as the person wrote it; None where one is on several."""
    operands = list(condition_operands(condition))
    if any(operand.span.line != operand.span.end_line for operand in operands):
        return None
    if isinstance(condition, All | Any):
        texts = [_text(source, term) for term in condition.terms]
        if None in texts:
            return None
        name = "all" if isinstance(condition, All) else "any"
        return f"{name}({', '.join(text for text in texts if text)})"
    line = source.line
    shown = [line(span.line)[span.col - 1 : span.end_col - 1] for span in (operand.span for operand in operands)]
    if isinstance(condition, Compare):
        if condition.left.span != condition.right.span:
            return f"{shown[0]} {condition.op} {shown[1]}"
        # A register alone is compared with a 0 that is not written.
        return shown[0] if condition.op == "!=" else f"{shown[0]} {condition.op} 0"
    assert isinstance(condition, Contact)
    edge = EDGE_FUNCTIONS[condition.edge] if condition.edge else None
    word = "nc" if condition.negated else edge
    return f"{word}({shown[0]})" if word else shown[0]
