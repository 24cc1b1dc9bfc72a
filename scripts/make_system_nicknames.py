"""Makes clickgen/device/system_nicknames.csv from an export of CLICK PLUS 3.41 and the catalog of pyclickplc.

If the two spell a name differently, the export has CLICK's own spelling (fixtures/click-3.41), and the catalog's is
kept as another one (click-facts [system.spellings]). ``--check`` writes nothing and only reports whether the file is
stale.
"""

from __future__ import annotations

import argparse
import csv
import sys
from collections.abc import Sequence
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
TARGET = ROOT / "clickgen" / "device" / "system_nicknames.csv"
EXPORT = ROOT / "fixtures" / "click-3.41" / "system-names.csv"


def system_nicknames_csv() -> str:
    """The data file: ``Address,Nickname,Other`` for each of CLICK's own points, in CLICK's row order.

    A name is a nickname only once. So if the export and the catalog give one name to two addresses, the address of
    the export has it as its nickname, and that of the catalog has it only under ``Other``.
    """
    from pyclickplc.system import AUTOMATIONDIRECT_SYSTEM_NICKNAMES

    with EXPORT.open(newline="", encoding="utf-8") as file:
        shown = {_point(row["Address"]): row["Nickname"] for row in csv.DictReader(file)}
    listed = {point: guidance.nickname for point, guidance in AUTOMATIONDIRECT_SYSTEM_NICKNAMES.items()}
    taken = {name.lower() for name in shown.values()}
    lines = ["Address,Nickname,Other"]
    # Only SC and SD have such names, so CLICK's row order is the plain one.
    for bank, number in sorted(shown.keys() | listed.keys()):
        other = listed.get((bank, number), "")
        name = shown.get((bank, number)) or ("" if other.lower() in taken else other)
        other = "" if other == name else other
        if bank not in ("SC", "SD") or any(character in name + other for character in ',"\r\n'):
            raise ValueError(f"{bank}{number}: system.py does not read {name!r} and {other!r}")
        lines.append(f"{bank}{number},{name},{other}")
    return "\n".join(lines) + "\n"


def _point(address: str) -> tuple[str, int]:
    return address[:2], int(address[2:])


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true", help="write nothing; exit 1 when the file is stale")
    check: bool = parser.parse_args(arguments).check
    made = system_nicknames_csv().encode()
    if TARGET.exists() and TARGET.read_bytes() == made:
        return 0
    if check:
        print(f"{TARGET} is stale: run python scripts/{Path(__file__).name}", file=sys.stderr)
        return 1
    TARGET.write_bytes(made)
    print(f"wrote {TARGET}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
