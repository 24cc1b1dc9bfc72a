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
from collections.abc import Callable
from typing import Any

from hypothesis import HealthCheck, Phase, given, seed, settings
from hypothesis import strategies as st
from hypothesis.errors import HypothesisWarning
from test_meaning_properties import MEANING
from test_power_properties import POWER
from test_robustness import ROBUSTNESS

Property = tuple[st.SearchStrategy[Any], Callable[[Any], None]]
PROPERTIES: dict[str, Property] = {**POWER, **MEANING, **ROBUSTNESS}


def one_round(strategy: st.SearchStrategy[Any], check: Callable[[Any], None], number: int, examples: int) -> str:
    """Run a property on random examples; the report of its smallest failure, or an empty text."""
    failed: list[tuple[Any, str]] = []

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
        return f"{getattr(example, 'text', repr(example))}\n{trace}"
    return ""


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
    reports: dict[str, int] = {}
    rounds = 0
    while time.monotonic() < stop:
        for name in options.only or PROPERTIES:
            report = one_round(*PROPERTIES[name], number, options.examples)
            rounds += 1
            number += 1
            if not report:
                continue
            last = f"{name}: {report.strip().splitlines()[-1][:100]}"
            reports[last] = reports.get(last, 0) + 1
            if reports[last] <= 2:
                print(f"\n{'=' * 100}\n{name}, seed {number - 1}\n{report}", flush=True)
    print(f"\n{rounds} rounds of {options.examples} examples; {sum(reports.values())} failed")
    for last, count in reports.items():
        print(f"  {count} x {last}")
    return 1 if reports else 0


if __name__ == "__main__":
    sys.exit(main())
