#!/bin/sh
# pyrung drops the conditions of rungs between for and next when it reads a ladder: they run without them.
#
# Package: pyrung 0.15.2 (with pyclickplc 0.4.1)
# Seen: A loop of four rounds around two rungs, the second with the contact DS1>2. ladder_to_pyrung() makes Python of
#   it without that contact, and without a warning; run, the second rung counts in all four rounds.
# Expected: The contact is kept (DS2 is 2 after a scan), or ladder_to_pyrung() raises: a rung in a loop has conditions
#   like any other.
# Meaning: A simulation or a proof of imported ladder answers for another program than the one in the PLC, and an export
#   back to CLICK removes interlocks. clickgen keeps the conditions; where it runs its scenarios in pyrung as an outside
#   judge, this difference is listed by name (tests/scenarios/control.py).
#
# Output:
#> with rung(C1):
#>     with forloop(4):
#>         calc(DS1 + 1, DS1)
#>         calc(DS2 + 1, DS2)
#> DS1=4 DS2=4
set -eu
expected=$(sed -n 's/^#> //p' "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
python3 -m venv "$work/venv"
"$work/venv/bin/python" -m pip install --quiet --disable-pip-version-check \
    pyrung==0.15.2 pyclickplc==0.4.1
cat > "$work/see.py" <<'PY'
import csv
import re
import runpy
from pathlib import Path

from pyrung import PLC
from pyrung.click import ladder_to_pyrung

HEADER = ["marker", *(chr(65 + i) for i in range(26)), *("A" + chr(65 + i) for i in range(6))]
RUNGS = (
    ("C1", "for(4)"),
    ("-", "math(DS1 + 1,DS1,mode=decimal)"),
    ("DS1>2", "math(DS2 + 1,DS2,mode=decimal)"),
    ("-", "next()"),
    ("-", "end()"),
)
with Path("main.csv").open("w", newline="") as file:
    writer = csv.writer(file)
    writer.writerow(HEADER)
    writer.writerows(["R", contact, *["-"] * 30, token] for contact, token in RUNGS)

code = ladder_to_pyrung(Path("main.csv"), output_path=Path("program.py"))
body = re.search(r"with Program\(\) as logic:\n((?:    .*\n)+)", code)
print("\n".join(line[4:] for line in body.group(1).splitlines()))

plc = PLC(runpy.run_path("program.py")["logic"], dt=0.01)
plc.patch({"C1": True})
plc.run(1)
tags = plc.current_state.tags
print(f"DS1={tags['DS1']} DS2={tags['DS2']}")
PY
seen=$(cd "$work" && venv/bin/python see.py)
printf '%s\n' "$seen"
[ "$seen" = "$expected" ] || { echo "changed: the output is not the one in the comment at the top" >&2; exit 1; }
