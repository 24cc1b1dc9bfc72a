"""Words that are functions of a formula elsewhere."""

from __future__ import annotations

from collections.abc import Sequence

from clickgen.dialects.if_rungs.trade.advice import (
    CLAMP,
    LIMIT,
    LIMITED,
    LIMITS,
    MAX,
    MIN,
    OWN_SIZE,
    SELECT,
    SIZE,
    TWO_RUNGS,
    table,
)

FORMULAS = table(
    ("pow power expt xpy", "write {}: a power has its sign", ("(ds.A ^ 2)",), "($1 ^ $2)"),
    ("exp", "write {}: a power of e", ("(2.7182818 ^ df.A)",), "(2.7182818 ^ $1)"),
    ("sqr", "a square is {}, a square root {}", ("ds.A ^ 2", "SQRT(df.A)"), ""),
    ("log10", "CLICK's LOG is the logarithm to base 10: {}", ("LOG(df.A)",), "LOG($1)"),
    ("log2", "write {}: a logarithm to base 2", ("(LN(df.A) / LN(2))",), "(LN($1) / LN(2))"),
    ("rol", "write {}: a rotation to the left", ("LRO(dh.A, 1)",), "LRO($1, $2)"),
    ("ror", "write {}: a rotation to the right", ("RRO(dh.A, 1)",), "RRO($1, $2)"),
    ("abs", SIZE, ("copy(ds.A, ds.Size)", 'if ds.Size < 0: calc("-ds.Size", ds.Size)'), OWN_SIZE),
    ("sine", "write {}: a sine", ("SIN(df.A)",), "SIN($1)"),
    ("cosine", "write {}: a cosine", ("COS(df.A)",), "COS($1)"),
    ("tangent", "write {}: a tangent", ("TAN(df.A)",), "TAN($1)"),
    ("sqroot root", "write {}: a square root", ("SQRT(df.A)",), "SQRT($1)"),
    ("add", "write {}: a sum has its sign", ("(ds.A + ds.B)",), "($1 + $2)"),
    ("sub", "write {}: a difference has its sign", ("(ds.A - ds.B)",), "($1 - $2)"),
    ("mul", "write {}: a product has its sign", ("(ds.A * ds.B)",), "($1 * $2)"),
    ("div", "write {}: a quotient has its sign", ("(ds.A / ds.B)",), "($1 / $2)"),
    ("neg", "write {}: the opposite number", ("(-ds.A)",), "(-$1)"),
    ("avg ave average mean", "write {}: a mean value", ("(SUM(ds[1:11]) / 10)",), "(($1 + $2) / 2)"),
    ("total", "write {}: a sum of a range", ("SUM(ds[1:11])",), ""),
    (
        "min",
        TWO_RUNGS,
        ("if ds.A <= ds.B: copy(ds.A, ds.C)", "if ds.A > ds.B: copy(ds.B, ds.C)"),
        MIN,
    ),
    (
        "max",
        TWO_RUNGS,
        ("if ds.A >= ds.B: copy(ds.A, ds.C)", "if ds.A < ds.B: copy(ds.B, ds.C)"),
        MAX,
    ),
    ("limit lim", LIMITS, LIMITED, LIMIT),
    ("clamp", LIMITS, LIMITED, CLAMP),
    ("sel", TWO_RUNGS, ("if nc(c.Pick): copy(ds.A, ds.C)", "if c.Pick: copy(ds.B, ds.C)"), SELECT),
    (
        "if iif choose",
        TWO_RUNGS,
        ("if c.Pick: copy(ds.A, ds.C)", "if nc(c.Pick): copy(ds.B, ds.C)"),
        "if $1: copy($2, $=)\nif nc($1): copy($3, $=)",
    ),
    ("mux", "a pointer chooses one of a table: {}", ("copy(ds[ds.Index], ds.C)",), ""),
    (
        "round",
        "add a half with {}, and cut the decimals off with {}",
        ('calc("df.A + 0.5", df.B)', "copy(df.B, ds.C)"),
        'calc("$1 + 0.5", df.Half)\ncopy(df.Half, ds.Rounded)',
    ),
    ("int trunc floor dint fix", "a copy to a whole number cuts the decimals off: {}", ("copy(df.A, ds.B)",), ""),
    ("real float", "a copy to DF makes a floating-point number: {}", ("copy(ds.A, df.B)",), ""),
    ("band", "words are combined in math_hex: {}", ('math_hex("dh.A AND dh.B", dh.C)',), ""),
    ("bor", "words are combined in math_hex: {}", ('math_hex("dh.A OR dh.B", dh.C)',), ""),
    ("bxor", "words are combined in math_hex: {}", ('math_hex("dh.A XOR dh.B", dh.C)',), ""),
)
"""What is written as a function of a formula."""


def formula_advice(word: str, arguments: Sequence[str], target: str) -> str:
    """What a function of another machine is here, with the person's own arguments where they fit; "" for any other."""
    found = FORMULAS.get(word.lower())
    if found is None:
        return ""
    written = found.written(arguments, target)
    return found.of(written) if written else found.shown
