"""Programs for the scan tests: their rungs write what their conditions and inputs read."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from hypothesis import strategies as st

from strategies.boxes import CLOCKED, DOWN, MUST_RESET, RESET, Box, DrumCells, drums, with_inputs
from strategies.conditions import (
    OPERATORS,
    Compare,
    Condition,
    Contact,
    Group,
    bit_ranges,
    compared,
    conditions,
    contacts,
    immediates,
    register,
    weighted,
    written,
)
from strategies.programs import Act, Branch, Item, Loop, Program, Rung


@dataclass(frozen=True)
class World:
    """The addresses that a program for the scan tests may look at."""

    flags: bool = False
    """Conditions may read the status bits that copies and formulas set; then clickgen must need no copy of its own."""
    immediates: str = "anywhere"
    """Where immediate contacts may be: "anywhere", "rungs" (a rung's first condition only) or "nowhere"."""


BOX_NUMBERS = {"T": (11, 12, 15), "CT": (13, 14)}


def world_leaves(world: World, immediate: bool = False) -> st.SearchStrategy[Condition]:
    bits = ["X001", "X002", "C1", "C2", "C3", "Y001", f"T{BOX_NUMBERS['T'][0]}", f"CT{BOX_NUMBERS['CT'][0]}", "SC7"]
    if world.flags:
        bits += ["SC43", "SC40", "SC43", "SC44"]
    registers = [register(name) for name in ("DS1", "DS2", "DS3", "DD1", "TD11", "CTD13", "SD26")]
    numbers = [*registers, *((str(n), str(n)) for n in range(4))]
    decimal = st.builds(compared, st.sampled_from(registers), st.sampled_from(OPERATORS), st.sampled_from(numbers))
    others = (Compare("DS1!=0", "ds[1]"), Compare("YD0==0001h", "yd[0] == 1"), Compare("DH1>0001h", "dh[1] > 0x0001"))
    texts = st.builds(
        compared,
        st.sampled_from([register(f"TXT{number}") for number in (1, 2, 3)]),
        st.sampled_from(OPERATORS),
        st.sampled_from((('"0"', '"0"'), ('"1"', '"1"'))),
    )
    ranges = bit_ranges(("C", "Y", "X"), 3).filter(lambda one: not one.immediate)
    return weighted(
        (6, contacts(bits)),
        (2, decimal),
        (1, st.sampled_from(others)),
        (1, texts),
        (1, ranges),
        (2, immediates(("X001", "X002")) if immediate else contacts(bits)),
    )


_TO_TEXT = "convert=to_text(suppress_zero={},exponential=0,termination_code={})"
_TCP = 'ModbusTcpTarget(ip="10.0.0.2")'
_TCP_TOKEN = 'target=ModbusTcpTarget(name="tcp",ip="10.0.0.2",port=502,device_id=1)'

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
    Act("search(ds[1:4] >= ds[2], result=ds[1], found=c[1])", "search(DS1..DS3 >= DS2,result=DS1,found=C1)", 2),
    Act(
        "search(2 > ds[1:4], ds[3], c[2], continuous=True)",
        "search(DS1..DS3 < 2,result=DS3,found=C2,continuous=1)",
        2,
    ),
)
WORLD_COUNTS = (
    Act("copy(0, td[11])", "copy(0,TD11)", 2),
    Act("copy(2, ctd[13])", "copy(2,CTD13)", 2),
    Act("copy(ds[1], ctd[13], oneshot=True)", "copy(DS1,CTD13,oneshot=1)", 2),
    Act("copy_fill(3, td[10:13])", "fill(3,TD10..TD12)", 2),
    Act("copy_block(ds[1:3], ctd[12])", "blockcopy(DS1..DS2,CTD12..CTD13)", 2),
    Act('calc("ds[1] + ds[2]", ctd[13])', "math(DS1 + DS2,CTD13,mode=decimal)"),
    Act('calc("ctd[13] + 1", td[11])', "math(CTD13 + 1,TD11,mode=decimal)"),
    Act("copy(ds[1], td[ds[2]])", "copy(DS1,TD[DS2])", 2),
)
"""Instructions that write current values of timers and counters."""
WORLD_TEXTS = (
    Act('copy("10", txt[1])', 'copy("10",TXT1)', 2),
    Act("copy(ds[1].as_text(), txt[1])", f"copy(DS1,TXT1,{_TO_TEXT.format(1, 'none')})", 2),
    Act(
        'copy(ds[2].as_text(termination_code="$31"), txt[1], oneshot=True)',
        f"copy(DS2,TXT1,oneshot=1,{_TO_TEXT.format(1, '$31')})",
        2,
    ),
    Act("copy(ds[2].as_text(pad=5), txt[1])", f"copy(DS2,TXT1,{_TO_TEXT.format(0, 'none')})", 2),
    Act("copy(txt[2].as_value(), ds[1])", "copy(TXT2,DS1,convert=to_value)", 2),
    Act("copy_block(txt[1:4].as_value(), ds[1])", "blockcopy(TXT1..TXT3,DS1..DS3,convert=to_value)", 2),
)
WORLD_MESSAGES = (
    Act(
        f'receive({_TCP}, "DS1", ds[1:4], receiving=c[1], success=c[2], error=c[3])',
        f'receive({_TCP_TOKEN},remote_start="DS1",dest=DS1..DS3,receiving=C1,success=C2,error=C3)',
        3,
    ),
    Act(
        f'receive({_TCP}, "C1", c[1:4], exception_response=ds[2])',
        f'receive({_TCP_TOKEN},remote_start="C1",dest=C1..C3,exception_response=DS2)',
        3,
    ),
    Act(
        f'receive({_TCP}, "Y001", y[1], success=c[1])',
        f'receive({_TCP_TOKEN},remote_start="Y001",dest=Y001,success=C1)',
        3,
    ),
    Act(
        f'send({_TCP}, "DS1", ds[1], sending=c[1], error=c[2], exception_response=ds[1])',
        f'send({_TCP_TOKEN},remote_start="DS1",source=DS1,sending=C1,error=C2,exception_response=DS1)',
        3,
    ),
    Act(
        f'send({_TCP}, "C1", c[1:4], success=c[3])',
        f'send({_TCP_TOKEN},remote_start="C1",source=C1..C3,success=C3)',
        3,
    ),
)
POINTER_FORMULAS = (
    Act('calc("ds[ds[1]] + 1", ds[2])', "math(DS[DS1] + 1,DS2,mode=decimal)"),
    Act('calc("ds[ds[1]] + ds[ds[2]]", ds[1], oneshot=True)', "math(DS[DS1] + DS[DS2],DS1,mode=decimal,oneshot=1)"),
)
WORLD_BOXES = (
    Box(Act("ton(t[{}], 2)", "on_delay(T{0},TD{0},preset=2,unit=Tms)", 2), ()),
    Box(Act("tof(t[{}], ds[1])", "off_delay(T{0},TD{0},preset=DS1,unit=Tms)", 2), ()),
    Box(Act("rton(t[{}], 2, Ts)", "on_delay(T{0},TD{0},preset=2,unit=Ts)", 2), (MUST_RESET,)),
    Box(Act("rtof(t[{}], 2, Ts)", "off_delay(T{0},TD{0},preset=2,unit=Ts)", 2), (MUST_RESET,)),
    Box(Act("ctu(ct[{}], 2)", "count_up(CT{0},CTD{0},preset=2)", 3), (RESET,)),
    Box(Act("ctd(ct[{}], ds[2])", "count_down(CT{0},CTD{0},preset=DS2)", 3), (RESET,)),
    Box(Act("ctud(ct[{}], 2)", "count_up(CT{0},CTD{0},preset=2)", 3), (DOWN, RESET)),
    Box(Act("shift(c[1:4])", "shift(C1..C3)", 3), CLOCKED),
    Box(Act("shift(c[3:0:-1])", "shift(C3..C1)", 3), CLOCKED),
)
_DRUM_EVENTS = (("X", 1), ("X", 2), ("C", 1), ("C", 2), ("C", 3), ("Y", 1), ("T", 11), ("CT", 13))


def world_drums(world: World) -> st.SearchStrategy[Box]:
    """Drums over the bits and registers of the world."""
    outputs = (("C", 1), ("C", 2), ("C", 3), ("Y", 1))
    cells = DrumCells(outputs, _DRUM_EVENTS, (1, 2, 3), (1, 2, 3, 4), (1, 2), not world.flags, 3)
    return drums(cells)


@st.composite
def large_conditions(draw: st.DrawFn, leaf: st.SearchStrategy[Condition]) -> Condition:
    """More than 31 columns or 32 rows, with few different leaves so that it is not always false or always true."""
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
    conditions_of = {}
    for where, immediate in (("rung", world.immediates != "nowhere"), ("branch", world.immediates == "anywhere")):
        leaf = world_leaves(world, immediate)
        tree = conditions(leaf, 2, 3, always=True)
        conditions_of[where] = weighted((24, tree), (1, large_conditions(leaf))) if large else tree
    branch, pin = conditions_of["branch"], conditions_of["branch"]
    acts = WORLD_ACTS if world.flags else (*WORLD_ACTS, *POINTER_FORMULAS)
    plain: st.SearchStrategy[Item] = weighted(
        (6, st.sampled_from(acts)),
        (2, st.sampled_from(WORLD_MESSAGES)),
        (2, st.sampled_from(WORLD_COUNTS)),
        (1, st.sampled_from(WORLD_TEXTS)),
    )
    boxes: list[st.SearchStrategy[Item]] = [with_inputs(box, pin) for box in WORLD_BOXES]
    drum: st.SearchStrategy[Item] = world_drums(world).flatmap(lambda box: with_inputs(box, pin))
    box = weighted((3, st.one_of(boxes)), (2, drum))
    leave: st.SearchStrategy[Item]
    if place == "main":
        calls = (Act("call(other)", 'call("other")'), Act("call(third)", 'call("third")'))
        leave = st.sampled_from((*calls, Act("end()", "end()")))
    else:
        leave = st.just(Act("return", "return()"))
    leaves_if: st.SearchStrategy[Item] = st.builds(lambda one, act: Branch(one, (act,)), branch, leave)
    item = weighted((5, plain), (4, box), (1, leave), (1, leaves_if))

    # Something that changes or leaves, and after it something that a split could get wrong.
    then = weighted((3, box), (1, st.builds(lambda one, act: Branch(one, (act,)), branch, box)))
    two = st.tuples(weighted((2, plain), (1, drum), (2, leaves_if), (1, leave)), then)

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
    """Return the program with a number for each timer, counter and drum; those beyond the last number become coils."""
    free = {bank: list(numbers) for bank, numbers in BOX_NUMBERS.items()}
    off_delays: list[int] = []

    def item(one: Item) -> Item:
        if isinstance(one, Branch):
            return Branch(one.condition, tuple(map(item, one.items)))
        if isinstance(one, Loop):
            return Loop(one.count, tuple(map(rung, one.body)), one.is_open)
        if "{}" not in one.call:
            return one
        numbers = free["CT" if "ct[{}" in one.call else "T"]
        if not numbers:
            return WORLD_ACTS[0]
        number = numbers.pop(0)
        if one.call.startswith("rtof"):
            off_delays.append(number)
        return one.numbered(number)

    def rung(one: Rung) -> Rung:
        return Rung(one.condition, tuple(map(item, one.items)))

    main = tuple(map(rung, program.main))
    subroutines = tuple((name, tuple(map(rung, rungs))) for name, rungs in program.subroutines)
    shown = tuple(Rung(Contact(f"T{n}"), (Act(f"out(c[{20 + n}])", f"out(C{20 + n})"),)) for n in off_delays)
    return Program((*main, *shown), subroutines, program.modules, program.wiring)


_FILES: Sequence[tuple[str, str]] = (("", ""), ("", ""), ("", ""), ("parts", ""), ("parts", "parts"), ("parts", "more"))
"""The files of the two subroutines."""


def meaning_programs(immediate_places: str = "anywhere", large: bool = True) -> st.SearchStrategy[Program]:
    """Programs of one to four files: boxes with inputs, calls, loops, returns, conditions too large."""
    kinds: list[st.SearchStrategy[Program]] = []
    for flags in (False, False, True):
        world = World(flags, immediates=immediate_places)
        main = st.lists(_world_items(world, "main", large), min_size=1, max_size=2).map(tuple)
        other = st.lists(_world_items(world, "other", large), max_size=2).map(tuple)
        third = st.lists(_world_items(world, "other", large), max_size=1).map(tuple)
        routines = st.builds(lambda two, three: (("other", two), ("third", three)), other, third)
        wiring = st.sampled_from((False, False, True))
        kinds.append(st.builds(Program, main, routines, st.sampled_from(_FILES), wiring))
    return st.one_of(kinds).map(_numbered)
