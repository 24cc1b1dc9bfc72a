"""The examples of the pages as whole programs, and the ladder that CLICK gets from them."""

from __future__ import annotations

import ast
import csv
import io
import tempfile
import textwrap
from pathlib import Path

import clickgen
from clickgen.instructions.control import CALL, END, FOR, NEXT, RETURN
from clickgen.instructions.data import SEARCH, SEARCH_RANGE
from clickgen.instructions.spec import Spec

_END = "    if True:\n        end()\n"
_PROGRAMS = {
    "program": "{}",
    "rung": "def main():\n{}\n" + _END,
    "actions": "def main():\n    if sc[1]:\n{}\n" + _END,
    "top": "{}\n\ndef main():\n" + _END,
    "table": "def main():\n" + _END,
}
"""The program for an example of each kind."""
KINDS = tuple(_PROGRAMS)
_INDENTS = {"rung": 4, "actions": 8}


def program_of(kind: str, text: str) -> str:
    """Return the whole program for an example."""
    return _PROGRAMS[kind].format(textwrap.indent(text, " " * _INDENTS.get(kind, 0)))


def built(kind: str, text: str) -> tuple[tuple[str, ...], str]:
    """The codes of an example's problems, and the output cells of its ladder, one to a line."""
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "prog.py"
        program.write_text(program_of(kind, text), "utf-8")
        result = clickgen.build(program)
    ladders = [text for name, text in result.files.items() if name == "main.csv" or name.startswith("subroutines/")]
    cells = [row[-1] for ladder in ladders for row in list(csv.reader(io.StringIO(ladder)))[1:] if row[0] != "#"]
    tokens = [cell for cell in cells if cell]
    codes = {problem.code for problem in result.diagnostics}
    return tuple(sorted(codes)), "\n".join(tokens if kind == "program" else tokens[:-1])


# -- the example of a Spec --------------------------------------------------------------------------------------------

_CALLED = f"""\
def main():
    if c.Auto:
        {CALL.example}

    if True:
        {END.example}


@sub
def auto_mode():
    if True:
        {RETURN.example}
"""
_HEAD, _, _BODY = FOR.example.partition(": ")
_LOOP = f"""\
if c.Repeat:
    {_HEAD}:
        {_BODY}

if True:
    calc("ds.Row + 1", ds.Row)

if True:
    {NEXT.example}
"""
_LARGER = {
    **{spec.name: ("program", _CALLED) for spec in (CALL, RETURN)},
    **{spec.name: ("rung", _LOOP) for spec in (FOR, NEXT)},
}
"""The kind and text of an example for a Spec whose own means nothing without another instruction."""
_WIDTH = 100


def examples(spec: Spec) -> tuple[str, list[str]]:
    """The kind of an instruction's example, and its text in every form that the instruction has."""
    if spec.name in _LARGER:
        kind, text = _LARGER[spec.name]
        return kind, [text]
    statement = ast.parse(spec.example).body[0]
    if not isinstance(statement, ast.Expr) or not isinstance(statement.value, ast.Call):
        return "actions", [spec.example]
    call = statement.value
    forms = [_broken(spec.name, [_source(spec, node) for node in (*call.args, *call.keywords)])]
    if spec.pins:
        forms.append(_chained(spec, call))
    if spec is SEARCH:
        forms.append(SEARCH_RANGE.example)
    return "actions", forms


def _source(spec: Spec, node: ast.AST) -> str:
    return ast.get_source_segment(spec.example, node) or ""


def _chained(spec: Spec, call: ast.Call) -> str:
    """Return the example with its inputs after it: ``jump=lambda: c.A, jump_step=2`` as ``.jump(c.A, step=2)``."""
    words = {word.arg: word.value for word in call.keywords}
    chain = ""
    for method, pin in spec.methods.items():
        condition = words.pop(pin.name, None)
        if isinstance(condition, ast.Lambda):
            own = [param for param in spec.params if param.of_pin == pin.name and param.name in words]
            settings = [f"{param.chained}={_source(spec, words.pop(param.name))}" for param in own]
            chain += f".{method}({', '.join([_source(spec, condition.body), *settings])})"
    others = [_source(spec, word) for word in call.keywords if word.arg in words]
    return _broken(spec.name, [*(_source(spec, node) for node in call.args), *others]) + chain


def _broken(name: str, arguments: list[str]) -> str:
    """A call; a long one has each argument on a line of its own."""
    line = f"{name}({', '.join(arguments)})"
    return line if len(line) <= _WIDTH else "\n".join([f"{name}(", *(f"    {text}," for text in arguments), ")"])
