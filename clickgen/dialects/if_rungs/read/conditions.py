"""Conditions out of expressions: contacts, comparisons, all, any."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import libcst as cst

from clickgen.device.banks import BANKS, Kind
from clickgen.dialects.if_rungs.fix.logic import in_language, opposite, python_logic, terms_in
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.nodes import (
    ADDRESSES,
    Node,
    arguments,
    called,
    is_literal,
    is_starred,
    keywords,
    literal,
    name_of,
    on_one_line,
)
from clickgen.dialects.if_rungs.read.operands import looks_like_address, read_address, read_operand
from clickgen.dialects.if_rungs.spelling import IfRungsSpelling
from clickgen.dialects.if_rungs.ways_out import no_condition
from clickgen.dialects.if_rungs.ways_out.binding import binds_otherwise
from clickgen.dialects.if_rungs.ways_out.hints import bank_of, is_condition, own
from clickgen.dialects.if_rungs.ways_out.meant import Meant, meant
from clickgen.dialects.if_rungs.write.expressions import EDGE_FUNCTIONS
from clickgen.ir.conditions import All, Always, Any, Compare, Condition, Contact
from clickgen.ir.operands import Cell, Hex, Immediate, Integer, Named, Pointer, Range, Real, form_of
from clickgen.ir.proposals import Proposal, Rewrite
from clickgen.problems.diagnostics import Diagnostic, Diagnostics
from clickgen.text.edits import Edit, Fix
from clickgen.text.source import Span
from clickgen.text.wording import shorten

COMPARISONS: dict[type[Node], str] = {
    cst.Equal: "==",
    cst.NotEqual: "!=",
    cst.LessThan: "<",
    cst.LessThanEqual: "<=",
    cst.GreaterThan: ">",
    cst.GreaterThanEqual: ">=",
}
_RANGE_MAX = 8
"""Of a longer range a message does not name each address."""
FUNCTIONS = ("all", "any", "nc", "re", "fe")
_EDGES = {function: edge for edge, function in EDGE_FUNCTIONS.items()}
_WAY_OUT = "a condition is a bit, a comparison, all(...), any(...), nc(...), re(...) or fe(...)"


def read_condition(context: Context, node: Node) -> Condition | None:
    """The condition that an expression writes; None with a problem."""
    if node.__class__ is not cst.Name:
        return _read_term(context, node)
    if literal(node) is True:
        return Always(context.span(node))
    if name_of(node).lower() == "true":
        fix = Fix((Edit(context.span(node), "True"),))
        context.problem("CG107", node, "this is not a condition", "a rung that always runs stands under if True:", fix)
        return None
    return _read_term(context, node)


def read_series(context: Context, nodes: Sequence[Node]) -> Condition | None:
    """Conditions one behind the other, all of which must hold; None with problems."""
    if len(nodes) == 1:
        return read_condition(context, nodes[0])
    terms = [_read_term(context, node) for node in nodes]
    kept = tuple(term for term in terms if term is not None)
    if len(kept) < len(terms):
        return None
    first, last = context.span(nodes[0]), context.span(nodes[-1])
    return All(kept, first._replace(end_line=last.end_line, end_col=last.end_col))


def _read_term(context: Context, node: Node) -> Condition | None:
    if node.__class__ in ADDRESSES:
        return _read_contact(context, node)
    if node.__class__ is cst.Comparison and isinstance(node, cst.Comparison):
        return _read_comparison(context, node)
    if isinstance(node, cst.Call) and (name := called(node)) in FUNCTIONS:
        return _read_function(context, node, name)
    logic = python_logic(node)
    if logic:
        _refuse_logic(context, node, logic[0])
    elif literal(node) is True:
        context.problem(
            "CG107",
            node,
            "True stands alone as a rung's or a branch's condition, not inside another",
            "leave it out; where a contact is needed, sc[1] is always on",
        )
    else:
        fault = "this call is not a condition" if isinstance(node, cst.Call) else "this is not a condition"
        if _said_otherwise(context, node, "CG107", fault):
            return None
        help, fix = no_condition.way_out(context, node, partial(fits_condition, context))
        context.problem("CG107", node, fault, help or _WAY_OUT, fix)
    return None


def _refuse_logic(context: Context, node: Node, word: str) -> None:
    """Python's and, or and not: rewritten where that is plain, said where a rung before is needed."""
    fault = f"{word} is not part of the language"
    proposal = None if context.is_trial else _proposal(context, "CG105", context.span(node), node, node)
    if proposal is None and _said_otherwise(context, node, "CG105", fault):
        return
    help = _WAY_OUT if proposal or context.is_trial else _in_the_way(context, node)
    context.problem("CG105", node, fault, help)
    if proposal:
        context.proposals.append(proposal)


def _said_otherwise(context: Context, node: Node, code: str, fault: str) -> bool:
    """Report an expression with what it means in the language, where that is certain; False without a word."""
    said = _meant(context, node)
    if said is None:
        return False
    context.problem(code, node, fault, said.way_out)
    propose_turned(context, code, node, said)
    return True


def propose_turned(context: Context, code: str, node: Node, said: Meant) -> None:
    """Have the judge of fixes say it where something that is turned round has no opposite, such as a block."""
    turned = tuple(leaf for leaf in _leaves(context, said.turned) if isinstance(leaf, Contact | Compare))
    if turned:
        context.proposals.append(Proposal(code, context.span(node), None, turned))


def pin_readings(context: Context, node: Node) -> list[Meant]:
    """What an expression can mean as the condition of an input: one thing, for a list two; none where it is open."""
    fits = partial(fits_condition, context)
    if literal(node) is True:
        return [Meant("True", (), ())]
    return no_condition.readings_of(context, node, fits)


def _meant(context: Context, node: Node, wanted: bool = True) -> Meant | None:
    """What an expression means as a condition; None in a trial, and where that is not certain."""
    return None if context.is_trial else meant(context, node, partial(fits_condition, context), wanted)


def _is_plain(context: Context, node: Node, wanted: bool = True) -> bool:
    """True for an expression that can be written in the language, itself or its opposite, with its own terms."""
    if in_language(node, wanted) is None:
        return False
    trial = Context(context.source, Diagnostics(), is_trial=True, places=context.places)
    return all(_read_term(trial, term) is not None for term, _, _ in terms_in(node)) and not trial.problems.found


def _exactly_meant(context: Context, node: Node, wanted: bool = True) -> Meant | None:
    """What an expression means that is not plain; None where that is not certain, or needs a rung before."""
    said = None if "#" in context.text(node) else _meant(context, node, wanted)
    return said if said and said.is_exact and not said.before else None


def _proposal(
    context: Context, code: str, place: Span, old: Node, meaning: Node, wanted: bool = True
) -> Proposal | None:
    """The fix of the problem at this place that writes what an expression means, or the opposite; None without one."""
    turned: Sequence[Node] = [term for term, _, is_wanted in terms_in(meaning, wanted=wanted) if not is_wanted]
    text = ""
    if not _is_plain(context, meaning, wanted):
        said = _exactly_meant(context, meaning, wanted)
        if said is None:
            return None
        text, turned = said.text, said.turned
    leaves = _leaves(context, turned)
    kept = tuple(term for term in leaves if isinstance(term, Contact | Compare))
    rewrite = Rewrite(context.span(old), context.span(meaning), wanted, text)
    return Proposal(code, place, rewrite, kept, is_read=None not in leaves)


def _leaves(context: Context, nodes: Sequence[Node]) -> list[Condition | None]:
    trial = context.aside()
    return [_read_term(trial, node) for node in nodes]


def fits_condition(context: Context, text: str) -> bool:
    """True for the text of a condition without a fault."""
    return condition_fault(context, text, is_trial=True) is None


def as_condition(context: Context, node: Node) -> str:
    """An expression as the text of a condition, and, or and not rewritten; "" where it is none."""
    text = " ".join(context.text(node).split())
    if "#" in text:
        return ""
    if fits_condition(context, text):
        return text
    if _is_plain(context, node):
        made = in_language(node)
        assert made is not None
        written, turned = on_one_line(made), [term for term, _, is_wanted in terms_in(node) if not is_wanted]
    else:
        said = _meant(context, node)
        if said is None or said.before:
            return ""
        written, turned = said.text, [*said.turned]
    return written if all(map(_has_plain_opposite, _leaves(context, turned))) else ""


def rewrites(context: Context, node: Node) -> bool:
    """True for and, or and not that can be written in the language, as far as the text says."""
    return _is_plain(context, node) or _exactly_meant(context, node) is not None


def _has_plain_opposite(leaf: Condition | None) -> bool:
    """True for what has an opposite, whatever the names of the program are.

    A name may be that of a block, whose bits are asked for together, and a DF register may hold no number.
    """
    if isinstance(leaf, Contact):
        return isinstance(leaf.operand, Cell | Immediate)
    return isinstance(leaf, Compare) and "DF" not in (form_of(leaf.left), form_of(leaf.right))


def condition_fault(context: Context, text: str, is_trial: bool = False) -> Diagnostic | None:
    """What is wrong with a condition of this text; None where nothing is. A trial finds no ways out."""
    trial = context.of_text(f"({text})", is_trial)
    node = trial.expression()
    if node is None:
        return Diagnostic("CG107", "this is not a condition", None, _WAY_OUT)
    read_condition(trial, node)
    return next(iter(trial.problems.found), None)


def _in_the_way(context: Context, node: Node) -> str:
    """The term for which Python's operators cannot be rewritten plainly, and the way out."""
    compared: cst.Comparison | None = None
    for term, function, wanted in terms_in(node):
        text = context.text(term)
        shown = shorten(text)
        # True is a condition where it stands alone, which it does not here.
        fault = condition_fault(context, f"all({text})")
        if fault is not None:
            both = _compared_too(context, function, compared, term)
            if not wanted and not both:
                # Its own way out is not yet the opposite that is asked for.
                return f"correct {shown} first: {fault.help}"
            return f"{shown} has no place in it: {f'compare it as well, {both}' if both else fault.help}"
        if not wanted and opposite(term) is None:
            return IfRungsSpelling().no_opposite(shown, is_negated=True)
        compared = term if isinstance(term, cst.Comparison) else None
    return f"in series write all(...), in parallel any(...); {_WAY_OUT}"


def _compared_too(context: Context, function: str, before: cst.Comparison | None, term: Node) -> str:
    """``any(ds.X == 1, ds.X == 2)`` for a number behind a comparison, ``ds.X == 1 or 2``; "" for anything else."""
    is_number = isinstance(term, cst.Integer | cst.Float)
    if not is_number or before is None or not is_literal(before.comparisons[0].comparator):
        return ""
    first = " ".join(context.text(before).split())
    second = f"{context.text(before.left)} {COMPARISONS[before.comparisons[0].operator.__class__]} {context.text(term)}"
    both = f"{function}({first}, {second})"
    return both if condition_fault(context, both) is None else ""


def _read_contact(context: Context, node: Node) -> Condition | None:
    """A bit as a contact; a bare numeric register means that it is not zero."""
    operand = read_address(context, node)
    if operand is None:
        return None
    bank = BANKS[operand.bank] if isinstance(operand, Named | Cell | Range | Immediate | Pointer) else None
    if bank is None or isinstance(operand, Pointer):
        _refuse_pointer(context, node)
        return None
    if bank.is_bit:
        assert isinstance(operand, Named | Cell | Range | Immediate)
        return Contact(operand, operand.span)
    if not isinstance(operand, Named | Cell) or bank.kind is Kind.TEXT:
        context.problem("CG107", node, f"{bank.name} holds no bits", f"compare it: {bank.dsl}[{bank.first}] == ...")
        return None
    zero = Hex(0, operand.span) if bank.kind is Kind.HEX else Integer(0, operand.span)
    right = Real(0.0, "0.0", operand.span) if bank.kind is Kind.FLOAT else zero
    return Compare("!=", operand, right, operand.span)


def _refuse_pointer(context: Context, node: Node) -> None:
    context.problem(
        "CG307",
        node,
        "a pointer cannot stand in a condition: CLICK reads it too late",
        "copy the register pointed to into another one in a rung before, and test that",
    )


def _read_comparison(context: Context, node: cst.Comparison) -> Condition | None:
    fits = partial(fits_condition, context)
    if not context.is_trial and binds_otherwise(context, node):
        fault = "& and | are not part of the language, and bind before a comparison in Python"
        if _said_otherwise(context, node, "CG105", fault):
            return None
    if len(node.comparisons) > 1:
        help, fix = no_condition.unchained(context, node, fits)
        if fix is None and _said_otherwise(context, node, "CG106", "comparisons do not chain"):
            return None
        context.problem("CG106", node, "comparisons do not chain", help, fix)
        return None
    sides = (node.left, node.comparisons[0].comparator)
    if any(is_condition(side) and not looks_like_address(side) for side in sides):
        fault = "a condition is on or off, and is not compared"
        if not _said_otherwise(context, node, "CG303", fault):
            context.problem("CG303", node, fault, no_condition.compared_condition(context, node, fits))
        return None
    bit = no_condition.compared_bit(context, node, fits)
    if bit is not None:
        _refuse_compared(context, node, bit)
        return None
    target = node.comparisons[0]
    operator = COMPARISONS.get(target.operator.__class__)
    if operator is None:
        fault = "CLICK has no such comparison"
        if not _said_otherwise(context, node, "CG107", fault):
            help = no_condition.searched(context, node, fits) or "the comparisons: == != < <= > >="
            context.problem("CG107", node, fault, help)
        return None
    if any(map(_is_calculated, sides)):
        wrong = next(side for side in sides if _is_calculated(side))
        fault = f"{shorten(context.text(wrong))} is not an address or a constant"
        if _said_otherwise(context, node, "CG113", fault):
            return None
    left = read_operand(context, node.left)
    right = read_operand(context, target.comparator)
    if left is None or right is None:
        return None
    for side in (left, right):
        if isinstance(side, Pointer):
            context.problems.add(
                "CG307",
                side.span,
                "a pointer cannot stand in a comparison: CLICK reads it too late",
                "copy the register pointed to into another one in a rung before, and compare that",
            )
            return None
        if isinstance(side, Range | Immediate):
            help = no_condition.compared_range(context, node, side, fits) or _WAY_OUT
            context.problems.add("CG107", side.span, "only single registers and constants compare", help)
            return None
    assert not isinstance(left, Range | Immediate)
    assert not isinstance(right, Range | Immediate)
    return Compare(operator, left, right, context.span(node))


def _is_calculated(node: Node) -> bool:
    """True for what is neither an address nor a constant, which may have a sign."""
    value = node.expression if isinstance(node, cst.UnaryOperation) else node
    return not is_literal(value) and not (looks_like_address(value) and value is node)


def _refuse_compared(context: Context, node: cst.Comparison, bit: no_condition.ComparedBit) -> None:
    fault = "a bit is a condition by itself, and is not compared"
    if bit.turned is None or bit.fix is None or context.is_trial:
        context.problem("CG303", node, fault, bit.help, bit.fix)
        return
    leaf = _read_term(context.aside(), bit.turned)
    context.problem("CG303", node, fault, no_condition.bit_help(context.text(bit.turned)))
    if isinstance(leaf, Contact):
        place = context.span(node)
        text = bit.fix.edits[0].text
        context.proposals.append(Proposal("CG303", place, Rewrite(place, place, text=text), (leaf,)))


def _read_function(context: Context, node: cst.Call, name: str) -> Condition | None:
    given = arguments(node)
    for keyword in keywords(node):
        context.problem("CG109", keyword, f"{name}() takes no keyword arguments", f"{name}(c.A, c.B)")
    if any(is_starred(argument) for argument in given):
        context.problem("CG107", node, f"{name}(...) takes its conditions one by one", f"{name}(c.A, c.B)")
        return None
    if name in ("all", "any"):
        if not given:
            context.problem("CG110", node, f"{name}() needs at least one condition", f"{name}(c.A, c.B)")
            return None
        terms = [_read_term(context, argument) for argument in given]
        kept = tuple(term for term in terms if term is not None)
        if len(kept) < len(terms):
            return None
        return All(kept, context.span(node)) if name == "all" else Any(kept, context.span(node))
    if len(given) != 1:
        context.problem("CG110", node, f"{name}() takes one bit", f"{name}(c.A)")
        return None
    return _read_bit_function(context, node, name, given[0])


def _read_bit_function(context: Context, node: cst.Call, name: str, argument: Node) -> Condition | None:
    if not looks_like_address(argument):
        help, fix = _without_function(context, node, name, argument)
        context.problem("CG107", argument, f"{name}() takes one bit, not a condition", help, fix)
        return None
    operand = read_operand(context, argument)
    if operand is None:
        return None
    if isinstance(operand, Pointer):
        _refuse_pointer(context, argument)
        return None
    if not isinstance(operand, Named | Cell | Range | Immediate) or not BANKS[operand.bank].is_bit:
        context.problem("CG107", argument, f"{name}() takes a bit", _of_no_bit(context, name, argument))
        return None
    if name == "nc":
        return Contact(operand, context.span(node), negated=True)
    if isinstance(operand, Range):
        context.problem("CG107", argument, f"{name}() takes one bit, not a range", _each_of(name, operand))
        return None
    if isinstance(operand, Immediate):
        shown = own(context, argument).removesuffix(".immediate")
        context.problem("CG308", argument, "an edge contact is never immediate", f"write {name}({shown or 'x[1]'})")
        return None
    return Contact(operand, context.span(node), edge=_EDGES[name])


def _of_no_bit(context: Context, name: str, argument: Node) -> str:
    """The way out for ``nc(ds.A)`` and ``re(ds.A)``."""
    text, bank = own(context, argument), bank_of(argument)
    if bank is not None and bank.kind is Kind.TEXT:
        text = f'{text} {"!=" if name == "nc" else "=="} "A"'
        return f"compare a character: {text}" if name == "nc" else _edge_of(name, text)
    if name == "nc":
        return f"compare a register: {text or 'ds.A'} == 0"
    return f"edges belong to bits; {_edge_of(name, text or 'ds.A')}"


def _edge_of(name: str, condition: str) -> str:
    return f"put the condition on a bit in a rung before, if {condition}: out(c.Edge), and write {name}(c.Edge)"


def _each_of(name: str, span: Range) -> str:
    """``any(re(c[1]), re(c[2]))`` for a range."""
    dsl = BANKS[span.bank].dsl
    if len(span) > _RANGE_MAX:
        return f"write {name}(...) of each bit: {name}({dsl}[{span.first}])"
    return f"write any({', '.join(f'{name}({dsl}[{address.number}])' for address in span.addresses())})"


def _without_function(context: Context, node: cst.Call, name: str, argument: Node) -> tuple[str, Fix | None]:
    """The way out for ``nc(ds.A == 5)`` and ``re(all(...))``: the opposite, or a bit in a rung before."""
    if context.is_trial:
        return "", None
    text = " ".join(context.text(argument).split())
    if name == "nc" and "#" not in text:
        proposal = _proposal(context, "CG107", context.span(argument), node, argument, wanted=False)
        if proposal is not None:
            context.proposals.append(proposal)
            return _WAY_OUT, None
    said = None if "#" in text else _meant(context, node)
    if said is not None:
        propose_turned(context, "CG107", argument, said)
        return said.way_out, None
    asked = text if fits_condition(context, f"all({text})") else as_condition(context, argument)
    if asked and "#" not in asked:
        return _edge_of(name, asked), None
    said = _meant(context, argument)
    if said is not None and not said.before:
        return _edge_of(name, said.text), None
    return no_condition.way_out(context, argument, partial(fits_condition, context))[0] or f"{name}(c.A)", None
