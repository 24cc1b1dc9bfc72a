"""Editors: pyright accepts programs that build, and finds mistakes at their places."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path

import pytest
from docs_examples import examples, program_of
from test_docs import EXAMPLES
from typed_programs import KNOWN, MISTAKEN_ACTIONS, MISTAKEN_CONDITIONS, MISTAKEN_LOOPS, MISTAKEN_TOP, MORE

import clickgen
from clickgen.api import known_names
from clickgen.commands.stubs.stub import builtins_stub
from clickgen.device.banks import Address
from clickgen.instructions import INSTRUCTIONS
from clickgen.results import KnownNames
from clickgen.table.rows import default_row

ROOT = Path(__file__).parents[3]
CASES = sorted((ROOT / "fixtures" / "cases").iterdir())
STUB = "__builtins__.pyi"

# -- pyright ----------------------------------------------------------------------------------------------------------

Finding = tuple[str, int, str, str]
"""File, line, rule and message."""


def pyright(folder: Path, mode: str = "standard", **settings: object) -> list[Finding]:
    """The findings of basedpyright for a project, in an environment that has clickgen."""
    (folder / "pyrightconfig.json").write_text(json.dumps({"typeCheckingMode": mode, **settings}))
    command = [sys.executable, "-m", "basedpyright", "--outputjson", "--pythonpath", sys.executable]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, encoding="utf-8")
    report = json.loads(done.stdout)
    assert report["summary"]["filesAnalyzed"]
    return [
        (
            Path(found["file"]).resolve().relative_to(folder.resolve()).as_posix(),
            found["range"]["start"]["line"] + 1,
            found.get("rule", ""),
            found["message"],
        )
        for found in report["generalDiagnostics"]
    ]


@pytest.fixture(scope="module")
def findings(tmp_path_factory: pytest.TempPathFactory) -> dict[str, list[Finding]]:
    """The findings of pyright for the folders of this module, in one run: its start takes most of its time."""
    parts = {
        "clean": write_what_builds,
        "stubs": write_stubs_below_each_other,
        "mistakes": write_mistakes,
        "imports": write_importing,
    }
    root = tmp_path_factory.mktemp("project")
    for name, write in parts.items():
        (root / name).mkdir()
        write(root / name)
    found: dict[str, list[Finding]] = {name: [] for name in parts}
    for file, line, rule, message in pyright(root):
        name, _, path = file.partition("/")
        found[name].append((path, line, rule, message))
    return found


def write_stub(folder: Path, names: Iterable[KnownNames]) -> None:
    found = list(names)
    rows = [row for known in found for row in known.rows]
    stub = builtins_stub(rows, [block for known in found for block in known.blocks])
    (folder / STUB).write_text(stub, "utf-8")


def folder_of(parent: Path, name: str, programs: dict[str, str]) -> Path:
    """A folder with programs and the stub file that all of them share."""
    folder = parent / name
    folder.mkdir()
    for file, text in programs.items():
        (folder / file).write_text(text, "utf-8")
    write_stub(folder, (known_names(folder / file) for file in programs))
    return folder


# -- programs without mistakes ----------------------------------------------------------------------------------------

UNTYPED = {
    ("cases/editor_import.py", "reportWildcardImportFromLibrary"): "pyright likes no import * from what is installed",
    ("several_files/prog.py", "reportWildcardImportFromLibrary"): "the same",
    ("several_files/filling.py", "reportAttributeAccessIssue"): "a subroutine that no program imports has no addresses",
}
"""The findings of pyright for programs that clickgen builds, and their reasons."""


def write_what_builds(root: Path) -> None:
    programs: dict[str, str] = {f"{case.name}.py": (case / "prog.py").read_text("utf-8") for case in CASES}
    for number, text in enumerate(_shown_programs()):
        programs[f"page{number}.py"] = text
    for name in ("several_files", "subroutine_names"):
        (several := root / name).mkdir()
        for source in (ROOT / "fixtures" / "cases" / name).glob("*.py"):
            (several / source.name).write_bytes(source.read_bytes())
        programs.pop(f"{name}.py")
        write_stub(several, [known_names(several / "prog.py")])
    folder = folder_of(root, "cases", programs)
    folder_of(root, "demo", {"prog.py": (CASES[0].parent / "demo" / "prog.py").read_text("utf-8")})
    folder_of(root, "more", {"prog.py": MORE})
    write_stub(folder, [*map(_names_of_case, CASES), *(known_names(folder / name) for name in programs)])


def test_what_builds_is_clean(findings: dict[str, list[Finding]]) -> None:
    found = findings["clean"]
    assert [finding for finding in found if (finding[0], finding[2]) not in UNTYPED] == []
    assert {(file, rule) for file, _, rule, _ in found} == {*UNTYPED}


def _names_of_case(case: Path) -> KnownNames:
    """The names of a case, from the table beside it if it has one."""
    return known_names(case / "prog.py")


def _shown_programs() -> Iterator[str]:
    """The programs of the pages, and each instruction's example in all forms."""
    for block in EXAMPLES:
        if block.kind != "table" and not block.codes and "import" not in block.text and "copy_words" not in block.text:
            yield program_of(block.kind, block.text)
    for spec in INSTRUCTIONS.values():
        kind, forms = examples(spec)
        yield from (program_of(kind, form) for form in forms)


def test_the_programs_with_more_forms_build(tmp_path: Path) -> None:
    (tmp_path / "prog.py").write_text(MORE)
    assert [str(problem) for problem in clickgen.build(tmp_path / "prog.py").diagnostics if problem.is_error] == []


def test_a_program_is_clean_in_the_default_mode_of_basedpyright(tmp_path: Path) -> None:
    """Its own mode warns if a box with inputs is not assigned to anything, and of CLICK's names with their _."""
    folder_of(tmp_path, "demo", {"prog.py": (ROOT / "fixtures/cases/demo/prog.py").read_text("utf-8")})
    rules = {rule for _, _, rule, _ in pyright(tmp_path, "recommended")}
    assert rules <= {"reportUnusedCallResult", "reportPrivateUsage"}


# -- where pyright looks ----------------------------------------------------------------------------------------------

PYTHON = "names: set[str] = set(word for word in ['a'] if all(letter == 'a' for letter in word))\n"
ONE = "def main():\n    if c.One:\n        out(y[1])\n    if c.Wrong:\n        end()\n"
TWO = ONE.replace("One", "Two")


def write_stubs_below_each_other(root: Path) -> None:
    for path, text, name in (("line-1", ONE, "One"), ("line-2", TWO, "Two"), ("line-2/deep", ONE, "One")):
        (root / path).mkdir()
        (root / path / "prog.py").write_text(text)
        (root / path / STUB).write_text(builtins_stub([default_row(Address("C", 1), name)]))
    (root / "line-1" / "below").mkdir()
    (root / "line-1" / "below" / "prog.py").write_text(ONE)
    (root / "tool.py").write_text(PYTHON)


def test_a_stub_holds_in_its_folder_and_below_it(findings: dict[str, list[Finding]]) -> None:
    wrong = {(file, 4) for file in ("line-1/prog.py", "line-2/prog.py", "line-2/deep/prog.py", "line-1/below/prog.py")}
    assert {finding[:2] for finding in findings["stubs"]} == wrong


def test_a_stub_in_the_root_holds_everywhere_but_in_roots_of_their_own(tmp_path: Path) -> None:
    for folder, text, name in ((tmp_path, ONE, "One"), (tmp_path / "line", TWO, "Two")):
        folder.mkdir(exist_ok=True)
        (folder / "prog.py").write_text(text)
        (folder / STUB).write_text(builtins_stub([default_row(Address("C", 1), name)]))
    assert {finding[:2] for finding in pyright(tmp_path)} == {("prog.py", 4), ("line/prog.py", 2), ("line/prog.py", 4)}
    found = pyright(tmp_path, executionEnvironments=[{"root": "line"}])
    assert {finding[:2] for finding in found} == {("prog.py", 4), ("line/prog.py", 4)}


# -- mistakes ---------------------------------------------------------------------------------------------------------


@cache
def mistaken_program() -> tuple[str, dict[int, str]]:
    """A program full of mistakes, and the mistake of each line that has one."""
    lines = [*KNOWN.splitlines(), "def main():", "    if x.Start:"]
    wrong: dict[int, str] = {}

    def add(indent: int, texts: Iterable[str], head: str = "", *more: str) -> None:
        for text in texts:
            lines.append(" " * indent + head + text + (":" if head else ""))
            wrong[len(lines)] = text
            lines.extend(more)

    add(8, MISTAKEN_ACTIONS)
    add(8, MISTAKEN_LOOPS, "for _ in ", "            pass")
    add(4, MISTAKEN_CONDITIONS, "if ", "        out(y.Motor)")
    lines += ["    if True:", "        end()", ""]
    add(0, MISTAKEN_TOP)
    return "\n".join(lines) + "\n", wrong


def write_mistakes(root: Path) -> None:
    (folder := root / "plc").mkdir()
    (folder / "known.py").write_text(KNOWN)
    write_stub(folder, [known_names(folder / "known.py")])
    (folder / "prog.py").write_text(mistaken_program()[0])


def test_mistakes_are_reported_where_they_stand(findings: dict[str, list[Finding]]) -> None:
    _, wrong = mistaken_program()
    found = {line: message for _, line, _, message in findings["mistakes"]}

    assert [text for line, text in wrong.items() if line not in found] == []
    assert {line: message for line, message in found.items() if line not in wrong} == {}
    assert len(wrong) >= 25


def test_clickgen_refuses_these_mistakes_too(tmp_path: Path) -> None:
    """So the table above holds nothing that the language allows; a new name by itself would get an address."""
    program = tmp_path / "prog.py"
    new_names = {"out(y.Moter)", "c.Runn"}
    for text in (*MISTAKEN_ACTIONS, *MISTAKEN_CONDITIONS):
        body = f"if x.Start:\n        {text}" if text in MISTAKEN_ACTIONS else f"if {text}:\n        out(y.Motor)"
        program.write_text(
            f"{KNOWN}def main():\n    {body}\n    if True:\n        end()\n".replace("\ndef plain", "\n@sub\ndef plain")
        )
        refused = any(problem.is_error for problem in clickgen.build(program).diagnostics)
        assert refused != (text in new_names or text == "call(plain)"), text


# -- clickgen.dsl ------------------------------------------------------------------------------------------------------

IMPORTING = """\
from clickgen.dsl import all, c, copy, copy_fill, ds, end, nickname, out, sub, y

nickname(ds.Recipe, ds[1:9])


@sub
def wash():
    if c.Anything:
        copy_fill(0, ds.Recipe)


def main():
    if all(c.Start, ds.Speed > 5):
        out(y.Motor)
        copy(ds.Recipe[3], ds.Speed)
        out(ds.Speed)
        ton(ds.Speed)
    if True:
        end()
"""


def write_importing(root: Path) -> None:
    (root / "prog.py").write_text(IMPORTING)


def test_a_program_that_imports_has_types_and_any_name(findings: dict[str, list[Finding]]) -> None:
    assert [(line, rule) for _, line, rule, _ in findings["imports"]] == [
        (16, "reportArgumentType"),
        (17, "reportUndefinedVariable"),
    ]
