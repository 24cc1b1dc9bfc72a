"""Modbus communication: send, receive (click-facts [message.count, message.targets])."""

from __future__ import annotations

from clickgen.instructions.effects import Effects, Move, Shape
from clickgen.instructions.spec import BITS, REGISTERS, Access, Param, ParamKind, Slot, Spec, Variant

COM_PORTS = ("cpu2", "slot0_1", "slot0_2", "slot1_1", "slot1_2")
"""The serial ports by the names that laddercodec has for them: it knows no other (click-facts [message.ports])."""

_TARGET = Param("target", ParamKind.TARGET)
_REMOTE = Param("remote_start", ParamKind.REMOTE)
# Captures show C, DS, DD and DH; the other banks hold the same kinds of values, unseen (click-facts [message.banks]).
_SENT = (*BITS, *REGISTERS)
_SOURCE = Param(
    "source",
    slot=Slot(cells=_SENT, ranges=_SENT, disputed=tuple(bank for bank in _SENT if bank not in ("C", "DS", "DD", "DH"))),
)
_RECEIVED = ("Y", "C", "DS", "DD", "DH", "DF", "YD", "TD", "CTD", "TXT")
_DEST = Param(
    "dest",
    slot=Slot(
        cells=_RECEIVED,
        ranges=_RECEIVED,
        access=Access.WRITE,
        disputed=tuple(bank for bank in _RECEIVED if bank not in ("C", "DS", "DD", "DH")),
    ),
)


def _flag(name: str) -> Param:
    # click-facts [message.flags]
    return Param(name, slot=Slot(cells=("C",), access=Access.WRITE), default=None, by_name=True)


_ENDING = (
    _flag("success"),
    _flag("error"),
    Param(
        "exception_response",
        slot=Slot(cells=("DS", "DD"), access=Access.WRITE, disputed=("DD",)),
        default=None,
        by_name=True,
    ),
    Param("word_swap", ParamKind.FLAG, default=False),
)
_NOTES = (
    "`target` is `ModbusTcpTarget(ip=, port=502, device_id=1)` or `ModbusRtuTarget(com_port=, device_id=)` with one of "
    f"the ports {', '.join(COM_PORTS)}; either may have a `name=` of its own.",
    '`remote_start` is an address of another CLICK, `"DS1"`, or of any device: `ModbusAddress(address=400001)`, or '
    'in hexadecimal `ModbusAddress(address="10h", register_type="holding")` with coil, discrete_input, holding or '
    "input.",
    "How many values go over is the length of the range. Each of the flags may be left out.",
)

SEND = Spec(
    name="send",
    params=(_TARGET, _REMOTE, _SOURCE, _flag("sending"), *_ENDING),
    variants=(
        Variant(
            "send(target={target},remote_start={remote_start},source={source}"
            "{sending}{success}{error}{exception_response}{word_swap})"
        ),
    ),
    summary="Write to another device over Modbus.",
    example='send(ModbusTcpTarget(ip="192.168.1.10"), "DS1", ds[1:6], success=c.Sent)',
    height=3,
    # click-facts [message.later]
    effects=Effects(moves=Move("source", "remote_start", Shape.MESSAGE), is_late=True),
    notes=_NOTES,
)
RECEIVE = Spec(
    name="receive",
    params=(_TARGET, _REMOTE, _DEST, _flag("receiving"), *_ENDING),
    variants=(
        Variant(
            "receive(target={target},remote_start={remote_start},dest={dest}"
            "{receiving}{success}{error}{exception_response}{word_swap})"
        ),
    ),
    summary="Read from another device over Modbus.",
    example='receive(ModbusRtuTarget(com_port="cpu2", device_id=5), ModbusAddress(address=400001), ds[1:6])',
    height=3,
    effects=Effects(moves=Move("remote_start", "dest", Shape.MESSAGE), is_late=True),
    notes=_NOTES,
)

SPECS = (SEND, RECEIVE)
