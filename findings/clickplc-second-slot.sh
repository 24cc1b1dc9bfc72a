#!/bin/sh
# clickplc switches off Y021 to Y036 whenever it sets Y016, alone or in a list.
#
# Package: clickplc 0.14.2; the PLC is the server of pyclickplc 0.4.1 (on pymodbus 3.12.1)
# Seen: set("y016", True) sends 17 coils, the last 16 of them off; set("y001", 16 x True) sends 32. Those 16 are Y021 to
#   Y036, the second I/O slot of the CPU (coils 8209 to 8224 in the address export of CLICK PLUS 3.41), which the driver
#   can neither read nor set. Fifteen outputs from Y001 on leave them alone.
# Expected: As many outputs as the list has.
# Meaning: On a CPU with two I/O slots a write to one output of the first slot releases all outputs of the second. Let
#   the ladder own the outputs, and write C bits instead. This happens outside the ladder, so clickgen cannot warn of
#   it; its bank table has Y021..Y036, and it refuses a range over a gap.
#
# Output:
#> Y001 to Y015 set: Y001=True Y016=False Y021=True Y036=True
#> Y016 set: Y001=True Y016=True Y021=False Y036=False
#> Y001 to Y016 set: Y001=True Y016=True Y021=False Y036=False
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
        for label, first, count in (
            ("Y001 to Y015", "y001", 15),
            ("Y016", "y016", 1),
            ("Y001 to Y016", "y001", 16),
        ):
            memory.bulk_set({"Y021": True, "Y036": True})
            await plc.set(first, [True] * count)
            found = " ".join(f"{address}={memory.get(address)}" for address in ("Y001", "Y016", "Y021", "Y036"))
            print(f"{label} set: {found}")


asyncio.run(asyncio.wait_for(main(), 60))
PY
seen=$(cd "$work" && venv/bin/python see.py)
printf '%s\n' "$seen"
[ "$seen" = "$expected" ] || { echo "changed: the output is not the one in the comment at the top" >&2; exit 1; }
