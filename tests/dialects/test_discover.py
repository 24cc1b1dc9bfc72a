"""The files that a check looks at: programs, files that belong to one, and files left out."""

from __future__ import annotations

import errno
import json
import os
from collections.abc import Iterator
from pathlib import Path

import pytest

from clickgen.cli import main
from clickgen.commands.check.cache import NAME, Cache, Cached, key_of
from clickgen.config import Config, ConfigError, find_config
from clickgen.device.banks import BANKS
from clickgen.dialects.discover import Target, discover, targets, wholly_judged
from clickgen.dialects.if_rungs.look import BANK_WORDS, CALL_WORDS, is_program
from clickgen.instructions import INSTRUCTIONS
from clickgen.text.patterns import matches
from clickgen.workspace import CouldNotRun, Workspace
from clickgen.workspace.digest import digest_of
from clickgen.workspace.memory import FOLDER, Memory

END = "    if True:\n        end()\n"
RUNG = "    if c.A:\n        out(c.B)\n"
CLEAN = f"def main():\n{RUNG}{END}"
PART = f"@sub\ndef fill():\n{RUNG}    if True:\n        return\n"


@pytest.fixture(autouse=True)
def _in_a_folder_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def write(path: str, text: str) -> Path:
    file = Path(path)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, "utf-8")
    return file


def here() -> Config:
    return find_config(Path.cwd())


def paths(*named: str, force: bool = False, exclude: tuple[str, ...] = ()) -> list[str]:
    return [target.path for target in targets(named, here(), exclude, force)]


# -- what is a program ------------------------------------------------------------------------------------------------

PROGRAMS = {
    "clean": CLEAN,
    "a subroutine": PART,
    "a subroutine without a word": "@sub\ndef idle():\n    if True:\n        return\n",
    "a subroutine with a name": '@sub("Auto Mode")\ndef idle():\n    if True:\n        return\n',
    "a subroutine with a name over lines": '@sub(\n    "Auto Mode",\n)  # in CLICK\ndef idle():\n    pass\n',
    "a subroutine with a comment": PART.replace("@sub", "@sub  # filling"),
    "declarations": 'nickname(x.Level, x[1], comment="full")\n',
    "a declaration over lines": "nickname(\n    x.Level,\n    x[1],\n)\n",
    "only calls": "from parts import fill\n\n\ndef main():\n    if True:\n        call(fill)\n" + END,
    "the editor's import": f"from clickgen.dsl import *\n\n\n{CLEAN}",
    "the editor's names": f"from clickgen.dsl import c, end, out\n\n\n{CLEAN}",
    "a formula": 'def main():\n    if True:\n        calc("ds.A + 1", ds.A)\n' + END,
    "a docstring at the left edge": CLEAN.replace(
        "main():\n", 'main():\n    """Fills.\n\nclass x: as it says\n    """\n'
    ),
    "a condition at the indent of the routine": CLEAN.replace("if c.A:", "if all(c.A,\n    c.B,\n    c.C,\n    c.D):"),
    "a loop": "def main():\n    if c.A:\n        for _ in range(ds.Rows):\n            pass\n",
    "a drum": "def main():\n    if c.A:\n        event_drum(\n            outputs=[y[1]],\n        ).reset(c.R)\n",
    "immediate": "def main():\n    if x.Start.immediate:\n        out(y.Lamp.immediate)\n" + END,
    "quoted names": 'def main():\n    if x["Door closed"]:\n        set(y["Lamp, red"])\n' + END,
    "edges, and a module of that name": f"import re\n\n\n{CLEAN.replace('c.A', 're(c.A)')}",
    "a merge": f"<<<<<<< HEAD\n{CLEAN}=======\n{CLEAN}>>>>>>> c\n",
    "a merge in a rung": CLEAN.replace(
        "        out(c.B)", "<<<<<<< HEAD\n    out(c.B)\n=======\n    out(c.C)\n>>>>>>> x"
    ),
    "a constant": f"SPEED = 5\n\n\n{CLEAN}",
    "a stray end": f"{CLEAN}end()\n",
    "one line, no end": "def main():\n    if c.A: set(y[1])\n",
    "and, no end": "def main():\n    if c.A and c.B:\n        copy(1, ds[1])\n",
    "bare actions": "def main():\n    out(y[1])\n    out(y[2])\n    out(y[3])\n",
    "a misspelled main": CLEAN.replace("main", "mian"),
    "a misspelled declaration": "nicknam(x.Level, x[1])\n",
    "a blank before the brackets": CLEAN.replace("main()", "main ()"),
    "async": f"async {CLEAN}",
    "a parameter": CLEAN.replace("main()", "main(args)"),
    "a missing colon": CLEAN.replace("c.A:", "c.A"),
    "no colon behind main": CLEAN.replace("main():", "main()"),
    "assignments": "def main():\n    ds.Total = ds.A + 1\n    c.Run = True\n",
    "Python around it": (
        "import time\n\nSPEED = 5\n\n\nclass Plant:\n    pass\n\n\ndef main():\n    while c.A:\n        out(y[1])\n"
        "        print(time.time())\n\n\nif __name__ == '__main__':\n    main()\n"
    ),
    "a name of its own for a bank": CLEAN.replace("main():\n", "main():\n    c = 5\n"),
    "a text that does not end": CLEAN.replace("main():\n", 'main():\n    """Fills.\n'),
    "an import of everything": f"from signals import *\n\n\n{CLEAN}",
    "decorated": CLEAN.replace("def", "@sub()\ndef"),
    "tabs": CLEAN.replace("    ", "\t"),
}
PYTHON = {
    "nothing": "",
    "the issue": (
        "import re\nimport sys\n\n\ndef main():\n    for m in re.finditer('a', sys.argv[1]):\n        print(m.end())\n"
    ),
    "argparse": (
        "import argparse\n\n\ndef main():\n    parser = argparse.ArgumentParser()\n    parser.add_argument('--out')\n"
        "    args = parser.parse_args()\n    if args.out:\n        print(args.out)\n\n\n"
        "if __name__ == '__main__':\n    main()\n"
    ),
    "click": (
        "import click\n\n\n@click.group()\ndef main():\n    pass\n\n\n@main.command()\n@click.argument('x')\n"
        "def reset(x):\n    click.echo(x[1])\n"
    ),
    "typer": (
        "import typer\n\napp = typer.Typer()\n\n\n@app.command()\ndef main(c: str, t: int = 5):\n    print(c[0], t)\n"
    ),
    "dataclass": (
        "from dataclasses import dataclass\n\n\n@dataclass\nclass Point:\n    x: int\n    y: int\n\n"
        "    def set(self, c):\n        self.x, self.y = c.x, c.y\n\n\ndef main():\n    p = Point(1, 2)\n    p.set(p)\n"
    ),
    "tests": "def test_set():\n    x = [1, 2]\n    assert x[1] == 2\n    assert any(c > 1 for c in x)\n",
    "fixture": (
        "import pytest\n\n\n@pytest.fixture\ndef c():\n    return 1\n\n\ndef test_c(c):\n    assert c.real == 1\n"
    ),
    "variables": (
        "def main():\n    x = [1, 2]\n    for c in load():\n        if c.name:\n            print(x[1], c.name)\n"
        "    y, z = x\n    print(y[0])\n"
    ),
    "builtins": (
        "def main():\n    names = set(['a'])\n    if any(name for name in names):\n        set(names)\n"
        "    if all(names):\n        return\n"
    ),
    "shutil": "from shutil import copy\n\n\ndef main():\n    for x in files():\n        copy(x[0], x[1])\n",
    "subprocess": "from subprocess import call\n\n\ndef main():\n    if True:\n        call(['ls'])\n",
    "its own words": (
        "def out(text):\n    print(text)\n\n\ndef end():\n    out('done')\n\n\n"
        "def main():\n    if True:\n        out('x[1]')\n        end()\n"
    ),
    "pandas": (
        "import pandas as pd\n\n\ndef main():\n    df = pd.read_csv('a.csv')\n    if df.empty:\n        return\n"
        "    df['x'] = df.a + df['b']\n    ds = df.to_xarray()\n    print(ds.a, ds['b'])\n"
    ),
    "with": (
        "def main():\n    with open('a') as c, open('b') as t:\n        if c.closed:\n            t.write(c.name)\n"
    ),
    "lambda": "def main():\n    rows = sorted(load(), key=lambda x: x[1])\n    print(rows)\n",
    "walrus": "def main():\n    if (t := find()) and t.name:\n        print(t[0])\n",
    "imported names": "from geometry import x, y\n\n\ndef main():\n    if x[0]:\n        print(y[0], x.name)\n",
    "imported in brackets": (
        "from geometry import (\n    x,\n    out,\n)\n\n\ndef main():\n    if x[0]:\n        out(x.a)\n"
    ),
    "a module of that name": "import c\nimport xd.deep\n\n\ndef main():\n    if c.ready:\n        print(xd.deep)\n",
    "everything imported": (
        "from tkinter import *\n\n\ndef main():\n    root = Tk()\n    end()\n    reset()\n    root.mainloop()\n"
    ),
    "a decorator named sub": (
        "from broker import sub\n\n\n@sub\ndef on_message():\n    print('got it')\n\n\ndef main():\n    on_message()\n"
    ),
    "a decorator named sub with a text": (
        "from broker import sub\n\n\n@sub('news')\ndef on_message():\n    print('got it')\n\n\n"
        "def main():\n    on_message()\n"
    ),
    "a decorator of its own named sub": (
        "def sub(topic):\n    return print\n\n\n@sub('news')\ndef on_message():\n    print('got it')\n"
    ),
    "a decorator named sub of something": "import broker\n\n\n@broker.sub('news')\ndef main():\n    print('got it')\n",
    "a ladder in a text": f'LADDER = """\n{CLEAN}"""\n\n\ndef main():\n    print(LADDER)\n',
    "a ladder in a comment": "def main():\n    print('x')\n\n# if c.A:\n#     out(y[1])\n",
    "settings of a notebook": (
        "c.ServerApp.port = 1\nc.Spawner.cmd = ['a']\n\n\ndef hook():\n    return c.ServerApp.port\n"
    ),
    "merged Python": "def main():\n<<<<<<< HEAD\n    x = [1]\n=======\n    x = [2]\n>>>>>>> end\n    print(x[0])\n",
    "old Python": "def main():\n    for c in load():\n        print c.name, c[1]\n",
    "empty main": "def main():\n    pass\n",
    "a method": (
        "class Bus:\n    def send(self, x):\n        self.c.out(x[1])\n\n\ndef main():\n    Bus().send([1, 2])\n"
    ),
}


@pytest.mark.parametrize("name", PROGRAMS)
def test_a_program_is_known_however_broken(name: str) -> None:
    assert is_program(PROGRAMS[name])


@pytest.mark.parametrize("name", PYTHON)
def test_other_python_is_left_alone(name: str) -> None:
    assert not is_program(PYTHON[name])


def test_no_module_of_pythons_own_is_a_program() -> None:
    for path in Path(os.__file__).parent.glob("*.py"):
        assert not is_program(path.read_text("utf-8", "replace")), path


def test_every_program_of_this_project_is_one() -> None:
    for path in (Path(__file__).parents[3] / "fixtures").rglob("*.py"):
        assert is_program(path.read_text("utf-8", "replace")), path


def test_no_word_of_the_language_is_missing() -> None:
    assert {name.lower() for name in BANKS} == BANK_WORDS
    assert {*INSTRUCTIONS, "nickname"} == CALL_WORDS


@pytest.mark.parametrize("name", ["a merge", "a constant", "a stray end", "one line, no end", "and, no end"])
def test_a_broken_program_in_a_folder_has_findings(name: str) -> None:
    write("plc/p.py", PROGRAMS[name])
    assert main(["check", "."]) == 1
    assert main(["check", "--force-exclude", "plc/p.py"]) == 1


# -- what is configured -----------------------------------------------------------------------------------------------


def test_a_configured_program_is_never_left_alone() -> None:
    write("clickgen.toml", 'programs = ["p.py"]\n')
    write("p.py", "from parts import fill\n")
    write("parts.py", "def fil(:\n")
    write("tool.py", PYTHON["argparse"])
    assert paths(".") == ["p.py"]
    assert paths("p.py", force=True) == ["p.py"]
    assert paths("parts.py", force=True) == ["p.py"]
    assert paths("tool.py", force=True) == []


@pytest.mark.parametrize("text", ["", PART])
def test_a_configured_program_needs_a_main(text: str, capsys: pytest.CaptureFixture[str]) -> None:
    write("clickgen.toml", 'programs = ["p.py"]\n')
    write("p.py", text)
    for arguments in ((), ("p.py",), (".",)):
        assert main(["check", *arguments]) == 1
        assert "CG401" in capsys.readouterr().out


def test_a_broken_part_is_not_left_alone_when_a_program_imports_it() -> None:
    write("p.py", f"import wiring, texts\nfrom parts import fill\n\n\n{CLEAN}")
    for name in ("wiring", "texts", "parts"):
        write(f"{name}.py", "<<<<<<<\n")
        assert paths(f"{name}.py", force=True) == ["p.py"]


def test_python_that_imports_a_part_is_no_program_of_it() -> None:
    write("parts.py", PART)
    write("tool.py", "import parts\n\n\ndef main():\n    print(parts)\n")
    assert targets(["parts.py"], here()) == [Target("parts.py", is_part=True)]


# -- what cannot be read ----------------------------------------------------------------------------------------------


def test_a_file_that_cannot_be_read_is_told(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    write("plc/p.py", CLEAN)

    def refuse(*_: object, **__: object) -> None:
        raise PermissionError(errno.EACCES, "Permission denied")

    monkeypatch.setattr("clickgen.workspace.read_start", refuse)
    assert main(["check", "plc"]) == 2
    assert "plc/p.py cannot be read: Permission denied" in capsys.readouterr().err.replace("\\", "/")
    with pytest.raises(CouldNotRun, match="cannot be read"):
        paths("plc/p.py", force=True)


def test_a_folder_that_cannot_be_read_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    write("plc/p.py", CLEAN)
    scan = os.scandir

    def refuse(path: str) -> Iterator[os.DirEntry[str]]:
        if str(path).endswith("plc"):
            raise PermissionError(errno.EACCES, "Permission denied", path)
        return scan(path)

    monkeypatch.setattr(os, "scandir", refuse)
    with pytest.raises(CouldNotRun, match="plc cannot be read: Permission denied"):
        paths(".")


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="who may everything may read everything")
def test_rights_that_are_missing_are_told() -> None:
    file = write("plc/p.py", CLEAN)
    for path in (file, file.parent):
        path.chmod(0)
        assert main(["check", "."]) == 2
        path.chmod(0o755)


@pytest.mark.skipif(os.name == "nt", reason="links need rights there")
def test_a_link_to_nowhere_is_no_source() -> None:
    write("p.py", CLEAN)
    os.symlink("nowhere", ".#p.py")
    assert paths(".") == ["p.py"]


# -- what is not there ------------------------------------------------------------------------------------------------


def test_a_folder_without_a_program_is_known() -> None:
    write("plc/p.py", CLEAN)
    write("empty/tool.py", PYTHON["argparse"])
    assert discover(["plc", "empty"], here()).empty == ("empty",)
    assert discover(["empty/tool.py"], here(), force=True) == ([], ())
    assert discover([], here()).empty == ()
    assert discover([], here(), ["plc"]).empty == (".",)


# -- a text in place of a file ----------------------------------------------------------------------------------------


def unsaved(path: str, text: str) -> Workspace:
    return Workspace({os.path.realpath(path): text.encode()})


def test_a_text_is_judged_as_the_file_it_is_given_for() -> None:
    write("p.py", f"from lib import fill\n\n\n{CLEAN}")
    write("lib.py", "")
    assert targets(["lib.py"], here(), workspace=unsaved("lib.py", PART)) == [Target("p.py")]
    assert targets(["lib.py"], here(), workspace=unsaved("lib.py", CLEAN)) == [Target("lib.py")]
    assert targets(["new.py"], here(), workspace=unsaved("new.py", CLEAN)) == [Target("new.py")]
    assert targets(["p.py"], here(), workspace=unsaved("p.py", "")) == [Target("p.py", is_part=True)]


def test_a_text_for_an_excluded_file_is_left_out_like_the_file() -> None:
    assert targets(["old/p.py"], here(), ["old"], True, unsaved("old/p.py", CLEAN)) == []


# -- whether all was judged -------------------------------------------------------------------------------------------


def whole(path: str, *judged: Target) -> bool:
    return wholly_judged([path], judged, here()) == {path}


def test_a_part_is_wholly_judged_with_every_program_that_imports_it() -> None:
    for name in ("a", "b"):
        write(f"{name}.py", f"from lib import fill\n\n\n{CLEAN}")
    write("lib.py", PART)
    write("lone.py", PART)
    a, b = Target("a.py"), Target("b.py")
    assert whole("a.py", a)
    assert not whole("lib.py", a)
    assert whole("lib.py", a, b)
    assert not whole("lone.py", Target("lone.py", is_part=True))


def test_a_program_that_others_import_is_wholly_judged_with_them() -> None:
    write("a.py", f"from b import fill\n\n\n{CLEAN}")
    write("b.py", f"{PART}\n\n{CLEAN}")
    a, b = Target("a.py"), Target("b.py")
    assert not whole("b.py", a)
    assert not whole("b.py", b)
    assert whole("b.py", a, b)


# -- patterns ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("pattern", "path"),
    [
        ("old", "old/p.py"),
        ("old", "plc/old/deep/p.py"),
        ("old/", "plc/old/p.py"),
        ("./old", "old/p.py"),
        ("/old", "old/p.py"),
        ("p.py", "plc/p.py"),
        ("p*", "plc/p.py"),
        ("plc/p.py", "plc/p.py"),
        ("plc/*", "plc/deep/p.py"),
        ("plc/*.py", "plc/p.py"),
        ("plc/**", "plc/deep/p.py"),
        ("plc/**/*.py", "plc/p.py"),
        ("plc/**/*.py", "plc/a/b/p.py"),
        ("**/old", "old/p.py"),
        ("**/old/*.py", "a/old/p.py"),
        ("a/**/b", "a/b/p.py"),
        ("*", "plc/p.py"),
        ("[op]*", "plc/p.py"),
    ],
)
def test_a_pattern_meets(pattern: str, path: str) -> None:
    assert matches(pattern, path, Path.cwd())
    assert matches(pattern, Path.cwd() / path, os.curdir)


@pytest.mark.parametrize(
    ("pattern", "path"),
    [
        ("old", "older/p.py"),
        ("/old", "plc/old/p.py"),
        ("./p.py", "plc/p.py"),
        ("deep/p.py", "plc/deep/p.py"),
        ("plc/*.py", "plc/deep/p.py"),
        ("plc/p", "plc/p.py"),
        ("plc/p.py/x", "plc/p.py"),
        ("**/old", "plc/p.py"),
        ("/", "plc/p.py"),
        ("", "plc/p.py"),
    ],
)
def test_a_pattern_does_not_meet(pattern: str, path: str) -> None:
    assert not matches(pattern, path, Path.cwd())


def test_a_pattern_with_the_whole_path_meets() -> None:
    assert matches(f"{Path.cwd().as_posix()}/old", "old/p.py", Path.cwd())


@pytest.mark.parametrize("pattern", ["./sub", "/sub", "sub/", "sub/**/*.py", "sub/*.py"])
def test_excluded_folders_are_left_out(pattern: str) -> None:
    write("sub/p.py", CLEAN)
    write("q.py", CLEAN)
    assert paths(".", exclude=(pattern,)) == ["q.py"]


@pytest.mark.parametrize("pattern", ["", "/", "..", "../old", "!old", "old\\\\p.py"])
@pytest.mark.parametrize("key", ['exclude = ["{}"]', 'per-file-ignores = {{ "{}" = ["CG5"] }}'])
def test_a_pattern_that_can_never_meet_is_refused(key: str, pattern: str) -> None:
    write("clickgen.toml", f"[check]\n{key.format(pattern)}\n")
    with pytest.raises(ConfigError, match="no path is like"):
        here()


# -- the cache --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "damage",
    [
        {"reads": []},
        {"reads": {}},
        {"findings": [["CG999", "m", None, "", [], None]]},
        {"findings": [["CG501", "m", ["p.py", "one", 1, 1, 1], "", [], None]]},
        {"findings": [["CG501", "m", ["p.py", 1], "", [], None]]},
        {"findings": [["CG501", "m", None, "", 5, None]]},
        {"findings": [["CG501", "m", None, "", [], []]]},
        {"findings": [5]},
        {"findings": None},
        {"sources": ["nowhere.py"]},
        {"sources": "p.py"},
        {"sources": [5]},
    ],
    ids=json.dumps,
)
def test_a_damaged_entry_is_no_cache(damage: dict[str, object]) -> None:
    """Even with the mark of this user: the mark says who wrote it, not that it is sound."""
    file = write("p.py", CLEAN)
    key, cached = key_of("p.py"), Cached((), ("p.py",))
    memory = Memory(Path.cwd())
    Cache(Workspace(memory=memory)).put(key, cached, {"p.py": file.read_bytes()})
    memory.save()
    assert remembered(key) == cached
    path = Path(FOLDER, NAME)
    mark, body = path.read_bytes().split(b"\n", 1)
    damaged = {key: json.loads(body)[key] | damage}
    path.write_bytes(mark + b"\n" + json.dumps(damaged).encode())
    assert remembered(key) is None
    memory.put(NAME, damaged)
    memory.save()
    assert remembered(key) is None


def remembered(key: str) -> Cached | None:
    """What a new process finds in the cache."""
    return Cache(Workspace(memory=Memory(Path.cwd()))).get(key)


@pytest.mark.parametrize("damage", [5, [], {"": 5}, {"": [True, True]}, {"": [1, 1, []]}, None], ids=repr)
def test_a_damaged_discovery_is_made_anew(damage: object) -> None:
    """An unchanged file is not looked through again, unless what is remembered of it has another form."""
    file = write("p.py", CLEAN)
    found = targets(["."], find_config(Path.cwd()))
    memory = Memory(Path.cwd())
    if isinstance(damage, dict):
        damage = {digest_of(file.read_bytes()): one for one in damage.values()}
    memory.put("discovered.json", damage)
    memory.save()
    workspace = Workspace(memory=Memory(Path.cwd()))
    assert targets(["."], find_config(Path.cwd()), workspace=workspace) == found != []
