"""Timers: they count the time of each scan, the first one included.

click-facts [timer.off-delay, timer.on-delay, timer.retentive]
"""

from __future__ import annotations

from .scenario import Scenario, scans, scenario

MINUTES = 60_000

TIMERS: tuple[Scenario, ...] = (
    scenario(
        "ton counts while on and is cleared when off",
        """
        if c[1]:
            ton(t[1], 30)
        """,
        scans(3).give(TD1=0, T1=0),
        scans(1, C1=1).give(TD1=10, T1=0),
        scans(1).give(TD1=20, T1=0),
        scans(1).give(TD1=30, T1=1),
        scans(2).give(TD1=50, T1=1),
        scans(1, C1=0).give(TD1=0, T1=0),
        scans(2, C1=1).give(TD1=20, T1=0),
        scans(1, C1=0).give(TD1=0, T1=0),
    ),
    scenario(
        "ton stops counting at 32767",
        """
        if c[1]:
            ton(t[1], 32767)
        """,
        scans(3, C1=1).give(TD1=30_000, T1=0),
        scans(1).give(TD1=32767, T1=1),
        scans(5).give(TD1=32767, T1=1),
        scans(1, C1=0).give(TD1=0, T1=0),
        ms=10_000,
    ),
    scenario(
        "tof stays on for its time",
        """
        if c[1]:
            tof(t[1], 30)
        """,
        scans(5).give(TD1=0, T1=0),
        scans(1, C1=1).give(TD1=0, T1=1),
        scans(4).give(TD1=0, T1=1),
        scans(1, C1=0).give(TD1=10, T1=1),
        scans(1).give(TD1=20, T1=1),
        scans(1).give(TD1=30, T1=0),
        scans(1, C1=1).give(TD1=0, T1=1),
        scans(2, C1=0).give(TD1=20, T1=1),
        scans(1, C1=1).give(TD1=0, T1=1),
    ),
    scenario(
        "rton holds its time until it is reset",
        """
        if c[1]:
            rton(t[1], 30, reset=lambda: c[2])
        """,
        scans(2, C1=1).give(TD1=20, T1=0),
        scans(3, C1=0).give(TD1=20, T1=0),
        scans(1, C1=1).give(TD1=30, T1=1),
        scans(3, C1=0).give(TD1=30, T1=1),
        scans(1, C2=1).give(TD1=0, T1=0),
        scans(3, C1=1).give(TD1=0, T1=0),
        scans(1, C2=0).give(TD1=10, T1=0),
        scans(4).give(TD1=50, T1=1),
        scans(1, C2=1).give(TD1=0, T1=0),
    ),
    # CLICK has none; t[1] means the bit that clickgen makes for it. C5 shows it.
    scenario(
        "rtof adds up the time that it is off",
        """
        if c[1]:
            rtof(t[1], 30, reset=lambda: c[2])

        if t[1]:
            out(c[5])
        """,
        scans(2).give(C5=0),
        # On, at first under a reset.
        scans(1, C1=1, C2=1).give(C5=1, TD1=0),
        scans(2, C2=0).give(C5=1, TD1=0),
        # Off: it counts, and what it has counted outlasts another on.
        scans(1, C1=0).give(C5=1, TD1=10),
        scans(1).give(C5=1, TD1=20),
        scans(3, C1=1).give(C5=1, TD1=20),
        scans(1, C1=0).give(C5=0, TD1=30),
        scans(2).give(C5=0, TD1=50),
        # Off and reset: the time is gone, and the bit does not come back.
        scans(1, C2=1).give(C5=0, TD1=0),
        scans(1, C2=0).give(C5=0, TD1=10),
        # On with its time already over.
        scans(3).give(C5=0, TD1=40),
        scans(2, C1=1).give(C5=1, TD1=40),
        scans(1, C1=0).give(C5=0, TD1=50),
        # Off under a reset that is held: it does not count.
        scans(1, C1=1, C2=1).give(C5=1, TD1=0),
        scans(5, C1=0).give(C5=1, TD1=0),
        scans(2, C2=0).give(C5=1, TD1=20),
        scans(1).give(C5=0, TD1=30),
    ),
    scenario(
        "rtof answers to an edge of its bit",
        """
        if c[1]:
            rtof(t.Idle, 20, reset=lambda: c[2])

        if re(t.Idle):
            calc("ds[1] + 1", ds[1])

        if fe(t.Idle):
            calc("ds[2] + 1", ds[2])

        if nc(t.Idle):
            out(c[5])
        """,
        scans(3, C2=1, DS1=10, DS2=20).give(DS1=10, DS2=20, C5=1),
        scans(2, C1=1, C2=0).give(DS1=11, DS2=20, C5=0),
        scans(1, C1=0).give(DS1=11, DS2=20, C5=0),
        scans(1).give(DS1=11, DS2=21, C5=1),
        scans(3).give(DS1=11, DS2=21, C5=1),
    ),
    scenario(
        "milliseconds and seconds",
        """
        if c[1]:
            ton(t[1], 1000)
            ton(t[2], 1000, Tms)
            ton(t[3], 2, Ts)
            tof(t[4], 2, unit=Ts)
        """,
        scans(3, C1=1).give(TD1=750, T1=0, TD2=750, T2=0, TD3=0, T3=0, TD4=0, T4=1),
        scans(1).give(TD1=1000, T1=1, TD2=1000, T2=1, TD3=1, T3=0),
        scans(4).give(TD3=2, T3=1),
        scans(7, C1=0).give(TD1=0, TD3=0, TD4=1, T4=1),
        scans(1).give(TD4=2, T4=0),
        ms=250,
    ),
    scenario(
        "minutes, hours and days",
        """
        if c[1]:
            ton(t[1], 60, unit=Tm)
            ton(t[2], 2, unit=Th)
            ton(t[3], 1, unit=Td)
            rton(t[4], 90, unit=Tm, reset=lambda: c[2])
        """,
        scans(1, C1=1).give(TD1=30, T1=0, TD2=0, TD3=0, TD4=30),
        scans(1).give(TD1=60, T1=1, TD2=1, T2=0, TD3=0, TD4=60, T4=0),
        scans(2).give(TD1=120, TD2=2, T2=1, TD3=0, TD4=120, T4=1),
        scans(43).give(TD2=23, TD3=0, T3=0),
        scans(1).give(TD2=24, TD3=1, T3=1),
        scans(1, C1=0).give(TD1=0, TD2=0, TD3=0, TD4=1440),
        ms=30 * MINUTES,
    ),
    scenario(
        "a preset in a register can change while the timer runs",
        """
        if c[1]:
            ton(t[1], ds[1])
            rton(t[2], setpoint=ds[2], unit=Tms, reset=lambda: c[2])
        """,
        scans(3, C1=1, DS1=100, DS2=40).give(TD1=30, T1=0, TD2=30, T2=0),
        scans(1, DS1=40).give(TD1=40, T1=1, TD2=40, T2=1),
        scans(1, DS1=60).give(TD1=50, T1=0, TD2=50, T2=1),
        scans(1).give(TD1=60, T1=1, TD2=60, T2=1),
        scans(1, C1=0).give(TD1=0, T1=0, TD2=60, T2=1),
    ),
)
