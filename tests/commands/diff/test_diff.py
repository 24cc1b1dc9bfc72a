"""``clickgen diff`` as a user sees it: its messages about rungs and routines."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest
from diffing import RUNGS, SUB, Drawing, Run, build, bundle, happened, plant, program, run, side, write, write_plant

from clickgen.click.compare.same import Comparison, Likeness
from clickgen.commands.diff.changes import ADDED
from clickgen.commands.diff.programs import diff

__all__ = ["bundle", "run"]


# -- rungs -------------------------------------------------------------------------------------------------------------


def test_what_was_built_is_what_the_program_says(run: Run, bundle: str) -> None:
    before = {path: path.read_bytes() for path in Path().rglob("*") if path.is_file()}
    said = run("prog.py", bundle)
    assert said == (0, "--- prog.py\n+++ plc\n\nNo difference in logic: 7 rungs in 2 routines.\n", "")
    assert run(bundle, "prog.py").code == 0
    assert {path: path.read_bytes() for path in Path().rglob("*") if path.is_file()} == before


def test_a_changed_rung(run: Run, bundle: str) -> None:
    write("prog.py", program(RUNGS[0].replace("c.EStop", "c.Stop"), *RUNGS[1:], sub=SUB))
    said = run(bundle, "prog.py")
    assert said.code == 1
    assert said.lines == [
        "main",
        "  rung 1 changed",
        "      | Start and stop",
        "    - if C1:Start and not C2:EStop",
        "    + if C1:Start and not C6:Stop",
        "        latch(C3:Running)",
        "Nicknames",
        "  + C6 Stop",
        "1 rung changed in 1 routine.",
        "Without effect on the PLC: 1 nickname or its comment differs.",
        "Note: a name of prog.py has no address yet; the one that a build would choose is compared.",
    ]
    assert run(bundle, "prog.py", "--quiet").out == "\n".join(said.lines[-3:]) + "\n"


def test_an_added_rung_is_no_noise(run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    rungs = [f"    if c[{n}]:\n        set(y[1])\n" for n in (1, 2) * 100]
    write("prog.py", program(*rungs))
    build("prog.py", "plc", capsys)
    write("prog.py", program("    if c[3]:\n        out(c[4])\n", *rungs))
    said = run("plc", "prog.py")
    assert said.lines == ["main", "  rung 1 added", "    + if C3", "    +   out(C4)", "1 rung added in 1 routine."]
    assert run("prog.py", "plc").lines[1] == "  rung 1 removed"


def test_a_rung_that_is_there_twice(run: Run, bundle: str) -> None:
    write("prog.py", program(*RUNGS[:2], RUNGS[1], *RUNGS[2:], sub=SUB))
    said = run(bundle, "prog.py")
    assert said.code == 1
    assert [line for line in said.lines if line.startswith("  rung")] in (["  rung 2 added"], ["  rung 3 added"])


def test_a_moved_rung(run: Run, bundle: str) -> None:
    write("prog.py", program(RUNGS[0], RUNGS[2], RUNGS[3], RUNGS[1], sub=SUB))
    said = run(bundle, "prog.py")
    assert said.code == 1
    assert said.lines == [
        "main",
        "  rung 2 moved to rung 4",
        "      if C3:Running",
        "        out(Y001)",
        "1 rung moved in 1 routine.",
    ]


def test_a_rung_that_moves_to_another_routine(run: Run, bundle: str) -> None:
    write("prog.py", program(*RUNGS[:1], *RUNGS[2:], sub=SUB.replace("def wash():\n", f"def wash():\n{RUNGS[1]}\n")))
    said = run(bundle, "prog.py")
    assert said.code == 1
    assert said.lines[:2] == ["main", "  rung 2 moved to wash rung 1"]
    assert said.lines[4:6] == ["wash", "  rung 1 moved here from main rung 2"]
    assert said.lines[-1] == "1 rung moved in 2 routines."


def test_a_rung_that_changes_its_place_and_its_comment(run: Run, bundle: str) -> None:
    other = RUNGS[2].replace("How many", "How much")
    write("prog.py", program(other, *RUNGS[:2], RUNGS[3], sub=SUB))
    said = run(bundle, "prog.py")
    assert said.lines[1:4] == ["  rung 3 moved to rung 1", "    - | How many", "    + | How much"]


def test_a_changed_rung_with_another_number(run: Run, bundle: str) -> None:
    write("prog.py", program(*RUNGS[1:3], RUNGS[3].replace("5", "6"), sub=SUB))
    said = run(bundle, "prog.py")
    assert [line for line in said.lines if line.startswith("  rung")] == [
        "  rung 1 removed",
        "  rung 4, now rung 3, changed",
    ]


def test_only_a_comment(run: Run, bundle: str) -> None:
    write("prog.py", program(*RUNGS[:2], RUNGS[2].replace("How many", "How many\n    # and why"), RUNGS[3], sub=SUB))
    said = run(bundle, "prog.py")
    assert said.code == 0
    assert said.lines == [
        "main",
        "  rung 3 comment changed",
        "      | How many",
        "    + | and why",
        "No difference in logic: 7 rungs in 2 routines.",
        "Without effect on the PLC: 1 comment changed.",
    ]


def test_a_rung_that_is_only_drawn_otherwise(run: Run, bundle: str) -> None:
    rung = RUNGS[0].replace("all(c.Start, nc(c.EStop))", "all(nc(c.EStop), c.Start)")
    write("prog.py", program(rung, *RUNGS[1:], sub=SUB, top="nickname(c.Start, c[1])\nnickname(c.EStop, c[2])\n\n\n"))
    said = run(bundle, "prog.py")
    assert said.code == 0
    assert said.lines[-1] == "Without effect on the PLC: 1 rung is drawn otherwise."


def test_long_conditions_are_compared_term_by_term(run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    terms = ", ".join(f"c.Rather_long_name_{n}" for n in range(12))
    write("prog.py", program(f"    if all({terms}):\n        out(y[1])\n"))
    build("prog.py", "plc", capsys)
    write("prog.py", program(f"    if all({terms.replace('name_7', 'text_7')}):\n        out(y[1])\n"))
    marked = [line for line in run("plc", "prog.py").lines if line[4:5] in ("-", "+")]
    assert marked == ["    -    and C8:Rather_long_name_7", "    +    and C13:Rather_long_text_7"]


def test_a_proof_that_fails_is_told(run: Run, bundle: str, monkeypatch: pytest.MonkeyPatch) -> None:
    unknown = Comparison(Likeness.UNKNOWN, "too many ways")
    monkeypatch.setattr("clickgen.commands.diff.rungs.compare", lambda *_: unknown)
    write("prog.py", program(RUNGS[0].replace("nc(c.EStop)", "c.EStop"), *RUNGS[1:], sub=SUB))
    said = run(bundle, "prog.py")
    assert (said.code, said.lines[1]) == (1, "  rung 1 changed, as far as is known (too many ways)")


def test_words_that_hide_a_difference(run: Run, bundle: str, monkeypatch: pytest.MonkeyPatch) -> None:
    different = Comparison(Likeness.DIFFERENT, "out(Y001) has power always")
    monkeypatch.setattr("clickgen.commands.diff.rungs.compare", lambda *_: different)
    said = run(bundle, "prog.py")
    assert said.code == 1
    assert "  rung 2 changed, which its words do not show (out(Y001) has power always)" in said.lines
    assert "      C3:Running  30 x -  out(Y001)" in said.lines


def test_a_rung_without_words_is_shown_by_its_cells(run: Run, bundle: str) -> None:
    text = Path("plc/main.csv").read_text("utf-8")
    wires = ",".join(["C3", *["-"] * 30])
    assert f"R,{wires},out(Y001)" in text
    write("plc/main.csv", text.replace(f"R,{wires},out(Y001)", f"R,{','.join(['', *['-'] * 30])},out(Y001)"))
    said = run(bundle, "prog.py")
    assert said.code == 1
    assert "    - .  30 x -  out(Y001)" in said.lines


# -- one rung on one side, several on the other ------------------------------------------------------------------------


MIXED: Drawing = [
    ("X001 T", "out(Y001)"),
    (". -", "count_up(CT1,CTD1,preset=5)"),
    (".", ""),
    ("X002", ".reset()"),
]


DIVIDED: tuple[Drawing, ...] = (
    [("X001", "out(Y001)")],
    [("X001", "count_up(CT1,CTD1,preset=5)"), (".", ""), ("X002", ".reset()")],
)


LOOP: Drawing = [("-", "for(5)")]


NEXT: Drawing = [("-", "next()")]


@pytest.mark.parametrize("is_twice", [False, True])
@pytest.mark.parametrize(
    ("one", "other"),
    [
        ([MIXED], DIVIDED),
        ([[("X003", "out(C9)")], MIXED, [("X001", "out(Y001)")]], [[("X003", "out(C9)")], *DIVIDED, DIVIDED[0]]),
        ([LOOP, MIXED, NEXT], [LOOP, *DIVIDED, NEXT]),
        ([[("C1 T", "out(C2)"), (". -", "out(C3)")]], [[("C1", "out(C2)")], [("C1", "out(C3)")]]),
        (
            [[("C1 T", "out(C2)"), (". -", "out(C3)")], [("C1", "out(C4)")]],
            [[("C1", "out(C2)")], [("C1 T", "out(C3)"), (". -", "out(C4)")]],
        ),
    ],
)
def test_a_rung_that_is_divided_stays(one: Sequence[Drawing], other: Sequence[Drawing], is_twice: bool) -> None:
    times = 2 if is_twice else 1
    for before, after in ((one, other), (other, one)):
        found = diff(side(plant(*[*before] * times)), side(plant(*[*after] * times)))
        assert (found.differs, happened(found)) == (False, [])
        assert found.drawn_otherwise
        if len(after) > 1:
            assert diff(side(plant(*before)), side(plant(*after[::-1]))).differs
        added = diff(side(plant(*before)), side(plant(*after, [("X009", "out(Y009)")])))
        assert [kind for kind, *_ in happened(added)] == [ADDED]


def test_a_divided_rung_is_no_pretext() -> None:
    """A later part must not look at what an earlier one drives."""
    whole: Drawing = [("C1 T", "out(C1)"), (". -", "out(C2)")]
    parts: tuple[Drawing, ...] = ([("C1", "out(C1)")], [("C1", "out(C2)")])
    assert not diff(side(plant(whole)), side(plant(whole))).differs
    other: tuple[Drawing, ...] = ([("~X001 C1", "out(C1)")], [("C1", "out(C2)")])
    joined: Drawing = [("C1 T ~X001", "out(C1)"), (". -", "out(C2)")]
    assert diff(side(plant(whole)), side(plant(*parts))).differs
    assert diff(side(plant(joined)), side(plant(*other))).differs


def test_a_tall_rung_that_is_divided_stays() -> None:
    wires = ["X001 T", *[". T"] * 30, ". -"]
    tall = [(wire, f"out(C{n})") for n, wire in enumerate(wires, 1)]
    single_ones = [[("X001", f"out(C{n})")] for n in range(1, 33)]
    assert not diff(side(plant(tall)), side(plant(*single_ones))).differs
    assert diff(side(plant(tall)), side(plant(*single_ones[:-1]))).differs


# -- rungs that do nothing ---------------------------------------------------------------------------------------------


def test_a_rung_that_does_nothing_is_no_logic(run: Run) -> None:
    coil: Drawing = [("X001", "out(Y001)")]
    write_plant("plant", coil)
    for number, idle in enumerate(([("-", "NOP")], [("X002", "")])):
        write_plant("new", coil, idle)
        said = run("plant", "new")
        assert said.code == 0, number
        assert said.lines[:2] == ["main", "  rung 2, which does nothing, added"]
        assert "Without effect on the PLC: 1 comment changed." in said.lines
        said = run("new", "plant")
        assert (said.code, said.lines[1]) == (0, "  rung 2, which does nothing, removed")
        text = Path("new/main.csv").read_text("utf-8")
        marker = text.split("\n")[2]
        write("new/main.csv", text.replace(marker, f"#,Valves\n{marker}"))
        said = run("plant", "new")
        assert (said.code, said.lines[2]) == (0, "    + | Valves")


# -- routines ----------------------------------------------------------------------------------------------------------


def test_routines_that_come_and_go(run: Run, bundle: str) -> None:
    write("prog.py", program(*RUNGS, sub=SUB.replace("wash", "rinse").replace("c.Wash", "c.Rinse")))
    said = run(bundle, "prog.py")
    assert said.code == 1
    assert said.lines[:6] == [
        "rinse added (2 rungs)",
        "  rung 1 added",
        "    + if C6:Rinse",
        "    +   out(C5:Valve)",
        "  rung 2 added",
        "    + always",
    ]
    place = said.lines.index("wash removed (2 rungs)")
    assert said.lines[place + 1 : place + 4] == ["  rung 1 removed", "    - if C4:Wash", "    -   out(C5:Valve)"]
    assert said.lines[-3] == "1 routine added; 1 routine removed."


def test_the_rungs_of_a_large_routine_are_counted(run: Run, bundle: str) -> None:
    rungs = "\n".join(f"    if c[{n}]:\n        out(c[{n + 100}])\n" for n in range(100, 120))
    write("prog.py", program(*RUNGS, sub=f"{SUB}\n\n@sub\ndef more():\n{rungs}\n    if True:\n        return\n"))
    assert run(bundle, "prog.py").lines == ["more added (21 rungs)", "1 routine added."]
    assert run("prog.py", bundle).lines == ["more removed (21 rungs)", "1 routine removed."]


def test_a_renamed_routine(run: Run, bundle: str) -> None:
    write("prog.py", program(*RUNGS, sub=SUB.replace("wash", "rinse")))
    said = run(bundle, "prog.py")
    assert (said.code, said.lines) == (1, ["wash renamed to rinse (2 rungs)", "1 routine renamed."])


def test_the_order_of_routines_is_no_logic(run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    other = SUB.replace("wash", "air").replace("c.Wash", "c.Air").replace("c.Valve", "c.Fan")
    write("prog.py", program(*RUNGS, sub=SUB + other))
    build("prog.py", "plc", capsys)
    write("prog.py", program(*RUNGS, sub=other + SUB))
    assert run("plc", "prog.py").code == 0


def test_a_long_main_in_several_files(run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    rungs = [f"    if c[{n % 1000 + 1}]:\n        set(y[{n % 16 + 1}])\n" for n in range(600)]
    write("prog.py", program(*rungs))
    build("prog.py", "plc", capsys)
    assert len(list(Path("plc").glob("main*.csv"))) > 1
    assert run("prog.py", "plc").code == 0
    write("prog.py", program(*rungs[:449], *rungs[450:]))
    said = run("plc", "prog.py")
    assert [line for line in said.lines if line.startswith("  rung")] == ["  rung 450 removed"]
