"""The page of an instruction, made from its Spec and from the ladder of its example."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from dataclasses import replace
from itertools import product

from docs_examples import built, examples
from docs_markdown import block, bullets, listed, problem_link, quoted, table

from clickgen.device.banks import parse_address
from clickgen.device.system import system_name_of
from clickgen.dialects.if_rungs.read.options import MODIFIERS
from clickgen.instructions.copies import CONVERSIONS
from clickgen.instructions.data import SEARCH, SEARCH_RANGE
from clickgen.instructions.raw import RAW
from clickgen.instructions.spec import CODE, HEX, INTEGER, REAL, REQUIRED, TEXT, Pair, Param, ParamKind, Slot, Spec
from clickgen.instructions.timers import UNITS

MADE = "<!-- made from the code: change it there and run make docs -->"
_DISPUTED = f"with the warning {problem_link('CG312')}"


def instruction_page(spec: Spec) -> str:
    parts = [f"# {spec.name}", MADE, spec.summary, bullets(map(quoted, _signatures(spec)))]
    if spec.params:
        parts += ["## Arguments", _arguments(spec)]
    if spec is SEARCH:
        parts += ["In the second form:", _arguments(SEARCH_RANGE)]
    parts += [*_matrix(spec), *_conversions(spec), *_example(spec), "## In CLICK", bullets(_in_click(spec))]
    if spec.notes:
        parts += ["## Notes", bullets(spec.notes)]
    return "\n\n".join([*parts, "[All instructions](README.md)"]) + "\n"


_SYNTAX = {"return": "return", "for": "for _ in range(count, oneshot=False):", "pass": "pass"}
"""The syntax of instructions that are not calls."""


def _signatures(spec: Spec) -> Iterator[str]:
    """Yield every form of the instruction."""
    yield _SYNTAX.get(spec.name, spec.signature)
    if spec.pins:
        settings = {param.of_pin: f", {param.chained}=..." for param in spec.params if param.of_pin}
        plain = tuple(param for param in spec.params if param not in spec.pins and not param.of_pin)
        links = (f".{method}(...{settings.get(pin.name, '')})" for method, pin in spec.methods.items())
        yield replace(spec, params=plain).signature + "".join(links)
    if spec is SEARCH:
        yield SEARCH_RANGE.signature


# -- arguments --------------------------------------------------------------------------------------------------------

_TAKES = {
    ParamKind.FLAG: "`True` or `False`",
    ParamKind.UNIT: listed(map(quoted, UNITS)),
    ParamKind.PIN: "a condition after `lambda:`",
    ParamKind.FORMULA: "a [formula](../language.md#formulas) in quotes",
    ParamKind.PATTERN: "rows of 0 and 1: `[[1, 0], [0, 1]]`",
    ParamKind.TARGET: "`ModbusTcpTarget(...)` or `ModbusRtuTarget(...)`",
    ParamKind.REMOTE: 'the first address in the other device: `"DS1"` or `ModbusAddress(...)`',
    ParamKind.RANGE_COMPARISON: "a range compared with a value: `ds[1:101] >= 100`",
}
"""Replacements for a problem's words that would read oddly in a table."""
_CONSTANTS = {
    INTEGER: "an integer",
    HEX: "a hexadecimal word",
    REAL: "a floating-point number",
    TEXT: "a text",
    CODE: "a character code",
}


def _arguments(spec: Spec) -> str:
    rows = [
        (listed(map(quoted, (param.name, *param.aliases))), _takes(spec, param), _left_out(param), _access(param))
        for param in spec.params
    ]
    return table(("Argument", "Takes", "If left out", "Access"), *rows)


def _takes(spec: Spec, param: Param) -> str:
    if param.kind is ParamKind.OPTIONS:
        return listed(map(quoted, spec.conversions)) if spec.conversions else "`None`: it converts nothing"
    if param.kind not in (ParamKind.OPERAND, ParamKind.OPERANDS):
        return _TAKES.get(param.kind) or re.sub('"[^"]+"', r"`\g<0>`", param.kind.value)
    takes = _forms(param.slot) if param.name in spec.matrix else _operand(param.slot)
    if param.extends_over:
        takes += f"; an address begins a range as long as `{param.extends_over}`"
    return f"a list; each item is {takes}" if param.kind is ParamKind.OPERANDS else takes


def _forms(slot: Slot) -> str:
    """The forms of an operand whose banks are in the table of pairs."""
    forms = {"an address": slot.cells, "a range": slot.ranges, "a constant": slot.constants}
    pointer = [f"a pointer into {listed(slot.pointers)}"] if slot.pointers else []
    return listed([*(form for form, banks in forms.items() if banks), *pointer]) + "; see the next table"


def _operand(slot: Slot) -> str:
    """The banks and constants of an operand, with those that get a warning last."""
    limits = f" from {slot.limits[0]} to {slot.limits[1]}" if slot.limits else ""
    constants = [_CONSTANTS[form] + (limits if form == INTEGER else "") for form in slot.constants]
    sure = _places(slot, {*slot.cells, *slot.ranges, *slot.immediates} - {*slot.disputed}) + constants
    doubted = _places(slot, slot.disputed)
    return listed(sure) + (f"; also {listed(doubted)}, {_DISPUTED}" if doubted else "")


def _places(slot: Slot, wanted: Collection[str]) -> list[str]:
    """``an address or a range in Y or C`` and the like, of the wanted banks."""
    forms = {"an address": slot.cells, "a range": slot.ranges, "an immediate address": slot.immediates}
    places: dict[tuple[str, ...], list[str]] = {}
    for form, banks in forms.items():
        places.setdefault(tuple(bank for bank in banks if bank in wanted), []).append(form)
    return [f"{' or '.join(names)} in {listed(banks)}" for banks, names in places.items() if banks]


def _left_out(param: Param) -> str:
    if param.missing_pin:
        return f"never on (`~SC1`), with the warning {problem_link(param.missing_pin)}"
    if param.default is REQUIRED:
        return "required"
    if param.of_pin:
        return f"allowed only without `{param.of_pin}`"
    if param.kind is ParamKind.PIN:
        return "the box has no such input"
    if param.kind is ParamKind.OPTIONS:
        return "converts nothing"
    return "none" if param.default is None else quoted(param.default)


def _access(param: Param) -> str:
    if param.kind in (ParamKind.OPERAND, ParamKind.OPERANDS):
        return param.slot.access.value
    if param.kind is ParamKind.TOKEN:
        return "read and written: every address in it"
    return "read" if param.kind in (ParamKind.PIN, ParamKind.FORMULA, ParamKind.RANGE_COMPARISON) else ""


# -- copies -----------------------------------------------------------------------------------------------------------


def _pairs(spec: Spec) -> list[Pair]:
    return [pair for variant in spec.variants for pair in variant.pairs]


def _matrix(spec: Spec) -> list[str]:
    """The pairs between which a copy copies, with the lengths of the ranges if these are limited."""
    pairs = _pairs(spec)
    rows = [("From", "To", "Addresses")]
    for pair in pairs:
        target = _banks(pair.targets) + (f", {_DISPUTED}" if pair.disputed else "")
        rows.append((_banks(pair.sources), target, _length(pair)))
    columns = 3 if any(pair.lengths for pair in pairs) else 2
    return ["## Source and destination", table(*(row[:columns] for row in rows))] if pairs else []


def _banks(forms: Collection[str]) -> str:
    return listed(_CONSTANTS.get(form, form) for form in forms)


def _length(pair: Pair) -> str:
    low, high = pair.lengths or (0, 0)
    return "any number" if not high else str(low) if low == high else f"{low} to {high}"


def _conversions(spec: Spec) -> list[str]:
    if not spec.conversions:
        return []
    rows = []
    for modifier, option in MODIFIERS.items():
        if option in spec.conversions:
            sources, targets = (dict.fromkeys(banks) for banks in zip(*_converted(spec, option), strict=True))
            rows.append((f"`options={option}`", f"`.{modifier}()`", _banks(sources), _banks(targets)))
    words = "Use an option, or a modifier after the source. [Copies](../language.md#copies) says what each does."
    return ["## Conversions", words, table(("Option", "Modifier", "From", "To"), *rows)]


def _converted(spec: Spec, option: str) -> Iterator[tuple[str, str]]:
    """The banks that an option converts from and to in this instruction."""
    sources, targets = CONVERSIONS[option]
    for pair in _pairs(spec):
        yield from product((s for s in pair.sources if s in sources), [t for t in pair.targets if t in targets])


# -- the example, and CLICK -------------------------------------------------------------------------------------------


def _example(spec: Spec) -> list[str]:
    """The example in every form, and the one ladder that all of them become."""
    kind, forms = examples(spec)
    ((codes, tokens),) = {built(kind, form) for form in forms}
    notes = f"example: {kind}" + (f", gives {' '.join(codes)}" if codes else "")
    shown = "\n\nThe same in the other form:\n\n".join(block(notes, "python", form) for form in forms)
    said = [f"The example gives {listed(map(problem_link, codes), 'and')}."] if codes else []
    ladder = ["In ladder CSV:", block("tokens", "text", tokens)] if tokens else []
    return ["## Example", shown, *ladder, *said]


def _in_click(spec: Spec) -> Iterator[str]:
    if not spec.variants:
        yield "Nothing: it never gets into a ladder."
        return
    if spec is RAW:
        yield "Height: as many grid rows as the token says; a formula has 1."
        yield "Rung: can be shared with other instructions."
        yield "One-shot, and the system bits that it may set: as in the token, or unknown."
        return
    inputs = ", including its inputs" if spec.pins else ""
    yield f"Height: {spec.height} grid row{'s' * (spec.height > 1)}{inputs}."
    yield "Rung: its own." if spec.pins or spec.alone else "Rung: can be shared with other instructions."
    has_oneshot = any(param.name == "oneshot" for param in spec.params)
    yield "One-shot: yes, with `oneshot=True`." if has_oneshot else "One-shot: no."
    bits = [f"{name} (`{system_name_of(address)}`)" for name in spec.effects.flags if (address := parse_address(name))]
    yield f"System bits that it may set: {listed(bits, 'and') if bits else 'none'}."
