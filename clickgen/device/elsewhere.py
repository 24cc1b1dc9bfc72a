"""What banks and units of time are called on other machines: the one list for all who read text."""

from __future__ import annotations

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
"""What a bank is called in other machines."""
