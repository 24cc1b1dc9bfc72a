"""The list of writers is the listing of this folder: every module or package here with a ``WRITER``."""

from __future__ import annotations

import pkgutil
from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cache
from importlib import import_module

import clickgen.emit
from clickgen.emit.built import BuiltProgram
from clickgen.emit.writer import Writer


@cache
def writers() -> tuple[Writer, ...]:
    """Every writer, in the order of the outputs."""
    names = [module.name for module in pkgutil.iter_modules(clickgen.emit.__path__)]
    modules = [import_module(f"{clickgen.emit.__name__}.{name}") for name in sorted(names)]
    found: list[Writer] = [module.WRITER for module in modules if hasattr(module, "WRITER")]
    return tuple(sorted(found, key=lambda writer: writer.rank))


def writer_of(path: str) -> Writer | None:
    """The writer that can choose a path inside an output folder."""
    return next((writer for writer in writers() if writer.owns.fullmatch(path)), None)


def folders() -> tuple[str, ...]:
    """The subfolders of an output folder that writers use."""
    return tuple(dict.fromkeys(folder for writer in writers() for folder in writer.folders))


class Outputs(Mapping[str, str]):
    """The text of each output of a build, by its path inside the output folder. A text is made when it is asked for."""

    def __init__(self, built: BuiltProgram) -> None:
        self._writers = {path: writer for writer in writers() if not writer.on_request for path in writer.paths(built)}
        self._built = replace(built, outputs=tuple(self._writers))
        self._made: dict[str, str] = {}

    def __getitem__(self, path: str) -> str:
        if path not in self._made:
            text = self._writers[path].write(self._built, path)
            assert isinstance(text, str)
            self._made[path] = text
        return self._made[path]

    def __iter__(self) -> Iterator[str]:
        return iter(self._writers)

    def __len__(self) -> int:
        return len(self._writers)
