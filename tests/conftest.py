"""Settings for every test: how many examples a property runs, and the mark by which ``make fuzz`` finds it."""

from __future__ import annotations

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
