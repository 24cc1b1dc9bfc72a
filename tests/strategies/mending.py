"""Programs to be fixed: else and elif, Python's operators, repeated terms, and findings of other rules."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TypeVar

from hypothesis import strategies as st

from strategies.conditions import (
    ALWAYS,
    OPERATORS,
    BitRange,
    Compare,
    Condition,
    Contact,
    Group,
    Logic,
    compared,
    register,
    weighted,
)
from strategies.meaning import WORLD_ACTS, WORLD_MESSAGES, WORLD_TEXTS
from strategies.programs import Act, Arm, Branch, Item, Pin, Program, Rung
from strategies.shown import ShownAsText

WORDS = (
    Act('search("eq", 1, ds[1], ds[3], ds[2], c[4])', "search(DS1..DS3 == 1,result=DS2,found=C4)", 2),
    Act('search("lt", 2, ds[1], ds[3], ds[3], c[2])', "search(DS1..DS3 < 2,result=DS3,found=C2)", 2),
)
CALLS = (Act("call(other)", 'call("other")'), Act("call(third)", 'call("third")'))
VALUES = (Act("copy(0, ctd[13])", "copy(0,CTD13)", 2), Act("copy(ds[1], ctd[13])", "copy(DS1,CTD13)", 2))
NAMES = {
    "c[1:4]": ("c.Bits", "c.Bits[0:3]"),
    "c[1:3]": ("c.Bits[0:2]",),
    "c[2:4]": ("c.Bits[1:3]",),
    "c[1]": ("c.First", "c.Bits[0]"),
    "c[2]": ("c.Bits[1]",),
    "c[3]": ("c.Bits[2]", "c.Third"),
    "ds[1:4]": ("ds.Row",),
    "ds[1]": ("ds.Step", "ds.Row[0]"),
    "ds[2]": ("ds.Row[1]",),
    "ct[13]": ("ct.Count",),
    "ctd[13]": ("ctd.Count",),
}
"""Names for some addresses."""
TABLE = """\
Address,Data Type,Nickname,Initial Value,Retentive,Address Comment
C1,BIT,"First",0,No,"<Bits>"
C3,BIT,"Third",0,No,"</Bits>"
CT13,BIT,"Count",0,Yes,""
DS1,INT,"Step",0,Yes,"<Row>"
DS3,INT,"",0,Yes,"</Row>"
"""


@dataclass(frozen=True)
class Mending(ShownAsText):
    """A program to be fixed, and the words for its addresses."""

    program: Program
    words: tuple[tuple[str, str], ...] = ()

    @property
    def texts(self) -> dict[str, str]:
        """The text of each file, that of main first."""
        return {name: self._worded(text) for name, text in self.program.texts.items()}

    @property
    def text(self) -> str:
        return "\n".join(f"# ---- {name}\n{text}" for name, text in self.texts.items())

    def _worded(self, text: str) -> str:
        words = dict(self.words)
        return re.sub(r"\b[a-z]+\[[0-9:]+\]", lambda match: words.get(match[0], match[0]), text)

    @property
    def meant(self) -> Program:
        """The person's meaning, in the language: the arms of an if are branches that exclude each other."""
        program = self.program
        routines = tuple((name, _meant_rungs(rungs)) for name, rungs in program.subroutines)
        return Program(_meant_rungs(program.main), routines, program.modules, program.wiring)


def _meant_rungs(rungs: Sequence[Rung]) -> tuple[Rung, ...]:
    return tuple(
        Rung(ALWAYS, tuple(_branches(rung))) if rung.others else Rung(rung.condition, _meant_items(rung.items))
        for rung in rungs
    )


def _meant_items(items: Sequence[Item]) -> tuple[Item, ...]:
    return tuple(one for item in items for one in (_branches(item) if isinstance(item, Branch) else [item]))


def _branches(chain: Rung | Branch) -> list[Item]:
    found: list[Item] = []
    earlier: list[Condition] = []
    for arm in (Arm(chain.condition, chain.items), *chain.others):
        own = arm.condition or ALWAYS
        none = tuple(Logic("not", (test,)) for test in earlier)
        found.append(Branch(Group("all", (*none, own)), _meant_items(arm.items)))
        earlier.append(own)
    return found


_BITS = ("C1", "C2", "C3", "X001", "X002", "Y001", "CT13", "C1", "C2")
_LEVELS = st.builds(Contact, st.sampled_from(_BITS), st.sampled_from(("", "", "nc")))
_EDGES = st.builds(Contact, st.sampled_from(_BITS), st.sampled_from(("re", "fe")))
_NUMBERS = st.builds(
    compared,
    st.sampled_from([register(name) for name in ("DS1", "DS1", "DS2", "CTD13", "DD1")]),
    st.sampled_from(OPERATORS),
    st.sampled_from([*((str(n), str(n)) for n in range(3)), register("DS2")]),
)
_TEXT = st.builds(
    compared, st.just(register("TXT1")), st.sampled_from(OPERATORS), st.sampled_from((('"0"', '"0"'), ('"1"', '"1"')))
)
_RANGES = st.builds(BitRange, st.just("C"), st.sampled_from((1, 2)), st.just(3), st.booleans())
_IMMEDIATES = st.builds(Contact, st.just("X001"), st.sampled_from(("", "nc")), st.just(True))
_BARE = st.sampled_from((Compare("DS1!=0", "ds[1]"), Compare("DH1!=0000h", "dh[1]")))
LEAVES: st.SearchStrategy[Condition] = weighted(
    (8, _LEVELS), (6, _NUMBERS), (1, _EDGES), (1, _TEXT), (1, _RANGES), (1, _IMMEDIATES), (1, _BARE)
)


def _logic(inner: st.SearchStrategy[Condition]) -> st.SearchStrategy[Condition]:
    some = st.lists(inner, min_size=2, max_size=3).map(tuple)
    one = st.tuples(inner)
    return st.one_of(
        st.builds(Logic, st.sampled_from(("and", "or", "&", "|")), some),
        st.builds(Logic, st.sampled_from(("not", "~")), one),
    )


def _groups(inner: st.SearchStrategy[Condition]) -> st.SearchStrategy[Condition]:
    return st.builds(Group, st.sampled_from(("all", "any")), st.lists(inner, min_size=1, max_size=4).map(tuple))


PLAIN: st.SearchStrategy[Condition] = st.recursive(LEAVES, _groups, max_leaves=5)
"""Conditions in the language, with repeated terms."""
WRONG: st.SearchStrategy[Condition] = st.recursive(
    LEAVES, lambda inner: st.one_of(_logic(inner), _logic(inner), _groups(inner)), max_leaves=5
)
TESTS: st.SearchStrategy[Condition] = weighted((3, LEAVES), (3, PLAIN), (2, WRONG))

_COUNTER = st.builds(
    lambda reset: Act("ctu(ct[13], 2)", "count_up(CT13,CTD13,preset=2)", 3, (Pin("reset", reset),)), PLAIN
)
ACTS: st.SearchStrategy[Item] = weighted(
    (10, st.sampled_from(WORLD_ACTS)),
    (2, st.sampled_from(WORDS)),
    (2, st.sampled_from(VALUES)),
    (1, st.sampled_from(WORLD_TEXTS)),
    (1, st.sampled_from(WORLD_MESSAGES)),
)


Made = TypeVar("Made")


def _items(acts: st.SearchStrategy[Item], depth: int) -> st.SearchStrategy[tuple[Item, ...]]:
    item = acts
    if depth:
        inner = _items(acts, depth - 1)
        item = weighted((4, acts), (1, st.builds(Branch, TESTS, inner)), (2, _chains(Branch, inner)))
    return st.lists(item, min_size=1, max_size=2).map(tuple)


def _chains(
    made: Callable[[Condition, tuple[Item, ...], tuple[Arm, ...]], Made], items: st.SearchStrategy[tuple[Item, ...]]
) -> st.SearchStrategy[Made]:
    elifs = st.lists(st.builds(Arm, TESTS, items), max_size=2).map(tuple)
    last = st.builds(Arm, st.none(), items).map(lambda arm: (arm,))
    ends: st.SearchStrategy[tuple[Arm, ...]] = weighted((2, last), (1, st.just(())))
    return st.builds(made, TESTS, items, st.builds(lambda some, end: (*some, *end), elifs, ends))


@st.composite
def mendings(draw: st.DrawFn) -> Mending:
    """Programs of one or two files, their addresses as numbers, nicknames or members of blocks."""
    with_calls: st.SearchStrategy[Item] = weighted((9, ACTS), (1, st.sampled_from(CALLS)))
    rung = weighted(
        (3, _chains(Rung, _items(with_calls, 1))),
        (2, st.builds(Rung, TESTS, _items(with_calls, 1))),
    )
    main = draw(st.lists(rung, min_size=1, max_size=2).map(tuple))
    plain = st.lists(st.builds(Rung, weighted((3, LEAVES), (1, TESTS)), _items(ACTS, 0)), max_size=2).map(tuple)
    other, third = draw(plain), draw(plain)
    counter = draw(st.lists(st.builds(lambda test, box: Rung(test, (box,)), LEAVES, _COUNTER), max_size=1).map(tuple))
    modules = draw(st.sampled_from((("", ""), ("parts", ""), ("parts", "parts"))))
    program = Program((*main, *counter), (("other", other), ("third", third)), modules)
    words = {old: draw(st.sampled_from(new)) for old, new in NAMES.items() if draw(st.booleans())}
    return Mending(program, tuple(words.items()))
