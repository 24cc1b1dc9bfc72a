"""Address tables made by hypothesis, and tables to read."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import strategies as st

from clickgen.device.banks import BANKS, Address, Kind, parse_address
from clickgen.problems.diagnostics import Diagnostic, Diagnostics
from clickgen.table.address_table import AddressTable
from clickgen.table.read import read_table
from clickgen.table.rows import HEADER, Row, format_initial

EXPORT = Path(__file__).parents[2] / "fixtures" / "nicknames" / "export.csv"


def at(text: str) -> Address:
    address = parse_address(text)
    assert address is not None
    return address


def judged(path: Path, content: str | bytes) -> tuple[AddressTable, tuple[Diagnostic, ...]]:
    """Write the file, read it as a table, and check that it would be written back unchanged."""
    data = content.encode() if isinstance(content, str) else content
    path.write_bytes(data)
    problems = Diagnostics()
    table = read_table(path, "nicknames.csv", problems)
    assert table.to_bytes() == data
    return table, problems.in_order()


def table_of(path: Path, *rows: str, header: str = HEADER + "\n") -> AddressTable:
    table, problems = judged(path, header + "".join(row + "\n" for row in rows))
    assert problems == ()
    return table


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "nicknames.csv"


ADDRESSES = st.sampled_from(
    [Address(bank.name, number) for bank in BANKS.values() for number in list(bank.numbers())[:6]]
    + [Address("XD", 0, True), Address("YD", 0, True)]
)


NICKNAMES = st.text(st.sampled_from("abAB12_ "), max_size=6).filter(
    lambda name: name == name.strip() and name[:1] != "_" and name.lower() not in ("pi", "ln")
)


# pyclickplc strips nickname, comment and initial value when it reads; a comment here has no space at its ends.
COMMENTS = st.text(st.characters(exclude_categories=["Cc", "Cs"]) | st.sampled_from('",\n'), max_size=20).map(str.strip)


INITIALS: dict[Kind, st.SearchStrategy[str]] = {
    Kind.BIT: st.sampled_from(["0", "1"]),
    Kind.INT16: st.integers(-32768, 32767).map(str),
    Kind.INT32: st.integers(-(2**31), 2**31 - 1).map(str),
    Kind.HEX: st.integers(0, 0xFFFF).map("{:04X}".format) | st.just("0"),
    Kind.FLOAT: st.floats(width=32, allow_nan=False, allow_infinity=False).map(
        lambda value: format_initial(Kind.FLOAT, value) or ""
    ),
    Kind.TEXT: st.characters(min_codepoint=33, max_codepoint=126) | st.just(""),
}


@st.composite
def made_rows(draw: st.DrawFn, max_size: int = 12) -> list[Row]:
    addresses = draw(st.lists(ADDRESSES, unique=True, max_size=max_size))
    names: set[str] = set()
    rows = []
    for address in addresses:
        name = draw(NICKNAMES)
        if name.lower() in names:
            name = ""
        names.add(name.lower())
        fixed = address.bank in ("XD", "YD")
        initial = "0" if fixed else draw(INITIALS[address.kind])
        retentive = False if fixed else draw(st.booleans())
        rows.append(Row(address, name, initial, retentive, draw(COMMENTS)))
    return rows
