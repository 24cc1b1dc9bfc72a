"""What holds for every test: how many examples a property runs, and the mark by which ``make fuzz`` finds it.

And for the tests of rules: what they judge is judged in any order of the rules.
"""

from __future__ import annotations

from collections.abc import Iterator

import budget
import pytest


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add ``--times``, with which ``tests/fuzz.py`` runs the properties."""
    parser.addoption("--times", type=int, default=1, help="run a property on so many times its examples, new each time")


def pytest_configure(config: pytest.Config) -> None:
    """Set the budget before a module with properties is imported."""
    config.addinivalue_line("markers", "property: holds for examples that hypothesis makes (added by conftest.py)")
    budget.choose(config.getoption("--times"))


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark the properties."""
    for item in items:
        if getattr(getattr(item, "obj", None), "is_hypothesis_test", False):
            item.add_marker(pytest.mark.property)


@pytest.fixture(autouse=True, scope="module")
def rules_in_any_order(request: pytest.FixtureRequest) -> Iterator[None]:
    """Judge every program of the tests of rules once more, with the rules in another order."""
    with pytest.MonkeyPatch.context() as patch:
        if request.path.parent.name == "rules":
            from any_order import judged_in_any_order

            patch.setattr("clickgen.pipeline.judge", judged_in_any_order)
        yield
