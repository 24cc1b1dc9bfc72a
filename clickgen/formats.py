"""The formats in which ``clickgen check`` reports; each is a module of ``clickgen.report``."""

from __future__ import annotations

FORMATS = ("text", "concise", "json", "github", "gitlab", "sarif", "junit")
