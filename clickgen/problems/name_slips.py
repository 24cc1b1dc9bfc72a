"""Names that look like one another by a slip of the hand: swapped, dropped, doubled or mistaken letters, separators."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable

_WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|[0-9]+")
_SEPARATORS = re.compile(r"[_\s]+")

_INFLECTIONS = "sdrnye"
"""A letter at the end that makes another word: parts, closed, feeder."""

_TRADE_WORDS = """
bell belt boil bolt card cart case center coat code coil cold cont cool count cover cycle door dose down drain draw
drum dry enter fall falling feed feeling fell fill filling film fire fixing flow fold folding form from front full
gate gear grab grip guard hand head hear hearing heat heating hold holding hole home hook hose hour inlet inner input
lane lead leading leak left lift lime limit line link list load loading lock long loop loss lost low lower made main
make mask mean meat mill mind mine mist mixing mode motor move near open outer oven over part past path peak pick pile
pipe place plate play point poll pool port pose post power press prime print probe pulse pump purge push ramp range
rate read ready real rear reel reset rest ring rinse rinsing rise rising roll room rotor running safe salt save scale
scan seal seat send sent set shift short shot side sign site size skip slide slot slow soak sort spare speed spin spot
stack stage star start stat state step stick stock stop store strip table take tank tape test tilt time tool top total
tower track trail train trap tray trial trim trip turn turning type under unit unloading uploading upper valve vent
wait waiting walk wall warm wash washing waste water wedding weight welding wide wind wire work zone
"""
_TRADE = frozenset(_TRADE_WORDS.split())
"""Words that differ by a letter and mean different things on a machine: neither is a misspelling of the other."""


def is_slip(name: str, other: str) -> bool:
    """True for two different names that are one by a slip of the hand: ``Gaurd_Fault`` and ``Guard_Fault``.

    ``Pump1`` and ``Pump2``, ``Part`` and ``Parts``, ``ValveA`` and ``ValveB`` are names that somebody chose.
    """
    if name.lower() == other.lower() or _digits(name) != _digits(other):
        return False
    mine, theirs = _plain(name), _plain(other)
    if mine == theirs:
        return True
    ours, others = _words(name), _words(other)
    if len(ours) != len(others):
        # A slip in a letter and in a separator: a letter more may be a word of its own.
        return len(mine) == len(theirs) >= 8 and _is_swapped(mine, theirs)
    differing = [(one, two) for one, two in zip(ours, others, strict=True) if one != two]
    return len(differing) == 1 and _is_slip_in_word(*differing[0])


class Spellings:
    """Many names, and which of them another one looks like."""

    def __init__(self, names: Iterable[str]) -> None:
        # Names with different numbers are never slips of each other, and share most of their stems.
        self._by_stem: dict[tuple[str, str], list[str]] = defaultdict(list)
        for name in dict.fromkeys(names):
            digits = _digits(name)
            for stem in _stems(name):
                self._by_stem[digits, stem].append(name)

    def near(self, name: str) -> list[str]:
        """Those of the names that are this one but for a slip, in their order."""
        digits = _digits(name)
        found = dict.fromkeys(other for stem in _stems(name) for other in self._by_stem.get((digits, stem), ()))
        return [other for other in found if is_slip(name, other)]


def _stems(name: str) -> set[str]:
    """The name without separators, and without each of its letters: two names one slip apart have one in common."""
    plain = _plain(name)
    return {plain, *(plain[:index] + plain[index + 1 :] for index in range(len(plain)))}


def _plain(name: str) -> str:
    return _SEPARATORS.sub("", name).lower()


def _digits(name: str) -> str:
    """The numbers in a name, apart from each other."""
    return " ".join(_NUMBERS.findall(name))


_NUMBERS = re.compile(r"[0-9]+")


def _words(name: str) -> list[str]:
    return [word.lower() for word in _WORD.findall(name)]


def _is_slip_in_word(one: str, two: str) -> bool:
    if one in _TRADE and two in _TRADE:
        return False
    if len(one) == len(two):
        return _is_swapped(one, two) or _is_mistaken(one, two)
    short, long = sorted((one, two), key=len)
    return len(long) == len(short) + 1 and _is_dropped(short, long)


def _is_swapped(one: str, two: str) -> bool:
    at = [index for index, (mine, other) in enumerate(zip(one, two, strict=True)) if mine != other]
    is_pair = len(at) == 2 and at[1] == at[0] + 1
    is_long = len(one) >= 4 or (len(one) == 3 and one[0] == two[0])
    return is_long and is_pair and one[at[0]] == two[at[1]] and one[at[1]] == two[at[0]]


def _is_mistaken(one: str, two: str) -> bool:
    """One other letter, neither the first nor the last, in a word that is long enough."""
    at = [index for index, (mine, other) in enumerate(zip(one, two, strict=True)) if mine != other]
    return len(one) >= 6 and len(at) == 1 and 0 < at[0] < len(one) - 1 and (one + two).isalpha()


def _is_dropped(short: str, long: str) -> bool:
    at = next((index for index, letter in enumerate(short) if letter != long[index]), len(short))
    if short[at:] != long[at + 1 :] or not long[at].isalpha():
        return False
    if at and long[at] == long[at - 1]:
        return len(short) >= 3 and not (at == len(short) and long[at] in _INFLECTIONS and len(short) < 4)
    if at == len(short):
        return len(short) >= 4 and long[at] not in _INFLECTIONS
    return at > 0 and len(short) >= 4
