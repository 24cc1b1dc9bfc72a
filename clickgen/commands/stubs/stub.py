"""The stub files: ``__builtins__.pyi`` beside programs, and the types of ``clickgen.dsl``."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from clickgen.commands.stubs.arguments import literals, option_class
from clickgen.commands.stubs.forms import cell, named, pointer, span, within
from clickgen.commands.stubs.instructions import call_of_bank, instruction_functions, loop_function
from clickgen.commands.stubs.names import name_attributes
from clickgen.commands.stubs.text import class_text, docstring, function_text
from clickgen.commands.stubs.values import value_classes
from clickgen.device.banks import BANKS, POINTED, Bank
from clickgen.device.modbus import REGISTER_TYPES
from clickgen.instructions.communication import COM_PORTS
from clickgen.instructions.copies import CONVERSIONS
from clickgen.instructions.timers import UNITS
from clickgen.table.blocks import Block
from clickgen.table.rows import Row

MARK = "# made by clickgen stubs; do not edit\n"
"""The beginning of every file that clickgen stubs may overwrite."""
_MODULE_MARK = "# made by scripts/dsl_stub.py; do not edit\n"

_HEADER = '''\
# pyright: basic, reportIncompatibleMethodOverride=false, reportOverlappingOverload=false
# pyright: reportInconsistentOverload=false
# mypy: disable-error-code="override, overload-overlap, misc"
# ruff: noqa
# fmt: off
"""The language of clickgen programs, for editors. A program is only read, never run."""

from collections.abc import Callable, Iterable, Sequence
from typing import Final, Literal, Protocol, TypeAlias, TypeVar, overload

'''

_UNIT_TITLES = {"Tms": "milliseconds", "Ts": "seconds", "Tm": "minutes", "Th": "hours", "Td": "days"}

_CONDITIONS = '''\
# 5 == ds.A is a bool for Python, because its left side decides.
_Given: TypeAlias = _Condition | bool
_Series: TypeAlias = _Given | Sequence[_Series]
_Pin: TypeAlias = Callable[[], _Given]
_Contact: TypeAlias = _Bit | _BitRange | _XImmediate

def all(condition: _Given, /, *conditions: _Given) -> _Condition:
    """Conditions in series: every one of them holds."""
def any(condition: _Given, /, *conditions: _Given) -> _Condition:
    """Conditions in parallel: at least one of them holds."""
def nc(bit: _Contact, /) -> _Condition:
    """A normally closed contact: the bit is off; every bit of a range is off."""
def re(bit: _Bit, /) -> _Condition:
    """A rising edge: the bit has just come on."""
def fe(bit: _Bit, /) -> _Condition:
    """A falling edge: the bit has just gone off."""
'''

_DECLARATIONS = '''\
class _Subroutine(Protocol):
    """A subroutine, to be called by call(...)."""
    _is_subroutine: None
@overload
def sub(routine: Callable[[], None], /) -> _Subroutine:
    """Marks a subroutine, on the line above def name():."""
@overload
def sub(name: str, /) -> Callable[[Callable[[], None]], _Subroutine]:
    """Marks a subroutine that CLICK calls otherwise than the program: @sub("Auto Mode")."""

def nickname(
    name: _Address,
    address: _Address,
    /,
    *,
    initial: float | str = ...,
    retentive: bool = ...,
    comment: str = ...,
) -> None:
    """Tie a name to an address of the same bank, at the top level of a file.

    Example: nickname(ds.MaxAlarms, ds[5], initial=10, retentive=False, comment="rows of alarms")
    """
'''


def builtins_stub(rows: Iterable[Row] = (), blocks: Iterable[Block] = ()) -> str:
    """Return the text of ``__builtins__.pyi``: the language, and these names as attributes of their banks."""
    attributes = name_attributes(rows, blocks)
    return MARK + _stub({bank: attributes.get(bank, "") for bank in BANKS})


def module_stub() -> str:
    """Return the text of ``clickgen/dsl.pyi``: the language, with any nickname."""
    own = name_attributes()
    return _MODULE_MARK + _stub({bank: own.get(bank, "") + _any_name(bank) for bank in BANKS})


def _any_name(bank: str) -> str:
    return function_text("__getattr__", ["self", "nickname: str"], named(bank), "The address with this nickname.")


def _stub(members: dict[str, str]) -> str:
    parts = [
        *value_classes(),
        _CONDITIONS,
        *(_bank_class(bank, members[bank.name]) for bank in BANKS.values()),
        "".join(_bank_variables()),
        f'_Address = TypeVar("_Address", {", ".join(map(within, BANKS))})\n{_DECLARATIONS}',
        _units(),
        *_options(),
        *_modbus(),
        *instruction_functions(),
        loop_function(),
    ]
    return _HEADER + "\n".join(parts)


# -- banks ------------------------------------------------------------------------------------------------------------


def _bank_class(bank: Bank, members: str) -> str:
    name = bank.name
    keys = {"int": cell(name), "str": named(name), "slice[int, int, int | None]": span(name)}
    if name in POINTED:
        keys[cell("DS")] = pointer(name)
    getters = [
        f"@overload\n{function_text('__getitem__', ['self', f'key: {key}', '/'], result)}"
        for key, result in keys.items()
    ]
    return class_text(_bank(bank), "_NoCondition", _about(bank), [members, *getters, call_of_bank(bank)])


def _bank_variables() -> Iterator[str]:
    for bank in BANKS.values():
        yield f"{bank.dsl}: {_bank(bank)}\n{docstring(_about(bank))}"


def _bank(bank: Bank) -> str:
    return f"_{bank.name}Bank"


def _about(bank: Bank) -> str:
    retentive = ", retentive" if bank.retentive else ""
    return f"{bank.name}: {bank.title}, {bank.describe_range()}{retentive}"


# -- words ------------------------------------------------------------------------------------------------------------


def _units() -> str:
    variables = "".join(f"{unit}: _Unit\n{docstring(_UNIT_TITLES[unit])}" for unit in UNITS)
    return class_text("_Unit", "", "The unit of a timer's setpoint.") + variables


def _options() -> Iterator[str]:
    """The conversions of a copy: each a word that may be called, one of them with settings."""
    for option in CONVERSIONS:
        settings = _SETTINGS if option == "to_text" else []
        call = function_text("__call__", ["self", *settings], option_class(option))
        yield class_text(option_class(option), "", _OPTION_TITLES[option], [call])
        yield f"{option}: {option_class(option)}\n{docstring(_OPTION_TITLES[option])}"


_SETTINGS = [
    "*",
    "suppress_zero: bool = True",
    "exponential: bool = False",
    "termination_code: int | str | None = None",
]
_OPTION_TITLES = {
    "to_value": 'The digits become a value: "5" becomes 5.',
    "to_ascii": 'The character becomes its code: "5" becomes 53.',
    "to_binary": "The number becomes the character with that code.",
    "to_text": "The number becomes digits.",
}


def _modbus() -> Iterator[str]:
    """The other end of a send or receive, and addresses in it."""
    settings = {
        "ModbusTcpTarget": ["ip: str", "port: int = 502", "device_id: int = 1", 'name: str = "tcp"'],
        "ModbusRtuTarget": [f"com_port: {literals(COM_PORTS)}", "device_id: int", 'name: str = "rtu"'],
        "ModbusAddress": ["address: int | str", f"register_type: {literals(REGISTER_TYPES)} | None = None"],
    }
    titles = {
        "ModbusTcpTarget": "A device in the network.",
        "ModbusRtuTarget": "A device on a serial line.",
        "ModbusAddress": 'An address in any device: 400001, or hexadecimal "64h" with a register type.',
    }
    for name, own in settings.items():
        yield class_text(name, "", titles[name], [function_text("__init__", ["self", "*", *own], "None")])
