"""Numbers and names in messages."""

from __future__ import annotations


def counted(number: int, noun: str, plural: str = "") -> str:
    """``1 rung``, ``2 rungs``, ``3 addresses``."""
    return f"{number} {noun}" if number == 1 else f"{number} {plural or noun + 's'}"


def quoted(text: str) -> str:
    """A text in quotes, double ones where it can be: ``"Auto Mode"``."""
    shown = repr(text)
    return shown if '"' in text else f'"{shown[1:-1]}"'


def as_utf8(text: str) -> str:
    """Text that UTF-8 can hold: the bytes of a file name that is no text become escapes such as ``\\udcff``."""
    return text.encode(errors="backslashreplace").decode()


def no_opposite(shown: str, is_negated: bool = False) -> str:
    """The way out for what has no opposite; ``is_negated`` where a ``not`` asks for it, not an else."""
    nothing, then = "nothing", "test the bit"
    if is_negated:
        nothing, then = "nothing in the language", "write nc(...) of that bit"
    return f"{nothing} is the opposite of {shown}: put it on a bit with out(...) in a rung before, and {then}"
