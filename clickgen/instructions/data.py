"""Shift registers and table search (click-facts [search.forms, shift.forms])."""

from __future__ import annotations

from dataclasses import replace

from clickgen.instructions.effects import Effects, Find, Keeps
from clickgen.instructions.spec import (
    CODE,
    HEX,
    INTEGER,
    ONESHOT,
    REAL,
    TEXT,
    Access,
    Param,
    ParamKind,
    Slot,
    Spec,
    Variant,
)

# click-facts [shift.work]
SHIFT = Spec(
    name="shift",
    params=(
        Param("range", slot=Slot(ranges=("C",), access=Access.WRITE, reversible=True), aliases=("address",)),
        Param("clock", ParamKind.PIN, default=None, pin=".clock()", missing_pin="CG419"),
        Param("reset", ParamKind.PIN, default=None, pin=".reset()", missing_pin="CG419"),
    ),
    variants=(Variant("shift({range})"),),
    summary="Shift register: the rung is the data bit, which moves in on each rising edge of the clock.",
    example="shift(c[1:9], clock=lambda: c.Clock, reset=lambda: c.Clear)",
    height=3,
    effects=Effects(keeps=frozenset((Keeps.BITS,)), reset_by="reset"),
    notes=("A reversed slice, `c[8:0:-1]`, shifts the other way.",),
)

_SEARCHED = ("DS", "DD", "DH", "DF", "XD", "YD", "TD", "CTD", "SD", "TXT")

# click-facts [search.result]
_RESULT = Param(
    "result",
    slot=Slot(cells=("DS", "DD"), access=Access.WRITE, disputed=("DD",)),
    aliases=("result_address",),
    by_name=True,
)
_FLAG = Param("flag", slot=Slot(cells=("C",), access=Access.WRITE), aliases=("result_flag", "found"), by_name=True)
_HOW = (Param("continuous", ParamKind.FLAG, default=False), ONESHOT)

# click-facts [search.continuous, text.search]
SEARCH_RANGE = Spec(
    name="search",
    params=(
        Param("comparison", ParamKind.RANGE_COMPARISON),
        _RESULT,
        replace(_FLAG, name="found", aliases=("flag", "result_flag")),
        *_HOW,
    ),
    variants=(Variant("search({start}..{end} {condition} {value},result={result},found={flag}{continuous}{oneshot})"),),
    summary="Find the first register of a range that meets a condition; both ends are searched.",
    example="search(ds[100:201] == ds.Target, result=ds.FoundAt, found=c.Found)",
    height=2,
    effects=Effects(
        finds=Find("start", "end", "condition", "value", goes_on="continuous", result="result"),
        # No source says what becomes of the flag while the rung is off: it may need no power.
        reports=("result", "flag"),
    ),
    notes=(
        "The result is the number of the address that was found, or -1; then the flag is off.",
        "With `continuous=True` each search goes on behind the last find; 0 in the result begins anew.",
        "Texts are searched with `==` or `!=`; a text of several characters is found where it begins.",
    ),
)
SEARCH = replace(
    SEARCH_RANGE,
    params=(
        Param("condition", ParamKind.COMPARISON),
        Param(
            "value",
            slot=Slot(cells=_SEARCHED, constants=(INTEGER, HEX, REAL, TEXT, CODE)),
            aliases=("search_value",),
            typed_by="start",
        ),
        Param("start", slot=Slot(cells=_SEARCHED), aliases=("start_address",), extends_to="end"),
        Param("end", slot=Slot(cells=_SEARCHED), aliases=("end_address",)),
        _RESULT,
        _FLAG,
        *_HOW,
    ),
    example='search("==", ds.Target, ds[100], ds[200], ds.FoundAt, c.Found)',
    short=SEARCH_RANGE,
)

SPECS = (SHIFT, SEARCH)
