"""A source file to what it holds: routines with rungs, branches and loops, declarations, imports."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from clickgen.dialects.if_rungs.fix.chains import Arm, propose
from clickgen.dialects.if_rungs.read import pieces
from clickgen.dialects.if_rungs.read.calls import read_call
from clickgen.dialects.if_rungs.read.comments import rung_comment
from clickgen.dialects.if_rungs.read.conditions import read_condition
from clickgen.dialects.if_rungs.read.context import Context
from clickgen.dialects.if_rungs.read.operands import read_constant, read_operand, shorten
from clickgen.dialects.if_rungs.read.parse import parse_tree, soundness
from clickgen.dialects.if_rungs.read.pieces import Broken, RoutineNode, Statement, statements_in_pieces, statements_of
from clickgen.dialects.if_rungs.trade import ARGUMENTS
from clickgen.dialects.if_rungs.ways_out.hints import flat_address, own, replaced
from clickgen.dialects.if_rungs.ways_out.misplaced import WayOut, way_out
from clickgen.instructions.control import FOR, NOP, RETURN
from clickgen.ir.conditions import Always, Condition
from clickgen.ir.imports import Import
from clickgen.ir.operands import Cell, Constant, Integer, Named, Operand, Range, Text
from clickgen.ir.program import Action, BlockDeclaration, Branch, Declaration, Item, Loop, Routine, Rung, Value, Word
from clickgen.ir.proposals import Proposal
from clickgen.problems.diagnostics import Diagnostic, Diagnostics, Edit, Fix, did_you_mean
from clickgen.text.source import SourceFile, Span
from clickgen.text.wording import no_opposite, quoted

_DSL_MODULE = "clickgen.dsl"
_LIBRARIES = frozenset(("clickgen", "pyrung", "pyclickplc", "clickplc", "laddercodec"))
"""Python libraries that know CLICK; none of them has a place in a program."""


@dataclass(frozen=True)
class FileContent:
    """What one file holds at its top level, in the order of its text."""

    path: str
    items: tuple[Routine | Declaration | BlockDeclaration | Import, ...]
    proposals: tuple[Proposal, ...] = ()
    """The fixes of what is wrong in its routines."""
    is_declared: bool = True
    """False when what it declares or imports could not be read."""


def read_file(source: SourceFile, problems: Diagnostics) -> FileContent | None:
    """Read one program file; None when it is not Python. Everything else that is wrong is in ``problems``."""
    if len(source.lines) > 2 * pieces.LINES:
        before = len(problems.found)
        try:
            return _read_statements(Context(source, problems), statements_in_pieces(source, soundness(source)))
        except Broken:
            del problems.found[before:]
    tree = parse_tree(source, problems)
    return None if tree is None else _read_statements(Context(source, problems), statements_of(tree))


def _read_statements(context: Context, statements: Iterator[Statement]) -> FileContent:
    items: list[Routine | Declaration | BlockDeclaration | Import | None] = []
    is_declared = True
    problems = context.problems
    for node, body in statements:
        before = len(problems.found)
        if isinstance(node, RoutineNode):
            items.append(_read_routine(context, node, body))
            is_declared &= not any(_hides_declaration(context.source, problem) for problem in problems.found[before:])
            continue
        if isinstance(node, ast.Expr) and _is_call_of(node.value, "nickname"):
            assert isinstance(node.value, ast.Call)
            items.append(_read_declaration(context, node.value))
        elif isinstance(node, ast.Import | ast.ImportFrom):
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


def _at_top_level(context: Context, node: ast.stmt) -> str:
    """The way out for a statement at the top level."""
    help = "move logic into a rung of main or of a subroutine"
    if isinstance(node, ast.If):
        is_start = "__name__" in context.text(node.test)
        return "a program is never run as Python: leave it out" if is_start else f"a rung stands in def main():; {help}"
    if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
        name = node.value.func.id if isinstance(node.value.func, ast.Name) else ""
        if name.lower() == "nickname":
            return "it is written in small letters: nickname(...)"
        return "main is called by CLICK itself: leave it out" if name == "main" else help
    return way_out(context, node).help or help


def _is_call_of(node: ast.expr, name: str) -> bool:
    return isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == name


def _is_docstring(node: ast.stmt) -> bool:
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)


def _read_imports(context: Context, node: ast.Import | ast.ImportFrom) -> list[Import]:
    """``from auto import auto_mode`` or ``import wiring``; the editor's own import is read past."""
    modules: list[tuple[str, tuple[tuple[str, Span], ...]]]
    if isinstance(node, ast.Import):
        modules = [(alias.name, ()) for alias in node.names]
    elif node.module == _DSL_MODULE and node.level == 0:
        return []
    else:
        names = tuple((alias.name, _alias_span(context, alias)) for alias in node.names)
        modules = [("" if node.level > 1 else node.module or "", names)]
    help = ""
    module = node.module or "" if isinstance(node, ast.ImportFrom) else node.names[0].name
    if module.partition(".")[0] in _LIBRARIES:
        help = "leave it out: a program is only read, and its words are known without an import"
    elif any(alias.asname for alias in node.names):
        help = "a subroutine keeps its name: leave out as"
    elif any(name == "*" for _, names in modules for name, _ in names):
        help = "name the subroutines one by one"
    elif not all(module.isidentifier() for module, _ in modules):
        help = "the file stands beside this one: from auto import auto_mode reads auto.py"
    if help:
        context.problem("CG120", node, "an import names the subroutines of a file beside this one", help)
        return [Import("", names, context.span(node)) for _, names in modules]
    return [Import(module, names, context.span(node)) for module, names in modules]


def _alias_span(context: Context, alias: ast.alias) -> Span:
    source, line = context.source, alias.lineno
    return source.span(
        line, source.column(line, alias.col_offset), line, source.column(line, alias.end_col_offset or alias.col_offset)
    )


# -- routines ---------------------------------------------------------------------------------------------------------


def _read_routine(context: Context, node: RoutineNode, body: Iterable[ast.stmt]) -> Routine:
    source = context.source
    # From def to the end of the name, for which ast has no place.
    start = source.column(node.lineno, node.col_offset)
    end = max(source.line(node.lineno).find(node.name, start) + len(node.name), start) + 1
    span = Span(source.path, node.lineno, start, node.lineno, end)
    mark = node.decorator_list[0] if len(node.decorator_list) == 1 else None
    is_titled = mark is not None and _is_call_of(mark, "sub")
    is_sub = is_titled or (isinstance(mark, ast.Name) and mark.id == "sub")
    is_main = node.name == "main" and not node.decorator_list
    problems = context.problems
    name = node.name
    if name != "main" and name.lower() == "main" and not node.decorator_list:
        # There is one main; that it is meant is certain where nothing else is called so.
        place = Span(source.path, node.lineno, end - len(name), node.lineno, end)
        is_only = re.search(r"^def[ \t]+main\b", source.text, re.MULTILINE) is None
        fix = Fix((Edit(place, "main"),), is_only)
        problems.add("CG114", span, "main is written in small letters", "write def main():", fix=fix)
        is_main, name = True, "main"
    if isinstance(node, ast.AsyncFunctionDef):
        problems.add("CG114", span, "a routine is not async", f"def {node.name}():")
    elif ast.unparse(node.args) or node.returns is not None:
        problems.add("CG114", span, "a routine takes no parameters and returns nothing", f"def {node.name}():")
    if not is_main and (not is_sub or name == "main"):
        if node.name == "main":
            problems.add("CG114", span, "main has no decorators", "def main():")
        else:
            problems.add(
                "CG114",
                span,
                "a subroutine stands under @sub alone",
                f"write @sub on the line above def {node.name}():",
                fix=_as_sub(context, node),
            )
    title = _read_title(context, mark) if isinstance(mark, ast.Call) and is_titled and node.name != "main" else None
    before = len(problems.found)
    rungs = _read_rungs(context, body, node.lineno)
    is_whole = len(problems.found) == before
    if title is None:
        return Routine(name, rungs, span, name == "main", is_whole)
    return Routine(str(title.value), rungs, span, False, is_whole, node.name, title.span)


def _as_sub(context: Context, node: ast.FunctionDef | ast.AsyncFunctionDef) -> Fix | None:
    """The fix that writes @sub for what it is called elsewhere: ``@Sub``, ``@subroutine("Auto Mode")``."""
    mark = node.decorator_list[0] if len(node.decorator_list) == 1 else None
    named = mark.func if isinstance(mark, ast.Call) else mark
    if not isinstance(named, ast.Name) or named.id.lower() not in ("sub", "subroutine"):
        return None
    return Fix((Edit(context.span(named), "sub"),), is_safe=named.id.lower() == "sub")


def _read_title(context: Context, mark: ast.Call) -> Word | None:
    """CLICK's name in ``@sub("Auto Mode")``; None where there is no text, with a problem."""
    given = [*mark.args, *(keyword.value for keyword in mark.keywords)]
    titles = [
        Word(node.value, context.span(node))
        for node in given
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
    ]
    title = titles[0] if titles else None
    if title is None or len(given) > 1 or mark.keywords:
        number = given[0].value if len(given) == 1 and isinstance(given[0], ast.Constant) else None
        help = 'write the name in plain quotes: @sub("Auto Mode")'
        if not given:
            help = "write @sub without brackets to use the function's name, or " + help.removeprefix("write ")
        elif len(titles) > 1:
            help = f"a subroutine has one name: @sub({quoted(str(titles[0].value))})"
        elif title is not None:
            help = f"write @sub({quoted(str(title.value))})"
        elif type(number) is int:
            help = f'write the number in quotes: @sub("{number}")'
        context.problem("CG114", mark, "@sub(...) takes one text: the subroutine's name in CLICK", help)
    return title


def _read_rungs(
    context: Context, nodes: Iterable[ast.stmt], header: int, holder: str = "a routine"
) -> tuple[Rung, ...]:
    """The rungs of a block; ``header`` is the last line of what holds it."""
    rungs: list[Rung] = []
    before: ast.stmt | None = None
    for node in nodes:
        if isinstance(node, ast.If):
            rungs.append(_read_rung(context, node, rung_comment(context.source, node, before, header)))
        elif not (isinstance(node, ast.Pass) or (before is None and _is_docstring(node))):
            help = "put it under a condition; if True: is the unconditional rung"
            is_call = isinstance(node, ast.Expr) and isinstance(node.value, ast.Call)
            way = WayOut() if is_call else way_out(context, node)
            context.problem("CG103", node, way.message or f"{holder} holds only rungs: if ...:", way.help or help)
        before = node
    return tuple(rungs)


def _read_rung(context: Context, node: ast.If, comment: str) -> Rung:
    condition, items = _read_if(context, node, is_branch=False)
    span = context.span(node)
    if condition is None:
        condition = Always(context.span(node.test))
    head = Span(span.path, span.line, span.col, condition.span.end_line, condition.span.end_col)
    return Rung(condition, items, comment, head, span)


def _read_if(context: Context, node: ast.If, is_branch: bool) -> tuple[Condition | None, tuple[Item, ...]]:
    """The condition and the items of an ``if``. A rung has no else; the problem stands at the ``else`` itself."""
    before = len(context.problems.found)
    condition = read_condition(context, node.test)
    items = _read_items(context, node.body)
    span = _else_span(context, node)
    if span is not None:
        arms = [Arm(context.span(node), node.test, condition, items), *_read_arms(context, node)]
        is_read = not any(problem.is_error for problem in context.problems.found[before:])
        word = context.source.line(span.line)[span.col - 1 : span.end_col - 1]
        proposal, place = propose(context, "CG104", span, arms, is_branch, is_read)
        help = "write a rung of its own with the opposite condition: nc(...) of a bit, or the opposite comparison"
        if place is not None:
            help = no_opposite(shorten(context.source.line(place.line)[place.col - 1 :][: place.end_col - place.col]))
        context.problems.add("CG104", span, f"a rung has no {word}", help)
        context.proposals.append(proposal)
    return condition, items


def _read_arms(context: Context, node: ast.If) -> Iterator[Arm]:
    """Every elif behind an ``if``, and the else: no part of the program, but read, so that all problems are found."""
    span = _else_span(context, node)
    while span is not None:
        following = node.orelse[0]
        if context.source.line(span.line)[span.col - 1 :].startswith("else"):
            yield Arm(span, None, Always(span), _read_items(context, node.orelse))
            return
        assert isinstance(following, ast.If)
        condition = read_condition(context, following.test)
        yield Arm(span, following.test, condition, _read_items(context, following.body))
        node, span = following, _else_span(context, following)


def _else_span(context: Context, node: ast.If) -> Span | None:
    """Where the ``else`` or ``elif`` of an ``if`` stands; None when it has none."""
    if not node.orelse:
        return None
    source, first = context.source, node.orelse[0]
    last_line = node.body[-1].end_lineno or node.body[-1].lineno
    for line in range(last_line + 1, first.lineno + 1):
        text = source.line(line)
        if text.strip()[:4] in ("else", "elif"):
            col = len(text) - len(text.lstrip()) + 1
            return Span(source.path, line, col, line, col + 4)
    return None


# -- rung bodies ------------------------------------------------------------------------------------------------------


def _read_items(context: Context, nodes: Sequence[ast.stmt]) -> tuple[Item, ...]:
    items = [item for node in nodes if (item := _read_item(context, node)) is not None]
    if not items and all(isinstance(node, ast.Pass) for node in nodes):
        items.append(Action(NOP, {}, context.span(nodes[0])))
    return tuple(items)


def _read_item(context: Context, node: ast.stmt) -> Item | None:
    if isinstance(node, ast.Expr) and _is_call_of(node.value, "nickname"):
        context.problem("CG112", node, "nickname(...) has no place in a rung", "write it at the top level, above main")
        return None
    if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
        return read_call(context, node.value)
    if isinstance(node, ast.If):
        condition, items = _read_if(context, node, is_branch=True)
        return Branch(condition or Always(context.span(node.test)), items, context.span(node))
    if isinstance(node, ast.For | ast.AsyncFor):
        return _read_loop(context, node)
    if isinstance(node, ast.Return):
        if node.value is not None:
            context.problem("CG112", node.value, "return gives nothing back", "write return alone")
        return Action(RETURN, {}, context.span(node))
    if isinstance(node, ast.Pass):
        return None
    way = way_out(context, node)
    help = way.help or "the actions of a rung are instruction calls, nested ifs, for, return and pass"
    context.problem("CG112", node, way.message or "this statement has no place in a rung", help, way.fix)
    return None


def _read_loop(context: Context, node: ast.For | ast.AsyncFor) -> Loop | None:
    if (
        isinstance(node, ast.AsyncFor)
        or not (isinstance(node.target, ast.Name) and node.target.id == "_")
        or node.orelse
        or not _is_call_of(node.iter, "range")
    ):
        context.problem("CG119", node, "a loop is written for _ in range(n):", *_counted_loop(context, node))
        return None
    call = node.iter
    assert isinstance(call, ast.Call)
    args: dict[str, Value] = {}
    if len(call.args) != 1 or isinstance(call.args[0], ast.Starred):
        bounds = [bound.value for bound in call.args if isinstance(bound, ast.Constant) and type(bound.value) is int]
        rounds = bounds[1] - bounds[0] if len(bounds) == len(call.args) == 2 else 0
        help = f"for _ in range({rounds if rounds > 0 else 'ds.Count'}):"
        context.problem("CG119", call, "range takes one count: a DS register or a number", help)
        return None
    count = read_operand(context, call.args[0])
    for keyword in call.keywords:
        if keyword.arg in ("oneshot", "one_shot") and isinstance(keyword.value, ast.Constant):
            args["oneshot"] = Word(keyword.value.value is True, context.span(keyword.value))
        else:
            context.problem("CG109", keyword, "a loop has no such argument", "for _ in range(n, oneshot=True):")
    body: tuple[Rung, ...] | None = None
    if not all(isinstance(child, ast.Pass) for child in node.body):
        body = _read_rungs(context, node.body, call.end_lineno or call.lineno, "the body of a loop")
    if count is None:
        return None
    args["count"] = count
    head = Span(context.source.path, *context.span(node)[1:3], *context.span(call)[3:5])
    return Loop(Action(FOR, args, head), body)


def _counted_loop(context: Context, node: ast.For | ast.AsyncFor) -> tuple[str, Fix | None]:
    """The way out for a loop in another form, and the fix for one whose variable nobody uses."""
    target = node.target
    is_range = _is_call_of(node.iter, "range") and not node.orelse and isinstance(node, ast.For)
    if not is_range or not isinstance(target, ast.Name):
        return "the count is a DS register or a number: for _ in range(ds.Count):", None
    is_used = any(
        isinstance(part, ast.Name) and part.id == target.id for child in node.body for part in ast.walk(child)
    )
    if is_used:
        way = "count in a register, and point through it: copy(ds[ds.Row], ds.Value)"
        return f"the loop has no variable, write _ for {target.id}; {way}", None
    return f"write _ for {target.id}: for _ in {context.text(node.iter)}:", replaced(context, target, "_", is_safe=True)


# -- declarations -----------------------------------------------------------------------------------------------------

_DECLARED = ("initial", "retentive", "comment")


def _read_declaration(context: Context, node: ast.Call) -> Declaration | BlockDeclaration | None:
    example = 'nickname(ds.MaxAlarms, ds[5], initial=10, retentive=False, comment="...")'
    if len(node.args) != 2:
        context.problem("CG110", node, "nickname takes a name and its address", example)
        return None
    named, cell = (read_operand(context, argument) for argument in node.args)
    initial: Constant | None = None
    retentive = comment = None
    for keyword in node.keywords:
        value = keyword.value.value if isinstance(keyword.value, ast.Constant) else ...
        if keyword.arg == "initial":
            # A bit begins as 0 or 1, for which Python's words do as well.
            if isinstance(value, bool):
                initial = Integer(int(value), context.span(keyword.value))
            else:
                initial = read_constant(context, keyword.value)
        elif keyword.arg == "retentive" and isinstance(value, bool):
            retentive = value
        elif keyword.arg == "comment" and isinstance(value, str):
            comment = value
        elif keyword.arg in _DECLARED:
            kind = "True or False" if keyword.arg == "retentive" else "a text in quotes"
            context.problem("CG115", keyword.value, f"{keyword.arg} must be {kind}", example)
        else:
            other = ARGUMENTS.get((keyword.arg or "").lower(), "")
            text = own(context, keyword.value)
            help = f"write {other}={text}: {example}" if other in _DECLARED and text else ""
            help = help or did_you_mean(keyword.arg or "", _DECLARED) or example
            context.problem("CG109", keyword, f"nickname has no argument {keyword.arg or '**'!r}", help)
    if named is None or cell is None:
        return None
    if not isinstance(named, Named) or named.part is not None:
        help = _named(context, node, named, cell) or example
        context.problem("CG115", node.args[0], "the first argument is a name in its bank: ds.MaxAlarms", help)
        return None
    if isinstance(cell, Range) and not cell.is_reversed:
        return BlockDeclaration(named, cell, context.span(node), initial, retentive, comment)
    if not isinstance(cell, Cell):
        help = f"{example}; for a block: nickname(ds.Recipe, ds[100:150])"
        flat = flat_address(str(cell.value)) if isinstance(cell, Text) else ""
        help = f"write {flat}, without quotes" if flat else help
        context.problem("CG115", node.args[1], "the second argument is one address or a range forwards", help)
        return None
    return Declaration(named, cell, context.span(node), initial, retentive, comment)


def _named(context: Context, node: ast.Call, named: Operand, cell: Operand) -> str:
    """``nickname(x.Start, x[1])`` for a name in quotes, and for a name and an address in the wrong order."""
    first, second = (own(context, argument) for argument in node.args)
    if isinstance(named, Cell) and isinstance(cell, Named) and first and second:
        return f"the name comes first: nickname({second}, {first})"
    if isinstance(named, Text) and isinstance(cell, Cell | Range) and named.value:
        shown = f".{named.value}" if named.value.isidentifier() else f"[{first}]"
        return f"write nickname({cell.bank.lower()}{shown}, {second})"
    return ""
