"""Coils, shift registers, loops and calls (click-facts [coil.targets, control.for, shift.forms])."""

from __future__ import annotations

from matrix.notation import (
    CONSTANTS,
    DOUBTED_SC,
    WRITABLE_SC,
    WRITTEN,
    Cell,
    Matrices,
    Operand,
    Takes,
    action,
    addresses,
    hex_text,
    numbered,
    slot,
)

# -- coils ------------------------------------------------------------------------------------------------------------

_COIL = Takes(cells="Y C SC", ranges="Y C SC", immediates="Y", is_written=True)


def _coils(name: str, token: str) -> list[Cell]:
    """Every bank in every form, and every SC number."""
    return [
        *slot(_COIL, lambda operand: (f"{name}({operand.source})", f"{token}({operand.token})")),
        *(
            action(
                f"{name}(sc[{number}])",
                f"{token}(SC{number})",
                codes="" if number in WRITABLE_SC else "CG312" if number in DOUBTED_SC else "CG304",
            )
            for number in range(1, 1001)
        ),
        action(f"{name}(sc[65:68])", f"{token}(SC65..SC67)"),
        action(f"{name}(sc[51:54])", codes="CG304"),
        action(f"{name}(sc[49:52])", codes="CG304"),
        action(f"{name}(c[7:8])", f"{token}(C7)"),
        action(f"{name}(y[3:4].immediate)", f"{token}(immediate(Y003))"),
        # A range over the gap between two modules: unknown on CLICK (click-facts [bank.gap]).
        action(f"{name}(y[16:22])", codes="CG202"),
        action(f"{name}(c[8:0:-1])", codes="CG202"),
    ]


def _one_shots() -> list[Cell]:
    """A one-shot range is a coil for each bit; there is no one-shot immediate coil, and no one-shot set or reset."""
    found = [
        action("out(c[1:5], one_shot=True)", *(f"out(C{number},oneshot=1)" for number in (1, 2, 3, 4))),
        action("out(y[5], oneshot=False)", "out(Y005)"),
        action("out(y[5].immediate, oneshot=False)", "out(immediate(Y005))"),
        action("out(c[1:5], oneshot=False)", "out(C1..C4)"),
        *(action(f"{name}(y[5], oneshot=True)", codes="CG109") for name in ("set", "reset")),
    ]
    for operand in (*addresses(WRITTEN), *CONSTANTS):
        # One fault of an immediate C is enough to report.
        fault = _COIL.fault(operand) or ("CG313" if operand.form == "immediate" else "")
        bits = operand.token.split("..") if operand.form == "range" else [operand.token]
        found.append(
            action(f"out({operand.source}, oneshot=True)", *(f"out({bit},oneshot=1)" for bit in bits), codes=fault)
        )
    return found


# -- shift registers --------------------------------------------------------------------------------------------------

_SHIFTED = Takes(ranges="C", is_written=True)
_INPUTS = "clock=lambda: c[2], reset=lambda: c[3]"


def _shift(operand: Operand) -> tuple[str, ...]:
    return f"shift({operand.source}, {_INPUTS})", f"shift({operand.token})", "C2", ".clock()", "C3", ".reset()"


_SHIFTS = [
    *slot(_SHIFTED, _shift),
    action(f"shift(c[8:0:-1], {_INPUTS})", "shift(C8..C1)", "C2", ".clock()", "C3", ".reset()"),
    action("shift(c[1:9]).clock(c[2]).reset(c[3])", "shift(C1..C8)", "C2", ".clock()", "C3", ".reset()"),
    # A bare wire is no input (click-facts [grid.pin-contact]): a pin that is left out is never on.
    action("shift(c[1:9])", "shift(C1..C8)", "~SC1", ".clock()", "~SC1", ".reset()", codes="CG419"),
    action("shift(c[1:9], clock=lambda: c[10])", "shift(C1..C8)", "C10", ".clock()", "~SC1", ".reset()", codes="CG419"),
    action("shift(c[1:9], reset=lambda: c[10])", "shift(C1..C8)", "~SC1", ".clock()", "C10", ".reset()", codes="CG419"),
    action(f"shift(c[1:9], {_INPUTS}, oneshot=True)", codes="CG109"),
]

# -- loops and calls --------------------------------------------------------------------------------------------------

_COUNT = Takes(cells="DS", constants="integer")


def _loop(arguments: str, token: str = "", codes: str = "") -> Cell:
    source = f"for _ in range({arguments}):\n            if c[2]:\n                out(c[3])"
    return action(source, token, "C2", "out(C3)", "next()", codes=codes)


_LOOPS = [
    *(
        _loop(operand.source, f"for({operand.token})", _COUNT.fault(operand))
        for operand in (*addresses(numbered(3)), *CONSTANTS, hex_text(5))
    ),
    # A count of 0 or below: unknown on CLICK (click-facts [control.for-count]).
    *(_loop(str(value), codes="CG302") for value in (-32768, -1, 0, 32768)),
    *(_loop(str(value), f"for({value})") for value in (1, 32767)),
    *(_loop(f"ds[3], {word}=True", "for(DS3,oneshot=1)") for word in ("oneshot", "one_shot")),
    _loop("3, oneshot=False", "for(3)"),
    _loop("3, retentive=True", codes="CG109"),
    *(_loop(arguments, codes="CG119") for arguments in ("", "1, 3", "*c[3]")),
    *(_loop(arguments, codes="CG113") for arguments in ("n", "ds[1] + 1", "DS5", "True")),
]

_CALLS = [
    *(
        action(f"call({arguments})", 'call("auto")')
        for arguments in ("auto", '"auto"', "subroutine=auto", 'subroutine_name="auto"')
    ),
    # The name of a routine is also that of a file, and keeps its capital letters.
    *(action(f"call({name})", codes="CG405") for name in ("other", '"other"', "main", '"Auto"')),
    *(action(f"call({name})", codes="CG115") for name in ("5", "0x05", "1.5", "True", "auto()", "c[1]", "ds[ds[1]]")),
]

MATRICES: Matrices = {
    "out": _coils("out", "out"),
    "out oneshot": _one_shots(),
    "set": _coils("set", "latch"),
    "reset": _coils("reset", "reset"),
    "shift range": _SHIFTS,
    "for count": _LOOPS,
    "call": _CALLS,
}
