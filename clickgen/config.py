"""The one reader of settings: ``clickgen.toml``, or ``[tool.clickgen]`` in the nearest ``pyproject.toml`` with it."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, TypeVar

from clickgen.problems.codes import CODES
from clickgen.problems.diagnostics import did_you_mean
from clickgen.table.names import TABLE_NAME, is_workbook
from clickgen.workspace import MIB, CouldNotRun, Workspace

if TYPE_CHECKING:
    from clickgen.device.banks import Address

_FILE_MAX = MIB
OWN_FILE, PROJECT_FILE = "clickgen.toml", "pyproject.toml"


_DEPTH_MAX = 32
"""Levels of tables and lists: other tools share a pyproject.toml, and some of them nest."""
_BITS_MAX = 64


class ConfigError(CouldNotRun):
    """The settings cannot be used. The message names the file, the key and the way out."""


class ProgramSettings(NamedTuple):
    """One PLC of a repository: its main file, address table and output folder. None is the default place."""

    path: Path
    nicknames: Path | None = None
    output: Path | None = None


class CheckSettings(NamedTuple):
    """Which rules run where. Codes may be prefixes: ``CG5`` is every rule of that group."""

    select: tuple[str, ...] | None = None
    """None means every rule that is on by default."""
    extend_select: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()
    exclude: tuple[str, ...] = ()
    per_file_ignores: tuple[tuple[str, tuple[str, ...]], ...] = ()


class Settings(NamedTuple):
    """The settings for building one program, besides its own text.

    ``nicknames`` names the address table; None is ``nicknames.csv`` beside the program. A workbook that it names is
    only read: names that it lacks go into ``nicknames.csv`` beside the program. ``table_must_exist`` refuses a missing
    one. ``frozen`` forbids choosing addresses; ``reserved`` are never chosen. ``wants`` tells whether a check
    should look for a code. ``is_part`` marks a file without a main that no program imports. ``named_elsewhere`` has the
    names, in lower case, and the addresses that other programs of the table use.
    """

    nicknames: str | os.PathLike[str] | None = None
    table_must_exist: bool = False
    frozen: bool = False
    reserved: tuple[Address, ...] = ()
    wants: Callable[[str], bool] = lambda _: True
    is_part: bool = False
    named_elsewhere: frozenset[str] = frozenset()

    @property
    def workbook(self) -> Path | None:
        """The workbook that is named in place of an address table."""
        named = Path(self.nicknames) if self.nicknames is not None else None
        return named if named is not None and is_workbook(named) else None

    def table_of(self, program: str | os.PathLike[str]) -> Path:
        """The address table for the new names of a program."""
        if self.nicknames is None or self.workbook is not None:
            return Path(program).parent / TABLE_NAME
        return Path(self.nicknames)


class Config(NamedTuple):
    """The settings of a repository. Paths and patterns are relative to ``root``, the folder of ``file``."""

    root: Path
    file: Path | None = None
    programs: tuple[ProgramSettings, ...] = ()
    reserved: tuple[Address, ...] = ()
    """Addresses that allocation leaves alone: the reserved ones, and those outside a bank's own settings."""
    check: CheckSettings = CheckSettings()

    def program(self, path: Path) -> ProgramSettings:
        """Return the settings of the program at ``path``; the defaults if it has none of its own."""
        for settings in self.programs:
            if _same(settings.path, path):
                return settings
        return ProgramSettings(path)


def find_config(start: Path, files: Workspace | None = None) -> Config:
    """Return the settings for the folder ``start``: the nearest file upward. Raises ConfigError."""
    files = files or Workspace()
    for folder in (start.absolute(), *start.absolute().parents):
        for name in (OWN_FILE, PROJECT_FILE):
            path = folder / name
            # Whoever reads it refuses an entry that is not a file: a pipe or a device has no settings.
            if path.exists() and not path.is_dir():
                config = _read(path, files, optional=name == PROJECT_FILE)
                if config is not None:
                    return config
    return Config(start)


def read_config(path: Path, files: Workspace | None = None) -> Config:
    """Return the settings in a named file. Raises ConfigError, also if a project file has none for clickgen."""
    config = _read(path, files or Workspace(), optional=False)
    assert config is not None
    return config


def _same(one: Path, other: Path) -> bool:
    if os.path.abspath(one) == os.path.abspath(other):
        return True
    return one.exists() and other.exists() and one.samefile(other)


def code_prefix(value: object) -> str:
    """Return a code, or the beginning of some: ``CG501``, ``CG5``, ``ALL``. Raises ValueError with the way out."""
    if value == "ALL":
        return "CG"
    if isinstance(value, str) and value.startswith("CG") and any(code.startswith(value) for code in CODES):
        return value
    near = did_you_mean(str(value), CODES) or "a code is CG501, a group CG5, everything ALL"
    raise ValueError(f"clickgen has no code {value!r}; {near}")


# -- reading ----------------------------------------------------------------------------------------------------------

T = TypeVar("T")


def _read(path: Path, files: Workspace, optional: bool) -> Config | None:
    import tomllib

    try:
        text = files.read(path, _FILE_MAX).decode("utf-8-sig")
        tree: object = tomllib.loads(text.replace("\r\n", "\n").replace("\r", "\n"))
    except OSError as error:
        raise ConfigError(f"{path} cannot be read: {error.strerror or error}") from None
    except RecursionError:
        raise ConfigError(f"{path} is nested too deeply for settings") from None
    except ValueError as error:  # not TOML, not UTF-8, or a number of thousands of digits
        raise ConfigError(f"{path} is not TOML: {error}") from None
    _refuse_monsters(path, tree)
    if path.name != OWN_FILE and isinstance(tree, dict) and ("tool" in tree or path.name == PROJECT_FILE):
        tool = tree.get("tool", {})
        if not isinstance(tool, dict) or "clickgen" not in tool:
            if optional:
                return None
            raise ConfigError(f"{path} has no [tool.clickgen]")
        return _Table(path, "tool.clickgen", tool["clickgen"]).config()
    return _Table(path, "", tree).config()


def _refuse_monsters(path: Path, tree: object) -> None:
    """Raise ConfigError for values that no setting has and no message could show: deep nesting and endless numbers."""
    waiting: list[tuple[object, int]] = [(tree, 0)]
    while waiting:
        value, depth = waiting.pop()
        if depth > _DEPTH_MAX:
            raise ConfigError(f"{path} is nested too deeply for settings")
        if isinstance(value, int) and value.bit_length() > _BITS_MAX:
            raise ConfigError(f"{path} holds a number of {value.bit_length()} bits; no setting is that large")
        inner = value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
        waiting += ((one, depth + 1) for one in inner)


class _Table:
    """One table of the file; every fault in it is reported with file and key."""

    def __init__(self, file: Path, place: str, tree: object) -> None:
        self._file = file
        self._place = place
        if not isinstance(tree, dict):
            raise ConfigError(f"{file}: {place} must be a table")
        self._tree: Mapping[str, object] = tree

    def config(self) -> Config:
        self._known("programs", "reserved", "allocation", "check")
        root = self._file.parent
        programs = self._list("programs", lambda place, value: self._program(place, value, root))
        paths = [str(program.path) for program in programs]
        for path in paths:
            if paths.count(path) > 1:
                raise self._error("programs", f"names {path} twice")
        reserved = [address for run in self._list("reserved", self._addresses) for address in run]
        reserved += _Table(self._file, self._key("allocation"), self._tree.get("allocation", {}))._closed()
        check = _Table(self._file, self._key("check"), self._tree.get("check", {})).check()
        return Config(root, self._file, tuple(programs), tuple(dict.fromkeys(reserved)), check)

    def check(self) -> CheckSettings:
        self._known("select", "extend-select", "ignore", "exclude", "per-file-ignores")
        patterns = _Table(self._file, self._key("per-file-ignores"), self._tree.get("per-file-ignores", {}))
        return CheckSettings(
            tuple(self._list("select", self._code)) if "select" in self._tree else None,
            tuple(self._list("extend-select", self._code)),
            tuple(self._list("ignore", self._code)),
            tuple(self._list("exclude", self._pattern)),
            tuple(
                (patterns._pattern(patterns._place, pattern), tuple(patterns._list(pattern, patterns._code)))
                for pattern in patterns._tree
            ),
        )

    # -- values -------------------------------------------------------------------------------------------------------

    def _program(self, place: str, value: object, root: Path) -> ProgramSettings:
        if isinstance(value, str):
            return ProgramSettings(root / self._path(place, value))
        table = _Table(self._file, place, value)
        table._known("path", "nicknames", "output")
        path, nicknames, output = (table._optional_path(key) for key in ("path", "nicknames", "output"))
        if path is None:
            raise table._error("path", "is missing: it names the program's main file")
        return ProgramSettings(root / path, root / nicknames if nicknames else None, root / output if output else None)

    def _closed(self) -> list[Address]:
        """The addresses that the settings of each bank close: those to avoid, before its start, outside its ranges."""
        if not self._tree:
            return []
        from clickgen.device.banks import BANKS, Address

        banks = [bank.dsl.upper() for bank in BANKS.values() if bank.allocatable]
        closed: list[Address] = []
        for key, value in self._tree.items():
            if key.upper() not in banks:
                hint = did_you_mean(key, banks) or f"clickgen chooses addresses in {', '.join(banks)}"
                raise ConfigError(f"{self._file}: {self._place} has no bank {key}; {hint}")
            table = _Table(self._file, self._key(key), value)
            table._known("use", "avoid", "start")
            used, avoided = (set(table._numbers(name, key.upper())) for name in ("use", "avoid"))
            start = table._tree.get("start")
            first = min(table._run_in(table._key("start"), start, key.upper())) if start is not None else 0
            bank = BANKS[key.upper()]
            numbers = [
                n for n in bank.numbers() if n < first or n in avoided or ("use" in table._tree and n not in used)
            ]
            closed += (Address(bank.name, number) for number in numbers)
        return closed

    def _numbers(self, key: str, bank: str) -> Iterable[int]:
        """The numbers of a list of addresses of one bank."""
        for run in self._list(key, lambda place, value: self._run_in(place, value, bank)):
            yield from run

    def _run_in(self, place: str, value: object, bank: str) -> list[int]:
        addresses = list(self._addresses(place, value))
        if addresses[0].bank != bank:
            raise ConfigError(f"{self._file}: {place} must be addresses of {bank}, not {value!r}")
        return [address.number for address in addresses]

    def _addresses(self, place: str, value: object) -> Iterable[Address]:
        from clickgen.device.banks import BANKS, Address

        match = _RUN.fullmatch(value) if isinstance(value, str) else None
        bank = BANKS.get(match[1].upper()) if match else None
        if match and bank:
            first, last = int(match[2]), int(match[3] or match[2])
            if first <= last and bank.has(first) and bank.has(last):
                return [Address(bank.name, number) for number in range(first, last + 1) if bank.has(number)]
        raise ConfigError(f'{self._file}: {place} must be addresses like "DS100" or "DS1000..DS1999", not {value!r}')

    def _code(self, place: str, value: object) -> str:
        try:
            return code_prefix(value)
        except ValueError as error:
            raise ConfigError(f"{self._file}: {place}: {error}") from None

    def _text(self, place: str, value: object) -> str:
        if isinstance(value, str):
            return value
        raise ConfigError(f"{self._file}: {place} must be a text in quotes, not {value!r}")

    def _pattern(self, place: str, value: object) -> str:
        """A pattern that can name a path: it begins with the folder of the settings or a name in it."""
        text = self._text(place, value)
        names = [name for name in text.split("/") if name not in ("", ".")]
        if names and ".." not in names and "\\" not in text and not text.startswith("!"):
            return text
        raise ConfigError(
            f"{self._file}: {place}: no path is like {value!r}; a pattern is a name or a path below this file with /, "
            'such as "old", "plc/*.py" or "plc/**/old"'
        )

    def _path(self, place: str, value: object) -> str:
        text = self._text(place, value)
        if "\0" in text:
            raise ConfigError(f"{self._file}: {place}: no path is like {value!r}; take the \\u0000 out of it")
        return text

    def _optional_path(self, key: str) -> str | None:
        return self._path(self._key(key), self._tree[key]) if key in self._tree else None

    def _list(self, key: str, read: Callable[[str, object], T]) -> list[T]:
        values = self._tree.get(key, [])
        if not isinstance(values, list):
            raise self._error(key, "must be a list: [...]")
        return [read(f"{self._key(key)}[{index}]", value) for index, value in enumerate(values)]

    # -- keys ---------------------------------------------------------------------------------------------------------

    def _known(self, *keys: str) -> None:
        for key in self._tree:
            if key not in keys:
                hint = did_you_mean(key, keys) or f"the keys: {', '.join(keys)}"
                raise ConfigError(f"{self._file}: unknown key {self._key(key)}; {hint}")

    def _key(self, key: str) -> str:
        return f"{self._place}.{key}" if self._place else key

    def _error(self, key: str, fault: str) -> ConfigError:
        return ConfigError(f"{self._file}: {self._key(key)} {fault}")


_RUN = re.compile(r"([A-Za-z]{1,3})([0-9]{1,4})(?:\.\.\1([0-9]{1,4}))?", re.IGNORECASE)
