"""Search (click-facts [search.forms, search.result])."""

from __future__ import annotations

from matrix.notation import (
    BANKS,
    READ,
    REGISTERS,
    Cell,
    Matrices,
    Operand,
    Takes,
    action,
    addresses,
    cell,
    cells,
    code,
    hexadecimal,
    integer,
    real,
    slot,
    span,
    text,
)

_CLASSES = {
    "decimal": "DS TD SD DD CTD DF integer real",
    "hexadecimal": "DH XD YD hex",
    "text": "TXT text code",
}
_CLASS = {kind: name for name, kinds in _CLASSES.items() for kind in kinds.split()}
_REGISTER = Takes(cells=REGISTERS, constants="integer hex real text code")
_WHOLE = "DS TD SD DD CTD"


def _search(value: Operand, bank: str, codes: str = "", operator: str = "==", is_range: bool = False) -> Cell:
    """Both ends are searched. ``is_range`` is the other spelling: a comparison of a range."""
    first, last, whole = cell(bank, 2), cell(bank, 7), span(bank, 2, 6)
    value_token = value.word if _CLASS.get(bank) == "hexadecimal" else value.token
    token = f"search({whole.token} {operator} {value_token},result=DS20,found=C5)"
    source = f'search("{operator}", {value.source}, {first.source}, {last.source}, ds[20], c[5])'
    if is_range:
        source = f"search({whole.source} {operator} {value.source}, result=ds[20], found=c[5])"
    return action(source, token, codes=codes)


def _found_in(value: Operand, bank: str, is_range: bool = False) -> str:
    """The codes of a value and the bank that is searched: both registers, and of one class.

    A search among bits says that they are bits, for each end or for the range, and no more; a value that is refused as
    one is not also of another kind.
    """
    ends = 1 if is_range else 2
    faults = [_REGISTER.fault(cell(bank, 2))] * ends + [_REGISTER.fault(value)]
    if any(faults):
        return " ".join(faults)
    if value.form == "integer" and _CLASS[bank] == "hexadecimal":
        return ""
    if _CLASS[value.kind] != _CLASS[bank]:
        return "CG303"
    return "CG302" if value.form == "real" and bank in _WHOLE.split() else ""


_VALUES = (integer(5), hexadecimal(0x00FF), real("1.5"), text("A"), text("AB"), code(0x0D))
_NO_CELLS = [operand for operand in addresses(READ) if operand.form != "cell"]


def _with(**changed: str) -> str:
    arguments = {"value": "5", "start": "ds[2]", "end": "ds[7]", "result": "ds[20]", "flag": "c[5]"} | changed
    return f'search("==", {", ".join(arguments.values())})'


_MIRRORED = {"==": "==", "!=": "!=", "<": ">", "<=": ">=", ">": "<", ">=": "<="}
_OPERATORS = {"==": "eq", "!=": "ne", "<": "lt", "<=": "le", ">": "gt", ">=": "ge"}


def _operators() -> list[Cell]:
    """Six operators, under two names each; for texts only the two that compare for equality."""
    cells = []
    for operator, word in _OPERATORS.items():
        text_fault = "" if operator in ("==", "!=") else "CG301"
        cells += [
            _search(cell("DS", 1), "DS", operator=operator),
            _search(cell("XD", 1), "DH", operator=operator),
            _search(cell("DS", 1), "DS", operator=operator, is_range=True),
            action(
                f"search(ds[1] {_MIRRORED[operator]} ds[2:8], result=ds[20], found=c[5])",
                f"search(DS2..DS7 {operator} DS1,result=DS20,found=C5)",
            ),
            _search(text("A"), "TXT", text_fault, operator),
            _search(cell("TXT", 1), "TXT", text_fault, operator),
            action(
                f'search("{word}", 5, dd[2], dd[7], ds[20], c[5])',
                f"search(DD2..DD7 {operator} 5,result=DS20,found=C5)",
            ),
        ]
    return [
        *cells,
        *(
            action(f"search({operator}, 5, dd[2], dd[7], ds[20], c[5])", codes="CG115")
            for operator in ('"="', '"<>"', '"equal"', '"EQ"', '""', "5", "c[1]", "eq")
        ),
    ]


_LIMITS = [
    *(_search(integer(value), "DS") for value in (-32768, 32767)),
    *(_search(integer(value), "DS", "CG302") for value in (-32769, 32768)),
    *(_search(integer(value), "DD") for value in (-(2**31), 2**31 - 1)),
    *(_search(integer(value), "DD", "CG302") for value in (-(2**31) - 1, 2**31)),
    *(_search(integer(value), "DH") for value in (0, 65535)),
    *(_search(integer(value), "DH", "CG302") for value in (65536, -1)),
    _search(hexadecimal(65536), "DH", "CG302"),
    *(_search(real(value), "DF", "CG302") for value in ("3.5e38", "1e-39")),
    *(_search(text(value), "TXT", "CG302") for value in ("", "\N{DEGREE SIGN}")),
    _search(code(0x80), "TXT", "CG302"),
    action(_with(start="ds[7]", end="ds[2]"), codes="CG306"),
    action(_with(end="dd[7]"), codes="CG306"),
    action(_with(end="ds[2]"), "search(DS2..DS2 == 5,result=DS20,found=C5)"),
    *(action(_with(value="0x05", start=f'{bank}["0u"]', end=f"{bank}[7]"), codes="CG301") for bank in ("xd", "yd")),
    action(_with(value="xd[1]", start="xd[0]", end="xd[8]"), "search(XD0..XD8 == XD1,result=DS20,found=C5)"),
]

_FLAGS = [
    action(_with(flag=f"c[5], {flags}"), f"search(DS2..DS7 == 5,result=DS20,found=C5{token})")
    for flags, token in (
        ("continuous=True", ",continuous=1"),
        ("oneshot=True", ",oneshot=1"),
        ("one_shot=True", ",oneshot=1"),
        ("oneshot=True, continuous=True", ",continuous=1,oneshot=1"),
        ("True, False", ",continuous=1"),
        ("continuous=False, oneshot=False", ""),
    )
]


def _result(operand: Operand) -> tuple[str, str]:
    return _with(result=operand.source), f"search(DS2..DS7 == 5,result={operand.token},found=C5)"


def _flag(operand: Operand) -> tuple[str, str]:
    return _with(flag=operand.source), f"search(DS2..DS7 == 5,result=DS20,found={operand.token})"


MATRICES: Matrices = {
    "search banks": [_search(value, bank, _found_in(value, bank)) for bank in BANKS for value in cells(READ)],
    "search constants": [_search(value, bank, _found_in(value, bank)) for bank in BANKS for value in _VALUES],
    "search of a range": [
        _search(value, bank, _found_in(value, bank, True), is_range=True)
        for bank in BANKS
        for value in (*cells(READ), *_VALUES)
    ],
    "search forms": [
        *(_search(operand, "DS", _REGISTER.fault(operand)) for operand in _NO_CELLS),
        *(action(_with(start=operand.source), codes=_REGISTER.fault(operand)) for operand in _NO_CELLS),
        *(action(_with(end=operand.source), codes=_REGISTER.fault(operand)) for operand in _NO_CELLS),
        *(action(_with(start=operand.source), codes="CG301") for operand in _VALUES),
        *(action(_with(end=operand.source), codes="CG301") for operand in _VALUES),
    ],
    "search result": slot(Takes(cells="DS", disputed="DD", is_written=True), _result),
    "search flag": slot(Takes(cells="C", is_written=True), _flag),
    "search operators": _operators(),
    "search limits": _LIMITS,
    "search flags": _FLAGS,
}
