"""Tokens to actions and back, by the templates that write them; a token without a word is kept unchanged."""

from __future__ import annotations

import pytest
from judges.power import read_ladder
from test_importing_cases import CASE_NAMES, golden_ladders

from clickgen.click.draw.tokens import (
    action_token,
    compare_token,
    contact_token,
    formula_text,
    operand_token,
    pin_token,
)
from clickgen.click.read.calls import call_of, split
from clickgen.click.read.formulas import formula_of
from clickgen.click.read.kept import raw_of
from clickgen.click.read.operands import condition_of, operand_of
from clickgen.click.read.tokens import action_of, height_of, pin_row_of
from clickgen.instructions import FAMILIES
from clickgen.instructions.raw import RAW
from clickgen.ir.conditions import Always, Compare, Contact
from clickgen.ir.program import Action
from clickgen.text.source import Span

HERE = Span("main.csv", 1, 1, 1, 2)


def action(token: str, *pins: str) -> Action | None:
    return action_of(token, dict.fromkeys(pins, Always(HERE)), HERE)


@pytest.mark.parametrize("name", CASE_NAMES)
def test_every_golden_token_comes_back(name: str) -> None:
    for text in golden_ladders(name).values():
        for rung in read_ladder(text):
            for output in rung.outputs():
                found = action(output.token, *(pin.token for pin in output.pins))
                if found is None and name == RAW.name:
                    found = raw_of(output.token, HERE)
                assert found is not None, output.token
                assert raw_of(output.token, HERE) is None or found.spec is RAW
                assert action_token(found) == output.token
                shown = [pin_token(found, param) for param in found.spec.pins if param.name in found.args]
                assert shown == [pin.token for pin in output.pins]


def test_every_instruction_has_a_golden_token() -> None:
    """Except rtof, which CLICK does not have, and tokens without a word."""
    files = [text for name in CASE_NAMES for text in golden_ladders(name).values()]
    outputs = [output for text in files for rung in read_ladder(text) for output in rung.outputs()]
    found = {one.spec.name for output in outputs if (one := action(output.token, *(pin.token for pin in output.pins)))}
    assert {spec.name for family in FAMILIES for spec in family.SPECS} - found == {"rtof", "raw", "not_imported"}


SPELLINGS = {
    "out( C1 , oneshot = 1 )": "out(C1,oneshot=1)",
    "out(C1,oneshot=0)": "out(C1)",
    "for(3,oneshot=0)": "for(3)",
    "out(Y001.immediate)": "out(immediate(Y001))",
    "out(Y1)": "out(Y001)",
    "copy(DS1,TXT1,convert=to_text(suppress_zero=1,exponential=0,termination_code=$7))": (
        "copy(DS1,TXT1,convert=to_text(suppress_zero=1,exponential=0,termination_code=$07))"
    ),
    "copy(DS1,TXT1,convert=to_text(suppress_zero=0),oneshot=1)": (
        "copy(DS1,TXT1,oneshot=1,convert=to_text(suppress_zero=0,exponential=0,termination_code=none))"
    ),
    "pack_words(X001..X016,DH1)": "pack_bits(X001..X016,DH1)",
    "search(DS1..DS9==5,result=DS20,found=C1)": "search(DS1..DS9 == 5,result=DS20,found=C1)",
    "blockcopy(DS1,DS11)": "blockcopy(DS1..DS1,DS11..DS11)",
    "math(DS1+DS2*( 3 ),DS3,mode=decimal)": "math(DS1 + DS2 * ( 3 ),DS3,mode=decimal)",
}


@pytest.mark.parametrize("token", SPELLINGS)
def test_other_spellings_mean_the_same(token: str) -> None:
    found = action(token)
    assert found is not None
    assert action_token(found) == SPELLINGS[token]


@pytest.mark.parametrize(
    "token",
    [
        "",
        "out",
        "out(",
        "out(C1))",
        "out()",
        "out(C2001)",
        "out(C1,C2)",
        "out(C1,twice=1)",
        "out(C1,oneshot=1,oneshot=1)",
        "out(oneshot=1,C1)",
        'copy("ABC,TXT1)',
        "on_delay(T1,TD2,preset=5,unit=Ts)",
        "on_delay(T1,TD1,preset=5,unit=Tx)",
        "blockcopy(DS1..DS5,DS11..DS14)",
        "blockcopy(Y001..Y020,C1..C20)",
        "copy(DS1,TXT1,convert=to_french)",
        "copy(DS1,TXT1,convert=to_text(1))",
        "copy(DS1,TXT1,convert=to_text(suppress_zero=2))",
        "copy(DS1,TXT1,convert=to_text(termination_code=$80))",
        "copy(DS1,TXT1,convert=to_text(other=1))",
        "blockcopy(XD0u,DS1)",
        "math(DS1 + DS2,DS3,mode=octal)",
        "math(SUM ( DS5 : DD9 ),DS3,mode=decimal)",
    ],
)
def test_what_is_no_instruction_is_none(token: str) -> None:
    assert action(token) is None


@pytest.mark.parametrize(
    ("outputs", "pattern", "is_known"),
    [("C1", "[1]", True), ("", "[1]", False), ("C1", "[2]", False), ("C1", "1", False), ("C1", "[]", False)],
)
def test_a_drum_has_outputs_and_rows_of_bits(outputs: str, pattern: str, is_known: bool) -> None:
    token = f"event_drum(outputs=[{outputs}],events=[C2],pattern=[{pattern}],current_step=DS1,completion_flag=C3)"
    assert (action(token, ".reset()") is not None) is is_known


TCP = 'ModbusTcpTarget(name="a",ip="10.0.0.5",port=502,device_id=1)'


@pytest.mark.parametrize(
    ("target", "start", "is_known"),
    [
        (TCP, '"DS1"', True),
        (TCP.replace("port=502,", ""), '"DS1"', False),
        (TCP.replace('"a"', "a"), '"DS1"', False),
        ('ModbusRtuTarget(name="a",com_port="cpu2",device_id=1)', '"DS1"', True),
        ('ModbusRtuTarget(name="a",com_port="cpu9",device_id=1)', '"DS1"', False),
        (TCP, '"DS0"', False),
        (TCP, "DS1", False),
        (TCP, "ModbusAddress(address=400001)", True),
        (TCP, "ModbusAddress(address=400001,other=1)", False),
    ],
)
def test_a_message_has_a_device_and_an_address_in_it(target: str, start: str, is_known: bool) -> None:
    flags = "receiving=C1,success=C2,error=C3,exception_response=DS100"
    found = action(f"receive(target={target},remote_start={start},dest=DS1..DS5,{flags})")
    assert (found is not None) is is_known


@pytest.mark.parametrize(
    ("token", "pins"),
    [
        ("on_delay(T1,TD1,preset=5,unit=Ts)", [".clock()"]),
        ("off_delay(T1,TD1,preset=5,unit=Ts)", [".reset()"]),
        ("count_up(CT1,CTD1,preset=5)", [".down()"]),
        ("shift(C1..C8)", [".clock()"]),
        ("NOP", [".reset()"]),
    ],
)
def test_other_inputs_are_no_instruction(token: str, pins: list[str]) -> None:
    assert action(token, *pins) is None


FORMULAS = [
    "SUM ( DS1 : DS10 ) + DS100 * 2",
    "( DS8 * 10 ) + 3991 + 8",
    "SQRT ( DF1 ) ^ 2 + PI",
    "DS601 MOD 2",
    "0 - DS1",
    "0.50 + DF1",
]


@pytest.mark.parametrize("text", FORMULAS)
def test_a_formula_comes_back(text: str) -> None:
    found = formula_of(text, "decimal", HERE)
    assert found is not None
    assert formula_text(found) == text


@pytest.mark.parametrize("text", ["LSH ( DH1 , 2h )", "DH1 AND 00FFh", "DH1 XOR FFFFh", "SUM ( DH1 : DH4 ) + Ah"])
def test_a_hexadecimal_formula_comes_back(text: str) -> None:
    found = formula_of(text, "hex", HERE)
    # A number that begins with a letter is shown with all its digits.
    assert (formula_text(found) if found else "") == ("" if text.endswith("Ah") else text)


@pytest.mark.parametrize("text", ["", "DS1 +", "DS1 MOD DS2 * DS3", "-1", "DS9999", "DS1 ; 2", "DS[DS1] + 1"])
def test_a_formula_that_would_change_is_none(text: str) -> None:
    assert formula_of(text, "decimal", HERE) is None


@pytest.mark.parametrize(
    "token",
    [
        "raw(Odd,0x2799,1,222d=0,609b=1,3218=9744,0000=)",
        "math(DS1 MOD DS2 * DS3,DS4,mode=decimal)",
    ],
)
def test_what_has_no_word_is_kept_as_it_is(token: str) -> None:
    assert action(token) is None
    kept = raw_of(token, HERE)
    assert kept is not None
    assert action_token(kept) == token


@pytest.mark.parametrize("token", ["dance(C1)", "out(", "shift(C1..C8)", "raw(Velocity", 'copy("$0D",TXT1)'])
def test_what_laddercodec_would_refuse_is_not_kept(token: str) -> None:
    assert raw_of(token, HERE) is None


def test_boxes_have_their_heights_and_inputs() -> None:
    assert [height_of(token) for token in ("out(C1)", "copy(DS1,DS2)", "count_up(CT1)", "event_drum()", "what")] == [
        1,
        2,
        3,
        4,
        1,
    ]
    assert height_of("raw(Odd,0x2799,3,aa=1)") == 3
    assert [pin_row_of("count_up(CT1)", pin) for pin in (".down()", ".reset()", ".jog()")] == [1, 2, 0]


@pytest.mark.parametrize(
    "text", ["X001", "~C2000", "immediate(X001)", "~immediate(X816)", "rise(SC5)", "fall(T1)", "DS1==5", '"A"==TXT1']
)
def test_a_contact_comes_back(text: str) -> None:
    found = condition_of(text, HERE)
    assert isinstance(found, Contact | Compare)
    assert (contact_token(found) if isinstance(found, Contact) else compare_token(found)) == text


@pytest.mark.parametrize(
    "text", ["X017", "DS1", "~", "immediate(C1)", "rise(~C1)", "rise(DS1)", "DS1==", "DS1=5", "C1..C8", "+", "-!"]
)
def test_what_is_no_contact_is_none(text: str) -> None:
    assert condition_of(text, HERE) is None


@pytest.mark.parametrize(
    "text",
    [
        "DS5",
        "XD0u",
        "C1..C8",
        "C8..C1",
        "DS[DS1]",
        "immediate(Y001..Y004)",
        "-5",
        "00FFh",
        "1.5",
        '"say ""go"""',
        "$0D",
    ],
)
def test_an_operand_comes_back(text: str) -> None:
    found = operand_of(text, HERE)
    assert found is not None
    assert operand_token(found) == text


@pytest.mark.parametrize(
    "text", ["", "DS0", "X016..X021", "C1..DS8", "DS[DD1]", "X[DS1]", "1F", "123456789h", "$1", '"']
)
def test_what_is_no_operand_is_none(text: str) -> None:
    assert operand_of(text, HERE) is None


def test_a_call_is_taken_apart() -> None:
    call = call_of('send(a(1,2),"x,""y",key=[1,[2]],other=)')
    assert call is not None
    assert (call.name, call.arguments, call.keywords) == (
        "send",
        ("a(1,2)", '"x,""y"'),
        {"key": "[1,[2]]", "other": ""},
    )
    assert split("a,(b") is None
    assert split('a,"b') is None


@pytest.mark.parametrize("text", ["9" * 5000, "\u0661\u0662", "DS\u0661", "1e9999", "X" * 5000 + "1"])
def test_numbers_that_are_none_are_refused(text: str) -> None:
    """Digits of other scripts, and more digits than any number has, are damage and no reason to end."""
    assert operand_of(text, HERE) is None
    assert condition_of(f"DS1=={text}", HERE) is None


@pytest.mark.parametrize("number", ["²", "\u0661", "9" * 5000])
@pytest.mark.parametrize("place", ["port=502", "device_id=1"])
def test_numbers_of_targets_that_are_none_are_refused(place: str, number: str) -> None:
    target = 'ModbusTcpTarget(name="tcp",ip="192.168.1.10",port=502,device_id=1)'.replace(
        place, f"{place.partition('=')[0]}={number}"
    )
    token = f'receive(target={target},remote_start="DS1",dest=DS1..DS5,receiving=C1,success=C2,error=C3)'
    assert action_of(token, {}, HERE) is None
