#!/bin/sh
# ClickNick cannot be installed beside pyclickplc 0.4.1: it asks for exactly 0.4.0.
#
# Packages: clicknick 0.23.4 and pyclickplc 0.4.1
# Seen: pip refuses the pair, because clicknick 0.23.4 depends on pyclickplc==0.4.0. Its other dependencies are pinned
#   to one version as well, laddercodec==0.2.2 and pyrung==0.15.2 among them.
# Expected: A range, as pyrung 0.15.2 has for the same library (pyclickplc>=0.4.0).
# Meaning: The program that pastes a bundle into CLICK needs an environment of its own, and does not get what pyclickplc
#   0.4.1 mended. clickgen takes laddercodec from 0.2.2 on, so the two can share an environment only with 0.2.2;
#   clickgen's tests, which use pyclickplc 0.4.1, judge bundles with the libraries and not with ClickNick.
#
# Output:
#> the user asks for pyclickplc==0.4.1
#> clicknick 0.23.4 depends on pyclickplc==0.4.0
set -eu
expected=$(sed -n 's/^#> //p' "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
python3 -m venv "$work/venv"
if "$work/venv/bin/python" -m pip install --dry-run --disable-pip-version-check \
    clicknick==0.23.4 pyclickplc==0.4.1 > "$work/pip.txt" 2>&1; then
    seen="they can be installed together"
else
    seen=$(sed -n -e 's/^ *The user requested \(pyclickplc.*\)/the user asks for \1/p' \
        -e 's/^ *\(clicknick [0-9.]* depends on pyclickplc.*\)/\1/p' "$work/pip.txt")
fi
printf '%s\n' "$seen"
[ "$seen" = "$expected" ] || { echo "changed: the output is not the one in the comment at the top" >&2; exit 1; }
