"""What a check found, kept by the contents that it was found in: an unchanged program is not judged again."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import NamedTuple

from clickgen import __version__
from clickgen.codes import CODES
from clickgen.diagnostics import Diagnostic, Edit, Fix, Label
from clickgen.source import Span

FOLDER = ".clickgen_cache"
_FORMAT = 1


class Cached(NamedTuple):
    """The findings of one program before anything is selected or silenced, and the files that it was made of."""

    findings: tuple[Diagnostic, ...]
    sources: tuple[str, ...]


class Cache:
    """One file for each program in a folder that git ignores. A cache that cannot be used is no cache."""

    def __init__(self, folder: Path | None) -> None:
        self._folder = folder

    def get(self, key: str) -> Cached | None:
        """What is known of a program, when every file that it was made of is as it was."""
        if self._folder is None:
            return None
        try:
            entry = json.loads((self._folder / _name(key)).read_bytes())
            if entry["key"] != key or not _is_as_it_was(entry["reads"]):
                return None
            return Cached(tuple(map(_finding, entry["findings"])), _sources(entry))
        except (OSError, ValueError, LookupError, TypeError, RecursionError):
            return None

    def put(self, key: str, cached: Cached, reads: Mapping[str, bytes | None]) -> None:
        if self._folder is None:
            return
        entry = {
            "key": key,
            "reads": {path: None if data is None else _digest(data) for path, data in reads.items()},
            "findings": [_entry(finding) for finding in cached.findings],
            "sources": cached.sources,
        }
        try:
            self._folder.mkdir(exist_ok=True)
            ignore = self._folder / ".gitignore"
            if not ignore.exists():
                ignore.write_text("*\n", "utf-8")
            path = self._folder / _name(key)
            staged = path.with_suffix(f".{os.getpid()}")
            staged.write_text(json.dumps(entry), "utf-8")
            staged.replace(path)
        except OSError:
            return


def key_of(*parts: object) -> str:
    """What a program's findings depend on beside its files: settings, and clickgen itself."""
    return json.dumps([_FORMAT, __version__, _own_state(), *map(str, parts)])


@cache
def _own_state() -> int:
    """The youngest of clickgen's own files: a checkout that is worked on has no version of its own."""
    youngest = 0
    for folder, _, files in os.walk(Path(__file__).parents[1]):
        for name in files:
            if name.endswith((".py", ".lark", ".csv")):
                youngest = max(youngest, os.stat(os.path.join(folder, name)).st_mtime_ns)
    return youngest


def _name(key: str) -> str:
    return f"{_digest(key.encode())[:32]}.json"


def _digest(data: bytes) -> str:
    return hashlib.blake2b(data, digest_size=20).hexdigest()


def _digest_of(path: str) -> str | None:
    try:
        with open(path, "rb") as file:
            return _digest(file.read())
    except FileNotFoundError:
        return None


def _is_as_it_was(reads: object) -> bool:
    if not isinstance(reads, dict) or not reads:
        raise ValueError("a program is read from somewhere")
    return all(_digest_of(path) == digest for path, digest in reads.items())


def _sources(entry: Mapping[str, Mapping[str, object]]) -> tuple[str, ...]:
    """The files of the program, each of which was read."""
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


def _finding(entry: list[object]) -> Diagnostic:
    code, message, span, help, labels, fix = entry
    if code not in CODES or not isinstance(labels, list):
        raise ValueError("this is no finding")
    return Diagnostic(
        str(code),
        str(message),
        _span(span),
        str(help),
        tuple(Label(_sure(_span(place)), str(text)) for place, text in labels),
        _fix(fix),
    )


def _fix(entry: object) -> Fix | None:
    if not isinstance(entry, list):
        return None
    edits: Iterable[list[object]] = entry[0]
    return Fix(tuple(Edit(_sure(_span(place)), str(text)) for place, text in edits), entry[1] is True, entry[2] is True)


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
