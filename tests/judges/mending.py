"""Checks that fixes keep a person's meaning: the fixed program does, scan by scan, what Python reads in its text."""

from __future__ import annotations

import ast
import io
import tokenize
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from strategies.mending import TABLE, Mending

import clickgen
from clickgen.api import check
from clickgen.problems.diagnostics import Diagnostic
from clickgen.text.edits import Fix, apply_fixes

from .builds import workshop
from .meaning import check_same

_ROUNDS_MAX = 20


def mended(before: Mapping[str, str], is_wanted: Callable[[Diagnostic], bool]) -> tuple[dict[str, str], dict[str, int]]:
    """Return the files after all wanted fixes, round by round, and how many of each code were applied."""
    texts, codes = dict(before), dict[str, int]()
    for _ in range(_ROUNDS_MAX):
        fixes: dict[str, list[Fix]] = {}
        for finding in findings(texts):
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
    texts, _ = mended(mending.texts, is_wanted)
    result = clickgen.build(_written(texts))
    if not result.ok:
        return False
    files = {name: file for name, file in result.files.items() if name.startswith(("main", "subroutines/"))}
    check_same(mending.meant, files)
    return True


def findings(texts: Mapping[str, str]) -> Sequence[Diagnostic]:
    """The problems of a program in these files, that of main first."""
    return check(_written(texts)).diagnostics


def check_fix_stays_in_its_statement(text: str, finding: Diagnostic) -> None:
    """Check that the fix of a finding in this text changes no byte outside of its rung, and no comment."""
    assert finding.fix is not None
    assert finding.span is not None
    after, count = apply_fixes(text, [finding.fix])
    assert count == 1
    lines = text.splitlines(keepends=True)
    first, last = _rung_at(text, finding.span.line)
    assert after.startswith("".join(lines[: first - 1])), "bytes before the statement"
    assert after.endswith("".join(lines[last:])), "bytes after the statement"
    assert _comments(after) == _comments(text)


def _rung_at(text: str, line: int) -> tuple[int, int]:
    """The lines of the rung at a line; the place after the last rung of a routine whose head is there."""
    for routine in ast.parse(text).body:
        if isinstance(routine, ast.FunctionDef):
            if line == routine.lineno:
                end = routine.end_lineno or line
                return end + 1, end
            for rung in routine.body:
                if rung.lineno <= line <= (rung.end_lineno or line):
                    return rung.lineno, rung.end_lineno or line
    raise AssertionError(f"no rung at line {line}")


def _comments(text: str) -> list[str]:
    tokens = tokenize.generate_tokens(io.StringIO(text).readline)
    return [token.string for token in tokens if token.type == tokenize.COMMENT]


def _written(texts: Mapping[str, str]) -> Path:
    for path in workshop().iterdir():
        path.unlink()
    (workshop() / "nicknames.csv").write_text(TABLE, "utf-8")
    for name, text in texts.items():
        (workshop() / name).write_text(text, "utf-8")
    return workshop() / next(iter(texts))
