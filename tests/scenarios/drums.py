"""Drum sequencers. No source says what they hold before their first reset and after their last step.

click-facts [drum.work]
"""

from __future__ import annotations

from .scenario import Scenario, scans, scenario

THREE_STEPS = "outputs=[y[1], y[2]], events=[c[3], c[4], c[5]], pattern=[[1, 0], [0, 1], [1, 1]]"

DRUMS: tuple[Scenario, ...] = (
    scenario(
        "an event drum goes on with the event of its step",
        f"""
        if c[1]:
            event_drum({THREE_STEPS}, current_step=ds[1], completion_flag=c[9], reset=lambda: c[6])
        """,
        scans(1, C1=1, C6=1).give(DS1=1, Y001=[1, 0], C9=0),
        scans(2, C6=0).give(DS1=1, Y001=[1, 0]),
        # The event of another step, then its own.
        scans(1, C5=1).give(DS1=1, Y001=[1, 0], C9=0),
        scans(1, C5=0, C3=1).give(DS1=2, Y001=[0, 1], C9=0),
        scans(2).give(DS1=2, Y001=[0, 1]),
        scans(1, C3=0, C4=1).give(DS1=3, Y001=[1, 1], C9=0),
        scans(2, C4=0).give(DS1=3, Y001=[1, 1], C9=0),
        scans(1, C5=1).give(C9=1),
        scans(1, C5=0).give(C9=1),
        scans(1, C6=1).give(DS1=1, Y001=[1, 0], C9=0),
        # Without power it waits.
        scans(1, C1=0, C6=0).give(DS1=1),
        scans(1, C3=1).give(DS1=1),
        scans(1, C3=0).give(DS1=1),
        scans(1, C1=1).give(DS1=1, Y001=[1, 0]),
        scans(1, C3=1).give(DS1=2, Y001=[0, 1]),
    ),
    scenario(
        "an event that is on already must come again",
        f"""
        if c[1]:
            event_drum({THREE_STEPS}, current_step=ds[1], completion_flag=c[9], reset=lambda: c[6])
        """,
        scans(1, C1=1, C6=1, C4=1).give(DS1=1),
        scans(1, C6=0).give(DS1=1),
        scans(1, C3=1).give(DS1=2, Y001=[0, 1]),
        scans(3).give(DS1=2, Y001=[0, 1]),
        scans(1, C4=0).give(DS1=2),
        scans(1, C4=1).give(DS1=3, Y001=[1, 1]),
    ),
    scenario(
        "one event for all steps",
        """
        if c[1]:
            event_drum(outputs=[y[1], c[20]], events=[x[1], x[1], x[1]], pattern=[[1, 0], [0, 1], [1, 1]],
                       current_step=ds[1], completion_flag=c[9], reset=lambda: any(c[6], c[7]))
        """,
        scans(1, C1=1, C6=1).give(DS1=1, Y001=1, C20=0),
        scans(1, C6=0).give(DS1=1),
        scans(3, X001=1).give(DS1=2, Y001=0, C20=1),
        scans(3, X001=0).give(DS1=2),
        scans(3, X001=1).give(DS1=3, Y001=1, C20=1, C9=0),
        scans(3, X001=0).give(DS1=3, C9=0),
        scans(3, X001=1).give(C9=1),
        scans(1, X001=0, C7=1).give(DS1=1, Y001=1, C20=0, C9=0),
    ),
    scenario(
        "reset takes an event drum back and clears the completion",
        f"""
        if c[1]:
            event_drum({THREE_STEPS}, current_step=ds[1], completion_flag=c[9], reset=lambda: c[6])
        """,
        scans(1, C1=1, C6=1).give(DS1=1),
        scans(1, C6=0).give(DS1=1),
        scans(1, C3=1).give(DS1=2),
        scans(1, C4=1).give(DS1=3),
        scans(1, C5=1).give(C9=1),
        scans(1, C6=1).give(DS1=1, Y001=[1, 0], C9=0),
        scans(2, C3=0, C4=0, C5=0).give(DS1=1, Y001=[1, 0], C9=0),
        scans(1, C6=0).give(DS1=1, C9=0),
        scans(1, C3=1).give(DS1=2, Y001=[0, 1]),
    ),
    scenario(
        "an event drum jumps to a step, and jogs to the next",
        f"""
        if c[1]:
            event_drum({THREE_STEPS}, current_step=ds[1], completion_flag=c[9], reset=lambda: c[6],
                       jump=lambda: c[7], jump_step=3, jog=lambda: c[8])
        """,
        scans(1, C1=1, C6=1).give(DS1=1, Y001=[1, 0]),
        scans(2, C6=0).give(DS1=1),
        scans(3, C8=1).give(DS1=2, Y001=[0, 1]),
        scans(1, C8=0, C6=1).give(DS1=1, Y001=[1, 0]),
        scans(1, C6=0, C7=1).give(DS1=3, Y001=[1, 1], C9=0),
        # Both inputs look for an edge.
        scans(1, C6=1).give(DS1=1),
        scans(2, C6=0).give(DS1=1, Y001=[1, 0]),
        scans(1, C7=0).give(DS1=1),
        scans(1, C7=1).give(DS1=3, Y001=[1, 1]),
    ),
    scenario(
        "an event drum jumps where a register says",
        f"""
        if c[1]:
            event_drum({THREE_STEPS}, current_step=ds[1], completion_flag=c[9], reset=lambda: c[6],
                       jump=lambda: all(c[7], nc(c[8])), jump_step=ds[2])
        """,
        scans(1, C1=1, C6=1, DS2=3).give(DS1=1),
        scans(1, C6=0, C7=1).give(DS1=3, Y001=[1, 1]),
        scans(1, DS2=2).give(DS1=3),
        scans(1, C8=1).give(DS1=3),
        scans(1, C8=0).give(DS1=2, Y001=[0, 1]),
        scans(1, C4=1).give(DS1=3, Y001=[1, 1]),
    ),
    scenario(
        "a chain on an event drum",
        f"""
        if c[1]:
            event_drum({THREE_STEPS}, current_step=ds[1], completion_flag=c[9]).reset(c[6]).jump(
                (c[7], nc(c[10])), step=2).jog(c[8], c[11])
        """,
        scans(1, C1=1, C6=1, C10=1).give(DS1=1),
        scans(1, C6=0, C7=1).give(DS1=1),
        scans(1, C10=0).give(DS1=2, Y001=[0, 1]),
        scans(1, C8=1).give(DS1=2),
        scans(1, C11=1).give(DS1=3, Y001=[1, 1]),
    ),
    scenario(
        "an event drum with a jog on either of two contacts",
        f"""
        if c[1]:
            event_drum({THREE_STEPS}, current_step=ds[1], completion_flag=c[9], reset=lambda: c[6],
                       jog=lambda: any(c[7], c[8]))
        """,
        scans(1, C1=1, C6=1).give(DS1=1),
        scans(1, C6=0, C7=1).give(DS1=2),
        scans(1, C8=1).give(DS1=2),
        scans(1, C7=0, C8=0).give(DS1=2),
        scans(1, C8=1).give(DS1=3),
        pyrung_cannot="must immediately follow its owning instruction row",
    ),
    scenario(
        "an event drum with a jog and no jump",
        f"""
        if c[1]:
            event_drum({THREE_STEPS}, current_step=ds[1], completion_flag=c[9], reset=lambda: any(c[6], c[10]),
                       jog=lambda: all(c[7], nc(c[8])))
        """,
        scans(1, C1=1, C10=1, C7=1, C8=1).give(DS1=1, Y001=[1, 0]),
        scans(1, C10=0).give(DS1=1),
        scans(2, C8=0).give(DS1=2, Y001=[0, 1]),
        scans(1, C8=1).give(DS1=2),
        scans(1, C8=0).give(DS1=3, Y001=[1, 1]),
    ),
    scenario(
        "a branch behind a drum sees the step from before it",
        """
        if c[1]:
            set(c[20])
            event_drum(outputs=[y[1], y[2]], events=[c[3], c[4]], pattern=[[1, 0], [0, 1]], current_step=ds[1],
                       completion_flag=c[9], reset=lambda: nc(c[20]))
            if ds[1] == 2:
                calc("ds[2] + 1", ds[2])

        if ds[1] == 2:
            calc("ds[3] + 1", ds[3])
        """,
        # C20 comes on in this rung: the drum is still reset in the first scan.
        scans(1, C1=1, DS1=2).give(DS1=1, Y001=[1, 0], C20=1, DS2=1, DS3=0),
        scans(1).give(DS1=1, DS2=1, DS3=0),
        scans(1, C3=1).give(DS1=2, Y001=[0, 1], DS2=1, DS3=1),
        scans(2).give(DS1=2, DS2=3, DS3=3),
    ),
    scenario(
        "a time drum stays in each step for its time",
        """
        if c[1]:
            time_drum(outputs=[y[1], y[2]], presets=[20, 30, 10], unit=Tms, pattern=[[1, 0], [0, 1], [1, 1]],
                      current_step=ds[1], accumulator=td[1], completion_flag=c[9], reset=lambda: c[6])
        """,
        scans(1, C1=1, C6=1).give(DS1=1, TD1=0, Y001=[1, 0], C9=0),
        scans(1, C6=0).give(DS1=1, TD1=10, Y001=[1, 0]),
        scans(1).give(DS1=2, Y001=[0, 1]),
        scans(2).give(DS1=2, TD1=20, Y001=[0, 1]),
        scans(1).give(DS1=3, Y001=[1, 1], C9=0),
        scans(1).give(C9=1),
        scans(1, C6=1).give(DS1=1, TD1=0, Y001=[1, 0], C9=0),
        scans(2, C6=0).give(DS1=2, Y001=[0, 1], C9=0),
        # Without power its time does not advance.
        scans(5, C1=0).give(DS1=2, C9=0),
    ),
    scenario(
        "a time drum in seconds, with presets in registers",
        """
        if c[1]:
            time_drum(outputs=[c[21]], presets=[ds[2], 3], unit=Ts, pattern=[[1], [0]], current_step=ds[1],
                      accumulator=td[1], completion_flag=c[9], reset=lambda: c[6])
        """,
        scans(1, C1=1, C6=1, DS2=1).give(DS1=1, C21=1),
        scans(1, C6=0).give(DS1=1, TD1=0, C21=1),
        scans(1).give(DS1=2, C21=0),
        scans(5).give(DS1=2, TD1=2, C9=0),
        scans(1).give(C9=1),
        ms=500,
    ),
    scenario(
        "a time drum jumps and jogs",
        """
        if c[1]:
            time_drum(outputs=[y[1], y[2]], presets=[1000, 1000, 1000], unit=Tms, pattern=[[1, 0], [0, 1], [1, 1]],
                      current_step=ds[1], accumulator=td[1], completion_flag=c[9]
                      ).reset(c[6]).jump(c[7], step=ds[2]).jog(c[8])
        """,
        scans(1, C1=1, C6=1, DS2=3).give(DS1=1, Y001=[1, 0]),
        scans(3, C6=0, C8=1).give(DS1=2, Y001=[0, 1]),
        scans(1, C8=0).give(DS1=2),
        scans(1, C8=1).give(DS1=3, Y001=[1, 1]),
        scans(1, C8=0, C6=1).give(DS1=1, Y001=[1, 0]),
        scans(3, C6=0, C7=1).give(DS1=3, Y001=[1, 1]),
        scans(1, DS2=2).give(DS1=3, Y001=[1, 1], C9=0),
    ),
)
