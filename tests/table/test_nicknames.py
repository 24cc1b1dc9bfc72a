"""The nicknames that CLICK takes, compared with pyclickplc over generated names.

Where the two differ click-facts [name.characters] is followed. pyclickplc takes these and clickgen does not: the empty
name (there it means no name), a comma, anything outside ASCII, control characters, and a space at either end (its
reader strips them, so such a name would not come back).
"""

from __future__ import annotations

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from pyclickplc import validation as theirs

from clickgen.device.banks import Address
from clickgen.device.nicknames import (
    COMMENT_MAX,
    FORBIDDEN,
    NICKNAME_MAX,
    RESERVED,
    comment_fault,
    is_click_owned,
    nickname_fault,
)

WORDS = st.sampled_from(sorted(RESERVED)).flatmap(lambda word: st.sampled_from([word, word.upper(), word.title()]))
NAMES = (
    st.text(st.characters(min_codepoint=32, max_codepoint=126), max_size=30)
    | st.text(st.sampled_from("aZ09_ "), max_size=30)
    | st.text(max_size=30)
    | WORDS
)


def only_clickgen_minds(name: str) -> bool:
    return not name or "," in name or not name.isascii() or not name.isprintable() or name != name.strip(" ")


def test_the_tables_are_the_same() -> None:
    assert theirs.NICKNAME_MAX_LENGTH == NICKNAME_MAX
    assert theirs.COMMENT_MAX_LENGTH == COMMENT_MAX
    assert theirs.RESERVED_NICKNAMES == RESERVED
    assert theirs.FORBIDDEN_CHARS | {","} == FORBIDDEN


@given(NAMES)
@example("a" * 24)
@example("a" * 25)
@example("_a")
@example("a_")
def test_users_names(name: str) -> None:
    accepted, _ = theirs.validate_nickname(name)
    fault = nickname_fault(name)
    if only_clickgen_minds(name):
        assert fault is not None
    else:
        assert (fault is None) == accepted


@given(NAMES)
@example("_I/O_Module_Error")
def test_click_s_own_names(name: str) -> None:
    accepted, _ = theirs.validate_nickname(name, system_bank="SD")
    fault = nickname_fault(name, system=True)
    if not name or not name.isascii() or not name.isprintable() or name != name.strip(" "):
        assert fault is not None
    else:
        assert (fault is None) == accepted


@pytest.mark.parametrize(
    ("name", "fault"),
    [
        ("", "it is empty"),
        ("Conveyor_running_too_fast", "it has 25 characters and CLICK takes 24"),
        ("Pump-1", "it holds -, which CLICK forbids in a nickname"),
        ("a,b", "it holds a comma, which CLICK forbids in a nickname"),
        ('5"', "it holds a double quote, which CLICK forbids in a nickname"),
        ("a\0b", "it holds the character U+0000, which CLICK forbids in a nickname"),
        ("Öl_Pumpe", "it holds Ö, which is not ASCII"),
        ("a\u2028b", "it holds the character U+2028, which is not ASCII"),
        (" a", "it begins with a space"),
        ("a ", "it ends with a space"),
        ("Mod", "Mod is a word of CLICK's formulas"),
        ("_Always_ON", "it begins with an underscore, which CLICK keeps for its own names"),
        ("First X", None),
        ("1st_Pump", None),
        ("Sums", None),
    ],
)
def test_the_fault_is_named(name: str, fault: str | None) -> None:
    assert nickname_fault(name) == fault


def test_where_names_may_be_click_s_own() -> None:
    assert is_click_owned(Address("SC", 20), "_I/O_BUS_Error")
    assert is_click_owned(Address("SD", 1), "anything")
    assert is_click_owned(Address("X", 101), "_IO1_Module_Error")
    assert not is_click_owned(Address("X", 101), "_Module_Error")
    assert not is_click_owned(Address("Y", 101), "_IO1_Module_Error")


@given(st.text(st.characters(exclude_categories=["Cc", "Cs"]), max_size=140))
@example("x" * 128)
@example("x" * 129)
def test_comments(text: str) -> None:
    assert (comment_fault(text) is None) == theirs.validate_comment(text)[0]


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ("", None),
        ("Umlaute äöü sind erlaubt", None),
        ("two\r\nlines\tand a tab", None),
        ("x" * 129, "it has 129 characters and CLICK takes 128"),
        ("a\0b", "it holds the character U+0000"),
        ("a\ud800b", "it holds the character U+D800"),
    ],
)
def test_the_fault_of_a_comment_is_named(text: str, fault: str | None) -> None:
    assert comment_fault(text) == fault
