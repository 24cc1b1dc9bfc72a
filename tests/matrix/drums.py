"""Drum sequencers (click-facts [drum.inputs, drum.lists, drum.presets, drum.registers])."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from matrix.notation import (
    BITS,
    CONSTANTS,
    READ,
    WRITTEN,
    Cell,
    Matrices,
    Operand,
    Takes,
    action,
    addresses,
    cell,
    hexadecimal,
    integer,
    real,
    span,
)

_STEPS = {"event_drum": "events", "time_drum": "presets"}
_OUTPUTS = Takes(cells="Y C", is_written=True)
_ENDS = {"event_drum": Takes(cells=BITS), "time_drum": Takes(disputed="DS", constants="integer")}

Shown = tuple[str, str]
"""An argument in the source and in the token."""


def _one(operand: Operand) -> Shown:
    return operand.source, operand.token


def _listed(*operands: Operand) -> Shown:
    """In a list, a slice means each of its addresses."""
    tokens: list[str] = []
    for operand in operands:
        tokens += [bit.token for bit in _bits(operand)] if operand.form == "range" else [operand.token]
    return f"[{', '.join(operand.source for operand in operands)}]", f"[{','.join(tokens)}]"


def _bits(operand: Operand) -> list[Operand]:
    first, last = (int(end) for end in operand.source.strip("]").partition("[")[2].split(":"))
    return [cell(operand.bank, number) for number in range(first, last)]


def _pattern(height: int, width: int) -> Shown:
    row = f"[{','.join(['1'] * width)}]"
    rows = f"[{','.join([row] * height)}]"
    return rows, rows


_RESET = ("reset=lambda: c[2]", "C2", ".reset()")


def _drum(name: str, number: int, codes: str = "", pins: Sequence[str] = _RESET, **changed: Shown) -> Cell:
    """One output and one step, except for the changes. A time drum's accumulator is a timer's and has one owner."""
    arguments: dict[str, Shown] = {
        "outputs": _listed(cell("C", 5)),
        **(
            {"events": _listed(cell("C", 7))}
            if name == "event_drum"
            else {"presets": _listed(integer(5)), "unit": ("Ts", "Ts")}
        ),
        "pattern": _pattern(1, 1),
        "current_step": _one(cell("DS", 5)),
        **({} if name == "event_drum" else {"accumulator": _one(cell("TD", number))}),
        "completion_flag": _one(cell("C", 6)),
    } | changed
    inside = ", ".join(f"{key}={value}" for key, (value, _) in arguments.items())
    token = ",".join(f"{key}={value}" for key, (_, value) in arguments.items())
    return action(f"{name}({inside}, {pins[0]})", f"{name}({token})", *pins[1:], codes=codes)


def _lists(name: str, argument: str, takes: Takes) -> Iterator[Cell]:
    """Each form alone in the list; a slice of two needs two places in the pattern, and has its fault once."""
    numbers = WRITTEN if takes.is_written else READ
    for n, operand in enumerate((*addresses(numbers), *CONSTANTS, hexadecimal(5), real("5.0")), 1):
        count = 2 if operand.form == "range" else 1
        fault = takes.fault(_bits(operand)[0] if operand.form == "range" else operand)
        if operand.form == "immediate":
            fault = "CG308"
        pattern = _pattern(1, count) if argument == "outputs" else _pattern(count, 1)
        yield _drum(name, n, fault, pattern=pattern, **{argument: _listed(operand)})


def _single(name: str, argument: str, takes: Takes) -> Iterator[Cell]:
    # CT and CTD share their numbers, as T and TD do; the addresses of an accumulator have one owner.
    numbers = WRITTEN if takes.is_written else READ | {"T": 2, "CT": 3, "TD": 4, "CTD": 5}
    for n, operand in enumerate((*addresses(numbers), *CONSTANTS), 101):
        yield _drum(name, n, takes.fault(operand), **{argument: _one(operand)})


def _sizes(name: str) -> Iterator[Cell]:
    """1 to 16 outputs and steps, and a pattern with a row for each step and a place in it for each output."""
    steps = _STEPS[name]

    def listed(count: int) -> Shown:
        if steps == "presets":
            return _listed(*(integer(number) for number in range(count)))
        return _listed(*(cell("C", 100 + number) for number in range(count)))

    for n, count in enumerate((0, 1, 2, 15, 16, 17), 300):
        fault = "" if 1 <= count <= 16 else "CG316"
        outputs = _listed(span("C", 201, count)) if count else ("[]", "[]")
        yield _drum(name, n, fault, outputs=outputs, pattern=_pattern(1, count))
        yield _drum(name, n + 20, fault, pattern=_pattern(count, 1), **{steps: listed(count)})
        if count:
            yield _drum(
                name,
                n + 40,
                fault and "CG316 CG316",
                outputs=outputs,
                pattern=_pattern(count, count),
                **{steps: listed(count)},
            )
    for n, (height, width) in enumerate(((0, 1), (2, 1), (1, 2), (1, 0)), 400):
        yield _drum(name, n, "CG316", pattern=_pattern(height, width))
    yield _drum(name, 404, "CG316", outputs=_listed(cell("C", 5), cell("C", 5)), pattern=_pattern(1, 2))
    for n, value in enumerate((-1, 32768), 405):
        if steps == "presets":
            yield _drum(name, n, "CG302", presets=_listed(integer(value)))
    for n, value in enumerate((0, 32767), 407):
        if steps == "presets":
            yield _drum(name, n, presets=_listed(integer(value)))


def _units() -> Iterator[Cell]:
    for n, unit in enumerate(("Tms", "Ts", "Tm", "Th", "Td"), 1):
        yield _drum("time_drum", n, unit=(unit, unit))
    for unit in ("ts", '"Ts"', "5"):
        yield _drum("time_drum", 10, "CG115", unit=(unit, unit))


def _pins(name: str) -> Iterator[Cell]:
    """Reset, jump and jog in this order; a step to jump to is a DS register, and a number is copied to one first."""
    takes = Takes(cells="DS", constants="integer")
    for n, operand in enumerate((*addresses(READ), *CONSTANTS), 1):
        if operand.form == "integer":
            continue
        pins = (
            f"reset=lambda: c[2], jump=lambda: c[3], jump_step={operand.source}, jog=lambda: c[4]",
            *("C2", ".reset()", "C3", f".jump({operand.token})", "C4", ".jog()"),
        )
        yield _drum(name, n, takes.fault(operand), pins)
    yield _drum(name, 200, "", ("reset=lambda: c[2], jog=lambda: c[4]", "C2", ".reset()", "C4", ".jog()"))
    chain = (
        "reset=lambda: c[2]).jump(c[3], step=ds[5]).jog(c[4]",
        *("C2", ".reset()", "C3", ".jump(DS5)", "C4", ".jog()"),
    )
    yield _drum(name, 210, "", chain)
    yield _drum(name, 201, "CG110", ("reset=lambda: c[2], jump=lambda: c[3]",))
    yield _drum(name, 202, "CG110", ("reset=lambda: c[2], jump_step=ds[3]",))
    yield _drum(name, 203, "CG110", ("jog=lambda: c[4]",))
    for n, (step, fault) in enumerate(((0, "CG302"), (-1, "CG302"), (2, "CG316"), (17, "CG302")), 204):
        yield _drum(name, n, fault, (f"reset=lambda: c[2], jump=lambda: c[3], jump_step={step}",))


def _matrices(name: str) -> Matrices:
    found = {
        f"{name} outputs": list(_lists(name, "outputs", _OUTPUTS)),
        f"{name} {_STEPS[name]}": list(_lists(name, _STEPS[name], _ENDS[name])),
        f"{name} current_step": list(_single(name, "current_step", Takes(cells="DS", is_written=True))),
        f"{name} completion_flag": list(_single(name, "completion_flag", Takes(cells="C", is_written=True))),
        f"{name} sizes": list(_sizes(name)),
        f"{name} inputs": list(_pins(name)),
    }
    if name == "time_drum":
        found[f"{name} accumulator"] = list(_single(name, "accumulator", Takes(cells="TD")))
        found[f"{name} unit"] = list(_units())
    return found


MATRICES: Matrices = {**_matrices("event_drum"), **_matrices("time_drum")}
