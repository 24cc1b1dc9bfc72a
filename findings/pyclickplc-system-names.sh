#!/bin/sh
# pyclickplc's names of CLICK's system bits and registers are not those that CLICK exports, for 23 of 206 addresses.
#
# Package: pyclickplc 0.4.1
# Seen: canonical_system_nickname() follows the vendor's help topics. The address export of CLICK PLUS 3.41, whose names
#   for these addresses the script holds, spells 21 of them otherwise, and two of its names belong to other registers:
#   pyclickplc has _Port1_AL_Denied_Count at SD134, the export at SD132. canonicalize_system_nickname() renames these
#   two names of the export.
# Expected: The package calls its list canonical, so a name from CLICK's own export should be in it, at its address.
# Meaning: A program that names system points by this list does not fit the project in CLICK: _RTC_Hour is not found,
#   and an access counter can be the wrong one. clickgen takes the spelling of the export first and the others as
#   aliases, refuses a name that moved (CG215), and tests both in tests/device/test_system_names.py.
#
# Output:
#> SC19: CLICK '_PLC Error', pyclickplc '_PLC_Error'
#> SC20: CLICK '_I/O Module Error', pyclickplc '_I/O_BUS_Error'
#> SC21: CLICK '_System Config Error', pyclickplc '_System_Config_Error'
#> SC22: CLICK '_I/O Config Error', pyclickplc '_I/O_Module_Error'
#> SC23: CLICK '_Memory Check Error', pyclickplc '_Flash_Memory Error'
#> SC24: CLICK '_Project File Error', pyclickplc '_Project_File_Error'
#> SC25: CLICK '_Firmware Version Error', pyclickplc '_Project_File_Ver_Error'
#> SC26: CLICK '_Watchdog Timer Error', pyclickplc '_Watchdog_Timer_ Error'
#> SC27: CLICK '_Lost SDRAM Data', pyclickplc '_Lost_SDRAM_Data'
#> SC28: CLICK '_Battery Low Voltage', pyclickplc '_Battery_Low_Voltage'
#> SC29: CLICK '_Battery Replacement', pyclickplc '_Battery_Replacement'
#> SC32: CLICK '_C2DCM_FW_Ver_Error', pyclickplc '_C2INT_FW_Ver_Error'
#> SD19: CLICK '_RTC_Year(4 digits)', pyclickplc '_RTC_Year (4 digits)'
#> SD20: CLICK '_RTC_Year(2 digits)', pyclickplc '_RTC_Year (2 digits)'
#> SD21: CLICK '_RTC_Month', pyclickplc '_RTC_Month (1-12)'
#> SD22: CLICK '_RTC_Day', pyclickplc '_RTC_Day (1-31)'
#> SD23: CLICK '_RTC_Day_of_The_Week', pyclickplc '_RTC_Day_of_the_Week'
#> SD24: CLICK '_RTC_Hour', pyclickplc '_RTC_Hour (0-23)'
#> SD25: CLICK '_RTC_Minute', pyclickplc '_RTC_Minute (0-59)'
#> SD26: CLICK '_RTC_Second', pyclickplc '_RTC_Second (0-59)'
#> SD132: CLICK '_Port1_AL_Denied_Count', pyclickplc '_Port1_AL_Denied_No1_Cnt'; CLICK's name is at SD134; renamed
#> SD133: CLICK '_WLAN_AL_Denied_Count', pyclickplc '_WLAN_AL_Denied_No1_Cnt'; CLICK's name is at SD135; renamed
#> SD214: CLICK '_WLAN_No_Comm_Time', pyclickplc '_WLAN_No_Com_Time'
set -eu
expected=$(sed -n 's/^#> //p' "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
python3 -m venv "$work/venv"
"$work/venv/bin/python" -m pip install --quiet --disable-pip-version-check \
    pyclickplc==0.4.1
cat > "$work/see.py" <<'PY'
import re

from pyclickplc.system import (
    AUTOMATIONDIRECT_SYSTEM_NICKNAMES,
    canonical_system_nickname,
    canonicalize_system_nickname,
)

EXPORTED = """\
SC19,_PLC Error
SC20,_I/O Module Error
SC21,_System Config Error
SC22,_I/O Config Error
SC23,_Memory Check Error
SC24,_Project File Error
SC25,_Firmware Version Error
SC26,_Watchdog Timer Error
SC27,_Lost SDRAM Data
SC28,_Battery Low Voltage
SC29,_Battery Replacement
SC32,_C2DCM_FW_Ver_Error
SD19,_RTC_Year(4 digits)
SD20,_RTC_Year(2 digits)
SD21,_RTC_Month
SD22,_RTC_Day
SD23,_RTC_Day_of_The_Week
SD24,_RTC_Hour
SD25,_RTC_Minute
SD26,_RTC_Second
SD132,_Port1_AL_Denied_Count
SD133,_WLAN_AL_Denied_Count
SD214,_WLAN_No_Comm_Time
"""
elsewhere = {one.nickname: f"{bank}{number}" for (bank, number), one in AUTOMATIONDIRECT_SYSTEM_NICKNAMES.items()}
for line in EXPORTED.splitlines():
    address, name = line.split(",")
    bank, number = re.fullmatch(r"([A-Z]+)(\d+)", address).groups()
    theirs = canonical_system_nickname(bank, int(number))
    if theirs == name:
        continue
    moved = f"; CLICK's name is at {elsewhere[name]}" if name in elsewhere else ""
    renamed = "; renamed" if canonicalize_system_nickname(bank, int(number), name) != name else ""
    print(f"{address}: CLICK {name!r}, pyclickplc {theirs!r}{moved}{renamed}")
PY
seen=$(cd "$work" && venv/bin/python see.py)
printf '%s\n' "$seen"
[ "$seen" = "$expected" ] || { echo "changed: the output is not the one in the comment at the top" >&2; exit 1; }
