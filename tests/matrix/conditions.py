"""Contacts and comparisons.

click-facts [compare.classes, compare.pointers, compare.signs, contact.edges, contact.forms]
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from matrix.notation import (
    BITS,
    CONSTANTS,
    POINTED,
    READ,
    Cell,
    Matrices,
    Operand,
    addresses,
    cell,
    cells,
    condition,
    hex_text,
    integer,
    numbered,
    real,
    text,
)

# -- contacts ---------------------------------------------------------------------------------------------------------


def _series(operand: Operand, form: str) -> list[str]:
    """A range has no contact of its own: it is a series of its bits."""
    if ":" not in operand.source:
        return [form.format(operand.token)]
    bits = [cell(operand.bank, number).token for number in (1, 2)]
    return [form.format(f"immediate({bit})" if operand.form == "immediate" else bit) for bit in bits]


def _contacts(source: str, token: str, judge: Callable[[Operand], str]) -> list[Cell]:
    return [
        condition(source.format(operand.source), *_series(operand, token), codes=judge(operand))
        for operand in (*addresses(READ), *CONSTANTS)
        if not (operand.form == "cell" and operand.bank not in BITS.split() and source == "{}")
    ]


def _level(operand: Operand) -> str:
    """Normally open and normally closed: one bit or a range of bits; immediates only on X."""
    if operand.form == "pointer":
        return "CG307" if operand.bank in POINTED.split() else "CG213"
    if operand.bank not in BITS.split():
        return "CG107"
    return "CG308" if operand.form == "immediate" and operand.bank != "X" else ""


def _edge(operand: Operand) -> str:
    """Rising and falling: one bit, never immediate."""
    if operand.form == "immediate" and operand.bank in BITS.split():
        return "CG308"
    return _level(operand) or ("CG107" if operand.form == "range" else "")


# A register alone is "not zero"; the zero has the register's form.
_BARE = {
    **dict.fromkeys(("DS", "DD", "TD", "CTD", "SD"), "0"),
    **dict.fromkeys(("DH", "XD", "YD"), "0000h"),
    "DF": "0.0",
}
_BARE_REGISTERS = [
    *(condition(f"{bank.lower()}[1]", f"{bank}1!={zero}") for bank, zero in _BARE.items()),
    condition("txt[1]", codes="CG107"),
]

# -- comparisons ------------------------------------------------------------------------------------------------------

_CLASSES = {
    "decimal": "DS DD DF TD CTD SD integer real",
    "hexadecimal": "DH XD YD hex",
    "text": "TXT text code",
}
_CLASS = {kind: name for name, kinds in _CLASSES.items() for kind in kinds.split()}
_OPERATORS = ("==", "!=", "<", "<=", ">", ">=")


def _compare(left: Operand, right: Operand, operator: str = "==") -> Cell:
    """Values of one class; an integer beside a hexadecimal register is a word; constants alone compare nothing."""
    classes = [_CLASS.get(operand.kind, "bit") for operand in (left, right)]
    tokens = [left.token, right.token]
    if sorted(classes) == ["decimal", "hexadecimal"] and "integer" in (left.form, right.form):
        classes, tokens = ["hexadecimal", "hexadecimal"], [left.word, right.word]
    legal = classes[0] == classes[1] != "bit" and (left.bank or right.bank)
    source = f"{left.source} {operator} {right.source}"
    return condition(source, operator.join(tokens), codes="" if legal else "CG303")


def _no_value() -> Iterator[Cell]:
    """Ranges, pointers and immediates are not compared, on either side."""
    for operand in addresses(READ):
        if operand.form != "cell":
            fault = {"pointer": "CG307" if operand.bank in POINTED.split() else "CG213"}.get(operand.form, "CG107")
            yield condition(f"{operand.source} == ds[5]", codes=fault)
            yield condition(f"ds[5] == {operand.source}", codes=fault)


_LIMITS = [
    *(_compare(cell("DS", 1), integer(value)) for value in (-32768, 32767)),
    *(_compare(cell(bank, 1), integer(value)) for bank in ("DD", "CTD", "DF") for value in (-(2**31), 2**31 - 1)),
    _compare(cell("DH", 1), integer(65535)),
    _compare(hex_text(0x00FF), cell("DH", 1)),
    _compare(cell("DS", 1), hex_text(0x00FF)),
    *(condition(f"{bank}[1] == {value}", codes="CG302") for bank in ("ds", "td", "sd") for value in (-32769, 32768)),
    *(condition(f"{bank}[1] == {value}", codes="CG302") for bank in ("dd", "ctd") for value in (-(2**31) - 1, 2**31)),
    *(condition(f"{bank}[1] == {value}", codes="CG302") for bank in ("dh", "xd", "yd") for value in (65536, "0x10000")),
    *(condition(f"{bank}[1] == -1", codes="CG302") for bank in ("dh", "xd", "yd")),
    *(condition(f"df[1] == {value}", codes="CG302") for value in ("3.5e38", "-3.5e38", "1e-39")),
    condition('txt[1] == ""', codes="CG302"),
    *(condition(f'txt[1] == "{value}"', codes="CG302") for value in ("AB", "\N{DEGREE SIGN}", "00FFh")),
    condition('xd["0u"] == yd["0u"]', "XD0u==YD0u"),
    *(condition(f'txt[1] == "${value}"', codes="CG302") for value in ("80", "FF")),
]

MATRICES: Matrices = {
    "contact": [*_contacts("{}", "{}", _level), *_BARE_REGISTERS],
    "contact nc": _contacts("nc({})", "~{}", _level),
    "contact re": _contacts("re({})", "rise({})", _edge),
    "contact fe": _contacts("fe({})", "fall({})", _edge),
    "compare banks": [_compare(left, right) for left in cells(READ) for right in cells(numbered(2))],
    "compare constant right": [_compare(left, right) for left in cells(READ) for right in CONSTANTS],
    "compare constant left": [_compare(left, right) for left in CONSTANTS for right in cells(READ)],
    "compare constants": [_compare(left, right) for left in CONSTANTS for right in CONSTANTS],
    "compare operators": [
        _compare(left, right, operator)
        for operator in _OPERATORS
        for left, right in (
            (cell("DS", 1), cell("DF", 2)),
            (real("-2.5"), cell("CTD", 2)),
            (cell("DH", 1), cell("XD", 2)),
            (cell("YD", 1), integer(10)),
            (cell("TXT", 1), cell("TXT", 2)),
            (cell("TXT", 1), text("A")),
        )
    ],
    "compare forms": list(_no_value()),
    "compare limits": _LIMITS,
}
