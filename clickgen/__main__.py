"""``python -m clickgen``."""

import sys

from clickgen.cli import main

sys.exit(main())
