"""Send and receive (click-facts [message.banks, message.flags, message.targets])."""

from __future__ import annotations

from collections.abc import Iterator

from matrix.notation import (
    BITS,
    CONSTANTS,
    READ,
    WRITTEN,
    Cell,
    Matrices,
    Operand,
    Takes,
    action,
    addresses,
    cell,
    span,
)

# The captures show C, DS, DD and DH. The others hold the same kinds of values: taken with a warning.
_UNSEEN = "X Y T CT SC DF XD YD TD CTD SD TXT"
_UNSEEN_WRITTEN = "Y DF YD TD CTD TXT"
_OWN = {
    "send": Takes(cells="C DS DD DH", ranges="C DS DD DH", disputed=_UNSEEN),
    "receive": Takes(cells="C DS DD DH", ranges="C DS DD DH", disputed=_UNSEEN_WRITTEN, is_written=True),
}
_FLAG = Takes(cells="C", is_written=True)
_RESPONSE = Takes(cells="DS", disputed="DD", is_written=True)
_NAMES = {"send": ("source", "sending"), "receive": ("dest", "receiving")}

Shown = tuple[str, str]
"""An argument in the source and in the token."""

_TCP = 'ModbusTcpTarget(name="tcp",ip="192.168.1.10",port=502,device_id=1)'
_RTU = 'ModbusRtuTarget(name="rtu",com_port="cpu2",device_id=5)'
_BITS, _WORDS = span("C", 21, 5), span("DS", 21, 5)


def _one(operand: Operand) -> Shown:
    return operand.source, operand.token


def _same(text: str) -> Shown:
    return text, text


def _call(name: str, codes: str = "", changed: dict[str, Shown | None] | None = None) -> Cell:
    """A send or receive of registers, except for what is changed or left out (None)."""
    own, busy = _NAMES[name]
    arguments: dict[str, Shown | None] = {
        "target": _same(_TCP),
        "remote_start": _same('"DS1"'),
        own: _one(_WORDS),
        busy: _one(cell("C", 11)),
        "success": _one(cell("C", 12)),
        "error": _one(cell("C", 13)),
        "exception_response": _one(cell("DS", 20)),
        **(changed or {}),
    }
    kept = [(key, shown) for key, shown in arguments.items() if shown]
    source = ", ".join(f"{key}={written}" for key, (written, _) in kept)
    token = ",".join(f"{key}={written}" for key, (_, written) in kept)
    return action(f"{name}({source})", f"{name}({token})", codes=codes)


def _own(name: str) -> Iterator[Cell]:
    """The cells that are sent, or that receive: bits from or to bits, registers from or to registers."""
    takes = _OWN[name]
    for operand in (*addresses(WRITTEN if takes.is_written else READ), *CONSTANTS):
        fault = takes.fault(operand)
        if fault == "CG301" and operand.form == "range" and operand.bank in takes.disputed.split():
            fault = "CG312"
        remote = '"C1"' if operand.bank in BITS.split() else '"DS1"'
        yield _call(name, fault, {"remote_start": _same(remote), _NAMES[name][0]: _one(operand)})


def _flags(name: str, argument: str) -> Iterator[Cell]:
    takes = _RESPONSE if argument == "exception_response" else _FLAG
    for operand in (*addresses(WRITTEN), *CONSTANTS):
        yield _call(name, takes.fault(operand), {argument: _one(operand)})
    yield _call(name, changed={argument: None})


def _ends(name: str) -> Iterator[Cell]:
    """Both ends hold bits or both hold registers; words are swapped only if there are words."""
    own = _NAMES[name][0]
    for remote in ('"Y001"', '"C1"', "ModbusAddress(address=0h,register_type=coil)"):
        source = remote.replace("0h", '"0h"').replace("=coil", '="coil"')
        yield _call(name, "", {"remote_start": (source, remote), own: _one(_BITS)})
        yield _call(name, "CG305", {"remote_start": (source, remote)})
    for remote in ('"DS1"', '"DD1"', '"DH1"', '"DF1"', '"TXT1"', "ModbusAddress(address=400001)"):
        yield _call(name, "", {"remote_start": _same(remote)})
        yield _call(name, "CG305", {"remote_start": _same(remote), own: _one(_BITS)})
    yield _call(name, "", {"word_swap": ("True", "1")})
    yield _call(name, "CG314", {"word_swap": ("True", "1"), "remote_start": _same('"C1"'), own: _one(_BITS)})
    yield _call(name, "", {"target": _same(_RTU)})


def _matrices(name: str) -> Matrices:
    own, busy = _NAMES[name]
    flags = (busy, "success", "error", "exception_response")
    return {
        f"{name} {own}": list(_own(name)),
        **{f"{name} {flag}": list(_flags(name, flag)) for flag in flags},
        f"{name} ends": list(_ends(name)),
    }


MATRICES: Matrices = {**_matrices("send"), **_matrices("receive")}
