"""Names that are the same but for a slip of the hand, and names that somebody chose."""

from __future__ import annotations

import pytest

from clickgen.problems.name_slips import Spellings, is_slip

SLIPS = [
    ("Gaurd_Fault", "Guard_Fault"),
    ("GuardFault", "Guard_Fault"),
    ("guardfault", "Guard_Fault"),
    ("Guard Fault", "Guard_Fault"),
    ("Guard_Fualt", "Guard_Fault"),
    ("Guad_Fault", "Guard_Fault"),
    ("Guardd_Fault", "Guard_Fault"),
    ("Guard_Faul", "Guard_Fault"),
    ("Gaurdfault", "Guard_Fault"),
    ("MotorRuning", "MotorRunning"),
    ("Weigth", "Weight"),
    ("Presure", "Pressure"),
    ("Conveyer", "Conveyor"),
    ("Recieved", "Received"),
    ("Pump_1_Run", "Pump1_Run"),
    ("Pump1_Rnu_Time", "Pump1_Run_Time"),
    ("HornTmie2", "HornTime2"),
    ("StartDely", "StartDelay"),
    ("Fil_Valve", "Fill_Valve"),
]
CHOSEN = [
    ("Pump1", "Pump2"),
    ("Pump1", "Pump11"),
    ("Pump", "Pump1"),
    ("Zone1_Valve2", "Zone2_Valve1"),
    ("Part", "Parts"),
    ("Close", "Closed"),
    ("Feed", "Feeder"),
    ("ValveA", "ValveB"),
    ("Valve_L", "Valve_R"),
    ("Level_Hi", "Level_Lo"),
    ("Fill", "Full"),
    ("FillValve", "FullValve"),
    ("Heat", "Head"),
    ("MotorStart", "MotorStat"),
    ("Motor_Count", "Motor_Cont"),
    ("xMotor", "Motor"),
    ("Run", "Ran"),
    ("Min", "Max"),
    ("Open", "Oven"),
    ("Inlet", "Outlet"),
    ("Guard", "guard"),
    ("Rinsing", "Rising"),
    ("SetTemp", "GetTemp"),
    ("Lower", "Tower"),
    ("AutoMode", "ManualMode"),
]


@pytest.mark.parametrize(("name", "other"), SLIPS)
def test_a_slip(name: str, other: str) -> None:
    assert is_slip(name, other)
    assert is_slip(other, name)
    assert Spellings([other]).near(name) == [other]


@pytest.mark.parametrize(("name", "other"), CHOSEN)
def test_names_that_somebody_chose(name: str, other: str) -> None:
    assert not is_slip(name, other)
    assert not is_slip(other, name)
    assert Spellings([other]).near(name) == []
