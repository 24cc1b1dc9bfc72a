"""Words that are actions elsewhere: coils, timers, counters, moves, mathematics, program control."""

from __future__ import annotations

from clickgen.dialects.if_rungs.trade.advice import (
    CLAMP,
    EDGE,
    LATER,
    LIMIT,
    LIMITED,
    LIMITS,
    MAX,
    MIN,
    OTHER_WAY,
    OWN_SIZE,
    SELECT,
    SIZE,
    TWO_RUNGS,
    table,
)

_OUT, _SET, _RESET = ("out(y.Motor)",), ("set(y.Motor)",), ("reset(y.Motor)",)
_TON, _TOF = "ton(t.Delay, setpoint=5, unit=Ts)", "tof(t.RunOn, setpoint=5, unit=Ts)"
_RTON = "rton(t.Hours, setpoint=5, unit=Th, reset=lambda: c.Serviced)"
_CTU, _CTD = "ctu(ct.Parts, setpoint=10, reset=lambda: c.Clear)", "ctd(ct.Left, setpoint=10, reset=lambda: c.Filled)"
_CTUD = "ctud(ct.Stock, setpoint=10, count_down=lambda: re(x[2]), reset=lambda: c.Clear)"
_SR = ("if x[2]: reset(c.A)", "if x[1]: set(c.A)", "if x[1]: set(c.A)", "if x[2]: reset(c.A)")
_RS = ("if x[1]: set(c.A)", "if x[2]: reset(c.A)", "if x[2]: reset(c.A)", "if x[1]: set(c.A)")
_SUB = "write a subroutine at the top level: @sub on the line above def fill():, and call it with {}"
_WAIT = "a scan never waits: start a timer, {}, and let another rung depend on its bit: {}"

ACTIONS = table(
    ("ote coil output energize oute", "write {}: a coil", _OUT, "out($1)"),
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
    ("ons osr os one_shot oneshot osri r_trig rise pls difu", EDGE, ("re(c.A)", "out(c.Pulse, oneshot=True)"), ""),
    (
        "osf f_trig fall plf difd",
        "a falling edge belongs to the condition: {} with {}",
        ("fe(c.A)", "out(c.Pulse)"),
        "",
    ),
    (
        "sr",
        f"{LATER} IEC's SR is set dominant: first {{}}, then {{}}; Siemens' SR is reset dominant: {OTHER_WAY}",
        _SR,
        "",
    ),
    (
        "rs",
        f"{LATER} IEC's RS is reset dominant: first {{}}, then {{}}; Siemens' RS is set dominant: {OTHER_WAY}",
        _RS,
        "",
    ),
    (
        "flipflop bistable",
        f"{LATER} with set dominant: first {{}}, then {{}}; with reset dominant: {OTHER_WAY}",
        _SR,
        "",
    ),
    ("keep", f"{LATER} KEEP is reset dominant: first {{}}, then {{}}", _RS[:2], ""),
    (
        "mps mrd mpp lps lrd lpp",
        "a branch needs no stack: it is an if under another if, {}",
        ("if c.A: set(c.B)",),
        "",
    ),
    # Timers and counters
    (
        "on_delay ondelay delay_on tond tonx tmr tmrf tim timh sd_timer s_odt",
        "write {}: an on-delay timer",
        (_TON,),
        "ton($*)",
    ),
    ("off_delay offdelay delay_off toff s_offdt", "write {}: an off-delay timer", (_TOF,), "tof($*)"),
    (
        "rto tonr rtot ret_on retentive_timer acc_timer tmra tmraf ttim s_odts",
        "write {}: a retentive timer",
        (_RTON,),
        "rton($*)",
    ),
    ("timer", "an on-delay timer is {}, an off-delay timer {}, a retentive one {}", (_TON, _TOF, _RTON), ""),
    (
        "tp pulse pulse_timer monostable s_pulse s_pext",
        "CLICK has no pulse timer; three rungs make one: {}, {} and {}",
        ("if re(x[1]): set(c.Pulse)", "if c.Pulse: ton(t.PulseTime, setpoint=500)", "if t.PulseTime: reset(c.Pulse)"),
        "",
    ),
    ("wait sleep delay pause dwell", _WAIT, (_TON, "t.Delay"), ""),
    ("count_up countup cnt_up s_cu", "write {}: an up counter", (_CTU,), "ctu($*)"),
    ("count_down countdown cnt_down s_cd", "write {}: a down counter", (_CTD,), "ctd($*)"),
    ("counter count cnt ctr", "a counter counts up, {}, down, {}, or both ways, {}", (_CTU, _CTD, _CTUD), ""),
    ("count_up_down updown udc cntr s_cud", "write {}: a counter for both ways", (_CTUD,), ""),
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
    ("abs", SIZE, ("copy(ds.A, ds.Size)", 'if ds.Size < 0: calc("-ds.Size", ds.Size)'), OWN_SIZE),
    ("avg ave average mean", "write {}: a mean value", ('calc("SUM(ds[1:11]) / 10", ds.Mean)',), ""),
    ("sum total", "write {}: a sum", ('calc("SUM(ds[1:11])", ds.Total)',), ""),
    (
        "inc incr increment incp",
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
        "xnor bxnor wxnr",
        "write {}: words combined bit by bit",
        ('math_hex("NOT (dh.A XOR dh.B)", dh.C)',),
        'math_hex("NOT ($1 XOR $2)", $3)',
    ),
    ("zrst", "write {}: a range of bits turned off", ("reset(c[1:9])",), ""),
    ("shl", "write {}: a word shifted to the left", ('math_hex("dh.A SHL 1", dh.B)',), 'math_hex("$1 SHL $2", $3)'),
    ("shr", "write {}: a word shifted to the right", ('math_hex("dh.A SHR 1", dh.B)',), 'math_hex("$1 SHR $2", $3)'),
    ("rol", "write {}: a word rotated to the left", ('math_hex("LRO(dh.A, 1)", dh.B)',), ""),
    ("ror", "write {}: a word rotated to the right", ('math_hex("RRO(dh.A, 1)", dh.B)',), ""),
    (
        "not bnot",
        "write {}: every bit of a word turned round",
        ('math_hex("NOT dh.A", dh.B)',),
        'math_hex("NOT $1", $2)',
    ),
    (
        "max",
        TWO_RUNGS,
        ("if ds.A >= ds.B: copy(ds.A, ds.C)", "if ds.A < ds.B: copy(ds.B, ds.C)"),
        MAX,
    ),
    (
        "min",
        TWO_RUNGS,
        ("if ds.A <= ds.B: copy(ds.A, ds.C)", "if ds.A > ds.B: copy(ds.B, ds.C)"),
        MIN,
    ),
    ("limit lim", LIMITS, LIMITED, LIMIT),
    ("clamp", LIMITS, LIMITED, CLAMP),
    ("sel select", TWO_RUNGS, ("if nc(c.Pick): copy(ds.A, ds.C)", "if c.Pick: copy(ds.B, ds.C)"), SELECT),
    ("mux", "a pointer chooses one of a table: {}", ("copy(ds[ds.Index], ds.C)",), ""),
    # Program control
    (
        "jsr gosub gts sbs cal calls callp call_sub sbr_call",
        "write {}: a call of a subroutine",
        ("call(fill)",),
        "call($1)",
    ),
    ("sbr subroutine subr function proc", _SUB, ("call(fill)",), ""),
    ("ret rts rtn sret", "a subroutine ends in {}", ("return",), ""),
    (
        "jmp goto jump cj lbl label jme",
        "CLICK has no jumps: put the rungs into a subroutine, and {}",
        ("call(fill)",),
        "",
    ),
    (
        "mcr mc mcs mls mlr ilc",
        "CLICK has no master control: put the condition into each rung, {}",
        ("all(c.Zone, x[1])",),
        "",
    ),
    ("nop noop", "a rung that does nothing holds {}", ("pass",), ""),
    ("afi", "sc[1] is always on, so a rung under {} never runs", ("nc(sc[1])",), ""),
    ("tnd fin fend endc", "write {}: the end of the scan", ("end()",), ""),
    ("next endfor end_for loop_end", "write {}: the end of a loop", ("next_loop()",), ""),
    ("loop repeat forloop", "write {}: a loop", ("for _ in range(ds.Count): pass",), ""),
    # Tables, shift registers, drums, messages
    (
        "bsl bsr shiftreg shift_register sft shrb",
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
"""Words that are written as an action."""
