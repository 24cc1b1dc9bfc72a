"""What is written as a condition elsewhere."""

from __future__ import annotations

from clickgen.trade.advice import BEFORE, EDGE, table

CONDITIONS = table(
    (
        "xic ld lod load str no examine_on normally_open",
        "write {}: a normally open contact is the bit alone",
        ("c.A",),
        "$1",
    ),
    (
        "xio ldi ldn ldnot strn examine_off normally_closed",
        "write {}: a normally closed contact",
        ("nc(c.A)",),
        "nc($1)",
    ),
    ("not inv inverse negate is_off", "write {}: a normally closed contact", ("nc(c.A)",), "nc($1)"),
    ("and all_of allof every series", "write {}: conditions in series", ("all(c.A, c.B)",), "all($*)"),
    ("or any_of anyof some parallel", "write {}: conditions in parallel", ("any(c.A, c.B)",), "any($*)"),
    ("andn ani andnot", "write {}: a normally closed contact in series", ("all(c.A, nc(c.B))",), "all($1, nc($2))"),
    ("orn ori ornot", "write {}: a normally closed contact in parallel", ("any(c.A, nc(c.B))",), "any($1, nc($2))"),
    ("nand", "write {}: not both", ("any(nc(c.A), nc(c.B))",), "any(nc($1), nc($2))"),
    ("nor none none_of", "write {}: none of them", ("all(nc(c.A), nc(c.B))",), "all(nc($1), nc($2))"),
    (
        "xor",
        "write {}: one of the two, but not both",
        ("any(all(c.A, nc(c.B)), all(nc(c.A), c.B))",),
        "any(all($1, nc($2)), all(nc($1), $2))",
    ),
    (
        "rise rising rising_edge r_trig rtrig r_edge ldp posedge pos_edge strpd on_edge oneshot_rising",
        "write {}: a rising edge",
        ("re(c.A)",),
        "re($1)",
    ),
    (
        "fall falling falling_edge f_trig ftrig f_edge ldf negedge neg_edge strnd off_edge oneshot_falling",
        "write {}: a falling edge",
        ("fe(c.A)",),
        "fe($1)",
    ),
    ("ons osr os oneshot one_shot osri dif difu pls", EDGE, ("re(c.A)", "out(c.Pulse, oneshot=True)"), ""),
    ("osf osfi difd plf", "a one-shot at the end of a signal is a falling edge in the condition: {}", ("fe(c.A)",), ""),
    ("equ eq eql equal cmp compare", "write {}: a comparison has its sign", ("ds.A == 5",), "$1 == $2"),
    ("neq ne nequ", "write {}: a comparison has its sign", ("ds.A != 5",), "$1 != $2"),
    ("grt gt grtr greater", "write {}: a comparison has its sign", ("ds.A > 5",), "$1 > $2"),
    ("geq ge grq", "write {}: a comparison has its sign", ("ds.A >= 5",), "$1 >= $2"),
    ("les lt less", "write {}: a comparison has its sign", ("ds.A < 5",), "$1 < $2"),
    ("leq le", "write {}: a comparison has its sign", ("ds.A <= 5",), "$1 <= $2"),
    (
        "lim in_range inrange between within",
        "write {}: a value between two limits",
        ("all(1 <= ds.A, ds.A <= 5)",),
        "all($1 <= $2, $2 <= $3)",
    ),
    (
        "meq mequ",
        "CLICK has no masked comparison: write {} in a rung before, and compare the result: {}",
        ('math_hex("dh.A AND 0x000F", dh.Masked)', "dh.Masked == 0x0001"),
        "",
    ),
    ("immediate imm xici", "write {}: an immediate contact", ("x[1].immediate",), "$1.immediate"),
    ("xioi", "write {}: an immediate normally closed contact", ("nc(x[1].immediate)",), "nc($1.immediate)"),
    ("abs", "a condition does not calculate; of a size, test both signs: {}", ("any(ds.A > 3, ds.A < -3)",), ""),
    ("sum", BEFORE, ('calc("SUM(ds[1:11])", ds.Total)', "ds.Total > 5"), ""),
    ("max min limit", "compare each by itself: {} or {}", ("any(ds.A > 5, ds.B > 5)", "all(ds.A > 5, ds.B > 5)"), ""),
    ("afi false never alwaysoff always_off alwaysfalse always_false", "sc[1] is always on, so that a rung under {} never runs", ("nc(sc[1])",), ""),
    (
        "always true alwayson always_on alwaystrue always_true",
        "a rung that always runs stands under if True:, and a contact that is always on is {}",
        ("sc[1]",),
        "",
    ),
    ("first_scan fs s_fs firstscan s:fs", "write {}: the first scan", ("sc._1st_SCAN",), ""),
)
"""What is written as a condition."""
