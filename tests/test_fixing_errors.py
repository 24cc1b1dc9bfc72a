"""The fixes of errors: what they write builds, means what was meant, and every other byte stands."""

from __future__ import annotations

import tempfile
from pathlib import Path

import pytest
from hypothesis import given, note, settings
from hypothesis import strategies as st
from mended import NAMES, assert_builds, fixed, found, rung, truth_table

# -- and, or, not ------------------------------------------------------------------------------------------------------

REWRITTEN = [
    ("c.A and c.B", "all(c.A, c.B)"),
    ("c.A or c.B or c.C", "any(c.A, c.B, c.C)"),
    ("c.A & c.B & c.C", "all(c.A, c.B, c.C)"),
    ("c.A | (c.B | c.C)", "any(c.A, c.B, c.C)"),
    ("not c.A", "nc(c.A)"),
    ("~c.A", "nc(c.A)"),
    ("not c.A and c.B", "all(nc(c.A), c.B)"),
    ("~c.A & ~(c.B)", "all(nc(c.A), nc(c.B))"),
    ("c.A and (c.B or c.C)", "all(c.A, any(c.B, c.C))"),
    ("(c.A or c.B) and not (c.C or c.D)", "all(any(c.A, c.B), nc(c.C), nc(c.D))"),
    ("c.A and c.B or c.C", "any(all(c.A, c.B), c.C)"),
    ("((c.A or c.B)) and ((c.C and c.D))", "all((any(c.A, c.B)), c.C, c.D)"),
    ("not (c.A and c.B)", "any(nc(c.A), nc(c.B))"),
    ("not ((c.A and (c.B or c.C)))", "any(nc(c.A), all(nc(c.B), nc(c.C)))"),
    ("not not c.A", "c.A"),
    ("not nc(c.A)", "c.A"),
    ("not all(c.A, c.B)", "any(nc(c.A), nc(c.B))"),
    ("not any( c.A,c.B or c.C, )", "all( nc(c.A),nc(c.B), nc(c.C), )"),
    ("ds.A  ==  5 or not ds.A<=7", "any(ds.A  ==  5, ds.A>7)"),
    ("not (ds.A != ds.B) and not 5 > (ds.A)", "all((ds.A == ds.B), 5 <= (ds.A))"),
    ("not ds.A and not df.B and not dh.C", "all(ds.A == 0, df.B == 0, dh.C == 0)"),
    ("all(c.A, c.B) and c.C", "all(all(c.A, c.B), c.C)"),
    ("any(c.A and c.B, re(c.C)) or fe(c.D)", "any(any(all(c.A, c.B), re(c.C)), fe(c.D))"),
    ("all(c.A, c.B or c.C)", "all(c.A, any(c.B, c.C))"),
    ("all(not c.A, ~c.B)", "all(nc(c.A), nc(c.B))"),
    ("(c.A and c.B)", "all(c.A, c.B)"),
    ("((not c.A))", "(nc(c.A))"),
    ("x[1].immediate and not x[2].immediate", "all(x[1].immediate, nc(x[2].immediate))"),
    ('c["a or b"] and ds["a and b"] == 5 and txt[1] == "&"', 'all(c["a or b"], ds["a and b"] == 5, txt[1] == "&")'),
    ("c[1:5] and not c[6]", "all(c[1:5], nc(c[6]))"),
    (
        "(\n        c.A\n        and c.B\n        and not (c.C)\n    )",
        "all(\n        c.A,\n        c.B,\n        nc(c.C)\n    )",
    ),
    ("(c.A or\n        c.B)", "any(c.A,\n        c.B)"),
    ("c.A and \\\n        c.B", "all(c.A, \\\n        c.B)"),
    ("c.A \\\n        and c.B", "all(c.A, \\\n        c.B)"),
]


@pytest.mark.parametrize(("condition", "after"), REWRITTEN)
def test_python_logic_is_rewritten(condition: str, after: str, tmp_path: Path) -> None:
    assert fixed(rung(condition), "CG105", tmp_path) == rung(after)
    assert_builds(rung(after), tmp_path)
    assert [problem.fix and problem.fix.is_safe for problem in found(rung(condition), "CG105", tmp_path)]


@pytest.mark.parametrize(
    "condition",
    [
        "not c[1:5]",
        "not nc(c[1:5])",
        "not x[1:3].immediate",
        "not re(c.A)",
        "c.A and not all(c.B, fe(c.C))",
        "not txt[1]",
        "True and c.A",
        "c.A and 5",
        "c.A and foo(c.B)",
        "c.A and ds[ds.I] == 5",
        "not ds[ds.I]",
        "not 1 < ds.A < 5",
        "not c.A.immediate.immediate",
        "c.A and not z.B",
        'txt[1] == "#" and c.B',
        "(\n        c.A  # the first\n        and c.B\n    )",
        "all(*c.A) or c.B",
        "all() and c.A",
        "not nc(c.A, c.B)",
    ],
)
def test_what_is_not_plain_is_not_rewritten(condition: str, tmp_path: Path) -> None:
    problems = found(rung(condition), "CG105", tmp_path)
    assert problems
    assert not any(problem.fix for problem in problems)


def test_parentheses_of_a_comment_or_a_call_are_left_alone(tmp_path: Path) -> None:
    comment = "(  # note (\n        c.A and c.B\n    )"
    assert fixed(rung(comment), "CG105", tmp_path) == rung(comment.replace("c.A and c.B", "all(c.A, c.B)"))
    assert fixed(b"def main():\n    if(c.A and c.B): set(c.Q)\n", "CG105", tmp_path) == (
        b"def main():\n    if(all(c.A, c.B)): set(c.Q)\n"
    )
    assert fixed(rung("any (c.A and c.B)"), "CG105", tmp_path) == rung("any (all(c.A, c.B))")
    chained = rung("re(c.A)").replace(b"set(c.Q)", b"ctu(ct.N, 5).reset((c.B or c.C), (not c.D))")
    after = chained.replace(b"(c.B or c.C), (not c.D)", b"any(c.B, c.C), nc(c.D)")
    assert fixed(chained, "CG105", tmp_path) == after
    assert_builds(after, tmp_path)


def test_pins_branches_and_several_on_one_line_are_rewritten_together(tmp_path: Path) -> None:
    before = """\
def main():
    if all(not c.A, c.B or c.C):
        rton(t.T, 5, reset=lambda: not c.D and c.E)
        if c.F or c.G: set(c.Q); set(c.R)  # ä and ö
    if True:
        end()
"""
    after = """\
def main():
    if all(nc(c.A), any(c.B, c.C)):
        rton(t.T, 5, reset=lambda: all(nc(c.D), c.E))
        if any(c.F, c.G): set(c.Q); set(c.R)  # ä and ö
    if True:
        end()
"""
    assert fixed(before.encode(), "CG105", tmp_path) == after.encode()
    assert_builds(after.encode(), tmp_path)


def test_columns_behind_other_alphabets_are_right(tmp_path: Path) -> None:
    before = 'def main():\n    if x["Tür"] and ds.Ä == 5 or not x["門"]: set(c.Q)\n'
    after = 'def main():\n    if any(all(x["Tür"], ds.Ä == 5), nc(x["門"])): set(c.Q)\n'
    assert fixed(before.encode(), "CG105", tmp_path) == after.encode()


LEAVES = st.sampled_from([*(f"c.{name}" for name in NAMES), "nc(c.A)", "(ds.V == 5)", "(5 <= ds.V)", "(ds.V != ds.V)"])
SPACES = st.sampled_from(["", " ", "\n        "])


def logic(inner: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    """A Python operator, or one of the language's functions, over some conditions in parentheses or without."""
    bare = LEAVES.filter(lambda leaf: not leaf.startswith("("))
    terms = st.lists(st.one_of(bare, st.builds("({1}{0}{1})".format, inner, SPACES)), min_size=2, max_size=3)
    operators = st.sampled_from([" and ", " or ", " & ", "|", " \n        and ", " or\n        "])
    return st.one_of(
        st.builds(lambda operator, parts: operator.join(parts), operators, terms),
        st.builds("not ({})".format, inner),
        st.builds("~({})".format, inner.map(lambda text: f"({text})")),
        st.builds(lambda name, parts: f"{name}({', '.join(parts)})", st.sampled_from(["all", "any"]), terms),
    )


@settings(max_examples=150, deadline=None)
@given(st.recursive(LEAVES, logic, max_leaves=8), SPACES)
def test_a_rewritten_condition_means_the_same(condition: str, space: str) -> None:
    before = f"({space}{condition}{space})"
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        data = fixed(rung(before), "CG105", folder)
        note(data.decode())
        assert found(data, "CG105", folder) == []
        assert_builds(data, folder)
    after = data.decode().partition("if ")[2].rpartition(":\n        set")[0]
    assert truth_table(after) == truth_table(before)


# -- else and elif ----------------------------------------------------------------------------------------------------


def body(text: str) -> bytes:
    return f"def main():\n{text}\n    if True:\n        end()\n".encode()


def test_else_and_elif_of_a_branch_become_branches(tmp_path: Path) -> None:
    before = """\
    if c.Run:
        if ds.Mode == 1:
            set(c.A)
        # manual
        elif c.Manual:  # the key
            set(c.B)
        else:
            set(c.C)
        if nc(c.D):
            set(c.E)
        else: set(c.F)"""
    after = """\
    if c.Run:
        if ds.Mode == 1:
            set(c.A)
        # manual
        if all(ds.Mode != 1, c.Manual):  # the key
            set(c.B)
        if all(ds.Mode != 1, nc(c.Manual)):
            set(c.C)
        if nc(c.D):
            set(c.E)
        if c.D: set(c.F)"""
    assert fixed(body(before), "CG104", tmp_path) == body(after)
    assert all(problem.fix and problem.fix.is_safe for problem in found(body(before), "CG104", tmp_path))
    assert_builds(body(after), tmp_path)


def test_else_of_a_rung_becomes_a_rung_with_care(tmp_path: Path) -> None:
    before = """\
    if ds.A:
        copy(0, ds.A)
    else:
        set(c.B)
    if c.C:
        set(c.D)
    elif all(c.E, c.F):
        set(c.G)"""
    after = """\
    if ds.A:
        copy(0, ds.A)
    if ds.A == 0:
        set(c.B)
    if c.C:
        set(c.D)
    if all(nc(c.C), all(c.E, c.F)):
        set(c.G)"""
    problems = found(body(before), "CG104", tmp_path)
    assert [problem.fix is not None and not problem.fix.is_safe for problem in problems] == [True, True]
    assert fixed(body(before), "CG104", tmp_path) == body(after)
    assert_builds(body(after), tmp_path)


@pytest.mark.parametrize(
    "text",
    [
        "    if re(c.A):\n        set(c.B)\n    else:\n        set(c.C)",
        "    if all(c.A, c.D):\n        set(c.B)\n    else:\n        set(c.C)",
        "    if x[1].immediate:\n        set(c.B)\n    else:\n        set(c.C)",
        "    if c[1:5]:\n        set(c.B)\n    else:\n        set(c.C)",
        "    if c.A:\n        set(c.B)\n    elif any(c.D, c.E):\n        set(c.C)\n    else:\n        set(c.F)",
        "    if c.A:\n        set(c.B)\n    elif (c.D):\n        set(c.C)",
        "    if c.A:\n        set(c.B)\n    elif c.D and c.E:\n        set(c.C)",
        "    if True:\n        set(c.B)\n    else:\n        set(c.C)",
    ],
)
def test_other_conditions_have_no_opposite_to_write(text: str, tmp_path: Path) -> None:
    problems = found(body(text), "CG104", tmp_path)
    assert problems
    assert not any(problem.fix for problem in problems)


# -- endings ----------------------------------------------------------------------------------------------------------


TIMER = "def main():\n \f    if c.A:\n        tof(\n            t.B,\n            5,\n        )\n"
BEHIND = "\n\n@sub\ndef s():\n    if True:\n        return\n"


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("def main():\n    if c.A:\n        set(c.B)\n", "    if True:\n        end()\n"),
        ("def main():\n  if c.A: set(c.B)", "\n  if True:\n    end()"),
        ("\ufeffdef main():\r\n\tif c.A:\r\n\t\tset(c.B)  # ä\r\n", "\tif True:\r\n\t\tend()\r\n"),
        ("def main():\n    if c.A:\n        end()\n", "    if True:\n        end()\n"),
        (TIMER, "    if True:\n        end()\n"),
        (TIMER + "\n    # Says why.\n    if c.D: set(c.E)\n", "\n    if True:\n        end()\n"),
    ],
)
@pytest.mark.parametrize("behind", ["", "    # Last words.\n", BEHIND])
def test_a_missing_end_is_added_as_the_last_rung(before: str, after: str, behind: str, tmp_path: Path) -> None:
    if not before.endswith("\n"):
        behind = ""
    assert fixed((before + behind).encode(), "CG403", tmp_path) == (before + after + behind).encode()
    assert_builds((before + after + behind).encode(), tmp_path)


def test_missing_returns_are_added(tmp_path: Path) -> None:
    before = """\
@sub
def one():
    if c.A:
        return


def main():
    if True:
        call(one)
        call(two)
        end()


@sub
def two():
    if True:
        return

    # No more.
    if c.B:
        set(c.C)  # the last
"""
    after = before.replace("        return\n\n\ndef", "        return\n    if True:\n        return\n\n\ndef")
    after += "\n    if True:\n        return\n"
    assert fixed(before.encode(), "CG404", tmp_path) == after.encode()
    assert all(problem.fix and problem.fix.is_safe for problem in found(before.encode(), "CG404", tmp_path))
    assert_builds(after.encode(), tmp_path)


def test_an_empty_routine_gets_no_ending(tmp_path: Path) -> None:
    [problem] = found(b"def main():\n    pass\n", "CG403", tmp_path)
    assert problem.fix is None
