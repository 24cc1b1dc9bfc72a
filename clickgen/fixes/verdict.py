"""Gives the fixes that the text suggests their verdict: safe, not safe, or none.

A fix is safe only if the resolved program proves it: every name in it is a known address, the conditions that it
reverses have an opposite, those that it writes hold exactly when the arms ran, and nothing between two
rungs changes the condition of the later one.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from clickgen.dialects.base import Dialect, Mender
from clickgen.fixes.hazards import Hazards
from clickgen.fixes.proof import stand_alone
from clickgen.ir.conditions import Compare, Contact
from clickgen.ir.operands import Cell, Immediate, Named, Operand, Pointer, Range, Section, form_of
from clickgen.ir.proposals import Proposal
from clickgen.ir.walk import condition_operands, rung_operands
from clickgen.problems.diagnostics import Diagnostic, Diagnostics
from clickgen.resolve.resolve import Resolved
from clickgen.text.edits import Fix
from clickgen.text.source import SourceFile, Span

_CONDITIONS = ("CG104", "CG105", "CG106", "CG107")
"""Errors in conditions: the instructions beside them are read."""
_OTHERS_FIRST = "correct the other problems first, which may hide what it is"


def judge_proposals(
    written: Iterable[Proposal],
    resolved: Resolved,
    sources: Iterable[SourceFile],
    dialect: Dialect,
    problems: Diagnostics,
    is_part: bool = False,
) -> None:
    """Give each problem with a proposal its fix and its help.

    ``written`` has the proposals as the text has them, in the order of those in ``resolved``. In a part of a program
    other files will declare names.
    """
    pairs = {(one.code, one.span): (one, known) for one, known in zip(written, resolved.proposals, strict=True)}
    if pairs:
        judge = _Judge(resolved, {source.path: source for source in sources}, dialect, problems, is_part)
        problems.found = [
            judge.judged(problem, *pairs[problem.code, problem.span])
            if problem.span and (problem.code, problem.span) in pairs
            else problem
            for problem in problems.found
        ]


class _Judge:
    def __init__(
        self,
        resolved: Resolved,
        sources: Mapping[str, SourceFile],
        dialect: Dialect,
        problems: Diagnostics,
        is_part: bool,
    ) -> None:
        self._dialect = dialect
        self._sources = sources
        self._menders: dict[str, Mender | None] = {}
        self._chosen = resolved.chosen
        self._is_declared = resolved.is_declared and not is_part
        # A part is called by programs, and runs beside routines, that nobody sees here.
        is_whole = not is_part and not any(map(_hides_instruction, problems.found))
        self._hazards = Hazards(resolved.program, resolved.proposals, is_whole)

    def judged(self, problem: Diagnostic, written: Proposal, resolved: Proposal) -> Diagnostic:
        is_negated = not resolved.arms
        for said, leaf in zip(written.turned, resolved.turned, strict=True):
            shown = self._text(said.span)
            if _is_block(said, leaf):
                return problem._replace(help=self._dialect.spell.no_opposite(shown, is_negated), fix=None)
            if self._may_be_block(leaf):
                why = f"{shown} may be a block, and nothing is the opposite of one"
                return problem._replace(help=f"{why}: {_OTHERS_FIRST}", fix=None)
        mender = self._mender(written.span.path)
        mended = mender.proposed(written) if mender is not None else None
        if mended is None:
            return problem
        rests_on_names = bool(resolved.turned or resolved.arms)
        fix = Fix(mended.edits, self._is_safe(resolved), rests_on_names)
        help = f"write {mended.shown}" if mended.shown else problem.help
        if is_negated and any(map(_is_float, resolved.turned)):
            help += "; neither may hold while a DF register holds no number (NaN)"
        return problem._replace(help=help, fix=fix)

    def _mender(self, path: str) -> Mender | None:
        """What writes the fixes of a file: it reads the statements with proposals again."""
        if path not in self._menders:
            self._menders[path] = self._dialect.mender(self._sources[path])
        return self._menders[path]

    def _text(self, span: Span) -> str:
        source = self._sources[span.path]
        if span.line == span.end_line:
            return source.line(span.line)[span.col - 1 : span.end_col - 1]
        lines = source.lines[span.line - 1 : span.end_line]
        return " ".join("\n".join([lines[0][span.col - 1 :], *lines[1:-1], lines[-1][: span.end_col - 1]]).split())

    # -- blocks -------------------------------------------------------------------------------------------------------

    def _may_be_block(self, leaf: Contact | Compare) -> bool:
        """True for a name that nothing declares, if not everything that declares could be understood."""
        if self._is_declared or not isinstance(leaf, Contact):
            return False
        bit = _bit(leaf)
        return (isinstance(bit, Named) and bit.part is None) or (isinstance(bit, Cell) and bit.address in self._chosen)

    # -- safety -------------------------------------------------------------------------------------------------------

    def _is_safe(self, proposal: Proposal) -> bool:
        if not proposal.is_read or not all(map(self._has_opposite, proposal.turned)):
            return False
        if not proposal.arms:
            return True
        operands = (operand for rung in proposal.rungs() for operand in rung_operands(rung))
        if not all(map(self._is_known, operands)) or not stand_alone(proposal.arms):
            return False
        hazards = self._hazards
        return not hazards.may_undo(proposal.arms) and (proposal.is_branch or hazards.may_look_again(proposal.arms))

    def _has_opposite(self, leaf: Contact | Compare) -> bool:
        """True if the opposite holds exactly when the leaf does not.

        A DF register may hold no number (NaN), after a root of a negative number, a word that was packed into it or a
        message. No source says what CLICK's comparisons give then: neither of two opposite ones may hold, or both.
        """
        if isinstance(leaf, Contact):
            return isinstance(_bit(leaf), Cell) and self._is_known(leaf.operand)
        return not _is_float(leaf) and self._is_known(leaf.left) and self._is_known(leaf.right)

    def _is_known(self, operand: Operand) -> bool:
        """True for a certain address, or a constant."""
        if isinstance(operand, Named):
            return False
        if isinstance(operand, Immediate):
            return self._is_known(operand.target)
        if isinstance(operand, Pointer):
            return self._is_known(operand.register)
        return self._is_declared or not isinstance(operand, Cell) or operand.address not in self._chosen


def _hides_instruction(problem: Diagnostic) -> bool:
    """True for an error that may hide an instruction that nobody has read."""
    return problem.is_error and problem.code.startswith("CG1") and problem.code not in _CONDITIONS


def _is_float(leaf: Contact | Compare) -> bool:
    return any(form_of(operand) == "DF" for operand in condition_operands(leaf))


def _bit(leaf: Contact) -> Named | Cell | Range:
    return leaf.operand.target if isinstance(leaf.operand, Immediate) else leaf.operand


def _is_block(written: Contact | Compare, resolved: Contact | Compare) -> bool:
    """True for a range, and for a name that turned out to be one, even in the wrong place or bank."""
    for said, operand in zip(condition_operands(written), condition_operands(resolved), strict=True):
        bit = operand.target if isinstance(operand, Immediate) else operand
        named = said.target if isinstance(said, Immediate) else said
        is_refused = isinstance(bit, Named) and isinstance(bit.part, Section)
        if isinstance(bit, Range) or (is_refused and isinstance(named, Named) and not isinstance(named.part, int)):
            return True
    return False
