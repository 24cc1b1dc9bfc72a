"""Rows of the address table: an address and its settings in CLICK, in CLICK's form.

click-facts [nickname-file.values]
"""

from __future__ import annotations

import math
import re
import struct

from clickgen.device.banks import BANKS, FLOAT_MAX, INTEGER_RANGES, Address, Kind
from clickgen.records import dataclass
from clickgen.text.source import Span

COLUMNS = ("Address", "Data Type", "Nickname", "Initial Value", "Retentive", "Address Comment")
HEADER = ",".join(COLUMNS)


@dataclass(frozen=True, slots=True)
class Row:
    """One row: an address and its settings in CLICK. ``initial`` is as written in the file.

    ``line`` counts from 1 and is 0 for a new row; ``raw`` is the row as it is in the file, without its line end.
    ``cell`` is where a row of a workbook has its address, ``spare`` the text there in place of a nickname.
    """

    address: Address
    nickname: str
    initial: str
    retentive: bool
    comment: str
    line: int = 0
    raw: str = ""
    cell: Span | None = None
    spare: str = ""

    @property
    def content(self) -> tuple[Address, str, str, bool, str]:
        """The content of the row, wherever and however it is written."""
        return (self.address, self.nickname, self.initial, self.retentive, self.comment)

    @property
    def is_default(self) -> bool:
        """True if the row says nothing that CLICK would not assume without it.

        click-facts [nickname-file.defaults]
        """
        bank = BANKS[self.address.bank]
        return (
            not self.nickname
            and not self.comment
            and self.initial in ("", _default_initial(bank.kind))
            and self.retentive == bank.retentive
        )


def format_row(row: Row) -> str:
    """Return a row in CLICK's form: nickname and comment always quoted, and nothing else.

    click-facts [nickname-file.columns]
    """
    kind = row.address.kind
    initial = row.initial or _default_initial(kind)
    # How CLICK writes a comma or a quote as the initial value of a TXT is unknown; unquoted it would not be a CSV
    # (click-facts [nickname-file.text-quotes]).
    if kind is Kind.TEXT and initial in (",", '"', "\n", "\r"):
        initial = _quoted(initial)
    retentive = "Yes" if row.retentive else "No"
    return f"{row.address},{kind.value},{_quoted(row.nickname)},{initial},{retentive},{_quoted(row.comment)}"


SCRATCH = "Scratch_"
"""The beginning of the nicknames that clickgen gives to cells it needs for itself."""


def scratch_name(address: Address) -> str:
    return f"{SCRATCH}{address}"


_SCRATCH_NAME = re.compile(rf"{SCRATCH}[A-Z]+[0-9]+", re.IGNORECASE)
_SCRATCH_REASON = re.compile(r".+ of [\w -]+: [a-z_]+( .+)?|rtof T[0-9]+: .+|.+ of [\w -]+ rung [0-9]+(: .+)?")
"""The last form is that of earlier versions."""


def looks_like_scratch(name: str) -> bool:
    """True for a name of the kind that clickgen keeps for its own cells."""
    return _SCRATCH_NAME.fullmatch(name) is not None


def is_scratch(row: Row) -> bool:
    """True for a row that clickgen itself wrote for a scratch use, judged by its name and its reason."""
    return row.nickname == scratch_name(row.address) and _SCRATCH_REASON.fullmatch(row.comment) is not None


def default_row(address: Address, nickname: str, comment: str = "") -> Row:
    """Return a new row with CLICK's own initial value and retention for the bank."""
    bank = BANKS[address.bank]
    return Row(address, nickname, _default_initial(bank.kind), bank.retentive, comment)


def format_initial(kind: Kind, value: object) -> str | None:
    """Return an initial value as CLICK writes it, or None if a cell of this kind cannot hold the value.

    Takes bool, 0 or 1 for a bit; int; float or int for FLOAT; int or text such as ``"00FFh"`` for HEX; one ASCII
    character or nothing for TEXT.
    """
    if kind is Kind.TEXT:
        return value if isinstance(value, str) and initial_fault(kind, value) is None else None
    if kind is Kind.HEX and isinstance(value, str):
        digits = re.fullmatch(r"([0-9A-Fa-f]{1,4})[hH]?", value)
        return _hex(int(digits[1], 16)) if digits else None
    if kind is Kind.BIT and isinstance(value, bool):
        return str(int(value))
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return None
    if kind is Kind.FLOAT:
        return _float(value)
    if not isinstance(value, int):
        return None
    if kind is Kind.HEX:
        return _hex(value) if 0 <= value <= 0xFFFF else None
    low, high = (0, 1) if kind is Kind.BIT else INTEGER_RANGES[kind]
    return str(value) if low <= value <= high else None


def is_default_initial(kind: Kind, text: str) -> bool:
    """True for an initial value that means CLICK's default, however it is written: 0, or no text.

    A value that CLICK does not take counts as the default too.
    """
    if not text or initial_fault(kind, text):
        return True
    if kind is Kind.TEXT:
        return False
    return (int(text, 16) if kind is Kind.HEX else float(text)) == 0


def _default_initial(kind: Kind) -> str:
    return "" if kind is Kind.TEXT else "0"


def _quoted(text: str) -> str:
    return '"' + text.replace('"', '""') + '"'


def _hex(value: int) -> str:
    return f"{value:04X}" if value else "0"


def _float(value: float) -> str | None:
    """The shortest digits that give the same 32-bit float, with CLICK's exponent (``-3.4028235E+38``)."""
    if not -FLOAT_MAX <= value <= FLOAT_MAX:  # also false for NaN
        return None
    single = _single(float(value))
    if single == 0:
        return "0"
    digits = next(text for text in (f"{single:.{n}e}" for n in range(9)) if _single(float(text)) == single)
    mantissa, _, exponent = digits.partition("e")
    power = int(exponent)
    if -5 <= power < 7:
        places = len(mantissa.partition(".")[2])
        return f"{float(digits):.{max(places - power, 0)}f}"
    return f"{mantissa}E{power:+03d}"


def _single(value: float) -> float:
    try:
        number: float = struct.unpack("<f", struct.pack("<f", value))[0]
    except OverflowError:
        return math.inf
    return number


_BIT_FORM = re.compile(r"[01]")
_INTEGER_FORM = re.compile(r"-?[0-9]{1,10}")
_HEX_FORM = re.compile(r"[0-9A-Fa-f]{1,4}")
_FLOAT_FORM = re.compile(r"-?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")


def initial_fault(kind: Kind, text: str) -> str | None:
    """What CLICK takes instead; None if it takes this initial value for this kind of cell."""
    if kind is Kind.BIT:
        return None if _BIT_FORM.fullmatch(text) else "0 or 1"
    if kind is Kind.HEX:
        return None if _HEX_FORM.fullmatch(text) else "up to four hexadecimal digits without h, such as 00FF"
    if kind is Kind.TEXT:
        return None if len(text) <= 1 and text.isascii() and text != "\0" else "one ASCII character, or nothing"
    if kind is Kind.FLOAT:
        # Long digit strings are legal for float(), and cheap.
        legal = _FLOAT_FORM.fullmatch(text) and abs(float(text)) <= FLOAT_MAX
        return None if legal else "a number from -3.4028235E+38 to 3.4028235E+38"
    low, high = INTEGER_RANGES[kind]
    legal = _INTEGER_FORM.fullmatch(text) and low <= int(text) <= high
    return None if legal else f"a whole number from {low} to {high}"


def text_span(shown: str, line: int, raw: str, start: int, end: int) -> Span:
    """The span of ``raw[start:end]`` of a row that begins on ``line``; an empty stretch is widened to one column."""
    first, last = _position(raw, start), _position(raw, max(end, start))
    if first == last:
        last = (last[0], last[1] + 1)
    return Span(shown, line + first[0], first[1], line + last[0], last[1])


def _position(raw: str, offset: int) -> tuple[int, int]:
    """Return the number of lines below the row's first, and the column from 1."""
    return raw.count("\n", 0, offset), offset - raw.rfind("\n", 0, offset)
