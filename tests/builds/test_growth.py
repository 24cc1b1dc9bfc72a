"""Work grows with its input: counted in calls of functions, so that a busy machine changes nothing."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from judges.work import calls_in

from clickgen.cli import main
from clickgen.click.read.operands import condition_of, operand_of
from clickgen.commands.check.programs import Outcome, Request
from clickgen.commands.check.programs import run as run_check
from clickgen.config import find_config
from clickgen.device.banks import Kind
from clickgen.device.limits import comment_bytes, styled_part
from clickgen.dialects.if_rungs.look import is_program
from clickgen.lower import split
from clickgen.table.blocks import mark_in
from clickgen.table.rows import initial_fault
from clickgen.text.patterns import matches
from clickgen.text.source import Span

END = "    if True:\n        end()\n"
RUNGS: dict[str, Callable[[int], str]] = {
    "outputs of one rung": lambda n: "    if x[1]:\n" + "".join(f"        copy({i}, ds[{i + 1}])\n" for i in range(n)),
    "branches of one rung": lambda n: (
        "    if x[1]:\n" + "".join(f"        if c[{i + 1}]:\n            copy({i}, ds[{i + 1}])\n" for i in range(n))
    ),
    "rungs on one coil": lambda n: "".join(f"    if c[{i + 1}]:\n        out(y[1])\n" for i in range(n)),
    "silenced findings": lambda n: "".join(
        f"    if c[{i + 1}]:\n        out(y[1])  # clickgen: ignore[CG501]\n" for i in range(n)
    ),
    "toggles of one bit": lambda n: (
        "    if all(re(x[1]), nc(c[1])):\n        set(c[1])\n    if all(re(x[1]), c[1]):\n        reset(c[1])\n" * n
    ),
    "toggles of one bit on a level": lambda n: (
        "    if all(x[1], nc(c[1])):\n        set(c[1])\n    if all(x[1], c[1]):\n        reset(c[1])\n" * n
    ),
    "branches that fill a long range": lambda n: (
        "    if x[1]:\n" + "".join(f"        if c[{i + 1}]:\n            copy_fill({i}, ds[1:301])\n" for i in range(n))
    ),
    "coils in ranges that are reset": lambda n: "".join(
        f"    if x[1]:\n        out(c[{i + 1}])\n    if x[2]:\n        reset(c[1:301])\n" for i in range(n)
    ),
}
ALTERNATING = "".join(f"{'all' if i % 2 else 'any'}(c.{'AB'[i % 2]}, " for i in range(25)) + "c.Z" + ")" * 25


def judged(text: str, folder: Path) -> int:
    """The work of a check."""
    return judged_and_told(text, folder)[0]


def judged_and_told(text: str, folder: Path) -> tuple[int, list[str]]:
    """The work of a check, and the codes of its findings."""
    (folder / "p.py").write_text(text, "utf-8")
    (folder / "clickgen.toml").write_text('[check.per-file-ignores]\n"**/q*.py" = ["CG5"]\n', "utf-8")
    request = Request(find_config(folder), paths=(str(folder / "p.py"),), use_cache=False)
    outcomes: list[Outcome] = []
    work = calls_in(lambda: outcomes.append(run_check(request)))
    return work, [problem.code for problem in outcomes[0].findings]


@pytest.mark.parametrize("name", RUNGS)
def test_the_work_of_a_check_grows_with_the_program(name: str, tmp_path: Path) -> None:
    judged("def main():\n" + RUNGS[name](10) + END, tmp_path)
    small, large = (judged("def main():\n" + RUNGS[name](n) + END, tmp_path) for n in (100, 200))
    assert large < 2.4 * small


def subroutines_on_one_coil(n: int) -> str:
    calls = "".join(f"    if x[1]:\n        call(s{i})\n" for i in range(n))
    subs = (
        f"@sub\ndef s{i}():\n    if c[{i + 1}]:\n        out(y[1])\n    if True:\n        return\n" for i in range(n)
    )
    return "def main():\n" + calls + END + "".join(subs)


def test_subroutines_on_one_coil_are_not_all_compared_with_each_other(tmp_path: Path) -> None:
    small, large = (judged(subroutines_on_one_coil(n), tmp_path) for n in (100, 200))
    assert large < 2.4 * small


def declared_blocks(n: int) -> str:
    blocks = "".join(f"nickname(ds.B{i}, ds[{2 * i + 1}:{2 * i + 3}])\n" for i in range(n))
    return blocks + "def main():\n    if x[1]:\n        copy(1, ds.B1[0])\n" + END


def test_blocks_are_not_all_compared_with_each_other(tmp_path: Path) -> None:
    small, large = (judged(declared_blocks(n), tmp_path) for n in (200, 400))
    assert large < 2.4 * small


def nested_blocks(n: int) -> str:
    begins = "".join(f'DS{i + 1},INT,"",0,Yes,"<B{i}>"\n' for i in range(n))
    ends = "".join(f'DS{4501 - n + i},INT,"",0,Yes,"</B{n - 1 - i}>"\n' for i in range(n))
    return "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment\n" + begins + ends


def test_blocks_inside_each_other_are_gone_through_once(tmp_path: Path) -> None:
    program = f"def main():\n    if x[1]:\n        copy(1, ds.B1[0])\n{END}"
    work = []
    for n in (10, 200, 400):
        (tmp_path / "nicknames.csv").write_text(nested_blocks(n), "utf-8")
        work.append(judged(program, tmp_path))
    assert work[2] < 2.4 * work[1]


def test_a_long_range_costs_little_more_than_a_short_one(tmp_path: Path) -> None:
    """Its addresses are made once, and a coil in it asks only for its own bit."""
    text = "def main():\n    if x[1]:\n        out(c[1])\n    if x[2]:\n        set(c[1:{}])\n" + END
    judged(text.format(10), tmp_path)
    small, large = (judged(text.format(n), tmp_path) for n in (500, 1000))
    assert large < 2.1 * small


def test_alternatives_inside_each_other_do_not_double(tmp_path: Path) -> None:
    work = judged(f"def main():\n    if {ALTERNATING}:\n        out(y[1])\n{END}", tmp_path)
    assert work < 1_000_000


def test_patterns_with_many_stars_are_quick() -> None:
    path = "/r/" + "a/" * 60 + "b"
    many = "/r/" + "**/a/" * 20 + "c"
    assert calls_in(lambda: matches(many, path, "/r")) < 50_000
    assert not matches(many, path, "/r")
    assert matches("/r/" + "**/a/" * 20 + "b", path, "/r")
    assert matches("**/**/b/**", path, "/r")


@pytest.mark.parametrize(
    "text",
    [
        "'\\" * 50_000,
        '"\\' * 50_000,
        '\\"""' * 50_000,
        "from" + " " * 100_000,
        "'" * 99_999,
        '"""' * 33_333,
        "<" * 100_000,
    ],
    ids=["quote", "double", "triple", "import", "quotes", "triples", "marks"],
)
def test_a_long_line_is_no_long_look(text: str) -> None:
    """Each of these took minutes: the end of a text was searched for again at every quote."""
    assert not is_program(text)


@pytest.mark.parametrize("digits", ["9" * 100_000, "-" + "9" * 100_000 + ".", "1." + "9" * 100_000])
def test_a_long_number_is_no_long_look(digits: str) -> None:
    """Some of these took a minute: the end of something that is not a number was tried at every digit."""
    span = Span("main.csv", 1, 1, 1, 2)
    assert condition_of(digits, span) is None
    assert condition_of(f"DS1=={digits}x", span) is None
    assert operand_of(f"{digits}x", span) is None
    assert initial_fault(Kind.FLOAT, f"{digits}x") is not None


def test_marks_and_styles_are_looked_for_in_what_can_hold_them() -> None:
    assert mark_in("<" * 100_000 + "Recipe>") is not None
    assert mark_in("<" * 100_000) is None
    assert styled_part(" __a" * 50_000) == ""
    assert comment_bytes(" __a" * 50_000) == 200_000


def test_scratch_cells_that_cannot_be_placed_are_not_drawn(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each of these rungs takes ten scratch bits; after two hundred the bank is full, and the rest is not drawn."""
    divided: list[object] = []
    real = split._RungSplit.run

    def run(rung: split._RungSplit) -> None:
        divided.append(rung)
        real(rung)

    monkeypatch.setattr(split._RungSplit, "run", run)
    rungs = "    if nc(c[1:301]):\n        set(y[1])\n" * 220
    assert judged_and_told("def main():\n" + rungs + END, tmp_path)[1] == ["CG208"]
    assert len(divided) == 201


def test_names_that_have_no_room_apart_are_not_compared(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """At one address two names would look like one. 400 bits are free, too few for 201 names of each side."""
    monkeypatch.chdir(tmp_path)
    Path("clickgen.toml").write_text('reserved = ["C401..C2000"]\n', "utf-8")
    names = [f"A{i}" for i in range(201)]
    others = [f"B{i}" for i in range(201)]
    for folder, own in (("a", names), ("b", others), ("moved", [*names[1:], names[0]])):
        Path(folder).mkdir()
        rungs = "".join(f"    if x[1]:\n        set(c.{name})\n" for name in own)
        Path(folder, "p.py").write_text("def main():\n" + rungs + END, "utf-8")
    assert main(["diff", "a/p.py", "b/p.py"]) == 2
    assert "b/p.py cannot be compared by its names" in capsys.readouterr().err.replace("\\", "/")
    assert main(["diff", "a/p.py", "moved/p.py"]) == 1
    assert "rung 1 moved to rung 201" in capsys.readouterr().out


def unknown_calls(n: int) -> str:
    calls = "".join(f"    if x[1]:\n        call(other{i})\n" for i in range(n))
    return (
        "def main():\n" + calls + END + "".join(f"@sub\ndef s{i}():\n    if True:\n        return\n" for i in range(n))
    )


def test_unknown_names_are_not_all_compared_with_all_names(tmp_path: Path) -> None:
    """The first hundred get a suggestion if there is one."""
    small, large = (judged(unknown_calls(n), tmp_path) for n in (200, 400))
    assert large < 2.4 * small


def python_logic(n: int) -> str:
    lines = (f"    if x[1] and not c[{i + 1}] or x[2]:\n        copy({i}, ds[{i + 1}])\n" for i in range(n))
    return "def main():\n" + "".join(lines) + END


def test_lines_with_and_or_not_are_rewritten_one_by_one(tmp_path: Path) -> None:
    small, large = (judged(python_logic(n), tmp_path) for n in (40, 80))
    assert large < 2.4 * small
