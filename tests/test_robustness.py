"""Whatever stands in the files, a build says what is wrong or builds what outside readers take."""

from __future__ import annotations

import contextlib
import gc
import io
import keyword
import re
import tempfile
from dataclasses import dataclass
from pathlib import Path

import pytest
from hypothesis import given, note, settings
from hypothesis import strategies as st
from judges.codec import assert_codec_reads
from judges.power import check_limits, check_no_backfeed, read_ladder
from strategies import meaning_programs, power_programs, weighted

import clickgen
import clickgen.cli
from clickgen.codes import CODES

CASES = sorted(
    (Path(__file__).parents[1] / "fixtures").glob("cases/*/prog.py"), key=lambda path: (path.stat().st_size, path)
)
PROGRAMS = [path.read_text("utf-8") for path in CASES]
NAMED = next(text for path, text in zip(CASES, PROGRAMS, strict=True) if path.parent.name == "demo")


@dataclass(frozen=True)
class Given:
    """A program and the address table beside it, as bytes."""

    program: bytes
    table: bytes | None = None

    @property
    def text(self) -> str:
        shown = self.program.decode("utf-8", "backslashreplace")
        return shown if self.table is None else f"{shown}\n--- nicknames.csv\n{self.table!r}"


def check_build(given: Given, codec: bool = True) -> None:
    """Build through the API and through the command line, and judge all that comes out."""
    with tempfile.TemporaryDirectory(prefix="clickgen-robust-") as name:
        folder = Path(name)
        program, table, out = folder / "prog.py", folder / "nicknames.csv", folder / "out"
        program.write_bytes(given.program)
        if given.table is not None:
            table.write_bytes(given.table)
        before = contents(folder)
        try:
            result = clickgen.build(program)
        except clickgen.CouldNotRun:
            expected = 2
        else:
            expected = 0 if result.ok else 1
            check_diagnostics(result, {str(program): given.program, str(table): given.table or b""})
        assert contents(folder) == before, "clickgen.build wrote something"

        code = command_line(program, out)
        assert code == expected, f"exit code {code}, and clickgen.build means {expected}"
        if code:
            assert contents(folder) == before, f"exit code {code}, and something was written"
            return
        check_outputs(out, codec)
        built = contents(folder)
        assert command_line(program, out, "--frozen") == 0, "the same again with --frozen is refused"
        assert contents(folder) == built, "the same again with --frozen writes something else"


def contents(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def command_line(program: Path, out: Path, *more: str) -> int:
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()) as errors:
        code = clickgen.cli.main(["build", str(program), "-o", str(out), *more])
    gc.enable()  # the command line turns it off
    assert code in (0, 1, 2), f"exit code {code}"
    assert code == 0 or errors.getvalue(), f"exit code {code} without a word"
    assert "Traceback" not in errors.getvalue()
    return code


def check_diagnostics(result: clickgen.BuildResult, files: dict[str, bytes]) -> None:
    lines = {}
    for path, data in files.items():
        text = data.decode("utf-8-sig", "replace")
        lines[path] = text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
    for problem in result.diagnostics:
        assert problem.code in CODES
        assert problem.message
        assert problem.span is not None, f"{problem.code} has no place"
        for span in (problem.span, *(label.span for label in problem.labels)):
            where = f"{problem.code} at {span!r}"
            assert span.path in lines, where
            there = lines[span.path]
            assert 1 <= span.line <= span.end_line <= len(there), f"{where}: the file has {len(there)} lines"
            assert 1 <= span.col <= len(there[span.line - 1]) + 1, f"{where}: the line is {there[span.line - 1]!r}"
            assert (span.line, span.col) < (span.end_line, span.end_col), f"{where} is empty"


def check_outputs(out: Path, codec: bool) -> None:
    """Outside readers take every ladder file."""
    for path in (*out.glob("main*.csv"), *out.glob("subroutines/*.csv")):
        text = path.read_bytes().decode("utf-8")
        rungs = read_ladder(text)
        check_limits(rungs)
        for rung in rungs:
            check_no_backfeed(rung, max_vars=5)
        if codec:
            assert_codec_reads(text)


# ---------------------------------------------------------------------------------------------------- broken programs


def split(text: str) -> list[str]:
    return text.split()


_WORDS = split(
    """
    and or not if elif else for in while def return lambda pass import from as with class global None True False _
    all any nc re fe out set reset copy copy_block copy_fill copy_pack copy_unpack shift search calc math_hex ton
    tof rton rtof ctu ctd ctud call end next_loop nickname range main sub oneshot one_shot unit setpoint options
    to_text immediate x y c t ct sc ds dd dh df xd yd td ctd sd txt Ts Tms other Motor con
    """
)
_NUMBERS = split(
    """
    0 1 2 8 9 16 17 20 21 816 817 2000 2001 4500 32767 32768 -1 2147483648 99999999999999999999 1e999 1.5 1j 0x10
    0xFFFFF 0b1 0o17 1_000 007
    """
)
_SIGNS = [
    *split("( ) [ ] { } : , . ; = == != < <= > >= + - * / ** ^ & | ~ @ := -> ... # `"),
    "\\",
    "'",
    '"',
    '"""',
    "\\\n",
]
_ODD = [
    "é",
    "ß",
    "\N{GREEK SMALL LETTER ALPHA}",
    "\N{FULLWIDTH LATIN SMALL LETTER C}",
    "\u2028",
    "\u00a0",
    "\ufeff",
    "\x00",
    "\x0c",
    "\x1b[31m",
    "\t",
]
_ODD += ["\r", "\r\n", "\n", "\x7f", "\U0001f600", "e\u0301", "\ud800", "\x85", " ", "    "]
_TEXTS = [
    '"A"',
    '""',
    '"$0D"',
    '"0u"',
    "'it''s'",
    'f"{c}"',
    'b"A"',
    '"ds.A + 1"',
    '"((((((((((1))))))))))"',
    '"dh[1] AND 0x1"',
]
_TEXTS += [
    '"_1st_SCAN"',
    '"SUM(ds[1:5])"',
    '"\\N{BULLET}"',
    '"\\x41"',
    'r"\\"',
    '"""\n"""',
    '"a" "b"',
    '"ds[ds[1]] / 0"',
]
PIECES = [*_WORDS, *_NUMBERS, *_SIGNS, *_ODD, *_TEXTS]
_TOKEN = re.compile(r"[A-Za-z_]\w*|\d+|\n *|[^\w\s]|\s|\w")

_ALIKE = {
    "word": [word for word in _WORDS if not keyword.iskeyword(word)],
    "number": _NUMBERS,
    "sign": ["==", "!=", "<", ">=", ":", ",", ".", "+", "-", "*"],
}


def _kind(token: str) -> str:
    if token.isidentifier():
        return "" if keyword.iskeyword(token) else "word"
    if token.isdigit():
        return "number"
    return "sign" if token in _ALIKE["sign"] else ""


Change = tuple[str, int, str]
TOKEN_CHANGES = ("alike", "replace", "delete", "twice", "swap", "insert", "nest")
LINE_CHANGES = ("drop line", "double line", "indent", "dedent", "swap lines")
changes = st.lists(
    st.tuples(
        weighted((6, st.just("alike")), (3, st.sampled_from(TOKEN_CHANGES)), (1, st.sampled_from(LINE_CHANGES))),
        st.integers(0, 2**16),
        st.sampled_from(PIECES),
    ),
    min_size=1,
    max_size=4,
)


def changed(text: str, todo: list[Change]) -> str:
    for kind, number, piece in todo:
        is_token = kind in TOKEN_CHANGES
        parts = _TOKEN.findall(text) if is_token else text.split("\n")
        if not parts:
            return piece
        at = number % len(parts)
        one = parts[at]
        if kind == "alike":
            # The next token of the same kind, so that what comes out is mostly Python still.
            alike = [index for index, part in enumerate(parts) if _kind(part)]
            if alike:
                at = alike[number % len(alike)]
                others = [*_ALIKE[_kind(parts[at])], *(part for part in parts if _kind(part) == _kind(parts[at]))]
                parts[at] = others[(number + len(piece)) % len(others)]
        elif kind == "replace":
            parts[at] = piece
        elif kind in ("delete", "drop line"):
            del parts[at]
        elif kind in ("twice", "double line"):
            parts.insert(at, one)
        elif kind in ("swap", "swap lines"):
            other = number // 7 % len(parts)
            parts[at], parts[other] = parts[other], one
        elif kind == "insert":
            parts.insert(at, piece)
        elif kind == "nest":
            parts[at] = f"{piece}({one})"
        elif kind == "indent":
            parts[at] = "    " + one
        else:
            parts[at] = one.removeprefix("  ")
        text = ("" if is_token else "\n").join(parts)
    return text


def as_file(text: str, table: bytes | None = None) -> Given:
    return Given(text.encode("utf-8", "surrogatepass"), table)


whole_programs = st.sampled_from(range(len(PROGRAMS))).map(lambda index: PROGRAMS[index])
valid = weighted(
    (4, whole_programs),
    (1, meaning_programs(large=False).map(lambda one: one.text)),
    (1, power_programs().map(lambda one: one.text)),
)


def _expressions() -> st.SearchStrategy[str]:
    """Python expressions of the language's words, most of them without sense."""
    banks = st.sampled_from(split("x y c t ct sc ds dd dh df xd yd td ctd sd txt foo"))
    words = st.sampled_from(split("all any nc re fe out to_text to_value range foo"))
    operators = st.sampled_from(split("== != < <= > >= and or & | + - in is"))
    signs = st.sampled_from(["not", "-", "lambda:", "lambda a:", "+"])
    names = st.sampled_from(["A", "B", "immediate", "Motor", "_x", "name_" * 6, "and_"])
    known = st.builds("{}[{}]".format, banks, st.integers(1, 20))
    named = st.builds("{}.{}".format, banks, names)
    number = st.sampled_from([one for one in _NUMBERS if one != "007"])
    plain = weighted((4, known), (1, named), (1, number), (1, st.sampled_from(_PLAIN)))
    tree = plain
    for _ in range(3):
        some = st.lists(tree, max_size=3).map(", ".join)
        tree = weighted(
            (4, plain),
            (4, st.builds("{}({})".format, words, some)),
            (1, st.builds("{}[{}]".format, banks, tree)),
            (1, st.builds("{}[{}:{}]".format, banks, tree, tree)),
            (1, st.builds("{}.{}".format, known, names)),
            (1, st.builds("{} {} {}".format, tree, operators, tree)),
            (1, st.builds("({} {})".format, signs, tree)),
        )
    return tree


_PLAIN = ["True", "None", "Ts", "foo", "...", *(one for one in _TEXTS if one[0] in "\"'" and "\n" not in one)]
_INSTRUCTIONS = split(
    """
    out set reset copy copy_block copy_fill copy_pack copy_unpack shift search calc math_hex ton tof rton rtof ctu
    ctd ctud call end next_loop nickname pass send event_drum
    """
)
_KEYWORDS = split(
    """
    oneshot one_shot unit setpoint options reset clock count_down source destination initial comment retentive
    formula continuous value start end result flag range
    """
)


@st.composite
def sound_python(draw: st.DrawFn) -> Given:
    """Programs that Python reads: instructions with arguments of any kind, rungs in rungs, loops, declarations."""
    expression = _expressions()
    pins = expression.map("lambda: {}".format)

    def call() -> str:
        arguments = draw(st.lists(expression, max_size=3))
        named = draw(st.dictionaries(st.sampled_from(_KEYWORDS), st.one_of(expression, pins), max_size=2))
        arguments += [f"{name}={value}" for name, value in named.items()]
        return f"{draw(st.sampled_from(_INSTRUCTIONS))}({', '.join(arguments)})"

    def block(depth: int) -> list[str]:
        lines: list[str] = []
        for _ in range(draw(st.integers(1, 3))):
            kind = draw(st.integers(0, 7)) if depth < 4 else 0
            if kind < 4:
                lines.append(call())
            elif kind < 6:
                lines += [f"if {draw(expression)}:", *("    " + line for line in block(depth + 1))]
            elif kind == 6:
                lines += [f"for _ in range({draw(expression)}):", *("    " + line for line in block(depth + 1))]
            else:
                lines.append(
                    draw(st.sampled_from(("return", "pass", "return 1", "x = 1", "if True: out(c[1])", "# note")))
                )
        return [*lines, "pass"] if lines[-1].startswith("#") else lines

    text = (
        "" if draw(st.booleans()) else f"nickname({draw(expression)}, {draw(expression)}, initial={draw(expression)})\n"
    )
    for head in ("def main():", "@sub\ndef other():")[: draw(st.integers(1, 2))]:
        text += "\n".join((head, *("    " + line for line in ("if True:", *("    " + one for one in block(0)))))) + "\n"
        text += "    if True:\n        " + ("end()" if "main" in head else "return") + "\n"
    return as_file(text)


broken_programs = st.builds(lambda text, todo: as_file(changed(text, todo)), valid, changes)
_salad = st.lists(st.sampled_from(PIECES), max_size=40).map(" ".join)
random_programs = st.one_of(
    sound_python(),
    sound_python(),
    sound_python(),
    st.binary(max_size=200).map(Given),
    st.text(max_size=100).map(as_file),
    _salad.map(as_file),
    _salad.map(lambda text: as_file(f"def main():\n    if {text}:\n        out(c[1])\n    if True:\n        end()\n")),
    _salad.map(lambda text: as_file(f"def main():\n    if True:\n        {text}\n    if True:\n        end()\n")),
    st.builds(
        lambda text, at, data: Given(text.encode()[:at] + data + text.encode()[at:]),
        whole_programs,
        st.integers(0, 500),
        st.binary(max_size=4),
    ),
)


@given(broken_programs)
@settings(max_examples=200, deadline=None, print_blob=True)
def test_a_broken_program_is_told_or_builds(files: Given) -> None:
    note(files.text)
    check_build(files)


@given(random_programs)
@settings(max_examples=150, deadline=None, print_blob=True)
def test_anything_can_stand_in_a_program(files: Given) -> None:
    note(files.text)
    check_build(files)


@pytest.mark.parametrize("start", [b"", b"\xef\xbb\xbf", b"a\n", b"\xef\xbb\xbfa\n\n", b"a\r", b"a\r\n", b"\xc3\xa9"])
@pytest.mark.parametrize("byte", [b"\x80", b"\xff"])
def test_the_byte_that_is_no_text_is_named_in_its_place(start: bytes, byte: bytes, tmp_path: Path) -> None:
    """Line and column count from the first character: behind a byte order mark, and whatever ends the lines."""
    path = tmp_path / "prog.py"
    path.write_bytes(start + byte + b"\n")
    [problem] = clickgen.build(path).diagnostics
    before = start.decode("utf-8-sig").replace("\r\n", "\n").replace("\r", "\n").split("\n")
    assert problem.span is not None
    assert (problem.code, problem.span.line, problem.span.col) == ("CG101", len(before), len(before[-1]) + 1)
    assert f"0x{byte[0]:02X}" in problem.message


@pytest.mark.parametrize("path", CASES, ids=lambda path: path.parent.name)
def test_the_programs_to_break_are_whole(path: Path) -> None:
    check_build(Given(path.read_bytes()))


# ---------------------------------------------------------------------------------------------------- broken tables

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
table_builds = st.builds(lambda text, table: as_file(text, table), _with_table, broken_tables)


@given(table_builds)
@settings(max_examples=150, deadline=None, print_blob=True)
def test_anything_can_stand_in_the_address_table(files: Given) -> None:
    note(files.text)
    check_build(files, codec=False)


ROBUSTNESS = {
    "broken programs": (broken_programs, check_build),
    "random programs": (random_programs, check_build),
    "tables": (table_builds, lambda one: check_build(one, codec=False)),
}
"""Each property with its examples, for ``fuzz.py``."""
