"""Rules about logic worth a second look, one file each. They run when a program has no errors.

The list of rules is the listing of this folder: every module here has a ``RULE``.
"""

from __future__ import annotations

import pkgutil
from importlib import import_module

from clickgen.rules.rule import Rule


def _rules() -> tuple[Rule, ...]:
    modules = [import_module(f"{__name__}.{module.name}") for module in pkgutil.iter_modules(__path__)]
    rules: list[Rule] = [module.RULE for module in modules if hasattr(module, "RULE")]
    return tuple(sorted(rules, key=lambda rule: rule.code))


RULES = _rules()
"""In the order of their codes."""
