"""Builds of programs under test: in memory, judging everything that a person sees of a build."""

from __future__ import annotations

import contextlib
import gc
import io
import tempfile
from collections.abc import Mapping
from functools import cache
from pathlib import Path

from strategies.given import TABLE, Given

import clickgen
import clickgen.cli
from clickgen.problems.codes import CODES

from .codec import assert_codec_reads
from .power import check_limits, check_no_backfeed, read_ladder


@cache
def workshop() -> Path:
    """A folder of this process for the programs under test; no table is ever written into it."""
    return Path(tempfile.mkdtemp(prefix="clickgen-properties-"))


def ladder_files(texts: Mapping[str, str]) -> dict[str, str]:
    """Return the ladder files of a program, given by the text of each of its files; it must build."""
    for name, text in texts.items():
        (workshop() / name).write_text(text, encoding="utf-8")
    for path in workshop().glob("*.py"):
        if path.name not in texts:
            path.unlink()
    result = clickgen.build(workshop() / next(iter(texts)))
    assert result.ok, "\n".join(f"{one.code} {one.span}: {one.message}" for one in result.diagnostics)
    return {name: file for name, file in result.files.items() if name.startswith(("main", "subroutines/"))}


# ---------------------------------------------------------------------------------------------------- anything


def check_build(given: Given, codec: bool = True, is_valid: bool = False) -> None:
    """Build through the API and through the command line, and judge every result."""
    with tempfile.TemporaryDirectory(prefix="clickgen-robust-") as name:
        folder = Path(name)
        program, out = folder / given.files[0][0], folder / "out"
        for file, data in given.files:
            (folder / file).write_bytes(data)
        before = contents(folder)
        try:
            result = clickgen.build(program)
        except clickgen.CouldNotRun:
            expected = 2
        else:
            expected = 0 if result.ok else 1
            assert result.ok or not is_valid, result.diagnostics
            files = {str(folder / file): data for file, data in ((TABLE, b""), *given.files)}
            check_diagnostics(result, files)
            assert said(clickgen.build(program)) == said(result), "the same again says something else"
        assert contents(folder) == before, "clickgen.build wrote something"

        code = command_line(program, out)
        assert code == expected, f"exit code {code}, and clickgen.build means {expected}"
        if code:
            assert contents(folder) == before, f"exit code {code}, and something was written"
            return
        check_outputs(out, codec)
        built = contents(folder)
        assert command_line(program, out, "--frozen") == 0, "the same again with --frozen is refused"
        assert contents(folder) == built, "the same again with --frozen writes something else"


def contents(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def command_line(program: Path, out: Path, *more: str) -> int:
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()) as errors:
        code = clickgen.cli.main(["build", str(program), "-o", str(out), *more])
    gc.enable()  # the command line turns it off
    assert code in (0, 1, 2), f"exit code {code}"
    assert code == 0 or errors.getvalue(), f"exit code {code} without a word"
    assert "Traceback" not in errors.getvalue()
    return code


def said(result: clickgen.BuildResult) -> tuple[object, ...]:
    return result.diagnostics, dict(result.files), result.table


def check_diagnostics(result: clickgen.BuildResult, files: dict[str, bytes]) -> None:
    lines = {}
    for path, data in files.items():
        text = data.decode("utf-8-sig", "replace")
        lines[path] = text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
    for problem in result.diagnostics:
        assert problem.code in CODES
        assert problem.message
        assert problem.help, f"{problem.code} has no way out: {problem.message}"
        assert problem.span is not None, f"{problem.code} has no place"
        for span in (problem.span, *(label.span for label in problem.labels)):
            where = f"{problem.code} at {span!r}"
            assert span.path in lines, where
            there = lines[span.path]
            assert 1 <= span.line <= span.end_line <= len(there), f"{where}: the file has {len(there)} lines"
            assert 1 <= span.col <= len(there[span.line - 1]) + 1, f"{where}: the line is {there[span.line - 1]!r}"
            assert (span.line, span.col) < (span.end_line, span.end_col), f"{where} is empty"


def check_outputs(out: Path, codec: bool) -> None:
    """Check that outside readers take every ladder file."""
    for path in (*out.glob("main*.csv"), *out.glob("subroutines/*.csv")):
        text = path.read_bytes().decode("utf-8")
        rungs = read_ladder(text)
        check_limits(rungs)
        for rung in rungs:
            check_no_backfeed(rung, max_vars=5)
        if codec:
            assert_codec_reads(text)
