#!/bin/sh
# laddercodec writes a capture that it cannot read: 31 contacts in series before a box of two rows.
#
# Package: laddercodec 0.2.2
# Seen: encode() takes a rung whose contacts fill all 31 columns up to a box of two or more rows (copy, timer, counter).
#   decode() of those bytes raises DecodeError. With 30 contacts, or before a coil of one row, the rung comes back.
# Expected: decode() reads what encode() wrote. CLICK's grid has 31 columns, and the rung fills them.
# Meaning: A capture with one rung as wide as CLICK allows cannot be read at all, and a rung that is to be pasted cannot
#   be checked before by reading it back. clickgen reads and writes such rungs in ladder CSV, and reports a capture
#   that laddercodec does not decode as a problem that names this limit (CG710), never as fewer rungs.
#
# Output:
#> 30 contacts, out(Y001): 30 contacts, out(Y001)
#> 31 contacts, out(Y001): 31 contacts, out(Y001)
#> 30 contacts, copy(DS1,DS2): 30 contacts, copy(DS1,DS2)
#> 31 contacts, copy(DS1,DS2): DecodeError
#> 30 contacts, on_delay(T1,TD1,preset=5,unit=Ts): 30 contacts, on_delay(T1,TD1,preset=5,unit=Ts)
#> 31 contacts, on_delay(T1,TD1,preset=5,unit=Ts): DecodeError
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
from laddercodec.decode import DecodeError

HEADER = ["marker", *(chr(65 + i) for i in range(26)), *("A" + chr(65 + i) for i in range(6))]


def ladder(contacts, token, rows):
    path = Path("rung.csv")
    cells = [f"C{i + 1}" for i in range(contacts)] + ["-"] * (31 - contacts)
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(HEADER)
        writer.writerow(["R", *cells, token])
        writer.writerows([[""] * 33] * (rows - 1))
    return laddercodec.read_csv(path)


for token, rows in (("out(Y001)", 1), ("copy(DS1,DS2)", 2), ("on_delay(T1,TD1,preset=5,unit=Ts)", 2)):
    for contacts in (30, 31):
        capture = laddercodec.encode(ladder(contacts, token, rows))
        try:
            rung = laddercodec.decode(capture)
            found = sum(isinstance(cell, laddercodec.Contact) for cell in rung.conditions[0])
            print(f"{contacts} contacts, {token}: {found} contacts, {rung.instructions[0].to_csv()}")
        except DecodeError as error:
            print(f"{contacts} contacts, {token}: {type(error).__name__}")
PY
seen=$(cd "$work" && venv/bin/python see.py)
printf '%s\n' "$seen"
[ "$seen" = "$expected" ] || { echo "changed: the output is not the one in the comment at the top" >&2; exit 1; }
