"""Operands, contacts and instructions as CLICK's ladder tokens (click-facts [token.constants])."""

from __future__ import annotations

from collections.abc import Callable
from decimal import Decimal
from typing import Any

from clickgen.device.banks import Address, current_value
from clickgen.device.system import ALWAYS_ON
from clickgen.formula import print_formula
from clickgen.instructions.spec import Param, ParamKind, Spec
from clickgen.ir.conditions import Compare, Contact
from clickgen.ir.modbus import Remote, RemoteCell, RemoteModbus, RtuTarget, Target, TcpTarget
from clickgen.ir.operands import Cell, CharCode, Hex, Immediate, Integer, Named, Operand, Pointer, Range, Real, Text
from clickgen.ir.program import Action, FormulaText, KeptToken, Operands, Options, Pattern, Word
from clickgen.ir.reach import reached

Namer = Callable[[Operand], str]
"""Returns the text of an operand: its token, or with its nickname beside it."""

ALWAYS_CONTACT = str(ALWAYS_ON)
NEVER_CONTACT = f"~{ALWAYS_ON}"

CONVERSION = "convert"
"""The word before a copy's option."""


def operand_token(operand: Operand) -> str:
    """Return an operand as CLICK writes it: ``DS5``, ``C1..C8``, ``DS[DS1]``, ``00FFh``, ``"ABC"``, ``$0D``."""
    token = _TOKENS.get(operand.__class__)
    if token is None:
        raise TypeError(f"{type(operand).__name__} has no token")
    return token(operand)


_TOKENS: dict[type, Callable[[Any], str]] = {
    Cell: lambda cell: str(cell.address),
    Integer: lambda integer: str(integer.value),
    Range: lambda span: f"{Address(span.bank, span.first)}..{Address(span.bank, span.last)}",
    Hex: lambda number: f"{number.value:04X}h",
    Real: lambda real: real_token(real),
    Text: lambda text: '"' + text.value.replace('"', '""') + '"',
    Pointer: lambda pointer: f"{pointer.bank}[{operand_token(pointer.register)}]",
    Immediate: lambda immediate: f"immediate({operand_token(immediate.target)})",
    CharCode: lambda code: f"${code.value:02X}",
}


def real_token(real: Real) -> str:
    """Return a floating-point constant in plain decimal, as the person wrote it if that is plain already."""
    if real.value == 0:
        return "0.0"
    text = real.text.replace("_", "")
    if "e" not in text.lower():
        whole, _, fraction = text.partition(".")
        return f"{whole if whole not in ('', '-') else whole + '0'}.{fraction or '0'}"
    plain = format(Decimal(text), "f")
    return plain if "." in plain else plain + ".0"


def contact_token(contact: Contact) -> str:
    """One contact: ``X001``, ``~X001``, ``immediate(X001)``, ``rise(C1)``."""
    token = operand_token(contact.operand)
    if contact.edge:
        return f"{contact.edge.value}({token})"
    return f"~{token}" if contact.negated else token


def compare_token(compare: Compare) -> str:
    """A comparison, without spaces: ``DS1==5``."""
    return f"{operand_token(compare.left)}{compare.op}{operand_token(compare.right)}"


def formula_text(formula: FormulaText, name: Namer = operand_token) -> str:
    """A formula in CLICK's form: single spaces between all tokens."""

    def shown(operand: Named | Cell | Pointer | Range) -> str:
        if isinstance(operand, Range):
            return f"{operand.bank}{operand.first} : {operand.bank}{operand.last}"
        return name(operand)

    return print_formula(formula.formula, shown)


def action_token(action: Action, name: Namer = operand_token) -> str:
    """The token of an instruction, except its pins."""
    return action.variant.token.format_map(_texts(action, name))


def pin_token(action: Action, param: Param, name: Namer = operand_token) -> str:
    """The token of a pin's row: ``.reset()``, ``.jump(DS1)``."""
    return param.pin.format_map(_texts(action, name))


def _texts(action: Action, name: Namer) -> dict[str, str]:
    """The text of each argument in a token; none for arguments left out."""
    texts = {param.name: _argument(action, param, name) for param in action.spec.params}
    for param in action.spec.owns:
        owner = action.args.get(param.name)
        if isinstance(owner, Cell):
            texts[f"{param.name}_value"] = name(Cell(current_value(owner.address), owner.span))
    return texts


def _argument(action: Action, param: Param, name: Namer) -> str:
    value = reached(action, param) if param.extends_over else action.args.get(param.name)
    if param.kind is ParamKind.FLAG:
        return f",{keyword_of(param)}=1" if action.flag(param.name) else ""
    shown = _SHOWN.get(value.__class__)
    if shown is not None:
        return shown(value, param, name)
    return str(param.default) if param.kind is ParamKind.UNIT else ""


def _operand(value: Operand, param: Param, name: Namer) -> str:
    if value.__class__ is Range and isinstance(value, Range):
        is_cell = len(value) == 1 and value.bank in param.slot.cells and not param.extends_over
        value = Cell(Address(value.bank, value.first), value.span) if is_cell else value
    word = keyword_of(param)
    return f",{word}={name(value)}" if word else name(value)


def _pattern(pattern: Pattern) -> str:
    return ",".join(f"[{','.join(str(int(bit)) for bit in row)}]" for row in pattern.rows)


def keyword_of(param: Param) -> str:
    """The word before an argument that a token may omit, with its comma; "" for one that is always there."""
    if param.kind is ParamKind.OPTIONS:
        return CONVERSION
    is_left_out = param.kind is ParamKind.FLAG or (param.kind is ParamKind.OPERAND and param.default is None)
    return param.name if is_left_out and not param.of_pin else ""


def _target(target: Target) -> str:
    if isinstance(target, TcpTarget):
        place = f'ip="{target.ip}",port={target.port}'
        return f'ModbusTcpTarget(name="{target.name}",{place},device_id={target.device_id})'
    assert isinstance(target, RtuTarget)
    return f'ModbusRtuTarget(name="{target.name}",com_port="{target.com_port}",device_id={target.device_id})'


def _remote(remote: Remote) -> str:
    if isinstance(remote, RemoteCell):
        return f'"{remote.address}"'
    if not remote.register_type:
        return f"ModbusAddress(address={remote.number})"
    return f"ModbusAddress(address={remote.number:X}h,register_type={remote.register_type})"


def _options(options: Options) -> str:
    """The options of to_text: all three settings are always written (click-facts [copy.to-text])."""
    if options.name != "to_text":
        return f",{CONVERSION}={options.name}"
    code = "none" if options.termination_code is None else f"${options.termination_code:02X}"
    suppress, exponential = int(options.suppress_zero), int(options.exponential)
    return f",{CONVERSION}=to_text(suppress_zero={suppress},exponential={exponential},termination_code={code})"


_SHOWN: dict[type, Callable[[Any, Param, Namer], str]] = {
    Word: lambda word, _, __: str(word.value),
    Options: lambda options, _, __: _options(options),
    KeptToken: lambda token, _, __: token.text,
    FormulaText: lambda formula, _, name: formula_text(formula, name),
    Operands: lambda operands, _, name: ",".join(map(name, operands.items)),
    Pattern: lambda pattern, _, __: _pattern(pattern),
    **dict.fromkeys((TcpTarget, RtuTarget), lambda target, _, __: _target(target)),
    **dict.fromkeys((RemoteCell, RemoteModbus), lambda remote, _, __: _remote(remote)),
    **dict.fromkeys((Named, *_TOKENS), _operand),
}
"""How each kind of argument is shown in a token; conditions are no part of one."""


def pin_row(spec: Spec, param: Param) -> int:
    """The row of a pin below its instruction's: pins fill the box from its last row upward."""
    return spec.height - len(spec.pins) + spec.pins.index(param)
