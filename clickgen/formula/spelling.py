"""How formulas write addresses: ``ds.Name``, ``ds["Any name"]``, ``ds[5]``, ``xd["0u"]``, ``ds[1:11]``, ``ds[ds.I]``.

A dialect that writes them in the same way uses this, too.
"""

from __future__ import annotations

from clickgen.device.banks import Address
from clickgen.ir.operands import Cell, Named, Pointer, Range, Section


class BracketAddresses:
    """Addresses with their bank in front, and a name after a dot or a number in brackets: an ``AddressSpelling``."""

    range_end = "the end of a slice is not included"

    def cell(self, address: Address) -> str:
        number = '"0u"' if address.upper else str(address.number)
        return f"{address.bank.lower()}[{number}]"

    def name(self, bank: str, name: str) -> str:
        return f"{bank.lower()}.{name}" if name.isidentifier() else self.in_quotes(bank, name)

    def in_quotes(self, bank: str, name: str) -> str:
        return f'{bank.lower()}["{name}"]'

    def range(self, bank: str, first: int, last: int) -> str:
        ends = f"{first}:{last + 1}" if first <= last else f"{first}:{last - 1}:-1"
        return f"{bank.lower()}[{ends}]"

    def member(self, block: str, index: int) -> str:
        return f"{block}[{index}]"

    def members(self, block: str, count: int) -> str:
        return f"{block}[0:{count}]"

    def section(self, block: str, section: Section) -> str:
        """A part of a block that is written so."""
        start, stop, step = ("" if bound is None else str(bound) for bound in section)
        return f"{block}[{start}:{stop}{'' if section.step == 1 else f':{step}'}]"

    def pointer(self, bank: str, register: str) -> str:
        return f"{bank.lower()}[{register}]"

    def reference(self, ref: Named | Cell | Pointer | Range) -> str:
        """An address of any form."""
        if isinstance(ref, Named):
            name = self.name(ref.bank, ref.name)
            if ref.part is None:
                return name
            return self.member(name, ref.part) if isinstance(ref.part, int) else self.section(name, ref.part)
        if isinstance(ref, Cell):
            return self.cell(ref.address)
        if isinstance(ref, Range):
            return self.range(ref.bank, ref.first, ref.last)
        return self.pointer(ref.bank, self.reference(ref.register))


SPELL = BracketAddresses()
"""The addresses of formulas."""
