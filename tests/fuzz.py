"""The properties of the pytest files as a long run: ``python tests/fuzz.py --minutes 10``.

Prints each failure once, in its smallest form, and goes on. Exit code 1 when there was one.
"""

from __future__ import annotations

import argparse
import random
import sys
import time
import traceback
import warnings
from collections import Counter
from collections.abc import Callable
from typing import Any

from hypothesis import HealthCheck, Phase, given, seed, settings
from hypothesis import strategies as st
from hypothesis.errors import HypothesisWarning
from strategies.given import TABLE, Given
from test_import_properties import IMPORT
from test_meaning_properties import MEANING
from test_mending_properties import MENDING
from test_power_properties import POWER
from test_robustness import ROBUSTNESS

Check = Callable[[Any], None]
Property = tuple[st.SearchStrategy[Any], Check]
PROPERTIES: dict[str, Property] = {**POWER, **MEANING, **MENDING, **IMPORT, **ROBUSTNESS}


def one_round(strategy: st.SearchStrategy[Any], check: Check, number: int, examples: int) -> tuple[str, int]:
    """Run a property on random examples: the report of its smallest failure or an empty text, and how many ran."""
    failed: list[tuple[Any, str]] = []
    count = 0

    @seed(number)
    @settings(
        max_examples=examples,
        database=None,
        deadline=None,
        report_multiple_bugs=False,
        suppress_health_check=list(HealthCheck),
        phases=(Phase.generate, Phase.shrink),
    )
    @given(strategy)
    def run(example: Any) -> None:
        nonlocal count
        count += 1
        try:
            check(example)
        except Exception:
            failed.append((example, traceback.format_exc(limit=-6)))
            raise

    try:
        run()
    except BaseException as error:
        if isinstance(error, KeyboardInterrupt) or not failed:
            raise
        example, trace = failed[-1]  # hypothesis ends with the smallest
        if isinstance(example, Given):
            example = without_lines(example, check, fault_of(trace))
        return f"{getattr(example, 'text', repr(example))}\n{trace}", count
    return "", count


def fault_of(trace: str) -> str:
    """What a failure is known by: the first words of its last line."""
    return trace.strip().splitlines()[-1][:60]


def without_lines(files: Given, check: Check, fault: str) -> Given:
    """The same files without the lines that the fault does not need."""

    def fails(some: Given) -> bool:
        try:
            check(some)
        except Exception:
            return fault_of(traceback.format_exc(limit=-6)) == fault
        return False

    for name, _ in files.files:
        at = 0
        while name != TABLE:
            lines = dict(files.files)[name].splitlines(keepends=True)
            if at >= len(lines):
                break
            rest = b"".join(lines[:at] + lines[at + 1 :])
            fewer = Given(tuple((other, rest if other == name else data) for other, data in files.files))
            if fails(fewer):
                files = fewer
            else:
                at += 1
    return files


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--minutes", type=float, default=10)
    parser.add_argument("--examples", type=int, default=300, help="examples in one round of a property")
    parser.add_argument("--seed", type=int, help="of the first round, to repeat a run")
    parser.add_argument("--only", choices=sorted(PROPERTIES), action="append", help="one property; may be repeated")
    options = parser.parse_args()
    warnings.simplefilter("ignore", HypothesisWarning)
    stop = time.monotonic() + 60 * options.minutes
    number = options.seed if options.seed is not None else random.randrange(2**32)
    print(f"seed {number}", flush=True)
    reports: Counter[str] = Counter()
    ran: Counter[str] = Counter()
    while time.monotonic() < stop:
        for name in options.only or PROPERTIES:
            report, count = one_round(*PROPERTIES[name], number, options.examples)
            ran[name] += count
            number += 1
            if not report:
                continue
            last = f"{name}: {report.strip().splitlines()[-1][:100]}"
            reports[last] += 1
            if reports[last] <= 2:
                print(f"\n{'=' * 100}\n{name}, seed {number - 1}\n{report}", flush=True)
    print("\nexamples: " + ", ".join(f"{name} {count}" for name, count in ran.items()))
    print(f"{sum(reports.values())} rounds failed")
    for last, count in reports.items():
        print(f"  {count} x {last}")
    return 1 if reports else 0


if __name__ == "__main__":
    sys.exit(main())
