#!/bin/sh
# pyrung reads a nickname file without its column Retentive, in both directions.
#
# Package: pyrung 0.15.2 (with pyclickplc 0.4.1)
# Seen: ladder_to_pyrung(..., nickname_csv=...) takes names and initial values of single addresses. After STOP and RUN a
#   DS with Retentive No keeps its value, and a C with Retentive Yes loses its own: each bank has its default.
# Expected: As the file says, DS1 back at its initial value 5 and C1 still on. pyrung's blocks can do it: its
#   documentation has slot(..., retentive=...).
# Meaning: A test of what a machine does after a power failure passes in the simulation and fails at the PLC, or the
#   other way round. clickgen keeps the column in its address table; where its scenarios are run in pyrung, this
#   difference is listed by name (tests/scenarios/control.py).
#
# Output:
#> before: DS1=9 DS2=9 C1=True C2=True
#> after:  DS1=9 DS2=9 C1=False C2=False
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
import runpy
from pathlib import Path

from pyrung import PLC
from pyrung.click import ladder_to_pyrung

HEADER = ["marker", *(chr(65 + i) for i in range(26)), *("A" + chr(65 + i) for i in range(6))]
RUNGS = (
    ("SC2", "copy(9,DS1)"),
    ("SC2", "copy(9,DS2)"),
    ("SC2", "latch(C1)"),
    ("SC2", "latch(C2)"),
    ("-", "end()"),
)
NAMES = """Address,Data Type,Nickname,Initial Value,Retentive,Address Comment
C1,BIT,"Kept Bit",0,Yes,""
C2,BIT,"Lost Bit",0,No,""
DS1,INT,"Lost Word",5,No,""
DS2,INT,"Kept Word",0,Yes,""
"""
Path("nicknames.csv").write_text(NAMES)
with Path("main.csv").open("w", newline="") as file:
    writer = csv.writer(file)
    writer.writerow(HEADER)
    for contact, token in RUNGS:
        writer.writerow(["R", contact, *["-"] * 30, token])
        writer.writerows([[""] * 33] * token.startswith("copy"))

ladder_to_pyrung(Path("main.csv"), nickname_csv=Path("nicknames.csv"), output_path=Path("program.py"))
program = runpy.run_path("program.py")
plc = PLC(program["logic"], dt=0.01)


def memory():
    tags = plc.current_state.tags
    cells = {"DS1": program["ds"][1], "DS2": program["ds"][2], "C1": program["c"][1], "C2": program["c"][2]}
    return " ".join(f"{address}={tags[tag.name]}" for address, tag in cells.items())


plc.run(1)
print("before:", memory())
plc.stop()
plc.run(0)
print("after: ", memory())
PY
seen=$(cd "$work" && venv/bin/python see.py)
printf '%s\n' "$seen"
[ "$seen" = "$expected" ] || { echo "changed: the output is not the one in the comment at the top" >&2; exit 1; }
