"""Write clickgen/dsl.pyi, the types of the language, from the Specs. A test fails while it is stale."""

from __future__ import annotations

from pathlib import Path

from clickgen.commands.stubs.stub import module_stub

PATH = Path(__file__).parents[1] / "clickgen" / "dsl.pyi"


def main() -> None:
    PATH.write_text(module_stub(), "utf-8", newline="\n")


if __name__ == "__main__":
    main()
