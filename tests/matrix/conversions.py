"""The conversions of copy and block copy: to_value, to_ascii, to_binary, to_text (click-facts [copy.convert])."""

from __future__ import annotations

from collections.abc import Iterator

from matrix.copies import BLOCK, BLOCK_DESTINATION, BLOCK_SOURCE, DESTINATION, SOURCE
from matrix.notation import (
    READ,
    WRITTEN,
    Cell,
    Matrices,
    action,
    cells,
    code,
    hexadecimal,
    integer,
    pairs,
    pointers,
    ranges,
    real,
    span,
    table,
    text,
)

_TO_NUMBER = table("TXT -> DS DD DH DF YD TD CTD SD")
_TO_TEXT = table("DS DD DH DF XD YD TD CTD SD -> TXT")
_LEGAL = {"to_value": _TO_NUMBER, "to_ascii": _TO_NUMBER, "to_binary": _TO_TEXT, "to_text": _TO_TEXT}
_PLAIN_TEXT = "to_text(suppress_zero=1,exponential=0,termination_code=none)"

_BLOCK_OPTIONS = ("to_value", "to_ascii")
"""The conversions that a block copy has."""


def _token(option: str) -> str:
    return _PLAIN_TEXT if option == "to_text" else option


def _copies(option: str) -> Iterator[Cell]:
    """Among the copy's operands, the option converts its own pairs; a constant is not converted."""
    constants = (integer(5), hexadecimal(0x00FF), real("2.0"), text("5"), code(0x0D))
    sources, targets = [*cells(READ), *pointers(8), *constants], [*cells(WRITTEN), *pointers()]
    for source, target, codes in pairs(_LEGAL[option], (SOURCE, DESTINATION), sources, targets):
        yield action(
            f"copy({source.source}, {target.source}, options={option})",
            f"copy({source.token},{target.token},convert={_token(option)})",
            codes=codes.replace("CG305", "CG314"),
        )


def _modifiers(option: str) -> Iterator[Cell]:
    """The same with the modifier of the other dialect after the source."""
    modifier = option.replace("to_", "as_")
    for source, target, codes in pairs(_LEGAL[option], (SOURCE, DESTINATION), cells(READ), cells(WRITTEN)):
        yield action(
            f"copy({source.source}.{modifier}(), {target.source})",
            f"copy({source.token},{target.token},convert={_token(option)})",
            codes=codes.replace("CG305", "CG314"),
        )


def _blocks(option: str) -> Iterator[Cell]:
    """The option of another pair is its fault; if it fits, the block copy has fewer pairs than the copy."""
    legal = BLOCK if option in _BLOCK_OPTIONS else {}
    targets = [*cells(WRITTEN), *ranges(WRITTEN)]
    for source, target, codes in pairs(legal, (BLOCK_SOURCE, BLOCK_DESTINATION), ranges(READ), targets):
        is_fitting = option in _BLOCK_OPTIONS and (source.bank, target.bank) in _LEGAL[option]
        fault = codes if is_fitting or codes not in ("", "CG305") else "CG314"
        whole = span(target.bank, WRITTEN[target.bank], 2)
        yield action(
            f"copy_block({source.source}, {target.source}, options={option})",
            f"blockcopy({source.token},{whole.token},convert={option})",
            codes=fault,
        )


_NUMBERS = ("DS", "DD", "DH", "DF", "XD", "YD", "TD", "CTD", "SD")
_ENDS = {"None": "none", '"$0D"': "$0D", '"$13"': "$13", "13": "$0D", '"A"': "$41", "0": "$00", "127": "$7F"}
_DIGITS = {"DS": 5, "TD": 5, "SD": 5, "DD": 10, "CTD": 10, "DH": 4, "XD": 4, "YD": 4}
"""The digits of a number whose zeros are not suppressed (click-facts [value.number-text])."""


def _settings() -> Iterator[Cell]:
    """Exponential text is for floating-point numbers, and never with leading zeros (click-facts [copy.exponential])."""
    for bank in _NUMBERS:
        for is_suppressed in (True, False):
            for is_exponential in (True, False):
                for end, end_token in _ENDS.items():
                    source = f"suppress_zero={is_suppressed}, exponential={is_exponential}, termination_code={end}"
                    token = f"suppress_zero={is_suppressed:d},exponential={is_exponential:d}"
                    is_legal = not is_exponential or (bank == "DF" and is_suppressed)
                    yield action(
                        f"copy({bank.lower()}[1], txt[5], options=to_text({source}))",
                        f"copy({bank}1,TXT5,convert=to_text({token},termination_code={end_token}))",
                        codes="" if is_legal else "CG314",
                    )


def _pads() -> Iterator[Cell]:
    """Padding is possible to all digits of the type."""
    for bank in _NUMBERS:
        for pad in (1, 4, 5, 6, 10, 11):
            yield action(
                f"copy({bank.lower()}[1].as_text(pad={pad}), txt[5])",
                f"copy({bank}1,TXT5,convert=to_text(suppress_zero=0,exponential=0,termination_code=none))",
                codes="" if pad == _DIGITS.get(bank) else "CG314",
            )


_SPELLINGS = [
    *(
        action(f"copy(ds[1], txt[5], options={option})", f"copy(DS1,TXT5,convert={_PLAIN_TEXT})")
        for option in ("to_text", "to_text()", '"to_text"')
    ),
    action("copy(ds[1], txt[5], options=None)", "copy(DS1,TXT5)"),
    action("copy(ds[1], txt[5], True, to_binary)", "copy(DS1,TXT5,oneshot=1,convert=to_binary)"),
    action("copy(ds[1], txt[5], options=to_text, oneshot=True)", f"copy(DS1,TXT5,oneshot=1,convert={_PLAIN_TEXT})"),
    action(
        "copy_block(txt[1:5], ds[11], oneshot=True, options=to_ascii)",
        "blockcopy(TXT1..TXT4,DS11..DS14,oneshot=1,convert=to_ascii)",
    ),
    *(
        action(f"copy(df[1], txt[5], options=to_text({setting}))", codes="CG115")
        for setting in ("suppress_zero=1", "exponential=0", 'termination_code="$80"', "termination_code=128")
    ),
    *(
        action(f"copy(df[1], txt[5], options=to_text(termination_code={value}))", codes="CG115")
        for value in ('"AB"', '""', "-1", "1.5", "True", '"\N{DEGREE SIGN}"', "ds[1]")
    ),
    *(
        action(f"copy(df[1], txt[5], options={option})", codes="CG109")
        for option in ("to_text(True)", "to_text(pad=5)", "to_text(suppress=True)", "to_binary(suppress_zero=True)")
    ),
    *(
        action(f"copy_fill({value}, {target}[5:7], options={option})", codes="CG314")
        for value, target, option in (
            ("txt[1]", "ds", "to_value"),
            ("txt[1]", "txt", "to_ascii"),
            ("ds[1]", "ds", "to_binary"),
            ("5", "ds", "to_text"),
        )
    ),
]

MATRICES: Matrices = {
    **{f"copy {option}": list(_copies(option)) for option in _LEGAL},
    **{f"copy {option} as a modifier": list(_modifiers(option)) for option in _LEGAL},
    **{f"copy_block {option}": list(_blocks(option)) for option in _LEGAL},
    "to_text settings": list(_settings()),
    "to_text pad": list(_pads()),
    "options spelt": _SPELLINGS,
}
