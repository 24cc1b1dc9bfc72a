"""A program in several files: each is read once, as text, beside the file that imports it."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

import clickgen

SUB = "@sub\ndef {name}():\n    if {condition}:\n        out({bit})\n    if True:\n        return\n"
MAIN = "{imports}\n\n\ndef main():\n    if c.Go:\n{calls}\n    if True:\n        end()\n"


def lay_out(folder: Path, **files: str) -> Path:
    for name, text in files.items():
        (folder / f"{name}.py").write_text(text, "utf-8")
    return folder / "plc.py"


def subroutine(name: str, condition: str = "c.Go", bit: str = "c[9]") -> str:
    return SUB.format(name=name, condition=condition, bit=bit)


def main_of(imports: str, *called: str) -> str:
    return MAIN.format(imports=imports, calls="\n".join(f"        call({name})" for name in called or ("local",)))


def codes(result: clickgen.BuildResult) -> list[tuple[str, str]]:
    """Code and file of each problem."""
    return [(problem.code, Path(problem.span.path).name if problem.span else "") for problem in result.diagnostics]


def test_own_routines_come_first_then_the_imported_ones_in_order(tmp_path: Path) -> None:
    two = subroutine("second") + "\n\n" + subroutine("first")
    text = main_of("from two import first, second\nfrom one import third", "first", "second", "third", "local")
    result = clickgen.build(
        lay_out(tmp_path, two=two, one=subroutine("third"), plc=text + "\n\n" + subroutine("local"))
    )
    assert result.ok, result.diagnostics
    assert [routine.name for routine in result.routines] == ["main", "local", "first", "second", "third"]
    assert [Path(source.path).name for source in result.sources] == ["plc.py", "two.py", "one.py"]


def test_what_is_not_imported_stays_out(tmp_path: Path) -> None:
    auto = subroutine("used") + "\n\n" + subroutine("unused", bit="c.Unused")
    result = clickgen.build(lay_out(tmp_path, auto=auto, plc=main_of("from auto import used", "used")))
    assert result.ok, result.diagnostics
    assert [name for name in result.files if name.startswith("subroutines/")] == ["subroutines/used.csv"]
    assert "Unused" not in result.files["nicknames.csv"]


def test_the_declarations_of_every_file_hold(tmp_path: Path) -> None:
    wiring = "nickname(x.Start, x[7])\n"
    auto = "import wiring\n\n\n" + subroutine("auto_mode", "x.Start")
    result = clickgen.build(
        lay_out(tmp_path, wiring=wiring, auto=auto, plc=main_of("from auto import auto_mode", "auto_mode"))
    )
    assert result.ok, result.diagnostics
    assert "X007" in result.files["subroutines/auto_mode.csv"]


def test_a_file_imported_twice_is_one_file(tmp_path: Path) -> None:
    wiring = "nickname(x.Start, x[7])\n"
    auto = "import wiring\n\n\n" + subroutine("auto_mode", "x.Start")
    imports = "import wiring\nfrom auto import auto_mode\nfrom auto import auto_mode"
    result = clickgen.build(lay_out(tmp_path, wiring=wiring, auto=auto, plc=main_of(imports, "auto_mode")))
    assert result.ok, result.diagnostics
    assert len(result.subroutines) == 1


def test_files_are_found_beside_the_importing_file_wherever_the_command_runs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "plant"
    folder.mkdir()
    lay_out(folder, auto=subroutine("auto_mode"), plc=main_of("from .auto import auto_mode", "auto_mode"))
    monkeypatch.chdir(tmp_path)
    result = clickgen.build(os.path.join("plant", "plc.py"))
    assert result.ok, result.diagnostics
    routines = json.loads(result.files["sources.json"])["routines"]
    assert {rung["file"] for rung in routines["auto_mode"]} == {"auto.py"}
    assert {rung["file"] for rung in routines["main"]} == {"plc.py"}


def test_problems_stand_in_the_file_that_has_them(tmp_path: Path) -> None:
    auto = subroutine("auto_mode", "c.Go and c.Stop")
    result = clickgen.build(lay_out(tmp_path, auto=auto, plc=main_of("from auto import auto_mode", "auto_mod")))
    assert codes(result) == [("CG105", "auto.py"), ("CG405", "plc.py")]


def test_two_files_cannot_bring_the_same_name(tmp_path: Path) -> None:
    one, two = subroutine("auto_mode"), subroutine("Auto_Mode")
    imports = "from one import auto_mode\nfrom two import Auto_Mode"
    result = clickgen.build(lay_out(tmp_path, one=one, two=two, plc=main_of(imports, "auto_mode")))
    assert codes(result) == [("CG402", "two.py")]
    (problem,) = result.diagnostics
    assert "one.py:2:1" in problem.message


def test_two_files_cannot_declare_a_name_twice(tmp_path: Path) -> None:
    imports = "import one\nimport two\nfrom one import auto_mode"
    one = "nickname(c.Go, c[5])\n\n\n" + subroutine("auto_mode")
    result = clickgen.build(lay_out(tmp_path, one=one, two="nickname(c.Go, c[6])\n", plc=main_of(imports, "auto_mode")))
    assert codes(result) == [("CG205", "two.py")]


@pytest.mark.parametrize("data", [b"\xff\xfe\x00", b"caf\xe9", b"def (", b"a\0b"])
def test_an_unreadable_sibling_is_a_problem_in_its_own_file(tmp_path: Path, data: bytes) -> None:
    program = lay_out(tmp_path, plc=main_of("from auto import auto_mode", "auto_mode"))
    (tmp_path / "auto.py").write_bytes(data)
    assert codes(clickgen.build(program)) == [("CG101", "auto.py")]


def test_a_folder_in_place_of_a_file_is_a_problem(tmp_path: Path) -> None:
    program = lay_out(tmp_path, plc=main_of("from auto import auto_mode", "auto_mode"))
    (tmp_path / "auto.py").mkdir()
    assert codes(clickgen.build(program)) == [("CG121", "plc.py")]


def test_a_file_that_imports_itself_is_a_circle(tmp_path: Path) -> None:
    text = main_of("from plc import local", "local") + "\n\n" + subroutine("local")
    assert codes(clickgen.build(lay_out(tmp_path, plc=text))) == [("CG122", "plc.py")]


def test_a_subroutine_is_imported_from_the_file_that_defines_it(tmp_path: Path) -> None:
    one = "from two import far\n\n\n" + subroutine("near")
    result = clickgen.build(
        lay_out(tmp_path, one=one, two=subroutine("far"), plc=main_of("from one import far", "far"))
    )
    assert codes(result) == [("CG123", "plc.py")]
