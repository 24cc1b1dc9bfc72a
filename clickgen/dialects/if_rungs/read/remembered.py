"""The reading of a file, remembered: the IR of each rung by its text, and what the whole file holds.

Only what has no problem is remembered, so what a person has to hear is found anew every time. Everything else that the
reading depends on, clickgen itself and the libraries that parse, is for the memory to know.
"""

from __future__ import annotations

import os
from dataclasses import replace
from typing import Any

from clickgen.dialects.if_rungs.read.content import FileContent
from clickgen.ir.data import FromData, NotData, to_data
from clickgen.ir.program import Routine, Rung
from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.source import SourceFile
from clickgen.workspace.digest import digest_of
from clickgen.workspace.memory import Memory

_RUNGS = "rungs"


def read_content(source: SourceFile, problems: Diagnostics, memory: Memory) -> FileContent | None:
    """Read one program file; None when it is not Python. Everything else that is wrong is in ``problems``."""
    remembered = RememberedFile(source, memory)
    content = remembered.content()
    if content is None:
        # Loads libcst, which takes longer than many a build.
        from clickgen.dialects.if_rungs.read.program import read_file

        before = len(problems.found)
        content = read_file(source, problems, remembered)
        if content is not None:
            remembered.keep_content(content, is_plain=len(problems.found) == before)
    return content


class RememberedFile:
    """What is known of one file: a file in the memory, and the rungs that this process has read."""

    def __init__(self, source: SourceFile, memory: Memory) -> None:
        self._source = source
        self._memory = memory
        self._name = f"{_RUNGS}-{digest_of(os.fsencode(os.path.realpath(source.path)))[:32]}.json"
        self._digest = digest_of(source.text.encode())
        self._known = _sound(memory.get(self._name))
        self._read: dict[str, Any] = memory.texts.setdefault(_RUNGS, {})
        """The rungs that this process has read: their data, by their text."""
        self._tree = FromData(source)
        self._met: dict[int, tuple[Rung, int, str]] = {}
        """By the identity of each rung of this file: the line that its places count from, and its text."""

    def content(self) -> FileContent | None:
        """What the file holds; None where its text is not the one that is remembered."""
        if self._known["text"] != self._digest:
            return None
        try:
            return FileContent(self._source.path, tuple(map(self._item, self._known["items"])))
        except (ValueError, LookupError, TypeError):
            return None

    def rung(self, text: str, base: int) -> Rung | None:
        """The rung with this text; None for one that nobody remembers. ``base`` is the line before its first."""
        data = self._read.get(text)
        if data is None:
            data = self._known["rungs"].get(_key(text)) if self._known["rungs"] else None
            if data is None:
                return None
            self._read[text] = data
        try:
            rung = self._tree(data, base)
        except (ValueError, LookupError, TypeError):
            return None
        if not isinstance(rung, Rung):
            return None
        self._met[id(rung)] = rung, base, text
        return rung

    def keep(self, text: str, base: int, rung: Rung) -> None:
        """Remember a rung that was read without a problem."""
        try:
            self._read[text] = to_data(rung, self._source, base)
        except NotData:
            return
        self._met[id(rung)] = rung, base, text

    def keep_content(self, content: FileContent, is_plain: bool) -> None:
        """Remember a file; one with problems by its rungs alone."""
        keys = {text: _key(text) for _, _, text in self._met.values()}
        items: list[object] | None = None
        if is_plain and content.is_declared and not content.proposals:
            items = self._items(content, keys)
        new = {
            "text": "" if items is None else self._digest,
            "items": items or [],
            "rungs": {key: self._read[text] for text, key in keys.items()},
        }
        if new != self._known:
            self._memory.put(self._name, new)

    def _items(self, content: FileContent, keys: dict[str, str]) -> list[object] | None:
        """The items as data, each routine with the lines and keys of its rungs; None where one has another form."""
        items: list[object] = []
        try:
            for item in content.items:
                if isinstance(item, Routine):
                    rungs = [(base, keys[text]) for _, base, text in (self._met[id(rung)] for rung in item.rungs)]
                    items.append([to_data(replace(item, rungs=()), self._source, 0), rungs])
                else:
                    items.append([to_data(item, self._source, 0)])
        except (NotData, KeyError):
            return None
        return items

    def _item(self, data: list[Any]) -> Any:
        item = self._tree(data[0], 0)
        if len(data) == 1:
            return item
        rungs = self._known["rungs"]
        return replace(item, rungs=tuple(self._tree(rungs[key], base) for base, key in data[1]))


def _key(text: str) -> str:
    return digest_of(text.encode())[:32]


def _sound(found: Any) -> dict[str, Any]:
    """What the memory has of a file, where it is of the form that is written here."""
    if isinstance(found, dict) and isinstance(found.get("rungs"), dict) and isinstance(found.get("items"), list):
        return {"text": "", **found}
    return {"text": "", "items": [], "rungs": {}}
