"""The files of this repository for other tools: the GitHub action, the problem matcher, the examples for pipelines."""

from __future__ import annotations

import contextlib
import io
import json
import os
import re
import runpy
import shlex
import shutil
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple
from xml.etree import ElementTree as ET

import pytest
import yaml

from clickgen.cli import main
from clickgen.problems.codes import CODES, Severity
from clickgen.problems.diagnostics import Diagnostic
from clickgen.problems.formats import FORMATS
from clickgen.problems.report import Report, render
from clickgen.text.edits import Edit, Fix
from clickgen.text.source import Span

PROJECT = Path(__file__).parents[2]
PAGES = [PROJECT / "docs" / name for name in ("check-in-ci.md", "check-output.md")]
ACTION: dict[str, Any] = yaml.safe_load((PROJECT / "action.yml").read_text("utf-8"))
STEPS: list[dict[str, Any]] = ACTION["runs"]["steps"]
MATCHER = PROJECT / ".github" / "clickgen-problem-matcher.json"


def validate(schema: str, text: str, folder: Path) -> None:
    """Validate YAML against a schema that comes with check-jsonschema, or as pre-commit does it."""
    path = folder / "example.yml"
    path.write_text(text, "utf-8")
    tool = ["check_jsonschema", "--builtin-schema", f"vendor.{schema}"]
    if schema == "pre-commit":
        tool = ["pre_commit", "validate-config"]
    # In this process: most of their time goes into imports.
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sys, "argv", [*tool, str(path)])
        with pytest.raises(SystemExit) as end:
            runpy.run_module(tool[0], run_name="__main__")
    assert not end.value.code, "the schema is broken: see what was printed"


@cache
def flags_of(command: str) -> set[str]:
    """The long flags of a command of clickgen."""
    with contextlib.redirect_stdout(io.StringIO()) as help, pytest.raises(SystemExit):
        main([command, "--help"])
    return set(re.findall(r"(?<![\w-])--[a-z][a-z-]+", help.getvalue()))


def check_command(words: list[str]) -> None:
    """A command line anywhere: its flags exist, and so does its format."""
    assert {word for word in words if word.startswith("--")} <= flags_of(words[1]), words
    if "--output-format" in words:
        assert words[words.index("--output-format") + 1] in FORMATS


# -- the action -------------------------------------------------------------------------------------------------------


def test_the_action_keeps_to_the_schema(tmp_path: Path) -> None:
    validate("github-actions", (PROJECT / "action.yml").read_text("utf-8"), tmp_path)


def expressions(tree: object) -> Iterator[str]:
    """Everything in ``${{ }}``, and the conditions, which have no braces."""
    if isinstance(tree, dict):
        yield from (tree[key] for key in ("if",) if key in tree)
        for value in tree.values():
            yield from expressions(value)
    elif isinstance(tree, list):
        for value in tree:
            yield from expressions(value)
    elif isinstance(tree, str):
        yield from re.findall(r"\$\{\{(.*?)\}\}", tree)


def test_every_input_is_used_and_every_used_one_is_there() -> None:
    used = {name for text in expressions(STEPS) for name in re.findall(r"inputs\.([\w-]+)", text)}
    assert used == ACTION["inputs"].keys()


def test_every_input_is_described_and_optional() -> None:
    for input in ACTION["inputs"].values():
        assert input["description"].endswith(".")
        assert isinstance(input["default"], str)


def test_what_a_step_takes_from_another_is_given_there() -> None:
    """Outputs that our scripts write; those of other actions are their documentation's."""
    written = {(step["id"], name) for step in STEPS for name in re.findall(r'echo "([\w-]+)=', step.get("run", ""))} | {
        ("python", "python-path")
    }
    texts = [*expressions(STEPS), *(output["value"] for output in ACTION["outputs"].values())]
    taken = {match for text in texts for match in re.findall(r"steps\.([\w-]+)\.outputs\.([\w-]+)", text)}
    assert taken == written


@pytest.mark.parametrize("step", [step for step in STEPS if "run" in step], ids=lambda step: step["id"])
def test_a_script_takes_inputs_only_from_its_environment(step: dict[str, Any]) -> None:
    assert "${{" not in step["run"], "what a user gives would be run"
    used = set(re.findall(r"\$\{?([A-Z_]+)", step["run"]))
    given = {"RUNNER_TEMP", "GITHUB_OUTPUT", "GITHUB_ACTION_PATH"}
    assert used - given == step["env"].keys()


def test_the_flags_in_the_scripts_are_there() -> None:
    script = next(step["run"] for step in STEPS if step.get("id") == "check")
    calls = re.findall(r"^ *check (--.*)$", script, re.MULTILINE)
    assert len(calls) == 2
    for call in calls:
        check_command(["clickgen", "check", *shlex.split(call)])


needs_bash = pytest.mark.skipif(os.name == "nt" or not shutil.which("bash"), reason="the scripts are for bash")

TWICE = """\
nickname(y.Door, y[1])


def main():
    if c.Open:
        out(y.Door)

    if c.Bell:
        out(y.Door)

    if True:
        end()
"""
CLEAN = TWICE.replace("    if c.Bell:\n        out(y.Door)\n\n", "")


class Ran(NamedTuple):
    code: int
    output: str
    outputs: dict[str, str]


def run_step(id: str, folder: Path, **inputs: str) -> Ran:
    """A step's script as a runner runs it."""
    step = next(step for step in STEPS if step.get("id") == id)
    assert step["env"].keys() >= inputs.keys()
    script, outputs = folder / "script.sh", folder / "outputs"
    script.write_text(step["run"])
    outputs.write_text("")
    environ = {"RUNNER_TEMP": str(folder / "temp"), "GITHUB_OUTPUT": str(outputs)}
    (folder / "temp").mkdir(exist_ok=True)
    done = subprocess.run(
        ["bash", "--noprofile", "--norc", "-eo", "pipefail", script],
        cwd=folder / "workspace",
        env=os.environ | dict.fromkeys(step["env"], "") | environ | {"PYTHON": sys.executable} | inputs,
        capture_output=True,
        encoding="utf-8",
    )
    lines = (line.split("=", 1) for line in outputs.read_text().splitlines())
    return Ran(done.returncode, done.stdout + done.stderr, dict(lines))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    plant = tmp_path / "workspace" / "my plant"
    plant.mkdir(parents=True)
    (plant / "doors.py").write_text(TWICE)
    (plant / "gates.py").write_text(CLEAN)
    return tmp_path


@needs_bash
def test_the_check_of_the_action_fails_with_annotations(folder: Path) -> None:
    ran = run_step("check", folder)
    assert ran.code == 1, ran.output
    assert ran.output.startswith("::warning file=my plant/doors.py,line=9,")
    assert ran.outputs == {}


@needs_bash
def test_the_check_of_the_action_takes_paths_and_arguments(folder: Path) -> None:
    ran = run_step("check", folder, PATHS="my plant/gates.py\n\n", ARGS="--deny-warnings  --no-cache")
    assert (ran.code, ran.output) == (0, "")
    ran = run_step("check", folder, PATHS="my plant/gates.py\nmy plant/doors.py", ARGS="--deny-warnings")
    assert ran.output.startswith("::error ")
    ran = run_step("check", folder, ARGS="--ignore CG501")
    assert ran.code == 0, ran.output
    ran = run_step("check", folder, PATHS="*; echo caught")
    assert ran.code == 2
    assert "no file or folder *; echo caught" in ran.output


@needs_bash
def test_the_check_of_the_action_writes_sarif_although_it_fails(folder: Path) -> None:
    ran = run_step("check", folder, FILE="found it.sarif")
    assert ran.code == 1, ran.output
    assert ran.outputs == {"sarif-file": "found it.sarif"}
    log = json.loads((folder / "workspace" / "found it.sarif").read_text("utf-8"))
    assert [result["ruleId"] for result in log["runs"][0]["results"]] == ["CG501"]
    ran = run_step("check", folder, UPLOAD="true")
    assert Path(ran.outputs["sarif-file"]).parent == folder / "temp"
    assert Path(ran.outputs["sarif-file"]).is_file()


@needs_bash
@pytest.mark.parametrize(("version", "package"), [("", "/actions/click gen"), ("0.1.0", "clickgen-plc==0.1.0")])
def test_the_action_installs_itself_or_the_version_that_is_named(
    version: str, package: str, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    python = folder / "python"
    python.write_text(
        """#!/usr/bin/env bash
printf '%s|' "$@" >> "$LOG"
if [ "$2" = venv ]; then mkdir -p "$3/bin"; cp "$0" "$3/bin/python"; fi
"""
    )
    python.chmod(0o755)
    monkeypatch.setenv("LOG", str(folder / "log"))
    monkeypatch.setenv("GITHUB_ACTION_PATH", "/actions/click gen")
    ran = run_step("install", folder, PYTHON=str(python), VERSION=version)
    assert ran.code == 0, ran.output
    home = folder / "temp" / "clickgen"
    assert ran.outputs == {"python": str(home / "bin" / "python")}
    assert (folder / "log").read_text() == (
        f"-m|venv|{home}|-m|pip|install|--quiet|--disable-pip-version-check|{package}|"
    )


# -- the problem matcher ----------------------------------------------------------------------------------------------

MATCHERS: list[dict[str, Any]] = json.loads(MATCHER.read_text("utf-8"))["problemMatcher"]
LEVELS = {"error": Severity.ERROR, "warning": Severity.WARNING, "notice": Severity.INFO}


def matches(line: str) -> list[dict[str, Any]]:
    """A runner's reading of a line: IssueMatcher.cs of https://github.com/actions/runner."""
    found = []
    for matcher in MATCHERS:
        (pattern,) = matcher["pattern"]
        match = re.search(pattern["regexp"], line, re.ASCII)
        if match:
            groups = {name: match[number] for name, number in pattern.items() if name != "regexp"}
            found.append({"severity": matcher["severity"], **groups})
    return found


def test_the_matchers_have_what_the_runner_wants() -> None:
    owners = [matcher["owner"] for matcher in MATCHERS]
    assert len(set(owners)) == len(owners)
    for matcher in MATCHERS:
        assert matcher["severity"] in LEVELS
        (pattern,) = matcher["pattern"]
        count = re.compile(pattern["regexp"]).groups
        assert all(1 <= number <= count for name, number in pattern.items() if name != "regexp")
        assert "message" in pattern


@pytest.mark.parametrize("code", CODES)
def test_a_concise_line_is_matched_with_the_severity_of_its_code(code: str) -> None:
    fix = Fix((Edit(Span("a.py", 1, 1, 1, 1), ""),))
    path = "my plant/süd:2.py"
    for finding in (
        Diagnostic(code, "said in a.py:7:8: CG101, twice", Span(path, 12, 34, 12, 40)),
        Diagnostic(code, "said in a.py:7:8: CG101, twice", Span(path, 12, 34, 12, 40), fix=fix),
    ):
        (match,) = matches(render("concise", Report((finding,))).rstrip("\n"))
        assert LEVELS[match.pop("severity")] is CODES[code].severity
        assert match == {"file": path, "line": "12", "column": "34", "code": code, "message": finding.message}


def test_a_concise_line_without_a_place_is_matched() -> None:
    (match,) = matches(render("concise", Report((Diagnostic("CG401", "no main", None),))).rstrip("\n"))
    assert (match["file"], match["code"], match["message"]) == (None, "CG401", "no main")


@pytest.mark.parametrize(
    "line", ["1 error in 1 file", "CG501  warning  an output coil", "3  CG501  [*]  x", "a.py:1:2: x"]
)
def test_nothing_else_is_matched(line: str) -> None:
    assert matches(line) == []


# -- the pages --------------------------------------------------------------------------------------------------------


class Block(NamedTuple):
    note: str
    language: str
    text: str

    @property
    def head(self) -> str:
        """The first line."""
        return self.text.split("\n")[0]


def blocks(page: Path) -> list[Block]:
    found = re.findall(
        r"(?:^<!-- ([^\n]*) -->\n)?^```(\w+)\n(.*?)^```$", page.read_text("utf-8"), re.DOTALL | re.MULTILINE
    )
    return [Block(*groups) for groups in found]


BLOCKS = [block for page in PAGES for block in blocks(page)]
YAML = [block for block in BLOCKS if block.language == "yaml"]


def test_every_example_can_be_read() -> None:
    assert {"json", "xml", "yaml"} <= {block.language for block in BLOCKS}
    for block in BLOCKS:
        if block.language == "json":
            json.loads(block.text)
        elif block.language == "xml":
            ET.fromstring(block.text)
        elif block.language == "yaml":
            assert yaml.safe_load(block.text)


FILES = {
    "# .pre-commit-config.yaml": "pre-commit",
    "# .github/workflows/plc.yml": "github-workflows",
    "# .gitlab-ci.yml": "gitlab-ci",
    "# azure-pipelines.yml": "azure-pipelines",
}
"""The first line of an example, which names the file it belongs in, and its schema."""


@pytest.mark.parametrize("block", YAML, ids=lambda block: block.head)
def test_a_yaml_example_keeps_to_its_schema(block: Block, tmp_path: Path) -> None:
    validate(FILES[block.head], block.text, tmp_path)


def strings(tree: object) -> Iterator[str]:
    if isinstance(tree, dict):
        tree = list(tree.values())
    if isinstance(tree, list):
        for value in tree:
            yield from strings(value)
    elif isinstance(tree, str):
        yield tree


def test_the_commands_of_the_examples_have_flags_that_there_are() -> None:
    commands = [text for block in YAML for text in strings(yaml.safe_load(block.text)) if text.startswith("clickgen ")]
    assert len(commands) >= 5
    for command in commands:
        check_command(shlex.split(command))


def uses(tree: object) -> Iterator[dict[str, Any]]:
    """Every step that uses an action."""
    if isinstance(tree, dict):
        if "uses" in tree:
            yield tree
        tree = list(tree.values())
    if isinstance(tree, list):
        for value in tree:
            yield from uses(value)


def test_the_examples_use_the_action_as_it_is() -> None:
    own = [step for block in YAML for step in uses(yaml.safe_load(block.text)) if "/clickgen@" in step["uses"]]
    assert len(own) >= 2
    for step in own:
        assert step["with"].keys() <= ACTION["inputs"].keys()
    page = PAGES[0].read_text("utf-8")
    assert re.findall(r"^\| `([\w-]+)` \|", page, re.MULTILINE) == list(ACTION["inputs"])


def test_the_examples_use_the_same_versions_of_actions() -> None:
    texts = [(PROJECT / "action.yml").read_text("utf-8"), *(block.text for block in YAML)]
    versions = {match for text in texts for match in re.findall(r"uses: ((?:actions|github)/[\w/-]+)@(\S+)", text)}
    assert len({name for name, _ in versions}) == len(versions)


def test_the_hooks_of_the_example_are_there() -> None:
    hooks = {hook["id"] for hook in yaml.safe_load((PROJECT / ".pre-commit-hooks.yaml").read_text("utf-8"))}
    (example,) = [yaml.safe_load(block.text) for block in YAML if FILES[block.head] == "pre-commit"]
    assert {hook["id"] for repo in example["repos"] for hook in repo["hooks"]} == hooks


def test_the_page_about_formats_has_them_all() -> None:
    rows = re.findall(r"^\| \[?`(\w+)`", PAGES[1].read_text("utf-8"), re.MULTILINE)
    assert rows[: len(FORMATS)] == list(FORMATS)


def test_the_page_about_formats_has_every_key_of_json() -> None:
    text = PAGES[1].read_text("utf-8")
    (tree,) = [json.loads(block.text) for block in BLOCKS if block.note == "output: findings.json"]
    named = set(re.findall(r"`(?:findings\[\]\.|counts\.)?(\w+)`", text))
    assert {*tree, *tree["tool"], *tree["findings"][0], *tree["counts"]} - {"counts"} <= named
