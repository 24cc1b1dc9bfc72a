"""Ratios measured in one run, for this machine: never quote a single time of it.

Times are those of the processor, user and system, of whole processes that run in turn: a busy machine changes them less
than the time of the clock.

cold build and cold check of 2,000 rungs against a bare libcst.parse_module of the same file, and their memory;
rebuild and recheck after one rung of 2,000 in 20 files changed, against the revision `BEFORE`, where git has it;
a program of one rung with a formula, built again after a change of its table, against a bare python -c pass;
growth of the build from 500 to 4,000 rungs;
a repeated check, and its growth with the number of files, against a bare python -c pass;
growth of nicknames sync, nicknames check, with a CSV and with a workbook, and workbook with the rows of the table;
nicknames check, nicknames sync and workbook of 10,000 names, and diff of two bundles, against a build of the same;
import of bundles of 500 and of 4,000 rungs against pyrung's ladder_to_pyrung of the same bundle;
clickgen --version against the same.
"""

from __future__ import annotations

import csv
import io
import os
import shutil
import statistics
import subprocess
import sys
import tarfile
import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from clickgen.device.banks import BANKS

RUNS = 7
PER_ROUTINE = 200
FILES = 100
BEFORE = "6a254e8"
"""The last revision that read programs without libcst."""


def rung(number: int) -> str:
    """One rung of a believable mixture: contacts, timers, counters, copies, mathematics, branches."""
    n = number
    kinds: tuple[Callable[[], str], ...] = (
        lambda: f"    # Start {n}\n    if all(c.Start{n % 50}, nc(x[1])):\n        out(c.Motor{n})\n",
        lambda: (
            f"    if any(c.Start{n % 50}, all(c.Auto{n % 90}, nc(c.Stop{n % 30}))):\n        set(c.Run{n})\n"
            f"        copy(ds.Recipe{n % 40}, ds.Target{n % 300})\n"
        ),
        lambda: f"    if c.Run{n - 1}:\n        ton(t.Delay{n}, setpoint=5, unit=Ts)\n",
        lambda: (
            f"    if ds.Recipe{n % 40} == {n % 100}:\n"
            f'        calc("ds.Recipe{n % 40} * 10 + ds.Target{n % 300}", ds.Result{n % 100})\n'
        ),
        lambda: (
            f"    if re(c.Start{n % 50}):\n"
            + (
                f"        ctu(ct.Parts{n // 8}, setpoint=5, reset=lambda: c.Stop{n % 30})\n"
                if n < 2000
                else f"        copy(ds.Recipe{n % 40}, dd.Total{n % 90}, oneshot=True)\n"
            )
        ),
        lambda: "    if True:\n        copy_block(ds[4001:4005], ds[4100])\n        copy_fill(0, ds[4200:4210])\n",
        lambda: (
            f"    if c.Stop{n % 30}:\n        out(y[{n % 16 + 1}])\n        if c.Auto{n % 90}:\n"
            f"            reset(c.Run{n - 5})\n"
        ),
        lambda: (
            f"    if all(c.A1, c.A2, any(c.A3, c.A4), nc(c.A5), ds.Recipe{n % 40} > {n % 7}):\n"
            f"        out(c.Lamp{n % 99})\n"
        ),
    )
    return kinds[n % len(kinds)]()


def program(rungs: int, per_routine: int = PER_ROUTINE) -> str:
    """A program of this many rungs in routines of this many, and a main that calls them."""
    routines = []
    names = []
    for start in range(0, rungs, per_routine):
        name = f"part_{start // per_routine}"
        names.append(name)
        body = "\n".join(rung(number) for number in range(start, min(start + per_routine, rungs)))
        routines.append(f"@sub\ndef {name}():\n{body}\n    if True:\n        return\n")
    calls = "\n".join(f"        call({name})" for name in names)
    main = f"def main():\n    if True:\n{calls}\n\n    if True:\n        end()\n"
    return "\n\n".join((main, *routines))


def clean_program(rungs: int) -> str:
    """A program of this many rungs without any problem."""
    body = "\n".join(
        f"    # Motor {n}\n    if all(c[{n + 1}], nc(x[{n % 16 + 1}])):\n        out(c[{n + 1001}])\n"
        for n in range(rungs)
    )
    return f"def main():\n{body}\n    if True:\n        end()\n"


def project(rows: int, folder: Path) -> Path:
    """A program that uses half of the names of an address table of this many rows."""
    banks = [bank for bank in BANKS.values() if bank.allocatable and bank.name not in ("X", "Y")]
    share = rows / sum(bank.last for bank in banks)
    names = {bank: [f"{bank.name}_value_{n}" for n in range(1, round(bank.last * share) + 1)] for bank in banks}
    lines = ["Address,Data Type,Nickname,Initial Value,Retentive,Address Comment"]
    rungs = []
    for bank, own in names.items():
        rest = f"{'' if bank.name == 'TXT' else 0},{'Yes' if bank.retentive else 'No'}"
        lines += [f'{bank.name}{n},{bank.kind.value},"{name}",{rest},"value {n}"' for n, name in enumerate(own, 1)]
        quarter = 0 if bank.name in ("T", "CT") else len(own) // 4
        for one, other in zip(own[:quarter], own[len(own) - quarter :], strict=True):
            action = f"out(c.{other})" if bank.is_bit else f"copy({bank.dsl}.{one}, {bank.dsl}.{other})"
            rungs.append(f"    if {f'c.{one}' if bank.is_bit else 'x[1]'}:\n        {action}\n")
    folder.mkdir()
    (folder / "nicknames.csv").write_text("\n".join((*lines, "")))
    (folder / "plc.py").write_text(f"def main():\n{''.join(rungs)}    if True:\n        end()\n")
    return folder / "plc.py"


def with_workbook(project: Path) -> Path:
    """The same program in a folder of its own, its address table as a workbook."""
    import openpyxl

    folder = project.parent / "listed"
    if not folder.exists():
        folder.mkdir()
        (folder / "plc.py").write_text(project.read_text())
        book = openpyxl.Workbook(write_only=True)
        sheet = book.create_sheet("IO")
        with (project.parent / "nicknames.csv").open(newline="") as file:
            for row in csv.reader(file):
                sheet.append(row)
        book.save(folder / "io.xlsx")
    return folder / "plc.py"


class Spent(NamedTuple):
    """Seconds of the processor, and the most memory in kilobytes (on macOS in bytes)."""

    seconds: float
    memory: int


def spent(
    command: Sequence[str], env: Mapping[str, str] | None = None, cwd: Path | None = None, may_fail: bool = False
) -> Spent:
    """What a process and those that it starts take."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=env, cwd=cwd)
    _, status, used = os.wait4(process.pid, 0)
    if status and not may_fail:
        raise SystemExit(f"{' '.join(command)} failed: {status}")
    return Spent(used.ru_utime + used.ru_stime, used.ru_maxrss)


def seconds(command: Sequence[str], before: Callable[[], None]) -> float:
    before()
    return spent(command).seconds


def compare(command: Sequence[str], other: Sequence[str], before: Callable[[], None]) -> tuple[float, float]:
    """The medians of both commands, run in turn."""
    pairs = [(seconds(command, before), seconds(other, before)) for _ in range(RUNS + 1)][1:]
    return statistics.median(one for one, _ in pairs), statistics.median(two for _, two in pairs)


def plant_of_files(folder: Path) -> Callable[[int], None]:
    """A program of 2,000 rungs in 20 files; what is returned changes one rung of one of them."""
    folder.mkdir()
    (folder / "clickgen.toml").write_text("")

    def write(number: int, edit: int = 0) -> None:
        body = "\n".join(rung(n) for n in range(number * 100, number * 100 + 100))
        last = f"    if ds.Recipe1 == {edit}:\n        out(c.Extra1)\n\n    if True:\n        return\n"
        (folder / f"file{number}.py").write_text(f"@sub\ndef part_{number}():\n{body}\n{last}")

    for number in range(20):
        write(number)
    taken = "\n".join(f"from file{number} import part_{number}" for number in range(20))
    calls = "\n".join(f"        call(part_{number})" for number in range(20))
    (folder / "plc.py").write_text(f"{taken}\n\n\ndef main():\n    if True:\n{calls}\n\n    if True:\n        end()\n")
    return lambda edit: write(7, edit)


def earlier(folder: Path) -> dict[str, str] | None:
    """The environment in which Python finds clickgen as it was at `BEFORE`; None where git does not have it."""
    root = Path(__file__).parents[1]
    found = subprocess.run(["git", "archive", "--format=tar", BEFORE], cwd=root, capture_output=True, check=False)
    if found.returncode:
        return None
    with tarfile.open(fileobj=io.BytesIO(found.stdout)) as archive:
        archive.extractall(folder, filter="data")
    return {**os.environ, "PYTHONPATH": str(folder)}


def one_edit(folder: Path, clickgen: Sequence[str]) -> None:
    """Rebuild and recheck after an edit, as a share of what they took at `BEFORE`."""
    before = earlier(folder / "before")
    if before is None:
        print(f"rebuild and recheck after one edit: git has no revision {BEFORE} to compare with")
        return
    plants = {
        name: (folder / name, plant_of_files(folder / name), env) for name, env in (("new", None), ("old", before))
    }
    taken: dict[str, list[tuple[float, float]]] = {"new": [], "old": []}
    for number in range(RUNS + 1):
        for name, (plant, change, env) in plants.items():
            change(number)
            build = spent([*clickgen, "build", "plc.py", "-o", "out"], env, plant)
            check = spent([*clickgen, "check", "--exit-zero", "-q", "-o", "report.txt", "plc.py"], env, plant)
            if number:
                taken[name].append((build.seconds, check.seconds))
    build_new, check_new, build_old, check_old = (
        statistics.median(pair[part] for pair in taken[name]) for name in ("new", "old") for part in (0, 1)
    )
    ratio = (build_new + check_new) / (build_old + check_old)
    print(
        f"rebuild and recheck after one edit / at {BEFORE}: {ratio:.2f} (at most 0.5; aim 0.35); "
        f"rebuild {build_new / build_old:.2f}, recheck {check_new / check_old:.2f}"
    )


def one_formula(folder: Path, clickgen: Sequence[str]) -> None:
    """A small program, built again after a change of its table, as a multiple of a bare Python."""
    folder.mkdir()
    path, table = folder / "plc.py", folder / "nicknames.csv"
    path.write_text('def main():\n    if c.A:\n        calc("ds.In * 2", ds.Out)\n    if True:\n        end()\n')
    count = 0

    def change() -> None:
        nonlocal count
        count += 1
        table.write_text(
            f"Address,Data Type,Nickname,Initial Value,Retentive,Address Comment\nDS{count},INT,In,0,Yes,\n"
        )

    (folder / "clickgen.toml").write_text("")
    build = [*clickgen, "build", str(path), "-o", str(folder / "out"), "--config", str(folder / "clickgen.toml")]
    again, bare = compare(build, [sys.executable, "-c", "pass"], change)
    print(
        f"one rung with a formula, built after a change of its table / python -c pass: {again / bare:.1f} (at most 8)"
    )


def cpu(command: Sequence[str], before: Callable[[], None]) -> float:
    """Return the CPU seconds of a process, user and system. A command that finds a difference exits with 1."""
    before()
    return spent(command, may_fail=True).seconds


def share(command: Sequence[str], other: Sequence[str], before: Callable[[], None]) -> float:
    """Return the CPU time of a command as a share of another's: the median of pairs that run in turn."""
    pairs = [(cpu(command, before), cpu(other, before)) for _ in range(RUNS + 1)][1:]
    return statistics.median(one / two for one, two in pairs)


def against_a_build(folder: Path, clickgen: Sequence[str]) -> None:
    """Measure the commands about names, the workbook and a diff against a build of the same program."""
    path, output = folder / "table10000" / "plc.py", folder / "against"

    def fresh() -> None:
        shutil.rmtree(output, ignore_errors=True)
        output.mkdir()

    build = [*clickgen, "build", "--no-cache", str(path), "-o", str(output / "built")]
    for what, command, most in (
        ("nicknames check", ["nicknames", "check", str(path)], 1.2),
        ("nicknames sync", ["nicknames", "sync", str(path)], 1.1),
        ("workbook", ["workbook", "-o", str(output / "project.xlsx"), str(path)], 3),
    ):
        found = share([*clickgen, *command], build, fresh)
        print(f"{what} of 10,000 names / a build of them, CPU: {found:.2f} (at most {most})")

    sources = folder / "compared"
    sources.mkdir()
    text = program(2000)
    bundles = []
    for name, changed in (("one", text), ("other", text.replace("all(c.A1, c.A2,", "all(c.A2,", 40))):
        (sources / f"{name}.py").write_text(changed)
        bundles.append(str(sources / name))
        command = [*clickgen, "build", "--no-cache", str(sources / f"{name}.py"), "-o", bundles[-1]]
        subprocess.run(command, check=True, capture_output=True)
    build = [*clickgen, "build", "--no-cache", str(sources / "one.py"), "-o", str(output / "built")]
    found = share([*clickgen, "diff", *bundles], build, fresh)
    print(f"diff of two bundles of 2,000 rungs / a build of one, CPU: {found:.2f} (at most 1)")


def imports(folder: Path, clickgen: Sequence[str], subroutines: int, rungs: int) -> tuple[float, float]:
    """Importing a bundle without and with verification, each as a share of pyrung's time for the same, CPU."""
    path, bundle = folder / f"imported{rungs}" / "prog.py", folder / f"bundle{rungs}"
    path.parent.mkdir()
    path.write_text(program(subroutines * rungs, rungs))
    subprocess.run([*clickgen, "build", "--no-cache", str(path), "-o", str(bundle)], check=True, capture_output=True)
    routines = list(bundle.rglob("*.csv"))
    count = sum(file.read_text().count("\nR,") for file in routines if file.name != "nicknames.csv")
    print(f"a bundle of {count} rungs in {len(routines) - 1} files:")
    output = folder / "import"

    def fresh() -> None:
        shutil.rmtree(output, ignore_errors=True)
        output.mkdir()

    code = "import sys; from pyrung.click import ladder_to_pyrung as read; read(sys.argv[1], output_path=sys.argv[2])"
    theirs = [sys.executable, "-c", code, str(bundle), str(output / "theirs.py")]
    ours = [*clickgen, "import", str(bundle), "-o", str(output / "ours.py")]
    return share([*ours, "--no-verify"], theirs, fresh), share(ours, theirs, fresh)


def main() -> None:
    folder = Path(tempfile.mkdtemp(prefix="clickgen-bench-"))
    python = sys.executable
    try:
        clickgen = [python, "-m", "clickgen"]

        def cold() -> None:
            shutil.rmtree(folder / "out", ignore_errors=True)
            shutil.rmtree(folder / ".clickgen_cache", ignore_errors=True)
            (folder / "nicknames.csv").unlink(missing_ok=True)

        (folder / "clickgen.toml").write_text("")
        config = ["--config", str(folder / "clickgen.toml")]

        def build(rungs: int) -> list[str]:
            path = folder / f"p{rungs}.py"
            path.write_text(program(rungs))
            return [*clickgen, "build", str(path), "-o", str(folder / "out"), *config]

        build_2000 = build(2000)
        parse = [python, "-c", f"import libcst; libcst.parse_module(open({str(folder / 'p2000.py')!r}).read())"]
        ours, bare = compare(build_2000, parse, cold)
        cold()
        memory = spent(build_2000).memory / spent(parse).memory
        print(f"cold build of 2,000 rungs / bare libcst parse: {ours / bare:.2f} (at most 1.0; aim 0.85)")
        print(f"most memory of it / of the parse: {memory:.2f} (at most 0.5)")
        one_edit(folder, clickgen)
        one_formula(folder / "formula", clickgen)

        times = {}
        for rungs in (500, 1000, 2000, 4000):
            command = build(rungs)
            times[rungs] = statistics.median(seconds(command, cold) for _ in range(3))
        per_rung = {rungs: 1000 * spent / rungs for rungs, spent in times.items()}
        shown = ", ".join(f"{rungs}: {spent:.2f} ms" for rungs, spent in per_rung.items())
        print(f"time per rung as programs grow: {shown} (linear: it does not rise)")

        check = [*clickgen, "check", "--exit-zero", "-q", "-o", str(folder / "report.txt")]
        ours, bare = compare([*check, "--no-cache", str(folder / "p2000.py")], parse, cold)
        print(f"cold check of 2,000 rungs / bare libcst parse: {ours / bare:.2f} (at most 1.5)")

        plant = folder / "plant"
        for number in range(FILES):
            (plant / f"line{number}").mkdir(parents=True)
            (plant / f"line{number}" / "plc.py").write_text(clean_program(100))
        one = [*check, *config, str(plant / "line0")]
        every = [*one[:-1], str(plant)]
        subprocess.run(every, check=True)
        warm, nothing = compare(one, [python, "-c", "pass"], lambda: None)
        print(f"repeated check of one file / python -c pass: {warm / nothing:.1f} (at most 3)")
        more, warm = compare(every, one, lambda: None)
        print(f"each further unchanged file: {1000 * (more - warm) / (FILES - 1):.2f} ms (at most 0.10)")

        for what, command in (
            ("nicknames sync", ["nicknames", "sync"]),
            ("nicknames check", ["nicknames", "check"]),
            ("workbook", ["workbook", "-o", str(folder / "project.xlsx")]),
        ):
            times = {}
            for rows in (2500, 5000, 10000):
                path = folder / f"table{rows}" / "plc.py"
                path = path if path.exists() else project(rows, path.parent)
                times[rows] = statistics.median(
                    seconds([*clickgen, *command, str(path)], lambda: None) for _ in range(3)
                )
            per_row = ", ".join(f"{rows}: {1000 * spent / rows:.2f} ms" for rows, spent in times.items())
            print(f"{what}, time per row as tables grow: {per_row} (linear: it does not rise)")

        times = {}
        for rows in (2500, 5000, 10000):
            path = with_workbook(folder / f"table{rows}" / "plc.py")
            check_list = [*clickgen, "nicknames", "check", "--nicknames", str(path.with_name("io.xlsx")), str(path)]
            times[rows] = statistics.median(seconds(check_list, lambda: None) for _ in range(3))
        per_row = ", ".join(f"{rows}: {1000 * spent / rows:.2f} ms" for rows, spent in times.items())
        print(f"nicknames check with a workbook as the table, time per row: {per_row} (linear: it does not rise)")

        against_a_build(folder, clickgen)
        # 33 subroutines of 14 source rungs, each a little more than one CLICK rung; and a program of the largest kind.
        for subroutines, rungs, most in ((33, 14, 0.85), (29, 138, 1)):
            plain, verified = imports(folder, clickgen, subroutines, rungs)
            print(f"import without verification / pyrung, CPU: {plain:.2f}")
            print(f"import with verification / pyrung, CPU: {verified:.2f} (at most {most})")

        version, nothing = compare([*clickgen, "--version"], [python, "-c", "pass"], lambda: None)
        print(f"clickgen --version / python -c pass: {version / nothing:.1f} (at most 6)")
    finally:
        shutil.rmtree(folder)


if __name__ == "__main__":
    main()
