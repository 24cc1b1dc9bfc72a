"""From paths to programs: the files to check, and for a file without a main the programs that import it."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from fnmatch import fnmatch
from functools import cache, cached_property
from pathlib import Path
from typing import NamedTuple, NoReturn

from clickgen.config import Config
from clickgen.workspace import CouldNotRun, Workspace
from clickgen.workspace.memory import Memory

_USUAL_EXCLUDES = ("build", "dist", "venv", "node_modules", "__pycache__", "site-packages")
"""Folders that hold no sources; those with a dot in front are left out too."""


class Target(NamedTuple):
    """One program to check. A file without a main that no program imports is judged as a part of one."""

    path: str
    nicknames: str | None = None
    is_part: bool = False


class Found(NamedTuple):
    """What to check, each program once, in the order of their paths; and the folders that have no program."""

    targets: list[Target]
    empty: tuple[str, ...] = ()


def discover(
    paths: Sequence[str],
    config: Config,
    exclude: Iterable[str] = (),
    force: bool = False,
    workspace: Workspace | None = None,
) -> Found:
    """The programs that these paths name. Raises CouldNotRun for what is not there or cannot be read.

    Without paths it is the configured programs, and without those the working folder. ``exclude`` and the configured
    patterns hold for what is found in folders; with ``force`` also for files that were named, and those of them that
    have nothing to do with a program are left alone: pre-commit names every Python file.
    """
    repository = _Repository(config, (*config.check.exclude, *exclude), workspace or Workspace())
    if not paths and config.programs:
        return Found(_each_once(repository.configured_targets(), repository.real))
    found: list[Target] = []
    empty: list[str] = []
    for path in paths or ["."]:
        targets = list(repository.targets(path, force))
        found += targets
        if not targets and os.path.isdir(path):
            empty.append(path)
    return Found(_each_once(found, repository.real), tuple(empty))


def targets(
    paths: Sequence[str],
    config: Config,
    exclude: Iterable[str] = (),
    force: bool = False,
    workspace: Workspace | None = None,
) -> list[Target]:
    """The programs that ``discover`` finds."""
    return discover(paths, config, exclude, force, workspace).targets


def wholly_judged(
    paths: Iterable[str], judged: Iterable[Target], config: Config, workspace: Workspace | None = None
) -> set[str]:
    """Those of these files of which every program was judged: nothing more can be found in them.

    A part that no program imports is never among them: some other file will bring what it lacks.
    """
    done, programs = _programs_of(paths, judged, config, workspace)
    return {path for path, needed in programs.items() if needed and needed <= done}


def partly_judged(
    paths: Iterable[str], judged: Iterable[Target], config: Config, workspace: Workspace | None = None
) -> set[str]:
    """Those of these files that belong to a program which was not judged."""
    done, programs = _programs_of(paths, judged, config, workspace)
    return {path for path, needed in programs.items() if not needed <= done}


def _programs_of(
    paths: Iterable[str], judged: Iterable[Target], config: Config, workspace: Workspace | None
) -> tuple[set[str], dict[str, set[str]]]:
    """The programs that were judged, and those that each of these files belongs to, by their real paths."""
    repository = _Repository(config, (), workspace or Workspace())
    done = {os.path.realpath(target.path) for target in judged if not target.is_part}
    return done, {path: {os.path.realpath(program) for program in repository.programs_with(path)} for path in paths}


def _each_once(targets: Iterable[Target], real: Callable[[str], str]) -> list[Target]:
    programs: dict[str, Target] = {}
    for target in targets:
        programs.setdefault(real(target.path), target)
    return sorted(programs.values(), key=lambda target: target.path)


def _shown(path: Path) -> str:
    """Relative to the working folder where it is below."""
    here = Path.cwd()
    return str(path.relative_to(here)) if path.is_relative_to(here) else str(path)


# -- the files --------------------------------------------------------------------------------------------------------


class _File(NamedTuple):
    """What a look at a file tells."""

    is_program: bool
    has_main: bool
    modules: list[str]
    """What it imports: the names of files beside it, not all of which need be there."""


def _seen(text: str) -> _File:
    code = _code_of(text)
    # A text in quotes may show a main.
    has_main = _MAIN.search(text) is not None and _MAIN.search(code) is not None
    return _File(_is_program(code), has_main, list(dict.fromkeys(_modules(text))))


_NAME_IN_MEMORY = "discovered.json"
_REMEMBERED_MAX = 20_000
"""So many files are remembered, by their digests; the last that were new."""


class _Seen:
    """What was seen of files, by the digests of their contents: an unchanged file is not looked through again."""

    def __init__(self, memory: Memory) -> None:
        found = memory.get(_NAME_IN_MEMORY)
        self._memory = memory
        self._known: dict[str, list[object]] = found if isinstance(found, dict) else {}

    def get(self, digest: str) -> _File | None:
        match self._known.get(digest):
            case [bool() as is_program, bool() as has_main, list() as modules]:
                return _File(is_program, has_main, modules)
        return None

    def put(self, digest: str, file: _File) -> None:
        self._known[digest] = [*file]
        while len(self._known) > _REMEMBERED_MAX:
            del self._known[next(iter(self._known))]
        self._memory.put(_NAME_IN_MEMORY, self._known)


class _Repository:
    """The files around the programs, each read once."""

    def __init__(self, config: Config, patterns: Sequence[str], files: Workspace) -> None:
        self._config = config
        self._patterns = patterns
        self._workspace = files
        self._seen = _Seen(files.memory)
        self._files: dict[str, _File] = {}
        self._programs: dict[str, list[str]] = {}
        self._parts: dict[str, set[str]] = {}

    # -- targets ------------------------------------------------------------------------------------------------------

    def configured_targets(self) -> Iterator[Target]:
        for program in self._config.programs:
            if not program.path.exists():
                raise CouldNotRun(f"there is no file {program.path}, which {self._config.file} names as a program")
            yield self._target(_shown(program.path))

    def targets(self, path: str, force: bool) -> Iterator[Target]:
        """The programs in a folder, or those that a file belongs to."""
        if os.path.isdir(path):
            for file in self._walk(path):
                yield from self._targets_of(file)
        elif not os.path.exists(path) and self.real(path) not in self._workspace.overlay:
            raise CouldNotRun(f"there is no file or folder {path}")
        elif not force or (not self._is_excluded(path) and (self._is_ours(path) or self._importers(path))):
            yield from self._targets_of(path)

    def _targets_of(self, path: str) -> Iterator[Target]:
        """The program that a file is, else those that import it, else the file as a part of one."""
        if self._is_whole(path):
            yield self._target(path)
            return
        programs = self._importers(path)
        yield from map(self._target, programs)
        if not programs:
            yield self._target(path)._replace(is_part=True)

    def _target(self, path: str) -> Target:
        nicknames = self._config.program(Path(path)).nicknames
        return Target(path, _shown(nicknames.absolute()) if nicknames else None)

    # -- finding ------------------------------------------------------------------------------------------------------

    def _walk(self, folder: str) -> Iterator[str]:
        """The files in a folder that are programs or parts of them."""
        for root, folders, files in os.walk(folder, onerror=_give_up):
            folders[:] = sorted(
                name
                for name in folders
                if not name.startswith(".")
                and name not in _USUAL_EXCLUDES
                and not self._is_excluded(os.path.join(root, name))
            )
            for name in sorted(files):
                path = os.path.normpath(os.path.join(root, name))
                if name.endswith(".py") and self._is_wanted(path):
                    yield path

    def _is_wanted(self, path: str) -> bool:
        """True for a program or a part that is not excluded. A link to nowhere and a pipe are neither."""
        return not self._is_excluded(path) and os.path.isfile(path) and self._is_ours(path)

    def _is_excluded(self, path: str) -> bool:
        if not self._patterns:
            return False
        root = str(self._config.root)
        names = _names_below(path, root)
        return any(_meets(names, _steps(pattern, root)) for pattern in self._patterns)

    def _is_ours(self, path: str) -> bool:
        return self._look(path).is_program or self.real(path) in self._named

    def _is_whole(self, path: str) -> bool:
        """True for a program, however broken; not for a part of one."""
        return self._look(path).has_main or self.real(path) in self._configured

    @cached_property
    def _configured(self) -> dict[str, str]:
        """The configured programs that are there, by their real paths."""
        programs = [_shown(program.path) for program in self._config.programs if program.path.is_file()]
        return {self.real(program): program for program in programs}

    @cached_property
    def _named(self) -> set[str]:
        """The configured programs and all that they import: these are never left alone."""
        return {*self._configured}.union(*map(self._imported, self._configured))

    # -- parts of programs --------------------------------------------------------------------------------------------

    def programs_with(self, path: str) -> list[str]:
        """The programs that a file belongs to: itself, if it is one, and those that import it."""
        return [*([path] if self._is_whole(path) else []), *self._importers(path)]

    def _importers(self, path: str) -> list[str]:
        real = self.real(path)
        return [program for program in self._programs_around(path) if real in self._imported(program)]

    def _programs_around(self, path: str) -> list[str]:
        """The programs that could import a file: those configured and those beside it."""
        folder = os.path.dirname(path)
        if folder not in self._programs:
            beside = (os.path.normpath(os.path.join(folder, name)) for name in _names(folder) if name.endswith(".py"))
            programs = {self.real(file): file for file in beside if self._is_program_with_main(file)}
            self._programs[folder] = [*({**programs, **self._configured}).values()]
        return self._programs[folder]

    def _is_program_with_main(self, path: str) -> bool:
        if not os.path.isfile(path):
            return False
        try:
            file = self._look(path)
        except CouldNotRun:
            return False
        return file.is_program and file.has_main

    def _imported(self, program: str) -> set[str]:
        """Every file that a program is made of, itself aside, by its real path."""
        if program not in self._parts:
            self._parts[program] = self._reached(program)
        return self._parts[program]

    def _reached(self, program: str) -> set[str]:
        seen: set[str] = set()
        waiting = [program]
        while waiting:
            path = waiting.pop()
            folder = os.path.dirname(path)
            imported = [os.path.realpath(os.path.join(folder, f"{name}.py")) for name in self._look(path).modules]
            new = [file for file in imported if file not in seen and os.path.isfile(file)]
            seen.update(new)
            waiting += new
        return seen

    # -- reading ------------------------------------------------------------------------------------------------------

    def _look(self, path: str) -> _File:
        """What a file is. Raises CouldNotRun when it cannot be read: it could be a program."""
        real = self.real(path)
        if real not in self._files:
            self._files[real] = self._seen_or_known(path)
        return self._files[real]

    def _seen_or_known(self, path: str) -> _File:
        data = self._bytes(path)
        digest = self._workspace.digest(path) or ""
        file = self._seen.get(digest)
        if file is None:
            text = data.decode("utf-8-sig", "replace")
            file = _seen(text.replace("\r\n", "\n").replace("\r", "\n") if "\r" in text else text)
            self._seen.put(digest, file)
        return file

    def real(self, path: str) -> str:
        return self._workspace.real(path)

    def _bytes(self, path: str) -> bytes:
        try:
            return self._workspace.read(path)
        except OSError as error:
            error.filename = path
            _give_up(error)


def _give_up(error: OSError) -> NoReturn:
    raise CouldNotRun(f"{error.filename} cannot be read: {error.strerror or error}")


def _names(folder: str) -> list[str]:
    try:
        return sorted(os.listdir(folder or "."))
    except OSError:
        return []


# -- patterns ---------------------------------------------------------------------------------------------------------


def matches(pattern: str, path: str | os.PathLike[str], root: str | os.PathLike[str]) -> bool:
    """True when a pattern of the settings in ``root`` names the path or a folder above it, as in ``.gitignore``.

    ``*`` stays in one name and ``**`` is any number of folders. A pattern without a slash meets a name anywhere; one
    with a slash, also in front, begins at ``root``.
    """
    return _meets(_names_below(path, root), _steps(pattern, os.fspath(root)))


def _names_below(path: str | os.PathLike[str], root: str | os.PathLike[str]) -> tuple[str, ...]:
    """The names that lead from ``root`` to the path; all of its names when it is elsewhere."""
    absolute, above = Path(os.path.abspath(path)), Path(os.path.abspath(root))
    return absolute.relative_to(above).parts if absolute.is_relative_to(above) else absolute.parts[1:]


@cache
def _steps(pattern: str, root: str) -> tuple[str, ...]:
    """A pattern as the names that follow each other; ``**`` for any number of them."""
    below = pattern.removeprefix(f"{Path(os.path.abspath(root)).as_posix()}/")
    is_anchored = below != pattern or "/" in pattern.rstrip("/")
    names = tuple(name for name in below.split("/") if name not in ("", "."))
    return names if is_anchored or not names else ("**", *names)


def _meets(names: tuple[str, ...], steps: tuple[str, ...]) -> bool:
    """True when the steps lead to the path or to a folder above it. A pattern without a name leads nowhere.

    Each name is compared with the steps that can be reached there, each once: no pattern makes it try more.
    """
    while len(steps) > 1 and steps[-1] == "**":
        steps = steps[:-1]
    reached = {0} if steps else set()
    for name in names:
        reached = {beyond for step in reached for beyond in _beyond(steps, step, name)}
        if len(steps) in reached:
            return True
    return False


def _beyond(steps: tuple[str, ...], step: int, name: str) -> Iterator[int]:
    """The steps that can follow when a name has come to ``step``; ``**`` takes any number of names."""
    while steps[step] == "**":
        yield step
        step += 1
        if step == len(steps):
            yield step
            return
    if fnmatch(name, steps[step]):
        yield step + 1


# -- which files are programs -----------------------------------------------------------------------------------------

# fmt: off
BANK_WORDS = frozenset((
    "x", "y", "c", "t", "ct", "sc", "ds", "dd", "dh", "df", "xd", "yd", "td", "ctd", "sd", "txt",
))
CALL_WORDS = frozenset((
    "calc", "call", "copy", "copy_block", "copy_fill", "copy_pack", "copy_unpack", "ctd", "ctu", "ctud", "end",
    "event_drum", "math_hex", "next_loop", "nickname", "not_imported", "out", "raw", "receive", "reset", "rtof", "rton",
    "search", "send", "set", "shift", "time_drum", "tof", "ton",
))
# fmt: on
_OWN_WORDS = BANK_WORDS | CALL_WORDS | {"sub"}
_BUILTINS = {"set"}
"""What every Python program may call."""

_ESCAPED = re.compile(r"\\[^\n]")
_TEXTS = re.compile(
    r"""(?=["'#<=>|])(?:"""
    r'"""[^"]*+(?:"(?!"")[^"]*+)*+"""'
    r"|'''[^']*+(?:'(?!'')[^']*+)*+'''"
    r'|"[^"\n]*+"'
    r"|'[^'\n]*+'"
    r"|#[^\n]*"
    r"|^(?:<{7}|={7}|>{7}|\|{7})(?: [^\n]*)?$)",
    re.MULTILINE | re.DOTALL,
)
"""Everything that is not code: texts in quotes, comments, the marks of a merge. See ``_code_of``."""


def _code_of(text: str) -> str:
    """The code in a text. An escaped quote ends no text; without those, no look for an end is ever repeated."""
    return _TEXTS.sub("", _ESCAPED.sub("__", text) if "\\" in text else text)


_NAME = re.compile(r"([A-Za-z_@.]\w*)([\w.]*)[ \t]*([\[(]?)")
"""A name, what hangs on it with dots, and the bracket behind. One behind a dot or an @ is no name of its own."""
_MAKING = re.compile(r"(?:def|class|import)[ \t]+(\w+)")

# What few files need is compiled when they do: a repeated check is over before all of it would be.
_SUB = r"(?m)^@sub[ \t]*(?:\([\s,]*\)[ \t]*)?$"
"""Also ``@sub("Auto Mode")``, of which the text is gone."""
_ROUTINE = r"(?m)^(?:(?:async[ \t]+)?def[ \t]+main\b|@sub\b|nickname\b|\w+[ \t]*\(\s*\w+[.\[])"
_EDITOR = r"(?m)^from[ \t]+clickgen\.dsl[ \t]+import\b"
_STAR = r"import[ \t]*\*"
_FIRST_INDENT = r"(?m)^([ \t]+)\S"
_RUNG = rf"(?:if|for|pass|{'|'.join(sorted(CALL_WORDS))})\b|[)\]}}]"


def is_program(text: str) -> bool:
    """True for a text that looks like clickgen's, valid or broken. Other Python is left alone.

    Python has to make a name before it uses it; clickgen has its banks and instructions without that. So a file is
    clickgen's when it uses one of them, ``c.Auto``, ``y[1]`` or ``out(...)``, and nowhere makes a name like it. That
    holds however broken the rest is.
    """
    return _is_program(_code_of(text))


def _is_program(code: str) -> bool:
    """``is_program`` of a text without what is in quotes."""
    if "clickgen.dsl" in code and re.search(_EDITOR, code):
        return True
    has_routine = "\ndef main(" in code or re.search(_ROUTINE, code) is not None
    is_plain = has_routine and not ("*" in code and re.search(_STAR, code))
    return (is_plain or _is_made_of_rungs(code)) and _uses_own_words(code)


def _uses_own_words(code: str) -> bool:
    used: set[str] = set()
    made: set[str] = _BUILTINS.union(_MAKING.findall(code))
    for word, rest, bracket in set(_NAME.findall(code)):
        if word in _OWN_WORDS:
            is_own = word in BANK_WORDS and _is_cell(rest[1:], bracket) if rest else _is_own(word, bracket)
            (used if is_own else made).add(word)
    return bool(used - made) or ("sub" not in made and re.search(_SUB, code) is not None)


def _is_cell(rest: str, bracket: str) -> bool:
    """True for what stands behind the dot of ``c.Name``, also with a modifier behind it; not for a method."""
    nickname, dot, modifier = rest.partition(".")
    return modifier.startswith(("immediate", "as_")) if dot else bool(nickname) and not bracket


def _is_own(word: str, bracket: str) -> bool:
    return (bracket == "[" and word in BANK_WORDS) or (bracket == "(" and word in CALL_WORDS)


def _is_made_of_rungs(code: str) -> bool:
    """True when most statements are a rung's. It decides where there is no main or @sub, or an ``import *``."""
    indent = re.search(_FIRST_INDENT, code)
    inner: list[str] = re.findall(rf"^{indent[1]}(?=\S)(.*)", code, re.MULTILINE) if indent else []
    return len(inner) < 2 * sum(re.match(_RUNG, line) is not None for line in inner)


# -- what stands in a file --------------------------------------------------------------------------------------------

_MAIN = re.compile(r"^(?:async[ \t]+)?def[ \t]+main\b", re.MULTILINE)
_IMPORT = re.compile(r"^[ \t]*(?:from[ \t]+(?:\.[ \t]*)?(\w+)[ \t]+import\b|import[ \t]+([\w., \t]+))", re.MULTILINE)


def _modules(text: str) -> Iterator[str]:
    """The modules that a file imports, those without a dot."""
    for source, listed in _IMPORT.findall(text):
        for name in (source, *listed.split(",")):
            module = name.split()[0] if name.strip() else ""
            if module and "." not in module:
                yield module
