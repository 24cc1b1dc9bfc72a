"""Counters: the vendor counts edges, others say every scan; an edge in the program makes both the same.

click-facts [counter.count-down, counter.edges, counter.limits]
"""

from __future__ import annotations

from .scenario import Scenario, scans, scenario

EVERY_SCAN = "it counts in every scan, the vendor once for each change from off to on (click-facts [counter.edges])"
FROM_ZERO = "it counts from zero down to minus the preset, the vendor from a preloaded value down to the preset"

COUNTERS: tuple[Scenario, ...] = (
    scenario(
        "ctu behind an edge",
        """
        if re(c[1]):
            ctu(ct[1], 3, reset=lambda: c[2])
        """,
        scans(3).give(CTD1=0, CT1=0),
        scans(1, C1=1).give(CTD1=1, CT1=0),
        scans(5).give(CTD1=1, CT1=0),
        scans(3, C1=0).give(CTD1=1),
        scans(2, C1=1).give(CTD1=2, CT1=0),
        scans(1, C1=0).give(CTD1=2),
        scans(1, C1=1).give(CTD1=3, CT1=1),
        scans(1, C1=0).give(CTD1=3, CT1=1),
        scans(1, C1=1).give(CTD1=4, CT1=1),
        scans(1, C1=0, C2=1).give(CTD1=0, CT1=0),
        scans(1, C1=1).give(CTD1=0, CT1=0),
        scans(1, C2=0).give(CTD1=0, CT1=0),
    ),
    scenario(
        "ctu on a level",
        """
        if c[1]:
            ctu(ct[1], 2, reset=lambda: c[2])
        """,
        scans(1, C1=1).give(CTD1=1, CT1=0),
        scans(2).give(CTD1=1, CT1=0).but_pyrung(EVERY_SCAN, CTD1=3, CT1=1),
        scans(2, C1=0).give(CTD1=1, CT1=0).but_pyrung(EVERY_SCAN, CTD1=3, CT1=1),
        scans(2, C1=1).give(CTD1=2, CT1=1).but_pyrung(EVERY_SCAN, CTD1=5),
        scans(1, C2=1).give(CTD1=0, CT1=0),
    ),
    scenario(
        "a counter's preset in a register",
        """
        if re(c[1]):
            ctu(ct[1], ds[1], reset=lambda: c[2])
            ctu(ct[2], dd[1], reset=lambda: c[2])
        """,
        scans(2, C1=1, DS1=1, DD1=70_000, CTD2=69_998).give(CTD1=1, CT1=1, CTD2=69_999, CT2=0),
        scans(1, C1=0, DS1=2).give(CTD1=1, CT1=0, CTD2=69_999, CT2=0),
        scans(1, C1=1).give(CTD1=2, CT1=1, CTD2=70_000, CT2=1),
    ),
    # With zero for a preset, the two ideas of a down counter come to the same.
    scenario(
        "ctd counts down from what it holds",
        """
        if re(c[1]):
            ctd(ct[1], 0, reset=lambda: c[2])
        """,
        scans(1, C1=1, CTD1=2).give(CTD1=1, CT1=0),
        scans(3).give(CTD1=1, CT1=0),
        scans(1, C1=0).give(CTD1=1, CT1=0),
        scans(1, C1=1).give(CTD1=0, CT1=1),
        scans(1, C1=0).give(CTD1=0, CT1=1),
        scans(1, C1=1).give(CTD1=-1, CT1=1),
        scans(1, C1=0, C2=1, CTD1=7).give(CTD1=0),
    ),
    scenario(
        "ctd with a preset",
        """
        if re(c[1]):
            ctd(ct[1], 2, reset=lambda: c[2])
        """,
        scans(2, C1=1, CTD1=4).give(CTD1=3, CT1=0),
        scans(1, C1=0).give(CTD1=3, CT1=0),
        scans(1, C1=1).give(CTD1=2, CT1=1).but_pyrung(FROM_ZERO, CT1=0),
        scans(1, C1=0).give(CTD1=2, CT1=1).but_pyrung(FROM_ZERO, CT1=0),
        scans(1, C1=1).give(CTD1=1, CT1=1).but_pyrung(FROM_ZERO, CT1=0),
        scans(1, C1=0, CTD1=-1).give(CTD1=-1, CT1=1).but_pyrung(FROM_ZERO, CT1=0),
        scans(1, C1=1).give(CTD1=-2, CT1=1),
    ),
    scenario(
        "ctd on a level",
        """
        if c[1]:
            ctd(ct[1], 0, reset=lambda: c[2])
        """,
        scans(1, C1=1, CTD1=5).give(CTD1=4, CT1=0),
        scans(3).give(CTD1=4, CT1=0).but_pyrung(EVERY_SCAN, CTD1=1),
        scans(1).give(CTD1=4, CT1=0).but_pyrung(EVERY_SCAN, CTD1=0, CT1=1),
    ),
    scenario(
        "ctud behind edges",
        """
        if re(c[1]):
            ctud(ct[1], 2, count_down=lambda: re(c[2]), reset=lambda: c[3])
        """,
        scans(2, C1=1).give(CTD1=1, CT1=0),
        scans(1, C1=0).give(CTD1=1, CT1=0),
        scans(2, C1=1).give(CTD1=2, CT1=1),
        scans(2, C2=1).give(CTD1=1, CT1=0),
        scans(1, C1=0, C2=0).give(CTD1=1, CT1=0),
        scans(1, C1=1, C2=1).give(CTD1=1, CT1=0),
        scans(1, C1=0, C2=0).give(CTD1=1, CT1=0),
        scans(1, C2=1).give(CTD1=0, CT1=0),
        scans(1, C2=0).give(CTD1=0, CT1=0),
        scans(1, C2=1).give(CTD1=-1, CT1=0),
        scans(1, C1=1, C3=1).give(CTD1=0, CT1=0),
    ),
    scenario(
        "ctud on levels",
        """
        if c[1]:
            ctud(ct[1], 2, count_down=lambda: c[2], reset=lambda: c[3])
        """,
        scans(1, C1=1).give(CTD1=1, CT1=0),
        scans(1).give(CTD1=1, CT1=0).but_pyrung(EVERY_SCAN, CTD1=2, CT1=1),
        scans(2, C1=0, C2=1).give(CTD1=0, CT1=0),
        scans(1).give(CTD1=0, CT1=0).but_pyrung(EVERY_SCAN, CTD1=-1),
        scans(1, C2=0, C3=1).give(CTD1=0, CT1=0),
    ),
    scenario(
        "counters stop at the ends of 32 bits",
        """
        if re(c[1]):
            ctu(ct[1], 2147483647, reset=lambda: c[2])
            ctd(ct[2], 0, reset=lambda: c[2])
        """,
        scans(1, C1=1, CTD1=2_147_483_646, CTD2=-2_147_483_647).give(CTD1=2_147_483_647, CT1=1, CTD2=-2_147_483_648),
        scans(1, C1=0).give(CTD1=2_147_483_647, CTD2=-2_147_483_648),
        scans(1, C1=1).give(CTD1=2_147_483_647, CT1=1, CTD2=-2_147_483_648, CT2=1),
    ),
)
