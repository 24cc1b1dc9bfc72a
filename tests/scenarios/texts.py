"""Text: one character for each TXT address.

click-facts [copy.convert, text.cell, value.float-text, value.number-text]
"""

from __future__ import annotations

from .scenario import Scenario, scans, scenario

TEXTS: tuple[Scenario, ...] = (
    scenario(
        "a text fills the addresses from the first on",
        """
        if True:
            copy("READY", txt[10])
            copy("A", txt[20])
            copy("$41", txt[21])
            copy('say "x"', txt[30])
        """,
        scans(1, TXT15="!").give(TXT10="READY!", TXT20="AA", TXT30='say "x"'),
    ),
    scenario(
        "characters as values and as codes",
        """
        if True:
            copy(txt[1], ds[1], options=to_value)
            copy(txt[1], ds[2], options=to_ascii)
            copy(ds[3], txt[2], options=to_binary)
            copy_block(txt[11:14], ds[11], options=to_value)
            copy_block(txt[11:14], ds[21], options=to_ascii)
        """,
        scans(1, TXT1="7", DS3=65, TXT11="123").give(
            DS1=7, DS2=55, TXT2="A", DS11=[1, 2, 3], DS21=[49, 50, 51], TXT1="7"
        ),
        scans(1, TXT1="0", DS3=122).give(DS1=0, DS2=48, TXT2="z"),
    ),
    scenario(
        "conversions written as modifiers",
        """
        if True:
            copy(txt[1].as_value(), ds[1])
            copy(txt[1].as_ascii(), ds[2])
            copy(ds[3].as_text(), txt[11])
            copy(ds[3].as_text(pad=5), txt[21])
            copy(ds[4].as_binary(), txt[31])
        """,
        scans(1, TXT1="7", DS3=42, DS4=0x5A).give(DS1=7, DS2=55, TXT11="42", TXT21="00042", TXT31="Z"),
    ),
    scenario(
        "integers as text",
        """
        if True:
            copy(ds[1], txt[1], options=to_text())
            copy(ds[1], txt[11], options=to_text(suppress_zero=False))
            copy(dd[1], txt[21], options=to_text(suppress_zero=False))
            copy(dd[1], txt[41], options=to_text(suppress_zero=True))
            copy(dh[1], txt[61], options=to_text(suppress_zero=False))
            copy(ds[1], txt[71], options=to_text(termination_code="$0D"))
        """,
        scans(1, DS1=123, DD1=4567, DH1=0x00AF, TXT4="-", TXT75="-").give(
            TXT1="123-", TXT11="00123", TXT21="0000004567", TXT41="4567", TXT61="00AF", TXT71="123\r-"
        ),
        scans(1, DS1=0, DD1=-9).give(TXT1="0", TXT11="00000", TXT41="-9"),
    ),
    scenario(
        "floating-point numbers as text",
        """
        if True:
            copy(df[1], txt[1], options=to_text())
            copy(df[1], txt[21], options=to_text(exponential=True))
        """,
        scans(1, DF1=10_000.0).give(TXT1="10000.0000000", TXT21="1.0000000E+04"),
        scans(1, DF1=0.5).give(TXT1="0.5000000", TXT21="5.0000000E-01"),
    ),
    scenario(
        "text packed into numbers",
        """
        if True:
            copy_pack(txt[1:5], ds[1])
            copy_pack(txt[1:5], dd[1])
            copy_pack(txt[11:15], df[1])
            copy_pack(txt[21:25], ds[2], allow_whitespace=True)
        """,
        scans(1, TXT1="0123", TXT11="12.5", TXT21=" 42 ").give(DS1=123, DD1=123, DF1=12.5, DS2=42),
        scans(1, TXT1="-007").give(DS1=-7, DD1=-7),
    ),
    scenario(
        "text copied, filled and compared",
        """
        if True:
            copy(txt[1], txt[2])
            copy_fill("-", txt[11:14])
            copy_fill("$2B", txt[15:17])
            copy(txt[ds[1]], txt[20])

        if txt[2] == "B":
            set(c[2])

        if "B" != txt[2]:
            set(c[3])
        """,
        scans(1, TXT1="A", DS1=5, TXT5="x").give(TXT2="A", TXT11="---", TXT14="", TXT15="++", TXT20="x", C2=0, C3=1),
        scans(1, TXT1="B", C3=0).give(TXT2="B", C2=1, C3=0),
    ),
)
