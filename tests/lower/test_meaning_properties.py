"""Splitting keeps the meaning: the source and the emitted ladder do the same, scan by scan (``judges.meaning``)."""

from __future__ import annotations

import budget
import pytest
from budget import examples
from hypothesis import given, note
from judges.meaning import check_meaning
from strategies.conditions import ALWAYS, Compare, Condition, Contact, written
from strategies.meaning import meaning_programs
from strategies.programs import Act, Branch, Loop, Pin, Program, Rung


@given(meaning_programs())
@examples(20)
def test_the_ladder_does_what_the_source_says(program: Program) -> None:
    note(program.text)
    check_meaning(program)


@given(meaning_programs())
@examples(10)
def test_a_rung_looks_at_a_moving_input_once(program: Program) -> None:
    """All conditions of a rung are looked at in one moment, whatever changes by itself in the meantime."""
    note(program.text)
    check_meaning(program, inputs_move=True)


def _out(number: int) -> Act:
    return Act(f"out(c[{number}])", f"out(C{number})")


def _ctu(number: int, reset: Condition) -> Act:
    return Act(f"ctu(ct[{number}], 2)", f"count_up(CT{number},CTD{number},preset=2)", 3, (Pin("reset", reset),))


def _program(*main: Rung, other: tuple[Rung, ...] = ()) -> Program:
    return Program(main, (("other", other),))


X1, X2, X3, RISE = Contact("X001"), Contact("X002"), Contact("X003"), Contact("X003", "re")
END, RETURN, CALL = Act("end()", "end()"), Act("return", "return()"), Act("call(other)", 'call("other")')
RTOF = Act("rtof(t[11], 2)", "off_delay(T11,TD11,preset=2,unit=Tms)", 2, (Pin("reset", X3),))
CALLS = Rung(ALWAYS, (CALL,))
PADDED = Act(
    "copy(ds[2].as_text(pad=5), txt[1])",
    "copy(DS2,TXT1,convert=to_text(suppress_zero=0,exponential=0,termination_code=none))",
    2,
)
RECEIVE = Act(
    'receive(ModbusTcpTarget(ip="10.0.0.2"), "C1", c[1:4])',
    'receive(target=ModbusTcpTarget(name="tcp",ip="10.0.0.2",port=502,device_id=1),remote_start="C1",dest=C1..C3)',
    3,
)


def _drum(event: str, *pins: Pin) -> Act:
    call = f"event_drum([c[1]], [{written(event)}], [[1]], ds[1], c[2])"
    token = f"event_drum(outputs=[C1],events=[{event}],pattern=[[1]],current_step=DS1,completion_flag=C2)"
    return Act(call, token, 4, (Pin("reset", X3), *pins))


def _write(cell: str, value: int = 0) -> Act:
    bank, number = cell[:-1].upper().split("[")
    return Act(f"copy({value}, {cell})", f"copy({value},{bank}{number})", 2)


CLOCK = Contact("SC7")
TIMED = Branch(Contact("T11"), (_out(5),))

FOUND: dict[str, Program] = {
    "an edge on an input behind an end": _program(Rung(X1, (Branch(X2, (END,)), _ctu(13, RISE)))),
    "an edge on an input behind a return": _program(CALLS, other=(Rung(X1, (Branch(X2, (RETURN,)), _ctu(13, RISE))),)),
    "an edge behind a loop that returns": _program(
        CALLS, other=(Rung(RISE, (Loop(1, (Rung(X2, (RETURN,)),)), _out(1))),)
    ),
    "an edge behind a loop that ends": _program(Rung(X1, (Loop(1, (Rung(X2, (END,)),)), Branch(RISE, (_out(1),))))),
    "the bit of an rtof behind a loop with it": _program(Rung(X1, (Loop(1, (Rung(X2, (RTOF,)),)), TIMED))),
    "the bit of an rtof behind a call of it": _program(
        Rung(X1, (CALL, _ctu(13, X3), TIMED)), other=(Rung(X2, (RTOF,)),)
    ),
    "an input behind a pointer": _program(
        Rung(X1, (Act("copy(x[2], c[ds[1]])", "copy(X002,C[DS1])", 2), _ctu(13, Contact("C2"))))
    ),
    "an input behind its word": _program(
        Rung(X1, (Act("copy(dh[1], yd[0])", "copy(DH1,YD0)", 2), _ctu(13, Contact("Y001")))),
        Rung(X2, (Act('math_hex("dh[1] + dh[1]", dh[1])', "math(DH1 + DH1,DH1,mode=hex)"),)),
    ),
    "a one-shot formula with a pointer": _program(
        Rung(X2, (Act("copy(1, ds[1])", "copy(1,DS1)", 2),)),
        Rung(X1, (Act('calc("ds[ds[1]] + 1", ds[1], oneshot=True)', "math(DS[DS1] + 1,DS1,mode=decimal,oneshot=1)"),)),
    ),
    "an input behind the end of a number's text": _program(
        Rung(X1, (PADDED, _ctu(13, Compare('TXT3=="0"', 'txt[3] == "0"'))))
    ),
    "an input behind what a receive brings": _program(Rung(X1, (RECEIVE, _ctu(13, Contact("C2"))))),
    "a constant step behind an end": _program(
        Rung(X1, (Branch(X2, (END,)), _drum("X001", Pin("jump", RISE, "1"), Pin("jog", RISE))))
    ),
    "the input of a box behind a drum": _program(Rung(X1, (_drum("X002"), _ctu(13, Contact("C1"))))),
    "the inputs of a drum behind its step": _program(
        Rung(X1, (Act("copy(1, ds[1])", "copy(1,DS1)", 2), _drum("X002", Pin("jog", Compare("DS1==1", "ds[1] == 1")))))
    ),
    "the event of a drum is an rtof": _program(Rung(X1, (RTOF,)), Rung(X2, (_drum("T11"),))),
    "the bit of a counter behind a copy to its value": _program(
        Rung(Contact("CT13"), (_write("ctd[13]"), _ctu(14, Contact("CT13"))))
    ),
    "the bit of a timer behind a copy to its value": _program(
        Rung(Contact("T11", "nc"), (_write("td[11]", 2), _ctu(13, Contact("T11", "nc"))))
    ),
    "the bit of a counter behind a pointer to its value": _program(
        Rung(X1, (Act("copy(1, ds[1])", "copy(1,DS1)", 2),)),
        Rung(Contact("CT1"), (Act("copy(0, ctd[ds[1]])", "copy(0,CTD[DS1])", 2), _ctu(14, Contact("CT1")))),
    ),
    "the bit of a counter behind a call that writes its value": _program(
        Rung(Contact("CT13"), (CALL, _ctu(14, Contact("CT13")))), other=(Rung(X2, (_write("ctd[13]"),)),)
    ),
    "a clock of two instructions": _program(Rung(CLOCK, (_out(1), _ctu(13, X3)))),
    "the edge of a clock": _program(Rung(Contact("SC7", "re"), (_out(1), _ctu(13, X3)))),
    "a clock on the inputs of two boxes": _program(Rung(X1, (_ctu(13, CLOCK), _ctu(14, Contact("SC7", "nc"))))),
    "the time of day": _program(Rung(Compare("SD26>1", "sd[26] > 1"), (_out(1), _ctu(13, X3)))),
    "what a message brings in its own time": _program(
        Rung(X1, (RECEIVE,)), Rung(Contact("C2"), (_out(4), _out(5), _ctu(13, X3), _out(6)))
    ),
    "how a message in a subroutine fares": _program(
        CALLS,
        Rung(X2, (_out(4), _out(5), _ctu(13, Contact("C3")), _out(6))),
        other=(
            Rung(
                X1,
                (
                    Act(
                        'send(ModbusTcpTarget(ip="10.0.0.2"), "C1", c[1], success=c[3])',
                        'send(target=ModbusTcpTarget(name="tcp",ip="10.0.0.2",port=502,device_id=1),'
                        'remote_start="C1",source=C1,success=C3)',
                        3,
                    ),
                ),
            ),
        ),
    ),
    "outputs below a return": _program(
        CALLS, other=(Rung(X1, (_out(1), Branch(X2, (RETURN,)), _out(2), Branch(Contact("C1"), (_out(3),)))),)
    ),
    "True in True": _program(Rung(ALWAYS, (Branch(ALWAYS, (_out(1), _ctu(13, X3))),))),
}
"""Programs that went wrong once, or that random ones seldom come near."""


@pytest.mark.property
@pytest.mark.parametrize("name", FOUND)
def test_what_was_found(name: str) -> None:
    seeds = len(budget.rounds(8))
    check_meaning(FOUND[name], seeds=seeds)
    check_meaning(FOUND[name], inputs_move=True, seeds=seeds)
