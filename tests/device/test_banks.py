"""Banks and addresses, compared bank by bank with pyclickplc."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pyclickplc import banks as theirs
from pyclickplc.addresses import format_address_display
from pyclickplc.addresses import parse_address as their_parse_address

from clickgen.device.banks import BANKS, CURRENT_VALUE_OF, ORDER, UPPER_BYTE_BANKS, Address, Bank, Kind, parse_address

# pyclickplc numbers XD and YD as CLICK's database does: XD0 is 0, XD0u is 1, XD1 is 2, ... XD8 is 16. clickgen counts
# as CLICK shows them, 0..8 and 0u.
DATABASE_NUMBERED = ("XD", "YD")

EVERY_BANK = pytest.mark.parametrize("bank", BANKS.values(), ids=list(BANKS))


def database_number(address: Address) -> int:
    if address.bank not in DATABASE_NUMBERED:
        return address.number
    return 1 if address.upper else address.number * 2


def every_address(bank: Bank) -> list[Address]:
    upper = [Address(bank.name, 0, True)] if bank.name in UPPER_BYTE_BANKS else []
    return [Address(bank.name, number) for number in bank.numbers()] + upper


def test_the_same_banks_in_the_same_order() -> None:
    assert set(BANKS) == set(theirs.BANKS)
    assert list(BANKS) == sorted(theirs.BANKS, key=theirs.MEMORY_TYPE_BASES.__getitem__)
    assert [ORDER[name] for name in BANKS] == list(range(16))


@EVERY_BANK
def test_numbers(bank: Bank) -> None:
    other = theirs.BANKS[bank.name]
    if bank.name in DATABASE_NUMBERED:
        assert {database_number(address) for address in every_address(bank)} == {
            number
            for number in range(other.min_addr, other.max_addr + 1)
            if number == 1 or number % 2 == 0  # the odd ones above 1 are hidden slots
        }
        return
    assert bank.ranges == (other.valid_ranges or ((other.min_addr, other.max_addr),))
    assert (bank.first, bank.last) == (other.min_addr, other.max_addr)
    for number in range(-1, other.max_addr + 20):
        assert bank.has(number) == theirs.is_valid_address(bank.name, number)


@EVERY_BANK
def test_kinds(bank: Bank) -> None:
    # pyclickplc calls the last kind TXT; CLICK's nickname CSV has TEXT.
    their_name = theirs.BANKS[bank.name].data_type.name.replace("TXT", "TEXT")
    assert bank.kind is Kind(their_name)
    assert bank.is_bit == (bank.name in theirs.BIT_ONLY_TYPES)


@EVERY_BANK
def test_retention(bank: Bank) -> None:
    assert bank.retentive == theirs.DEFAULT_RETENTIVE[bank.name]
    assert bank.settings_fixed == (bank.name in theirs.NON_EDITABLE_TYPES)


def test_current_values_belong_to_their_bits() -> None:
    assert CURRENT_VALUE_OF == theirs.PAIRED_RETENTIVE_TYPES
    for value, bit in CURRENT_VALUE_OF.items():
        assert BANKS[value].ranges == BANKS[bit].ranges
        assert BANKS[value].retentive == BANKS[bit].retentive


@EVERY_BANK
def test_every_address_reads_and_prints_alike(bank: Bank) -> None:
    for address in every_address(bank):
        text = str(address)
        assert parse_address(text) == address
        assert parse_address(text.lower()) == address
        number = database_number(address)
        assert their_parse_address(text) == (bank.name, number)
        assert format_address_display(bank.name, number) == text


@given(
    bank=st.sampled_from([*BANKS, "Z", "", "DSX"]),
    number=st.integers(min_value=0, max_value=6000).map(str),
    zeros=st.sampled_from(["", "0", "00"]),
    end=st.sampled_from(["", "u", "U", " ", "uu", "x"]),
)
def test_what_is_no_address_is_none_for_both(bank: str, number: str, zeros: str, end: str) -> None:
    text = f"{bank}{zeros}{number}{end}"
    try:
        name, their_number = their_parse_address(text)
    except ValueError:
        assert parse_address(text) is None
        return
    ours = parse_address(text)
    # pyclickplc takes a u after any bank's number (DS5u is its DS5); there is no such address in CLICK.
    if "u" in text.lower() and name not in UPPER_BYTE_BANKS:
        assert ours is None
    else:
        assert ours is not None
        assert (ours.bank, database_number(ours)) == (name, their_number)


@pytest.mark.parametrize(
    "text", ["", " ", "X", "5", "X-1", "X017", "X²", "DS0", "DS4501", "XD9", "XD1u", "YD", "u", "X1 2"]
)
def test_no_address(text: str) -> None:
    assert parse_address(text) is None


def test_rows_are_ordered_by_bank_then_number() -> None:
    texts = ["TXT1", "XD8", "XD0u", "XD0", "XD1", "CT1", "T10", "T9", "Y001", "X816", "X001", "TD1", "SC1"]
    order = sorted((parse_address(text) for text in texts), key=lambda address: address.sort_key if address else ())
    assert [str(address) for address in order] == [
        "X001", "X816", "Y001", "T9", "T10", "CT1", "SC1", "XD0", "XD0u", "XD1", "XD8", "TD1", "TXT1"
    ]  # fmt: skip
