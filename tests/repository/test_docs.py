"""The pages for users are true: examples build, commands run, shown outputs and tables are the real ones.

An HTML comment on the line above a fenced block says what the block is, in words separated by commas:

    example: program      a whole program (any python block with ``def main`` is one without saying so)
    example: rung         rungs of main; ``end()`` is added
    example: actions      goes under a condition
    example: top          declarations or subroutines in front of a main
    example: table        a csv block: an address table
    example: api          Python that uses clickgen, run in the page's folder
    example: settings     a toml block: settings that can be read
    example: rule         an example of a rule about logic, tested with the rule
    example: spec         an instruction's Spec, which the next examples of the page may use
    file: NAME            a file of the page's folder, and a program
    ..., part             not a program but a file that the next programs of the page import
    output: PATH          lines of this file of the page's folder
    tokens                the ladder of the example above, in a page that is made from the code
    ..., gives CG104      the problems that an example has; without it it has none
    ..., frozen           built without choosing addresses
    exit N                on a console block: the exit code of its last command, 0 if nothing is said

``scripts/docs.py`` writes the parts that come from the code.
"""

from __future__ import annotations

import gc
import re
import shlex
import textwrap
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

import pytest
from docs_examples import KINDS, program_of
from docs_markdown import anchor

import clickgen
import docs
from clickgen.cli import COULD_NOT_RUN, OK, PROBLEMS, main
from clickgen.config import read_config
from clickgen.instructions import INSTRUCTIONS
from clickgen.instructions.spec import Spec
from clickgen.problems.codes import CODES

ROOT = docs.ROOT
PAGES = [ROOT / "README.md", ROOT / "CHANGELOG.md", *sorted((ROOT / "docs").rglob("*.md"))]
PROBLEM_PAGES = ROOT / "docs" / "problems"

# -- reading a page ---------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Block:
    """A fenced block and what the comment above it says."""

    page: Path
    line: int
    language: str
    text: str
    notes: tuple[tuple[str, str], ...]

    def note(self, name: str) -> str:
        return dict(self.notes).get(name, "")

    @property
    def kind(self) -> str:
        if self.note("file"):
            return "part" if self.note("part") else "program"
        return self.note("example") or ("program" if self.language == "python" and "def main" in self.text else "")

    @property
    def codes(self) -> list[str]:
        return sorted(self.note("gives").split())

    def __str__(self) -> str:
        return f"{self.page.relative_to(ROOT).as_posix()}:{self.line}"


_FENCE = re.compile(r"^( *)```(\w*)$")
_NOTES = re.compile(r"^ *<!-- (.*) -->$")
_WORDS = ("example", "file", "part", "output", "tokens", "gives", "exit", "frozen")


def blocks_of(page: Path) -> Iterator[Block]:
    lines = page.read_text("utf-8").split("\n")
    index = 0
    while index < len(lines):
        opening = _FENCE.match(lines[index])
        if not opening:
            index += 1
            continue
        end = next(n for n in range(index + 1, len(lines)) if lines[n].strip() == "```")
        above = _NOTES.match(lines[index - 1]) if index else None
        body = textwrap.dedent("\n".join(lines[index + 1 : end])) + "\n"
        yield Block(page, index + 1, opening[2], body, tuple(_notes(above[1])) if above else ())
        index = end + 1


def _notes(text: str) -> Iterator[tuple[str, str]]:
    for part in text.split(","):
        name, _, value = part.strip().replace(":", "", 1).partition(" ")
        assert name in _WORDS, f"{name!r} is no word of these comments"
        yield name, value.strip() or "yes"


BLOCKS = [block for page in PAGES for block in blocks_of(page)]
EXAMPLES = [block for block in BLOCKS if block.kind in KINDS]

# -- examples ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("block", EXAMPLES, ids=str)
def test_an_example_builds_or_has_the_problems_that_are_said(
    block: Block, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for earlier in blocks_of(block.page):
        if earlier.line > block.line:
            break
        if earlier.kind == "spec":
            for spec in _specs_of(earlier):
                monkeypatch.setitem(INSTRUCTIONS, spec.name, spec)
        elif earlier.kind == "part":
            (tmp_path / Path(earlier.note("file")).name).write_text(earlier.text, "utf-8")
    program = tmp_path / "prog.py"
    program.write_text(program_of(block.kind, block.text), "utf-8")
    if block.kind == "table":
        (tmp_path / "nicknames.csv").write_text(block.text, "utf-8")
    result = clickgen.build(program, frozen=block.note("frozen") == "yes")
    found = sorted({problem.code for problem in result.diagnostics})
    assert found == block.codes, "\n".join(f"{p.code} {p.span}: {p.message}" for p in result.diagnostics)


def _specs_of(block: Block) -> list[Spec]:
    module = ModuleType("shown")
    exec(compile(block.text, str(block), "exec"), module.__dict__)
    return [value for value in vars(module).values() if isinstance(value, Spec)]


def test_every_python_block_is_tested() -> None:
    known = (*KINDS, "part", "api", "spec", "rule")
    assert [str(block) for block in BLOCKS if block.language == "python" and block.kind not in known] == []


def test_every_shown_output_is_compared() -> None:
    known = ("output", "tokens")
    shown = [block for block in BLOCKS if block.language in ("text", "csv", "json", "xml") and not block.kind]
    assert [str(block) for block in shown if not any(map(block.note, known))] == []
    # The pages about CI, with their yaml, have tests of their own.
    tested = ("python", "console", "text", "csv", "json", "xml", "toml", "yaml")
    assert [str(block) for block in BLOCKS if block.language not in tested] == []


@pytest.mark.parametrize("block", [block for block in BLOCKS if block.language == "toml"], ids=str)
def test_shown_settings_can_be_read(block: Block, tmp_path: Path) -> None:
    path = tmp_path / "clickgen.toml"
    path.write_text(block.text, "utf-8")
    assert read_config(path).programs


# -- files, commands and outputs of a page ----------------------------------------------------------------------------


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_what_a_page_does_gives_what_it_shows(
    page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    for block in blocks_of(page):
        if block.note("file"):
            path = tmp_path / block.note("file")
            path.parent.mkdir(exist_ok=True)
            path.write_text(block.text, "utf-8")
        elif block.language == "console":
            _run_commands(block, capfd)
        elif block.note("output"):
            shown = (tmp_path / block.note("output")).read_text("utf-8")
            assert f"\n{block.text}" in f"\n{shown}", f"{block}: {block.note('output')} holds\n{shown}"
        elif block.kind == "api":
            exec(compile(block.text, str(block), "exec"), {"__name__": "shown"})


def _run_commands(block: Block, capfd: pytest.CaptureFixture[str]) -> None:
    """Run the ``$ clickgen`` lines; the text after one is all of its output, unless there is none."""
    commands: list[tuple[str, list[str]]] = []
    for line in block.text.rstrip("\n").split("\n"):
        if line.startswith("$ "):
            commands.append((line[2:], []))
        else:
            commands[-1][1].append(line)
    for number, (command, said) in enumerate(commands, 1):
        words = shlex.split(command)
        if words[0] != "clickgen":
            assert words[0] in ("make", "pip", "git"), f"{block}: {command} is not run by this test"
            continue
        code = _code_of(words[1:])
        out, err = capfd.readouterr()
        expected = int(block.note("exit") or 0) if number == len(commands) else 0
        assert code == expected, f"{block}: {command}\n{err}"
        if said:
            assert (err + out).replace("\\", "/").rstrip().split("\n") == said, f"{block}: {command}"


def _code_of(arguments: list[str]) -> int:
    """The exit code of a command line, run in this process."""
    try:
        return main(arguments)
    except SystemExit as stop:
        return int(str(stop.code or 0))
    finally:
        gc.enable()  # the command line turns it off


def test_commands_stand_in_console_blocks() -> None:
    """Only there are they run."""
    loose = [
        str(block)
        for block in BLOCKS
        if block.language != "console" and re.search(r"^\s*(\$ )?clickgen (build|--)", block.text, re.MULTILINE)
    ]
    assert loose == []


def test_the_readme_has_the_flags_and_exit_codes_of_build(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert _code_of(["build", "--help"]) == OK
    help = capsys.readouterr().out
    readme = (ROOT / "README.md").read_text("utf-8")
    flags = set(re.findall(r"(?<![\w-])--?[a-z]+", help)) - {"-h", "--help"}
    rows = "\n".join(line for line in readme.split("\n") if line.startswith("| `-"))
    assert set(re.findall(r"(?<![\w-])--?[a-z]+", rows)) == flags
    shown = re.findall(r"^\| (\d) \| ", readme, re.MULTILINE)
    assert [int(code) for code in shown] == [OK, PROBLEMS, COULD_NOT_RUN]
    for words in (["build", "missing.py"], ["build", "--wrong"], []):
        assert _code_of(words) == COULD_NOT_RUN


# -- links ------------------------------------------------------------------------------------------------------------

_LINK = re.compile(r"\]\(([^)\s]+)\)")
_HEADING = re.compile(r"^#+ (.+)$", re.MULTILINE)


def _prose(page: Path) -> str:
    return re.sub(r"^ *```.*?^ *```$", "", page.read_text("utf-8"), flags=re.DOTALL | re.MULTILINE)


def _anchors(page: Path) -> set[str]:
    return set(map(anchor, _HEADING.findall(_prose(page))))


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_relative_links_resolve(page: Path) -> None:
    for link in _LINK.findall(_prose(page)):
        if "://" in link:
            continue
        path, _, anchor = link.partition("#")
        target = (page.parent / path).resolve() if path else page
        assert target.exists(), f"{page.name}: {link}"
        assert not anchor or anchor in _anchors(target), f"{page.name}: {link}"


def test_source_files_that_pages_name_exist() -> None:
    for page in PAGES:
        for name in re.findall(r"`((?:clickgen|tests|scripts|grammar|fixtures)/[\w./]*\w/?)`", _prose(page)):
            assert (ROOT / name).exists(), f"{page.name}: {name}"


# -- codes ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("code", [code for code in CODES if not code.startswith("CG5")])
def test_an_example_of_a_problem_gives_it(code: str) -> None:
    """Those of the rules about logic are tested with the rules."""
    blocks = list(blocks_of(PROBLEM_PAGES / f"{code}.md"))
    assert all(code in block.codes for block in blocks if block.codes), code


# -- what is made from the code ---------------------------------------------------------------------------------------


def test_what_is_made_from_the_code_is_up_to_date() -> None:
    assert [str(path.relative_to(ROOT)) for path in docs.stale()] == [], "run: make docs"


def test_a_page_that_is_changed_missing_or_left_over_is_stale(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(docs, "made", lambda: {tmp_path / name: name for name in ("a.md", "b.md", "c.md")})
    monkeypatch.setattr(docs, "MADE_FOLDERS", (tmp_path,))
    for name, text in (("a.md", "a.md"), ("b.md", "changed"), ("d.md", "d.md")):
        (tmp_path / name).write_text(text, "utf-8")
    assert docs.stale() == {tmp_path / "b.md": "b.md", tmp_path / "c.md": "c.md", tmp_path / "d.md": None}


def test_every_made_part_has_its_place() -> None:
    shown = [
        name for page in PAGES for name in re.findall(r"<!-- made from the code: (\w+) -->", page.read_text("utf-8"))
    ]
    assert sorted(shown) == sorted(docs.PARTS)
