"""Builds given as files, starting with complete programs."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from hypothesis import strategies as st

from strategies.conditions import weighted
from strategies.meaning import meaning_programs
from strategies.one_rung import power_programs
from strategies.programs import PROGRAM
from strategies.shown import ShownAsText

TABLE = "nicknames.csv"
FIXTURES = Path(__file__).parents[2] / "fixtures"
CASES = sorted(FIXTURES.glob("cases/*/prog.py"), key=lambda path: (path.stat().st_size, path))
REJECTS = sorted((*FIXTURES.glob("reject/*.py"), *FIXTURES.glob("reject/*/prog.py")))
LARGE = 8000
"""Bytes of a program that is too long to be built a hundred times."""


@dataclass(frozen=True)
class Given(ShownAsText):
    """The files of a program, main's first, and perhaps the address table beside them."""

    files: tuple[tuple[str, bytes], ...]

    @property
    def text(self) -> str:
        """The text for people."""
        (_, first), *more = self.files
        shown = first.decode("utf-8", "backslashreplace")
        for name, data in more:
            text = repr(data) if name == TABLE else data.decode("utf-8", "backslashreplace")
            shown += f"\n# ---- {name}\n{text}"
        return shown


Texts = dict[str, str]
"""The text of each file, main's first."""


def given_files(texts: Texts, table: bytes | None = None) -> Given:
    files = [(name, text.encode("utf-8", "surrogatepass")) for name, text in texts.items()]
    return Given((*files, *(((TABLE, table),) if table is not None else ())))


def given_program(text: str | bytes) -> Given:
    return Given(((PROGRAM, text if isinstance(text, bytes) else text.encode("utf-8", "surrogatepass")),))


def case_texts(path: Path) -> Texts:
    """A golden case, or a program with a fault, with the files beside it."""
    if path.name != PROGRAM:
        return {PROGRAM: path.read_text("utf-8", "replace")}
    others = sorted(other for other in path.parent.glob("*.py") if other != path)
    return {file.name: file.read_text("utf-8", "replace") for file in (path, *others)}


WHOLE = [case_texts(path) for path in CASES if path.stat().st_size <= LARGE]
FAULTY = [case_texts(path) for path in REJECTS if path.stat().st_size <= LARGE]
whole_programs = st.sampled_from(range(len(WHOLE))).map(lambda index: WHOLE[index])
faulty_programs = st.sampled_from(range(len(FAULTY))).map(lambda index: FAULTY[index])
valid: st.SearchStrategy[Texts] = weighted(
    (4, whole_programs),
    (1, meaning_programs(large=False).map(lambda one: one.texts)),
    (2, power_programs().map(lambda one: one.texts)),
)
