"""Table search and shift registers.

click-facts [search.continuous, search.result, shift.work]
"""

from __future__ import annotations

from .scenario import Scenario, scans, scenario

SEARCH_AND_SHIFT: tuple[Scenario, ...] = (
    scenario(
        "search finds the first, and says -1 when there is none",
        """
        if c[1]:
            search(">=", ds[100], ds[1], ds[5], ds[101], c[11])
            search("==", 7, ds[1], ds[5], ds[102], c[12])
            search("!=", 0, dd[3], dd[6], dd[101], c[13])
            search("<", -1.5, df[1], df[3], ds[103], c[14])
            search("==", 0x00FF, dh[1], dh[3], ds[104], c[15])
        """,
        scans(1, DS1=[5, 20, 30, 20, 7], DS100=20, DS101=9, C11=1).give(DS101=9, C11=1),
        scans(1, C1=1, DS6=999, DD4=1, DF1=[-1.5, -1.0, -1.75], DH1=[1, 0xFF, 0xFF]).give(
            DS101=2, C11=1, DS102=5, C12=1, DD101=4, C13=1, DS103=3, C14=1, DS104=2, C15=1
        ),
        scans(1, DS100=31, DS5=6, DS6=7, DD7=1, DF4=-9.0, DH4=0xFF, DD4=0, DF3=-1.5, DH1=[0xFE, 0xFE, 0x1FF]).give(
            DS101=-1, C11=0, DS102=-1, C12=0, DD101=-1, C13=0, DS103=-1, C14=0, DS104=-1, C15=0
        ),
        scans(1, DS100=500, DS6=999).give(DS101=-1, C11=0),
        scans(1, DS100=5, DS1=7, DD3=1, DF1=-1.6, DH1=0xFF).give(DS101=1, DS102=1, DD101=3, DS103=1, DS104=1),
        scans(1, C1=0, DS100=31).give(DS101=1, C11=1),
    ),
    scenario(
        "search goes on behind its last hit",
        """
        if c[1]:
            search("==", 5, ds[11], ds[15], ds[1], c[2], continuous=True)
        """,
        scans(1, C1=1, DS11=[5, 0, 5, 5, 0, 5]).give(DS1=11, C2=1),
        scans(1).give(DS1=13, C2=1),
        scans(1).give(DS1=14, C2=1),
        scans(1).give(DS1=-1, C2=0),
        scans(2).give(DS1=-1, C2=0),
        scans(1, DS1=0).give(DS1=11, C2=1),
        scans(2, C1=0).give(DS1=11, C2=1),
        scans(1, C1=1).give(DS1=13, C2=1),
    ),
    scenario(
        "search once",
        """
        if c[1]:
            search("==", 5, ds[11], ds[15], ds[1], c[2], continuous=True, oneshot=True)
        """,
        scans(3, C1=1, DS11=[5, 0, 5, 5, 0]).give(DS1=11, C2=1),
        scans(1, C1=0).give(DS1=11),
        scans(3, C1=1).give(DS1=13),
    ),
    scenario(
        "search for a text",
        """
        if c[1]:
            search("==", "AB", txt[1], txt[6], ds[1], c[2])
            search("!=", "X", txt[1], txt[6], ds[2], c[3])
        """,
        scans(1, C1=1, TXT1="XAXABB", TXT7="A").give(DS1=4, C2=1, DS2=2, C3=1),
        scans(1, TXT1="XXXXXX").give(DS1=-1, C2=0, DS2=-1, C3=0),
        scans(1, TXT6="A", TXT7="B").give(DS1=-1, C2=0, DS2=6, C3=1),
        scans(1, TXT1="ABABAB").give(DS1=1, C2=1, DS2=1, C3=1),
    ),
    scenario(
        "search in the form of a comparison",
        """
        if c[1]:
            search(ds[11:16] >= 100, result=ds[1], found=c[2])
        """,
        scans(1, C1=1, DS11=[5, 99, 100, 101, 0]).give(DS1=13, C2=1),
        scans(1, DS11=[5, 99, 0, 0, 99], DS16=100).give(DS1=-1, C2=0),
        scans(1, DS15=200).give(DS1=15, C2=1),
        scans(1, DS11=100).give(DS1=11, C2=1),
        scans(1, C1=0, DS11=0).give(DS1=11, C2=1),
    ),
    scenario(
        "shift moves its bits up",
        """
        if c[1]:
            shift(c[11:15], clock=lambda: c[2], reset=lambda: c[3])
        """,
        scans(2, C1=1, C15=1).give(C11=[0, 0, 0, 0]),
        scans(1, C2=1).give(C11=[1, 0, 0, 0]),
        scans(3).give(C11=[1, 0, 0, 0]),
        scans(2, C2=0, C1=0).give(C11=[1, 0, 0, 0]),
        scans(1, C2=1).give(C11=[0, 1, 0, 0]),
        scans(1, C2=0, C1=1).give(C11=[0, 1, 0, 0]),
        scans(1, C2=1).give(C11=[1, 0, 1, 0]),
        scans(1, C2=0).give(C11=[1, 0, 1, 0]),
        scans(1, C2=1).give(C11=[1, 1, 0, 1, 1]),
        scans(1, C2=0).give(C11=[1, 1, 0, 1]),
        scans(1, C2=1).give(C11=[1, 1, 1, 0, 1]),
        scans(1, C3=1).give(C11=[0, 0, 0, 0, 1]),
        scans(1, C2=0).give(C11=[0, 0, 0, 0]),
        scans(1, C2=1).give(C11=[0, 0, 0, 0]),
        scans(1, C3=0).give(C11=[0, 0, 0, 0]),
    ),
    scenario(
        "shift moves its bits down",
        """
        if c[1]:
            shift(c[14:10:-1], clock=lambda: all(c[2], nc(c[4])), reset=lambda: c[3])
        """,
        scans(1, C1=1, C2=1, C10=1).give(C10=1, C11=[0, 0, 0, 1]),
        scans(1, C4=1, C1=0).give(C11=[0, 0, 0, 1]),
        scans(1, C4=0).give(C11=[0, 0, 1, 0]),
        scans(1, C2=0).give(C11=[0, 0, 1, 0]),
        scans(1, C2=1).give(C11=[0, 1, 0, 0]),
        scans(1, C4=1).give(C11=[0, 1, 0, 0]),
        scans(1, C4=0).give(C11=[1, 0, 0, 0]),
        scans(1, C3=1).give(C11=[0, 0, 0, 0], C10=1),
    ),
)
