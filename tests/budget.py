"""The number of examples that a property runs: few, and always the same, in ``make test``; many new ones in ``make
fuzz``.

``@examples(30)`` above ``@given`` sets the number for ``make test``. A property without it runs `PLAIN` examples. A
round of ``make fuzz`` runs every property on twenty times as many.

No property has a deadline, and none fails because its examples are slow to make: both would measure how busy the
machine is.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

from hypothesis import HealthCheck, settings

T = TypeVar("T")

PLAIN = 60
"""The examples of a property that sets no number: these are quick."""

_times = 1


def choose(times: int) -> None:
    """Run every property on ``times`` as many examples; once means the same examples in every run."""
    global _times
    _times = times
    settings.register_profile(
        "clickgen",
        max_examples=PLAIN * times,
        derandomize=times == 1,
        database=None,
        deadline=None,
        print_blob=True,
        report_multiple_bugs=False,
        suppress_health_check=[
            HealthCheck.too_slow,
            HealthCheck.data_too_large,
            HealthCheck.function_scoped_fixture,
        ],
    )
    settings.load_profile("clickgen")


def some(items: Sequence[T], step: int) -> Sequence[T]:
    """Each ``step``-th of the items in ``make test``, and all of them in ``make fuzz``.

    For tests that try every place, marked with ``pytest.mark.property``.
    """
    return items[:: step if _times == 1 else 1]


def rounds(count: int) -> range:
    """This many rounds of a test with random numbers of its own, marked with ``pytest.mark.property``."""
    return range(count * _times)


def examples(count: int) -> settings:
    """Run a property on this many examples in ``make test``."""
    return settings(max_examples=count * _times)
