"""Broken programs: one step away from valid, with changed tokens and lines, valid Python without sense, noise."""

from __future__ import annotations

import keyword
import re

from hypothesis import strategies as st

from strategies.conditions import weighted
from strategies.given import Given, Texts, faulty_programs, given_files, given_program, valid, whole_programs
from strategies.mutations import CHANGES, TORN, mutated
from strategies.words import METHODS, split

# ---------------------------------------------------------------------------------------------------- one step away

_kinds = (*CHANGES, *(kind for kind in CHANGES if kind not in TORN))
one_change = st.tuples(st.sampled_from(_kinds), st.integers(0, 2**16), st.integers(0, 3))


def mutant(texts: Texts, todo: list[tuple[str, int, int]]) -> Given:
    """Changes in one file or another."""
    for kind, number, which in todo:
        name = tuple(texts)[which % len(texts)]
        texts = {**texts, name: mutated(texts[name], kind, number)}
    return given_files(texts)


_few_changes = weighted((3, one_change.map(lambda one: [one])), (1, st.lists(one_change, min_size=2, max_size=3)))
mutants: st.SearchStrategy[Given] = st.builds(mutant, weighted((4, valid), (1, faulty_programs)), _few_changes)


# ---------------------------------------------------------------------------------------------------- tokens and lines

_WORDS = split(
    """
    and or not if elif else for in while def return lambda pass import from as with class global None True False _
    all any nc re fe out set reset copy copy_block copy_fill copy_pack copy_unpack shift search calc math_hex ton
    tof rton rtof ctu ctd ctud event_drum time_drum send receive call end next_loop nickname range main sub oneshot
    one_shot unit setpoint options to_text immediate jump_step x y c t ct sc ds dd dh df xd yd td ctd sd txt Ts Tms
    other Motor con
    """
)
_NUMBERS = split(
    """
    0 1 2 8 9 16 17 20 21 816 817 2000 2001 4500 32767 32768 -1 2147483648 99999999999999999999 1e999 1.5 1j 0x10
    0xFFFFF 0b1 0o17 1_000 007
    """
)
_SIGNS = [
    *split("( ) [ ] { } : , . ; = == != < <= > >= + - * / ** ^ & | ~ @ := -> ... # `"),
    "\\",
    "'",
    '"',
    '"""',
    "\\\n",
]
_ODD = [
    "é",
    "ß",
    "\N{GREEK SMALL LETTER ALPHA}",
    "\N{FULLWIDTH LATIN SMALL LETTER C}",
    "\u2028",
    "\u00a0",
    "\ufeff",
    "\x00",
    "\x0c",
    "\x1b[31m",
    "\t",
]
_ODD += ["\r", "\r\n", "\n", "\x7f", "\U0001f600", "e\u0301", "\ud800", "\x85", " ", "    "]
_TEXTS = [
    '"A"',
    '""',
    '"$0D"',
    '"0u"',
    "'it''s'",
    'f"{c}"',
    'b"A"',
    '"ds.A + 1"',
    '"((((((((((1))))))))))"',
    '"dh[1] AND 0x1"',
]
_TEXTS += [
    '"_1st_SCAN"',
    '"SUM(ds[1:5])"',
    '"\\N{BULLET}"',
    '"\\x41"',
    'r"\\"',
    '"""\n"""',
    '"a" "b"',
    '"ds[ds[1]] / 0"',
]
PIECES = [*_WORDS, *_NUMBERS, *_SIGNS, *_ODD, *_TEXTS]
_TOKEN = re.compile(r"[A-Za-z_]\w*|\d+|\n *|[^\w\s]|\s|\w")

_ALIKE = {
    "word": [word for word in _WORDS if not keyword.iskeyword(word)],
    "number": _NUMBERS,
    "sign": ["==", "!=", "<", ">=", ":", ",", ".", "+", "-", "*"],
}


def _kind(token: str) -> str:
    if token.isidentifier():
        return "" if keyword.iskeyword(token) else "word"
    if token.isdigit():
        return "number"
    return "sign" if token in _ALIKE["sign"] else ""


Change = tuple[str, int, str]
TOKEN_CHANGES = ("alike", "replace", "delete", "twice", "swap", "insert", "nest")
LINE_CHANGES = ("drop line", "double line", "indent", "dedent", "swap lines")
changes = st.lists(
    st.tuples(
        weighted((6, st.just("alike")), (3, st.sampled_from(TOKEN_CHANGES)), (1, st.sampled_from(LINE_CHANGES))),
        st.integers(0, 2**16),
        st.sampled_from(PIECES),
    ),
    min_size=1,
    max_size=4,
)


def changed(text: str, todo: list[Change]) -> str:
    for kind, number, piece in todo:
        is_token = kind in TOKEN_CHANGES
        parts = _TOKEN.findall(text) if is_token else text.split("\n")
        if not parts:
            return piece
        at = number % len(parts)
        one = parts[at]
        if kind == "alike":
            # The next token of the same kind, so that the result is mostly still Python.
            alike = [index for index, part in enumerate(parts) if _kind(part)]
            if alike:
                at = alike[number % len(alike)]
                others = [*_ALIKE[_kind(parts[at])], *(part for part in parts if _kind(part) == _kind(parts[at]))]
                parts[at] = others[(number + len(piece)) % len(others)]
        elif kind == "replace":
            parts[at] = piece
        elif kind in ("delete", "drop line"):
            del parts[at]
        elif kind in ("twice", "double line"):
            parts.insert(at, one)
        elif kind in ("swap", "swap lines"):
            other = number // 7 % len(parts)
            parts[at], parts[other] = parts[other], one
        elif kind == "insert":
            parts.insert(at, piece)
        elif kind == "nest":
            parts[at] = f"{piece}({one})"
        elif kind == "indent":
            parts[at] = "    " + one
        else:
            parts[at] = one.removeprefix("  ")
        text = ("" if is_token else "\n").join(parts)
    return text


def _expressions() -> st.SearchStrategy[str]:
    """Python expressions of the language's words, most of them without sense."""
    banks = st.sampled_from(split("x y c t ct sc ds dd dh df xd yd td ctd sd txt foo"))
    words = st.sampled_from(split("all any nc re fe out to_text to_value range foo"))
    operators = st.sampled_from(split("== != < <= > >= and or & | + - in is"))
    signs = st.sampled_from(["not", "-", "lambda:", "lambda a:", "+"])
    names = st.sampled_from(["A", "B", "immediate", "Motor", "_x", "name_" * 6, "and_"])
    known = st.builds("{}[{}]".format, banks, st.integers(1, 20))
    named = st.builds("{}.{}".format, banks, names)
    number = st.sampled_from([one for one in _NUMBERS if one != "007"])
    plain = weighted((4, known), (1, named), (1, number), (1, st.sampled_from(_PLAIN)))
    tree = plain
    for _ in range(3):
        some = st.lists(tree, max_size=3).map(", ".join)
        tree = weighted(
            (4, plain),
            (4, st.builds("{}({})".format, words, some)),
            (1, st.builds("{}[{}]".format, banks, tree)),
            (1, st.builds("{}[{}:{}]".format, banks, tree, tree)),
            (1, st.builds("{}.{}".format, known, names)),
            (1, st.builds("{} {} {}".format, tree, operators, tree)),
            (1, st.builds("({} {})".format, signs, tree)),
        )
    return tree


_PLAIN = ["True", "None", "Ts", "foo", "...", *(one for one in _TEXTS if one[0] in "\"'" and "\n" not in one)]
_INSTRUCTIONS = split(
    """
    out set reset copy copy_block copy_fill copy_pack copy_unpack shift search calc math_hex ton tof rton rtof ctu
    ctd ctud call end next_loop nickname pass send receive event_drum time_drum
    """
)
_KEYWORDS = split(
    """
    oneshot one_shot unit setpoint options reset clock count_down source destination initial comment retentive
    formula continuous value start end result flag range outputs events presets pattern current_step accumulator
    completion_flag jump jump_step jog target remote_start dest success
    """
)


@st.composite
def sound_python(draw: st.DrawFn) -> Given:
    """Programs that Python reads: instructions with arguments of any kind, nested rungs, loops, declarations."""
    expression = _expressions()
    pins = expression.map("lambda: {}".format)

    def call() -> str:
        arguments = draw(st.lists(expression, max_size=3))
        named = draw(st.dictionaries(st.sampled_from(_KEYWORDS), st.one_of(expression, pins), max_size=2))
        arguments += [f"{name}={value}" for name, value in named.items()]
        links = draw(st.lists(st.tuples(st.sampled_from(METHODS), expression), max_size=1))
        chain = "".join(f".{method}({condition})" for method, condition in links)
        return f"{draw(st.sampled_from(_INSTRUCTIONS))}({', '.join(arguments)}){chain}"

    def block(depth: int) -> list[str]:
        lines: list[str] = []
        for _ in range(draw(st.integers(1, 3))):
            kind = draw(st.integers(0, 7)) if depth < 4 else 0
            if kind < 4:
                lines.append(call())
            elif kind < 6:
                lines += [f"if {draw(expression)}:", *("    " + line for line in block(depth + 1))]
            elif kind == 6:
                lines += [f"for _ in range({draw(expression)}):", *("    " + line for line in block(depth + 1))]
            else:
                lines.append(
                    draw(st.sampled_from(("return", "pass", "return 1", "x = 1", "if True: out(c[1])", "# note")))
                )
        return [*lines, "pass"] if lines[-1].startswith("#") else lines

    text = (
        "" if draw(st.booleans()) else f"nickname({draw(expression)}, {draw(expression)}, initial={draw(expression)})\n"
    )
    for head in ("def main():", "@sub\ndef other():")[: draw(st.integers(1, 2))]:
        text += "\n".join((head, *("    " + line for line in ("if True:", *("    " + one for one in block(0)))))) + "\n"
        text += "    if True:\n        " + ("end()" if "main" in head else "return") + "\n"
    return given_program(text)


def _broken(texts: Texts, todo: list[Change], which: int) -> Given:
    name = tuple(texts)[which % len(texts)]
    return given_files({**texts, name: changed(texts[name], todo)})


_any_file = st.integers(0, 3)
broken_programs = st.builds(_broken, valid, changes, _any_file)
_salad = st.lists(st.sampled_from(PIECES), max_size=40).map(" ".join)
_RUNG = "def main():\n    if {}:\n        {}\n    if True:\n        end()\n"


def _with_bytes(texts: Texts, at: int, data: bytes, which: int) -> Given:
    files = list(given_files(texts).files)
    name, whole = files[which % len(files)]
    files[which % len(files)] = name, whole[:at] + data + whole[at:]
    return Given(tuple(files))


random_programs = st.one_of(
    sound_python(),
    sound_python(),
    sound_python(),
    st.binary(max_size=200).map(given_program),
    st.text(max_size=100).map(given_program),
    _salad.map(given_program),
    _salad.map(lambda text: given_program(_RUNG.format(text, "out(c[1])"))),
    _salad.map(lambda text: given_program(_RUNG.format("True", text))),
    st.builds(_with_bytes, whole_programs, st.integers(0, 500), st.binary(max_size=4), _any_file),
)
