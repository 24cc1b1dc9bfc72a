"""Loops, subroutines, the end of the scan, and what outlasts a power failure.

click-facts [control.call, control.for, control.for-off, scan.power-up, scan.skipped]
"""

from __future__ import annotations

from .scenario import Scenario, power_up, scans, scenario

BODY_WITHOUT_CONDITIONS = "it drops the conditions of the rungs in a loop"
BODY_SWITCHED_OFF = "it runs the body without power, where CLICK is taken to go past it (click-facts [control.for-off])"
TIMERS_KEPT = "its timers are retentive; TD and T are not (click-facts [bank.defaults])"
COLUMN_IGNORED = "it does not read the column Retentive of single addresses"

CONTROL: tuple[Scenario, ...] = (
    scenario(
        "a loop runs its rungs several times in a scan",
        """
        if c[1]:
            for _ in range(3):
                if True:
                    calc("ds[1] + 1", ds[1])
                    copy(ds[1], dd[ds[1]])

        if True:
            copy(ds[1], ds[2])
        """,
        scans(1).give(DS1=0, DS2=0),
        scans(1, C1=1).give(DS1=3, DS2=3, DD1=[1, 2, 3, 0]),
        scans(2).give(DS1=9, DS2=9, DD8=[8, 9, 0]),
        scans(1, C1=0).give(DS1=9),
    ),
    scenario(
        "a loop that next_loop closes, as often as a register says",
        """
        if c[1]:
            for _ in range(ds[1]):
                pass

        if True:
            calc("ds[2] + ds[3]", ds[2])

        if True:
            calc("ds[3] + 1", ds[3])

        if True:
            next_loop()

        if True:
            calc("ds[4] + 1", ds[4])
        """,
        scans(1, C1=1, DS1=4, DS3=1).give(DS2=10, DS3=5, DS4=1),
        scans(1, DS1=2).give(DS2=21, DS3=7, DS4=2),
        scans(1, C1=0).give(DS2=21, DS3=7, DS4=3),
    ),
    scenario(
        "a loop once",
        """
        if c[1]:
            for _ in range(5, oneshot=True):
                if True:
                    calc("ds[1] + 1", ds[1])
        """,
        scans(3, C1=1).give(DS1=5),
        scans(1, C1=0).give(DS1=5),
        scans(2, C1=1).give(DS1=10),
    ),
    scenario(
        "conditions inside a loop",
        """
        if c[1]:
            for _ in range(4):
                if True:
                    calc("ds[1] + 1", ds[1])

                if ds[1] > 2:
                    calc("ds[2] + 1", ds[2])
        """,
        scans(1, C1=1).give(DS1=4, DS2=2).but_pyrung(BODY_WITHOUT_CONDITIONS, DS2=4),
    ),
    scenario(
        "a loop that is off leaves its coils alone",
        """
        if c[1]:
            for _ in range(2):
                if True:
                    out(c[2])
        """,
        scans(1, C1=1).give(C2=1),
        scans(1, C1=0).give(C2=1).but_pyrung(BODY_SWITCHED_OFF, C2=0),
    ),
    scenario(
        "a subroutine runs where it is called, and returns early",
        """
        @sub
        def add():
            if True:
                calc("ds[1] + 1", ds[1])

            if c[2]:
                return

            if True:
                calc("ds[2] + ds[1]", ds[2])
                out(c[3])

            if True:
                return

        def main():
            if True:
                copy(10, ds[1])

            if c[1]:
                call(add)
                copy(ds[1], ds[3])
                call("add")
        """,
        scans(1).give(DS1=10, DS2=0, C3=0),
        scans(1, C1=1).give(DS1=12, DS2=23, DS3=11, C3=1),
        scans(1, C2=1).give(DS1=12, DS2=23, DS3=11, C3=1),
        scans(1, C1=0, C2=0).give(DS1=10, DS2=23, C3=1),
    ),
    scenario(
        "a return in a branch",
        """
        @sub
        def count():
            if c[2]:
                calc("ds[1] + 1", ds[1])
                if c[3]:
                    return
                calc("ds[2] + 1", ds[2])

            if True:
                calc("ds[3] + 1", ds[3])

            if True:
                return

        def main():
            if c[1]:
                call(count)
        """,
        scans(1, C1=1).give(DS1=[0, 0, 1]),
        scans(1, C2=1).give(DS1=[1, 1, 2]),
        scans(1, C3=1).give(DS1=[2, 1, 2]),
        scans(1, C2=0).give(DS1=[2, 1, 3]),
    ),
    scenario(
        "an end under a condition, and one behind other actions",
        """
        @sub
        def count():
            if True:
                calc("ds[4] + 1", ds[4])
                return

        def main():
            if True:
                calc("ds[1] + 1", ds[1])

            if c[1]:
                out(c[11])
                end()

            if c[2]:
                call(count)
                calc("ds[2] + 1", ds[2])
                end()
                calc("ds[3] + 1", ds[3])

            if True:
                calc("ds[5] + 1", ds[5])
        """,
        scans(1, DS1=[10, 20, 30, 40, 50]).give(DS1=[11, 20, 30, 40, 51], C11=0),
        scans(1, C2=1).give(DS1=[12, 21, 30, 41, 51]),
        scans(3, C1=1).give(DS1=[15, 21, 30, 41, 51], C11=1),
        scans(1, C1=0, C2=0).give(DS1=[16, 21, 30, 41, 52], C11=0),
        pyrung_cannot="Unrecognised AF instruction: 'end'",
        ends_return=True,
    ),
    scenario(
        "the first scan",
        """
        if sc[2]:
            calc("ds[1] + 1", ds[1])

        if nc(sc._1st_SCAN):
            calc("ds[2] + 1", ds[2])

        if sc._Always_ON:
            calc("ds[3] + 1", ds[3])
        """,
        scans(1).give(DS1=[1, 0, 1]),
        scans(3).give(DS1=[1, 3, 4]),
    ),
    scenario(
        "retentive memory outlasts a power failure",
        """
        if c[1]:
            set(c[11])
            set(y[1])
            ton(t[1], 30)
            copy(5, ds[1])
            copy(5, dd[1])
            copy(5, dh[1])
            copy(2.5, df[1])
            copy("A", txt[1])

        if re(c[1]):
            ctu(ct[1], 1, reset=lambda: c[2])
        """,
        scans(2, C1=1).give(C11=1, Y001=1, TD1=20, CTD1=1, CT1=1, DS1=5, TXT1="A"),
        scans(1, C1=0).give(C11=1, Y001=1, TD1=0, CT1=1),
        power_up(1).give(C1=0, C11=0, Y001=0, CTD1=1, CT1=1, DS1=5, DD1=5, DH1=5, DF1=2.5, TXT1="A"),
        scans(2, C1=1).give(TD1=20, T1=0, CTD1=2),
        power_up(1, C1=1).give(TD1=10, T1=0).but_pyrung(TIMERS_KEPT, TD1=30, T1=1),
    ),
    scenario(
        "initial values are taken at power up",
        """
        nickname(ds.Fresh, ds[1], initial=5, retentive=False)
        nickname(c.Begin, c[11], initial=1)
        nickname(c.Kept, c[12], retentive=True)
        nickname(ds.Held, ds[2])
        nickname(dh.Mask, dh[1], initial=0x00FF, retentive=False)
        nickname(df.Ratio, df[1], initial=2.5, retentive=False)
        nickname(txt.Letter, txt[1], initial="A", retentive=False)

        def main():
            if c[1]:
                calc("ds.Fresh + 1", ds.Fresh)
                calc("ds.Held + 1", ds.Held)
                reset(c.Begin)
                set(c.Kept)

            if True:
                copy(dh.Mask, dh[2])
                copy(df.Ratio, df[2])
                copy(txt.Letter, txt[2])
        """,
        scans(1).give(DS1=5, DS2=0, C11=1, C12=0, DH2=0x00FF, DF2=2.5, TXT2="A"),
        scans(2, C1=1).give(DS1=7, DS2=2, C11=0, C12=1),
        power_up(1).give(DS1=5, DS2=2, C11=1, C12=1, DH1=0x00FF).but_pyrung(COLUMN_IGNORED, DS1=7, C12=0),
    ),
)
