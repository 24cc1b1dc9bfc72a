#!/bin/sh
# laddercodec loses rungs without a word once the rows of a capture, counted with its rungs, reach 2,048.
#
# Package: laddercodec 0.2.2
# Seen: 63 rungs with 1,984 rows (2,047 together) come back. One row more encodes without an error, and decode() makes
#   one rung of -1 rows of the bytes: the sum is kept in 16 bits, in steps of 32, and has become 0.
# Expected: An error, as for the other limit of a capture: 257 rungs raise ValueError.
# Meaning: Whoever pastes a long routine into CLICK through this codec must split it by rows as well as by rungs.
#   clickgen has both limits in one table (clickgen/device/limits.py) and splits a long main into files below them.
#
# Output:
#> 63 rungs, 1984 rows, 2047 together: 63 rungs, 1984 rows
#> 63 rungs, 1985 rows, 2048 together: 1 rungs, -1 rows
#> 256 rungs, 256 rows, 512 together: 256 rungs, 256 rows
#> 257 rungs, 257 rows, 514 together: ValueError
set -eu
expected=$(sed -n 's/^#> //p' "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
python3 -m venv "$work/venv"
"$work/venv/bin/python" -m pip install --quiet --disable-pip-version-check \
    laddercodec==0.2.2
cat > "$work/see.py" <<'PY'
import csv
from pathlib import Path

import laddercodec

HEADER = ["marker", *(chr(65 + i) for i in range(26)), *("A" + chr(65 + i) for i in range(6))]


def ladder(heights):
    path = Path("main.csv")
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(HEADER)
        for height in heights:
            for row in range(height):
                writer.writerow(["" if row else "R", f"C{row + 1}", *["-"] * 30, f"out(C{row + 101})"])
    return laddercodec.read_csv(path)


for heights in ([32] * 61 + [16, 16], [32] * 61 + [16, 17], [1] * 256, [1] * 257):
    drawn = ladder(heights)
    assert [rung.logical_rows for rung in drawn] == heights
    try:
        decoded = laddercodec.decode(laddercodec.encode(drawn))
    except ValueError as error:
        found = type(error).__name__
    else:
        decoded = decoded if isinstance(decoded, list) else [decoded]
        found = f"{len(decoded)} rungs, {sum(rung.logical_rows for rung in decoded)} rows"
    rungs, rows = len(heights), sum(heights)
    print(f"{rungs} rungs, {rows} rows, {rungs + rows} together: {found}")
PY
seen=$(cd "$work" && venv/bin/python see.py)
printf '%s\n' "$seen"
[ "$seen" = "$expected" ] || { echo "changed: the output is not the one in the comment at the top" >&2; exit 1; }
