"""How arguments are written: by position or by name, lists, options; and the same in the ladder."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from hypothesis import strategies as st

from strategies.conditions import ladder_name

Shown = tuple[str, str]
"""A text in the source, and in the ladder's token."""


@dataclass(frozen=True)
class Given:
    """One argument: its keyword, perhaps one of several, and its text; None leaves it out."""

    names: tuple[str, ...]
    text: str | None


def given(name: str, text: str | None, *aliases: str) -> Given:
    return Given((name, *aliases), text)


def called(draw: st.DrawFn, name: str, arguments: Sequence[Given]) -> str:
    """Return a call with its first arguments by position and the others by name, in either order."""
    in_place = next((n for n, one in enumerate(arguments) if one.text is None), len(arguments))
    count = draw(st.integers(0, in_place))
    named = [f"{draw(st.sampled_from(one.names))}={one.text}" for one in arguments[count:] if one.text is not None]
    if draw(st.booleans()):
        named.reverse()
    return f"{name}({', '.join([*(str(one.text) for one in arguments[:count]), *named])})"


def oneshots(draw: st.DrawFn) -> tuple[Given, str]:
    """``oneshot=`` or not."""
    if draw(st.booleans()):
        return given("oneshot", "True", "one_shot"), ",oneshot=1"
    return given("oneshot", draw(st.sampled_from((None, None, "False"))), "one_shot"), ""


def cell(bank: str, number: int) -> Shown:
    return f"{bank.lower()}[{number}]", ladder_name(bank, number)


def span(bank: str, first: int, length: int) -> Shown:
    """A range of this many addresses."""
    token = f"{ladder_name(bank, first)}..{ladder_name(bank, first + length - 1)}"
    return f"{bank.lower()}[{first}:{first + length}]", token


def sequence(draw: st.DrawFn, texts: Sequence[str]) -> str:
    """A list or a tuple of these."""
    inner = ", ".join(texts)
    if draw(st.integers(0, 3)):
        return f"[{inner}]"
    return f"({inner},)" if len(texts) == 1 else f"({inner})"


def bit_list(draw: st.DrawFn, bits: Sequence[tuple[str, int]]) -> Shown:
    """Bits in a list; runs of neighbours may be a slice, and a single run needs no list."""
    texts: list[str] = []
    at = 0
    slices = draw(st.booleans())
    while at < len(bits):
        bank, number = bits[at]
        length = 1
        while at + length < len(bits) and bits[at + length] == (bank, number + length):
            length += 1
        if not (slices and length > 1 and _is_unbroken(bank, number, length)):
            length = 1
        texts.append(span(bank, number, length)[0] if length > 1 else cell(bank, number)[0])
        at += length
    token = ",".join(ladder_name(*bit) for bit in bits)
    if len(texts) == 1 and ":" in texts[0] and draw(st.booleans()):
        return texts[0], token
    return sequence(draw, texts), token


def _is_unbroken(bank: str, first: int, length: int) -> bool:
    """X and Y have gaps after each sixteen."""
    return bank not in ("X", "Y") or (first - 1) % 20 + length <= 16
