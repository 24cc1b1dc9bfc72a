"""Shapes that people draw, read as conditions, branches and inputs."""

from __future__ import annotations

from collections.abc import Sequence

import pytest
from judges.builds import ladder_files
from test_importing_cases import check_same, compared, ladder_text, round_trip, wired

from clickgen.click.draw.tokens import action_token
from clickgen.click.read.grid import read_ladder
from clickgen.click.read.network import ONE_WAY_WIRE
from clickgen.click.read.problem import LadderProblem
from clickgen.click.read.reduce import BRIDGE
from clickgen.click.read.rungs import ENTANGLED, ImportedRung, import_rung, routine_of
from clickgen.dialects.if_rungs.write.routine import write_source
from clickgen.instructions.raw import RAW
from clickgen.ir.program import Action, Rung

Drawing = Sequence[tuple[str, str]]
"""Rows: contacts, ``.`` for a blank square; and the output."""

END = wired("", "end()", "R")


def rows_of(drawing: Drawing) -> list[list[str]]:
    return [wired(contacts, output, "" if index else "R") for index, (contacts, output) in enumerate(drawing)]


def read(drawing: Drawing) -> ImportedRung:
    [rung] = read_ladder(ladder_text(rows_of(drawing)), "main.csv").rungs
    return import_rung(rung)


def source(drawing: Drawing) -> str:
    """The rung as a program has it, without its indentation."""
    text = write_source([routine_of("main", [read(drawing).rung], True)])
    return "\n".join(line[4:] for line in text.splitlines()[1:])


SHAPES: dict[str, tuple[Drawing, str]] = {
    "a wire": ([("", "out(C1)")], "if True:\n    out(c[1])"),
    "a series": ([("X001 - ~X002", "out(C1)")], "if all(x[1], nc(x[2])):\n    out(c[1])"),
    "legs at the rail": (
        [("X001 T", "out(C1)"), ("rise(X002) |", ""), ("DS1==5", "")],
        "if any(x[1], re(x[2]), ds[1] == 5):\n    out(c[1])",
    ),
    "legs in the middle": (
        [("X001 T:X002 T", "out(C1)"), (". X003", "")],
        "if all(x[1], any(x[2], x[3])):\n    out(c[1])",
    ),
    "legs above the output": (
        [("X001 |", ""), ("X002 -", "out(C1)")],
        "if any(x[1], x[2]):\n    out(c[1])",
    ),
    "a short leg and a long one": (
        [("X001 - - T", "out(C1)"), ("X002 X003 X004", "")],
        "if any(x[1], all(x[2], x[3], x[4])):\n    out(c[1])",
    ),
    "a leg with wires before its contact": (
        [("X001 - - T", "out(C1)"), ("- - X002", "")],
        "if any(x[1], x[2]):\n    out(c[1])",
    ),
    "legs inside legs": (
        [("X001 T:X002 T - T", "out(C1)"), (". X003 - - |", ""), ("X004 - - -", "")],
        "if any(all(x[1], any(x[2], x[3])), x[4]):\n    out(c[1])",
    ),
    "several outputs": (
        [("X001 T", "out(C1)"), (". T", "out(C2)"), (". -", "out(C3)")],
        "if x[1]:\n    out(c[1])\n    out(c[2])\n    out(c[3])",
    ),
    "merge and split in one column": (
        [("X001 T", "out(C1)"), ("X002 -", "out(C2)")],
        "if any(x[1], x[2]):\n    out(c[1])\n    out(c[2])",
    ),
    "merge and split in two columns": (
        [("X001 T T", "out(C1)"), ("X002 . -", "out(C2)")],
        "if any(x[1], x[2]):\n    out(c[1])\n    out(c[2])",
    ),
    "a branch": (
        [("X001 T", "out(C1)"), (". T:X002", "out(C2)"), (". -", "out(C3)")],
        "if x[1]:\n    out(c[1])\n    if x[2]:\n        out(c[2])\n    out(c[3])",
    ),
    "a branch in a branch": (
        [("X001 T:X002 T", "out(C1)"), (". | X003", "out(C2)"), (". X004", "out(C3)")],
        "if x[1]:\n    if x[2]:\n        out(c[1])\n        if x[3]:\n            out(c[2])\n"
        "    if x[4]:\n        out(c[3])",
    ),
    "several wires": (
        [("X001", "out(C1)"), ("X002 T", "out(C2)"), (". -", "out(C3)"), ("", "out(C4)")],
        "if True:\n    if x[1]:\n        out(c[1])\n    if x[2]:\n        out(c[2])\n        out(c[3])\n    out(c[4])",
    ),
    "an empty row with a wire through it": (
        [("X001 T", "out(C1)"), (". |", ""), ("X002 .", "")],
        "if any(x[1], x[2]):\n    out(c[1])",
    ),
    "an empty row that the wire is led through": (
        [("X001 T", "out(C1)"), (". .", ""), ("X002 .", "")],
        "if any(x[1], x[2]):\n    out(c[1])",
    ),
    "wires below a box": (
        [("X001 T", "copy(1,DS1)"), (". |", ""), (". -", "copy(2,DS2)"), ("X002 X003", "out(C1)")],
        "if True:\n    if x[1]:\n        copy(1, ds[1])\n        copy(2, ds[2])\n"
        "    if all(x[2], x[3]):\n        out(c[1])",
    ),
    "a box without its empty row": (
        [("X001 T", "copy(1,DS1)"), (". -", "copy(2,DS2)")],
        "if x[1]:\n    copy(1, ds[1])\n    copy(2, ds[2])",
    ),
    "legs above a box with inputs": (
        [("X001 |", ""), ("X002 -", "on_delay(T1,TD1,preset=5,unit=Tms)"), ("X003", ".reset()")],
        "if any(x[1], x[2]):\n    rton(t[1], setpoint=5, unit=Tms, reset=lambda: x[3])",
    ),
    "legs below the last input": (
        [("X001", "on_delay(T1,TD1,preset=5,unit=Tms)"), ("X002 T", ".reset()"), ("X003", "")],
        "if x[1]:\n    rton(t[1], setpoint=5, unit=Tms, reset=lambda: any(x[2], x[3]))",
    ),
    "an input from the same branch": (
        [("X001 T X002", "on_delay(T1,TD1,preset=5,unit=Tms)"), (". X003", ".reset()")],
        "if all(x[1], x[2]):\n    rton(t[1], setpoint=5, unit=Tms, reset=lambda: all(x[1], x[3]))",
    ),
    "an input on the bare rail": (
        [("X001", "on_delay(T1,TD1,preset=5,unit=Tms)"), ("", ".reset()")],
        "if x[1]:\n    rton(t[1], setpoint=5, unit=Tms, reset=lambda: True)",
    ),
    "NOP": ([(".", "NOP")], "if True:\n    pass"),
    "NOP with a contact": ([("X001", "NOP")], "if x[1]:\n    pass"),
    "a counter that counts down": (
        [(".", ""), ("rise(X001)", "count_down(CT1,CTD1,preset=50)"), ("X002", ".reset()")],
        "if re(x[1]):\n    ctd(ct[1], setpoint=50, reset=lambda: x[2])",
    ),
}


@pytest.mark.parametrize("name", SHAPES)
def test_a_shape_is_read(name: str) -> None:
    drawing, expected = SHAPES[name]
    assert source(drawing) == expected
    assert read(drawing).notes == ()


NOT_JUDGED = ("NOP", "an empty row that the wire is led through", "an input on the bare rail")
"""The judge takes only drawings without loose wires and bare inputs."""


@pytest.mark.parametrize("name", [name for name in SHAPES if name not in NOT_JUDGED])
def test_a_shape_comes_back(name: str) -> None:
    files = {"main.csv": ladder_text([*rows_of(SHAPES[name][0]), END])}
    round_trip(files)


def rungs_of(text: str) -> list[Rung]:
    return [import_rung(rung).rung for rung in read_ladder(text, "main.csv").rungs]


def check_truth(drawing: Drawing) -> None:
    """Built again, the rung has the same outputs with the same power from left to right."""
    files = {"main.csv": ladder_text([*rows_of(drawing), END])}
    built = ladder_files({"prog.py": write_source([routine_of("main", rungs_of(files["main.csv"]), True)])})
    for pair in compared(files, built):
        check_same(pair)


BRIDGES: dict[str, tuple[Drawing, str]] = {
    "a bridge": (
        [("X001 T X003 T", "out(C1)"), (". X005 | |", ""), ("X002 - X004 .", "")],
        "if any(all(x[1], x[3]), all(any(all(x[1], x[5]), x[2]), x[4])):\n    out(c[1])",
    ),
    "an output in the middle of a leg": (
        [("X001 T X002 T", "out(C1)"), (". T X003 .", ""), (". -", "out(C2)")],
        "if x[1]:\n    if any(x[2], x[3]):\n        out(c[1])\n    out(c[2])",
    ),
    "an output in the middle of a lower leg": (
        [("X001 - - T", "out(C1)"), ("X002 T X003 .", ""), (". -", "out(C2)")],
        "if True:\n    if any(x[1], all(x[2], x[3])):\n        out(c[1])\n    if x[2]:\n        out(c[2])",
    ),
}


@pytest.mark.parametrize("name", BRIDGES)
def test_a_bridge_is_written_out(name: str) -> None:
    drawing, expected = BRIDGES[name]
    assert source(drawing) == expected
    assert read(drawing).notes == ((BRIDGE,) if name != "an output in the middle of a leg" else ())
    check_truth(drawing)


def test_a_contact_with_a_wire_around_it_is_left_out() -> None:
    drawing: Drawing = [("X001 T:X002 T", "out(C1)"), (". - .", "")]
    assert source(drawing) == "if x[1]:\n    out(c[1])"
    [note] = read(drawing).notes
    assert note == "X002 in row 1, column B is left out: a wire leads around it"
    check_truth(drawing)


def test_a_wire_that_could_carry_power_back() -> None:
    """Power after X003 does not come back through the wire to C2."""
    drawing: Drawing = [("X003 - - T", "out(C1)"), ("X001 T - .", ""), (". X004", "out(C2)")]
    assert source(drawing) == (
        "if True:\n    if any(x[3], x[1]):\n        out(c[1])\n    if all(x[1], x[4]):\n        out(c[2])"
    )
    assert ONE_WAY_WIRE in read(drawing).notes
    check_truth(drawing)


REFUSED: dict[str, tuple[Drawing, int, str]] = {
    "a contact that leads nowhere": (
        [("X001", "out(C1)"), ("X002 - .", "")],
        3,
        "X002 in row 2, column A does not lead from the power rail to an output",
    ),
    "a contact without power": (
        [("X001", "out(C1)"), (". . DS1==5", "out(C2)")],
        3,
        "DS1==5 in row 2, column C does not lead from the power rail to an output",
    ),
    "an output without power": (
        [("X001 . -", "out(C1)")],
        2,
        "X001 in row 1, column A does not lead from the power rail to an output",
    ),
    "an output on a wire without power": ([(". -", "out(C1)")], 2, "out(C1) is not connected to the power rail"),
    "an instruction that nobody knows": (
        [("X001", "out(C1)"), ("X002", "dance(C1)")],
        3,
        "dance(C1) is no instruction that CLICK is known for",
    ),
    "an input that an instruction lacks": (
        [("X001", "off_delay(T1,TD1,preset=5,unit=Tms)"), ("X002", ".reset()")],
        3,
        "off_delay has no .reset() here",
    ),
    "a counter without its reset": (
        [("X001", "count_up(CT1,CTD1,preset=5)")],
        2,
        "count_up(CT1,CTD1,preset=5) is not written as CLICK writes it: look at its arguments and its inputs",
    ),
    "a range over a gap": ([("X001", "out(Y017)")], 2, "out(Y017) names Y017, which CLICK does not have"),
    "a token that the codec writes otherwise": (
        [("X001", "raw(Email,0x2737,1,60a5=1)")],
        2,
        "raw(Email,0x2737,1,60a5=1) cannot be kept: ",
    ),
    "an instruction of nobody": ([("X001", "blink(Y001)")], 2, "blink(Y001) is no instruction that CLICK is known for"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_cannot_be_kept_is_refused_with_its_row(name: str) -> None:
    drawing, row, message = REFUSED[name]
    with pytest.raises(LadderProblem) as caught:
        read(drawing)
    assert (caught.value.file, caught.value.row) == ("main.csv", row)
    assert caught.value.message.startswith(message)


def test_a_condition_beyond_reading_is_refused() -> None:
    """Bridges down and up again: each pair more than doubles the contacts."""
    drawing: Drawing = [
        ("X001 " + "T:X002 - - T " * 7 + "- -", "out(C1)"),
        (". " + "X003 | T:X006 . " * 7, ""),
        ("X004 " + "- X005 - - " * 7, "out(C2)"),
    ]
    with pytest.raises(LadderProblem, match=ENTANGLED):
        read(drawing)


def test_a_rung_without_an_output_becomes_nop() -> None:
    drawing: Drawing = [(".", ""), ("- - .", "")]
    assert source(drawing) == "if True:\n    pass"
    assert read(drawing).remarks == ("the rung has no output: it becomes NOP",)


def test_nop_beside_an_output_is_left_out() -> None:
    drawing: Drawing = [("X001 T", "out(C1)"), (". -", "NOP")]
    assert source(drawing) == "if x[1]:\n    out(c[1])"
    assert read(drawing).remarks == ("NOP beside an output does nothing: it is left out",)


def test_an_input_without_a_wire_is_never_on() -> None:
    rows = [wired("X001", "count_up(CT1,CTD1,preset=5)", "R"), ["", *[""] * 31, ".down()"], wired("X002", ".reset()")]
    [rung] = read_ladder(ladder_text(rows), "main.csv").rungs
    text = write_source([routine_of("main", [import_rung(rung).rung], True)])
    assert "count_down=lambda: nc(sc[1])" in text


def test_an_instruction_without_a_word_is_kept() -> None:
    token = "raw(Odd,0x2799,1,222d=0,222e=0,6096=1,609f=X004,60a0=X005,3218=9738,0000=)"
    rung = read([("X001", token)])
    [action] = rung.rung.items
    assert isinstance(action, Action)
    assert action.spec is RAW
    assert action_token(action) == token
    assert source([("X001", token)]) == f'if x[1]:\n    raw(\n        "{token}"\n    )'


def test_a_box_with_inputs_beside_an_output_is_built_as_two_rungs() -> None:
    """CLICK wants all inputs of a box on one branch (C000A); people draw it otherwise all the same."""
    drawing: Drawing = [
        ("X001 T", "out(C1)"),
        (". X002", "on_delay(T1,TD1,preset=5,unit=Tms)"),
        ("X003", ".reset()"),
    ]
    text = write_source([routine_of("main", rungs_of(ladder_text([*rows_of(drawing), END])), True)])
    assert text.startswith(
        "def main():\n    if x[1]:\n        out(c[1])\n        if x[2]:\n"
        "            rton(t[1], setpoint=5, unit=Tms, reset=lambda: x[3])\n"
    )
    assert len(rungs_of(ladder_files({"prog.py": text})["main.csv"])) == 3


def test_loops_close_around_their_rungs() -> None:
    rows = [wired("X001", "for(DS1,oneshot=1)", "R"), wired("", "out(C1)", "R"), wired("", "next()", "R")]
    text = write_source([routine_of("main", rungs_of(ladder_text(rows)), True)])
    assert text == (
        "def main():\n"
        "    if x[1]:\n"
        "        for _ in range(ds[1], oneshot=True):\n"
        "            if True:\n"
        "                out(c[1])\n"
    )


@pytest.mark.parametrize("between", [[], [["#", "the end"]], [wired("", "for(2)", "R")]])
def test_other_loops_stay_open(between: list[list[str]]) -> None:
    """An empty loop, one whose end has a comment, one that is not closed."""
    rows = [wired("", "for(3)", "R"), *between, wired("", "next()", "R")]
    text = write_source([routine_of("main", rungs_of(ladder_text(rows)), True)])
    assert "        for _ in range(3):\n            pass\n" in text
    assert "        next_loop()\n" in text


@pytest.mark.parametrize("name", ["two words", "9lives", "class", "main"])
def test_a_subroutine_needs_a_name_that_a_function_can_have(name: str) -> None:
    with pytest.raises(LadderProblem, match="cannot have the name"):
        routine_of(name, rungs_of(ladder_text([wired("", "return()", "R")])), False)
