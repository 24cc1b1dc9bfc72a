"""Conditions: contacts, ranges, comparisons, ``all`` and ``any``, with when they hold and how much room they take."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeVar

from hypothesis import strategies as st


def ladder_name(bank: str, number: int) -> str:
    return f"{bank}{number:03d}" if bank in ("X", "Y") else f"{bank}{number}"


def written(name: str) -> str:
    """Return a ladder name as the program writes it: ``X001`` is ``x[1]``."""
    bank = name.rstrip("0123456789")
    return f"{bank.lower()}[{int(name[len(bank) :])}]"


@dataclass(frozen=True)
class Contact:
    """A contact on one bit; ``bit`` is the ladder's name of it and ``form`` one of "", nc, re, fe."""

    bit: str
    form: str = ""
    immediate: bool = False

    @property
    def leaf(self) -> str:
        """The ladder token without its ``~``."""
        if self.immediate:
            return f"immediate({self.bit})"
        return {"re": f"rise({self.bit})", "fe": f"fall({self.bit})"}.get(self.form, self.bit)

    @property
    def text(self) -> str:
        address = written(self.bit) + (".immediate" if self.immediate else "")
        return f"{self.form}({address})" if self.form else address


@dataclass(frozen=True)
class BitRange:
    """A contact on a range: every bit of it, or with ``negated`` none of it."""

    bank: str
    first: int
    last: int
    negated: bool = False
    immediate: bool = False

    @property
    def contacts(self) -> tuple[Contact, ...]:
        bits = (ladder_name(self.bank, number) for number in range(self.first, self.last + 1))
        return tuple(Contact(bit, "nc" if self.negated else "", self.immediate) for bit in bits)

    @property
    def text(self) -> str:
        address = f"{self.bank.lower()}[{self.first}:{self.last + 1}]" + (".immediate" if self.immediate else "")
        return f"nc({address})" if self.negated else address


@dataclass(frozen=True)
class Compare:
    """A comparison: ``leaf`` is the ladder's token, ``text`` the program's text."""

    leaf: str
    text: str


@dataclass(frozen=True)
class Group:
    """``all(...)`` or ``any(...)``."""

    word: str
    terms: tuple[Condition, ...]

    @property
    def text(self) -> str:
        return f"{self.word}({', '.join(term.text for term in self.terms)})"


@dataclass(frozen=True)
class Logic:
    """Conditions that the language does not have: those under one of Python's own operators."""

    operator: str
    terms: tuple[Condition, ...]

    @property
    def text(self) -> str:
        texts = [f"({term.text})" if isinstance(term, Logic | Compare) else term.text for term in self.terms]
        if self.operator in ("not", "~"):
            return f"{self.operator}{' ' * (self.operator == 'not')}{texts[0]}"
        return f" {self.operator} ".join(texts)


@dataclass(frozen=True)
class Always:
    text: str = "True"


Condition = Contact | BitRange | Compare | Group | Logic | Always
Leaf = Contact | Compare
ALWAYS = Always()


def leaves(condition: Condition) -> Iterator[Leaf]:
    """Every contact and comparison in source order, ranges divided into bits."""
    if isinstance(condition, Group | Logic):
        for term in condition.terms:
            yield from leaves(term)
    elif isinstance(condition, BitRange):
        yield from condition.contacts
    elif not isinstance(condition, Always):
        yield condition


def solve(condition: Condition, sets: Mapping[str, int], full: int) -> int:
    """The situations of ``full`` in which the condition holds; ``sets`` has those of each leaf."""
    if isinstance(condition, Always):
        return full
    if isinstance(condition, Group):
        series = condition.word == "all"
        found = full if series else 0
        for term in condition.terms:
            one = solve(term, sets, full)
            found = found & one if series else found | one
        return found
    if isinstance(condition, Logic):
        if condition.operator in ("not", "~"):
            return full & ~solve(condition.terms[0], sets, full)
        return solve(Group("all" if condition.operator in ("and", "&") else "any", condition.terms), sets, full)
    if isinstance(condition, BitRange):
        return solve(Group("all", condition.contacts), sets, full)
    negated = isinstance(condition, Contact) and condition.form == "nc"
    return full & ~sets[condition.leaf] if negated else sets[condition.leaf]


def size(condition: Condition) -> tuple[int, int]:
    """Columns and rows that a condition takes when drawn."""
    if isinstance(condition, Group):
        sizes = [size(term) for term in condition.terms]
        widths, heights = [one[0] for one in sizes], [one[1] for one in sizes]
        return (sum(widths), max(heights)) if condition.word == "all" else (max(widths), sum(heights))
    if isinstance(condition, Logic):
        return size(Group("all" if condition.operator in ("and", "&") else "any", condition.terms))
    if isinstance(condition, BitRange):
        return len(condition.contacts), 1
    return (0, 0) if isinstance(condition, Always) else (1, 1)


def flat(condition: Condition) -> Condition:
    """The same leaves in series, without legs."""
    if isinstance(condition, Group | Logic):
        return Group("all", tuple(flat(term) for term in condition.terms))
    return condition


# ---------------------------------------------------------------------------------------------------- strategies

T = TypeVar("T")


def weighted(*choices: tuple[int, st.SearchStrategy[T]]) -> st.SearchStrategy[T]:
    """One of some strategies, each as often as its weight; the first is the simplest."""
    indices = [index for index, (weight, _) in enumerate(choices) for _ in range(weight)]
    return st.sampled_from(indices).flatmap(lambda index: choices[index][1])


FORMS = ("", "", "nc", "re", "fe")
POWER_BITS = (
    "X001",
    "X016",
    "X021",
    "Y001",
    "Y116",
    "C1",
    "C2",
    "C2000",
    "T1",
    "T500",
    "CT1",
    "CT250",
    "SC2",
    "SC1000",
)


def compared(left: tuple[str, str], op: str, right: tuple[str, str]) -> Compare:
    return Compare(f"{left[0]}{op}{right[0]}", f"{left[1]} {op} {right[1]}")


def register(name: str) -> tuple[str, str]:
    return name, written(name)


OPERATORS = ("==", "!=", "<", "<=", ">", ">=")
_DECIMAL = [register(name) for name in ("DS1", "DS4500", "DD1", "TD1", "CTD250", "SD9")]
_DECIMAL += [("5", "5"), ("-7", "-7"), ("32767", "32767")]
_HEX = [register(name) for name in ("DH1", "DH500", "XD8", "YD0")] + [("00FFh", "0x00FF"), ("0005h", "5")]
_TEXT = [register("TXT1"), register("TXT1000"), ('"A"', '"A"'), ('","', '","')]
_FLOAT = [register("DF1"), register("DF500"), ("1.5", "1.5"), ("-0.25", "-0.25")]
_BARE = (("DS2", "0"), ("DD3", "0"), ("DH4", "0000h"), ("DF5", "0.0"), ("TD6", "0"), ("CTD7", "0"))


@st.composite
def any_compares(draw: st.DrawFn) -> Compare:
    """Comparisons of every class, a constant on either side, and bare registers."""
    if draw(st.integers(0, 4)) == 0:
        name, zero = draw(st.sampled_from(_BARE))
        return Compare(f"{name}!={zero}", written(name))
    side = draw(st.sampled_from((_DECIMAL, _HEX, _TEXT, _FLOAT)))
    left = draw(st.sampled_from(side))
    right = draw(st.sampled_from([one for one in side if one[0][0].isalpha() or left[0][0].isalpha()]))
    return compared(left, draw(st.sampled_from(OPERATORS)), right)


def contacts(bits: Sequence[str], forms: Sequence[str] = FORMS) -> st.SearchStrategy[Contact]:
    return st.builds(Contact, st.sampled_from(bits), st.sampled_from(forms))


def immediates(bits: Sequence[str]) -> st.SearchStrategy[Contact]:
    return st.builds(Contact, st.sampled_from(bits), st.sampled_from(("", "nc")), st.just(True))


@st.composite
def bit_ranges(draw: st.DrawFn, banks: Sequence[str] = ("X", "Y", "C", "T", "CT", "SC"), last: int = 8) -> BitRange:
    bank = draw(st.sampled_from(banks))
    first = draw(st.integers(1, last))
    stop = draw(st.integers(first, min(first + 4, last)))
    return BitRange(bank, first, stop, draw(st.booleans()), bank == "X" and draw(st.booleans()))


def conditions(
    leaf: st.SearchStrategy[Condition],
    depth: int = 3,
    breadth: int = 4,
    always: bool = False,
    groups_weight: int = 1,
) -> st.SearchStrategy[Condition]:
    """Trees of ``all`` and ``any``, also with a single term or with their own kind inside."""
    tree = leaf
    for _ in range(depth):
        groups = st.builds(
            Group, st.sampled_from(("all", "any")), st.lists(tree, min_size=1, max_size=breadth).map(tuple)
        )
        tree = weighted((1, leaf), (groups_weight, groups))
    return weighted((5, tree), (1, st.just(ALWAYS))) if always else tree


any_leaves: st.SearchStrategy[Condition] = st.one_of(
    contacts(POWER_BITS), contacts(POWER_BITS), immediates(("X001", "X002", "X816")), bit_ranges(), any_compares()
)


def few_leaves(count: int) -> st.SearchStrategy[st.SearchStrategy[Condition]]:
    """A strategy over a pool of at most this many different leaves, so that all their situations can be tried."""
    pools = st.lists(any_leaves, min_size=min(6, count), max_size=count, unique=True)
    return pools.map(st.sampled_from)
