"""The formats in which ``clickgen check`` reports; each is a module of ``clickgen.problems.report``."""

from __future__ import annotations

FORMATS = ("text", "concise", "json", "github", "gitlab", "sarif", "junit")
