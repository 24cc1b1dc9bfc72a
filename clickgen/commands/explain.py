"""The meaning of a code, as Markdown: of a rule about logic from the rule, of any other from its own file.

Also, from the pages of the documentation, an instruction and a part of the language.
"""

from __future__ import annotations

import re
import textwrap
from pathlib import Path

from clickgen.problems.codes import CODES, Severity

_FOLDER = Path(__file__).parents[1] / "problems" / "explanations"
_WORDS = {Severity.ERROR: "Error", Severity.WARNING: "Warning", Severity.INFO: "Note"}


def explanation(code: str) -> str:
    """Return the page of a code: title, severity, why it matters, examples. Raises KeyError for an unknown code."""
    entry = CODES[code]
    word = _WORDS[entry.severity] + ("" if entry.is_on else ", off by default")
    path = _FOLDER / f"{code}.md"
    body = path.read_text("utf-8") if path.is_file() else _of_rule(code)
    return f"# {code}: {entry.title}\n\n**{word}.** {body.strip()}\n"


def _of_rule(code: str) -> str:
    from clickgen.rules.advice import RULES

    rule = next(rule for rule in RULES if rule.code == code)
    parts = [rule.why.strip()]
    for number, example in enumerate(rule.wrong):
        parts += ["" if number else "Found in the lines that `# <-` marks:", _block(example.text)]
        if example.fixed:
            parts += ["`--fix` makes of it:", _block(example.fixed)]
    parts.append("Not found:")
    parts += [_block(example) for example in rule.right]
    return "\n\n".join(part for part in parts if part)


def _block(text: str) -> str:
    body = text.strip("\n")
    return f"<!-- example: rule -->\n```python\n{body}\n```"


def documentation() -> Path:
    """The folder of the pages: package data in a wheel, a folder beside the package in a checkout."""
    inside = Path(__file__).parents[1] / "docs"
    return inside if inside.is_dir() else Path(__file__).parents[2] / "docs"


def instruction_page(name: str) -> str:
    """Return the page of an instruction, by its name. Raises KeyError if there is none."""
    if name not in instructions():
        raise KeyError(name)
    text = (documentation() / "instructions" / f"{name}.md").read_text("utf-8")
    return text.replace("\n[All instructions](README.md)\n", "")


def instructions() -> dict[str, str]:
    """A line on each instruction, including return, for and pass."""
    from clickgen.instructions import INSTRUCTIONS
    from clickgen.instructions.control import FOR, NOP, RETURN

    return {spec.name: spec.summary for spec in (*INSTRUCTIONS.values(), RETURN, FOR, NOP)}


def topics() -> dict[str, str]:
    """The parts of the language page, each by its title in lower case; the instructions are a list."""
    text = (documentation() / "language.md").read_text("utf-8")
    parts = re.split(r"^## ", text, flags=re.MULTILINE)[1:]
    pages = {part.partition("\n")[0].lower(): f"# {part}" for part in parts}
    rows = [f"{name:<14}{summary}" for name, summary in instructions().items()]
    pages["instructions"] = "\n".join(["# Instructions", "", *rows, "", "clickgen explain NAME tells of one.", ""])
    return pages


def plain(markdown: str) -> str:
    """Return Markdown for a terminal: without comments and fences, examples indented."""
    text = re.sub(r"<!--.*?-->\n", "", markdown)
    text = re.sub(
        r"^```\w*\n(.*?)^```$", lambda match: textwrap.indent(match[1].rstrip(), "    "), text, flags=re.DOTALL | re.M
    )
    text = re.sub(r"\[([^\]]+)\]\([^)]+\)", r"\1", text)
    text = re.sub(r"^# ", "", text)
    return re.sub(r"\*\*([^*]+)\*\*", r"\1", text)
