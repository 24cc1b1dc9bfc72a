#!/bin/sh
# pyclickplc's server half-does a write that runs over the end of a bank, and reads nothing as zeros.
#
# Package: pyclickplc 0.4.1 (on pymodbus 3.12.1)
# Seen: A write of four registers from DS4499 on is answered with exception 02 (illegal address), yet DS4499 and DS4500
#   have the new values. A read of the same four registers is answered normally, with zeros for the two that do not
#   exist; so is a read where there is no bank at all.
# Expected: A request is done or refused as a whole, and what cannot be written for want of an address cannot be read.
# Meaning: A master with a wrong register number sees plausible zeros in its tests, and after a refused write it does
#   not know the state. clickgen refuses a send or receive that leaves the bank of the other CLICK (CG306).
#
# Output:
#> write 4 registers from DS4499: exception 02, DS4499=1 DS4500=2
#> read 4 registers from DS4499: ['0001h', '0002h', '0000h', '0000h']
#> write register 2710h: exception 02
#> read register 2710h: ['0000h']
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


def outcome(answer):
    return f"exception {answer[1]:02}" if answer[0] & 0x80 else "done"


async def main():
    port = free_port()
    memory = MemoryDataProvider()
    first = 4498  # DS4499; the bank ends with DS4500
    async with ClickServer(memory, host="127.0.0.1", port=port):
        written = await ask(port, struct.pack(">BHHB4H", 16, first, 4, 8, 1, 2, 3, 4))
        last = f"DS4499={memory.get('DS4499')} DS4500={memory.get('DS4500')}"
        print(f"write 4 registers from DS4499: {outcome(written)}, {last}")
        print("read 4 registers from DS4499:", words(await ask(port, struct.pack(">BHH", 3, first, 4))))
        print("write register 2710h:", outcome(await ask(port, struct.pack(">BHH", 6, 0x2710, 1))))
        print("read register 2710h:", words(await ask(port, struct.pack(">BHH", 3, 0x2710, 1))))


asyncio.run(asyncio.wait_for(main(), 60))
PY
seen=$(cd "$work" && venv/bin/python see.py)
printf '%s\n' "$seen"
[ "$seen" = "$expected" ] || { echo "changed: the output is not the one in the comment at the top" >&2; exit 1; }
