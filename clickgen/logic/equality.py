"""Two logics for power: sets of situations, and decision diagrams.

The set of all situations is exact for few variables, and a sample for many. A reduced ordered binary decision diagram
is exact for any number: equal functions are one node. It has a limit of nodes, so that no rung takes forever.
"""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

NODES_MAX = 200_000
VARIABLES_MAX = 500
"""The recursion of a diagram is as deep as its number of variables."""

_SAMPLES = 1024
_STEPS = (0, 1, 2, 4)
"""A density for each step and its mirror: one half, and one in 4, 8 and 32 on or off."""


@dataclass(frozen=True)
class Situations:
    """Each truth value is a set of situations, a bit for each."""

    variables: Mapping[str, int]
    always: int
    never: int = 0

    @classmethod
    def every(cls, names: Sequence[str]) -> Situations:
        """All combinations of the variables."""
        size = 1 << len(names)
        always = (1 << size) - 1
        # Blocks of 2**n situations, alternately off and on: 1010..., 1100..., 11110000...
        masks = [always // ((1 << (1 << n)) + 1) << (1 << n) for n in range(len(names))]
        return cls(dict(zip(names, masks, strict=True)), always)

    @classmethod
    def sampled(cls, names: Sequence[str]) -> Situations:
        """Several thousand combinations, always the same for the same variables: few on, many on, one on, one off."""
        chance = random.Random("\n".join(sorted(names)))
        variables = dict.fromkeys(names, 0)
        count = 0
        for step in _STEPS:
            for is_mirrored in (False, True):
                for name in names:
                    bits = chance.getrandbits(_SAMPLES)
                    for _ in range(step):
                        bits &= chance.getrandbits(_SAMPLES)
                    if is_mirrored:
                        bits ^= (1 << _SAMPLES) - 1
                    variables[name] |= bits << count
                count += _SAMPLES
        every = (1 << len(names)) - 1
        for index, name in enumerate(names):
            # All off, one on; all on, one off.
            one = 1 << index
            variables[name] |= one << count
            variables[name] |= (every ^ one) << (count + len(names))
            variables[name] |= 2 << (count + 2 * len(names))
        count += 2 * len(names) + 2
        return cls(variables, (1 << count) - 1)

    def variable(self, name: str) -> int:
        return self.variables[name]

    def both(self, one: int, other: int) -> int:
        return one & other

    def either(self, one: int, other: int) -> int:
        return one | other

    def opposite(self, one: int) -> int:
        return self.always ^ one


class TooMany(Exception):
    """A diagram has more nodes or variables than the limit."""


class Decisions:
    """Binary decision diagrams over variables in this order; each function is the number of its node."""

    never: int = 0
    always: int = 1

    def __init__(self, order: Sequence[str], limit: int = NODES_MAX) -> None:
        """Raises TooMany, as every operation does."""
        if len(order) > VARIABLES_MAX:
            raise TooMany
        self._names = list(order)
        self._levels = {name: level for level, name in enumerate(order)}
        self._limit = limit
        # Variable, the function while it is off, the function while it is on; the constants are below all variables.
        self._nodes: list[tuple[int, int, int]] = [(len(order), 0, 0), (len(order), 1, 1)]
        self._known: dict[tuple[int, int, int], int] = {}
        self._chosen: dict[tuple[int, int, int], int] = {}

    def variable(self, name: str) -> int:
        return self._node(self._levels[name], 0, 1)

    def both(self, one: int, other: int) -> int:
        one, other = sorted((one, other))
        return self._choice(one, other, 0)

    def either(self, one: int, other: int) -> int:
        one, other = sorted((one, other))
        return self._choice(one, 1, other)

    def opposite(self, one: int) -> int:
        return self._choice(one, 0, 1)

    def smallest_case(self, function: int) -> dict[str, bool]:
        """A few variables whose values make a function true. The function must not be constantly false."""
        # A node comes after those that it leads to.
        costs: list[tuple[float, bool]] = [(float("inf"), False), (0, False)]
        for _, off, on in self._nodes[2 : function + 1]:
            is_on = costs[on][0] < costs[off][0]
            costs.append((costs[on if is_on else off][0] + 1, is_on))
        case: dict[str, bool] = {}
        node = function
        while node > 1:
            level, off, on = self._nodes[node]
            is_on = costs[node][1]
            case[self._names[level]] = is_on
            node = on if is_on else off
        for name in list(case):
            rest = {other: value for other, value in case.items() if other != name}
            if self._holds(function, rest):
                case = rest
        return case

    def _holds(self, function: int, case: Mapping[str, bool]) -> bool:
        """True if a function is true whenever these variables have these values."""
        waiting, seen = [function], {function}
        while waiting:
            node = waiting.pop()
            if node < 2:
                if node == self.never:
                    return False
                continue
            level, off, on = self._nodes[node]
            is_on = case.get(self._names[level])
            following = {off, on} if is_on is None else {on if is_on else off}
            waiting += following - seen
            seen |= following
        return True

    def _node(self, level: int, off: int, on: int) -> int:
        if off == on:
            return off
        key = (level, off, on)
        found = self._known.get(key)
        if found is None:
            if len(self._nodes) >= self._limit:
                raise TooMany
            found = self._known[key] = len(self._nodes)
            self._nodes.append(key)
        return found

    def _choice(self, test: int, then: int, otherwise: int) -> int:
        """``then`` if ``test`` is true, else ``otherwise``."""
        if test < 2:
            return then if test else otherwise
        if then == otherwise:
            return then
        if (then, otherwise) == (1, 0):
            return test
        key = (test, then, otherwise)
        found = self._chosen.get(key)
        if found is None:
            nodes = self._nodes
            level = min(nodes[test][0], nodes[then][0], nodes[otherwise][0])
            branches = []
            for side in (1, 2):
                parts = [node if nodes[node][0] != level else nodes[node][side] for node in key]
                branches.append(self._choice(parts[0], parts[1], parts[2]))
            found = self._chosen[key] = self._node(level, branches[0], branches[1])
        return found
