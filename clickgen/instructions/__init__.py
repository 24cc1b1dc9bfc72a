"""The instructions of the language, one file per family, each declared once as a Spec."""

from __future__ import annotations

from clickgen.instructions import coils, communication, control, copies, counters, data, drums, maths, raw, timers
from clickgen.instructions.spec import Spec

FAMILIES = (coils, timers, counters, copies, data, maths, drums, communication, control, raw)

INSTRUCTIONS: dict[str, Spec] = {spec.name: spec for family in FAMILIES for spec in family.SPECS}
"""Every instruction that a program calls by name."""
