"""Ways out for code that people bring from other machines and languages, in their own words."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

import libcst as cst

from clickgen.device.banks import VALUE_BANK, Address, Bank, Kind, parse_address, points_of
from clickgen.device.elsewhere import BANKS as FOREIGN_BANKS
from clickgen.device.nicknames import nickname_fault
from clickgen.dialects.if_rungs.read.context import Context, Located
from clickgen.dialects.if_rungs.read.nodes import (
    ADDRESSES,
    Node,
    called,
    every,
    keyword_name,
    literal,
    name_of,
    terms,
    whole_number,
    word,
)
from clickgen.dialects.if_rungs.spelling import IfRungsSpelling
from clickgen.dialects.if_rungs.trade import ARGUMENTS, CONDITIONS, MEMBERS, Advice, advice, bank_hint
from clickgen.dialects.ways_out import reset_hint, with_reset
from clickgen.formula.spelling import SPELL
from clickgen.instructions.offered import CTU
from clickgen.ir.addresses import BANK_NAMES
from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.edits import Edit, Fix
from clickgen.text.source import SourceFile

Fits = Callable[[str], bool]
"""True for code that the language takes in this place."""

_OWN_MAX = 120
"""At most this much of a person's own code is repeated in a message."""

_HEX_WORD = re.compile(r"([A-Fa-f][0-9A-Fa-f]{0,7})[hH]")
_FLAT = re.compile(r"([A-Za-z]+?)([0-9]{1,4}[uU]?)")
"""A text that may be an address: ``"ds.A"``."""
_SURE_MEMBERS = frozenset(("done", "dn", "q", "acc", "accum", "accumulator", "et", "cv", "current"))
"""Members of a timer or counter with only one meaning."""


def expression_of(text: str) -> cst.BaseExpression | None:
    """A text as an expression; None if it is not one."""
    return Context(SourceFile("", text), Diagnostics()).expression()


def own(context: Context, node: Located) -> str:
    """A node as written, on one line; "" if a message cannot repeat it."""
    text = context.text(node)
    text = "" if "#" in text and "\n" in text else " ".join(text.split())
    return text if len(text) <= _OWN_MAX else ""


def own_advice(
    context: Context,
    found: Advice | None,
    arguments: Sequence[Node],
    fits: Fits,
    keywords: Sequence[cst.Arg] = (),
) -> str:
    """The way out for a word of the trade, with the person's own arguments if that gives correct code."""
    if found is None:
        return ""
    written = own_code(context, found, arguments, fits, keywords)
    return found.of(written) if written else found.shown


def own_code(
    context: Context,
    found: Advice,
    arguments: Sequence[Node],
    fits: Fits,
    keywords: Sequence[cst.Arg] = (),
) -> str:
    """The person's own arguments as the code is written here; "" if that gives nothing correct."""
    texts = [own(context, argument) for argument in arguments]
    if keywords:
        if "$*" not in found.own or not all(keyword.keyword for keyword in keywords):
            return ""
        names = [keyword_name(keyword) for keyword in keywords]
        given = [own(context, keyword.value) for keyword in keywords]
        texts += [f"{ARGUMENTS.get(name, name)}={text}" for name, text in zip(names, given, strict=True)]
    # An argument that is a calculation would need parentheses of its own in a formula.
    if '"' in found.own and not all(_is_operand(one, "math_hex" in found.own) for one in arguments):
        return ""
    written = found.written(texts, is_action=True) if all(texts) else ""
    actions = [piece.partition(": ")[2] if piece.startswith("if ") else piece for piece in written.split("\n")]
    return written if written and all(map(fits, actions)) else ""


def around_value(word: str, arguments: Sequence[Node]) -> Sequence[Node]:
    """Put the limits of LIM around its value, which other functions, such as ``between``, take first."""
    if len(arguments) != 3 or advice(word, CONDITIONS) != CONDITIONS["lim"]:
        return arguments
    registers = [argument for argument in arguments if isinstance(argument, cst.Attribute | cst.Subscript)]
    value = registers[0] if len(registers) == 1 else arguments[word.lower() == "lim"]
    low, high = [argument for argument in arguments if argument is not value]
    return low, value, high


def _is_operand(node: Node, is_hex: bool) -> bool:
    """True for a number or an address that a formula of this kind takes."""
    if isinstance(node, cst.Integer | cst.Float):
        return not is_hex
    holder = node.value if isinstance(node, cst.Attribute | cst.Subscript) else None
    bank = BANK_NAMES.get(name_of(holder))
    wanted = ("DH",) if is_hex else ("DS", "DD", "DF", "TD", "CTD", "SD")
    return bank is not None and bank.name in wanted


def trade_advice(
    context: Context,
    name: str,
    table: dict[str, Advice],
    arguments: Sequence[Node],
    fits: Fits,
    keywords: Sequence[cst.Arg] = (),
) -> str:
    """``own_advice`` for a word; "" for one that is not in the table."""
    return own_advice(context, advice(name, table), arguments, fits, keywords)


def replaced(context: Context, node: Located, text: str, is_safe: bool) -> Fix:
    """The fix that replaces a node by this text."""
    return Fix((Edit(context.span(node), text),), is_safe)


# -- addresses --------------------------------------------------------------------------------------------------------


def flat_address(text: str) -> str:
    """The language's form of what looks like one of CLICK's addresses: ``C1``, ``ds5``, ``X001``; "" for others."""
    address = parse_address(text) if len(text) < 10 else None
    return SPELL.cell(address) if address is not None else ""


def name_hint(name: str) -> str:
    """The way out for a bare word in place of an address; "" for a word that says nothing."""
    exact = flat_address(name)
    if exact:
        return f"write {exact}"
    word = _HEX_WORD.fullmatch(name)
    if word and (not word[1].isalpha() or word[1].isupper() or len(set(word[1])) == 1):
        return f"a hexadecimal number begins with 0x: 0x{int(word[1], 16):04X}"
    match = _FLAT.fullmatch(name)
    if match and match[1].lower() in BANK_NAMES:
        bank = BANK_NAMES[match[1].lower()]
        return f"{bank.name} has {bank.describe_range()}: write {bank.dsl}[{bank.first}]"
    if match and match[1].lower() in FOREIGN_BANKS:
        return bank_hint(match[1], match[2])
    return ""


def text_hint(value: str, bank: str = "c") -> str:
    """The way out for a text in quotes in place of an address, likely one of a bank."""
    exact = flat_address(value)
    if exact:
        return f"write {exact}, without quotes"
    inner = expression_of(value) if "." in value or "[" in value else None
    if inner is not None and bank_of(inner) is not None:
        return f"write {value.strip()}, without quotes"
    shown = f".{value}" if value.isidentifier() else f'["{value}"]'
    if nickname_fault(value) is not None or '"' in value:
        return "an address is written ds[5] or ds.Name, without quotes around it"
    return f"a nickname follows its bank, without quotes around it all: {bank}{shown}"


def bit_of_word(word: str, bank: Bank, index: int | None) -> str:
    """The way to look at a bit of a word, for ``ds[1][3]``."""
    bits = 32 if bank.kind in (Kind.INT32, Kind.FLOAT) else 16
    number = 3 if index is None or not 0 <= index < bits else index
    match = re.fullmatch(r"[xy]d\[(\d)\]", word)
    if match and bank.has(int(match[1])):
        point = points_of(Address(bank.name, int(match[1])))[number]
        return f"bit {number} of this word is {SPELL.cell(point)}"
    source, before = word, ""
    if bank.name not in ("DS", "DD", "DH", "DF"):
        if bank.kind is Kind.TEXT:
            return 'a character has no bits; compare it: txt[1] == "A"'
        wide = bits == 32
        source = "dd.Word" if wide else "dh.Word" if bank.kind is Kind.HEX else "ds.Word"
        before = f"copy({word}, {source}) and "
    target = f"c[1001:{1001 + bits}]"
    unpacked = f"{before}copy_unpack({source}, {target})"
    return f"copy the bits out in a rung before, {unpacked}, and bit {number} is c[{1001 + number}]"


def bank_of(node: Located) -> Bank | None:
    """The bank of an address, whether a name, a number or a range; None for anything else."""
    inner = node
    while isinstance(inner, cst.Attribute | cst.Subscript):
        inner = inner.value
    return None if inner is node else BANK_NAMES.get(name_of(inner))


def has_bits(node: Node) -> bool:
    """True for an expression with a bit in it, which no formula takes."""
    banks = (bank_of(part) for part in every(node) if part.__class__ in ADDRESSES)
    return any(bank is not None and bank.is_bit for bank in banks)


# -- conditions -------------------------------------------------------------------------------------------------------

_ALWAYS = frozenset(("true", "on", "always"))
_NEVER = frozenset(("false", "off", "never"))


def truth_of(node: Node) -> bool | None:
    """The meaning of a value for a bit: True, 1, on; None for anything else."""
    value = literal(node)
    if isinstance(value, int) and value in (0, 1):
        return bool(value)
    lower = value.lower() if isinstance(value, str) else name_of(node).lower()
    return True if lower in _ALWAYS else False if lower in _NEVER else None


def is_condition(node: Node) -> bool:
    """True for something that is on or off: a bit, a comparison, a function of conditions, a combination of them."""
    if isinstance(node, cst.Attribute | cst.Subscript):
        bank = bank_of(node)
        return bank is not None and bank.is_bit
    if isinstance(node, cst.Comparison):
        return True
    if isinstance(node, cst.Call):
        name = called(node)
        found = advice(name, CONDITIONS)
        return name in ("all", "any", "nc", "re", "fe") or (found is not None and bool(found.own))
    if isinstance(node, cst.BooleanOperation):
        return any(map(is_condition, terms(node)))
    if isinstance(node, cst.UnaryOperation):
        return isinstance(node.operator, cst.Not | cst.BitInvert) and is_condition(node.expression)
    if isinstance(node, cst.BinaryOperation):
        is_joined = isinstance(node.operator, cst.BitAnd | cst.BitOr | cst.BitXor | cst.Add | cst.Multiply)
        return is_joined and is_condition(node.left) and is_condition(node.right)
    return isinstance(node, cst.IfExp) and is_condition(node.body)


def number_of(node: Node | None) -> int | None:
    """A whole number with its sign; None for anything else."""
    if isinstance(node, cst.UnaryOperation) and isinstance(node.operator, cst.Minus):
        inner = number_of(node.expression)
        return None if inner is None else -inner
    return whole_number(node)


# -- members ----------------------------------------------------------------------------------------------------------


def member_hint(context: Context, node: cst.Attribute, bank: Bank, rest: str) -> tuple[str, Fix | None]:
    """The way out for ``t.A.done`` and the like; ``rest`` follows the bank: ``.A``."""
    base, kind = f"{bank.dsl}{rest}", MEMBERS.get(word(node.attr).lower(), "")
    value = VALUE_BANK.get(bank.name, "").lower()
    fix: Fix | None = None
    if not kind:
        return "", None
    if kind == "bit" or (kind == "current" and not value):
        text = base
    elif kind == "current":
        text = f"{value}{rest}"
    elif kind in ("timing", "expired") and bank.name == "T":
        return _while_timing(context, base, f"{value}{rest}", kind), None
    elif kind == "expired":
        text = base
    elif bank.is_bit and kind in ("off", "rising", "falling"):
        text = {"off": "nc", "rising": "re", "falling": "fe"}[kind] + f"({base})"
    elif kind == "immediate" and bank.name in ("X", "Y"):
        text = f"{base}.immediate"
    elif kind == "setpoint" and value:
        example = (
            f"ton({base}, setpoint=ds.Limit)"
            if bank.name == "T"
            else with_reset(IfRungsSpelling(), CTU, base, "ds.Limit")
        )
        return f"a setpoint is not read back: keep it in a register, {example}, and read that, ds.Limit", None
    elif kind == "enabled" and value:
        return "CLICK has no such bit: test what the rung of the instruction tests", None
    elif kind == "reset" and value:
        return reset_hint(IfRungsSpelling(), bank.name, base, timers_of(context, base)), None
    else:
        return "", None
    if value and word(node.attr).lower() in _SURE_MEMBERS:
        fix = replaced(context, node, text, is_safe=True)
    return f"write {text}", fix


def timers_of(context: Context, bit: str) -> frozenset[str]:
    """The instructions of this file that own a timer, as its text has them: ``ton``, ``tof``, ``rton``, ``rtof``."""
    pattern = rf"\b(r?to[nf])\s*\(\s*(?:timer\s*=\s*)?{re.escape(bit)}\s*[,)]"
    text = context.source.text
    return frozenset(
        found[1].lower()
        for found in re.finditer(pattern, text, re.IGNORECASE)
        if "#" not in text[text.rfind("\n", 0, found.start()) + 1 : found.start()]
    )


def _while_timing(context: Context, bit: str, current: str, kind: str) -> str:
    """The code for ``t.A.tt`` and ``t.A.expired``, which depends on the instruction that owns the timer.

    The bit of an off-delay is on while it counts and goes off at its end (click-facts [timer.off-delay]).
    """
    running = {"ton": f"all({current} > 0, nc({bit}))", "tof": f"all({current} > 0, {bit})"}
    kept = "a retentive timer keeps its value while its rung is off, so add the condition of that rung"
    running["rton"] = f"{running['ton']}; {kept}"
    ended = {"ton": bit, "rton": bit, "tof": f"nc({bit})"}
    table = running if kind == "timing" else ended
    owners = {owner.replace("rtof", "tof") for owner in timers_of(context, bit)}
    if len(owners) == 1:
        return f"write {table[owners.pop()]}"
    return f"of an on-delay (ton) write {table['ton']}, of an off-delay (tof) {table['tof']}"
