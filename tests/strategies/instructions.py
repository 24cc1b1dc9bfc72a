"""Instructions without inputs: a fixed choice of all, and copies and searches in each of their forms."""

from __future__ import annotations

from collections.abc import Sequence

from hypothesis import strategies as st

from strategies.arguments import Given, Shown, called, cell, given, oneshots, span
from strategies.conditions import weighted
from strategies.messages import messages
from strategies.programs import Act

PLAIN_ACTS = (
    Act("out(y[1])", "out(Y001)"),
    Act("out(y[1].immediate)", "out(immediate(Y001))"),
    Act("out(y[1:5].immediate)", "out(immediate(Y001..Y004))"),
    Act("out(c[5:9])", "out(C5..C8)"),
    Act("out(c[5], oneshot=True)", "out(C5,oneshot=1)"),
    Act("out(c[5:8], one_shot=True)", "out(C5..C7,oneshot=1)", 3),
    Act("out(sc[50])", "out(SC50)"),
    Act("set(c[1])", "latch(C1)"),
    Act("set(y[1:5].immediate)", "latch(immediate(Y001..Y004))"),
    Act("reset(y[101])", "reset(Y101)"),
    Act("reset(c[1:2001])", "reset(C1..C2000)"),
    Act("copy(1, ds[1])", "copy(1,DS1)", 2),
    Act('copy("AB", txt[1], oneshot=True)', 'copy("AB",TXT1,oneshot=1)', 2),
    Act('copy("a,\\"b", txt[1])', 'copy("a,""b",TXT1)', 2),
    Act("copy(ds[ds[1]], dd[ds[2]])", "copy(DS[DS1],DD[DS2])", 2),
    Act("copy(5, dh[1])", "copy(0005h,DH1)", 2),
    Act("copy_block(ds[1:5], ds[100])", "blockcopy(DS1..DS4,DS100..DS103)", 2),
    Act("copy_fill(0, df[20:30])", "fill(0,DF20..DF29)", 2),
    Act("copy_pack(c[1:17], dh[1])", "pack_bits(C1..C16,DH1)", 2),
    Act("copy_unpack(dd[1], c[101:133])", "unpack_to_bits(DD1,C101..C132)", 2),
    Act('search(">=", 5, ds[1], ds[9], ds[20], c[3])', "search(DS1..DS9 >= 5,result=DS20,found=C3)", 2),
    Act('calc("(ds[1] + 2) * 3", ds[3])', "math(( DS1 + 2 ) * 3,DS3,mode=decimal)"),
    Act('math_hex("dh[1] AND 0x00FF", dh[2], oneshot=True)', "math(DH1 AND 00FFh,DH2,mode=hex,oneshot=1)"),
    Act("call(other)", 'call("other")'),
)
OWN_ACTS = (
    Act("ton(t[{}], 5, Ts)", "on_delay(T{0},TD{0},preset=5,unit=Ts)", 2),
    Act("tof(t[{}], setpoint=ds[7])", "off_delay(T{0},TD{0},preset=DS7,unit=Tms)", 2),
)


# ---------------------------------------------------------------------------------------------------- copies

_NUMERIC = ("DS", "DD", "DH", "DF", "XD", "YD", "TD", "CTD", "SD")
_VALUES = ("DS", "DD", "DH", "DF", "YD", "TD", "CTD")
_POINTED = ("DS", "DD", "DH", "DF", "TD", "CTD", "TXT")
_BLOCK_VALUES = ("DS", "DD", "DH", "DF")
_DIGITS = {"DS": 5, "TD": 5, "SD": 5, "DD": 10, "CTD": 10, "DH": 4, "XD": 4, "YD": 4}
_CODES: tuple[Shown, ...] = (('"$0D"', "$0D"), ("13", "$0D"), ('"A"', "$41"), ("0", "$00"), ("127", "$7F"))


def _place(draw: st.DrawFn, bank: str) -> Shown:
    """An address, or sometimes a pointer."""
    if bank in _POINTED and draw(st.integers(0, 4)) == 0:
        number = draw(st.integers(1, 9))
        return f"{bank.lower()}[ds[{number}]]", f"{bank}[DS{number}]"
    return cell(bank, draw(st.integers(1, 8)))


def _text_settings(draw: st.DrawFn, bank: str, is_modifier: bool) -> Shown:
    """The settings of a number's text: in the source those given, in the token all three."""
    settings: list[str] = []
    suppress, exponential = "1", "0"
    kind = draw(st.sampled_from(("", "suppress", "zeros", "pad", "exponential")))
    if kind == "suppress":
        settings.append("suppress_zero=True")
    elif kind == "zeros":
        settings.append("suppress_zero=False")
        suppress = "0"
    elif kind == "pad" and is_modifier and bank in _DIGITS:
        settings.append(f"pad={_DIGITS[bank]}")
        suppress = "0"
    elif kind == "exponential" and bank == "DF":
        settings.append("exponential=True")
        exponential = "1"
    elif kind == "exponential":
        settings.append("exponential=False")
    code = "none"
    if draw(st.booleans()):
        text, code = draw(st.sampled_from((*_CODES, ("None", "none"))))
        settings.append(f"termination_code={text}")
    token = f"(suppress_zero={suppress},exponential={exponential},termination_code={code})"
    return ", ".join(draw(st.permutations(settings))), token


@st.composite
def converting_copies(draw: st.DrawFn) -> Act:
    """Copies that convert, with ``options=`` or with the equivalent modifier after the source."""
    name = draw(st.sampled_from(("value", "ascii", "binary", "text")))
    is_modifier = draw(st.booleans())
    to_text = name in ("binary", "text")
    word, token_word = "copy", "copy"
    settings: Shown = ("", "")
    if not to_text and draw(st.booleans()):
        word, token_word = "copy_block", "blockcopy"
        length, bank, first = draw(st.integers(1, 9)), draw(st.sampled_from(_BLOCK_VALUES)), draw(st.integers(1, 9))
        source = span("TXT", draw(st.integers(1, 9)), length)
        target = (cell(bank, first)[0], span(bank, first, length)[1])
    else:
        bank = draw(st.sampled_from(_NUMERIC if to_text else _VALUES))
        source, target = _place(draw, bank if to_text else "TXT"), _place(draw, "TXT" if to_text else bank)
        if name == "text":
            settings = _text_settings(draw, bank, is_modifier)
    given_oneshot, oneshot = oneshots(draw)
    option = f"to_{name}({settings[0]})" if settings[0] or (name == "text" and draw(st.booleans())) else f"to_{name}"
    text = f"{source[0]}.as_{name}({settings[0]})" if is_modifier else source[0]
    names = ("source", *(("source_range",) if word == "copy_block" else ()))
    more = ("destination_start",) if word == "copy_block" else ()
    arguments = [Given(names, text), given("destination", target[0], *more), given_oneshot]
    if not is_modifier:
        arguments.append(given("options", option))
    token = f"{token_word}({source[1]},{target[1]}{oneshot},convert=to_{name}{settings[1]})"
    return Act(called(draw, word, arguments), token, 2)


# ---------------------------------------------------------------------------------------------------- searches

_WORDS = {"==": "eq", "!=": "ne", "<": "lt", "<=": "le", ">": "gt", ">=": "ge"}
_MIRRORED = {"==": "==", "!=": "!=", "<": ">", "<=": ">=", ">": "<", ">=": "<="}
_SEARCHED: tuple[tuple[Sequence[str], Sequence[Shown]], ...] = (
    (("DS", "DD", "TD", "CTD", "SD"), (("5", "5"), ("-7", "-7"), ("32767", "32767"), ("ds[9]", "DS9"))),
    (("DH", "XD", "YD"), (("0x00FF", "00FFh"), ("5", "0005h"), ("dh[9]", "DH9"), ("yd[1]", "YD1"))),
    (("DF",), (("1.5", "1.5"), ("-0.25", "-0.25"), ("df[9]", "DF9"))),
    (("TXT",), (('"A"', '"A"'), ('"A,B"', '"A,B"'), ("txt[9]", "TXT9"))),
)


@st.composite
def searches(draw: st.DrawFn) -> Act:
    """A search by its arguments, or by a comparison with the range on either side."""
    banks, values = draw(st.sampled_from(_SEARCHED))
    bank, value = draw(st.sampled_from(banks)), draw(st.sampled_from(values))
    operator = draw(st.sampled_from(("==", "!=") if bank == "TXT" else tuple(_WORDS)))
    first, length = draw(st.integers(1, 4)), draw(st.integers(1, 5))
    text, token = span(bank, first, length)
    result, found = cell("DS", draw(st.sampled_from((20, 4500)))), cell("C", draw(st.sampled_from((3, 2000))))
    oneshot, oneshot_token = oneshots(draw)
    if draw(st.booleans()):
        where = f"{text} {operator} {value[0]}"
        if draw(st.booleans()):
            where = f"{value[0]} {_MIRRORED[operator]} {text}"
        arguments = [given("comparison", where)]
    else:
        start, end = cell(bank, first), cell(bank, first + length - 1)
        arguments = [given("condition", f'"{draw(st.sampled_from((operator, _WORDS[operator])))}"')]
        arguments += [given("value", value[0], "search_value"), given("start", start[0], "start_address")]
        arguments.append(given("end", end[0], "end_address"))
    arguments += [given("result", result[0], "result_address"), given("flag", found[0], "found", "result_flag")]
    is_continuous = draw(st.booleans())
    if arguments[0].names == ("comparison",):
        # A program would write no name for the comparison itself.
        head, tail = (
            f"search({arguments[0].text}, ",
            called(draw, "", [*arguments[1:], *_flags(is_continuous, oneshot)]),
        )
        call = head + tail[1:]
    else:
        call = called(draw, "search", [*arguments, *_flags(is_continuous, oneshot)])
    flags = (",continuous=1" if is_continuous else "") + oneshot_token
    return Act(call, f"search({token} {operator} {value[1]},result={result[1]},found={found[1]}{flags})", 2)


def _flags(is_continuous: bool, oneshot: Given) -> list[Given]:
    return [given("continuous", "True" if is_continuous else None), oneshot]


plain_acts: st.SearchStrategy[Act] = weighted(
    (4, st.sampled_from(PLAIN_ACTS)), (1, converting_copies()), (1, searches()), (1, messages())
)
