#!/bin/sh
# A DF that pyrung computes can be too large for pyclickplc's server, which then answers a read with no data at all.
#
# Packages: pyrung 0.15.2, pyclickplc 0.4.1 (on pymodbus 3.12.1)
# Seen: pyrung's documentation calls a Real (CLICK's DF) a 32-bit float. It keeps 64 bits: 16777216 + 1 is 16777217, and
#   1e30 * 1e30 is 1e60. Served over Modbus by pyrung's ClickDataProvider, a block read of DF1 to DF3 gets a normal
#   answer (function 03, no exception) with 0 bytes of data; a read of DF1 alone is fine.
# Expected: Single precision, as in CLICK: 16777216, and nothing above 3.4028235e38. From the server an exception for a
#   register that it cannot serve, not an answer that is shorter than the request.
# Meaning: A comparison of floats can be true in the simulation and false in the PLC, and one value of this kind blanks
#   every block read that includes it. clickgen rounds the constants of comparisons to single precision before it judges
#   them (clickgen/ir/logic.py), and its scenarios use no float that depends on the difference.
#
# Output:
#> DF1=1e+30 DF2=1.0000000000000001e+60 DF3=16777217.0
#> read DF1: 03 04 f2ca7149
#> read DF2: 03 00
#> read DF1 to DF3: 03 00
set -eu
expected=$(sed -n 's/^#> //p' "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
python3 -m venv "$work/venv"
"$work/venv/bin/python" -m pip install --quiet --disable-pip-version-check \
    pyrung==0.15.2 pyclickplc==0.4.1 pymodbus==3.12.1
cat > "$work/see.py" <<'PY'
import asyncio
import socket
import struct

from pyclickplc import ClickServer
from pyrung import PLC, Program, Real, calc, rung
from pyrung.click import ClickBlocks, ClickDataProvider, TagMap

df = ClickBlocks()[9]
large, square, count = Real("Large"), Real("Square"), Real("Count")
with Program() as logic:
    with rung():
        calc(large * large, square)
    with rung():
        calc(large * 0 + 16777216 + 1, count)
mapping = TagMap({large: df[1], square: df[2], count: df[3]})
plc = PLC(logic, dt=0.01)
plc.patch({"Large": 1e30})
plc.run(1)
tags = plc.current_state.tags
print(f"DF1={tags['Large']} DF2={tags['Square']} DF3={tags['Count']}")


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


async def main():
    port = free_port()
    async with ClickServer(ClickDataProvider(plc, tag_map=mapping), host="127.0.0.1", port=port):
        reader, writer = await asyncio.open_connection("127.0.0.1", port)
        for label, first, registers in (("DF1", 28672, 2), ("DF2", 28674, 2), ("DF1 to DF3", 28672, 6)):
            writer.write(struct.pack(">HHHBBHH", 1, 0, 6, 1, 3, first, registers))
            length = struct.unpack(">HHHB", await reader.readexactly(7))[2]
            answer = await reader.readexactly(length - 1)
            print(f"read {label}: {answer[0]:02x} {answer[1]:02x} {answer[2:].hex()}".rstrip())
        writer.close()


asyncio.run(asyncio.wait_for(main(), 60))
PY
seen=$(cd "$work" && venv/bin/python see.py)
printf '%s\n' "$seen"
[ "$seen" = "$expected" ] || { echo "changed: the output is not the one in the comment at the top" >&2; exit 1; }
