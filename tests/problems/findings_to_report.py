"""Reports with every kind of finding, for the tests of the formats."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import pytest
import xmlschema

from clickgen.problems.codes import CODES
from clickgen.problems.diagnostics import Diagnostic, Label
from clickgen.problems.formats import FORMATS
from clickgen.problems.report import Report
from clickgen.text.edits import Edit, Fix
from clickgen.text.source import Span

SCHEMAS = Path(__file__).with_name("schemas")


MACHINES = [name for name in FORMATS if name not in ("text", "concise")]


SOURCE = """\
def main():
    if c.Ä and "\N{GRINNING FACE}":
        out(y.Motor)
    if c.B:
        out(y.Motor)
"""


ODD_PATH = "süd, ost/50%:pumpe.py"


FIX = Fix((Edit(Span(ODD_PATH, 5, 9, 5, 21), "set(y.Motor)"), Edit(Span(ODD_PATH, 4, 1, 4, 1), "    # now\n")))


ODD = Diagnostic(
    "CG501",
    "a\r\n100% <b>&\"'[1](2) {0} ]]>\x00\x1b[31m\x85\u2028\ufffe \N{GRINNING FACE} ä",
    Span(ODD_PATH, 2, 16, 2, 19),
    "one, two: three\nfour",
    (Label(Span(ODD_PATH, 3, 9, 3, 21), "here [x]"), Label(Span("other.py", 7, 1, 8, 2), "and there")),
    FIX,
)


PLACELESS = Diagnostic("CG401", "the program has no main", None)


LONG = Diagnostic("CG403", "over several lines", Span("other.py", 7, 5, 9, 2))


def line_of(path: str, number: int) -> str:
    lines = SOURCE.split("\n") if path == ODD_PATH else []
    return lines[number - 1] if 0 < number <= len(lines) else ""


def many(code: str, count: int, path: str = "many.py") -> tuple[Diagnostic, ...]:
    return tuple(Diagnostic(code, f"finding {n}", Span(path, n, 1, n, 5)) for n in range(1, count + 1))


EVERY_CODE = tuple(Diagnostic(code, "said", Span("every.py", n, 1, n, 2), "do that") for n, code in enumerate(CODES, 1))


REPORTS = {
    "nothing at all": Report(()),
    "clean": Report((), ("one.py", "two.py")),
    "odd": Report((ODD, LONG, PLACELESS), (ODD_PATH, "clean.py"), line_of, 2, skipped={"in the baseline": 3}),
    "placeless only": Report((PLACELESS,)),
    "denied": Report((ODD, *many("CG506", 2)), (ODD_PATH,), line_of, deny_warnings=True),
    "hundred": Report(many("CG501", 100), ("many.py",)),
    "every code": Report(EVERY_CODE, ("every.py",)),
}


every_report = pytest.mark.parametrize("report", REPORTS.values(), ids=list(REPORTS))


def one(code: str, path: str = "one.py", message: str = "said") -> Report:
    return Report((Diagnostic(code, message, Span(path, 3, 5, 3, 9)),), (path,))


_SARIF_SCHEMA = json.loads((SCHEMAS / "sarif-schema-2.1.0.json").read_text("utf-8"))


_SARIF = jsonschema.Draft7Validator(_SARIF_SCHEMA)


_JUNIT = xmlschema.XMLSchema(str(SCHEMAS / "junit-10.xsd"))
