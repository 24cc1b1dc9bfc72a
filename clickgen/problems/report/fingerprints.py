"""A name for each finding that stays the same while lines move, for services that follow findings from run to run."""

from __future__ import annotations

import hashlib
from collections import Counter

from clickgen.problems.finding_keys import Key, keys_of
from clickgen.problems.report import Report, shown_path


def fingerprints(report: Report) -> list[str]:
    """One for each finding, in their order, all different: made from its baseline key and a number."""
    seen: Counter[Key] = Counter()
    names = []
    for key in keys_of(report.findings, shown_path, report.line_of):
        seen[key] += 1
        text = "\0".join((*key, str(seen[key])))
        # A file name that is no UTF-8 has lone surrogates.
        names.append(hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()[:32])
    return names
