"""CLICK's own names: the data file is the one that the script makes, and lookups go both ways."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from pyclickplc.system import AUTOMATIONDIRECT_SYSTEM_NICKNAMES

from clickgen.device import system
from clickgen.device.banks import BANKS, Address
from clickgen.device.nicknames import nickname_fault
from clickgen.device.system import (
    ALWAYS_ON,
    WRITABLE_SC,
    WRITABLE_SD,
    find_system_name,
    system_name_of,
    system_nicknames,
)

ROOT = Path(__file__).parents[1]
SCRIPT = ROOT / "scripts" / "make_system_nicknames.py"


def test_the_data_file_is_not_stale() -> None:
    run = subprocess.run([sys.executable, str(SCRIPT), "--check"], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr


def test_a_stale_data_file_is_noticed(tmp_path: Path) -> None:
    copy = tmp_path / "scripts" / SCRIPT.name
    copy.parent.mkdir()
    copy.write_text(SCRIPT.read_text())
    data = tmp_path / "clickgen" / "device" / "system_nicknames.csv"
    data.parent.mkdir(parents=True)

    def run(*arguments: str) -> int:
        return subprocess.run([sys.executable, str(copy), *arguments], capture_output=True, check=False).returncode

    assert run("--check") == 1
    assert not data.exists()
    assert run() == 0
    assert run("--check") == 0
    assert data.read_bytes() == (ROOT / "clickgen" / "device" / "system_nicknames.csv").read_bytes()
    data.write_text("Address,Nickname\nSC1,_Something_else\n")
    assert run("--check") == 1


def test_every_name_is_found_by_name_and_by_address() -> None:
    assert len(AUTOMATIONDIRECT_SYSTEM_NICKNAMES) == 344
    for (bank, number), guidance in AUTOMATIONDIRECT_SYSTEM_NICKNAMES.items():
        address = Address(bank, number)
        assert system_name_of(address) == guidance.nickname
        assert system_nicknames()[guidance.nickname.lower()] == (guidance.nickname, address)
    # No two points share a name today; the count would say so.
    assert len(system_nicknames()) == 344


def test_spaces_and_case_of_a_system_name_do_not_matter() -> None:
    point = ("_RTC_Year (4 digits)", Address("SD", 19))
    for spelling in ("_RTC_Year (4 digits)", "_RTC_Year(4 digits)", "_rtc_year(4digits)"):
        assert find_system_name(spelling) == point
    assert find_system_name("_RTC_Jahr") is None


def test_names_stand_in_click_s_row_order() -> None:
    addresses = [address for _, address in system_nicknames().values()]
    assert addresses == sorted(addresses, key=lambda address: address.sort_key)


def test_a_name_shared_by_two_points_goes_to_the_first(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    data = tmp_path / "names.csv"
    data.write_text("Address,Nickname\nSC7,_Twin\nSD3,_TWIN\n")
    monkeypatch.setattr(system, "_DATA", data)
    _forget()
    try:
        assert system_nicknames() == {"_twin": ("_Twin", Address("SC", 7))}
        assert system_name_of(Address("SD", 3)) == "_TWIN"
    finally:
        _forget()


def _forget() -> None:
    system._names_by_address.cache_clear()
    system_nicknames.cache_clear()


def test_every_name_is_legal_for_click_s_own_points() -> None:
    for name, _ in system_nicknames().values():
        assert nickname_fault(name, system=True) is None
        assert nickname_fault(name) is not None


def test_the_points_that_the_compiler_itself_uses() -> None:
    assert system_name_of(ALWAYS_ON) == "_Always_ON"
    assert system_name_of(Address("DS", 1)) is None
    assert system_name_of(Address("SC", 999)) is None


def test_writable_points_exist() -> None:
    assert all(BANKS["SC"].has(number) for number in WRITABLE_SC)
    assert all(BANKS["SD"].has(number) for number in WRITABLE_SD)
    assert ALWAYS_ON.number not in WRITABLE_SC
    # Setting the clock is what most programs write SD for (click-facts, section 3).
    assert {29, 31, 32, 34, 35, 36, 140, 147, 214, 215} <= WRITABLE_SD
    assert (len(WRITABLE_SC), len(WRITABLE_SD)) == (17, 29)
