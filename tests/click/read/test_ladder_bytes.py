"""CLICK's own files are read as their bytes say, or refused; damaged files too.

The captures are laddercodec's own encodings; where CLICK itself writes otherwise, they are patched by hand
(harmless.py).
"""

from __future__ import annotations

import random
import re
import struct
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path

import budget
import laddercodec
import pytest
from judges.power import HEADER
from judges.program_files import program_file

from clickgen.cli import main
from clickgen.click.read.binary import read_clipboard, read_program
from clickgen.click.read.capture import cut
from clickgen.click.read.grid import Ladder
from clickgen.click.read.harmless import HARMLESS
from clickgen.click.read.program_file import read_rungs
from clickgen.click.read.rtf import left_out

WIDTH = 31
TARGET = 'ModbusRtuTarget(name="rtu",com_port="slot0_1",device_id=5)'
FLAGS = "receiving=C11,success=C12,error=C13,exception_response=DS100"
RECEIVE = f'receive(target={TARGET},remote_start="DS1",dest=DS1..DS5,{FLAGS})'
SEND = f'send(target={TARGET},remote_start="DS1",source=DS1..DS5,{FLAGS.replace("receiving", "sending")})'
EVENT_DRUM = (
    "event_drum(outputs=[Y001,C2],events=[C3,C4],pattern=[[1,0],[0,1]],current_step=DS1,completion_flag=C9)",
    ".reset()",
    ".jog()",
)
TIME_DRUM = (
    "time_drum(outputs=[Y001,C2],presets=[10,20],unit=Ts,pattern=[[1,0],[0,1]],current_step=DS1,accumulator=TD1,"
    "completion_flag=C9)",
    ".reset()",
)
RUNGS: list[tuple[str, ...]] = [
    ("out(Y001)",),
    ("out(C1,oneshot=1)",),
    ("latch(immediate(Y001..Y004))",),
    ("on_delay(T1,TD1,preset=5,unit=Ts)",),
    ("on_delay(T1,TD1,preset=DS5,unit=Th)", ".reset()"),
    ("count_up(CT1,CTD1,preset=5)", ".down()", ".reset()"),
    ("count_down(CT1,CTD1,preset=5)", ".reset()"),
    ("copy(DS1,TXT1,convert=to_text(suppress_zero=1,exponential=0,termination_code=none))",),
    ("blockcopy(TXT1..TXT4,DS1..DS4,convert=to_value)",),
    ("fill(0,DS1..DS5,oneshot=1)",),
    ("pack_bits(X001..X016,DH1)",),
    ("pack_words(DS1..DS2,DD1)",),
    ("pack_text(TXT1..TXT4,DS1,allow_whitespace=1)",),
    ("unpack_to_bits(DH1,Y001..Y016)",),
    ("unpack_to_words(DD1,DS1..DS2)",),
    ("shift(C1..C8)", ".clock()", ".reset()"),
    ("search(DS1..DS10 >= 5,result=DS20,found=C1,continuous=1)",),
    ("math(SUM ( DS1 : DS5 ) + 2,DS9,mode=decimal)",),
    ("for(DS1,oneshot=1)",),
    ('call("Heat")',),
    EVENT_DRUM,
    TIME_DRUM,
    (RECEIVE,),
    (SEND,),
]


def capture(folder: Path, *rungs: Sequence[str], comment: str = "") -> bytes:
    """Rungs of a contact and a box with its pins, each pin with a contact."""
    lines = []
    for tokens in rungs:
        lines += [f"#,{comment}"] if comment else []
        for number, token in enumerate(tokens):
            cells = [f"C{number + 21}", *["-"] * (WIDTH - 1), '"' + token.replace('"', '""') + '"']
            lines.append(",".join(["" if number else "R", *cells]))
    path = folder / "made.csv"
    path.write_text("\n".join([",".join(HEADER), *lines]) + "\n")
    return bytes(laddercodec.encode(laddercodec.read_csv(path)))


def tokens(ladder: Ladder) -> list[str]:
    assert not ladder.all_problems
    return [box.token for rung in ladder.rungs for box in rung.boxes]


def codes(ladder: Ladder) -> list[str]:
    return [problem.code for problem in ladder.all_problems]


def with_field(data: bytes, tag: int, old: str, new: str, count: int = 1) -> bytes:
    """A capture in which a field has another value of the same length, as often as it occurs."""
    before, after = (struct.pack("<HI", tag, 0xFFFFFFFF) + text.encode("utf-16-le") + b"\0\0" for text in (old, new))
    assert data.count(before) == count
    return data.replace(before, after)


@pytest.mark.parametrize("rung", RUNGS, ids=lambda rung: rung[0].split("(")[0])
def test_what_laddercodec_writes_is_read_and_proven(tmp_path: Path, rung: tuple[str, ...]) -> None:
    """Alone and among others, with their own words: pack_bits of X and unpack_to_bits of Y too."""
    assert tokens(read_clipboard(capture(tmp_path, rung), "x"))[0].split("(")[0] == rung[0].split("(")[0]
    ladder = read_clipboard(capture(tmp_path, ("out(C1)",), rung, ("end()",), comment="why"), "x")
    found = tokens(ladder)
    assert (found[0], found[-1], len(ladder.rungs)) == ("out(C1)", "end()", 3)
    assert found[1].split("(")[0] == rung[0].split("(")[0]


def test_all_of_them_in_one_capture(tmp_path: Path) -> None:
    ladder = read_clipboard(capture(tmp_path, *RUNGS), "x")
    assert (len(ladder.rungs), ladder.all_problems) == (len(RUNGS), ())
    assert tokens(read_clipboard(capture(tmp_path, *[("out(C1)",)] * 256), "x")) == ["out(C1)"] * 256


# Each is a code that laddercodec does not know, and what it takes it for.
UNKNOWN: list[tuple[str, tuple[str, ...], int, str, str]] = [
    ("a port as cpu2", (RECEIVE,), 0x220C, "4", "3"),
    ("a port as cpu2", (SEND,), 0x220C, "4", "9"),
    ("a Modbus function", (RECEIVE,), 0x2211, "2", "3"),
    ("a kind of address", (RECEIVE,), 0x320F, "2", "9"),
    ("a unit as milliseconds", TIME_DRUM, 0x21F9, "1", "7"),
    ("a kind of drum as a time drum", TIME_DRUM, 0x2200, "0", "2"),
    ("an off-delay", ("on_delay(T1,TD1,preset=5,unit=Ts)",), 0x21FA, "0", "7"),
    ("a retentive timer", ("on_delay(T1,TD1,preset=5,unit=Ts)",), 0x21FB, "0", "x"),
    ("a coil without a switch", ("out(Y001,oneshot=1)",), 0x3218, "8205", "8207"),
    ("a one-shot that is off", ("fill(0,DS1..DS5)",), 0x11F8, "0", "7"),
    ("a pack of words", ("pack_bits(C1..C16,DH1)",), 0x2206, "0", "2"),
    ("a continuous search", ("search(DS1..DS10 >= 5,result=DS20,found=C1)",), 0x1277, "0", "2"),
    ("the second address of a counter", ("count_up(CT1,CTD1,preset=5)", ".reset()"), 0x606D, "CT1", "CT2"),
    ("CLICK's own code", ("out(Y001)",), 0x3218, "8193", "8195"),
    ("CLICK's own code", ('call("Heat")',), 0x3218, "9221", "9223"),
    ("a second device", (RECEIVE,), 0x60B2, "5", "6"),
    ("an error that is not told", (RECEIVE,), 0x120B, "1", "0"),
    ("a register of the port", (RECEIVE,), 0x608D, "SD50", "SD51"),
    ("the formula that CLICK runs", ("math(DS1 + 2,DS9,mode=decimal)",), 0x6229, "@#+#H2", "@#-#H2"),
    ("the formula that CLICK shows", ("math(DS1 + 2,DS9,mode=decimal)",), 0x6228, "DS1 + 2", "DS1 - 2"),
]


@pytest.mark.parametrize(("name", "rung", "tag", "old", "new"), UNKNOWN, ids=[one[0] for one in UNKNOWN])
def test_a_code_that_is_taken_for_another_is_refused(
    tmp_path: Path, name: str, rung: tuple[str, ...], tag: int, old: str, new: str
) -> None:
    assert name
    data = with_field(capture(tmp_path, ("return()",), rung, ("return()",)), tag, old, new)
    ladder = read_clipboard(data, "x.bin")
    assert [len(one.problems) for one in ladder.rungs] == [0, 1, 0]
    [problem] = ladder.all_problems
    # A few codes that laddercodec itself does not take, and some that it cannot write again.
    assert problem.code in ("CG701", "CG708")
    if problem.code == "CG708":
        assert "is read" in problem.message or "cannot be compared" in problem.message
        assert not ladder.rungs[1].boxes


def test_an_import_names_the_rung_and_leaves_it_out(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    data = with_field(capture(tmp_path, ("out(C1)",), (RECEIVE,), ("end()",)), 0x220C, "4", "3")
    Path("plant.bin").write_bytes(data)
    assert main(["import", "plant.bin", "-o", "-"]) == 1
    told = capsys.readouterr()
    assert "error[CG708]" in told.err.replace("plant.bin: ", "") or "CG708" in told.err
    assert "main rung 2: row 1, column AF: RD has '3' in its field 220c (the port), and '0' is read" in told.err
    assert told.out == ""
    assert main(["import", "plant.bin", "-o", "-", "--keep-going"]) == 1
    told = capsys.readouterr()
    assert "not_imported(" in told.out
    assert "receive" not in told.out.replace("RD has", "")
    assert "2 of 3 rungs verified" in told.err
    Path("sound.bin").write_bytes(capture(tmp_path, ("out(C1)",), (RECEIVE,), ("end()",)))
    assert main(["diff", "plant.bin", "sound.bin"]) == 2
    assert "RD has '3' in its field 220c" in capsys.readouterr().err


# -- where CLICK writes otherwise -------------------------------------------------------------------------------------


def _call_number(data: bytes) -> bytes:
    return with_field(data, 0x3219, "0", "7")


def _nicknames_in_formula(data: bytes) -> bytes:
    data = with_field(data, 0x2224, "0", "1")
    old, new = ("DS1 + DS2".encode("utf-16-le"), "<A> + <B>".encode("utf-16-le"))
    marker = struct.pack("<HI", 0x6228, 0xFFFFFFFF)
    assert data.count(marker + old) == 1
    return data.replace(marker + old, marker + new)


def _switch_as_one(data: bytes) -> bytes:
    # One character less: CLICK's blob is that much shorter, and the end of the page gets two bytes more.
    before, after = (
        struct.pack("<HI", 0x11F8, 0xFFFFFFFF) + text.encode("utf-16-le") + b"\0\0" for text in ("-1", "1")
    )
    assert data.count(before) == 1
    return data.replace(before, after) + b"\0\0"


def _leftovers(data: bytes) -> bytes:
    """Fill the bytes in which CLICK leaves earlier contents, in the head of the file and in every cell."""
    changed = bytearray(data)
    changed[0x20:0x254] = bytes(range(256)) * 2 + bytes(0x254 - 0x20 - 512)
    at = 0x0A60
    changed[at + 0x0B : at + 0x0D] = b"\x9d\x0f"
    changed[at + 0x15] ^= 1
    return bytes(changed)


def _jog_without_jump(data: bytes) -> bytes:
    before, after = (struct.pack("<HI", 0x3A05, 3) + text.encode("utf-16-le") + b"\0\0" for text in ("8497", "8496"))
    assert data.count(before) == 1
    return data.replace(before, after)


NATIVE: list[tuple[tuple[str, ...], Callable[[bytes], bytes]]] = [
    (('call("Heat")',), _call_number),
    (("math(DS1 + DS2,DS9,mode=decimal)",), _nicknames_in_formula),
    (("fill(0,DS1..DS5,oneshot=1)",), _switch_as_one),
    (("out(C1)",), _leftovers),
    (EVENT_DRUM, _jog_without_jump),
]


@pytest.mark.parametrize(("rung", "change"), NATIVE, ids=[change.__name__ for _, change in NATIVE])
def test_what_click_writes_otherwise_and_means_the_same_is_kept(
    tmp_path: Path, rung: tuple[str, ...], change: Callable[[bytes], bytes]
) -> None:
    data = capture(tmp_path, rung)
    changed = change(data)
    assert changed != data
    changed = changed[: len(changed) // 4096 * 4096]
    assert tokens(read_clipboard(changed, "x")) == tokens(read_clipboard(data, "x"))


def test_the_numbers_inside_a_sum_are_kept_and_no_others(tmp_path: Path) -> None:
    data = capture(tmp_path, ("math(SUM ( DS1 : DS4 ),DS9,mode=decimal)",))

    def listed(*inside: str) -> bytes:
        changed = data
        for number, address in enumerate(inside):
            empty = struct.pack("<HI", 0x688C, number) + b"\0\0"
            assert changed.count(empty) == 1
            changed = changed.replace(empty, empty[:-2] + address.encode("utf-16-le") + b"\0\0")
        return changed[: len(changed) // 4096 * 4096]

    assert tokens(read_clipboard(listed("DS2", "DS3"), "x")) == tokens(read_clipboard(data, "x"))
    for wrong in (("DS2", "DS4"), ("DS3", "DS2"), ("DS2", "DS3", "DS5")):
        assert codes(read_clipboard(listed(*wrong), "x")) == ["CG708"]


def test_every_harmless_difference_has_its_reason() -> None:
    assert all(entry.reason and entry.classes for entry in HARMLESS)
    places = [(name, entry.tag) for entry in HARMLESS for name in entry.classes]
    assert len(places) == len(set(places))


# -- damage -----------------------------------------------------------------------------------------------------------


def _shown(ladder: Ladder) -> str:
    """The result of reading, without the places in it."""
    shapes = [
        ([(row.squares, row.output) for row in rung.rows], [(box.token, box.pins) for box in rung.boxes])
        for rung in ladder.rungs
    ]
    return re.sub(r"Span\([^)]*\)", "", repr(shapes))


def _is_silent(ladder: Ladder) -> bool:
    return not ladder.all_problems and not any(rung.notes for rung in ladder.rungs)


def _wires_and_instructions(data: bytes) -> object:
    """The parts of a capture that count."""
    return [
        [[(cell.header.right, cell.header.down, cell.blob) for cell in row] for row in rung.rows]
        for rung in cut(data).rungs
    ]


def _damaged(data: bytes, places: Iterable[int], bits: Sequence[int]) -> Iterator[tuple[str, bytes]]:
    for place in places:
        for bit in bits:
            yield f"{place:#x}, bit {bit}", data[:place] + bytes((data[place] ^ 1 << bit,)) + data[place + 1 :]


@pytest.mark.property
@pytest.mark.parametrize("rung", [RUNGS[0], RUNGS[3], RUNGS[7], ("copy(X001,C1)",)], ids=lambda rung: rung[0])
def test_a_damaged_byte_of_a_capture_is_told_or_read_as_what_it_says(tmp_path: Path, rung: tuple[str, ...]) -> None:
    """It is read differently without a problem only if it says something else."""
    data = capture(tmp_path, ("out(C7)",), rung, comment="A word")
    sound, said = _shown(read_clipboard(data, "x")), _wires_and_instructions(data)
    source = random.Random(rung[0])
    places = sorted(source.sample(range(0x250, len(data.rstrip(b"\0"))), 250))
    for where, damaged in _damaged(data, budget.some(places, 4), [source.randrange(8)]):
        ladder = read_clipboard(damaged, "x")
        if _is_silent(ladder):
            assert (_shown(ladder) == sound) == (_wires_and_instructions(damaged) == said), where


@pytest.mark.property
def test_a_damaged_byte_of_a_program_file_is_told_or_read_as_what_it_says() -> None:
    rows = [["X001", *["-"] * 30, "out(C1)"], ["~X002", *["-"] * 30, 'call("Heat")']]
    data = program_file("Heat", 2, [("A word", rows[:1]), ("", rows[1:]), ("", [["-"] * 31 + ["return()"]])])
    sound = _shown(read_program(data, "x"))
    said = [(rung.rights, rung.downs, rung.placed) for rung in read_rungs(data)]
    for where, damaged in _damaged(data, budget.some(range(0x40, len(data)), 5), (0, 3, 6)):
        ladder = read_program(damaged, "x")
        if _is_silent(ladder):
            says = [(rung.rights, rung.downs, rung.placed) for rung in read_rungs(damaged)]
            assert (_shown(ladder) == sound) == (says == said), where


@pytest.mark.parametrize(
    ("comment", "expected"),
    [
        (rb"{\rtf1\ansi\ansicpg1252\fs20 plain\b  bold\b0\par {\i x}\tab \{ \\ \}\'e9\u8211?}", []),
        (rb"{\rtf1\fs20 a\cf1 red\cf0 }", [r"\cf1", r"\cf0"]),
        (rb"{\rtf1\fs20 a\f0\fs20 b\f1 c}", [r"\f1"]),
        (rb"{\rtf1\fs20 a\'zz b\'81}", [r"\'zz", r"\'81"]),
        (rb"{\rtf1\fs20 {\*\generator x;}a\bullet }", [r"\*", r"\generator", r"\bullet"]),
    ],
)
def test_what_is_left_out_of_a_comment(comment: bytes, expected: list[str]) -> None:
    assert left_out(comment) == expected


def test_a_comment_with_other_marks_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    data = capture(tmp_path, ("end()",), comment="A word in red")
    Path("x.bin").write_bytes(data.replace(rb"\fs20 A word", rb"\fs20 \cf1 w"))
    assert main(["import", "x.bin", "-o", "-"]) == 0
    told = capsys.readouterr()
    assert "CG709" in told.err
    assert r"\cf1" in told.err
    assert "1 of 1 rung verified" in told.err


# -- rungs that laddercodec cannot read -------------------------------------------------------------------------------


@pytest.mark.parametrize("token", ["copy(DS1,DS2)", "on_delay(T1,TD1,preset=5,unit=Ts)"])
def test_a_full_rung_before_a_box_is_a_limit_and_no_damage(
    token: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """findings/laddercodec-31-contacts.sh"""
    monkeypatch.chdir(tmp_path)
    lines = [",".join(HEADER), ",".join(["R", *(f"C{n}" for n in range(1, 32)), f'"{token}"']), "," * 32]
    Path("rung.csv").write_text("\n".join(lines) + "\n")
    data = bytes(laddercodec.encode(laddercodec.read_csv(Path("rung.csv"))))
    Path("saved.bin").write_bytes(data)
    assert main(["import", "saved.bin", "-o", "prog.py"]) == 1
    said = capsys.readouterr().err
    assert "CG710" in said
    assert "laddercodec 0.2.2 cannot decode 31 contacts" in said
    assert "mend the file" not in said
    # A capture that is cut off is still damaged.
    Path("saved.bin").write_bytes(data[: len(data) // 2])
    assert main(["import", "saved.bin", "-o", "prog.py"]) == 1
    assert "CG701" in capsys.readouterr().err
