"""Where the command ``clickgen`` begins: Ctrl-C shows no traceback from here on, while modules are still to be loaded.

Nothing but the command imports this.
"""

import os

# The module signal loads others before it is there, which takes longer than all that Python has done until here.
signals = __import__("_signal")


def _leave(number: int, _: object) -> None:
    word = b"interrupted" if number == signals.SIGINT else b"terminated"
    os.write(2, b"clickgen: %s; nothing was written\n" % word)
    os._exit(128 + number)


for _number in (signals.SIGINT, signals.SIGTERM):
    # Who starts a command in the background may want it to ignore them.
    if signals.getsignal(_number) != signals.SIG_IGN:
        signals.signal(_number, _leave)

from clickgen.cli import run  # noqa: E402

__all__ = ["run"]
