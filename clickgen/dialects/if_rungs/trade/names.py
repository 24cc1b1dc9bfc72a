"""What arguments and members of a timer are called elsewhere; ``device/elsewhere.py`` has banks and units."""

from __future__ import annotations

from clickgen.formula.spelling import SPELL
from clickgen.ir.addresses import AddressReader

ARGUMENTS = {
    word: name
    for words, name in (
        ("preset pre pt pv sp time delay limit duration setpt set_point goal period", "setpoint"),
        ("timebase time_base base tb", "unit"),
        ("r res rst clear clr reset_input", "reset"),
        ("cd down countdown", "count_down"),
        ("clk clock_bit trigger", "clock"),
        ("src from_ input s", "source"),
        ("dst dest to target d result output", "destination"),
        ("os ons one_shot oneshoot pulse edge", "oneshot"),
        ("expr expression", "formula"),
        ("sub name routine", "subroutine"),
        ("initial_value init value default start", "initial"),
        ("retain retained keep persistent", "retentive"),
        ("description desc note text", "comment"),
        ("acc accumulator_td", "accumulator"),
        ("done done_bit complete completion", "completion_flag"),
        ("step", "current_step"),
    )
    for word in words.split()
}
"""The names of arguments elsewhere, and here."""

MEMBERS = {
    word: kind
    for words, kind in (
        ("done dn q qu output out bit done_bit status is_done on is_on state value_bit", "bit"),
        ("finished expired elapsed_bit timed_out timedout", "expired"),
        ("acc accum accumulator et cv current value val count elapsed elapsed_time current_value present", "current"),
        ("pre preset pt pv sp setpoint", "setpoint"),
        ("en in_ enabled enable ena cu cd", "enabled"),
        ("tt timing running active busy", "timing"),
        ("res reset rst clear", "reset"),
        ("off is_off not_ inverted nc negated", "off"),
        ("rise rising re pos edge r_trig pressed", "rising"),
        ("fall falling fe neg f_trig released", "falling"),
        ("imm im i now", "immediate"),
    )
    for word in words.split()
}
"""What people write behind an address with a dot, and what they mean by it."""


def bank_hint(name: str, index: str = "") -> str:
    """What a bank of another machine is here, with the number where it fits; "" for a word that is none."""
    is_number = index.isascii() and index.isdigit() and len(index) < 6
    return AddressReader(SPELL).foreign_bank(name, int(index) if is_number else 0)
