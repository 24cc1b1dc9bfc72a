"""The rules that are on by default say what they should of whole programs, and nothing else.

The programs of ``fixtures/lint`` are good practice except for the defects that ``# <- CG502`` marks. The cases of
``fixtures/cases`` show features, so they have findings; each of them was reviewed and is right.
"""

from __future__ import annotations

import random
import re
import shutil
import tempfile
from collections import Counter, defaultdict
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import golden
import pytest
from hypothesis import given
from hypothesis import strategies as st
from test_examples import program_of
from test_spec_example import SPECIFICATION

from clickgen.api import check
from clickgen.problems.codes import CODES

FIXTURES = Path(__file__).parents[2] / "fixtures" / "lint"
PROGRAMS = sorted(FIXTURES.glob("*.py"))
_MARK = re.compile(r"# <- (CG\d{3})")

GOLDEN: dict[str, dict[str, tuple[int, ...]]] = {
    "allocation": {"CG502": (10, 11, 12), "CG503": (9,), "CG521": (16,)},
    "banks": {"CG521": (16, 16, 16, 16)},
    "calc": {"CG521": (15, 15)},
    "call": {"CG545": (20, 29)},
    "chains": {"CG513": (18,)},
    "comments": {"CG515": (52,)},
    "comparisons": {"CG521": (11, 11)},
    "contacts": {"CG521": (14, 32), "CG526": (32, 32)},
    "copy_modifiers": {"CG521": (14,)},
    "current_values": {"CG521": (20,)},
    "demo": {"CG514": (200, 216)},
    "event_drum": {"CG521": (40,)},
    "ladder_tokens": {"CG502": (234, 237, 240), "CG503": (383, 386, 389), "CG513": (97,), "CG528": (228,)},
    "loop_body": {"CG502": (28,), "CG528": (26,)},
    "loop_open": {"CG528": (7,)},
    "nested_ifs": {"CG556": (46,)},
    "nickname_options": {"CG550": (4, 8, 9, 10, 11)},
    "pin_conditions": {"CG513": (9, 12)},
    "quoted_names": {"CG510": (16,)},
    "receive": {"CG546": (15, 16, 17, 18, 21, 22, 27)},
    "return_and_end": {"CG545": (27,)},
    "scratch_on_scratch": {"CG502": (15,), "CG513": (17,), "CG526": (17,), "CG542": (17,)},
    "search": {"CG521": (12,), "CG524": (7, 9)},
    "several_files": {"CG545": (10,)},
    "several_outputs": {"CG502": (10,), "CG503": (12,), "CG510": (15,)},
    "split_changed_condition": {
        "CG502": (11,),
        "CG503": (37,),
        "CG513": (7, 18, 23, 28, 33, 38, 42, 43),
        "CG542": (12, 38, 43),
    },
    "split_edge_and_return": {"CG513": (30, 43)},
    "split_hidden_writes": {"CG513": (8, 13)},
    "split_immediate": {"CG513": (7, 10, 15)},
    "split_pinned_box": {"CG513": (13, 18)},
    "subroutine_names": {"CG542": (17,), "CG545": (4, 11, 27)},
    "table_given": {"CG550": (3, 10, 12)},
    "time_drum": {"CG512": (36,)},
    "ton": {"CG512": (7,), "CG521": (13,)},
    "wide_and_tall": {"CG513": (45,)},
}
"""The findings of the golden cases, as lines by case and code: latches with one half, timers looked at without their
instruction, counters on levels, and everything else that an example of one thing leaves out."""


def findings(program: Path, only_default: bool = True) -> Counter[tuple[str, int]]:
    """The findings of the rules about logic, as code and line of the program's own file; any error fails."""
    result = check(program)
    assert not [problem for problem in result.diagnostics if problem.is_error]
    return Counter(
        (problem.code, problem.span.line)
        for problem in result.diagnostics
        if problem.span and problem.code.startswith("CG5") and (CODES[problem.code].is_on or not only_default)
    )


def marks(text: str) -> Counter[tuple[str, int]]:
    return Counter((code, n) for n, line in enumerate(text.split("\n"), 1) for code in _MARK.findall(line))


# -- whole programs ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.stem)
def test_exactly_the_marked_defects_are_found(path: Path, tmp_path: Path) -> None:
    program = tmp_path / path.name
    shutil.copyfile(path, program)
    assert findings(program) == marks(path.read_text("utf-8"))


def test_the_programs_are_many_rungs_and_show_every_kind_of_defect() -> None:
    texts = [path.read_text("utf-8") for path in PROGRAMS]
    assert len(texts) >= 5
    assert sum(len(re.findall(r"^ +if .*:", text, re.MULTILINE)) for text in texts) >= 150
    shown = {code for text in texts for code, _ in marks(text)}
    assert shown >= {"CG501", "CG502", "CG503", "CG506", "CG510", "CG513", "CG515", "CG516", "CG521", "CG522"}


@pytest.mark.parametrize("name", golden.names())
def test_a_golden_case_has_the_findings_that_are_right(name: str, tmp_path: Path) -> None:
    found: dict[str, list[int]] = defaultdict(list)
    for (code, line), times in sorted(findings(golden.lay_out(golden.CASES / name, tmp_path)).items()):
        found[code] += [line] * times
    assert {code: tuple(lines) for code, lines in found.items()} == GOLDEN.get(name, {})


@pytest.mark.skipif(not SPECIFICATION.is_file(), reason="the specification is not beside the project")
def test_the_specification_s_example(tmp_path: Path) -> None:
    blocks = re.findall(r"^```python\n(.*?)^```", SPECIFICATION.read_text("utf-8"), re.DOTALL | re.MULTILINE)
    program = tmp_path / "prog.py"
    program.write_text(blocks[-1], "utf-8")
    # A counter that counts down on a level, an edge that only one mode looks at, and a cycle that nothing ends.
    assert findings(program) == Counter(
        {("CG513", 32): 1, ("CG514", 94): 1, ("CG502", 95): 1, ("CG528", 63): 1, ("CG545", 98): 1}
    )


# -- several files ----------------------------------------------------------------------------------------------------

WIRING = "nickname(x.Start, x[1])\nnickname(x.Elsewhere, x[2])\n"
PARTS = """
nickname(x.Level, x[3])
nickname(x.Old, x[4])


@sub
def fill():
    if all(x.Start, x.Level):
        out(y[1])
    if True:
        return


@sub
def empty():
    if True:
        out(y[2])
        return
"""
MAIN = """
import wiring
from parts import IMPORTED


def main():
    if True:
        call(fill)
        end()
"""


@pytest.mark.parametrize(
    ("imported", "found"),
    [
        # Nobody knows what the other subroutine needs, so no name of its file is accused.
        ("fill", []),
        ("fill, empty", [("CG506", "parts.py", 3), ("CG515", "parts.py", 15)]),
    ],
)
def test_shared_files_are_judged_only_as_a_whole(
    imported: str, found: list[tuple[str, str, int]], tmp_path: Path
) -> None:
    (tmp_path / "wiring.py").write_text(WIRING)
    (tmp_path / "parts.py").write_text(PARTS)
    program = tmp_path / "prog.py"
    program.write_text(MAIN.replace("IMPORTED", imported))
    result = check(program)
    problems = [problem for problem in result.diagnostics if problem.code in ("CG506", "CG515") and problem.span]
    assert [(p.code, Path(p.span.path).name, p.span.line) for p in problems if p.span] == found
    assert all("import" in p.help for p in problems if p.code == "CG515")


# -- rule by rule -----------------------------------------------------------------------------------------------------


def _snippets() -> list[tuple[str, str, str]]:
    """Code, title and text of each: code that looks like a defect but is none, and code that does not hide one."""
    text = (FIXTURES / "snippets.txt").read_text("utf-8")
    split = [snippet.strip().partition("\n") for snippet in text.split("---\n")]
    return [(head[:5], head[6:], text) for head, _, text in split]


@pytest.mark.parametrize(("code", "title", "text"), _snippets())
def test_a_rule_speaks_where_it_is_marked(code: str, title: str, text: str, tmp_path: Path) -> None:
    program = tmp_path / "prog.py"
    program.write_text(program_of(text), "utf-8")
    wanted = marks(program_of(text))
    codes = {code, *(marked for marked, _ in wanted)}
    found = Counter({place: n for place, n in findings(program, only_default=False).items() if place[0] in codes})
    assert found == wanted, title


# -- what CG510 calls lost makes no difference -------------------------------------------------------------------------

Memory = dict[str, int]


@dataclass(frozen=True)
class Step:
    """An action as text, and what it does to a memory of C1..C3 and DS1..DS5."""

    text: str
    run: Callable[[Memory], None]


def _copy(source: str, target: int, once: bool) -> Step:
    def run(memory: Memory) -> None:
        if not once or memory["once"]:
            memory[f"ds{target}"] = memory[source] if source in memory else int(source)

    written = f"ds[{source[2:]}]" if source.startswith("ds") else source
    return Step(f"copy({written}, ds[{target}]{', oneshot=True' if once else ''})", run)


def _sum(one: int, other: int, target: int) -> Step:
    def run(memory: Memory) -> None:
        memory[f"ds{target}"] = (memory[f"ds{one}"] + memory[f"ds{other}"]) % 7

    return Step(f'calc("ds[{one}] + ds[{other}]", ds[{target}])', run)


def _fill(value: int, first: int, count: int) -> Step:
    last = min(first + count, 5)

    def run(memory: Memory) -> None:
        memory.update({f"ds{number}": value for number in range(first, last + 1)})

    return Step(f"copy_fill({value}, ds[{first}:{last + 1}])", run)


def _pointer(register: int, other: int, is_source: bool) -> Step:
    def run(memory: Memory) -> None:
        place = f"ds{memory[f'ds{register}']}"
        if place in memory:
            ends = (place, f"ds{other}") if is_source else (f"ds{other}", place)
            memory[ends[1]] = memory[ends[0]]

    pointer, cell = f"ds[ds[{register}]]", f"ds[{other}]"
    return Step(f"copy({pointer}, {cell})" if is_source else f"copy({cell}, {pointer})", run)


def _coil(word: str, bit: int) -> Step:
    return Step(f"{word}(c[{bit}])", lambda memory: memory.update({f"c{bit}": int(word == "set")}))


_numbers = st.integers(1, 5)
_steps = st.one_of(
    st.builds(_copy, st.sampled_from(["1", "2", "ds1", "ds2"]), _numbers, st.sampled_from([False, False, True])),
    st.builds(_copy, st.sampled_from(["3", "4"]), st.integers(1, 2), st.just(False)),
    st.builds(_sum, _numbers, _numbers, _numbers),
    st.builds(_fill, st.integers(0, 5), _numbers, st.integers(0, 4)),
    st.builds(_pointer, _numbers, _numbers, st.booleans()),
    st.builds(_coil, st.sampled_from(["set", "reset"]), st.integers(1, 3)),
)
_rungs = st.tuples(
    st.sampled_from(["True", "c[1]", "c[2]", "nc(c[1])", "all(c[1], c[2])", "ds[1] > 2", "ds[2] > 1", "ds[2] == 3"]),
    st.lists(_steps, min_size=1, max_size=4),
)
_TESTS: dict[str, Callable[[Memory], bool]] = {
    "True": lambda _: True,
    "c[1]": lambda memory: memory["c1"] == 1,
    "c[2]": lambda memory: memory["c2"] == 1,
    "nc(c[1])": lambda memory: memory["c1"] == 0,
    "all(c[1], c[2])": lambda memory: memory["c1"] == memory["c2"] == 1,
    "ds[1] > 2": lambda memory: memory["ds1"] > 2,
    "ds[2] > 1": lambda memory: memory["ds2"] > 1,
    "ds[2] == 3": lambda memory: memory["ds2"] == 3,
}


def _scan(rungs: list[tuple[str, list[Step]]], seed: int, without: int) -> Memory:
    """One scan from random values; ``without`` is the line of an action that is left out."""
    draw = random.Random(seed)
    memory = {f"ds{n}": draw.randrange(6) for n in range(1, 6)} | {f"c{n}": draw.randrange(2) for n in range(1, 4)}
    memory["once"] = draw.randrange(2)
    line = 1
    for condition, steps in rungs:
        line += 1
        is_on = _TESTS[condition](memory)
        for step in steps:
            line += 1
            if is_on and line != without:
                step.run(memory)
    return memory


@given(rungs=st.lists(_rungs, min_size=1, max_size=7))
def test_a_lost_value_makes_no_difference(rungs: list[tuple[str, list[Step]]]) -> None:
    lines = [line for test, steps in rungs for line in (f"if {test}:", *(f"    {step.text}" for step in steps))]
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "prog.py"
        program.write_text(program_of("\n".join(lines)), "utf-8")
        lost = [line for code, line in findings(program) if code == "CG510"]
    for line in lost:
        for seed in range(60):
            assert _scan(rungs, seed, line) == _scan(rungs, seed, 0), lines[line - 2]
