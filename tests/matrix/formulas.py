"""Formulas: what calc and math_hex read, calculate and write (click-facts [math.functions, math.operators])."""

from __future__ import annotations

from collections.abc import Iterator

from matrix.notation import (
    BANKS,
    BITS,
    POINTED,
    READ,
    WRITABLE_SD,
    Cell,
    Matrices,
    Operand,
    Takes,
    action,
    address,
    cell,
    immediate,
    pointer,
    slot,
    span,
)

_DECIMAL = "DS TD SD DD CTD DF"
_HEX = "DH XD YD"
_BANKS = {"calc": _DECIMAL, "math_hex": _HEX}
_TARGETS = {"calc": (_DECIMAL, "DS5", "decimal"), "math_hex": ("DH", "DH5", "hex")}
_KEPT_IN = {"XD": "DH", "YD": "DH", "TD": "DS", "CTD": "DD"}
"""Banks that have no register to spare, and the bank of the same kind that has one."""
_ONE = {"calc": ("1", "1"), "math_hex": ("0x01", "01h")}


def _formula(name: str, formula: str, token: str, codes: str = "", copied: str = "", ending: str = "") -> Cell:
    """``copied`` are the arguments of the copy to a scratch register that comes first, in the same rung."""
    _, target, mode = _TARGETS[name]
    oneshot = ",oneshot=1" if ending else ""
    return action(
        f"{name}({formula!r}, {target[:2].lower()}[5]{ending})",
        *([f"copy({copied}{oneshot})"] if copied else []),
        f"math({token},{target},mode={mode}{oneshot})",
        codes=codes,
    )


def _wrong_kind(name: str, bank: str) -> str:
    """Bits and text are not numbers; hexadecimal and decimal do not mix."""
    if bank in f"{BITS} TXT".split():
        return "CG301"
    return "" if bank in _BANKS[name].split() else "CG309"


def _operands(name: str) -> Iterator[Cell]:
    """XD, YD and pointers are lowered to a register of the same kind: CLICK's formulas read no such operand."""
    one, one_token = _ONE[name]
    for ending in ("", ", oneshot=True"):
        for bank in BANKS:
            plain, behind, kept = cell(bank, READ[bank]), pointer(bank, 9), f"{_KEPT_IN.get(bank, bank)}?"
            fault = _wrong_kind(name, bank)
            copied = f"{plain.token},{kept}" if bank in ("XD", "YD") else ""
            shown = kept if copied else plain.token
            yield _formula(name, f"{plain.source} + {one}", f"{shown} + {one_token}", fault, copied, ending)
            if bank not in POINTED.split():
                fault = "CG213"
            copied = f"{behind.token},{kept}"
            yield _formula(name, f"{behind.source} + {one}", f"{kept} + {one_token}", fault, copied, ending)
    for bank in ("XD", "YD"):
        if name == "math_hex":
            yield _formula(name, f'{bank.lower()}["0u"] + {one}', f"DH? + {one_token}", "", f"{bank}0u,DH?")
    for bank in BANKS:
        for point in (immediate(cell(bank, 1)), immediate(span(bank, 1, 2)), span(bank, 1, 2)):
            yield _formula(name, f"{point.source} + {one}", "", "CG116")


def _sums(name: str) -> Iterator[Cell]:
    """SUM adds up a range; it cannot add XD and YD words, because they are not operands."""
    for bank in BANKS:
        whole = span(bank, READ[bank], 4)
        fault = _wrong_kind(name, bank) or ("CG301" if bank in ("XD", "YD") else "")
        ends = f"{address(bank, READ[bank])} : {address(bank, READ[bank] + 3)}"
        yield _formula(name, f"SUM({whole.source})", f"SUM ( {ends} )", fault)
    bank = _BANKS[name].split()[0]
    for wrong in (f"{bank.lower()}[1]", f"{bank.lower()}[1], {bank.lower()}[2]", "1"):
        yield _formula(name, f"SUM({wrong})", "", "CG116")


def _target(name: str, operand: Operand) -> tuple[str, str]:
    _, _, mode = _TARGETS[name]
    one, token = _ONE[name]
    return f'{name}("{one}", {operand.source})', f"math({token},{operand.token},mode={mode})"


def _targets(name: str) -> list[Cell]:
    """The destination of a formula; in SD only writable ones."""
    numbers = (1, 28, *WRITABLE_SD, 30, 148, 216, 1000) if name == "calc" else ()
    return [
        *slot(Takes(cells=_TARGETS[name][0], is_written=True), lambda operand: _target(name, operand)),
        *(
            action(*_target(name, cell("SD", number)), codes="" if number in WRITABLE_SD else "CG304")
            for number in numbers
        ),
    ]


# -- constants --------------------------------------------------------------------------------------------------------

# The constants seen of CLICK begin with a digit, or have all four.
_HEX_CONSTANTS = {
    "5": "5h",
    "0x05": "05h",
    "0x0005": "0005h",
    "0x00005": "0005h",
    "0x1F": "1Fh",
    "5A68h": "5A68h",
    "0xA": "000Ah",
    "0x0FF": "0FFh",
    "0xFF": "00FFh",
    "FFh": "00FFh",
    "0xFFFF": "FFFFh",
}
_CONSTANTS = [
    *(_formula("calc", f"ds[1] + {value}", f"DS1 + {value}") for value in ("5", "1.5", "2147483647", "100000.0")),
    *(_formula("calc", f"ds[1] + {value}", "", "CG302") for value in ("2147483648", "3.5e38", "1e-39")),
    *(_formula("calc", f"ds[1] + {value}", "", "CG309") for value in ("0x05", "05h", "5A68h")),
    *(_formula("calc", f"ds[1] + {value}", "", "CG116") for value in ('"A"', '"$0D"', "$0D")),
    *(_formula("math_hex", f"dh[1] + {value}", f"DH1 + {token}") for value, token in _HEX_CONSTANTS.items()),
    *(
        _formula("math_hex", f"dh[1] + {value}", f"DH1 + {token}", "CG315")
        for value, token in (("10", "000Ah"), ("16", "10h"), ("255", "00FFh"), ("65535", "FFFFh"))
    ),
    *(_formula("math_hex", f"dh[1] + {value}", "", "CG302") for value in ("1.5", "65536", "0x10000")),
    *(_formula("math_hex", f"dh[1] + {value}", "", "CG116") for value in ('"A"', '"$0D"', "$0D")),
]

# -- operators and functions ------------------------------------------------------------------------------------------


def _words() -> Iterator[Cell]:
    for operator in ("+", "-", "*", "/", "^", "MOD"):
        yield _formula("calc", f"ds[1]{operator:^5}ds[2]", f"DS1 {operator} DS2")
    for operator in ("+", "-", "*", "/", "MOD", "AND", "OR", "XOR"):
        yield _formula("math_hex", f"dh[1]{operator:^5}dh[2]", f"DH1 {operator} DH2")
    for function in ("SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN", "LOG", "LN", "SQRT", "RAD", "DEG"):
        for spelt in (function, function.lower()):
            yield _formula("calc", f"{spelt}(df[1])", f"{function} ( DF1 )")
        yield _formula("math_hex", f"{function}(dh[1])", "", "CG117")
        yield _formula("calc", f"{function}(df[1], df[2])", "", "CG116")
    yield _formula("calc", "2*PI", "2 * PI")
    yield _formula("math_hex", "dh[1] + PI", "", "CG117")
    for written_as, function in (("LSH", "LSH"), ("RSH", "RSH"), ("LRO", "LRO"), ("RRO", "RRO"), *_SHIFTS):
        yield _formula("math_hex", f"{written_as}(dh[1], 4)", f"{function} ( DH1 , 4h )")
        yield _formula("math_hex", f"dh[1] {written_as} 4", f"{function} ( DH1 , 4h )")
        yield _formula("math_hex", f"{written_as}(dh[1])", "", "CG116")
        yield _formula("calc", f"{written_as}(ds[1], 4)", "", "CG117")
    for operator in ("AND", "OR", "XOR"):
        yield _formula("calc", f"ds[1] {operator} ds[2]", "", "CG117")
    yield _formula("calc", "NOT ds[1]", "", "CG117")
    yield _formula("math_hex", "dh[1] ^ dh[2]", "", "CG117")
    # NOT does not exist on CLICK, and a minus in front of an operand is not captured.
    yield _formula("math_hex", "NOT dh[1]", "DH1 XOR FFFFh")
    yield _formula("calc", "-ds[1]", "0 - DS1")
    yield _formula("math_hex", "-dh[1]", "0h - DH1")
    yield _formula("calc", "( ds[181]*10 )+2991", "( DS181 * 10 ) + 2991")
    yield _formula("calc", "SQRT(ds[1]+ds[2])", "SQRT ( DS1 + DS2 )")
    for function in ("ABS", "EXP", "MIN", "MAX", "ROUND"):
        yield _formula("calc", f"{function}(ds[1])", "", "CG117")


_SHIFTS = (("SHL", "LSH"), ("SHR", "RSH"))


def _limits() -> Iterator[Cell]:
    """8 nested parentheses and 68 operands."""
    for depth, fault in ((8, ""), (9, "CG310")):
        yield _formula("calc", "(" * depth + "ds[1]" + ")" * depth, "( " * depth + "DS1" + " )" * depth, fault)
    for depth, fault in ((7, ""), (8, "CG310")):
        yield _formula(
            "calc", "(" * depth + "SQRT(ds[1])" + ")" * depth, "( " * depth + "SQRT ( DS1 )" + " )" * depth, fault
        )
    for count, fault in ((68, ""), (69, "CG311")):
        yield _formula("calc", " + ".join(["ds[1]"] * count), " + ".join(["DS1"] * count), fault)


MATRICES: Matrices = {
    **{f"{name} operands": list(_operands(name)) for name in _BANKS},
    **{f"{name} sum": list(_sums(name)) for name in _BANKS},
    **{f"{name} destination": _targets(name) for name in _BANKS},
    "formula constants": _CONSTANTS,
    "formula words": list(_words()),
    "formula limits": list(_limits()),
}
