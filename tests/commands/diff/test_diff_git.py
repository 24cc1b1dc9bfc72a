"""``clickgen diff``: revisions of a git repository."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest
from diffing import RUNGS, SUB, TABLE, Run, build, bundle, git, program, run, write

from clickgen.cli import main
from clickgen.click.ladder_csv import HEADER
from clickgen.commands.diff.revision import named_revision

__all__ = ["bundle", "run"]


# -- git ---------------------------------------------------------------------------------------------------------------


@pytest.fixture
def repository(run: Run) -> Run:
    """A repository with prog.py and its table, committed."""
    git("init", "--quiet", "--initial-branch=main")
    write("prog.py", program(*RUNGS))
    assert main(["nicknames", "sync", "prog.py"]) == 0
    commit()
    return run


def commit() -> None:
    git("add", "--all")
    git("commit", "--quiet", "--message=x")


CHANGED_RUNGS = (RUNGS[0].replace("nc(c.EStop)", "c.EStop"), *RUNGS[1:])


def test_a_revision(repository: Run, capsys: pytest.CaptureFixture[str]) -> None:
    capsys.readouterr()
    assert repository("HEAD:prog.py", "prog.py").code == 0
    write("prog.py", program(*CHANGED_RUNGS))
    status = git("status", "--porcelain")
    said = repository("HEAD:prog.py", "prog.py")
    assert said.code == 1
    assert said.out.startswith("--- HEAD:prog.py\n+++ prog.py\n")
    assert said.lines[:5] == [
        "main",
        "  rung 1 changed",
        "      | Start and stop",
        "    - if C1:Start and not C2:EStop",
        "    + if C1:Start and C2:EStop",
    ]
    assert repository(":prog.py", "prog.py").code == 1
    git("add", "prog.py")
    assert repository(":prog.py", "prog.py").code == 0
    assert repository(":prog.py", "HEAD:prog.py").code == 1
    git("reset", "--quiet")
    assert git("status", "--porcelain") == status
    commit()
    assert repository("HEAD~1:prog.py", "main:prog.py").code == 1
    assert repository("HEAD^{/x}:prog.py", "prog.py").code == 0


def test_a_revision_has_its_own_surroundings(repository: Run, capsys: pytest.CaptureFixture[str]) -> None:
    """Table, settings and imported files are those of the revision, and files deleted from disk are there."""
    write("plc/clickgen.toml", 'programs = [{ path = "line.py", nicknames = "names/line.csv" }]\n')
    write("plc/names/line.csv", TABLE + 'C77,BIT,"Wash",0,No,"old"\n')
    write("plc/parts.py", SUB.strip() + "\n")
    write("plc/line.py", "from parts import wash\n\n\n" + program("    if c.Go:\n        call(wash)\n"))
    commit()
    git("rm", "-r", "--quiet", "plc/names", "plc/clickgen.toml", "plc/parts.py")
    write("plc/line.py", program("    if c.Go:\n        call(wash)\n", sub=SUB))
    os.chdir("plc")
    capsys.readouterr()
    said = repository("HEAD:line.py", "line.py")
    assert said.out.startswith("--- HEAD:plc/line.py\n+++ line.py\n")
    assert "    - if C77:Wash" in said.lines
    assert said.err == ""
    assert repository("HEAD:./line.py", "HEAD:plc/line.py").code == 0


def test_named_settings_and_tables_are_those_of_the_revision(
    repository: Run, capsys: pytest.CaptureFixture[str]
) -> None:
    write("conf/own.toml", 'reserved = ["C1..C100"]\nprograms = [{ path = "../prog.py", nicknames = "empty.csv" }]\n')
    write("conf/empty.csv", TABLE)
    commit()
    write("conf/own.toml", 'reserved = ["C1..C200"]\nprograms = [{ path = "../prog.py", nicknames = "empty.csv" }]\n')
    write("conf/empty.csv", TABLE + 'C777,BIT,"EStop",0,No,""\n')
    capsys.readouterr()
    said = repository("HEAD:prog.py", "prog.py", "--config", "conf/own.toml")
    assert "    - if C101:Start and not C102:EStop" in said.lines
    assert "    + if C201:Start and not C777:EStop" in said.lines
    said = repository("HEAD:prog.py", "prog.py", "--nicknames", "conf/empty.csv")
    assert "    - if C1:Start and not C2:EStop" in said.lines
    assert "    + if C1:Start and not C777:EStop" in said.lines
    # A file that the revision does not have is read from disk.
    write("conf/new.csv", TABLE + 'C888,BIT,"EStop",0,No,""\n')
    assert repository("HEAD:prog.py", "prog.py", "--nicknames", "conf/new.csv").code == 0


def test_what_is_not_merged_is_not_in_the_index(repository: Run, capsys: pytest.CaptureFixture[str]) -> None:
    git("switch", "--quiet", "--create", "other")
    write("prog.py", program(*CHANGED_RUNGS))
    commit()
    git("switch", "--quiet", "main")
    write("prog.py", program(RUNGS[0].replace("c.Start", "c.Go"), *RUNGS[1:]))
    commit()
    with pytest.raises(subprocess.CalledProcessError):
        git("merge", "other")
    capsys.readouterr()
    said = repository(":prog.py", "HEAD:prog.py")
    assert (said.code, said.err) == (2, "clickgen: :prog.py is not merged: there is no file to compare\n")


def test_the_root_comes_first_as_for_git(repository: Run, capsys: pytest.CaptureFixture[str]) -> None:
    write("sub/prog.py", program(*CHANGED_RUNGS))
    commit()
    os.chdir("sub")
    capsys.readouterr()
    said = repository("HEAD:prog.py", "../prog.py")
    assert said.code == 0
    assert said.err == (
        "clickgen: HEAD:prog.py is prog.py of the repository's root, as for git; "
        "the one in the working folder is HEAD:./prog.py\n"
    )
    assert repository("HEAD:./prog.py", "HEAD:../prog.py").code == 1


def test_a_bundle_of_a_revision(repository: Run, capsys: pytest.CaptureFixture[str]) -> None:
    build("prog.py", "out/prog", capsys)
    commit()
    write("prog.py", program(*CHANGED_RUNGS))
    said = repository("HEAD:out/prog", "prog.py")
    assert said.code == 1
    assert "    - if C1:Start and not C2:EStop" in said.lines
    assert repository("HEAD:out/prog/main.csv", "HEAD:prog.py").code == 0
    assert repository("HEAD:out/prog/", "HEAD:out/prog").code == 0


def test_a_path_that_is_there_wins(repository: Run, capsys: pytest.CaptureFixture[str]) -> None:
    if os.name == "nt":
        pytest.skip("no colon in a file name")
    write("HEAD:prog.py", program(*CHANGED_RUNGS))
    capsys.readouterr()
    assert repository("HEAD:prog.py", "prog.py").code == 1


def test_a_program_of_a_revision_with_errors(repository: Run, capsys: pytest.CaptureFixture[str]) -> None:
    write("prog.py", "import gone\n\n\n" + program("    if c.A:\n        nothing(c.B)\n"))
    commit()
    capsys.readouterr()
    said = repository("HEAD:prog.py", "HEAD~1:prog.py")
    assert said.code == 2
    assert "HEAD:prog.py:6:9: error[" in said.err
    assert "6 |         nothing(c.B)" in said.err
    assert "there is no file HEAD:gone.py" in said.err
    assert "clickgen-" not in said.err


@pytest.mark.parametrize(
    ("side", "reason"),
    [
        ("nowhere:prog.py", "git knows no revision nowhere"),
        ("--all:prog.py", "git knows no revision --all"),
        ("HEAD:other.py", "the revision HEAD has no other.py"),
        ("HEAD:../prog.py", "the revision HEAD has no ../prog.py"),
        ("HEAD:", "names no file or folder"),
        ("HEAD:/etc/prog.py", "names no file or folder"),
        ("HEAD:link.py", "HEAD:link.py is a link"),
        ("HEAD:large.py", "is kept in Git LFS"),
        ("HEAD:large/", "is kept in Git LFS"),
        ("HEAD:empty", "HEAD:empty holds neither main.csv"),
    ],
)
def test_what_a_revision_lacks(repository: Run, capsys: pytest.CaptureFixture[str], side: str, reason: str) -> None:
    pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 12\n"
    write("large.py", pointer)
    write("large/main.csv", pointer)
    write("empty/note.txt", "")
    if os.name != "nt":
        os.symlink("prog.py", "link.py")
    commit()
    capsys.readouterr()
    said = repository("--", side, "prog.py")
    assert (said.code, said.out) == (2, "")
    assert reason in said.err
    assert "clickgen-" not in said.err


def test_no_name_of_a_tree_leaves_the_folder(repository: Run) -> None:
    """Trees that git itself would never make."""

    def hashed(kind: str, data: bytes) -> str:
        command = ["git", "hash-object", "-t", kind, "-w", "--literally", "--stdin"]
        return subprocess.run(command, input=data, capture_output=True, check=True).stdout.decode().strip()

    def tree(mode: str, name: str, what: str) -> bytes:
        return f"{mode} {name}\0".encode() + bytes.fromhex(what)

    blob = hashed("blob", b"evil")
    inner = hashed("tree", tree("100644", "main.csv", blob))
    main_csv = hashed("blob", (",".join(HEADER) + "\n").encode())
    up = hashed("tree", tree("40000", "..", inner) + tree("100644", "main.csv", main_csv))
    root = hashed("tree", tree("40000", "plc", up))
    said = repository(f"{root}:plc", "prog.py")
    assert said.code == 2
    assert "plc/../main.csv is no name that a file can have here" in said.err


@pytest.mark.skipif(not shutil.which("git"), reason="there is no git")
def test_without_a_repository(run: Run, bundle: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GIT_CEILING_DIRECTORIES", str(Path.cwd().parent))
    assert "in no git repository" in run("HEAD:prog.py", bundle).err
    monkeypatch.setenv("PATH", "")
    said = run("HEAD:prog.py", bundle)
    assert (said.code, "needs git" in said.err) == (2, True)


@pytest.mark.parametrize(
    ("text", "named"),
    [
        ("HEAD~1:prog.py", ("HEAD~1", "prog.py")),
        ("main@{10:30}:a/prog.py", ("main@{10:30}", "a/prog.py")),
        (":prog.py", ("", "prog.py")),
        ("v1:./prog.py", ("v1", "./prog.py")),
        ("C:prog.py", ("C", "prog.py")),
        ("C:\\x\\prog.py", None),
        ("c:/x/prog.py", None),
        ("C:", None),
        ("prog.py", None),
    ],
)
def test_what_names_a_revision(text: str, named: tuple[str, str] | None) -> None:
    found = named_revision(text)
    assert (tuple(found) if found else None) == named


# -- revisions and folders without a program's name --------------------------------------------------------------------


def test_two_revisions_without_a_path_are_the_only_program(repository: Run) -> None:
    write("prog.py", program(*CHANGED_RUNGS))
    commit()
    repository("prog.py", "prog.py")  # Its earlier names were given.
    named = repository("HEAD~1:./prog.py", "HEAD:./prog.py")
    assert named.code == 1
    assert repository("HEAD~1", "HEAD") == named
    for sides in (("HEAD~1", "prog.py"), ("HEAD~1", "HEAD:prog.py"), ("HEAD~1", ":prog.py"), ("HEAD~1", "HEAD", "-q")):
        assert repository(*sides).code == 1
    assert repository("HEAD", "prog.py").code == 0


def test_two_revisions_without_a_path_are_every_program_of_the_settings(repository: Run) -> None:
    write("packer/packer.py", program(*RUNGS))
    write("clickgen.toml", 'programs = ["prog.py", "packer/packer.py"]\n')
    commit()
    write("packer/packer.py", program(*CHANGED_RUNGS))
    commit()
    repository("prog.py", "prog.py")
    said = repository("HEAD~1", "HEAD")
    assert said.code == 1
    assert said.out.startswith("--- HEAD~1:prog.py\n")
    assert "--- HEAD~1:packer/packer.py\n+++ HEAD:packer/packer.py\n" in said.out
    told = repository("HEAD~1", "HEAD", "--output-format", "json")
    found = json.loads(told.out)
    assert (told.code, found["version"], found["differs"]) == (1, 1, True)
    assert [(each["old"], each["differs"]) for each in found["programs"]] == [
        ("HEAD~1:prog.py", False),
        ("HEAD~1:packer/packer.py", True),
    ]
    assert repository("HEAD~1", "packer/packer.py").code == 1


def test_a_program_that_came_or_went_with_a_revision(repository: Run) -> None:
    write("clickgen.toml", 'programs = ["prog.py"]\n')
    commit()
    write("packer/packer.py", program(*RUNGS))
    write("clickgen.toml", 'programs = ["prog.py", "packer/packer.py"]\n')
    commit()
    repository("prog.py", "prog.py")
    said = repository("HEAD~1", "HEAD")
    assert said.code == 1
    assert "HEAD:packer/packer.py is new: there is no packer/packer.py in HEAD~1\n" in said.out
    assert "main added" in said.out
    back = repository("HEAD", "HEAD~1", "-q")
    assert back.code == 1
    assert "HEAD:packer/packer.py was removed: there is no packer/packer.py in HEAD~1\n" in back.out
    found = json.loads(repository("HEAD~1", "HEAD", "--output-format", "json").out)
    assert [(each["old"], each["new"], each["differs"]) for each in found["programs"]] == [
        ("HEAD~1:prog.py", "HEAD:prog.py", False),
        (None, "HEAD:packer/packer.py", True),
    ]
    # Gone with its line in the settings.
    Path("packer/packer.py").unlink()
    write("clickgen.toml", 'programs = ["prog.py"]\n')
    commit()
    said = repository("HEAD~1", "HEAD")
    assert said.code == 1
    assert "HEAD~1:packer/packer.py was removed: there is no packer/packer.py in HEAD\n" in said.out
    # In neither revision, and without settings: the only program is new.
    write("late.py", program(*RUNGS))
    write("clickgen.toml", 'programs = ["prog.py", "late.py"]\n')
    assert repository("HEAD", "HEAD").code == 0


def test_the_only_program_may_be_new(repository: Run) -> None:
    git("mv", "prog.py", "plant.py")
    commit()
    repository("plant.py", "plant.py")
    said = repository("HEAD~1", "HEAD")
    assert (said.code, "HEAD:plant.py is new" in said.out) == (1, True)


def test_a_program_with_errors_among_several(repository: Run) -> None:
    write("bad.py", program("if c.A AND:\n        out(y[1])"))
    write("clickgen.toml", 'programs = ["prog.py", "bad.py"]\n')
    commit()
    write("prog.py", program(*CHANGED_RUNGS))
    commit()
    repository("prog.py", "prog.py")
    said = repository("HEAD~1", "HEAD", "--output-format", "json")
    assert said.code == 2
    assert [each["differs"] for each in json.loads(said.out)["programs"]] == [True, None]


@pytest.mark.parametrize(
    "sides", [("HEDA", "HEAD"), ("HEAD", "HEDA"), ("HEDA", "HEDB"), ("HEDA", "prog.py"), ("prog.py", "HEDA")]
)
def test_an_unknown_revision_is_named(repository: Run, sides: tuple[str, str]) -> None:
    repository("prog.py", "prog.py")
    for several in (False, True):
        if several:
            write("other.py", program(*RUNGS))
            write("clickgen.toml", 'programs = ["prog.py", "other.py"]\n')
        said = repository(*sides)
        assert (said.code, said.out) == (2, "")
        assert "there is no file, folder or revision 'HEDA'" in said.err


def test_a_revision_that_could_be_any_of_several_programs_names_them(repository: Run) -> None:
    write("other.py", program(*RUNGS))
    commit()
    said = repository("HEAD~1", "HEAD")
    assert said.code == 2
    assert "HEAD~1 does not say which program: write one of HEAD~1:other.py, HEAD~1:prog.py" in said.err
    assert repository("HEAD", "other.py").code == 0


def test_a_folder_of_programs_is_its_program(repository: Run) -> None:
    write("plant/prog.py", program(*RUNGS))
    commit()
    write("plant/prog.py", program(*CHANGED_RUNGS))
    commit()
    repository("prog.py", "prog.py")
    named = repository("HEAD~1:plant/prog.py", "HEAD:plant/prog.py")
    assert named.code == 1
    for sides in (("HEAD~1:plant/", "HEAD:plant/"), ("HEAD~1:plant", "HEAD:plant"), ("HEAD~1:./plant/", "HEAD:plant")):
        assert repository(*sides) == named
    assert repository("HEAD~1:plant/", "plant").code == repository("HEAD~1:plant", "plant/").code == 1
    assert repository("HEAD:plant/", "plant").code == 0
    write("plant/other.py", program(*RUNGS))
    commit()
    said = repository("HEAD:plant/", "plant")
    assert said.code == 2
    assert "has several programs: name one of HEAD:plant/other.py, HEAD:plant/prog.py" in said.err
    # A folder of ladder is one of ladder.
    assert main(["build", "plant/prog.py", "-o", "out"]) == 0
    commit()
    assert repository("HEAD:out/", "plant/prog.py").code == 0
