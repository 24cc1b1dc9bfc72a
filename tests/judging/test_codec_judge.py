"""laddercodec as a judge: what it takes, and where it differs."""

from __future__ import annotations

import csv
import random
from pathlib import Path

import laddercodec
import pytest
from drawn_by_hand import COPY, CTD, DRUM, SEND, Line, csv_rows, csv_text, draw
from judges.codec import assert_codec_reads, comments_agree, normalise
from judges.power import (
    HEIGHTS,
    check_no_backfeed,
    read_ladder,
)

SHARED = Path(__file__).parents[3] / "shared"


TOKENS = SHARED / "data" / "ladder-tokens.csv"


# -- laddercodec -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("lines", "message"),
    [
        # comes back as convert=to_value: the two share a code in the clipboard
        (
            [("C1", "copy(DF1,TXT1,convert=to_text(suppress_zero=0,exponential=1,termination_code=none))")],
            "convert=to_value",
        ),
        ([("C1", DRUM), ("C2", ".reset()"), ("C3 T", ".jog()"), ("C4", "")], "Vertical-down tokens"),
        ([("C1 T", "out(Y001)"), (". -", CTD), ("C2", ".reset()")], "on row 2 is"),
        ([("C1", COPY), ("", "")], "1 rows, ours 2"),
        # it counts the down counter's own bridge row as a second NOP
        ([("C1", CTD), ("C2", ".reset()"), ("C3", "NOP")], "Only one NOP"),
        ([("C1", SEND.replace("ModbusTcpTarget", "Nobody"))], "laddercodec: "),
    ],
)
def test_what_laddercodec_loses_or_writes_otherwise_fails(lines: list[Line], message: str) -> None:
    read_ladder(draw(*lines))
    with pytest.raises(AssertionError) as caught:
        assert_codec_reads(draw(*lines))
    assert message in str(caught.value)


@pytest.mark.parametrize("quoted", ['"C1"', '"out(Y001)"'])
def test_needless_quotes_fail(quoted: str) -> None:
    text = draw(("C1", "out(Y001)")).replace(quoted.strip('"'), quoted)
    read_ladder(text)
    with pytest.raises(AssertionError, match="quotes belong"):
        assert_codec_reads(text)


@pytest.mark.parametrize(
    "comment",
    [
        ("",),
        ("first", "", "third", ""),
        ("  indented, with {braces} and back\\slash",),
        ("**bold** *italic* __under__ _lean_ snake_case_name",),
        ("Öl ≥ 5 µm → stop",),
        ("x" * 1400,),
    ],
)
def test_comments_survive(comment: tuple[str, ...]) -> None:
    assert_codec_reads(draw(("C1", "out(Y001)"), comment=comment))


def test_comment_that_is_too_long_fails() -> None:
    with pytest.raises(AssertionError, match="1400 bytes"):
        assert_codec_reads(draw(("C1", "out(Y001)"), comment=("x" * 1390, "{}" * 3)))


def test_comments_that_differ_are_told_apart() -> None:
    assert not comments_agree(("tank one",), ("tank two",))
    assert not comments_agree(("tank", "one"), ("tank one",))
    assert not comments_agree((), ("tank",))


def test_normalising_keeps_real_differences() -> None:
    apart = [
        ("pack_bits(C1..C16,DH1)", "pack_words(DS1..DS2,DD1)"),
        ("unpack_to_bits(DH1,C1..C16)", "unpack_to_words(DD1,DS1..DS2)"),
        ("for(DS1)", "for(DS1,oneshot=1)"),
        ("X001", "X001.immediate"),
        ("~immediate(X001)", "immediate(X001)"),
        (SEND, SEND.replace("192.168.1.10", "192.168.1.11")),
    ]
    for one, other in apart:
        assert normalise(one) != normalise(other)
    assert normalise("pack_words(X001..X016,DH1)") == normalise("pack_bits(X001..X016,DH1)")


@pytest.mark.parametrize(
    ("row", "column", "cell"),
    [(0, 1, "-"), (0, 0, laddercodec.Contact.from_csv_token("C7")), (1, 0, ""), (0, 5, "")],
)
def test_a_reader_that_errs_is_caught(monkeypatch: pytest.MonkeyPatch, row: int, column: int, cell: object) -> None:
    decode = laddercodec.decode

    def wrong(data: bytes) -> object:
        rung = decode(data)
        rung.conditions[row][column] = cell
        return rung

    text = draw(("C1 T", "out(Y001)"), ("C2", ""))
    assert_codec_reads(text)
    monkeypatch.setattr(laddercodec, "decode", wrong)
    with pytest.raises(AssertionError):
        assert_codec_reads(text)


# -- every token -------------------------------------------------------------------------------------------------------


def token_examples() -> dict[str, list[list[Line]]]:
    """Rungs by name from the table beside the project, or none if it is not there."""
    if not TOKENS.exists():
        return {}
    examples: dict[str, list[list[Line]]] = {}
    with TOKENS.open(encoding="utf-8", newline="") as handle:
        for record in csv.DictReader(handle):
            name, _, marker = record["marker"].partition(":")
            rungs = examples.setdefault(name, [])
            if marker == "R":
                rungs.append([])
            rungs[-1].append((record["A"], record["AF"]))
    return examples


EXAMPLES = token_examples()


@pytest.mark.skipif(not EXAMPLES, reason="shared/data/ladder-tokens.csv is not beside the project")
def test_every_token_passes_both_judges() -> None:
    rng = random.Random(0)
    for name, rungs in EXAMPLES.items():
        text = csv_text(*(row for lines in rungs for row in csv_rows(*lines)))
        try:
            assert_codec_reads(text)
            for rung in read_ladder(text):
                check_no_backfeed(rung)
        except AssertionError as error:
            pytest.fail(f"{name}: {error}")
    every = [csv_rows(*lines) for rungs in EXAMPLES.values() for lines in rungs]
    rng.shuffle(every)
    assert len(assert_codec_reads(csv_text(*(row for rows in every for row in rows)))) == len(every)


@pytest.mark.skipif(not EXAMPLES, reason="shared/data/ladder-tokens.csv is not beside the project")
def test_every_height_has_an_example() -> None:
    used = {af.partition("(")[0] for rungs in EXAMPLES.values() for lines in rungs for _, af in lines}
    assert set(HEIGHTS) - {"raw"} <= used
