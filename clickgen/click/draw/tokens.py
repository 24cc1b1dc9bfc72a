"""Operands, contacts and instructions as CLICK's ladder tokens (click-facts [token.constants])."""

from __future__ import annotations

from collections.abc import Callable
from decimal import Decimal

from clickgen.device.banks import Address, current_value
from clickgen.device.system import ALWAYS_ON
from clickgen.formula import print_formula
from clickgen.instructions.spec import Param, ParamKind, Spec
from clickgen.ir.conditions import Compare, Contact
from clickgen.ir.modbus import Remote, RemoteCell, RtuTarget, Target, TcpTarget
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
    if isinstance(operand, Cell):
        return str(operand.address)
    if isinstance(operand, Integer):
        return str(operand.value)
    if isinstance(operand, Range):
        return f"{Address(operand.bank, operand.first)}..{Address(operand.bank, operand.last)}"
    if isinstance(operand, Hex):
        return f"{operand.value:04X}h"
    if isinstance(operand, Real):
        return real_token(operand)
    if isinstance(operand, Text):
        return '"' + operand.value.replace('"', '""') + '"'
    if isinstance(operand, Pointer):
        return f"{operand.bank}[{operand_token(operand.register)}]"
    if isinstance(operand, Immediate):
        return f"immediate({operand_token(operand.target)})"
    if isinstance(operand, CharCode):
        return f"${operand.value:02X}"
    raise TypeError(f"{type(operand).__name__} has no token")


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
    if param.kind is ParamKind.OPTIONS:
        return _options(value) if isinstance(value, Options) else ""
    if isinstance(value, Word):
        return str(value.value)
    if isinstance(value, KeptToken):
        return value.text
    if isinstance(value, FormulaText):
        return formula_text(value, name)
    if param.kind is ParamKind.UNIT:
        return str(param.default)
    if isinstance(value, Operands):
        return ",".join(map(name, value.items))
    if isinstance(value, Pattern):
        return ",".join(f"[{','.join(str(int(bit)) for bit in row)}]" for row in value.rows)
    if isinstance(value, Target):
        return _target(value)
    if isinstance(value, Remote):
        return _remote(value)
    if not isinstance(value, Operand):
        return ""
    if isinstance(value, Range) and len(value) == 1 and value.bank in param.slot.cells and not param.extends_over:
        value = Cell(Address(value.bank, value.first), value.span)
    word = keyword_of(param)
    return f",{word}={name(value)}" if word else name(value)


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


def pin_row(spec: Spec, param: Param) -> int:
    """The row of a pin below its instruction's: pins fill the box from its last row upward."""
    return spec.height - len(spec.pins) + spec.pins.index(param)
