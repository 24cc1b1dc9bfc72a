"""Modbus numbers as manuals print them: the message for each, and its way out, which builds."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import clickgen
from clickgen.device.modbus import NUMBERS_984, of_manual, register_type_of
from clickgen.problems.diagnostics import Diagnostic

_WAY = re.compile(r"ModbusAddress\([^)]*\)")


def problems(folder: Path, remote: str, own: str, word: str = "receive") -> list[Diagnostic]:
    """The message of a build about one send or receive."""
    program = folder / "prog.py"
    text = f'def main():\n    if c[1]:\n        {word}(ModbusTcpTarget(ip="10.0.0.1"), {remote}, {own})\n'
    program.write_text(f"{text}    if True:\n        end()\n", "utf-8")
    return list(clickgen.build(program).diagnostics)


@pytest.mark.parametrize(
    ("remote", "own", "code", "way"),
    [
        ("ModbusAddress(address=42332)", "ds[1:5]", "CG305", "ModbusAddress(address=402332)"),
        ('ModbusAddress(address="40001")', "ds[1]", "CG305", "ModbusAddress(address=400001)"),
        ("ModbusAddress(address=30010)", "ds[1]", "CG305", "ModbusAddress(address=300010)"),
        ("ModbusAddress(address=100)", "ds[1]", "CG305", "ModbusAddress(address=400100)"),
        ("ModbusAddress(address=50000)", "ds[1]", "CG305", "ModbusAddress(address=450000)"),
        ('"42332"', "ds[1]", "CG201", "ModbusAddress(address=402332)"),
        ('"400001"', "ds[1]", "CG201", "ModbusAddress(address=400001)"),
        ("40001", "ds[1]", "CG115", "ModbusAddress(address=400001)"),
        ("400001", "ds[1]", "CG115", "ModbusAddress(address=400001)"),
        ("42332", "ds[1]", "CG115", "ModbusAddress(address=402332)"),
        ('ModbusAddress(address=40001, register_type="holding")', "ds[1]", "CG314", "ModbusAddress(address=400001)"),
        ('ModbusAddress(address=100, register_type="holding")', "ds[1]", "CG314", "ModbusAddress(address=400100)"),
        ("ModbusAddress(address=10001)", "c[1:9]", "CG551", "ModbusAddress(address=100001)"),
        ('ModbusAddress(address="10016")', "c[1]", "CG551", "ModbusAddress(address=100016)"),
    ],
)
def test_a_number_of_a_manual_is_named_with_six_digits(
    remote: str, own: str, code: str, way: str, tmp_path: Path
) -> None:
    (problem,) = problems(tmp_path, remote, own)
    assert problem.code == code
    ways = _WAY.findall(problem.help)
    assert ways[0] == way
    for one in ways:
        assert problems(tmp_path, one, own) == []


@pytest.mark.parametrize("number", [10001, 19999, 30001, 40001, 49999])
def test_a_coil_that_is_meant_has_a_way_too(number: int, tmp_path: Path) -> None:
    (problem,) = problems(tmp_path, f"ModbusAddress(address={number})", "c[1]")
    assert problem.code == "CG551"
    hexadecimal = _WAY.findall(problem.help)[-1]
    assert hexadecimal == f'ModbusAddress(address="{number - 1:X}h", register_type="coil")'
    assert problems(tmp_path, hexadecimal, "c[1]") == []
    assert problems(tmp_path, f'ModbusAddress(address="0{number}")', "c[1]") == []


@pytest.mark.parametrize("number", [1, 9999, 10000, 16385, 18384, 20001, 40000, 50001, 61490])
def test_other_coils_are_left_alone(number: int, tmp_path: Path) -> None:
    assert problems(tmp_path, f"ModbusAddress(address={number})", "c[1]") == []


def test_six_digits_are_those_of_the_register_type() -> None:
    for number in range(1, 60000, 7):
        manual = of_manual(number)
        if manual is not None:
            name, six = manual
            low, high = NUMBERS_984[name]
            assert low <= six <= high
            assert register_type_of(six) == name
            assert six % 10000 == number % 10000
