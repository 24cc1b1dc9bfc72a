#!/bin/sh
# clickplc writes a list of more than 62 registers twice: the end of it also lands 124 registers further on.
#
# Package: clickplc 0.14.2; the PLC is the server of pyclickplc 0.4.1 (on pymodbus 3.12.1)
# Seen: set("ds1", 70 values) writes DS1 to DS70 and then values 63 to 70 once more to DS125 to DS132. A list of 40
#   numbers for DF (80 registers) changes DF63 to DF71 in the same way. No error.
# Expected: The addresses that were named, and no other; the driver's docstring speaks of dividing long requests.
# Meaning: A recipe that is loaded into DS1..DS70 overwrites what the program keeps from DS125 on. Write at most 62 DS
#   or 31 DF at a time. This happens outside the ladder, so clickgen cannot warn of it; its address table shows what
#   comes after a recipe.
#
# Output:
#> DS1=1 DS62=62 DS63=63 DS70=70 DS71=0
#> DS124=0 DS125=63 DS132=70 DS133=0
#> DF40=40.0 DF41=0.0 DF62=0.0 DF63=32.0 DF71=40.0 DF72=0.0
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

        def cells(*addresses):
            return " ".join(f"{address}={memory.get(address)}" for address in addresses)

        await plc.set("ds1", list(range(1, 71)))
        print(cells("DS1", "DS62", "DS63", "DS70", "DS71"))
        print(cells("DS124", "DS125", "DS132", "DS133"))
        await plc.set("df1", [float(number) for number in range(1, 41)])
        print(cells("DF40", "DF41", "DF62", "DF63", "DF71", "DF72"))


asyncio.run(asyncio.wait_for(main(), 60))
PY
seen=$(cd "$work" && venv/bin/python see.py)
printf '%s\n' "$seen"
[ "$seen" = "$expected" ] || { echo "changed: the output is not the one in the comment at the top" >&2; exit 1; }
