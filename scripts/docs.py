"""Write what comes from the code: the table of codes, instruction pages, problem pages and some tables of pages.

The tests fail while one of them is stale, missing or left over.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator
from pathlib import Path

from docs_instruction import MADE, instruction_page
from docs_markdown import bullets, quoted, table

from clickgen.commands.explain import explanation
from clickgen.device.banks import BANKS, UPPER_BYTE_BANKS
from clickgen.device.elsewhere import BANKS as FOREIGN_BANKS
from clickgen.device.system import WRITABLE_SC, WRITABLE_SD
from clickgen.dialects.if_rungs.trade import ACTIONS, CONDITIONS, FORMULAS, Advice
from clickgen.instructions import FAMILIES, control
from clickgen.instructions.spec import Spec
from clickgen.problems.codes import CODES, Severity, entry_of
from clickgen.problems.declared import Code
from clickgen.rules import registry

ROOT = Path(__file__).parents[1]
LANGUAGE = ROOT / "docs" / "language.md"
WORDS = ROOT / "docs" / "words-of-other-machines.md"
INSTRUCTIONS = ROOT / "docs" / "instructions"
PROBLEMS = ROOT / "docs" / "problems"
TABLE = ROOT / "clickgen" / "problems" / "table.py"
MATCHER = ROOT / ".github" / "clickgen-problem-matcher.json"
MADE_FOLDERS = (INSTRUCTIONS, PROBLEMS)
"""Folders that hold nothing else."""

_PART = re.compile(r"(<!-- made from the code: (\w+) -->\n).*?(<!-- end -->)", re.DOTALL)


def made() -> dict[Path, str]:
    """Every page that is made from the code, fully or in part, with the text that it should have."""
    pages = {INSTRUCTIONS / f"{spec.name}.md": instruction_page(spec) for _, specs in families() for spec in specs}
    pages[INSTRUCTIONS / "README.md"] = index()
    pages[MATCHER] = problem_matcher()
    pages[TABLE] = code_table()
    pages |= problem_pages()
    for page in (LANGUAGE, WORDS, PROBLEMS / "README.md"):
        text = page.read_text("utf-8")
        pages[page] = _PART.sub(lambda match: f"{match[1]}\n{PARTS[match[2]]()}\n\n{match[3]}", text)
    return pages


def codes() -> list[Code]:
    """Every code as its rule or its page declares it: the table of codes is made from these, and may be stale."""
    return [code for code, _ in registry.declarations().values()]


def problem_pages() -> dict[Path, str]:
    return {PROBLEMS / f"{code.name}.md": _with_origin(explanation(code)) for code in codes()}


def code_table() -> str:
    doc = (
        "Every code: severity, on or off, the rule that declares it, title. scripts/docs.py makes this from the rules."
    )
    return f'"""{doc}"""\n\nTABLE = """\\\n{registry.table()}\n"""\n'


def problem_matcher() -> str:
    """The patterns for GitHub to read the concise format, with the severity of each code."""
    words = {Severity.ERROR: ("errors", "error"), Severity.WARNING: ("warnings", "warning")}
    words[Severity.INFO] = ("notes", "notice")
    matchers = []
    for severity, (owner, word) in words.items():
        names = "|".join(code.name for code in codes() if code.severity is severity)
        pattern = rf"^(?:(.+?):(\d+):(\d+): )?({names})(?: \[\*\])? (\S.*)$"
        places = {"file": 1, "line": 2, "column": 3, "code": 4, "message": 5}
        matchers.append({"owner": f"clickgen-{owner}", "severity": word, "pattern": [{"regexp": pattern, **places}]})
    return json.dumps({"problemMatcher": matchers}, indent=2) + "\n"


def _with_origin(page: str) -> str:
    title, _, rest = page.partition("\n")
    return f"{title}\n\n{MADE}\n{rest}"


def stale() -> dict[Path, str | None]:
    """The pages that differ from the code, with the text that each should have; None for one that should not exist."""
    pages = made()
    changed = {path: text for path, text in pages.items() if not path.is_file() or path.read_text("utf-8") != text}
    there = [path for folder in MADE_FOLDERS for path in folder.glob("*")]
    return {**changed, **{path: None for path in there if path not in pages}}


def main() -> None:
    # The examples are built, perhaps by a rule that is new.
    CODES.update(map(entry_of, registry.table().splitlines()))
    for folder in MADE_FOLDERS:
        folder.mkdir(exist_ok=True)
    for path, text in sorted(stale().items()):
        print(path.relative_to(ROOT))
        if text is None:
            path.unlink()
        else:
            path.write_text(text, "utf-8")


def families() -> Iterator[tuple[str, tuple[Spec, ...]]]:
    """Each family of instructions by its title; return, for and pass are included, though nothing calls these."""
    for family in FAMILIES:
        title = re.split("[:(]", family.__doc__ or "")[0].strip()
        yield title, (*family.SPECS, control.RETURN, control.FOR, control.NOP) if family is control else family.SPECS


_READING = """\
Each instruction has a page. [The language](../language.md#instructions) describes how they work together.

You can give arguments by position or by name; if a table lists two names for one argument, both work. In the column
*Access*, *read* and *written* say what the instruction does to an address. *Owned* says that the number, with its bit
and its current value, belongs to this instruction alone. In SC and SD, only [some
addresses](../language.md#instructions) are writable.

The examples are in a rung that is always on, and their names have the addresses that a first build chooses. *In ladder
CSV* shows the output column of `main.csv`: the instruction, and below it the inputs of its box."""


def index() -> str:
    parts = ["# Instructions", MADE, _READING]
    for title, specs in families():
        rows = [(f"[{spec.name}]({spec.name}.md)", spec.summary) for spec in specs]
        parts += [f"## {title}", table(("Instruction", "What it does"), *rows)]
    return "\n\n".join(parts) + "\n"


# -- parts of the language page ---------------------------------------------------------------------------------------


def families_table() -> str:
    rows = [
        (title, ", ".join(f"[`{spec.name}`](instructions/{spec.name}.md)" for spec in specs))
        for title, specs in families()
    ]
    return table(("Family", "Instructions"), *rows)


def banks_table() -> str:
    rows = []
    for bank in BANKS.values():
        numbers = bank.describe_range() + (" and `0u`" if bank.name in UPPER_BYTE_BANKS else "")
        retentive = ("yes" if bank.retentive else "no") + (", fixed" if bank.settings_fixed else "")
        chosen = "yes" if bank.allocatable else "no"
        rows.append((quoted(bank.dsl), numbers, f"{bank.title}, {bank.kind.value}", retentive, chosen))
    return table(("Bank", "Addresses", "Holds", "Retentive", "clickgen chooses"), *rows)


def writable_points() -> str:
    points = {"SC": WRITABLE_SC, "SD": WRITABLE_SD}
    return bullets(f"{bank}: {', '.join(map(str, sorted(numbers)))}" for bank, numbers in points.items())


_GROUPS = {
    "CG1": "Syntax",
    "CG2": "Names and addresses",
    "CG3": "Operands and types",
    "CG4": "Structure and limits",
    "CG5": "Logic worth a second look",
    "CG6": "The address table",
}


def codes_table() -> str:
    parts = []
    for group, title in _GROUPS.items():
        rows = [
            (f"[{code.name}]({code.name}.md)", f"{code.severity.value}{'' if code.is_on else ', off'}", code.title)
            for code in codes()
            if code.name.startswith(group)
        ]
        parts += [f"## {title}", table(("Code", "Severity", "Title"), *rows)]
    return "\n\n".join(parts)


def trade_tables() -> str:
    """The words for conditions, actions and formulas elsewhere, with their equivalents here."""
    parts = []
    for title, words in (("As a condition", CONDITIONS), ("As an action", ACTIONS), ("In a formula", FORMULAS)):
        rows: dict[Advice, list[str]] = {}
        for word, advice in words.items():
            rows.setdefault(advice, []).append(quoted(word.upper() if len(word) < 5 else word))
        shown = [(", ".join(names), _quoting(advice)) for advice, names in rows.items()]
        parts += [f"## {title}", table(("Word", "Here"), *shown)]
    return "\n\n".join(parts)


def _quoting(advice: Advice) -> str:
    pieces = [quoted(code.replace("|", "\\|")) for code in advice.code]
    text = advice.text.format(*pieces)
    return text.removeprefix("write ")


def trade_banks() -> str:
    rows: dict[str, list[str]] = {}
    for word, bank in FOREIGN_BANKS.items():
        rows.setdefault(bank, []).append(quoted(word.upper() if len(word) < 4 else word))
    shown = [(", ".join(words), f"`{bank}`: {BANKS[bank.upper()].title}") for bank, words in rows.items()]
    return table(("Elsewhere", "Here"), *shown)


PARTS: dict[str, Callable[[], str]] = {
    "banks": banks_table,
    "writable": writable_points,
    "instructions": families_table,
    "codes": codes_table,
    "trade": trade_tables,
    "trade_banks": trade_banks,
}
"""The parts of hand-written pages by the words in their comments."""

if __name__ == "__main__":
    main()
