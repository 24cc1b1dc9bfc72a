"""What a condition in the form of another language means here: ``not 0 < ds.A < 5``, ``x[1] == False``.

The caller shows it as a way out, and the judge of fixes looks at what is turned round.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple

import libcst as cst

from clickgen.dialects.if_rungs.fix.logic import opposite, python_logic
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.nodes import (
    Node,
    arguments,
    called,
    code,
    comparison,
    elements,
    index_of,
    is_literal,
    is_name,
    is_starred,
    keywords,
    name_of,
    on_one_line,
    terms,
)
from clickgen.dialects.if_rungs.trade import CONDITIONS, advice
from clickgen.dialects.if_rungs.ways_out.binding import compare, is_tight, unbound
from clickgen.dialects.if_rungs.ways_out.condition_parts import (
    MIRRORED,
    SIGNS,
    Part,
    algebra,
    is_bool,
    is_listed,
    joined,
    single,
)
from clickgen.dialects.if_rungs.ways_out.formulas import bit_under_mask, calculated
from clickgen.dialects.if_rungs.ways_out.hints import (
    Fits,
    around_value,
    bank_of,
    flat_address,
    is_condition,
    member_hint,
    number_of,
    own,
    own_code,
    truth_of,
)
from clickgen.ir.conditions import OPPOSITE

_STEPS = 200
"""So many parts are looked at; a comparison of two conditions looks at each of them twice."""
_LONGEST = 400
_LISTED = 8
"""So many values of a range are compared one by one."""
_SWAPPED = {"all": "any", "any": "all"}
_TURNED_EDGE = {"re": "fe", "fe": "re"}


class Meant(NamedTuple):
    """A condition in the language. ``turned`` are the single conditions of which it has the opposite."""

    text: str
    turned: tuple[Node, ...]
    before: tuple[str, ...]
    """The rungs that have to stand before the one with the condition."""
    is_exact: bool = True
    """False where it is what people mean by it, and not what Python would make of it: no fix writes it."""

    @property
    def way_out(self) -> str:
        """The help that tells it."""
        return f"{self.rungs}, and write {self.text}" if self.before else f"write {self.text}"

    @property
    def rungs(self) -> str:
        """The rungs before it, as a help asks for them."""
        return f"put {'a rung' if len(self.before) == 1 else 'rungs'} before it, {' and '.join(self.before)}"


def meant(context: Context, node: Node, fits: Fits, wanted: bool = True) -> Meant | None:
    """What an expression means as a condition, or its opposite where it is not wanted; None for what is not certain."""
    reader = _Reader(context, fits)
    part = reader.said(node, wanted)
    text = part.text if part is not None else ""
    if not text or len(text) > _LONGEST or not fits(text):
        return None
    return Meant(text, tuple(reader.turned), tuple(reader.before), reader.is_exact)


class _Reader:
    def __init__(self, context: Context, fits: Fits) -> None:
        self._context = context
        self._fits = fits
        self._left = _STEPS
        self.turned: list[Node] = []
        self.before: list[str] = []
        self._results: dict[tuple[str, ...], str] = {}
        self.is_exact = True

    def said(self, node: Node, wanted: bool) -> Part | None:
        """An expression in the language, or its opposite; None where that is not certain."""
        self._left -= 1
        if self._left < 0:
            return None
        logic = python_logic(node) or algebra(node)
        self.is_exact &= not logic or logic[0] != "+"
        if logic and logic[1] == "nc":
            return self.said(logic[2][0], not wanted)
        if logic:
            return self._several(logic[1], logic[2], wanted)
        if isinstance(node, cst.Call):
            return self._called(node, wanted)
        if isinstance(node, cst.Comparison):
            return self._compared(node, wanted)
        if isinstance(node, cst.IfExp):
            return self._chosen(node, wanted)
        if isinstance(node, cst.Tuple | cst.List) and len(node.elements) == 1:
            return self.said(elements(node)[0], wanted)
        if isinstance(node, cst.BinaryOperation) and isinstance(node.operator, cst.BitXor) and is_condition(node):
            return self._unlike(node.left, node.right, wanted)
        if isinstance(node, cst.BinaryOperation):
            sides = [node.left, node.right]
            if is_tight(node) and any(map(is_condition, sides)):
                self.is_exact = False
                return self._several("all" if isinstance(node.operator, cst.BitAnd) else "any", sides, wanted)
            return self._calculated(node, wanted)
        if isinstance(node, cst.UnaryOperation) and isinstance(node.operator, cst.BitInvert | cst.Minus):
            return self._calculated(node, wanted)
        if is_name(node):
            return self._of_text(node, flat_address(name_of(node)), wanted)
        return self._leaf(node, wanted)

    def _several(self, function: str, terms: Sequence[Node], wanted: bool) -> Part | None:
        kept = [term for term in terms if truth_of(term) is not (function == "all")]
        function = function if wanted else _SWAPPED[function]
        return joined(function, (self.said(term, wanted) for term in kept))

    def _leaf(self, node: Node, wanted: bool) -> Part | None:
        """A single condition of the language, or its opposite."""
        text = own(self._context, node)
        if not text or not self._fits(text):
            return self._of_text(node, self._member(node), wanted)
        if wanted:
            return single(text)
        turned = opposite(node)
        self.turned.append(node)
        return single(on_one_line(turned.with_changes(lpar=[], rpar=[]))) if turned is not None else None

    def _member(self, node: Node) -> str:
        """The bit that ``t.A.done`` is; "" for anything else."""
        bank = bank_of(node)
        if not isinstance(node, cst.Attribute) or bank is None or not own(self._context, node.value):
            return ""
        help, _ = member_hint(self._context, node, bank, own(self._context, node.value).removeprefix(bank.dsl))
        return help.removeprefix("write ") if help.startswith("write ") else ""

    def _of_text(self, node: Node, text: str, wanted: bool) -> Part | None:
        """A bit that is written otherwise than the node has it."""
        self.is_exact = False
        if not text or not self._fits(text):
            return None
        if wanted:
            return single(text)
        self.turned.append(node)
        return single(f"nc({text})") if re.fullmatch(r"[a-z]+[.\[][\w\"\]]+", text) else None

    def _called(self, node: cst.Call, wanted: bool) -> Part | None:
        name, given = called(node), arguments(node)
        if keywords(node) or any(map(is_starred, given)):
            return None
        if name in _SWAPPED and given:
            return self._several(name, given, wanted)
        inner = given[0] if len(given) == 1 else None
        if name == "nc" and inner is not None and not isinstance(inner, cst.Attribute | cst.Subscript):
            return self.said(inner, not wanted)
        if name in _TURNED_EDGE and inner is not None and not isinstance(inner, cst.Attribute | cst.Subscript):
            part = self.said(inner, True)
            bit = re.fullmatch(r"(nc\()?([a-z]+(?:\.\w+|\[[^\[\]]+\]))\)?", part.text) if part else None
            edge = bit and f"{_TURNED_EDGE[name] if bit[1] else name}({bit[2]})"
            return single(edge) if edge and wanted and self._fits(edge) else None
        if self._fits(own(self._context, node) or "-"):
            return self._leaf(node, wanted)
        found = advice(name, CONDITIONS)
        text = own_code(self._context, found, around_value(name, given), self._fits) if found else ""
        return self._of_text(node, text, wanted)

    def _chosen(self, node: cst.IfExp, wanted: bool) -> Part | None:
        """``x[1] if x[2] else x[3]``: two ways in parallel."""
        legs: list[Part | None] = []
        for holds, value in ((True, node.body), (False, node.orelse)):
            truth = truth_of(value)
            if truth is None:
                legs.append(joined("all", [self.said(node.test, holds), self.said(value, wanted)]))
            elif truth is wanted:
                legs.append(self.said(node.test, holds))
        return joined("any", legs)

    def _unlike(self, one: Node, other: Node, wanted: bool) -> Part | None:
        """One of two conditions, but not both; where that is not wanted, both or none."""
        pairs = ((holds, holds is not wanted) for holds in (True, False))
        return joined("any", [joined("all", [self.said(one, a), self.said(other, b)]) for a, b in pairs])

    # -- comparisons --------------------------------------------------------------------------------------------------

    def _compared(self, node: cst.Comparison, wanted: bool) -> Part | None:
        groups = unbound(self._context, node)
        if groups is not None:
            self.is_exact = False
            return self.said(groups, wanted)
        operators, operands = comparison(node)
        if len(operators) > 1:
            pairs = zip(operators, operands, operands[1:], strict=False)
            each = [compare(self._context, [operator], [left, right]) for operator, left, right in pairs]
            return self._several("all", each, wanted)
        operator, (left, right) = operators[0], operands
        if isinstance(operator, cst.In | cst.NotIn):
            return self._listed(left, right, wanted is isinstance(operator, cst.In))
        sign = SIGNS[operator.__class__]
        if is_listed(right) or is_listed(left):
            listed, other = (right, left) if is_listed(right) else (left, right)
            return self._each(listed, other, sign, wanted)
        if is_literal(left) or (truth_of(left) is not None and truth_of(right) is None):
            left, right, sign = right, left, MIRRORED.get(sign, sign)
        truth = truth_of(right)
        if sign in ("==", "!=") and truth is not None and is_condition(left):
            if truth is not (sign == "==") and isinstance(left, cst.Attribute | cst.Subscript):
                # Of a block nobody knows what it is to be compared with False.
                self.turned.append(left)
            return self.said(left, wanted is (truth is (sign == "==")))
        bank = bank_of(left)
        if sign in ("==", "!=") and bank is not None and not bank.is_bit and is_bool(right):
            self.is_exact = False
            is_on = (truth is (sign == "==")) is wanted
            return self._of_register(left, "!=" if is_on else "==", "0", wanted)
        if is_condition(left) and is_condition(right):
            return self._unlike(left, right, wanted is (sign == "!=")) if sign in ("==", "!=") else None
        text, is_identity = own(self._context, node), isinstance(operator, cst.Is | cst.IsNot)
        if text and not is_identity and self._fits(text):
            return self._leaf(node, wanted)
        chosen = self._of_choice(left, sign, right, wanted) or self._of_choice(
            right, MIRRORED.get(sign, sign), left, wanted
        )
        if chosen is not None:
            return chosen
        texts = [self._value(side) for side in (left, right)]
        if not all(texts):
            return None
        return self._of_register(node, sign if wanted else OPPOSITE[sign], texts[1], wanted, texts[0])

    def _of_choice(self, node: Node, sign: str, other: Node, wanted: bool) -> Part | None:
        """``abs(ds.A) > 5``, ``max(ds.A, ds.B) > 5``: each possible value is compared."""
        name = called(node).lower()
        if not isinstance(node, cst.Call) or name not in ("abs", "max", "min") or keywords(node) or not arguments(node):
            return None
        values, limit = [self._value(argument) for argument in arguments(node)], self._value(other)
        sign = sign if wanted else OPPOSITE[sign]
        if not all(values) or not limit:
            return None
        if name == "abs":
            number = number_of(other)
            if len(values) > 1 or number is None or number < 0:
                return None
            function = "any" if sign in (">", ">=", "==") else "all"
            pairs = [f"{values[0]} {sign} {number}", f"{values[0]} {MIRRORED.get(sign, sign)} {-number}"]
        else:
            if sign not in MIRRORED:
                return None
            function = "any" if (sign[0] == ">") is (name == "max") else "all"
            pairs = [f"{value} {sign} {limit}" for value in values]
        return self._checked(function, pairs, node, wanted)

    def _of_register(self, node: Node, sign: str, value: str, wanted: bool, shown: str = "") -> Part | None:
        text = f"{shown or own(self._context, node)} {sign} {value}"
        if not wanted:
            self.turned.append(node)
        return single(text) if self._fits(text) else None

    def _value(self, node: Node) -> str:
        """A side of a comparison: a register, a constant, or the register that a rung before calculates."""
        bank = bank_of(node)
        if bank is not None and bank.is_bit:
            self.is_exact = False
            current = {"T": "td", "CT": "ctd"}.get(bank.name, "")
            return re.sub(rf"^{bank.dsl}(?=[.\[])", current, own(self._context, node)) if current else ""
        if bank is not None or is_literal(node):
            return own(self._context, node)
        if isinstance(node, cst.UnaryOperation) and is_literal(node.expression):
            return own(self._context, node)
        return self._result(node)

    def _result(self, node: Node) -> str:
        """The register with the result of a calculation, which a rung before makes; "" for what CLICK has not."""
        if not isinstance(node, cst.BaseExpression):
            return ""
        shown = code(node)
        if shown not in self._results:
            found = calculated(self._context, node, len(self._results))
            if found is None:
                return ""
            self.before += found.rungs
            self._results[shown] = found.result
        return self._results[shown]

    def _calculated(self, node: Node, wanted: bool) -> Part | None:
        """A calculation alone: it is not zero."""
        bit = bit_under_mask(self._context, node)
        if bit is not None:
            self.before += bit.rungs
            return single(bit.result if wanted else f"nc({bit.result})")
        result = self._result(node)
        return self._of_register(node, "!=" if wanted else "==", "0", wanted, result) if result else None

    # -- lists --------------------------------------------------------------------------------------------------------

    def _listed(self, left: Node, values: Node, wanted: bool) -> Part | None:
        """``ds.A in (1, 2)``, ``ds.A in range(1, 5)``, ``ds.A in ds[1:5]``."""
        texts: list[str] = []
        if isinstance(values, cst.Call) and called(values) == "range":
            given = arguments(values)
            bounds = [bound for argument in given if (bound := number_of(argument)) is not None]
            is_whole = len(bounds) == len(given) in (1, 2, 3) and not keywords(values)
            span = range(*bounds) if is_whole and bounds[2:] != [0] else range(0)
            if not span:
                return None
            shown = self._value(left)
            if span.step == 1 and len(span) > 1 and shown:
                signs = (">=", "<") if wanted else ("<", ">=")
                pairs = [f"{shown} {signs[0]} {span.start}", f"{shown} {signs[1]} {span.stop}"]
                return self._checked("all" if wanted else "any", pairs, left, wanted)
            texts = [str(number) for number in span] if len(span) <= _LISTED else []
        elif isinstance(values, cst.Tuple | cst.List | cst.Set):
            texts = [own(self._context, value) for value in elements(values)]
        elif isinstance(values, cst.Subscript) and isinstance(index := index_of(values), cst.Slice):
            bank = bank_of(values)
            first, last = number_of(index.lower), number_of(index.upper)
            if bank is None or first is None or last is None or index.step or last - first > _LISTED:
                return None
            texts = [f"{bank.dsl}[{number}]" for number in range(first, last)]
        shown = self._value(left)
        sign, function = ("==", "any") if wanted else ("!=", "all")
        pairs = [f"{shown} {sign} {text}" for text in texts]
        return self._checked(function, pairs, left, wanted) if shown and all(texts) else None

    def _each(self, listed: Node, other: Node, sign: str, wanted: bool) -> Part | None:
        """``ds.A == (1, 2)``, ``ds.A == (1 or 2)``, ``(ds.A or ds.B) == 5``: each compared by itself."""
        self.is_exact = False
        values = terms(listed) if isinstance(listed, cst.BooleanOperation) else elements(listed)
        is_all = isinstance(listed, cst.BooleanOperation) and isinstance(listed.operator, cst.And)
        numbers = all(map(is_literal, values))
        if truth_of(other) is not None or (numbers and (sign not in ("==", "!=") or is_all)):
            return None
        function = "all" if is_all or (numbers and sign == "!=") else "any"
        one, shown = ([self._value(value) for value in values], self._value(other))
        sides = [(shown, text) if numbers else (text, shown) for text in one]
        sign = sign if wanted else OPPOSITE[sign]
        pairs = [f"{left} {sign} {right}" for left, right in sides]
        function = function if wanted else _SWAPPED[function]
        return self._checked(function, pairs, other, wanted) if shown and all(one) else None

    def _checked(self, function: str, texts: Sequence[str], node: Node, wanted: bool) -> Part | None:
        if not wanted:
            self.turned.append(node)
        return joined(function, map(single, texts)) if all(map(self._fits, texts)) else None
