"""The pages for users say what is so: examples build, commands run, shown outputs and tables are the real ones.

What a fenced block is, an HTML comment on the line above it says, in words separated by commas:

    example: program      a whole program (any python block with ``def main`` is one without saying so)
    example: rung         rungs of main; ``end()`` is added
    example: actions      what stands under a condition
    example: top          declarations or subroutines in front of a main
    example: table        a csv block: an address table
    example: api          Python that uses clickgen, run in the page's folder
    example: spec         an instruction's Spec, which the next examples of the page may use
    file: NAME            a file of the page's folder, and a program
    output: PATH          lines that stand in this file of the page's folder
    ..., gives CG104      the problems that an example has; without it it has none
    ..., frozen           built without choosing addresses
    exit N                on a console block: the exit code of its last command, 0 when nothing is said

``python tests/test_docs.py`` writes the parts that are made from the code anew.
"""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
import textwrap
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

import pytest

import clickgen
from clickgen.cli import COULD_NOT_RUN, OK, PROBLEMS
from clickgen.codes import CODES, Severity
from clickgen.device.banks import BANKS
from clickgen.device.system import WRITABLE_SC, WRITABLE_SD
from clickgen.instructions import FAMILIES, INSTRUCTIONS, control, timers
from clickgen.instructions.spec import REQUIRED, Param, ParamKind, Spec

ROOT = Path(__file__).parents[1]
PAGES = [ROOT / "README.md", ROOT / "CHANGELOG.md", *sorted((ROOT / "docs").glob("*.md"))]
LANGUAGE = ROOT / "docs" / "language.md"
PROBLEMS_PAGE = ROOT / "docs" / "problems.md"

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
            return "program"
        return self.note("example") or ("program" if self.language == "python" and "def main" in self.text else "")

    @property
    def codes(self) -> list[str]:
        return sorted(self.note("gives").split())

    def __str__(self) -> str:
        return f"{self.page.name}:{self.line}"


_FENCE = re.compile(r"^( *)```(\w*)$")
_NOTES = re.compile(r"^ *<!-- (.*) -->$")
_WORDS = ("example", "file", "output", "gives", "exit", "frozen")


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
EXAMPLES = [block for block in BLOCKS if block.kind in ("program", "rung", "actions", "top", "table")]

# -- examples ---------------------------------------------------------------------------------------------------------

_END = "    if True:\n        end()\n"
_WRAPPERS = {
    "program": "{}",
    "rung": "def main():\n{}\n" + _END,
    "actions": "def main():\n    if c.Rung:\n{}\n" + _END,
    "top": "{}\n\ndef main():\n" + _END,
    "table": "def main():\n" + _END,
}
_INDENTS = {"rung": 4, "actions": 8}


def program_of(block: Block) -> str:
    return _WRAPPERS[block.kind].format(textwrap.indent(block.text, " " * _INDENTS.get(block.kind, 0)))


@pytest.mark.parametrize("block", EXAMPLES, ids=str)
def test_an_example_builds_or_has_the_problems_that_are_said(
    block: Block, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for earlier in blocks_of(block.page):
        if earlier.kind == "spec" and earlier.line < block.line:
            for spec in _specs_of(earlier):
                monkeypatch.setitem(INSTRUCTIONS, spec.name, spec)
    program = tmp_path / "prog.py"
    program.write_text(program_of(block), "utf-8")
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
    known = ("program", "rung", "actions", "top", "api", "spec")
    assert [str(block) for block in BLOCKS if block.language == "python" and block.kind not in known] == []


def test_every_shown_output_is_compared() -> None:
    assert [str(b) for b in BLOCKS if b.language in ("text", "csv") and not b.note("output") and not b.kind] == []
    assert [str(b) for b in BLOCKS if b.language not in ("python", "console", "text", "csv")] == []


# -- files, commands and outputs of a page ----------------------------------------------------------------------------


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_what_a_page_does_gives_what_it_shows(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for block in blocks_of(page):
        if block.note("file"):
            (tmp_path / block.note("file")).write_text(block.text, "utf-8")
        elif block.language == "console":
            _run_commands(block, tmp_path)
        elif block.note("output"):
            shown = (tmp_path / block.note("output")).read_text("utf-8")
            assert f"\n{block.text}" in f"\n{shown}", f"{block}: {block.note('output')} holds\n{shown}"
        elif block.kind == "api":
            exec(compile(block.text, str(block), "exec"), {"__name__": "shown"})


def _run_commands(block: Block, folder: Path) -> None:
    """Runs the ``$ clickgen`` lines; what follows one is all that it says, unless nothing follows."""
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
        done = subprocess.run(
            [sys.executable, "-m", *words], cwd=folder, capture_output=True, encoding="utf-8", check=False
        )
        expected = int(block.note("exit") or 0) if number == len(commands) else 0
        assert done.returncode == expected, f"{block}: {command}\n{done.stderr}"
        if said:
            assert (done.stderr + done.stdout).replace("\\", "/").rstrip().split("\n") == said, f"{block}: {command}"


def test_commands_stand_in_console_blocks() -> None:
    """Only there are they run."""
    loose = [
        str(block)
        for block in BLOCKS
        if block.language != "console" and re.search(r"^\s*(\$ )?clickgen (build|--)", block.text, re.MULTILINE)
    ]
    assert loose == []


def test_the_readme_has_the_flags_and_exit_codes_of_build(tmp_path: Path) -> None:
    help = subprocess.run(
        [sys.executable, "-m", "clickgen", "build", "--help"], capture_output=True, encoding="utf-8", check=True
    ).stdout
    readme = (ROOT / "README.md").read_text("utf-8")
    flags = set(re.findall(r"(?<![\w-])--?[a-z]+", help)) - {"-h", "--help"}
    rows = "\n".join(line for line in readme.split("\n") if line.startswith("| `-"))
    assert set(re.findall(r"(?<![\w-])--?[a-z]+", rows)) == flags
    shown = re.findall(r"^\| (\d) \| ", readme, re.MULTILINE)
    assert [int(code) for code in shown] == [OK, PROBLEMS, COULD_NOT_RUN]
    for words in (["build", "missing.py"], ["build", "--wrong"], []):
        done = subprocess.run(
            [sys.executable, "-m", "clickgen", *words], cwd=tmp_path, capture_output=True, check=False
        )
        assert done.returncode == COULD_NOT_RUN


# -- links ------------------------------------------------------------------------------------------------------------

_LINK = re.compile(r"\]\(([^)\s]+)\)")
_HEADING = re.compile(r"^#+ (.+)$", re.MULTILINE)


def _prose(page: Path) -> str:
    return re.sub(r"^ *```.*?^ *```$", "", page.read_text("utf-8"), flags=re.DOTALL | re.MULTILINE)


def _anchors(page: Path) -> set[str]:
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in _HEADING.findall(_prose(page))}


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

_CODE_HEADING = re.compile(r"^### (CG\d{3}): (.+)\n\n\*\*(\w+)\.\*\* ", re.MULTILINE)


def test_the_problems_page_has_every_code() -> None:
    words = {Severity.ERROR: "Error", Severity.WARNING: "Warning", Severity.INFO: "Note"}
    shown = [match.groups() for match in _CODE_HEADING.finditer(PROBLEMS_PAGE.read_text("utf-8"))]
    assert shown == [(name, code.title, words[code.severity]) for name, code in CODES.items()]


def test_an_example_in_the_problems_page_gives_the_problem_of_its_heading() -> None:
    text = PROBLEMS_PAGE.read_text("utf-8").split("\n")
    for block in blocks_of(PROBLEMS_PAGE):
        heading = next(line for line in reversed(text[: block.line]) if line.startswith("### "))
        assert not block.codes or heading[4:9] in block.codes, str(block)


# -- parts made from the code -----------------------------------------------------------------------------------------


def _listed(words: list[str], joiner: str = "or") -> str:
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} {joiner} {words[-1]}"


def banks_table() -> str:
    rows = ["| Bank | Addresses | Holds | Retentive | clickgen chooses |", "|---|---|---|---|---|"]
    for bank in BANKS.values():
        numbers = bank.describe_range() + (" and `0u`" if bank.name in ("XD", "YD") else "")
        retentive = ("yes" if bank.retentive else "no") + (", fixed" if bank.settings_fixed else "")
        held = f"{bank.title}, {bank.kind.value}"
        rows.append(f"| `{bank.dsl}` | {numbers} | {held} | {retentive} | {'yes' if bank.allocatable else 'no'} |")
    return "\n".join(rows)


def writable_points() -> str:
    def numbers(some: frozenset[int]) -> str:
        return ", ".join(map(str, sorted(some)))

    return f"- SC: {numbers(WRITABLE_SC)}\n- SD: {numbers(WRITABLE_SD)}"


def instruction_reference() -> str:
    parts: list[str] = []
    for family in FAMILIES:
        title = re.split(r"[:(]", family.__doc__ or "")[0].strip()
        parts.append(f"### {title}")
        parts += [_instruction(spec) for spec in family.SPECS]
    return "\n\n".join(parts)


def _instruction(spec: Spec) -> str:
    lines = [f"#### `{spec.signature}`", "", spec.summary, ""]
    if spec.params:
        lines += ["| Argument | Takes |", "|---|---|", *(_argument(spec, param) for param in spec.params), ""]
    lines += _matrix(spec)
    lines += [f"{note}\n" for note in spec.notes]
    lines.append(f"Takes {spec.height} grid row{'s' * (spec.height > 1)}.{_own_rung(spec)}")
    if spec not in control.SPECS:
        codes = ["CG420"] * (spec is timers.RTOF) + ["CG210"] * bool(re.search(r"\b[xy]\.", spec.example))
        gives = f", gives {' '.join(codes)}" if codes else ""
        lines += ["", f"<!-- example: actions{gives} -->", "```python", spec.example, "```"]
    return "\n".join(lines)


_FORMS = {"integer": "integer", "hex": "hexadecimal word", "real": "floating-point number", "code": "character code"}


def _matrix(spec: Spec) -> list[str]:
    """The pairs that a copy copies between."""
    pairs = [pair for variant in spec.variants for pair in variant.pairs]
    if not pairs:
        return []
    has_lengths = any(pair.lengths for pair in pairs)
    lines = ["| From | To |", "|---|---|"] if not has_lengths else ["| From | To | Addresses |", "|---|---|---|"]
    for pair in pairs:
        sources, targets = (", ".join(_FORMS.get(form, form) for form in some) for some in (pair.sources, pair.targets))
        row = f"| {sources} | {targets}{' (sources disagree: CG312)' if pair.disputed else ''} |"
        low, high = pair.lengths or (0, 0)
        length = "any" if not high else str(low) if low == high else f"{low} to {high}"
        lines.append(f"{row} {length} |" if has_lengths else row)
    return [*lines, ""]


def _own_rung(spec: Spec) -> str:
    return " It gets a CLICK rung of its own." if spec.pins or spec.alone else ""


def _argument(spec: Spec, param: Param) -> str:
    takes = param.slot.describe() if param.kind is ParamKind.OPERAND else param.kind.value
    if param.name in spec.matrix:
        slot = param.slot
        forms = {
            "an address": slot.cells,
            "a range": slot.ranges,
            "a pointer": slot.pointers,
            "a constant": slot.constants,
        }
        takes = _listed([form for form, banks in forms.items() if banks]) + ", see below"
    if param.kind is ParamKind.FORMULA:
        takes = "a formula in quotes"
    if param.kind is ParamKind.OPTIONS:
        takes = _listed([f"`{name}`" for name in spec.conversions]) if spec.conversions else "nothing: it converts none"
    if param.kind is ParamKind.PIN:
        takes = "a condition behind `lambda:`"
    if param.missing_pin:
        takes += f"; left out, the input gets `~SC1`, with the warning {param.missing_pin}"
    elif param.default is not REQUIRED and param.kind is not ParamKind.OPTIONS:
        takes += f"; {param.default} when left out"
    if param.extends_over:
        takes += f"; one address is enough, the length comes from `{param.extends_over}`"
    names = " or ".join(f"`{name}`" for name in (param.name, *param.aliases))
    return f"| {names} | {takes} |"


MADE = {"banks": banks_table, "writable": writable_points, "instructions": instruction_reference}
_MADE = re.compile(r"(<!-- made from the code: (\w+) -->\n).*?(<!-- end -->)", re.DOTALL)


def _remade(text: str) -> str:
    return _MADE.sub(lambda match: f"{match[1]}\n{MADE[match[2]]()}\n\n{match[3]}", text)


def test_the_parts_made_from_the_code_are_up_to_date() -> None:
    text = LANGUAGE.read_text("utf-8")
    assert {match[1] for match in _MADE.findall(text)} == set(MADE)
    assert text == _remade(text), "run: python tests/test_docs.py"


def test_the_language_page_shows_every_signature() -> None:
    shown = re.findall(r"^#### `(.+)`$", LANGUAGE.read_text("utf-8"), re.MULTILINE)
    assert shown == [spec.signature for spec in INSTRUCTIONS.values()]


if __name__ == "__main__":
    LANGUAGE.write_text(_remade(LANGUAGE.read_text("utf-8")), "utf-8")
