"""Wrong conditions: the message shows what was meant, in the person's own words, and it builds as shown."""

from __future__ import annotations

import builtins
import operator
import re
from functools import partial
from itertools import product
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from mended import found

import clickgen
from clickgen.dialects.if_rungs.read.conditions import fits_condition
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.ways_out.meant import meant
from clickgen.problems.diagnostics import Diagnostic, Diagnostics
from clickgen.text.edits import apply_fixes
from clickgen.text.source import SourceFile

ENDING = "    if True:\n        end()\n"
SUB = "@sub\ndef fill():\n    if True:\n        return\n\n\n"


def program(rungs: str) -> str:
    return f"{SUB}def main():\n{rungs}{ENDING}"


def under(condition: str, before: str = "") -> str:
    return program(f"{before}    if {condition}:\n        out(y[1])\n")


def action(text: str) -> str:
    return program(f"    if re(c.Go):\n        {text}\n")


def errors(text: str, folder: Path) -> list[Diagnostic]:
    path = folder / "prog.py"
    path.write_text(text, "utf-8")
    (folder / "nicknames.csv").unlink(missing_ok=True)
    return [problem for problem in clickgen.build(path).diagnostics if problem.is_error]


SAID = [
    # Bits and conditions that are compared
    ("(x[1] and x[2]) == False", "any(nc(x[1]), nc(x[2]))"),
    ("(x[1] and x[2]) == True", "all(x[1], x[2])"),
    ("all(x[1], x[2]) == 0", "any(nc(x[1]), nc(x[2]))"),
    ("nc(x[1]) == True", "nc(x[1])"),
    ("nc(x[1]) == False", "x[1]"),
    ("re(x[1]) == True", "re(x[1])"),
    ("False == (x[1] | x[2])", "all(nc(x[1]), nc(x[2]))"),
    ("(x[1] or x[2]) == x[3]", "any(all(any(x[1], x[2]), x[3]), all(nc(x[1]), nc(x[2]), nc(x[3])))"),
    ("not x[1] == False", "x[1]"),
    ("nc(x[1] == False)", "x[1]"),
    ("nc(c.B == 1)", "nc(c.B)"),
    ("nc(t.A >= 5)", "td.A < 5"),
    ("ct.A >= 5 and x[1]", "all(ctd.A >= 5, x[1])"),
    ("c[1:3] == True", "c[1:3]"),
    ("c[1:3] == False", "nc(c[1:3])"),
    ("re(x[1] == True)", "re(x[1])"),
    ("re(x[1] == False)", "fe(x[1])"),
    ("fe(not x[1])", "re(x[1])"),
    ("re(c[1:3])", "any(re(c[1]), re(c[2]))"),
    ("re(x[1].immediate)", "re(x[1])"),
    # The signs of Python
    ("ds[1] == 5 & x[1]", "all(ds[1] == 5, x[1])"),
    ("x[1] & ds[1] == 5", "all(x[1], ds[1] == 5)"),
    ("ds[1] == 5 | x[1]", "any(ds[1] == 5, x[1])"),
    ("ds[1] == 5 & ds[2] == 3", "all(ds[1] == 5, ds[2] == 3)"),
    ("ds[1] > 5 | ds[2] > 3", "any(ds[1] > 5, ds[2] > 3)"),
    ("x[1] & x[2]", "all(x[1], x[2])"),
    ("x[1] | x[2]", "any(x[1], x[2])"),
    ("~x[1]", "nc(x[1])"),
    ("x[1] ^ x[2]", "any(all(x[1], nc(x[2])), all(nc(x[1]), x[2]))"),
    ("c.A * c.B + c.C", "any(all(c.A, c.B), c.C)"),
    ("True and c.A", "c.A"),
    # Chains, lists and choices
    ("not 0 < ds.A < 5", "any(0 >= ds.A, ds.A >= 5)"),
    ("nc(0 < ds.A < 5)", "any(0 >= ds.A, ds.A >= 5)"),
    ("x[1] and 0 < ds.A < 5", "all(x[1], 0 < ds.A, ds.A < 5)"),
    ("not ds.A in (1, 2)", "all(ds.A != 1, ds.A != 2)"),
    ("ds.A in range(1, 5)", "all(ds.A >= 1, ds.A < 5)"),
    ("ds.A in range(1, 5, 1)", "all(ds.A >= 1, ds.A < 5)"),
    ("ds.A not in range(1, 5)", "any(ds.A < 1, ds.A >= 5)"),
    ("ds.A in range(0, 6, 2)", "any(ds.A == 0, ds.A == 2, ds.A == 4)"),
    ("ds.A in ds[1:3]", "any(ds.A == ds[1], ds.A == ds[2])"),
    ("ds.A in 1, 2, 3", "any(ds.A == 1, ds.A == 2, ds.A == 3)"),
    ("ds.A == (1 or 2)", "any(ds.A == 1, ds.A == 2)"),
    ("(ds.A or ds.B) == 5", "any(ds.A == 5, ds.B == 5)"),
    ("x[1] if x[2] else x[3]", "any(all(x[2], x[1]), all(nc(x[2]), x[3]))"),
    ("x[1] if x[2] else False", "all(x[2], x[1])"),
    ("not (x[1] if x[2] else x[3])", "any(all(x[2], nc(x[1])), all(nc(x[2]), nc(x[3])))"),
    ("all(x[4], x[1] if x[2] else x[3])", "any(all(x[2], x[1]), all(nc(x[2]), x[3]))"),
    ("abs(ds.A) > 5", "any(ds.A > 5, ds.A < -5)"),
    ("max(ds.A, ds.B) > 5", "any(ds.A > 5, ds.B > 5)"),
    ("ds.A.between(1, 5)", "all(1 <= ds.A, ds.A <= 5)"),
    ("between(ds.A, 1, 5)", "all(1 <= ds.A, ds.A <= 5)"),
    # Words
    ("ds.A between 1 and 5", "all(1 <= ds.A, ds.A <= 5)"),
    ("x[1] and ds.A not between 1 and 5", "all(x[1], any(1 > ds.A, ds.A > 5))"),
    ("ds.A is greater than 5", "ds.A > 5"),
    ("ds.A at least 5", "ds.A >= 5"),
    ("ds.A less than or equal to 5", "ds.A <= 5"),
    ("x[1] on", "x[1]"),
    ("x[1] is off and x[2] on", "all(nc(x[1]), x[2])"),
    ("ds.A > 5 and < 10", "all(ds.A > 5, ds.A < 10)"),
    ("x[1] x[2]", "all(x[1], x[2])"),
    ("x[1] x[2]", "any(x[1], x[2])"),
    ("c.A c.B", "all(c.A, c.B)"),
    ("x[1] ds.A == 5", "all(x[1], ds.A == 5)"),
    ("not X1", "nc(x[1])"),
    ("XIC(x[1]) and XIO(x[2])", "all(x[1], nc(x[2]))"),
    ("t.A.done and x[1]", "all(t.A, x[1])"),
    # Quotes
    ('"c.Start"', "c.Start"),
    ('"c.Start and c.Stop"', "all(c.Start, c.Stop)"),
    ('"ds.A == 5"', "ds.A == 5"),
    ('all(c.A, "c.B")', "c.B"),
    # Values of another kind
    ('ds.A == "5"', "ds.A == 5"),
    ('ds.A == "A"', "ds.A == 65"),
    ("ds.A == 0x10", "ds.A == 16"),
    ("ds.A != 0xFFFF", "ds.A != -1"),
    ("dd.A == 0xFFFF", "dd.A == 65535"),
    ('df.A > "1.5"', "df.A > 1.5"),
    ('dh.A == "FF"', "dh.A == 0x00FF"),
    ('dh.A == "10"', "dh.A == 0x0010"),
    ('dh.A == "10"', "0x000A where 10 is decimal"),
    ("dh.A == -1", "dh.A == 0xFFFF"),
    ("txt[1] == 5", 'txt[1] == "5"'),
    ("txt.A == 0x41", 'txt.A == "A"'),
]


@pytest.mark.parametrize(("written", "meant"), SAID)
def test_a_condition_is_said_as_it_is_meant(written: str, meant: str, tmp_path: Path) -> None:
    problem = errors(under(written), tmp_path)[0]
    assert meant in problem.help
    if "where" not in meant:
        assert not [one for one in errors(under(meant), tmp_path) if one.code != "CG207"]


RUNG_BEFORE = [
    ("dh.A & 0x0001", ['math_hex("dh.A AND 0x0001", dh.Result)'], "dh.Result != 0"),
    ("dh.A & 0x0001 == 1", ['math_hex("dh.A AND 0x0001", dh.Result)'], "dh.Result == 1"),
    ("not dh.A & 4", ['math_hex("dh.A AND 0x0004", dh.Result)'], "dh.Result == 0"),
    ("dh.A & dh.B", ['math_hex("dh.A AND dh.B", dh.Result)'], "dh.Result != 0"),
    ("ds.A & 1", ["copy(ds.A, dh.Word)", 'math_hex("dh.Word AND 0x0001", dh.Result)'], "dh.Result != 0"),
    ("dd.A & 0x0008", ["copy_unpack(dd.A, c[1001:1033])"], "c[1004]"),
    ("~dh.A", ['math_hex("NOT dh.A", dh.Result)'], "dh.Result != 0"),
    ("ds.A % 2 == 0", ['calc("ds.A MOD 2", dd.Result)'], "dd.Result == 0"),
    ("x[1] and ds.A % 2 == 0", ['calc("ds.A MOD 2", dd.Result)'], "all(x[1], dd.Result == 0)"),
    ("not ds.A % 2 == 0", ['calc("ds.A MOD 2", dd.Result)'], "dd.Result != 0"),
    ("ds[1] + 1 > 5", ['calc("ds[1] + 1", dd.Result)'], "dd.Result > 5"),
    ("ds[1] > ds[2] + 5", ['calc("ds[2] + 5", dd.Result)'], "ds[1] > dd.Result"),
    ("1 <= ds.A + 1 <= 5", ['calc("ds.A + 1", dd.Result)'], "all(dd.Result >= 1, dd.Result <= 5)"),
    ("ds.A - (ds.B - ds.C) > 1", ['calc("ds.A - (ds.B - ds.C)", dd.Result)'], "dd.Result > 1"),
    ("ds.A // 2 == 1", ['calc("ds.A / 2", dd.Result)'], "dd.Result == 1"),
    ("ds.A ** 2 > 5", ['calc("ds.A ^ 2", dd.Result)'], "dd.Result > 5"),
    ("df.A * 2 > 1.5", ['calc("df.A * 2", df.Result)'], "df.Result > 1.5"),
    ("sqrt(ds.A) > 5", ['calc("SQRT(ds.A)", df.Result)'], "df.Result > 5"),
    ("ds[ds.I] + 1 > 5", ['calc("ds[ds.I] + 1", dd.Result)'], "dd.Result > 5"),
    ("ds.A in ds[1:99]", ["search(ds[1:99] == ds.A, result=ds.FoundAt, found=c.Found)"], "c.Found"),
    ("ds.A == dh.B", ["copy(dh.B, ds.Copy)"], "ds.A == ds.Copy"),
    ("ds.A == txt.B", ["copy(txt.B, ds.Copy, options=to_value)"], "ds.A == ds.Copy"),
    ("dh.A == 1.5", ["copy(dh.A, df.Copy)"], "df.Copy == 1.5"),
    ("txt[1] == 250", ["copy_pack(txt[1:4], dd.Value)"], "dd.Value == 250"),
]


@pytest.mark.parametrize(("written", "actions", "meant"), RUNG_BEFORE)
def test_a_calculation_gets_a_rung_before(written: str, actions: list[str], meant: str, tmp_path: Path) -> None:
    problem = errors(under(written), tmp_path)[0]
    rungs = [f"if True: {one}" for one in actions]
    many = "a rung" if len(rungs) == 1 else "rungs"
    assert problem.help.endswith(f"put {many} before it, {' and '.join(rungs)}, and write {meant}")
    assert problem.fix is None
    assert not errors(under(meant, "".join(f"    {rung}\n" for rung in rungs)), tmp_path)


@pytest.mark.parametrize(
    ("written", "asked", "meant"),
    [
        ("re(x[1]) == False", "if re(x[1]): out(c.Result)", "nc(c.Result)"),
        ("fe(x[1]) == 0", "if fe(x[1]): out(c.Result)", "nc(c.Result)"),
        ("re(x[1] and x[2])", "if all(x[1], x[2]): out(c.Edge)", "re(c.Edge)"),
        ("re(0 < ds.A < 5)", "if all(0 < ds.A, ds.A < 5): out(c.Edge)", "re(c.Edge)"),
        ("fe(ds.A)", "if ds.A: out(c.Edge)", "fe(c.Edge)"),
    ],
)
def test_an_edge_of_a_condition_gets_a_bit(written: str, asked: str, meant: str, tmp_path: Path) -> None:
    problem = errors(under(written), tmp_path)[0]
    assert f"in a rung before, {asked}, and write {meant}" in problem.help
    assert not errors(under(meant, f"    {asked}\n"), tmp_path)


PINS = [
    ("(x[2], x[3])", ["all(x[2], x[3])", "any(x[2], x[3])"]),
    ("[x[2]]", ["x[2]"]),
    ('"x[2]"', ["x[2]"]),
    ('"Reset"', ["c.Reset"]),
    ("X2", ["x[2]"]),
    ("x[2] == False", ["nc(x[2])"]),
    ("not x[2]", ["nc(x[2])"]),
    ("0 < ds.B < 5", ["all(0 < ds.B, ds.B < 5)"]),
    ("x[2] if x[3] else x[4]", ["any(all(x[3], x[2]), all(nc(x[3]), x[4]))"]),
    ("lambda signal: x[2]", ["x[2]"]),
]


@pytest.mark.parametrize("call", ["rton(t.A, 5, reset={})", "shift(c[1:9], clock=lambda: c.K, reset={})"])
@pytest.mark.parametrize(("written", "meant"), PINS)
def test_an_input_is_a_condition_behind_lambda(call: str, written: str, meant: list[str], tmp_path: Path) -> None:
    (problem,) = errors(action(call.format(written)), tmp_path)
    for text in meant:
        assert f"reset=lambda: {text}" in problem.help
        assert not errors(action(call.format(f"lambda: {text}")), tmp_path)


@pytest.mark.parametrize(("written", "meant"), [('"x[2]"', "x[2]"), ("x[2] == False", "nc(x[2])"), ("X2", "x[2]")])
def test_what_is_wrong_behind_lambda_is_said(written: str, meant: str, tmp_path: Path) -> None:
    for call in ("rton(t.A, 5, reset=lambda: {})", "rton(t.A, 5).reset({})"):
        (problem,) = errors(action(call.format(written)), tmp_path)
        assert f"write {meant}" in problem.help
        assert not errors(action(call.format(meant)), tmp_path)


def test_a_chained_input_has_no_lambda(tmp_path: Path) -> None:
    (problem,) = errors(action("rton(t.A, 5).reset(lambda: x[2])"), tmp_path)
    assert problem.help.startswith("write .reset(x[2]):")


DRIVEN = [
    ("x[1] and out(y[1])", "if x[1]: out(y[1])"),
    ("x[1] & out(y[1])", "if x[1]: out(y[1])"),
    ("x[1] or out(y[1])", "if nc(x[1]): out(y[1])"),
    ("x[1] and ds.A == 5 and out(y[1])", "if all(x[1], ds.A == 5): out(y[1])"),
    ("x[1] == True and OUT(y[1])", "if x[1]: out(y[1])"),
    ("x[1] and fill()", "if x[1]: call(fill)"),
    ("x[1], out(y[1])", "if x[1]: out(y[1])"),
    ("out(y[1]) if x[1] else None", "if x[1]: out(y[1])"),
    ("out(y[1]) if x[1] else out(y[2])", "if nc(x[1]): out(y[2])"),
    ("out(y[1]) if x[1]", "if x[1]: out(y[1])"),
    ("if x[1] then out(y[1])", "if x[1]: out(y[1])"),
    ("if x[1] out(y[1])", "if x[1]: out(y[1])"),
    ("x[1]: out(y[1])", "if x[1]: out(y[1])"),
    ("x[1] -> out(y[1])", "if x[1]: out(y[1])"),
    ("fill", "call(fill)"),
    ("Fill", "call(fill)"),
]


@pytest.mark.parametrize(("written", "meant"), DRIVEN)
def test_an_action_stands_under_its_condition(written: str, meant: str, tmp_path: Path) -> None:
    problem = errors(action(written), tmp_path)[0]
    assert meant in problem.help
    assert problem.fix is None or not problem.fix.is_safe
    assert not errors(action(meant), tmp_path)


@pytest.mark.parametrize("written", ["fill", "fill()"])
def test_a_subroutine_is_no_condition(written: str, tmp_path: Path) -> None:
    assert "call(fill)" in errors(under(written), tmp_path)[0].help


# -- timers -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("owner", "member", "meant"),
    [
        ("ton(t.A, 5)", "tt", "all(td.A > 0, nc(t.A))"),
        ("tof(t.A, 5)", "tt", "all(td.A > 0, t.A)"),
        ("tof(t.A, 5)", "running", "all(td.A > 0, t.A)"),
        ("rton(t.A, 5).reset(c.R)", "tt", "all(td.A > 0, nc(t.A))"),
        ("ton(t.A, 5)", "expired", "t.A"),
        ("tof(t.A, 5)", "expired", "nc(t.A)"),
        ("tof(t.A, 5)", "done", "t.A"),
    ],
)
def test_a_member_is_said_by_the_kind_of_its_timer(owner: str, member: str, meant: str, tmp_path: Path) -> None:
    text = f"    if x[1]:\n        {owner}\n    if {{}}:\n        out(y[1])\n"
    (problem,) = errors(program(text.format(f"t.A.{member}")), tmp_path)
    assert re.match(re.escape(f"write {meant}") + "(?:;|$)", problem.help)
    assert not errors(program(text.format(meant)), tmp_path)


def test_a_timer_of_another_file_may_be_of_either_kind(tmp_path: Path) -> None:
    (problem,) = errors(under("t.A.tt"), tmp_path)
    assert "(ton) write all(td.A > 0, nc(t.A))" in problem.help
    assert "(tof) all(td.A > 0, t.A)" in problem.help


def test_an_off_delay_is_reset_by_its_rung(tmp_path: Path) -> None:
    rungs = "    if x[1]:\n        tof(t.A, 5)\n    if x[2]:\n        reset(t.A)\n"
    (problem,) = errors(program(rungs), tmp_path)
    assert "a tof is reset when its rung comes on" in problem.help


# -- what must not be said --------------------------------------------------------------------------------------------


def fixed(text: str, folder: Path) -> str:
    fixes = [one.fix for one in errors(text, folder) if one.fix]
    return apply_fixes(text, fixes)[0] if fixes else text


@pytest.mark.parametrize("written", ["dh.A & dh.B", "~dh.A", "ds.A & 3", "~ds.A", "x[1] & ds.A"])
def test_single_bits_of_words_are_not_taken_for_logic(written: str, tmp_path: Path) -> None:
    """1 & 2 is 0, although both are not."""
    assert fixed(under(written), tmp_path) == under(written)


@pytest.mark.parametrize(
    "written", ["(c.Bits and x[1]) == False", "not (c.Bits == False)", "x[1] if c.Bits else x[2]", "nc(c.Bits == 1)"]
)
def test_a_block_has_no_opposite(written: str, tmp_path: Path) -> None:
    text = "nickname(c.Bits, c[10:14])\n\n\n" + under(written)
    assert fixed(text, tmp_path) == text
    assert "is the opposite of c.Bits" in errors(text, tmp_path)[0].help


def test_a_register_that_may_hold_no_number_gets_no_safe_fix(tmp_path: Path) -> None:
    (problem,) = errors(under("not 0 < df.A < 5"), tmp_path)
    assert problem.fix is not None
    assert not problem.fix.is_safe
    assert "(NaN)" in problem.help


def test_conditions_in_conditions_do_not_grow(tmp_path: Path) -> None:
    """A comparison of two conditions repeats each of them, which doubles with every level."""
    for head, tail in (("(", " == x[1])"), ("(x[2] if ", " else x[3])"), ("(x[2] ^ ", ")"), ("abs(", ") > 5")):
        text = head * 40 + "x[4]" + tail * 40
        assert found(under(text).encode(), "", tmp_path) or errors(under(text), tmp_path)


# -- meaning ----------------------------------------------------------------------------------------------------------

NUMBERS = st.integers(-2, 7)
BITS = st.sampled_from(["c[1]", "c[2]", "c[3]"])
SIGNS = st.sampled_from(["==", "!=", "<", "<=", ">", ">="])
COMPARED = st.one_of(
    st.builds("ds[1] {} {}".format, SIGNS, NUMBERS),
    st.builds("{} {} ds[1] {} {}".format, NUMBERS, SIGNS, SIGNS, NUMBERS),
    st.builds("ds[1] {} ({}, {})".format, st.sampled_from(["in", "not in"]), NUMBERS, NUMBERS),
    st.builds("ds[1] {} range({}, {})".format, st.sampled_from(["in", "not in"]), NUMBERS, st.integers(3, 9)),
    st.builds("abs(ds[1]) {} {}".format, SIGNS, st.integers(0, 5)),
    st.builds("{}(ds[1], ds[2]) {} {}".format, st.sampled_from(["max", "min"]), SIGNS, NUMBERS),
    st.builds("{} {} {}".format, BITS, st.sampled_from(["==", "!=", "is"]), st.sampled_from(["True", "False"])),
)
EXPRESSIONS = st.recursive(
    st.one_of(BITS, COMPARED),
    lambda inner: st.one_of(
        st.builds("(not {})".format, inner),
        st.builds("({} and {})".format, inner, inner),
        st.builds("({} or {})".format, inner, inner),
        st.builds("(({}) if ({}) else ({}))".format, inner, inner, st.one_of(inner, st.just("False"), st.just("True"))),
        st.builds("(({}) == ({}))".format, inner, inner),
        st.builds("(({}) != {})".format, inner, st.sampled_from(["True", "False"])),
        st.builds("(({}) ^ ({}))".format, inner, inner),
        st.builds("(({}) & ({}))".format, inner, inner),
    ),
    max_leaves=6,
)
STATES = [(bits, one, other) for bits in product((False, True), repeat=3) for one in range(-3, 8) for other in (-1, 4)]


def table(text: str) -> list[bool]:
    """The value of an expression in every state, as Python reads it; the functions of the language are its own."""
    code = compile(text, "", "eval")
    words = {
        "all": lambda *terms: builtins.all(terms),
        "any": lambda *terms: builtins.any(terms),
        "nc": operator.not_,
        "__builtins__": {"abs": abs, "max": max, "min": min, "range": range},
    }
    return [bool(eval(code, words | {"c": (None, *bits), "ds": (None, one, other)})) for bits, one, other in STATES]


@given(EXPRESSIONS, st.booleans())
def test_what_is_said_holds_exactly_when_the_expression_does(text: str, wanted: bool) -> None:
    context = Context(SourceFile("prog.py", text), Diagnostics())
    node = context.expression()
    assert node is not None
    said = meant(context, node, partial(fits_condition, context), wanted)
    if said is not None and not said.before:
        assert table(said.text) == [holds is wanted for holds in table(text)]
