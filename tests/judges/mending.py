"""Checks that fixes keep a person's meaning: the fixed program does, scan by scan, what Python reads in its text."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from strategies.mending import TABLE, Mending

import clickgen
from clickgen.api import check
from clickgen.problems.diagnostics import Diagnostic
from clickgen.text.edits import Fix, apply_fixes

from .builds import workshop
from .meaning import check_same

_ROUNDS_MAX = 20


def mended(mending: Mending, is_wanted: Callable[[Diagnostic], bool]) -> tuple[dict[str, str], dict[str, int]]:
    """Return the files after all wanted fixes, round by round, and how many of each code were applied."""
    texts, codes = dict(mending.texts), dict[str, int]()
    for _ in range(_ROUNDS_MAX):
        fixes: dict[str, list[Fix]] = {}
        found = check(_written(texts)).diagnostics
        for finding in found:
            if finding.fix and is_wanted(finding):
                fixes.setdefault(Path(finding.fix.edits[0].span.path).name, []).append(finding.fix)
                codes[finding.code] = codes.get(finding.code, 0) + 1
        if not fixes:
            return texts, codes
        for name, some in fixes.items():
            texts[name], count = apply_fixes(texts[name], some)
            assert count, "fixes that go nowhere"
    raise AssertionError(f"still something to mend after {_ROUNDS_MAX} rounds")


def _is_safe(finding: Diagnostic) -> bool:
    return finding.fix is not None and finding.fix.is_safe


def check_mended(mending: Mending, is_wanted: Callable[[Diagnostic], bool] = _is_safe) -> bool:
    """Check that the fixed program builds and does what was meant; False if something is left that no fix removes."""
    texts, _ = mended(mending, is_wanted)
    result = clickgen.build(_written(texts))
    if not result.ok:
        return False
    files = {name: file for name, file in result.files.items() if name.startswith(("main", "subroutines/"))}
    check_same(mending.meant, files)
    return True


def _written(texts: dict[str, str]) -> Path:
    for path in workshop().iterdir():
        path.unlink()
    (workshop() / "nicknames.csv").write_text(TABLE, "utf-8")
    for name, text in texts.items():
        (workshop() / name).write_text(text, "utf-8")
    return workshop() / next(iter(texts))
