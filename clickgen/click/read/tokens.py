"""Turns output tokens into actions, by the templates with which the instructions' Specs write them.

A template is split like a token. What it names is at the same place in the token, and is read by the kind of
its parameter.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from clickgen.click.draw.tokens import keyword_of, pin_row
from clickgen.click.read.calls import Call, call_of
from clickgen.click.read.values import value_of
from clickgen.device.banks import current_value, parse_address
from clickgen.instructions import every, of_instructions
from clickgen.instructions.raw import rows_of
from clickgen.instructions.spec import REQUIRED, ParamKind, Spec, Variant
from clickgen.ir.conditions import Condition
from clickgen.ir.made import NOP_TOKEN, nothing
from clickgen.ir.operands import Cell, Integer, Range
from clickgen.ir.program import Action, Value
from clickgen.text.source import Span

PIN = re.compile(r"\.[a-z_]+\(.*\)")

_PLACE = re.compile(r"\{(\w+)\}")
_PATTERNS = {ParamKind.COMPARISON: "==|!=|<=|>=|<|>"}


@dataclass(frozen=True)
class _Template:
    """A Spec's token: what each argument must look like; ``optional`` names those that may be missing."""

    spec: Spec
    arguments: tuple[re.Pattern[str], ...]
    keywords: Mapping[str, re.Pattern[str]]
    optional: frozenset[str]

    def match(self, call: Call) -> dict[str, str] | None:
        """Return the texts of the parameters; None if the token is another's."""
        is_known = call.keywords.keys() <= self.keywords.keys()
        is_whole = self.keywords.keys() - self.optional <= call.keywords.keys()
        if len(call.arguments) != len(self.arguments) or not is_known or not is_whole:
            return None
        pairs = [*zip(self.arguments, call.arguments, strict=True)]
        pairs += [(self.keywords[name], text) for name, text in call.keywords.items()]
        texts: dict[str, str] = {}
        for pattern, text in pairs:
            match = pattern.fullmatch(text)
            if match is None:
                return None
            texts |= match.groupdict()
        return texts


@of_instructions
def _templates() -> dict[str, tuple[_Template, ...]]:
    """Every template by the name of its token. What is kept as it is has none, nor has what is no call."""
    found: dict[str, tuple[_Template, ...]] = {}
    for spec in every():
        for variant in () if spec.effects.is_unknown else spec.variants:
            if variant.token != NOP_TOKEN:
                name, template = _template(spec, variant)
                found[name] = (*found.get(name, ()), template)
    return found


def _template(spec: Spec, variant: Variant) -> tuple[str, _Template]:
    text, optional = variant.token, set()
    for param in spec.params:
        word = keyword_of(param)
        if word:
            optional.add(word)
            text = text.replace(f"{{{param.name}}}", f",{word}={{{param.name}}}")
    call = call_of(text)
    assert call is not None, variant.token
    kinds = {param.name: param.kind for param in spec.params}
    keywords = {word: _pattern(part, kinds) for word, part in call.keywords.items()}
    arguments = tuple(_pattern(part, kinds) for part in call.arguments)
    return call.name, _Template(spec, arguments, keywords, frozenset(optional))


def _pattern(text: str, kinds: Mapping[str, ParamKind]) -> re.Pattern[str]:
    """A part of a template as an expression: its places are groups, and extra spaces are allowed."""
    pieces = _PLACE.split(text)
    for index, piece in enumerate(pieces):
        if index % 2:
            inner = _PATTERNS.get(kinds.get(piece, ParamKind.OPERAND), ".+?")
            pieces[index] = f"(?P<{piece}>{inner})"
        else:
            pieces[index] = r"\s*".join(re.escape(part) for part in re.split(r"\s+", piece))
    return re.compile("".join(pieces), re.DOTALL)


def specs_of(token: str) -> list[Spec]:
    """The instructions that are written with the name of this token, such as ``on_delay``."""
    return [*dict.fromkeys(template.spec for template in _templates().get(token.partition("(")[0], ()))]


# -- boxes ------------------------------------------------------------------------------------------------------------


def height_of(token: str) -> int:
    """The rows of an instruction (click-facts [grid.heights]); 1 for an unknown one."""
    heights = [spec.height for spec in specs_of(token)]
    return max(heights, default=rows_of(token))


def pin_row_of(token: str, pin: str) -> int:
    """The row of a pin below its instruction's; 0 if it has no such pin."""
    name = pin.partition("(")[0]
    for template in _templates().get(token.partition("(")[0], ()):
        for param in template.spec.pins:
            if param.pin.partition("(")[0] == name:
                return pin_row(template.spec, param)
    return 0


def is_own_input_below(token: str) -> bool:
    """True for a box whose own input has a row below its first one."""
    return any(template.spec.own_row for template in _templates().get(token.partition("(")[0], ()))


# -- actions ----------------------------------------------------------------------------------------------------------


def action_of(token: str, pins: Mapping[str, Condition], span: Span) -> Action | None:
    """Return the action that would write this token and these pins; None if no Spec writes it."""
    if token == NOP_TOKEN:
        return None if pins else nothing(span)
    call = call_of(token)
    if call is None:
        return None
    for template in _templates().get(call.name, ()):
        texts = template.match(call)
        args = _with_pins(template.spec, texts, pins) if texts is not None else None
        action = _action(template.spec, args, span) if args is not None else None
        if action is not None:
            return action
    return None


def _with_pins(spec: Spec, texts: dict[str, str], pins: Mapping[str, Condition]) -> dict[str, str | Condition] | None:
    """The texts with the conditions of the pins; None if the instruction has others."""
    found: dict[str, str | Condition] = dict(texts)
    for token, condition in pins.items():
        for param in spec.pins:
            of_pin = [other for other in spec.params if other.of_pin == param.name]
            pattern = _pattern(param.pin, {other.name: other.kind for other in of_pin})
            match = pattern.fullmatch(token)
            if match:
                found |= {param.name: condition, **match.groupdict()}
                break
        else:
            return None
    needed = (param for param in spec.pins if param.default is REQUIRED or param.missing_pin)
    return found if all(param.name in found for param in needed) else None


def _action(spec: Spec, given: Mapping[str, str | Condition], span: Span) -> Action | None:
    """The arguments read by their kinds, in the order of the parameters."""
    args: dict[str, Value] = {}
    for param in spec.params:
        text = given.get(param.name)
        if text is None or (param.kind is ParamKind.FLAG and text == "0"):
            continue
        value = value_of(param, text, span) if isinstance(text, str) else text
        # Only the language has a constant step of a jump: CLICK jumps to the one that a register holds
        # (click-facts [drum.inputs]).
        if value is None or (param.of_pin and isinstance(value, Integer)):
            return None
        args[param.name] = value
    return _shortened(Action(spec, args, span), given)


def _shortened(action: Action, given: Mapping[str, str | Condition]) -> Action | None:
    """Leave out what follows from the rest: a current value from its timer, the end of a block from its source."""
    args = dict(action.args)
    for param in action.spec.params:
        value = args.get(param.name)
        if param.extends_over and isinstance(value, Range):
            source = args.get(param.extends_over)
            if not isinstance(source, Range) or len(source) != len(value) or value.is_reversed:
                return None
            first = value.addresses()[0]
            args[param.name] = Cell(first, value.span)
        own = given.get(f"{param.name}_value")
        if own is not None:
            address = parse_address(str(own))
            if not isinstance(value, Cell) or address != current_value(value.address):
                return None
    shortened = Action(action.spec, args, action.span)
    return shortened if _has_form(shortened) else None


def _has_form(action: Action) -> bool:
    """False if the instruction has no token for these banks."""
    try:
        return action.variant is not None
    except ValueError:
        return False
