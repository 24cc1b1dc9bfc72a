"""Tokens that the language has no word for: kept to the letter, with no assumptions about what they do."""

from __future__ import annotations

import csv
import io
import sys
from pathlib import Path

import pytest
from budget import examples
from hypothesis import given
from hypothesis import strategies as st
from judges.codec import assert_codec_reads
from judges.power import check_limits, check_no_backfeed, read_ladder
from test_importing_cases import CASE_NAMES, golden_ladders

import clickgen
from clickgen.api import check
from clickgen.cli import main
from clickgen.click.draw.tokens import action_token, operand_token
from clickgen.click.read.kept import fault_of, raw_of
from clickgen.click.read.rungs import import_rung
from clickgen.click.read.tokens import height_of
from clickgen.dialects.registry import default
from clickgen.instructions.raw import RAW, rows_of
from clickgen.ir.operands import Cell, Pointer, Range
from clickgen.ir.program import KeptToken
from clickgen.ir.reach import touches
from clickgen.results import BuildResult
from clickgen.text.source import Span

HERE = Span("main.csv", 1, 1, 1, 2)

# From real projects: laddercodec 0.2.2, tests/fixtures/coverage/golden/raw_instructions__*.bin, which are clipboard
# buffers of CLICK, as its decode and decoded_rung_to_rows write them.
CAPTURED = {
    "Email": (
        'raw(Email,0x2737,1,60a5=1,60a6=,60a7=,2237=0,6235="TEST",6236="TEST",60ae=,60af=,2206=0,2238=0,6217="TEST",'
        '622a="TEST",6081=,6082=,607c=C1,607b=C2,607d=C3,6083=DS1,2239=0,68b1[250]=,68b0[250]=,20ca=2,3218=9748,0000=)'
    ),
    "Home": (
        "raw(Home,0x2734,1,222d=0,222e=0,6096=1,6097=1,609e=,609f=X004,60a0=X005,609c=1,609d=1,222f=0,11f5=0,2230=0,"
        "60a1=,60a3=,60a4=,607b=,607d=,6083=,2232=0,2233=0,3218=9738,0000=)"
    ),
    "Position": (
        "raw(Position,0x2736,1,222d=0,6098=1,6099=,609a=,2206=0,609b=1,609c=1,609d=1,222f=2,11f5=0,2231=0,60a2=,"
        "60a3=,60a4=,607b=,607d=,6083=,3218=9745,0000=)"
    ),
    "Velocity": (
        "raw(Velocity,0x2735,1,222d=0,609b=1,609c=1,609d=1,222f=2,11f5=0,2231=0,60a2=,60a3=,60a4=,607b=,607d=,6083=,"
        "3218=9744,0000=)"
    ),
}
MADE_UP = {
    "three rows": "raw(X,0x2711,3,0000=)",  # laddercodec's own, tests/csv/test_writer.py
    "two rows": "raw(Odd,0x2799,2,60aa=DS1..DS5,0000=)",
    "all rows": "raw(Odd,0x2799,32,0000=)",
    "a comma in quotes": 'raw(Odd,0x2799,1,6235="a, b",0000=)',
    "quotes in quotes": 'raw(Odd,0x2799,1,6235="say ""go""",0000=)',
    "other letters": "raw(Odd,0x2799,1,6235=Größe €,0000=)",
    "a backslash": "raw(Odd,0x2799,1,6235=a\\nb,0000=)",
    "braces": "raw(Odd,0x2799,1,6235={token},0000=)",
    "a formula": "math(DS1+DS2,DS3,mode=decimal)",
    "a formula with a one-shot": "math(DS1 MOD DS2 * DS3,DS4,mode=decimal,oneshot=1)",
    "a hexadecimal formula": "math(DH1 AND DH2 OR DH3,DH4,mode=hex)",
}
TOKENS = CAPTURED | MADE_UP
HEIGHTS = {"three rows": 3, "two rows": 2, "all rows": 32}

each_token = pytest.mark.parametrize("name", TOKENS)

END = "\n    if True:\n        end()\n"


def build(folder: Path, text: str) -> BuildResult:
    program = folder / "prog.py"
    program.write_text(text, "utf-8")
    return clickgen.build(program)


def ladder(folder: Path, body: str) -> str:
    """The ladder of a main with these rungs, which outside readers take."""
    result = build(folder, f"def main():\n{body}{END}")
    assert result.ok, result.diagnostics
    text = result.files["main.csv"]
    rungs = read_ladder(text)
    check_limits(rungs)
    for rung in rungs:
        check_no_backfeed(rung)
    assert_codec_reads(text)
    return text


def outputs(text: str) -> list[str]:
    return [row[-1] for row in list(csv.reader(io.StringIO(text)))[1:] if row[0] != "#" and row[-1]]


def written(token: str) -> str:
    """The instruction as a program has it."""
    return f"raw({token!r})"


# -- the token --------------------------------------------------------------------------------------------------------


@each_token
def test_a_token_is_built_to_the_letter(name: str, tmp_path: Path) -> None:
    assert outputs(ladder(tmp_path, f"    if c.Go:\n        {written(TOKENS[name])}\n")) == [TOKENS[name], "end()"]


SHAPES = {
    "first of several": "    if c.Go:\n        {raw}\n        out(c.A)\n        set(c.B)\n",
    "last of several": "    if c.Go:\n        out(c.A)\n        {raw}\n",
    "between tall boxes": "    if c.Go:\n        copy(ds.A, ds.B)\n        {raw}\n        copy(ds.B, ds.C)\n",
    "behind alternatives": "    if any(c.Go, all(c.A, x[1]), c.B):\n        {raw}\n",
    "in branches": "    if c.Go:\n        if c.A:\n            {raw}\n        if c.B:\n            {raw}\n",
    "twice": "    if any(c.Go, c.A):\n        {raw}\n        {raw}\n",
    "beside a counter": "    if c.Go:\n        {raw}\n        ctu(ct.N, 5, reset=lambda: c.A)\n        {raw}\n",
    "in a loop": "    if c.Go:\n        for _ in range(3):\n            if c.A:\n                {raw}\n",
}


@pytest.mark.parametrize("shape", SHAPES)
@each_token
def test_it_stands_among_others(name: str, shape: str, tmp_path: Path) -> None:
    text = ladder(tmp_path, SHAPES[shape].format(raw=written(TOKENS[name])))
    assert outputs(text).count(TOKENS[name]) == SHAPES[shape].count("{raw}")


@each_token
def test_its_height_is_its_own(name: str, tmp_path: Path) -> None:
    token = TOKENS[name]
    height = HEIGHTS.get(name, 1)
    kept = raw_of(token, HERE)
    assert kept is not None
    assert kept.height == rows_of(token) == height_of(token) == height
    (rung, _) = assert_codec_reads(ladder(tmp_path, f"    if c.Go:\n        {written(token)}\n"))
    assert rung.logical_rows == height


def test_tall_ones_are_divided_over_several_rungs(tmp_path: Path) -> None:
    tall = "".join(f"        {written(f'raw(Odd,0x2799,10,60aa={n},0000=)')}\n" for n in range(1, 8))
    text = ladder(tmp_path, f"    if c.Go:\n{tall}")
    # One rung for the scratch bit, three for the seven boxes, and the end.
    assert [len(rung.rows) for rung in read_ladder(text)] == [1, 30, 30, 10, 1]


@pytest.mark.parametrize("name", CAPTURED)
def test_an_import_keeps_it(name: str, tmp_path: Path) -> None:
    from clickgen.click.read.grid import read_ladder as read_drawn
    from clickgen.click.read.rungs import routine_of
    from clickgen.dialects.if_rungs.write.routine import write_source

    first = ladder(tmp_path, f"    if any(c[1], c[2]):\n        out(y[1])\n        {written(CAPTURED[name])}\n")
    rungs = [import_rung(rung).rung for rung in read_drawn(first, "main.csv").rungs]
    source = write_source([routine_of("main", rungs, True)])
    assert build(tmp_path, source).files["main.csv"] == first


def test_laddercodec_is_loaded_only_where_something_is_kept(tmp_path: Path) -> None:
    import subprocess

    for token, expected in (("out(c.A)", "False"), (written(CAPTURED["Home"]), "True")):
        (tmp_path / "prog.py").write_text(f"def main():\n    if c.Go:\n        {token}\n{END}")
        code = "import sys, clickgen\nassert clickgen.build('prog.py').ok\nprint('laddercodec' in sys.modules)"
        run = [sys.executable, "-c", code]
        done = subprocess.run(run, cwd=tmp_path, capture_output=True, text=True, check=True)
        assert done.stdout.strip() == expected


# -- what is not kept -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", [name for name in CASE_NAMES if name != RAW.name])
def test_no_token_is_kept_that_has_a_word(name: str) -> None:
    for text in golden_ladders(name).values():
        for token in outputs(text):
            assert token.startswith(".") or raw_of(token, HERE) is None, token


REFUSED = {
    "out(Y001)": "the language has a word for it: write out(",
    "latch(C1)": "the language has a word for it: write set(",
    "NOP": "the language has a word for it: write pass",
    "for(3)": "the language has a word for it: write for _ in range",
    "shift(C1..C8)": "the language has a word for it: write shift(",
    'copy("$0D",TXT1)': "the language has a word for it: write copy(",
    "math(DS1 + DS2,DS3,mode=decimal)": "the language has a word for it: write calc(",
    "math(DH1 AND DH2,DH3,mode=hex)": "the language has a word for it: write math_hex(",
    "math(DS1  +DS2,DS3,mode=decimal)": "otherwise: write math(DS1 +DS2,DS3,mode=decimal)",
    "math(DS1+DS2,DS3)": "it is no math(formula,destination",
    "math(DS1+DS2,X001,mode=decimal)": "calc does not write X001",
    "math(DS1+DS2,SD1,mode=decimal)": "calc does not write SD1",
    "math(DS1+DS2,DH1,mode=decimal)": "calc does not write DH1",
    "math(DS1+DS2,DS3,mode=decimal,oneshot=2)": "laddercodec",
    ".reset()": "it is no raw(...)",
    "dance(C1)": "it is no raw(...)",
    "": "it is no raw(...)",
    " raw(Odd,0x2799,1,0000=)": "it is no raw(...)",
    "raw(Odd,0x2799,1,0000=) ": "does not write such a token",
    "raw(Odd,0x2799,1,0000=": "does not write such a token",
    "raw(Odd,0x2799,1,68b1[99999999]=)": "does not write such a token",
    "raw(Odd,0x2799,0,0000=)": "does not write such a token",
    "raw(Odd,0x2799,33,0000=)": "33 rows tall",
    "raw(Odd,0x2799,1,60AA=DS1)": "otherwise: write raw(Odd,0x2799,1,60aa=DS1)",
    "raw(Odd,0x0002799,1,60aa=DS1)": "otherwise: write raw(Odd,0x2799,1,60aa=DS1)",
    "raw(Odd,0x2799,1,DS1)": "laddercodec does not read it",
    "raw(Home,0x2734,2,0000=)": "otherwise: write raw(Home,0x2734,1,222d=0",
    "raw(Odd,0x2799,1,6235=a\nb)": "a line break or a control character",
    "raw(Odd,0x2799,1,6235=a\x00b)": "a line break or a control character",
    "raw(Odd,0x2799,1,6235=a\u2028b)": "a line break or a control character",
    "raw(Odd,0x2799,1,6235=a\ud800b)": "a line break or a control character",
}


@pytest.mark.parametrize("token", REFUSED, ids=ascii)
def test_what_cannot_be_kept_is_refused_with_a_way_out(token: str, tmp_path: Path) -> None:
    fault = fault_of(token)
    assert fault is not None
    assert fault.help
    assert REFUSED[token] in f"{fault.message}: {fault.way_out(default().spell)}"
    assert raw_of(token, HERE) is None
    result = build(tmp_path, f"def main():\n    if c.Go:\n        raw({token!a})\n{END}")
    assert [problem.code for problem in result.diagnostics] == ["CG317"]
    assert not result.files


def test_a_coil_in_the_binary_form_is_no_way_around_the_word() -> None:
    """laddercodec shows the binary form of a coil as raw on request; read back it is a coil."""
    from laddercodec.csv.converter import af_node_to_token
    from laddercodec.csv.token_parser import parse_af_token
    from laddercodec.instructions.raw import RawInstruction, find_blob_boundary

    for token, word in (("out(C1)", "out("), ('call("other")', "call("), ("return()", "return")):
        blob = af_node_to_token(parse_af_token(token)).build_blob()
        disguised = RawInstruction(class_name=find_blob_boundary(blob)[0], blob=blob).to_csv()
        assert disguised.startswith("raw(")
        fault = fault_of(disguised)
        assert fault is not None
        assert f"write {word}" in fault.way_out(default().spell)


TEXTS = st.text(st.characters(codec="utf-16", exclude_categories=("Cc", "Cs")), max_size=12)
FIELDS = st.tuples(st.integers(0x1000, 0xFFFF), TEXTS | st.sampled_from(["DS1", "C1..C8", "", "0", '"a"']))


@examples(15)
@given(
    st.sampled_from(["Odd", "Email", "Home", "Out", "Copy", "Tmr"]), st.integers(1, 33), st.lists(FIELDS, max_size=4)
)
def test_what_is_kept_laddercodec_reads_and_writes_so(name: str, rows: int, fields: list[tuple[int, str]]) -> None:
    token = f"raw({','.join([name, '0x2799', str(rows), *(f'{tag:04x}={value}' for tag, value in fields)])})"
    kept = raw_of(token, HERE)
    if kept is None:
        return
    assert action_token(kept) == token
    line = io.StringIO()
    header = ["marker", *map(chr, range(65, 91)), "AA", "AB", "AC", "AD", "AE", "AF"]
    csv.writer(line, lineterminator="\n").writerows([header, ["R", *["-"] * 31, token]])
    (rung,) = assert_codec_reads(line.getvalue())
    assert rung.logical_rows == rows


# -- its addresses ----------------------------------------------------------------------------------------------------

NAMED = {
    "raw(Odd,0x2799,1,60aa=DS5)": "DS5",
    "raw(Odd,0x2799,1,60aa=DS5,60ab=X001,60ac=XD0u)": "DS5 X001 XD0u",
    "raw(Odd,0x2799,1,60aa=DS1..DS5)": "DS1..DS5",
    "raw(Odd,0x2799,1,60aa=DS1 : DS5)": "DS1..DS5",
    "raw(Odd,0x2799,1,60aa=DS1-DS5)": "DS1..DS5",
    "raw(Odd,0x2799,1,60aa=C8..C1)": "C1..C8",
    "raw(Odd,0x2799,1,60aa=Y015..Y022)": "Y015..Y016 Y021..Y022",
    "raw(Odd,0x2799,1,60aa=DS1..DD5)": "DS1 DD5",
    "raw(Odd,0x2799,1,60aa=ds5,60ab=x1)": "DS5 X001",
    'raw(Odd,0x2799,1,6235="Level ds5, and [C7]")': "DS5 C7",
    "raw(Odd,0x2799,1,60aa=TXT[DS2],60ab=CT1)": "TXT[DS2] DS2 CT1",
    "raw(Odd,0x2799,1,60aa=X[DS2])": "DS2",
    "raw(Odd,0x2799,1,c123=DS1,dd12:00000000=C3,df10[5]=)": "DS1 C3",
    "raw(Odd,0x2799,1,60aa=DS0,60ab=DS4501,60ac=ADS5,60ad=DS5x,60ae=Q1,60af=X017)": "",
    "math(DS1-DS5 * SUM ( DS10 : DS12 ),DD3,mode=decimal)": "DS1 DS5 DS10..DS12 DD3",
    f"raw(Odd,0x2799,1,60aa=DS{'1' * 5000})": "",
}


@pytest.mark.parametrize("token", NAMED, ids=lambda token: token[:70])
def test_every_address_is_found(token: str, tmp_path: Path) -> None:
    program = tmp_path / "prog.py"
    program.write_text(f"def main():\n    if c.Go:\n        raw({token!r})\n{END}")
    facts = clickgen.build(program).facts
    assert facts is not None
    action = facts.actions[0].action
    kept = action.args["token"]
    assert isinstance(kept, KeptToken)
    assert " ".join(map(operand_token, kept.operands)) == NAMED[token]
    accesses = {(operand_token(touch.operand), touch.is_written) for touch in touches(action)}
    assert accesses == {(operand_token(operand), is_written) for operand in kept.operands for is_written in (0, 1)}
    for operand in kept.operands:
        assert isinstance(operand, Cell | Range | Pointer)
        line = program.read_text().split("\n")[operand.span.line - 1]
        assert line[operand.span.col - 1 : operand.span.end_col - 1] in token


def test_no_name_gets_an_address_that_stands_in_a_token(tmp_path: Path) -> None:
    body = '    if c.Go:\n        raw("raw(Odd,0x2799,1,60aa=C1,60ab=DS1..DS5,60ac=T1,60ad=C2000,0000=)")\n'
    body += "        copy(1, ds.A)\n        ton(t.B, 5)\n        ctu(ct.C, 5, reset=lambda: c.D)\n"
    result = build(tmp_path, f"def main():\n{body}{END}")
    assert result.ok
    found = {row.nickname: str(row.address) for row in result.rows}
    assert found["Go"] == "C2"
    assert found["A"] == "DS6"
    assert found["B"] == "T2"
    assert {name for name in found if name.startswith("Scratch")} == {"Scratch_C1999", "Scratch_C1998"}
    again = build(tmp_path, f"def main():\n{body}{END}")
    assert again.rows == result.rows


def test_a_scratch_cell_is_not_taken_for_it(tmp_path: Path) -> None:
    before = "def main():\n    if c.Go:\n        set(c.Go)\n        ctu(ct.C, 5, reset=lambda: c.D)\n" + END
    build(tmp_path, before).write(tmp_path / "out")
    text = before.replace("        set", '        raw("raw(Odd,0x2799,1,60aa=C2000,0000=)")\n        set')
    [problem] = build(tmp_path, text).diagnostics
    assert problem.code == "CG205"
    assert problem.span is not None
    assert text.split("\n")[problem.span.line - 1][problem.span.col - 1 :].startswith("C2000,")


def test_the_bit_of_an_emulated_timer_has_no_place_in_a_token(tmp_path: Path) -> None:
    body = "    if c.Go:\n        rtof(t[3], 5, reset=lambda: c.R)\n        raw('raw(Odd,0x2799,1,60aa={})')\n"
    for operand, codes in (("T3", {"CG301", "CG420"}), ("T1..T5", {"CG301", "CG420"}), ("T4", {"CG420"})):
        result = build(tmp_path, f"def main():\n{body.format(operand)}{END}")
        assert {problem.code for problem in result.diagnostics} == codes


def test_a_name_that_only_a_token_uses_is_not_pruned(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    program = tmp_path / "prog.py"
    program.write_text(f"def main():\n    if c.Go:\n        copy(1, ds.Kept)\n        copy(2, ds.Gone)\n{END}")
    assert main(["nicknames", "sync", str(program)]) == 0
    program.write_text(f"def main():\n    if c.Go:\n        raw('raw(Odd,0x2799,1,60aa=DS1..DS1,0000=)')\n{END}")
    assert main(["nicknames", "sync", "--prune", str(program)]) == 0
    table = (tmp_path / "nicknames.csv").read_text()
    assert '"Kept"' in table
    assert '"Gone"' not in table
    capsys.readouterr()
    assert main(["nicknames", "why", "Kept", str(program)]) == 0
    assert "prog.py:3" in capsys.readouterr().out


# -- what it may do ---------------------------------------------------------------------------------------------------

COUNTER = "        ctu(ct.N, 5, reset=lambda: nc(c.Also))\n"
KEPT = "        raw('raw(Odd,0x2799,1,0000=)')\n"
KEPT_LATER = "raw(Odd,0x2799,1,60aa=DS5,0000=)"


@pytest.mark.parametrize(
    ("body", "rungs"),
    [
        # Two scratch bits: the rung's condition and the counter's input.
        (f"    if c.Go:\n{KEPT}{COUNTER}", 4),
        # The rest after the counter is in a part of its own, and sees the condition as it was.
        (f"    if c.Go:\n{COUNTER}{KEPT}", 2),
        (f"    if True:\n{KEPT}        ctu(ct.N, 5, reset=lambda: sc[1])\n", 3),
        (f"    if True:\n{KEPT}        set(c.A)\n", 1),
        (f"    if c.Go:\n        call(other)\n{COUNTER}", 4),
    ],
)
def test_behind_it_no_condition_is_looked_at_again(body: str, rungs: int, tmp_path: Path) -> None:
    other = f"\n\n@sub\ndef other():\n    if c.X:\n{KEPT}\n    if True:\n        return\n" if "call" in body else ""
    result = build(tmp_path, f"def main():\n{body}{END}{other}")
    assert result.ok
    assert len(read_ladder(result.files["main.csv"])) == rungs + 1


# Each of these is a finding without the kept instruction.
SUSPICIOUS = {
    "CG502": ("    if x[1]:\n        set(c[1])\n", "C1"),
    "CG503": ("    if x[1]:\n        reset(c[1])\n", "C1"),
    "CG504": ("    if c[1]:\n        out(y[1])\n", "C1"),
    "CG505": ("    if x[1]:\n        copy(1, ds[1])\n", "DS1"),
    "CG510": (
        "    if x[1]:\n        copy(1, ds[1])\n{raw}        copy(2, ds[1])\n    if ds[1] == 2:\n        out(y[1])\n",
        "DS7",
    ),
    "CG521": ("    if t[1]:\n        out(y[1])\n", "T1"),
}


@pytest.mark.parametrize("code", SUSPICIOUS)
def test_a_rule_about_logic_counts_its_addresses(code: str, tmp_path: Path) -> None:
    body, address = SUSPICIOUS[code]
    raw = f"        raw('raw(Odd,0x2799,1,60aa={address},0000=)')\n"
    here, behind = (raw, "") if "{raw}" in body else ("", f"    if x[2]:\n{raw}")
    program = tmp_path / "prog.py"
    found = []
    for kept in (False, True):
        text = body.format(raw=here if kept else "") + (behind if kept else "")
        program.write_text(f"def main():\n{text}{END}")
        found.append({problem.code for problem in check(program).diagnostics})
    assert code in found[0]
    assert found[1] == set()


@pytest.mark.parametrize(("token", "is_found"), [("math(DS1+DS2,DS5,mode=decimal)", True), (KEPT_LATER, False)])
def test_what_a_kept_formula_writes_does_not_change_by_itself(token: str, is_found: bool, tmp_path: Path) -> None:
    """A formula runs at once like any other; what another kept instruction writes may change in its own time."""
    twice = "    if ds[5] == 1:\n        copy(1, ds.X)\n    if ds[5] == 1:\n        copy(2, ds.X)\n"
    read = "    if ds.X == 2:\n        out(y[1])\n"
    program = tmp_path / "prog.py"
    program.write_text(f"def main():\n{twice}{read}    if x[1]:\n        raw({token!r})\n{END}")
    assert ("CG510" in {problem.code for problem in check(program).diagnostics}) is is_found


def test_an_output_in_a_token_is_not_said_to_be_driven(tmp_path: Path) -> None:
    program = tmp_path / "prog.py"
    program.write_text(
        "def main():\n    if x[1]:\n        raw('raw(Odd,0x2799,1,60aa=Y001,0000=)')\n"
        "    if True:\n        call(other)\n"
        f"{END}\n\n@sub\ndef other():\n    if x[2]:\n        out(y[1])\n\n    if True:\n        return\n"
    )
    assert check(program).diagnostics == ()


@pytest.mark.parametrize(
    "shape",
    [
        "{raw}    else:\n        set(c[2])\n",
        "        set(c[1])\n    else:\n{raw}",
        # It may work on in its own time.
        "        set(c[1])\n    else:\n        set(c[2])\n    if x[2]:\n{raw}",
    ],
)
def test_an_else_beside_it_is_not_mended_by_itself(shape: str, tmp_path: Path) -> None:
    is_safe = []
    for inside in ("        set(c[3])\n", KEPT):
        result = build(tmp_path, f"def main():\n    if x[1]:\n{shape.format(raw=inside)}{END}")
        [problem] = result.diagnostics
        assert problem.code == "CG104"
        is_safe.append(problem.fix is not None and problem.fix.is_safe)
    assert is_safe == [True, False]


# -- the listing ------------------------------------------------------------------------------------------------------


@each_token
def test_the_listing_loses_nothing(name: str, tmp_path: Path) -> None:
    result = build(tmp_path, f"def main():\n    if c[1]:\n        {written(TOKENS[name])}\n{END}")
    listing = result.files["listing.txt"]
    rest = listing.partition("  if C1\n    ")[2]
    shown = rest.partition("\n\nRung 2")[0]
    assert "".join(line.removeprefix("    ").removeprefix("  ") for line in shown.split("\n")) == TOKENS[name]
    assert max(map(len, shown.split("\n"))) <= 110


# -- rungs that were left out -----------------------------------------------------------------------------------------


def test_a_rung_that_was_left_out_stops_build_and_check(tmp_path: Path) -> None:
    reason = "main.csv:45: the contacts are wired\n in too many ways"
    result = build(tmp_path, f"def main():\n    # As it was.\n    if True:\n        not_imported({reason!r})\n{END}")
    for found in (result, check(tmp_path / "prog.py")):
        [problem] = found.diagnostics
        assert problem.code == "CG426"
        assert problem.message.endswith(": main.csv:45: the contacts are wired in too many ways")
        assert "by hand" in problem.help
    assert not result.files


def test_its_word_in_a_ladder_file_is_none_of_ours() -> None:
    assert fault_of('not_imported("a")') is not None
    assert height_of('not_imported("a")') == 1


def test_a_token_of_endless_length_is_not_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    """It is not even given to laddercodec, which took a quarter of a minute over these blanks."""
    monkeypatch.setattr("clickgen.click.read.kept._fault_in_codec", lambda _: pytest.fail("it was asked"))
    for token in (f"math(DS1{' ' * 60_000}!,DS1,mode=decimal)", f"raw(Email,0x2737,1,60a5={'1' * 60_000})"):
        fault = fault_of(token)
        assert fault is not None
        assert "no instruction has so many" in fault.message
