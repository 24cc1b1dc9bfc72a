"""pyrung as outside machine: it reads a bundle that clickgen wrote and runs it scan by scan."""

from __future__ import annotations

import re
import runpy
import shutil
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from pyclickplc.addresses import parse_address
from pyrung import PLC
from pyrung.click import ladder_to_pyrung

Value = int | float | str


@dataclass(frozen=True)
class Spelling:
    """A spelling that pyrung does not read, or writes but does not run, and one that it takes for the same."""

    pattern: str
    readable: str | Callable[[re.Match[str]], str]
    reason: str
    action: str
    """An action of the language that is emitted in this way."""
    in_program: bool = False
    """True if it is in the Python that pyrung makes from the ladder, not in the ladder."""


SPELLINGS: tuple[Spelling, ...] = (
    Spelling(
        r"\b(A?SIN|A?COS|A?TAN|LOG|LN|SQRT|RAD|DEG|[LR]SH|[LR]RO) \(",
        r"\1(",
        "CLICK puts a space behind a function's name (click-facts [math.spaces])",
        'calc("SQRT(df[1])", df[2])',
    ),
    Spelling(
        r",termination_code=none\b",
        "",
        "all three settings are always written (click-facts [copy.to-text])",
        "copy(ds[1], txt[1], options=to_text())",
    ),
    Spelling(
        r"(?<=termination_code=)\$([0-9A-F]{2})",
        lambda code: str(int(code[1], 16)),
        "character codes are hexadecimal (click-facts [token.constants])",
        'copy(ds[1], txt[1], options=to_text(termination_code="$0D"))',
    ),
    Spelling(
        r"(?<=copy\(|fill\()\$([0-9A-F]{2})",
        lambda code: f'""{chr(int(code[1], 16))}""',
        "a character can be given by its code (click-facts [text.code])",
        'copy("$41", txt[1])',
    ),
    Spelling(
        r"\.select\((\d+), (\d+)\)",
        lambda ends: ends[0] if int(ends[1]) <= int(ends[2]) else f".select({ends[2]}, {ends[1]}).reverse()",
        "a range that falls shifts the other way (click-facts [shift.forms])",
        "shift(c[14:10:-1], clock=lambda: c[2], reset=lambda: c[3])",
        in_program=True,
    ),
    Spelling(
        r"(?m)(\.jump\(.*?, )(\w+\)(?=\.jog\(|$))",
        r"\1step=\2",
        "a jump names the register with its step (click-facts [drum.inputs])",
        "event_drum(outputs=[y[1]], events=[c[2], c[3]], pattern=[[1], [0]], current_step=ds[1], "
        "completion_flag=c[4], reset=lambda: c[5], jump=lambda: c[6], jump_step=ds[2])",
        in_program=True,
    ),
)
"""Spellings of CLICK that pyrung does not read, each with its reason."""

WHOLE_MAIN = "WholeMain"


class Simulator:
    """A PLC that holds the program of one bundle folder; each of its scans takes the same time.

    ``ends_return`` makes main a subroutine that the whole scan calls: pyrung has only the last end(), and a return()
    leaves a subroutine as an end() leaves main.
    """

    def __init__(
        self, folder: Path, ms: float, spellings: Sequence[Spelling] = SPELLINGS, ends_return: bool = False
    ) -> None:
        assert not list(folder.glob("main_*.csv")), "a main in several files is too long for a scenario"
        readable = folder.parent / "for_pyrung"
        shutil.copytree(folder, readable)
        if ends_return:
            _main_to_subroutine(readable)
        for ladder in (readable / "main.csv", *readable.glob("subroutines/*.csv")):
            _respell(ladder, [one for one in spellings if not one.in_program])
        script = readable / "program.py"
        ladder_to_pyrung(readable, nickname_csv=readable / "nicknames.csv", output_path=script)
        _respell(script, [one for one in spellings if one.in_program])
        self._code = runpy.run_path(str(script))
        slots = self._code["mapping"].mapped_slots()
        self._names: dict[str, str] = {slot.hardware_address: slot.logical_name for slot in slots}
        self._plc = PLC(self._code["logic"], dt=ms / 1000)

    def _name(self, address: str) -> str:
        """pyrung's name for an address: its own for system points and timers, perhaps a nickname for the others."""
        if address not in self._names:
            bank, number = parse_address(address)
            self._names[address] = self._code[bank.lower()][number].name
        return self._names[address]

    def set(self, values: Mapping[str, Value]) -> None:
        """Write to the memory before the next scan; an input keeps its value."""
        self._plc.patch({self._name(address): value for address, value in values.items()})

    def run(self, scans: int) -> None:
        self._plc.run(scans)

    def read(self, address: str) -> Value:
        """The value after the last scan."""
        value: Value | None = self._plc.current_state.tags.get(self._name(address))
        if value is None:  # nothing in the program mentions it
            return "" if address.startswith("TXT") else 0
        return "" if value == "\0" else value

    def power_up(self) -> None:
        """Do what a PLC does with its memory when it begins to run; pyrung does it on the way from STOP to RUN."""
        self._plc.stop()
        self._plc.run(0)


def _respell(path: Path, spellings: Sequence[Spelling]) -> None:
    text = path.read_text("utf-8")
    for spelling in spellings:
        text = re.sub(spelling.pattern, spelling.readable, text)
    path.write_text(text, "utf-8")


def _main_to_subroutine(folder: Path) -> None:
    main = (folder / "main.csv").read_text("utf-8")
    (folder / "subroutines").mkdir(exist_ok=True)
    (folder / "subroutines" / f"{WHOLE_MAIN}.csv").write_text(main.replace("end()", "return()"), "utf-8")
    header = main.splitlines()[0]
    wire = "R" + ",-" * 31
    call = f'{wire},"call(""{WHOLE_MAIN}"")"'
    (folder / "main.csv").write_text(f"{header}\n{call}\n{wire},end()\n", "utf-8")
