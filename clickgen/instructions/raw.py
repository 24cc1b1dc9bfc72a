"""Kept from old projects: instructions that the language has no word for, and places of rungs that were left out."""

from __future__ import annotations

import re

from clickgen.instructions.effects import Effects
from clickgen.instructions.spec import Param, ParamKind, Spec, Variant

WORD = "raw"
"""The word that laddercodec has for an instruction that it does not model (click-facts [token.raw])."""

RAW = Spec(
    name=WORD,
    params=(Param("token", ParamKind.TOKEN),),
    variants=(Variant("{token}"),),
    summary="An instruction that the language has no word for, as its ladder token.",
    example=(
        'raw("raw(Velocity,0x2735,1,222d=0,609b=1,609c=1,609d=1,222f=2,11f5=0,2231=0,'
        '60a2=,60a3=,60a4=,607b=C1,607d=C2,6083=DS1,3218=9744,0000=)")'
    ),
    effects=Effects(is_unknown=True),
    notes=(
        "`clickgen import` writes it. What CLICK does there, clickgen does not know: every address in the token counts "
        "as read and as written.",
        "Kept are tokens `raw(...)` as laddercodec writes them, and formulas `math(...)` that clickgen would write "
        "otherwise (CG317).",
    ),
)
NOT_IMPORTED = Spec(
    name="not_imported",
    params=(Param("reason", ParamKind.TEXT),),
    variants=(),
    summary="The place of a rung that `clickgen import` left out: a program that has it does not build.",
    example='not_imported("main.csv:45: the contacts are wired in too many ways")',
    effects=Effects(is_unknown=True),
    notes=("Draw the rung again by hand from the old project, and take the line out (CG426).",),
)

SPECS = (RAW, NOT_IMPORTED)

_ROWS = re.compile(r"raw\(\w+,0x[0-9A-Fa-f]+,(\d{1,5})[,)]")


def rows_of(token: str) -> int:
    """The grid rows of a kept instruction; ``raw(Class,0x2737,N,...)`` says them itself (click-facts [token.raw])."""
    match = _ROWS.match(token)
    return max(1, int(match[1])) if match else RAW.height
