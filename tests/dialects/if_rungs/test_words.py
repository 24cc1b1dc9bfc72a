"""Words of the trade and misspelt words: suggestions build, and are never a word of another meaning."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

import clickgen
from clickgen.device.elsewhere import BANKS, UNITS
from clickgen.dialects.if_rungs.trade import (
    ACTIONS,
    ARGUMENTS,
    CONDITIONS,
    FORMULAS,
    MEMBERS,
    Advice,
    bank_hint,
)
from clickgen.formula.words import ALL_FUNCTIONS
from clickgen.instructions import INSTRUCTIONS
from clickgen.problems.suggest import are_opposed, is_slip, near_words

FUNCTIONS = ("all", "any", "nc", "re", "fe")
WORDS = (*INSTRUCTIONS, *FUNCTIONS, *(name.lower() for name in ALL_FUNCTIONS))
ENDING = "    if True:\n        end()\n"
SUB = "@sub\ndef fill():\n    if x[9]:\n        {code}\n    if True:\n        return\n\n\n"


def build(text: str, folder: Path) -> clickgen.BuildResult:
    program = folder / "prog.py"
    program.write_text(text)
    (folder / "nicknames.csv").unlink(missing_ok=True)
    return clickgen.build(program)


def as_rungs(code: str) -> str:
    """The rungs for a piece of advice: a rung itself, an action, a formula or a condition."""
    if code.startswith("if "):
        return f"    {code}\n"
    if code.startswith("for ") or code == "next_loop()":
        return "    if c[9]:\n        for _ in range(ds.Count): pass\n    if True:\n        next_loop()\n"
    name = code.partition("(")[0]
    if code == "pass" or name in INSTRUCTIONS:
        return f"    if c[9]:\n        {code}\n"
    if name in ("", "SQRT", "LOG", "SIN", "COS", "TAN", "LRO", "RRO", "SUM") or code.startswith("ds.A ^"):
        function, bank = ("math_hex", "dh") if "dh." in code else ("calc", "df")
        return f"    if c[9]:\n        {function}('{code}', {bank}.Result)\n"
    return f"    if {code}:\n        out(c.Out)\n"


def assert_right(code: str, folder: Path) -> None:
    inside = "return" if code == "return" else "pass"
    rungs = "" if code == "return" else as_rungs(code)
    text = SUB.format(code=inside) + f"def main():\n{rungs}{ENDING}"
    result = build(text, folder)
    assert result.ok, (code, text, [(one.code, one.message) for one in result.diagnostics if one.is_error])


def advices() -> Iterator[tuple[str, str, Advice]]:
    for title, table in (("condition", CONDITIONS), ("action", ACTIONS), ("formula", FORMULAS)):
        for word, advice in table.items():
            yield title, word, advice


EACH = list({advice: (title, word, advice) for title, word, advice in advices()}.values())


@pytest.mark.parametrize(("title", "word", "advice"), EACH, ids=[f"{title} {word}" for title, word, _ in EACH])
def test_every_advice_builds(title: str, word: str, advice: Advice, tmp_path: Path) -> None:
    assert advice.text.count("{}") == len(advice.code), (title, word)
    for code in advice.code:
        assert code in advice.shown
        assert_right(code, tmp_path)


CALLED = {
    "XIC(x[1])": "x[1]",
    "XIO(x[1])": "nc(x[1])",
    "AND(x[1], x[2])": "all(x[1], x[2])",
    "Or(x[1], x[2])": "any(x[1], x[2])",
    "XOR(x[1], x[2])": "any(all(x[1], nc(x[2])), all(nc(x[1]), x[2]))",
    "NOT(x[1])": "nc(x[1])",
    "fall(x[1])": "fe(x[1])",
    "rise(x[1])": "re(x[1])",
    "R_TRIG(x[1])": "re(x[1])",
    "GEQ(ds.A, 5)": "ds.A >= 5",
    "LIM(1, ds.A, 5)": "all(1 <= ds.A, ds.A <= 5)",
    "all_of(c.A, c.B)": "all(c.A, c.B)",
    "immediate(x[1])": "x[1].immediate",
}
STATED = {
    "OTE(y[1])": "out(y[1])",
    "otl(y[1])": "set(y[1])",
    "otu(y[1])": "reset(y[1])",
    "unlatch(y[1])": "reset(y[1])",
    "turn_on(y[1])": "set(y[1])",
    "turn_off(y[1])": "reset(y[1])",
    "MOV(5, ds.A)": "copy(5, ds.A)",
    "ADD(ds.A, 1, ds.B)": 'calc("ds.A + 1", ds.B)',
    "jsr(fill)": "call(fill)",
    "on_delay(t.A, preset=5)": "ton(t.A, setpoint=5)",
    "count_up(ct.A, 5)": "ctu(ct.A, 5)",
    "fll(0, ds[1:5])": "copy_fill(0, ds[1:5])",
    "res(ct.A)": "ctu(ct.A, setpoint=10, reset=lambda: c.Clear)",
    "TON(t.A, 5)": "ton(t.A, 5)",
    "y[1].set()": "set(y[1])",
}


@pytest.mark.parametrize(("written", "meant"), CALLED.items())
def test_a_condition_of_the_trade_is_said_with_the_persons_own_bits(written: str, meant: str, tmp_path: Path) -> None:
    text = f"def main():\n    if {{}}:\n        out(y[5])\n{ENDING}"
    (problem,) = (one for one in build(text.format(written), tmp_path).diagnostics if one.is_error)
    assert meant in problem.help
    assert build(text.format(meant), tmp_path).ok


@pytest.mark.parametrize(("written", "meant"), STATED.items())
def test_an_action_of_the_trade_is_said_with_the_persons_own_addresses(
    written: str, meant: str, tmp_path: Path
) -> None:
    text = SUB.format(code="pass") + f"def main():\n    if re(x[9]):\n        {{}}\n{ENDING}"
    (problem,) = (one for one in build(text.format(written), tmp_path).diagnostics if one.is_error)
    assert meant in problem.help
    assert build(text.format(meant), tmp_path).ok


@pytest.mark.parametrize(
    ("formula", "never"),
    [("MIN(ds.A, ds.B)", "SIN"), ("IN(df.A)", "SIN"), ("SEL(1, ds.A, 5)", "SHL"), ("MAX(ds.A, ds.B)", "TAN")],
)
def test_a_function_is_not_taken_for_another(formula: str, never: str, tmp_path: Path) -> None:
    text = f'def main():\n    if c.A:\n        calc("{formula}", df.C)\n{ENDING}'
    (problem,) = (one for one in build(text, tmp_path).diagnostics if one.code == "CG117")
    assert f"did you mean {never}" not in problem.help


# -- misspelt words ---------------------------------------------------------------------------------------------------


def test_no_known_word_is_suggested_for_another() -> None:
    trade = {*CONDITIONS, *ACTIONS, *FORMULAS}
    for word in {*WORDS, *trade}:
        for known in (INSTRUCTIONS, FUNCTIONS, [name.lower() for name in ALL_FUNCTIONS]):
            # A word of the table is never looked up by its spelling; a known word elsewhere must not mislead.
            near = [other for other in near_words(word, known) if other != word]
            assert not any(are_opposed(word, other) for other in near), (word, near)


@given(
    st.sampled_from(WORDS),
    st.sampled_from(["insert", "delete", "change", "swap"]),
    st.integers(0, 30),
    st.sampled_from("abcdefghijklmnopqrstuvwxyz_"),
)
def test_a_slip_of_the_keyboard_leads_back_or_nowhere(word: str, kind: str, place: int, letter: str) -> None:
    at = place % len(word)
    if kind == "insert":
        typed = word[:at] + letter + word[at:]
    elif kind == "delete":
        typed = word[:at] + word[at + 1 :]
    elif kind == "change":
        typed = word[:at] + letter + word[at + 1 :]
    else:
        typed = word[:at] + word[at : at + 2][::-1] + word[at + 2 :]
    for known in (list(INSTRUCTIONS), list(FUNCTIONS), [name.lower() for name in ALL_FUNCTIONS]):
        if word in known and typed not in known:
            near = near_words(typed, known)
            assert word in near or not near, (word, typed, near)


NEVER = [
    ("Pump1_Run", "Pump2_Run"),
    ("Pump_1", "Pump_11"),
    ("Pump_A_Run", "Pump_B_Run"),
    ("PumpARun", "PumpBRun"),
    ("Start", "Restart"),
    ("Start", "Stop"),
    ("Stop", "Step"),
    ("Valve_Open", "Valve_Close"),
    ("Valve_Opened", "Valve_Opening"),
    ("Lock", "Unlock"),
    ("Reenable_Drive", "Enable_Drive"),
    ("Tank_LL", "Tank_LH"),
    ("Level_Hi", "Level_Lo"),
    ("Motor_On", "Motor_Off"),
    ("_RTC_Hour", "_RTC_New_Hour"),
    ("set", "reset"),
    ("ton", "tof"),
    ("ctu", "ctd"),
    ("SIN", "ASIN"),
    ("Ts", "Tms"),
    ("cpu3", "cpu2"),
    ("Xlock", "Block"),
]


@pytest.mark.parametrize(("one", "other"), [*NEVER, *((other, one) for one, other in NEVER)])
def test_names_of_different_things_are_never_suggested(one: str, other: str) -> None:
    assert near_words(one, [other]) == []


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("Gaurd_Fault", "Guard_Fault"),
        ("Conveyer_Run", "Conveyor_Run"),
        ("pump1_rnu_time", "Pump1_Run_Time"),
        ("MotorRun", "Motor_Run"),
        ("Pumps", "Pump"),
        ("_1st_SCN", "_1st_SCAN"),
        ("setpoit", "setpoint"),
        ("resset", "reset"),
        ("coppy", "copy"),
        ("al", "all"),
        ("an", "any"),
    ],
)
def test_slips_are_seen(typed: str, meant: str) -> None:
    assert near_words(typed, [meant, "Something_Else"]) == [meant]


def test_words_that_are_equally_near_are_all_named() -> None:
    assert near_words("cal", INSTRUCTIONS) == ["calc", "call"]
    assert near_words("tom", INSTRUCTIONS) == []
    assert near_words("Pmp", ["Pump", "Pimp", "Pomp", "Pemp"]) == []


@given(st.text(max_size=30), st.text(max_size=30))
def test_any_two_words_can_be_compared(one: str, other: str) -> None:
    assert is_slip(one, other) in (True, False)
    assert near_words(one, [other]) in ([], [other])


# -- names ------------------------------------------------------------------------------------------------------------


def test_every_name_leads_to_something_that_there_is() -> None:
    params = {name for spec in INSTRUCTIONS.values() for param in spec.params for name in (param.name, *param.aliases)}
    assert set(ARGUMENTS.values()) <= {*params, "initial", "retentive", "comment"}
    assert set(UNITS.values()) == {"Tms", "Ts", "Tm", "Th", "Td"}
    assert set(MEMBERS.values()) >= {"bit", "current", "setpoint"}
    # CLICK's own banks are not words of other machines.
    assert not {bank for bank in BANKS if bank in BANKS.values()}


@pytest.mark.parametrize("word", BANKS)
def test_the_hint_at_a_bank_builds(word: str, tmp_path: Path) -> None:
    (cell,) = re.findall(r"write (\w+\[\d+\])", bank_hint(word, "5"))
    condition = f'{cell} == "A"' if cell.startswith("txt") else cell
    assert build(f"def main():\n    if {condition}:\n        out(y[1])\n{ENDING}", tmp_path).ok
