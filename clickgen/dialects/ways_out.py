"""Ways out for what no program writes: inputs, bits of timers and counters, CLICK's own points."""

from __future__ import annotations

import re

from clickgen.device.system import WRITABLE_SD, system_nicknames
from clickgen.dialects.base import Spelling
from clickgen.instructions.offered import COPY, CTU, RTON, TON
from clickgen.instructions.spec import Spec

_CLOCK = re.compile(r"_RTC_(?!New_)", re.IGNORECASE)
_COILS = ("set", "reset", "out")


def instead_of(
    spell: Spelling,
    bank: str,
    shown: str,
    action: Spec,
    value: str = "",
    name: str = "",
    owners: frozenset[str] = frozenset(),
) -> str:
    """What to write in the place of an address that nothing writes. It is shown as the program writes it.

    ``action`` is the instruction that is to write it, and ``value`` the number or address that a copy has for it.
    ``owners`` are the instructions of a timer, where they are known.
    """
    if bank in ("T", "CT"):
        if action.name not in ("set", "out"):
            return reset_hint(spell, bank, shown, owners)
        bit = spell.call(action, spell.name("C", "Name"))
        what = "timer" if bank == "T" else "counter"
        return f"its {what} alone turns it on, {counting(spell, bank, shown)}; turn on a bit of the program, {bit}"

    def written(to: str) -> str:
        if action.name in _COILS:
            return spell.call(action, spell.name(to, "Name"))
        return spell.call(COPY, value or spell.name("C", "A"), spell.name(to, "Name"))

    if bank == "X":
        output, bit = written("Y"), written("C")
        return f"an input follows its terminal; write an output, {output}, or a bit of the program, {bit}"
    if bank == "SC":
        return f"write a bit of the program: {written('C')}"
    if bank == "XD":
        copy = spell.call(COPY, value or shown, spell.name("DH", "Name"))
        return f"an input word follows its terminals; write a register of the program: {copy}"
    new = system_nicknames().get(_CLOCK.sub("_RTC_New_", name).lower()) if _CLOCK.match(name) else None
    if new is not None and new[1].number in WRITABLE_SD:
        text = spell.name("SD", new[0])
        copy = spell.call(COPY, value or "0", text)
        return f"CLICK's clock shows its time there; what it is set to goes to {text}: {copy}"
    return f"write a register of the program: {spell.call(COPY, value or '0', spell.name('DS', 'Name'))}"


def counting(spell: Spelling, bank: str, shown: str) -> str:
    """The instruction that makes a timer or a counter count."""
    if bank == "T":
        return spell.call(TON, shown, setpoint="5", unit="Ts")
    box, clear = spell.call(CTU, shown, setpoint="10"), spell.name("C", "Clear")
    chained = spell.chained("reset", clear)
    return f"{box}{chained}" if chained else with_reset(spell, CTU, shown, "10")


def with_reset(spell: Spelling, box: Spec, shown: str, setpoint: str, unit: str = "") -> str:
    """A box with an input for its reset."""
    texts = [shown, spell.setting("setpoint", setpoint), *([spell.setting("unit", unit)] if unit else [])]
    return spell.call(box, *texts, spell.pin("reset", spell.name("C", "Clear")))


def reset_hint(spell: Spelling, bank: str, shown: str, owners: frozenset[str] = frozenset()) -> str:
    """How a timer or a counter is reset: ``reset(t.A)`` does not do it. ``owners`` are its instructions, if known."""
    if bank in ("CT", "CTD"):
        return f"a counter has an input for its reset: {with_reset(spell, CTU, shown, '10')}"
    retentive = with_reset(spell, RTON, shown, "5", "Ts")
    if owners == {"tof"}:
        return f"a tof is reset when its rung comes on; a retentive timer has an input for it: {retentive}"
    plain = "" if owners <= {"ton", "rton"} and owners else ", a tof when it comes on"
    return f"a ton is reset when its rung goes off{plain}; a retentive timer has an input for it: {retentive}"
