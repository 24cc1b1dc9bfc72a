#!/bin/sh
# clickplc reads the neighbour of a timer bit, fails on a range of timers, and returns counters that nobody asked for.
#
# Package: clickplc 0.14.2; the PLC is the server of pyclickplc 0.4.1 (on pymodbus 3.12.1)
# Seen: With T1 on and T2 off, get("t1") is False; with T2 on too, True. get("t1-t5") raises ValueError for a negative
#   count. get("ct1-ct5") gives 254 entries, the last of them for CT254, where CLICK's bank ends with CT250.
# Expected: T1 at coil 45056 (B000h: CLICK PLUS 3.41 exports T1 as 145057, CT1 as 149153), and five bits for five asked.
# Meaning: A supervisor on this driver takes the done bit of the next timer for that of the one it names. Drive a C with
#   the timer's contact in the ladder, and read the C. This happens outside the ladder, so clickgen cannot warn of it.
#
# Output:
#> T1=True T2=False: t1 is False
#> T1=True T2=True: t1 is True
#> t1-t5: ValueError
#> ct1-ct5: 254 entries, ct1 to ct254
set -eu
expected=$(sed -n 's/^#> //p' "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
python3 -m venv "$work/venv"
"$work/venv/bin/python" -m pip install --quiet --disable-pip-version-check \
    clickplc==0.14.2 pyclickplc==0.4.1 pymodbus==3.12.1
cat > "$work/see.py" <<'PY'
import asyncio
import socket

from clickplc import ClickPLC
from pyclickplc import ClickServer, MemoryDataProvider
from pymodbus.client import AsyncModbusTcpClient


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


async def main():
    port = free_port()
    memory = MemoryDataProvider()
    async with ClickServer(memory, host="127.0.0.1", port=port), ClickPLC("127.0.0.1", timeout=5) as plc:
        # The driver connects to 502, or to 5020 on this host, when the loop gets its turn; a free port is safer.
        plc.client = AsyncModbusTcpClient("127.0.0.1", port=port, timeout=5)
        for second in (False, True):
            memory.bulk_set({"T1": True, "T2": second})
            print(f"T1=True T2={second}: t1 is {await plc.get('t1')}")
        try:
            print("t1-t5:", await plc.get("t1-t5"))
        except ValueError as error:
            print(f"t1-t5: {type(error).__name__}")
        counters = list(await plc.get("ct1-ct5"))
        print(f"ct1-ct5: {len(counters)} entries, {counters[0]} to {counters[-1]}")


asyncio.run(asyncio.wait_for(main(), 60))
PY
seen=$(cd "$work" && venv/bin/python see.py)
printf '%s\n' "$seen"
[ "$seen" = "$expected" ] || { echo "changed: the output is not the one in the comment at the top" >&2; exit 1; }
