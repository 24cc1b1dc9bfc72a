"""Instructions that are kept as ladder tokens are ones that laddercodec leaves as they are."""

from __future__ import annotations

from clickgen.facts.facts import Facts
from clickgen.ir.program import KeptToken
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

CODE = "CG317"


def find(facts: Facts) -> Findings:
    tokens = [placed.action.args.get("token") for placed in facts.actions]
    for token in tokens:
        if isinstance(token, KeptToken):
            # Few programs keep tokens. The readers of ladder files know them, and load slowly.
            from clickgen.click.read.kept import fault_of

            fault = fault_of(token.text)
            if fault is not None:
                help = fault.way_out(facts.spell)
                yield finding(CODE, token.span, f"the ladder token cannot be kept: {fault.message}", help)


ABOUT = Code(
    "CG317",
    Severity.ERROR,
    "the ladder token cannot be kept",
    """
`raw("...")` keeps, as its ladder token, an instruction that the language has no word for. It takes only
a token `raw(...)` exactly as laddercodec writes it, or a formula `math(...)` that clickgen would print differently.
If the language has a word for an instruction, use that word, so that clickgen can check it.

If a token is not as laddercodec writes it, it would not come back unchanged from CLICK. Copy it again from the ladder
file, or use the form that the problem's help shows.
""",
    wrong=(
        Wrong(
            """
if x[1]:
    raw("out(Y001)")  # <-
""",
        ),
        Wrong(
            """
if x[1]:
    raw("math(DS1  +DS2,DS3,mode=decimal)")  # <-
""",
        ),
    ),
    right=(
        """
if x[1]:
    out(y[1])
""",
    ),
)

RULE = Rule(find, (ABOUT,), holds_in_parts=True)
