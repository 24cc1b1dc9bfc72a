"""Print the development requirements of pyproject.toml, one to a line, for pips without dependency groups."""

import tomllib
from pathlib import Path

PROJECT = Path(__file__).parents[1] / "pyproject.toml"


def main() -> None:
    groups = tomllib.loads(PROJECT.read_text("utf-8"))["dependency-groups"]
    print("\n".join(groups["dev"]))


if __name__ == "__main__":
    main()
