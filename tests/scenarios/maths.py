"""Formulas: they wrap around where copies clamp.

click-facts [math.division, math.float, math.overflow, math.trigonometry]
"""

from __future__ import annotations

from math import pi, sqrt

from .scenario import Scenario, scans, scenario

NO_XD = "Unsupported CSV operand expression: 'XD0'"

MATHS: tuple[Scenario, ...] = (
    scenario(
        "16 bits wrap around and set SC43",
        """
        if True:
            calc("ds[1] + 1", ds[2])

        if sc[43]:
            out(c[2])

        if True:
            calc("ds[3] * ds[4]", ds[5])
            calc("0 - ds[6] - 2", ds[7])
        """,
        scans(1, DS1=32_766).give(DS2=32_767, C2=0),
        scans(1, DS1=32_767, DS3=160, DS4=250, DS6=32_767).give(DS2=-32_768, C2=1, DS5=40_000 - 65_536, DS7=32_767),
        scans(1, DS1=5).give(DS2=6, C2=0),
    ),
    scenario(
        "32 bits wrap around",
        """
        if True:
            calc("dd[1] * dd[1]", dd[2])
            calc("dd[3] + 1", dd[4])
            calc("ds[1] * ds[1]", dd[5])
        """,
        scans(1, DD1=50_000, DD3=2_147_483_647, DS1=200).give(DD2=-1_794_967_296, DD4=-2_147_483_648, DD5=40_000),
    ),
    scenario(
        "a division by zero gives 0 and sets SC40",
        """
        if True:
            calc("ds[1] / ds[2]", ds[3])

        if sc[40]:
            out(c[2])

        if True:
            calc("df[1] / df[2]", df[3])
        """,
        scans(1, DS1=9, DS2=3, DF1=9.0, DF2=4.0).give(DS3=3, C2=0, DF3=2.25),
        scans(1, DS2=0).give(DS3=0, C2=1),
        scans(1, DS2=2, DF2=0.0).give(DS3=4, C2=0, DF3=0.0),
    ),
    scenario(
        "an integer division cuts off towards zero",
        """
        if True:
            calc("ds[1] / 2", ds[2])
            calc("ds[3] / ds[4]", dd[1])
        """,
        scans(1, DS1=-7, DS3=7, DS4=-2).give(DS2=-3, DD1=-3),
        scans(1, DS1=7, DS3=-1, DS4=2).give(DS2=3, DD1=0),
    ),
    scenario(
        "any floating-point operand makes the whole formula so",
        """
        if True:
            calc("ds[1] / 2.0", df[1])
            calc("(df[2] - 32) * 5 / 9", df[3])
            calc("df[2] / 4", ds[2])
            calc("ds[1] / 2 * df[4]", ds[3])
        """,
        scans(1, DS1=7, DF2=50.0, DF4=2.0).give(DF1=3.5, DF3=10.0, DS2=12, DS3=7),
    ),
    scenario(
        "functions of decimal formulas",
        """
        if True:
            calc("SQRT(df[1])", df[11])
            calc("2 * SIN(RAD(df[2]))", df[12])
            calc("COS(PI) + TAN(PI / 4)", df[13])
            calc("LOG(df[3]) - LN(df[4])", df[14])
            calc("DEG(PI)", df[15])
            calc("ASIN(1.0) + ACOS(0.0)", df[16])
            calc("ATAN(1.0) * 4", df[17])
            calc("df[1] ^ 3", df[18])
        """,
        scans(1, DF1=2.0, DF2=30.0, DF3=1000.0, DF4=2.7182818).give(
            DF11=sqrt(2.0), DF12=1.0, DF13=0.0, DF14=2.0, DF15=180.0, DF16=pi, DF17=pi, DF18=8.0
        ),
    ),
    scenario(
        "remainders, sums, powers, signs and parentheses",
        """
        if True:
            calc("ds[1] MOD 5", ds[11])
            calc("SUM(ds[1:4])", ds[12])
            calc("SUM(ds[1:4]) / 2 + 1", ds[13])
            calc("-ds[1]", ds[14])
            calc("ds[2] - -ds[1]", ds[15])
            calc("2 ^ 10", ds[16])
            calc("(ds[1] + ds[2]) * (ds[3] - 1)", ds[17])
            calc("ds[1] - ds[2] - ds[3]", ds[18])
            calc("-ds[2] * -ds[3]", ds[19])
            calc("100 - (ds[1] - (ds[2] - ds[3]))", ds[20])
        """,
        scans(1, DS1=[17, 4, 3], DS4=1000).give(
            DS11=[2, 24, 13, -17, 21, 1024, 42, 10, 12, 84],
        ),
    ),
    scenario(
        "a pointer in a formula",
        """
        if True:
            calc("ds[ds[1]] * 2 + dd[ds[2]]", dd[1])
            calc("ds[1] + 1", ds[1])
            calc("ds[ds[1]] + ds[ds[1]]", ds[3])
        """,
        scans(1, DS1=50, DS2=7, DS50=[10, 100, 1000], DD7=3).give(DD1=23, DS1=51, DS3=200),
        scans(1).give(DD1=203, DS1=52, DS3=2000),
    ),
    scenario(
        "a formula once",
        """
        if c[1]:
            calc("ds[1] + 1", ds[1], oneshot=True)
            calc("ds[ds[5]] + 1", ds[2], one_shot=True)
            math_hex("dh[1] + 1h", dh[1], oneshot=True)
        """,
        scans(3, C1=1, DS5=10, DS10=7).give(DS1=1, DS2=8, DH1=1),
        scans(1, C1=0, DS10=70).give(DS1=1, DS2=8, DH1=1),
        scans(2, C1=1).give(DS1=2, DS2=71, DH1=2),
    ),
    scenario(
        "bit operations on words",
        """
        if True:
            math_hex("dh[1] AND 0x0FF0", dh[11])
            math_hex("dh[1] OR dh[2]", dh[12])
            math_hex("dh[1] XOR FFFFh", dh[13])
            math_hex("NOT dh[1]", dh[14])
            math_hex("NOT dh[1] AND 0x0FF0 OR 0x00CF", dh[15])
            math_hex("dh[1] XOR (dh[2] OR 0x8003)", dh[16])
        """,
        scans(1, DH1=0x5A3D, DH2=0x00F3).give(
            DH11=[0x0A30, 0x5AFF, 0xA5C2, 0xA5C2, 0x05CF, 0xDACE],
        ),
    ),
    scenario(
        "words shift and rotate",
        """
        if True:
            math_hex("dh[1] SHL 4", dh[11])
            math_hex("SHR(dh[1], 4)", dh[12])
            math_hex("LSH(dh[1], 8)", dh[13])
            math_hex("RSH(dh[1], 0x000C)", dh[14])
            math_hex("LRO(dh[2], 1)", dh[15])
            math_hex("RRO(dh[2], 1)", dh[16])
            math_hex("RRO(dh[1], 4) AND 0xFF00", dh[17])
            math_hex("dh[1] SHL 10", dh[18])
        """,
        scans(1, DH1=0x1234, DH2=0x8001).give(
            DH11=[0x2340, 0x0123, 0x3400, 0x0001, 0x0003, 0xC000, 0x4100, 0xD000],
        ),
    ),
    scenario(
        "words calculate in 16 bits",
        """
        if True:
            math_hex("dh[1] + 1h", dh[11])
            math_hex("dh[2] - 1h", dh[12])
            math_hex("dh[3] * 10h", dh[13])
            math_hex("dh[3] / 10h", dh[14])
            math_hex("dh[3] MOD 10h", dh[15])
            math_hex("SUM(dh[3:6])", dh[16])
            math_hex("dh[3] + 10", dh[17])
        """,
        scans(1, DH1=0xFFFF, DH2=0, DH3=[0x1234, 1, 2, 4]).give(
            DH11=[0x0000, 0xFFFF, 0x2340, 0x0123, 0x0004, 0x1237, 0x123E],
        ),
    ),
    scenario(
        "the words of the inputs and outputs",
        """
        if True:
            copy(xd[0], dh[1])
            math_hex("xd[0] AND 0x00FF", dh[2])
            copy(0x0005, yd[0])
        """,
        scans(1, X001=1, X016=1).give(DH1=0x8001, DH2=0x0001, Y001=[1, 0, 1, 0]),
        pyrung_cannot=NO_XD,
    ),
)
