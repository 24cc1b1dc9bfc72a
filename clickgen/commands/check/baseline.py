"""Findings that existed when a repository began to check: they are not shown again until they change."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import NamedTuple

from clickgen.problems.diagnostics import Diagnostic
from clickgen.problems.finding_keys import Key, keys_of
from clickgen.text.wording import json_text
from clickgen.workspace import CouldNotRun, Workspace

_FORMAT = 1


def read_baseline(path: Path, files: Workspace) -> Counter[Key] | None:
    """Return how often each finding was there; None if there is no such file. Raises CouldNotRun."""
    try:
        tree = json.loads(files.read(path).decode("utf-8"))
        if tree["format"] != _FORMAT:
            raise CouldNotRun(f"{path} is a baseline of another clickgen; delete it and make it anew")
        return Counter({(row["file"], row["code"], row["line"]): int(row["count"]) for row in tree["findings"]})
    except FileNotFoundError:
        return None
    except OSError as error:
        raise CouldNotRun(f"{path} cannot be read: {error.strerror or error}") from None
    except (ValueError, KeyError, TypeError, OverflowError, RecursionError):
        raise CouldNotRun(f"{path} is no baseline that clickgen made; delete it and make it anew") from None


def baseline_text(keys: Iterable[Key]) -> str:
    """The baseline as a file, one finding on a line so that it diffs well."""
    rows = [
        json_text({"file": file, "code": code, "line": line, "count": count})
        for (file, code, line), count in sorted(Counter(keys).items())
    ]
    body = ",\n    ".join(rows)
    inner = f"\n    {body}\n  " if rows else ""
    return f'{{\n  "format": {_FORMAT},\n  "findings": [{inner}]\n}}\n'


class Baseline(NamedTuple):
    """The findings from when a repository began: how often each key, with ``name`` as ``keys_of`` takes it."""

    known: Counter[Key]
    name: Callable[[str], str]

    def news(self, findings: list[Diagnostic], line_of: Callable[[str, int], str]) -> list[Diagnostic]:
        """Return the findings that the baseline does not know; errors always."""
        left = Counter(self.known)
        new = []
        for finding, key in zip(findings, keys_of(findings, self.name, line_of), strict=True):
            if not finding.is_error and left[key] > 0:
                left[key] -= 1
            else:
                new.append(finding)
        return new
