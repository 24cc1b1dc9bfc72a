"""A new rule is one file: check, explain, the list of rules, the pages, suppression and selection find it there."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path

import pytest
from any_order import judged_in_any_order
from test_examples import program_of

import docs
from clickgen.cli import main
from clickgen.dialects.registry import default
from clickgen.facts.facts import Facts
from clickgen.ir.program import Program
from clickgen.problems.codes import CODES, entry_of
from clickgen.rules import registry
from clickgen.rules.registry import Folder, declarations, every_rule
from clickgen.rules.rule import Findings, Rule, finding
from clickgen.text.source import SourceFile

RULE = r'''
"""A horn is loud."""

from clickgen.facts.facts import Facts
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

CODE = "CG599"


def find(facts: Facts) -> Findings:
    for placed in facts.actions:
        operand = placed.action.args.get("address")
        if operand is not None and "Horn" in facts.text(operand.span):
            yield finding(CODE, operand.span, "the horn is loud", "use a lamp")


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "a horn sounds",
    "People are startled.",
    wrong=(Wrong("if x[1]:\n    out(y.Horn)  # <-\n"),),
    right=("if x[1]:\n    out(y.Lamp)\n",),
)

RULE = Rule(find, (ABOUT,), holds_in_parts=True)
'''
FACTS = Facts(Program(SourceFile("prog.py", "\n"), (), ()), default())
HORN = program_of("if x[1]:\n    out(y.Horn)\n")


@dataclass
class Project:
    """A project with one program, and clickgen's command line."""

    folder: Path
    say: Callable[[], str]

    def check(self, text: str, *flags: str) -> list[str]:
        """The codes that ``check`` finds in a text."""
        (self.folder / "prog.py").write_text(text, "utf-8")
        main(["check", "prog.py", "--output-format", "json", *flags])
        return [found["code"] for found in json.loads(self.say())["findings"]]


@pytest.fixture(params=Folder, ids=lambda folder: folder.value)
def project(
    request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> Iterator[Project]:
    """A project, with one more rule in a folder of rules and the table of codes made anew."""
    package = import_module(f"clickgen.rules.{request.param.value}")
    name = f"{package.__name__}.loud_horn"
    more = tmp_path / "more"
    more.mkdir()
    (more / "loud_horn.py").write_text(RULE, "utf-8")
    monkeypatch.setattr(package, "__path__", [*package.__path__, str(more)])
    registry.modules.cache_clear()
    made: dict[str, str] = {}
    exec(docs.code_table(), made)
    for code, entry in map(entry_of, made["TABLE"].splitlines()):
        monkeypatch.setitem(CODES, code, entry)
    monkeypatch.chdir(tmp_path)
    yield Project(tmp_path, lambda: capsys.readouterr().out)
    registry.modules.cache_clear()
    sys.modules.pop(name, None)
    vars(package).pop("loud_horn", None)


def test_a_check_finds_it(project: Project) -> None:
    assert "CG599" in project.check(HORN)
    assert "CG599" not in project.check(HORN.replace("Horn", "Lamp"))


def test_it_is_selected_and_left_out(project: Project) -> None:
    assert project.check(HORN, "--select", "CG599") == ["CG599"]
    assert "CG599" not in project.check(HORN, "--ignore", "CG599")


def test_a_comment_silences_it(project: Project) -> None:
    assert "CG599" not in project.check(HORN.replace("y.Horn)", "y.Horn)  # clickgen: ignore[CG599] it is a fire horn"))
    assert "CG525" in project.check(HORN.replace("y.Horn)", "y.Lamp)  # clickgen: ignore[CG599] it is a fire horn"))


def test_it_is_explained_and_listed(project: Project) -> None:
    main(["explain", "cg599"])
    said = project.say()
    assert said.startswith("CG599: a horn sounds")
    assert "People are startled." in said
    assert "out(y.Horn)  # <-" in said
    main(["rules"])
    assert "CG599  warning  a horn sounds\n" in project.say()


def test_the_pages_and_reports_have_it(project: Project) -> None:
    assert "| [CG599](CG599.md) | warning | a horn sounds |" in docs.codes_table()
    assert "People are startled." in docs.problem_pages()[docs.PROBLEMS / "CG599.md"]
    assert "CG599" in docs.problem_matcher()
    (project.folder / "prog.py").write_text(HORN, "utf-8")
    main(["check", "prog.py", "--output-format", "sarif"])
    (run,) = json.loads(project.say())["runs"]
    found = next(result for result in run["results"] if result["ruleId"] == "CG599")
    assert run["tool"]["driver"]["rules"][found["ruleIndex"]]["id"] == "CG599"


# -- the shape --------------------------------------------------------------------------------------------------------


def test_every_code_is_declared_once_and_in_the_table() -> None:
    assert list(declarations()) == sorted(CODES)
    for name, (code, home) in declarations().items():
        assert CODES[name] == (code.severity, code.title, code.is_on, home)
        assert registry.declared(name) == code


@pytest.mark.parametrize("folder", Folder)
def test_rules_are_in_the_order_of_their_codes(folder: Folder) -> None:
    first = [min((code.name for code in rule.codes), default="") for rule in registry.rules(folder)]
    assert first == sorted(first)


def test_the_codes_that_a_rule_borrows_are_declared_elsewhere() -> None:
    for rule in every_rule():
        assert not {code.name for code in rule.codes} & set(rule.also)
        assert set(rule.also) <= CODES.keys()
        assert rule.codes or rule.also


def test_a_code_that_is_declared_twice_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    again = next(rule for rule in every_rule() if rule.codes)
    monkeypatch.setattr(registry, "modules", lambda _: {f"{registry.__package__}.twice": again})
    with pytest.raises(ValueError, match=again.codes[0].name):
        declarations()


def test_a_rule_that_asks_what_came_before_it_is_noticed() -> None:
    before: dict[int, list[int]] = {}

    def rule(number: int) -> Rule:
        def find(facts: Facts) -> Findings:
            asked = before.setdefault(id(facts), [])
            yield finding("CG501", None, f"rule {number} came after {len(asked)} others")
            asked.append(number)

        return Rule(find, (), ("CG501",))

    with pytest.raises(AssertionError):
        judged_in_any_order(FACTS, [rule(number) for number in range(8)], lambda _: True, False)


def test_a_rule_that_reports_a_code_that_it_does_not_name_is_noticed() -> None:
    def find(facts: Facts) -> Findings:
        yield finding("CG502", facts.program.source.span(1, 1, 1, 2), "found")

    with pytest.raises(AssertionError):
        judged_in_any_order(FACTS, [Rule(find, (), ("CG501",))], lambda _: True, False)
