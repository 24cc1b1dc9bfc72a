"""Subroutines with names that no function can have: one name in CLICK, another in the source."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from laddercodec.csv.bundle import parse_bundle

import clickgen
from clickgen.cli import main
from clickgen.click.read.problem import LadderProblem
from clickgen.click.read.rungs import routine_of
from clickgen.dialects.if_rungs.write.functions import RESERVED, function_name
from clickgen.dialects.if_rungs.write.routine import functions_of, write_source
from clickgen.instructions.control import CALL, END, RETURN
from clickgen.ir.conditions import Always
from clickgen.ir.program import Action, Rung, Word
from clickgen.text.source import Span

END_RUNG = "    if True:\n        end()\n"


def subroutine(function: str, title: str = "") -> str:
    mark = f"@sub({json.dumps(title)})" if title else "@sub"
    return f"\n\n{mark}\ndef {function}():\n    if c.Go:\n        out(c.Done)\n    if True:\n        return\n"


def main_of(*calls: str) -> str:
    return "def main():\n" + "".join(f"    if c.Go:\n        call({call})\n" for call in calls) + END_RUNG


def build(folder: Path, text: str, **siblings: str) -> clickgen.BuildResult:
    for name, sibling in siblings.items():
        (folder / f"{name}.py").write_text(sibling.lstrip("\n"), "utf-8")
    (folder / "plc.py").write_text(text, "utf-8")
    return clickgen.build(folder / "plc.py")


def told(result: clickgen.BuildResult) -> list[tuple[str, str]]:
    return [(problem.code, problem.help) for problem in result.diagnostics]


# -- what comes out ---------------------------------------------------------------------------------------------------


def test_the_outputs_have_clicks_name(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    result = build(tmp_path, main_of("auto_mode", '"Auto Mode"') + subroutine("auto_mode", "Auto Mode"))
    assert result.ok, result.diagnostics
    assert [routine.name for routine in result.routines] == ["main", "Auto Mode"]
    assert result.files["main.csv"].count('"call(""Auto Mode"")"') == 2
    assert "subroutines/Auto Mode.csv" in result.files
    assert {*json.loads(result.files["sources.json"])["routines"]} == {"main", "Auto Mode"}
    assert "auto_mode" not in "".join(result.files.values())
    assert main(["build", str(tmp_path / "plc.py"), "-o", str(tmp_path / "out")]) == 0
    assert "create 1 subroutine by hand, named Auto Mode\n" in capsys.readouterr().out


def test_a_reader_of_bundles_finds_the_subroutine_that_is_called(tmp_path: Path) -> None:
    build(tmp_path, main_of("auto_mode") + subroutine("auto_mode", "Auto Mode")).write(tmp_path / "bundle")
    bundle = parse_bundle(tmp_path / "bundle")
    [read] = bundle.subroutines
    assert read.path is not None
    assert Path(read.path).stem == "Auto Mode"
    assert "Auto Mode" in repr(bundle.main)


def test_the_name_of_the_function_may_be_given_as_well(tmp_path: Path) -> None:
    plain = build(tmp_path, main_of("fill") + subroutine("fill"))
    titled = build(tmp_path, main_of("fill") + subroutine("fill", "fill"))
    assert titled.ok
    assert {**titled.files, "sources.json": ""} == {**plain.files, "sources.json": ""}


def test_a_function_is_not_called_like_another_subroutine(tmp_path: Path) -> None:
    """``call(one)`` and ``call("one")`` would run two subroutines, and nobody would see it."""
    result = build(tmp_path, main_of("one", '"one"') + subroutine("one", "two") + subroutine("other", "one"))
    assert [problem.code for problem in result.diagnostics] == ["CG402"]
    assert "the function 'one' is called like the subroutine 'one'" in result.diagnostics[0].message


@pytest.mark.parametrize("function", ["reset", "copy", "call", "x", "ctd", "ds", "all", "Tms", "range", "print"])
def test_a_function_may_have_a_word_of_the_language(tmp_path: Path, function: str) -> None:
    """A call names it by its place, so it can mean nothing else; an editor takes it for the subroutine from then on."""
    for title in ("", "Auto Mode"):
        result = build(tmp_path, main_of(function) + subroutine(function, title))
        assert result.ok, result.diagnostics
        assert f'"call(""{title or function}"")"' in result.files["main.csv"]


def test_what_a_subroutine_writes_is_known_under_its_name(tmp_path: Path) -> None:
    """A condition that the called subroutine changes goes to a scratch bit, whichever name the call has."""
    rung = "def main():\n    if c.Done:\n        call({})\n        ctu(ct.A, 5, reset=lambda: c.R)\n" + END_RUNG
    for call in ("auto_mode", '"Auto Mode"'):
        result = build(tmp_path, rung.format(call) + subroutine("auto_mode", "Auto Mode"))
        assert result.ok, result.diagnostics
        assert len(result.scratch_rows) == 1


# -- several files ----------------------------------------------------------------------------------------------------


def test_an_import_names_the_function(tmp_path: Path) -> None:
    auto = subroutine("auto_mode", "Auto Mode") + subroutine("other", "Auto")
    result = build(tmp_path, "from auto import auto_mode\n\n\n" + main_of("auto_mode"), auto=auto)
    assert result.ok, result.diagnostics
    assert [routine.name for routine in result.subroutines] == ["Auto Mode"]
    result = build(tmp_path, "from auto import Auto\n\n\n" + main_of("Auto"), auto=auto)
    assert told(result) == [("CG123", "an import names the function: other")]


@pytest.mark.parametrize(
    ("call", "help"),
    [
        ("manual", "write from auto import manual at the top"),
        ('"Manual Mode"', "write from auto import manual at the top"),
        ('"manual"', "write from auto import manual at the top, and call(manual) without quotes"),
        ('"auto_mode"', 'quotes are for CLICK\'s name: write call(auto_mode), or call("Auto Mode")'),
        ('"auto mode"', "did you mean Auto Mode?"),
        ("auto_mod", "did you mean auto_mode?"),
    ],
)
def test_a_wrong_call_has_a_way_out(tmp_path: Path, call: str, help: str) -> None:
    auto = subroutine("auto_mode", "Auto Mode") + subroutine("manual", "Manual Mode")
    result = build(tmp_path, "from auto import auto_mode\n\n\n" + main_of("auto_mode", call), auto=auto)
    assert told(result) == [("CG405", help)]


def test_what_an_import_fails_to_bring_has_its_problem_there(tmp_path: Path) -> None:
    result = build(tmp_path, "from auto import auto_mode\n\n\n" + main_of("auto_mode", '"Auto Mode"'))
    assert [code for code, _ in told(result)] == ["CG121"]


def test_two_functions_of_one_name_are_refused_wherever_they_stand(tmp_path: Path) -> None:
    start = "from one import start\nfrom two import start\n\n\n" + main_of("start")
    one, two = subroutine("start", "Start 1"), subroutine("start", "Start 2")
    assert [code for code, _ in told(build(tmp_path, start, one=one, two=two))] == ["CG402"]
    start = "from one import start\n\n\n" + main_of("start")
    assert [code for code, _ in told(build(tmp_path, start, one=one + two))] == ["CG402"]


def test_a_name_of_click_may_be_used_again_in_a_file_that_is_not_all_imported(tmp_path: Path) -> None:
    auto = subroutine("auto_mode", "Auto") + subroutine("older", "Auto")
    assert build(tmp_path, "from auto import auto_mode\n\n\n" + main_of("auto_mode"), auto=auto).ok


# -- names ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "title", ["A", "1", "-", "_", "a b", "a  b", "2nd-Line", "x" * 24, "class", "Main loop", "conx"]
)
def test_what_click_takes_is_taken(tmp_path: Path, title: str) -> None:
    result = build(tmp_path, main_of("one") + subroutine("one", title))
    assert result.ok, result.diagnostics
    assert f"subroutines/{title}.csv" in result.files


@pytest.mark.parametrize(
    "title",
    [" ", "a ", " a", "x" * 25, "a.b", "a/b", "a\\b", "a:b", "a\nb", "ä", "NUL", "com1", "Lpt9", "main", "MAIN"],
)
def test_what_is_no_file_or_no_name_is_refused(tmp_path: Path, title: str) -> None:
    result = build(tmp_path, main_of("one") + subroutine("one", title))
    [problem] = result.diagnostics
    assert problem.code == "CG417"
    assert problem.span is not None
    assert (problem.span.line, problem.span.col) == (8, 6)


def test_a_check_speaks_of_clicks_name(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = "def main():\n" + END_RUNG + subroutine("auto_mode", "Auto Mode")
    (tmp_path / "plc.py").write_text(text, "utf-8")
    main(["check", str(tmp_path / "plc.py"), "--output-format", "concise"])
    assert "CG515 Auto Mode is in the program and nothing calls it" in capsys.readouterr().out


# -- the other way: a function for a name -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "function"),
    [
        ("fill", "fill"),
        ("Auto Mode", "Auto_Mode"),
        ("a - b", "a_b"),
        ("a__b", "a__b"),
        ("2nd-Line", "sub_2nd_Line"),
        ("-2", "_2"),
        ("class", "class_"),
        ("match", "match_"),
        ("reset", "reset_"),
        ("x", "x_"),
        ("Tms", "Tms_"),
        ("sub", "sub_"),
        ("main", "main_"),
        ("print", "print_"),
        ("Reset", "Reset"),
        ("-", "sub_"),
        ("", "sub_"),
    ],
)
def test_a_function_for_a_name(name: str, function: str) -> None:
    assert function_name(name, ()) == function
    assert function.isidentifier()


def test_functions_that_are_taken_get_numbers() -> None:
    taken: list[str] = []
    for name in ("A B", "a-b", "A_B", "A_B_2", "x", "x_", "x-"):
        taken.append(function_name(name, taken))
    assert taken == ["A_B", "a_b_2", "A_B_3", "A_B_2_2", "x_", "x_2", "x_3"]


def test_no_word_of_the_language_becomes_a_function() -> None:
    import clickgen.dsl as dsl

    assert {*vars(dsl)["__all__"]} <= RESERVED
    assert all(function_name(word, ()) != word for word in RESERVED)


HERE = Span("main.csv", 1, 1, 1, 2)


def rung(*actions: Action) -> Rung:
    return Rung(Always(HERE), actions, "", HERE, HERE)


def call(name: str) -> Action:
    return Action(CALL, {"subroutine": Word(name, HERE)}, HERE)


def test_a_routine_is_written_under_both_names(tmp_path: Path) -> None:
    names = ("Auto Mode", "reset", "fill", "class", "2")
    taken: list[str] = []
    routines = [routine_of("main", [rung(*map(call, names)), rung(Action(END, {}, HERE))], True)]
    for name in names:
        taken.append(function_name(name, taken))
        routines.append(routine_of(name, [rung(Action(RETURN, {}, HERE))], False, taken[-1]))
    text = write_source(routines)
    assert '\n\n\n@sub("Auto Mode")\ndef Auto_Mode():\n' in text
    assert "\n\n\n@sub\ndef fill():\n" in text
    assert (
        "call(Auto_Mode)\n        call(reset_)\n        call(fill)\n        call(class_)\n        call(sub_2)\n" in text
    )
    result = build(tmp_path, text)
    assert result.ok, result.diagnostics
    assert [routine.name for routine in result.subroutines] == [*names]
    assert all(f'"call(""{name}"")"' in result.files["main.csv"] for name in names)


def test_a_subroutine_of_another_file_is_called_by_its_function_or_in_quotes() -> None:
    main_alone = routine_of("main", [rung(call("Auto Mode"), call("class"))], True)
    auto = routine_of("Auto Mode", [], False, "auto_mode")
    assert 'call("Auto Mode")\n        call("class")\n' in write_source([main_alone])
    assert 'call(auto_mode)\n        call("class")\n' in write_source([main_alone], functions=functions_of([auto]))


@pytest.mark.parametrize("function", ["two words", "9lives", "class", "main"])
def test_a_routine_needs_a_function_that_python_takes(function: str) -> None:
    with pytest.raises(LadderProblem, match="cannot have the name"):
        routine_of("Auto Mode", [], False, function)


@pytest.mark.parametrize("title", ["Count Parts", "2nd-Line", "Pump rung 3"])
def test_scratch_cells_are_known_again_in_a_second_build(tmp_path: Path, title: str) -> None:
    """The reason in the table names the routine, and by it clickgen knows the row for its own."""
    rungs = "    if all(x[3], nc(c[5])):\n        set(c[5])\n        ctu(ct[1], 10, reset=lambda: x[4])\n"
    program = f'{main_of("cp")}\n\n@sub("{title}")\ndef cp():\n{rungs}    if True:\n        return\n'
    first = build(tmp_path, program)
    assert first.scratch_rows
    first.write(tmp_path / "out")
    second = clickgen.build(tmp_path / "plc.py", frozen=True)
    assert second.ok, second.diagnostics
    assert second.files == first.files
