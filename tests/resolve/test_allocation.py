"""The addresses that new names and scratch cells get, and the rows that are written to the table."""

from __future__ import annotations

import pytest
from resolving import HEADER, Desk, desk, new, rung

import clickgen

__all__ = ["desk"]


# -- allocation --------------------------------------------------------------------------------------------------------


def test_names_are_allocated_in_the_order_of_first_use(desk: Desk) -> None:
    result = desk.good(
        """\
        if all(c.One, any(nc(c.Two), re(c.Three))):
            if c.Four:
                out(c.Five)
            out(c.Two)
            calc("ds.A + ds.B", ds.C)
            rton(t.T1, ds.D, reset=lambda: c.Six)
        if c.Seven:
            for _ in range(ds.E):
                if c.Eight:
                    copy(ds[ds.F], ds.G)
        """
    )
    chosen = new(result)
    assert {name: chosen[name] for name in ("One", "Two", "Three", "Four", "Five", "Six", "Seven", "Eight")} == {
        name: f"C{number}"
        for number, name in enumerate(("One", "Two", "Three", "Four", "Five", "Six", "Seven", "Eight"), 1)
    }
    assert [chosen[name] for name in "ABCDEFG"] == [f"DS{number}" for number in range(1, 8)]


def test_every_bank_begins_at_its_lowest_free_address(desk: Desk) -> None:
    result = desk.good(
        """\
        if all(x.A, c.B, ct.D, t.C):
            out(y.E)
            copy(dd.F, df.G)
            copy(dh.H, ds.I)
            copy("A", txt.J)
        """
    )
    assert new(result) == {
        "A": "X001",
        "B": "C1",
        "C": "T1",
        "D": "CT1",
        "E": "Y001",
        "F": "DD1",
        "G": "DF1",
        "H": "DH1",
        "I": "DS1",
        "J": "TXT1",
    }


def test_addresses_of_the_table_are_not_free(desk: Desk) -> None:
    desk.rows('C1,BIT,"A",0,No,""', 'C2,BIT,"",0,Yes,""', 'C4,BIT,"",0,No,"kept for the panel"')
    assert new(desk.good("if c.New1:\n    out(c.New2)")) == {"New1": "C3", "New2": "C5"}


def test_declared_addresses_are_not_free(desk: Desk) -> None:
    result = desk.good("if c.New1:\n    out(c.New2)", "nickname(c.Unused, c[1])\nnickname(c.Later, c[3])")
    assert new(result) == {"New1": "C2", "New2": "C4"}


@pytest.mark.parametrize(
    ("action", "chosen"),
    [
        ("copy(1, ds[1])", "DS2"),
        ("copy(1, ds[2])", "DS1"),
        ("copy_fill(0, ds[1:5])", "DS5"),
        ("copy_fill(0, ds[2:5])", "DS1"),
        ("copy_block(dd[1:4], ds[1])", "DS4"),
        ("copy_block(ds[1:3], ds[3:5])", "DS5"),
        ("copy_unpack(dd[1], ds[1:3])", "DS3"),
        ('search("==", 1, ds[1], ds[9], dd[1], c[1])', "DS10"),
        ('calc("SUM(ds[1:11])", dd[1])', "DS11"),
        ('calc("ds[1] + ds[2]", ds[3])', "DS4"),
        ("copy(dd[ds[1]], dd[1])", "DS2"),
        ("ton(t[1], ds[1])", "DS2"),
        ("ctu(ct[1], ds[1], reset=lambda: c[1])", "DS2"),
        ("ctu(ct[1], 5, reset=lambda: ds[1] == 0)", "DS2"),
        ('calc("dd[ds[1]] + 1", dd[1])', "DS2"),
    ],
)
def test_addresses_that_the_program_uses_by_number_are_not_free(desk: Desk, action: str, chosen: str) -> None:
    """Wherever the number is, even after the name in the program."""
    result = desk.good(f"if re(x[1]):\n    copy(ds.New, dd[9])\nif re(x[1]):\n    {action}")
    assert new(result)["New"] == chosen


def test_bits_that_the_program_uses_by_number_are_not_free(desk: Desk) -> None:
    result = desk.good(
        """\
        if all(c.New, nc(c[1:4]), c[5]):
            out(c.Next)
            shift(c[9:5:-1], clock=lambda: c[10], reset=lambda: re(c[11]))
            copy_pack(c[12:14], dh[1])
        """
    )
    assert new(result)["New"] == "C4"
    assert new(result)["Next"] == "C14"


@pytest.mark.parametrize(
    ("copied", "chosen"),
    [
        ('copy("ABC", txt[1])', "TXT4"),
        ('copy("A", txt[1])', "TXT2"),
        ('copy("$0D", txt[1])', "TXT2"),
        ('copy_fill("A", txt[1:4])', "TXT4"),
        ("copy(txt[9], txt[1])", "TXT2"),
        ("copy_pack(txt[1:5], ds[1])", "TXT5"),
    ],
)
def test_a_text_takes_an_address_for_each_character(desk: Desk, copied: str, chosen: str) -> None:
    assert new(desk.good(f'if x[1]:\n    copy("X", txt.New)\n    {copied}'))["New"] == chosen


def test_a_number_as_text_takes_as_many_addresses_as_it_can_have_digits(desk: Desk) -> None:
    result = desk.good('if x[1]:\n    copy(ds[1], txt[1], options=to_text)\n    copy("X", txt.New)')
    assert int(new(result)["New"].removeprefix("TXT")) > 6


def test_a_named_block_is_allocated_with_its_length(desk: Desk) -> None:
    result = desk.good("if x[1]:\n    copy_block(dd[1:5], ds.Copy)\n    copy(1, ds.Next)\n    copy(ds[2], ds[9])")
    assert new(result) == {"Copy": "DS3", "Next": "DS1"}
    assert "blockcopy(DD1..DD4,DS3..DS6)" in result.files["main.csv"]


def test_a_named_text_is_allocated_with_its_length(desk: Desk) -> None:
    result = desk.good('if x[1]:\n    copy("READY", txt.Message)\n    copy("X", txt.Next)')
    assert new(result) == {"Message": "TXT1", "Next": "TXT6"}


def test_the_reach_of_a_known_name_is_not_free(desk: Desk) -> None:
    desk.rows('DS1,INT,"Copy",0,Yes,""', 'TXT1,TEXT,"Message",,Yes,""')
    result = desk.good(
        'if x[1]:\n    copy_block(dd[1:5], ds.Copy)\n    copy(1, ds.Next)\n    copy("HI", txt.Message)\n    '
        'copy("X", txt.Letter)'
    )
    assert new(result) == {"Next": "DS5", "Letter": "TXT3"}


def test_the_range_between_two_known_names_of_a_search_is_not_free(desk: Desk) -> None:
    result = desk.good(
        'if x[1]:\n    search("==", 1, ds.First, ds.Last, dd[1], c[1])\n    copy(1, ds.New)',
        "nickname(ds.First, ds[1])\nnickname(ds.Last, ds[5])",
    )
    assert new(result) == {"New": "DS6"}


@pytest.mark.parametrize(
    ("row", "name"),
    [
        ('TD1,INT,"Elapsed",0,No,""', "t.New"),
        ('T1,BIT,"Delay",0,No,""', "t.New"),
        ('CTD1,INT2,"Total",0,Yes,""', "ct.New"),
        ('CT1,BIT,"Parts",0,Yes,""', "ct.New"),
    ],
)
def test_a_bit_and_its_current_value_are_taken_together(desk: Desk, row: str, name: str) -> None:
    desk.rows(row)
    assert new(desk.good(f"if {name}:\n    out(y[1])"))["New"].endswith("T2")


def test_a_current_value_by_number_takes_its_timer(desk: Desk) -> None:
    result = desk.good("if t.New:\n    copy(td[1], ds[1])\n    copy_fill(0, ctd[1:4])\nif ct.Parts:\n    out(y[1])")
    assert new(result) == {"New": "T2", "Parts": "CT4"}


def test_inputs_and_outputs_are_given_with_a_warning(desk: Desk) -> None:
    result = desk.good("if x.Start:\n    out(y.Motor)")
    warnings = [problem for problem in result.diagnostics if problem.code == "CG210"]
    assert [desk.text_at(problem) for problem in warnings] == ["x.Start", "y.Motor"]
    assert [problem.help for problem in warnings] == [
        "pin it: nickname(x.Start, x[1])",
        "pin it: nickname(y.Motor, y[1])",
    ]
    desk.table.write_bytes(result.table)
    assert not desk.good("if x.Start:\n    out(y.Motor)").diagnostics


def test_inputs_are_allocated_around_their_gaps(desk: Desk) -> None:
    taken = [f"x[{number}]" for number in (*range(2, 17), *range(21, 36))]
    result = desk.good(f"if all(x.A, x.B, x.C, any({', '.join(taken)})):\n    out(y[1])")
    assert new(result) == {"A": "X001", "B": "X036", "C": "X101"}


def test_a_block_of_outputs_does_not_cross_a_gap(desk: Desk) -> None:
    result = desk.good("if x[1]:\n    copy_block(c[1:9], y.Lamps)\n    out(y[5])\n    out(y[12])")
    assert new(result) == {"Lamps": "Y021"}


@pytest.mark.parametrize("name", ["sc.FirstScan", "sd.Clock", "xd.Panel", "yd.Panel"])
def test_system_banks_are_never_given(desk: Desk, name: str) -> None:
    condition = name if name.startswith("sc") else f"{name} == {'5' if name.startswith('sd') else '0x5'}"
    problem = desk.bad("CG206", f"if {condition}:\n    out(y[1])")
    assert desk.text_at(problem) == name


def test_names_in_system_banks_come_from_declarations_and_the_table(desk: Desk) -> None:
    desk.rows('XD2,HEX,"Panel",0,No,""')
    result = desk.good(
        "if all(xd.Panel == 5, sc.Slow, sd.Code == 3):\n    out(y[1])",
        "nickname(sc.Slow, sc[900])\nnickname(sd.Code, sd[900])",
    )
    assert rung(result) == "XD2==0005h SC900 SD900==3 out(Y001)"
    assert "SC900" not in result.files["nicknames.csv"]
    assert "SD900" not in result.files["nicknames.csv"]
    assert b'SC900,BIT,"Slow"' in result.table


@pytest.mark.parametrize(("taken", "name"), [("ct[1:251]", "ct.New"), ("c[1:2001]", "c.New"), ("t[1:501]", "t.New")])
def test_a_full_bank(desk: Desk, taken: str, name: str) -> None:
    bank, count = taken.split("[")[0], int(taken.split(":")[1].rstrip("]")) - 1
    kind, retentive = "BIT", "Yes" if bank == "ct" else "No"
    desk.rows(*(f'{bank.upper()}{number},{kind},"N{number}",0,{retentive},""' for number in range(1, count + 1)))
    problem = desk.bad("CG208", f"if {name}:\n    out(y[1])")
    assert desk.text_at(problem) == name
    assert str(count) in problem.help


def test_the_last_free_address_of_a_bank_is_given(desk: Desk) -> None:
    desk.rows(*(f'CT{number},BIT,"N{number}",0,Yes,""' for number in range(1, 251) if number != 137))
    assert new(desk.good("if ct.New:\n    out(y[1])")) == {"New": "CT137"}


def test_a_block_that_no_gap_is_long_enough_for(desk: Desk) -> None:
    desk.rows(*(f'DH{number},HEX,"N{number}",0,Yes,""' for number in range(3, 501, 3)))
    problem = desk.bad("CG208", "if x[1]:\n    copy_block(ds[1:5], dh.Copy)")
    assert desk.text_at(problem) == "dh.Copy"


def test_a_name_that_click_does_not_take_is_told_once(desk: Desk) -> None:
    problem = desk.bad("CG203", 'if c["a,b"]:\n    out(c["a,b"])\nif c["A,B"]:\n    out(y[1])')
    assert problem.span is not None
    assert problem.span.line == 4


# -- frozen ------------------------------------------------------------------------------------------------------------


def test_frozen_names_all_that_is_missing(desk: Desk) -> None:
    desk.rows('C1,BIT,"Old",0,No,""')
    result = desk.build("if all(c.Old, c.New, c.new):\n    out(c.Other)\n    ton(t.Delay, ds.Time)", frozen=True)
    assert not result.ok
    assert [(problem.code, desk.text_at(problem)) for problem in result.diagnostics] == [
        ("CG209", "c.New"),
        ("CG209", "c.Other"),
        ("CG209", "t.Delay"),
        ("CG209", "ds.Time"),
    ]
    assert result.table == desk.table.read_bytes()


def test_frozen_without_a_table(desk: Desk) -> None:
    desk.bad("CG209", "if c.New:\n    out(y[1])", frozen=True)
    assert desk.good("if c[1]:\n    out(y[1])", frozen=True).files
    assert not desk.table.exists()


def test_frozen_takes_declared_and_system_names(desk: Desk) -> None:
    result = desk.good("if all(c.Run, sc._1st_SCAN):\n    out(y[1])", "nickname(c.Run, c[3])", frozen=True)
    assert rung(result) == "C3 SC2 out(Y001)"
    assert 'C3,BIT,"Run",0,No,""' in result.files["nicknames.csv"]


SPLIT = "if all(c.Go, nc(c.Done)):\n    set(c.Done)\n    rton(t.Run, 5, reset=lambda: c.Clear)"


def test_frozen_refuses_a_new_scratch_address(desk: Desk) -> None:
    first = desk.good(SPLIT)
    desk.table.write_bytes(first.table)
    assert desk.good(SPLIT, frozen=True).files == first.files
    desk.table.write_bytes(b"".join(line for line in first.table.splitlines(keepends=True) if b"Scratch" not in line))
    problem = desk.bad("CG209", SPLIT, frozen=True)
    assert problem.span is not None
    assert problem.span.line == 4


# -- scratch -----------------------------------------------------------------------------------------------------------


def test_scratch_comes_from_the_top_with_name_and_comment(desk: Desk) -> None:
    result = desk.good(SPLIT)
    assert new(result)["Scratch_C2000"] == "C2000"
    assert b'C2000,BIT,"Scratch_C2000",0,No,"condition of main: rton T1 Run"' in result.table


def test_scratch_avoids_what_the_table_and_the_program_use(desk: Desk) -> None:
    desk.rows('C2000,BIT,"Mine",0,No,""', 'C1999,BIT,"",0,Yes,""')
    result = desk.good(SPLIT + "\nif c[1998]:\n    reset(c[1990:1998])", "nickname(c.Pinned, c[1989])")
    assert [name for name in new(result) if name.startswith("Scratch")] == ["Scratch_C1988"]


@pytest.mark.parametrize("use", ["out(c[2000])", "reset(c[1995:2001])", "copy_block(x[1:6], c[1996])"])
def test_a_scratch_address_is_not_shared_with_a_number_of_the_program(desk: Desk, use: str) -> None:
    """The program has taken the address by number after an earlier build put a scratch bit there."""
    desk.table.write_bytes(desk.good(SPLIT).table)
    result = desk.build(f"{SPLIT}\nif x[9]:\n    {use}")
    if result.ok:
        assert "out(C2000)" not in rung(result), "a scratch bit and the program's own bit are one"


@pytest.mark.parametrize(
    ("top", "rows"),
    [
        ("", ()),
        ("nickname(c.Scratch_C2000, c[7])", ()),
        ("", ('C1500,BIT,"Scratch_C2000",0,No,""',)),
    ],
)
def test_a_name_of_the_users_may_look_like_a_scratch_name(desk: Desk, top: str, rows: tuple[str, ...]) -> None:
    if rows:
        desk.rows(*rows)
    result = desk.build(f"{SPLIT}\nif x[9]:\n    out(c.Scratch_C2000)", top)
    assert result.ok or {problem.code[:3] for problem in result.diagnostics} == {"CG2"}


def test_a_declared_scratch_name_is_the_users(desk: Desk) -> None:
    """Or it is refused at once; but not taken by one build and refused by the next."""
    top = "nickname(c.Scratch_C2000, c[2000])"
    rungs = f"{SPLIT}\nif x[9]:\n    out(c.Scratch_C2000)"
    first = desk.build(rungs, top)
    if first.ok:
        desk.table.write_bytes(first.table)
        assert "out(C2000)" not in rung(desk.good(rungs, top))


# -- what is written to the table --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("declaration", "row"),
    [
        ("nickname(c.A, c[5])", 'C5,BIT,"A",0,No,""'),
        ("nickname(c.A, c[5], initial=1)", 'C5,BIT,"A",1,No,""'),
        ("nickname(ds.A, ds[5])", 'DS5,INT,"A",0,Yes,""'),
        ("nickname(ds.A, ds[5], retentive=False)", 'DS5,INT,"A",0,No,""'),
        ("nickname(ds.A, ds[5], initial=-32768)", 'DS5,INT,"A",-32768,Yes,""'),
        ("nickname(dd.A, dd[5], initial=2147483647)", 'DD5,INT2,"A",2147483647,Yes,""'),
        ("nickname(dh.A, dh[5], initial=0x00ff)", 'DH5,HEX,"A",00FF,Yes,""'),
        ('nickname(dh.A, dh[5], initial="00FFh")', 'DH5,HEX,"A",00FF,Yes,""'),
        ("nickname(df.A, df[5], initial=2.5)", 'DF5,FLOAT,"A",2.5,Yes,""'),
        ("nickname(df.A, df[5], initial=-3.4028235e38)", 'DF5,FLOAT,"A",-3.4028235E+38,Yes,""'),
        ('nickname(txt.A, txt[5], initial="Q")', 'TXT5,TEXT,"A",Q,Yes,""'),
        ("nickname(x.A, x[5], initial=1, retentive=True)", 'X005,BIT,"A",1,Yes,""'),
        ("nickname(c.A, c[5], comment='say \"hi\", you')", 'C5,BIT,"A",0,No,"say ""hi"", you"'),
        ('nickname(y["A b"], y[21], comment="")', 'Y021,BIT,"A b",0,No,""'),
        ("nickname(td.A, td[5])", 'TD5,INT,"A",0,No,""'),
        ("nickname(ctd.A, ctd[5])", 'CTD5,INT2,"A",0,Yes,""'),
    ],
)
def test_declared_attributes_are_written(desk: Desk, declaration: str, row: str) -> None:
    result = desk.good("if True:\n    pass", declaration)
    assert result.table.decode() == f"{HEADER}\n{row}\n"
    assert row in result.files["nicknames.csv"]


@pytest.mark.parametrize(
    "declaration",
    [
        "nickname(c.A, c[5], initial=2)",
        "nickname(ds.A, ds[5], initial=32768)",
        "nickname(ds.A, ds[5], initial=1.5)",
        'nickname(ds.A, ds[5], initial="5")',
        "nickname(dh.A, dh[5], initial=0x10000)",
        "nickname(df.A, df[5], initial=1e39)",
        'nickname(txt.A, txt[5], initial="QQ")',
        "nickname(sc.A, sc[5], initial=1)",
        "nickname(sd.A, sd[5], retentive=True)",
    ],
)
def test_declared_attributes_that_click_does_not_hold(desk: Desk, declaration: str) -> None:
    problem = desk.bad("CG302", "if True:\n    pass", declaration)
    assert problem.span is not None
    assert problem.span.line == 1


def test_a_declaration_changes_only_what_it_says(desk: Desk) -> None:
    desk.rows('DS5,INT,"Rows",7,No,"rows of the list"', 'DS6,INT,"",9,No,"unnamed"')
    result = desk.good("if True:\n    pass", "nickname(ds.Rows, ds[5], initial=10)\nnickname(ds.Cols, ds[6])")
    assert result.table.decode().splitlines()[1:] == [
        'DS5,INT,"Rows",10,No,"rows of the list"',
        'DS6,INT,"Cols",9,No,"unnamed"',
    ]


def test_new_rows_stand_in_clicks_order(desk: Desk) -> None:
    desk.rows('X001,BIT,"First",0,No,""', 'C5,BIT,"Mid",0,No,""', 'TXT1,TEXT,"Last",,Yes,""')
    result = desk.good("if c.A:\n    copy(1, ds.B)\n    ton(t.D, 5)", "nickname(c.Z, c[9])")
    addresses = [line.split(",")[0] for line in result.table.decode().splitlines()[1:]]
    assert addresses == ["X001", "C1", "C5", "C9", "T1", "DS1", "TXT1"]


STRANGE = (
    'C0005,BIT,Loose,0,No,""',
    'DS3,INT,"Unquoted comment",5,No,plain',
    "",
    'SC1,BIT,"_Always_ON",0,No,""',
    'C77,BIT,"Say ""so""",0,No,"x"',
    'DH1,HEX,"Low",00ff,Yes,"two ""quotes"" and, a comma"',
    'C3,BIT,"Out of order",0,No,""',
    'TXT9,TEXT,"Letter",A,No,""',
)


@pytest.mark.parametrize("end", ["\n", "\r\n"])
@pytest.mark.parametrize("bom", [b"", b"\xef\xbb\xbf"])
@pytest.mark.parametrize("final", [True, False])
def test_foreign_rows_are_kept_byte_for_byte(desk: Desk, end: str, bom: bytes, final: bool) -> None:
    rows = [row for row in STRANGE if "Say" not in row and "C0005" not in row]
    text = end.join((HEADER, *rows)) + (end if final else "")
    desk.table.write_bytes(bom + text.encode())
    result = desk.good("if c.New:\n    copy(1, ds.Fresh)")
    lines = result.table.removeprefix(bom).decode().split(end)
    assert result.table.startswith(bom)
    assert (lines[-1] == "") == final
    if end == "\r\n":
        assert result.table.count(b"\n") == result.table.count(b"\r\n")
    added = ['C1,BIT,"New",0,No,""', 'DS1,INT,"Fresh",0,Yes,""']
    assert [line for line in lines if line not in added] == [HEADER, *rows, *([""] if final else [])]
    assert all(line in lines for line in added)
    desk.table.write_bytes(result.table)
    assert desk.good("if c.New:\n    copy(1, ds.Fresh)").table == result.table


def test_the_csv_for_click_is_in_plain_form_whatever_the_table(desk: Desk) -> None:
    desk.table.write_bytes(
        b"\xef\xbb\xbf" + f'{HEADER}\r\nDS3,INT,"B",5,No,plain\r\nC3,BIT,A,0,No,""\r\nC9,BIT,"",0,No,""\r\n'.encode()
    )
    text = desk.good("if c.A:\n    out(y[1])").files["nicknames.csv"]
    assert text == f'{HEADER}\nC3,BIT,"A",0,No,""\nDS3,INT,"B",5,No,"plain"\n'


def test_a_malformed_row_stops_the_build_and_touches_nothing(desk: Desk) -> None:
    desk.rows('C1,BIT,"A",0,Perhaps,""', 'C2001,BIT,"B",0,No,""', 'DS1,BIT,"D",0,Yes,""')
    before = desk.table.read_bytes()
    result = desk.build("if c.New:\n    out(y[1])")
    assert {problem.code for problem in result.diagnostics} == {"CG601"}
    assert [desk.text_at(problem) for problem in result.diagnostics] == ["Perhaps", "C2001", "BIT"]
    assert result.table == before


def test_a_table_name_that_click_does_not_take(desk: Desk) -> None:
    desk.rows('C1,BIT,"Run!",0,No,""')
    assert desk.text_at(desk.bad("CG603", "if True:\n    pass")) == '"Run!"'


def test_a_named_table_must_exist(desk: Desk) -> None:
    desk.program.write_text("def main():\n    if True:\n        end()\n")
    with pytest.raises(clickgen.CouldNotRun, match=r"no address table at .*other\.csv"):
        clickgen.build(desk.program, nicknames=desk.folder / "other.csv")


def test_a_named_table_is_used_instead_of_the_one_beside(desk: Desk) -> None:
    desk.rows('C5,BIT,"Run",0,No,""')
    other = desk.folder / "other.csv"
    other.write_text(f'{HEADER}\nC6,BIT,"Run",0,No,""\n')
    desk.good("if c.Run:\n    out(y[1])")
    result = clickgen.build(desk.program, nicknames=other)
    assert rung(result) == "C6 out(Y001)"
    assert result.table_path == other
