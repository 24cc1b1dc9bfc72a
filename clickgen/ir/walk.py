"""Walks and rewrites the program tree."""

from __future__ import annotations

import typing as tp
from collections.abc import Callable, Iterator
from dataclasses import replace

from clickgen.ir.conditions import All, Always, Any, Compare, Condition, Contact
from clickgen.ir.formula_nodes import Formula, references
from clickgen.ir.formula_nodes import Operand as FormulaOperand
from clickgen.ir.formula_operands import map_refs
from clickgen.ir.operands import Cell, Immediate, Named, Operand, Pointer, Range, Single
from clickgen.ir.program import Action, Branch, FormulaText, Item, KeptToken, Loop, Operands, Program, Rung, Value
from clickgen.ir.proposals import Alternative, Proposal

# -- walking ----------------------------------------------------------------------------------------------------------


def condition_operands(condition: Condition) -> Iterator[Operand]:
    """Every operand of a condition in source order."""
    if isinstance(condition, Contact):
        yield condition.operand
    elif isinstance(condition, Compare):
        yield condition.left
        yield condition.right
    elif isinstance(condition, All | Any):
        for term in condition.terms:
            yield from condition_operands(term)


def leaves(condition: Condition) -> Iterator[Contact | Compare]:
    """Every contact and comparison of a condition in source order."""
    if isinstance(condition, Contact) or isinstance(condition, Compare):  # noqa: SIM101
        yield condition
    elif not isinstance(condition, Always):
        for term in condition.terms:
            yield from leaves(term)


def action_operands(action: Action) -> Iterator[Operand]:
    """Yield every operand of an action, including those of its pins and its formula."""
    for value in action.args.values():
        yield from value_operands(value)


def value_operands(value: Value) -> Iterator[Operand]:
    """Every operand of an argument; a pointer brings its register."""
    parts = _PARTS.get(value.__class__)
    return iter(()) if parts is None else parts(value)


def _formula_operands(value: FormulaText) -> Iterator[Operand]:
    for node in references(value.formula):
        yield from _with_register(node.ref if isinstance(node, FormulaOperand) else node.range)


def _listed_operands(value: Operands) -> Iterator[Operand]:
    for item in value.items:
        yield from _with_register(item)


def _with_register(operand: Operand) -> Iterator[Operand]:
    """Yield an operand, and after a pointer the register it goes through."""
    yield operand
    if isinstance(operand, Pointer):
        yield operand.register


_PARTS: dict[type, Callable[[tp.Any], Iterator[Operand]]] = {
    **dict.fromkeys((Contact, Compare, All, Any, Always), condition_operands),
    FormulaText: _formula_operands,
    Operands: _listed_operands,
    KeptToken: lambda token: iter(token.operands),
    **dict.fromkeys(tp.get_args(Operand), _with_register),
}
"""The operands of each kind of argument; others have none."""


def rung_operands(rung: Rung) -> Iterator[Operand]:
    """Yield every operand of a rung in source order, including those of loop bodies."""
    yield from condition_operands(rung.condition)
    yield from items_operands(rung.items)


def items_operands(items: tuple[Item, ...]) -> Iterator[Operand]:
    """Yield every operand of what depends on a condition, in source order."""
    for item in items:
        if isinstance(item, Action):
            yield from action_operands(item)
        elif isinstance(item, Branch):
            yield from condition_operands(item.condition)
            yield from items_operands(item.items)
        else:
            yield from action_operands(item.action)
            for rung in item.body or ():
                yield from rung_operands(rung)


def program_operands(program: Program) -> Iterator[Operand]:
    """Every operand of every rung, routine by routine."""
    for routine in program.routines:
        for rung in routine.rungs:
            yield from rung_operands(rung)


# -- rewriting --------------------------------------------------------------------------------------------------------


class Rewriter:
    """Rebuilds a program with other addresses. Subclasses define how a name or a cell changes, wherever it is."""

    def cell(self, cell: Named | Cell) -> Named | Cell:
        return cell

    def single(self, operand: Single) -> Single:
        if isinstance(operand, Named | Cell):
            return self.cell(operand)
        if isinstance(operand, Pointer):
            return Pointer(operand.bank, self.cell(operand.register), operand.span)
        return operand

    def operand(self, operand: Operand) -> Operand:
        if isinstance(operand, Immediate):
            target = operand.target
            return operand if isinstance(target, Range) else Immediate(self.cell(target), operand.span)
        return operand if isinstance(operand, Range) else self.single(operand)

    def compare(self, compare: Compare) -> Compare:
        return replace(compare, left=self.single(compare.left), right=self.single(compare.right))

    def action(self, action: Action) -> Action:
        return Action(action.spec, {name: self.value(value) for name, value in action.args.items()}, action.span)

    def program(self, program: Program) -> Program:
        """Return the program with its routines rebuilt; its proposals are not part of it."""
        routines = tuple(replace(routine, rungs=self.rungs(routine.rungs)) for routine in program.routines)
        return replace(program, routines=routines)

    def proposal(self, proposal: Proposal) -> Proposal:
        arms = tuple(
            Alternative(self.condition(arm.test), self.condition(arm.alone), self.items(arm.items), arm.word)
            for arm in proposal.arms
        )
        return replace(proposal, turned=tuple(map(self.leaf, proposal.turned)), arms=arms)

    def leaf(self, leaf: Contact | Compare) -> Contact | Compare:
        return self.contact(leaf) if isinstance(leaf, Contact) else self.compare(leaf)

    def rungs(self, rungs: tuple[Rung, ...]) -> tuple[Rung, ...]:
        return tuple(
            Rung(self.condition(rung.condition), self.items(rung.items), rung.comment, rung.head, rung.span)
            for rung in rungs
        )

    def items(self, items: tuple[Item, ...]) -> tuple[Item, ...]:
        return tuple(self._item(item) for item in items)

    def condition(self, condition: Condition) -> Condition:
        if isinstance(condition, Contact):
            return self.contact(condition)
        if isinstance(condition, Compare):
            return self.compare(condition)
        if isinstance(condition, All):
            return All(tuple(map(self.condition, condition.terms)), condition.span)
        if isinstance(condition, Any):
            return Any(tuple(map(self.condition, condition.terms)), condition.span)
        return condition

    def contact(self, contact: Contact) -> Contact:
        operand = self.operand(contact.operand)
        assert isinstance(operand, Named | Cell | Range | Immediate)
        return Contact(operand, contact.span, contact.negated, contact.edge)

    def value(self, value: Value) -> Value:
        if isinstance(value, Contact | Compare | All | Any | Always):
            return self.condition(value)
        if isinstance(value, FormulaText):
            return FormulaText(self.formula(value.formula), value.span)
        if isinstance(value, Operands):
            return Operands(tuple(map(self.single, value.items)), value.span)
        if isinstance(value, Operand):
            return self.operand(value)
        return value

    def formula(self, formula: Formula) -> Formula:
        return map_refs(formula, self._ref, self.sum_range)

    def sum_range(self, operand: Range | Named) -> Range | Named:
        return operand

    def _ref(self, ref: Named | Cell | Pointer) -> Named | Cell | Pointer:
        if isinstance(ref, Pointer):
            return Pointer(ref.bank, self.cell(ref.register), ref.span)
        return self.cell(ref)

    def _item(self, item: Item) -> Item:
        if isinstance(item, Action):
            return self.action(item)
        if isinstance(item, Branch):
            return Branch(self.condition(item.condition), self.items(item.items), item.span)
        body = None if item.body is None else self.rungs(item.body)
        return Loop(self.action(item.action), body)
