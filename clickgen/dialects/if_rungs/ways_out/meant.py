"""What a condition in the form of another language means here: ``not 0 < ds.A < 5``, ``x[1] == False``.

The caller shows it as a way out, and the judge of fixes looks at what is turned round.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from clickgen.dialects.if_rungs.fix.rewrite import opposite_text, python_logic
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.trade import CONDITIONS, advice
from clickgen.dialects.if_rungs.ways_out.binding import compare, is_tight, unbound
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
SIGNS: dict[type[ast.cmpop], str] = {
    ast.Eq: "==",
    ast.NotEq: "!=",
    ast.Is: "==",
    ast.IsNot: "!=",
    ast.Lt: "<",
    ast.LtE: "<=",
    ast.Gt: ">",
    ast.GtE: ">=",
}
MIRRORED = {"<": ">", "<=": ">=", ">": "<", ">=": "<="}


class Meant(NamedTuple):
    """A condition in the language. ``turned`` are the single conditions of which it has the opposite."""

    text: str
    turned: tuple[ast.expr, ...]
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


def meant(context: Context, node: ast.expr, fits: Fits, wanted: bool = True) -> Meant | None:
    """What an expression means as a condition, or its opposite where it is not wanted; None for what is not certain."""
    reader = _Reader(context, fits)
    part = reader.said(node, wanted)
    text = part.text if part is not None else ""
    if not text or len(text) > _LONGEST or not fits(text):
        return None
    return Meant(text, tuple(reader.turned), tuple(reader.before), reader.is_exact)


class _Part(NamedTuple):
    """A single condition, or several in ``all`` or ``any``."""

    function: str
    texts: tuple[str, ...]

    @property
    def text(self) -> str:
        return f"{self.function}({', '.join(self.texts)})" if self.function else self.texts[0]


def _single(text: str) -> _Part:
    return _Part("", (text,))


def _joined(function: str, parts: Iterable[_Part | None]) -> _Part | None:
    texts: list[str] = []
    for part in parts:
        if part is None:
            return None
        texts += part.texts if part.function in ("", function) else [part.text]
    return _Part(function, tuple(texts)) if len(texts) > 1 else _single(texts[0]) if texts else None


class _Reader:
    def __init__(self, context: Context, fits: Fits) -> None:
        self._context = context
        self._fits = fits
        self._left = _STEPS
        self.turned: list[ast.expr] = []
        self.before: list[str] = []
        self._results: dict[str, str] = {}
        self.is_exact = True

    def said(self, node: ast.expr, wanted: bool) -> _Part | None:
        """An expression in the language, or its opposite; None where that is not certain."""
        self._left -= 1
        if self._left < 0:
            return None
        logic = python_logic(node) or _algebra(node)
        self.is_exact &= not logic or logic[0] != "+"
        if logic and logic[1] == "nc":
            return self.said(logic[2][0], not wanted)
        if logic:
            return self._several(logic[1], logic[2], wanted)
        if isinstance(node, ast.Call):
            return self._called(node, wanted)
        if isinstance(node, ast.Compare):
            return self._compared(node, wanted)
        if isinstance(node, ast.IfExp):
            return self._chosen(node, wanted)
        if isinstance(node, ast.Tuple | ast.List) and len(node.elts) == 1:
            return self.said(node.elts[0], wanted)
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.BitXor) and is_condition(node):
            return self._unlike(node.left, node.right, wanted)
        if isinstance(node, ast.BinOp):
            sides = [node.left, node.right]
            if is_tight(node) and any(map(is_condition, sides)):
                self.is_exact = False
                return self._several("all" if isinstance(node.op, ast.BitAnd) else "any", sides, wanted)
            return self._calculated(node, wanted)
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.Invert | ast.USub):
            return self._calculated(node, wanted)
        if isinstance(node, ast.Name):
            return self._of_text(node, flat_address(node.id), wanted)
        return self._leaf(node, wanted)

    def _several(self, function: str, terms: Sequence[ast.expr], wanted: bool) -> _Part | None:
        kept = [term for term in terms if truth_of(term) is not (function == "all")]
        function = function if wanted else _SWAPPED[function]
        return _joined(function, (self.said(term, wanted) for term in kept))

    def _leaf(self, node: ast.expr, wanted: bool) -> _Part | None:
        """A single condition of the language, or its opposite."""
        text = own(self._context, node)
        if not text or not self._fits(text):
            return self._of_text(node, self._member(node), wanted)
        if wanted:
            return _single(text)
        turned = opposite_text(self._context, node)
        self.turned.append(node)
        return _single(" ".join(turned.split())) if turned else None

    def _member(self, node: ast.expr) -> str:
        """The bit that ``t.A.done`` is; "" for anything else."""
        bank = bank_of(node)
        if not isinstance(node, ast.Attribute) or bank is None or not own(self._context, node.value):
            return ""
        help, _ = member_hint(self._context, node, bank, own(self._context, node.value).removeprefix(bank.dsl))
        return help.removeprefix("write ") if help.startswith("write ") else ""

    def _of_text(self, node: ast.expr, text: str, wanted: bool) -> _Part | None:
        """A bit that is written otherwise than the node has it."""
        self.is_exact = False
        if not text or not self._fits(text):
            return None
        if wanted:
            return _single(text)
        self.turned.append(node)
        return _single(f"nc({text})") if re.fullmatch(r"[a-z]+[.\[][\w\"\]]+", text) else None

    def _called(self, node: ast.Call, wanted: bool) -> _Part | None:
        name = node.func.id if isinstance(node.func, ast.Name) else ""
        if node.keywords or any(isinstance(argument, ast.Starred) for argument in node.args):
            return None
        if name in _SWAPPED and node.args:
            return self._several(name, node.args, wanted)
        inner = node.args[0] if len(node.args) == 1 else None
        if name == "nc" and inner is not None and not isinstance(inner, ast.Attribute | ast.Subscript):
            return self.said(inner, not wanted)
        if name in _TURNED_EDGE and inner is not None and not isinstance(inner, ast.Attribute | ast.Subscript):
            part = self.said(inner, True)
            bit = re.fullmatch(r"(nc\()?([a-z]+(?:\.\w+|\[[^\[\]]+\]))\)?", part.text) if part else None
            edge = bit and f"{_TURNED_EDGE[name] if bit[1] else name}({bit[2]})"
            return _single(edge) if edge and wanted and self._fits(edge) else None
        if self._fits(own(self._context, node) or "-"):
            return self._leaf(node, wanted)
        found = advice(name, CONDITIONS)
        text = own_code(self._context, found, around_value(name, node.args), self._fits) if found else ""
        return self._of_text(node, text, wanted)

    def _chosen(self, node: ast.IfExp, wanted: bool) -> _Part | None:
        """``x[1] if x[2] else x[3]``: two ways in parallel."""
        legs: list[_Part | None] = []
        for holds, value in ((True, node.body), (False, node.orelse)):
            truth = truth_of(value)
            if truth is None:
                legs.append(_joined("all", [self.said(node.test, holds), self.said(value, wanted)]))
            elif truth is wanted:
                legs.append(self.said(node.test, holds))
        return _joined("any", legs)

    def _unlike(self, one: ast.expr, other: ast.expr, wanted: bool) -> _Part | None:
        """One of two conditions, but not both; where that is not wanted, both or none."""
        pairs = ((holds, holds is not wanted) for holds in (True, False))
        return _joined("any", [_joined("all", [self.said(one, a), self.said(other, b)]) for a, b in pairs])

    # -- comparisons --------------------------------------------------------------------------------------------------

    def _compared(self, node: ast.Compare, wanted: bool) -> _Part | None:
        groups = unbound(self._context, node)
        if groups is not None:
            self.is_exact = False
            return self.said(groups, wanted)
        if len(node.ops) > 1:
            operands = [node.left, *node.comparators]
            pairs = zip(operands, node.ops, operands[1:], strict=False)
            return self._several("all", [compare(left, op, right) for left, op, right in pairs], wanted)
        left, op, right = node.left, node.ops[0], node.comparators[0]
        if isinstance(op, ast.In | ast.NotIn):
            return self._listed(left, right, wanted is isinstance(op, ast.In))
        sign = SIGNS[type(op)]
        if _is_listed(right) or _is_listed(left):
            values, other = (right, left) if _is_listed(right) else (left, right)
            return self._each(values, other, sign, wanted)
        if isinstance(left, ast.Constant) or (truth_of(left) is not None and truth_of(right) is None):
            left, right, sign = right, left, MIRRORED.get(sign, sign)
        truth = truth_of(right)
        if sign in ("==", "!=") and truth is not None and is_condition(left):
            if truth is not (sign == "==") and isinstance(left, ast.Attribute | ast.Subscript):
                # Of a block nobody knows what it is to be compared with False.
                self.turned.append(left)
            return self.said(left, wanted is (truth is (sign == "==")))
        bank = bank_of(left)
        if sign in ("==", "!=") and bank is not None and not bank.is_bit and _is_bool(right):
            self.is_exact = False
            is_on = (truth is (sign == "==")) is wanted
            return self._of_register(left, "!=" if is_on else "==", "0", wanted)
        if is_condition(left) and is_condition(right):
            return self._unlike(left, right, wanted is (sign == "!=")) if sign in ("==", "!=") else None
        if own(self._context, node) and self._fits(own(self._context, node)) and not isinstance(op, ast.Is | ast.IsNot):
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

    def _of_choice(self, node: ast.expr, sign: str, other: ast.expr, wanted: bool) -> _Part | None:
        """``abs(ds.A) > 5``, ``max(ds.A, ds.B) > 5``: each possible value is compared."""
        name = node.func.id.lower() if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) else ""
        if not isinstance(node, ast.Call) or name not in ("abs", "max", "min") or node.keywords or not node.args:
            return None
        values, limit = [self._value(argument) for argument in node.args], self._value(other)
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

    def _of_register(self, node: ast.expr, sign: str, value: str, wanted: bool, shown: str = "") -> _Part | None:
        text = f"{shown or own(self._context, node)} {sign} {value}"
        if not wanted:
            self.turned.append(node)
        return _single(text) if self._fits(text) else None

    def _value(self, node: ast.expr) -> str:
        """A side of a comparison: a register, a constant, or the register that a rung before calculates."""
        bank = bank_of(node)
        if bank is not None and bank.is_bit:
            self.is_exact = False
            current = {"T": "td", "CT": "ctd"}.get(bank.name, "")
            return re.sub(rf"^{bank.dsl}(?=[.\[])", current, own(self._context, node)) if current else ""
        if bank is not None or isinstance(node, ast.Constant):
            return own(self._context, node)
        if isinstance(node, ast.UnaryOp) and isinstance(node.operand, ast.Constant):
            return own(self._context, node)
        return self._result(node)

    def _result(self, node: ast.expr) -> str:
        """The register with the result of a calculation, which a rung before makes; "" for what CLICK has not."""
        shown = ast.unparse(node)
        if shown not in self._results:
            found = calculated(self._context, node, len(self._results))
            if found is None:
                return ""
            self.before += found.rungs
            self._results[shown] = found.result
        return self._results[shown]

    def _calculated(self, node: ast.expr, wanted: bool) -> _Part | None:
        """A calculation alone: it is not zero."""
        bit = bit_under_mask(self._context, node)
        if bit is not None:
            self.before += bit.rungs
            return _single(bit.result if wanted else f"nc({bit.result})")
        result = self._result(node)
        return self._of_register(node, "!=" if wanted else "==", "0", wanted, result) if result else None

    # -- lists --------------------------------------------------------------------------------------------------------

    def _listed(self, left: ast.expr, values: ast.expr, wanted: bool) -> _Part | None:
        """``ds.A in (1, 2)``, ``ds.A in range(1, 5)``, ``ds.A in ds[1:5]``."""
        texts: list[str] = []
        if isinstance(values, ast.Call) and isinstance(values.func, ast.Name) and values.func.id == "range":
            bounds = [bound for argument in values.args if (bound := number_of(argument)) is not None]
            is_whole = len(bounds) == len(values.args) in (1, 2, 3) and not values.keywords
            span = range(*bounds) if is_whole and bounds[2:] != [0] else range(0)
            if not span:
                return None
            shown = self._value(left)
            if span.step == 1 and len(span) > 1 and shown:
                low, high = values.args if len(bounds) > 1 else (ast.Constant(0), values.args[0])
                first, last = (ast.unparse(bound) for bound in (low, high))
                signs = (">=", "<") if wanted else ("<", ">=")
                pairs = [f"{shown} {signs[0]} {first}", f"{shown} {signs[1]} {last}"]
                return self._checked("all" if wanted else "any", pairs, left, wanted)
            texts = [str(number) for number in span] if len(span) <= _LISTED else []
        elif isinstance(values, ast.Tuple | ast.List | ast.Set):
            texts = [own(self._context, value) for value in values.elts]
        elif isinstance(values, ast.Subscript) and isinstance(values.slice, ast.Slice):
            bank, index = bank_of(values), values.slice
            first_, last_ = number_of(index.lower), number_of(index.upper)
            if bank is None or first_ is None or last_ is None or index.step or last_ - first_ > _LISTED:
                return None
            texts = [f"{bank.dsl}[{number}]" for number in range(first_, last_)]
        shown = self._value(left)
        sign, function = ("==", "any") if wanted else ("!=", "all")
        pairs = [f"{shown} {sign} {text}" for text in texts]
        return self._checked(function, pairs, left, wanted) if shown and all(texts) else None

    def _each(self, values: ast.expr, other: ast.expr, sign: str, wanted: bool) -> _Part | None:
        """``ds.A == (1, 2)``, ``ds.A == (1 or 2)``, ``(ds.A or ds.B) == 5``: each compared by itself."""
        self.is_exact = False
        terms = values.values if isinstance(values, ast.BoolOp) else getattr(values, "elts", [])
        is_all = isinstance(values, ast.BoolOp) and isinstance(values.op, ast.And)
        numbers = all(isinstance(term, ast.Constant) for term in terms)
        if truth_of(other) is not None or (numbers and (sign not in ("==", "!=") or is_all)):
            return None
        function = "all" if is_all or (numbers and sign == "!=") else "any"
        one, shown = ([self._value(term) for term in terms], self._value(other))
        sides = [(shown, text) if numbers else (text, shown) for text in one]
        sign = sign if wanted else OPPOSITE[sign]
        pairs = [f"{left} {sign} {right}" for left, right in sides]
        function = function if wanted else _SWAPPED[function]
        return self._checked(function, pairs, other, wanted) if shown and all(one) else None

    def _checked(self, function: str, texts: Sequence[str], node: ast.expr, wanted: bool) -> _Part | None:
        if not wanted:
            self.turned.append(node)
        return _joined(function, map(_single, texts)) if all(map(self._fits, texts)) else None


# -- what a part is ---------------------------------------------------------------------------------------------------


def _algebra(node: ast.expr) -> tuple[str, str, list[ast.expr]] | None:
    """``c.A + c.B`` and ``c.A * c.B``, as boolean algebra writes or and and."""
    function = {ast.Add: "any", ast.Mult: "all"}.get(type(node.op)) if isinstance(node, ast.BinOp) else None
    if function is None or not isinstance(node, ast.BinOp) or not is_condition(node):
        return None
    return ("+", function, [node.left, node.right])


def _is_listed(node: ast.expr) -> bool:
    """True for several values where one is compared."""
    if isinstance(node, ast.BoolOp):
        return not any(is_condition(value) for value in node.values)
    return isinstance(node, ast.Tuple | ast.List | ast.Set) and len(node.elts) > 0


def _is_bool(node: ast.expr) -> bool:
    return (isinstance(node, ast.Constant) and isinstance(node.value, bool)) or (
        isinstance(node, ast.Name) and truth_of(node) is not None
    )
