"""A fix is safe only if the resolved program proves it: by its table, its files, and every program it is in."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path

import pytest
from mended import assert_builds, body, chain, rung

from clickgen.api import check
from clickgen.cli import main
from clickgen.config import Settings
from clickgen.problems.diagnostics import Diagnostic

HEADER = "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment\n"
RECIPE = """\
DS100,INT,"",0,Yes,"<Recipe>"
DS103,INT,"Speed",0,Yes,""
DS109,INT,"",0,Yes,"</Recipe>"
"""
ALARMS = 'C1,BIT,"",0,No,"<Door alarms>"\nC2,BIT,"Door",0,No,""\nC4,BIT,"",0,No,"</Door alarms>"\n'


def problems(
    folder: Path, data: bytes, table: str = "", files: Mapping[str, str] = {}, is_part: bool = False
) -> list[Diagnostic]:
    """The problems with else, and, or and not of a program beside a table and other files."""
    (folder / "prog.py").write_bytes(data)
    for name, text in files.items():
        (folder / f"{name}.py").write_text(text, "utf-8")
    if table:
        (folder / "nicknames.csv").write_text(HEADER + table, "utf-8")
    found = check(folder / "prog.py", Settings(is_part=is_part)).diagnostics
    return [problem for problem in found if problem.code in ("CG104", "CG105")]


def verdicts(
    folder: Path, data: bytes, table: str = "", files: Mapping[str, str] = {}, is_part: bool = False
) -> list[bool | None]:
    """Whether the fix of each is safe; None if there is none."""
    found = problems(folder, data, table, files, is_part)
    return [problem.fix and problem.fix.is_safe for problem in found]


# -- blocks of the table ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arms", "is_safe"),
    [
        (["if ds.Speed == 0: copy_fill(5, ds.Recipe)", "else: set(y[1])"], False),
        (["if ds.Speed == 0: copy(5, ds.Recipe[3])", "else: set(y[1])"], False),
        (["if ds.Speed == 0: copy(5, ds.Recipe[4])", "else: set(y[1])"], True),
        (["if ds.Speed == 0: copy_fill(5, ds.Recipe[0:3])", "else: set(y[1])"], True),
        (["if ds.Speed == 0: copy_fill(5, ds[100:110])", "else: set(y[1])"], False),
        (["if ds[103] == 0: copy(5, ds.Speed)", "else: set(y[1])"], False),
        (["if ds[104] == 0: copy(5, ds.Speed)", "else: set(y[1])"], True),
        (["if ds.Recipe[3] == 0: copy(5, ds.Speed)", "elif x[1]: set(y[1])"], False),
        (["if x[1]: copy(5, ds.Speed)", "elif x[2]: search(ds.Recipe >= 5, ds.At, c.F)", "else: set(y[1])"], True),
        (["if x[1]: copy(5, ds.Speed)", "else: calc('SUM(ds.Recipe)', ds.Total)"], True),
        (["if x[1]: calc('ds.A + 1', ds.Recipe[9])", "elif ds[109] > 4: set(y[1])"], False),
        (["if c.Door: set(c[9])", "else: set(y[1])"], True),
        (["if c.Door: set(c['Door alarms'])", "else: set(y[1])"], False),
        (["if c['Door alarms'][1]: reset(c.Door)", "else: set(y[1])"], False),
    ],
)
def test_what_an_arm_changes_is_known_by_the_table(arms: list[str], is_safe: bool, tmp_path: Path) -> None:
    assert verdicts(tmp_path, body(chain(*arms)), RECIPE + ALARMS) == [is_safe]


@pytest.mark.parametrize(
    "bits", ['c["Door alarms"]', 'c["door alarms"]', 'nc(c["Door alarms"])', 'c["Door alarms"][1:3]']
)
def test_a_block_of_the_table_has_no_opposite(bits: str, tmp_path: Path) -> None:
    for data in (rung(f"not {bits}"), rung(f"c.A and not ({bits} or c.B)"), rung(f"~all(c.A, {bits})")):
        [problem] = problems(tmp_path, data, ALARMS)
        assert problem.fix is None
        assert problem.help.startswith(f"nothing in the language is the opposite of {bits}: put it on a bit with out(")
    for test in (bits, f"all(c.A, {bits})"):
        [problem] = problems(tmp_path, body(chain(f"if {test}: set(y[1])", "else: set(y[2])")), ALARMS)
        assert problem.fix is None
        assert problem.help.startswith(f"nothing is the opposite of {bits}: put it on a bit with out(...)")


def test_the_way_out_for_a_block_builds(tmp_path: Path) -> None:
    (tmp_path / "nicknames.csv").write_text(HEADER + ALARMS, "utf-8")
    out = '    if c["Door alarms"]:\n        out(c.AllDoors)\n    if nc(c.AllDoors):\n        set(y[1])'
    assert_builds(body(out), tmp_path)


def test_what_is_not_turned_round_may_be_a_block(tmp_path: Path) -> None:
    assert verdicts(tmp_path, rung('c.A and c["Door alarms"] or not c.B'), ALARMS) == [True]
    arms = chain("if nc(c.A): set(y[1])", 'elif c["Door alarms"]: set(y[2])')
    assert verdicts(tmp_path, body(arms), ALARMS) == [True]


def test_a_member_of_a_block_is_a_bit(tmp_path: Path) -> None:
    assert verdicts(tmp_path, rung('not c["Door alarms"][2]'), ALARMS) == [True]
    # There is no such member, and a fix would leave that error in the line.
    assert verdicts(tmp_path, rung('not c["Door alarms"][7]'), ALARMS) == [None]


def test_an_own_table_of_timers_is_a_block_too(tmp_path: Path) -> None:
    table = 'T1,BIT,"",0,No,"<Waits>"\nT4,BIT,"",0,No,"</Waits>"\n'
    [problem] = problems(tmp_path, rung("not t.Waits"), table)
    assert problem.fix is None


# -- what cannot be read ----------------------------------------------------------------------------------------------

HIDING = {
    "a declaring file is no Python": ("import decl\n", {"decl": "nickname(c.Bits, c[1:5])\nif (\n"}, ""),
    "a declaring file is not there": ("import decl\n", {}, ""),
    "an import that cannot be read": ("from os.path import join\n", {}, ""),
    "a declaring file imports what is not there": ("import decl\n", {"decl": "import more\n"}, ""),
    "a declaration with a fault": ("nickname(c.Other, zz[1:5])\n", {}, ""),
    "a declaration under a condition": ("if True:\n    nickname(c.Bits, c[1:5])\n", {}, ""),
    "a misspelled declaration": ("nickname_(c.Bits, c[1:5])\n", {}, ""),
    "a declaration in the wrong bank": ("nickname(c.Bits, ds[1:5])\n", {}, ""),
    "a broken row of the table": ("", {}, 'C1,BIT,"",0,No,"<Bits>"\nC4,"",0\n'),
    "a block without an end": ("", {}, 'C1,BIT,"",0,No,"<Bits>"\n'),
    "a row twice": ("", {}, 'C1,BIT,"Own",0,No,""\nC1,BIT,"Bits",0,No,""\n'),
}


@pytest.mark.parametrize("name", HIDING)
def test_where_something_hides_what_a_name_is_no_fix_is_safe(name: str, tmp_path: Path) -> None:
    head, files, table = HIDING[name]
    first = head.encode()
    for data in (
        rung("not c.Bits"),
        rung("c.A and not c.Bits"),
        body(chain("if c.Bits: set(y[1])", "else: set(y[2])")),
    ):
        [problem] = problems(tmp_path, first + data, table, files)
        assert problem.fix is None
        assert "nc(" not in problem.help.replace("nc(...)", "")
    arms = chain("if ds.A == 0: copy(1, ds.B)", "else: set(y[1])")
    assert verdicts(tmp_path, first + body(arms), table, files) == [False]
    assert verdicts(tmp_path, first + rung("not ds.A"), table, files) == [False]
    # A fix that needs no name, or turns nothing round, is as safe as ever.
    for text in ("c.A and c.Bits", "not c[500]", "not ds[4000] == 5", "not x[1].immediate"):
        assert verdicts(tmp_path, first + rung(text), table, files) == [True]


def test_a_declaration_in_a_rung_hides_what_a_name_is(tmp_path: Path) -> None:
    for inner in ("        nickname(c.Bits, c[1:5])\n", "    nickname(c.Bits, c[1:5])\n"):
        data = rung("not c.Bits").replace(b"    if True", inner.encode() + b"    if True")
        [problem] = problems(tmp_path, data)
        assert problem.fix is None


def test_an_error_in_another_rung_hides_no_name(tmp_path: Path) -> None:
    data = rung("not c.A").replace(b"    if True", b"    if c.B:\n        sett(c.C)\n    if True")
    assert verdicts(tmp_path, data) == [True]
    data = data.replace(b"not c.A", b"not ds.A and not c.B")
    assert verdicts(tmp_path, data) == [True]
    # But an instruction that nobody has read may be a receive.
    arms = chain("if c.A: set(c.B)", "else: set(c.C)")
    assert verdicts(tmp_path, body(arms + "\n    if c.B:\n        sett(c.C)")) == [False]


def test_a_part_of_a_program_gets_its_names_elsewhere(tmp_path: Path) -> None:
    arms = chain("if x[1]: set(y[1])", "else: set(y[2])")
    assert verdicts(tmp_path, rung("not c.A"), is_part=True) == [None]
    assert verdicts(tmp_path, rung("not c[1] and c.A"), is_part=True) == [True]
    assert verdicts(tmp_path, body(arms), is_part=True) == [False]


# -- what arrives, and when -------------------------------------------------------------------------------------------

RECEIVING = 'receive(ModbusTcpTarget(ip="10.0.0.1"), "C1", c[1:5], receiving=c[6], success=c[7], error=c[8], {})'
SENDING = 'send(ModbusTcpTarget(ip="10.0.0.1"), "C1", c[1:5], sending=c[6], success=c[7], error=c[8], {})'
ERROR = "exception_response=ds[9]"
KEPT = (
    'raw("raw(Velocity,0x2735,1,222d=0,609b=1,609c=1,609d=1,222f=2,11f5=0,2231=0,'
    '60a2=,60a3=,60a4=,607b=C11,607d=C12,6083=DS1,3218=9744,0000=)")'
)


def sub(action: str, name: str = "talk") -> str:
    return f"@sub\ndef {name}():\n    if x[9]:\n        {action}\n    if True:\n        return\n"


@pytest.mark.parametrize(
    ("action", "tests", "is_safe"),
    [
        (RECEIVING.format(ERROR), ("c[1]", "c[4]", "c[6]", "c[7]", "c[8]", "ds[9] == 1"), False),
        (SENDING.format(ERROR), ("c[6]", "c[7]", "c[8]", "ds[9] == 1"), False),
        (RECEIVING.format(ERROR), ("c[5]", "c[9]", "ds[8] == 1", "c.A"), True),
        (SENDING.format(ERROR), ("c[1]", "c[9]", "ds[8] == 1", "c.A"), True),
        (KEPT, ("c[1]", "c.A", "ds[8] == 1", "x[1]"), False),
    ],
)
def test_what_other_devices_send_arrives_in_its_own_time(
    action: str, tests: tuple[str, ...], is_safe: bool, tmp_path: Path
) -> None:
    for test in tests:
        arms = chain(f"if {test}: set(y[1])", "else: set(y[2])")
        called = "    if True:\n        call(talk)\n"
        assert verdicts(tmp_path, b"from other import talk\n" + body(called + arms), files={"other": sub(action)}) == [
            is_safe
        ]
        assert verdicts(tmp_path, sub(action).encode() + body(called + arms)) == [is_safe]
        # Branches look at the same moment.
        branches = "    if x[8]:\n" + chain(f"if {test}: set(y[1])", "else: set(y[2])", line="        ")
        assert verdicts(
            tmp_path, b"from other import talk\n" + body(called + branches), files={"other": sub(action)}
        ) == [True]


def test_a_message_in_an_arm_that_is_no_part_of_the_program_counts(tmp_path: Path) -> None:
    other = chain("if x[1]: set(y[1])", "else: " + RECEIVING.format(ERROR))
    arms = chain("if c[1]: set(y[1])", "else: set(y[2])")
    assert verdicts(tmp_path, body(f"{other}\n{arms}")) == [True, False]


def test_a_subroutine_does_what_its_file_says(tmp_path: Path) -> None:
    arms = chain("if c[1]: call(talk)", "else: set(y[2])")
    for action, is_safe in (("set(c[2])", True), ("set(c[1])", False), ("copy(c[3], c[ds.I])", False)):
        for imported in (True, False):
            first = "from other import talk\n" if imported else sub(action)
            assert verdicts(tmp_path, first.encode() + body(arms), files={"other": sub(action)}) == [is_safe]
    # Nobody knows what a file does that cannot be read, or is missing.
    assert verdicts(tmp_path, b"from other import talk\n" + body(arms), files={"other": sub("sett(c[9])")}) == [False]
    assert verdicts(tmp_path, b"from other import talk\n" + body(arms), files={"other": sub("set(c[9])", "walk")}) == [
        False
    ]
    assert verdicts(tmp_path, body(arms)) == [False]


# -- several programs -------------------------------------------------------------------------------------------------

LIB = "@sub\ndef lamp():\n    if {}:\n        out(y[1])\n    if True:\n        return\n"
PROGRAM = "from lib import lamp\n\n\ndef main():\n    if True:\n        call(lamp)\n        end()\n"
BITS = 'C1,BIT,"",0,No,"<Bits>"\nC4,BIT,"",0,No,"</Bits>"\n'


@pytest.fixture
def _shared(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Two programs with one subroutine, each with a table of its own."""
    monkeypatch.chdir(tmp_path)
    for name in ("a", "b"):
        Path(f"{name}.py").write_text(PROGRAM, "utf-8")
        Path(f"{name}.csv").write_text(HEADER, "utf-8")
    Path("clickgen.toml").write_text(
        'programs = [{path="a.py", nicknames="a.csv"}, {path="b.py", nicknames="b.csv"}]\n', "utf-8"
    )


def mended(capsys: pytest.CaptureFixture[str], lib: str, *flags: str) -> str:
    Path("lib.py").write_text(lib, "utf-8")
    main(["check", "--fix", *flags])
    capsys.readouterr()
    return Path("lib.py").read_text("utf-8")


@pytest.mark.usefixtures("_shared")
@pytest.mark.parametrize("flags", [(), ("--no-cache",), ("--unsafe-fixes",), ("a.py", "./b.py"), ("./b.py", "a.py")])
@pytest.mark.parametrize("owner", ["a", "b"])
def test_a_block_of_one_program_is_no_bit_in_the_other(
    owner: str, flags: tuple[str, ...], capsys: pytest.CaptureFixture[str]
) -> None:
    Path(f"{owner}.csv").write_text(HEADER + BITS, "utf-8")
    for _ in range(2):  # The second time the findings come from the cache.
        lib = LIB.format("not c.Bits")
        assert mended(capsys, lib, *flags) == lib
        main(["check", "--output-format", "json", *(flag for flag in flags if flag != "--unsafe-fixes")])
        [finding] = json.loads(capsys.readouterr().out)["findings"]
        assert finding["fix"] is None
        assert "nothing in the language is the opposite of c.Bits" in finding["help"]


@pytest.mark.usefixtures("_shared")
def test_where_both_programs_agree_the_shared_file_is_mended(capsys: pytest.CaptureFixture[str]) -> None:
    for _ in range(2):
        assert mended(capsys, LIB.format("not c.Bits")) == LIB.format("nc(c.Bits)")
    for name in ("a", "b"):
        Path(f"{name}.csv").write_text(HEADER + BITS, "utf-8")
    assert mended(capsys, LIB.format("not c.Bits[1]")) == LIB.format("nc(c.Bits[1])")


@pytest.mark.usefixtures("_shared")
def test_a_fix_of_a_shared_file_waits_for_its_other_program(capsys: pytest.CaptureFixture[str]) -> None:
    Path("b.csv").write_text(HEADER + BITS, "utf-8")
    lib = LIB.format("not c.Bits")
    assert mended(capsys, lib, "a.py") == lib
    # A fix that rests on no name does not wait.
    assert mended(capsys, LIB.format("c.Bits and c.A"), "a.py") == LIB.format("all(c.Bits, c.A)")


@pytest.mark.usefixtures("_shared")
def test_the_cache_forgets_a_verdict_with_the_table_and_the_files_that_it_rests_on(
    capsys: pytest.CaptureFixture[str],
) -> None:
    lib = LIB.format("not c.Bits")
    Path("lib.py").write_text(lib, "utf-8")
    main(["check"])
    Path("a.csv").write_text(HEADER + BITS, "utf-8")
    assert mended(capsys, lib) == lib
    Path("a.csv").write_text(HEADER, "utf-8")
    assert mended(capsys, lib) == LIB.format("nc(c.Bits)")
