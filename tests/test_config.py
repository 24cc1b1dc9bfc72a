"""Settings: where they are found, what they mean, and what is said when they cannot be used."""

from __future__ import annotations

from pathlib import Path

import pytest

from clickgen.cli import main
from clickgen.config import CheckSettings, ConfigError, ProgramSettings, find_config, read_config
from clickgen.device.banks import Address

PROGRAM = "def main():\n    if c.A:\n        copy(ds.Speed, ds[900])\n    if True:\n        end()\n"


def settings(folder: Path, text: str, name: str = "clickgen.toml") -> Path:
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, "utf-8")
    return path


# -- where they are found ---------------------------------------------------------------------------------------------


def test_without_settings_there_are_defaults(tmp_path: Path) -> None:
    config = find_config(tmp_path)
    assert (config.root, config.file, config.programs) == (tmp_path, None, ())


def test_the_nearest_file_that_has_settings_wins(tmp_path: Path) -> None:
    settings(tmp_path, "[tool.clickgen]\nreserved = ['C1']\n", "pyproject.toml")
    settings(tmp_path, "[tool.other]\n", "plant/pyproject.toml")
    inner = tmp_path / "plant" / "line"
    inner.mkdir()
    assert find_config(inner).file == tmp_path / "pyproject.toml"
    nearer = settings(tmp_path, "reserved = ['C2']\n", "plant/clickgen.toml")
    config = find_config(inner)
    assert (config.file, config.root, config.reserved) == (nearer, tmp_path / "plant", (Address("C", 2),))


def test_its_own_file_comes_before_the_project_file(tmp_path: Path) -> None:
    settings(tmp_path, "[tool.clickgen]\n", "pyproject.toml")
    own = settings(tmp_path, "")
    assert find_config(tmp_path).file == own


def test_a_named_file_may_have_any_name(tmp_path: Path) -> None:
    path = settings(tmp_path, "programs = ['plc.py']\n", "other.toml")
    assert read_config(path).programs == (ProgramSettings(tmp_path / "plc.py"),)
    path = settings(tmp_path, "[tool.clickgen]\nprograms = ['plc.py']\n", "third.toml")
    assert read_config(path).programs == (ProgramSettings(tmp_path / "plc.py"),)


# -- what they mean ---------------------------------------------------------------------------------------------------


def test_everything_is_read(tmp_path: Path) -> None:
    path = settings(
        tmp_path,
        """
programs = ["one.py", { path = "two/main.py", nicknames = "two/io.csv", output = "out/two" }]
reserved = ["DS1000..DS1002", "y16..Y21"]

[check]
select = ["CG5", "CG312"]
extend-select = ["CG504"]
ignore = ["ALL"]
exclude = ["old/*"]
per-file-ignores = { "legacy/*.py" = ["CG5"] }
""",
    )
    config = read_config(path)
    two = ProgramSettings(tmp_path / "two/main.py", tmp_path / "two/io.csv", tmp_path / "out/two")
    assert config.programs == (ProgramSettings(tmp_path / "one.py"), two)
    assert config.program(tmp_path / "one" / ".." / "two" / "main.py") == two
    assert config.reserved == (
        *(Address("DS", number) for number in (1000, 1001, 1002)),
        Address("Y", 16),
        Address("Y", 21),
    )
    assert config.check == CheckSettings(
        ("CG5", "CG312"), ("CG504",), ("CG",), ("old/*",), (("legacy/*.py", ("CG5",)),)
    )


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("program = ['plc.py']", "unknown key program; did you mean programs?"),
        ("[check]\nselct = ['CG5']", "unknown key check.selct; did you mean select?"),
        ("[check]\nselect = 'CG5'", "check.select must be a list"),
        ("[check]\nselect = ['CG9']", "check.select[0]: clickgen has no code 'CG9'"),
        ("[check]\nignore = ['C5']", "check.ignore[0]: clickgen has no code 'C5'"),
        ("[check]\nignore = [5]", "check.ignore[0]"),
        ("[check]\nexclude = [5]", "check.exclude[0] must be a text"),
        ("[check.per-file-ignores]\n'a.py' = 'CG5'", "check.per-file-ignores.a.py must be a list"),
        ("check = 5", "check must be a table"),
        ("programs = [5]", "programs[0] must be a table"),
        ("programs = [{ nicknames = 'a.csv' }]", "programs[0].path is missing"),
        ("programs = [{ path = 'a.py', nickname = 'a.csv' }]", "did you mean nicknames?"),
        ("programs = ['a.py', 'a.py']", "twice"),
        ('programs = ["a\\u0000.py"]', "programs[0]: no path is like 'a\\x00.py'"),
        ('programs = [{ path = "a\\u0000.py" }]', "programs[0].path: no path is like"),
        ('programs = [{ path = "a.py", output = "\\u0000" }]', "programs[0].output: no path is like"),
        ('programs = [{ path = "a.py", nicknames = "\\u0000" }]', "programs[0].nicknames: no path is like"),
        ("reserved = ['DS0']", "reserved[0] must be addresses"),
        ("reserved = ['DS9..DS3']", "reserved[0] must be addresses"),
        ("reserved = ['ZZ1']", "reserved[0] must be addresses"),
        ("reserved = ['DS1..DD3']", "reserved[0] must be addresses"),
        ("[allocation]\nDX = {}", "allocation has no bank DX; clickgen chooses addresses in X, Y, C, T, CT, DS"),
        ("[allocation]\nSD = {}", "allocation has no bank SD"),
        ("[allocation]\nDS = 5", "allocation.DS must be a table"),
        ("[allocation.DS]\nuses = []", "unknown key allocation.DS.uses; did you mean use?"),
        ("[allocation.DS]\nuse = 'DS1'", "allocation.DS.use must be a list"),
        ("[allocation.DS]\nuse = ['DD1']", "allocation.DS.use[0] must be addresses of DS, not 'DD1'"),
        ("[allocation.DS]\nstart = 100", 'allocation.DS.start must be addresses like "DS100"'),
        ("programs = [", "is not TOML"),
    ],
)
def test_what_cannot_be_used_is_named_with_its_file(tmp_path: Path, text: str, words: str) -> None:
    path = settings(tmp_path, text)
    with pytest.raises(ConfigError) as caught:
        find_config(tmp_path)
    assert str(caught.value).startswith(str(path))
    assert words in str(caught.value)


@pytest.mark.parametrize("data", [b"\xff\xfe", b"\x00"])
def test_a_file_that_is_no_text_is_told(tmp_path: Path, data: bytes) -> None:
    (tmp_path / "clickgen.toml").write_bytes(data)
    with pytest.raises(ConfigError, match="is not TOML"):
        find_config(tmp_path)


def test_a_project_file_without_settings_is_none_when_it_is_named(tmp_path: Path) -> None:
    path = settings(tmp_path, "[project]\nname = 'x'\n", "pyproject.toml")
    with pytest.raises(ConfigError, match=r"has no \[tool.clickgen\]"):
        read_config(path)


# -- building with them -----------------------------------------------------------------------------------------------


@pytest.fixture
def plant(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Two programs, one with a table and an output folder of its own."""
    monkeypatch.chdir(tmp_path)
    settings(tmp_path, PROGRAM, "one/plc.py")
    settings(tmp_path, PROGRAM, "two/plc.py")
    settings(
        tmp_path,
        """
reserved = ["DS1..DS10"]
programs = ["one/plc.py", { path = "two/plc.py", nicknames = "tables/two.csv", output = "out/two" }]
""",
    )
    (tmp_path / "tables").mkdir()
    return tmp_path


def test_every_configured_program_is_built(plant: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert main(["build"]) == 0
    assert (plant / "build/plc/main.csv").is_file()
    assert (plant / "out/two/main.csv").is_file()
    assert 'DS11,INT,"Speed"' in (plant / "one/nicknames.csv").read_text("utf-8")
    assert 'DS11,INT,"Speed"' in (plant / "tables/two.csv").read_text("utf-8")
    monkeypatch.chdir(plant / "one")
    assert main(["build", "--frozen"]) == 0


def test_a_named_program_has_its_configured_places(plant: Path) -> None:
    assert main(["build", "two/plc.py"]) == 0
    assert (plant / "out/two/main.csv").is_file()
    assert (plant / "tables/two.csv").is_file()
    assert not (plant / "one/nicknames.csv").exists()


def test_nothing_is_written_when_one_of_them_has_errors(plant: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (plant / "two/plc.py").write_text("def main():\n    out(c.A)\n", "utf-8")
    assert main(["build"]) == 1
    assert "nothing was written" in capsys.readouterr().err
    assert not (plant / "build").exists()
    assert not (plant / "one/nicknames.csv").exists()


@pytest.mark.parametrize("flags", [["-o", "x"], ["--nicknames", "x.csv"]])
def test_one_place_is_not_enough_for_several(plant: Path, flags: list[str]) -> None:
    assert main(["build", *flags]) == 2
    assert not (plant / "build").exists()


def test_two_programs_of_one_name_need_two_folders(plant: Path, capsys: pytest.CaptureFixture[str]) -> None:
    settings(plant, 'programs = ["one/plc.py", "two/plc.py"]\n')
    assert main(["build"]) == 2
    assert "two programs would be built into" in capsys.readouterr().err


def test_check_looks_at_the_configured_programs(plant: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (plant / "three").mkdir()
    (plant / "three/plc.py").write_text("def main():\n    out(c.A)\n", "utf-8")
    assert main(["check", "--output-format", "concise"]) == 0
    assert capsys.readouterr().out == "2 files checked, all is well\n"
    (plant / "one/plc.py").unlink()
    assert main(["check"]) == 2
    assert "which" in capsys.readouterr().err


def test_programs_that_share_a_table_are_built_one_on_the_other(
    plant: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """In one go: the second finds the names of the first in the table, and all is written together."""
    shared = "def main():\n    if c.{}:\n        out(c.Common)\n    if True:\n        end()\n"
    for name in ("a", "b"):
        (plant / f"{name}.py").write_text(shared.format(name.upper()))
    settings(plant, 'programs = ["a.py", "b.py"]\n')
    monkeypatch.chdir(plant)
    assert main(["build"]) == 0
    said = capsys.readouterr()
    assert said.err == ""
    assert said.out.startswith("Built a.py: ")
    assert "Files: build/b" in said.out.replace("\\", "/")
    rows = (plant / "nicknames.csv").read_text("utf-8").splitlines()[1:]
    assert [row.split(",")[:3:2] for row in rows] == [["C1", '"A"'], ["C2", '"Common"'], ["C3", '"B"']]
    assert main(["build", "--frozen"]) == 0


def test_programs_that_share_a_table_are_written_all_or_none(plant: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name, text in (("a", "out(c.X)"), ("b", "out(c.Y)")):
        (plant / f"{name}.py").write_text(f"def main():\n    if x[1]:\n        {text}\n    if True:\n        end()\n")
    settings(plant, 'programs = ["a.py", "b.py"]\n')
    monkeypatch.chdir(plant)
    (plant / "build" / "b").mkdir(parents=True)
    (plant / "build" / "b" / "main.csv").mkdir()
    assert main(["build"]) == 2
    assert not (plant / "nicknames.csv").exists()
    assert not (plant / "build" / "a").exists()


def test_allocation_keeps_to_the_settings_of_its_bank(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    text = """
reserved = ["C1"]

[allocation]
C = { start = "C3" }
ds = { use = ["DS10..DS12", "DS20"], avoid = ["DS11"] }
"""
    settings(tmp_path, text)
    monkeypatch.chdir(tmp_path)
    copies = "".join(f"        copy({number}, ds.R{number})\n" for number in range(3))
    (tmp_path / "plc.py").write_text(f"def main():\n    if c.A:\n{copies}    if True:\n        end()\n")
    assert main(["build", "plc.py"]) == 0
    rows = (tmp_path / "nicknames.csv").read_text("utf-8").splitlines()[1:]
    assert [row.split(",")[0] for row in rows] == ["C3", "DS10", "DS12", "DS20"]
    (tmp_path / "plc.py").write_text(
        "def main():\n    if c.A:\n        copy(1, ds.Fourth)\n    if True:\n        end()\n"
    )
    assert main(["build", "plc.py"]) == 1
    assert "no DS address is free for Fourth" in capsys.readouterr().err
