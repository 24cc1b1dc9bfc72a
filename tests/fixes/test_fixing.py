"""Fixes keep every other byte and do not overlap; those of rules keep the meaning and leave nothing to fix."""

from __future__ import annotations

import tempfile
from pathlib import Path

import pytest
from budget import examples
from hypothesis import given, note
from hypothesis import strategies as st
from mended import assert_builds, fixed, found, rung, truth_table

from clickgen.dialects.if_rungs.read.parse import decode
from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.edits import Edit, Fix, apply_fixes
from clickgen.text.source import Span

# -- edits ------------------------------------------------------------------------------------------------------------


def edit(line: int, col: int, end: int, text: str) -> Edit:
    return Edit(Span("prog.py", line, col, line, end), text)


def applied(text: str, *edits: Edit) -> str:
    return apply_fixes(text, [Fix(edits)])[0]


@pytest.mark.parametrize(
    ("text", "line", "after"),
    [
        ("ab\ncd\n", 2, "ab\nc!\n"),
        ("ab\r\ncd\r\n", 2, "ab\r\nc!\r\n"),
        ("ab\rcd\r", 2, "ab\rc!\r"),
        ("ab\r\n\rcd\n", 3, "ab\r\n\rc!\n"),
        ("ab\ncd", 2, "ab\nc!"),
        ("\ufeffcd\n", 1, "\ufeffc!\n"),
        ("\fcd\n", 1, "\fc!\n"),
        ("\ufeff \t\fcd\r\n", 1, "\ufeff \t\fc!\r\n"),
        ("ab\n  \fcd\n", 2, "ab\n  \fc!\n"),
        ("ab\r\fcd\r", 2, "ab\r\fc!\r"),
        ("ä\u2028ö\x0b\x1c\ncd\n", 2, "ä\u2028ö\x0b\x1c\nc!\n"),
    ],
)
def test_a_place_is_where_the_reader_of_the_file_sees_it(text: str, line: int, after: str) -> None:
    source = decode("prog.py", text.encode(), Diagnostics())
    assert source is not None
    assert source.line(line)[1:2] == "d"
    assert applied(text, edit(line, 2, 3, "!")) == after


def test_columns_are_characters() -> None:
    assert applied("# ä 🚰 d\n", edit(1, 7, 8, "!")) == "# ä 🚰 !\n"


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_new_lines_end_as_those_of_the_file(end: str) -> None:
    assert applied(f"a{end}b{end}", edit(1, 2, 2, "\nx\ny")) == f"a{end}x{end}y{end}b{end}"


def test_an_insertion_behind_a_last_line_without_an_end() -> None:
    assert applied("a\nb", edit(2, 2, 2, "\nc")) == "a\nb\nc"


def test_an_edit_over_several_lines() -> None:
    assert applied("ab\r\ncd\r\nef", Edit(Span("prog.py", 1, 2, 3, 2), "+")) == "a+f"


def test_edits_of_one_fix_go_in_together_and_in_order() -> None:
    edits = (edit(1, 3, 4, "C"), edit(1, 1, 1, "<"), edit(1, 1, 1, "["), edit(1, 1, 2, "A"), edit(1, 4, 4, "]"))
    assert applied("abc", *edits) == "<[AbC]"


def test_of_fixes_that_meet_the_earlier_goes_in_whole() -> None:
    first, second = Fix((edit(1, 1, 3, "x"),)), Fix((edit(1, 2, 4, "y"), edit(2, 1, 2, "z")))
    assert apply_fixes("abcd\nefgh", [second, first]) == ("xcd\nefgh", 1)


def test_two_insertions_at_one_place_and_one_removal_twice_go_in_once() -> None:
    assert apply_fixes("ab", [Fix((edit(1, 2, 2, "x"),)), Fix((edit(1, 2, 2, "y"),))]) == ("axb", 1)
    assert apply_fixes("ab", [Fix((edit(1, 1, 2, ""),)), Fix((edit(1, 1, 2, ""),))]) == ("b", 1)


def test_fixes_side_by_side_all_go_in() -> None:
    fixes = [Fix((edit(1, n, n + 1, str(n)),)) for n in range(1, 5)]
    assert apply_fixes("abcd", fixes) == ("1234", 4)


def test_no_fixes_change_nothing() -> None:
    assert apply_fixes("\ufeffa\r\n", []) == ("\ufeffa\r\n", 0)


# -- repeated terms ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("condition", "after"),
    [
        ("all(c.A, c.A)", "c.A"),
        ("all(c.A, c.A, c.A)", "c.A"),
        ("all(c.A, c.B, c.A)", "all(c.A, c.B)"),
        ("all( c.A , c.B , c.A , )", "all( c.A , c.B , )"),
        ("all((c.A), (c.A))", "c.A"),
        ("all(c.A, all(c.A, c.B), all(c.B, c.A))", "all(c.A, c.B)"),
        ("all(c.A, all(c.A, c.B, c.C))", "all(c.A, all(c.B, c.C))"),
        ("any(c.A, ds.V == 5, 5 == ds.V, any(c.B, c.A), ds.V == 5)", "any(c.A, ds.V == 5, c.B)"),
        ("all(any(c.A, c.A), any(c.B, c.B, c.C))", "all(c.A, any(c.B, c.C))"),
        ("all(any(c.A, c.B), c.C, any(c.A, c.B))", "all(any(c.A, c.B), c.C)"),
        ("all(re(c.A), c[1:3], nc(c.B), c[1:3], nc(c.B), re(c.A))", "all(re(c.A), c[1:3], nc(c.B))"),
        ("all(ds.V, ds.V != 0, c.A)", "all(ds.V, c.A)"),
        (
            "all(\n        c.A,\n        c.B,\n        c.A,\n        c.C,\n    )",
            "all(\n        c.A,\n        c.B,\n        c.C,\n    )",
        ),
        (
            "all(\n        any(\n            c.A,\n            c.B),\n        any(c.A, c.B),\n    )",
            "any(\n            c.A,\n            c.B)",
        ),
    ],
)
def test_repeated_terms_are_taken_out(condition: str, after: str, tmp_path: Path) -> None:
    assert fixed(rung(condition), "CG509", tmp_path) == rung(after)
    assert_builds(rung(after), tmp_path)


@pytest.mark.parametrize(
    "condition",
    [
        "all(c.B, c.A, (c.A))",
        "all(\n        c.A,  # one\n        c.A,\n    )",
        "all(ds.V\n        == 5, 5 == ds.V)",
    ],
)
def test_where_more_than_a_term_would_go_nothing_goes(condition: str, tmp_path: Path) -> None:
    [problem] = found(rung(condition), "CG509", tmp_path)
    assert problem.fix is None


def test_repeats_in_a_chain_are_taken_out(tmp_path: Path) -> None:
    before = rung("re(c.A)").replace(b"set(c.Q)", b"ctu(ct.N, 5).reset([c.B, c.C], (c.B), c.D, c.D)")
    assert [problem.fix for problem in found(before, "CG509", tmp_path)] == [None]
    before = before.replace(b", (c.B)", b"")
    assert fixed(before, "CG509", tmp_path) == before.replace(b", c.D, c.D", b", c.D")


SAID = st.sampled_from(["c.A", "c.B", "nc(c.A)", "ds.V == 5", "5 != ds.V", "c.C"])


def groups(inner: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    return st.builds(
        lambda name, terms, space: f"{name}({space}{f',{space}'.join(terms)})",
        st.sampled_from(["all", "any"]),
        st.lists(inner, min_size=1, max_size=4),
        st.sampled_from(["", " ", "\n        "]),
    )


@examples(50)
@given(st.recursive(SAID, groups, max_leaves=10), st.sampled_from(["\n", "\r\n", "\r"]), st.booleans())
def test_taking_repeats_out_changes_no_meaning_and_leaves_none(condition: str, end: str, has_bom: bool) -> None:
    before = b"\xef\xbb\xbf" * has_bom + rung(condition).replace(b"\n", end.encode())
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        after = fixed(before, "CG509", folder)
        note(after.decode())
        # A repeat may come to light when a group inside becomes a single term.
        while (again := fixed(after, "CG509", folder)) != after:
            assert len(again) < len(after)
            after = again
        assert_builds(after, folder)
    assert after[:3] == before[:3]
    text = after.decode("utf-8-sig").replace(end, "\n").partition("if ")[2].rpartition(":\n        set")[0]
    assert truth_table(text) == truth_table(condition)


# -- other rules ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("quote", ['"', "'", '"""'])
def test_a_word_is_replaced_inside_its_quotes(quote: str, tmp_path: Path) -> None:
    before = rung("c.A").replace(b"set(c.Q)", f"search({quote}ne{quote}, 5, ds[1], ds[9], ds.At, c.Q)".encode())
    assert fixed(before, "CG524", tmp_path) == before.replace(b"ne", b"!=", 1)


def test_a_slice_that_is_not_plain_is_not_made_longer(tmp_path: Path) -> None:
    [problem] = found(rung("c.A").replace(b"set(c.Q)", b"copy_pack(c[1:0x10], dh.W)"), "CG519", tmp_path)
    assert problem.fix is None
    [problem] = found(rung("c.A").replace(b"set(c.Q)", b"copy_pack(c[ 1 : 16 ], dh.W)"), "CG519", tmp_path)
    assert problem.fix == Fix((Edit(Span(str(tmp_path / "prog.py"), 3, 26, 3, 28), "17"),), is_safe=False)


def test_a_slice_over_two_lines_is_not_made_longer(tmp_path: Path) -> None:
    before = rung("c.A").replace(b"set(c.Q)", b"copy_pack(c[1:\n            16], dh.W)")
    [problem] = found(before, "CG519", tmp_path)
    assert problem.fix is None


@pytest.mark.parametrize(
    ("condition", "after"),
    [
        ("any(c.A, c.Row)", "any(c.A, c.Row[0], c.Row[1], c.Row[2])"),
        ("any(nc( c.Row ), c.A)", "any(nc(c.Row[0]), nc(c.Row[1]), nc(c.Row[2]), c.A)"),
        ("any(c.A, c.Row[1:3])", "any(c.A, c[12], c[13])"),
        ("any(c.A, x[1:3].immediate)", "any(c.A, x[1].immediate, x[2].immediate)"),
        ("any(c.A, nc(  # none\n        c[1:3]))", ""),
    ],
)
def test_a_range_becomes_its_bits(condition: str, after: str, tmp_path: Path) -> None:
    declared = b"nickname(c.Row, c[11:14])\n\n\n"
    if not after:
        [problem] = found(declared + rung(condition), "CG526", tmp_path)
        assert problem.fix is None
        return
    assert fixed(declared + rung(condition), "CG526", tmp_path) == declared + rung(after)
    assert_builds(declared + rung(after), tmp_path)


def test_a_comparison_of_floating_point_is_repeated_only_word_for_word(tmp_path: Path) -> None:
    assert fixed(rung("all(df.V > 5, c.A, df.V > 5)"), "CG509", tmp_path) == rung("all(df.V > 5, c.A)")
    [problem] = found(rung("all(df.V > 5, c.A, 5 < df.V)"), "CG509", tmp_path)
    assert problem.fix is None


def test_two_words_for_one_address_are_so_in_one_program(tmp_path: Path) -> None:
    declared = b"nickname(c.A, c[7])\n\n\n"
    for condition, rests in (("all(c.A, c[7])", True), ("all(c.A, c.B, c.A)", False), ("any(ds.V, ds.V != 0)", False)):
        [problem] = found(declared + rung(condition), "CG509", tmp_path)
        assert problem.fix
        assert problem.fix.rests_on_names is rests
