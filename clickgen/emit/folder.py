"""The output folder: what an earlier build left in it, and what must not be there."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path

_MAP = "sources.json"


class ForeignFiles(Exception):
    """The folder holds files in the way that clickgen did not make; the message names them."""


def stale_files(folder: Path, files: Mapping[str, bytes]) -> list[Path]:
    """Files of an earlier build that this one does not make.

    Raises ForeignFiles when an output would replace a file that is not an earlier output, and when other CSV files
    are there: ClickNick's guided paste takes every CSV file of the folder as ladder (click-facts, section 7).
    """
    made_before = _made_before(folder)
    there = {path.relative_to(folder).as_posix(): path for path in _csv_files(folder)}
    in_the_way = [path for name, path in there.items() if name not in files and name not in made_before]
    if in_the_way:
        raise ForeignFiles(_message(folder, "ClickNick would take these for ladder", in_the_way))
    taken = [folder / name for name, data in files.items() if name not in made_before and _differs(folder / name, data)]
    if taken:
        raise ForeignFiles(_message(folder, "these are not an earlier build's", taken))
    return [path for name, path in there.items() if name not in files]


def _csv_files(folder: Path) -> list[Path]:
    """Files that Windows takes for CSV, whatever the case of their ending."""
    folders = [place for place in (folder, folder / "subroutines") if place.is_dir()]
    return sorted(path for place in folders for path in place.iterdir() if path.suffix.casefold() == ".csv")


def _differs(path: Path, data: bytes) -> bool:
    return path.is_file() and path.read_bytes() != data


def _message(folder: Path, why: str, paths: list[Path]) -> str:
    names = ", ".join(path.relative_to(folder).as_posix() for path in paths)
    return (
        f"{folder} holds files that clickgen did not make ({why}): {names}; move them, or choose another folder with -o"
    )


def _made_before(folder: Path) -> set[str]:
    """The outputs that the last build noted in its source map."""
    try:
        noted = json.loads((folder / _MAP).read_text("utf-8"))
    except (OSError, ValueError, RecursionError):
        return set()
    files = noted.get("files") if isinstance(noted, dict) and noted.get("generator") == "clickgen" else None
    return {name for name in files if isinstance(name, str)} if isinstance(files, list) else set()
