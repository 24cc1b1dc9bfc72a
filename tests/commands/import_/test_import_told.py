"""The messages of an import about rungs, comments, loops and ends, and the faults that stop it."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import pytest
from drawn_rungs import END, RETURN, Drawing, Rows, coils, first_rung, imported, rung, write_bundle
from test_importing_cases import ladder_text, wired

import clickgen
from clickgen.click.read.network import ONE_WAY_WIRE
from clickgen.commands.import_.project import Target, import_project
from clickgen.workspace import CouldNotRun

BLANK = ["R", *[""] * 32]
"""A rung in which nobody has drawn anything yet."""


def comment(*lines: str) -> Rows:
    return [["#", line] for line in lines]


def came_back(folder: Path, routines: Mapping[str, Rows]) -> str:
    """Check a program: built and imported again it has the same text, and a judge finds the same power."""
    result = imported(folder, routines)
    result.write()
    source = (folder / "prog.py").read_text(encoding="utf-8")
    built = clickgen.build(folder / "prog.py", frozen=True)
    assert built.ok, built.diagnostics
    built.write(folder / "again")
    second = import_project(folder / "again", Target(folder / "second" / "prog.py"))
    assert second.files[folder / "second" / "prog.py"].decode() == source
    assert second.verdict is not None
    assert (second.verdict.verified, second.verdict.redrawn) == (second.rungs, [])
    return source


# -- what a person should know -----------------------------------------------------------------------------------------


def test_contacts_that_wires_lead_around_are_told(tmp_path: Path) -> None:
    drawing: Drawing = [
        ("X001 T:X002 T:X003 T T", "out(C1)"),
        (". X004 - X005 |", ""),
        ("X006 - T:X007 T |", ""),
        (". . X008 - .", ""),
    ]
    result = imported(tmp_path, {"main": [*rung(*drawing), END]})
    assert [problem.message for problem in result.diagnostics] == [
        "main rung 1: X003 in row 1, column C is left out: a wire leads around it",
        "main rung 1: X005 in row 2, column D is left out: a wire leads around it",
    ]
    source = result.files[tmp_path / "prog.py"].decode()
    assert first_rung(source) == "if any(all(x[1], any(x[2], x[4])), all(x[6], any(x[7], x[8]))):\n    out(c[1])"


def test_a_ladder_of_legs_that_is_neither_series_nor_parallel_is_told(tmp_path: Path) -> None:
    """Power could come back through the wire in row 2; it is assumed to go only to the right."""
    drawing: Drawing = [("X003 - - T", "out(C1)"), ("X001 T - .", ""), (". X004", "out(C2)")]
    result = imported(tmp_path, {"main": [*rung(*drawing), END]})
    assert {problem.code for problem in result.diagnostics} == {"CG704"}
    assert f"main rung 1: {ONE_WAY_WIRE}" in [problem.message for problem in result.diagnostics]


REFUSED: dict[str, tuple[Drawing, str, str]] = {
    "a leg below the middle input": (
        [
            ("X001", "count_up(CT1,CTD1,preset=DS5)"),
            ("X002 T", ".down()"),
            ("X003 .", ""),
            ("X004", ".reset()"),
        ],
        "CG701",
        "main rung 1: .reset() is not directly below its instruction",
    ),
    "a leg that was left over": (
        [("X001 T X002", "out(C1)"), ("X003 . X004 |", "")],
        "CG70",
        "main rung 1: ",
    ),
    "seventeen copies": (
        coils(17, "copy({0},DS{0})"),
        "CG701",
        "main rung 1: the rung has 34 rows with its boxes at their full height, and CLICK 32",
    ),
    "thirty-three coils": (
        coils(33, "out(C{})"),
        "CG701",
        "main rung 1: the rung has 33 rows with its boxes at their full height, and CLICK 32",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_refused_names_the_rung_and_the_reason(name: str, tmp_path: Path) -> None:
    drawing, code, message = REFUSED[name]
    write_bundle(tmp_path / "plant", {"main": [*rung(*drawing), END]})
    result = import_project(tmp_path / "plant", Target(tmp_path / "prog.py"))
    assert not result.files
    [problem] = result.diagnostics
    assert problem.code.startswith(code)
    assert problem.message.startswith(message)
    assert problem.span is not None
    assert problem.help


# -- comments ----------------------------------------------------------------------------------------------------------


COMMENTS: dict[str, tuple[tuple[str, ...], str]] = {
    "one line": (("Only a comment.",), "# Only a comment."),
    "blank lines around": (("", "in between", "", ""), "#\n# in between\n#\n#"),
    "indentation": (("Steps:", "  1. fill", "     - slowly"), "# Steps:\n#   1. fill\n#      - slowly"),
    "a tab": (("\tindented",), "# \tindented"),
    "quotes and backslashes": (("the 'old' \"line\" \\n",), "# the 'old' \"line\" \\n"),
    "hashes": (("# ---", "#", "12 # of parts"), "# # ---\n# #\n# 12 # of parts"),
    "what speaks to other tools": (("fmt: off", "noqa", "type: ignore"), "# fmt: off\n# noqa\n# type: ignore"),
    "commas": (("a, b, c",), "# a, b, c"),
    "other alphabets": (("Kühlung 40 °C",), "# Kühlung 40 °C"),
    "what looks like a rung": (("if x[1]:", "    out(y[1])"), "# if x[1]:\n#     out(y[1])"),
    "as long as CLICK takes it": (("x" * 1400,), "# " + "x" * 1400),
    "spaces at the ends": (("a  ", "b"), "# a\n# b"),
    "two blank lines": (("", ""), "#\n#"),
}


@pytest.mark.parametrize("name", COMMENTS)
def test_a_comment_comes_back(name: str, tmp_path: Path) -> None:
    lines, expected = COMMENTS[name]
    source = came_back(tmp_path, {"main": [*comment(*lines), *rung(("X001", "out(C1)")), END]})
    assert first_rung(source) == f"{expected}\nif x[1]:\n    out(c[1])"
    again = (tmp_path / "again" / "main.csv").read_text(encoding="utf-8")
    assert again == ladder_text([*comment(*map(str.rstrip, lines)), *rung(("X001", "out(C1)")), END])


def test_a_comment_of_spaces_is_no_comment(tmp_path: Path) -> None:
    came_back(tmp_path, {"main": [*comment("   "), *rung(("X001", "out(C1)")), END]})


def test_rungs_with_the_same_comment_keep_it_each(tmp_path: Path) -> None:
    rungs = [row for bit in ("C1", "C2", "C3") for row in [*comment("Lamp test"), *rung(("X001", f"out({bit})"))]]
    source = came_back(tmp_path, {"main": [*rungs, END]})
    assert source.count("    # Lamp test\n    if x[1]:\n") == 3


@pytest.mark.parametrize("drawn", [[wired(".", "NOP", "R")], [wired("", "NOP", "R")], [BLANK]])
def test_a_rung_of_a_comment_alone(drawn: Rows, tmp_path: Path) -> None:
    """People write headings of sections this way; CLICK keeps a NOP there."""
    source = came_back(tmp_path, {"main": [*comment("=== Cooling ===", ""), *drawn, END]})
    assert first_rung(source) == "# === Cooling ===\n#\nif True:\n    pass"


def test_a_comment_that_is_too_long_is_told(tmp_path: Path) -> None:
    write_bundle(tmp_path / "plant", {"main": [*comment("x" * 1401), *rung(("X001", "out(C1)")), END]})
    result = import_project(tmp_path / "plant", Target(tmp_path / "prog.py"))
    [problem] = result.diagnostics
    assert (problem.code, problem.message.startswith("main rung 1: ")) == ("CG702", True)
    assert "1401 bytes" in problem.message


# -- loops, returns, ends ----------------------------------------------------------------------------------------------


def test_loops(tmp_path: Path) -> None:
    """A loop is around its rungs; an empty one, or one whose end has a comment, is closed by hand."""
    rows = [
        *rung(("X001", "for(3)")),
        *rung(("", "out(C1)")),
        *rung(("", "next()")),
        *comment("All parts."),
        *rung(("", "for(DS1,oneshot=1)")),
        *rung(("X001", "out(C2)")),
        *comment("second"),
        *rung(("X002 T", "out(C3)"), ("X003 -", "out(C4)")),
        *rung(("", "next()")),
        *rung(("", "for(5)")),
        *rung(("", "next()")),
        *rung(("", "for(6)")),
        *rung(("", "out(C5)")),
        *comment("end of it"),
        *rung(("", "next()")),
        END,
    ]
    assert first_rung(came_back(tmp_path, {"main": rows})) == (
        "if x[1]:\n"
        "    for _ in range(3):\n"
        "        if True:\n"
        "            out(c[1])\n"
        "\n"
        "# All parts.\n"
        "if True:\n"
        "    for _ in range(ds[1], oneshot=True):\n"
        "        if x[1]:\n"
        "            out(c[2])\n"
        "\n"
        "        # second\n"
        "        if any(x[2], x[3]):\n"
        "            out(c[3])\n"
        "            out(c[4])\n"
        "\n"
        "if True:\n"
        "    for _ in range(5):\n"
        "        pass\n"
        "\n"
        "if True:\n"
        "    next_loop()\n"
        "\n"
        "if True:\n"
        "    for _ in range(6):\n"
        "        pass\n"
        "\n"
        "if True:\n"
        "    out(c[5])\n"
        "\n"
        "# end of it\n"
        "if True:\n"
        "    next_loop()"
    )


def test_returns_and_ends_in_the_middle(tmp_path: Path) -> None:
    main = [
        *rung(("X001", 'call("Auto Mode")')),
        *rung(("X002 T:X003", 'call("Auto Mode")'), (". X004", 'call("Init")')),
        *rung(("X005", "end()")),
        *rung(("X006", "out(C1)")),
        END,
        *rung(("X007", "out(C2)")),
        END,
    ]
    auto = [*rung(("X001 T", "out(C3)"), (". X002", "return()")), *rung(("X003", "return()")), RETURN]
    assert came_back(tmp_path, {"main": main, "Auto Mode": auto, "Init": [RETURN]}) == (
        "def main():\n"
        "    if x[1]:\n"
        "        call(Auto_Mode)\n"
        "\n"
        "    if x[2]:\n"
        "        if x[3]:\n"
        "            call(Auto_Mode)\n"
        "        if x[4]:\n"
        "            call(Init)\n"
        "\n"
        "    if x[5]:\n"
        "        end()\n"
        "\n"
        "    if x[6]:\n"
        "        out(c[1])\n"
        "\n"
        "    if True:\n"
        "        end()\n"
        "\n"
        "    if x[7]:\n"
        "        out(c[2])\n"
        "\n"
        "    if True:\n"
        "        end()\n"
        "\n"
        "\n"
        '@sub("Auto Mode")\n'
        "def Auto_Mode():\n"
        "    if x[1]:\n"
        "        out(c[3])\n"
        "        if x[2]:\n"
        "            return\n"
        "\n"
        "    if x[3]:\n"
        "        return\n"
        "\n"
        "    if True:\n"
        "        return\n"
        "\n"
        "\n"
        "@sub\n"
        "def Init():\n"
        "    if True:\n"
        "        return\n"
    )


def test_rungs_that_nobody_drew_anything_in(tmp_path: Path) -> None:
    source = came_back(tmp_path, {"main": [BLANK, *rung((".", "NOP")), *rung(("X001", "NOP")), END]})
    assert first_rung(source) == "if True:\n    pass\n\nif True:\n    pass\n\nif x[1]:\n    pass"


def test_the_same_ladder_in_parts_of_main(tmp_path: Path) -> None:
    """Rungs are counted through main.csv and main_2.csv, and a build divides them again."""
    write_bundle(tmp_path / "plant", {"main": [row for _ in range(3) for row in rung(("X001", "out(C1)"))]})
    (tmp_path / "plant" / "main_2.csv").write_text(ladder_text([*rung(("X001", "out(X009)")), END]))
    result = import_project(tmp_path / "plant", Target(tmp_path / "prog.py"))
    [problem] = result.diagnostics
    assert problem.message.startswith("main rung 4: ")
    assert problem.span is not None
    assert Path(problem.span.path).name == "main_2.csv"


# -- what stops the whole program --------------------------------------------------------------------------------------


def test_a_subroutine_with_the_name_of_main_is_refused(tmp_path: Path) -> None:
    """CLICK distinguishes the two, a program and a bundle do not."""
    write_bundle(tmp_path / "plant", {"main": [END]})
    (tmp_path / "plant" / "subroutines" / "main.csv").write_text(ladder_text([RETURN]))
    with pytest.raises(CouldNotRun, match=r"subroutines.main\.csv: a subroutine cannot be called main"):
        import_project(tmp_path / "plant", Target(tmp_path / "prog.py"), keep_going=True)


@pytest.mark.parametrize("name", ["Main", "COM1", "a.b", "S" * 25])
def test_a_name_that_no_build_takes_is_told_once_without_a_promise(name: str, tmp_path: Path) -> None:
    """``--keep-going`` marks rungs; it cannot help here."""
    write_bundle(tmp_path / "plant", {"main": [END], name: [RETURN]})
    result = import_project(tmp_path / "plant", Target(tmp_path / "prog.py"))
    [problem] = result.diagnostics
    assert problem.code == "CG702"
    assert name in problem.message
    assert "--keep-going" not in problem.help


def test_a_fault_in_the_address_table_is_told_once(tmp_path: Path) -> None:
    write_bundle(tmp_path / "plant", {"main": [*rung(("C1", "out(C2)")), END]})
    rows = 'C1,BIT,"A",0,No,""\nC1,BIT,"B",0,No,""\nC2,BIT,"C",0,No,"' + "x" * 129 + '"\n'
    header = "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment\n"
    (tmp_path / "plant" / "nicknames.csv").write_text(header + rows)
    result = import_project(tmp_path / "plant", Target(tmp_path / "prog.py"))
    assert sorted(problem.code for problem in result.diagnostics) == ["CG601", "CG602"]
    assert not result.files
