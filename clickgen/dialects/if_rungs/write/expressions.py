"""Operands, conditions and calls as a program writes them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from keyword import iskeyword

from clickgen.click.draw.tokens import real_token
from clickgen.device.banks import CURRENT_VALUE_OF, Address
from clickgen.dialects.if_rungs.write.layout import Atom, Brackets, Comparison, Keyword, Piece
from clickgen.formula import print_source
from clickgen.instructions.spec import Param, ParamKind
from clickgen.ir.conditions import All, Always, Any, Compare, Condition, Edge
from clickgen.ir.modbus import Remote, RemoteCell, RemoteModbus, RtuTarget, Target, TcpTarget
from clickgen.ir.operands import Cell, CharCode, Hex, Immediate, Integer, Named, Operand, Pointer, Range, Real, Text
from clickgen.ir.program import Action, FormulaText, KeptToken, Operands, Options, Pattern, Word
from clickgen.ir.walk import Rewriter

EDGE_FUNCTIONS = {Edge.RISE: "re", Edge.FALL: "fe"}
"""How the language writes a contact on an edge."""

Names = Mapping[Address, str]
"""The nicknames to write in place of addresses."""


class WithNames(Rewriter):
    """A program with the nicknames that are known."""

    def __init__(self, names: Names) -> None:
        self._names = names

    def cell(self, cell: Named | Cell) -> Named | Cell:
        if isinstance(cell, Named):
            return cell
        name = self._names.get(cell.address)
        if name is None and cell.bank in CURRENT_VALUE_OF:
            name = self._names.get(Address(CURRENT_VALUE_OF[cell.bank], cell.address.number))
        return cell if name is None else Named(cell.bank, name, cell.span)

    def action(self, action: Action) -> Action:
        """Keep the numbers of a search's ends if only one has a name: then they are written as a slice."""
        changed = super().action(action)
        finds = action.effects.finds
        ends = (finds.start, finds.end) if finds is not None else ()
        if all(isinstance(changed.args[name], Named) for name in ends):
            return changed
        return Action(action.spec, {**changed.args, **{name: action.args[name] for name in ends}}, action.span)


# -- operands ---------------------------------------------------------------------------------------------------------


def operand_text(operand: Operand) -> str:
    """``ds.Step``, ``ds[5]``, ``c[1:9]``, ``c[8:0:-1]``, ``ds[ds.Index]``, ``x[1].immediate``, ``0x00FF``, ``"A"``."""
    if isinstance(operand, Named):
        is_plain = operand.name.isascii() and operand.name.isidentifier() and not iskeyword(operand.name)
        bank = operand.bank.lower()
        return f"{bank}.{operand.name}" if is_plain else f"{bank}[{quoted(operand.name)}]"
    if isinstance(operand, Cell):
        number = '"0u"' if operand.address.upper else str(operand.address.number)
        return f"{operand.bank.lower()}[{number}]"
    if isinstance(operand, Range):
        step = -1 if operand.is_reversed else 1
        behind = f"{operand.last + step}" + (":-1" if operand.is_reversed else "")
        return f"{operand.bank.lower()}[{operand.first}:{behind}]"
    if isinstance(operand, Pointer):
        return f"{operand.bank.lower()}[{operand_text(operand.register)}]"
    if isinstance(operand, Immediate):
        return f"{operand_text(operand.target)}.immediate"
    if isinstance(operand, Integer):
        return str(operand.value)
    if isinstance(operand, Hex):
        return f"0x{operand.value:04X}"
    if isinstance(operand, Real):
        return real_token(operand)
    if isinstance(operand, CharCode):
        return f'"${operand.value:02X}"'
    assert isinstance(operand, Text)
    return quoted(operand.value)


def quoted(text: str) -> str:
    """Return a text as a literal: in double quotes, unless single ones save escapes."""
    escaped = "".join(map(_escaped, text))
    if '"' in escaped and "'" not in escaped:
        return f"'{escaped}'"
    return '"' + escaped.replace('"', '\\"') + '"'


def _escaped(character: str) -> str:
    if character == "\\":
        return "\\\\"
    return character if character.isprintable() else character.encode("unicode_escape").decode()


# -- conditions -------------------------------------------------------------------------------------------------------


def condition_piece(condition: Condition) -> Piece:
    """A condition: ``True``, ``c.Run``, ``nc(x[1])``, ``ds[1] == 5``, ``any(c.A, all(c.B, c.C))``."""
    if isinstance(condition, Always):
        return Atom("True")
    if isinstance(condition, Compare):
        return Comparison(operand_text(condition.left), condition.op, operand_text(condition.right))
    if isinstance(condition, All | Any):
        opening = "all(" if isinstance(condition, All) else "any("
        return Brackets(opening, tuple(map(condition_piece, condition.terms)), ")")
    operand = Atom(operand_text(condition.operand))
    edge = condition.edge
    function = EDGE_FUNCTIONS[edge] if edge else "nc" if condition.negated else ""
    return Brackets(f"{function}(", (operand,), ")") if function else operand


# -- calls ------------------------------------------------------------------------------------------------------------


def action_piece(action: Action) -> Piece:
    """An instruction: ``ton(t.Delay, setpoint=5, unit=Ts)``, ``return``, ``pass``."""
    name = action.spec.name
    if name in ("return", "pass"):
        return Atom(name)
    parts = _search_parts(action) if action.effects.finds is not None else list(_parts(action))
    return Brackets(f"{name}(", tuple(parts), ")")


def _parts(action: Action) -> Iterator[Piece]:
    for param in action.spec.params:
        value = action.args.get(param.name)
        if value is None:
            continue
        if param.kind is ParamKind.PIN:
            condition = action.pin(param.name)
            assert condition is not None
            yield Keyword(f"{param.name}=lambda: ", condition_piece(condition))
            continue
        piece = value_piece(action, param)
        by_name = param.by_name or param.kind in (ParamKind.FLAG, ParamKind.UNIT, ParamKind.OPTIONS)
        yield Keyword(f"{param.name}=", piece) if by_name else piece


def _search_parts(action: Action) -> list[Piece]:
    """``ds[100:201] >= ds.Limit, result=ds.FoundAt, found=c.Found``"""
    start, end, value = (action.args[name] for name in ("start", "end", "value"))
    if not (isinstance(start, Named | Cell) and isinstance(end, Named | Cell) and isinstance(value, Operand)):
        raise TypeError("a search needs its range and its value")
    if isinstance(start, Named) or isinstance(end, Named) or start.address.upper or end.address.upper:
        return list(_parts(action))
    searched = Range(start.bank, start.address.number, end.address.number, start.span)
    first = Comparison(operand_text(searched), action.word("condition"), operand_text(value))
    rest = {param.name: value_piece(action, param) for param in action.spec.params if param.name in action.args}
    names = {"result": "result", "flag": "found", "continuous": "continuous", "oneshot": "oneshot"}
    return [first, *(Keyword(f"{word}=", rest[name]) for name, word in names.items() if name in rest)]


def value_piece(action: Action, param: Param) -> Piece:
    """One argument, except those of a pin."""
    value = action.args[param.name]
    if isinstance(value, Operand):
        return Atom(operand_text(value))
    if isinstance(value, FormulaText):
        return Atom(quoted(print_source(value.formula)))
    if isinstance(value, Operands):
        return Brackets("[", tuple(Atom(operand_text(item)) for item in value.items), "]")
    if isinstance(value, Pattern):
        rows = (Brackets("[", tuple(Atom(str(int(bit))) for bit in row), "]") for row in value.rows)
        return Brackets("[", tuple(rows), "]")
    if isinstance(value, Options):
        return _options_piece(value)
    if isinstance(value, Target):
        return _target_piece(value)
    if isinstance(value, Remote):
        return remote_piece(value)
    if isinstance(value, KeptToken):
        return Atom(quoted(value.text))
    assert isinstance(value, Word)
    if isinstance(value.value, bool):
        return Atom(str(value.value))
    if param.kind is ParamKind.UNIT or value.is_function:
        return Atom(value.value)
    assert param.kind in (ParamKind.ROUTINE, ParamKind.COMPARISON, ParamKind.TEXT)
    return Atom(quoted(value.value))


def _options_piece(options: Options) -> Piece:
    settings = []
    if not options.suppress_zero:
        settings.append("suppress_zero=False")
    if options.exponential:
        settings.append("exponential=True")
    if options.termination_code is not None:
        settings.append(f'termination_code="${options.termination_code:02X}"')
    return Brackets(f"{options.name}(", tuple(map(Atom, settings)), ")") if settings else Atom(options.name)


def _target_piece(target: Target) -> Piece:
    if isinstance(target, TcpTarget):
        label = [] if target.name == "tcp" else [f"name={quoted(target.name)}"]
        parts = [*label, f'ip="{target.ip}"', f"port={target.port}", f"device_id={target.device_id}"]
        return Brackets("ModbusTcpTarget(", tuple(map(Atom, parts)), ")")
    assert isinstance(target, RtuTarget)
    label = [] if target.name == "rtu" else [f"name={quoted(target.name)}"]
    parts = [*label, f'com_port="{target.com_port}"', f"device_id={target.device_id}"]
    return Brackets("ModbusRtuTarget(", tuple(map(Atom, parts)), ")")


def remote_piece(remote: Remote) -> Piece:
    """An address of another device."""
    if isinstance(remote, RemoteCell):
        return Atom(f'"{remote.address}"')
    assert isinstance(remote, RemoteModbus)
    if not remote.register_type:
        return Brackets("ModbusAddress(", (Atom(f"address={remote.number}"),), ")")
    parts = (Atom(f'address="{remote.number:X}h"'), Atom(f'register_type="{remote.register_type}"'))
    return Brackets("ModbusAddress(", parts, ")")
