"""Rungs as people draw them in CLICK, through the whole import: what a person would write, verified, and stable."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import pytest
from test_importing_cases import check_same, compared, ladder_text, wired

import clickgen
from clickgen.click.read.network import ONE_WAY_WIRE
from clickgen.commands.import_.project import ImportResult, Target, import_project
from clickgen.workspace import CouldNotRun

Drawing = Sequence[tuple[str, str]]
"""Rows: contacts, ``.`` for a blank square; and the output."""
Rows = list[list[str]]

END, RETURN = wired("", "end()", "R"), wired("", "return()", "R")
BLANK = ["R", *[""] * 32]
"""A rung in which nobody has drawn anything yet."""


def rung(*drawing: tuple[str, str]) -> Rows:
    return [wired(contacts, output, "" if index else "R") for index, (contacts, output) in enumerate(drawing)]


def comment(*lines: str) -> Rows:
    return [["#", line] for line in lines]


def write_bundle(folder: Path, routines: Mapping[str, Rows]) -> None:
    (folder / "subroutines").mkdir(parents=True)
    for name, rows in routines.items():
        path = folder / "main.csv" if name == "main" else folder / "subroutines" / f"{name}.csv"
        path.write_text(ladder_text(rows), encoding="utf-8")


def imported(folder: Path, routines: Mapping[str, Rows]) -> ImportResult:
    """Import a bundle; every rung must be verified."""
    write_bundle(folder / "plant", routines)
    result = import_project(folder / "plant", Target(folder / "prog.py"))
    assert result.ok, [(problem.code, problem.message) for problem in result.diagnostics]
    assert result.verdict is not None
    assert result.verdict.verified == result.rungs > 0
    return result


def came_back(folder: Path, routines: Mapping[str, Rows]) -> str:
    """The program. Built and imported again it has the same text, and a judge finds the same power."""
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


def first_rung(source: str) -> str:
    """The text of main's rungs before ``end()``, without the indentation."""
    body = source.removeprefix("def main():\n").partition("\n\n    if True:\n        end()\n")[0]
    return "\n".join(line[4:] for line in body.splitlines())


def coils(count: int, output: str) -> Drawing:
    """Outputs one below the other on one contact."""
    wires = ["X001 T", *[". T"] * (count - 2), ". -"]
    return [(wire, output.format(number)) for number, wire in enumerate(wires, 1)]


SHAPES: dict[str, tuple[Drawing, str]] = {
    "wires below boxes": (
        [("X001 T", "copy(1,DS1)"), (". |", ""), (". T", "copy(2,DS2)"), (". |", ""), (". X002", "out(C1)")],
        "if x[1]:\n    copy(1, ds[1])\n    copy(2, ds[2])\n    if x[2]:\n        out(c[1])",
    ),
    "a leg beside the lower row of a box": (
        [("X001 T:X002 T", "copy(1,DS1)"), (". X003 .", "")],
        "if all(x[1], any(x[2], x[3])):\n    copy(1, ds[1])",
    ),
    "empty rows between circuits": (
        [("X001", "out(C1)"), (". .", ""), (". .", ""), ("X002", "out(C2)"), (". .", "")],
        "if True:\n    if x[1]:\n        out(c[1])\n    if x[2]:\n        out(c[2])",
    ),
    "an empty row behind": (
        [("X001 T", "out(C1)"), ("X002 .", ""), (". .", "")],
        "if any(x[1], x[2]):\n    out(c[1])",
    ),
    "legs above a counter": (
        [("X001 |", ""), ("~X002 |", ""), ("rise(X003) -", "count_up(CT1,CTD1,preset=10)"), ("X004", ".reset()")],
        "if any(x[1], nc(x[2]), re(x[3])):\n    ctu(ct[1], setpoint=10, reset=lambda: x[4])",
    ),
    "legs above a shift register": (
        [("X001 |", ""), ("X002 -", "shift(C1..C8)"), ("SC7", ".clock()"), ("X003", ".reset()")],
        "if any(x[1], x[2]):\n    shift(c[1:9], clock=lambda: sc._1sec_Clock, reset=lambda: x[3])",
    ),
    "an or into the last input": (
        [
            ("X001", "count_up(CT1,CTD1,preset=DS5)"),
            ("X002", ".down()"),
            ("X003 T", ".reset()"),
            ("X004 |", ""),
            ("SC2 .", ""),
        ],
        "if x[1]:\n"
        "    ctud(\n"
        "        ct[1],\n"
        "        setpoint=ds[5],\n"
        "        count_down=lambda: x[2],\n"
        "        reset=lambda: any(x[3], x[4], sc._1st_SCAN),\n"
        "    )",
    ),
    "an or in the middle of the last input": (
        [("X001", "on_delay(T1,TD1,preset=5,unit=Ts)"), ("X002 T:X003 T", ".reset()"), (". X004 .", "")],
        "if x[1]:\n    rton(t[1], setpoint=5, unit=Ts, reset=lambda: all(x[2], any(x[3], x[4])))",
    ),
    "an input that branches off the enable": (
        [("X001 T", "count_up(CT1,CTD1,preset=3)"), (". X003", ".reset()")],
        "if x[1]:\n    ctu(ct[1], setpoint=3, reset=lambda: all(x[1], x[3]))",
    ),
    "a drum with all inputs": (
        [
            (
                "X001",
                "event_drum(outputs=[Y001,C2],events=[C3,X004],pattern=[[1,0],[0,1]],current_step=DS1,completion_flag=C9)",
            ),
            ("X002", ".reset()"),
            ("X003", ".jump(DS2)"),
            ("rise(X005)", ".jog()"),
        ],
        "if x[1]:\n"
        "    event_drum(\n"
        "        outputs=[y[1], c[2]],\n"
        "        events=[c[3], x[4]],\n"
        "        pattern=[[1, 0], [0, 1]],\n"
        "        current_step=ds[1],\n"
        "        completion_flag=c[9],\n"
        "        reset=lambda: x[2],\n"
        "        jump=lambda: x[3],\n"
        "        jump_step=ds[2],\n"
        "        jog=lambda: re(x[5]),\n"
        "    )",
    ),
    "a time drum": (
        [
            (
                "X001",
                "time_drum(outputs=[Y001,Y002],presets=[10,20],unit=Ts,pattern=[[1,0],[0,1]],current_step=DS1,accumulator=TD1,completion_flag=C9)",
            ),
            ("X002", ".reset()"),
        ],
        "if x[1]:\n"
        "    time_drum(\n"
        "        outputs=[y[1], y[2]],\n"
        "        presets=[10, 20],\n"
        "        unit=Ts,\n"
        "        pattern=[[1, 0], [0, 1]],\n"
        "        current_step=ds[1],\n"
        "        accumulator=td[1],\n"
        "        completion_flag=c[9],\n"
        "        reset=lambda: x[2],\n"
        "    )",
    ),
    "a NOP with contacts and legs": (
        [("X001 T:X002 T", "NOP"), (". X003 .", "")],
        "if all(x[1], any(x[2], x[3])):\n    pass",
    ),
    "a NOP beside outputs": (
        [("X001 T", "out(C1)"), (". -", "NOP")],
        "if x[1]:\n    out(c[1])",
    ),
    "a NOP above an output of another circuit": (
        [("", "NOP"), ("X001", "out(C1)")],
        "if x[1]:\n    out(c[1])",
    ),
    "several circuits of several kinds": (
        [
            ("X001 T", "out(C1)"),
            ("X002 .", ""),
            ("DS1>5 T", "copy(1,DS2)"),
            (". |", ""),
            (". ~X003", "latch(C2)"),
            ("", "math(DS1 + 1,DS1,mode=decimal)"),
            ("X004", "reset(C2)"),
        ],
        "if True:\n"
        "    if any(x[1], x[2]):\n"
        "        out(c[1])\n"
        "    if ds[1] > 5:\n"
        "        copy(1, ds[2])\n"
        "        if nc(x[3]):\n"
        "            set(c[2])\n"
        '    calc("ds[1] + 1", ds[1])\n'
        "    if x[4]:\n"
        "        reset(c[2])",
    ),
    "taps at several points of one path": (
        [("X001 T:X002 T:X003 T:X004", "out(C1)"), (". | | -", "out(C2)"), (". | -", "out(C3)"), (". -", "out(C4)")],
        "if x[1]:\n"
        "    if x[2]:\n"
        "        if x[3]:\n"
        "            if x[4]:\n"
        "                out(c[1])\n"
        "            out(c[2])\n"
        "        out(c[3])\n"
        "    out(c[4])",
    ),
    "taps that go on": (
        [("X001 T T:X002 T", "out(C1)"), (". | | X003", "out(C2)"), (". | X004", "out(C3)"), (". X005", "out(C4)")],
        "if x[1]:\n"
        "    if x[2]:\n"
        "        out(c[1])\n"
        "        if x[3]:\n"
        "            out(c[2])\n"
        "    if x[4]:\n"
        "        out(c[3])\n"
        "    if x[5]:\n"
        "        out(c[4])",
    ),
    "branches in branches in branches": (
        [
            ("X001 T:X002 T:X003 T:X004 T", "out(C1)"),
            (". | | | -", "out(C2)"),
            (". | | X005", "out(C3)"),
            (". | X006 T", "out(C4)"),
            (". | . X007", "out(C5)"),
            (". X008", "out(C6)"),
        ],
        "if x[1]:\n"
        "    if x[2]:\n"
        "        if x[3]:\n"
        "            if x[4]:\n"
        "                out(c[1])\n"
        "                out(c[2])\n"
        "            if x[5]:\n"
        "                out(c[3])\n"
        "        if x[6]:\n"
        "            out(c[4])\n"
        "            if x[7]:\n"
        "                out(c[5])\n"
        "    if x[8]:\n"
        "        out(c[6])",
    ),
    "a branch that comes back": (
        [("X001 T:X002 T:X003 T", "out(C1)"), (". | X004 .", ""), (". X005 - -", "out(C2)")],
        "if x[1]:\n    if all(x[2], any(x[3], x[4])):\n        out(c[1])\n    if x[5]:\n        out(c[2])",
    ),
    "two branches that come back one behind the other": (
        [("X001 T:X002 T:X003 T X006", "out(C1)"), (". X004 T:X005 |", ""), (". . X007 .", "")],
        "if all(x[1], any(x[2], x[4]), any(x[3], x[5], x[7]), x[6]):\n    out(c[1])",
    ),
    "a bridge between two outputs": (
        [("X001 T T:X002", "out(C1)"), ("X003 . X004", "out(C2)")],
        "if any(x[1], x[3]):\n    if x[2]:\n        out(c[1])\n    if x[4]:\n        out(c[2])",
    ),
    "a chain of T": (
        [("X001 T T T", "out(C1)"), (". . . T:X002", "out(C2)"), (". . . X003", "out(C3)")],
        "if x[1]:\n    out(c[1])\n    if x[2]:\n        out(c[2])\n    if x[3]:\n        out(c[3])",
    ),
    "a downward wire through blanks": (
        [("X001 T", "out(C1)"), (". |", ""), (". |", ""), (". X002", "out(C2)")],
        "if x[1]:\n    out(c[1])\n    if x[2]:\n        out(c[2])",
    ),
    "every kind of coil at once": (
        [
            ("X001 T", "out(Y001)"),
            (". T", "out(C1..C8)"),
            (". T", "out(immediate(Y002))"),
            (". T", "out(immediate(Y003..Y004))"),
            (". T", "out(C9,oneshot=1)"),
            (". T", "latch(C10)"),
            (". T", "latch(C11..C12)"),
            (". T", "latch(immediate(Y005))"),
            (". T", "reset(C10)"),
            (". T", "reset(C11..C12)"),
            (". T", "reset(immediate(Y005))"),
            (". -", "out(SC50)"),
        ],
        "if x[1]:\n"
        "    out(y[1])\n"
        "    out(c[1:9])\n"
        "    out(y[2].immediate)\n"
        "    out(y[3:5].immediate)\n"
        "    out(c[9], oneshot=True)\n"
        "    set(c[10])\n"
        "    set(c[11:13])\n"
        "    set(y[5].immediate)\n"
        "    reset(c[10])\n"
        "    reset(c[11:13])\n"
        "    reset(y[5].immediate)\n"
        "    out(sc._PLC_Mode_Change_to_STOP)",
    ),
    "every kind of box at once": (
        [
            ("X001 T", "copy(DS[DS1],DD[DS2],oneshot=1)"),
            (". T", "blockcopy(DS1..DS5,DS100..DS104)"),
            (". T", "fill(0,DS1..DS5)"),
            (". T", "pack_bits(C1..C16,DH1)"),
            (". T", "unpack_to_bits(DH1,C1..C16)"),
            (". T", "search(DS1..DS10 == 5,result=DS20,found=C1)"),
            (". T", "math(( DS1 * 10 ) + SUM ( DS301 : DS350 ),DD2,mode=decimal)"),
            (". T", "off_delay(T2,TD2,preset=DS3,unit=Tm)"),
            (". T", 'copy("AB",TXT1)'),
            (". -", "copy($0D,TXT2)"),
        ],
        "if x[1]:\n"
        "    copy(ds[ds[1]], dd[ds[2]], oneshot=True)\n"
        "    copy_block(ds[1:6], ds[100])\n"
        "    copy_fill(0, ds[1:6])\n"
        "    copy_pack(c[1:17], dh[1])\n"
        "    copy_unpack(dh[1], c[1:17])\n"
        "    search(ds[1:11] == 5, result=ds[20], found=c[1])\n"
        '    calc("(ds[1] * 10) + SUM(ds[301:351])", dd[2])\n'
        "    tof(t[2], setpoint=ds[3], unit=Tm)\n"
        '    copy("AB", txt[1])\n'
        '    copy("$0D", txt[2])',
    ),
    "immediate contacts and edges": (
        [
            ("immediate(X001) T:rise(X002) T", "out(immediate(Y001))"),
            (". T:~immediate(X003) |", ""),
            (". fall(C1) .", ""),
        ],
        "if all(x[1].immediate, any(re(x[2]), nc(x[3].immediate), fe(c[1]))):\n    out(y[1].immediate)",
    ),
    "compares in legs": (
        [("DS1==5 T:DF1>=1.5 T", "out(C1)"), ('TXT1=="A" DH1!=00FFh .', "")],
        'if all(any(ds[1] == 5, txt[1] == "A"), any(df[1] >= 1.5, dh[1] != 0x00FF)):\n    out(c[1])',
    ),
    "a box with inputs between coils": (
        [
            ("X001 T", "out(C1)"),
            (". X002", "on_delay(T1,TD1,preset=5,unit=Ts)"),
            ("X003", ".reset()"),
            ("X004", "out(C2)"),
        ],
        "if x[1]:\n"
        "    out(c[1])\n"
        "\n"
        "if all(x[1], x[2]):\n"
        "    rton(t[1], setpoint=5, unit=Ts, reset=lambda: x[3])\n"
        "\n"
        "if x[4]:\n"
        "    out(c[2])",
    ),
    "two boxes with inputs": (
        [
            ("X001", "count_up(CT1,CTD1,preset=5)"),
            ("X002", ".reset()"),
            ("X003", "count_down(CT2,CTD2,preset=5)"),
            ("X004", ".reset()"),
        ],
        "if x[1]:\n"
        "    ctu(ct[1], setpoint=5, reset=lambda: x[2])\n"
        "\n"
        "if x[3]:\n"
        "    ctd(ct[2], setpoint=5, reset=lambda: x[4])",
    ),
    "a box with inputs and a coil that it reads": (
        [("X001", "out(C1)"), ("C1", "on_delay(T1,TD1,preset=5,unit=Ts)"), ("X003", ".reset()"), ("T1 C1", "out(C2)")],
        "if True:\n"
        "    if x[1]:\n"
        "        out(c[1])\n"
        "    if c[1]:\n"
        "        rton(t[1], setpoint=5, unit=Ts, reset=lambda: x[3])\n"
        "    if all(t[1], c[1]):\n"
        "        out(c[2])",
    ),
    "a call and a return in branches": (
        [("X001 T:X002", 'call("Sub")'), (". T:X003", "out(C1)"), (". X004", 'call("Sub")')],
        "if x[1]:\n    if x[2]:\n        call(Sub)\n    if x[3]:\n        out(c[1])\n    if x[4]:\n        call(Sub)",
    ),
    "a contact twice": (
        [("X001 T:X001 T", "out(C1)"), (". ~X001 .", "")],
        "if all(x[1], any(x[1], nc(x[1]))):\n    out(c[1])",
    ),
    "a wire that crosses another": (
        [("X001 T X002", "out(C1)"), ("X003 T X004", "out(C2)"), (". X005", "out(C3)")],
        "if any(x[1], x[3]):\n"
        "    if x[2]:\n"
        "        out(c[1])\n"
        "    if x[4]:\n"
        "        out(c[2])\n"
        "    if x[5]:\n"
        "        out(c[3])",
    ),
    "a hanging wire": (
        [("X001 T", "out(C1)"), (". |", ""), (". |", ""), (". .", "")],
        "if x[1]:\n    out(c[1])",
    ),
    "always on and never on": (
        [("SC1", "out(C1)"), ("~SC1", "out(C2)")],
        "if True:\n    if sc._Always_ON:\n        out(c[1])\n    if nc(sc._Always_ON):\n        out(c[2])",
    ),
    "sixteen copies, thirty-two rows with their boxes": (
        coils(16, "copy({0},DS{0})"),
        "if x[1]:\n" + "\n".join(f"    copy({number}, ds[{number}])" for number in range(1, 17)),
    ),
    "thirty-two coils": (
        coils(32, "out(C{})"),
        "if x[1]:\n" + "\n".join(f"    out(c[{number}])" for number in range(1, 33)),
    ),
    "thirty-one contacts in series": (
        [(" ".join(f"C{number}" for number in range(1, 32)), "out(Y001)")],
        "if all(\n" + "".join(f"    c[{number}],\n" for number in range(1, 32)) + "):\n    out(y[1])",
    ),
    "thirty-two legs": (
        [("C1 T", "out(Y001)"), *((f"C{number} |", "") for number in range(2, 32)), ("C32", "")],
        "if any(\n" + "".join(f"    c[{number}],\n" for number in range(1, 33)) + "):\n    out(y[1])",
    ),
    "a contact right before the output": (
        [("X001 " + "- " * 29 + "X002", "out(C1)")],
        "if all(x[1], x[2]):\n    out(c[1])",
    ),
    "legs that meet right before the output": (
        [("X001 " + "- " * 29 + "T", "out(C1)"), ("X002 " + "- " * 29 + ".", "")],
        "if any(x[1], x[2]):\n    out(c[1])",
    ),
}

SPLIT = (
    "a box with inputs between coils",
    "two boxes with inputs",
    "a box with inputs and a coil that it reads",
)
"""CLICK wants all inputs of a box on one branch (C000A), so a build makes several rungs of these, and import too.

The last one needs scratch bits, and stays as it is drawn.
"""
HANGING = ("a hanging wire", "a chain of T", "empty rows between circuits", "an empty row behind")
"""The judge takes no wires that hang in the air, and no rows without anything."""


@pytest.mark.parametrize("name", SHAPES)
def test_a_shape_is_written_as_a_person_would(name: str, tmp_path: Path) -> None:
    drawing, expected = SHAPES[name]
    rows = [*rung(*drawing), END]
    result = imported(tmp_path, {"main": rows, "Sub": [RETURN]})
    source = result.files[tmp_path / "prog.py"].decode()
    assert first_rung(source) == expected
    codes = {problem.code for problem in result.diagnostics}
    assert codes - {"CG705"} == ({"CG704"} if name in SPLIT else set())
    if name == SPLIT[-1]:
        return
    result.write()
    before = {"main.csv": ladder_text(rows), "subroutines/Sub.csv": ladder_text([RETURN])}
    built = clickgen.build(tmp_path / "prog.py", frozen=True)
    assert built.ok, built.diagnostics
    built.write(tmp_path / "again")
    second = import_project(tmp_path / "again", Target(tmp_path / "second" / "prog.py"))
    assert second.files[tmp_path / "second" / "prog.py"].decode() == source
    if name not in (*HANGING, *SPLIT) and "NOP" not in name:
        for pair in compared(before, {file: built.files[file] for file in before}):
            check_same(pair)


@pytest.mark.parametrize("name", SPLIT)
def test_a_rung_that_becomes_several_is_the_same(name: str, tmp_path: Path) -> None:
    """Without ``frozen``: the parts may need scratch bits. The second import has the parts."""
    result = imported(tmp_path, {"main": [*rung(*SHAPES[name][0]), END]})
    assert result.verdict is not None
    assert len(result.verdict.redrawn) == 1
    result.write()
    built = clickgen.build(tmp_path / "prog.py")
    assert built.ok, built.diagnostics
    assert len(built.routines[0].rungs) > 2
    built.write(tmp_path / "again")
    second = import_project(tmp_path / "again", Target(tmp_path / "second" / "prog.py"))
    assert second.ok
    assert second.verdict is not None
    assert (second.verdict.verified, second.verdict.redrawn) == (second.rungs, [])


def test_the_last_output_reads_what_the_first_wrote_before_the_rung(tmp_path: Path) -> None:
    """All conditions of a rung are looked at before its first output runs: a split needs a scratch bit for that."""
    name = "a box with inputs and a coil that it reads"
    imported(tmp_path, {"main": [*rung(*SHAPES[name][0]), END]}).write()
    built = clickgen.build(tmp_path / "prog.py")
    assert built.scratch_rows
    scratch = {str(row.address) for row in built.scratch_rows}
    lines = built.files["main.csv"].splitlines()
    coil = next(index for index, line in enumerate(lines) if line.endswith("out(C1)"))
    assert any(line.endswith(f"out({bit})") for line in lines[:coil] for bit in scratch)
    assert not any(",C1," in line for line in lines[coil + 1 :])


# -- what a person should know ----------------------------------------------------------------------------------------


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
    """Power could come back through the wire in row 2; it is taken to go to the right alone."""
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
        "main rung 1: .reset() does not stand directly below its instruction",
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


# -- comments ---------------------------------------------------------------------------------------------------------

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
    """People head a section so; CLICK keeps a NOP there."""
    source = came_back(tmp_path, {"main": [*comment("=== Cooling ===", ""), *drawn, END]})
    assert first_rung(source) == "# === Cooling ===\n#\nif True:\n    pass"


def test_a_comment_that_is_too_long_is_told(tmp_path: Path) -> None:
    write_bundle(tmp_path / "plant", {"main": [*comment("x" * 1401), *rung(("X001", "out(C1)")), END]})
    result = import_project(tmp_path / "plant", Target(tmp_path / "prog.py"))
    [problem] = result.diagnostics
    assert (problem.code, problem.message.startswith("main rung 1: ")) == ("CG702", True)
    assert "1401 bytes" in problem.message


# -- loops, returns, ends ---------------------------------------------------------------------------------------------


def test_loops(tmp_path: Path) -> None:
    """A loop stands around its rungs; one around nothing, or whose end has a comment, is closed by hand."""
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
    """Rungs are counted through main.csv and main_2.csv, and a build parts them anew."""
    write_bundle(tmp_path / "plant", {"main": [row for _ in range(3) for row in rung(("X001", "out(C1)"))]})
    (tmp_path / "plant" / "main_2.csv").write_text(ladder_text([*rung(("X001", "out(X009)")), END]))
    result = import_project(tmp_path / "plant", Target(tmp_path / "prog.py"))
    [problem] = result.diagnostics
    assert problem.message.startswith("main rung 4: ")
    assert problem.span is not None
    assert Path(problem.span.path).name == "main_2.csv"


# -- what stops the whole program -------------------------------------------------------------------------------------


def test_a_subroutine_with_the_name_of_main_is_refused(tmp_path: Path) -> None:
    """CLICK tells the two apart, a program and a bundle do not."""
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
