"""Instruction calls: arguments, and what is chained behind them, bound to the Spec's parameters."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import libcst as cst

from clickgen.device.banks import READ_ONLY
from clickgen.dialects.if_rungs.read.arguments import read_argument
from clickgen.dialects.if_rungs.read.conditions import fits_condition, read_series
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.nodes import (
    Node,
    arguments,
    called,
    elements,
    is_starred,
    keyword_name,
    keywords,
    literal,
    whole_number,
    word,
)
from clickgen.dialects.if_rungs.read.options import modifier_of, read_modifier
from clickgen.dialects.if_rungs.read.searches import read_range_comparison
from clickgen.dialects.if_rungs.trade import ARGUMENTS
from clickgen.dialects.if_rungs.ways_out import hints, no_call
from clickgen.dialects.if_rungs.ways_out.misgiven import misgiven
from clickgen.instructions import INSTRUCTIONS
from clickgen.instructions.spec import REQUIRED, Access, Param, ParamKind, Spec
from clickgen.ir.operands import Cell, Constant, Immediate, Operand, Pointer, Range, form_of
from clickgen.ir.program import Action, Value
from clickgen.problems.diagnostics import did_you_mean
from clickgen.text.edits import Fix
from clickgen.text.source import Span
from clickgen.text.wording import shorten

_NOTHING_CHAINED = "nothing is chained behind it:"

_RELATIVES = {
    ("ton", "reset"): "rton",
    ("tof", "reset"): "rtof",
    ("ctu", "count_down"): "ctud",
    ("ctu", "down"): "ctud",
    ("ctd", "count_down"): "ctud",
    ("ctd", "down"): "ctud",
}
"""The instruction that has the input which this one lacks."""


def read_call(context: Context, node: cst.Call) -> Action | None:
    """The instruction that a call statement writes, with what is chained behind it; None with problems."""
    links: list[cst.Call] = []
    base = node
    while isinstance(base.func, cst.Attribute) and isinstance(base.func.value, cst.Call):
        links.insert(0, base)
        base = base.func.value
    name = called(base)
    spec = INSTRUCTIONS.get(name)
    if spec is None:
        shown = name or shorten(context.text(base.func))
        help, fix = no_call.no_instruction(context, base, partial(fits_action, context))
        context.problem("CG108", base.func, f"there is no instruction {shown!r}", help, fix if base is node else None)
        return None
    is_short = spec.short is not None and _is_range_form(base)
    args = _Call(context, spec, is_short, base, links).read()
    return None if args is None else Action(spec, _in_order(spec, args), context.span(node))


def _in_order(spec: Spec, args: dict[str, Value]) -> dict[str, Value]:
    """Arguments in the order of the parameters, however they were written: names get their addresses in it."""
    names = {param.name: [name for name in (param.name, *param.aliases) if name in args] for param in spec.params}
    return {name: args[given[0]] for name, given in names.items() if given}


def _is_range_form(node: cst.Call) -> bool:
    """True for ``search(ds[1:101] >= 100, ...)``."""
    return any(isinstance(argument, cst.Comparison) for argument in arguments(node)[:1]) or any(
        keyword_name(keyword) == "comparison" for keyword in keywords(node)
    )


def fits_action(context: Context, text: str) -> bool:
    """True for the text of an action without a fault."""
    trial = context.of_text(text)
    node = trial.expression()
    action = read_call(trial, node) if isinstance(node, cst.Call) else None
    return action is not None and not trial.problems.found and _takes_all(action)


def _takes_all(action: Action) -> bool:
    """True where each operand is of a bank that the instruction takes there, as far as names tell."""
    spec = action.spec
    for param in spec.params:
        value, slot = action.args.get(param.name), param.slot
        if param.kind is not ParamKind.OPERAND or not isinstance(value, Operand):
            continue
        places = {Immediate: slot.immediates, Pointer: slot.pointers, Range: slot.ranges, Cell: slot.cells}
        forms = slot.constants if isinstance(value, Constant) else places.get(type(value), slot.cells + slot.ranges)
        if form_of(value) not in forms or (slot.access is Access.WRITE and form_of(value) in READ_ONLY):
            return False
    ends = [action.args.get(name) for name in spec.matrix]
    forms_of_ends = [form_of(end) for end in ends if isinstance(end, Operand)]
    pairs = [pair for variant in spec.variants for pair in variant.pairs]
    return (
        not pairs
        or len(forms_of_ends) < 2
        or any(forms_of_ends[0] in pair.sources and forms_of_ends[1] in pair.targets for pair in pairs)
    )


class _Call:
    """One call: its arguments by parameter, every fault reported."""

    def __init__(self, context: Context, spec: Spec, is_short: bool, node: cst.Call, links: list[cst.Call]) -> None:
        self._context = context
        self._forms = spec.forms
        self._spec = spec.short if is_short and spec.short is not None else spec
        self._node = node
        self._links = links
        self._bound: dict[str, Node] = {}
        self._args: dict[str, Value] = {}
        self._faults = 0

    def read(self) -> dict[str, Value] | None:
        """The arguments; None with problems."""
        wrong = misgiven(self._context, self._spec, self._node, partial(fits_action, self._context))
        if wrong is not None:
            self._context.problem(wrong.code, wrong.node, wrong.message, wrong.help)
            return None
        self._bind_positional()
        self._bind_keywords()
        chained = {name for link in self._links if (name := self._bind_link(link))}
        for param in self._spec.params:
            is_given = param.name in self._bound or param.name in chained
            if param.default is REQUIRED and not is_given and not self._faults:
                self._fault("CG110", self._node, f"{self._spec.name} needs {param.name!r}")
        for param in self._spec.params:
            if param.name in self._bound:
                self._read(param, self._bound[param.name])
        if self._faults:
            return None
        return self._args

    def _fault(self, code: str, place: Node | Span, message: str, hint: str = "", fix: Fix | None = None) -> None:
        span = place if isinstance(place, Span) else self._context.span(place)
        help = " ".join(filter(None, (hint, " or ".join(form.signature for form in self._forms))))
        self._context.problems.add(code, span, message, help, fix=fix)
        self._faults += 1

    # -- binding ------------------------------------------------------------------------------------------------------

    def _bind_positional(self) -> None:
        params = self._spec.params
        for index, argument in enumerate(arguments(self._node)):
            if is_starred(argument):
                self._fault("CG115", argument, "arguments are written one by one")
            elif index >= len(params):
                self._fault("CG109", argument, f"{self._spec.name} takes no more than {len(params)} arguments")
            else:
                self._bound[params[index].name] = argument

    def _bind_keywords(self) -> None:
        names = {alias: param.name for param in self._spec.params for alias in (param.name, *param.aliases)}
        for keyword in keywords(self._node):
            written = keyword_name(keyword)
            name = names.get(written)
            if not written:
                self._fault("CG115", keyword, "arguments are written one by one")
            elif name is None:
                hint, fix = self._relative(written), None
                if not hint:
                    hint, fix = no_call.other_argument(self._context, self._spec, keyword, tuple(names))
                if not hint and written in ("oneshot", "one_shot", "os", "ons"):
                    hint = "it has no one-shot; put an edge into the condition, re(c.A):"
                hint = hint or did_you_mean(written, names)
                self._fault("CG109", keyword, f"{self._spec.name} has no argument {written!r}", hint, fix)
            elif name in self._bound:
                self._fault("CG111", keyword, f"{self._spec.name} is given {name!r} twice")
            else:
                self._bound[name] = keyword.value

    def _relative(self, word: str) -> str:
        relative = _RELATIVES.get((self._spec.name, word))
        return f"{relative} has it: {INSTRUCTIONS[relative].signature};" if relative else ""

    # -- chains -------------------------------------------------------------------------------------------------------

    def _bind_link(self, link: cst.Call) -> str:
        """Read one ``.reset(c.A, c.B)``; the name of the pin, or "" with problems."""
        assert isinstance(link.func, cst.Attribute)
        method = word(link.func.attr)
        place = self._context.span(link.func.attr)
        pin = self._spec.methods.get(method)
        if pin is None:
            known = " and ".join(f".{name}" for name in self._spec.methods)
            other = ARGUMENTS.get(method.lower(), "").replace("count_down", "down")
            hint = f"write .{other}(...):" if other in self._spec.methods else did_you_mean(method, self._spec.methods)
            hint = hint or (f"it has {known}:" if known else _NOTHING_CHAINED)
            self._fault("CG109", place, f"{self._spec.name} has no .{method}(...)", self._relative(method) or hint)
            return ""
        if pin.name in self._bound or pin.name in self._args:
            self._fault("CG111", place, f"{self._spec.name} is given {method!r} twice")
            return ""
        nodes = _flat(arguments(link))
        own = {param.chained: param for param in self._spec.params if param.of_pin == pin.name}
        condition = None
        if not nodes:
            self._fault("CG110", place, f".{method}() needs a condition", f"write .{method}(c.Name) behind")
        elif any(isinstance(node, cst.Lambda) or is_starred(node) for node in nodes):
            inner = [node.body if isinstance(node, cst.Lambda) else node for node in nodes]
            shown = ", ".join(self._context.text(node) for node in inner)
            hint = f"write .{method}({shown}):" if fits_condition(self._context, f"all({shown})") else ""
            self._fault("CG115", nodes[0], f"the conditions of .{method}(...) stand one by one, without lambda", hint)
        elif own and (number := whole_number(nodes[-1])) is not None:
            hint = f"write {next(iter(own))}={number}:"
            self._fault("CG115", nodes[-1], f"a number is no condition of .{method}(...)", hint)
        else:
            condition = read_series(self._context, nodes)
            self._faults += condition is None
        for keyword in keywords(link):
            written = keyword_name(keyword)
            param = own.get(written)
            if param is None:
                hint = did_you_mean(written, own)
                self._fault("CG109", keyword, f".{method}() has no argument {written or '**'!r}", hint)
            elif param.name in self._bound:
                self._fault("CG111", keyword, f"{self._spec.name} is given {param.name!r} twice")
            else:
                self._bound[param.name] = keyword.value
        if condition is None:
            return ""
        self._args[pin.name] = condition
        return pin.name

    # -- reading ------------------------------------------------------------------------------------------------------

    def _read(self, param: Param, node: Node) -> None:
        if param.default is None and literal(node) is None:
            return
        if param.kind is ParamKind.RANGE_COMPARISON:
            found = read_range_comparison(self._context, node)
            self._args.update(found or {})
            self._faults += found is None
            return
        modifier = modifier_of(node)
        if modifier and param.name == self._spec.matrix[0]:
            self._read_modified(param, *modifier)
            return
        target = self._bound.get("destination")
        shown = hints.own(self._context, target) if target is not None else ""
        value = read_argument(self._context, self._spec, param, node, shown)
        if value is None:
            self._faults += 1
        else:
            self._args[param.name] = value

    def _read_modified(self, source: Param, call: cst.Call, attribute: cst.Attribute) -> None:
        """``copy(txt[1].as_value(), ds[1])``: the option stands behind the source."""
        options = read_modifier(self._context, call, attribute)
        given = self._bound.get("options")
        if given is not None and literal(given) is not None:
            self._fault("CG111", given, f"{self._spec.name} is given its option twice")
        if options is None:
            self._faults += 1
        else:
            self._args["options"] = options
        self._read(source, attribute.value)


def _flat(nodes: Sequence[Node]) -> list[Node]:
    """Conditions one by one, those of tuples and lists included."""
    flat: list[Node] = []
    for node in nodes:
        flat += _flat(elements(node)) if isinstance(node, cst.Tuple | cst.List) else [node]
    return flat
