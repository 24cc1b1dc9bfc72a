"""The smallest form of files that fail: hypothesis makes examples smaller, but takes whole programs as they are."""

from __future__ import annotations

import traceback
from collections.abc import Callable
from dataclasses import dataclass

from strategies.given import TABLE, Given
from strategies.shown import ShownAsText


@dataclass(frozen=True)
class Smallest(ShownAsText):
    """Files under a check. Only a failure is printed, and only then are its superfluous lines removed."""

    files: Given
    check: Callable[[Given], None]

    @property
    def text(self) -> str:
        fault = fault_of(self.files, self.check)
        return without_lines(self.files, self.check, fault).text if fault else self.files.text


def fault_of(files: Given, check: Callable[[Given], None]) -> str:
    """The first words of what a check raises; "" if the files pass."""
    try:
        check(files)
    except Exception as error:
        return traceback.format_exception_only(error)[-1].strip()[:60]
    return ""


def without_lines(files: Given, check: Callable[[Given], None], fault: str) -> Given:
    """Return the files without the lines that the fault does not need."""
    for name, _ in files.files:
        at = 0
        while name != TABLE:
            lines = dict(files.files)[name].splitlines(keepends=True)
            if at >= len(lines):
                break
            rest = b"".join(lines[:at] + lines[at + 1 :])
            fewer = Given(tuple((other, rest if other == name else data) for other, data in files.files))
            if fault_of(fewer, check) == fault:
                files = fewer
            else:
                at += 1
    return files
