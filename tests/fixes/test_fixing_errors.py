"""The fixes of errors: their text builds, means what was meant, and every other byte stays."""

from __future__ import annotations

import re
import tempfile
from pathlib import Path

import pytest
from budget import examples
from hypothesis import given, note
from hypothesis import strategies as st
from mended import NAMES, assert_builds, body, chain, fixed, found, rung, truth_table

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
    ('txt[1] == "#" and c.B', 'all(txt[1] == "#", c.B)'),
]

COMMENTED = [
    ("(c.A  # why\n        and c.B)", "all(c.A,  # why\n        c.B)"),
    ("(c.A and  # why (\n        c.B)", "all(c.A,  # why (\n        c.B)"),
    (
        "(c.A  # one and\n        # two\n        and  # three\n        c.B)",
        "all(c.A,  # one and\n        # two\n        # three\n        c.B)",
    ),
    (
        "(\n        # first\n        (c.A or c.C)  # (second)\n        and c.B  # last\n    )",
        "(\n        # first\n        all(any(c.A, c.C),  # (second)\n        c.B)  # last\n    )",
    ),
    ("(not (c.A  # )\n        or c.B))", "all(nc(c.A),  # )\n        nc(c.B))"),
    ("(c.A  # why\n        and (c.B  # not\n        and c.C))", "all(c.A,  # why\n        c.B,  # not\n        c.C)"),
    (
        "any(\n        c.A and c.B,  # both\n        c.C,\n    )",
        "any(\n        all(c.A, c.B),  # both\n        c.C,\n    )",
    ),
]


@pytest.mark.parametrize(("condition", "after"), [*REWRITTEN, *COMMENTED])
def test_python_logic_is_rewritten(condition: str, after: str, tmp_path: Path) -> None:
    assert fixed(rung(condition), "CG105", tmp_path) == rung(after)
    assert_builds(rung(after), tmp_path)
    # If a DF register holds no number, it can be that neither of two opposite comparisons holds.
    is_float = "not df" in condition
    safety = [problem.fix and problem.fix.is_safe for problem in found(rung(condition), "CG105", tmp_path)]
    assert set(safety) == {not is_float}


@pytest.mark.parametrize(
    "condition",
    [
        "not c[1:5]",
        "not nc(c[1:5])",
        "not x[1:3].immediate",
        "not re(c.A)",
        "c.A and not all(c.B, fe(c.C))",
        "not txt[1]",
        "c.A and 5",
        "c.A and foo(c.B)",
        "c.A and ds[ds.I] == 5",
        "not ds[ds.I]",
        "not c.A.immediate.immediate",
        "c.A and not z.B",
        "all(*c.A) or c.B",
        "all() and c.A",
        "not nc(c.A, c.B)",
    ],
)
def test_what_is_not_plain_is_not_rewritten(condition: str, tmp_path: Path) -> None:
    problems = found(rung(condition), "CG105", tmp_path)
    assert problems
    assert not any(problem.fix for problem in problems)


@pytest.mark.parametrize(
    ("condition", "help"),
    [
        ("True and c.A", "write c.A"),
        ("not 1 < ds.A < 5", "write any(1 >= ds.A, ds.A >= 5)"),
        ("ds.X == 1 or 2", "2 has no place in it: compare it as well, any(ds.X == 1, ds.X == 2)"),
        ("ds.X != 1 and 2", "2 has no place in it: compare it as well, all(ds.X != 1, ds.X != 2)"),
        (
            "c.A and 5",
            "5 has no place in it: a condition is a bit, a comparison, all(...), any(...), nc(...), re(...) or fe(...)",
        ),
        ("c.A and al(c.B)", "al(c.B) has no place in it: did you mean all?"),
        (
            "not c[1:5]",
            "nothing in the language is the opposite of c[1:5]: put it on a bit with out(...) in a rung "
            "before, and write nc(...) of that bit",
        ),
        (
            "c.A and not all(c.B, fe(c.C))",
            "nothing in the language is the opposite of fe(c.C): put it on a bit with "
            "out(...) in a rung before, and write nc(...) of that bit",
        ),
        ("c.A and c.B", "write all(c.A, c.B)"),
        ("(c.A  # why\n        and c.B)", "write all(c.A, c.B)"),
    ],
)
def test_the_help_says_nothing_that_would_be_refused(condition: str, help: str, tmp_path: Path) -> None:
    [problem, *_] = found(rung(condition), "CG105", tmp_path)
    assert problem.help == help


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
    line = '    if x["Tür"] and ds.Ä == 5 or not x["門"]: set(c.Q)'
    problems = found(f"def main():\n{line}\n".encode(), "CG105", tmp_path)
    spans = [problem.span for problem in problems if problem.span]
    assert [line[span.col - 1 : span.end_col - 1] for span in spans] == ['x["Tür"] and ds.Ä == 5 or not x["門"]']
    # CLICK takes no such nicknames: no fix leaves one in the line that it fixes.
    assert [problem.fix for problem in problems] == [None]


LEAVES = st.sampled_from([*(f"c.{name}" for name in NAMES), "nc(c.A)", "(ds.V == 5)", "(5 <= ds.V)", "(ds.V != ds.V)"])
SPACES = st.sampled_from(["", " ", "\n        ", "  # and (\n        "])


def logic(inner: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    """A Python operator, or one of the language's functions, over some conditions in parentheses or without."""
    bare = LEAVES.filter(lambda leaf: not leaf.startswith("("))
    terms = st.lists(st.one_of(bare, st.builds("({1}{0}{1})".format, inner, SPACES)), min_size=2, max_size=3)
    operators = st.sampled_from(
        [" and ", " or ", " & ", "|", " \n        and ", " or\n        ", "  # (or)\n        | "]
    )
    return st.one_of(
        st.builds(lambda operator, parts: operator.join(parts), operators, terms),
        st.builds("not ({})".format, inner),
        st.builds("~({})".format, inner.map(lambda text: f"({text})")),
        st.builds(lambda name, parts: f"{name}({', '.join(parts)})", st.sampled_from(["all", "any"]), terms),
    )


@examples(50)
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
    assert re.findall("#.*", after) == re.findall("#.*", before)


# -- else and elif ----------------------------------------------------------------------------------------------------


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


def safety(text: str, folder: Path) -> bool | None:
    """Whether the fix of the only else or elif is safe; None if there is none."""
    [problem] = found(body(text), "CG104", folder)
    return problem.fix and problem.fix.is_safe


BECOMES = [
    # Rungs look one after the other.
    (["if ds.S == 1: copy(1, ds.T)", "elif ds.S == 2: copy(2, ds.T)"], ["if ds.S == 1", "if ds.S == 2"]),
    (["if c.A: out(y[1])", "else: out(y[2])"], ["if c.A", "if nc(c.A)"]),
    (["if nc(c.A): out(y[1])", "else: out(y[2])"], ["if nc(c.A)", "if c.A"]),
    (["if all(c.A, c.B): set(c.P)", "else: set(c.Q)"], ["if all(c.A, c.B)", "if any(nc(c.A), nc(c.B))"]),
    (["if any(c.A, c.B): set(c.P)", "else: set(c.Q)"], ["if any(c.A, c.B)", "if all(nc(c.A), nc(c.B))"]),
    (
        ["if ds.S == 1: set(c.P)", "elif 2 == ds.S: set(c.Q)", "else: set(c.R)"],
        ["if ds.S == 1", "if 2 == ds.S", "if all(ds.S != 1, 2 != ds.S)"],
    ),
    (
        ["if ds.L > 50: set(c.P)", "elif ds.L > 30: set(c.Q)", "else: set(c.R)"],
        ["if ds.L > 50", "if all(ds.L <= 50, ds.L > 30)", "if ds.L <= 30"],
    ),
    (["if ds.L > 5: set(c.P)", "elif ds.L < 6: set(c.Q)"], ["if ds.L > 5", "if ds.L < 6"]),
    (["if all(df.L > 5, c.A): set(c.P)", "elif nc(c.A): set(c.Q)"], ["if all(df.L > 5, c.A)", "if nc(c.A)"]),
    # A name that no table and no declaration knows gets an address of its own.
    (["if c[1]: set(c.Q)", "else: set(c[3])"], ["if c[1]", "if nc(c[1])"]),
    (["if c.A: set(c[3])", "else: set(c.P)"], ["if c.A", "if nc(c.A)"]),
    (['if txt[1] == "A": copy("AB", txt.M)', "else: set(c.Q)"], ['if txt[1] == "A"', 'if txt[1] != "A"']),
    (["if ct.N: ctu(ct.M, 5, reset=lambda: c.R)", "else: set(c.Q)"], ["if ct.N", "if nc(ct.N)"]),
    (
        ["if df.L == 0.1: set(c.P)", "elif df.L == 0.100000001: set(c.Q)"],
        None,
    ),
    (["if ds.A < ds.B: set(c.P)", "elif ds.B < ds.A: set(c.Q)"], ["if ds.A < ds.B", "if ds.B < ds.A"]),
    (["if ds.A < ds.B: set(c.P)", "else: set(c.Q)"], ["if ds.A < ds.B", "if ds.A >= ds.B"]),
    (['if txt[1] == "A": set(c.P)', 'elif txt[1] == "B": set(c.Q)'], ['if txt[1] == "A"', 'if txt[1] == "B"']),
    (["if ds.V: set(c.P)", "else: set(c.Q)"], ["if ds.V", "if ds.V == 0"]),
    (["if ds.V == 0: set(c.P)", "elif ds.V: set(c.Q)"], ["if ds.V == 0", "if ds.V"]),
    (["if c.A: set(c.P)", "elif any(c.A, c.B): set(c.Q)"], ["if c.A", "if all(nc(c.A), c.B)"]),
    (["if all(c.A, c.B): set(c.P)", "elif c.A: set(c.Q)"], ["if all(c.A, c.B)", "if all(nc(c.B), c.A)"]),
    (["if c.A: set(c.P)", "elif all(c.E, c.F): set(c.Q)"], ["if c.A", "if all(nc(c.A), c.E, c.F)"]),
    (
        ["if c.A: set(c.P)", "elif (c.D): set(c.Q)", "elif (all(c.E, c.F)) : set(c.R)"],
        ["if c.A", "if all(nc(c.A), (c.D))", "if (all(nc(c.A), nc(c.D), c.E, c.F)) "],
    ),
    (["if c.A: set(c.P)", "elif True: set(c.Q)"], ["if c.A", "if nc(c.A)"]),
    (["if c[1:5]: set(c[20])", "elif nc(c[4]): set(c[21])"], ["if c[1:5]", "if nc(c[4])"]),
    (["if all(c.A, c.X): set(c.P)", "elif all(nc(c.A), c.Y): set(c.Q)"], ["if all(c.A, c.X)", "if all(nc(c.A), c.Y)"]),
    (["if c.A: set(c.P)", "elif nc(c.A): set(c.Q)"], ["if c.A", "if nc(c.A)"]),
    (["if ct.N: set(c.P)", "else: call(s)"], ["if ct.N", "if nc(ct.N)"]),
    (["if fe(c.A): set(c.P)", "elif c.A: set(c.Q)"], ["if fe(c.A)", "if c.A"]),
    (["if c.A: set(c.P)", "elif any(c.B, re(c.A)): set(c.Q)"], ["if c.A", "if all(nc(c.A), c.B)"]),
    (
        ["if all(ds.V > 5, c.B): set(c.P)", "elif all(any(ds.V == 1, ds.V == 2), c.C): set(c.Q)"],
        ["if all(ds.V > 5, c.B)", "if all(any(ds.V == 1, ds.V == 2), c.C)"],
    ),
    (["if c[1]: set(y[1])", "elif c.A: set(y[2])"], ["if c[1]", "if all(nc(c[1]), c.A)"]),
    # Conditions that exclude each other are not looked at again.
    (
        ["if all(ds.S == 1, c.Go, re(c.A)): reset(c.Go)", "elif all(t.T, ds.S == 1): call(s)"],
        None,
    ),
    (
        ["if all(ds.S == 1, c.Go, re(c.A), t.T): reset(c.Go)", "elif ds.S == 2: call(s)"],
        ["if all(ds.S == 1, c.Go, re(c.A), t.T)", "if ds.S == 2"],
    ),
]


@pytest.mark.parametrize(("arms", "heads"), BECOMES)
def test_else_and_elif_of_a_rung_become_rungs_where_that_is_the_same(
    arms: list[str], heads: list[str] | None, tmp_path: Path
) -> None:
    text = chain(*arms)
    if heads is None:
        assert found(body(text), "CG104", tmp_path)[0].fix is None
        return
    after = chain(*(f"{head}: {arm.partition(': ')[2]}" for head, arm in zip(heads, arms, strict=True)))
    assert safety(text, tmp_path) is True
    assert fixed(body(text), "CG104", tmp_path) == body(after)
    if "call(s)" not in text:
        assert_builds(body(after), tmp_path)
        for code in ("CG507", "CG508", "CG509"):
            assert found(body(after), code, tmp_path) == []


@pytest.mark.parametrize(
    "arms",
    [
        # An earlier rung writes what a later one looks at, or may.
        ["if ds.S == 1: copy(2, ds.S)", "elif ds.S == 2: copy(1, ds.S)"],
        ["if c.A: out(c.A)", "else: set(c.Q)"],
        ["if ds.A: copy(0, ds[ds.B])", "else: set(c.Q)"],
        ['if txt[2] == "A": copy("AB", txt[1])', "else: set(c.Q)"],
        ["if y[1]: copy(1, yd[0])", "else: set(c.Q)"],
        ["if ct.N: ctu(ct.N, 5, reset=lambda: c.R)", "else: set(c.Q)"],
        ["if ct[1]: copy(0, ctd[1])", "else: set(c.Q)"],
        ["if ct[1]: copy(0, ctd[ds.I])", "else: set(c.Q)"],
        ["if nc(ct[1]): copy_fill(9, ctd[1:3])", "elif c.A: set(c.P)", "else: set(c.Q)"],
        ["if t[1]: copy(0, td[1])", "else: set(c.Q)"],
        ["if ctd.N > 5: ctu(ct.N, 5, reset=lambda: c.R)", "else: set(c.Q)"],
        ["if c.A: call(s)", "else: set(c.Q)"],
        ["if c.A: end()", "else: set(c.Q)"],
        ["if c.A: return", "else: set(c.Q)"],
        ["if c.A: set(c.P)", "elif c.B: set(c.C)", "elif c.C: set(c.D)"],
        ["if c.A: set(c.P)", "else: ctu(ct.N, 5, reset=lambda: c.P)"],
        # Some conditions differ from look to look.
        ["if t.T: set(c.P)", "else: set(c.Q)"],
        ["if t.T: set(c.P)", "elif nc(t.T): set(c.Q)"],
        ["if td.T > 5: set(c.P)", "elif td.T < 3: set(c.Q)"],
        ["if td.T > 5: set(c.P)", "else: set(c.Q)"],
        ["if sc[1]: set(c.P)", "else: set(c.Q)"],
        ["if sd[9] == 1: set(c.P)", "elif sd[9] == 2: set(c.Q)"],
        ["if c.A: set(c.P)", "elif re(c.B): set(c.Q)"],
        ["if c.A: set(c.P)", "elif x[1].immediate: set(c.Q)"],
        # Floating point: the register may hold no number.
        ["if df.L > 5: set(c.P)", "else: set(c.Q)"],
        ["if df.L: set(c.P)", "else: set(c.Q)"],
        ["if ds.L < df.L: set(c.P)", "else: set(c.Q)"],
        ["if df.L > 5: set(c.P)", "elif df.L < 6: set(c.Q)"],
        ["if df.L == 0.1: set(c.P)", "elif df.L == 0.2: set(c.Q)"],
        ["if df.L < 16777217: set(c.P)", "elif df.L > 16777217: set(c.Q)"],
        # A coil is turned off when its rung is off.
        ["if c.A: out(y[1])", "else: out(y[1])"],
        ["if c.A: set(y[1])", "else: out(y[1])"],
    ],
)
def test_where_a_rung_of_its_own_may_mean_another_thing_the_fix_is_not_safe(arms: list[str], tmp_path: Path) -> None:
    assert safety(chain(*arms), tmp_path) is False


def test_a_coil_of_two_arms_is_not_safe_in_a_branch_either(tmp_path: Path) -> None:
    for first, second in (("out(y[1])", "out(y[1])"), ("set(y[1])", "out(y[1:3])"), ("call(s)", "out(y[1])")):
        text = "    if c.Q:\n" + chain(f"if c.A: {first}", f"else: {second}", line="        ")
        assert safety(text, tmp_path) is False
    text = "    if c.Q:\n" + chain("if c.A: out(y[1])", "else: set(y[1])", line="        ")
    assert safety(text, tmp_path) is True


def test_what_cannot_be_read_is_not_known_to_be_safe(tmp_path: Path) -> None:
    nested = chain("if c.A: set(c.P)") + "\n    else:\n" + chain("if c.B: set(c.Q)", "else: set(c.R)", line="        ")
    outer, inner = found(body(nested), "CG104", tmp_path)
    assert [problem.fix and problem.fix.is_safe for problem in (outer, inner)] == [False, True]
    assert safety(chain("if c.A: set(c.P)", "else: sett(c.Q)"), tmp_path) is False
    received = 'if c.G: receive(ModbusTcpTarget(ip="10.0.0.1"), "DS1", ds[1:5], sending=c.S)'
    assert safety(chain("if c.A: set(c.P)", "else: set(c.Q)") + "\n" + chain(received), tmp_path) is False


def test_problems_of_every_arm_are_found_and_mended_round_by_round(tmp_path: Path) -> None:
    before = "    if c.Q:\n" + chain(
        "if c.A: set(c.E)", "elif c.B and c.D: set(c.F)", "else: set(c.G)", line="        "
    )
    assert [problem.fix for problem in found(body(before), "CG104", tmp_path)] == [None]
    once = fixed(body(before), "CG105", tmp_path)
    assert once == body(before.replace("c.B and c.D", "all(c.B, c.D)"))
    after = before.replace("elif c.B and c.D", "if all(nc(c.A), c.B, c.D)").replace(
        "else", "if all(nc(c.A), any(nc(c.B), nc(c.D)))"
    )
    assert fixed(once, "CG104", tmp_path) == body(after)
    assert_builds(body(after), tmp_path)


def test_every_other_byte_of_a_chain_stays(tmp_path: Path) -> None:
    before = """\
def main():
\tif any(  # either
\t\tc.A,
\t\tc.B):  # one
\t\tset(c.P)

\t# why
\telif all(  # both
\t\tc.D,  # first
\t\tc.E,
\t):  # two

\t\tset(c.Q)
\telif (c.F  # ä
\t\t):
\t\tset(c.R)
\telse:  # else
\t\tset(c.S)
\tif True: end()
"""
    after = (
        before.replace("elif all(  # both\n\t\tc.D,", "if all(  nc(c.A), nc(c.B),  # both\n\t\tc.D,")
        .replace("elif (c.F  # ä\n\t\t):", "if all(nc(c.A), nc(c.B), any(nc(c.D), nc(c.E)), (c.F  # ä\n\t\t)):")
        .replace("else:", "if all(nc(c.A), nc(c.B), any(nc(c.D), nc(c.E)), nc(c.F)):")
    )
    for end in ("\n", "\r\n"):
        data = before.replace("\n", end).encode()
        assert fixed(data, "CG104", tmp_path) == after.replace("\n", end).encode()
    assert_builds(after.encode(), tmp_path)


@pytest.mark.parametrize(
    "arms",
    [
        ["if re(c.A): set(c.B)", "else: set(c.C)"],
        ["if all(c.D, fe(c.A)): set(c.B)", "else: set(c.C)"],
        ["if x[1].immediate: set(c.B)", "else: set(c.C)"],
        ["if nc(x[1].immediate): out(y[1])", "else: out(y[2])"],
        ["if any(c.A, nc(x[1].immediate)): out(y[1])", "else: out(y[2])"],
        ["if c[1:5]: set(c.B)", "else: set(c.C)"],
        ["if c.A: set(c.B)", "elif c.D and c.E: set(c.C)"],
        ["if True: set(c.B)", "else: set(c.C)"],
        ["if all(c.A, any(c.B, nc(c.C))): set(c.D)", "elif all(c.A, c.B): set(c.E)"],
    ],
)
def test_other_conditions_have_no_opposite_to_write(arms: list[str], tmp_path: Path) -> None:
    for line in ("", "    "):
        text = ("    if c.Q:\n" if line else "") + chain(*arms, line=line + "    ")
        problems = found(body(text), "CG104", tmp_path)
        assert problems
        assert not any(problem.fix for problem in problems)


@pytest.mark.parametrize(
    "arms",
    [
        ["if ds.V > 40000: set(c.P)", "else: set(c.Q)"],
        ["if any(c.A, ds.V == 2.5): set(c.P)", "elif nc(c.A): set(c.Q)"],
        ["if c.A: set(c.P)", "elif ds.V >= -32768: set(c.Q)"],
        ["if all(c.A, c.B, nc(c.A)): set(c.P)", "elif c.C: set(c.Q)"],
        ["if any(c.A, c.B): set(c.P)", "elif all(c.B, c.C): set(c.Q)"],
    ],
)
def test_an_arm_that_never_runs_or_asks_nothing_is_first_to_be_looked_at(arms: list[str], tmp_path: Path) -> None:
    assert safety(chain(*arms), tmp_path) is None


def test_a_block_has_no_opposite_and_its_name_may_be_any_address_of_it(tmp_path: Path) -> None:
    declared = b"nickname(c.Flags, c[1:5])\nnickname(c.A, c[3])\nnickname(c.P, c[20])\n\n\n"
    for test in ("c.Flags", "nc(c.Flags)", "c.Flags[0:2]"):
        text = chain(f"if {test}: set(c.P)", "else: set(c.Q)")
        [problem] = found(declared + body(text), "CG104", tmp_path)
        assert problem.fix is None
        [problem] = found(declared + rung(f"not {test}"), "CG105", tmp_path)
        assert problem.fix is None
    for arms in (["if c.A: set(c.Flags)", "else: set(c.Q)"], ["if c.Flags[2]: set(c.A)", "else: set(c.Q)"]):
        [problem] = found(declared + body(chain(*arms)), "CG104", tmp_path)
        assert [problem.fix and problem.fix.is_safe] == [False]


def test_the_help_names_what_has_no_opposite(tmp_path: Path) -> None:
    text = chain("if any(c.A, nc(x[1].immediate)): out(y[1])", "else: out(y[2])")
    [problem] = found(body(text), "CG104", tmp_path)
    assert problem.help.startswith("nothing is the opposite of nc(x[1].immediate): put it on a bit with out(...)")


VALUES = ["c.A", "c.B", "nc(c.C)", "ds.V == 5", "ds.V <= 5", "5 != ds.V", "ds.V > 5"]
TESTS = st.recursive(
    st.sampled_from(VALUES),
    lambda inner: st.builds(
        lambda name, terms: f"{name}({', '.join(terms)})",
        st.sampled_from(["all", "any"]),
        st.lists(inner, min_size=1, max_size=3),
    ),
    max_leaves=4,
)


@examples(50)
@given(st.lists(TESTS, min_size=1, max_size=4), st.booleans())
def test_the_rungs_of_a_chain_run_when_its_arms_did(tests: list[str], has_else: bool) -> None:
    heads = [f"{'elif' if number else 'if'} {test}" for number, test in enumerate(tests)]
    arms = [f"{head}: set(c.Q{number})" for number, head in enumerate([*heads, *["else"] * has_else])]
    tables = [truth_table(test) for test in [*tests, *["all()"] * has_else]]
    with tempfile.TemporaryDirectory() as name:
        data = fixed(body(chain(*arms)), "CG104", Path(name))
    note(data.decode())
    after = re.findall(r"^    if (.*):\n        set", data.decode(), re.MULTILINE)
    if len(after) < len(arms):
        return  # Some arm could never run, or there was only one.
    for number, test in enumerate(after):
        wanted = [here and not any(before) for here, *before in zip(tables[number], *tables[:number], strict=True)]
        assert truth_table(test) == wanted


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


def test_no_ending_goes_behind_a_line_that_goes_on(tmp_path: Path) -> None:
    [problem] = found(b"def main():\n    if c.A: set(c.B) \\\n\n", "CG403", tmp_path)
    assert problem.fix is None


def test_an_empty_routine_gets_no_ending(tmp_path: Path) -> None:
    [problem] = found(b"def main():\n    pass\n", "CG403", tmp_path)
    assert problem.fix is None
