"""Copy, block copy and fill (click-facts [copy.block, copy.fill, copy.single])."""

from __future__ import annotations

from collections.abc import Iterator

from matrix.notation import (
    BITS,
    CONSTANTS,
    POINTED,
    READ,
    REGISTERS,
    WRITABLE_SD,
    WRITTEN,
    Cell,
    Matrices,
    Operand,
    Takes,
    action,
    addresses,
    cell,
    cells,
    code,
    hex_text,
    hexadecimal,
    immediates,
    integer,
    pairs,
    pointer,
    pointers,
    ranges,
    real,
    span,
    table,
    text,
)

EVERY_BANK = f"{BITS} {REGISTERS}"
EVERY_FORM = "integer hex real text code"
_WHOLE = ["DS", "DD", "TD", "CTD", "SD"]
_WORDS = ["DH", "XD", "YD"]


def _typed(source: Operand, target: Operand) -> tuple[str, str]:
    """A constant as its destination takes it, and the code if it does not: no fraction into a whole number."""
    token = source.word if target.bank in _WORDS else source.token
    if source.form == "hex" and target.bank in (*_WHOLE, "DF"):
        token = str(int(source.word[:-1], 16))
    if source.form == "real" and target.bank in (*_WHOLE, *_WORDS):
        if not float(source.source).is_integer():
            return "", "CG302"
        whole = integer(int(float(source.source)))
        token = whole.word if target.bank in _WORDS else whole.token
    return token, ""


# -- copy -------------------------------------------------------------------------------------------------------------

# click-facts [copy.bit-constant, copy.single]; a text is a constant for TXT only.
_SINGLE = table("""
    X Y C T CT SC                                       -> Y C
    DS DD DH DF XD YD TD CTD SD TXT integer hex real    -> DS DD DH DF YD TD CTD SD TXT
    text code                                           -> TXT
    """)
SOURCE = Takes(cells=EVERY_BANK, pointers=POINTED, constants=EVERY_FORM)
DESTINATION = Takes(cells=EVERY_BANK, pointers=POINTED, is_written=True)


def _copies() -> Iterator[Cell]:
    sources, targets = [*cells(READ), *pointers(8)], [*cells(WRITTEN), *pointers()]
    for source, target, codes in pairs(_SINGLE, (SOURCE, DESTINATION), sources, targets):
        yield action(f"copy({source.source}, {target.source})", f"copy({source.token},{target.token})", codes=codes)
    yield action('copy(xd["0u"], yd["0u"])', "copy(XD0u,YD0u)")
    yield action('copy(5, xd["0u"])', codes="CG304")
    for word in ("oneshot", "one_shot"):
        yield action(f"copy(ds[1], ds[5], {word}=True)", "copy(DS1,DS5,oneshot=1)")


def _copied_constants() -> Iterator[Cell]:
    constants, targets = [*CONSTANTS, real("2.0"), hex_text(0x00FF)], [*cells(WRITTEN), *pointers()]
    for source, target, codes in pairs(_SINGLE, (SOURCE, DESTINATION), constants, targets):
        token, fault = _typed(source, target)
        if "CG213" in codes:
            fault = ""
        if source == hex_text(0x00FF) and target.bank == "TXT":
            token = '"00FFh"'
        yield action(
            f"copy({source.source}, {target.source})", f"copy({token},{target.token})", codes=f"{codes} {fault}"
        )


def _copied_forms() -> Iterator[Cell]:
    for operand in (*ranges(READ), *immediates(READ)):
        yield action(f"copy({operand.source}, ds[5])", codes=SOURCE.fault(operand))
    for operand in (*ranges(WRITTEN), *immediates(WRITTEN), *CONSTANTS):
        yield action(f"copy(ds[1], {operand.source})", codes=DESTINATION.fault(operand))


_INT16, _INT32, _WORD = (-(2**15), 2**15 - 1), (-(2**31), 2**31 - 1), (0, 2**16 - 1)
_LIMITS = {"DS": _INT16, "TD": _INT16, "SD": _INT16, "DD": _INT32, "CTD": _INT32, "DH": _WORD, "YD": _WORD}
_TEXTS = ("ABC", 'say "hi"', "a,b", "a=b", "f(x)", "a..b", "a;b", "a;b,c=(d)", " ", "  ", "5", "00FFh", "'")


def _copied(source: Operand, target: Operand, codes: str = "") -> Cell:
    token, _ = _typed(source, target)
    return action(f"copy({source.source}, {target.source})", f"copy({token},{target.token})", codes=codes)


def _copied_limits() -> Iterator[Cell]:
    for bank, (low, high) in _LIMITS.items():
        targets = [cell(bank, WRITTEN[bank]), *([] if bank == "SD" else [pointer(bank, 9)])]
        for target in targets:
            yield from (_copied(integer(value), target) for value in (low, 0, high))
            yield from (_copied(integer(value), target, "CG302") for value in (low - 1, high + 1))
    yield _copied(hexadecimal(0xFFFF), cell("DH", 5))
    yield from (_copied(hexadecimal(0x10000), cell(bank, 5), "CG302") for bank in ("DH", "YD"))
    for written, token in (("-1.5", "-1.5"), (".5", "0.5"), ("1.", "1.0"), ("1e3", "1000.0"), ("-2.5e-3", "-0.0025")):
        yield action(f"copy({written}, df[5])", f"copy({token},DF5)")
    yield from (_copied(real(value), cell("DF", 5), "CG302") for value in ("3.5e38", "-3.5e38", "1e-39"))
    yield from (_copied(text(value), cell("TXT", 5)) for value in _TEXTS)
    yield action('copy("a\\\\b", txt[5])', 'copy("a\\b",TXT5)')
    yield from (_copied(text(value), cell("TXT", 5), "CG302") for value in ("", "\N{DEGREE SIGN}", "\\n"))
    yield from (_copied(code(value), cell("TXT", 5)) for value in (0x00, 0x0D, 0x7F))
    yield from (_copied(code(value), cell("TXT", 5), "CG302") for value in (0x80, 0xFF))
    yield _copied(text("ABC"), cell("TXT", 998))
    yield _copied(text("ABC"), cell("TXT", 999), "CG306")


_SYSTEM = [
    action(f"copy(5, sd[{number}])", f"copy(5,SD{number})", codes="" if number in WRITABLE_SD else "CG304")
    for number in range(1, 1001)
]

# -- block copy -------------------------------------------------------------------------------------------------------

# There is no evidence for TXT to TXT.
BLOCK = table("""
    X Y C T CT SC       -> Y C
    DS DD DH DF SD      -> DS DD DH DF YD TD CTD
    TXT                 -> DS DD DH DF
    """)
BLOCK_SOURCE = Takes(ranges=EVERY_BANK)
BLOCK_DESTINATION = Takes(cells=EVERY_BANK, ranges=EVERY_BANK, is_written=True)


def _blocks() -> Iterator[Cell]:
    """The destination is its first address or the whole range; CLICK gets the range."""
    targets = [*cells(WRITTEN), *ranges(WRITTEN)]
    for source, target, codes in pairs(BLOCK, (BLOCK_SOURCE, BLOCK_DESTINATION), ranges(READ), targets):
        whole = span(target.bank, WRITTEN[target.bank], 2)
        yield action(
            f"copy_block({source.source}, {target.source})", f"blockcopy({source.token},{whole.token})", codes=codes
        )


def _block_forms() -> Iterator[Cell]:
    for operand in (*addresses(READ), *CONSTANTS):
        if operand.form != "range":
            yield action(f"copy_block({operand.source}, ds[5])", codes=BLOCK_SOURCE.fault(operand))
    for operand in (*pointers(), *immediates(WRITTEN), *CONSTANTS):
        yield action(f"copy_block(ds[1:3], {operand.source})", codes=BLOCK_DESTINATION.fault(operand))


_BLOCK_LENGTHS = [
    action("copy_block(ds[1:5], ds[11:15])", "blockcopy(DS1..DS4,DS11..DS14)"),
    action("copy_block(ds[1:2], ds[11])", "blockcopy(DS1..DS1,DS11..DS11)"),
    action("copy_block(ds[1:5], ds[11], oneshot=True)", "blockcopy(DS1..DS4,DS11..DS14,oneshot=1)"),
    action("copy_block(x[1:17], y[21])", "blockcopy(X001..X016,Y021..Y036)"),
    action("copy_block(ds[1:1001], dd[1])", "blockcopy(DS1..DS1000,DD1..DD1000)"),
    *(action(f"copy_block(ds[1:5], ds[11:{end}])", codes="CG306") for end in (14, 16)),
    *(action(f"copy_block(ds[1:3], {last})", codes="CG306") for last in ("ds[4500]", "dd[1000]", "dh[500]", "yd[8]")),
    # There is a gap after the last point of a module.
    *(action(f"copy_block(c[1:3], y[{last}])", codes="CG306") for last in (16, 36, 816)),
    action('copy_block(dh[1:3], yd["0u"])', codes="CG301"),
    action("copy_block(ds[4:0:-1], ds[11])", codes="CG202"),
    action("copy_block(ds[1:5], ds[14:10:-1])", codes="CG202"),
]

# -- fill -------------------------------------------------------------------------------------------------------------

_FILL = table("""
    DS DD DH DF XD YD TD CTD SD integer hex real    -> DS DD DH DF YD TD CTD SD
    TXT text code                                   -> TXT
    """)
_FILL_SOURCE = Takes(cells=REGISTERS, constants=EVERY_FORM)
_FILL_DESTINATION = Takes(ranges=EVERY_BANK, is_written=True)


def _fills() -> Iterator[Cell]:
    takes = (_FILL_SOURCE, _FILL_DESTINATION)
    for source, target, codes in pairs(_FILL, takes, cells(READ), ranges(WRITTEN)):
        yield action(
            f"copy_fill({source.source}, {target.source})", f"fill({source.token},{target.token})", codes=codes
        )


def _filled_constants() -> Iterator[Cell]:
    """Constants are written as the destination's type."""
    constants, takes = [*CONSTANTS, real("2.0"), hex_text(0x00FF)], (_FILL_SOURCE, _FILL_DESTINATION)
    for source, target, codes in pairs(_FILL, takes, constants, ranges(WRITTEN)):
        token, fault = _typed(source, target)
        if source == hex_text(0x00FF) and target.bank == "TXT":
            fault, codes = "CG302", ""  # a text of five characters
        yield action(
            f"copy_fill({source.source}, {target.source})", f"fill({token},{target.token})", codes=f"{codes} {fault}"
        )


def _fill_forms() -> Iterator[Cell]:
    for operand in addresses(READ):
        if operand.form != "cell":
            yield action(f"copy_fill({operand.source}, ds[5:7])", codes=_FILL_SOURCE.fault(operand))
    for operand in (*addresses(WRITTEN), *CONSTANTS):
        if operand.form != "range":
            yield action(f"copy_fill(5, {operand.source})", codes=_FILL_DESTINATION.fault(operand))


_FILL_LIMITS = [
    action("copy_fill(0, ds[5:6])", "fill(0,DS5..DS5)"),
    action("copy_fill(0, ds[1:4501], oneshot=True)", "fill(0,DS1..DS4500,oneshot=1)"),
    *(action(f"copy_fill({value}, ds[5:7])", codes="CG302") for value in (-32769, 32768, 1.5)),
    *(action(f"copy_fill({value}, dh[5:7])", codes="CG302") for value in (-1, 65536, "0x10000")),
    *(action(f"copy_fill({value}, txt[5:7])", codes="CG302") for value in ('"AB"', '""', '"\N{DEGREE SIGN}"', '"$80"')),
    action("copy_fill(0, ds[6:4:-1])", codes="CG202"),
    *(
        action(f"copy_fill(0, sd[{n}:{n + 1}])", f"fill(0,SD{n}..SD{n})", codes="" if n in WRITABLE_SD else "CG304")
        for n in range(1, 1001)
    ),
    action("copy_fill(0, sd[140:148])", "fill(0,SD140..SD147)"),
    action("copy_fill(0, sd[140:149])", codes="CG304"),
]

MATRICES: Matrices = {
    "copy banks and pointers": list(_copies()),
    "copy constants": list(_copied_constants()),
    "copy forms": list(_copied_forms()),
    "copy limits": list(_copied_limits()),
    "copy SD numbers": _SYSTEM,
    "copy_block banks": list(_blocks()),
    "copy_block forms": list(_block_forms()),
    "copy_block lengths": _BLOCK_LENGTHS,
    "copy_fill banks": list(_fills()),
    "copy_fill constants": list(_filled_constants()),
    "copy_fill forms": list(_fill_forms()),
    "copy_fill limits": _FILL_LIMITS,
}
