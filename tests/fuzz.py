"""The properties of the tests as a long run: ``make fuzz``, or ``python tests/fuzz.py --minutes 10``.

A round is a run of pytest over all properties with new examples, twenty times as many as in ``make test``. A property
that fails prints its smallest example and sits out the following rounds. The exit code is 1 if one failed.
"""

from __future__ import annotations

import argparse
import random
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from xml.etree import ElementTree

TESTS = Path(__file__).parent


def one_round(seed: int, options: argparse.Namespace, without: list[str]) -> list[str]:
    """Run the properties once, except some of them; return those that failed, by their pytest ids."""
    with tempfile.TemporaryDirectory(prefix="clickgen-fuzz-") as folder:
        report = Path(folder) / "report.xml"
        command = [sys.executable, "-m", "pytest", "-q", "-r", "fE", "-m", "property", f"--rootdir={TESTS.parent}"]
        command += [f"--times={options.times}", f"--hypothesis-seed={seed}", f"--junitxml={report}"]
        command += ["-o", "junit_family=xunit1", "-n", str(options.workers), "--dist=worksteal"]
        command += [f"-k={options.only}"] if options.only else []
        command += [f"--deselect={test}" for test in without]
        code = subprocess.run([*command, str(TESTS)], cwd=TESTS.parent, check=False).returncode
        # 5: all have failed before, and none is left.
        if code not in (0, 1, 5):
            sys.exit(code)
        return list(failed_in(report))


def failed_in(report: Path) -> list[str]:
    """The tests that failed, by their pytest ids."""
    return [
        f"{case.get('file')}::{case.get('name')}"
        for case in ElementTree.parse(report).iter("testcase")
        if case.find("failure") is not None or case.find("error") is not None
    ]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--minutes", type=float, default=0, help="begin new rounds until then; one round without it")
    parser.add_argument("--times", type=int, default=20, help="examples of a property, in times those of make test")
    parser.add_argument("--seed", type=int, help="of the first round, to repeat a run")
    parser.add_argument("--only", help="properties whose names hold this, as for pytest -k")
    parser.add_argument("--workers", default="auto", help="processes, as for pytest -n")
    options = parser.parse_args()
    stop = time.monotonic() + 60 * options.minutes
    seed = options.seed if options.seed is not None else random.randrange(2**32)
    failed: list[str] = []
    while True:
        print(f"\nseed {seed}", flush=True)
        failed += one_round(seed, options, failed)
        seed += 1
        if time.monotonic() >= stop:
            break
    if failed:
        print("\nFailed:\n" + "\n".join(f"  {test}" for test in failed))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
