"""The Modbus number of every address of CLICK, against an export of CLICK PLUS 3.41 that lists them all."""

from __future__ import annotations

import csv
from collections.abc import Iterator
from pathlib import Path

import pytest

from clickgen.device.banks import BANKS, Address, parse_address
from clickgen.device.modbus import modbus_number

EXPORT = Path(__file__).parents[2] / "fixtures" / "click-3.41" / "modbus.csv"


def _runs() -> list[dict[str, str]]:
    with EXPORT.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def _listed() -> Iterator[tuple[Address, str, str, str]]:
    """Every address of the export with its numbers in both notations and its function codes."""
    for run in _runs():
        first, last = parse_address(run["First"]), parse_address(run["Last"])
        if first is None or last is None:
            continue
        count = last.number - first.number + 1
        low, high = int(run["Modbus 984 first"]), int(run["Modbus 984 last"])
        hex_low = int(run["Modbus hex first"][:-1], 16)
        for index in range(count):
            # Runs count up evenly: one register for each address, two for each, or one for two.
            step = index if high - low == count - 1 else index * 2 if high - low > count - 1 else index // 2
            address = Address(first.bank, first.number + index, first.upper)
            yield address, str(low + step), f"{hex_low + step:04X}h", run["Function Code"]


def test_every_address_has_the_number_that_click_shows() -> None:
    listed = list(_listed())
    for address, decimal, hexadecimal, code in listed:
        number = modbus_number(address)
        assert (str(address), number.decimal, number.hexadecimal) == (str(address), decimal, hexadecimal)
        assert number.function_code == code, address
    every = {Address(bank.name, number) for bank in BANKS.values() for number in bank.numbers()}
    every |= {Address("XD", 0, True), Address("YD", 0, True)}
    assert {address for address, *_ in listed} == every


def test_the_last_of_each_run_is_as_listed() -> None:
    for run in _runs():
        last = parse_address(run["Last"])
        if last is not None:
            number = modbus_number(last)
            assert number.decimal == run["Modbus 984 last"]
            assert number.hexadecimal == run["Modbus hex last"]


@pytest.mark.parametrize(
    ("address", "decimal", "code"),
    [
        ("X036", "100032", "FC=02"),
        ("X101", "100033", "FC=02"),
        ("Y816", "8464", "FC=01,05,15"),
        ("DD2", "416387", "FC=03,06,16"),
        ("TXT1", "436865", "FC=03,06,16"),
        ("TXT2", "436865", "FC=03,06,16"),
        ("TXT3", "436866", "FC=03,06,16"),
        ("XD0u", "357346", "FC=04"),
        ("XD1", "357347", "FC=04"),
        ("SC50", "61490", "FC=01,05,15"),
        ("SC305", "161745", "FC=02"),
        ("SD29", "461469", "FC=03,06,16"),
    ],
)
def test_some_addresses(address: str, decimal: str, code: str) -> None:
    parsed = parse_address(address)
    assert parsed is not None
    number = modbus_number(parsed)
    assert (number.decimal, number.function_code) == (decimal, code)
