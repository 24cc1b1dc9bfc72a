"""Programs for type checkers: legal code in rare forms, and mistakes, each on a line of its own."""

from __future__ import annotations

MORE = """\
nickname(ds.Recipe, ds[100:110], initial=5, comment="a block")
nickname(c.Valves, c[10:13])
nickname(ds["Other block"], ds[200:210])
nickname(t.Stations, t[5:7])


@sub
def wash():
    if c.Valves:
        return

    if True:
        return


@sub("Wash cycle")
def wash_cycle():
    if True:
        return


def main():
    if all("0A00h" == dh.Code, 5 < ds.Recipe[2], 5 == ds.Level, c.Valves[1:], nc(c.Valves), td.Stations[1] > 5):
        copy(ds.Recipe[3], ds.Level)
        copy(ds["Other block"][3], ds.Level)
        copy_fill(7, ds.Recipe)
        copy_block(source_range=ds.Recipe[5:], destination_start=ds[1], one_shot=True)
        copy_block(ds.Recipe[:2], destination_start=ds[1])
        copy_pack(source_range=c[1:17], destination=dh.Word)
        copy(txt[1], ds.Level, options="to_value")
        copy(ds[1], txt[1], options=to_text)
        calc(formula="ds.Level + 1", result_destination=ds.Level)
        search("==", search_value=5, start_address=ds[1], end_address=ds[9], result_address=ds[20], result_flag=c.Found)
        search("eq", 5, ds[1], ds[9], result=ds[20], found=c.Found)
        search(ds.Recipe >= 5, result_address=ds[20], result_flag=c.Found)
        search(100 == ds.Recipe[2:], ds[20], c.Found)
    if c.Go:
        ctd(ct.Left, 5).reset(c.Refilled)
        out(y.Lamp.immediate)
        out(y.Horn, one_shot=True)
    if td.Stations[0] >= ds.Level:
        call(subroutine_name=wash)
        call("wash")
        call(wash_cycle)
        call("Wash cycle")
        for _ in range(10, one_shot=True):
            pass
    if True:
        next_loop()
    if xd["0u"] == 0x0F:
        end()
    if True:
        end()
"""
"""Forms that no case has."""


# -- mistakes ----------------------------------------------------------------------------------------------------------

KNOWN = """\
nickname(x.Start, x[1])
nickname(y.Motor, y[1])
nickname(c.Run, c[1])
nickname(t.Delay, t[1])
nickname(ct.Parts, ct[1])
nickname(ds.Speed, ds[1])
nickname(ds.Recipe, ds[100:110])
nickname(dh.Mask, dh[1])
nickname(df.Gain, df[1])
nickname(txt.Letter, txt[1])


@sub
def wash():
    if True:
        return


def plain():
    if True:
        return


"""

MISTAKEN_ACTIONS = (
    # names
    "out(y.Moter)",
    "out(Y.Motor)",
    "outt(y.Motor)",
    "call(wahs)",
    "call(plain)",
    "ds.Speed = ds.Speed",
    "ds[1] = 5",
    "Speed = ds.Sped",
    # banks
    "out(ds[1])",
    "set(ds[1])",
    "set(x.Start)",
    "reset(t.Delay)",
    "out(c.Run.immediate)",
    "ton(ct.Parts, 5)",
    "ton(ds.Speed, 5)",
    "ctu(t.Delay, 5, reset=lambda: c.Run)",
    "ctd(ct.Parts, df.Gain, reset=lambda: c.Run)",
    "copy(1, x[1])",
    "copy(c.Run, ds.Speed)",
    "copy(ds.Speed, c.Run)",
    "copy(ds.Speed, t.Delay)",
    "copy_pack(t[1:5], dd[1])",
    "copy_unpack(ds.Speed, ds[1:3])",
    "calc('1 + 1', c.Run)",
    "math_hex('1', ds.Speed)",
    "shift(y[1:9]).reset(c.Run)",
    "send(ModbusTcpTarget(ip='10.0.0.1'), 'DS1', ds[1:5], success=y.Motor)",
    # forms of addresses
    "ton(t[1:3], 5)",
    "ton(t.Delay, ds[1:3])",
    "ton(t.Delay, ds.Recipe)",
    "copy(ds[1:3], ds[5])",
    "copy_block(ds.Speed, ds[5])",
    "copy_fill(0, ds.Speed)",
    "copy(ds[dd[1]], ds.Speed)",
    "copy(x[ds.Speed], c.Run)",
    "copy_fill(0, ds[ds.Speed:10])",
    "copy(ds.Speed[3], ds[5])",
    "copy(1, ds[1.5])",
    # arguments
    "ton(t.Delay)",
    "ton(t.Delay, 5, units=Ts)",
    "ton(t.Delay, 5, Ts, 6)",
    "ton(t.Delay, 2.5)",
    "ton(t.Delay, '5')",
    "ton(t.Delay, 5, unit='Ts')",
    "ton(t.Delay, 5, unit=Tsec)",
    "out(y.Motor, oneshot=1)",
    "set(c.Run, oneshot=True)",
    "copy(1, ds.Speed, option=to_value)",
    "copy(txt.Letter, ds.Speed, options=to_number)",
    "copy_fill(1, ds[1:3], options=to_value)",
    "copy(ds.Speed, txt.Letter, options=to_text(pad=5))",
    "calc(ds.Speed + 1, ds.Speed)",
    "calc(5, ds.Speed)",
    "search('=', 5, ds[1], ds[9], ds[20], c.Run)",
    "search(ds.Speed >= 5, result=ds[20], found=c.Run)",
    "search(ds[1:9] >= 5, result=ds[20])",
    "end(1)",
    "call()",
    # inputs
    "rton(t.Delay, 5, reset=c.Run)",
    "rton(t.Delay, 5, reset=lambda: ds[1:3])",
    "rton(t.Delay, 5).rest(c.Run)",
    "rton(t.Delay, 5).reset(lambda: c.Run)",
    "rton(t.Delay, 5).reset()",
    "ton(t.Delay, 5).reset(c.Run)",
    "ctu(ct.Parts, 5).down(c.Run)",
    "ctd(ct.Parts, 5).down(c.Run)",
    # lists and targets
    "time_drum([y[1]], [1], Ts, [[2]], ds[1], td[1], c[1]).reset(c.Run)",
    "time_drum([ds[1]], [1], Ts, [[1]], ds[1], td[1], c[1]).reset(c.Run)",
    "event_drum([y[1]], [nc(x[1])], [[1]], ds[1], c[1]).reset(c.Run)",
    "event_drum([y[1]], [x[1]], [[1]], ds[1], c[1]).reset(c.Run).jump(c[2])",
    "event_drum([y[1]], [x[1]], [[1]], ds[1]).reset(c.Run)",
    "receive(ModbusRtuTarget(com_port='cpu3', device_id=5), 'DS1', ds[1:5])",
    "receive(ModbusTcpTarget('10.0.0.1'), 'DS1', ds[1:5])",
    "receive('10.0.0.1', 'DS1', ds[1:5])",
    "receive(ModbusTcpTarget(ip='10.0.0.1'), ModbusAddress(address='1h', register_type='coils'), c[1:5])",
)
MISTAKEN_CONDITIONS = (
    "c.Runn",
    "C1",
    "ds[1:3]",
    "txt.Letter",
    "ds[ds.Speed]",
    "y.Motor.immediate",
    "nc(ds.Speed)",
    "nc(all(c.Run, x.Start))",
    "re(c[1:3])",
    "re(x.Start.immediate)",
    "fe(ds.Speed > 5)",
    "c.Run & x.Start",
    "~c.Run",
    "all()",
    "all(c.Run, ds[1:3])",
    "any([c.Run, x.Start])",
    "ds.Speed == 'A'",
    "ds.Speed < 'A'",
    "dh.Mask == ds.Speed",
    "txt.Letter == 5",
    "c.Run == 1",
    "ds.Speed > c.Run",
    "ds.Speed + 1 > 5",
    "ds[1:3] == 5",
)
MISTAKEN_TOP = (
    "nickname(ds.Speed, x[1])",
    "nickname(ds.Speed)",
    "nickname(ds.Speed, ds[1], note='x')",
    "nickname(ds.Speed, ds[1], retentive='yes')",
    "nickname('Speed', ds[1])",
    "sub()",
    "sub(5)",
    "sub(name='Wash cycle')",
    "sub('Wash', 'cycle')",
)
MISTAKEN_LOOPS = ("range(ds.Speed, 5)", "range(c.Run)", "range(5, once=True)")
