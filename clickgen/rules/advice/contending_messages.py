"""Two messages that may want one port at the same time: the second is not sent, or fails
(click-facts [message.busy])."""

from __future__ import annotations

from collections import defaultdict
from itertools import product

from clickgen.device.banks import Address
from clickgen.facts.facts import STARTING, Facts, Placed
from clickgen.facts.idle import never_run
from clickgen.facts.uses import addresses_of
from clickgen.instructions.effects import Keeps, Shape
from clickgen.ir.conditions import Condition, Contact
from clickgen.ir.modbus import RtuTarget, TcpTarget
from clickgen.ir.operands import Cell
from clickgen.ir.program import Action, actions_in
from clickgen.ir.walk import leaves
from clickgen.logic.conditions import are_exclusive, terms_of
from clickgen.problems.diagnostics import Label
from clickgen.rules.rule import Code, Findings, Rule, Severity, Wrong, finding

CODE = "CG546"

_MANY = 50
"""A message is compared with this many others on its port before it."""
_READY = frozenset(Address("SC", number) for number in (90, 100, 102))
"""_Port_1_Ready_Flag to _Port_3_Ready_Flag: whoever looks at one waits for the port (click-facts [system.ready])."""
_OWN_FLAGS = ("sending", "receiving", "success", "error")


def find(facts: Facts) -> Findings:
    on_port: dict[object, list[Placed]] = defaultdict(list)
    idle = never_run(facts)
    for placed in facts.actions:
        if placed.effects.shape is not Shape.MESSAGE or id(placed.action) in idle:
            continue
        port = _port(placed)
        before = on_port[port][:_MANY]
        other = next((one for one in before if _may_meet(facts, one, placed)), None)
        if other is not None:
            yield from _report(facts, placed, other)
        on_port[port].append(placed)


def _port(placed: Placed) -> object:
    """The serial port; in the network the device, as CLICK may talk to several at once."""
    target = placed.action.args["target"]
    if isinstance(target, RtuTarget):
        return target.com_port
    assert isinstance(target, TcpTarget)
    return target.ip, target.port


def _may_meet(facts: Facts, one: Placed, other: Placed) -> bool:
    ways = product(_ways(facts, one), _ways(facts, other))
    return any(not _take_turns(facts, mine, theirs, one, other) for mine, theirs in ways)


def _take_turns(facts: Facts, mine: _Way, theirs: _Way, one: Placed, other: Placed) -> bool:
    if are_exclusive(*mine, *theirs) or _waits(mine, other) or _waits(theirs, one):
        return True
    return _hangs_on_step(facts, mine) and _hangs_on_step(facts, theirs)


_Way = tuple[Condition, ...]


def _ways(facts: Facts, placed: Placed) -> list[_Way]:
    """The conditions for a message to go out, for each call that leads to it."""
    own = facts.ways_to(placed)
    if placed.routine.is_main:
        return [own]
    return [(*facts.ways_to(call), *own) for call in facts.calls.get(placed.routine.name, ())]


def _waits(way: _Way, other: Placed) -> bool:
    """True if a message looks at what the other one reports, or at whether the port is ready."""
    flags = {bit for name in _OWN_FLAGS for bit in addresses_of(other.action.args.get(name))} | _READY
    contacts = (leaf for condition in way for leaf in leaves(condition) if isinstance(leaf, Contact))
    return any(isinstance(one.operand, Cell) and one.operand.address in flags for one in contacts)


def _hangs_on_step(facts: Facts, way: _Way) -> bool:
    """True if a token bit decides: whatever sets it resets another one in the same rung."""
    for term in terms_of(*way):
        if not isinstance(term, Contact) or not isinstance(term.operand, Cell) or term.negated:
            continue
        writers = facts.writers(term.operand.address)
        if not all(writer.effects.keeps.isdisjoint((Keeps.STEP, Keeps.BITS)) for writer in writers):
            return True
        sets = [writer for writer in writers if writer.action.turns and not writer.depends_only_on(STARTING)]
        has_coil = any(writer.effects.follows_power for writer in writers)
        if sets and not has_coil and all(_resets(writer) for writer in sets):
            return True
    return False


def _resets(writer: Placed) -> bool:
    return any(action.turns is False for action in actions_in(writer.rung.items))


def _report(facts: Facts, placed: Placed, other: Placed) -> Findings:
    turn = facts.spell.name("DS", "Turn")
    here, there = placed.action, other.action
    target = here.args["target"]
    port = f"port {target.com_port}" if isinstance(target, RtuTarget) else f"the connection to {_ip(here)}"
    yield finding(
        CODE,
        here.span,
        f"this {here.spec.name} and the {there.spec.name} in {there.span.seen_from(here.span)} may both be on, and "
        f"{port} carries one message at a time",
        f"let them take turns: compare a register, {facts.spell.compared(turn, '==', '0')} there and "
        f"{facts.spell.compared(turn, '==', '1')} here, and count it on when a message has ended",
        (Label(there.span, "wants the same port"),),
    )


def _ip(action: Action) -> str:
    target = action.args["target"]
    return target.ip if isinstance(target, TcpTarget) else ""


ABOUT = Code(
    CODE,
    Severity.WARNING,
    "two messages may want one port at the same time",
    """
A message takes many scans: the other device has to answer. While one is under way on a port, another one on that port
is not sent, or one of the two fails, and it depends on chance which. It works on the bench with one device and fails on
the machine with three.

Let the messages take turns. Count a register on when a message has ended, and compare it in each rung; so every message
gets its turn, also after an error. Or ask in each rung for the bits `sending` and `receiving` of the others.

Messages are compared that use one serial port, or that go to one device in the network. The rule is silent where their
conditions exclude each other, where one of them looks at what the other reports (sending, receiving, success, error) or
at a `_Port_..._Ready_Flag`, and where steps hand on from one to the next.
""",
    wrong=(
        Wrong(
            """
if sc._1sec_Clock:
    receive(ModbusRtuTarget(com_port="cpu2", device_id=1), ModbusAddress(address=400001), ds[1:6])

if sc._1sec_Clock:
    receive(ModbusRtuTarget(com_port="cpu2", device_id=2), ModbusAddress(address=400001), ds[11:16])  # <-
"""
        ),
        Wrong(
            """
if re(c.Ask):
    receive(ModbusTcpTarget(ip="192.168.1.10"), "DS1", ds[1:6], success=c.Answered)

if re(c.Tell):
    send(ModbusTcpTarget(ip="192.168.1.10"), "DS11", ds[11:16], success=c.Told)  # <-
"""
        ),
    ),
    right=(
        """
if all(ds.Turn == 0, nc(c.Busy)):
    receive(
        ModbusRtuTarget(com_port="cpu2", device_id=1),
        ModbusAddress(address=400001),
        ds[1:6],
        receiving=c.Busy,
        success=c.Done,
        error=c.Failed,
    )

if all(ds.Turn == 1, nc(c.Busy)):
    receive(
        ModbusRtuTarget(com_port="cpu2", device_id=2),
        ModbusAddress(address=400001),
        ds[11:16],
        receiving=c.Busy,
        success=c.Done,
        error=c.Failed,
    )

if any(re(c.Done), re(c.Failed)):
    calc("(ds.Turn + 1) MOD 2", ds.Turn)
""",
        """
if c.Ask:
    receive(ModbusRtuTarget(com_port="cpu2", device_id=1), ModbusAddress(address=400001), ds[1:6], receiving=c.Asking)

if all(c.Tell, nc(c.Asking)):
    send(ModbusRtuTarget(com_port="cpu2", device_id=1), ModbusAddress(address=400011), ds[11:16])
""",
        """
if c.Ask:
    receive(ModbusRtuTarget(com_port="cpu2", device_id=1), ModbusAddress(address=400001), ds[1:6])

if c.Tell:
    send(ModbusRtuTarget(com_port="slot0_1", device_id=1), ModbusAddress(address=400011), ds[11:16])
""",
        """
if sc._1st_SCAN:
    set(c.AskDrive)

if c.AskDrive:
    receive(ModbusRtuTarget(com_port="cpu2", device_id=1), "DS1", ds[1:6], success=c.DriveDone, error=c.DriveLost)

if any(c.DriveDone, c.DriveLost):
    reset(c.AskDrive)
    set(c.AskScale)

if c.AskScale:
    receive(ModbusRtuTarget(com_port="cpu2", device_id=2), "DS1", ds[11:16], success=c.ScaleDone, error=c.ScaleLost)

if any(c.ScaleDone, c.ScaleLost):
    reset(c.AskScale)
    set(c.AskDrive)
""",
    ),
)

RULE = Rule(find, (ABOUT,))
