"""Candidates for a place in a program, right or wrong there: words, numbers at their limits, forms of operands."""

from __future__ import annotations


def split(text: str) -> list[str]:
    return text.split()


BANKS = split("x y c ds dd dh df txt t ct td ctd sc sd xd yd X DS foo")
"""The first twelve hold addresses that a program can name."""
FUNCTIONS = ("all", "any", "nc", "re", "fe")
INSTRUCTIONS = split(
    """
    out set reset copy copy_block copy_fill copy_pack copy_unpack shift search calc math_hex ton tof rton rtof ctu
    ctd ctud event_drum time_drum send receive call end next_loop nickname range to_text ModbusTcpTarget
    ModbusRtuTarget ModbusAddress latch blockcopy foo
    """
)
KEYWORDS = split(
    """
    address source destination source_range destination_start destination_range oneshot one_shot options
    timer counter setpoint unit reset count_down clock range condition value start end result flag found continuous
    formula subroutine outputs events presets pattern current_step accumulator completion_flag jump jump_step jog step
    target remote_start dest sending receiving success error exception_response word_swap name ip port device_id
    com_port register_type allow_whitespace suppress_zero exponential termination_code pad initial retentive comment foo
    """
)
METHODS = split("reset down count_down clock jump jog step jump_step immediate as_value as_text set end name reste")
LINKS = split(
    """
    .immediate .as_value() .as_ascii() .as_binary() .as_text() .as_text(pad=5) .as_text(pad=3) .as_value .Name
    .immediate.immediate [1] [1:3] (1) .as_text(exponential=True) .as_text(termination_code="$0D") .as_value(pad=1)
    """
)
OPERATORS = [*split("== != < <= > >= is in not and or + - * ** // % & | ^ << = := ,"), "is not", "not in", "==="]
PYTHON = split(
    """
    if elif else for while def class lambda return pass import from as with try True False None in not and or is del
    assert raise yield global async await match sub main end
    """
)
LIMITS = (
    -(2**31), -32768, -1, 0, 1, 2, 8, 9, 16, 17, 20, 21, 24, 32, 36, 101, 116, 123, 125, 128, 216, 247, 250, 255, 500,
    502, 816, 986, 1000, 1400, 1968, 2000, 4500, 9999, 10000, 16384, 32767, 65535, 65536, 100001, 165536, 300001,
    400001, 465536, 2**31, 2**32, 10**30,
)  # fmt: skip
INDICES = split(
    """
    0 1 -1 2001 4501 1:5 5:1 1:1 8:0:-1 1:9:2 : 1: :5 0:9 "0u" "Name" "" 1.5 0x1 True None ds[1] ds[1:3] ds.A dd[1]
    ds[ds[1]] c[1] ds[1]+1 1,2 -5:-1 1:2001 1:999999999 "_1st_SCAN" [1] ds[1].immediate *c x
    """
)
OPERANDS = [
    *split(
        """
        c[1] c.Name c[0] c[2001] c[1:5] c[5:1] c[8:0:-1] c[:] c[1:2001] c[1:1] x[1] x[17] x[816] x[15:23] x[1].immediate
        x[1:5].immediate y[1] y[1].immediate y[1:4].immediate t[1] t.Name ct[1] sc[1] sc[50] sc._1st_SCAN ds[1] ds.Name
        ds[4500] ds[4501] ds[1:5] ds[ds[1]] ds[ds.Name] ds[dd[1]] c[ds[1]] dd[1] dh[1] dh[1:3] df[1] xd[0] xd["0u"]
        yd[8] td[1] td.Name ctd[1] sd[1] sd[29] txt[1] txt[1:5] txt[1000] txt[ds[1]] 0 1 5 -5 17 32767 32768 -32768
        -32769 2147483648 0x10 0xFFFF 0x10000 1.5 -1.5 1e400 1e-50 .5 1e5 "A" "AB" "" "$0D" "$FF" "$0" "DS1" "00FFh"
        "==" "=>" "eq" True False None ... 1j b"A" f"A" () [] {} [c[1]] (c[1],) [c[1],ds[1]] [[1,0],[0,1]] [[1]] [[]]
        [1,[0]] [5] [1:3] c ds Ts Tms "Ts" to_value to_ascii to_binary to_text to_text() to_text(pad=5) range(3) other
        main foo nc(c[1]) re(c[1]) fe(x[1]) all(c[1],c[2]) any(c[1],ds[1]>2) nc(c[1:3]) txt[1].as_value()
        ds[1].as_text(pad=5) ModbusTcpTarget(ip="1.2.3.4") ModbusTcpTarget(ip="1.2.3") ModbusTcpTarget()
        ModbusTcpTarget("1.2.3.4") ModbusRtuTarget(com_port="cpu2",device_id=5)
        ModbusRtuTarget(com_port="cpu3",device_id=500) ModbusAddress(address=400001)
        ModbusAddress(address="0h",register_type="coil") ModbusAddress(address="0h") ModbusAddress()
        "C1" "X001" "x1" "XD0u" "DS4501"
        """
    ),
    "lambda: c[1]",
    "lambda: True",
    "lambda x: c[1]",
    "lambda: (c[1], c[2])",
    "ds[1] > 5",
    "ds[1:5] >= 5",
    "5 <= ds[1:5]",
    "ds[1:5] == ds[6:9]",
    "1 < ds[1] < 5",
    "c[1] and c[2]",
    "not c[1]",
    "'a' 'b'",
    '"ds[1] + 1"',
    '"SUM(ds[1:5])"',
    '"dh[1] AND 0x00FF"',
]
LISTS = [
    "[]",
    "()",
    "[[{}]]",
    "({})",
    "{{{}}}",
    "[*{}]",
    "[{} for x in c]",
    "[x for x in [{}]]",
    "list({})",
    "{}",
    "[[{0}], [{0}]]",
]
SIBLINGS = [
    "from parts import other",
    "from parts import other as mine",
    "from parts import *",
    "from parts import nothing",
    "from parts import other, third",
    "from . import parts",
    "from .parts import other",
    "from prog import main",
    "import prog",
    "import parts",
    "import parts as p",
    "import parts, wiring",
    "import missing",
    "from missing import other",
    "from clickgen.dsl import *",
    "import clickgen",
    "from os import path",
    "from parts import (other)",
    "from parts import",
    "import parts.more",
]
CHARACTERS = [
    *split(
        "( ) [ ] { } , . : ; + - * / ^ = < > ! ' \" # $ % & | ~ ` @ ? 0 1 9 h u A z _ ds[1] c.A MOD AND 0x SUM( SIN("
    ),
    " ",
    "  ",
    "\\",
    "\\n",
    "\t",
    "é",
    "\N{FULLWIDTH LATIN SMALL LETTER C}",
    "\u2028",
    "((((((((((",
]
COMMENTS = [
    "#",
    "# note",
    "#!",
    '# say "when", or not',
    "# *bold* and **bolder**",
    "# _x_ __y__ a_b_c * * _",
    "# {\\rtf1 \\b0} \\'e9",
    "# " + "x" * 1399,
    "# " + "{" * 700,
    "# é ß € → ≥ •",
    "# \U0001f600 e\u0301",
    "#\ttab\t",
    "# R,C1,-",
    "# " + "line\n    # " * 40,
]
