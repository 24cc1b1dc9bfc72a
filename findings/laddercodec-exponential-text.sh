#!/bin/sh
# laddercodec encodes a number-to-text copy as a text-to-number copy when both display options are used together.
#
# Package: laddercodec 0.2.2
# Seen: copy(DF1,TXT1,convert=to_text(suppress_zero=0,exponential=1,...)) is read and encoded without an error, with the
#   function code of convert=to_value, and is decoded as that. Each of the other three pairs comes back as it was.
# Expected: The package's description of ladder CSV gives 0 or 1 for both options, so the pair either works or raises.
# Meaning: CLICK would run another instruction than the file says. clickgen refuses the pair (CG314) and gives the
#   reason where it does so, in clickgen/check/rules/copies.py.
#
# Output:
#> suppress_zero=0,exponential=0: copy(DF1,TXT1,convert=to_text(suppress_zero=0,exponential=0,termination_code=none))
#> suppress_zero=0,exponential=1: copy(DF1,TXT1,convert=to_value)
#> suppress_zero=1,exponential=0: copy(DF1,TXT1,convert=to_text(suppress_zero=1,exponential=0,termination_code=none))
#> suppress_zero=1,exponential=1: copy(DF1,TXT1,convert=to_text(suppress_zero=1,exponential=1,termination_code=none))
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


def decoded(token):
    path = Path("rung.csv")
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerows([HEADER, ["R", "C1", *["-"] * 30, token], [""] * 33])
    rung = laddercodec.decode(laddercodec.encode(laddercodec.read_csv(path)))
    return rung.instructions[0].to_csv()


for zero in (0, 1):
    for exponential in (0, 1):
        options = f"suppress_zero={zero},exponential={exponential}"
        token = decoded(f"copy(DF1,TXT1,convert=to_text({options},termination_code=none))")
        print(f"{options}: {token}")
PY
seen=$(cd "$work" && venv/bin/python see.py)
printf '%s\n' "$seen"
[ "$seen" = "$expected" ] || { echo "changed: the output is not the one in the comment at the top" >&2; exit 1; }
