"""Programs in which every rung is one CLICK rung, except for a drum's constant step."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from hypothesis import strategies as st

from strategies.boxes import PINNED, drums, pinned, pins_of
from strategies.conditions import Condition, Contact, conditions, few_leaves, flat, leaves, size, weighted
from strategies.instructions import OWN_ACTS, plain_acts
from strategies.programs import Act, Branch, Item, Numbers, Program, Rung


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
                found.append(draw(st.sampled_from(OWN_ACTS)).numbered(mine.next()))
            else:
                found.append(draw(plain_acts))
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
    """True if a plain rung surely fits one CLICK rung: the last column is left for the wire after a merge."""
    width, height = rung_size(rung.condition, rung.items)
    return width <= 30 and height <= 32


@st.composite
def pinned_rungs(draw: st.DrawFn, numbers: Numbers | None = None) -> Rung:
    """A rung with one box that has inputs, its conditions as tall as one CLICK rung takes."""
    leaf = draw(few_leaves(10))
    mine = numbers or Numbers()
    tree = conditions(leaf, draw(st.integers(1, 4)), 3, always=True, groups_weight=2)
    box = draw(weighted((1, st.sampled_from(PINNED)), (1, drums())))
    act = pinned(box, pins_of(draw, box, tree, tree.map(flat)), draw(st.booleans()))
    found: Item = act.numbered(mine.next())
    for _ in range(draw(st.integers(0, 2))):
        found = Branch(draw(tree), (found,))
    return _settled(Rung(draw(tree), (found,)))


def _settled(rung: Rung) -> Rung:
    """An immediate contact may change while the step of a jump is copied; after the copy it needs a scratch bit."""
    branches, act = _taken_apart(rung)
    if not act.constant_step:
        return rung
    conditions = [*branches, *(pin.condition for pin in act.pins if pin.condition is not None)]
    if not any(isinstance(leaf, Contact) and leaf.immediate for one in conditions for leaf in leaves(one)):
        return rung
    pins = tuple(replace(pin, step="DS5") if pin.step else pin for pin in act.pins)
    item: Item = replace(act, pins=pins)
    for condition in reversed(branches[1:]):
        item = Branch(condition, (item,))
    return Rung(rung.condition, (item,))


def _taken_apart(rung: Rung) -> tuple[list[Condition], Act]:
    """The nested conditions around a rung's only instruction."""
    branches, item = [rung.condition], rung.items[0]
    while isinstance(item, Branch):
        branches.append(item.condition)
        item = item.items[0]
    assert isinstance(item, Act)
    return branches, item


def pinned_fits(rung: Rung) -> bool:
    branches, act = _taken_apart(rung)
    enables = [size(condition) for condition in branches]
    width, legs_above = sum(columns for columns, _ in enables), max(rows for _, rows in enables)
    pins = [size(pin.condition) for pin in act.pins if pin.condition is not None]
    legs_below = max([1, *(rows for _, rows in pins)])  # only the last has any
    widest = max([width, *(columns for columns, _ in pins)])
    return widest <= 30 and max(legs_above, 1) - 1 + act.height + legs_below - 1 <= 32


@st.composite
def power_programs(draw: st.DrawFn) -> Program:
    """Main and a subroutine, which may be in a file of its own."""
    numbers = Numbers()

    def rungs(least: int, most: int) -> tuple[Rung, ...]:
        plain, boxed = plain_rungs(numbers).filter(fits), pinned_rungs(numbers).filter(pinned_fits)
        return tuple(draw(boxed if draw(st.booleans()) else plain) for _ in range(draw(st.integers(least, most))))

    main = rungs(1, 3)
    if draw(st.integers(0, 4)):
        return Program(main, (("other", ()),))
    # A subroutine calls none, so its calls are left out.
    module = draw(st.sampled_from(("", "parts")))
    return Program(main, (("other", tuple(map(_without_calls, rungs(0, 1)))),), (module,), draw(st.booleans()))


def _without_calls(rung: Rung) -> Rung:
    def kept(items: Sequence[Item]) -> tuple[Item, ...]:
        found: list[Item] = []
        for item in items:
            if isinstance(item, Branch):
                found.append(Branch(item.condition, kept(item.items)))
            elif isinstance(item, Act) and item.token.startswith("call("):
                found.append(Act("out(y[1])", "out(Y001)"))
            else:
                found.append(item)
        return tuple(found)

    return Rung(rung.condition, kept(rung.items))
