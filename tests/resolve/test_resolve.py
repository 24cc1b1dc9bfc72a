"""The source of an address (docs/language.md, "Addresses"), through whole builds."""

from __future__ import annotations

import pytest
from resolving import Desk, desk, new, rung

import clickgen
from clickgen.device.system import find_system_name, system_name_of, system_nicknames, system_points

__all__ = ["desk"]


# -- the order of the four sources -------------------------------------------------------------------------------------


def test_a_declaration_comes_before_the_table(desk: Desk) -> None:
    desk.rows('C9,BIT,"Other",0,No,""')
    result = desk.good("if c.Run:\n    out(c.Other)", "nickname(c.Run, c[5])")
    assert rung(result) == "C5 out(C9)"
    assert new(result) == {}


def test_the_table_comes_before_allocation(desk: Desk) -> None:
    desk.rows('C7,BIT,"Run",0,No,""')
    assert rung(desk.good("if c.Run:\n    out(y[1])")) == "C7 out(Y001)"


def test_the_table_comes_before_clicks_own_names(desk: Desk) -> None:
    name = "_1st_SCAN"
    desk.rows(f'SC777,BIT,"{name}",0,No,""')
    assert rung(desk.good(f"if sc.{name}:\n    out(y[1])")) == "SC777 out(Y001)"


def test_clicks_own_names_come_before_allocation(desk: Desk) -> None:
    result = desk.good("if sc._1st_SCAN:\n    out(y[1])")
    assert rung(result) == "SC2 out(Y001)"
    assert new(result) == {}


def test_a_declared_name_may_agree_with_the_table(desk: Desk) -> None:
    desk.rows('C5,BIT,"Run",0,No,""')
    before = desk.table.read_bytes()
    result = desk.good("if c.Run:\n    out(y[1])", "nickname(c.Run, c[5])")
    assert result.table == before


def test_a_declaration_below_the_routine_counts_as_well(desk: Desk) -> None:
    desk.program.write_text(
        "def main():\n    if c.Run:\n        end()\n    if True:\n        end()\n\n\nnickname(c.Run, c[5])\n"
    )
    result = clickgen.build(desk.program)
    assert result.ok
    assert new(result) == {}
    assert b'C5,BIT,"Run",0,No,""' in result.table


# -- disagreement ------------------------------------------------------------------------------------------------------


def test_a_declaration_moves_no_name_of_the_table(desk: Desk) -> None:
    desk.rows('C6,BIT,"Run",0,No,""')
    problem = desk.bad("CG205", "if c.Run:\n    out(y[1])", "nickname(c.Run, c[5])")
    assert desk.text_at(problem) == "nickname(c.Run, c[5])"
    assert "C5" in problem.message
    assert "C6" in problem.message
    assert "line 2" in problem.message
    assert problem.labels[0].span.path == str(desk.table)


def test_a_declaration_takes_no_address_of_the_table(desk: Desk) -> None:
    desk.rows('C5,BIT,"Stop",0,No,""')
    problem = desk.bad("CG205", "if c.Run:\n    out(y[1])", "nickname(c.Run, c[5])")
    assert "Stop" in problem.message


@pytest.mark.parametrize("second", ["nickname(c.Run, c[6])", "nickname(c.RUN, c[6])", "nickname(c.Stop, c[5])"])
def test_two_declarations_disagree_at_the_later_one(desk: Desk, second: str) -> None:
    problem = desk.bad("CG205", "if c.Run:\n    out(y[1])", f"nickname(c.Run, c[5])\n{second}")
    assert desk.text_at(problem) == second
    assert problem.labels[0].span.line == 1


def test_a_declaration_cannot_take_clicks_own_name_away(desk: Desk) -> None:
    for declaration in ("nickname(c._1st_SCAN, c[5])", "nickname(sc._1st_SCAN, sc[5])"):
        problem = desk.build("if True:\n    pass", declaration).diagnostics[0]
        assert problem.is_error
        assert problem.code in ("CG203", "CG205")


def test_a_declaration_names_its_bank_twice(desk: Desk) -> None:
    problem = desk.bad("CG205", "if True:\n    pass", "nickname(c.Run, ds[5])")
    assert "DS5" in problem.message


def test_a_wrong_declaration_is_one_problem_and_its_uses_are_none(desk: Desk) -> None:
    desk.bad("CG205", "if c.Run:\n    out(c.Run)\nif c.Run:\n    set(c.Run)", "nickname(c.Run, ds[5])")


def test_the_table_gives_an_address_twice(desk: Desk) -> None:
    desk.rows('C1,BIT,"Run",0,No,""', 'C1,BIT,"Stop",0,No,""')
    problem = desk.bad("CG602", "if True:\n    pass")
    assert problem.span is not None
    assert problem.span.line == 3
    assert problem.labels[0].span.line == 2


def test_the_table_gives_a_name_twice_whatever_the_case(desk: Desk) -> None:
    desk.rows('C1,BIT,"Run",0,No,""', 'DS1,INT,"RUN",0,Yes,""')
    problem = desk.bad("CG602", "if True:\n    pass")
    assert desk.text_at(problem) == '"RUN"'


# -- one nickname, one address -----------------------------------------------------------------------------------------


def test_names_know_no_case(desk: Desk) -> None:
    result = desk.good("if c.Run:\n    out(c.run)\nif c.RUN:\n    out(y[1])")
    assert new(result) == {"Run": "C1"}
    assert rung(result, 2) == "C1 out(Y001)"


def test_the_table_keeps_its_spelling(desk: Desk) -> None:
    desk.rows('C1,BIT,"RUN",0,No,""')
    before = desk.table.read_bytes()
    assert desk.good("if c.run:\n    out(y[1])").table == before
    assert desk.good("if c.run:\n    out(y[1])", "nickname(c.Run, c[1])").table == before


@pytest.mark.parametrize("first", ["if c.Speed:\n    out(y[1])", "if True:\n    out(c.Speed)"])
def test_one_name_in_two_banks_is_a_problem_at_the_later_use(desk: Desk, first: str) -> None:
    problem = desk.bad("CG204", f"{first}\nif True:\n    copy(1, ds.speed)")
    assert desk.text_at(problem) == "ds.speed"
    assert problem.labels[0].span.line < (problem.span.line if problem.span else 0)


def test_one_name_in_two_banks_between_table_and_program(desk: Desk) -> None:
    desk.rows('DS4,INT,"Speed",0,Yes,""')
    problem = desk.bad("CG204", "if c.Speed:\n    out(y[1])")
    assert desk.text_at(problem) == "c.Speed"
    assert problem.labels[0].span.path == str(desk.table)


def test_a_system_name_in_the_wrong_bank(desk: Desk) -> None:
    problem = desk.bad("CG204", 'if c["_1st_SCAN"]:\n    out(y[1])')
    assert "sc._1st_SCAN" in problem.message


# -- current values ----------------------------------------------------------------------------------------------------


def test_td_and_ctd_names_are_the_current_values(desk: Desk) -> None:
    result = desk.good(
        """\
        if td.Delay > 5:
            copy(ctd.Parts, dd[1])
        if re(x[1]):
            ton(t.Delay, 10)
            ctu(ct.Parts, 10, reset=lambda: x[2])
        """
    )
    assert rung(result) == 'TD1>5 "copy(CTD1,DD1)"'
    assert new(result) == {"Delay": "T1", "Parts": "CT1"}


def test_td_names_follow_the_table_and_declarations(desk: Desk) -> None:
    desk.rows('T7,BIT,"Delay",0,No,""')
    result = desk.good("if td.delay > ctd.Parts:\n    out(y[1])", "nickname(ct.Parts, ct[9])")
    assert rung(result) == "TD7>CTD9 out(Y001)"


def test_a_td_address_may_have_a_nickname_of_its_own(desk: Desk) -> None:
    desk.rows('TD3,INT,"Elapsed",0,No,""')
    result = desk.good("if td.Elapsed > 5:\n    ton(t.Delay, 10)")
    assert rung(result) == 'TD3>5 "on_delay(T1,TD1,preset=10,unit=Tms)"'


def test_a_declared_td_name(desk: Desk) -> None:
    result = desk.good("if td.Elapsed > 5:\n    ton(t[4], 10)", "nickname(td.Elapsed, td[4])")
    assert rung(result) == 'TD4>5 "on_delay(T4,TD4,preset=10,unit=Tms)"'


@pytest.mark.parametrize("name", ["td.Dely", "ctd.Dely"])
def test_a_current_value_of_nothing(desk: Desk, name: str) -> None:
    problem = desk.bad("CG207", f"if {name} > 5:\n    ton(t.Delay, 10)")
    assert desk.text_at(problem) == name


def test_a_td_name_that_is_a_register(desk: Desk) -> None:
    assert desk.text_at(desk.bad("CG204", "if td.Level > 5:\n    copy(1, ds.Level)")) in ("td.Level", "ds.Level")


# -- quoted names ------------------------------------------------------------------------------------------------------


def test_quoted_names(desk: Desk) -> None:
    desk.rows('C5,BIT,"Belt runs",0,No,""', 'C6,BIT,"1st",0,No,""')
    result = desk.good('if all(c["Belt runs"], c["1st"], c["belt RUNS"], c["New one"]):\n    out(c["Plain"])')
    assert new(result) == {"New one": "C1", "Plain": "C2"}
    assert b'C1,BIT,"New one",0,No,""' in result.table


def test_a_quoted_plain_name_is_the_same_name(desk: Desk) -> None:
    assert new(desk.good('if c["Run"]:\n    out(c.Run)')) == {"Run": "C1"}


def test_quoted_names_in_formulas_and_declarations(desk: Desk) -> None:
    result = desk.good(
        """if x[1]:\n    calc("ds['Belt speed'] + 1", ds["Belt speed"])""", 'nickname(ds["Belt speed"], ds[8])'
    )
    assert '"math(DS8 + 1,DS8,mode=decimal)"' in result.files["main.csv"]


# -- clicks own names --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("written", "token"),
    [
        ('sd["_RTC_Year (4 digits)"]', "SD19"),
        ('sd["_RTC_Year(4 digits)"]', "SD19"),
        ('sd["_rtc_year(4DIGITS)"]', "SD19"),
        ("sd._rtc_new_month", "SD31"),
    ],
)
def test_system_names_with_and_without_spaces(desk: Desk, written: str, token: str) -> None:
    assert rung(desk.good(f"if {written} > 5:\n    out(y[1])")) == f"{token}>5 out(Y001)"


def test_every_system_name_resolves(desk: Desk) -> None:
    points = [(name, address) for name, address in system_nicknames().values() if '"' not in name]
    bits = [(name, address) for name, address in points if address.bank == "SC"]
    assert len(bits) > 100
    rungs = "\n".join(f'if sc["{name}"]:\n    out(y[1])' for name, _ in bits)
    result = desk.good(rungs)
    assert new(result) == {}
    text = "".join(result.files[name] for name in sorted(result.files) if name.startswith("main"))
    for _, address in bits:
        assert f"\nR,{address}," in text


def test_a_misspelt_system_name_gets_a_hint(desk: Desk) -> None:
    problem = desk.bad("CG206", "if sc._1st_SCN:\n    out(y[1])")
    assert problem.help == "did you mean _1st_SCAN?"


@pytest.mark.parametrize(
    ("written", "help"),
    [
        ("sd._RTC_Hours", "did you mean _RTC_Hour?"),
        ("sd._RTC_New_Hours", "did you mean _RTC_New_Hour?"),
        ("sd._Minimun_Scan_Time", "did you mean _Minimum_Scan_Time?"),
        ("sc._Run_Edit_Project_Error", 'did you mean sc["_Run Edit Project Error"]?'),
        ("sc._Port1_Ready_Flag", "did you mean _Port_1_Ready_Flag?"),
    ],
)
def test_a_name_that_can_only_mean_one_point_is_suggested(desk: Desk, written: str, help: str) -> None:
    rung = f"if {written}:\n    out(y[1])" if written.startswith("sc") else f"if {written} == 1:\n    out(y[1])"
    assert desk.bad("CG206", rung).help == help


@pytest.mark.parametrize(
    "written",
    [
        "sd._RTC_Mins",
        "sd._RTC_Hour_New",
        "sd._Port4_No_Comm_Time",
        "sd._Scan_Time",
        "sd._S2_CPU_USAGE",
        "sd._WLAN_IP_Address5",
        "sc._Always_OFF",
        "sc._5sec_Clock",
        "sc._2nd_SCAN",
        "sc._Port_4_Ready_Flag",
        "sc._BT_Enable_Pairing",
        "sc._RTC_Date_Chance_Time",
        "sc._WLAN_Unready_Flag",
    ],
)
def test_no_neighbour_is_suggested(desk: Desk, written: str) -> None:
    rung = f"if {written}:\n    out(y[1])" if written.startswith("sc") else f"if {written} == 1:\n    out(y[1])"
    assert "did you mean" not in desk.bad("CG206", rung).help


def test_other_spellings_of_click_s_own_names_mean_the_same_address(desk: Desk) -> None:
    others = [point for point in system_points() if point.name and point.other]
    assert len(others) == 23
    # SC22's reads like the name of SC20 too: it is refused.
    others = [point for point in others if point.other != "_I/O_Module_Error"]
    bits = [point for point in others if point.address.bank == "SC"]
    result = desk.good("\n".join(f'if sc["{point.other}"]:\n    out(y[1])' for point in bits))
    assert "".join(result.files["main.csv"]).count("\nR,SC") == len(bits)
    for point in others:
        assert find_system_name(point.other) == (point.name, point.address)
        assert system_name_of(point.address) == point.name


def test_a_name_that_moved_between_versions_of_click_is_refused(desk: Desk) -> None:
    for name, newest, older in (("_Port1_AL_Denied_Count", 132, 134), ("_WLAN_AL_Denied_Count", 133, 135)):
        problem = desk.bad("CG215", f"if x[1]:\n    copy(sd.{name}, ds[1])")
        assert f"SD{newest} in CLICK 3.41 and SD{older}" in problem.message
        assert f"sd[{newest}] or sd[{older}]" in problem.help
        # The way out compiles: the number, or the name tied to it.
        assert f"copy(SD{older},DS1)" in desk.good(f"if x[1]:\n    copy(sd[{older}], ds[1])").files["main.csv"]
        for number in (newest, older):
            pinned = desk.build(f"if x[1]:\n    copy(sd.{name}, ds[1])", top=f"nickname(sd.{name}, sd[{number}])")
            assert f"copy(SD{number},DS1)" in pinned.files["main.csv"]
    desk.rows('SD134,INT,"_Port1_AL_Denied_Count",0,No,""')
    assert "copy(SD134,DS1)" in desk.good("if x[1]:\n    copy(sd._Port1_AL_Denied_Count, ds[1])").files["main.csv"]


@pytest.mark.parametrize(
    "name", ["_I/O_Module_Error", "_i/o_module_error", "_I/O Module_Error", "_I/O_Module Error", "_I/OModuleError"]
)
def test_a_name_that_reads_like_the_names_of_two_addresses_is_refused(desk: Desk, name: str) -> None:
    problem = desk.bad("CG215", f'if sc["{name}"]:\n    out(y[1])')
    for address in ("SC20", "SC22"):
        assert address in problem.message
    assert "sc[20] or sc[22]" in problem.help
    for number in (20, 22):
        assert f"SC{number},-" in desk.good(f"if sc[{number}]:\n    out(y[1])").files["main.csv"]
        pinned = desk.build(f'if sc["{name}"]:\n    out(y[1])', top=f'nickname(sc["{name}"], sc[{number}])')
        assert f"SC{number},-" in pinned.files["main.csv"]
    for shown, number in (("_I/O Module Error", 20), ("_i/o module error", 20), ("_I/O Config Error", 22)):
        clean = desk.build(f'if sc["{shown}"]:\n    out(y[1])')
        assert f"SC{number},-" in clean.files["main.csv"]
        assert not clean.diagnostics
    desk.rows('SC22,BIT,"_I/O_Module_Error",0,No,""')
    assert "SC22,-" in desk.good('if sc["_I/O_Module_Error"]:\n    out(y[1])').files["main.csv"]


def test_disputed_system_bits_are_written_with_a_warning(desk: Desk) -> None:
    result = desk.build("if x[1]:\n    set(sc[305])\n    reset(sc[325:327])\n    out(sc[303])")
    assert result.ok
    warnings = [problem for problem in result.diagnostics if problem.code == "CG312"]
    assert [problem.message.split(" has ")[1].split(" as ")[0] for problem in warnings] == ["SC305", "SC325, SC326"]
    desk.bad("CG304", "if x[1]:\n    set(sc[307])")
