"""The written program reads like a person's, and is laid out as ``ruff format`` does."""

from __future__ import annotations

import pytest
from test_importing_cases import CASE_NAMES, golden_ladders, imported, ladder_text, source_of, wired
from test_importing_properties import ruff_changes

from clickgen.click.read.grid import read_ladder
from clickgen.click.read.rungs import import_rung, routine_of
from clickgen.device.banks import Address, parse_address
from clickgen.dialects.if_rungs.write.expressions import quoted
from clickgen.dialects.if_rungs.write.routine import write_source


def addresses(names: dict[str, str]) -> dict[Address, str]:
    return {address: name for text, name in names.items() if (address := parse_address(text))}


NAMES = addresses(
    {
        "X001": "Start",
        "C1": "Running",
        "C2": "for",
        "C3": "Lamp 3",
        "T1": "Delay",
        "CT1": "Parts",
        "DS1": "Step",
        "DS2": "Index",
        "DS10": "First",
        "SC1": "_Always_ON",
        "XD0": "Word",
        "TXT1": "Letter",
    }
)


def written(contacts: str, output: str, *pins: tuple[str, str], names: dict[Address, str] | None = None) -> str:
    """One rung as source, without its indentation."""
    rows = [wired(contacts, output, "R"), *(wired(*pin) for pin in pins)]
    [rung] = read_ladder(ladder_text(rows), "main.csv").rungs
    main = routine_of("main", [import_rung(rung).rung], True)
    text = write_source([main], NAMES if names is None else names, functions={"fill": "fill", "Fill 2": "fill_2"})
    assert ruff_changes(text) == ""
    return "\n".join(line[4:] for line in text.splitlines()[1:])


LINES: dict[str, tuple[str, str, str]] = {
    "nicknames": ("X001 ~C1 rise(T1)", "out(C4)", "if all(x.Start, nc(c.Running), re(t.Delay)):\n    out(c[4])"),
    "odd nicknames": ("C2 C3", "out(C3)", 'if all(c["for"], c["Lamp 3"]):\n    out(c["Lamp 3"])'),
    "current values": (
        "TD1>=DS1 CTD1==5",
        "out(C1)",
        "if all(td.Delay >= ds.Step, ctd.Parts == 5):\n    out(c.Running)",
    ),
    "CLICK's own names": ("SC1", "out(C1)", "if sc._Always_ON:\n    out(c.Running)"),
    "a word of upper points": ("XD0u==00FFh", "copy(XD0,DH1)", 'if xd["0u"] == 0x00FF:\n    copy(xd.Word, dh[1])'),
    "immediate": (
        "~immediate(X001)",
        "out(immediate(Y001..Y004))",
        "if nc(x.Start.immediate):\n    out(y[1:5].immediate)",
    ),
    "ranges": ("X001", "blockcopy(DS10..DS14,DS20..DS24)", "if x.Start:\n    copy_block(ds[10:15], ds[20])"),
    "a range backwards": (
        "X001",
        "latch(C8..C5)",
        "if x.Start:\n    set(c[8:4:-1])",
    ),
    "pointers": ("X001", "copy(DS[DS2],DD[DS3])", "if x.Start:\n    copy(ds[ds.Index], dd[ds[3]])"),
    "texts": ("X001", 'copy("Say ""go"" \\",TXT1)', "if x.Start:\n    copy('Say \"go\" \\\\', txt.Letter)"),
    "character codes": ("X001", "copy($0D,TXT1,oneshot=1)", 'if x.Start:\n    copy("$0D", txt.Letter, oneshot=True)'),
    "options": (
        "X001",
        "copy(DS1,TXT1,convert=to_text(suppress_zero=0,exponential=0,termination_code=$0D))",
        "if x.Start:\n    copy(\n        ds.Step,\n        txt.Letter,\n"
        '        options=to_text(suppress_zero=False, termination_code="$0D"),\n    )',
    ),
    "plain options": (
        "X001",
        "copy(DS1,TXT1,convert=to_text(suppress_zero=1,exponential=0,termination_code=none))",
        "if x.Start:\n    copy(ds.Step, txt.Letter, options=to_text)",
    ),
    "formulas": (
        "X001",
        "math(( DS1 + 2 ) * SUM ( DS10 : DS19 ),DD1,mode=decimal)",
        'if x.Start:\n    calc("(ds.Step + 2) * SUM(ds[10:20])", dd[1])',
    ),
    "hexadecimal formulas": (
        "X001",
        "math(LSH ( DH1 , 2h ) AND 00FFh,DH2,mode=hex,oneshot=1)",
        'if x.Start:\n    math_hex("LSH(dh[1], 0x2) AND 0x00FF", dh[2], oneshot=True)',
    ),
    "a search": (
        "X001",
        "search(DS10..DS19 >= DS1,result=DS2,found=C1,continuous=1)",
        "if x.Start:\n    search(ds[10:20] >= ds.Step, result=ds.Index, found=c.Running, continuous=True)",
    ),
    "a search between names": (
        "X001",
        "search(DS1..DS10 == 5,result=DS2,found=C1)",
        'if x.Start:\n    search("==", 5, ds.Step, ds.First, result=ds.Index, flag=c.Running)',
    ),
    "timers": (
        "X001",
        "on_delay(T1,TD1,preset=DS1,unit=Th)",
        "if x.Start:\n    ton(t.Delay, setpoint=ds.Step, unit=Th)",
    ),
    "calls": ("X001", 'call("fill")', "if x.Start:\n    call(fill)"),
    "calls by another name": ("X001", 'call("Fill 2")', "if x.Start:\n    call(fill_2)"),
    "calls of what is elsewhere": ("X001", 'call("Fill 3")', 'if x.Start:\n    call("Fill 3")'),
    "float constants": ("DF1>=1.5E+10", "copy(-0.5,DF1)", "if df[1] >= 15000000000.0:\n    copy(-0.5, df[1])"),
}


@pytest.mark.parametrize("name", LINES)
def test_a_rung_is_written_as_a_person_would(name: str) -> None:
    contacts, output, expected = LINES[name]
    assert written(contacts, output) == expected


def test_inputs_are_lambdas() -> None:
    found = written("rise(X001)", "count_up(CT1,CTD1,preset=DS1)", ("C1", ".down()"), ("C3", ".reset()"))
    assert found == (
        "if re(x.Start):\n"
        "    ctud(\n"
        "        ct.Parts,\n"
        "        setpoint=ds.Step,\n"
        "        count_down=lambda: c.Running,\n"
        '        reset=lambda: c["Lamp 3"],\n'
        "    )"
    )


LONG = {
    Address(bank, number): f"A_name_of_{bank}_{number:04}_letters"[:24]
    for bank in ("C", "DS")
    for number in range(1, 40)
}
LONG_RUNGS = [
    (" ".join(f"C{n}" for n in range(1, 4)), "out(C5)"),
    (" ".join(f"C{n}" for n in range(1, 20)), "out(C5)"),
    ("DS1==DS2", "copy(DS3,DS4,oneshot=1)"),
    ("DS1==DS2 DS3>=DS4", "search(DS1..DS9 >= DS20,result=DS21,found=C9,continuous=1,oneshot=1)"),
    ("C1", "math(DS1 + DS2 + DS3 + DS4 + DS5,DS6,mode=decimal)"),
    ("C1", 'copy("' + "x" * 80 + '",TXT1)'),
    ("C1", "raw(Odd,0x2799,1,222d=0,609b=1,609c=1,609d=1,222f=2,11f5=0,2231=0,60a2=,60a3=,60a4=,607b=,0000=)"),
    (
        "C1",
        'send(target=ModbusTcpTarget(name="a long label of it",ip="192.168.100.100",port=502,device_id=1),'
        "remote_start=ModbusAddress(address=64h,register_type=holding),source=DS1..DS5,sending=C1,success=C2)",
    ),
]


@pytest.mark.parametrize(("contacts", "output"), LONG_RUNGS)
def test_long_lines_are_divided_as_ruff_does(contacts: str, output: str) -> None:
    assert written(contacts, output, names=LONG)


def test_deep_branches_are_divided_as_ruff_does() -> None:
    """Each rung hangs on the one before it, a column further to the right."""
    last = 11
    lines: list[list[str]] = []
    for number in range(last):
        down = "T:" if number and number + 1 < last else ""
        blank = ["|" if column == number and number else "" for column in range(number)]
        condition = f"{down}DS{number + 1}==DS{number + 13}".removeprefix("T:")
        behind = ["T" if number + 1 < last else "-", *["-"] * (29 - number)]
        lines.append(["" if number else "R", *blank, condition, *behind, f"out(C{number + 1})"])
    [rung] = read_ladder(ladder_text(lines), "main.csv").rungs
    text = write_source([routine_of("main", [import_rung(rung).rung], True)], LONG)
    assert text.count("if ") == 11
    assert ruff_changes(text) == ""


@pytest.mark.parametrize("name", CASE_NAMES)
def test_golden_ladders_are_laid_out_as_ruff_does(name: str) -> None:
    assert ruff_changes(source_of(golden_ladders(name))) == ""


def test_a_file_has_its_header_and_its_routines() -> None:
    routines = imported(golden_ladders("call")).items()
    text = write_source(
        [routine_of(name, [one.rung for one in rungs], name == "main") for name, rungs in routines],
        header='"""The press."""\n',
    )
    assert text.startswith('"""The press."""\n\n\ndef main():\n    if ds[1] == 1:\n        call(Wash_Cycle)\n\n')
    assert "\n        end()\n\n\n@sub\ndef Wash_Cycle():\n    if x[2]:\n" in text
    assert ruff_changes(text) == ""


def test_a_routine_without_rungs_is_written() -> None:
    assert write_source([routine_of("empty", [], False)]) == "@sub\ndef empty():\n    pass\n"


@pytest.mark.parametrize(
    ("text", "literal"),
    [("A", '"A"'), ('"', "'\"'"), ("it's", '"it\'s"'), ("'\"", '"\'\\""'), ("\\", '"\\\\"'), ("\r", '"\\r"')],
)
def test_texts_are_quoted_as_ruff_does(text: str, literal: str) -> None:
    assert quoted(text) == literal
    assert ruff_changes(f"a = {literal}\n") == ""
