"""Pack and unpack: bits, words and text.

click-facts [copy.pack-bits, copy.pack-text, copy.pack-words, copy.unpack]
"""

from __future__ import annotations

from collections.abc import Iterator

from matrix.notation import (
    BITS,
    CONSTANTS,
    READ,
    WRITTEN,
    Cell,
    Matrices,
    Operand,
    Takes,
    action,
    addresses,
    cell,
    cells,
    pairs,
    ranges,
    span,
    table,
)

# -- pack -------------------------------------------------------------------------------------------------------------

_PACK_BITS = table("""
    X Y T CT SC     -> DH
    X Y T CT SC     ?> DS
    C               -> DH DS DD DF
    """)
_PACK_WORDS = table("""
    DS              -> DD DF
    DH              -> DD
    DH              ?> DF
    """)
_PACK_TEXT = table("TXT -> DS DD DH DF TD CTD")
_PACK = {**_PACK_BITS, **_PACK_WORDS, **_PACK_TEXT}
_PACK_FROM = Takes(ranges=f"{BITS} DS DH TXT")
_PACK_TO = Takes(cells="DS DD DH DF TD CTD", is_written=True)
_LENGTHS = (1, 2, 3, 16, 17, 32, 33)


def _name(pair: tuple[str, str]) -> str:
    return "pack_bits" if pair in _PACK_BITS else "pack_words" if pair in _PACK_WORDS else "pack_text"


def _fits(source: str, target: str, length: int) -> bool:
    """16 bits or 32 depending on the register that holds them, two words exactly, any number of characters."""
    if (source, target) in _PACK_TEXT:
        return True
    if (source, target) in _PACK_WORDS:
        return length == 2
    return length <= (32 if target in ("DD", "DF") else 16)


def _packs(ending: str = "", token: str = "") -> Iterator[Cell]:
    for source, target, codes in pairs(_PACK, (_PACK_FROM, _PACK_TO), ranges(READ), cells(WRITTEN)):
        pair = source.bank, target.bank
        # Also if the pair is disputed.
        spaces = "allow_whitespace" in token and codes in ("", "CG312") and _name(pair) != "pack_text"
        yield action(
            f"copy_pack({source.source}, {target.source}{ending})",
            f"{_name(pair)}({source.token},{target.token}{token})",
            codes=f"{codes} CG314" if spaces else codes,
        )


def _pack_lengths() -> Iterator[Cell]:
    """A module has 16 points, so no range of X or Y is longer."""
    for (source, target), verdict in _PACK.items():
        for length in _LENGTHS:
            bits = span(source, 1, length)
            fault = verdict if _fits(source, target, length) else f"{verdict} CG306"
            if source in ("X", "Y") and length > 16:
                fault = "CG202"
            yield action(
                f"copy_pack({bits.source}, {target.lower()}[5])",
                f"{_name((source, target))}({bits.token},{target}5)",
                codes=fault,
            )
    yield action("copy_pack(c[16:0:-1], dh[5])", codes="CG202")
    yield action("copy_pack(sc[1:17], dh[5])", "pack_bits(SC1..SC16,DH5)")


def _pack_forms() -> Iterator[Cell]:
    for operand in (*addresses(READ), *CONSTANTS):
        if operand.form != "range":
            yield action(f"copy_pack({operand.source}, dd[5])", codes=_PACK_FROM.fault(operand))
    for operand in (*addresses(WRITTEN), *CONSTANTS):
        if operand.form != "cell":
            yield action(f"copy_pack(c[1:3], {operand.source})", codes=_PACK_TO.fault(operand))


def _options() -> Iterator[Cell]:
    """An instruction that packs or unpacks converts nothing."""
    for option in ("to_value", "to_ascii", "to_binary", "to_text", "to_text(suppress_zero=False)"):
        yield action(f"copy_pack(txt[1:5], ds[5], options={option})", codes="CG314")
        yield action(f"copy_unpack(dh[1], c[1:17], options={option})", codes="CG314")
    yield action("copy_pack(txt[1:5], ds[5], options=None)", "pack_text(TXT1..TXT4,DS5)")
    yield action("copy_unpack(dh[1], c[1:17], options=None)", "unpack_to_bits(DH1,C1..C16)")
    yield action(
        "copy_pack(txt[1:5], ds[5], allow_whitespace=True, oneshot=True)",
        "pack_text(TXT1..TXT4,DS5,oneshot=1,allow_whitespace=1)",
    )
    yield action("copy_pack(c[1:5], ds[5], allow_whitespace=False)", "pack_bits(C1..C4,DS5)")
    yield action("copy_unpack(dh[1], c[1:17], allow_whitespace=True)", codes="CG109")


# -- unpack -----------------------------------------------------------------------------------------------------------

_UNPACK_BITS = table("DS DH DD DF -> Y C")
_UNPACK_WORDS = table("DD DF -> DS DH")
_UNPACK = {**_UNPACK_BITS, **_UNPACK_WORDS}
_UNPACK_FROM = Takes(cells="DS DD DH DF")
_UNPACK_TO = Takes(ranges="Y C DS DH", is_written=True)


def _unpack(source: Operand, target: Operand, codes: str, ending: str = "", token: str = "") -> Cell:
    name = "unpack_to_bits" if target.bank in ("Y", "C") else "unpack_to_words"
    return action(
        f"copy_unpack({source.source}, {target.source}{ending})",
        f"{name}({source.token},{target.token}{token})",
        codes=codes,
    )


def _unpacks(ending: str = "", token: str = "") -> Iterator[Cell]:
    for source, target, codes in pairs(_UNPACK, (_UNPACK_FROM, _UNPACK_TO), cells(READ), ranges(WRITTEN)):
        yield _unpack(source, target, codes, ending, token)


def _unpack_lengths() -> Iterator[Cell]:
    for source, target in _UNPACK:
        for length in _LENGTHS:
            most = 32 if source in ("DD", "DF") else 16
            fits = length <= most if (source, target) in _UNPACK_BITS else length == 2
            fault = "CG202" if target == "Y" and length > 16 else "" if fits else "CG306"
            yield _unpack(cell(source, 1), span(target, 1, length), fault)
    yield action("copy_unpack(dh[1], c[16:0:-1])", codes="CG202")


def _unpack_forms() -> Iterator[Cell]:
    for operand in (*addresses(READ), *CONSTANTS):
        if operand.form != "cell":
            yield action(f"copy_unpack({operand.source}, c[1:3])", codes=_UNPACK_FROM.fault(operand))
    for operand in (*addresses(WRITTEN), *CONSTANTS):
        if operand.form != "range":
            yield action(f"copy_unpack(dd[1], {operand.source})", codes=_UNPACK_TO.fault(operand))


MATRICES: Matrices = {
    "copy_pack banks": list(_packs()),
    "copy_pack oneshot": list(_packs(", oneshot=True", ",oneshot=1")),
    "copy_pack allow_whitespace": list(_packs(", allow_whitespace=True", ",allow_whitespace=1")),
    "copy_pack lengths": list(_pack_lengths()),
    "copy_pack forms": list(_pack_forms()),
    "copy_unpack banks": list(_unpacks()),
    "copy_unpack oneshot": list(_unpacks(", oneshot=True", ",oneshot=1")),
    "copy_unpack lengths": list(_unpack_lengths()),
    "copy_unpack forms": list(_unpack_forms()),
    "pack options": list(_options()),
}
