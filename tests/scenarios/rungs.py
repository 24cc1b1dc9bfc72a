"""Contacts, coils, and what a rung looks at before its first action.

click-facts [scan.conditions, scan.edges, scan.io]
"""

from __future__ import annotations

from .scenario import Scenario, scans, scenario

RUNGS: tuple[Scenario, ...] = (
    scenario(
        "out follows, set and reset hold",
        """
        if c[1]:
            out(y[1])
            out(c[11:14])

        if c[2]:
            set(y[2])
            set(c[21:24])

        if c[3]:
            reset(y[2])
            reset(c[22:24])

        if c[4]:
            out(c[30])

        if c[5]:
            out(c[30])
        """,
        scans(1, C1=1, C2=1).give(Y001=1, C11=[1, 1, 1, 0], Y002=1, C21=[1, 1, 1, 0]),
        scans(1, C1=0, C2=0).give(Y001=0, C11=[0, 0, 0], Y002=1, C21=[1, 1, 1]),
        scans(1, C3=1, C24=1).give(Y002=0, C21=[1, 0, 0, 1]),
        scans(1, C3=0).give(Y002=0, C21=[1, 0, 0, 1]),
        scans(1, C2=1, C3=1).give(Y002=0, C21=[1, 0, 0, 1]),
        # The last of two coils decides.
        scans(1, C4=1).give(C30=0),
        scans(1, C5=1).give(C30=1),
    ),
    scenario(
        "out once is on for one scan",
        """
        if c[1]:
            out(c[10], oneshot=True)
            out(c[11:14], oneshot=True)
        """,
        scans(1).give(C10=0, C11=[0, 0, 0]),
        scans(1, C1=1).give(C10=1, C11=[1, 1, 1, 0]),
        scans(1).give(C10=0, C11=[0, 0, 0]),
        scans(2).give(C10=0, C11=[0, 0, 0]),
        scans(1, C1=0).give(C10=0),
        scans(1, C1=1).give(C10=1, C11=[1, 1, 1]),
    ),
    scenario(
        "edges last one scan",
        """
        if re(x[1]):
            calc("ds[1] + 1", ds[1])

        if fe(x[1]):
            calc("ds[2] + 1", ds[2])

        if any(re(x[1]), fe(x[2])):
            calc("ds[3] + 1", ds[3])

        if all(re(x[1]), nc(x[2])):
            calc("ds[4] + 1", ds[4])
        """,
        scans(2, DS1=[10, 20, 30, 40]).give(DS1=[10, 20, 30, 40]),
        scans(4, X001=1).give(DS1=[11, 20, 31, 41]),
        scans(4, X001=0).give(DS1=[11, 21, 31, 41]),
        scans(4, X001=1, X002=1).give(DS1=[12, 21, 32, 41]),
        scans(4, X001=0, X002=0).give(DS1=[12, 22, 33, 41]),
    ),
    scenario(
        "an edge on a bit that the program drives",
        """
        if c[1]:
            out(c[2])

        if re(c[2]):
            calc("ds[1] + 1", ds[1])

        if fe(c[2]):
            calc("ds[2] + 1", ds[2])
        """,
        scans(3, C1=1).give(DS1=[1, 0]),
        scans(3, C1=0).give(DS1=[1, 1]),
        scans(1, C1=1).give(DS1=[2, 1]),
    ),
    scenario(
        "comparisons",
        """
        if ds[1] == 5:
            out(c[11])

        if ds[1] != 5:
            out(c[12])

        if ds[1] < ds[2]:
            out(c[13])

        if ds[1] <= ds[2]:
            out(c[14])

        if ds[1] > dd[1]:
            out(c[15])

        if ds[1] >= df[1]:
            out(c[16])

        if 5 >= ds[1]:
            out(c[17])

        if dh[1] == 0x00FF:
            out(c[18])

        if dh[1] > "00FEh":
            out(c[19])
        """,
        scans(1, DS1=5, DS2=5, DD1=5, DF1=5.5, DH1=0x00FF).give(C11=[1, 0, 0, 1, 0, 0, 1, 1, 1]),
        scans(1, DS1=6, DF1=6.0, DH1=0x8000).give(C11=[0, 1, 0, 0, 1, 1, 0, 0, 1]),
        scans(1, DS1=-6, DH1=0x00FE).give(C11=[0, 1, 1, 1, 0, 0, 1, 0, 0]),
        scans(1, DS1=5, DF1=5.5).give(C11=[1, 0, 0, 1, 0, 0, 1, 0, 0]),
    ),
    scenario(
        "a register and a range as a condition",
        """
        if ds[1]:
            out(c[1])

        if df[1]:
            out(c[2])

        if c[11:14]:
            out(c[3])

        if nc(c[11:14]):
            out(c[4])

        if all(any(c[5], ds[1]), nc(c[6])):
            out(c[7])
        """,
        scans(1).give(C1=[0, 0, 0, 1], C7=0),
        scans(1, DS1=-1, DF1=0.25, C11=1).give(C1=[1, 1, 0, 0], C7=1),
        scans(1, DS1=0, DF1=0.0, C12=1, C13=1, C5=1).give(C1=[0, 0, 1, 0], C7=1),
        scans(1, C6=1, C14=1).give(C1=[0, 0, 1, 0], C7=0),
        scans(1, C11=0).give(C1=[0, 0, 0, 0]),
        scans(1, C11=1, C12=0).give(C1=[0, 0, 0, 0]),
        scans(1, C12=1, C13=0).give(C1=[0, 0, 0, 0]),
    ),
    scenario(
        "current values and words in conditions",
        """
        if True:
            ton(t[1], 100)

        if all(td[1] >= 20, td[1] != 30):
            out(c[11])

        if re(c[1]):
            ctu(ct[1], 100, reset=lambda: c[2])

        if ctd[1]:
            out(c[12])

        if ctd[1] > td[1]:
            out(c[13])

        if any(dh[1], ct[2]):
            out(c[14])
        """,
        scans(1).give(C11=[0, 0, 0, 0]),
        scans(1, C1=1, DH1=0x8000).give(C11=[1, 1, 0, 1]),
        scans(1, CTD1=31, DH1=0).give(C11=[0, 1, 1, 0]),
        scans(1, C2=1, CT2=1).give(C11=[1, 0, 0, 1]),
    ),
    scenario(
        "series and parallel, nested",
        """
        if any(all(c[1], c[2]), all(c[3], any(c[4], nc(c[5])))):
            out(c[10])

        if all(any(c[1], c[3]), any(c[2], c[4]), any(nc(c[5]), ds[1] > 3)):
            out(c[11])
        """,
        scans(1).give(C10=[0, 0]),
        scans(1, C3=1).give(C10=[1, 0]),
        scans(1, C5=1).give(C10=[0, 0]),
        scans(1, C4=1).give(C10=[1, 0]),
        scans(1, DS1=3).give(C10=[1, 0]),
        scans(1, DS1=4).give(C10=[1, 1]),
        scans(1, C1=1, C3=0).give(C10=[0, 1]),
        scans(1, C2=1, C5=0, DS1=0).give(C10=[1, 1]),
        scans(1, C1=0).give(C10=[0, 0]),
    ),
    scenario(
        "immediate contacts and coils",
        """
        if all(x[1].immediate, nc(x[2].immediate)):
            out(y[1].immediate)
            set(y[3:5].immediate)
        """,
        scans(1, X001=1).give(Y001=1, Y003=[1, 1, 0]),
        scans(1, X002=1).give(Y001=0, Y003=[1, 1]),
    ),
    scenario(
        "a branch sees the memory from before the rung",
        """
        if c[1]:
            calc("ds[1] + 1", ds[1])
            if ds[1] == 5:
                set(c[11])
            reset(c[2])
            if c[2]:
                copy(7, ds[2])
                if nc(c[3]):
                    set(c[12])
                set(c[3])
                if c[3]:
                    set(c[13])
            set(c[4])

        if ds[1] == 5:
            set(c[14])
        """,
        # C11 waits for the scan that finds a 5; the next rung sees it at once.
        scans(1, C1=1, DS1=4, C2=1).give(DS1=5, C11=0, C2=0, DS2=7, C12=1, C3=1, C13=0, C4=1, C14=1),
        scans(1, DS2=0).give(DS1=6, C11=1, C2=0, DS2=0, C13=0),
        scans(1, C2=1).give(DS1=7, C2=0, DS2=7, C13=1),
        scans(1, C1=0, C2=1).give(DS1=7, C2=1),
    ),
    scenario(
        "independent wires in one rung",
        """
        if True:
            if c[1]:
                out(c[11])
                copy(1, ds[1])
            if c[11]:
                out(c[12])
            if nc(c[1]):
                copy(2, ds[1])
        """,
        scans(1, C1=1).give(C11=[1, 0], DS1=1),
        scans(1).give(C11=[1, 1], DS1=1),
        scans(1, C1=0).give(C11=[0, 1], DS1=2),
        scans(1).give(C11=[0, 0]),
    ),
    scenario(
        "actions run in the order of the source",
        """
        if c[1]:
            copy(1, ds[1])
            copy(ds[1], ds[2])
            if c[2]:
                copy(2, ds[1])
            copy(ds[1], ds[3])
            copy(3, ds[1])
            copy(ds[1], ds[4])
        """,
        scans(1, C1=1).give(DS1=[3, 1, 1, 3]),
        scans(1, C2=1).give(DS1=[3, 1, 2, 3]),
    ),
    scenario(
        "a rung that does nothing",
        """
        # Only a comment.
        if True:
            pass

        if c[1]:
            pass

        if c[1]:
            out(c[2])
        """,
        scans(1, C1=1).give(C2=1),
    ),
)
