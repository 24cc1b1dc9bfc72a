"""Names of arguments, units of time, banks and members of a timer elsewhere."""

from __future__ import annotations

from clickgen.device.banks import BANKS as CLICK_BANKS

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

UNITS = {
    word: unit
    for words, unit in (
        ("tms ms msec msecs millisecond milliseconds", "Tms"),
        ("ts s sec secs second seconds tsec", "Ts"),
        ("tm m min mins minute minutes tmin", "Tm"),
        ("th h hr hrs hour hours thr", "Th"),
        ("td d day days tday", "Td"),
    )
    for word in words.split()
}
"""Units of time as people write them."""

BANKS = {
    word: bank
    for words, bank in (
        ("i in input inputs inp di", "x"),
        ("q o output outputs outp do", "y"),
        ("m b b3 cr mx bit bits flag relay coil memory", "c"),
        ("v n n7 d w vw mw reg register int ints data hr", "ds"),
        ("dint md vd dw long", "dd"),
        ("f f8 real float", "df"),
        ("h hex word words", "dh"),
        ("tim tmr t4 timer timers", "t"),
        ("cnt ctr c5 counter counters z", "ct"),
        ("str string st st9 text char", "txt"),
        ("sm s2 sys system sp", "sc"),
        ("iw", "xd"),
        ("qw", "yd"),
        ("tv", "td"),
        ("cv ctv", "ctd"),
    )
    for word in words.split()
}
"""The names of banks in other machines."""


def bank_hint(name: str, index: str = "") -> str:
    """The bank here for one of another machine, with the number if it fits; "" for any other word."""
    found = BANKS.get(name.lower())
    if found is None:
        return ""
    bank = CLICK_BANKS[found.upper()]
    number = int(index) if index.isascii() and index.isdigit() and len(index) < 6 else 0
    shown = number if bank.has(number) else bank.first
    return f"{bank.title} are in {bank.name}: write {bank.dsl}[{shown}], or {bank.dsl}.Name"


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
"""The members that people write after an address with a dot, and what they mean by them."""
