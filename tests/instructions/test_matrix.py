"""The operands of each instruction, cell by cell: legal ones build and read back, others have their code.

The tables in ``matrix/`` are written from docs/click-facts.md, independently of clickgen's Specs. The arguments of a
call are judged by the Spec itself: every instruction's faults name its signature.
"""

from __future__ import annotations

import ast
import re
import textwrap
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

import pytest
from judges.codec import assert_codec_reads
from judges.power import condition_of, read_ladder
from matrix import coils, conditions, conversions, copies, drums, formulas, modbus, packs, searches, timers
from matrix.notation import WARNINGS, Cell, Matrices

from clickgen.api import build
from clickgen.instructions import INSTRUCTIONS
from clickgen.instructions.spec import REQUIRED, ParamKind, Spec
from clickgen.problems.diagnostics import Diagnostic
from clickgen.results import BuildResult

MATRICES: Matrices = {
    **conditions.MATRICES,
    **coils.MATRICES,
    **timers.MATRICES,
    **drums.MATRICES,
    **copies.MATRICES,
    **conversions.MATRICES,
    **packs.MATRICES,
    **searches.MATRICES,
    **formulas.MATRICES,
    **modbus.MATRICES,
}

_HEAD = "@sub\ndef auto():\n    if True:\n        return\n\n\ndef main():\n"
_END = "    if True:\n        end()\n"
_FIRST_LINE = _HEAD.count("\n") + 1
_TOKENS_OF_A_FILE = 240
"""Below the 256 rungs of a ladder file, the last of which is the end."""
_SHOWN = 15
"""How many cells a failure shows."""

# -- cells ------------------------------------------------------------------------------------------------------------

each_matrix = pytest.mark.parametrize("name", MATRICES)


@each_matrix
def test_what_is_taken_builds_and_reads_back(name: str, tmp_path: Path) -> None:
    for cells in _files([cell for cell in MATRICES[name] if cell.builds]):
        result = _build(cells, tmp_path)
        _assert_codes(cells, result)
        ladder = result.files["main.csv"]
        assert_codec_reads(ladder)
        chosen = {str(row.address) for row in result.new_rows}
        tokens = iter([_without_choices(token, chosen) for token in _tokens(ladder)])
        wrong = []
        for cell in cells:
            found = tuple(next(tokens, "") for _ in cell.tokens)
            if found != cell.tokens:
                wrong.append(f"{_shown(cell)} should be {' '.join(cell.tokens)}, and is {' '.join(found)}")
        _assert_none(wrong, cells)
        assert list(tokens) == ["end()"]


@each_matrix
def test_what_is_refused_has_its_code(name: str, tmp_path: Path) -> None:
    cells = [cell for cell in MATRICES[name] if not cell.builds]
    if cells:
        _assert_codes(cells, _build(cells, tmp_path))


def _files(cells: Sequence[Cell]) -> Iterator[list[Cell]]:
    """Cells in files that CLICK takes; a rung has one token or more."""
    part: list[Cell] = []
    for cell in cells:
        if sum(len(other.tokens) for other in part) + len(cell.tokens) > _TOKENS_OF_A_FILE:
            yield part
            part = []
        part.append(cell)
    if part:
        yield part


def _build(cells: Sequence[Cell], folder: Path) -> BuildResult:
    program = folder / "prog.py"
    program.write_text(_HEAD + "".join(cell.source for cell in cells) + _END, "utf-8")
    return build(program)


def _problems(cells: Sequence[Cell], result: BuildResult) -> list[list[Diagnostic]]:
    """The problems of each cell; there are no others.

    A second look at the logic (CG5xx) is about whole programs. So is whether a text can run past TXT1000 (CG430): no
    cell has a rung that bounds the register of a pointer.
    """
    owners = [index for index, cell in enumerate(cells) for _ in range(cell.source.count("\n"))]
    found: list[list[Diagnostic]] = [[] for _ in cells]
    for problem in result.diagnostics:
        if problem.code.startswith("CG5") or problem.code == "CG430":
            continue
        assert problem.span, problem
        place = problem.span.line - _FIRST_LINE
        assert 0 <= place < len(owners), problem
        found[owners[place]].append(problem)
    return found


def _assert_codes(cells: Sequence[Cell], result: BuildResult) -> None:
    """Every cell has exactly its codes; if it is refused, warnings beside them do not count."""
    wrong = []
    for cell, found in zip(cells, _problems(cells, result), strict=True):
        expected = [code for code in cell.codes if cell.builds or code not in WARNINGS]
        kept = [problem for problem in found if cell.builds or problem.is_error]
        if Counter(problem.code for problem in kept) != Counter(expected):
            said = "".join(f"\n    {problem.code}: {problem.message}" for problem in kept)
            wrong.append(f"{_shown(cell)} should have {' '.join(expected) or 'no problem'}, and has{said or ' none'}")
    _assert_none(wrong, cells)


def _assert_none(wrong: list[str], cells: Sequence[Cell]) -> None:
    if wrong:
        pytest.fail(f"{len(wrong)} of {len(cells)} cells\n" + "\n".join(wrong[:_SHOWN]), pytrace=False)


def _tokens(ladder: str) -> Iterator[str]:
    """Contacts and outputs in reading order."""
    for rung in read_ladder(ladder):
        for row in rung.written:
            yield from filter(None, map(condition_of, row.cells))
            if row.af:
                yield row.af


def _without_choices(token: str, chosen: set[str]) -> str:
    """``C?`` for any C that clickgen chose."""
    return re.sub(r"\b([A-Z]+)\d+\b", lambda match: f"{match[1]}?" if match[0] in chosen else match[0], token)


def _shown(cell: Cell) -> str:
    return textwrap.shorten(cell.source, 160)


# -- arguments --------------------------------------------------------------------------------------------------------


class Call(NamedTuple):
    """A call with one fault: its code, and the words of the problem."""

    source: str
    code: str
    says: tuple[str, ...]


_ANY_VALUE = {
    ParamKind.OPERAND: "c[1]",
    ParamKind.FLAG: "False",
    ParamKind.UNIT: "Ts",
    ParamKind.PIN: "lambda: c[1]",
    ParamKind.OPTIONS: "None",
}
"""One of the kinds that an instruction can leave out."""

_WRONG_VALUES = {
    ParamKind.OPERANDS: ("5", "{c[1]}", "lambda: c[1]"),
    ParamKind.PATTERN: ("5", '"10"', "[[1, 2]]", "[5]", "c[1]"),
    ParamKind.TARGET: ('"192.168.1.10"', "5", "c[1]", "TcpTarget()"),
    ParamKind.REMOTE: ("5", "ds[1]", "lambda: ds[1]", "Address(address=1)"),
    ParamKind.FLAG: ("1", "0", '"True"', "c[1]", "lambda: True"),
    ParamKind.UNIT: ("5", '"Ts"', "ts", "Minutes", "c[1]"),
    ParamKind.PIN: ("c[1]", "True", "5", "lambda x: c[1]", '"c[1]"'),
    ParamKind.OPTIONS: ("5", "True", '"text"', "to_number", "ds[1]"),
    ParamKind.FORMULA: ("5", "ds[1]", "ds[1] + 1", 'f"{1}"', "lambda: ds[1]"),
    ParamKind.ROUTINE: ("5", "True", "c[1]", "auto()", "lambda: auto"),
    ParamKind.COMPARISON: ("5", '"=<"', '""', "c[1]", "eq"),
    ParamKind.TEXT: ("5", "None", "c[1]", 'f"{1}"', 'lambda: "a"'),
    ParamKind.TOKEN: ("5", "None", "out(c[1])", 'f"{1}"', 'b"out(C1)"'),
}
_NO_OPERANDS = ("True", "None", "lambda: c[1]", "[c[1]]", "(c[1], c[2])", "c[1] + 1", "Name", 'f"{1}"', "auto()")


def _given(spec: Spec) -> dict[str, str]:
    """Every parameter and a value for it: that of the Spec's example, if it has one."""
    call = ast.parse(spec.example, mode="eval").body
    assert isinstance(call, ast.Call)
    names = {alias: param.name for param in spec.params for alias in (param.name, *param.aliases)}
    positional = {param.name: ast.unparse(value) for param, value in zip(spec.params, call.args, strict=False)}
    keywords = {names[keyword.arg or ""]: ast.unparse(keyword.value) for keyword in call.keywords}
    return {param.name: _ANY_VALUE.get(param.kind, "") for param in spec.params} | positional | keywords


def _call(spec: Spec, values: dict[str, str], positional: int = 0, more: Sequence[str] = ()) -> str:
    arguments = [
        value if index < positional else f"{name}={value}" for index, (name, value) in enumerate(values.items())
    ]
    return f"{spec.name}({', '.join([*arguments, *more])})"


def _unknown(spec: Spec) -> Iterator[Call]:
    yield Call(_call(spec, _given(spec), more=["quite_unknown=1"]), "CG109", ("'quite_unknown'",))


def _near_miss(spec: Spec) -> Iterator[Call]:
    for param in spec.params:
        values = _given(spec)
        value = values.pop(param.name)
        miss = f"{param.name[:-1]}_{param.name[-1]}"
        yield Call(_call(spec, values, more=[f"{miss}={value}"]), "CG109", (f"{miss!r}", f"did you mean {param.name}?"))


def _missing(spec: Spec) -> Iterator[Call]:
    for param in spec.params:
        if param.default is REQUIRED:
            values = _given(spec)
            del values[param.name]
            yield Call(_call(spec, values), "CG110", (f"{param.name!r}",))


def _twice(spec: Spec) -> Iterator[Call]:
    for index, param in enumerate(spec.params):
        values = _given(spec)
        for name in (param.name, *param.aliases):
            again = f"{name}={values[param.name]}"
            yield Call(_call(spec, values, index + 1, [again]), "CG111", (f"{param.name!r} twice",))
            yield Call(_call(spec, values, index, [again]), "CG111", (f"{param.name!r} twice",))


def _too_many(spec: Spec) -> Iterator[Call]:
    values, count = _given(spec), len(spec.params)
    yield Call(_call(spec, {**values, "more": "c[1]"}, count + 1), "CG109", (f"no more than {count}",))
    yield Call(f"{spec.name}(*c[1])", "CG115", ("one by one",))
    yield Call(f"{spec.name}(**c[1])", "CG115", ("one by one",))


def _wrong_kind(spec: Spec) -> Iterator[Call]:
    for param in spec.params:
        if param.kind is not ParamKind.OPERAND:
            for value in _WRONG_VALUES[param.kind]:
                yield Call(_call(spec, {**_given(spec), param.name: value}), "CG115", ())


def _no_operand(spec: Spec) -> Iterator[Call]:
    for param in spec.params:
        if param.kind is ParamKind.OPERAND:
            for value in _NO_OPERANDS:
                # None leaves out an argument that may be left out.
                if value != "None" or param.default is not None:
                    yield Call(_call(spec, {**_given(spec), param.name: value}), "CG113", ())


_FAULTS: dict[str, Callable[[Spec], Iterator[Call]]] = {
    "an unknown keyword": _unknown,
    "a near miss": _near_miss,
    "a missing argument": _missing,
    "an argument twice": _twice,
    "too many arguments": _too_many,
    "a wrong kind": _wrong_kind,
    "no address": _no_operand,
}


@pytest.mark.parametrize("fault", _FAULTS)
@pytest.mark.parametrize("name", INSTRUCTIONS)
def test_a_fault_in_the_arguments_names_the_signature(name: str, fault: str, tmp_path: Path) -> None:
    spec = INSTRUCTIONS[name]
    calls = list(_FAULTS[fault](spec))
    cells = [Cell(f"    if c[1]:\n        {call.source}\n", (), (call.code,)) for call in calls]
    result = _build(cells, tmp_path)
    _assert_codes(cells, result)
    wrong = []
    for call, problems in zip(calls, _problems(cells, result), strict=True):
        words = (spec.signature, *call.says)
        said = "; ".join(f"{problem.message}: {problem.help}" for problem in problems if problem.is_error)
        wrong += [f"{call.source}\n    should say {word}, and says {said}" for word in words if word not in said]
    _assert_none(wrong, cells)
