"""A safe fix leaves no error in the statement that it fixes, and changes nothing inside a text."""

from __future__ import annotations

import tempfile
from pathlib import Path

import pytest
from budget import examples
from hypothesis import example, given
from hypothesis import strategies as st

from clickgen.api import check
from clickgen.dialects.if_rungs.ways_out.slips import SLIPS
from clickgen.problems.diagnostics import Diagnostic
from clickgen.text.edits import apply_fixes

TOP = """\
nickname(ds.Blk, ds[100:110])
nickname(c.Bits, c[100:104])
nickname(txt.Msg, txt[101:111])
nickname(t.Waits, t[11:14])
nickname(x.In, x[1])
nickname(sc.Clock, sc[7])


@sub
def fill():
    if c.A:
        out(c.Filled)

    if True:
        return


def main():
"""
REST = "    if True:\n        end()\n"
_LOOP = ("CG408", "CG409")
"""Another rung closes or opens a loop."""


def rung(statement: str) -> str:
    """A program with a wrong statement: the head of a rung, or an action in one."""
    first = statement.lstrip().lower()
    is_head = first.startswith(("if", "elif", "else", "while", "for", "def")) and statement.rstrip().endswith(":")
    inner = f"    {statement}\n        out(y[1])\n" if is_head else f"    if c.Go:\n        {statement}\n"
    return f"{TOP}{inner}{REST}"


def errors(text: str, folder: Path) -> list[Diagnostic]:
    path = folder / "prog.py"
    path.write_text(text, "utf-8")
    return [problem for problem in check(path).diagnostics if problem.is_error]


def is_statement(problem: Diagnostic) -> bool:
    """True for an error in the wrong statement, which is in the first rung of main."""
    first = TOP.count("\n") + 1
    return problem.span is None or first <= problem.span.line <= first + 1


def assert_safe_fixes_mend(statement: str, folder: Path) -> None:
    """Each safe fix, and those of the errors that come up in the statement then, leave it without an error."""
    text = rung(statement)
    for problem in errors(text, folder):
        if problem.fix is None or not problem.fix.is_safe or not is_statement(problem):
            continue
        mended, _ = apply_fixes(text, [problem.fix])
        for _ in range(6):
            left = [one for one in errors(mended, folder) if is_statement(one) and one.code not in _LOOP]
            safe = [one.fix for one in left if one.fix is not None and one.fix.is_safe]
            if not safe:
                break
            mended, _ = apply_fixes(mended, safe)
        assert not left, f"{statement}: {mended.splitlines()[TOP.count(chr(10)) :][:3]}: {left}"


@pytest.mark.parametrize("statement", [example for slip in SLIPS for example in slip.examples])
def test_slips(statement: str, tmp_path: Path) -> None:
    assert_safe_fixes_mend(statement, tmp_path)


BITS = [
    "c.A",
    "c.Bits",
    "c.Bits[1]",
    "x.In",
    "x[2]",
    "y[1]",
    "t.Wait",
    "t.Waits",
    "ct.N",
    "sc.Clock",
    "c[1:5]",
    "sc[1]",
]
NUMBERS = ["ds.One", "ds.Blk", "ds.Blk[3]", "dd.Long", "df.F", "dh.W", "td.Wait", "ctd.N", "sd[1]", "ds[1:5]", "xd[0]"]
TEXTS = ["txt.T", "txt.Msg", "txt[1:4]"]
VALUES = ["0", "5", "40000", "-3", "2.5", "True", "False", '"A"', "0x10", "ds[ds.One]", "TRUE"]
TARGETS = st.sampled_from([*BITS, *NUMBERS, *TEXTS])
SOURCES = st.sampled_from([*BITS, *NUMBERS, *TEXTS, *VALUES])
SHAPES = [
    "{a} = {b}",
    "{a} := {b}",
    "{a} := {b};",
    "{a} == {b}",
    "{a} += {b}",
    "{a} -= {b}",
    "{a} *= {b}",
    "{a} /= {b}",
    "{a} &= {b}",
    "{a}++",
    "{a} = {a} + {b}",
    "{a}: int = {b}",
    "if {a} AND {b}:",
    "if {a} && {b}:",
    "if !{a}:",
    "if not {a}:",
    "if NOT {a} OR {b}:",
    "if {a} and {b}:",
    "if {a} or not {b}:",
    "if ~{a} & {b}:",
    "if {a} = {b}:",
    "if {a} == {b}:",
    "if {a} is {b}:",
    "if {a} != {b}:",
    "if {a} => {b}:",
    "if {a} <> {b}:",
    "if 0 < {a} < {b}:",
    "if {a}.done:",
    "if {a}.acc > {b}:",
    "if NC({a}):",
    "if nc({a} == {b}):",
    "if true:",
    "If {a}:",
    "IF {a} THEN",
    "if {a}",
    "if {a}, {b}:",
    "if {a} \N{GREATER-THAN OR EQUAL TO} {b}:",
    "TON({a}, {b})",
    "ton({a}, preset={b})",
    "ton({a}, 5, unit=s)",
    "rton({a}, 5, reset={b})",
    "ctu({a}, 5).reset(lambda: {b})",
    "ctu({a}, 5, reset={b})",
    "COPY({b}, {a})",
    "copy({b}; {a})",
    "copy({b}, {a}, oneshot=true)",
    "copy({b}, {a}, oneshot=1)",
    "copy(\N{LEFT DOUBLE QUOTATION MARK}A\N{RIGHT DOUBLE QUOTATION MARK}, {a})",
    "copy({b}, {a})  // {b}",
    "OUT({a})",
    "out {a}",
    "out({a})  // on",
    "fill()",
    "Fill({a})",
    "main()",
    "for i in range({b}): copy({b}, {a})",
    "copy(\N{EN DASH}5, {a})",
    "shift({a}, clock={b}, reset=c.A)",
    "search({a} = {b}, result=ds.R, found=c.F)",
    "math_hex({b}, {a})",
    "calc({b} + 1, {a})",
    "copy(16#FF, {a})",
    "set({a}), reset({b})",
    "set({a}) reset({b})",
]


@example("{a} = {b}", "ds.Blk", "0")
@example("{a} += {b}", "ds.Blk", "5")
@example("{a} := {b}", "x[2]", "x.In")
@example("{a} := {b}", "ds.Blk", "0")
@examples(40)
@given(st.sampled_from(SHAPES), TARGETS, SOURCES)
def test_statements(shape: str, target: str, source: str) -> None:
    with tempfile.TemporaryDirectory() as name:
        assert_safe_fixes_mend(shape.format(a=target, b=source), Path(name))


# -- blocks -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("statement", "way"),
    [("ds.Blk = 0", "copy_fill(0, ds.Blk)"), ("ds.Blk += 1", "ds.Blk[0]"), ("ds.Blk := 0", "")],
)
def test_no_fix_writes_a_call_that_does_not_take_the_block(statement: str, way: str, tmp_path: Path) -> None:
    problems = [problem for problem in errors(rung(statement), tmp_path) if is_statement(problem)]
    assert [problem.fix for problem in problems] == [None]
    assert way in problems[0].help
    assert not problems[0].help.startswith("write c")


def test_the_table_says_what_is_a_block(tmp_path: Path) -> None:
    text = "def main():\n    if c.A:\n        ds.Tab = 0\n        ds.Reg = 0\n" + REST
    (tmp_path / "nicknames.csv").write_text(
        "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment\n"
        'DS1,INT,"",0,Yes,"<Tab>"\nDS4,INT,"",0,Yes,"</Tab>"\n'
    )
    fixes = {problem.span.line: problem.fix for problem in errors(text, tmp_path) if problem.span}
    assert fixes[3] is None
    assert fixes[4] is not None
    assert fixes[4].is_safe


def test_a_name_may_be_a_block_where_a_declaration_cannot_be_read(tmp_path: Path) -> None:
    text = "import wiring\n\n\ndef main():\n    if c.A:\n        ds.Reg = 0\n" + REST
    (tmp_path / "wiring.py").write_text("nickname(ds.Reg, ds[1:5)\n")
    fixes = [problem.fix for problem in errors(text, tmp_path) if problem.code == "CG112"]
    assert [fix.is_safe for fix in fixes if fix] == [False]


def test_a_fix_is_offered_beside_other_lines_that_cannot_be_read(tmp_path: Path) -> None:
    text = "def main():\n    if c.A AND c.B:\n        out(y[1])\n    if c.A ANDALSO c.B:\n        set y[2]\n" + REST
    [problem] = errors(text, tmp_path)
    assert problem.fix
    assert problem.fix.is_safe


def test_a_fix_beside_a_declaration_that_cannot_be_read_waits(tmp_path: Path) -> None:
    text = "def main():\n    if c.A:\n        ds.Reg := 0\n" + REST + "\n\nnickname(ds.Reg ds[1:5)\n"
    [problem] = errors(text, tmp_path)
    assert problem.fix is None


# -- signs of word processors -----------------------------------------------------------------------------------------

LEFT, RIGHT, DASH, APOSTROPHE, LOW = "\u201c", "\u201d", "\u2013", "\u2019", "\u201e"


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (f"nickname(c.A, c[1], comment={LEFT}up {DASH} down{RIGHT})", f'nickname(c.A, c[1], comment="up {DASH} down")'),
        (
            f"nickname(c.A, c[1], comment={LEFT}it{APOSTROPHE}s{RIGHT})",
            f'nickname(c.A, c[1], comment="it{APOSTROPHE}s")',
        ),
        (f"nickname(c.A, c[1], comment={LOW}auf{LEFT})", 'nickname(c.A, c[1], comment="auf")'),
        ("nickname(c.A, c[1], comment=\u00abauf\u00bb)", 'nickname(c.A, c[1], comment="auf")'),
        (f"nickname(c.A, c[1], comment={RIGHT}up{RIGHT})", 'nickname(c.A, c[1], comment="up")'),
        (f"nickname(c.A, c[1], comment=\u2018up {DASH} a\u2019)", f"nickname(c.A, c[1], comment='up {DASH} a')"),
        (
            f"nickname(c.A, c[1], comment={LEFT}up{RIGHT})  # it{APOSTROPHE}s {DASH} on",
            f'nickname(c.A, c[1], comment="up")  # it{APOSTROPHE}s {DASH} on',
        ),
        (
            f'nickname(ds.A, ds[1], comment="{DASH}", initial={DASH}5)',
            f'nickname(ds.A, ds[1], comment="{DASH}", initial=-5)',
        ),
    ],
)
def test_only_the_quotes_around_a_text_change(before: str, after: str, tmp_path: Path) -> None:
    program = f"{{}}\n\n\ndef main():\n{REST}"
    text = program.format(before)
    [problem] = errors(text, tmp_path)
    assert problem.fix
    mended, _ = apply_fixes(text, [problem.fix])
    assert mended == program.format(after)
    assert not errors(mended, tmp_path)


@pytest.mark.parametrize(
    "text",
    [
        f'copy({LEFT}5" pipe{RIGHT}, txt[1])',
        f"copy({LEFT}A, txt[1])",
        f"copy({LEFT}A {DASH} B{RIGHT}, txt[1])",
        "copy(c.It\u2019s, c.A)",
    ],
)
def test_no_fix_where_a_text_would_end_elsewhere_or_not_fit(text: str, tmp_path: Path) -> None:
    assert [problem.fix for problem in errors(rung(text), tmp_path)] == [None]
