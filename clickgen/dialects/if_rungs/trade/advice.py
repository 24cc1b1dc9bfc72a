"""The advice for a word of the trade, and the texts that several tables share."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import NamedTuple


class Advice(NamedTuple):
    """How to write something here. ``text`` has a ``{}`` for each piece of ``code``.

    ``own`` makes the first pieces from the person's own arguments, one a line: ``$1`` is the first argument, ``$*`` is
    all of them, and ``$=`` is where the result goes: an argument after the others, or a register called Result.
    """

    text: str
    code: tuple[str, ...] = ()
    own: str = ""

    @property
    def shown(self) -> str:
        """The advice with its examples."""
        return self.text.format(*self.code)

    @property
    def has_several(self) -> bool:
        """True for advice that takes several rungs or actions."""
        return "\n" in self.own

    def of(self, written: str) -> str:
        """Return the advice with the person's own code as its first examples."""
        pieces = written.split("\n")
        return self.text.format(*pieces, *self.code[len(pieces) :])

    def written(self, arguments: Sequence[str], target: str = "", is_action: bool = False) -> str:
        """Return the code here for the person's own arguments; "" if their number does not fit.

        ``target`` is where the result goes; an action says it by an argument after the others.
        """
        wanted = max((int(number) for number in re.findall(r"\$(\d)", self.own)), default=0)
        given = list(arguments)
        if "$=" in self.own:
            target = given.pop() if is_action and len(given) == wanted + 1 else target or _result(given)
        if not self.own or not arguments or (wanted and wanted != len(given)):
            return ""
        # The value that is copied first gets worked on: a number there is in the place of another argument.
        first = re.match(r"copy\(\$(\d)", self.own) if self.has_several else None
        if ("$=" in self.own and not target) or (first and not _ADDRESS.match(given[int(first[1]) - 1])):
            return ""
        text = self.own.replace("$*", ", ".join(given)).replace("$=", target)
        return re.sub(r"\$(\d)", lambda number: given[int(number[1]) - 1], text)


_ADDRESS = re.compile(r"[a-z]+(?=[.\[])")


def _result(arguments: Sequence[str]) -> str:
    """A register for the result, in the bank of the first address among the arguments that is not a bit."""
    banks = [found[0] for argument in arguments if (found := _ADDRESS.match(argument))]
    bank = next((bank for bank in banks if bank in ("ds", "dd", "df", "dh")), "ds" if banks else "")
    return f"{bank}.Result" if bank else ""


def advice(word: str, table: dict[str, Advice]) -> Advice | None:
    """The entry of a table for a word, whatever its case; None for a word that is not in it."""
    return table.get(word.lower())


def table(*rows: tuple[str, str, tuple[str, ...], str]) -> dict[str, Advice]:
    return {word: Advice(text, code, own) for words, text, code, own in rows for word in words.split()}


EDGE = "a one-shot is a rising edge in the condition, {}, or oneshot=True in the action: {}"
BEFORE = "a condition does not calculate: write {} in a rung before, and compare the result: {}"
SIZE = "copy the number, {}, and turn it round in a rung below where it is negative: {}"
TWO_RUNGS = "CLICK chooses by conditions, in two rungs: {} and {}"
LATER = "set and reset are rungs of their own, and the later one in the scan wins;"
OTHER_WAY = "first {}, then {}"
MAX = "if $1 >= $2: copy($1, $=)\nif $1 < $2: copy($2, $=)"
MIN = "if $1 <= $2: copy($1, $=)\nif $1 > $2: copy($2, $=)"
SELECT = "if nc($1): copy($2, $=)\nif $1: copy($3, $=)"
OWN_SIZE = 'copy($1, $=)\nif $= < 0: calc("-$=", $=)'
LIMITS = "copy the value, {}, and keep it between the limits in two rungs below: {} and {}"
LIMITED = ("copy(ds.A, ds.B)", "if ds.B < 0: copy(0, ds.B)", "if ds.B > 100: copy(100, ds.B)")
LIMIT = "copy($2, $=)\nif $= < $1: copy($1, $=)\nif $= > $3: copy($3, $=)"
CLAMP = "copy($1, $=)\nif $= < $2: copy($2, $=)\nif $= > $3: copy($3, $=)"
