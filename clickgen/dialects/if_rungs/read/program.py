"""A source file to what it holds: routines with rungs, branches and loops, declarations, imports."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

import libcst as cst

from clickgen.dialects.if_rungs.fix.chains import Arm, propose
from clickgen.dialects.if_rungs.read import pieces
from clickgen.dialects.if_rungs.read.calls import read_call
from clickgen.dialects.if_rungs.read.comments import rung_comment
from clickgen.dialects.if_rungs.read.conditions import read_condition
from clickgen.dialects.if_rungs.read.content import FileContent
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.nodes import (
    Node,
    arguments,
    called,
    dotted,
    every,
    is_literal,
    is_starred,
    keyword_name,
    keywords,
    literal,
    name_of,
    statements,
    text_value,
    whole_number,
    word,
)
from clickgen.dialects.if_rungs.read.operands import read_constant, read_operand
from clickgen.dialects.if_rungs.read.parse import parse_tree
from clickgen.dialects.if_rungs.read.pieces import Broken
from clickgen.dialects.if_rungs.read.places import has_parameters
from clickgen.dialects.if_rungs.read.remembered import RememberedFile
from clickgen.dialects.if_rungs.read.statements import Piece, Refused, Statement, read_in_pieces, read_statements
from clickgen.dialects.if_rungs.spelling import IfRungsSpelling
from clickgen.dialects.if_rungs.trade import ARGUMENTS
from clickgen.dialects.if_rungs.ways_out.hints import flat_address, own, replaced
from clickgen.dialects.if_rungs.ways_out.misplaced import way_out
from clickgen.dialects.if_rungs.ways_out.way_out import WayOut
from clickgen.ir.conditions import Always, Condition
from clickgen.ir.imports import Import
from clickgen.ir.made import ending, loop_opening, nothing
from clickgen.ir.operands import Cell, Constant, Integer, Named, Operand, Range, Text
from clickgen.ir.program import BlockDeclaration, Branch, Declaration, Item, Loop, Routine, Rung, Value, Word
from clickgen.problems.diagnostics import Diagnostic, Diagnostics, did_you_mean
from clickgen.text.edits import Edit, Fix
from clickgen.text.source import SourceFile, Span
from clickgen.text.wording import quoted, shorten

_DSL_MODULE = "clickgen.dsl"
_LIBRARIES = frozenset(("clickgen", "pyrung", "pyclickplc", "clickplc", "laddercodec"))
"""Python libraries that know CLICK; none of them has a place in a program."""


def read_file(
    source: SourceFile, problems: Diagnostics, remembered: RememberedFile | None = None
) -> FileContent | None:
    """Read one program file; None when it is not Python. Everything else that is wrong is in ``problems``."""
    before = len(problems.found)
    context = Context(source, problems, remembered=remembered)
    if len(source.lines) > 2 * pieces.LINES:
        try:
            return _read_all(context, read_in_pieces(source, context.places))
        except (Broken, Refused):
            del problems.found[before:]
            context = Context(source, problems, remembered=remembered)
    tree = parse_tree(source, problems)
    if tree is None:
        return None
    try:
        return _read_all(context, read_statements(source, tree, context.places))
    except Refused as refused:
        del problems.found[before:]
        problems.add(refused.code, refused.span, refused.message, refused.help)
        return None


def _read_all(context: Context, found: Iterator[Statement]) -> FileContent:
    items: list[Routine | Declaration | BlockDeclaration | Import | None] = []
    is_declared = True
    problems = context.problems
    for node, body in found:
        before = len(problems.found)
        if isinstance(node, cst.FunctionDef):
            items.append(_read_routine(context, node, body))
            is_declared &= not any(_hides_declaration(context.source, problem) for problem in problems.found[before:])
            continue
        if isinstance(node, cst.Expr) and isinstance(node.value, cst.Call) and called(node.value) == "nickname":
            items.append(_read_declaration(context, node.value))
        elif isinstance(node, cst.Import | cst.ImportFrom):
            items += _read_imports(context, node)
        elif not _is_docstring(node):
            message = "only imports, nickname(...), def main(): and @sub routines stand at the top level"
            context.problem("CG102", node, message, _at_top_level(context, node))
        is_declared &= len(problems.found) == before
    kept = tuple(item for item in items if item is not None)
    return FileContent(context.source.path, kept, tuple(context.proposals), is_declared)


def _hides_declaration(source: SourceFile, problem: Diagnostic) -> bool:
    """True for a nickname(...) in a routine, where it declares nothing until somebody moves it."""
    span = problem.span
    return (
        problem.code in ("CG103", "CG112")
        and span is not None
        and source.line(span.line)[span.col - 1 :].startswith("nickname")
    )


def _at_top_level(context: Context, node: Node) -> str:
    """The way out for a statement at the top level."""
    help = "move logic into a rung of main or of a subroutine"
    if isinstance(node, cst.If):
        is_start = "__name__" in context.text(node.test)
        return "a program is never run as Python: leave it out" if is_start else f"a rung stands in def main():; {help}"
    if isinstance(node, cst.Expr) and isinstance(node.value, cst.Call):
        name = called(node.value)
        if name.lower() == "nickname":
            return "it is written in small letters: nickname(...)"
        return "main is called by CLICK itself: leave it out" if name == "main" else help
    return way_out(context, node).help or help


def _is_docstring(node: Node) -> bool:
    return isinstance(node, cst.Expr) and text_value(node.value) is not None


def _read_imports(context: Context, node: cst.Import | cst.ImportFrom) -> list[Import]:
    """``from auto import auto_mode`` or ``import wiring``; the editor's own import is read past."""
    modules: list[tuple[str, tuple[tuple[str, Span], ...]]]
    aliases = () if isinstance(node.names, cst.ImportStar) else node.names
    if isinstance(node, cst.Import):
        first = dotted(aliases[0].name)
        modules = [(dotted(alias.name), ()) for alias in aliases]
    else:
        first = dotted(node.module)
        if first == _DSL_MODULE and not node.relative:
            return []
        names = tuple((dotted(alias.name), context.span(alias)) for alias in aliases)
        if isinstance(node.names, cst.ImportStar):
            names = (("*", context.span(node.names)),)
        modules = [("" if len(node.relative) > 1 else first, names)]
    help = ""
    if first.partition(".")[0] in _LIBRARIES:
        help = "leave it out: a program is only read, and its words are known without an import"
    elif any(alias.asname for alias in aliases):
        help = "a subroutine keeps its name: leave out as"
    elif any(name == "*" for _, names in modules for name, _ in names):
        help = "name the subroutines one by one"
    elif not all(module.isidentifier() for module, _ in modules):
        help = "the file stands beside this one: from auto import auto_mode reads auto.py"
    if help:
        context.problem("CG120", node, "an import names the subroutines of a file beside this one", help)
        return [Import("", names, context.span(node)) for _, names in modules]
    return [Import(module, names, context.span(node)) for module, names in modules]


# -- routines ---------------------------------------------------------------------------------------------------------


def _read_routine(context: Context, node: cst.FunctionDef, body: Iterable[Piece]) -> Routine:
    source, function = context.source, word(node.name)
    # From def to the end of the name.
    span = context.stretch(context.extent(node)[0], context.extent(node.name)[1])
    decorators = [one.decorator for one in node.decorators]
    mark = decorators[0] if len(decorators) == 1 else None
    is_titled = called(mark) == "sub"
    is_sub = is_titled or name_of(mark) == "sub"
    is_main = function == "main" and not decorators
    problems = context.problems
    name = function
    if name != "main" and name.lower() == "main" and not decorators:
        # There is one main; that it is meant is certain where nothing else is called so.
        place = context.span(node.name)
        is_only = re.search(r"^def[ \t]+main\b", source.text, re.MULTILINE) is None
        fix = Fix((Edit(place, "main"),), is_only)
        problems.add("CG114", span, "main is written in small letters", "write def main():", fix=fix)
        is_main, name = True, "main"
    if node.asynchronous is not None:
        problems.add("CG114", span, "a routine is not async", f"def {function}():")
    elif has_parameters(node.params) or node.returns is not None:
        problems.add("CG114", span, "a routine takes no parameters and returns nothing", f"def {function}():")
    if not is_main and (not is_sub or name == "main"):
        if function == "main":
            problems.add("CG114", span, "main has no decorators", "def main():")
        else:
            problems.add(
                "CG114",
                span,
                "a subroutine stands under @sub alone",
                f"write @sub on the line above def {function}():",
                fix=_as_sub(context, mark),
            )
    title = _read_title(context, mark) if isinstance(mark, cst.Call) and is_titled and function != "main" else None
    before = len(problems.found)
    rungs = _read_body(context, body)
    is_whole = len(problems.found) == before
    if title is None:
        return Routine(name, rungs, span, name == "main", is_whole)
    return Routine(str(title.value), rungs, span, False, is_whole, function, title.span)


def _as_sub(context: Context, mark: cst.BaseExpression | None) -> Fix | None:
    """The fix that writes @sub for what it is called elsewhere: ``@Sub``, ``@subroutine("Auto Mode")``."""
    named = mark.func if isinstance(mark, cst.Call) else mark
    name = name_of(named)
    if not isinstance(named, cst.Name) or name.lower() not in ("sub", "subroutine"):
        return None
    return Fix((Edit(context.span(named), "sub"),), is_safe=name.lower() == "sub")


def _read_title(context: Context, mark: cst.Call) -> Word | None:
    """CLICK's name in ``@sub("Auto Mode")``; None where there is no text, with a problem."""
    given = [*arguments(mark), *(keyword.value for keyword in keywords(mark))]
    titles = [Word(text, context.span(node)) for node in given if (text := text_value(node)) is not None]
    title = titles[0] if titles else None
    if title is None or len(given) > 1 or keywords(mark):
        number = whole_number(given[0]) if len(given) == 1 else None
        help = 'write the name in plain quotes: @sub("Auto Mode")'
        if not given:
            help = "write @sub without brackets to use the function's name, or " + help.removeprefix("write ")
        elif len(titles) > 1:
            help = f"a subroutine has one name: @sub({quoted(str(titles[0].value))})"
        elif title is not None:
            help = f"write @sub({quoted(str(title.value))})"
        elif number is not None:
            help = f'write the number in quotes: @sub("{number}")'
        context.problem("CG114", mark, "@sub(...) takes one text: the subroutine's name in CLICK", help)
    return title


def _read_body(context: Context, body: Iterable[Piece]) -> tuple[Rung, ...]:
    """The rungs of a routine. Those without a problem are remembered by their text."""
    rungs: list[Rung] = []
    remembered, problems, proposals = context.remembered, context.problems.found, context.proposals
    for number, piece in enumerate(body):
        known = remembered.rung(piece.text, piece.base) if remembered else None
        if known is not None:
            rungs.append(known)
            continue
        before = len(problems), len(proposals)
        nodes = piece.read()
        new = _read_rungs(context, nodes, is_first=number == 0)
        is_plain = len(nodes) == len(new) == 1 and before == (len(problems), len(proposals))
        if remembered and piece.text and is_plain:
            remembered.keep(piece.text, piece.base, new[0])
        rungs += new
    return tuple(rungs)


def _read_rungs(
    context: Context, found: Iterable[Node], holder: str = "a routine", is_first: bool = True
) -> tuple[Rung, ...]:
    """The rungs of a block."""
    rungs: list[Rung] = []
    for node in found:
        if isinstance(node, cst.If):
            rungs.append(_read_rung(context, node, rung_comment(node)))
        elif not (isinstance(node, cst.Pass) or (is_first and _is_docstring(node))):
            help = "put it under a condition; if True: is the unconditional rung"
            is_call = isinstance(node, cst.Expr) and isinstance(node.value, cst.Call)
            way = WayOut() if is_call else way_out(context, node)
            context.problem("CG103", node, way.message or f"{holder} holds only rungs: if ...:", way.help or help)
        is_first = False
    return tuple(rungs)


def _read_rung(context: Context, node: cst.If, comment: str) -> Rung:
    condition, items = _read_if(context, node, is_branch=False)
    span = context.span(node)
    if condition is None:
        condition = Always(context.span(node.test))
    head = Span(span.path, span.line, span.col, condition.span.end_line, condition.span.end_col)
    return Rung(condition, items, comment, head, span)


def _read_if(context: Context, node: cst.If, is_branch: bool) -> tuple[Condition | None, tuple[Item, ...]]:
    """The condition and the items of an ``if``. A rung has no else; the problem stands at the ``else`` itself."""
    before = len(context.problems.found)
    condition = read_condition(context, node.test)
    items = _read_items(context, statements(node.body))
    span = _else_span(context, node)
    if span is not None:
        arms = [Arm(context.span(node), condition, items), *_read_arms(context, node)]
        is_read = not any(problem.is_error for problem in context.problems.found[before:])
        word = context.source.line(span.line)[span.col - 1 : span.end_col - 1]
        proposal, place = propose("CG104", span, arms, is_branch, is_read)
        help = "write a rung of its own with the opposite condition: nc(...) of a bit, or the opposite comparison"
        if place is not None:
            help = IfRungsSpelling().no_opposite(
                shorten(context.source.line(place.line)[place.col - 1 :][: place.end_col - place.col])
            )
        context.problems.add("CG104", span, f"a rung has no {word}", help)
        context.proposals.append(proposal)
    return condition, items


def _read_arms(context: Context, node: cst.If) -> Iterator[Arm]:
    """Every elif behind an ``if``, and the else: no part of the program, but read, so that all problems are found."""
    other = node.orelse
    while other is not None:
        span = _word_span(context, other)
        if isinstance(other, cst.Else):
            yield Arm(span, Always(span), _read_items(context, statements(other.body)))
            return
        condition = read_condition(context, other.test)
        yield Arm(span, condition, _read_items(context, statements(other.body)))
        other = other.orelse


def _else_span(context: Context, node: cst.If) -> Span | None:
    """The place of the first ``else`` or ``elif`` of an ``if``; None when it has none."""
    return None if node.orelse is None else _word_span(context, node.orelse)


def _word_span(context: Context, node: cst.If | cst.Else) -> Span:
    """The place of an ``elif`` or ``else``."""
    start, _ = context.extent(node)
    return context.stretch(start, start + 4)


# -- rung bodies ------------------------------------------------------------------------------------------------------


def _read_items(context: Context, found: Sequence[Node]) -> tuple[Item, ...]:
    items = [item for node in found if (item := _read_item(context, node)) is not None]
    if not items and all(isinstance(node, cst.Pass) for node in found):
        items.append(nothing(context.span(found[0])))
    return tuple(items)


def _read_item(context: Context, node: Node) -> Item | None:
    if isinstance(node, cst.Expr) and isinstance(node.value, cst.Call):
        if called(node.value) != "nickname":
            return read_call(context, node.value)
        context.problem("CG112", node, "nickname(...) has no place in a rung", "write it at the top level, above main")
        return None
    if isinstance(node, cst.If):
        condition, items = _read_if(context, node, is_branch=True)
        return Branch(condition or Always(context.span(node.test)), items, context.span(node))
    if isinstance(node, cst.For):
        return _read_loop(context, node)
    if isinstance(node, cst.Return):
        if node.value is not None:
            context.problem("CG112", node.value, "return gives nothing back", "write return alone")
        return ending(False, context.span(node))
    if isinstance(node, cst.Pass):
        return None
    way = way_out(context, node)
    help = way.help or "the actions of a rung are instruction calls, nested ifs, for, return and pass"
    context.problem("CG112", node, way.message or "this statement has no place in a rung", help, way.fix)
    return None


def _read_loop(context: Context, node: cst.For) -> Loop | None:
    call = node.iter
    if (
        node.asynchronous is not None
        or name_of(node.target) != "_"
        or node.orelse is not None
        or not isinstance(call, cst.Call)
        or called(call) != "range"
    ):
        context.problem("CG119", node, "a loop is written for _ in range(n):", *_counted_loop(context, node))
        return None
    args: dict[str, Value] = {}
    given = arguments(call)
    if len(given) != 1 or is_starred(given[0]):
        bounds = [number for bound in given if (number := whole_number(bound)) is not None]
        rounds = bounds[1] - bounds[0] if len(bounds) == len(given) == 2 else 0
        help = f"for _ in range({rounds if rounds > 0 else 'ds.Count'}):"
        context.problem("CG119", call, "range takes one count: a DS register or a number", help)
        return None
    count = read_operand(context, given[0])
    for keyword in keywords(call):
        if keyword_name(keyword) in ("oneshot", "one_shot") and is_literal(keyword.value):
            args["oneshot"] = Word(literal(keyword.value) is True, context.span(keyword.value))
        else:
            context.problem("CG109", keyword, "a loop has no such argument", "for _ in range(n, oneshot=True):")
    inner = statements(node.body)
    body: tuple[Rung, ...] | None = None
    if not all(isinstance(child, cst.Pass) for child in inner):
        body = _read_rungs(context, inner, "the body of a loop")
    if count is None:
        return None
    args["count"] = count
    head = context.stretch(context.extent(node)[0], context.extent(call)[1])
    return Loop(loop_opening(args, head), body)


def _counted_loop(context: Context, node: cst.For) -> tuple[str, Fix | None]:
    """The way out for a loop in another form, and the fix for one whose variable nobody uses."""
    name = name_of(node.target)
    if called(node.iter) != "range" or node.orelse is not None or node.asynchronous is not None or not name:
        return "the count is a DS register or a number: for _ in range(ds.Count):", None
    if any(name_of(part) == name for part in every(node.body)):
        way = "count in a register, and point through it: copy(ds[ds.Row], ds.Value)"
        return f"the loop has no variable, write _ for {name}; {way}", None
    fix = replaced(context, node.target, "_", is_safe=True)
    return f"write _ for {name}: for _ in {context.text(node.iter)}:", fix


# -- declarations -----------------------------------------------------------------------------------------------------

_DECLARED = ("initial", "retentive", "comment")


def _read_declaration(context: Context, node: cst.Call) -> Declaration | BlockDeclaration | None:
    example = 'nickname(ds.MaxAlarms, ds[5], initial=10, retentive=False, comment="...")'
    given = arguments(node)
    if len(given) != 2:
        context.problem("CG110", node, "nickname takes a name and its address", example)
        return None
    named, cell = (read_operand(context, argument) for argument in given)
    initial: Constant | None = None
    retentive = comment = None
    for keyword in keywords(node):
        name, value = keyword_name(keyword), literal(keyword.value)
        if name == "initial":
            # A bit begins as 0 or 1, for which Python's words do as well.
            if isinstance(value, bool):
                initial = Integer(int(value), context.span(keyword.value))
            else:
                initial = read_constant(context, keyword.value)
        elif name == "retentive" and isinstance(value, bool):
            retentive = value
        elif name == "comment" and isinstance(value, str):
            comment = value
        elif name in _DECLARED:
            kind = "True or False" if name == "retentive" else "a text in quotes"
            context.problem("CG115", keyword.value, f"{name} must be {kind}", example)
        else:
            other = ARGUMENTS.get(name.lower(), "")
            text = own(context, keyword.value)
            help = f"write {other}={text}: {example}" if other in _DECLARED and text else ""
            help = help or did_you_mean(name, _DECLARED) or example
            context.problem("CG109", keyword, f"nickname has no argument {name or '**'!r}", help)
    if named is None or cell is None:
        return None
    if not isinstance(named, Named) or named.part is not None:
        help = _named(context, node, named, cell) or example
        context.problem("CG115", given[0], "the first argument is a name in its bank: ds.MaxAlarms", help)
        return None
    if isinstance(cell, Range) and not cell.is_reversed:
        return BlockDeclaration(named, cell, context.span(node), initial, retentive, comment)
    if not isinstance(cell, Cell):
        help = f"{example}; for a block: nickname(ds.Recipe, ds[100:150])"
        flat = flat_address(str(cell.value)) if isinstance(cell, Text) else ""
        help = f"write {flat}, without quotes" if flat else help
        context.problem("CG115", given[1], "the second argument is one address or a range forwards", help)
        return None
    return Declaration(named, cell, context.span(node), initial, retentive, comment)


def _named(context: Context, node: cst.Call, named: Operand, cell: Operand) -> str:
    """``nickname(x.Start, x[1])`` for a name in quotes, and for a name and an address in the wrong order."""
    first, second = (own(context, argument) for argument in arguments(node))
    if isinstance(named, Cell) and isinstance(cell, Named) and first and second:
        return f"the name comes first: nickname({second}, {first})"
    if isinstance(named, Text) and isinstance(cell, Cell | Range) and named.value:
        shown = f".{named.value}" if named.value.isidentifier() else f"[{first}]"
        return f"write nickname({cell.bank.lower()}{shown}, {second})"
    return ""
