"""The rules, one file each. A rule is a function ``check(facts, problems)`` in a module of its own."""

from __future__ import annotations

from collections.abc import Callable

from clickgen.facts.facts import Facts
from clickgen.problems.diagnostics import Diagnostics
from clickgen.rules.errors import (
    calls,
    chosen_points,
    comments,
    comparisons,
    contacts,
    copies,
    drums,
    endings,
    formulas,
    left_out,
    loops,
    modbus,
    operands,
    overruns,
    owners,
    pins,
    retentive_off_delay,
    routines,
    searches,
)

Rule = Callable[[Facts, Diagnostics], None]

RULES: tuple[Rule, ...] = (
    routines.check,
    endings.check,
    calls.check,
    loops.check,
    owners.check,
    comments.check,
    contacts.check,
    comparisons.check,
    operands.check,
    copies.check,
    overruns.check,
    chosen_points.check,
    searches.check,
    drums.check,
    modbus.check,
    formulas.check,
    pins.check,
    retentive_off_delay.check,
    left_out.check,
)
"""In the order in which a person reads a program: its routines, their structure, their operands."""
