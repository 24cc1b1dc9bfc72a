"""Programs edited step by step, with names that clickgen places and needs for scratch cells."""

from __future__ import annotations

import random
from collections.abc import Iterator
from dataclasses import dataclass, field

from hypothesis import strategies as st

RUNGS: tuple[str, ...] = (
    "if {c0}:\n    out({c1})",
    "if all({c0}, nc({c1})):\n    set({c2})\n    if re({c1}):\n        copy({d0}, {d1})",
    'if {c0}:\n    calc("{d0} + {d1} * 2", {d2})',
    # Scratch bits: the condition is written before a box with pins looks at it again.
    "if all({c0}, nc({c1})):\n    set({c1})\n    rton({t0}, {d0}, unit=Ts, reset=lambda: {c2})",
    "if any({c0}, {c1}):\n    reset({c0})\n    ctu({k0}, 10, reset=lambda: all({c1}, {c2}))",
    # Formula pointers take scratch registers of several banks.
    'if {c0}:\n    calc("ds[{d0}] + dd[{d1}]", {d2})',
    'if {c0}:\n    math_hex("xd[0] AND dh[{d0}]", dh.Word{n})',
    "if {c0}:\n    rtof({t0}, {d0}, unit=Tm, reset=lambda: {c1})\nif {t0}:\n    out({c2})",
    "if {c0}:\n    copy_block(dd[900:903], ds.Block{n})",
    "if x[1]:\n    copy_fill({d0}, ds[{n}:{n2}])",
    "if c[{n}:{n2}]:\n    out(c.Whole{n})",
    'if {c0}:\n    copy("TEXT{n}", txt.Text{n})',
    "if " + "any({c0}, " + ", ".join(f"all(c[{1000 + 40 * k}:{1030 + 40 * k}], {{c1}})" for k in range(3)) + "):\n"
    "    out({c2})",
    "if all(td.Elapsed{n} > 3, {c0}):\n    out({c1})\nif {c2}:\n    ton(t.Elapsed{n}, 500)",
    "if x.Input{n}:\n    out(y.Output{n})",
    # The constant step of a jump takes a scratch register, legs at an input and changed conditions scratch bits.
    "if {c0}:\n    event_drum([{c1}, c.Lamp{n}], [{c2}, x[3]], [[1, 0], [0, 1]], ds.Step{n}, c.Done{n})"
    ".reset({c1}).jump({c2}, step=2)",
    "if {c0}:\n    set({c1})\n    time_drum([c.Lamp{n}], [5], Ts, [[1]], ds.Step{n}, td.Drum{n}, c.Done{n}, "
    "reset=lambda: any({c1}, {c2}), jog=lambda: {c1})",
    'if {c0}:\n    send(ModbusTcpTarget(ip="10.0.0.2"), "DS1", ds[{n}:{n2}], success={c1}, error={c2})',
    'if {c0}:\n    receive(ModbusRtuTarget(com_port="cpu2", device_id=5), ModbusAddress(address=400001), dd.Got{n}, '
    "exception_response={d0})",
    "if re({c0}):\n    ctud({k0}, 5).down({c1}).reset({c2}, nc({c0}))",
    "if {c0}:\n    copy({d0}.as_text(), txt.Number{n})\n    copy(txt.Number{n}.as_value(), {d1})",
    "if {c0}:\n    search(ds[{n}:{n2}] >= {d0}, result={d1}, found={c1})",
)
PLAIN, SCRATCH = range(3), (3, 4, 5, 7, 12, 15, 16)
"""Forms that need no scratch cells, and some that do."""
MESSAGES = tuple(form for form, text in enumerate(RUNGS) if "send(" in text or "receive(" in text)
"""Forms whose cells change in their own time, so every routine that looks at them keeps what it saw."""


@dataclass(frozen=True)
class Piece:
    """Some rungs of main: a form, the names in it, and a number that makes its own names unique."""

    form: int
    number: int
    bits: tuple[int, int, int]
    words: tuple[int, int, int]

    def text(self, renamed: dict[int, str]) -> str:
        number = self.number
        names: dict[str, object] = {"n": number, "n2": number + 3, "t0": f"t.Timer{number}", "k0": f"ct.Count{number}"}
        for place, bit in enumerate(self.bits):
            names[f"c{place}"] = f"c.{renamed.get(bit, f'Bit{bit}')}"
        for place, word in enumerate(self.words):
            names[f"d{place}"] = f"ds.Word_{word}"
        return RUNGS[self.form].format_map(names)


@dataclass
class Draft:
    """A program being edited; its subroutine may be in a file of its own."""

    pieces: list[Piece] = field(default_factory=list)
    routine: list[Piece] = field(default_factory=list)
    renamed: dict[int, str] = field(default_factory=dict)
    extra: list[str] = field(default_factory=list)
    is_apart: bool = False

    def texts(self) -> dict[str, str]:
        """The text of each file, main's first."""

        def body(pieces: list[Piece]) -> str:
            lines = "\n".join(piece.text(self.renamed) for piece in pieces).splitlines()
            return "".join(f"    {line}\n" for line in lines)

        declared = "".join(f"{line}\n" for line in self.extra)
        helper = f"\n@sub\ndef helper():\n{body(self.routine)}    if True:\n        return\n\n"
        main = f"def main():\n{body(self.pieces)}    if True:\n        call(helper)\n    if True:\n        end()\n"
        if self.is_apart:
            return {"prog.py": f"from parts import helper\n\n{declared}\n{main}", "parts.py": helper}
        return {"prog.py": declared + helper + main}


def numbers_from(first: int) -> Iterator[int]:
    """Numbers of pieces, each once."""
    return iter(range(first, first + 900))


_small = st.integers(0, 6)


@st.composite
def pieces(draw: st.DrawFn, numbers: Iterator[int]) -> Piece:
    bits = draw(st.lists(_small, min_size=3, max_size=3, unique=True))
    words = draw(st.lists(_small, min_size=3, max_size=3, unique=True))
    form = draw(st.integers(0, len(RUNGS) - 1))
    return Piece(form, next(numbers), (bits[0], bits[1], bits[2]), (words[0], words[1], words[2]))


def edit(data: st.DataObject, draft: Draft, numbers: Iterator[int]) -> None:
    """Change the draft in one place."""
    draw = data.draw
    part = draft.routine if draw(st.integers(0, 4)) == 0 else draft.pieces
    kind = draw(st.sampled_from(["insert", "insert", "remove", "swap", "rename", "declare", "double", "move"]))
    if kind == "move":
        draft.is_apart = not draft.is_apart
    elif kind == "insert" or (kind != "declare" and kind != "rename" and not part):
        part.insert(draw(st.integers(0, len(part))), draw(pieces(numbers)))
    elif kind == "remove":
        del part[draw(st.integers(0, len(part) - 1))]
    elif kind == "swap":
        one, other = draw(st.integers(0, len(part) - 1)), draw(st.integers(0, len(part) - 1))
        part[one], part[other] = part[other], part[one]
    elif kind == "rename":
        draft.renamed[draw(_small)] = f"Renamed{next(numbers)}"
    elif kind == "declare":
        number = next(numbers)
        draft.extra.append(f'nickname(ds.Declared{number}, ds[{4000 + number}], initial={number}, comment="d{number}")')
    else:
        # The same need a second time: its scratch cells have the same purpose.
        piece = part[draw(st.integers(0, len(part) - 1))]
        part.insert(draw(st.integers(0, len(part))), Piece(piece.form, next(numbers), piece.bits, piece.words))


def random_draft(seed: int) -> dict[str, str]:
    """The files of a program that depends only on the seed."""
    chance = random.Random(seed)

    def some(first: int) -> list[Piece]:
        found = []
        for number in range(first, first + 12):
            bits, words = chance.sample(range(7), 3), chance.sample(range(7), 3)
            form = chance.randrange(len(RUNGS))
            found.append(Piece(form, number, (bits[0], bits[1], bits[2]), (words[0], words[1], words[2])))
        return found

    return Draft(some(100), some(200), is_apart=seed % 2 == 1).texts()
