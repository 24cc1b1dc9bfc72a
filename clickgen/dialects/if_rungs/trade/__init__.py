"""The words of the trade, and their equivalents here: those of IEC 61131-3, Allen-Bradley, Siemens, the mnemonics of
instruction lists, CLICK's own menus and ladder files, and the dialect with ``with Rung(...)``.

They are tried before any spelling: ``otu`` is no misspelt ``out`` but its opposite. Every piece of code in
this table builds, which a test checks.
"""

from __future__ import annotations

from clickgen.dialects.if_rungs.trade.actions import ACTIONS
from clickgen.dialects.if_rungs.trade.advice import Advice, advice
from clickgen.dialects.if_rungs.trade.conditions import CONDITIONS
from clickgen.dialects.if_rungs.trade.formulas import FORMULAS
from clickgen.dialects.if_rungs.trade.names import ARGUMENTS, MEMBERS, bank_hint

__all__ = [
    "ACTIONS",
    "ARGUMENTS",
    "CONDITIONS",
    "FORMULAS",
    "MEMBERS",
    "Advice",
    "advice",
    "bank_hint",
]
