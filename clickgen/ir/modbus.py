"""The destination of a send or receive: the other device, and the first address there."""

from __future__ import annotations

from clickgen.device.banks import Address
from clickgen.records import dataclass
from clickgen.text.source import Span


@dataclass(frozen=True, slots=True)
class TcpTarget:
    """A device in the network. ``name`` is a label that CLICK does not keep (click-facts [message.targets])."""

    name: str
    ip: str
    port: int
    device_id: int
    span: Span


@dataclass(frozen=True, slots=True)
class RtuTarget:
    """A device on a serial port, such as ``cpu2``."""

    name: str
    com_port: str
    device_id: int
    span: Span


@dataclass(frozen=True, slots=True)
class RemoteCell:
    """An address of another CLICK."""

    address: Address
    span: Span


@dataclass(frozen=True, slots=True)
class RemoteModbus:
    """An address of any Modbus device: a 984 number such as 400001, or a hexadecimal one with its register type."""

    number: int
    span: Span
    register_type: str = ""
    """Empty for a 984 number, which implies it."""


Target = TcpTarget | RtuTarget
Remote = RemoteCell | RemoteModbus
