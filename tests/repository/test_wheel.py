"""The wheel, installed into a fresh virtual environment, builds the demo: nothing of the checkout is needed."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import venv
from pathlib import Path

PROJECT = Path(__file__).parents[2]
DEMO = PROJECT / "fixtures" / "cases" / "demo"


def run(*command: str | Path, cwd: Path) -> str:
    # Without the test environment's variables for Python, as on a user's machine.
    environ = {key: value for key, value in os.environ.items() if not key.startswith(("PYTHON", "VIRTUAL_ENV"))}
    done = subprocess.run(command, cwd=cwd, env=environ, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_the_wheel_builds_the_demo(tmp_path: Path) -> None:
    run(
        sys.executable, "-m", "build", "--wheel", "--no-isolation", "--outdir", tmp_path / "dist", PROJECT, cwd=tmp_path
    )
    (wheel,) = (tmp_path / "dist").glob("clickgen_plc-*.whl")
    venv.create(tmp_path / "venv", with_pip=False)
    scripts = tmp_path / "venv" / ("Scripts" if os.name == "nt" else "bin")
    pip = (sys.executable, "-m", "pip", "--python", scripts / "python", "--disable-pip-version-check")
    run(*pip, "install", "--quiet", "--no-compile", wheel, cwd=tmp_path)
    shutil.copy(DEMO / "prog.py", tmp_path / "prog.py")

    run(scripts / "clickgen", "build", "prog.py", cwd=tmp_path)

    built = tmp_path / "build" / "prog"
    for expected in (DEMO / "expected").rglob("*"):
        name = expected.relative_to(DEMO / "expected")
        if expected.is_file() and name.parts[0] != "table" and name.name != "diagnostics.txt":
            assert (built / name).read_bytes() == expected.read_bytes(), name
    assert run(scripts / "clickgen", "explain", "TON", cwd=tmp_path).startswith("ton\n")
    assert run(scripts / "clickgen", "explain", "addresses", cwd=tmp_path).startswith("Addresses\n")
    installed = run(scripts / "python", "-c", "import clickgen; print(clickgen.__file__)", cwd=tmp_path).strip()
    assert Path(installed).is_relative_to(tmp_path / "venv")


def test_installing_brings_no_modbus_stack() -> None:
    """pyclickplc and pyrung are for tests only."""
    import tomllib

    project = tomllib.loads((PROJECT / "pyproject.toml").read_text("utf-8"))["project"]
    names = {requirement.split(">")[0] for requirement in project["dependencies"]}
    assert names == {"libcst", "lark", "openpyxl", "defusedxml", "laddercodec", "rich"}
