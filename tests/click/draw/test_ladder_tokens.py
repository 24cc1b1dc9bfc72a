"""Every token that CLICK is known to take is built from a source: the case ``ladder_tokens`` has a rung for each."""

from __future__ import annotations

import csv

import golden
import pytest

TOKENS = golden.CASES.parents[2] / "shared" / "data" / "ladder-tokens.csv"
"""One example of every token, verified in CLICK itself: (name:marker, contacts of the row, output). It is beside the
project where its data is kept; the golden files have its contents."""

Rows = list[tuple[str, str]]


def _known() -> dict[str, Rows]:
    rungs: dict[str, Rows] = {}
    with TOKENS.open(encoding="utf-8", newline="") as file:
        for name, contacts, output in list(csv.reader(file))[1:]:
            rungs.setdefault(name.partition(":")[0], []).append((contacts, output))
    return rungs


def _built() -> dict[str, Rows]:
    """The rows of each rung by its comment, without wires; a rung without a comment belongs to the one before it."""
    rungs: dict[str, Rows] = {}
    for path in sorted((golden.CASES / "ladder_tokens" / golden.EXPECTED).glob("**/*.csv")):
        if path.name == golden.TABLE:
            continue
        name = ""
        with path.open(encoding="utf-8", newline="") as file:
            for marker, *cells in list(csv.reader(file))[1:]:
                if marker == "#":
                    name = cells[0]
                    rungs[name] = []
                else:
                    contacts = " ".join(cell for cell in cells[:-1] if cell not in ("", "-"))
                    rungs[name].append((contacts, cells[-1]))
    return rungs


@pytest.mark.skipif(not TOKENS.exists(), reason="the list of known tokens is not beside the project")
def test_every_known_token_is_built() -> None:
    built = _built()
    for name, rows in _known().items():
        assert built[name][: len(rows)] == rows, name
