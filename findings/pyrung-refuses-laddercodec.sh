#!/bin/sh
# pyrung does not read, or does not run, tokens that laddercodec writes of CLICK's own instructions.
#
# Packages: pyrung 0.15.2 (with pyclickplc 0.4.1) and laddercodec 0.2.2
# Seen: Each token below goes through laddercodec's binary form and comes back unchanged. pyrung's ladder_to_pyrung()
#   raises for three of them; for the others it writes Python that fails when it is run.
# Expected: They are read: pyrung's documentation names laddercodec's page as the format, and termination_code=none is
#   how laddercodec writes every to_text() without such a code.
# Meaning: A project that was captured from CLICK with laddercodec may not open in pyrung, and a caller must run the
#   generated file to find out. clickgen's outside judge has a table of such spellings, with the form that pyrung takes
#   (tests/judges/simulator.py).
#
# Output:
#> copy(DS1,TXT1,convert=to_text(suppress_zero=1,exponential=0,termination_code=none)): generated, then NameError
#> copy($0D,TXT1): ValueError
#> math(SQRT ( DF1 ),DF2,mode=decimal): ValueError
#> copy(XD0,DH1): ValueError
#> shift(C14..C10): generated, then ValueError
set -eu
expected=$(sed -n 's/^#> //p' "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
python3 -m venv "$work/venv"
"$work/venv/bin/python" -m pip install --quiet --disable-pip-version-check \
    pyrung==0.15.2 pyclickplc==0.4.1 laddercodec==0.2.2
cat > "$work/see.py" <<'PY'
import csv
import runpy
from pathlib import Path

import laddercodec
from pyrung.click import ladder_to_pyrung

HEADER = ["marker", *(chr(65 + i) for i in range(26)), *("A" + chr(65 + i) for i in range(6))]
BELOW = (("", ""),)
TOKENS = (
    ("copy(DS1,TXT1,convert=to_text(suppress_zero=1,exponential=0,termination_code=none))", BELOW),
    ("copy($0D,TXT1)", BELOW),
    ("math(SQRT ( DF1 ),DF2,mode=decimal)", ()),
    ("copy(XD0,DH1)", BELOW),
    ("shift(C14..C10)", (("C2", ".clock()"), ("C3", ".reset()"))),
)


def row(marker, contact, token):
    return [marker, contact, *["-" if contact else ""] * 30, token]


for token, pins in TOKENS:
    with Path("main.csv").open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerows([HEADER, row("R", "C1", token), *(row("", *pin) for pin in pins), row("R", "-", "end()")])
    decoded = laddercodec.decode(laddercodec.encode(laddercodec.read_csv("main.csv")))
    assert decoded[0].instructions[0].to_csv() == token
    try:
        ladder_to_pyrung(Path("main.csv"), output_path=Path("program.py"))
    except ValueError as error:
        print(f"{token}: {type(error).__name__}")
        continue
    try:
        runpy.run_path("program.py")
        print(f"{token}: runs")
    except (NameError, TypeError, ValueError) as error:
        print(f"{token}: generated, then {type(error).__name__}")
PY
seen=$(cd "$work" && venv/bin/python see.py)
printf '%s\n' "$seen"
[ "$seen" = "$expected" ] || { echo "changed: the output is not the one in the comment at the top" >&2; exit 1; }
