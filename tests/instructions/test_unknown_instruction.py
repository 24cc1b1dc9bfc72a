"""An instruction that no file knows: its Spec alone takes it through every rule, output and command."""

from __future__ import annotations

import ast
import importlib
import textwrap
from collections.abc import Iterable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from docs_instruction import instruction_page
from test_examples import program_of
from unknown import CLEAR, HALT, UNKNOWN

import clickgen
import docs
from clickgen.api import check
from clickgen.cli import main
from clickgen.click.draw.tokens import action_token
from clickgen.click.read.tokens import action_of, specs_of
from clickgen.commands.explain import instructions
from clickgen.commands.stubs.stub import builtins_stub
from clickgen.instructions import FAMILIES, added, copies, every
from clickgen.instructions.spec import Spec, Variant
from clickgen.ir.conditions import Always
from clickgen.problems.declared import Code
from clickgen.problems.diagnostics import Diagnostic
from clickgen.rules.registry import Folder, rules
from clickgen.text.source import Span

PACKAGE = Path(clickgen.__file__).parent

HERE = Span("", 1, 1, 1, 2)

each = pytest.mark.parametrize("spec", UNKNOWN, ids=lambda spec: spec.name)


@pytest.fixture(autouse=True)
def _with_unknown_instructions(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(copies, "SPECS", (*copies.SPECS, *UNKNOWN))
    with added(*UNKNOWN):
        yield


def _written(text: str, name: str = "prog.py") -> Path:
    program = Path(name)
    program.parent.mkdir(parents=True, exist_ok=True)
    program.write_text(program_of(text), "utf-8")
    return program


def _problems(text: str) -> list[Diagnostic]:
    result = check(_written(text))
    errors = [problem for problem in result.diagnostics if problem.is_error]
    assert not errors, errors
    return list(result.diagnostics)


def _codes(text: str) -> set[str]:
    return {problem.code for problem in _problems(text)}


def _rung(spec: Spec) -> str:
    return f"if all(x[1], c.Run):\n    {spec.example}\n    out(c.Beside)\n"


# -- the rules --------------------------------------------------------------------------------------------------------


ADVICE = [code for rule in rules(Folder.ADVICE) for code in rule.codes]


@pytest.mark.parametrize("code", ADVICE, ids=lambda code: code.name)
def test_every_rule_judges_a_program_with_unknown_instructions(code: Code) -> None:
    quiet = [spec for spec in UNKNOWN if spec is not HALT]
    assert code.name in {problem.code for problem in check(_beside(code, quiet)).diagnostics}
    # Some rules are silent where a scan may end early.
    assert check(_beside(code, UNKNOWN)).diagnostics


def _beside(code: Code, specs: Iterable[Spec]) -> Path:
    """The wrong example of a code, and in front of it a rung with each of these."""
    more = "".join(map(_rung, specs))
    own = program_of(code.wrong[0].text)
    return _written(own.replace("def main():\n", f"def main():\n{textwrap.indent(more, '    ')}", 1))


@each
def test_every_instruction_is_judged_alone(spec: Spec) -> None:
    assert not [problem for problem in check(_written(_rung(spec))).diagnostics if problem.is_error]


def test_what_it_clears_is_overwritten_or_overwrites() -> None:
    assert _codes("if c.A:\n    copy(5, ds[105])\nif True:\n    clear(ds[101:111])\nif ds[105]:\n    out(y[1])\n") >= {
        "CG510"
    }
    assert _codes("if c.A:\n    clear(ds[105])\nif True:\n    copy(5, ds[105])\nif ds[105]:\n    out(y[1])\n") >= {
        "CG510"
    }
    with_condition = "if True:\n    copy(5, ds[105])\nif c.A:\n    clear(ds[105])\nif ds[105]:\n    out(y[1])\n"
    assert "CG510" not in _codes(with_condition)


def test_what_it_clears_and_nothing_reads_is_work_for_nothing() -> None:
    assert "CG505" in _codes("if x[1]:\n    clear(ds[101:111])\n")
    assert "CG505" not in _codes("if x[1]:\n    clear(ds[101:111])\nif ds[105] > 1:\n    out(y[1])\n")


def test_a_step_that_it_takes_back_is_undone() -> None:
    step = (
        "if all(re(x[1]), ds.Step == 0):\n    copy(1, ds.Step)\nif all(re(x[1]), ds.Step == 1):\n    clear(ds.Step)\n"
    )
    assert "CG544" in _codes(step)
    lamp = "if all(re(x[1]), nc(c.Lamp)):\n    set(c.Lamp)\nif all(re(x[1]), c.Lamp):\n    clear(c.Lamp)\n"
    assert "CG544" in _codes(lamp)


def test_bits_that_it_clears_are_reset() -> None:
    latch = "if x[1]:\n    set(c.Running)\nif c.Running:\n    out(y[1])\n"
    assert "CG502" in _codes(latch)
    assert "CG502" not in _codes(f"{latch}if x[2]:\n    clear(c.Running)\n")
    assert "CG503" in _codes("if x[2]:\n    clear(c.Running)\nif c.Running:\n    out(y[1])\n")


def test_what_it_clears_in_the_first_scan_is_not_kept() -> None:
    counter = "if re(x[1]):\n    ctu(ct[10], 1000).reset(c.NewBatch)\n"
    assert "CG557" in _codes(f"if sc._1st_SCAN:\n    clear(ctd[10:20])\n{counter}")


def test_a_register_that_it_alone_writes_is_0() -> None:
    codes = _codes(
        'if x[1]:\n    clear(ds.Count)\nif x[2]:\n    calc("100 / ds.Count", ds.Each)\nif ds.Each:\n    out(y[1])\n'
    )
    assert "CG517" in codes


def test_a_box_that_acts_while_its_rung_is_off_is_a_coil() -> None:
    assert "CG501" in _codes("if x[1]:\n    out(y[1])\nif x[2]:\n    hold(y[1], release=lambda: x[3])\n")
    assert "CG543" in _codes("if x[1]:\n    set(y[1])\nif x[2]:\n    hold(y[1], release=lambda: x[3])\n")
    sub = (
        "\n\n@sub\ndef part():\n    if x[1]:\n        hold(y[1], release=lambda: x[3])\n    if True:\n        return\n"
    )
    called = f"def main():\n    if c.Auto:\n        call(part)\n    if True:\n        end()\n{sub}"
    assert "CG545" in _codes(called)
    assert "CG527" in _codes(called.replace("call(part)\n", "call(part)\n    if x[5]:\n        call(part)\n"))


def test_a_timer_is_known_by_what_it_keeps_and_owns() -> None:
    assert "CG512" in _codes("if x[1]:\n    pulse(t.P, setpoint=0)\nif t.P:\n    out(y[1])\n")
    assert "CG511" in _codes("if x[1]:\n    pulse(t.P, setpoint=900)\nif td.P == 500:\n    out(y[1])\n")
    assert "CG521" not in _codes("if x[1]:\n    pulse(t.P, setpoint=900)\nif t.P:\n    out(y[1])\n")
    in_loop = "if x[1]:\n    for _ in range(3):\n        if x[2]:\n            pulse(t.P, setpoint=900)\n"
    assert {"CG423"} <= {problem.code for problem in check(_written(in_loop)).diagnostics}


def test_what_leaves_the_scan_is_known_by_where_click_goes_on() -> None:
    assert "CG516" in _codes("if x[1]:\n    halt()\n    out(y[1])\n")


# -- lowering, outputs ------------------------------------------------------------------------------------------------


@each
def test_every_output_has_it(spec: Spec) -> None:
    result = clickgen.build(_written(_rung(spec)))
    assert result.ok, result.diagnostics
    word = spec.variants[0].token.partition("(")[0]
    assert f"{word}(" in result.files["main.csv"]
    assert all(text for name, text in result.files.items() if name.endswith((".csv", ".txt", ".json")))
    assert any(f"{word}(" in text for name, text in result.files.items() if name != "main.csv")
    assert main(["build", "prog.py", "-o", "out"]) == 0
    assert main(["workbook", "prog.py", "-o", "project.xlsx"]) == 0


def test_a_condition_that_it_changes_is_looked_at_before() -> None:
    """The box is a rung of its own, so that what it reads after the clear is kept on a scratch bit."""
    rung = "if c.Run:\n    clear(c[1:9])\n    if c[5]:\n        ctu(ct[1], 10).reset(x[1])\n"
    assert _scratch(rung.replace("clear(c[1:9])", "clear(c[11:19])")) == []
    assert len(_scratch(rung)) == 1


def _scratch(rung: str) -> list[str]:
    return [row.comment for row in clickgen.build(_written(rung)).new_rows if row.comment.startswith("condition")]


@each
def test_its_token_is_read_back(spec: Spec) -> None:
    result = clickgen.build(_written(_rung(spec)))
    [action] = [
        action
        for routine in result.built.routines
        for rung in routine.rungs
        for action in rung.actions
        if action.spec is spec
    ]
    pins = {param.pin: Always(HERE) for param in spec.pins}
    read = action_of(action_token(action), pins, HERE)
    assert read is not None
    assert read.spec is spec
    assert read.args.keys() == action.args.keys()


# -- commands ---------------------------------------------------------------------------------------------------------


@each
def test_a_bundle_with_it_is_imported_as_it_was_written(spec: Spec, capsys: pytest.CaptureFixture[str]) -> None:
    """laddercodec does not know the token, and a bundle is not asked about it: clickgen reads what it wrote."""
    _written(_rung(spec))
    assert main(["build", "prog.py", "-o", "out"]) == 0
    assert main(["import", "out", "-o", "read/prog.py"]) == 0, capsys.readouterr().err
    assert f"{spec.name}(" in Path("read/prog.py").read_text("utf-8")
    assert main(["build", "read/prog.py", "-o", "again"]) == 0
    assert Path("again/main.csv").read_bytes() == Path("out/main.csv").read_bytes()


def test_a_difference_is_told_in_its_words(capsys: pytest.CaptureFixture[str]) -> None:
    _written(_rung(CLEAR), "old/prog.py")
    _written(_rung(CLEAR).replace("111", "112"), "new/prog.py")
    assert main(["diff", "old/prog.py", "new/prog.py"]) == 1
    said = capsys.readouterr().out
    assert "zero(DS101..DS110)" in said
    assert "zero(DS101..DS111)" in said


@each
def test_editors_and_pages_know_it(spec: Spec) -> None:
    assert f"def {spec.name}(" in builtins_stub()
    assert instructions()[spec.name] == spec.summary
    page = instruction_page(spec)
    assert page in docs.made().values()
    assert spec.summary in page
    assert f"[{spec.name}]({spec.name}.md)" in docs.index()


def test_a_comment_silences_a_finding_about_it() -> None:
    _written("if x[1]:\n    clear(ds[101:111])\n")
    assert main(["check", "prog.py", "--select", "CG505", "--deny-warnings"]) == 1
    _written("if x[1]:\n    clear(ds[101:111])  # clickgen: ignore[CG505]\n")
    assert main(["check", "prog.py", "--select", "CG505", "--deny-warnings"]) == 0


def test_a_slip_in_it_is_mended() -> None:
    program = _written("if x[1]:\n    Clear(ds[101:111])\n")
    main(["check", "prog.py", "--fix"])
    assert "    clear(ds[101:111])" in program.read_text("utf-8")


def test_a_mistake_in_it_is_told() -> None:
    [problem] = [one for one in check(_written("if x[1]:\n    clear(sd[60])\n")).diagnostics if one.is_error]
    assert problem.code == "CG301"
    assert "clear does not take" in problem.message


@pytest.mark.parametrize(("action", "is_safe"), [("clear(ds.A)", True), ("hold(c.A, release=lambda: x[3])", False)])
def test_elif_becomes_a_rung_by_itself_where_it_needs_power(action: str, is_safe: bool) -> None:
    """A box that acts while its rung is off may undo what the arm before it did."""
    first = "clear(ds.A)" if is_safe else "set(c.A)"
    program = _written(f"if x[1]:\n    {first}\nelif x[2]:\n    {action}\n")
    main(["check", "prog.py", "--fix"])
    assert ("elif" not in program.read_text("utf-8")) is is_safe


# -- nobody names a Spec ----------------------------------------------------------------------------------------------

PLACES_MAX = 10


def _named_specs() -> Iterator[str]:
    """Each Spec, or tuple of Specs, that a module outside of ``instructions`` imports from a family, or asks of one."""
    families = {family.__name__ for family in FAMILIES}
    for path in sorted(PACKAGE.rglob("*.py")):
        if path.parent.name == "instructions" and path.parent.parent == PACKAGE:
            continue
        tree = ast.parse(path.read_text("utf-8"))
        modules: dict[str, str] = {}
        for node in ast.walk(tree):
            if isinstance(node, ast.ImportFrom) and node.module in families:
                yield from (f"{path.name}: {alias.name}" for alias in node.names if _is_spec(node.module, alias.name))
            elif isinstance(node, ast.ImportFrom) and node.module == "clickgen.instructions":
                found = {alias.asname or alias.name: f"{node.module}.{alias.name}" for alias in node.names}
                modules |= {name: module for name, module in found.items() if module in families}
        for node in ast.walk(tree):
            if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
                module = modules.get(node.value.id)
                if module is not None and _is_spec(module, node.attr):
                    yield f"{path.name}: {node.value.id}.{node.attr}"


def _is_spec(module: str, name: str) -> bool:
    value = getattr(importlib.import_module(module), name)
    return isinstance(value, Spec) or (isinstance(value, tuple) and any(isinstance(one, Spec) for one in value))


def test_few_places_name_a_spec() -> None:
    places = list(_named_specs())
    assert len(places) <= PLACES_MAX, places


def test_an_offered_instruction_is_only_spelled() -> None:
    """A message names it; nothing compares an instruction with it."""
    for path in sorted(PACKAGE.rglob("*.py")):
        tree = ast.parse(path.read_text("utf-8"))
        imports = [node for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)]
        names = {one.name for node in imports if node.module == "clickgen.instructions.offered" for one in node.names}
        compared = [node for node in ast.walk(tree) if isinstance(node, ast.Compare)]
        sides = [ast.unparse(side) for node in compared for side in (node.left, *node.comparators)]
        assert names.isdisjoint(sides), path


def test_an_instruction_is_gone_when_its_time_is_over() -> None:
    other = replace(CLEAR, name="other", variants=(Variant("other({range})"),))
    with added(other):
        assert other in every()
        assert specs_of("other(DS1)") == [other]
    assert other not in every()
    assert specs_of("other(DS1)") == []
