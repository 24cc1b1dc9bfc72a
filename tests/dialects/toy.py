# ruff: noqa: ARG002
"""A second dialect for tests: a program is written in words, ``WHEN bit C7 THEN drive bit Y1``.

Its texts are made from the IR, and reading gives that IR back with the places in the text: enough to send a program
through every stage in another spelling.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace

from clickgen.device.banks import Address
from clickgen.dialects.base import Dialect, Look, NamePlaces, Spelling
from clickgen.instructions.spec import Spec
from clickgen.ir.conditions import All, Always, Any, Compare, Condition, Contact
from clickgen.ir.formula_nodes import Formula
from clickgen.ir.formula_operands import map_refs
from clickgen.ir.modbus import Remote
from clickgen.ir.operands import (
    Cell,
    CharCode,
    Hex,
    Immediate,
    Named,
    Operand,
    Pointer,
    Range,
    Real,
    Single,
    Text,
)
from clickgen.ir.program import (
    Action,
    Branch,
    FormulaText,
    Item,
    KeptToken,
    Loop,
    Operands,
    Options,
    Pattern,
    Program,
    Routine,
    Rung,
    Value,
    Word,
)
from clickgen.problems.diagnostics import Diagnostic, Diagnostics
from clickgen.problems.silence import Directive
from clickgen.table.rows import Row
from clickgen.text.edits import Edit, Fix
from clickgen.text.source import EmbeddedText, SourceFile, Span
from clickgen.workspace import Workspace


class ToySpelling(Spelling):
    """Everything in words and angle brackets."""

    range_end = ""
    always = "EVER"
    immediate = "AT ONCE"
    backwards = "BACKWARDS"

    def cell(self, address: Address) -> str:
        return f"<{address}>"

    def name(self, bank: str, name: str) -> str:
        return f"<{bank} {name}>"

    def in_quotes(self, bank: str, name: str) -> str:
        return f"<{bank} {name}>"

    def range(self, bank: str, first: int, last: int) -> str:
        return f"<{bank}{first} TO {bank}{last}>"

    def member(self, block: str, index: int) -> str:
        return f"{block} MEMBER {index}"

    def members(self, block: str, count: int) -> str:
        return f"{block} FIRST {count}"

    def pointer(self, bank: str, register: str) -> str:
        return f"<{bank} AT {register}>"

    def is_address(self, text: str) -> bool:
        return text.startswith("<")

    def is_name(self, text: str) -> bool:
        return text.startswith("<") and " " in text and " AT " not in text and " TO " not in text

    def address_hint(self, text: str, bank: str = "C") -> str:
        return f"write {self.name(bank, text)}"

    def operand(self, operand: Operand) -> str:
        if isinstance(operand, Named):
            name = self.name(operand.bank, operand.name)
            if operand.part is None:
                return name
            if isinstance(operand.part, int):
                return self.member(name, operand.part)
            return f"{name} FROM {operand.part.start} UNTIL {operand.part.stop}"
        if isinstance(operand, Cell):
            return self.cell(operand.address)
        if isinstance(operand, Range):
            return self.range(operand.bank, operand.first, operand.last)
        if isinstance(operand, Pointer):
            return self.pointer(operand.bank, self.operand(operand.register))
        if isinstance(operand, Immediate):
            return f"{self.operand(operand.target)} {self.immediate}"
        if isinstance(operand, Hex):
            return self.hexadecimal(operand.value)
        if isinstance(operand, CharCode):
            return f"CODE {operand.value}"
        if isinstance(operand, Text):
            return self.quoted(operand.value)
        return operand.text if isinstance(operand, Real) else str(operand.value)

    def remote(self, remote: Remote) -> str:
        return f"<{type(remote).__name__}>"

    def condition(self, condition: Condition) -> str:
        return Writer("").condition(condition)[0]

    def action(self, action: Action) -> str:
        return Writer("").action(action)[0]

    def off(self, bit: str) -> str:
        return f"OFF {bit}"

    def rising(self, bit: str) -> str:
        return f"RISING {bit}"

    def compared(self, left: str, op: str, right: str) -> str:
        return f"{left} {op} {right}"

    def every(self, *terms: str) -> str:
        return f"BOTH {' AND '.join(terms)} END"

    def some(self, *terms: str) -> str:
        return f"EITHER {' OR '.join(terms)} END"

    def call(self, spec: Spec, *texts: str, **named: str) -> str:
        given = [*texts, *(self.setting(name, text) for name, text in named.items())]
        return f"DO {spec.name} WITH {', '.join(given)}" if given else f"DO {spec.name}"

    def rung(self, condition: str, *actions: str) -> str:
        return f"WHEN {condition or self.always} THEN {' '.join(actions)}".rstrip()

    def example(self, spec: Spec) -> str:
        return self.call(spec, *(param.name.upper() for param in spec.params))

    def signature(self, spec: Spec) -> str:
        return self.example(spec)

    def rung_at(self, indent: str, action: str) -> str:
        return f"{indent}WHEN {self.always} THEN {action}"

    def goes_on(self, line: str) -> bool:
        return False

    def pin(self, name: str, condition: str) -> str:
        return f"{name} FROM {condition}"

    def chained(self, name: str, condition: str, **named: str) -> str:
        return ""

    def declaration(self, *texts: str, **settings: str) -> str:
        given = [*texts, *(self.setting(name, text) for name, text in settings.items())]
        return f"NAME {' '.join(given)}" if given else "NAME"

    def setting(self, name: str, value: str = "") -> str:
        return f"{name} IS {value}".rstrip()

    def ignore(self, code: str) -> str:
        return f"(* quiet {code} *)"

    def routine(self, function: str, title: str = "", is_main: bool = False) -> str:
        return f"{'PROGRAM' if is_main else 'ROUTINE'} {function}"

    def subroutine_mark(self, title: str = "") -> str:
        return f"ROUTINE {title}".rstrip()

    def imported(self, module: str, function: str) -> str:
        return f"USE {function} OF {module}"

    def loop(self, count: str) -> str:
        return f"REPEAT {count}"

    def quoted(self, text: str) -> str:
        return f"'{text}'"

    def hexadecimal(self, value: int) -> str:
        return f"16#{value:04X}"


SPELL = ToySpelling()


class Writer:
    """Writes IR as text, line by line, and gives the IR back with the places that it has there."""

    def __init__(self, path: str) -> None:
        self.path = path
        self.lines: list[str] = []

    def span(self, start: int, end: int) -> Span:
        """A stretch of the line that is written next, counted from 0."""
        line = len(self.lines) + 1
        return Span(self.path, line, start + 1, line, max(end, start + 1) + 1)

    # -- parts of a line: each gets where it begins, and gives its text and itself with its place ----------------------

    def operand(self, operand: Operand, at: int = 0) -> tuple[str, Operand]:
        text = SPELL.operand(operand)
        span = self.span(at, at + len(text))
        if isinstance(operand, Pointer):
            inner = self.operand(operand.register, at + len(f"<{operand.bank} AT "))[1]
            assert isinstance(inner, Named | Cell)
            return text, Pointer(operand.bank, inner, span)
        if isinstance(operand, Immediate):
            target = self.operand(operand.target, at)[1]
            assert isinstance(target, Named | Cell | Range)
            return text, Immediate(target, span)
        if isinstance(operand, Text):
            places = tuple((span.line, span.col + 1 + index) for index in range(len(operand.value) + 1))
            embedded = EmbeddedText(operand.embedded.source, operand.value, places)
            return text, replace(operand, span=span, embedded=embedded)
        return text, replace(operand, span=span)

    def condition(self, condition: Condition, at: int = 0) -> tuple[str, Condition]:
        if isinstance(condition, Always):
            return SPELL.always, Always(self.span(at, at + len(SPELL.always)))
        if isinstance(condition, Contact):
            word = {"rise": "RISING ", "fall": "FALLING "}.get(condition.edge.value, "") if condition.edge else ""
            word = word or ("OFF " if condition.negated else "")
            text, operand = self.operand(condition.operand, at + len(word))
            assert isinstance(operand, Named | Cell | Range | Immediate)
            return word + text, replace(condition, operand=operand, span=self.span(at, at + len(word + text)))
        if isinstance(condition, Compare):
            left, one = self.operand(condition.left, at)
            is_bare = condition.left.span == condition.right.span
            head = left if is_bare else f"{left} {condition.op} "
            right, other = (
                (left, self.bare(condition.right, one)) if is_bare else self.operand(condition.right, at + len(head))
            )
            text = head if is_bare else head + right
            assert isinstance(one, Single)
            assert isinstance(other, Single)
            return text, replace(condition, left=one, right=other, span=self.span(at, at + len(text)))
        opening, sign = ("BOTH ", " AND ") if isinstance(condition, All) else ("EITHER ", " OR ")
        text = opening
        terms: list[Condition] = []
        for index, term in enumerate(condition.terms):
            text += sign if index else ""
            written, placed = self.condition(term, at + len(text))
            text, terms = text + written, [*terms, placed]
        text += " END"
        return text, type(condition)(tuple(terms), self.span(at, at + len(text)))

    @staticmethod
    def bare(zero: Operand, register: Operand) -> Operand:
        """The 0 that a register by itself is compared with is where the register is."""
        return replace(zero, span=register.span)

    def value(self, value: Value, at: int) -> tuple[str, Value]:
        if isinstance(value, Contact | Compare | All | Any | Always):
            return self.condition(value, at)
        if isinstance(value, Operand):
            return self.operand(value, at)
        if isinstance(value, FormulaText):
            return self.formula(value, at)
        if isinstance(value, Operands):
            text = ""
            items: list[Single] = []
            for index, item in enumerate(value.items):
                text += " " if index else ""
                written, placed = self.operand(item, at + len(text))
                assert isinstance(placed, Single)
                text, items = text + written, [*items, placed]
            return text, Operands(tuple(items), self.span(at, at + len(text)))
        if isinstance(value, KeptToken):
            # A token is CLICK's own text.
            return "TOKEN", replace(value, span=self.span(at, at + 5))
        if isinstance(value, Pattern):
            text = "/".join("".join(str(int(bit)) for bit in row) for row in value.rows)
        else:
            text = str(value.value) if isinstance(value, Word) else type(value).__name__.upper()
            text = value.name if isinstance(value, Options) else text
        return text, replace(value, span=self.span(at, at + len(text)))

    def formula(self, value: FormulaText, at: int) -> tuple[str, FormulaText]:
        span = self.span(at, at + len("FORMULA"))

        def placed(ref: Named | Cell | Pointer) -> Named | Cell | Pointer:
            if isinstance(ref, Pointer):
                return Pointer(ref.bank, replace(ref.register, span=span), span)
            return replace(ref, span=span)

        def summed(ref: Range | Named) -> Range | Named:
            return replace(ref, span=span)

        formula: Formula = map_refs(value.formula, placed, summed)
        return "FORMULA", FormulaText(formula, span)

    def action(self, action: Action, at: int = 0) -> tuple[str, Action]:
        text, args = f"DO {action.spec.name}", {}
        for index, (name, value) in enumerate(action.args.items()):
            text += f"{', ' if index else ' WITH '}{name} IS "
            written, placed = self.value(value, at + len(text))
            text, args[name] = text + written, placed
        return text, Action(action.spec, args, self.span(at, at + len(text)))

    # -- lines --------------------------------------------------------------------------------------------------------

    def items(self, items: Sequence[Item], depth: int) -> tuple[Item, ...]:
        found: list[Item] = []
        indent = "  " * depth
        for item in items:
            if isinstance(item, Branch):
                text, condition = self.condition(item.condition, len(indent) + 5)
                span = self.span(len(indent), len(indent) + 5 + len(text))
                self.lines.append(f"{indent}WHEN {text} THEN")
                inner = self.items(item.items, depth + 1)
                found.append(Branch(condition, inner, span._replace(end_line=len(self.lines))))
                continue
            text, action = self.action(item.action if isinstance(item, Loop) else item, len(indent))
            self.lines.append(indent + text)
            if isinstance(item, Loop):
                body = None if item.body is None else self.rungs(item.body, depth + 1)
                found.append(Loop(action, body))
            else:
                found.append(action)
        return tuple(found)

    def rungs(self, rungs: Sequence[Rung], depth: int = 1) -> tuple[Rung, ...]:
        found: list[Rung] = []
        indent = "  " * depth
        for rung in rungs:
            text, condition = self.condition(rung.condition, len(indent) + 5)
            head = self.span(len(indent), len(indent) + 5 + len(text))
            self.lines.append(f"{indent}WHEN {text} THEN")
            items = self.items(rung.items, depth + 1)
            last = len(self.lines)
            span = head._replace(end_line=last, end_col=len(self.lines[-1]) + 1)
            found.append(Rung(condition, items, rung.comment, head, span))
        return tuple(found)

    def program(self, program: Program) -> Program:
        """The program with its places in this text."""
        declarations = []
        for each in program.declarations:
            name, named = self.operand(each.named, 5)
            cell, placed = self.operand(each.cell, 6 + len(name))
            text = f"NAME {name} {cell}"
            assert isinstance(named, Named)
            assert isinstance(placed, Cell)
            initial = None if each.initial is None else replace(each.initial, span=placed.span)
            declarations.append(replace(each, named=named, cell=placed, span=self.span(0, len(text)), initial=initial))
            self.lines.append(text)
        blocks = []
        for block in program.blocks:
            name, named = self.operand(block.named, 5)
            cells, whole = self.operand(block.range, 6 + len(name))
            text = f"NAME {name} {cells}"
            assert isinstance(named, Named)
            assert isinstance(whole, Range)
            blocks.append(replace(block, named=named, range=whole, span=self.span(0, len(text)), initial=None))
            self.lines.append(text)
        routines = []
        for routine in program.routines:
            head = SPELL.routine(routine.function, is_main=routine.is_main)
            span = self.span(0, len(head))
            self.lines.append(head)
            title = None if routine.title is None else span
            routines.append(replace(routine, rungs=self.rungs(routine.rungs), span=span, title=title))
        source = SourceFile(self.path, "\n".join(self.lines) + "\n")
        return replace(
            program,
            source=source,
            routines=tuple(routines),
            declarations=tuple(declarations),
            blocks=tuple(blocks),
            proposals=(),
        )


class _ToyLook(Look):
    is_program = True
    has_main = True
    imports = ()


class Toy(Dialect):
    """``programs`` are those that it can read, by their texts."""

    name = "toy"
    suffix = ".toy"
    spell = SPELL

    def __init__(self) -> None:
        self.programs: dict[str, Program] = {}

    def written(self, program: Program, path: str) -> str:
        """The text of a program, which can be read from now on."""
        placed = Writer(path).program(program)
        self.programs[placed.source.text] = placed
        return placed.source.text

    def look(self, path: str, text: str) -> Look:
        return _ToyLook()

    def decode(self, path: str, data: bytes, problems: Diagnostics) -> SourceFile | None:
        return SourceFile(path, data.decode())

    def read(
        self, source: SourceFile, files: Workspace, problems: Diagnostics
    ) -> tuple[Program | None, tuple[SourceFile, ...]]:
        program = self.programs.get(source.text)
        if program is None:
            problems.add("CG101", source.span(1, 1, 1, 2), "the toy knows this text from nowhere")
        return program, (source,)

    def read_file(self, source: SourceFile, problems: Diagnostics) -> Sequence[object] | None:
        program = self.programs.get(source.text)
        return None if program is None else [*program.declarations, *program.blocks, *program.routines]

    def routines_in(self, source: SourceFile) -> list[str]:
        return [line.split()[1] for line in source.lines if line.startswith(("PROGRAM", "ROUTINE"))]

    def places(self, source: SourceFile, formulas: Sequence[FormulaText]) -> NamePlaces:
        raise NotImplementedError

    def comments_with(self, source: SourceFile, word: str) -> int:
        return 0

    def directives(self, source: SourceFile, problems: Diagnostics) -> list[Directive]:
        return []

    def ignoring(self, source: SourceFile, findings: Iterable[Diagnostic]) -> Fix | None:
        return None

    def without(self, source: SourceFile, directive: Directive, codes: Sequence[str]) -> Edit:
        raise NotImplementedError

    def write(self, routines: Sequence[Routine], names: Mapping[Address, str], declared: Sequence[Row] = ()) -> str:
        raise NotImplementedError

    def write_files(self, routines: Sequence[Routine], names: Mapping[Address, str]) -> dict[str, str]:
        raise NotImplementedError

    def function_name(self, name: str, taken: Collection[str]) -> str:
        return name

    def idle(self, line: str) -> str:
        return ""

    def system_point_hint(self, word: str) -> str:
        return ""

    def explain_word(self, word: str) -> list[str]:
        return []


DIALECT = Toy()
