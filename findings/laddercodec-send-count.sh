#!/bin/sh
# laddercodec ignores the count= that its own description gives to send(...) and receive(...): one value goes over.
#
# Package: laddercodec 0.2.2
# Seen: The description of ladder CSV in the sdist (docs/guides/csv-format.md) lists send(...,count=N). With count=5
#   the token is read without an error and encoded with a quantity of 1. A range, source=DS1..DS5, gives 5.
# Expected: Five values, or an error for a keyword that is not used.
# Meaning: A table of recipes sent so arrives with its first value only. clickgen writes ranges and never count=, and
#   its import refuses a send or receive that has one (CG702).
#
# Output:
#> source=DS1,count=5: quantity 1, written back as source=DS1
#> source=DS1..DS5: quantity 5, written back as source=DS1..DS5
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
import re
from pathlib import Path

import laddercodec

HEADER = ["marker", *(chr(65 + i) for i in range(26)), *("A" + chr(65 + i) for i in range(6))]
TARGET = 'target=ModbusTcpTarget(name="tcp",ip="192.168.1.10",port=502,device_id=1),remote_start="DS1"'
FLAGS = "sending=C1,success=C2,error=C3,exception_response=DS100"


def decoded(token):
    path = Path("rung.csv")
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerows([HEADER, ["R", "C10", *["-"] * 30, token], [""] * 33, [""] * 33])
    rung = laddercodec.decode(laddercodec.encode(laddercodec.read_csv(path)))
    return rung.instructions[0]


for source, count in (("DS1", ",count=5"), ("DS1..DS5", "")):
    send = decoded(f"send({TARGET},source={source},{FLAGS}{count})")
    written = re.search(r"source=[^,]*", send.to_csv()).group()
    print(f"source={source}{count}: quantity {send.quantity}, written back as {written}")
PY
seen=$(cd "$work" && venv/bin/python see.py)
printf '%s\n' "$seen"
[ "$seen" = "$expected" ] || { echo "changed: the output is not the one in the comment at the top" >&2; exit 1; }
