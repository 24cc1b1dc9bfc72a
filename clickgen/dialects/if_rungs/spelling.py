"""How the dialect writes what messages show."""

from __future__ import annotations

import re
from keyword import iskeyword
from typing import TYPE_CHECKING

from clickgen.device.banks import BANKS
from clickgen.dialects.base import Spelling
from clickgen.dialects.if_rungs.write.expressions import (
    action_piece,
    condition_piece,
    operand_text,
    quoted,
    remote_piece,
)
from clickgen.dialects.if_rungs.write.layout import flat
from clickgen.formula.spelling import BracketAddresses
from clickgen.instructions import INSTRUCTIONS
from clickgen.ir.operands import Named

if TYPE_CHECKING:
    from clickgen.instructions.spec import Spec
    from clickgen.ir.conditions import Condition
    from clickgen.ir.modbus import Remote
    from clickgen.ir.operands import Operand
    from clickgen.ir.program import Action


_ADDRESS = re.compile(rf"(?:{'|'.join(bank.dsl for bank in BANKS.values())})[.\[][^\n]+")
_NAME = re.compile(r"[a-z]+(\.\w+|\[\"[^\"]*\"\])")
"""A name without an index, which is a block where it is a range."""


class IfRungsSpelling(BracketAddresses, Spelling):
    """``if c.Run: out(y[1])``"""

    always = "True"
    immediate = ".immediate"
    backwards = ":-1"

    def name(self, bank: str, name: str) -> str:
        return f"{bank.lower()}[{quoted(name)}]" if iskeyword(name) else super().name(bank, name)

    # -- addresses that a person wrote --------------------------------------------------------------------------------

    def is_address(self, text: str) -> bool:
        return _ADDRESS.fullmatch(text) is not None

    def is_name(self, text: str) -> bool:
        return _NAME.fullmatch(text) is not None

    def address_hint(self, text: str, bank: str = "C") -> str:
        from clickgen.dialects.if_rungs.ways_out.hints import text_hint

        return text_hint(text, bank.lower())

    # -- what the IR has ----------------------------------------------------------------------------------------------

    def operand(self, operand: Operand) -> str:
        return self.reference(operand) if isinstance(operand, Named) else operand_text(operand)

    def condition(self, condition: Condition) -> str:
        return flat(condition_piece(condition))

    def remote(self, remote: Remote) -> str:
        return flat(remote_piece(remote))

    def action(self, action: Action) -> str:
        return flat(action_piece(action))

    # -- conditions out of texts --------------------------------------------------------------------------------------

    def off(self, bit: str) -> str:
        return f"nc({bit})"

    def rising(self, bit: str) -> str:
        return f"re({bit})"

    def compared(self, left: str, op: str, right: str) -> str:
        return f"{left} {op} {right}"

    def every(self, *terms: str) -> str:
        return f"all({', '.join(terms)})"

    def some(self, *terms: str) -> str:
        return f"any({', '.join(terms)})"

    # -- statements out of texts --------------------------------------------------------------------------------------

    def call(self, spec: Spec, *texts: str, **named: str) -> str:
        if spec.name in ("return", "pass"):
            return spec.name
        return f"{spec.name}({', '.join([*texts, *(f'{name}={text}' for name, text in named.items())])})"

    def rung(self, condition: str, *actions: str) -> str:
        return f"if {condition or 'True'}:{' ' if actions else ''}{'; '.join(actions)}"

    def example(self, spec: Spec) -> str:
        return spec.example

    def signature(self, spec: Spec) -> str:
        return spec.signature if spec.name in INSTRUCTIONS else spec.example

    def rung_at(self, indent: str, action: str) -> str:
        return f"{indent}if True:\n{indent * 2}{action}"

    def goes_on(self, line: str) -> bool:
        return line.endswith("\\")

    def chained(self, name: str, condition: str, **named: str) -> str:
        given = [condition, *(f"{word}={text}" for word, text in named.items())]
        return f".{name}({', '.join(given)})"

    def pin(self, name: str, condition: str) -> str:
        return f"{name}=lambda: {condition}"

    def declaration(self, *texts: str, **settings: str) -> str:
        given = [*texts, *(f"{name}={text}" for name, text in settings.items())]
        return f"nickname({', '.join(given) if given else '...'})"

    def setting(self, name: str, value: str = "") -> str:
        return f"{name}={value}"

    def ignore(self, code: str) -> str:
        return f"# clickgen: ignore[{code}]"

    def routine(self, function: str, title: str = "", is_main: bool = False) -> str:
        return f"def {function}():" if is_main else f"{self.subroutine_mark(title)} def {function}():"

    def subroutine_mark(self, title: str = "") -> str:
        return f"@sub({quoted(title)})" if title else "@sub"

    def imported(self, module: str, function: str) -> str:
        return f"from {module} import {function}"

    def loop(self, count: str) -> str:
        return f"for _ in range({count}): pass"

    def quoted(self, text: str) -> str:
        return quoted(text)

    def hexadecimal(self, value: int) -> str:
        return f"0x{value:04X}"
