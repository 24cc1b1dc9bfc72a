"""Rungs as people draw them in CLICK, and the text that a person would write for each."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from test_importing_cases import ladder_text, wired

from clickgen.commands.import_.project import ImportResult, Target, import_project

Drawing = Sequence[tuple[str, str]]
"""Rows: contacts, ``.`` for a blank square; and the output."""


Rows = list[list[str]]


END, RETURN = wired("", "end()", "R"), wired("", "return()", "R")


def rung(*drawing: tuple[str, str]) -> Rows:
    return [wired(contacts, output, "" if index else "R") for index, (contacts, output) in enumerate(drawing)]


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
    "two branches that come back one after the other": (
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
