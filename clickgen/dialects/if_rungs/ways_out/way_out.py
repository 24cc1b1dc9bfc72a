"""A way out for a statement: what the person may have meant."""

from __future__ import annotations

from typing import NamedTuple

from clickgen.text.edits import Fix


class WayOut(NamedTuple):
    """What to say of a statement, what to do, and a fix. Without a ``message`` the reader's own is said."""

    help: str = ""
    message: str = ""
    fix: Fix | None = None
