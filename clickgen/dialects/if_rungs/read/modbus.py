"""The target and the remote address of a send or receive."""

from __future__ import annotations

import re
from collections.abc import Mapping

import libcst as cst

from clickgen.device.banks import parse_address
from clickgen.device.modbus import (
    COIL,
    HEX_MAX,
    NUMBERS_984,
    PORT_MAX,
    REGISTER_TYPES,
    RTU_DEVICE_MAX,
    TCP_DEVICE_MAX,
    TYPE_WORDS,
    of_manual,
    register_type_of,
)
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.nodes import (
    Node,
    arguments,
    called,
    is_literal,
    keyword_name,
    keywords,
    literal,
    text_value,
    whole_number,
)
from clickgen.instructions.communication import COM_PORTS
from clickgen.ir.modbus import Remote, RemoteCell, RemoteModbus, RtuTarget, Target, TcpTarget
from clickgen.problems.diagnostics import did_you_mean

_TCP = 'ModbusTcpTarget(ip="192.168.1.10", port=502, device_id=1)'
_RTU = 'ModbusRtuTarget(com_port="cpu2", device_id=5)'
_TARGETS = {
    "ModbusTcpTarget": ("name", "ip", "port", "device_id"),
    "ModbusRtuTarget": ("name", "com_port", "device_id"),
}
_EXAMPLES = {"ModbusTcpTarget": _TCP, "ModbusRtuTarget": _RTU}
_LABEL = re.compile(r"[A-Za-z0-9 _-]{1,24}")
_DEVICE_IDS = {"ModbusTcpTarget": TCP_DEVICE_MAX, "ModbusRtuTarget": RTU_DEVICE_MAX}

_HEX = re.compile(r"([0-9A-Fa-f]{1,4})h")
_DECIMAL = re.compile(r"[0-9]{1,20}")
_DIGITS_MAX = 6
_REMOTE = 'remote_start="DS1", or ModbusAddress(address=400001)'


def read_target(context: Context, node: Node, signature: str) -> Target | None:
    """``ModbusTcpTarget(...)`` or ``ModbusRtuTarget(...)``; None with problems."""
    name = called(node)
    if not isinstance(node, cst.Call) or name not in _TARGETS:
        help = did_you_mean(name, _TARGETS) or f"{_TCP} or {_RTU}:"
        context.problem("CG115", node, "the target is a ModbusTcpTarget or a ModbusRtuTarget", f"{help} {signature}")
        return None
    before = len(context.problems.found)
    given = _given(context, node, name, _TARGETS[name], _EXAMPLES[name])
    reader = _Settings(context, node, name, given)
    label = reader.label()
    device_id = reader.number("device_id", 1 if name == "ModbusTcpTarget" else None, 0, _DEVICE_IDS[name])
    if name == "ModbusRtuTarget":
        com_port = reader.com_port()
        if label is None or com_port is None or device_id is None or len(context.problems.found) > before:
            return None
        return RtuTarget(label, com_port, device_id, context.span(node))
    ip, port = reader.ip(), reader.number("port", 502, 1, PORT_MAX)
    if label is None or ip is None or port is None or device_id is None or len(context.problems.found) > before:
        return None
    return TcpTarget(label, ip, port, device_id, context.span(node))


def _given(context: Context, node: cst.Call, name: str, known: tuple[str, ...], example: str) -> dict[str, Node]:
    """The arguments by name; any other is a problem."""
    given: dict[str, Node] = {}
    for argument in arguments(node):
        context.problem("CG115", argument, f"{name} takes its arguments by name", example)
    for keyword in keywords(node):
        setting = keyword_name(keyword)
        if setting not in known:
            help = did_you_mean(setting, known) or example
            context.problem("CG109", keyword, f"{name} has no argument {setting or '**'!r}", help)
        else:
            given[setting] = keyword.value
    return given


class _Settings:
    """The settings of one target, each with its problem."""

    def __init__(self, context: Context, node: cst.Call, name: str, given: Mapping[str, Node]) -> None:
        self._context = context
        self._node = node
        self._name = name
        self._given = given

    def label(self) -> str | None:
        default = "tcp" if self._name == "ModbusTcpTarget" else "rtu"
        value = self._value("name", default)
        if isinstance(value, str) and _LABEL.fullmatch(value):
            return value
        self._refuse("name", "a short label of letters and digits")
        return None

    def ip(self) -> str | None:
        value = self._value("ip", None)
        if value is None:
            return None
        if isinstance(value, str):
            import ipaddress

            try:
                return str(ipaddress.IPv4Address(value))
            except ValueError:
                pass
        self._refuse("ip", 'an IPv4 address: "192.168.1.10"')
        return None

    def com_port(self) -> str | None:
        value = self._value("com_port", None)
        if value is None or value in COM_PORTS:
            return str(value) if value else None
        near = did_you_mean(str(value), COM_PORTS)
        self._refuse("com_port", f"one of {', '.join(COM_PORTS)}", near)
        return None

    def number(self, name: str, default: int | None, low: int, high: int) -> int | None:
        value = self._value(name, default)
        if type(value) is int and low <= value <= high:
            return value
        if value is not None:
            self._refuse(name, f"a number {low}..{high}")
        return None

    def _value(self, name: str, default: object) -> object:
        """What is written; None with a problem when it is missing and has no default."""
        node = self._given.get(name)
        if node is None:
            if default is None:
                self._context.problem("CG110", self._node, f"{self._name} needs {name!r}", _EXAMPLES[self._name])
            return default
        value = literal(node)
        return ... if value is None else value

    def _refuse(self, name: str, what: str, help: str = "") -> None:
        node = self._given[name]
        self._context.problem("CG115", node, f"{name!r} must be {what}", help or _EXAMPLES[self._name])


# -- the remote address -----------------------------------------------------------------------------------------------


def read_remote(context: Context, node: Node, signature: str) -> Remote | None:
    """``"DS1"``, ``ModbusAddress(address=400001)`` or a hexadecimal one with its register type."""
    text = text_value(node)
    if text is not None:
        address = parse_address(text)
        if address is None:
            help = _of_any_device(text) or _REMOTE
            context.problem("CG201", node, f"a CLICK has no address {text!r}", help)
            return None
        return RemoteCell(address, context.span(node))
    name = called(node)
    if not isinstance(node, cst.Call) or name != "ModbusAddress":
        bare = whole_number(node)
        if bare is not None:
            help = _of_any_device(str(bare)) or _REMOTE
            context.problem("CG115", node, "this is not an address of another device", f"{help}: {signature}")
            return None
        way = "it is an address of the other device, in quotes: " if isinstance(node, cst.Subscript) else ""
        help = did_you_mean(name, ["ModbusAddress"]) or f"{way}{_REMOTE}:"
        context.problem("CG115", node, "this is not an address of another device", f"{help} {signature}")
        return None
    example = "ModbusAddress(address=400001)"
    before = len(context.problems.found)
    given = _given(context, node, name, ("address", "register_type"), example)
    if len(context.problems.found) > before:
        return None
    if "address" not in given:
        context.problem("CG110", node, "ModbusAddress needs 'address'", example)
        return None
    number, is_hex = _modbus_number(context, given["address"])
    type_node = given.get("register_type")
    register_type = literal(type_node) if is_literal(type_node) else None
    if number is None:
        return None
    if not is_hex:
        if type_node is not None and register_type is not None:
            _refuse_type(context, type_node, number, str(register_type))
            return None
        return RemoteModbus(number, context.span(node))
    if register_type not in REGISTER_TYPES:
        near = did_you_mean(str(register_type), REGISTER_TYPES) if register_type else ""
        help = near or f"a hexadecimal address needs one of {', '.join(REGISTER_TYPES)}"
        code, place = ("CG110", node) if type_node is None else ("CG115", type_node)
        context.problem(code, place, "register_type is missing or none that Modbus has", help)
        return None
    return RemoteModbus(number, context.span(node), str(register_type))


def _of_any_device(text: str) -> str:
    """The way out for a bare number in the place of a remote address; "" for what is none."""
    number = int(text) if text.isascii() and text.isdigit() and len(text) <= _DIGITS_MAX else 0
    manual = of_manual(number)
    if manual:
        return f"CLICK has six digits: {number} of a manual is ModbusAddress(address={manual[1]})"
    return f"the number of any device is ModbusAddress(address={number})" if register_type_of(number) else ""


def _refuse_type(context: Context, node: Node, number: int, said: str) -> None:
    """A decimal number has its register type in its digits; where it has another one than is said, it is not meant."""
    kind = register_type_of(number)
    low, _ = NUMBERS_984.get(said, (0, 0))
    if said == kind or not low:
        context.problem("CG314", node, f"{number} says its register type itself", "leave out register_type")
        return
    manual = of_manual(number)
    meant = manual[1] if manual and manual[0] == said else low - 1 + number
    help = "leave out register_type, or correct the number"
    if kind == COIL and register_type_of(meant) == said:
        counted = f'where that counts from 0, write ModbusAddress(address="{number:X}h", register_type="{said}")'
        help = f"{number} of a manual is ModbusAddress(address={meant})" + ("" if manual else f"; {counted}")
    words = f"{TYPE_WORDS[str(kind)]} by its digits, and not {TYPE_WORDS[said]}"
    context.problem("CG314", node, f"{number} is {words}", help)


def _modbus_number(context: Context, node: Node) -> tuple[int | None, bool]:
    """The number of a Modbus address, and whether it is hexadecimal."""
    value = literal(node)
    match = _HEX.fullmatch(value) if isinstance(value, str) else None
    if match:
        return int(match[1], 16), True
    if type(value) is int and context.text(node)[:2].lower() == "0x" and value <= HEX_MAX:
        return value, True
    if isinstance(value, str) and _DECIMAL.fullmatch(value):
        value = int(value)
    if type(value) is int and register_type_of(value):
        return value, False
    context.problem(
        "CG115",
        node,
        "this is no Modbus address",
        f"{', '.join(f'{low}..{high} {name}' for name, (low, high) in NUMBERS_984.items())}; "
        'or in hexadecimal "0h".."FFFFh" with a register_type',
    )
    return None, False
