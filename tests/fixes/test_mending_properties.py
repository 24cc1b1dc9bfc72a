"""A program after ``check --fix`` does what the person meant, scan by scan (``judges.mending``)."""

from __future__ import annotations

from pathlib import Path

import pytest
from budget import examples
from hypothesis import given, note
from judges.mending import check_fix_stays_in_its_statement, check_mended, findings, mended
from strategies.conditions import BitRange, Compare, Condition, Contact, Group, Logic
from strategies.mending import Mending, mendings
from strategies.programs import Act, Arm, Branch, Item, Program, Rung


@given(mendings())
@examples(15)
def test_safe_fixes_keep_the_meaning(mending: Mending) -> None:
    note(mending.text)
    check_mended(mending)


@given(mendings())
@examples(15)
def test_a_fix_changes_its_statement_alone_and_is_done_once(mending: Mending) -> None:
    texts = {name: _commented(text) for name, text in mending.texts.items()}
    note("\n".join(texts.values()))
    for finding in findings(texts):
        if finding.fix:
            check_fix_stays_in_its_statement(texts[Path(finding.fix.edits[0].span.path).name], finding)
    after, _ = mended(texts, lambda _: True)
    assert mended(after, lambda _: True) == (after, {})


def _commented(text: str) -> str:
    """A program with a comment of its own after each line of code."""
    lines = text.split("\n")
    return "\n".join(f"{line}  # {number} and (" if line.strip() else line for number, line in enumerate(lines, 1))


C1, C2, X1 = Contact("C1"), Contact("C2"), Contact("X001")
STEP = Compare("DS1==1", "ds[1] == 1")


def _out(number: int) -> Act:
    return Act(f"out(c[{number}])", f"out(C{number})")


def _copy(value: int, number: int) -> Act:
    return Act(f"copy({value}, ds[{number}])", f"copy({value},DS{number})", 2)


def _else(test: Condition, one: Item, other: Item) -> Rung:
    return Rung(test, (one,), (Arm(None, (other,)),))


FILL = Act("copy_fill(1, ds[1:4])", "fill(1,DS1..DS3)", 2)
CALL = Act("call(other)", 'call("other")')
MENDED: dict[str, tuple[Rung | Program, tuple[tuple[str, str], ...]]] = {
    "an else": (_else(C1, _out(2), _out(3)), ()),
    "an else of a step": (_else(STEP, _copy(5, 2), _copy(7, 3)), ()),
    "an else behind a block beside it": (_else(STEP, _copy(5, 2), _copy(7, 3)), (("ds[1]", "ds.Row[0]"),)),
    "an else of a bit of a block": (_else(C1, _out(5), _out(6)), (("c[1]", "c.Bits[0]"),)),
    "and, or, not": (
        Rung(Logic("or", (Logic("and", (C1, X1)), Logic("not", (Logic("and", (C2, STEP)),)))), (_out(5),)),
        (("c[2]", "c.Bits[1]"),),
    ),
    "terms said twice": (Rung(Group("all", (C1, X1, C1, Group("any", (C2, X1, C2)))), (_out(5),)), ()),
    "an else of a branch": (Rung(X1, (Branch(C1, (_out(1),), (Arm(C2, (_out(5),)), Arm(None, (_out(6),)))),)), ()),
    "an else behind a call": (
        Program((_else(C1, CALL, _out(5)),), (("other", (Rung(X1, (_out(6),)),)),), ("parts",)),
        (),
    ),
}
"""Programs that safe fixes can correct."""


@pytest.mark.parametrize("name", MENDED)
def test_what_is_sure_is_mended(name: str) -> None:
    made, words = MENDED[name]
    assert check_mended(Mending(made if isinstance(made, Program) else Program((made,)), words))


LEFT: dict[str, tuple[Rung | Program, tuple[tuple[str, str], ...]]] = {
    "an else behind a block over what it asks": (
        _else(STEP, FILL, _out(5)),
        (("ds[1]", "ds.Step"), ("ds[1:4]", "ds.Row")),
    ),
    "an else of a block": (_else(BitRange("C", 1, 3), _out(5), _out(6)), (("c[1:4]", "c.Bits"),)),
    "not of a block": (Rung(Logic("not", (BitRange("C", 1, 3),)), (_out(5),)), (("c[1:4]", "c.Bits"),)),
    "an else behind a call that writes what it asks": (
        Program((_else(C1, CALL, _out(5)),), (("other", (Rung(X1, (_out(1),)),)),), ("parts",)),
        (),
    ),
    "an else of a counter": (
        _else(Contact("CT13"), Act("copy(0, ctd[13])", "copy(0,CTD13)", 2), _out(5)),
        (("ctd[13]", "ctd.Count"),),
    ),
}
"""Programs that a person has to correct."""


@pytest.mark.parametrize("name", LEFT)
def test_what_is_not_sure_is_left(name: str) -> None:
    made, words = LEFT[name]
    assert not check_mended(Mending(made if isinstance(made, Program) else Program((made,)), words))
