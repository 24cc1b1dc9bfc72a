"""One step away from valid: changes to a program's text at the places of its grammar."""

from __future__ import annotations

import ast
import re
import textwrap
from collections.abc import Callable, Mapping, Sequence
from random import Random

from strategies.source import Source, Span
from strategies.words import (
    BANKS,
    CHARACTERS,
    COMMENTS,
    FUNCTIONS,
    INDICES,
    INSTRUCTIONS,
    KEYWORDS,
    LIMITS,
    LINKS,
    LISTS,
    METHODS,
    OPERANDS,
    OPERATORS,
    PYTHON,
    SIBLINGS,
)

Change = Callable[[Source, Random], str | None]
"""Returns the changed text, or None if there is nothing to change."""


def _one(source: Source, draw: Random, nodes: Sequence[ast.AST], new: Callable[[str], str]) -> str | None:
    if not nodes:
        return None
    node = draw.choice(nodes)
    return source.edited((*source.span(node), new(source.of(node))))


def _arguments(source: Source, call: ast.Call) -> list[Span]:
    return sorted(source.span(argument) for argument in (*call.args, *call.keywords))


def _with_arguments(source: Source, draw: Random, least: int) -> list[Span] | None:
    calls = [call for call in source.calls() if len(call.args) + len(call.keywords) >= least]
    return _arguments(source, draw.choice(calls)) if calls else None


# -- arguments --------------------------------------------------------------------------------------------------------


def drop_argument(source: Source, draw: Random) -> str | None:
    spans = _with_arguments(source, draw, 1)
    if spans is None:
        return None
    at = draw.randrange(len(spans))
    start, end = spans[at]
    if at + 1 < len(spans):
        end = spans[at + 1][0]
    elif at:
        start = spans[at - 1][1]
    return source.edited((start, end, ""))


def double_argument(source: Source, draw: Random) -> str | None:
    spans = _with_arguments(source, draw, 1)
    if spans is None:
        return None
    start, end = draw.choice(spans)
    return source.edited((end, end, ", " + source.text[start:end]))


def swap_arguments(source: Source, draw: Random) -> str | None:
    spans = _with_arguments(source, draw, 2)
    if spans is None:
        return None
    one, other = draw.sample(spans, 2)
    return source.edited((*one, source.text[slice(*other)]), (*other, source.text[slice(*one)]))


def rename_keyword(source: Source, draw: Random) -> str | None:
    nodes = source.every(ast.keyword)
    return _one(source, draw, nodes, lambda text: draw.choice(KEYWORDS) + text[text.find("=") :])


def keyword_to_place(source: Source, draw: Random) -> str | None:
    return _one(source, draw, source.every(ast.keyword), lambda text: text.partition("=")[2])


def place_to_keyword(source: Source, draw: Random) -> str | None:
    nodes: list[ast.AST] = [argument for call in source.calls() for argument in call.args]
    return _one(source, draw, nodes, lambda text: f"{draw.choice(KEYWORDS)}={text}")


def add_argument(source: Source, draw: Random) -> str | None:
    def new(text: str) -> str:
        value = draw.choice(OPERANDS)
        more = value if draw.random() < 0.3 else f"{draw.choice(KEYWORDS)}={value}"
        return f"{text[:-1]}{'' if text.endswith('()') else ', '}{more})"

    return _one(source, draw, source.calls(), new)


# -- operands and words -----------------------------------------------------------------------------------------------


def other_bank(source: Source, draw: Random) -> str | None:
    banks = [node for node in source.every(ast.Name) if source.of(node) in BANKS]
    return _one(source, draw, banks, lambda _: draw.choice(BANKS))


def other_number(source: Source, draw: Random) -> str | None:
    numbers = [node for node in source.every(ast.Constant) if source.of(node)[:1].isdigit()]

    def new(text: str) -> str:
        close = str(int(text) + draw.choice((-1, 1))) if text.isdigit() else text
        return close if draw.random() < 0.2 else str(draw.choice(LIMITS) + draw.choice((-1, 0, 1)))

    return _one(source, draw, numbers, new)


def other_operand(source: Source, draw: Random) -> str | None:
    nodes = source.every(ast.Subscript, ast.Attribute, ast.Constant, ast.Compare, ast.Lambda, ast.List)
    return _one(source, draw, nodes, lambda _: draw.choice(OPERANDS))


def operand_from_here(source: Source, draw: Random) -> str | None:
    """Replace an operand by one from elsewhere in the program."""
    nodes = source.every(ast.Subscript, ast.Attribute, ast.Constant, ast.Call, ast.Compare)
    return _one(source, draw, nodes, lambda _: source.of(draw.choice(nodes)))


def other_index(source: Source, draw: Random) -> str | None:
    nodes: list[ast.AST] = [node.slice for node in source.nodes if isinstance(node, ast.Subscript)]
    return _one(source, draw, nodes, lambda _: draw.choice(INDICES))


def behind_operand(source: Source, draw: Random) -> str | None:
    nodes = source.every(ast.Subscript, ast.Attribute, ast.Constant, ast.Call)
    return _one(source, draw, nodes, lambda text: text + draw.choice(LINKS))


def around_operand(source: Source, draw: Random) -> str | None:
    nodes = source.every(ast.Subscript, ast.Attribute, ast.Constant, ast.Call, ast.Compare, ast.Lambda)
    around = [f"{word}({{}})" for word in FUNCTIONS]
    around += ["not {}", "-{}", "~{}", "({})", "[{}]", "({},)", "{} and {}", "{} | c[1]", "lambda: {}", "*{}", "{}[1]"]
    around += ["{} == {}", "{} < {} < 5", "{} + 1", "{} if c[1] else c[2]", "(a := {})", "await {}", "{}:", "{0}.{0}"]
    return _one(source, draw, nodes, lambda text: draw.choice(around).format(text, text))


def other_function(source: Source, draw: Random) -> str | None:
    nodes: list[ast.AST] = [call.func for call in source.calls() if isinstance(call.func, ast.Name)]

    def new(text: str) -> str:
        words = FUNCTIONS if text in FUNCTIONS and draw.random() < 0.8 else tuple(INSTRUCTIONS)
        return draw.choice((*words, text.upper(), text[:-1]))

    return _one(source, draw, nodes, new)


def other_operator(source: Source, draw: Random) -> str | None:
    places = [match.span() for match in re.finditer(r"(?<= )(==|!=|<=|>=|<|>|\+|-|\*|/)(?= )", source.text)]
    return source.edited((*draw.choice(places), draw.choice(OPERATORS))) if places else None


def names_for_numbers(source: Source, draw: Random) -> str | None:
    """Write all addresses of a bank as names: ``c[1]`` becomes ``c.c_1``, which clickgen then places."""
    bank = draw.choice(BANKS[:12])
    text = re.sub(rf"\b{bank}\[(\d+)\]", rf"{bank}.{bank}_\1", source.text)
    return text if text != source.text else None


# -- texts and lists --------------------------------------------------------------------------------------------------


def _texts(source: Source) -> list[ast.AST]:
    return [
        node for node in source.nodes if isinstance(node, ast.Constant) and isinstance(node.value, str)
    ]  # docstrings too


def other_quotes(source: Source, draw: Random) -> str | None:
    def new(text: str) -> str:
        inner = text.strip("\"'")
        forms = (
            "'{}'",
            '"""{}"""',
            "'''{}'''",
            "f'{}'",
            "b'{}'",
            "r'{}'",
            "u'{}'",
            "'{}",
            "{}'",
            "'{}\"",
            "{}",
            "`{}`",
        )
        return draw.choice((*forms, "'{}' ''", '"{}" "b"', "'{}\n'")).format(inner)

    return _one(source, draw, _texts(source), new)


def other_text(source: Source, draw: Random) -> str | None:
    """Add, remove, double or replace a character inside the quotes: formulas, texts, addresses."""

    def new(text: str) -> str:
        at = draw.randrange(1, max(2, len(text) - 1))
        piece = draw.choice(CHARACTERS)
        return draw.choice(
            (text[:at] + text[at + 1 :], text[:at] + piece + text[at:], text[:at] + piece + text[at + 1 :])
        )

    return _one(source, draw, _texts(source), new)


def other_list(source: Source, draw: Random) -> str | None:
    """Make a list empty, nested, longer, shorter or of another kind."""
    nodes = [node for node in source.nodes if isinstance(node, ast.List | ast.Tuple)]
    if not nodes:
        return None
    node = draw.choice(nodes)
    items = [source.of(element) for element in node.elts]
    start, end = source.span(node)
    kind = draw.randrange(7)
    if kind == 0 and items:
        del items[draw.randrange(len(items))]
    elif kind == 1 and items:
        items.insert(draw.randrange(len(items)), draw.choice(items))
    elif kind == 2 and items:
        at = draw.randrange(len(items))
        items[at] = draw.choice(("[{}]", "({},)", "*{}", "[{0}, {0}]", "[]", "[[]]", "*[{}]")).format(items[at])
    elif kind == 3:
        items *= draw.choice((2, 8, 17))
    elif kind == 4:
        draw.shuffle(items)
    elif kind == 5:
        return source.edited((start, end, draw.choice(LISTS).format(", ".join(items))))
    else:
        items.append(draw.choice(OPERANDS))
    return source.edited((start, end, f"[{', '.join(items)}]"))


# -- chains -----------------------------------------------------------------------------------------------------------


def _links(source: Source) -> list[tuple[ast.Call, Span]]:
    """Each ``.reset(...)`` of a chain with its place, the point included."""
    found: list[tuple[ast.Call, Span]] = []
    for call in source.calls():
        if isinstance(call.func, ast.Attribute):
            found.append((call, (source.span(call.func.value)[1], source.span(call)[1])))
    return found


def chain(source: Source, draw: Random) -> str | None:
    """Add a method after a call."""
    condition = draw.choice((*OPERANDS, "c[1]", "c[1], c[2]", "(c[1], c[2])", "[c[1]]", "(c[1]), step=2", ""))
    link = f".{draw.choice(METHODS)}({condition})"
    return _one(source, draw, source.calls(), lambda text: text + link)


def other_link(source: Source, draw: Random) -> str | None:
    links = _links(source)
    if not links:
        return None
    call, (start, end) = draw.choice(links)
    text = source.text[start:end]
    inner = text[text.find("(") + 1 : -1]
    name = getattr(call.func, "attr", "")
    forms = ["", text * 2, f".{name}()", f".{name}", f".{name}(lambda: {inner})", f".{name}({inner}, step=1)"]
    forms += [f".{draw.choice(METHODS)}({inner})", f"({inner})", f".{name}(({inner},), [])", f".{name}(*{inner})"]
    return source.edited((start, end, draw.choice(forms)))


def chain_to_keyword(source: Source, draw: Random) -> str | None:
    """Move ``.reset(c[1])`` to the arguments, or copy it there."""
    links = [(call, span) for call, span in _links(source) if isinstance(getattr(call.func, "value", None), ast.Call)]
    if not links:
        return None
    call, (start, end) = draw.choice(links)
    name, inner = getattr(call.func, "attr", ""), source.text[start:end].partition("(")[2][:-1]
    rest = "" if draw.random() < 0.7 else source.text[start:end]
    return source.edited((start - 1, end, f", {name}={draw.choice(('lambda: ', '', 'lambda x: '))}{inner}){rest}"))


# -- lines, words of Python, brackets ---------------------------------------------------------------------------------


def _line(source: Source, draw: Random, new: Callable[[str], str]) -> str | None:
    lines = [edit for edit in source.lines() if edit[2].strip()]
    if not lines:
        return None
    start, end, line = draw.choice(lines)
    return source.edited((start, end, new(line)))


def drop_line(source: Source, draw: Random) -> str | None:
    return _line(source, draw, lambda _: "")


def double_line(source: Source, draw: Random) -> str | None:
    return _line(source, draw, lambda line: line.rstrip("\n") + "\n" + line)


def indent_line(source: Source, draw: Random) -> str | None:
    def new(line: str) -> str:
        steps = (
            "    " + line,
            " " + line,
            "\t" + line,
            line.removeprefix("    "),
            line[1:] if line[0] == " " else line,
        )
        return draw.choice((*steps, line.lstrip(), line.replace("    ", "\t")))

    return _line(source, draw, new)


def shape_line(source: Source, draw: Random) -> str | None:
    """Add a comment, a second statement in the line, a continuation or a trailing blank."""

    def new(line: str) -> str:
        body = line.rstrip("\n")
        space = body[: len(body) - len(body.lstrip())]
        bare = body.lstrip()
        forms = [f"{space}# {bare}\n", f"{body}; {bare}\n", f"{body} \\\n", f"{body} # note\n", f"\n{line}", body]
        forms += [f"{space}pass\n{line}", f"{space}{bare} {bare}\n", f"{space}if True: {bare}\n"]
        return draw.choice((*forms, f"{body};\n", f"{body}\n\n", f"{space}'''{body}'''\n", f"\f{line}"))

    return _line(source, draw, new)


def swap_lines(source: Source, draw: Random) -> str | None:
    lines = source.lines()
    if len(lines) < 2:
        return None
    one, other = draw.sample(lines, 2)
    return source.edited((one[0], one[1], other[2]), (other[0], other[1], one[2]))


def _statements(source: Source) -> list[tuple[int, int, str]]:
    """Each statement with its whole lines."""
    lines = source.lines()
    found: list[tuple[int, int, str]] = []
    for node in source.nodes:
        if isinstance(node, ast.stmt) and node.end_lineno is not None:
            above = [one.lineno for one in getattr(node, "decorator_list", ())]
            first, last = lines[min([node.lineno, *above]) - 1], lines[node.end_lineno - 1]
            found.append((first[0], last[1], source.text[first[0] : last[1]]))
    return found


def drop_statement(source: Source, draw: Random) -> str | None:
    statements = _statements(source)
    if not statements:
        return None
    start, end, text = draw.choice(statements)
    indent = text[: len(text) - len(text.lstrip())]
    return source.edited((start, end, draw.choice(("", f"{indent}pass\n"))))


def copy_statement(source: Source, draw: Random) -> str | None:
    """Copy a statement to before another one, indented alike or not."""
    statements = _statements(source)
    if not statements:
        return None
    (_, _, text), (start, _, other) = draw.choice(statements), draw.choice(statements)
    indent = len(other) - len(other.lstrip())
    block = textwrap.indent(textwrap.dedent(text.rstrip("\n") + "\n"), " " * indent)
    return source.edited((start, start, block))


def comment(source: Source, draw: Random) -> str | None:
    def new(line: str) -> str:
        return f"{line[: len(line) - len(line.lstrip())]}{draw.choice(COMMENTS)}\n{line}"

    return _line(source, draw, new)


def other_word(source: Source, draw: Random) -> str | None:
    words = [match.span() for match in re.finditer(rf"\b({'|'.join(PYTHON)})\b", source.text)]
    return source.edited((*draw.choice(words), draw.choice((*PYTHON, "")))) if words else None


def other_bracket(source: Source, draw: Random) -> str | None:
    places = [match.span() for match in re.finditer(r"[()\[\],:=.]", source.text)]
    return (
        source.edited((*draw.choice(places), draw.choice(("", "", "(", ")", "[", "]", ",", ":", "=", ".", "(("))))
        if places
        else None
    )


def other_sibling(source: Source, draw: Random) -> str | None:
    """Change what an import reads."""
    lines = [edit for edit in source.lines() if re.match(r"(from|import) ", edit[2])]
    new = draw.choice(SIBLINGS) + "\n"
    if not lines:
        return new + source.text
    start, end, _ = draw.choice(lines)
    return source.edited((start, end, new))


CHANGES: Mapping[str, Change] = {
    change.__name__.replace("_", " "): change
    for change in (
        drop_argument, double_argument, swap_arguments, rename_keyword, keyword_to_place, place_to_keyword,
        add_argument, other_bank, other_number, other_operand, operand_from_here, other_index, behind_operand,
        around_operand, other_function, other_operator, names_for_numbers, other_quotes, other_text, other_list,
        chain, other_link, chain_to_keyword, drop_statement, copy_statement, comment, drop_line, double_line,
        indent_line, shape_line, swap_lines, other_word, other_bracket, other_sibling,
    )
}  # fmt: skip
TORN = ("drop line", "double line", "indent line", "swap lines", "other word", "other bracket")
"""Changes that mostly leave no Python."""


def mutated(text: str, kind: str, number: int) -> str:
    """Return the text with one change of this kind; the number decides where and to what."""
    draw = Random(f"{kind} {number}")
    changed = CHANGES[kind](Source(text), draw)
    if changed is None:  # nothing of this kind is there
        changed = swap_lines(Source(text), draw)
    return text if changed is None else changed
