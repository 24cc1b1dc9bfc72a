#!/bin/sh
# pyclickplc writes a nickname file that it cannot read: the initial value of a TXT is not quoted.
#
# Package: pyclickplc 0.4.1
# Seen: A comma and a quotation mark are legal initial values of a TXT by the package's own check. write_csv() puts
#   them into the file bare. The comma moves the columns of its row (the comment is now "No"); after the quotation mark
#   the row and all that follow run together, and read_csv() raises AttributeError.
# Expected: Values in quotes where CSV needs them: nickname and comment of the same row have them.
# Meaning: One character of a printer text can spoil the nickname file of a project. clickgen quotes the value, and
#   tests its table against this reader with such values (tests/table/test_table.py).
#
# Output:
#> comma is legal: True
#> row: TXT1,TEXT,"Separator",,,No,"between fields"
#> read back: initial value '', comment 'No'
#> quotation mark is legal: True
#> row: TXT1,TEXT,"Separator",",No,"between fields"
#> read back: AttributeError
set -eu
expected=$(sed -n 's/^#> //p' "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
python3 -m venv "$work/venv"
"$work/venv/bin/python" -m pip install --quiet --disable-pip-version-check \
    pyclickplc==0.4.1
cat > "$work/see.py" <<'PY'
from pathlib import Path

from pyclickplc import read_csv, write_csv
from pyclickplc.addresses import AddressRecord
from pyclickplc.banks import DataType
from pyclickplc.validation import validate_initial_value

path = Path("nicknames.csv")
for name, value in (("comma", ","), ("quotation mark", '"')):
    print(f"{name} is legal: {validate_initial_value(value, DataType.TXT)[0]}")
    record = AddressRecord(
        memory_type="TXT",
        address=1,
        nickname="Separator",
        comment="between fields",
        initial_value=value,
        retentive=False,
        data_type=DataType.TXT,
    )
    write_csv(path, [record])
    print("row:", path.read_text().splitlines()[1])
    try:
        found = read_csv(path).addr["TXT1"]
        print(f"read back: initial value {found.initial_value!r}, comment {found.comment!r}")
    except AttributeError as error:
        print(f"read back: {type(error).__name__}")
PY
seen=$(cd "$work" && venv/bin/python see.py)
printf '%s\n' "$seen"
[ "$seen" = "$expected" ] || { echo "changed: the output is not the one in the comment at the top" >&2; exit 1; }
