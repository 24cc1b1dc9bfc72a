"""The copy family: copy, copy_block, copy_fill, copy_pack, copy_unpack."""

from __future__ import annotations

from clickgen.device.banks import POINTED
from clickgen.instructions.effects import COPY_FLAGS, Effects, Move, Shape
from clickgen.instructions.spec import (
    BITS,
    CODE,
    CONSTANTS,
    NUMBERS,
    ONESHOT,
    REGISTERS,
    TEXT,
    Access,
    Pair,
    Param,
    ParamKind,
    Slot,
    Spec,
    Variant,
)

_ALL = BITS + REGISTERS
_NUMERIC = ("DS", "DD", "DH", "DF", "XD", "YD", "TD", "CTD", "SD")
_NUMERIC_TARGETS = ("DS", "DD", "DH", "DF", "YD", "TD", "CTD", "SD")

CONVERSIONS: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "to_value": (("TXT",), _NUMERIC),
    "to_ascii": (("TXT",), _NUMERIC),
    "to_binary": (_NUMERIC, ("TXT",)),
    "to_text": (_NUMERIC, ("TXT",)),
}
"""The banks that each option of a copy converts from and to (click-facts [copy.convert])."""
_OPTIONS = Param("options", ParamKind.OPTIONS, default=None)


def _copies(shape: Shape) -> Effects:
    return Effects(moves=Move("source", "destination", shape), flags=COPY_FLAGS, needs_power=True)


def _source(slot: Slot) -> Param:
    return Param("source", slot=slot, typed_by="destination")


# click-facts [copy.clamp, copy.pointers, copy.single]
COPY = Spec(
    name="copy",
    params=(
        _source(Slot(cells=_ALL, pointers=POINTED, constants=CONSTANTS)),
        Param("destination", slot=Slot(cells=_ALL, pointers=POINTED, access=Access.WRITE)),
        ONESHOT,
        _OPTIONS,
    ),
    variants=(
        Variant(
            "copy({source},{destination}{oneshot}{options})",
            (
                Pair(BITS, ("Y", "C")),
                Pair((*REGISTERS, *NUMBERS), (*_NUMERIC_TARGETS, "TXT")),
                Pair((TEXT, CODE), ("TXT",)),
            ),
        ),
    ),
    conversions=tuple(CONVERSIONS),
    summary="Copy one value; what does not fit the destination is clamped to its range.",
    example="copy(ds.Recipe, ds.Setpoint)",
    height=2,
    matrix=("source", "destination"),
    effects=_copies(Shape.VALUE),
    notes=("Either side may be a pointer: `copy(ds[ds.Index], ds.Value)`.",),
)

# click-facts [copy.block]
COPY_BLOCK = Spec(
    name="copy_block",
    params=(
        Param("source", slot=Slot(ranges=_ALL), aliases=("source_range",)),
        Param(
            "destination",
            slot=Slot(cells=_ALL, ranges=_ALL, access=Access.WRITE),
            aliases=("destination_start",),
            extends_over="source",
        ),
        ONESHOT,
        _OPTIONS,
    ),
    variants=(
        Variant(
            "blockcopy({source},{destination}{oneshot}{options})",
            (
                Pair(BITS, ("Y", "C")),
                Pair(("DS", "DD", "DH", "DF", "SD"), ("DS", "DD", "DH", "DF", "YD", "TD", "CTD")),
                Pair(("TXT",), ("DS", "DD", "DH", "DF")),
            ),
        ),
    ),
    conversions=("to_value", "to_ascii"),
    summary="Copy a range to a range of the same length, which begins at the destination.",
    example="copy_block(ds[1:5], ds[100])",
    height=2,
    matrix=("source", "destination"),
    effects=_copies(Shape.BLOCK),
)

# click-facts [copy.fill]
COPY_FILL = Spec(
    name="copy_fill",
    params=(
        _source(Slot(cells=REGISTERS, constants=CONSTANTS)),
        Param(
            "destination",
            slot=Slot(ranges=_ALL, access=Access.WRITE),
            aliases=("destination_range",),
        ),
        ONESHOT,
        _OPTIONS,
    ),
    variants=(
        Variant(
            "fill({source},{destination}{oneshot})",
            (
                Pair(("DS", "DD", "DH", "DF", "XD", "YD", "TD", "CTD", "SD", *NUMBERS), _NUMERIC_TARGETS),
                Pair(("TXT", TEXT, CODE), ("TXT",)),
            ),
        ),
    ),
    summary="Copy one value into every register of a range.",
    example="copy_fill(0, ds[20:30])",
    height=2,
    matrix=("source", "destination"),
    effects=_copies(Shape.FILL),
)

_DISPUTED_PACK = "the vendor's table and the codec's captures disagree about this pair"

# click-facts [copy.pack-bits, copy.pack-text, copy.pack-words]
COPY_PACK = Spec(
    name="copy_pack",
    params=(
        Param("source", slot=Slot(ranges=(*BITS, "DS", "DH", "TXT")), aliases=("source_range",)),
        Param("destination", slot=Slot(cells=("DS", "DD", "DH", "DF", "TD", "CTD"), access=Access.WRITE)),
        ONESHOT,
        _OPTIONS,
        Param("allow_whitespace", ParamKind.FLAG, default=False),
    ),
    variants=(
        Variant(
            "pack_bits({source},{destination}{oneshot})",
            (
                Pair(("X", "Y", "T", "CT", "SC", "C"), ("DH",), (1, 16)),
                Pair(("C",), ("DS",), (1, 16)),
                Pair(("C",), ("DD", "DF"), (1, 32)),
                Pair(("X", "Y", "T", "CT", "SC"), ("DS",), (1, 16), disputed=_DISPUTED_PACK),
            ),
        ),
        Variant(
            "pack_words({source},{destination}{oneshot})",
            (
                Pair(("DS",), ("DD", "DF"), (2, 2)),
                Pair(("DH",), ("DD",), (2, 2)),
                Pair(("DH",), ("DF",), (2, 2), disputed=_DISPUTED_PACK),
            ),
        ),
        Variant(
            "pack_text({source},{destination}{oneshot}{allow_whitespace})",
            (Pair(("TXT",), ("DS", "DD", "DH", "DF", "TD", "CTD")),),
        ),
    ),
    summary="Pack bits into a word, two words into a double word (low word first), or text into a number.",
    example="copy_pack(c[1:17], dh.StatusWord)",
    height=2,
    matrix=("source", "destination"),
    effects=_copies(Shape.PACK),
)

# click-facts [copy.unpack]
COPY_UNPACK = Spec(
    name="copy_unpack",
    params=(
        Param("source", slot=Slot(cells=("DS", "DD", "DH", "DF"))),
        Param(
            "destination",
            slot=Slot(ranges=("Y", "C", "DS", "DH"), access=Access.WRITE),
            aliases=("destination_range",),
        ),
        ONESHOT,
        _OPTIONS,
    ),
    variants=(
        Variant(
            "unpack_to_bits({source},{destination}{oneshot})",
            (
                Pair(("DS", "DH"), ("Y", "C"), (1, 16)),
                Pair(("DD", "DF"), ("Y", "C"), (1, 32)),
            ),
        ),
        Variant(
            "unpack_to_words({source},{destination}{oneshot})",
            (Pair(("DD", "DF"), ("DS", "DH"), (2, 2)),),
        ),
    ),
    summary="Unpack a word into bits, or a double word into two words (low word first).",
    example="copy_unpack(dd.ConfigWord, c[101:133])",
    height=2,
    matrix=("source", "destination"),
    effects=_copies(Shape.UNPACK),
)

SPECS = (COPY, COPY_BLOCK, COPY_FILL, COPY_PACK, COPY_UNPACK)
