"""Timers and counters (click-facts [counter.forms, counter.setpoint, timer.setpoint])."""

from __future__ import annotations

from matrix.notation import (
    CONSTANTS,
    Cell,
    Matrices,
    Operand,
    Takes,
    action,
    addresses,
    cell,
    code,
    hex_text,
    hexadecimal,
    integer,
    numbered,
    real,
    text,
)

_TIMERS = {"ton": "on_delay", "tof": "off_delay", "rton": "on_delay", "rtof": "on_delay"}
_TIMER = Takes(cells="T")
_TIMER_SETPOINT = Takes(cells="DS")
_TIMER_LIMITS = {-32768: "CG302", -1: "CG302", 0: "", 32767: "", 32768: "CG302", 2**31: "CG302"}
_UNITS = ("Tms", "Ts", "Tm", "Th", "Td")

_COUNTERS = {"ctu": "count_up", "ctd": "count_down", "ctud": "count_up"}
_COUNTER = Takes(cells="CT")
_COUNTER_SETPOINT = Takes(cells="DS DD")
_COUNTER_LIMITS = {-(2**31) - 1: "CG302", -(2**31): "", -1: "", 0: "", 2**31 - 1: "", 2**31: "CG302"}

_NO_SETPOINTS = (hexadecimal(5), hex_text(5), real("1.5"), real("5.0"), text("A"), text("5"), code(0x0D))


def _timer(name: str, timer: Operand, setpoint: Operand, codes: str = "", unit: str = "") -> Cell:
    """The retentive ones have a reset. rtof does not exist: a note says it is a retentive on-delay and two bits."""
    number = timer.token.lstrip("T")
    tokens = [f"{_TIMERS[name]}(T{number},TD{number},preset={setpoint.token},unit={unit or 'Tms'})"]
    arguments = [timer.source, setpoint.source, *([unit] if unit else [])]
    if name in ("rton", "rtof"):
        arguments.append("reset=lambda: c[2]")
        tokens += ["C2", ".reset()"]
    if name == "rtof":
        tokens = ["out(C?)", "~C?", *tokens, "C?", "out(C?)", "C?", f"~T{number}"]
        codes = codes or "CG420"
    return action(f"{name}({', '.join(arguments)})", *tokens, codes=codes)


def _timer_matrices(name: str) -> Matrices:
    """One timer number has one owner, so each rung has its own."""
    setpoints = [*addresses(numbered(3)), *_NO_SETPOINTS]
    wrong_units = ("ts", "Tus", '"Ts"', "5", "True", "c[5]")
    return {
        # An operand that is refused as a timer owns no number.
        f"{name} timer": [
            _timer(name, operand, integer(5), _TIMER.fault(operand))
            for operand in (*addresses(numbered(3)), *CONSTANTS)
        ],
        f"{name} setpoint": [
            *(
                _timer(name, cell("T", number), operand, _TIMER_SETPOINT.fault(operand))
                for number, operand in enumerate(setpoints, 101)
            ),
            *(
                _timer(name, cell("T", number), integer(value), fault)
                for number, (value, fault) in enumerate(_TIMER_LIMITS.items(), 301)
            ),
        ],
        f"{name} unit": [
            _timer(name, cell("T", number), integer(5), "" if unit in _UNITS else "CG115", unit)
            for number, unit in enumerate((*_UNITS, *wrong_units), 1)
        ],
    }


def _counter(name: str, counter: Operand, setpoint: Operand, codes: str = "", is_reset: bool = True) -> Cell:
    """A bare wire is no input (click-facts [grid.pin-contact]): a reset that is left out is never on."""
    tokens = [f"{_COUNTERS[name]}({counter.token},CTD{counter.token.lstrip('CT')},preset={setpoint.token})"]
    arguments = [counter.source, setpoint.source]
    if name == "ctud":
        arguments.append("count_down=lambda: c[3]")
        tokens += ["C3", ".down()"]
    if is_reset:
        arguments.append("reset=lambda: c[2]")
    return action(f"{name}({', '.join(arguments)})", *tokens, "C2" if is_reset else "~SC1", ".reset()", codes=codes)


def _counter_matrices(name: str) -> Matrices:
    setpoints = [*addresses(numbered(3)), *_NO_SETPOINTS]
    return {
        # An operand that is refused as a counter owns no number.
        f"{name} counter": [
            *(
                _counter(name, operand, integer(5), _COUNTER.fault(operand))
                for operand in (*addresses(numbered(3)), *CONSTANTS)
            ),
            _counter(name, cell("CT", 250), integer(5), "CG418", is_reset=False),
        ],
        f"{name} setpoint": [
            *(
                _counter(name, cell("CT", number), operand, _COUNTER_SETPOINT.fault(operand))
                for number, operand in enumerate(setpoints, 101)
            ),
            *(
                _counter(name, cell("CT", number), integer(value), fault)
                for number, (value, fault) in enumerate(_COUNTER_LIMITS.items(), 201)
            ),
        ],
    }


_CHAINS = [
    action("rton(t[1], 5).reset(c[2])", "on_delay(T1,TD1,preset=5,unit=Tms)", "C2", ".reset()"),
    action("ctu(ct[1], 5).reset(c[2])", "count_up(CT1,CTD1,preset=5)", "C2", ".reset()"),
    action("ctd(ct[2], 5).reset(c[2])", "count_down(CT2,CTD2,preset=5)", "C2", ".reset()"),
    action("ctud(ct[3], 5).down(c[3]).reset(c[2])", "count_up(CT3,CTD3,preset=5)", "C3", ".down()", "C2", ".reset()"),
    # Inputs that do not exist: a reset on ton and tof, an input down on ctu and ctd (click-facts [counter.forms]).
    *(action(f"{name}(t[4], 5).reset(c[2])", codes="CG109") for name in ("ton", "tof")),
    *(action(f"{name}(ct[4], 5).down(c[3]).reset(c[2])", codes="CG109") for name in ("ctu", "ctd")),
    *(
        action(f"{call}, {word}=True)", codes="CG109")
        for call in ("ton(t[4], 5", "tof(t[4], 5", "rton(t[4], 5, reset=lambda: c[2]", "ctu(ct[4], 5", "ctd(ct[4], 5")
        for word in ("oneshot", "one_shot")
    ),
]

MATRICES: Matrices = {
    **{title: cells for name in _TIMERS for title, cells in _timer_matrices(name).items()},
    **{title: cells for name in _COUNTERS for title, cells in _counter_matrices(name).items()},
    "timer and counter inputs": _CHAINS,
}
