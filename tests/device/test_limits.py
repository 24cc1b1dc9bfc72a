"""The size of a rung comment, against laddercodec's encoding of it (the codec refuses more than 1,400 bytes)."""

from __future__ import annotations

from hypothesis import example, given
from hypothesis import strategies as st
from laddercodec.encode import COMMENT_MAX_BYTES, _build_rtf_body

from clickgen.device.limits import COMMENT_BYTES_MAX, comment_bytes, styled_part


def test_the_limit_is_the_codec_s() -> None:
    assert COMMENT_BYTES_MAX == COMMENT_MAX_BYTES


@given(st.text(st.sampled_from("ab _*\\{}\n\u00e9\u2192\u2014\u00b5\u4e2d\u0301"), max_size=60))
@example("**a** and __b__ and *c* and _d_")
@example("***a***")
@example("_*a*_ *_b_* __*c*__")
@example("*a*_\\_")
def test_a_comment_takes_the_bytes_that_the_codec_counts(comment: str) -> None:
    assert comment_bytes(comment) == len(_build_rtf_body(comment).encode("cp1252"))


def test_styled_text_is_found() -> None:
    assert styled_part("count_up_down a * b") == ""
    assert styled_part("a **bold** word") == "**bold**"
    assert styled_part("2 * 3 * 4") == "* 3 *"
