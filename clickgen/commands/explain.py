"""What a code means, as Markdown, made of what declares it: a rule, or a page of ``problems/explanations``.

Also, from the pages of the documentation, an instruction and a part of the language.
"""

from __future__ import annotations

import re
import textwrap
from pathlib import Path

from clickgen.problems.codes import Severity
from clickgen.problems.declared import WORDS, Code


def explanation(code: Code) -> str:
    """The page of a code: title, severity, why it matters, examples."""
    word = WORDS[code.severity] + ("" if code.is_on else ", off by default")
    parts = [f"# {code.name}: {code.title}", f"**{word}.** {code.why.strip()}"]
    for number, example in enumerate(code.wrong):
        parts += [] if number else ["Found in the lines that `# <-` marks:"]
        parts.append(_block(example.text))
        if example.fixed:
            parts += ["`--fix` makes of it:", _block(example.fixed)]
    if code.right:
        parts.append("The way out:" if code.wrong and code.severity is Severity.ERROR else "Not found:")
    parts += [_block(example) for example in code.right]
    return "\n\n".join(parts) + "\n"


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
    from clickgen.instructions import every

    return {spec.name: spec.summary for spec in every()}


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
