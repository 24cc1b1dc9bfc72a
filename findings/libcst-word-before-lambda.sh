#!/bin/sh
# libcst refuses Python that Python accepts: a lambda or a conditional expression in parentheses, directly after a word.
#
# Package: libcst 1.9.0
# Seen: parse_statement() raises TypeError for `not(lambda: a)` and `return(lambda: a)`, and CSTValidationError for
#   `not(a if b else c)`. With a blank after the word, all of them are read.
# Expected: the parentheses end the word, as they do for `not(a)`, which libcst reads. Python reads all of these. What a
#   parser refuses is reported as ParserSyntaxError.
# Meaning: A tool that catches ParserSyntaxError alone stops with a traceback at a valid line. clickgen catches all
#   three errors and asks for the blank (CG101).
#
# Output:
#> not(a): Python reads it, libcst reads it
#> not(lambda: a): Python reads it, libcst raises TypeError
#> not (lambda: a): Python reads it, libcst reads it
#> return(lambda: a): Python reads it, libcst raises TypeError
#> a in(lambda: b): Python reads it, libcst raises TypeError
#> not(a if b else c): Python reads it, libcst raises CSTValidationError
#> not (a if b else c): Python reads it, libcst reads it
set -eu
expected=$(sed -n 's/^#> //p' "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
python3 -m venv "$work/venv"
"$work/venv/bin/python" -m pip install --quiet --disable-pip-version-check \
    libcst==1.9.0
cat > "$work/see.py" <<'PY'
import ast

import libcst

for text in (
    "not(a)",
    "not(lambda: a)",
    "not (lambda: a)",
    "return(lambda: a)",
    "a in(lambda: b)",
    "not(a if b else c)",
    "not (a if b else c)",
):
    ast.parse(text)
    try:
        libcst.parse_statement(text)
        found = "reads it"
    except Exception as error:
        found = f"raises {type(error).__name__}"
    print(f"{text}: Python reads it, libcst {found}")
PY
seen=$(cd "$work" && venv/bin/python see.py)
printf '%s\n' "$seen"
[ "$seen" = "$expected" ] || { echo "changed: the output is not the one in the comment at the top" >&2; exit 1; }
