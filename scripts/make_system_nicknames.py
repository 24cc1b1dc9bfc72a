"""Makes clickgen/device/system_nicknames.csv from pyclickplc's catalog; ``--check`` only says whether it is stale."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

TARGET = Path(__file__).resolve().parents[1] / "clickgen" / "device" / "system_nicknames.csv"


def system_nicknames_csv() -> str:
    """The data file: one ``Address,Nickname`` line for each of CLICK's own names, in CLICK's row order."""
    from pyclickplc.system import AUTOMATIONDIRECT_SYSTEM_NICKNAMES

    lines = ["Address,Nickname"]
    # Only SC and SD have such names, so CLICK's row order is the plain one.
    for (bank, number), guidance in sorted(AUTOMATIONDIRECT_SYSTEM_NICKNAMES.items()):
        name = guidance.nickname
        if bank not in ("SC", "SD") or any(character in name for character in ',"\r\n'):
            raise ValueError(f"{bank}{number}: system.py does not read the name {name!r}")
        lines.append(f"{bank}{number},{name}")
    return "\n".join(lines) + "\n"


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
