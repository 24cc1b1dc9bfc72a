#!/bin/sh
# pyclickplc's server answers for the upper words of XD1..XD8 and YD1..YD8 with the lower ones.
#
# Package: pyclickplc 0.4.1 (on pymodbus 3.12.1)
# Seen: With XD1 at 9ABCh, the registers E002h and E003h both read 9ABCh. A write to E203h, the register after YD1, goes
#   to YD1 itself.
# Expected: In the address export of CLICK PLUS 3.41 each of these registers has its own Modbus number (E003h is 357348,
#   E203h is 457860) and data type HEX, and an empty address: the upper word has no name in CLICK, but it is not YD1.
# Meaning: A master that is tested against this server can write both words of an output module, and the second write
#   overwrites the first. clickgen knows XD0u and YD0u and no other upper words, and passes over the nameless rows when
#   it reads an export.
#
# Output:
#> read E002h, E003h: ['9ABCh', '9ABCh']
#> write 0001h to E202h: YD1=1
#> write 0002h to E203h: YD1=2
set -eu
expected=$(sed -n 's/^#> //p' "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
python3 -m venv "$work/venv"
"$work/venv/bin/python" -m pip install --quiet --disable-pip-version-check \
    pyclickplc==0.4.1 pymodbus==3.12.1
cat > "$work/see.py" <<'PY'
import asyncio
import socket
import struct

from pyclickplc import ClickServer, MemoryDataProvider


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


async def ask(port, request):
    reader, writer = await asyncio.open_connection("127.0.0.1", port)
    writer.write(struct.pack(">HHHB", 1, 0, len(request) + 1, 1) + request)
    length = struct.unpack(">HHHB", await reader.readexactly(7))[2]
    answer = await reader.readexactly(length - 1)
    writer.close()
    return answer


def words(answer):
    return [f"{word:04X}h" for word in struct.unpack(f">{answer[1] // 2}H", answer[2:])]


async def main():
    port = free_port()
    memory = MemoryDataProvider()
    async with ClickServer(memory, host="127.0.0.1", port=port):
        memory.set("XD1", 0x9ABC)
        print("read E002h, E003h:", words(await ask(port, struct.pack(">BHH", 4, 0xE002, 2))))
        for register, value in ((0xE202, 1), (0xE203, 2)):
            await ask(port, struct.pack(">BHH", 6, register, value))
            print(f"write {value:04X}h to {register:04X}h: YD1={memory.get('YD1')}")


asyncio.run(asyncio.wait_for(main(), 60))
PY
seen=$(cd "$work" && venv/bin/python see.py)
printf '%s\n' "$seen"
[ "$seen" = "$expected" ] || { echo "changed: the output is not the one in the comment at the top" >&2; exit 1; }
