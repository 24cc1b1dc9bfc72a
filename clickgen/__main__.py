"""``python -m clickgen``.

``-m`` lets Python look for modules in the working folder first, which may be anybody's repository: without ``-P`` or
``-I`` a file called ``argparse.py`` would be run from there. What is left to do here is to look there no longer; the
command ``clickgen`` never does.
"""

import os
import sys

if not sys.flags.safe_path and sys.path and os.path.realpath(sys.path[0]) != os.path.realpath(f"{__file__}/../.."):
    del sys.path[0]

from clickgen.start import run

run()
