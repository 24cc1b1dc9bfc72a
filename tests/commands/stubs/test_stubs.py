"""The stubs for editors hold the whole language and no more, and pyright finds mistakes with them."""

from __future__ import annotations

import ast
import importlib
from pathlib import Path

import pytest
from typed_programs import MORE

import clickgen
from clickgen.api import known_names
from clickgen.cli import main
from clickgen.commands.stubs.arguments import COMPARISONS
from clickgen.commands.stubs.stub import MARK, builtins_stub, module_stub
from clickgen.commands.stubs.text import docstring
from clickgen.config import Settings
from clickgen.device.banks import BANKS, Address
from clickgen.dialects.if_rungs.read import arguments, conditions, modbus, options
from clickgen.instructions import INSTRUCTIONS
from clickgen.instructions.timers import UNITS
from clickgen.ir.addresses import BANK_NAMES
from clickgen.table.rows import Row, default_row

ROOT = Path(__file__).parents[3]
STUB = "__builtins__.pyi"

# -- the words of the language ----------------------------------------------------------------------------------------


def words_of(stub: str) -> set[str]:
    """The public names that a stub defines."""
    names = set()
    for node in ast.parse(stub).body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            names.add(node.name)
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            names.add(node.target.id)
    return {name for name in names if not name.startswith("_")}


def test_a_stub_has_the_words_that_the_parser_knows() -> None:
    known = {
        *BANK_NAMES,
        *INSTRUCTIONS,
        *conditions.FUNCTIONS,
        *UNITS,
        *options.MODIFIERS.values(),
        *modbus._TARGETS,
        "ModbusAddress",
        "nickname",
        "sub",
        "range",
    }
    assert words_of(builtins_stub()) == words_of(module_stub()) == known
    assert set(importlib.import_module("clickgen.dsl").__all__) == known
    assert {*COMPARISONS} == {*arguments._COMPARISONS}


def test_the_types_of_clickgen_dsl_are_up_to_date() -> None:
    """``python scripts/dsl_stub.py`` rewrites them."""
    assert (ROOT / "clickgen" / "dsl.pyi").read_text("utf-8") == module_stub()


def test_targets_have_the_parsers_settings() -> None:
    tree = ast.parse(builtins_stub())
    classes = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
    for name, settings in modbus._TARGETS.items():
        init = next(node for node in classes[name].body if isinstance(node, ast.FunctionDef))
        assert {argument.arg for argument in init.args.kwonlyargs} == {*settings}


# -- clickgen.dsl -----------------------------------------------------------------------------------------------------


def test_to_import_a_program_does_no_harm_and_to_run_it_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "imported_program.py").write_text(f"from clickgen.dsl import *\n{MORE}")
    monkeypatch.syspath_prepend(str(tmp_path))
    program = importlib.import_module("imported_program")
    with pytest.raises(RuntimeError, match="clickgen build"):
        program.main()


def test_clickgen_reads_past_the_import(tmp_path: Path) -> None:
    (tmp_path / "prog.py").write_text(f"from clickgen.dsl import *\n{MORE}")
    assert clickgen.build(tmp_path / "prog.py").ok


# -- nicknames --------------------------------------------------------------------------------------------------------


def attributes(stub: str, bank: str) -> dict[str, str]:
    """The attributes of a bank's class with their documentation."""
    found: dict[str, str] = {}
    (node,) = (node for node in ast.parse(stub).body if isinstance(node, ast.ClassDef) and node.name == f"_{bank}Bank")
    for member, after in zip(node.body, node.body[1:], strict=False):
        if isinstance(member, ast.AnnAssign) and isinstance(member.target, ast.Name):
            assert isinstance(after, ast.Expr)
            assert isinstance(after.value, ast.Constant)
            found[member.target.id] = str(after.value.value)
    return found


def row(bank: str, number: int, nickname: str, comment: str = "", initial: str = "0") -> Row:
    plain = default_row(Address(bank, number), nickname, comment)
    return Row(plain.address, nickname, initial, plain.retentive, comment)


def test_a_nickname_is_an_attribute_with_what_is_known_of_it() -> None:
    stub = builtins_stub([row("DS", 5, "Level", "Tank level", "10"), row("DS", 2, "at"), row("T", 3, "Delay")])
    assert attributes(stub, "DS") == {"at": "DS2: retentive", "Level": 'DS5: "Tank level", initial 10, retentive'}
    assert attributes(stub, "T") == {"Delay": "T3"}
    assert attributes(stub, "TD") == {"Delay": "TD3: current value of Delay"}
    assert attributes(stub, "SC")["_Always_ON"] == "SC1: CLICK's own"


def test_names_that_python_has_no_word_for_are_left_out() -> None:
    names = ("2nd pump", "for", "Belt speed", "None", "ok")
    stub = builtins_stub([row("C", number, name) for number, name in enumerate(names, 1)])
    assert list(attributes(stub, "C")) == ["ok"]


@pytest.mark.parametrize("text", ['a"', '""', 'x"""y', "back\\slash", "\\", "tab\tend\x01", "Grüße", 'a\\"', '"""' * 3])
def test_any_comment_is_documentation(text: str) -> None:
    (statement,) = ast.parse(docstring(text)).body
    assert isinstance(statement, ast.Expr)
    assert ast.literal_eval(statement.value) == text


def test_programs_of_a_folder_may_give_a_name_to_two_addresses() -> None:
    stub = builtins_stub([row("DS", 1, "Speed"), row("DS", 2, "Speed"), row("DS", 1, "Speed")])
    assert attributes(stub, "DS") == {"Speed": "DS1: retentive; DS2: retentive"}


def test_the_order_of_rows_makes_no_difference() -> None:
    rows = [row(bank, number, f"{bank}{number}x") for bank in ("C", "DS", "X") for number in (1, 2, 3)]
    assert builtins_stub(rows) == builtins_stub(rows[::-1])
    assert all(f"class _{bank}Bank" in builtins_stub() for bank in BANKS)


# -- the command ------------------------------------------------------------------------------------------------------

PROGRAM = "def main():\n    if c.Run:\n        out(y[1])\n    if True:\n        end()\n"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "prog.py").write_text(PROGRAM)
    return tmp_path


def test_the_command_writes_once_and_says_so(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["stubs", "prog.py"]) == 0
    assert capsys.readouterr().out == f"{STUB}: written\n"
    assert attributes((folder / STUB).read_text("utf-8"), "C") == {"Run": "C1"}
    assert not (folder / "nicknames.csv").exists()
    time = (folder / STUB).stat().st_mtime_ns
    assert main(["stubs", "prog.py"]) == 0
    assert capsys.readouterr().out == f"{STUB}: nothing has changed\n"
    assert (folder / STUB).stat().st_mtime_ns == time


@pytest.mark.usefixtures("folder")
def test_building_makes_no_stub_stale() -> None:
    main(["stubs", "prog.py"])
    assert main(["build", "prog.py"]) == 0
    assert main(["stubs", "prog.py", "--check"]) == 0


def test_check_tells_missing_and_stale_files(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["stubs", "prog.py", "--check"]) == 1
    assert capsys.readouterr().err == (
        f"{STUB} is missing\nclickgen: run clickgen stubs prog.py and commit what it writes\n"
    )
    assert not (folder / STUB).exists()
    main(["stubs", "prog.py"])
    (folder / STUB).write_bytes((folder / STUB).read_bytes().replace(b"\n", b"\r\n"))
    assert main(["stubs", "prog.py", "--check"]) == 0
    (folder / "prog.py").write_text(PROGRAM.replace("c.Run", "c.Other"))
    capsys.readouterr()
    assert main(["stubs", "prog.py", "--check"]) == 1
    assert f"{STUB} is stale" in capsys.readouterr().err


@pytest.mark.parametrize("flags", [[], ["--check"]])
def test_somebody_elses_file_is_left_alone(flags: list[str], folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / STUB).write_text("reveal_type: object\n")
    assert main(["stubs", "prog.py", *flags]) == 2
    assert "was not made by clickgen stubs" in capsys.readouterr().err
    assert (folder / STUB).read_text() == "reveal_type: object\n"


def test_a_program_with_errors_has_what_is_known(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "nicknames.csv").write_text(
        'Address,Data Type,Nickname,Initial Value,Retentive,Address Comment\nC7,BIT,"Kept",0,No,""\n'
    )
    (folder / "prog.py").write_text("nickname(ds.Recipe, ds[1:9])\n" + PROGRAM.replace("y[1]", "ds.Run"))
    assert main(["stubs", "prog.py"]) == 0
    assert "prog.py has 1 error" in capsys.readouterr().err
    stub = (folder / STUB).read_text("utf-8")
    assert set(attributes(stub, "C")) == {"Kept", "Run"}
    assert attributes(stub, "DS") == {"Recipe": "DS1 to DS8: members 0 to 7"}
    (folder / "prog.py").write_text("def main(:\n")
    assert main(["stubs", "prog.py"]) == 0
    assert set(attributes((folder / STUB).read_text("utf-8"), "C")) == {"Kept"}


def test_frozen_knows_no_name_without_an_address(folder: Path) -> None:
    (folder / "prog.py").write_text("nickname(c.Known, c[5])\n" + PROGRAM)
    assert main(["stubs", "prog.py", "--frozen"]) == 0
    assert set(attributes((folder / STUB).read_text("utf-8"), "C")) == {"Known"}


def test_configured_programs_share_the_stub_of_their_folder(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name in ("one", "two"):
        (folder / "plc").mkdir(exist_ok=True)
        (folder / "plc" / f"{name}.py").write_text(PROGRAM.replace("Run", name))
    (folder / "clickgen.toml").write_text('programs = ["plc/one.py", "plc/two.py", "prog.py"]\n')
    assert main(["stubs"]) == 0
    assert capsys.readouterr().out == f"{Path('plc', STUB)}: written\n{STUB}: written\n"
    stub = (folder / "plc" / STUB).read_text("utf-8")
    assert stub.startswith(MARK)
    assert attributes(stub, "C") == {"one": "C1", "two": "C2"}


def test_what_cannot_be_read_is_no_stub(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["stubs", "nothing.py"]) == 2
    assert main(["stubs"]) == 2
    assert "no program is named" in capsys.readouterr().err
    assert not (folder / STUB).exists()


def test_scratch_cells_are_nobodys_names(folder: Path) -> None:
    (folder / "prog.py").write_text((ROOT / "fixtures/cases/rtof/prog.py").read_text("utf-8"))
    main(["build", "prog.py"])
    assert b"Scratch_" in (folder / "nicknames.csv").read_bytes()
    main(["stubs", "prog.py"])
    assert "Scratch_" not in (folder / STUB).read_text("utf-8")
    assert known_names("prog.py", Settings(frozen=True)).rows
