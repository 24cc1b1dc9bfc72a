"""The copy family on numbers and bits: it clamps where formulas wrap around.

click-facts [copy.clamp, copy.fill, copy.pack-words, copy.wild-pointer]
"""

from __future__ import annotations

from .scenario import Scenario, scans, scenario

NO_FLAG = "it clamps and leaves SC43 alone"
WORD_WRAPS = "it wraps around into a word, where every copy clamps"

COPIES: tuple[Scenario, ...] = (
    scenario(
        "copy clamps what does not fit",
        """
        if True:
            copy(dd[1], ds[1])
            copy(df[1], ds[2])
            copy(df[1], dd[2])
            copy(ctd[1], td[1])
        """,
        scans(1, DD1=40_000, DF1=3.0e9, CTD1=-70_000).give(
            DS1=32767, DS2=32767, DD2=2_147_483_647, TD1=-32768, DD1=40_000
        ),
        scans(1, DD1=-40_000, DF1=-3.0e9, CTD1=32_768).give(DS1=-32768, DS2=-32768, DD2=-2_147_483_648, TD1=32767),
        scans(1, DD1=-32_768, DF1=2.0e9, CTD1=-5).give(DS1=-32768, DS2=32767, DD2=2_000_000_000, TD1=-5),
    ),
    scenario(
        "copy clamps into a word",
        """
        if True:
            copy(dd[1], dh[1])
        """,
        scans(1, DD1=65_535).give(DH1=0xFFFF),
        scans(1, DD1=70_000).give(DH1=0xFFFF).but_pyrung(WORD_WRAPS, DH1=70_000 - 65_536),
    ),
    scenario(
        "copy sets SC43 when it clamps",
        """
        if True:
            copy(dd[1], ds[1])

        if sc[43]:
            set(c[2])
        """,
        scans(1, DD1=32_767).give(DS1=32_767, C2=0),
        scans(1, DD1=32_768).give(DS1=32_767, C2=1).but_pyrung(NO_FLAG, C2=0),
    ),
    scenario(
        "copy cuts off what stands behind the decimal point",
        """
        if True:
            copy(df[1], ds[1])
            copy(df[2], ds[2])
            copy(df[2], dd[1])
            copy(ds[3], df[3])
        """,
        scans(1, DF1=2.9, DF2=-2.9, DS3=-7).give(DS1=2, DS2=-2, DD1=-2, DF3=-7.0),
    ),
    scenario(
        "copy puts the bits of an integer into a word",
        """
        if True:
            copy(ds[1], dh[1])
        """,
        scans(1, DS1=-1).give(DH1=0xFFFF),
        scans(1, DS1=-32768).give(DH1=0x8000),
        scans(1, DS1=255).give(DH1=0x00FF),
    ),
    scenario(
        "copy of constants, and one that stands behind another",
        """
        if c[1]:
            copy(-5, ds[1])
            copy(100000, dd[1])
            copy(0x00FF, dh[1])
            copy(2.5, df[1])
            copy(7, df[2])
            copy(ds[1], ds[2])
            copy(x[1], c[5])
            copy(ct[1], y[1])
        """,
        scans(1).give(DS1=0, DD1=0, DH1=0, DF1=0.0),
        scans(1, C1=1, X001=1, CT1=1).give(DS1=-5, DD1=100_000, DH1=0x00FF, DF1=2.5, DF2=7.0, DS2=-5, C5=1, Y001=1),
        scans(1, X001=0, CT1=0).give(C5=0, Y001=0),
    ),
    scenario(
        "copy once",
        """
        if c[1]:
            copy(ds[1], ds[2], oneshot=True)
            copy(ds[1], ds[3])
        """,
        scans(1, C1=1, DS1=1).give(DS2=1, DS3=1),
        scans(1, DS1=2).give(DS2=1, DS3=2),
        scans(1, C1=0, DS1=3).give(DS2=1, DS3=2),
        scans(1, C1=1).give(DS2=3, DS3=3),
    ),
    scenario(
        "pointers on both sides",
        """
        if True:
            copy(ds[ds[1]], dd[ds[2]])
            copy(9, ds[1])
            copy(ds[ds[1]], ds[20])
            copy(5, dh[ds[3]])
        """,
        scans(1, DS1=100, DS100=-7, DS2=1000, DS9=77, DS3=500).give(DD1000=-7, DS1=9, DS20=77, DH500=5),
    ),
    scenario(
        "a pointer to no address copies nothing and sets SC44",
        """
        if True:
            copy(dd[ds[1]], dd[5])

        if sc[44]:
            calc("ds[10] + 1", ds[10])
        """,
        scans(1, DS1=1000, DD1000=4).give(DD5=4, DS10=0),
        scans(1, DS1=1001, DD5=8).give(DD5=8, DS10=1),
        scans(1, DS1=0).give(DD5=8, DS10=2),
        scans(1, DS1=-1).give(DD5=8, DS10=3),
        scans(1, DS1=1000).give(DD5=4, DS10=3),
    ),
    scenario(
        "copy_block and copy_fill",
        """
        if True:
            copy_block(ds[1:5], ds[11])
            copy_block(c[11:14], y[1])
            copy_block(ds[1:3], dd[1])
            copy_fill(ds[1], ds[21:24])
            copy_fill(-1, dd[21:23])
            copy_fill(2.5, df[21:23])
            copy_fill(0x0A0B, dh[21:23])
        """,
        scans(1, DS1=[-1, 2, 3, 4], C11=[1, 0, 1], DS15=50, DS24=60).give(
            DS11=[-1, 2, 3, 4, 50],
            Y001=[1, 0, 1],
            DD1=[-1, 2],
            DS21=[-1, -1, -1, 60],
            DD21=[-1, -1, 0],
            DF21=[2.5, 2.5, 0.0],
            DH21=[0x0A0B, 0x0A0B, 0],
        ),
    ),
    scenario(
        "pack puts the first bit lowest",
        """
        if True:
            copy_pack(c[11:27], dh[1])
            copy_pack(c[11:27], ds[1])
            copy_pack(c[11:15], dh[2])
            copy_pack(c[11:43], dd[1])
            copy_pack(x[1:9], dh[3])
        """,
        scans(1, C11=1).give(DH1=0x0001, DS1=1, DH2=1, DD1=1),
        scans(1, C13=1, C26=1).give(DH1=0x8005, DS1=-32763, DH2=5, DD1=0x8005),
        scans(1, C11=0, C13=0, C26=0, C42=1, C27=1).give(DH1=0, DS1=0, DD1=-2_147_483_648 + 65_536),
        scans(1, X002=1, X008=1, X009=1, C15=1).give(DH3=0x82, DH2=0),
    ),
    scenario(
        "unpack puts the lowest bit first",
        """
        if True:
            copy_unpack(dh[1], c[11:27])
            copy_unpack(ds[1], c[31:35])
            copy_unpack(dd[1], c[41:73])
            copy_unpack(dh[1], y[1:5])
        """,
        scans(1, DH1=0x8005, DS1=-2, DD1=-2_147_483_646, C35=1, Y005=1).give(
            C11=[1, 0, 1] + [0] * 12 + [1], C31=[0, 1, 1, 1, 1], C41=[0, 1] + [0] * 29 + [1], Y001=[1, 0, 1, 0, 1]
        ),
        scans(1, DH1=0x0002, DS1=0).give(C11=[0, 1, 0], C26=0, C31=[0, 0, 0, 0], Y001=[0, 1, 0, 0]),
    ),
    scenario(
        "words and double words: the low word comes first",
        """
        if True:
            copy_pack(ds[1:3], dd[1])
            copy_pack(dh[1:3], dd[2])
            copy_pack(ds[3:5], df[1])
            copy_unpack(dd[3], ds[11:13])
            copy_unpack(dd[3], dh[11:13])
            copy_unpack(df[2], dh[13:15])
        """,
        scans(1, DS1=[1, 2], DH1=[0x5678, 0x1234], DS3=[0, 0x3F80], DD3=-2, DF2=1.0).give(
            DD1=131_073, DD2=0x12345678, DF1=1.0, DS11=[-2, -1], DH11=[0xFFFE, 0xFFFF], DH13=[0, 0x3F80]
        ),
        scans(1, DS1=[-1, 0], DD3=65_536).give(DD1=65_535, DS11=[0, 1], DH11=[0, 1]),
        scans(1, DS1=[0, -1]).give(DD1=-65_536),
    ),
)
