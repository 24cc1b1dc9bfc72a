"""Wrong calls and values: each has its own reason, and whatever its way out shows builds in its place."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from test_ways_out import action, errors

from clickgen.instructions import INSTRUCTIONS

# The code as written, and what the way out must show; everything else that it shows must build too.
UNWRITABLE = [
    ("x[1] = 1", "set(c.Name)"),
    ("x[1] = 1", "set(y.Name)"),
    ("x.Start = False", "reset(c.Name)"),
    ("x[1] = c.A", "if c.A: out(c.Name)"),
    ("x[1:5] = 1", "set(c.Name)"),
    ("t[1] = 0", "rton(t[1], setpoint=5, unit=Ts, reset=lambda: c.Clear)"),
    ("t[1] = 1", "ton(t[1], setpoint=5, unit=Ts)"),
    ("t.A = c.B", "ton(t.A, setpoint=5, unit=Ts)"),
    ("ct[1] = 0", "ctu(ct[1], setpoint=10, reset=lambda: c.Clear)"),
    ("ct[1] = True", "ctu(ct[1], setpoint=10).reset(c.Clear)"),
    ("td[1] = 0", "copy(0, td[1])"),
    ("td.A = 0", "rton(t.A, setpoint=5, unit=Ts, reset=lambda: c.Clear)"),
    ("td.A = 5", "ton(t.A, setpoint=5, unit=Ts)"),
    ("ctd.A = 0", "ctu(ct.A, setpoint=10, reset=lambda: c.Clear)"),
    ("t[1].acc = 0", "copy(0, td[1])"),
    ("ct[1].acc = 7", "copy(7, ctd[1])"),
    ("sd[1] = 5", "copy(5, ds.Name)"),
    ("sd[1] += 1", 'calc("sd[1] + 1", ds.Name)'),
    ("sd._RTC_Hour = 5", "copy(5, sd._RTC_New_Hour)"),
    ("sc[1] = True", "set(c.Name)"),
    ("sc[2] = 0", "reset(c.Name)"),
    ("sc._1st_SCAN = c.A", "out(c.Name)"),
    ("xd[0] = 5", "copy(5, dh.Name)"),
    ("out(x[1])", "out(c.Name)"),
    ("set(t[1])", "set(c.Name)"),
    ("reset(sc[1])", "reset(c.Name)"),
    ("copy(5, sd[1])", "copy(5, ds.Name)"),
    ("copy(5, sd._RTC_Minute)", "copy(5, sd._RTC_New_Minute)"),
    ("copy(c.A, x[1])", "copy(c.A, y.Name)"),
    ("out(xd[0])", "copy(xd[0], dh.Name)"),
    ("set(x[1], 1)", "set(c.Name)"),
]
COILS = [
    ("reset(td.A)", "rton(t.A, setpoint=5, unit=Ts, reset=lambda: c.Clear)"),
    ("reset(td[1])", "copy(0, td[1])"),
    ("reset(ctd.A)", "ctu(ct.A, setpoint=10, reset=lambda: c.Clear)"),
    ("set(td.A, 0)", "rton(t.A, setpoint=5, unit=Ts, reset=lambda: c.Clear)"),
    ("out(td.A)", "ton(t.A, setpoint=5, unit=Ts)"),
    ("set(ds.A, 5)", "copy(5, ds.A)"),
    ("set(df.A, 1.5)", "copy(1.5, df.A)"),
    ("set(ds.A, ds.B)", "copy(ds.B, ds.A)"),
    ('set(txt.A, "X")', 'copy("X", txt.A)'),
    ("set(ds.A)", "copy(1, ds.A)"),
    ("reset(ds.A)", "copy(0, ds.A)"),
    ("out(ds.A)", "out(c.Name)"),
    ("out(ds.A, 5)", "copy(5, ds.A)"),
    ("out(txt[1])", 'copy("A", txt[1])'),
    ("set(c.A, 1)", "set(c.A)"),
    ("set(c.A, False)", "reset(c.A)"),
    ("reset(c.A, 0)", "reset(c.A)"),
    ("out(c.A, 1)", "out(c.A)"),
    ("set(c.A, c.B)", "set(c.B)"),
    ("out([c.A, c.B])", "out(c.B)"),
    ("out(y[1] = True)", "out(y[1])"),
    ("set(c.A := 0)", "reset(c.A)"),
    ("out(nc(c.A))", "out(c.A)"),
    ("out(not c.A)", "out(c.A)"),
    ("out(~c.A)", "out(c.A)"),
    ("out(not x[1])", "if nc(x[1]): out(c.Name)"),
    ("set(not c.A)", "reset(c.A)"),
    ("reset(nc(c.A))", "set(c.A)"),
    ("out(y[1] == True)", "out(y[1])"),
    ("set(c.A == 0)", "reset(c.A)"),
    ("out(re(c.A))", "out(c.A, oneshot=True)"),
    ("out(x[1] and x[2])", "if all(x[1], x[2]): out(c.Name)"),
    ("out(x[1] or nc(x[2]))", "if any(x[1], nc(x[2])): out(c.Name)"),
    ("set(ds.A > 5)", "if ds.A > 5: set(c.Name)"),
]
CONSTANTS = [
    ("copy(FFh, dh.A)", "copy(0x00FF, dh.A)"),
    ("copy(0FFh, dh.A)", "copy(0x00FF, dh.A)"),
    ("copy(0xFFFF, ds.A)", "copy(-1, ds.A)"),
    ("copy(0xFFFF, ds.A)", "copy(0xFFFF, dh.Name)"),
    ("copy_fill(0x8000, ds[1:5])", "copy(0x8000, dh.Name)"),
    ("copy(40000, ds.A)", "copy(40000, dd.Name)"),
    ("copy(70000, dh.A)", "copy(70000, dd.Name)"),
    ("copy(-1, dh.A)", "copy(0xFFFF, dh.A)"),
    ("copy(3000000000, dd.A)", "copy(3000000000.0, df.Name)"),
    ("copy(0xFFFFFFFF, dd.A)", "copy(-1, dd.A)"),
    ("copy(1.5, ds.A)", "copy(1.5, df.Name)"),
    ("copy(1,5, df.A)", "copy(1.5, df.A)"),
    ("copy(-1,5, df.A)", "copy(-1.5, df.A)"),
    ("copy(1,5, ds.A)", "copy(1.5, df.Name)"),
    ("copy_fill(0,25, df[1:5])", "copy_fill(0.25, df[1:5])"),
    ("copy 5, ds.A", "copy(5, ds.A)"),
    ("copy -5, ds.A", "copy(-5, ds.A)"),
    ("copy 5 ds.A", "copy(5, ds.A)"),
    ("copy ds.A ds.B", "copy(ds.A, ds.B)"),
    ('copy "A" txt[1]', 'copy("A", txt[1])'),
    ("copy(5 ds.A)", "copy(5, ds.A)"),
    ("copy(ds.A ds.B)", "copy(ds.A, ds.B)"),
    ("ton(t.A 5)", "ton(t.A, 5)"),
    ("ton(t.A, 5 unit=Ts)", "ton(t.A, 5, unit=Ts)"),
    ('copy("5", ds.A)', "copy(5, ds.A)"),
    ('copy("-5", dd.A)', "copy(-5, dd.A)"),
    ('copy("5.5", df.A)', "copy(5.5, df.A)"),
    ('copy("5,5", ds.A)', "copy(5.5, df.Name)"),
    ('copy("FF", dh.A)', "copy(0x00FF, dh.A)"),
    ('copy("ds.B", ds.A)', "copy(ds.B, ds.A)"),
    ('copy("DS5", ds.A)', "copy(ds[5], ds.A)"),
    ('copy("ABC", ds.A)', 'copy("ABC", txt.Name)'),
    ('copy(5, "ds.A")', "copy(5, ds.A)"),
    ("copy(ds.A, 5)", "copy(5, ds.A)"),
]
COPIES = [
    ("copy(x[1:17], ds.A)", "copy_pack(x[1:17], ds.A)"),
    ("copy(c[1:17], dh.A)", "copy_pack(c[1:17], dh.A)"),
    ("copy(y[1:9], dh.A)", "copy_pack(y[1:9], dh.A)"),
    ("copy(c[1:41], dd.A)", "copy_pack(c[1:33], dd.A)"),
    ("copy(ds[1:3], dd.A)", "copy_pack(ds[1:3], dd.A)"),
    ("copy_block(x[1:17], dh.A)", "copy_pack(x[1:17], dh.A)"),
    ("copy(ds.A, y[1:17])", "copy_unpack(ds.A, y[1:17])"),
    ("copy(dd.A, c[1:33])", "copy_unpack(dd.A, c[1:33])"),
    ("copy(ds.A, c[1:41])", "copy_unpack(ds.A, c[1:17])"),
    ("copy(dd.A, ds[1:3])", "copy_unpack(dd.A, ds[1:3])"),
    ("copy_block(ds.A, y[1:17])", "copy_unpack(ds.A, y[1:17])"),
    ("copy_fill(0, c[1:9])", "reset(c[1:9])"),
    ("copy_fill(1, y[1:9])", "set(y[1:9])"),
    ("copy(c.B, ds.A)", "if c.B: copy(1, ds.A)"),
    ("copy(ds.A, c.B)", "if ds.A != 0: out(c.B)"),
    ("copy(dh.A, y[1])", "if dh.A != 0x0000: out(y[1])"),
    ("copy(not c.A, y[1])", "if nc(c.A): out(y[1])"),
    ("copy(c.A and c.B, c.D)", "if all(c.A, c.B): out(c.D)"),
    ("copy(ds.A + 1, ds.B)", 'calc("ds.A + 1", ds.B)'),
    ("copy(max(ds.A, ds.B), ds.C)", "if ds.A >= ds.B: copy(ds.A, ds.C)"),
]
CHOICES = [
    ('calc("MAX(ds.Pump, ds.Fan)", ds.Best)', "if ds.Pump < ds.Fan: copy(ds.Fan, ds.Best)"),
    ('calc("MIN(df.Flow, 5)", df.Low)', "if df.Flow > 5: copy(5, df.Low)"),
    ('calc("1 + MAX(ds.Pump, ds.Fan)", ds.Best)', "if ds.Pump >= ds.Fan: copy(ds.Pump, ds.Result)"),
    ("MAX(ds.Pump, ds.Fan, ds.Best)", "if ds.Pump >= ds.Fan: copy(ds.Pump, ds.Best)"),
    ("MIN(ds.Pump, ds.Fan)", "if ds.Pump <= ds.Fan: copy(ds.Pump, ds.Result)"),
    ("ds.Best = max(ds.Pump, ds.Fan)", "if ds.Pump >= ds.Fan: copy(ds.Pump, ds.Best)"),
    ('calc("LIMIT(0, ds.Raw, 100)", ds.Held)', "if ds.Held > 100: copy(100, ds.Held)"),
    ("clamp(ds.Raw, 0, 100, ds.Held)", "copy(ds.Raw, ds.Held)"),
    ("SEL(c.Pick, ds.Low, ds.High, ds.Used)", "if nc(c.Pick): copy(ds.Low, ds.Used)"),
    ('calc("ABS(ds.Error)", ds.Size)', 'if ds.Size < 0: calc("-ds.Size", ds.Size)'),
    ("ds.Size = abs(ds.Error)", "copy(ds.Error, ds.Size)"),
    ('calc("ROUND(df.Raw)", ds.Whole)', 'calc("df.Raw + 0.5", df.Half)'),
]
_CALLS = re.compile(
    rf"(?:if [^:]*(?:\[[^\]]*\])?[^:]*: )?\b(?:{'|'.join(sorted(INSTRUCTIONS, key=len, reverse=True))})\("
)


def shown(help: str) -> list[str]:
    """The actions that a way out shows, each up to its last parenthesis, with the if before it."""
    found = []
    for match in _CALLS.finditer(help):
        end = _closing(help, match.end())
        while help.startswith(".reset(", end):
            end = _closing(help, end + len(".reset("))
        text = help[match.start() : end]
        # The signature of an instruction follows some ways out: it is no example.
        if "=None" not in text and "=False" not in text and "address)" not in text and "lambda: ..." not in text:
            found.append(text)
    return found


def _closing(text: str, start: int) -> int:
    depth = 1
    for at in range(start, len(text)):
        depth += (text[at] == "(") - (text[at] == ")")
        if depth == 0:
            return at + 1
    raise AssertionError(text)


@pytest.mark.parametrize(("written", "meant"), [*UNWRITABLE, *COILS, *CONSTANTS, *COPIES, *CHOICES])
def test_the_way_out_of_a_wrong_call_builds(written: str, meant: str, tmp_path: Path) -> None:
    problems = errors(action(written), tmp_path)
    said = " ".join(problem.help for problem in problems)
    assert meant in said or (meant.startswith("copy(") and _argument(meant) in said), said
    assert not errors(action(meant), tmp_path)
    for problem in problems[:1]:
        for text in shown(problem.help):
            if text.startswith("copy(") and re.search(r"\bc?td\.A\b", text):
                continue  # The current value of a timer that the way out runs first.
            assert not errors(action(text), tmp_path), text


def _argument(meant: str) -> str:
    """For a call with one wrong argument, the message names the argument: ``write 0x00FF``."""
    return (
        meant.partition("(")[2].partition(",")[0]
        if meant.startswith("copy(0x")
        else next(part.strip(" )") for part in reversed(meant.split(",")))
    )


def test_a_current_value_of_a_timer_of_the_file_is_written_by_a_copy(tmp_path: Path) -> None:
    owner = "if c.Run:\n        rton(t.A, 5, reset=lambda: c.Clear)\n    if c.Zero:\n        "
    for written in ("td.A = 0", "reset(td.A)"):
        (problem,) = errors(action(written).replace("if re(c.Go):\n        ", owner), tmp_path)
        assert "copy(0, td.A)" in problem.help
    assert not errors(action("copy(0, td.A)").replace("if re(c.Go):\n        ", owner), tmp_path)


@pytest.mark.parametrize("word", ["Each", "Beach", "Bach"])
def test_a_name_that_reads_like_a_number_stays_a_name(word: str, tmp_path: Path) -> None:
    assert f"ds.{word}" in errors(action(f"copy({word}, ds.A)"), tmp_path)[0].help


@pytest.mark.parametrize("written", ["limit(ds.Raw, 0, 100)", "clamp(0, ds.Raw, 100)"])
def test_limits_in_another_order_are_not_guessed(written: str, tmp_path: Path) -> None:
    assert "ds.Raw" not in errors(action(written), tmp_path)[0].help


@pytest.mark.parametrize("written", ['calc("MAX(ds.P, ds.Q, ds.R)", ds.S)', "copy(min(ds.P, ds.Q, ds.R), ds.S)"])
def test_a_third_value_is_no_destination(written: str, tmp_path: Path) -> None:
    assert ", ds.R)" not in errors(action(written), tmp_path)[0].help
