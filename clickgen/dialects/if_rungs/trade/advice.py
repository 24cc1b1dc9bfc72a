"""How a word of the trade is written here, and the texts that several tables share."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple


class Advice(NamedTuple):
    """How something is written here. ``text`` has a ``{}`` for each piece of ``code``.

    ``own`` makes the first piece of what the person wrote: ``$1`` is the first argument, ``$*`` are all of them.
    """

    text: str
    code: tuple[str, ...] = ()
    own: str = ""

    @property
    def shown(self) -> str:
        """The advice with its examples."""
        return self.text.format(*self.code)

    def of(self, written: str) -> str:
        """The advice with the person's own code as its first example."""
        return self.text.format(written, *self.code[1:])

    def written(self, arguments: Sequence[str]) -> str:
        """The person's own arguments as they are written here; "" where their number does not fit."""
        wanted = {int(number) for number in re.findall(r"\$(\d)", self.own)}
        if not self.own or not arguments or (wanted and max(wanted) != len(arguments)):
            return ""
        text = self.own.replace("$*", ", ".join(arguments))
        return re.sub(r"\$(\d)", lambda number: arguments[int(number[1]) - 1], text)


def advice(word: str, table: dict[str, Advice]) -> Advice | None:
    """What a table says to a word, whatever its case; None for a word that is not in it."""
    return table.get(word.lower())


def table(*rows: tuple[str, str, tuple[str, ...], str]) -> dict[str, Advice]:
    return {word: Advice(text, code, own) for words, text, code, own in rows for word in words.split()}


EDGE = "a one-shot is a rising edge in the condition, {}, or oneshot=True in the action: {}"
BEFORE = "a condition does not calculate: write {} in a rung before, and compare the result: {}"
SIZE = "copy the number, {}, and turn it round in a rung below where it is negative: {}"
TWO_RUNGS = "CLICK chooses by conditions, in two rungs: {} and {}"
LATER = "set and reset are rungs of their own, and the later one in the scan wins;"
OTHER_WAY = "first {}, then {}"
