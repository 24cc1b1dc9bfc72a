"""The IR as data: every class of the trees has a form, and comes back as it was."""

from __future__ import annotations

import dataclasses
import json
from typing import Any

import pytest

from clickgen.dialects.if_rungs.read.content import FileContent
from clickgen.dialects.if_rungs.read.program import read_file
from clickgen.instructions import INSTRUCTIONS
from clickgen.ir import conditions, data, formula_nodes, imports, modbus, operands, program
from clickgen.ir.data import FromData, NotData, to_data
from clickgen.problems.diagnostics import Diagnostics
from clickgen.text.source import SourceFile, Span

ROOMS = (conditions, formula_nodes, imports, modbus, operands, program)
WHOLE = {program.Program, program.Offer}
"""What a program is put together of: no part of a file."""


def content(text: str) -> tuple[SourceFile, FileContent]:
    source, problems = SourceFile("p.py", text), Diagnostics()
    found = read_file(source, problems)
    assert found is not None
    assert problems.found == []
    return source, found


def test_every_class_of_the_trees_has_a_form() -> None:
    found = {
        one
        for room in ROOMS
        for one in vars(room).values()
        if isinstance(one, type) and dataclasses.is_dataclass(one) and one.__module__ == room.__name__
    }
    assert found - WHOLE == {*data._CLASSES}


def same(value: Any, other: Any) -> bool:
    """Equality that looks into texts with places, too: two files are never equal."""
    if dataclasses.is_dataclass(value):
        names = [field.name for field in dataclasses.fields(value)]
        return type(value) is type(other) and all(same(getattr(value, n), getattr(other, n)) for n in names)
    if isinstance(value, dict):
        return list(value) == list(other) and all(same(value[key], other[key]) for key in value)
    if type(value) is tuple:
        return len(value) == len(other) and all(map(same, value, other))
    return type(value) is type(other) and bool(value == other)


EXTRA = (
    'nickname(ds.A, ds[5], initial=10, retentive=False, comment="a")',
    "nickname(ds.B, ds[10:15], initial=-3)",
    "nickname(df.C, df[5], initial=1.5)",
    "from other import one, two",
    "import wiring",
)
BODIES = (
    "if all(c.A, any(nc(c.B), re(c.D)), ds.A > 5, dh.B == 0x00FF, df.A < 1.5e3):\n        out(c.E)",
    'if x[1].immediate:\n        out(y[1].immediate)\n        copy("A\\x42\\tC", txt.A)\n        copy("$0D", txt.B)',
    'if c.A:\n        copy(ds[ds.P], ds.B)\n        copy("ab"\n            "cd", txt.C)\n        copy(ds.R[2], ds.C)',
    "if c.A:\n        for _ in range(ds.N):\n            if c.B:\n                out(c.D)",
    "if c.A:\n        copy_block(ds.Recipe[0:3], ds[100])\n        pass\n        return",
    'if c.A:\n        calc("-(ds.A + 2.5) * PI MOD SUM(ds[1:5]) + SQRT(ds[ds.P]) ^ 2", df.A)\n'
    '        math_hex("dh.A AND 0Fh OR NOT dh.B", dh.C)',
    'if c.A:\n        raw("raw(Velocity,0x2735,1,222d=0,607b=C1,607d=C2..C5,6083=DS[DS1],0000=)")',
)


@pytest.mark.parametrize(
    "text",
    [*EXTRA, *(f"def main():\n    {body}\n" for body in BODIES)]
    + [f"def main():\n    if c.A:\n        {spec.example}\n" for spec in INSTRUCTIONS.values()],
)
@pytest.mark.parametrize("base", [0, 3])
def test_a_file_comes_back_as_it_was(text: str, base: int) -> None:
    if "\n" not in text:
        text = f"{text}\n"
    source, found = content(text)
    written = [to_data(item, source, base) for item in found.items]
    assert written == json.loads(json.dumps(written))
    tree = FromData(source)
    assert same(tuple(tree(one, base) for one in written), found.items)


def test_what_moves_is_the_same_data() -> None:
    text = "def main():\n    if c.A:\n        copy('TEXT', txt.A)\n"
    source, found = content(text)
    moved, below = content(f"\n\n{text}")
    assert to_data(found.items[0], source, 0) == to_data(below.items[0], moved, 2)


@pytest.mark.parametrize("value", [object(), Span("other.py", 1, 1, 1, 1), {1}, b"", Span.of_cell("p.py", "IO", 1, 1)])
def test_what_has_no_form_is_refused(value: object) -> None:
    with pytest.raises(NotData):
        to_data((value,), SourceFile("p.py", ""), 0)


@pytest.mark.parametrize("value", [[9], [99], [3, "no_such_instruction"], [1, 1], [4, "a"], [10], ["x"], {}, 5, None])
def test_what_is_no_data_of_a_tree_is_refused(value: Any) -> None:
    with pytest.raises((ValueError, LookupError, TypeError)):
        FromData(SourceFile("p.py", ""))(value, 0)
