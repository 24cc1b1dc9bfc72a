"""What people write by mistake: each mistake has a reason of its own, and a way out that builds."""

from __future__ import annotations

from pathlib import Path

import pytest
from mended import found

import clickgen
from clickgen.api import check
from clickgen.cli import main
from clickgen.config import Settings
from clickgen.dialects.if_rungs.ways_out import slips
from clickgen.problems.diagnostics import Diagnostic
from clickgen.problems.suggest import near_words
from clickgen.text.edits import apply_fixes

ENDING = "    if True:\n        end()\n"
SUB = "@sub\ndef fill():\n    if True:\n        return\n\n\n"


def condition(text: str) -> str:
    return f"def main():\n    if {text}:\n        out(y[1])\n{ENDING}"


def action(text: str) -> str:
    return f"{SUB}def main():\n    if re(c.Go):\n        {text}\n{ENDING}"


def errors(text: str, folder: Path) -> list[Diagnostic]:
    program = folder / "prog.py"
    program.write_text(text, "utf-8")
    (folder / "nicknames.csv").unlink(missing_ok=True)
    return [problem for problem in clickgen.build(program).diagnostics if problem.is_error]


def mended(text: str, folder: Path, unsafe: bool = False) -> str:
    """The program after the fixes of its errors, repeated while there are any."""
    for _ in range(6):
        fixes = [one.fix for one in errors(text, folder) if one.fix and (unsafe or one.fix.is_safe)]
        if not fixes:
            break
        text, _count = apply_fixes(text, fixes)
    return text


# The code as written, and the help's code instead: the second builds in place of the first.
CONDITIONS = [
    ("x[1] AND x[2]", "all(x[1], x[2])"),
    ("x[1] OR x[2] AND x[3]", "any(x[1], all(x[2], x[3]))"),
    ("x[1] && x[2]", "all(x[1], x[2])"),
    ("x[1]||x[2]", "any(x[1], x[2])"),
    ("!x[1]", "nc(x[1])"),
    ("NOT x[1]", "nc(x[1])"),
    ("x[1] ^ x[2]", "any(all(x[1], nc(x[2])), all(nc(x[1]), x[2]))"),
    ("x[1] == True", "x[1]"),
    ("x[1] == False", "nc(x[1])"),
    ("x[1] is True", "x[1]"),
    ("x[1] is not True", "nc(x[1])"),
    ("x[1] == 1", "x[1]"),
    ("x[1] != 0", "x[1]"),
    ("0 == c.A", "nc(c.A)"),
    ("c.A == on", "c.A"),
    ("x[1].immediate == True", "x[1].immediate"),
    ("c.A == c.B", "any(all(c.A, c.B), all(nc(c.A), nc(c.B)))"),
    ("c.A != c.B", "any(all(c.A, nc(c.B)), all(nc(c.A), c.B))"),
    ("x[1] = 1", "x[1]"),
    ("ds.A = 5", "ds.A == 5"),
    ("ds.A := 5", "ds.A == 5"),
    ("ds.A => 5", "ds.A >= 5"),
    ("ds.A =< 5", "ds.A <= 5"),
    ("ds.A <> 5", "ds.A != 5"),
    ("ds.A \N{GREATER-THAN OR EQUAL TO} 5", "ds.A >= 5"),
    ("nc(ds.A == 5)", "ds.A != 5"),
    ("nc(all(c.A, c.B))", "any(nc(c.A), nc(c.B))"),
    ("nc(nc(c.A))", "c.A"),
    ("re(nc(c.A))", "fe(c.A)"),
    ("0 < ds[1] < 10", "all(0 < ds[1], ds[1] < 10)"),
    ("0 < ds[1] <= ds.Max < 99", "all(0 < ds[1], ds[1] <= ds.Max, ds.Max < 99)"),
    ("ds.A in (1, 2)", "any(ds.A == 1, ds.A == 2)"),
    ("ds.A not in [1, 2]", "all(ds.A != 1, ds.A != 2)"),
    ("(c.A, c.B)", "all(c.A, c.B)"),
    ("c.A, c.B", "all(c.A, c.B)"),
    ('"X001"', "x[1]"),
    ("X001", "x[1]"),
    ("C5", "c[5]"),
    ("DS1", "ds[1]"),
    ("X[1]", "x[1]"),
    ("x(1)", "x[1]"),
    ("x.1", "x[1]"),
    ("x[001]", "x[1]"),
    ("x[1..4]", "x[1:5]"),
    ("m[5]", "c[5]"),
    ("i[0]", "x[1]"),
    ("v[2000]", "ds[2000]"),
    ("b3[1]", "c[1]"),
    ("I:0/1", "x[1]"),
    ("%I0.1", "x[1]"),
    ("N7:0", "ds[1]"),
    ("B3:0/1", "c[1]"),
    ("c.1st", 'c["1st"]'),
    ("c.My Name", 'c["My Name"]'),
    ("c.Start-Stop", "c.Start_Stop"),
    ("ds[1:4] == 0", "all(ds[1] == 0, ds[2] == 0, ds[3] == 0)"),
    ("dh.A == $FF", "dh.A == 0x00FF"),
    ("dh.A == 0FFh", "dh.A == 0x00FF"),
    ("ds.A == 16#FF", "ds.A == 255"),
    ("xd[0][3]", "x[4]"),
    ("1", "sc[1]"),
    ("ds[1] == True", "ds[1] != 0"),
    ("ds[1] != True", "ds[1] == 0"),
    ("c.A + c.B", "any(c.A, c.B)"),
    ("ds.A - 1", "ds.Result != 0"),
    ("False", "nc(sc[1])"),
]
ACTIONS = [
    ("c.Start = True", "set(c.Start)"),
    ("c.Start = True", "out(c.Start)"),
    ("c.Start = False", "reset(c.Start)"),
    ("y[1] = 1", "set(y[1])"),
    ("c.A = c.B and not c[3]", "if all(c.B, nc(c[3])): out(c.A)"),
    ("ds[1] = 5", "copy(5, ds[1])"),
    ("ds[1] += 1", 'calc("ds[1] + 1", ds[1])'),
    ("ds.A -= ds.B", 'calc("ds.A - ds.B", ds.A)'),
    ("ds.A = ds.B + 1", 'calc("ds.B + 1", ds.A)'),
    ("ds.A := 5;", "copy(5, ds.A)"),
    ("ds.A = c.B", "if c.B: copy(1, ds.A)"),
    ("ds.A++", 'calc("ds.A + 1", ds.A)'),
    ("ds.A == 5", "copy(5, ds.A)"),
    ("out y[1]", "out(y[1])"),
    ("out[y[1]]", "out(y[1])"),
    ("call fill", "call(fill)"),
    ("fill()", "call(fill)"),
    ("call(fill())", "call(fill)"),
    ("ton(t.A, setpoint=5.5, unit=Ts)", "ton(t.A, setpoint=5500, unit=Tms)"),
    ("ton(t.A, setpoint=5.5)", "ton(t.A, setpoint=5500, unit=Tms)"),
    ("ton(t.A, setpoint=60000)", "ton(t.A, setpoint=60, unit=Ts)"),
    ('ton(t.A, setpoint="5s")', "ton(t.A, setpoint=5, unit=Ts)"),
    ('ton(t.A, setpoint="T#500ms")', "ton(t.A, setpoint=500, unit=Tms)"),
    ("ton(t.A, 5s)", "ton(t.A, setpoint=5, unit=Ts)"),
    ("ton(t.A, T#1.5s)", "ton(t.A, setpoint=1500, unit=Tms)"),
    ('ton(t.A, 5, unit="s")', "ton(t.A, 5, unit=Ts)"),
    ("ton(t.A, 5, unit=seconds)", "ton(t.A, 5, unit=Ts)"),
    ("ton(t.A, preset=5)", "ton(t.A, setpoint=5)"),
    ("ton(t.A, PT=5)", "ton(t.A, setpoint=5)"),
    ("ton(t.A, pre=5, timebase=Ts)", "ton(t.A, setpoint=5, unit=Ts)"),
    ("rton(t.A, 5, reset=x[2])", "rton(t.A, 5, reset=lambda: x[2])"),
    ("rton(t.A, 5, reset=c.B and c.D)", "rton(t.A, 5, reset=lambda: all(c.B, c.D))"),
    ("reset(t.A)", "rton(t.A, setpoint=5, unit=Ts, reset=lambda: c.Clear)"),
    ("reset(ct[1])", "ctu(ct[1], setpoint=10, reset=lambda: c.Clear)"),
    ("set(t.A)", "set(c.Name)"),
    ("set(ds.A)", "copy(1, ds.A)"),
    ("copy(1, c.A)", "set(c.A)"),
    ("copy(0, c.A)", "reset(c.A)"),
    ('copy("SETTLE", txt[1:7])', 'copy("SETTLE", txt[1])'),
    ("copy(txt[4:10].as_value(), ds.A)", "copy_pack(txt[4:10], ds.A)"),
    ("copy(ds[1:5], ds[10])", "copy_block(ds[1:5], ds[10])"),
    ("copy(0, ds[10:15])", "copy_fill(0, ds[10:15])"),
    ("out(y[1], oneshot=true)", "out(y[1], oneshot=True)"),
    ("copy(5; ds.A)", "copy(5, ds.A)"),
    ("ctu.res(ct.A)", "ctu(ct.A, setpoint=10, reset=lambda: c.Clear)"),
]
ARGUMENTS = [
    ('out("Y001")', '"Y001"', "y[1]"),
    ("out(Y001)", "Y001", "y[1]"),
    ('out("Motor")', '"Motor"', "y.Motor"),
    ("ton(T1, 5)", "T1", "t[1]"),
    ('ton("Delay", 5)', '"Delay"', "t.Delay"),
    ('calc(f"{ds.A} * 2", ds.B)', 'f"{ds.A} * 2"', '"ds.A * 2"'),
    ("calc(ds.A + 1, ds.B)", "ds.A + 1", '"ds.A + 1"'),
]
MEMBERS = [
    ("t.A.done", "t.A"),
    ("t[1].dn", "t[1]"),
    ("t.A.acc > 5", "td.A"),
    ("ct[1].acc > 5", "ctd[1]"),
    ("t.A.tt", "all(td.A > 0, nc(t.A))"),
    ("t.A.off", "nc(t.A)"),
]


@pytest.mark.parametrize(("written", "meant"), CONDITIONS)
def test_the_way_out_of_a_condition_builds(written: str, meant: str, tmp_path: Path) -> None:
    problem = errors(condition(written), tmp_path)[0]
    assert meant in problem.help or (written.startswith(("ds", "dh")) and meant.split()[-1] in problem.help)
    assert "a program has Python's syntax" not in problem.help
    assert not errors(condition(meant), tmp_path)


@pytest.mark.parametrize(("written", "meant"), ACTIONS)
def test_the_way_out_of_an_action_builds(written: str, meant: str, tmp_path: Path) -> None:
    said = " ".join(problem.help for problem in errors(action(written), tmp_path))
    # For a call with one wrong argument, the message names the argument.
    changed = [part for part in meant.split(", ") if part not in written.split(", ")]
    assert meant in said or all(part.strip("()").removeprefix("ton(") in said for part in changed), said
    assert not errors(action(meant), tmp_path)


@pytest.mark.parametrize(("written", "wrong", "meant"), ARGUMENTS)
def test_the_way_out_of_an_argument_builds(written: str, wrong: str, meant: str, tmp_path: Path) -> None:
    (problem,) = errors(action(written), tmp_path)
    assert meant in problem.help
    assert not errors(action(written.replace(wrong, meant)), tmp_path)


@pytest.mark.parametrize(("written", "meant"), MEMBERS)
def test_members_of_a_timer_are_said(written: str, meant: str, tmp_path: Path) -> None:
    owners = (
        "    if c.Go:\n        ton(t.A, 5)\n        ton(t[1], 5)\n    if re(c.Go):\n        ctu(ct[1], 5).reset(c.R)\n"
    )
    text = f"def main():\n{owners}    if {{}}:\n        out(y[1])\n{ENDING}"
    (problem,) = errors(text.format(written), tmp_path)
    assert f"write {meant}" in problem.help
    assert not errors(text.format(written.replace(written.split()[0], meant)), tmp_path)


def test_a_bit_of_a_word_is_copied_out(tmp_path: Path) -> None:
    for written, word, last in (("ds[1][3]", "ds[1]", 1017), ("ds[1].3", "ds[1]", 1017), ("dd[2][3]", "dd[2]", 1033)):
        (problem,) = errors(condition(written), tmp_path)
        assert f"copy_unpack({word}, c[1001:{last}]), and bit 3 is c[1004]" in problem.help
        rungs = f"    if True:\n        copy_unpack({word}, c[1001:{last}])\n    if c[1004]:\n        out(y[1])\n"
        assert not errors(f"def main():\n{rungs}{ENDING}", tmp_path)


def test_a_text_is_compared_by_a_search(tmp_path: Path) -> None:
    (problem,) = errors(condition('txt[1:4] == "INV"'), tmp_path)
    search = 'search(txt[1:4] == "INV", result=ds.FoundAt, found=c.Found)'
    assert search in problem.help
    rungs = f"    if True:\n        {search}\n    if c.Found:\n        out(y[1])\n"
    assert not errors(f"def main():\n{rungs}{ENDING}", tmp_path)


def test_a_register_is_compared_with_a_text_by_a_search(tmp_path: Path) -> None:
    block = "nickname(txt.Msg, txt[11:21])\n\n\n"
    for written, cells in (('txt[1] == "INV"', "txt[1:4]"), ('txt.Msg == "INV"', "txt.Msg[0:3]")):
        problem = errors(block + condition(written), tmp_path)[-1]
        search = f'search({cells} == "INV", result=ds.FoundAt, found=c.Found)'
        assert search in problem.help
        rungs = f"    if True:\n        {search}\n    if c.Found:\n        out(y[1])\n"
        assert not errors(f"{block}def main():\n{rungs}{ENDING}", tmp_path)


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ('copy("SETTLE", txt.Msg)', ("txt.Msg[0]", 'copy("SETTLE", txt.Msg[0])')),
        ("copy(5, ds.Rec)", ("copy_fill(5, ds.Rec)", "copy_fill(5, ds.Rec)")),
        ("copy(ds.Rec, ds.Other)", ("copy_block(ds.Rec, ds.Other)", "copy_block(ds.Rec, ds.Other)")),
        ("copy(1, c.Bits)", ("set(c.Bits)", "set(c.Bits)")),
        ("copy(txt.Msg.as_value(), ds.Q)", ("copy_pack(txt.Msg, ds.Q)", "copy_pack(txt.Msg, ds.Q)")),
        ("copy(txt.Msg, txt[50])", ("txt.Msg[0]", "copy(txt.Msg[0], txt[50])")),
    ],
)
def test_a_block_in_a_copy(written: str, meant: tuple[str, str], tmp_path: Path) -> None:
    blocks = "nickname(txt.Msg, txt[1:11])\nnickname(c.Bits, c[1:9])\nnickname(ds.Rec, ds[1:9])\n\n\n"
    problem = errors(blocks + action(written), tmp_path)[0]
    assert meant[0] in problem.help
    assert not errors(blocks + action(meant[1]), tmp_path)


def test_a_constant_has_a_register(tmp_path: Path) -> None:
    (problem,) = errors(f"MAX = 5\n\n\n{condition('ds.A > 5')}", tmp_path)
    home = "nickname(ds.MAX, ds[1], initial=5, retentive=False)"
    assert "write 5 where it is used" in problem.help
    assert home in problem.help
    assert not errors(f"{home}\n\n\n{condition('ds.A > ds.MAX')}", tmp_path)


def test_only_banks_that_can_be_written_are_listed(tmp_path: Path) -> None:
    (problem,) = errors(action("copy(5, 10)"), tmp_path)
    assert "it takes an address in Y, C, SC, DS, DD, DH, DF, YD, TD, CTD, SD or TXT" in problem.message


def test_main_is_written_in_small_letters(tmp_path: Path) -> None:
    text = f"def Main():\n{ENDING}"
    (problem,) = errors(text, tmp_path)
    assert (problem.code, problem.help) == ("CG114", "write def main():")
    assert mended(text, tmp_path) == f"def main():\n{ENDING}"


def test_a_part_names_its_program(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "wiring.py").write_text("nickname(x.A, x[1])\n")
    (tmp_path / "parts.py").write_text("import wiring\n\n\n" + SUB)
    (tmp_path / "plant.py").write_text(f"from parts import fill\n\n\ndef main():\n{ENDING}")
    for part in ("parts.py", "wiring.py"):
        assert main(["build", str(tmp_path / part)]) == 1
        assert f"build {tmp_path / 'plant.py'}" in capsys.readouterr().err


# -- fixes ------------------------------------------------------------------------------------------------------------

FIXED = [
    (condition("x[1] AND x[2]"), condition("all(x[1], x[2])")),
    (condition("0 < ds[1] < 10"), condition("all(0 < ds[1], ds[1] < 10)")),
    (condition("(0 < ds[1]  # low\n        < 10)"), condition("(all(0 < ds[1], ds[1]  # low\n        < 10))")),
    (condition("x[1] == False"), condition("nc(x[1])")),
    (condition("nc(ds.A == 5)"), condition("ds.A != 5")),
    (condition("true"), condition("True")),
    (condition("t.A.done"), condition("t.A")),
    (action("TON(t.A, 5)"), action("ton(t.A, 5)")),
    (action("ds[1] = 5"), action("copy(5, ds[1])")),
    (action("ds[1] = 5  # five"), action("copy(5, ds[1])  # five")),
    (action("ds[1] += 1"), action('calc("ds[1] + 1", ds[1])')),
    (action("rton(t.A, 5, reset=x[2])"), action("rton(t.A, 5, reset=lambda: x[2])")),
    (action("fill()"), action("call(fill)")),
    (action("out(y[1])  // on"), action("out(y[1])  # on")),
    (action("for i in range(3): pass"), action("for _ in range(3): pass")),
]
NOT_SAFE = [
    condition("c.A == True"),
    condition("nc(df.A == 5)"),
    action("c.A = True"),
    action("OTL(y[1])"),
    action("ds.A = ds.B + 1"),
    action("ds.A /= 2"),
    action("df.A = df.B * 2"),
    action("dd.A = ds.B"),
]


@pytest.mark.parametrize(("before", "after"), FIXED)
def test_safe_fixes(before: str, after: str, tmp_path: Path) -> None:
    assert mended(before, tmp_path) == after


@pytest.mark.parametrize("text", NOT_SAFE)
def test_what_is_not_certain_is_no_safe_fix(text: str, tmp_path: Path) -> None:
    assert mended(text, tmp_path) == text
    assert mended(text, tmp_path, unsafe=True) != text


def test_deep_mistakes_are_looked_at_once(tmp_path: Path) -> None:
    """A way out is tried by reading it, which must not look for further ways out: that doubles with every level."""
    deep = 60
    for head, tail in (("nc(", ")"), ("re(", ")"), ("XIC(", ")"), ("all(nc(", "))"), ("0 < ", " < 5")):
        count = deep // 2 if head.startswith("all") else deep
        assert errors(condition(head * count + "ds.A" + tail * count), tmp_path)


def test_a_comment_sign_that_may_divide_is_left_alone(tmp_path: Path) -> None:
    text = action("ds.B = ds.A // 2 AND 3")
    assert mended(text, tmp_path) == text


def test_a_chain_with_parentheses_or_calls_is_left_alone(tmp_path: Path) -> None:
    for chain in ("0 < (ds[1]) < 10", "0 < ds[ds.I] < 10", "0 < ds[1] in 5"):
        assert not any(one.fix for one in found(condition(chain).encode(), "CG106", tmp_path))


# -- lines that Python cannot read ------------------------------------------------------------------------------------

EXAMPLES = [example for kind in slips.SLIPS for example in kind.examples]


@pytest.mark.parametrize("example", EXAMPLES)
def test_every_slip_tells_its_examples(example: str, tmp_path: Path) -> None:
    if example.startswith(("<", "=", ">", "def ", "DEF ", "main")):
        text = f"{example}\n"
    elif example.startswith(("else", "ELSE", "elseif", "ELSIF")):
        text = f"def main():\n    if c.A:\n        out(y[1])\n    {example}\n        out(y[2])\n"
    elif example.lower().startswith("if ") and example.count(":") != example.count(": "):
        text = f"def main():\n    {example}\n        out(y[1])\n"
    else:
        text = f"def main():\n    if c.A:\n        {example}\n"
    program = tmp_path / "prog.py"
    program.write_text(text, "utf-8")
    problems = check(program, Settings()).diagnostics
    assert problems, example
    assert not any(problem.message.startswith("Python cannot read") for problem in problems), problems
    assert all(problem.help for problem in problems if problem.code == "CG101")


def test_a_line_is_looked_at_in_time_that_grows_with_it() -> None:
    """Patterns with two open ends would take minutes here."""
    from clickgen.text.source import SourceFile

    for piece in ("(", "a ", "x.A", '"\\"', "  ", "0", "else ", ": ", "; (", "a.b[", "{ ", "lambda "):
        source = SourceFile("prog.py", (piece * 2000)[: slips._LINE_MAX])
        slips.slip(source, 1, "invalid syntax")
    assert slips.slip(SourceFile("prog.py", "(" * (slips._LINE_MAX + 1)), 1, "invalid syntax") is None


# -- clickgen explain -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("words", "begins"),
    [
        (["TON"], "ton\n"),
        (["for"], "for\n"),
        (["return"], "return\n"),
        (["cg501"], "CG501: "),
        (["conditions"], "Conditions\n"),
        (["loops"], "Loops and subroutines\n"),
        (["nc"], "Conditions\n"),
        (["instructions"], "Instructions\n"),
        (["XIC"], "In a condition: write c.A"),
        (["OTU"], "As an action: write reset(y.Motor)"),
        (["n7"], "As a bank: 16-bit integers are in DS"),
        ([], "clickgen explain NAME\n"),
    ],
)
def test_explain(words: list[str], begins: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["explain", *words]) == 0
    assert capsys.readouterr().out.startswith(begins)


def test_explain_knows_a_slip(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["explain", "cuont"]) == 2
    assert main(["explain", "calcc"]) == 2
    assert "did you mean calc?" in capsys.readouterr().err


# -- signs that bind otherwise than Python's words --------------------------------------------------------------------


@pytest.mark.parametrize(
    "line",
    [
        "NOT x[1] & x[2]",
        "!x[1] & x[2]",
        "!x[1] | x[2]",
        "x[3] AND NOT x[1] & x[2]",
        "x[1] && !x[2] & x[3]",
        "!ds[1] >= 1",
        "NOT ds[1] == 5",
    ],
)
def test_a_not_of_another_language_takes_the_next_term_alone(line: str, tmp_path: Path) -> None:
    """Python's not takes a whole comparison, and & and | too: no fix, and no way out, may read the line so."""
    text = condition(line)
    assert mended(text, tmp_path) == mended(text, tmp_path, unsafe=True) == text
    [problem] = found(text.encode(), "CG101", tmp_path)
    assert "write what belongs together" in problem.help


def test_a_nickname_that_is_a_word_of_logic_is_left_alone(tmp_path: Path) -> None:
    assert mended(condition("c.Not && x[1]"), tmp_path) == condition("all(c.Not, x[1])")


def test_zeros_before_a_number_may_be_a_hexadecimal_constant(tmp_path: Path) -> None:
    text = condition("dh.Code == 0010")
    assert mended(text, tmp_path, unsafe=True) == text
    [problem] = found(text.encode(), "CG101", tmp_path)
    assert problem.help == "write 10, or 0x0010 where it is hexadecimal"


@pytest.mark.parametrize("asked", ["c.Bits == False", "c.Bits == 0", "c.Bits != True", "False == c.Bits"])
def test_a_block_that_is_compared_with_false_has_no_opposite(asked: str, tmp_path: Path) -> None:
    text = f"nickname(c.Bits, c[10:14])\n\n\n{condition(asked)}"
    assert mended(text, tmp_path, unsafe=True) == text
    [problem] = found(text.encode(), "CG303", tmp_path)
    assert "nothing in the language is the opposite of c.Bits" in problem.help


WORDS_OF_OTHERS = ["ANB", "ANL", "ANS", "ABL", "SIGN", "SGN", "RND", "RAND", "LSR", "LRR", "SINH", "SRET"]


@pytest.mark.parametrize("word", WORDS_OF_OTHERS)
def test_a_word_of_another_machine_is_no_misspelling_of_a_short_one(word: str) -> None:
    known = ["all", "any", "nc", "re", "fe", "set", "SIN", "COS", "TAN", "RAD", "SUM", "LSH", "LRO", "LOG"]
    assert near_words(word, known) == []
