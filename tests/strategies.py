"""Random programs: a small model of what was generated, its text in the language, and strategies over it.

Nothing here uses clickgen: tokens and meanings are written down once more, from the specification and click-facts.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TypeVar

from hypothesis import strategies as st

# ---------------------------------------------------------------------------------------------------- conditions


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
    """A comparison: ``leaf`` is the ladder's token, ``text`` what the program says."""

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
class Always:
    text: str = "True"


Condition = Contact | BitRange | Compare | Group | Always
Leaf = Contact | Compare
ALWAYS = Always()


def leaves(condition: Condition) -> Iterator[Leaf]:
    """Every contact and comparison in source order, ranges taken apart."""
    if isinstance(condition, Group):
        for term in condition.terms:
            yield from leaves(term)
    elif isinstance(condition, BitRange):
        yield from condition.contacts
    elif not isinstance(condition, Always):
        yield condition


def solve(condition: Condition, sets: Mapping[str, int], full: int) -> int:
    """In which of the situations of ``full`` the condition holds; ``sets`` says it of each leaf."""
    if isinstance(condition, Always):
        return full
    if isinstance(condition, Group):
        series = condition.word == "all"
        found = full if series else 0
        for term in condition.terms:
            one = solve(term, sets, full)
            found = found & one if series else found | one
        return found
    if isinstance(condition, BitRange):
        return solve(Group("all", condition.contacts), sets, full)
    negated = isinstance(condition, Contact) and condition.form == "nc"
    return full & ~sets[condition.leaf] if negated else sets[condition.leaf]


def size(condition: Condition) -> tuple[int, int]:
    """Columns and rows that a condition takes when it is drawn."""
    if isinstance(condition, Group):
        sizes = [size(term) for term in condition.terms]
        widths, heights = [one[0] for one in sizes], [one[1] for one in sizes]
        return (sum(widths), max(heights)) if condition.word == "all" else (max(widths), sum(heights))
    if isinstance(condition, BitRange):
        return len(condition.contacts), 1
    return (0, 0) if isinstance(condition, Always) else (1, 1)


# ---------------------------------------------------------------------------------------------------- programs


@dataclass(frozen=True)
class Act:
    """One instruction: ``call`` as the program writes it, up to its pins, and its ladder token."""

    call: str
    token: str
    height: int = 1
    pins: tuple[tuple[str, Condition | None], ...] = ()
    """Keyword of each input and its condition, in the order of the box; None is left out."""

    @property
    def text(self) -> str:
        given = [f"{name}=lambda: {condition.text}" for name, condition in self.pins if condition is not None]
        return self.call if not given else f"{self.call[:-1]}, {', '.join(given)})"

    @property
    def tokens(self) -> list[str]:
        """What stands in the output column: a one-shot range is one coil for each bit."""
        match = re.fullmatch(r"out\(([A-Z]+)(\d+)\.\.[A-Z]+(\d+),oneshot=1\)", self.token)
        if not match:
            return [self.token]
        bits = range(int(match[2]), int(match[3]) + 1)
        return [f"out({ladder_name(match[1], number)},oneshot=1)" for number in bits]


PIN_TOKENS = {"reset": ".reset()", "count_down": ".down()", "clock": ".clock()"}


@dataclass(frozen=True)
class Branch:
    condition: Condition
    items: tuple[Item, ...]


@dataclass(frozen=True)
class Loop:
    """``for _ in range(count):`` around rungs; an open one stands last in its rung and ends at ``next_loop()``."""

    count: int
    body: tuple[Rung, ...]
    is_open: bool = False


Item = Act | Branch | Loop


@dataclass(frozen=True)
class Rung:
    condition: Condition
    items: tuple[Item, ...]


@dataclass(frozen=True)
class Program:
    """``main`` and ``subroutines`` without their last rungs, the unconditional ``end()`` and ``return``."""

    main: tuple[Rung, ...]
    subroutines: tuple[tuple[str, tuple[Rung, ...]], ...] = ()
    _cache: dict[str, str] = field(default_factory=dict, compare=False, repr=False)

    @property
    def text(self) -> str:
        if "text" not in self._cache:
            lines = ["def main():", *_rung_lines(self.main, 1), "    if True:", "        end()"]
            for name, rungs in self.subroutines:
                lines += ["", "", "@sub", f"def {name}():", *_rung_lines(rungs, 1), "    if True:", "        return"]
            self._cache["text"] = "\n".join(lines) + "\n"
        return self._cache["text"]

    def __repr__(self) -> str:
        """Hypothesis prints the program, not the model."""
        return f"\n{self.text}"


def _rung_lines(rungs: Sequence[Rung], depth: int) -> Iterator[str]:
    for rung in rungs:
        yield "    " * depth + f"if {rung.condition.text}:"
        yield from _item_lines(rung.items, depth + 1)
        last = rung.items[-1] if rung.items else None
        if isinstance(last, Loop) and last.is_open:
            yield from _rung_lines(last.body, depth)
            yield from (f"{'    ' * depth}if True:", f"{'    ' * depth}    next_loop()")


def _item_lines(items: Sequence[Item], depth: int) -> Iterator[str]:
    indent = "    " * depth
    for item in items:
        if isinstance(item, Act):
            yield indent + item.text
        elif isinstance(item, Branch):
            yield f"{indent}if {item.condition.text}:"
            yield from _item_lines(item.items, depth + 1)
        else:
            yield f"{indent}for _ in range({item.count}):"
            yield from [indent + "    pass"] if item.is_open else _rung_lines(item.body, depth + 1)


def acts(items: Sequence[Item]) -> Iterator[Act]:
    """Every instruction below these items in source order, loop bodies included."""
    for item in items:
        if isinstance(item, Act):
            yield item
        elif isinstance(item, Branch):
            yield from acts(item.items)
        else:
            for rung in item.body:
                yield from acts(rung.items)


def program_acts(program: Program) -> Iterator[Act]:
    for rungs in (program.main, *(rungs for _, rungs in program.subroutines)):
        for rung in rungs:
            yield from acts(rung.items)


# ---------------------------------------------------------------------------------------------------- names


def ladder_name(bank: str, number: int) -> str:
    return f"{bank}{number:03d}" if bank in ("X", "Y") else f"{bank}{number}"


def written(name: str) -> str:
    """A ladder name as the program writes it: ``X001`` is ``x[1]``."""
    bank = name.rstrip("0123456789")
    return f"{bank.lower()}[{int(name[len(bank) :])}]"


# ---------------------------------------------------------------------------------------------------- leaves

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


def _compare(left: tuple[str, str], op: str, right: tuple[str, str]) -> Compare:
    return Compare(f"{left[0]}{op}{right[0]}", f"{left[1]} {op} {right[1]}")


def _register(name: str) -> tuple[str, str]:
    return name, written(name)


OPERATORS = ("==", "!=", "<", "<=", ">", ">=")
_DECIMAL = [_register(name) for name in ("DS1", "DS4500", "DD1", "TD1", "CTD250", "SD9")]
_DECIMAL += [("5", "5"), ("-7", "-7"), ("32767", "32767")]
_HEX = [_register(name) for name in ("DH1", "DH500", "XD8", "YD0")] + [("00FFh", "0x00FF"), ("0005h", "5")]
_TEXT = [_register("TXT1"), _register("TXT1000"), ('"A"', '"A"'), ('","', '","')]
_FLOAT = [_register("DF1"), _register("DF500"), ("1.5", "1.5"), ("-0.25", "-0.25")]
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
    return _compare(left, draw(st.sampled_from(OPERATORS)), right)


T = TypeVar("T")


def weighted(*choices: tuple[int, st.SearchStrategy[T]]) -> st.SearchStrategy[T]:
    """One of some strategies, each as often as its weight says; the first is the simplest."""
    indices = [index for index, (weight, _) in enumerate(choices) for _ in range(weight)]
    return st.sampled_from(indices).flatmap(lambda index: choices[index][1])


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
    """Trees of ``all`` and ``any``, also of a single term and of their own kind inside."""
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
    """A strategy over a pool of at most so many different leaves, so that all their situations can be tried."""
    pools = st.lists(any_leaves, min_size=min(6, count), max_size=count, unique=True)
    return pools.map(st.sampled_from)


# ---------------------------------------------------------------------------------------------------- one CLICK rung

PLAIN_ACTS = (
    Act("out(y[1])", "out(Y001)"),
    Act("out(y[1].immediate)", "out(immediate(Y001))"),
    Act("out(y[1:5].immediate)", "out(immediate(Y001..Y004))"),
    Act("out(c[5:9])", "out(C5..C8)"),
    Act("out(c[5], oneshot=True)", "out(C5,oneshot=1)"),
    Act("out(c[5:8], one_shot=True)", "out(C5..C7,oneshot=1)", 3),
    Act("out(sc[50])", "out(SC50)"),
    Act("set(c[1])", "latch(C1)"),
    Act("set(y[1:5].immediate)", "latch(immediate(Y001..Y004))"),
    Act("reset(y[101])", "reset(Y101)"),
    Act("reset(c[1:2001])", "reset(C1..C2000)"),
    Act("copy(1, ds[1])", "copy(1,DS1)", 2),
    Act('copy("AB", txt[1], oneshot=True)', 'copy("AB",TXT1,oneshot=1)', 2),
    Act('copy("a,\\"b", txt[1])', 'copy("a,""b",TXT1)', 2),
    Act("copy(ds[ds[1]], dd[ds[2]])", "copy(DS[DS1],DD[DS2])", 2),
    Act("copy(5, dh[1])", "copy(0005h,DH1)", 2),
    Act("copy_block(ds[1:5], ds[100])", "blockcopy(DS1..DS4,DS100..DS103)", 2),
    Act("copy_fill(0, df[20:30])", "fill(0,DF20..DF29)", 2),
    Act("copy_pack(c[1:17], dh[1])", "pack_bits(C1..C16,DH1)", 2),
    Act("copy_unpack(dd[1], c[101:133])", "unpack_to_bits(DD1,C101..C132)", 2),
    Act('search(">=", 5, ds[1], ds[9], ds[20], c[3])', "search(DS1..DS9 >= 5,result=DS20,found=C3)", 2),
    Act('calc("(ds[1] + 2) * 3", ds[3])', "math(( DS1 + 2 ) * 3,DS3,mode=decimal)"),
    Act('math_hex("dh[1] AND 0x00FF", dh[2], oneshot=True)', "math(DH1 AND 00FFh,DH2,mode=hex,oneshot=1)"),
    Act("call(other)", 'call("other")'),
)
OWN_ACTS = (
    Act("ton(t[{}], 5, Ts)", "on_delay(T{0},TD{0},preset=5,unit=Ts)", 2),
    Act("tof(t[{}], setpoint=ds[7])", "off_delay(T{0},TD{0},preset=DS7,unit=Tms)", 2),
)
PINNED_ACTS = (
    (Act("rton(t[{}], 32767, unit=Td)", "on_delay(T{0},TD{0},preset=32767,unit=Td)", 2), ("reset",), (1,)),
    (Act("ctu(ct[{}], 5)", "count_up(CT{0},CTD{0},preset=5)", 3), ("reset",), (2,)),
    (Act("ctd(ct[{}], dd[5])", "count_down(CT{0},CTD{0},preset=DD5)", 3), ("reset",), (2,)),
    (Act("ctud(ct[{}], ds[5])", "count_up(CT{0},CTD{0},preset=DS5)", 3), ("count_down", "reset"), (1, 2)),
    (Act("shift(c[1:9])", "shift(C1..C8)", 3), ("clock", "reset"), (1, 2)),
    (Act("shift(c[8:0:-1])", "shift(C8..C1)", 3), ("clock", "reset"), (1, 2)),
)
REQUIRED_PIN = {"rton": ("reset",), "ctud": ("count_down",), "rtof": ("reset",)}
"""The inputs that cannot be left out."""


class Numbers:
    """Timer and counter numbers: each has one owner. Low ones are left for contacts."""

    def __init__(self, start: int = 10) -> None:
        self.last = start

    def next(self) -> int:
        self.last += 1
        return self.last

    def own(self, act: Act, pins: tuple[tuple[str, Condition | None], ...] = ()) -> Act:
        number = self.next()
        return Act(act.call.format(number), act.token.format(number), act.height, pins)


@st.composite
def plain_rungs(draw: st.DrawFn, numbers: Numbers | None = None) -> Rung:
    """A rung of plain instructions and branches that fits one CLICK rung."""
    leaf = draw(few_leaves(10))
    mine = numbers or Numbers()
    tree = conditions(leaf, draw(st.integers(1, 4)), 3, always=True, groups_weight=2)

    def items(depth: int) -> tuple[Item, ...]:
        found: list[Item] = []
        for _ in range(draw(st.integers(1, 4 if depth else 5))):
            kind = draw(st.integers(0, 9))
            if kind < 3 and depth < 4:
                found.append(Branch(draw(tree), items(depth + 1)))
            elif kind < 4:
                found.append(mine.own(draw(st.sampled_from(OWN_ACTS))))
            else:
                found.append(draw(st.sampled_from(PLAIN_ACTS)))
        return tuple(found)

    return Rung(draw(tree), items(0))


def rung_size(condition: Condition, items: Sequence[Item]) -> tuple[int, int]:
    """Columns of the longest path and rows of a rung of plain instructions."""
    width, height = size(condition)
    below, inner = 0, 0
    for item in items:
        if isinstance(item, Branch):
            columns, rows = rung_size(item.condition, item.items)
            inner, below = max(inner, columns), below + rows
        elif isinstance(item, Act):
            below += item.height
    return width + inner, max(height, below)


def fits(rung: Rung) -> bool:
    """Whether a plain rung surely fits one CLICK rung: the last column is left for the wire behind a merge."""
    width, height = rung_size(rung.condition, rung.items)
    return width <= 30 and height <= 32


@st.composite
def pinned_rungs(draw: st.DrawFn, numbers: Numbers | None = None) -> Rung:
    """A rung with one box that has inputs, its conditions as tall as one CLICK rung takes them."""
    leaf = draw(few_leaves(10))
    mine = numbers or Numbers()
    tree = conditions(leaf, draw(st.integers(1, 4)), 3, always=True, groups_weight=2)
    act, names, _ = draw(st.sampled_from(PINNED_ACTS))
    pins: list[tuple[str, Condition | None]] = []
    for name in names:
        optional = name not in REQUIRED_PIN.get(act.call.partition("(")[0], ())
        pin = None if optional and draw(st.integers(0, 5)) == 0 else draw(tree)
        if pin is not None and name != names[-1]:
            pin = _flat(pin)
        pins.append((name, pin))
    box: Item = mine.own(act, tuple(pins))
    for _ in range(draw(st.integers(0, 2))):
        box = Branch(draw(tree), (box,))
    return Rung(draw(tree), (box,))


def _flat(condition: Condition) -> Condition:
    """The same leaves in series: an input that is not the last has no room for legs."""
    if isinstance(condition, Group):
        return Group("all", tuple(_flat(term) for term in condition.terms))
    return condition


def pinned_fits(rung: Rung) -> bool:
    width, rows, item = 0, 0, Branch(rung.condition, rung.items)
    inner: Item = item
    while isinstance(inner, Branch):
        columns, legs = size(inner.condition)
        width, rows = width + columns, max(rows, legs)
        inner = inner.items[0]
    assert isinstance(inner, Act)
    sizes = [size(pin) for _, pin in inner.pins if pin is not None]
    last = inner.pins[-1][1]
    legs = size(last)[1] if last is not None else 1
    widest = max([width, *(one[0] for one in sizes)])
    return widest <= 30 and max(rows, 1) - 1 + inner.height + max(legs, 1) - 1 <= 32


@st.composite
def power_programs(draw: st.DrawFn) -> Program:
    """Programs of which every rung is one CLICK rung."""
    numbers = Numbers()
    rungs = []
    for _ in range(draw(st.integers(1, 3))):
        if draw(st.booleans()):
            rung = draw(plain_rungs(numbers).filter(fits))
        else:
            rung = draw(pinned_rungs(numbers).filter(pinned_fits))
        rungs.append(rung)
    return Program(tuple(rungs), (("other", ()),))


# ---------------------------------------------------------------------------------------------------- meaning


@dataclass(frozen=True)
class World:
    """What a program for the scan tests may look at."""

    flags: bool = False
    """Conditions may read the status bits that copies and formulas set; then formulas read no pointers."""
    immediates: str = "anywhere"
    """Where immediate contacts may stand: "anywhere", "rungs" (a rung's first condition only) or "nowhere"."""


def world_leaves(world: World, timers: Sequence[int], immediate: bool = False) -> st.SearchStrategy[Condition]:
    bits = ["X001", "X002", "C1", "C2", "C3", "Y001", f"T{timers[0]}", f"CT{timers[2]}"]
    if world.flags:
        bits += ["SC43", "SC40", "SC43", "SC44"]
    registers = [_register(name) for name in ("DS1", "DS2", "DS3", "DD1", "TD11", "CTD13")]
    numbers = [*registers, *((str(n), str(n)) for n in range(4))]
    decimal = st.builds(_compare, st.sampled_from(registers), st.sampled_from(OPERATORS), st.sampled_from(numbers))
    others = (Compare("DS1!=0", "ds[1]"), Compare("YD0==0001h", "yd[0] == 1"), Compare("DH1>0001h", "dh[1] > 0x0001"))
    ranges = bit_ranges(("C", "Y", "X"), 3).filter(lambda one: not one.immediate)
    return weighted(
        (6, contacts(bits)),
        (2, decimal),
        (1, st.sampled_from(others)),
        (1, ranges),
        (2, immediates(("X001", "X002")) if immediate else contacts(bits)),
    )


WORLD_ACTS = (
    *(
        Act(f"{word}({written(bit)})", f"{token}({bit})")
        for word, token in (("out", "out"), ("set", "latch"), ("reset", "reset"))
        for bit in ("C1", "C2", "C3", "Y001")
    ),
    Act("out(c[1:4])", "out(C1..C3)"),
    Act("reset(c[1:4])", "reset(C1..C3)"),
    Act("out(c[2], oneshot=True)", "out(C2,oneshot=1)"),
    Act("out(c[1:4], oneshot=True)", "out(C1..C3,oneshot=1)"),
    Act("out(y[1].immediate)", "out(immediate(Y001))"),
    Act("copy(1, ds[1])", "copy(1,DS1)", 2),
    Act("copy(0, ds[1])", "copy(0,DS1)", 2),
    Act("copy(ds[1], ds[2])", "copy(DS1,DS2)", 2),
    Act("copy(3, dd[1], oneshot=True)", "copy(3,DD1,oneshot=1)", 2),
    Act("copy(x[1], c[1])", "copy(X001,C1)", 2),
    Act("copy(ds[ds[1]], ds[3])", "copy(DS[DS1],DS3)", 2),
    Act("copy(ds[2], ds[ds[1]])", "copy(DS2,DS[DS1])", 2),
    *(Act("copy(c[1], c[ds[1]])", "copy(C1,C[DS1])", 2),) * 3,
    *(Act("copy(dh[1], yd[0])", "copy(DH1,YD0)", 2),) * 3,
    Act("copy_fill(2, ds[1:4])", "fill(2,DS1..DS3)", 2),
    Act("copy_block(c[1:4], y[1])", "blockcopy(C1..C3,Y001..Y003)", 2),
    Act("copy_unpack(dh[1], c[1:4])", "unpack_to_bits(DH1,C1..C3)", 2),
    Act("copy_pack(c[1:4], dh[1])", "pack_bits(C1..C3,DH1)", 2),
    Act('calc("ds[1] + 1", ds[1])', "math(DS1 + 1,DS1,mode=decimal)"),
    Act('calc("ds[2] + ds[1]", ds[2], oneshot=True)', "math(DS2 + DS1,DS2,mode=decimal,oneshot=1)"),
    Act('search("==", 1, ds[1], ds[3], ds[2], c[4])', "search(DS1..DS3 == 1,result=DS2,found=C4)", 2),
)
POINTER_FORMULAS = (
    Act('calc("ds[ds[1]] + 1", ds[2])', "math(DS[DS1] + 1,DS2,mode=decimal)"),
    Act('calc("ds[ds[1]] + ds[ds[2]]", ds[1], oneshot=True)', "math(DS[DS1] + DS[DS2],DS1,mode=decimal,oneshot=1)"),
)
WORLD_BOXES: tuple[tuple[Act, tuple[str, ...]], ...] = (
    (Act("ton(t[{}], 2)", "on_delay(T{0},TD{0},preset=2,unit=Tms)", 2), ()),
    (Act("tof(t[{}], ds[1])", "off_delay(T{0},TD{0},preset=DS1,unit=Tms)", 2), ()),
    (Act("rton(t[{}], 2, Ts)", "on_delay(T{0},TD{0},preset=2,unit=Ts)", 2), ("reset",)),
    (Act("rtof(t[{}], 2, Ts)", "off_delay(T{0},TD{0},preset=2,unit=Ts)", 2), ("reset",)),
    (Act("ctu(ct[{}], 2)", "count_up(CT{0},CTD{0},preset=2)", 3), ("reset",)),
    (Act("ctd(ct[{}], ds[2])", "count_down(CT{0},CTD{0},preset=DS2)", 3), ("reset",)),
    (Act("ctud(ct[{}], 2)", "count_up(CT{0},CTD{0},preset=2)", 3), ("count_down", "reset")),
    (Act("shift(c[1:4])", "shift(C1..C3)", 3), ("clock", "reset")),
    (Act("shift(c[3:0:-1])", "shift(C3..C1)", 3), ("clock", "reset")),
)
BOX_NUMBERS = {"T": (11, 12), "CT": (13, 14)}


@st.composite
def large_conditions(draw: st.DrawFn, leaf: st.SearchStrategy[Condition]) -> Condition:
    """More than 31 columns or 32 rows, of few different leaves so that it is not always false or always true."""
    pool = draw(st.lists(leaf, min_size=1, max_size=3))
    some = st.sampled_from(pool)
    word, other = draw(st.sampled_from((("all", "any"), ("any", "all"))))
    count = draw(st.sampled_from((29, 30, 31, 32, 33, 34, 62, 63, 70)))
    shape = draw(st.integers(0, 3))
    terms: list[Condition] = [draw(some) for _ in range(3)]
    terms = [terms[index % 3] for index in range(count)]
    if shape == 1:
        inner = Group(other, tuple(draw(st.lists(some, min_size=2, max_size=4))))
        terms[draw(st.integers(0, count - 1))] = inner
    elif shape == 2:
        inner = Group(other, tuple(terms[: draw(st.sampled_from((5, 31, 33)))]))
        terms = [draw(some), inner, draw(some), inner]
    elif shape == 3:
        step = draw(st.integers(2, 9))
        terms = [Group(other, tuple(terms[at : at + step])) for at in range(0, count, step)]
    return Group(word, tuple(terms))


def _world_items(world: World, place: str, large: bool) -> st.SearchStrategy[Rung]:
    """Rungs of main or of a subroutine; their boxes have no numbers yet."""
    numbers = tuple(number for some in BOX_NUMBERS.values() for number in some)
    conditions_of = {}
    for where, immediate in (("rung", world.immediates != "nowhere"), ("branch", world.immediates == "anywhere")):
        leaf = world_leaves(world, numbers, immediate)
        tree = conditions(leaf, 2, 3, always=True)
        conditions_of[where] = weighted((24, tree), (1, large_conditions(leaf))) if large else tree
    branch, pin = conditions_of["branch"], conditions_of["branch"]
    plain: st.SearchStrategy[Item] = st.sampled_from(WORLD_ACTS if world.flags else (*WORLD_ACTS, *POINTER_FORMULAS))
    none: st.SearchStrategy[Condition | None] = st.none()
    boxes: list[st.SearchStrategy[Item]] = []
    for act, names in WORLD_BOXES:
        required = REQUIRED_PIN.get(act.call.partition("(")[0], ())
        inputs = [
            st.tuples(st.just(name), pin if name in required else weighted((5, pin), (1, none))) for name in names
        ]
        boxes.append(st.builds(Act, st.just(act.call), st.just(act.token), st.just(act.height), st.tuples(*inputs)))
    leave: st.SearchStrategy[Item]
    if place == "main":
        leave = st.sampled_from((Act("call(other)", 'call("other")'),) * 2 + (Act("end()", "end()"),))
    else:
        leave = st.just(Act("return", "return()"))
    leaves_if: st.SearchStrategy[Item] = st.builds(lambda one, act: Branch(one, (act,)), branch, leave)
    item = weighted((5, plain), (4, st.one_of(boxes)), (1, leave), (1, leaves_if))

    # Something that changes or leaves, and behind it something that a split could be wrong about.
    box = st.one_of(boxes)
    then = weighted((3, box), (1, st.builds(lambda one, act: Branch(one, (act,)), branch, box)))
    two = st.tuples(weighted((2, plain), (2, leaves_if), (1, leave)), then)

    def rungs(inner: st.SearchStrategy[Item]) -> st.SearchStrategy[Rung]:
        loop_or_item = inner
        for _ in range(2):
            some = st.lists(inner, min_size=1, max_size=3).map(tuple)
            inner = weighted((3, item), (2, st.builds(Branch, branch, some)), (1, loop_or_item))
        few, more = (st.lists(inner, min_size=low, max_size=high).map(tuple) for low, high in ((1, 3), (3, 5)))
        return st.builds(Rung, conditions_of["rung"], weighted((1, few), (3, more), (3, two)))

    body = st.lists(rungs(item), min_size=1, max_size=2).map(tuple)
    closed = rungs(weighted((2, item), (1, st.builds(Loop, st.integers(1, 3), body))))
    opened = st.builds(Loop, st.integers(1, 3), body, st.just(True))
    with_open = st.builds(lambda rung, loop: Rung(rung.condition, (*rung.items, loop)), closed, opened)
    return weighted((9, closed), (1, with_open))


def _numbered(program: Program) -> Program:
    """The same program with a number for each timer and counter; those beyond what there is become coils."""
    free = {bank: list(numbers) for bank, numbers in BOX_NUMBERS.items()}
    off_delays: list[int] = []

    def item(one: Item) -> Item:
        if isinstance(one, Branch):
            return Branch(one.condition, tuple(map(item, one.items)))
        if isinstance(one, Loop):
            return Loop(one.count, tuple(map(rung, one.body)), one.is_open)
        if "{}" not in one.call:
            return one
        numbers = free["CT" if "ct[" in one.call else "T"]
        if not numbers:
            return WORLD_ACTS[0]
        number = numbers.pop(0)
        if one.call.startswith("rtof"):
            off_delays.append(number)
        return Act(one.call.format(number), one.token.format(number), one.height, one.pins)

    def rung(one: Rung) -> Rung:
        return Rung(one.condition, tuple(map(item, one.items)))

    main = tuple(map(rung, program.main))
    subroutines = tuple((name, tuple(map(rung, rungs))) for name, rungs in program.subroutines)
    shown = tuple(Rung(Contact(f"T{n}"), (Act(f"out(c[{20 + n}])", f"out(C{20 + n})"),)) for n in off_delays)
    return Program((*main, *shown), subroutines)


def meaning_programs(immediate_places: str = "anywhere", large: bool = True) -> st.SearchStrategy[Program]:
    """Programs whose rungs write what they read: boxes with inputs, calls, loops, returns, conditions too large."""
    kinds: list[st.SearchStrategy[Program]] = []
    for flags in (False, False, True):
        world = World(flags, immediates=immediate_places)
        main = st.lists(_world_items(world, "main", large), min_size=1, max_size=2).map(tuple)
        other = st.lists(_world_items(world, "other", large), max_size=2).map(tuple)
        kinds.append(st.builds(Program, main, other.map(lambda rungs: (("other", rungs),))))
    return st.one_of(kinds).map(_numbered)
