"""Instruction calls: arguments, and what is chained behind them, bound to the Spec's parameters."""

from __future__ import annotations

import ast

from clickgen.diagnostics import did_you_mean
from clickgen.instructions import INSTRUCTIONS
from clickgen.instructions.data import SEARCH, SEARCH_RANGE
from clickgen.instructions.spec import REQUIRED, Param, ParamKind, Spec
from clickgen.ir.program import Action, Value
from clickgen.source import Span
from clickgen.syntax.arguments import read_argument
from clickgen.syntax.conditions import read_series
from clickgen.syntax.context import Context
from clickgen.syntax.options import modifier_of, read_modifier
from clickgen.syntax.searches import read_range_comparison

_ELSEWHERE = {
    "latch": "set",
    "on_delay": "ton",
    "off_delay": "tof",
    "count_up": "ctu",
    "count_down": "ctd",
    "blockcopy": "copy_block",
    "fill": "copy_fill",
    "pack_bits": "copy_pack",
    "pack_words": "copy_pack",
    "pack_text": "copy_pack",
    "unpack_to_bits": "copy_unpack",
    "unpack_to_words": "copy_unpack",
    "math": "calc",
    "next": "next_loop",
}
"""What CLICK's ladder files and other dialects call an instruction."""

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


def read_call(context: Context, node: ast.Call) -> Action | None:
    """The instruction that a call statement writes, with what is chained behind it; None with problems."""
    links: list[ast.Call] = []
    base = node
    while isinstance(base.func, ast.Attribute) and isinstance(base.func.value, ast.Call):
        links.insert(0, base)
        base = base.func.value
    name = base.func.id if isinstance(base.func, ast.Name) else ""
    spec = INSTRUCTIONS.get(name)
    if spec is None:
        shown = name or context.text(base.func)
        known = _elsewhere(name) or did_you_mean(name, INSTRUCTIONS) if name else ""
        context.problem("CG108", base.func, f"there is no instruction {shown!r}", known or "see the language reference")
        return None
    if spec is SEARCH and _is_range_form(base):
        spec = SEARCH_RANGE
    args = _Call(context, spec, base, links).read()
    if args is None:
        return None
    if spec is SEARCH_RANGE:
        spec, args["flag"] = SEARCH, args.pop("found")
    return Action(spec, _in_order(spec, args), context.span(node))


def _in_order(spec: Spec, args: dict[str, Value]) -> dict[str, Value]:
    """Arguments in the order of the parameters, however they were written: names get their addresses in it."""
    return {param.name: args[param.name] for param in spec.params if param.name in args}


def _is_range_form(node: ast.Call) -> bool:
    """True for ``search(ds[1:101] >= 100, ...)``."""
    return any(isinstance(argument, ast.Compare) for argument in node.args[:1]) or any(
        keyword.arg == "comparison" for keyword in node.keywords
    )


def _elsewhere(name: str) -> str:
    own = _ELSEWHERE.get(name)
    return f"here it is called {INSTRUCTIONS[own].signature}" if own else ""


class _Call:
    """One call: its arguments by parameter, every fault reported."""

    def __init__(self, context: Context, spec: Spec, node: ast.Call, links: list[ast.Call]) -> None:
        self._context = context
        self._spec = spec
        self._node = node
        self._links = links
        self._bound: dict[str, ast.expr] = {}
        self._args: dict[str, Value] = {}
        self._faults = 0

    def read(self) -> dict[str, Value] | None:
        """The arguments; None with problems."""
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

    def _fault(self, code: str, place: ast.expr | ast.keyword | Span, message: str, hint: str = "") -> None:
        span = place if isinstance(place, Span) else self._context.span(place)
        signatures = (SEARCH, SEARCH_RANGE) if self._spec in (SEARCH, SEARCH_RANGE) else (self._spec,)
        help = " ".join(filter(None, (hint, " or ".join(spec.signature for spec in signatures))))
        self._context.problems.add(code, span, message, help)
        self._faults += 1

    # -- binding ------------------------------------------------------------------------------------------------------

    def _bind_positional(self) -> None:
        params = self._spec.params
        for index, argument in enumerate(self._node.args):
            if isinstance(argument, ast.Starred):
                self._fault("CG115", argument, "arguments are written one by one")
            elif index >= len(params):
                self._fault("CG109", argument, f"{self._spec.name} takes no more than {len(params)} arguments")
            else:
                self._bound[params[index].name] = argument

    def _bind_keywords(self) -> None:
        names = {alias: param.name for param in self._spec.params for alias in (param.name, *param.aliases)}
        for keyword in self._node.keywords:
            name = names.get(keyword.arg or "")
            if keyword.arg is None:
                self._fault("CG115", keyword, "arguments are written one by one")
            elif name is None:
                hint = self._relative(keyword.arg) or did_you_mean(keyword.arg, names)
                self._fault("CG109", keyword, f"{self._spec.name} has no argument {keyword.arg!r}", hint)
            elif name in self._bound:
                self._fault("CG111", keyword, f"{self._spec.name} is given {name!r} twice")
            else:
                self._bound[name] = keyword.value

    def _relative(self, word: str) -> str:
        relative = _RELATIVES.get((self._spec.name, word))
        return f"{relative} has it: {INSTRUCTIONS[relative].signature};" if relative else ""

    # -- chains -------------------------------------------------------------------------------------------------------

    def _bind_link(self, link: ast.Call) -> str:
        """Read one ``.reset(c.A, c.B)``; the name of the pin, or "" with problems."""
        assert isinstance(link.func, ast.Attribute)
        method = link.func.attr
        end = self._context.span(link.func)
        place = Span(end.path, end.end_line, end.end_col - len(method), end.end_line, end.end_col)
        pin = self._spec.methods.get(method)
        if pin is None:
            known = " and ".join(f".{name}" for name in self._spec.methods)
            hint = did_you_mean(method, self._spec.methods) or (f"it has {known}:" if known else _NOTHING_CHAINED)
            self._fault("CG109", place, f"{self._spec.name} has no .{method}(...)", self._relative(method) or hint)
            return ""
        if pin.name in self._bound or pin.name in self._args:
            self._fault("CG111", place, f"{self._spec.name} is given {method!r} twice")
            return ""
        nodes = _flat(link.args)
        own = {param.chained: param for param in self._spec.params if param.of_pin == pin.name}
        condition = None
        if not nodes:
            self._fault("CG110", place, f".{method}() needs a condition", f"write .{method}(c.Name) behind")
        elif any(isinstance(node, ast.Lambda | ast.Starred) for node in nodes):
            self._fault("CG115", nodes[0], f"the conditions of .{method}(...) stand one by one, without lambda")
        elif own and isinstance(nodes[-1], ast.Constant) and type(nodes[-1].value) is int:
            hint = f"write {next(iter(own))}={nodes[-1].value}:"
            self._fault("CG115", nodes[-1], f"a number is no condition of .{method}(...)", hint)
        else:
            condition = read_series(self._context, nodes)
            self._faults += condition is None
        for keyword in link.keywords:
            param = own.get(keyword.arg or "")
            if param is None:
                hint = did_you_mean(keyword.arg or "", own)
                self._fault("CG109", keyword, f".{method}() has no argument {keyword.arg or '**'!r}", hint)
            elif param.name in self._bound:
                self._fault("CG111", keyword, f"{self._spec.name} is given {param.name!r} twice")
            else:
                self._bound[param.name] = keyword.value
        if condition is None:
            return ""
        self._args[pin.name] = condition
        return pin.name

    # -- reading ------------------------------------------------------------------------------------------------------

    def _read(self, param: Param, node: ast.expr) -> None:
        if param.default is None and isinstance(node, ast.Constant) and node.value is None:
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
        value = read_argument(self._context, self._spec, param, node)
        if value is None:
            self._faults += 1
        else:
            self._args[param.name] = value

    def _read_modified(self, source: Param, call: ast.Call, attribute: ast.Attribute) -> None:
        """``copy(txt[1].as_value(), ds[1])``: the option stands behind the source."""
        options = read_modifier(self._context, call, attribute)
        given = self._bound.get("options")
        if given is not None and not (isinstance(given, ast.Constant) and given.value is None):
            self._fault("CG111", given, f"{self._spec.name} is given its option twice")
        if options is None:
            self._faults += 1
        else:
            self._args["options"] = options
        self._read(source, attribute.value)


def _flat(nodes: list[ast.expr]) -> list[ast.expr]:
    """Conditions one by one, those of tuples and lists included."""
    flat: list[ast.expr] = []
    for node in nodes:
        flat += _flat(node.elts) if isinstance(node, ast.Tuple | ast.List) else [node]
    return flat
