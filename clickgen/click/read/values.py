"""The arguments of a token, each read by the kind of its parameter."""

from __future__ import annotations

import re
from collections.abc import Callable

from clickgen.click.read.calls import call_of, split, unquoted
from clickgen.click.read.formulas import formula_of
from clickgen.click.read.operands import operand_of
from clickgen.device.banks import parse_address
from clickgen.instructions.communication import COM_PORTS
from clickgen.instructions.copies import CONVERSIONS
from clickgen.instructions.spec import Param, ParamKind
from clickgen.instructions.timers import UNITS
from clickgen.ir.modbus import RemoteCell, RemoteModbus, RtuTarget, TcpTarget
from clickgen.ir.operands import Cell, CharCode, Immediate, Range
from clickgen.ir.program import Operands, Options, Pattern, Value, Word
from clickgen.text.source import Span

_HEX = re.compile(r"([0-9A-Fa-f]{1,4})h")
_NUMBER = re.compile(r"[0-9]{1,9}")


def value_of(param: Param, text: str, span: Span) -> Value | None:
    """What an argument says; None when it is nothing that the parameter takes."""
    if param.kind is ParamKind.FORMULA:
        return formula_of(text, "hex" if param.is_hex else "decimal", span)
    return _READERS[param.kind](param, text, span)


def _operand(param: Param, text: str, span: Span) -> Value | None:
    operand = operand_of(text, span)
    if isinstance(operand, Cell) and param.slot.ranges and not param.slot.cells:
        number = operand.address.number
        return None if operand.address.upper else Range(operand.bank, number, number, span)
    return operand


def _operands(_: Param, text: str, span: Span) -> Value | None:
    items = [operand_of(part, span) for part in split(text) or ()]
    singles = tuple(item for item in items if item is not None and not isinstance(item, Range | Immediate))
    return Operands(singles, span) if items and len(singles) == len(items) else None


def _pattern(_: Param, text: str, span: Span) -> Value | None:
    rows: list[tuple[bool, ...]] = []
    for row in split(text) or ():
        bits = split(row[1:-1]) if row[:1] == "[" and row[-1:] == "]" else None
        if not bits or not set(bits) <= {"0", "1"}:
            return None
        rows.append(tuple(bit == "1" for bit in bits))
    return Pattern(tuple(rows), span) if rows else None


def _flag(_: Param, text: str, span: Span) -> Value | None:
    return Word(True, span) if text == "1" else None


def _unit(_: Param, text: str, span: Span) -> Value | None:
    return Word(text, span) if text in UNITS else None


def _word(_: Param, text: str, span: Span) -> Value | None:
    return Word(text, span)


def _options(_: Param, text: str, span: Span) -> Value | None:
    if text in CONVERSIONS and text != "to_text":
        return Options(text, span)
    call = call_of(text)
    if call is None or call.name != "to_text" or call.arguments:
        return None
    settings = {"suppress_zero": "1", "exponential": "0", "termination_code": "none", **call.keywords}
    flags = settings["suppress_zero"], settings["exponential"]
    # laddercodec writes a code below $10 with one digit.
    code_text = re.sub(r"^\$(?=.$)", "$0", settings["termination_code"])
    code = operand_of(code_text, span)
    is_code = isinstance(code, CharCode) and code.value <= 0x7F
    if len(settings) > 3 or not set(flags) <= {"0", "1"} or not (is_code or code_text == "none"):
        return None
    return Options(
        "to_text", span, flags[0] == "1", flags[1] == "1", code.value if isinstance(code, CharCode) else None
    )


def _target(_: Param, text: str, span: Span) -> Value | None:
    call = call_of(text)
    given = call.keywords if call else {}
    device_id = given.get("device_id", "")
    name, place = unquoted(given.get("name", "")), unquoted(given.get("ip", given.get("com_port", "")))
    if call is None or call.arguments or name is None or place is None or not _NUMBER.fullmatch(device_id):
        return None
    keys, port = given.keys(), given.get("port", "")
    if call.name == "ModbusTcpTarget" and keys == {"name", "ip", "port", "device_id"} and _NUMBER.fullmatch(port):
        return TcpTarget(name, place, int(port), int(device_id), span)
    is_serial = call.name == "ModbusRtuTarget" and keys == {"name", "com_port", "device_id"} and place in COM_PORTS
    return RtuTarget(name, place, int(device_id), span) if is_serial else None


def _remote(_: Param, text: str, span: Span) -> Value | None:
    inner = unquoted(text)
    if inner is not None:
        address = parse_address(inner)
        return RemoteCell(address, span) if address else None
    call = call_of(text)
    given = call.keywords if call else {}
    if call is None or call.name != "ModbusAddress" or call.arguments:
        return None
    number = given.get("address", "")
    if given.keys() == {"address"} and _NUMBER.fullmatch(number):
        return RemoteModbus(int(number), span)
    match = _HEX.fullmatch(number)
    if given.keys() == {"address", "register_type"} and match:
        return RemoteModbus(int(match[1], 16), span, given["register_type"])
    return None


_READERS: dict[ParamKind, Callable[[Param, str, Span], Value | None]] = {
    ParamKind.OPERAND: _operand,
    ParamKind.OPERANDS: _operands,
    ParamKind.PATTERN: _pattern,
    ParamKind.FLAG: _flag,
    ParamKind.UNIT: _unit,
    ParamKind.COMPARISON: _word,
    ParamKind.ROUTINE: _word,
    ParamKind.OPTIONS: _options,
    ParamKind.TARGET: _target,
    ParamKind.REMOTE: _remote,
}
