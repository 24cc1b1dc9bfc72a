"""The findings of checks, kept by the contents that they were found in: an unchanged program is not judged again."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple

from clickgen.problems.codes import CODES
from clickgen.problems.diagnostics import Diagnostic, Label
from clickgen.text.edits import Edit, Fix
from clickgen.text.source import Span
from clickgen.workspace import Workspace
from clickgen.workspace.digest import digest_of

NAME = "checked.json"
_KEPT_MAX = 5000
"""So many programs are remembered, those that were checked last."""


class Cached(NamedTuple):
    """The findings of one program before anything is selected or silenced, and the files in it."""

    findings: tuple[Diagnostic, ...]
    sources: tuple[str, ...]


class Cache:
    """The findings of every program, in one file of the memory. An unusable cache is treated as missing."""

    def __init__(self, workspace: Workspace) -> None:
        self._workspace = workspace
        found = workspace.memory.get(NAME)
        self._entries: dict[str, Any] = found if isinstance(found, dict) else {}

    def get(self, key: str) -> Cached | None:
        """Return the findings of a program, if every file in it is unchanged."""
        try:
            entry = self._entries[key]
            if not self._is_as_it_was(entry["reads"]):
                return None
            sources = _sources(entry)
            return Cached(tuple(_finding(finding, sources) for finding in entry["findings"]), sources)
        except (OSError, ValueError, LookupError, TypeError, AttributeError):
            return None

    def put(self, key: str, cached: Cached, reads: Mapping[str, bytes | None]) -> None:
        """Remember the findings of a program, until the memory is saved."""
        self._entries.pop(key, None)
        self._entries[key] = {
            "reads": {path: None if data is None else digest_of(data) for path, data in reads.items()},
            "findings": [_entry(finding) for finding in cached.findings],
            "sources": list(cached.sources),
        }
        while len(self._entries) > _KEPT_MAX:
            del self._entries[next(iter(self._entries))]
        self._workspace.memory.put(NAME, self._entries)

    def _is_as_it_was(self, reads: object) -> bool:
        if not isinstance(reads, dict) or not reads:
            raise ValueError("a program is read from somewhere")
        return all(self._workspace.digest(path) == digest for path, digest in reads.items())


def key_of(*parts: object) -> str:
    """The key of everything that a program's findings depend on besides its files and clickgen: settings, and place."""
    return digest_of(json.dumps([os.getcwd(), *map(str, parts)]).encode())


def _sources(entry: Mapping[str, Mapping[str, object]]) -> tuple[str, ...]:
    """The files of the program, all of which were read."""
    sources, reads = entry["sources"], entry["reads"]
    if not isinstance(sources, list) or any(reads[path] is None for path in sources):
        raise ValueError("a source was not read")
    return tuple(sources)


# -- findings as JSON -------------------------------------------------------------------------------------------------


def _entry(finding: Diagnostic) -> list[object]:
    fix = finding.fix
    return [
        finding.code,
        finding.message,
        finding.span,
        finding.help,
        [[label.span, label.text] for label in finding.labels],
        [[[edit.span, edit.text] for edit in fix.edits], fix.is_safe, fix.rests_on_names] if fix else None,
    ]


def _finding(entry: list[object], sources: tuple[str, ...]) -> Diagnostic:
    code, message, span, help, labels, fix = entry
    if code not in CODES or not isinstance(labels, list):
        raise ValueError("this is no finding")
    return Diagnostic(
        str(code),
        str(message),
        _span(span),
        str(help),
        tuple(Label(_sure(_span(place)), str(text)) for place, text in labels),
        _fix(fix, sources),
    )


def _fix(entry: object, sources: tuple[str, ...]) -> Fix | None:
    if not isinstance(entry, list):
        return None
    edits: Iterable[list[object]] = entry[0]
    fix = Fix(tuple(Edit(_sure(_span(place)), str(text)) for place, text in edits), entry[1] is True, entry[2] is True)
    paths = {edit.span.path for edit in fix.edits}
    if len(paths) != 1 or not paths <= {*sources}:
        raise ValueError("a fix changes one source file of the program")
    return fix


def _span(entry: object) -> Span | None:
    if not isinstance(entry, list):
        return None
    span = Span(*entry)
    if tuple(map(type, span)) != (str, int, int, int, int, str):
        raise ValueError("this is no place")
    return span


def _sure(span: Span | None) -> Span:
    if span is None:
        raise ValueError("a place is missing")
    return span
