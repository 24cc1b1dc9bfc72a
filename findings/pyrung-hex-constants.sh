#!/bin/sh
# pyrung turns the hexadecimal constants of a ladder into decimal ones on the way through Python and back.
#
# Package: pyrung 0.15.2 (with pyclickplc 0.4.1)
# Seen: DH1==00FFh comes back as DH1==255, and a formula in hex mode, DH1 AND 00FFh, as DH1 AND 255 with mode=hex.
# Expected: The ladder that went in: the guide to the code generation (docs/dialects/click-codegen.md in the sdist) says
#   that the round trip reproduces it. In CLICK, constants beside DH and in hex mode are hexadecimal: 00FFh.
# Meaning: In a hex formula the digits 255 are no longer the value 00FFh, so a mask can change without a message.
#   clickgen writes constants with an h, warns of a decimal number in a hex formula (CG315), and its import stops at
#   such a ladder (CG703) instead of guessing.
#
# Output:
#> in:  DH1==00FFh, math(DH1 AND 00FFh,DH2,mode=hex)
#> out: DH1==255, math(DH1 AND 255,DH2,mode=hex)
#> in:  C1, math(DH1 + 10h,DH3,mode=hex)
#> out: C1, math(DH1 + 16,DH3,mode=hex)
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

from pyrung.click import ladder_to_pyrung, pyrung_to_ladder

HEADER = ["marker", *(chr(65 + i) for i in range(26)), *("A" + chr(65 + i) for i in range(6))]
RUNGS = (
    ("DH1==00FFh", "math(DH1 AND 00FFh,DH2,mode=hex)"),
    ("C1", "math(DH1 + 10h,DH3,mode=hex)"),
    ("-", "end()"),
)
with Path("main.csv").open("w", newline="") as file:
    writer = csv.writer(file)
    writer.writerow(HEADER)
    writer.writerows(["R", contact, *["-"] * 30, token] for contact, token in RUNGS)

ladder_to_pyrung(Path("main.csv"), output_path=Path("program.py"))
program = runpy.run_path("program.py")
bundle = pyrung_to_ladder(program["logic"], program["mapping"])
rows = [row for row in bundle.main_rows if row[0] == "R"]
for (contact, token), row in list(zip(RUNGS, rows, strict=True))[:-1]:
    print(f"in:  {contact}, {token}")
    print(f"out: {row[1]}, {row[-1]}")
PY
seen=$(cd "$work" && venv/bin/python see.py)
printf '%s\n' "$seen"
[ "$seen" = "$expected" ] || { echo "changed: the output is not the one in the comment at the top" >&2; exit 1; }
