"""Chooses addresses: the lowest free one for a name, the highest free one for a scratch use."""

from __future__ import annotations

from collections.abc import Iterable

from clickgen.device.banks import BANKS, CURRENT_VALUE_OF, VALUE_BANK, Address


class Allocator:
    """Knows every address that is taken. A timer's bit and current value share a number: taking either takes both."""

    def __init__(self, taken: Iterable[Address]) -> None:
        self._taken: dict[str, set[int]] = {name: set() for name in BANKS}
        self._next_low: dict[str, int] = {}
        self.take(taken)

    def take(self, addresses: Iterable[Address]) -> None:
        for bank, number, _ in addresses:
            self._taken[bank].add(number)
            twin = VALUE_BANK.get(bank) or CURRENT_VALUE_OF.get(bank)
            if twin:
                self._taken[twin].add(number)

    def lowest(self, bank: str, length: int = 1) -> Address | None:
        """Take the lowest ``length`` free addresses in a row and return the first; None if there are none."""
        taken = self._taken[bank]
        start = self._next_low.get(bank, BANKS[bank].first)
        for first, last in BANKS[bank].ranges:
            number = max(first, start)
            while number + length - 1 <= last:
                blocked = next((n for n in range(number + length - 1, number - 1, -1) if n in taken), None)
                if blocked is not None:
                    number = blocked + 1
                    continue
                if length == 1:
                    self._next_low[bank] = number + 1
                self.take(Address(bank, n) for n in range(number, number + length))
                return Address(bank, number)
        return None

    def highest(self, bank: str) -> Address | None:
        """Take the highest free address of a bank and return it; None if the bank is full."""
        taken = self._taken[bank]
        for first, last in reversed(BANKS[bank].ranges):
            for number in range(last, first - 1, -1):
                if number not in taken:
                    address = Address(bank, number)
                    self.take([address])
                    return address
        return None
