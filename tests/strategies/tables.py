"""Address tables as bytes, most of them broken in a few places."""

from __future__ import annotations

from hypothesis import strategies as st

from strategies.broken import changed, changes
from strategies.conditions import weighted
from strategies.given import CASES, case_texts, given_files, whole_programs
from strategies.words import split

NAMED = case_texts(next(path for path in CASES if path.parent.name == "demo"))
HEADER = "Address,Data Type,Nickname,Initial Value,Retentive,Address Comment"
_ADDRESSES = split(
    """
    C1 C2 C2000 X001 X017 Y001 DS1 DS4500 DS4501 TD1 T1 CT1 XD0u XD8 SC1 SD1 TXT1 DF1 DH1 c1 C01 C 1 é -
    """
)
_TYPES = ["BIT", "INT", "INT2", "HEX", "FLOAT", "TEXT", "bit", "WORD", ""]
_NAMES = [
    "Start",
    "StartButton",
    "start",
    "SystemRunning",
    "_1st_SCAN",
    "Scratch_C2000",
    "a b",
    "sin",
    "é",
    "x" * 25,
    "",
]
_NAMES += ['say ""x""', "a,b", "\x00", "line\nbreak", "ValueFound", "_IO1", "Scratch_C1"]
_INITIALS = ["0", "1", "", "-1", "32768", "FFFF", "FFFFh", "1e5", "-3.4028235E+38", "nan", "A", "AB", '"']
_COMMENTS = ["", "a comment", 'with ""quotes""', "x" * 129, "é", "two\nlines", "condition of main rung 1: C1"]


def _quoted(text: str) -> str:
    return f'"{text}"'


rows = st.tuples(
    st.sampled_from(_ADDRESSES),
    st.sampled_from(_TYPES),
    st.sampled_from(_NAMES).map(_quoted),
    st.sampled_from(_INITIALS),
    st.sampled_from(("Yes", "No", "yes", "")),
    st.sampled_from(_COMMENTS).map(_quoted),
).map(",".join)
_sane_rows = st.builds(
    lambda number, name, comment: f'C{number},BIT,"{name}",0,No,"{comment}"',
    st.integers(1, 2000),
    st.sampled_from(("Start", "SystemRunning", "Other", "Scratch_C2000", "a b", "")),
    st.sampled_from(("", "a comment", "condition of main rung 3")),
)


def _joined(header: str, some: list[str], end: str, last: str) -> str:
    return end.join([header, *some]) + last


tables = st.builds(
    _joined,
    weighted((9, st.just(HEADER)), (1, st.sampled_from(("", HEADER.lower(), HEADER + ",More", "\ufeff" + HEADER)))),
    st.lists(weighted((3, _sane_rows), (1, rows)), max_size=6),
    weighted((5, st.just("\n")), (1, st.sampled_from(("\r\n", "\r", "\n\n")))),
    st.sampled_from(("\n", "", "\r\n")),
)


def _table_bytes(text: str) -> bytes:
    return text.encode("utf-8", "surrogatepass")


broken_tables = weighted(
    (4, tables.map(_table_bytes)),
    (3, st.builds(lambda text, todo: _table_bytes(changed(text, todo)), tables, changes)),
    (1, st.binary(max_size=200)),
    (1, st.text(max_size=80).map(_table_bytes)),
    (1, st.builds(lambda text, at, data: text.encode()[:at] + data + text.encode()[at:], tables, st.integers(0, 300),
                  st.binary(max_size=4))),
)  # fmt: skip
_with_table = weighted((2, whole_programs), (1, st.just(NAMED)))
table_builds = st.builds(given_files, _with_table, broken_tables)
