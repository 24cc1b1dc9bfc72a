"""Nicknames and address comments that CLICK takes (click-facts [name.characters])."""

from __future__ import annotations

import re

from clickgen.device.banks import Address

NICKNAME_MAX = 24
COMMENT_MAX = 128
"""Both in characters (click-facts [name.length])."""

FORBIDDEN = frozenset("%\"<>!#$&'()*+-./:;=?@[\\]^`{|}~,")

# fmt: off
RESERVED = frozenset((
    "log", "sum", "sin", "asin", "rad", "cos", "acos", "sqrt", "deg", "tan", "atan", "ln", "pi",
    "mod", "and", "or", "xor", "lsh", "rsh", "lro", "rro",
))
# fmt: on
"""Words of CLICK's formulas; none may be a whole nickname, in any case (click-facts [name.reserved])."""

_PLAIN = re.compile(r"[A-Za-z0-9](?:[A-Za-z0-9_ ]{0,22}[A-Za-z0-9_])?")
_CHARACTER_NAMES = {
    ",": "a comma",
    '"': "a double quote",
    "'": "an apostrophe",
    "`": "a backtick",
    "\\": "a backslash",
    "\t": "a tab",
    "\n": "a line break",
    "\r": "a line break",
}


def nickname_fault(name: str, *, system: bool = False) -> str | None:
    """Return the fault of a nickname in one short sentence, or None if CLICK takes it.

    ``system`` is for a name that CLICK itself gave: it may begin with an underscore and hold punctuation.
    """
    if _PLAIN.fullmatch(name) and name.lower() not in RESERVED:
        return None
    if not name:
        return "it is empty"
    if len(name) > NICKNAME_MAX:
        return f"it has {len(name)} characters and CLICK takes {NICKNAME_MAX}"
    if name != name.strip(" "):
        return f"it {'begins' if name[0] == ' ' else 'ends'} with a space"
    for character in name:
        if not character.isascii():
            return f"it holds {_named(character)}, which is not ASCII"
        if not character.isprintable() or (character in FORBIDDEN and not system):
            return f"it holds {_named(character)}, which CLICK forbids in a nickname"
    if name.lower() in RESERVED:
        return f"{name} is a word of CLICK's formulas"
    if name[0] == "_" and not system:
        return "it begins with an underscore, which CLICK keeps for its own names"
    return None


def nickname_fault_at(address: Address, name: str) -> str | None:
    """Return the fault of a nickname of an address; CLICK's own names pass on CLICK's own points."""
    fault = nickname_fault(name)
    return nickname_fault(name, system=True) if fault and is_click_owned(address, name) else fault


def is_click_owned(address: Address, name: str) -> bool:
    """True if a nickname may be CLICK's own: on SC and SD, and ``_IO...`` on X (an analog module's state).

    click-facts [name.underscore, system.io-names]
    """
    return address.bank in ("SC", "SD") or (address.bank == "X" and name.startswith("_IO"))


def comment_fault(text: str) -> str | None:
    """Return the fault of an address comment in one short sentence, or None if CLICK takes it."""
    if len(text) > COMMENT_MAX:
        return f"it has {len(text)} characters and CLICK takes {COMMENT_MAX}"
    if text.isprintable():
        return None
    for character in text:
        # A UTF-8 text file cannot hold a NUL or a lone surrogate; line breaks are allowed between quotes.
        if (character < " " and character not in "\t\n\r") or character == "\x7f" or "\ud800" <= character <= "\udfff":
            return f"it holds {_named(character)}"
    return None


def _named(character: str) -> str:
    if character in _CHARACTER_NAMES:
        return _CHARACTER_NAMES[character]
    return character if character.isprintable() else f"the character U+{ord(character):04X}"
