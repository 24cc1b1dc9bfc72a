"""``python -m clickgen``."""

from clickgen.cli import run

run()
