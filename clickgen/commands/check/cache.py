"""The findings of checks, kept by the contents that they were found in: an unchanged program is not judged again.

The cache is in the repository, so whoever made the repository could have put anything there. Each entry is therefore
signed with a secret of this user; an unsigned one is ignored.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import NamedTuple

from clickgen import __version__
from clickgen.commands.check.secret import user_secret
from clickgen.problems.codes import CODES
from clickgen.problems.diagnostics import Diagnostic, Label
from clickgen.text.edits import Edit, Fix
from clickgen.text.source import Span
from clickgen.workspace import leads_elsewhere, read_file

FOLDER = ".clickgen_cache"
_FORMAT = 2


class Cached(NamedTuple):
    """The findings of one program before anything is selected or silenced, and the files in it."""

    findings: tuple[Diagnostic, ...]
    sources: tuple[str, ...]


class Cache:
    """One file for each program in a folder that git ignores. An unusable cache is treated as missing."""

    def __init__(self, folder: Path | None) -> None:
        usable = folder is not None and not leads_elsewhere(folder)
        self._folder = folder if usable else None
        self._secret = user_secret(folder.parent) if folder is not None and usable else None

    def get(self, key: str) -> Cached | None:
        """Return the findings of a program, if every file in it is unchanged."""
        if self._folder is None or self._secret is None:
            return None
        try:
            entry = json.loads(read_file(self._folder / _name(key)))
            if entry.pop("mark") != _mark(entry, self._secret) or entry["key"] != key:
                return None
            if not _is_as_it_was(entry["reads"]):
                return None
            sources = _sources(entry)
            return Cached(tuple(_finding(finding, sources) for finding in entry["findings"]), sources)
        except (OSError, ValueError, LookupError, TypeError, AttributeError, RecursionError):
            return None

    def put(self, key: str, cached: Cached, reads: Mapping[str, bytes | None]) -> None:
        if self._folder is None or self._secret is None:
            return
        entry = {
            "key": key,
            "reads": {path: None if data is None else _digest(data) for path, data in reads.items()},
            "findings": [_entry(finding) for finding in cached.findings],
            "sources": cached.sources,
        }
        data = json.dumps({**entry, "mark": _mark(entry, self._secret)}).encode()
        try:
            self._folder.mkdir(exist_ok=True)
            with contextlib.suppress(FileExistsError):
                _write_new(self._folder / ".gitignore", b"*\n")
            path = self._folder / _name(key)
            staged = path.with_suffix(f".{os.urandom(8).hex()}")
            _write_new(staged, data)
            staged.replace(path)
        except OSError:
            return


def _write_new(path: Path, data: bytes) -> None:
    """Write a file that does not exist yet, not even as a link. Raises OSError."""
    with open(path, "xb") as file:
        file.write(data)


def _mark(entry: object, secret: bytes) -> str:
    """The mark that only this user could have written into the entry."""
    return hashlib.blake2b(json.dumps(entry).encode(), key=secret, digest_size=32).hexdigest()


def key_of(*parts: object) -> str:
    """The key of everything that a program's findings depend on besides its files: settings, and clickgen itself."""
    return json.dumps([_FORMAT, __version__, _own_state(), os.getcwd(), *map(str, parts)])


@cache
def _own_state() -> int:
    """The time of clickgen's newest own file: a checkout under development has no version of its own."""
    youngest = 0
    for folder, _, files in os.walk(Path(__file__).parents[2]):
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
        return _digest(read_file(path))
    except FileNotFoundError:
        return None


def _is_as_it_was(reads: object) -> bool:
    if not isinstance(reads, dict) or not reads:
        raise ValueError("a program is read from somewhere")
    return all(_digest_of(path) == digest for path, digest in reads.items())


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
