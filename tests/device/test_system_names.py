"""CLICK's own names: the data file is the script's output, and lookups go both ways."""

from __future__ import annotations

import csv
import shutil
import subprocess
import sys
from pathlib import Path

from pyclickplc.system import AUTOMATIONDIRECT_SYSTEM_NICKNAMES

from clickgen.device.banks import BANKS, Address, parse_address
from clickgen.device.nicknames import nickname_fault
from clickgen.device.system import (
    ALWAYS_ON,
    DISPUTED_SC,
    WRITABLE_SC,
    WRITABLE_SD,
    addresses_of_system_name,
    doubt_about,
    find_system_name,
    near_system_name,
    system_name_of,
    system_nicknames,
    system_points,
)

ROOT = Path(__file__).parents[2]
SCRIPT = ROOT / "scripts" / "make_system_nicknames.py"
EXPORT = ROOT / "fixtures" / "click-3.41" / "system-names.csv"

LOOKALIKE = "_I/O_Module_Error"
"""SC22 in a list, but in CLICK ``_I/O Module Error`` is SC20."""
MOVED = {"_Port1_AL_Denied_Count": ("SD132", "SD134"), "_WLAN_AL_Denied_Count": ("SD133", "SD135")}


def _exported() -> list[dict[str, str]]:
    with EXPORT.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def _address(text: str) -> Address:
    address = parse_address(text)
    assert address is not None
    return address


def test_the_data_file_is_not_stale() -> None:
    run = subprocess.run([sys.executable, str(SCRIPT), "--check"], capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr


def test_a_stale_data_file_is_noticed(tmp_path: Path) -> None:
    copy = tmp_path / "scripts" / SCRIPT.name
    copy.parent.mkdir()
    copy.write_text(SCRIPT.read_text())
    shutil.copytree(EXPORT.parent, tmp_path / "fixtures" / "click-3.41")
    data = tmp_path / "clickgen" / "device" / "system_nicknames.csv"
    data.parent.mkdir(parents=True)

    def run(*arguments: str) -> int:
        return subprocess.run([sys.executable, str(copy), *arguments], capture_output=True, check=False).returncode

    assert run("--check") == 1
    assert not data.exists()
    assert run() == 0
    assert run("--check") == 0
    assert data.read_bytes() == (ROOT / "clickgen" / "device" / "system_nicknames.csv").read_bytes()
    data.write_text("Address,Nickname,Other\nSC1,_Something_else,\n")
    assert run("--check") == 1


def test_the_names_are_those_that_click_shows() -> None:
    exported = _exported()
    assert len(exported) == 206
    for row in exported:
        address, name = _address(row["Address"]), row["Nickname"]
        assert system_name_of(address) == name
        if name not in MOVED:
            assert find_system_name(name) == (name, address)
            assert system_nicknames()[name.lower()] == (name, address)


def test_every_name_of_the_other_list_still_means_its_address() -> None:
    assert len(AUTOMATIONDIRECT_SYSTEM_NICKNAMES) == 344
    shown = {row["Address"] for row in _exported()}
    for (bank, number), guidance in AUTOMATIONDIRECT_SYSTEM_NICKNAMES.items():
        address, name = Address(bank, number), guidance.nickname
        assert address in addresses_of_system_name(name)
        if name not in (*MOVED, LOOKALIKE):
            assert find_system_name(name) == (system_name_of(address), address)
        if str(address) not in shown and name not in MOVED:
            assert system_name_of(address) == name
    assert len(system_points()) == 344


def test_a_name_that_moved_means_both_addresses_and_is_offered_nowhere() -> None:
    for name, addresses in MOVED.items():
        assert tuple(map(str, addresses_of_system_name(name))) == addresses
        assert find_system_name(name) is None
        assert name.lower() not in system_nicknames()
        assert near_system_name(name[:-1], "SD") == ""
        assert system_name_of(_address(addresses[1])) is None


def test_only_one_older_name_reads_like_another() -> None:
    assert tuple(map(str, addresses_of_system_name(LOOKALIKE))) == ("SC20", "SC22")
    assert doubt_about(LOOKALIKE) == (
        "_I/O_Module_Error reads like '_I/O Module Error', which is SC20 in CLICK 3.41, "
        "and like '_I/O_Module_Error', which is SC22 in another version"
    )
    others = [point.other for point in system_points() if point.other and point.other not in MOVED]
    assert [other for other in others if len(addresses_of_system_name(other)) > 1] == [LOOKALIKE]


def test_no_spelling_of_spaces_underscores_and_case_picks_one_of_two_addresses() -> None:
    """Any spelling that CLICK 3.41 does not show means what all names of its letters mean, or nothing."""
    by_letters: dict[str, set[Address]] = {}
    written = [(name, point.address) for point in system_points() for name in (point.name, point.other) if name]
    for name, address in written:
        by_letters.setdefault(name.replace("_", "").replace(" ", "").lower(), set()).add(address)
    for name, address in written:
        meant = by_letters[name.replace("_", "").replace(" ", "").lower()]
        for spelling in (name, name.upper(), name.replace(" ", ""), name.replace(" ", "_"), name.replace("_", " ")):
            is_shown = spelling.lower() == (system_name_of(address) or "").lower() and name not in MOVED
            assert set(addresses_of_system_name(spelling)) in (({address},) if is_shown else (meant, set()))


def test_spaces_and_case_of_a_system_name_do_not_matter() -> None:
    point = ("_RTC_Year(4 digits)", Address("SD", 19))
    for spelling in ("_RTC_Year (4 digits)", "_RTC_Year(4 digits)", "_rtc_year(4digits)"):
        assert find_system_name(spelling) == point
    assert find_system_name("_RTC_Jahr") is None


def test_no_name_is_suggested_for_another_of_click_s_own() -> None:
    """Nothing that CLICK names itself gets a suggestion of a neighbour."""
    for point in system_points():
        for name in filter(None, (point.name, point.other)):
            near = near_system_name(name, point.address.bank)
            assert near in ("", system_name_of(point.address))


def test_names_stand_in_click_s_row_order() -> None:
    addresses = [point.address for point in system_points()]
    assert addresses == sorted(addresses, key=lambda address: address.sort_key)


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
    assert (len(WRITABLE_SC), len(WRITABLE_SD)) == (21, 29)


def test_what_click_lets_a_master_write_is_writable() -> None:
    """The export says for each address with a name whether Modbus writes it."""
    written = {row["Address"] for row in _exported() if row["Function Code"] in ("FC=01,05,15", "FC=03,06,16")}
    ours = {f"SC{number}" for number in WRITABLE_SC} | {f"SD{number}" for number in WRITABLE_SD}
    # Slots of communication modules: another list from an export has them as writable (click-facts
    # [bank.writable-sc, bank.writable-sc-disputed]).
    assert ours - written == {f"SC{number}" for number in (303, 304, 305, 306, 323, 324, 325, 326)}
    assert written <= ours
    assert {f"SC{number}" for number in DISPUTED_SC} < ours - written
