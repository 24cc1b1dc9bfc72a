#!/bin/sh
# laddercodec encodes a send to a system bit of another CLICK as a write of a register, if the bit is given by its name.
#
# Package: laddercodec 0.2.2
# Seen: A send of one value to "SC53" gets function code 06 (write a register). The same bit by its Modbus number,
#   61493, gets 05 (write a coil), and so do "C1" and "Y001" by name.
# Expected: One address, one function code. CLICK PLUS 3.41's own address export gives SC53 as number 61493 with the
#   function codes 01, 05 and 15. Register 06 at the same offset is SD53, which the export gives as read-only.
# Meaning: Setting the clock bits of another CLICK (SC53, SC55) by name does not do what the rung says; what CLICK makes
#   of the wrong code is not known. clickgen refuses SC as the remote address of a send (CG304). A ModbusAddress with
#   the number works.
#
# Output:
#> C1 05, 16385 05
#> Y001 05, 8193 05
#> SC53 06, 61493 05
#> DS1 06, 400001 06
set -eu
expected=$(sed -n 's/^#> //p' "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
python3 -m venv "$work/venv"
"$work/venv/bin/python" -m pip install --quiet --disable-pip-version-check \
    laddercodec==0.2.2
cat > "$work/see.py" <<'PY'
import struct

import laddercodec
from laddercodec import Contact, ModbusAddress, ModbusTcpTarget, Rung, Send

FUNCTION = 0x2211  # the field of a send that holds the kind of write
CODES = {"0": "05", "1": "06", "2": "15", "3": "16"}
TARGET = ModbusTcpTarget(name="tcp", ip="192.168.1.10", port=502, device_id=1)


def function_code(remote, source):
    send = Send(TARGET, remote, source, 1, sending="C1", success="C2", error="C3", exception_response="DS100")
    conditions = [[Contact.from_csv_token("C10"), *["-"] * 30], [""] * 31, [""] * 31]
    rung = Rung(logical_rows=3, conditions=conditions, instructions=[send, "", ""], comment=None)
    capture = laddercodec.encode(rung)
    value = capture.index(struct.pack("<H", FUNCTION) + b"\xff" * 4) + 6
    return CODES[capture[value : value + 2].decode("utf-16-le")]


for name, number, source in (
    ("C1", "16385", "C5"),
    ("Y001", "8193", "C5"),
    ("SC53", "61493", "C5"),
    ("DS1", "400001", "DS5"),
):
    print(f"{name} {function_code(name, source)}, {number} {function_code(ModbusAddress(number), source)}")
PY
seen=$(cd "$work" && venv/bin/python see.py)
printf '%s\n' "$seen"
[ "$seen" = "$expected" ] || { echo "changed: the output is not the one in the comment at the top" >&2; exit 1; }
