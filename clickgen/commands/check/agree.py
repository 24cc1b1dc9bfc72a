"""The findings of several programs as one list: a file that several share has each of its findings once.

A fix that rests on the meaning of names is safe only if every program that its file belongs to agrees: one
bit by the table of one program is a block by that of another.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping

from clickgen.commands.check.cache import Cached
from clickgen.dialects.discover import Target
from clickgen.problems.diagnostics import Diagnostic
from clickgen.text.edits import Fix


def agreed(
    judged: Mapping[Target, Cached], partly: Callable[[Iterable[str]], set[str]], real: _Real
) -> list[Diagnostic]:
    """Every finding once, with the most careful fix that a program gives it.

    ``partly`` returns which of some files belong to a program that was not judged; ``real`` gives a file its one path.
    """
    findings: dict[object, Diagnostic] = {}
    votes: Counter[object] = Counter()
    programs: Counter[str] = Counter()
    for cached in judged.values():
        programs.update({real(path) for path in cached.sources})
        votes.update({_vote(finding.code, finding.fix, real) for finding in cached.findings if finding.fix})
        for finding in cached.findings:
            key = _key(finding, real)
            if key not in findings or _boldness(finding.fix) < _boldness(findings[key].fix):
                findings[key] = finding
    paths = {_path(finding.fix) for finding in findings.values() if finding.fix and _is_doubtful(finding.fix)}
    unjudged = partly(paths) if paths else set()

    def settled(finding: Diagnostic) -> Diagnostic:
        fix = finding.fix
        if fix is None or not _is_doubtful(fix):
            return finding
        path = _path(fix)
        if path not in unjudged and votes[_vote(finding.code, fix, real)] == programs[real(path)]:
            return finding
        return finding._replace(fix=fix._replace(is_safe=False))

    return list(map(settled, findings.values()))


_Real = Callable[[str], str]
"""The one path of a file, however it is written."""


def _key(finding: Diagnostic, real: _Real) -> object:
    """The same key for findings of two programs about one place; their hints and fixes may differ."""
    spans = [
        span and span._replace(path=real(span.path))
        for span in (finding.span, *(label.span for label in finding.labels))
    ]
    return finding.code, finding.message, *spans, *(label.text for label in finding.labels)


def _vote(code: str, fix: Fix, real: _Real) -> object:
    return code, fix.is_safe, tuple((real(edit.span.path), edit.span[1:], edit.text) for edit in fix.edits)


def _boldness(fix: Fix | None) -> int:
    return 0 if fix is None else 1 + fix.is_safe


def _is_doubtful(fix: Fix) -> bool:
    """True if another program may judge it differently."""
    return fix.is_safe and fix.rests_on_names


def _path(fix: Fix) -> str:
    return fix.edits[0].span.path
