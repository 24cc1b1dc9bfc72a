"""Send and receive: targets in the network and on serial lines, CLICK and Modbus addresses, flags given or left out."""

from __future__ import annotations

from hypothesis import strategies as st

from strategies.arguments import Given, Shown, called, cell, given, span
from strategies.programs import Act

COM_PORTS = ("cpu2", "slot0_1", "slot0_2", "slot1_1", "slot1_2")
_WORDS = {"DS": 1, "DD": 2, "DH": 1, "DF": 2, "TD": 1, "CTD": 2, "TXT": 1}
"""The Modbus registers that a value takes."""
_OWN_BITS = {"send": ("C", "C", "C", "X", "Y", "T", "CT", "SC"), "receive": ("C", "C", "C", "Y")}
_OWN_WORDS = {
    "send": ("DS", "DS", "DD", "DH", "DF", "TD", "CTD", "SD", "XD", "TXT"),
    "receive": ("DS", "DS", "DD", "DH", "DF", "TD", "CTD", "YD", "TXT"),
}
_REMOTE_BITS = {"send": ("C", "Y"), "receive": ("C", "X", "Y", "T", "CT", "SC")}
_REMOTE_WORDS = {"send": ("DS", "DD", "DH", "DF", "TXT"), "receive": ("DS", "DD", "DH", "DF", "TD", "CTD", "TXT")}
_MODBUS_BITS = {
    "send": (1, 65536, "coil"),
    "receive": (1, 16385, 65536, 100001, 165536, "coil", "discrete_input"),
}
_MODBUS_WORDS = {
    "send": (400001, 465536, "holding"),
    "receive": (400001, 428673, 300001, 365536, "holding", "input"),
}
_MOST = {("send", True): 1968, ("receive", True): 2000, ("send", False): 123, ("receive", False): 125}
"""Bits (True) or registers in one Modbus request, which writes or reads them."""


def _target(draw: st.DrawFn, word: str) -> tuple[str, str]:
    """The target in the source and in the token."""
    name = draw(st.sampled_from(("", "", "press 1", "drive_2", "a-b")))
    if draw(st.booleans()):
        ip = draw(st.sampled_from(("192.168.1.10", "10.0.0.2", "255.255.255.255", "0.0.0.0")))
        port = draw(st.sampled_from((None, 502, 1, 65535)))
        device = draw(st.sampled_from((None, 1, 0, 255)))
        settings = {"name": f'"{name}"' if name else None, "ip": f'"{ip}"', "port": port, "device_id": device}
        values = f'name="{name or "tcp"}",ip="{ip}",port={port or 502},device_id={1 if device is None else device}'
        kind = "ModbusTcpTarget"
    else:
        com_port = draw(st.sampled_from(COM_PORTS))
        number = draw(st.sampled_from((5, 1, 247, *((0,) if word == "send" else ()))))
        settings = {"name": f'"{name}"' if name else None, "com_port": f'"{com_port}"', "device_id": number}
        values = f'name="{name or "rtu"}",com_port="{com_port}",device_id={number}'
        kind = "ModbusRtuTarget"
    texts = [f"{key}={value}" for key, value in settings.items() if value is not None]
    return f"{kind}({', '.join(draw(st.permutations(texts)))})", f"{kind}({values})"


def _remote(draw: st.DrawFn, word: str, is_bits: bool) -> tuple[str, str]:
    """The first address of the other device in the source and in the token."""
    if draw(st.booleans()):
        bank = draw(st.sampled_from((_REMOTE_BITS if is_bits else _REMOTE_WORDS)[word]))
        number = draw(st.integers(1, 8))
        token = f"{bank}{number:03d}" if bank in ("X", "Y") else f"{bank}{number}"
        return f'"{draw(st.sampled_from((token, token.lower())))}"', f'"{token}"'
    modbus: tuple[int | str, ...] = (_MODBUS_BITS if is_bits else _MODBUS_WORDS)[word]
    address = draw(st.sampled_from(modbus))
    if isinstance(address, int):
        text = draw(st.sampled_from((str(address), f'"{address}"')))
        return f"ModbusAddress(address={text})", f"ModbusAddress(address={address})"
    number = draw(st.sampled_from((0, 1, 0x1F4, 0x4000, 0xFFFF)))
    text = draw(st.sampled_from((f'"{number:X}h"', f"0x{number:X}", f'"{number:x}h"')))
    token = f"ModbusAddress(address={number:X}h,register_type={address})"
    return f'ModbusAddress(address={text}, register_type="{address}")', token


def _own(draw: st.DrawFn, word: str, is_bits: bool, short: bool) -> Shown:
    """The cells that are sent or filled; unless ``short``, up to as many as one request moves."""
    bank = draw(st.sampled_from((_OWN_BITS if is_bits else _OWN_WORDS)[word]))
    if bank in ("XD", "YD"):
        return cell(bank, draw(st.integers(0, 8)))
    if draw(st.booleans()):
        return cell(bank, draw(st.integers(1, 8)))
    if bank in ("C", "DS", "DD") and not short and draw(st.integers(0, 4)) == 0:
        return span(bank, 1, _MOST[word, is_bits] // _WORDS.get(bank, 1))
    first, length = draw(st.integers(1, 5)), draw(st.integers(1, 8))
    # For a range of one address laddercodec keeps only the address.
    return span(bank, first, length) if length > 1 else (span(bank, first, 1)[0], cell(bank, first)[1])


@st.composite
def messages(draw: st.DrawFn) -> Act:
    """A send or a receive with each of its optional arguments given or not."""
    word = draw(st.sampled_from(("send", "receive")))
    is_bits = draw(st.booleans())
    target, remote = _target(draw, word), _remote(draw, word, is_bits)
    # In another CLICK too the range stays inside its bank, and X and Y have a gap after the first 16.
    own_text, own = _own(draw, word, is_bits, short=remote[0].startswith('"'))
    name, busy = ("source", "sending") if word == "send" else ("dest", "receiving")
    arguments: list[Given] = [given("target", target[0]), given("remote_start", remote[0]), given(name, own_text)]
    token = f"{word}(target={target[1]},remote_start={remote[1]},{name}={own}"
    for flag, some in ((busy, "C"), ("success", "C"), ("error", "C"), ("exception_response", "DS")):
        if draw(st.booleans()):
            text, shown = cell(some, draw(st.sampled_from((1, 7, 700, 2000))))
            arguments.append(given(flag, text))
            token += f",{flag}={shown}"
        else:
            arguments.append(given(flag, None))
    if not is_bits and draw(st.booleans()):
        arguments.append(given("word_swap", "True"))
        token += ",word_swap=1"
    return Act(called(draw, word, arguments), token + ")", 3)
