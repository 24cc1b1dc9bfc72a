"""``clickgen explain NAME``: the meaning of a code, the operands of an instruction, a word of the trade here."""

from __future__ import annotations

import argparse

from clickgen.cli import COULD_NOT_RUN, OK, complain
from clickgen.commands.explain import explanation, instruction_page, instructions, plain, topics
from clickgen.dialects.registry import default
from clickgen.problems.codes import CODES
from clickgen.problems.diagnostics import did_you_mean
from clickgen.rules.registry import declared

DESCRIPTION = "What a code means and what to do; an instruction; a part of the language; a word of another machine."
EXAMPLES = """\
examples:
  clickgen explain CG501         what a code means
  clickgen explain ton           an instruction: arguments, banks, an example
  clickgen explain instructions  the list of them
  clickgen explain conditions    a part of the language
  clickgen explain XIC           what a word of another machine is here
"""

_CONDITIONS = ("all", "any", "nc", "re", "fe")


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("name", metavar="NAME", nargs="*", help="a code, an instruction, a topic or a word")


def run(options: argparse.Namespace) -> int:
    """Print the page; return the exit code."""
    written = " ".join(options.name)
    if not written:
        print(_overview(), end="")
        return OK
    page = _page(written)
    if page:
        print(page, end="")
        return OK
    complain(f"there is nothing about {written}; {_hint(written)}")
    return COULD_NOT_RUN


def _page(written: str) -> str:
    """The page of a code, an instruction, a topic or a word of the trade; "" if there is none."""
    name = written.lower().removesuffix("()")
    if written.upper() in CODES:
        return plain(explanation(declared(written.upper())))
    if name in instructions():
        return plain(instruction_page(name))
    pages = topics()
    begun = [title for title in pages if title.startswith(name)]
    if name in _CONDITIONS:
        begun = ["conditions"]
    if name in pages or len(begun) == 1:
        return plain(pages[name if name in pages else begun[0]])
    return _word(name)


def _word(name: str) -> str:
    """The meaning of a word of another machine here, in a condition, as an action and in a formula."""
    return "".join(f"{line}\n" for line in default().explain_word(name))


def _overview() -> str:
    codes = "codes           clickgen rules lists them, such as CG501"
    names = ", ".join(instructions())
    titles = ", ".join(topics())
    return f"clickgen explain NAME\n\n{codes}\ninstructions    {names}\ntopics          {titles}\n"


def _hint(written: str) -> str:
    group = [known for known in CODES if known.startswith(written.upper())]
    if group:
        return f"it begins {', '.join(group)}"
    near = did_you_mean(written, CODES) or did_you_mean(written, [*instructions(), *topics()])
    return near or "clickgen explain lists what there is"
