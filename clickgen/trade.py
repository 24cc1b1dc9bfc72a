"""The words of the trade, and what they are here: those of IEC 61131-3, Allen-Bradley, Siemens, the mnemonics of
instruction lists, CLICK's own menus and ladder files, and the dialect with ``with Rung(...)``.

They are looked at before any spelling: ``otu`` is no misspelt ``out`` but the opposite of it. Every piece of code in
this table builds, which a test tries.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple

from clickgen.device.banks import BANKS as CLICK_BANKS


class Advice(NamedTuple):
    """How something is written here. ``text`` has a ``{}`` for each piece of ``code``.

    ``own`` makes the first piece of what the person wrote: ``$1`` is the first argument, ``$*`` are all of them.
    """

    text: str
    code: tuple[str, ...] = ()
    own: str = ""

    @property
    def shown(self) -> str:
        """The advice with its examples."""
        return self.text.format(*self.code)

    def of(self, written: str) -> str:
        """The advice with the person's own code as its first example."""
        return self.text.format(written, *self.code[1:])

    def written(self, arguments: Sequence[str]) -> str:
        """The person's own arguments as they are written here; "" where their number does not fit."""
        wanted = {int(number) for number in re.findall(r"\$(\d)", self.own)}
        if not self.own or not arguments or (wanted and max(wanted) != len(arguments)):
            return ""
        text = self.own.replace("$*", ", ".join(arguments))
        return re.sub(r"\$(\d)", lambda number: arguments[int(number[1]) - 1], text)


def advice(word: str, table: dict[str, Advice]) -> Advice | None:
    """What a table says to a word, whatever its case; None for a word that is not in it."""
    return table.get(word.lower())


def _table(*rows: tuple[str, str, tuple[str, ...], str]) -> dict[str, Advice]:
    return {word: Advice(text, code, own) for words, text, code, own in rows for word in words.split()}


# -- conditions -------------------------------------------------------------------------------------------------------

_EDGE = "a one-shot is a rising edge in the condition, {}, or oneshot=True in the action: {}"
_BEFORE = "a condition does not calculate: write {} in a rung before, and compare the result: {}"
_ABS = "copy the number, {}, and turn it round in a rung below where it is negative: {}"
_TWO_RUNGS = "CLICK chooses by conditions, in two rungs: {} and {}"

CONDITIONS = _table(
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
    ("ons osr os oneshot one_shot osri dif difu pls plus", _EDGE, ("re(c.A)", "out(c.Pulse, oneshot=True)"), ""),
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
    ("sum", _BEFORE, ('calc("SUM(ds[1:11])", ds.Total)', "ds.Total > 5"), ""),
    ("max min limit", "compare each by itself: {} or {}", ("any(ds.A > 5, ds.B > 5)", "all(ds.A > 5, ds.B > 5)"), ""),
    ("afi false never", "sc[1] is always on, so that a rung under {} never runs", ("nc(sc[1])",), ""),
    (
        "always true",
        "a rung that always runs stands under if True:, and a contact that is always on is {}",
        ("sc[1]",),
        "",
    ),
    ("first_scan fs s_fs firstscan s:fs", "write {}: the first scan", ("sc._1st_SCAN",), ""),
)
"""What is written as a condition."""

# -- actions ----------------------------------------------------------------------------------------------------------

_OUT, _SET, _RESET = ("out(y.Motor)",), ("set(y.Motor)",), ("reset(y.Motor)",)
_TON, _TOF = "ton(t.Delay, setpoint=5, unit=Ts)", "tof(t.RunOn, setpoint=5, unit=Ts)"
_RTON = "rton(t.Hours, setpoint=5, unit=Th, reset=lambda: c.Serviced)"
_CTU, _CTD = "ctu(ct.Parts, setpoint=10, reset=lambda: c.Clear)", "ctd(ct.Left, setpoint=10, reset=lambda: c.Filled)"
_CTUD = "ctud(ct.Stock, setpoint=10, count_down=lambda: re(x[2]), reset=lambda: c.Clear)"
_SUB = "a subroutine stands at the top level: @sub on the line above def fill():, and is called with {}"
_WAIT = "a scan never waits: start a timer, {}, and let another rung stand on its bit: {}"

ACTIONS = _table(
    ("ote coil output energize oute otei", "write {}: a coil", _OUT, "out($1)"),
    ("otl latch lat set_bit setbit turn_on turnon s", "write {}: a coil that stays on", _SET, "set($1)"),
    (
        "otu unlatch unlat unl delatch rst reset_bit resetbit turn_off turnoff r",
        "write {}: a coil that turns off what set(...) turned on",
        _RESET,
        "reset($1)",
    ),
    (
        "res",
        "a counter and a retentive timer are reset by an input of their own: {}, {}; a bit is turned off with {}",
        (_CTU, _RTON, "reset(c.Run)"),
        "",
    ),
    (
        "toggle tog flip alternate alt altp invert",
        "a toggle is two branches of one rung under if re(x[1]): {} and {}",
        ("if nc(c.A): set(c.A)", "if c.A: reset(c.A)"),
        "",
    ),
    ("ons osr os one_shot oneshot osri r_trig rise pls difu", _EDGE, ("re(c.A)", "out(c.Pulse, oneshot=True)"), ""),
    (
        "osf f_trig fall plf difd",
        "a falling edge belongs to the condition: {} with {}",
        ("fe(c.A)", "out(c.Pulse)"),
        "",
    ),
    (
        "sr flipflop",
        "set and reset are rungs of their own and the later one wins; with set dominant: first {}, then {}",
        ("if x[2]: reset(c.A)", "if x[1]: set(c.A)"),
        "",
    ),
    (
        "rs",
        "set and reset are rungs of their own and the later one wins; with reset dominant: first {}, then {}",
        ("if x[1]: set(c.A)", "if x[2]: reset(c.A)"),
        "",
    ),
    # Timers and counters
    ("on_delay ondelay delay_on tond tonx tmr tim sd_timer", "write {}: an on-delay timer", (_TON,), "ton($*)"),
    ("off_delay offdelay delay_off toff", "write {}: an off-delay timer", (_TOF,), "tof($*)"),
    ("rto tonr rtot ret_on retentive_timer acc_timer", "write {}: a retentive timer", (_RTON,), "rton($*)"),
    ("timer", "an on-delay timer is {}, an off-delay timer {}, a retentive one {}", (_TON, _TOF, _RTON), ""),
    (
        "tp pulse pulse_timer tmp monostable",
        "CLICK has no pulse timer; three rungs make one: {}, {} and {}",
        ("if re(x[1]): set(c.Pulse)", "if c.Pulse: ton(t.PulseTime, setpoint=500)", "if t.PulseTime: reset(c.Pulse)"),
        "",
    ),
    ("wait sleep delay pause dwell", _WAIT, (_TON, "t.Delay"), ""),
    ("count_up countup cnt_up", "write {}: an up counter", (_CTU,), "ctu($*)"),
    ("count_down countdown cnt_down", "write {}: a down counter", (_CTD,), "ctd($*)"),
    ("counter count cnt ctr", "a counter counts up, {}, down, {}, or both ways, {}", (_CTU, _CTD, _CTUD), ""),
    ("count_up_down updown udc", "write {}: a counter for both ways", (_CTUD,), ""),
    # Copies
    ("mov move movw movd mvw mvd assign let", "write {}: a copy of one value", ("copy(ds.A, ds.B)",), "copy($1, $2)"),
    (
        "cop cps bmov blkmov blockcopy block_copy move_block",
        "write {}: a copy of a range",
        ("copy_block(ds[1:6], ds[10])",),
        "copy_block($*)",
    ),
    (
        "fll fill fmov fill_block",
        "write {}: a range filled with one value",
        ("copy_fill(0, ds[1:6])",),
        "copy_fill($1, $2)",
    ),
    ("pack pack_bits packbits", "write {}: bits packed into a word", ("copy_pack(c[1:17], dh.Word)",), "copy_pack($*)"),
    ("pack_words", "write {}: two words packed into one", ("copy_pack(ds[1:3], dd.Long)",), "copy_pack($*)"),
    ("pack_text", "write {}: a text as a number", ("copy_pack(txt[1:5], ds.Number)",), "copy_pack($*)"),
    (
        "unpack unpack_to_bits btd",
        "write {}: a word unpacked into bits",
        ("copy_unpack(dh.Word, c[1:17])",),
        "copy_unpack($*)",
    ),
    (
        "unpack_to_words",
        "write {}: a double word unpacked into words",
        ("copy_unpack(dd.Long, ds[1:3])",),
        "copy_unpack($*)",
    ),
    ("mvm", "write {}: a masked move", ('math_hex("dh.A AND 0x00FF OR dh.B AND 0xFF00", dh.B)',), ""),
    ("clr clear clearall zero", "a register is cleared with {}, a bit with {}", ("copy(0, ds.A)", "reset(c.A)"), ""),
    # Mathematics
    ("add", "write {}: a sum", ('calc("ds.A + ds.B", ds.C)',), 'calc("$1 + $2", $3)'),
    ("sub subtract", "write {}: a difference", ('calc("ds.A - ds.B", ds.C)',), 'calc("$1 - $2", $3)'),
    ("mul mult multiply", "write {}: a product", ('calc("ds.A * ds.B", ds.C)',), 'calc("$1 * $2", $3)'),
    ("div divide", "write {}: a quotient", ('calc("ds.A / ds.B", ds.C)',), 'calc("$1 / $2", $3)'),
    ("mod modulo", "write {}: a remainder", ('calc("ds.A MOD ds.B", ds.C)',), 'calc("$1 MOD $2", $3)'),
    ("neg", "write {}: the opposite number", ('calc("-ds.A", ds.B)',), 'calc("-$1", $2)'),
    ("sqr sqrt", "write {}: a square root", ('calc("SQRT(df.A)", df.B)',), 'calc("SQRT($1)", $2)'),
    ("abs", _ABS, ("copy(ds.A, ds.Size)", 'if ds.Size < 0: calc("-ds.Size", ds.Size)'), ""),
    ("avg ave average mean", "write {}: a mean value", ('calc("SUM(ds[1:11]) / 10", ds.Mean)',), ""),
    ("sum total", "write {}: a sum", ('calc("SUM(ds[1:11])", ds.Total)',), ""),
    (
        "inc incr increment incp ctinc",
        "to count up by one, write {}",
        ('calc("ds.A + 1", ds.A)',),
        'calc("$1 + 1", $1)',
    ),
    ("dec decr decrement decp", "to count down by one, write {}", ('calc("ds.A - 1", ds.A)',), 'calc("$1 - 1", $1)'),
    ("cpt compute math eval expr", "write {}: a calculation", ('calc("ds.A * 2", ds.B)',), "calc($*)"),
    ("math_dec mathdec", "write {}: a calculation", ('calc("ds.A * 2", ds.B)',), "calc($*)"),
    ("mathhex hex_math", "write {}: a hexadecimal calculation", ('math_hex("dh.A AND dh.B", dh.C)',), "math_hex($*)"),
    (
        "scp scl scale cpt_scale norm_x scale_x",
        "write {}: scaling",
        ('calc("(ds.Raw - 819) * 100 / 3276", df.Percent)',),
        "",
    ),
    (
        "and band wand",
        "write {}: words combined bit by bit",
        ('math_hex("dh.A AND dh.B", dh.C)',),
        'math_hex("$1 AND $2", $3)',
    ),
    (
        "or bor wor",
        "write {}: words combined bit by bit",
        ('math_hex("dh.A OR dh.B", dh.C)',),
        'math_hex("$1 OR $2", $3)',
    ),
    (
        "xor bxor wxor",
        "write {}: words combined bit by bit",
        ('math_hex("dh.A XOR dh.B", dh.C)',),
        'math_hex("$1 XOR $2", $3)',
    ),
    (
        "not bnot",
        "write {}: every bit of a word turned round",
        ('math_hex("NOT dh.A", dh.B)',),
        'math_hex("NOT $1", $2)',
    ),
    (
        "max",
        _TWO_RUNGS,
        ("if ds.A >= ds.B: copy(ds.A, ds.C)", "if ds.A < ds.B: copy(ds.B, ds.C)"),
        "",
    ),
    (
        "min",
        _TWO_RUNGS,
        ("if ds.A <= ds.B: copy(ds.A, ds.C)", "if ds.A > ds.B: copy(ds.B, ds.C)"),
        "",
    ),
    ("limit clamp lim", _TWO_RUNGS, ("if ds.A < 0: copy(0, ds.A)", "if ds.A > 100: copy(100, ds.A)"), ""),
    ("sel select", _TWO_RUNGS, ("if nc(c.Pick): copy(ds.A, ds.C)", "if c.Pick: copy(ds.B, ds.C)"), ""),
    ("mux", "a pointer chooses one of a table: {}", ("copy(ds[ds.Index], ds.C)",), ""),
    # Program control
    ("jsr gosub cal calls call_sub sbr_call", "write {}: a call of a subroutine", ("call(fill)",), "call($1)"),
    ("sbr subroutine subr function proc", _SUB, ("call(fill)",), ""),
    ("ret rts rtn", "a subroutine ends in {}", ("return",), ""),
    ("jmp goto jump lbl label jme", "CLICK has no jumps: put the rungs into a subroutine, and {}", ("call(fill)",), ""),
    ("mcr mc mcs", "CLICK has no master control: put the condition into each rung, {}", ("all(c.Zone, x[1])",), ""),
    ("nop noop", "a rung that does nothing holds {}", ("pass",), ""),
    ("afi", "sc[1] is always on, so that a rung under {} never runs", ("nc(sc[1])",), ""),
    ("tnd fin endc", "write {}: the end of the scan", ("end()",), ""),
    ("next endfor end_for loop_end", "write {}: the end of a loop", ("next_loop()",), ""),
    ("loop repeat forloop", "write {}: a loop", ("for _ in range(ds.Count): pass",), ""),
    # Tables, shift registers, drums, messages
    (
        "bsl bsr shiftreg shift_register sft shl shr rol ror",
        "write {}: a shift register",
        ("shift(c[1:9], clock=lambda: c.Clock, reset=lambda: c.Clear)",),
        "",
    ),
    (
        "srch find fsc",
        "write {}: a search through a table",
        ("search(ds[1:11] >= 100, result=ds.At, found=c.Found)",),
        "",
    ),
    ("print printf log display show", "a text for a panel goes to TXT: {}", ('copy("READY", txt[1])',), ""),
)
"""What is written as an action."""

# -- formulas ---------------------------------------------------------------------------------------------------------

FORMULAS = _table(
    ("pow power expt xpy", "write {}: a power has its sign", ("(ds.A ^ 2)",), "($1 ^ $2)"),
    ("exp", "write {}: a power of e", ("(2.7182818 ^ df.A)",), "(2.7182818 ^ $1)"),
    ("sqr", "a square is {}, a square root {}", ("ds.A ^ 2", "SQRT(df.A)"), ""),
    ("log10", "CLICK's LOG is the logarithm to base 10: {}", ("LOG(df.A)",), "LOG($1)"),
    ("log2", "write {}: a logarithm to base 2", ("(LN(df.A) / LN(2))",), "(LN($1) / LN(2))"),
    ("rol", "write {}: a rotation to the left", ("LRO(dh.A, 1)",), "LRO($1, $2)"),
    ("ror", "write {}: a rotation to the right", ("RRO(dh.A, 1)",), "RRO($1, $2)"),
    ("abs", _ABS, ("copy(ds.A, ds.Size)", 'if ds.Size < 0: calc("-ds.Size", ds.Size)'), ""),
    ("sqroot root", "write {}: a square root", ("SQRT(df.A)",), "SQRT($1)"),
    ("add", "write {}: a sum has its sign", ("(ds.A + ds.B)",), "($1 + $2)"),
    ("sub", "write {}: a difference has its sign", ("(ds.A - ds.B)",), "($1 - $2)"),
    ("mul", "write {}: a product has its sign", ("(ds.A * ds.B)",), "($1 * $2)"),
    ("div", "write {}: a quotient has its sign", ("(ds.A / ds.B)",), "($1 / $2)"),
    ("neg", "write {}: the opposite number", ("(-ds.A)",), "(-$1)"),
    ("avg ave average mean", "write {}: a mean value", ("(SUM(ds[1:11]) / 10)",), ""),
    ("total", "write {}: a sum of a range", ("SUM(ds[1:11])",), ""),
    (
        "min",
        "CLICK chooses by conditions, in two rungs: {} and {}",
        ("if ds.A <= ds.B: copy(ds.A, ds.C)", "if ds.A > ds.B: copy(ds.B, ds.C)"),
        "",
    ),
    (
        "max",
        "CLICK chooses by conditions, in two rungs: {} and {}",
        ("if ds.A >= ds.B: copy(ds.A, ds.C)", "if ds.A < ds.B: copy(ds.B, ds.C)"),
        "",
    ),
    (
        "limit clamp lim",
        "CLICK limits by conditions, in two rungs: {} and {}",
        ("if ds.A < 0: copy(0, ds.A)", "if ds.A > 100: copy(100, ds.A)"),
        "",
    ),
    (
        "sel if iif choose",
        "CLICK chooses by conditions, in two rungs: {} and {}",
        ("if nc(c.Pick): copy(ds.A, ds.C)", "if c.Pick: copy(ds.B, ds.C)"),
        "",
    ),
    ("mux", "a pointer chooses one of a table: {}", ("copy(ds[ds.Index], ds.C)",), ""),
    (
        "round",
        "add a half with {}, and cut the decimals off with {}",
        ('calc("df.A + 0.5", df.B)', "copy(df.B, ds.C)"),
        "",
    ),
    ("int trunc floor dint fix", "a copy to a whole number cuts the decimals off: {}", ("copy(df.A, ds.B)",), ""),
    ("real float", "a copy to DF makes a floating-point number: {}", ("copy(ds.A, df.B)",), ""),
    ("band", "words are combined in math_hex: {}", ('math_hex("dh.A AND dh.B", dh.C)',), ""),
    ("bor", "words are combined in math_hex: {}", ('math_hex("dh.A OR dh.B", dh.C)',), ""),
    ("bxor", "words are combined in math_hex: {}", ('math_hex("dh.A XOR dh.B", dh.C)',), ""),
)
"""What is written as a function of a formula."""

# -- arguments, units, banks, members ---------------------------------------------------------------------------------

ARGUMENTS = {
    word: name
    for words, name in (
        ("preset pre pt pv sp time delay limit duration setpt set_point goal period", "setpoint"),
        ("timebase time_base base tb", "unit"),
        ("r res rst clear clr reset_input", "reset"),
        ("cd down dn countdown", "count_down"),
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
"""What an argument is called elsewhere, and here."""

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


def bank_hint(name: str, index: str = "") -> str:
    """What a bank of another machine is here, with the number where it fits; "" for a word that is none."""
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
        ("done dn q qu output out bit done_bit finished expired status is_done on is_on state value_bit", "bit"),
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
