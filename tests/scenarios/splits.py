"""Rungs that CLICK cannot take in one piece: the pieces do what the rung says."""

from __future__ import annotations

from .scenario import Scenario, scans, scenario

SPLITS: tuple[Scenario, ...] = (
    scenario(
        "several boxes under one condition",
        """
        if c[1]:
            ton(t[1], 20)
            tof(t[2], 20)
            rton(t[3], 20, reset=lambda: c[2])
            rton(t[4], 30, reset=lambda: c[3])
            out(c[11])
            if t[3]:
                out(c[12])
        """,
        scans(1, C1=1).give(TD1=10, T1=0, TD2=0, T2=1, TD3=10, T3=0, TD4=10, C11=1, C12=0),
        scans(1).give(TD1=20, T1=1, TD3=20, T3=1, TD4=20, T4=0, C12=0),
        scans(1).give(TD4=30, T4=1, C12=1),
        scans(1, C1=0, C2=1).give(TD1=0, T1=0, TD2=10, T2=1, TD3=0, T3=0, TD4=30, T4=1, C11=0, C12=0),
        scans(1, C3=1).give(TD2=20, T2=0, TD4=0, T4=0),
        scans(1, C1=1).give(TD1=10, C11=1, C12=0),
    ),
    scenario(
        "a box behind the action that takes its condition away",
        """
        if all(c[1], nc(c[2])):
            set(c[2])
            rton(t[1], 20, reset=lambda: c[3])
            set(c[4])
        """,
        scans(1, C1=1).give(C2=1, TD1=10, T1=0, C4=1),
        scans(3).give(TD1=10),
        scans(1, C2=0, C4=0).give(C2=1, TD1=20, T1=1, C4=1),
        scans(2, C3=1).give(TD1=0, T1=0),
        scans(2, C1=0, C2=0, C4=0).give(C2=0, TD1=0, C4=0),
    ),
    scenario(
        "inputs of a box are looked at before the actions above it",
        """
        if c[1]:
            set(c[2])
            rton(t[1], 50, reset=lambda: c[2])
            reset(c[3])
            rton(t[2], 50, reset=lambda: c[3])
        """,
        # C2 comes on in this rung: the reset is there from the next scan on. C3 goes off: there for one more scan.
        scans(1, C1=1, C3=1, TD2=40).give(C2=1, TD1=10, C3=0, TD2=0),
        scans(1).give(TD1=0, TD2=10),
        scans(1, C1=0, C2=0, C3=1, TD1=40).give(C2=0, TD1=40, C3=1, TD2=0),
        scans(1, C1=1, C3=0).give(C2=1, TD1=50, T1=1, TD2=10),
        scans(1, C1=0).give(C2=1, TD1=0, T1=0, TD2=10),
    ),
    scenario(
        "two counters and a copy behind one edge",
        """
        if re(x[1]):
            ctu(ct[1], 5, reset=lambda: c[1])
            calc("ds[1] + 1", ds[1])
            ctu(ct[2], 5, reset=lambda: c[2])
            calc("ds[2] + 1", ds[2])
        """,
        scans(3, X001=1, DS2=20).give(CTD1=1, DS1=1, CTD2=1, DS2=21),
        scans(3, X001=0).give(CTD1=1, DS1=1, CTD2=1, DS2=21),
        scans(3, X001=1, C2=1).give(CTD1=2, DS1=2, CTD2=0, DS2=22),
    ),
    scenario(
        "a counter that resets itself",
        """
        if re(c[1]):
            ctu(ct[1], 2, reset=lambda: all(ct[1], c[2]))
            if ct[1]:
                calc("ds[1] + 1", ds[1])
        """,
        scans(2, C1=1, C2=1).give(CTD1=1, CT1=0),
        scans(1, C1=0).give(CTD1=1),
        scans(1, C1=1).give(CTD1=2, CT1=1, DS1=0),
        scans(1, C1=0).give(CTD1=0, CT1=0, DS1=0),
        scans(1, C1=1, C2=0).give(CTD1=1, CT1=0),
        scans(1, C1=0).give(CTD1=1),
        # The branch sees the counter's bit from before the rung.
        scans(2, C1=1).give(CTD1=2, CT1=1, DS1=0),
        scans(1, C1=0).give(CTD1=2, CT1=1),
        scans(2, C1=1).give(CTD1=3, CT1=1, DS1=1),
        scans(1, C1=0, C2=1).give(CTD1=0, CT1=0, DS1=1),
    ),
    scenario(
        "an or in front of a box and in its inputs",
        """
        if any(c[1], all(c[2], c[3])):
            rton(t[1], 30, reset=lambda: any(c[4], all(c[5], nc(c[6]))))

        if any(re(c[1]), re(c[2])):
            ctud(ct[1], 2, count_down=lambda: any(re(c[7]), re(c[8])), reset=lambda: any(c[4], c[9]))
        """,
        scans(1, C1=1).give(TD1=10, CTD1=1, CT1=0),
        scans(1, C1=0).give(TD1=10, CTD1=1),
        scans(1, C2=1).give(TD1=10, CTD1=2, CT1=1),
        scans(1, C3=1, C8=1).give(TD1=20, CTD1=1, CT1=0),
        scans(1, C5=1, C6=1).give(TD1=30, T1=1, CTD1=1),
        scans(1, C6=0).give(TD1=0, T1=0, CTD1=1),
        scans(1, C5=0, C4=1).give(TD1=0, T1=0, CTD1=0),
        scans(2, C4=0, C7=1).give(TD1=20, CTD1=-1),
        scans(1, C9=1).give(TD1=30, CTD1=0),
        scans(1, C2=0, C9=0).give(TD1=30, CTD1=0),
        scans(2, C1=1).give(TD1=50, CTD1=1),
    ),
    scenario(
        "an immediate contact as an input of a box",
        """
        if c[1]:
            rton(t[1], 30, reset=lambda: x[1].immediate)
        """,
        scans(2, C1=1).give(TD1=20),
        scans(1, X001=1).give(TD1=0),
        pyrung_cannot="Expected Condition or Tag",
    ),
    scenario(
        "an immediate contact that opens, as an input of a box",
        """
        if x[2].immediate:
            rton(t[1], 30, reset=lambda: nc(x[1].immediate))
        """,
        scans(2, X001=1, X002=1).give(TD1=20),
        scans(1, X001=0).give(TD1=0),
        scans(1, X001=1).give(TD1=10),
        scans(1, X002=0).give(TD1=10),
    ),
    scenario(
        "a chain on a box",
        """
        if re(c[1]):
            ctu(ct[1], 3).reset(c[2])
            ctud(ct[2], 3).down(re(c[3])).reset(c[2], nc(c[4]))

        if c[1]:
            rton(t[1], 30).reset(c[2])
            shift(c[11:14]).clock(c[5]).reset(c[2])
        """,
        scans(1, C1=1, C14=1).give(CTD1=1, CTD2=1, TD1=10, C11=[0, 0, 0]),
        scans(1).give(CTD1=1, CTD2=1, TD1=20, C11=[0, 0, 0, 1]),
        scans(1, C1=0, C3=1).give(CTD1=1, CTD2=0, TD1=20),
        scans(1, C1=1, C5=1).give(CTD1=2, CTD2=1, TD1=30, C11=[1, 0, 0]),
        scans(1, C2=1, C4=1).give(CTD1=0, CTD2=1, TD1=0, C11=[0, 0, 0, 1]),
        scans(1, C4=0).give(CTD2=0),
    ),
    scenario(
        "a branch around a box",
        """
        if c[1]:
            out(c[11])
            if c[2]:
                out(c[12])
                rton(t[1], 100, reset=lambda: c[3])
                reset(c[2])
            out(c[13])
            if c[2]:
                calc("ds[1] + 1", ds[1])
        """,
        scans(1, C1=1, DS1=10).give(C11=[1, 0, 1], TD1=0, DS1=10),
        scans(1, C2=1).give(C11=[1, 1, 1], TD1=10, C2=0, DS1=11),
        scans(1).give(C11=[1, 0, 1], TD1=10, DS1=11),
        scans(1, C1=0, C2=1).give(C11=[0, 0, 0], TD1=10, C2=1, DS1=11),
    ),
    scenario(
        "more conditions than a row has room for",
        f"""
        if all({", ".join(f"c[{number}]" for number in range(1, 41))}):
            out(c[100])
            reset(c[40])
            calc("ds[1] + 1", ds[1])
        """,
        scans(2, C1=[1] * 39).give(C100=0, DS1=0),
        scans(1, C40=1).give(C100=1, C40=0, DS1=1),
        scans(1).give(C100=0, DS1=1),
        *(scans(1, C1=[one != off for one in range(1, 41)]).give(C100=0, DS1=1) for off in range(1, 41)),
    ),
    scenario(
        "more actions than a rung has rows for",
        f"""
        if all(c[1], nc(c[2])):
            set(c[2])
            {"; ".join(f'calc("ds[{number}] + 1", ds[{number}])' for number in range(1, 41))}
            if c[3]:
                reset(c[1])
        """,
        scans(2, C1=1, DS1=range(10, 410, 10)).give(C2=1, DS1=range(11, 411, 10), C1=1),
        scans(1, C2=0, C3=1).give(C2=1, DS1=range(12, 412, 10), C1=0),
        scans(1, C2=0).give(C2=0, DS1=range(12, 412, 10)),
    ),
)
