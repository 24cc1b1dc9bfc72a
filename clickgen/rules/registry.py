"""The list of rules is the listing of this folder's folders: every module there has a ``RULE``."""

from __future__ import annotations

import pkgutil
from enum import Enum
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING

from clickgen.problems.codes import CODES
from clickgen.problems.declared import Code, page_of, pages

if TYPE_CHECKING:
    from clickgen.rules.rule import Rule


class Folder(Enum):
    """When a rule runs: its folder says it."""

    ERRORS = "errors"
    """In every build, once names are addresses, whatever else is wrong with the program."""
    LOWERED = "lowered"
    """In every build of a program without errors, once the scratch cells have addresses."""
    ADVICE = "advice"
    """In a check, of a program without errors: of another one, advice may speak of what the errors made."""


@cache
def modules(folder: Folder) -> dict[str, Rule]:
    """The rules of a folder in the order of their codes, each under the name of its module."""
    package = import_module(f"{__package__}.{folder.value}")
    names = [f"{package.__name__}.{module.name}" for module in pkgutil.iter_modules(package.__path__)]
    found: dict[str, Rule] = {name: import_module(name).RULE for name in names}
    return dict(sorted(found.items(), key=lambda item: (_first(item[1]), item[0])))


def rules(folder: Folder) -> tuple[Rule, ...]:
    """The rules of a folder, in the order of their codes."""
    return tuple(modules(folder).values())


def every_rule() -> tuple[Rule, ...]:
    """The rules of all folders."""
    return tuple(rule for folder in Folder for rule in rules(folder))


def _first(rule: Rule) -> str:
    return min((code.name for code in rule.codes), default="")


# -- codes ------------------------------------------------------------------------------------------------------------


def declared(name: str) -> Code:
    """What a code means. Raises KeyError for one that is none."""
    home = CODES[name].home
    if home:
        rule: Rule = import_module(f"{__package__}.{home}").RULE
        return next(code for code in rule.codes if code.name == name)
    page = page_of(name)
    if page is None:
        raise KeyError(name)
    return page


def declarations() -> dict[str, tuple[Code, str]]:
    """Every code that a rule or a page declares, in order, with the module of its rule below this folder."""
    found = [(code, "") for code in pages()]
    for folder in Folder:
        for module, rule in modules(folder).items():
            found += [(code, module.removeprefix(f"{__package__}.")) for code in rule.codes]
    names = [code.name for code, _ in found]
    twice = {name for name in names if names.count(name) > 1}
    if twice:
        raise ValueError(f"declared twice: {', '.join(sorted(twice))}")
    return {code.name: (code, home) for code, home in sorted(found, key=lambda pair: pair[0].name)}


def table() -> str:
    """The table of codes, for ``problems/table.py``: code, severity, whether it is on, home and title."""
    rows = [
        f"{name} {code.severity.value:7} {'on ' if code.is_on else 'off'} {home or '-'} {code.title}"
        for name, (code, home) in declarations().items()
    ]
    return "\n".join(rows)
