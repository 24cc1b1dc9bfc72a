"""In a simulator, programs do, scan by scan, what the references say of a CLICK."""

from __future__ import annotations

import re
from collections import Counter
from math import isclose
from pathlib import Path

import pytest
from judges.simulator import SPELLINGS, Simulator, Spelling, Value
from scenarios.control import CONTROL
from scenarios.copies import COPIES
from scenarios.counters import COUNTERS
from scenarios.drums import DRUMS
from scenarios.maths import MATHS
from scenarios.rungs import RUNGS
from scenarios.scenario import Scenario, Step, scenario
from scenarios.search_shift import SEARCH_AND_SHIFT
from scenarios.splits import SPLITS
from scenarios.texts import TEXTS
from scenarios.timers import TIMERS

import clickgen

SCENARIOS = (*TIMERS, *COUNTERS, *COPIES, *TEXTS, *MATHS, *SEARCH_AND_SHIFT, *RUNGS, *SPLITS, *CONTROL, *DRUMS)
RUN = [one for one in SCENARIOS if one.ends_return or not one.pyrung_cannot]
NOT_RUN = [one for one in SCENARIOS if one.pyrung_cannot]


def bundle(one: Scenario, folder: Path) -> Path:
    """The bundle that clickgen makes from the program."""
    program = folder / "prog.py"
    program.write_text(one.program, "utf-8")
    result = clickgen.build(program)
    assert result.ok, f"{one.name}: {[f'{problem.code} {problem.message}' for problem in result.diagnostics]}"
    result.write(folder / "bundle")
    return folder / "bundle"


def same(expected: Value, got: Value) -> bool:
    if isinstance(expected, float):
        return not isinstance(got, str) and isclose(expected, got, rel_tol=1e-6, abs_tol=1e-9)
    return expected == got


def run(machine: Simulator, step: Step) -> None:
    if step.powers_up:
        machine.power_up()
    machine.set(step.given)
    machine.run(step.scans)


def differences(step: Step, machine: Simulator) -> list[str]:
    """Where the memory differs from the step, or pyrung does not do what the step says of it."""
    found = []
    opinions = {one.address: one for one in step.disagreements}
    for address, click in step.expected.items():
        got, opinion = machine.read(address), opinions.get(address)
        expected = opinion.pyrung if opinion else click
        if not same(expected, got):
            note = f" by pyrung (CLICK: {click!r}; pyrung: {opinion.reason})" if opinion else ""
            found.append(f"{address}: expected {expected!r}{note}, got {got!r}")
    return found


@pytest.mark.parametrize("one", RUN, ids=lambda one: one.name)
def test_a_program_does_what_the_references_say(one: Scenario, tmp_path: Path) -> None:
    machine = Simulator(bundle(one, tmp_path), one.ms, ends_return=one.ends_return)
    scan = 0
    for number, step in enumerate(one.steps, 1):
        run(machine, step)
        scan += step.scans
        found = differences(step, machine)
        assert not found, f"{one.name}: step {number}, after scan {scan}:\n  " + "\n  ".join(found)


@pytest.mark.parametrize("one", NOT_RUN, ids=lambda one: one.name)
def test_pyrung_still_cannot_read_it(one: Scenario, tmp_path: Path) -> None:
    folder = bundle(one, tmp_path)
    with pytest.raises((ValueError, TypeError), match=re.escape(one.pyrung_cannot)):
        Simulator(folder, one.ms)


@pytest.mark.parametrize("spelling", SPELLINGS, ids=lambda one: one.action.partition("(")[0])
def test_pyrung_still_needs_another_spelling(spelling: Spelling, tmp_path: Path) -> None:
    folder = bundle(scenario(spelling.action, f"if c[1]:\n    {spelling.action}"), tmp_path)
    with pytest.raises((ValueError, NameError, TypeError)):
        Simulator(folder, ms=10, spellings=[one for one in SPELLINGS if one is not spelling])


def test_every_scenario_has_a_name_of_its_own() -> None:
    twice = [name for name, count in Counter(one.name for one in SCENARIOS).items() if count > 1]
    assert not twice
