"""Instructions that are kept as their ladder tokens: which these are, and that laddercodec leaves them unchanged."""

from __future__ import annotations

import re
import struct
import unicodedata
from functools import lru_cache
from typing import NamedTuple

from clickgen.click.draw.grid import COLUMNS, MAX_ROWS
from clickgen.click.draw.tokens import action_token
from clickgen.click.read.calls import call_of
from clickgen.click.read.operands import embedded, operand_of
from clickgen.click.read.tokens import action_of, specs_of
from clickgen.device.system import WRITABLE_SD
from clickgen.dialects.base import Spelling
from clickgen.instructions.offered import KEPT
from clickgen.instructions.raw import WORD, rows_of
from clickgen.instructions.spec import ParamKind, Spec
from clickgen.ir.kept import kept_token
from clickgen.ir.made import NOP_TOKEN, kept, nothing
from clickgen.ir.operands import Cell
from clickgen.ir.program import Action
from clickgen.text.source import Span

_FORMULA = "math"
_FIELDS = re.compile(r"raw\([A-Za-z]\w*,0x[0-9a-f]{4,8},[1-9]\d{0,2}(?:,.*)?\)")
"""``raw(Email,0x2737,1,60a5=1)``. The older form, a number of many digits, would hide the addresses in it."""
_LONG_RUN = re.compile(r"\[\d{4,}\]=")
"""No instruction has this many empty fields (the most that are known: 250)."""
_LENGTH_MAX = 16_384
"""Far more than any instruction has. laddercodec's work on a formula grows with the square of its blanks."""
_UNPRINTED = ("Cc", "Cs", "Zl", "Zp")
_NOWHERE = Span("", 1, 1, 1, 2)


class Fault(NamedTuple):
    """The reason why a token cannot be kept, and the way out."""

    message: str
    help: str
    instead: tuple[Spec, ...] = ()
    """The instructions that the language has for it: how they are written completes the help."""
    is_example: bool = False
    """True where they are only an example."""

    def way_out(self, spell: Spelling) -> str:
        """The help, with instructions as a dialect writes them."""
        write = spell.example if self.is_example else spell.signature
        words = " or ".join(map(write, self.instead))
        return f"{self.help} {words}" if words else self.help


def raw_of(token: str, span: Span) -> Action | None:
    """Return an instruction to keep unchanged; None if its token cannot be kept."""
    if fault_of(token) is not None:
        return None
    return kept(kept_token(embedded(token, span), span))


@lru_cache(maxsize=4096)
def fault_of(token: str) -> Fault | None:
    """The reason why a token cannot be kept; None for one that can.

    Tokens are kept if the language has no word for them: ``raw(...)``, and formulas that clickgen would print
    otherwise.
    """
    if len(token) > _LENGTH_MAX:
        return Fault(f"it has {len(token)} characters, and no instruction has so many", "draw the rung again in CLICK")
    if any(unicodedata.category(character) in _UNPRINTED for character in token):
        return Fault("it holds a line break or a control character", "copy it once more out of the ladder file")
    name = token.partition("(")[0]
    if name == _FORMULA:
        return _fault_of_formula(token) or _fault_in_codec(token)
    words = _words(token)
    if words:
        return Fault("the language has a word for it", "write", words)
    if name != WORD:
        return Fault(f"it is no {WORD}(...) and no {_FORMULA}(...)", "for example:", (KEPT,), True)
    if not _FIELDS.fullmatch(token) or _LONG_RUN.search(token):
        return Fault("laddercodec does not write such a token", "for example:", (KEPT,), True)
    if rows_of(token) > MAX_ROWS:
        return Fault(f"it is {rows_of(token)} rows tall, and a rung has {MAX_ROWS}", "correct its third part")
    return _fault_in_codec(token)


def _words(token: str) -> tuple[Spec, ...]:
    """The instructions of the language with the name of this token."""
    if token == NOP_TOKEN:
        return (nothing(_NOWHERE).spec,)
    return tuple(spec for spec in specs_of(token) if spec.built_from is None)


def _formulas() -> dict[str, Spec]:
    """The instructions that a formula is kept from, by the mode that its token names."""
    return {
        "hex" if param.is_hex else "decimal": spec
        for spec in specs_of(_FORMULA)
        for param in spec.params
        if param.kind is ParamKind.FORMULA
    }


def _fault_of_formula(token: str) -> Fault | None:
    """A formula can be kept if it goes to a writable register and clickgen would print it otherwise."""
    call = call_of(token)
    spec = _formulas().get(call.keywords.get("mode", "")) if call else None
    if call is None or spec is None or len(call.arguments) != 2 or not call.keywords.keys() <= {"mode", "oneshot"}:
        return Fault(f"it is no {_FORMULA}(formula,destination,mode=decimal) or mode=hex", "write", _words(token))
    destination = operand_of(call.arguments[1], _NOWHERE)
    banks = next(param.slot.cells for param in spec.params if param.name == "destination")
    is_written = isinstance(destination, Cell) and destination.bank in banks and _is_writable(destination)
    if not is_written:
        return Fault(f"{spec.name} does not write {call.arguments[1]}", "write", (spec,))
    action = action_of(token, {}, _NOWHERE)
    if action is not None and action_token(action) == token:
        return Fault("the language has a word for it", "write", (spec,))
    return None


def _is_writable(destination: Cell) -> bool:
    return destination.bank != "SD" or destination.address.number in WRITABLE_SD


# -- laddercodec ------------------------------------------------------------------------------------------------------


def _fault_in_codec(token: str) -> Fault | None:
    """Pass the token through laddercodec as a ladder file does, into the binary form and back."""
    try:
        written = _written_back(token)
    except (ValueError, TypeError, KeyError, IndexError, AttributeError, OverflowError, struct.error) as error:
        return Fault(f"laddercodec does not read it: {error}", "copy it once more out of the ladder file")
    if written == token:
        return None
    if written.partition("(")[0] in (WORD, _FORMULA):
        return Fault("laddercodec would write it otherwise", f"write {written}")
    return Fault("the language has a word for it", "write", _words(written))


def _written_back(token: str) -> str:
    """The token after the round trip; of two forms, the one that differs."""
    from laddercodec import Rung, decode, encode
    from laddercodec.csv.converter import af_node_to_token
    from laddercodec.csv.token_parser import parse_af_token
    from laddercodec.csv.writer import decoded_rung_to_rows

    instruction = af_node_to_token(parse_af_token(token))
    read = instruction if isinstance(instruction, str) else instruction.to_csv()
    if read != token:
        return str(read)
    below = rows_of(token) - 1
    rung = Rung(
        logical_rows=below + 1,
        conditions=[["-"] * COLUMNS, *([""] * COLUMNS for _ in range(below))],
        instructions=[instruction, *[""] * below],
        comment=None,
    )
    decoded = decode(encode(rung))
    assert isinstance(decoded, Rung)
    return str(decoded_rung_to_rows(decoded)[0][-1])
