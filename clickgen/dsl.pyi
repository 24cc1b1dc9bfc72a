# made by scripts/dsl_stub.py; do not edit
# pyright: basic, reportIncompatibleMethodOverride=false, reportOverlappingOverload=false
# pyright: reportInconsistentOverload=false
# mypy: disable-error-code="override, overload-overlap, misc"
# ruff: noqa
# fmt: off
"""The language of clickgen programs, for editors. A program is only read, never run."""

from collections.abc import Callable, Iterable, Sequence
from typing import Final, Literal, Protocol, TypeAlias, TypeVar, overload

class _Condition:
    """Anything that a rung, a branch or an input can depend on."""
    def __bool__(self) -> bool: ...

class _NoCondition:
    """Anything that cannot be a condition."""
    def __bool__(self) -> None: ...
    def __eq__(self, other: object) -> _NotComparable: ...
    def __ne__(self, other: object) -> _NotComparable: ...

class _NotComparable(_NoCondition):
    """CLICK compares decimal numbers with each other, hexadecimal words with each other, and text with text."""

class _RangeComparison(_NoCondition):
    """A range compared with a value, for a search."""

class _AsNumber(_NoCondition):
    """Text on its way into a number."""

class _AsNumbers(_NoCondition):
    """A range of text on its way into numbers."""

class _AsText(_NoCondition):
    """A number on its way into text."""

class _Number:
    """Anything that a copy can turn into text."""
    def as_binary(self) -> _AsText:
        """The character whose code this is."""
    def as_text(
        self,
        *,
        suppress_zero: bool = True,
        exponential: bool = False,
        termination_code: int | str | None = None,
        pad: int | None = None,
    ) -> _AsText:
        """The digits: without leading zeros, or all of them with suppress_zero=False or pad=5."""

class _Characters:
    """Anything that a copy can turn into a number."""
    def as_value(self) -> _AsNumber:
        """The value that the digits have: "5" becomes 5."""
    def as_ascii(self) -> _AsNumber:
        """The code of the character: "5" becomes 53."""

class _Bit(_Condition):
    """One bit."""
    def __eq__(self, other: object) -> _NotComparable: ...
    def __ne__(self, other: object) -> _NotComparable: ...

class _BitRange(_Condition):
    """Bits in a row; as a condition, all of them."""

class _Decimal(_Condition, _Number):
    """A register with a decimal number."""
    @overload
    def __eq__(self, other: _Decimal | float) -> _Condition: ...
    @overload
    def __eq__(self, other: _DecimalRange) -> _RangeComparison: ...
    @overload
    def __eq__(self, other: object) -> _NotComparable: ...
    @overload
    def __ne__(self, other: _Decimal | float) -> _Condition: ...
    @overload
    def __ne__(self, other: _DecimalRange) -> _RangeComparison: ...
    @overload
    def __ne__(self, other: object) -> _NotComparable: ...
    def __lt__(self, other: _Decimal | float) -> _Condition: ...
    def __le__(self, other: _Decimal | float) -> _Condition: ...
    def __gt__(self, other: _Decimal | float) -> _Condition: ...
    def __ge__(self, other: _Decimal | float) -> _Condition: ...

class _DecimalRange(_NoCondition):
    """Registers in a row."""
    def __eq__(self, other: _Decimal | float) -> _RangeComparison: ...
    def __ne__(self, other: _Decimal | float) -> _RangeComparison: ...
    def __lt__(self, other: _Decimal | float) -> _RangeComparison: ...
    def __le__(self, other: _Decimal | float) -> _RangeComparison: ...
    def __gt__(self, other: _Decimal | float) -> _RangeComparison: ...
    def __ge__(self, other: _Decimal | float) -> _RangeComparison: ...

class _Hexadecimal(_Condition, _Number):
    """A register with a hexadecimal word."""
    @overload
    def __eq__(self, other: _Hexadecimal | int | str) -> _Condition: ...
    @overload
    def __eq__(self, other: _HexadecimalRange) -> _RangeComparison: ...
    @overload
    def __eq__(self, other: object) -> _NotComparable: ...
    @overload
    def __ne__(self, other: _Hexadecimal | int | str) -> _Condition: ...
    @overload
    def __ne__(self, other: _HexadecimalRange) -> _RangeComparison: ...
    @overload
    def __ne__(self, other: object) -> _NotComparable: ...
    def __lt__(self, other: _Hexadecimal | int | str) -> _Condition: ...
    def __le__(self, other: _Hexadecimal | int | str) -> _Condition: ...
    def __gt__(self, other: _Hexadecimal | int | str) -> _Condition: ...
    def __ge__(self, other: _Hexadecimal | int | str) -> _Condition: ...

class _HexadecimalRange(_NoCondition):
    """Registers in a row."""
    def __eq__(self, other: _Hexadecimal | int | str) -> _RangeComparison: ...
    def __ne__(self, other: _Hexadecimal | int | str) -> _RangeComparison: ...
    def __lt__(self, other: _Hexadecimal | int | str) -> _RangeComparison: ...
    def __le__(self, other: _Hexadecimal | int | str) -> _RangeComparison: ...
    def __gt__(self, other: _Hexadecimal | int | str) -> _RangeComparison: ...
    def __ge__(self, other: _Hexadecimal | int | str) -> _RangeComparison: ...

class _Text(_NoCondition, _Characters):
    """A register with a character."""
    @overload
    def __eq__(self, other: _Text | str) -> _Condition: ...
    @overload
    def __eq__(self, other: _TextRange) -> _RangeComparison: ...
    @overload
    def __eq__(self, other: object) -> _NotComparable: ...
    @overload
    def __ne__(self, other: _Text | str) -> _Condition: ...
    @overload
    def __ne__(self, other: _TextRange) -> _RangeComparison: ...
    @overload
    def __ne__(self, other: object) -> _NotComparable: ...
    def __lt__(self, other: _Text | str) -> _Condition: ...
    def __le__(self, other: _Text | str) -> _Condition: ...
    def __gt__(self, other: _Text | str) -> _Condition: ...
    def __ge__(self, other: _Text | str) -> _Condition: ...

class _TextRange(_NoCondition):
    """Registers in a row."""
    def as_value(self) -> _AsNumbers:
        """The value of each digit: "5" becomes 5."""
    def as_ascii(self) -> _AsNumbers:
        """The code of each character: "5" becomes 53."""
    def __eq__(self, other: _Text | str) -> _RangeComparison: ...
    def __ne__(self, other: _Text | str) -> _RangeComparison: ...
    def __lt__(self, other: _Text | str) -> _RangeComparison: ...
    def __le__(self, other: _Text | str) -> _RangeComparison: ...
    def __gt__(self, other: _Text | str) -> _RangeComparison: ...
    def __ge__(self, other: _Text | str) -> _RangeComparison: ...

class _InX:
    """Addresses in X, one or several."""
    @property
    def immediate(self) -> _XImmediate:
        """The terminal itself, past the image of the scan."""

class _X(_Bit, _InX):
    """An address in X: input bits."""

class _XRange(_BitRange, _InX):
    """Addresses in X in a row."""

class _XBlock(_XRange):
    """A block of addresses in X."""
    @overload
    def __getitem__(self, key: int, /) -> _X: ...
    @overload
    def __getitem__(self, key: slice[int | None, int | None, int | None], /) -> _XRange: ...

class _XName(_X, _XBlock):
    """A nickname in X, or a block."""

class _XImmediate(_Condition):
    """Terminals in X, past the image of the scan."""

class _InY:
    """Addresses in Y, one or several."""
    @property
    def immediate(self) -> _YImmediate:
        """The terminal itself, past the image of the scan."""

class _Y(_Bit, _InY):
    """An address in Y: output bits."""

class _YRange(_BitRange, _InY):
    """Addresses in Y in a row."""

class _YBlock(_YRange):
    """A block of addresses in Y."""
    @overload
    def __getitem__(self, key: int, /) -> _Y: ...
    @overload
    def __getitem__(self, key: slice[int | None, int | None, int | None], /) -> _YRange: ...

class _YName(_Y, _YBlock):
    """A nickname in Y, or a block."""

class _YImmediate(_NoCondition):
    """Terminals in Y, past the image of the scan."""

class _InC:
    """Addresses in C, one or several."""

class _C(_Bit, _InC):
    """An address in C: control relays."""

class _CRange(_BitRange, _InC):
    """Addresses in C in a row."""

class _CBlock(_CRange):
    """A block of addresses in C."""
    @overload
    def __getitem__(self, key: int, /) -> _C: ...
    @overload
    def __getitem__(self, key: slice[int | None, int | None, int | None], /) -> _CRange: ...

class _CName(_C, _CBlock):
    """A nickname in C, or a block."""

class _CPointer(_NoCondition):
    """The C address whose number a DS register holds."""

class _InT:
    """Addresses in T, one or several."""

class _T(_Bit, _InT):
    """An address in T: timer bits."""

class _TRange(_BitRange, _InT):
    """Addresses in T in a row."""

class _TBlock(_TRange):
    """A block of addresses in T."""
    @overload
    def __getitem__(self, key: int, /) -> _T: ...
    @overload
    def __getitem__(self, key: slice[int | None, int | None, int | None], /) -> _TRange: ...

class _TName(_T, _TBlock):
    """A nickname in T, or a block."""

class _InCT:
    """Addresses in CT, one or several."""

class _CT(_Bit, _InCT):
    """An address in CT: counter bits."""

class _CTRange(_BitRange, _InCT):
    """Addresses in CT in a row."""

class _CTBlock(_CTRange):
    """A block of addresses in CT."""
    @overload
    def __getitem__(self, key: int, /) -> _CT: ...
    @overload
    def __getitem__(self, key: slice[int | None, int | None, int | None], /) -> _CTRange: ...

class _CTName(_CT, _CTBlock):
    """A nickname in CT, or a block."""

class _InSC:
    """Addresses in SC, one or several."""

class _SC(_Bit, _InSC):
    """An address in SC: system control relays."""

class _SCRange(_BitRange, _InSC):
    """Addresses in SC in a row."""

class _SCBlock(_SCRange):
    """A block of addresses in SC."""
    @overload
    def __getitem__(self, key: int, /) -> _SC: ...
    @overload
    def __getitem__(self, key: slice[int | None, int | None, int | None], /) -> _SCRange: ...

class _SCName(_SC, _SCBlock):
    """A nickname in SC, or a block."""

class _InDS:
    """Addresses in DS, one or several."""

class _DS(_Decimal, _InDS):
    """An address in DS: 16-bit integers."""

class _DSRange(_DecimalRange, _InDS):
    """Addresses in DS in a row."""

class _DSBlock(_DSRange):
    """A block of addresses in DS."""
    @overload
    def __getitem__(self, key: int, /) -> _DS: ...
    @overload
    def __getitem__(self, key: slice[int | None, int | None, int | None], /) -> _DSRange: ...

class _DSName(_DS, _DSBlock):
    """A nickname in DS, or a block."""

class _DSPointer(_NoCondition, _Number):
    """The DS address whose number a DS register holds."""

class _InDD:
    """Addresses in DD, one or several."""

class _DD(_Decimal, _InDD):
    """An address in DD: 32-bit integers."""

class _DDRange(_DecimalRange, _InDD):
    """Addresses in DD in a row."""

class _DDBlock(_DDRange):
    """A block of addresses in DD."""
    @overload
    def __getitem__(self, key: int, /) -> _DD: ...
    @overload
    def __getitem__(self, key: slice[int | None, int | None, int | None], /) -> _DDRange: ...

class _DDName(_DD, _DDBlock):
    """A nickname in DD, or a block."""

class _DDPointer(_NoCondition, _Number):
    """The DD address whose number a DS register holds."""

class _InDH:
    """Addresses in DH, one or several."""

class _DH(_Hexadecimal, _InDH):
    """An address in DH: hexadecimal words."""

class _DHRange(_HexadecimalRange, _InDH):
    """Addresses in DH in a row."""

class _DHBlock(_DHRange):
    """A block of addresses in DH."""
    @overload
    def __getitem__(self, key: int, /) -> _DH: ...
    @overload
    def __getitem__(self, key: slice[int | None, int | None, int | None], /) -> _DHRange: ...

class _DHName(_DH, _DHBlock):
    """A nickname in DH, or a block."""

class _DHPointer(_NoCondition, _Number):
    """The DH address whose number a DS register holds."""

class _InDF:
    """Addresses in DF, one or several."""

class _DF(_Decimal, _InDF):
    """An address in DF: floating-point numbers."""

class _DFRange(_DecimalRange, _InDF):
    """Addresses in DF in a row."""

class _DFBlock(_DFRange):
    """A block of addresses in DF."""
    @overload
    def __getitem__(self, key: int, /) -> _DF: ...
    @overload
    def __getitem__(self, key: slice[int | None, int | None, int | None], /) -> _DFRange: ...

class _DFName(_DF, _DFBlock):
    """A nickname in DF, or a block."""

class _DFPointer(_NoCondition, _Number):
    """The DF address whose number a DS register holds."""

class _InXD:
    """Addresses in XD, one or several."""

class _XD(_Hexadecimal, _InXD):
    """An address in XD: input words."""

class _XDRange(_HexadecimalRange, _InXD):
    """Addresses in XD in a row."""

class _XDBlock(_XDRange):
    """A block of addresses in XD."""
    @overload
    def __getitem__(self, key: int, /) -> _XD: ...
    @overload
    def __getitem__(self, key: slice[int | None, int | None, int | None], /) -> _XDRange: ...

class _XDName(_XD, _XDBlock):
    """A nickname in XD, or a block."""

class _XDPointer(_NoCondition, _Number):
    """The XD address whose number a DS register holds."""

class _InYD:
    """Addresses in YD, one or several."""

class _YD(_Hexadecimal, _InYD):
    """An address in YD: output words."""

class _YDRange(_HexadecimalRange, _InYD):
    """Addresses in YD in a row."""

class _YDBlock(_YDRange):
    """A block of addresses in YD."""
    @overload
    def __getitem__(self, key: int, /) -> _YD: ...
    @overload
    def __getitem__(self, key: slice[int | None, int | None, int | None], /) -> _YDRange: ...

class _YDName(_YD, _YDBlock):
    """A nickname in YD, or a block."""

class _YDPointer(_NoCondition, _Number):
    """The YD address whose number a DS register holds."""

class _InTD:
    """Addresses in TD, one or several."""

class _TD(_Decimal, _InTD):
    """An address in TD: timer current values."""

class _TDRange(_DecimalRange, _InTD):
    """Addresses in TD in a row."""

class _TDBlock(_TDRange):
    """A block of addresses in TD."""
    @overload
    def __getitem__(self, key: int, /) -> _TD: ...
    @overload
    def __getitem__(self, key: slice[int | None, int | None, int | None], /) -> _TDRange: ...

class _TDName(_TD, _TDBlock):
    """A nickname in TD, or a block."""

class _TDPointer(_NoCondition, _Number):
    """The TD address whose number a DS register holds."""

class _InCTD:
    """Addresses in CTD, one or several."""

class _CTD(_Decimal, _InCTD):
    """An address in CTD: counter current values."""

class _CTDRange(_DecimalRange, _InCTD):
    """Addresses in CTD in a row."""

class _CTDBlock(_CTDRange):
    """A block of addresses in CTD."""
    @overload
    def __getitem__(self, key: int, /) -> _CTD: ...
    @overload
    def __getitem__(self, key: slice[int | None, int | None, int | None], /) -> _CTDRange: ...

class _CTDName(_CTD, _CTDBlock):
    """A nickname in CTD, or a block."""

class _CTDPointer(_NoCondition, _Number):
    """The CTD address whose number a DS register holds."""

class _InSD:
    """Addresses in SD, one or several."""

class _SD(_Decimal, _InSD):
    """An address in SD: system data registers."""

class _SDRange(_DecimalRange, _InSD):
    """Addresses in SD in a row."""

class _SDBlock(_SDRange):
    """A block of addresses in SD."""
    @overload
    def __getitem__(self, key: int, /) -> _SD: ...
    @overload
    def __getitem__(self, key: slice[int | None, int | None, int | None], /) -> _SDRange: ...

class _SDName(_SD, _SDBlock):
    """A nickname in SD, or a block."""

class _InTXT:
    """Addresses in TXT, one or several."""

class _TXT(_Text, _InTXT):
    """An address in TXT: text characters."""

class _TXTRange(_TextRange, _InTXT):
    """Addresses in TXT in a row."""

class _TXTBlock(_TXTRange):
    """A block of addresses in TXT."""
    @overload
    def __getitem__(self, key: int, /) -> _TXT: ...
    @overload
    def __getitem__(self, key: slice[int | None, int | None, int | None], /) -> _TXTRange: ...

class _TXTName(_TXT, _TXTBlock):
    """A nickname in TXT, or a block."""

class _TXTPointer(_NoCondition, _Characters):
    """The TXT address whose number a DS register holds."""

# 5 == ds.A is a bool for Python, because its left side decides.
_Given: TypeAlias = _Condition | bool
_Series: TypeAlias = _Given | Sequence[_Series]
_Pin: TypeAlias = Callable[[], _Given]
_Contact: TypeAlias = _Bit | _BitRange | _XImmediate

def all(condition: _Given, /, *conditions: _Given) -> _Condition:
    """Conditions in series: every one of them holds."""
def any(condition: _Given, /, *conditions: _Given) -> _Condition:
    """Conditions in parallel: at least one of them holds."""
def nc(bit: _Contact, /) -> _Condition:
    """A normally closed contact: the bit is off; every bit of a range is off."""
def re(bit: _Bit, /) -> _Condition:
    """A rising edge: the bit has just come on."""
def fe(bit: _Bit, /) -> _Condition:
    """A falling edge: the bit has just gone off."""

class _XBank(_NoCondition):
    """X: input bits, 1..16, 21..36, 101..116, 201..216, 301..316, 401..416, 501..516, 601..616, 701..716, 801..816"""
    def __getattr__(self, nickname: str) -> _XName:
        """The address with this nickname."""
    @overload
    def __getitem__(self, key: int, /) -> _X: ...
    @overload
    def __getitem__(self, key: str, /) -> _XName: ...
    @overload
    def __getitem__(self, key: slice[int, int, int | None], /) -> _XRange: ...

class _YBank(_NoCondition):
    """Y: output bits, 1..16, 21..36, 101..116, 201..216, 301..316, 401..416, 501..516, 601..616, 701..716, 801..816"""
    def __getattr__(self, nickname: str) -> _YName:
        """The address with this nickname."""
    @overload
    def __getitem__(self, key: int, /) -> _Y: ...
    @overload
    def __getitem__(self, key: str, /) -> _YName: ...
    @overload
    def __getitem__(self, key: slice[int, int, int | None], /) -> _YRange: ...

class _CBank(_NoCondition):
    """C: control relays, 1..2000"""
    def __getattr__(self, nickname: str) -> _CName:
        """The address with this nickname."""
    @overload
    def __getitem__(self, key: int, /) -> _C: ...
    @overload
    def __getitem__(self, key: str, /) -> _CName: ...
    @overload
    def __getitem__(self, key: slice[int, int, int | None], /) -> _CRange: ...
    @overload
    def __getitem__(self, key: _DS, /) -> _CPointer: ...

class _TBank(_NoCondition):
    """T: timer bits, 1..500"""
    def __getattr__(self, nickname: str) -> _TName:
        """The address with this nickname."""
    @overload
    def __getitem__(self, key: int, /) -> _T: ...
    @overload
    def __getitem__(self, key: str, /) -> _TName: ...
    @overload
    def __getitem__(self, key: slice[int, int, int | None], /) -> _TRange: ...

class _CTBank(_NoCondition):
    """CT: counter bits, 1..250, retentive"""
    def __getattr__(self, nickname: str) -> _CTName:
        """The address with this nickname."""
    @overload
    def __getitem__(self, key: int, /) -> _CT: ...
    @overload
    def __getitem__(self, key: str, /) -> _CTName: ...
    @overload
    def __getitem__(self, key: slice[int, int, int | None], /) -> _CTRange: ...

class _SCBank(_NoCondition):
    """SC: system control relays, 1..1000"""
    _100ms_Clock: Final[_SC]
    """SC5: CLICK's own"""
    _10ms_Clock: Final[_SC]
    """SC4: CLICK's own"""
    _1hour_Clock: Final[_SC]
    """SC9: CLICK's own"""
    _1min_Clock: Final[_SC]
    """SC8: CLICK's own"""
    _1sec_Clock: Final[_SC]
    """SC7: CLICK's own"""
    _1st_SCAN: Final[_SC]
    """SC2: CLICK's own"""
    _500ms_Clock: Final[_SC]
    """SC6: CLICK's own"""
    _Address_Error: Final[_SC]
    """SC44: CLICK's own"""
    _Always_ON: Final[_SC]
    """SC1: CLICK's own"""
    _Battery_Installed: Final[_SC]
    """SC203: CLICK's own"""
    _BT_Activate_Pairing: Final[_SC]
    """SC61: CLICK's own"""
    _BT_Disable_Pairing: Final[_SC]
    """SC60: CLICK's own"""
    _BT_Paired_Devices: Final[_SC]
    """SC62: CLICK's own"""
    _BT_Pairing_SW_State: Final[_SC]
    """SC63: CLICK's own"""
    _C2DCM_FW_Ver_Error: Final[_SC]
    """SC32: CLICK's own"""
    _Division_Error: Final[_SC]
    """SC40: CLICK's own"""
    _EIP_Con1_ConOnline: Final[_SC]
    """SC111: CLICK's own"""
    _EIP_Con1_Error: Final[_SC]
    """SC112: CLICK's own"""
    _EIP_Con1_Originator_Run: Final[_SC]
    """SC113: CLICK's own"""
    _EIP_Con2_ConOnline: Final[_SC]
    """SC114: CLICK's own"""
    _EIP_Con2_Error: Final[_SC]
    """SC115: CLICK's own"""
    _EIP_Con2_Originator_Run: Final[_SC]
    """SC116: CLICK's own"""
    _Fixed_Scan_Mode: Final[_SC]
    """SC202: CLICK's own"""
    _Math_Operation_Error: Final[_SC]
    """SC46: CLICK's own"""
    _Mode_Switch: Final[_SC]
    """SC10: CLICK's own"""
    _Out_of_Range: Final[_SC]
    """SC43: CLICK's own"""
    _Password_Failure_Detect: Final[_SC]
    """SC131: CLICK's own"""
    _Password_Locked_Out: Final[_SC]
    """SC132: CLICK's own"""
    _PLC_Mode: Final[_SC]
    """SC11: CLICK's own"""
    _PLC_Mode_Change_to_STOP: Final[_SC]
    """SC50: CLICK's own"""
    _Port1_AL_Denied_Flag: Final[_SC]
    """SC134: CLICK's own"""
    _Port1_AL_Enabled: Final[_SC]
    """SC133: CLICK's own"""
    _Port_1_100MBIT_Flag: Final[_SC]
    """SC95: CLICK's own"""
    _Port_1_Connection_Limit: Final[_SC]
    """SC92: CLICK's own"""
    _Port_1_DHCP_Enabled: Final[_SC]
    """SC96: CLICK's own"""
    _Port_1_DNS_Error: Final[_SC]
    """SC98: CLICK's own"""
    _Port_1_DNS_Success: Final[_SC]
    """SC97: CLICK's own"""
    _Port_1_Error_Flag: Final[_SC]
    """SC91: CLICK's own"""
    _Port_1_IP_Resolved: Final[_SC]
    """SC93: CLICK's own"""
    _Port_1_Link_Flag: Final[_SC]
    """SC94: CLICK's own"""
    _Port_1_Ready_Flag: Final[_SC]
    """SC90: CLICK's own"""
    _Port_2_Error_Flag: Final[_SC]
    """SC101: CLICK's own"""
    _Port_2_Ready_Flag: Final[_SC]
    """SC100: CLICK's own"""
    _Port_3_Error_Flag: Final[_SC]
    """SC103: CLICK's own"""
    _Port_3_Ready_Flag: Final[_SC]
    """SC102: CLICK's own"""
    _PTO_Axis1_Ready_Flag: Final[_SC]
    """SC150: CLICK's own"""
    _PTO_Axis2_Ready_Flag: Final[_SC]
    """SC151: CLICK's own"""
    _PTO_Axis3_Ready_Flag: Final[_SC]
    """SC152: CLICK's own"""
    _RemotPLC_Enabled: Final[_SC]
    """SC64: CLICK's own"""
    _RTC_Date_Change: Final[_SC]
    """SC53: CLICK's own"""
    _RTC_Date_Change_Error: Final[_SC]
    """SC54: CLICK's own"""
    _RTC_Time_Change: Final[_SC]
    """SC55: CLICK's own"""
    _RTC_Time_Change_Error: Final[_SC]
    """SC56: CLICK's own"""
    _S0_P1_Error_Flag: Final[_SC]
    """SC141: CLICK's own"""
    _S0_P1_Ready_Flag: Final[_SC]
    """SC140: CLICK's own"""
    _S0_P2_Error_Flag: Final[_SC]
    """SC143: CLICK's own"""
    _S0_P2_Ready_Flag: Final[_SC]
    """SC142: CLICK's own"""
    _S0INT_100M_Bit_Flag: Final[_SC]
    """SC311: CLICK's own"""
    _S0INT_Application_Flag: Final[_SC]
    """SC315: CLICK's own"""
    _S0INT_DHCP_Enabled: Final[_SC]
    """SC312: CLICK's own"""
    _S0INT_Error_Flag: Final[_SC]
    """SC302: CLICK's own"""
    _S0INT_IP_Resolved: Final[_SC]
    """SC309: CLICK's own"""
    _S0INT_Link_Flag: Final[_SC]
    """SC310: CLICK's own"""
    _S0INT_Ready_Flag: Final[_SC]
    """SC301: CLICK's own"""
    _S0INT_Reset: Final[_SC]
    """SC303: CLICK's own"""
    _S0INT_SD_Copy_System: Final[_SC]
    """SC306: CLICK's own"""
    _S0INT_SD_Delete_All: Final[_SC]
    """SC305: CLICK's own"""
    _S0INT_SD_EJECT: Final[_SC]
    """SC304: CLICK's own"""
    _S0INT_SD_Ready_To_Use: Final[_SC]
    """SC307: CLICK's own"""
    _S1_P1_Error_Flag: Final[_SC]
    """SC145: CLICK's own"""
    _S1_P1_Ready_Flag: Final[_SC]
    """SC144: CLICK's own"""
    _S1_P2_Error_Flag: Final[_SC]
    """SC147: CLICK's own"""
    _S1_P2_Ready_Flag: Final[_SC]
    """SC146: CLICK's own"""
    _S1INT_100M_Bit_Flag: Final[_SC]
    """SC331: CLICK's own"""
    _S1INT_Application_Flag: Final[_SC]
    """SC335: CLICK's own"""
    _S1INT_Error_Flag: Final[_SC]
    """SC322: CLICK's own"""
    _S1INT_IP_Resolved: Final[_SC]
    """SC329: CLICK's own"""
    _S1INT_Link_Flag: Final[_SC]
    """SC330: CLICK's own"""
    _S1INT_Ready_Flag: Final[_SC]
    """SC321: CLICK's own"""
    _S1INT_Reset: Final[_SC]
    """SC323: CLICK's own"""
    _S1INT_SD_Copy_System: Final[_SC]
    """SC326: CLICK's own"""
    _S1INT_SD_Delete_All: Final[_SC]
    """SC325: CLICK's own"""
    _S1INT_SD_EJECT: Final[_SC]
    """SC324: CLICK's own"""
    _S1INT_SD_Ready_To_Use: Final[_SC]
    """SC327: CLICK's own"""
    _SCAN_Clock: Final[_SC]
    """SC3: CLICK's own"""
    _SD_Copy_System: Final[_SC]
    """SC67: CLICK's own"""
    _SD_Delete_All: Final[_SC]
    """SC66: CLICK's own"""
    _SD_Eject: Final[_SC]
    """SC65: CLICK's own"""
    _SD_Error: Final[_SC]
    """SC70: CLICK's own"""
    _SD_Ready_To_Use: Final[_SC]
    """SC68: CLICK's own"""
    _SD_Write_Status: Final[_SC]
    """SC69: CLICK's own"""
    _Sub_CPU_FW_Ver_Error: Final[_SC]
    """SC31: CLICK's own"""
    _Sub_CPU_Reset: Final[_SC]
    """SC76: CLICK's own"""
    _Watchdog_Timer_Reset: Final[_SC]
    """SC51: CLICK's own"""
    _WLAN_AL_Denied_Flag: Final[_SC]
    """SC136: CLICK's own"""
    _WLAN_AL_Enabled: Final[_SC]
    """SC135: CLICK's own"""
    _WLAN_Connected: Final[_SC]
    """SC84: CLICK's own"""
    _WLAN_Connection_Limit: Final[_SC]
    """SC82: CLICK's own"""
    _WLAN_DHCP_Enabled: Final[_SC]
    """SC86: CLICK's own"""
    _WLAN_DNS_Error: Final[_SC]
    """SC88: CLICK's own"""
    _WLAN_DNS_Success: Final[_SC]
    """SC87: CLICK's own"""
    _WLAN_Error_Flag: Final[_SC]
    """SC81: CLICK's own"""
    _WLAN_IP_Resolved: Final[_SC]
    """SC83: CLICK's own"""
    _WLAN_Ready_Flag: Final[_SC]
    """SC80: CLICK's own"""
    _WLAN_Reset: Final[_SC]
    """SC75: CLICK's own"""
    def __getattr__(self, nickname: str) -> _SCName:
        """The address with this nickname."""
    @overload
    def __getitem__(self, key: int, /) -> _SC: ...
    @overload
    def __getitem__(self, key: str, /) -> _SCName: ...
    @overload
    def __getitem__(self, key: slice[int, int, int | None], /) -> _SCRange: ...

class _DSBank(_NoCondition):
    """DS: 16-bit integers, 1..4500, retentive"""
    def __getattr__(self, nickname: str) -> _DSName:
        """The address with this nickname."""
    @overload
    def __getitem__(self, key: int, /) -> _DS: ...
    @overload
    def __getitem__(self, key: str, /) -> _DSName: ...
    @overload
    def __getitem__(self, key: slice[int, int, int | None], /) -> _DSRange: ...
    @overload
    def __getitem__(self, key: _DS, /) -> _DSPointer: ...

class _DDBank(_NoCondition):
    """DD: 32-bit integers, 1..1000, retentive"""
    def __getattr__(self, nickname: str) -> _DDName:
        """The address with this nickname."""
    @overload
    def __getitem__(self, key: int, /) -> _DD: ...
    @overload
    def __getitem__(self, key: str, /) -> _DDName: ...
    @overload
    def __getitem__(self, key: slice[int, int, int | None], /) -> _DDRange: ...
    @overload
    def __getitem__(self, key: _DS, /) -> _DDPointer: ...

class _DHBank(_NoCondition):
    """DH: hexadecimal words, 1..500, retentive"""
    def __getattr__(self, nickname: str) -> _DHName:
        """The address with this nickname."""
    @overload
    def __getitem__(self, key: int, /) -> _DH: ...
    @overload
    def __getitem__(self, key: str, /) -> _DHName: ...
    @overload
    def __getitem__(self, key: slice[int, int, int | None], /) -> _DHRange: ...
    @overload
    def __getitem__(self, key: _DS, /) -> _DHPointer: ...

class _DFBank(_NoCondition):
    """DF: floating-point numbers, 1..500, retentive"""
    def __getattr__(self, nickname: str) -> _DFName:
        """The address with this nickname."""
    @overload
    def __getitem__(self, key: int, /) -> _DF: ...
    @overload
    def __getitem__(self, key: str, /) -> _DFName: ...
    @overload
    def __getitem__(self, key: slice[int, int, int | None], /) -> _DFRange: ...
    @overload
    def __getitem__(self, key: _DS, /) -> _DFPointer: ...

class _XDBank(_NoCondition):
    """XD: input words, 0..8"""
    def __getattr__(self, nickname: str) -> _XDName:
        """The address with this nickname."""
    @overload
    def __getitem__(self, key: int, /) -> _XD: ...
    @overload
    def __getitem__(self, key: str, /) -> _XDName: ...
    @overload
    def __getitem__(self, key: slice[int, int, int | None], /) -> _XDRange: ...
    @overload
    def __getitem__(self, key: _DS, /) -> _XDPointer: ...

class _YDBank(_NoCondition):
    """YD: output words, 0..8"""
    def __getattr__(self, nickname: str) -> _YDName:
        """The address with this nickname."""
    @overload
    def __getitem__(self, key: int, /) -> _YD: ...
    @overload
    def __getitem__(self, key: str, /) -> _YDName: ...
    @overload
    def __getitem__(self, key: slice[int, int, int | None], /) -> _YDRange: ...
    @overload
    def __getitem__(self, key: _DS, /) -> _YDPointer: ...

class _TDBank(_NoCondition):
    """TD: timer current values, 1..500"""
    def __getattr__(self, nickname: str) -> _TDName:
        """The address with this nickname."""
    @overload
    def __getitem__(self, key: int, /) -> _TD: ...
    @overload
    def __getitem__(self, key: str, /) -> _TDName: ...
    @overload
    def __getitem__(self, key: slice[int, int, int | None], /) -> _TDRange: ...
    @overload
    def __getitem__(self, key: _DS, /) -> _TDPointer: ...

class _CTDBank(_NoCondition):
    """CTD: counter current values, 1..250, retentive"""
    def __getattr__(self, nickname: str) -> _CTDName:
        """The address with this nickname."""
    @overload
    def __getitem__(self, key: int, /) -> _CTD: ...
    @overload
    def __getitem__(self, key: str, /) -> _CTDName: ...
    @overload
    def __getitem__(self, key: slice[int, int, int | None], /) -> _CTDRange: ...
    @overload
    def __getitem__(self, key: _DS, /) -> _CTDPointer: ...
    def __call__(self, counter: _CT, setpoint: _DS | _DD | int, reset: _Pin | None = None) -> _CtdBox:
        """Count down.

        Example: ctd(ct.Left, setpoint=50, reset=lambda: c.Refilled)
        """

class _SDBank(_NoCondition):
    """SD: system data registers, 1..1000"""
    _BT_Paired_Device_Count: Final[_SD]
    """SD62: CLICK's own"""
    _CPU_AD_CH1_Value: Final[_SD]
    """SD71: CLICK's own"""
    _CPU_AD_CH2_Value: Final[_SD]
    """SD72: CLICK's own"""
    _CPU_DA_CH1_Value: Final[_SD]
    """SD75: CLICK's own"""
    _CPU_DA_CH2_Value: Final[_SD]
    """SD76: CLICK's own"""
    _Current_Scan_Time: Final[_SD]
    """SD10: CLICK's own"""
    _EIP_Con1_DisConCount: Final[_SD]
    """SD107: CLICK's own"""
    _EIP_Con1_ExtendedStatus: Final[_SD]
    """SD105: CLICK's own"""
    _EIP_Con1_GeneralStatus: Final[_SD]
    """SD104: CLICK's own"""
    _EIP_Con1_LostCount: Final[_SD]
    """SD106: CLICK's own"""
    _EIP_Con1_No_Comm_Time: Final[_SD]
    """SD108: CLICK's own"""
    _EIP_Con1_NodeStatus: Final[_SD]
    """SD103: CLICK's own"""
    _EIP_Con2_DisConCount: Final[_SD]
    """SD113: CLICK's own"""
    _EIP_Con2_ExtendedStatus: Final[_SD]
    """SD111: CLICK's own"""
    _EIP_Con2_GeneralStatus: Final[_SD]
    """SD110: CLICK's own"""
    _EIP_Con2_LostCount: Final[_SD]
    """SD112: CLICK's own"""
    _EIP_Con2_No_Comm_Time: Final[_SD]
    """SD114: CLICK's own"""
    _EIP_Con2_NodeStatus: Final[_SD]
    """SD109: CLICK's own"""
    _EIP_IdentityStatus: Final[_SD]
    """SD102: CLICK's own"""
    _EIP_ModuleStatus: Final[_SD]
    """SD101: CLICK's own"""
    _Firmware_Version_H: Final[_SD]
    """SD6: CLICK's own"""
    _Firmware_Version_L: Final[_SD]
    """SD5: CLICK's own"""
    _Fixed_Scan_Time_Setup: Final[_SD]
    """SD13: CLICK's own"""
    _Interrupt_Scan_Time: Final[_SD]
    """SD14: CLICK's own"""
    _Maximum_Scan_Time: Final[_SD]
    """SD12: CLICK's own"""
    _Minimum_Scan_Time: Final[_SD]
    """SD11: CLICK's own"""
    _Password_Failed_Count: Final[_SD]
    """SD131: CLICK's own"""
    _PLC_Error_Code: Final[_SD]
    """SD1: CLICK's own"""
    _Port1_Default_Gateway1: Final[_SD]
    """SD88: CLICK's own"""
    _Port1_Default_Gateway2: Final[_SD]
    """SD89: CLICK's own"""
    _Port1_Default_Gateway3: Final[_SD]
    """SD90: CLICK's own"""
    _Port1_Default_Gateway4: Final[_SD]
    """SD91: CLICK's own"""
    _Port1_IP_Address1: Final[_SD]
    """SD80: CLICK's own"""
    _Port1_IP_Address2: Final[_SD]
    """SD81: CLICK's own"""
    _Port1_IP_Address3: Final[_SD]
    """SD82: CLICK's own"""
    _Port1_IP_Address4: Final[_SD]
    """SD83: CLICK's own"""
    _Port1_MAC_Address1: Final[_SD]
    """SD188: CLICK's own"""
    _Port1_MAC_Address2: Final[_SD]
    """SD189: CLICK's own"""
    _Port1_MAC_Address3: Final[_SD]
    """SD190: CLICK's own"""
    _Port1_MAC_Address4: Final[_SD]
    """SD191: CLICK's own"""
    _Port1_MAC_Address5: Final[_SD]
    """SD192: CLICK's own"""
    _Port1_MAC_Address6: Final[_SD]
    """SD193: CLICK's own"""
    _Port1_No_Comm_Time: Final[_SD]
    """SD41: CLICK's own"""
    _Port1_Rcv_Pkt_High_Cnt: Final[_SD]
    """SD42: CLICK's own"""
    _Port1_Received_Data_Len: Final[_SD]
    """SD40: CLICK's own"""
    _Port1_Subnet_Mask1: Final[_SD]
    """SD84: CLICK's own"""
    _Port1_Subnet_Mask2: Final[_SD]
    """SD85: CLICK's own"""
    _Port1_Subnet_Mask3: Final[_SD]
    """SD86: CLICK's own"""
    _Port1_Subnet_Mask4: Final[_SD]
    """SD87: CLICK's own"""
    _Port2_No_Comm_Time: Final[_SD]
    """SD51: CLICK's own"""
    _Port2_Received_Data_Len: Final[_SD]
    """SD50: CLICK's own"""
    _Port3_No_Comm_Time: Final[_SD]
    """SD61: CLICK's own"""
    _Port3_Received_Data_Len: Final[_SD]
    """SD60: CLICK's own"""
    _RTC_Day: Final[_SD]
    """SD22: CLICK's own"""
    _RTC_Day_of_The_Week: Final[_SD]
    """SD23: CLICK's own"""
    _RTC_Hour: Final[_SD]
    """SD24: CLICK's own"""
    _RTC_Minute: Final[_SD]
    """SD25: CLICK's own"""
    _RTC_Month: Final[_SD]
    """SD21: CLICK's own"""
    _RTC_New_Day: Final[_SD]
    """SD32: CLICK's own"""
    _RTC_New_Hour: Final[_SD]
    """SD34: CLICK's own"""
    _RTC_New_Minute: Final[_SD]
    """SD35: CLICK's own"""
    _RTC_New_Month: Final[_SD]
    """SD31: CLICK's own"""
    _RTC_New_Second: Final[_SD]
    """SD36: CLICK's own"""
    _RTC_Second: Final[_SD]
    """SD26: CLICK's own"""
    _S0_Application_USAGE: Final[_SD]
    """SD351: CLICK's own"""
    _S0_CPU_USAGE: Final[_SD]
    """SD306: CLICK's own"""
    _S0_DataUpdateCycleTime: Final[_SD]
    """SD353: CLICK's own"""
    _S0_ERROR_CODE: Final[_SD]
    """SD308: CLICK's own"""
    _S0_ETH_Default_Gateway1: Final[_SD]
    """SD323: CLICK's own"""
    _S0_ETH_Default_Gateway2: Final[_SD]
    """SD324: CLICK's own"""
    _S0_ETH_Default_Gateway3: Final[_SD]
    """SD325: CLICK's own"""
    _S0_ETH_Default_Gateway4: Final[_SD]
    """SD326: CLICK's own"""
    _S0_ETH_IP_Address1: Final[_SD]
    """SD315: CLICK's own"""
    _S0_ETH_IP_Address2: Final[_SD]
    """SD316: CLICK's own"""
    _S0_ETH_IP_Address3: Final[_SD]
    """SD317: CLICK's own"""
    _S0_ETH_IP_Address4: Final[_SD]
    """SD318: CLICK's own"""
    _S0_ETH_MAC_Address1: Final[_SD]
    """SD327: CLICK's own"""
    _S0_ETH_MAC_Address2: Final[_SD]
    """SD328: CLICK's own"""
    _S0_ETH_MAC_Address3: Final[_SD]
    """SD329: CLICK's own"""
    _S0_ETH_MAC_Address4: Final[_SD]
    """SD330: CLICK's own"""
    _S0_ETH_MAC_Address5: Final[_SD]
    """SD331: CLICK's own"""
    _S0_ETH_MAC_Address6: Final[_SD]
    """SD332: CLICK's own"""
    _S0_ETH_Subnet_Mask1: Final[_SD]
    """SD319: CLICK's own"""
    _S0_ETH_Subnet_Mask2: Final[_SD]
    """SD320: CLICK's own"""
    _S0_ETH_Subnet_Mask3: Final[_SD]
    """SD321: CLICK's own"""
    _S0_ETH_Subnet_Mask4: Final[_SD]
    """SD322: CLICK's own"""
    _S0_Hotfix_Version: Final[_SD]
    """SD304: CLICK's own"""
    _S0_Major_Version: Final[_SD]
    """SD302: CLICK's own"""
    _S0_MEM_USAGE: Final[_SD]
    """SD307: CLICK's own"""
    _S0_Minor_Version: Final[_SD]
    """SD303: CLICK's own"""
    _S0_ModuleId: Final[_SD]
    """SD301: CLICK's own"""
    _S0_P1_No_Comm_Time: Final[_SD]
    """SD141: CLICK's own"""
    _S0_P1_Received_Data_Len: Final[_SD]
    """SD140: CLICK's own"""
    _S0_P2_No_Comm_Time: Final[_SD]
    """SD143: CLICK's own"""
    _S0_P2_Received_Data_Len: Final[_SD]
    """SD142: CLICK's own"""
    _S0_Release_Version: Final[_SD]
    """SD305: CLICK's own"""
    _S0_SD_FREE_MEM_H: Final[_SD]
    """SD312: CLICK's own"""
    _S0_SD_FREE_MEM_L: Final[_SD]
    """SD311: CLICK's own"""
    _S0_SD_TOTAL_MEM_H: Final[_SD]
    """SD310: CLICK's own"""
    _S0_SD_TOTAL_MEM_L: Final[_SD]
    """SD309: CLICK's own"""
    _S0_SD_USED_MEM_H: Final[_SD]
    """SD314: CLICK's own"""
    _S0_SD_USED_MEM_L: Final[_SD]
    """SD313: CLICK's own"""
    _S0_Session_Cnt: Final[_SD]
    """SD352: CLICK's own"""
    _S0_USB_Default_Gateway1: Final[_SD]
    """SD341: CLICK's own"""
    _S0_USB_Default_Gateway2: Final[_SD]
    """SD342: CLICK's own"""
    _S0_USB_Default_Gateway3: Final[_SD]
    """SD343: CLICK's own"""
    _S0_USB_Default_Gateway4: Final[_SD]
    """SD344: CLICK's own"""
    _S0_USB_IP_Address1: Final[_SD]
    """SD333: CLICK's own"""
    _S0_USB_IP_Address2: Final[_SD]
    """SD334: CLICK's own"""
    _S0_USB_IP_Address3: Final[_SD]
    """SD335: CLICK's own"""
    _S0_USB_IP_Address4: Final[_SD]
    """SD336: CLICK's own"""
    _S0_USB_MAC_Address1: Final[_SD]
    """SD345: CLICK's own"""
    _S0_USB_MAC_Address2: Final[_SD]
    """SD346: CLICK's own"""
    _S0_USB_MAC_Address3: Final[_SD]
    """SD347: CLICK's own"""
    _S0_USB_MAC_Address4: Final[_SD]
    """SD348: CLICK's own"""
    _S0_USB_MAC_Address5: Final[_SD]
    """SD349: CLICK's own"""
    _S0_USB_MAC_Address6: Final[_SD]
    """SD350: CLICK's own"""
    _S0_USB_Subnet_Mask1: Final[_SD]
    """SD337: CLICK's own"""
    _S0_USB_Subnet_Mask2: Final[_SD]
    """SD338: CLICK's own"""
    _S0_USB_Subnet_Mask3: Final[_SD]
    """SD339: CLICK's own"""
    _S0_USB_Subnet_Mask4: Final[_SD]
    """SD340: CLICK's own"""
    _S1_Application_USAGE: Final[_SD]
    """SD451: CLICK's own"""
    _S1_CPU_USAGE: Final[_SD]
    """SD406: CLICK's own"""
    _S1_DataUpdateCycleTime: Final[_SD]
    """SD453: CLICK's own"""
    _S1_ERROR_CODE: Final[_SD]
    """SD408: CLICK's own"""
    _S1_ETH_Default_Gateway1: Final[_SD]
    """SD423: CLICK's own"""
    _S1_ETH_Default_Gateway2: Final[_SD]
    """SD424: CLICK's own"""
    _S1_ETH_Default_Gateway3: Final[_SD]
    """SD425: CLICK's own"""
    _S1_ETH_Default_Gateway4: Final[_SD]
    """SD426: CLICK's own"""
    _S1_ETH_IP_Address1: Final[_SD]
    """SD415: CLICK's own"""
    _S1_ETH_IP_Address2: Final[_SD]
    """SD416: CLICK's own"""
    _S1_ETH_IP_Address3: Final[_SD]
    """SD417: CLICK's own"""
    _S1_ETH_IP_Address4: Final[_SD]
    """SD418: CLICK's own"""
    _S1_ETH_MAC_Address1: Final[_SD]
    """SD427: CLICK's own"""
    _S1_ETH_MAC_Address2: Final[_SD]
    """SD428: CLICK's own"""
    _S1_ETH_MAC_Address3: Final[_SD]
    """SD429: CLICK's own"""
    _S1_ETH_MAC_Address4: Final[_SD]
    """SD430: CLICK's own"""
    _S1_ETH_MAC_Address5: Final[_SD]
    """SD431: CLICK's own"""
    _S1_ETH_MAC_Address6: Final[_SD]
    """SD432: CLICK's own"""
    _S1_ETH_Subnet_Mask1: Final[_SD]
    """SD419: CLICK's own"""
    _S1_ETH_Subnet_Mask2: Final[_SD]
    """SD420: CLICK's own"""
    _S1_ETH_Subnet_Mask3: Final[_SD]
    """SD421: CLICK's own"""
    _S1_ETH_Subnet_Mask4: Final[_SD]
    """SD422: CLICK's own"""
    _S1_Hotfix_Version: Final[_SD]
    """SD404: CLICK's own"""
    _S1_Major_Version: Final[_SD]
    """SD402: CLICK's own"""
    _S1_MEM_USAGE: Final[_SD]
    """SD407: CLICK's own"""
    _S1_Minor_Version: Final[_SD]
    """SD403: CLICK's own"""
    _S1_ModuleId: Final[_SD]
    """SD401: CLICK's own"""
    _S1_P1_No_Comm_Time: Final[_SD]
    """SD145: CLICK's own"""
    _S1_P1_Received_Data_Len: Final[_SD]
    """SD144: CLICK's own"""
    _S1_P2_No_Comm_Time: Final[_SD]
    """SD147: CLICK's own"""
    _S1_P2_Received_Data_Len: Final[_SD]
    """SD146: CLICK's own"""
    _S1_Release_Version: Final[_SD]
    """SD405: CLICK's own"""
    _S1_SD_FREE_MEM_H: Final[_SD]
    """SD412: CLICK's own"""
    _S1_SD_FREE_MEM_L: Final[_SD]
    """SD411: CLICK's own"""
    _S1_SD_TOTAL_MEM_H: Final[_SD]
    """SD410: CLICK's own"""
    _S1_SD_TOTAL_MEM_L: Final[_SD]
    """SD409: CLICK's own"""
    _S1_SD_USED_MEM_H: Final[_SD]
    """SD414: CLICK's own"""
    _S1_SD_USED_MEM_L: Final[_SD]
    """SD413: CLICK's own"""
    _S1_Session_Cnt: Final[_SD]
    """SD452: CLICK's own"""
    _S1_USB_Default_Gateway1: Final[_SD]
    """SD441: CLICK's own"""
    _S1_USB_Default_Gateway2: Final[_SD]
    """SD442: CLICK's own"""
    _S1_USB_Default_Gateway3: Final[_SD]
    """SD443: CLICK's own"""
    _S1_USB_Default_Gateway4: Final[_SD]
    """SD444: CLICK's own"""
    _S1_USB_IP_Address1: Final[_SD]
    """SD433: CLICK's own"""
    _S1_USB_IP_Address2: Final[_SD]
    """SD434: CLICK's own"""
    _S1_USB_IP_Address3: Final[_SD]
    """SD435: CLICK's own"""
    _S1_USB_IP_Address4: Final[_SD]
    """SD436: CLICK's own"""
    _S1_USB_MAC_Address1: Final[_SD]
    """SD445: CLICK's own"""
    _S1_USB_MAC_Address2: Final[_SD]
    """SD446: CLICK's own"""
    _S1_USB_MAC_Address3: Final[_SD]
    """SD447: CLICK's own"""
    _S1_USB_MAC_Address4: Final[_SD]
    """SD448: CLICK's own"""
    _S1_USB_MAC_Address5: Final[_SD]
    """SD449: CLICK's own"""
    _S1_USB_MAC_Address6: Final[_SD]
    """SD450: CLICK's own"""
    _S1_USB_Subnet_Mask1: Final[_SD]
    """SD437: CLICK's own"""
    _S1_USB_Subnet_Mask2: Final[_SD]
    """SD438: CLICK's own"""
    _S1_USB_Subnet_Mask3: Final[_SD]
    """SD439: CLICK's own"""
    _S1_USB_Subnet_Mask4: Final[_SD]
    """SD440: CLICK's own"""
    _Scan_Counter: Final[_SD]
    """SD9: CLICK's own"""
    _SD_Error_Information: Final[_SD]
    """SD69: CLICK's own"""
    _SD_Free_Memory_H: Final[_SD]
    """SD66: CLICK's own"""
    _SD_Free_Memory_L: Final[_SD]
    """SD65: CLICK's own"""
    _SD_Log_File_Number: Final[_SD]
    """SD70: CLICK's own"""
    _SD_Total_Memory_H: Final[_SD]
    """SD64: CLICK's own"""
    _SD_Total_Memory_L: Final[_SD]
    """SD63: CLICK's own"""
    _SD_Used_Memory_H: Final[_SD]
    """SD68: CLICK's own"""
    _SD_Used_Memory_L: Final[_SD]
    """SD67: CLICK's own"""
    _Sub_Firmware_Version_H: Final[_SD]
    """SD8: CLICK's own"""
    _Sub_Firmware_Version_L: Final[_SD]
    """SD7: CLICK's own"""
    _WLAN_Connected_Channel: Final[_SD]
    """SD216: CLICK's own"""
    _WLAN_Connection_Status: Final[_SD]
    """SD213: CLICK's own"""
    _WLAN_Country_Code: Final[_SD]
    """SD217: CLICK's own"""
    _WLAN_Default_Gateway1: Final[_SD]
    """SD208: CLICK's own"""
    _WLAN_Default_Gateway2: Final[_SD]
    """SD209: CLICK's own"""
    _WLAN_Default_Gateway3: Final[_SD]
    """SD210: CLICK's own"""
    _WLAN_Default_Gateway4: Final[_SD]
    """SD211: CLICK's own"""
    _WLAN_IP_Address1: Final[_SD]
    """SD200: CLICK's own"""
    _WLAN_IP_Address2: Final[_SD]
    """SD201: CLICK's own"""
    _WLAN_IP_Address3: Final[_SD]
    """SD202: CLICK's own"""
    _WLAN_IP_Address4: Final[_SD]
    """SD203: CLICK's own"""
    _WLAN_No_Comm_Time: Final[_SD]
    """SD214: CLICK's own"""
    _WLAN_No_Connect_Status: Final[_SD]
    """SD218: CLICK's own"""
    _WLAN_Rcv_Pkt_High_Cnt: Final[_SD]
    """SD215: CLICK's own"""
    _WLAN_Signal_Strength: Final[_SD]
    """SD212: CLICK's own"""
    _WLAN_ST_MAC_Address1: Final[_SD]
    """SD194: CLICK's own"""
    _WLAN_ST_MAC_Address2: Final[_SD]
    """SD195: CLICK's own"""
    _WLAN_ST_MAC_Address3: Final[_SD]
    """SD196: CLICK's own"""
    _WLAN_ST_MAC_Address4: Final[_SD]
    """SD197: CLICK's own"""
    _WLAN_ST_MAC_Address5: Final[_SD]
    """SD198: CLICK's own"""
    _WLAN_ST_MAC_Address6: Final[_SD]
    """SD199: CLICK's own"""
    _WLAN_Subnet_Mask1: Final[_SD]
    """SD204: CLICK's own"""
    _WLAN_Subnet_Mask2: Final[_SD]
    """SD205: CLICK's own"""
    _WLAN_Subnet_Mask3: Final[_SD]
    """SD206: CLICK's own"""
    _WLAN_Subnet_Mask4: Final[_SD]
    """SD207: CLICK's own"""
    def __getattr__(self, nickname: str) -> _SDName:
        """The address with this nickname."""
    @overload
    def __getitem__(self, key: int, /) -> _SD: ...
    @overload
    def __getitem__(self, key: str, /) -> _SDName: ...
    @overload
    def __getitem__(self, key: slice[int, int, int | None], /) -> _SDRange: ...

class _TXTBank(_NoCondition):
    """TXT: text characters, 1..1000, retentive"""
    def __getattr__(self, nickname: str) -> _TXTName:
        """The address with this nickname."""
    @overload
    def __getitem__(self, key: int, /) -> _TXT: ...
    @overload
    def __getitem__(self, key: str, /) -> _TXTName: ...
    @overload
    def __getitem__(self, key: slice[int, int, int | None], /) -> _TXTRange: ...
    @overload
    def __getitem__(self, key: _DS, /) -> _TXTPointer: ...

x: _XBank
"""X: input bits, 1..16, 21..36, 101..116, 201..216, 301..316, 401..416, 501..516, 601..616, 701..716, 801..816"""
y: _YBank
"""Y: output bits, 1..16, 21..36, 101..116, 201..216, 301..316, 401..416, 501..516, 601..616, 701..716, 801..816"""
c: _CBank
"""C: control relays, 1..2000"""
t: _TBank
"""T: timer bits, 1..500"""
ct: _CTBank
"""CT: counter bits, 1..250, retentive"""
sc: _SCBank
"""SC: system control relays, 1..1000"""
ds: _DSBank
"""DS: 16-bit integers, 1..4500, retentive"""
dd: _DDBank
"""DD: 32-bit integers, 1..1000, retentive"""
dh: _DHBank
"""DH: hexadecimal words, 1..500, retentive"""
df: _DFBank
"""DF: floating-point numbers, 1..500, retentive"""
xd: _XDBank
"""XD: input words, 0..8"""
yd: _YDBank
"""YD: output words, 0..8"""
td: _TDBank
"""TD: timer current values, 1..500"""
ctd: _CTDBank
"""CTD: counter current values, 1..250, retentive"""
sd: _SDBank
"""SD: system data registers, 1..1000"""
txt: _TXTBank
"""TXT: text characters, 1..1000, retentive"""

_Address = TypeVar("_Address", _InX, _InY, _InC, _InT, _InCT, _InSC, _InDS, _InDD, _InDH, _InDF, _InXD, _InYD, _InTD, _InCTD, _InSD, _InTXT)
class _Subroutine(Protocol):
    """A subroutine, to be called by call(...)."""
    _is_subroutine: None
@overload
def sub(routine: Callable[[], None], /) -> _Subroutine:
    """Marks a subroutine, on the line above def name():."""
@overload
def sub(name: str, /) -> Callable[[Callable[[], None]], _Subroutine]:
    """Marks a subroutine that CLICK calls otherwise than the program: @sub("Auto Mode")."""

def nickname(
    name: _Address,
    address: _Address,
    /,
    *,
    initial: float | str = ...,
    retentive: bool = ...,
    comment: str = ...,
) -> None:
    """Tie a name to an address of the same bank, at the top level of a file.

    Example: nickname(ds.MaxAlarms, ds[5], initial=10, retentive=False, comment="rows of alarms")
    """

class _Unit:
    """The unit of a timer's setpoint."""
Tms: _Unit
"""milliseconds"""
Ts: _Unit
"""seconds"""
Tm: _Unit
"""minutes"""
Th: _Unit
"""hours"""
Td: _Unit
"""days"""

class _ToValue:
    """The digits become a value: "5" becomes 5."""
    def __call__(self) -> _ToValue: ...

to_value: _ToValue
"""The digits become a value: "5" becomes 5."""

class _ToAscii:
    """The character becomes its code: "5" becomes 53."""
    def __call__(self) -> _ToAscii: ...

to_ascii: _ToAscii
"""The character becomes its code: "5" becomes 53."""

class _ToBinary:
    """The number becomes the character with that code."""
    def __call__(self) -> _ToBinary: ...

to_binary: _ToBinary
"""The number becomes the character with that code."""

class _ToText:
    """The number becomes digits."""
    def __call__(
        self,
        *,
        suppress_zero: bool = True,
        exponential: bool = False,
        termination_code: int | str | None = None,
    ) -> _ToText: ...

to_text: _ToText
"""The number becomes digits."""

class ModbusTcpTarget:
    """A device in the network."""
    def __init__(self, *, ip: str, port: int = 502, device_id: int = 1, name: str = "tcp") -> None: ...

class ModbusRtuTarget:
    """A device on a serial line."""
    def __init__(
        self,
        *,
        com_port: Literal["cpu2", "slot0_1", "slot0_2", "slot1_1", "slot1_2"],
        device_id: int,
        name: str = "rtu",
    ) -> None: ...

class ModbusAddress:
    """An address in any device: 400001, or hexadecimal "64h" with a register type."""
    def __init__(
        self,
        *,
        address: int | str,
        register_type: Literal["coil", "discrete_input", "holding", "input"] | None = None,
    ) -> None: ...

def out(
    address: _Y | _C | _SC | _YRange | _CRange | _SCRange | _YImmediate,
    oneshot: bool = False,
    *,
    one_shot: bool = False,
) -> None:
    """Drive a bit: on while the rung is true, off while it is false.

    Example: out(y.Motor)
    """

def set(address: _Y | _C | _SC | _YRange | _CRange | _SCRange | _YImmediate) -> None:
    """Turn a bit on; it stays on until reset.

    Example: set(c.Running)
    """

def reset(address: _Y | _C | _SC | _YRange | _CRange | _SCRange | _YImmediate) -> None:
    """Turn a bit off.

    Example: reset(c.Running)
    """

def ton(timer: _T, setpoint: _DS | int, unit: _Unit = Tms) -> None:
    """On-delay timer: its bit comes on when the rung has been true for the setpoint.

    Example: ton(t.StartDelay, setpoint=5, unit=Ts)
    """

def tof(timer: _T, setpoint: _DS | int, unit: _Unit = Tms) -> None:
    """Off-delay timer: its bit goes off when the rung has been false for the setpoint.

    Example: tof(t.RunOn, setpoint=3, unit=Ts)
    """

class _RtonBox:
    """The inputs that can be chained after rton(...)."""
    def reset(self, condition: _Series, /, *more: _Series) -> None: ...

def rton(timer: _T, setpoint: _DS | int, unit: _Unit = Tms, reset: _Pin = ...) -> _RtonBox:
    """Retentive on-delay timer: adds up the time the rung is true until it is reset.

    Example: rton(t.RunHours, setpoint=100, unit=Th, reset=lambda: c.Serviced)
    """

class _RtofBox:
    """The inputs that can be chained after rtof(...)."""
    def reset(self, condition: _Series, /, *more: _Series) -> None: ...

def rtof(timer: _T, setpoint: _DS | int, unit: _Unit = Tms, reset: _Pin = ...) -> _RtofBox:
    """Retentive off-delay timer: adds up the time the rung is false until it is reset.

    Example: rtof(t.Idle, setpoint=30, unit=Tm, reset=lambda: c.Awake)
    """

class _CtuBox:
    """The inputs that can be chained after ctu(...)."""
    def reset(self, condition: _Series, /, *more: _Series) -> None: ...

def ctu(counter: _CT, setpoint: _DS | _DD | int, reset: _Pin | None = None) -> _CtuBox:
    """Count up; the counter bit is on from the setpoint upward.

    Example: ctu(ct.Parts, setpoint=100, reset=lambda: c.NewBatch)
    """

class _CtdBox:
    """The inputs that can be chained after ctd(...)."""
    def reset(self, condition: _Series, /, *more: _Series) -> None: ...

class _CtudBox:
    """The inputs that can be chained after ctud(...)."""
    def down(self, condition: _Series, /, *more: _Series) -> _CtudBox: ...
    def reset(self, condition: _Series, /, *more: _Series) -> _CtudBox: ...

def ctud(
    counter: _CT,
    setpoint: _DS | _DD | int,
    count_down: _Pin = ...,
    reset: _Pin | None = None,
) -> _CtudBox:
    """Count up on the rung and down on a second input.

    Example: ctud(ct.Level, setpoint=50, count_down=lambda: re(c.Taken), reset=lambda: c.Empty)
    """

@overload
def copy(
    source: _Bit | _CPointer,
    destination: _Y | _C | _CPointer,
    oneshot: bool = False,
    options: _ToValue | _ToAscii | _ToBinary | _ToText | Literal["to_value", "to_ascii", "to_binary", "to_text"] | None = None,
    *,
    one_shot: bool = False,
) -> None:
    """Copy one value; what does not fit the destination is clamped to its range.

    Example: copy(ds.Recipe, ds.Setpoint)
    """
@overload
def copy(
    source: _Decimal | _Hexadecimal | _TXT | _DSPointer | _DDPointer | _DHPointer | _DFPointer | _XDPointer | _YDPointer | _TDPointer | _CTDPointer | _TXTPointer | float | str,
    destination: _Decimal | _DH | _YD | _TXT | _DSPointer | _DDPointer | _DHPointer | _DFPointer | _YDPointer | _TDPointer | _CTDPointer | _TXTPointer,
    oneshot: bool = False,
    options: _ToValue | _ToAscii | _ToBinary | _ToText | Literal["to_value", "to_ascii", "to_binary", "to_text"] | None = None,
    *,
    one_shot: bool = False,
) -> None:
    """Copy one value; what does not fit the destination is clamped to its range.

    Example: copy(ds.Recipe, ds.Setpoint)
    """
@overload
def copy(
    source: str | _AsText,
    destination: _TXT | _TXTPointer,
    oneshot: bool = False,
    options: _ToValue | _ToAscii | _ToBinary | _ToText | Literal["to_value", "to_ascii", "to_binary", "to_text"] | None = None,
    *,
    one_shot: bool = False,
) -> None:
    """Copy one value; what does not fit the destination is clamped to its range.

    Example: copy(ds.Recipe, ds.Setpoint)
    """
@overload
def copy(
    source: _AsNumber,
    destination: _Decimal | _DH | _YD | _DSPointer | _DDPointer | _DHPointer | _DFPointer | _YDPointer | _TDPointer | _CTDPointer,
    oneshot: bool = False,
    options: _ToValue | _ToAscii | _ToBinary | _ToText | Literal["to_value", "to_ascii", "to_binary", "to_text"] | None = None,
    *,
    one_shot: bool = False,
) -> None:
    """Copy one value; what does not fit the destination is clamped to its range.

    Example: copy(ds.Recipe, ds.Setpoint)
    """

@overload
def copy_block(
    source: _BitRange,
    destination: _Y | _C | _YRange | _CRange,
    oneshot: bool = False,
    options: _ToValue | _ToAscii | Literal["to_value", "to_ascii"] | None = None,
    *,
    one_shot: bool = False,
) -> None:
    """Copy a range to a range of the same length, which begins at the destination.

    Example: copy_block(ds[1:5], ds[100])
    """
@overload
def copy_block(
    source: _DSRange | _DDRange | _DHRange | _DFRange | _SDRange,
    destination: _DS | _DD | _DH | _DF | _YD | _TD | _CTD | _DSRange | _DDRange | _DHRange | _DFRange | _YDRange | _TDRange | _CTDRange,
    oneshot: bool = False,
    options: _ToValue | _ToAscii | Literal["to_value", "to_ascii"] | None = None,
    *,
    one_shot: bool = False,
) -> None:
    """Copy a range to a range of the same length, which begins at the destination.

    Example: copy_block(ds[1:5], ds[100])
    """
@overload
def copy_block(
    source: _TXTRange | _AsNumbers,
    destination: _DS | _DD | _DH | _DF | _DSRange | _DDRange | _DHRange | _DFRange,
    oneshot: bool = False,
    options: _ToValue | _ToAscii | Literal["to_value", "to_ascii"] | None = None,
    *,
    one_shot: bool = False,
) -> None:
    """Copy a range to a range of the same length, which begins at the destination.

    Example: copy_block(ds[1:5], ds[100])
    """
@overload
def copy_block(
    *,
    source_range: _BitRange | _DSRange | _DDRange | _DHRange | _DFRange | _SDRange | _TXTRange | _AsNumbers,
    destination: _Y | _C | _DS | _DD | _DH | _DF | _YD | _TD | _CTD | _YRange | _CRange | _DSRange | _DDRange | _DHRange | _DFRange | _YDRange | _TDRange | _CTDRange,
    oneshot: bool = False,
    options: _ToValue | _ToAscii | Literal["to_value", "to_ascii"] | None = None,
    one_shot: bool = False,
) -> None:
    """Copy a range to a range of the same length, which begins at the destination.

    Example: copy_block(ds[1:5], ds[100])
    """
@overload
def copy_block(
    source: _BitRange | _DSRange | _DDRange | _DHRange | _DFRange | _SDRange | _TXTRange | _AsNumbers,
    *,
    destination_start: _Y | _C | _DS | _DD | _DH | _DF | _YD | _TD | _CTD | _YRange | _CRange | _DSRange | _DDRange | _DHRange | _DFRange | _YDRange | _TDRange | _CTDRange,
    oneshot: bool = False,
    options: _ToValue | _ToAscii | Literal["to_value", "to_ascii"] | None = None,
    one_shot: bool = False,
) -> None:
    """Copy a range to a range of the same length, which begins at the destination.

    Example: copy_block(ds[1:5], ds[100])
    """
@overload
def copy_block(
    source_range: _BitRange | _DSRange | _DDRange | _DHRange | _DFRange | _SDRange | _TXTRange | _AsNumbers,
    *,
    destination_start: _Y | _C | _DS | _DD | _DH | _DF | _YD | _TD | _CTD | _YRange | _CRange | _DSRange | _DDRange | _DHRange | _DFRange | _YDRange | _TDRange | _CTDRange,
    oneshot: bool = False,
    options: _ToValue | _ToAscii | Literal["to_value", "to_ascii"] | None = None,
    one_shot: bool = False,
) -> None:
    """Copy a range to a range of the same length, which begins at the destination.

    Example: copy_block(ds[1:5], ds[100])
    """

@overload
def copy_fill(
    source: _Decimal | _Hexadecimal | float | str,
    destination: _DecimalRange | _DHRange | _YDRange,
    oneshot: bool = False,
    options: None = None,
    *,
    one_shot: bool = False,
) -> None:
    """Copy one value into every register of a range.

    Example: copy_fill(0, ds[20:30])
    """
@overload
def copy_fill(
    source: _TXT | str,
    destination: _TXTRange,
    oneshot: bool = False,
    options: None = None,
    *,
    one_shot: bool = False,
) -> None:
    """Copy one value into every register of a range.

    Example: copy_fill(0, ds[20:30])
    """
@overload
def copy_fill(
    source: _Decimal | _Hexadecimal | _TXT | float | str,
    *,
    destination_range: _DecimalRange | _DHRange | _YDRange | _TXTRange,
    oneshot: bool = False,
    options: None = None,
    one_shot: bool = False,
) -> None:
    """Copy one value into every register of a range.

    Example: copy_fill(0, ds[20:30])
    """

@overload
def copy_pack(
    source: _XRange | _YRange | _TRange | _CTRange | _SCRange,
    destination: _DS | _DH,
    oneshot: bool = False,
    options: None = None,
    allow_whitespace: bool = False,
    *,
    one_shot: bool = False,
) -> None:
    """Pack bits into a word, two words into a double word (low word first), or text into a number.

    Example: copy_pack(c[1:17], dh.StatusWord)
    """
@overload
def copy_pack(
    source: _CRange,
    destination: _DS | _DD | _DH | _DF,
    oneshot: bool = False,
    options: None = None,
    allow_whitespace: bool = False,
    *,
    one_shot: bool = False,
) -> None:
    """Pack bits into a word, two words into a double word (low word first), or text into a number.

    Example: copy_pack(c[1:17], dh.StatusWord)
    """
@overload
def copy_pack(
    source: _DSRange | _DHRange,
    destination: _DD | _DF,
    oneshot: bool = False,
    options: None = None,
    allow_whitespace: bool = False,
    *,
    one_shot: bool = False,
) -> None:
    """Pack bits into a word, two words into a double word (low word first), or text into a number.

    Example: copy_pack(c[1:17], dh.StatusWord)
    """
@overload
def copy_pack(
    source: _TXTRange,
    destination: _DS | _DD | _DH | _DF | _TD | _CTD,
    oneshot: bool = False,
    options: None = None,
    allow_whitespace: bool = False,
    *,
    one_shot: bool = False,
) -> None:
    """Pack bits into a word, two words into a double word (low word first), or text into a number.

    Example: copy_pack(c[1:17], dh.StatusWord)
    """
@overload
def copy_pack(
    *,
    source_range: _BitRange | _DSRange | _DHRange | _TXTRange,
    destination: _DS | _DD | _DH | _DF | _TD | _CTD,
    oneshot: bool = False,
    options: None = None,
    allow_whitespace: bool = False,
    one_shot: bool = False,
) -> None:
    """Pack bits into a word, two words into a double word (low word first), or text into a number.

    Example: copy_pack(c[1:17], dh.StatusWord)
    """

@overload
def copy_unpack(
    source: _DS | _DH,
    destination: _YRange | _CRange,
    oneshot: bool = False,
    options: None = None,
    *,
    one_shot: bool = False,
) -> None:
    """Unpack a word into bits, or a double word into two words (low word first).

    Example: copy_unpack(dd.ConfigWord, c[101:133])
    """
@overload
def copy_unpack(
    source: _DD | _DF,
    destination: _YRange | _CRange | _DSRange | _DHRange,
    oneshot: bool = False,
    options: None = None,
    *,
    one_shot: bool = False,
) -> None:
    """Unpack a word into bits, or a double word into two words (low word first).

    Example: copy_unpack(dd.ConfigWord, c[101:133])
    """
@overload
def copy_unpack(
    source: _DS | _DD | _DH | _DF,
    *,
    destination_range: _YRange | _CRange | _DSRange | _DHRange,
    oneshot: bool = False,
    options: None = None,
    one_shot: bool = False,
) -> None:
    """Unpack a word into bits, or a double word into two words (low word first).

    Example: copy_unpack(dd.ConfigWord, c[101:133])
    """

class _ShiftBox:
    """The inputs that can be chained after shift(...)."""
    def clock(self, condition: _Series, /, *more: _Series) -> _ShiftBox: ...
    def reset(self, condition: _Series, /, *more: _Series) -> _ShiftBox: ...

@overload
def shift(range: _CRange, clock: _Pin | None = None, reset: _Pin | None = None) -> _ShiftBox:
    """Shift register: the rung is the data bit, which moves in on each rising edge of the clock.

    Example: shift(c[1:9], clock=lambda: c.Clock, reset=lambda: c.Clear)
    """
@overload
def shift(*, address: _CRange, clock: _Pin | None = None, reset: _Pin | None = None) -> _ShiftBox:
    """Shift register: the rung is the data bit, which moves in on each rising edge of the clock.

    Example: shift(c[1:9], clock=lambda: c.Clock, reset=lambda: c.Clear)
    """

@overload
def search(
    condition: Literal["==", "!=", "<", "<=", ">", ">=", "eq", "ne", "lt", "le", "gt", "ge"],
    value: _Decimal | _Hexadecimal | _TXT | float | str,
    start: _Decimal | _Hexadecimal | _TXT,
    end: _Decimal | _Hexadecimal | _TXT,
    result: _DS | _DD,
    flag: _C,
    continuous: bool = False,
    oneshot: bool = False,
    *,
    one_shot: bool = False,
) -> None:
    """Find the first register of a range that meets a condition; both ends are searched.

    Example: search("==", ds.Target, ds[100], ds[200], ds.FoundAt, c.Found)
    """
@overload
def search(
    condition: Literal["==", "!=", "<", "<=", ">", ">=", "eq", "ne", "lt", "le", "gt", "ge"],
    *,
    search_value: _Decimal | _Hexadecimal | _TXT | float | str,
    start: _Decimal | _Hexadecimal | _TXT,
    end: _Decimal | _Hexadecimal | _TXT,
    result: _DS | _DD,
    flag: _C,
    continuous: bool = False,
    oneshot: bool = False,
    one_shot: bool = False,
) -> None:
    """Find the first register of a range that meets a condition; both ends are searched.

    Example: search("==", ds.Target, ds[100], ds[200], ds.FoundAt, c.Found)
    """
@overload
def search(
    condition: Literal["==", "!=", "<", "<=", ">", ">=", "eq", "ne", "lt", "le", "gt", "ge"],
    value: _Decimal | _Hexadecimal | _TXT | float | str,
    *,
    start_address: _Decimal | _Hexadecimal | _TXT,
    end: _Decimal | _Hexadecimal | _TXT,
    result: _DS | _DD,
    flag: _C,
    continuous: bool = False,
    oneshot: bool = False,
    one_shot: bool = False,
) -> None:
    """Find the first register of a range that meets a condition; both ends are searched.

    Example: search("==", ds.Target, ds[100], ds[200], ds.FoundAt, c.Found)
    """
@overload
def search(
    condition: Literal["==", "!=", "<", "<=", ">", ">=", "eq", "ne", "lt", "le", "gt", "ge"],
    value: _Decimal | _Hexadecimal | _TXT | float | str,
    start: _Decimal | _Hexadecimal | _TXT,
    *,
    end_address: _Decimal | _Hexadecimal | _TXT,
    result: _DS | _DD,
    flag: _C,
    continuous: bool = False,
    oneshot: bool = False,
    one_shot: bool = False,
) -> None:
    """Find the first register of a range that meets a condition; both ends are searched.

    Example: search("==", ds.Target, ds[100], ds[200], ds.FoundAt, c.Found)
    """
@overload
def search(
    condition: Literal["==", "!=", "<", "<=", ">", ">=", "eq", "ne", "lt", "le", "gt", "ge"],
    value: _Decimal | _Hexadecimal | _TXT | float | str,
    start: _Decimal | _Hexadecimal | _TXT,
    end: _Decimal | _Hexadecimal | _TXT,
    *,
    result_address: _DS | _DD,
    flag: _C,
    continuous: bool = False,
    oneshot: bool = False,
    one_shot: bool = False,
) -> None:
    """Find the first register of a range that meets a condition; both ends are searched.

    Example: search("==", ds.Target, ds[100], ds[200], ds.FoundAt, c.Found)
    """
@overload
def search(
    condition: Literal["==", "!=", "<", "<=", ">", ">=", "eq", "ne", "lt", "le", "gt", "ge"],
    value: _Decimal | _Hexadecimal | _TXT | float | str,
    start: _Decimal | _Hexadecimal | _TXT,
    end: _Decimal | _Hexadecimal | _TXT,
    result: _DS | _DD,
    *,
    result_flag: _C,
    continuous: bool = False,
    oneshot: bool = False,
    one_shot: bool = False,
) -> None:
    """Find the first register of a range that meets a condition; both ends are searched.

    Example: search("==", ds.Target, ds[100], ds[200], ds.FoundAt, c.Found)
    """
@overload
def search(
    condition: Literal["==", "!=", "<", "<=", ">", ">=", "eq", "ne", "lt", "le", "gt", "ge"],
    value: _Decimal | _Hexadecimal | _TXT | float | str,
    start: _Decimal | _Hexadecimal | _TXT,
    end: _Decimal | _Hexadecimal | _TXT,
    result: _DS | _DD,
    *,
    found: _C,
    continuous: bool = False,
    oneshot: bool = False,
    one_shot: bool = False,
) -> None:
    """Find the first register of a range that meets a condition; both ends are searched.

    Example: search("==", ds.Target, ds[100], ds[200], ds.FoundAt, c.Found)
    """
@overload
def search(
    condition: Literal["==", "!=", "<", "<=", ">", ">=", "eq", "ne", "lt", "le", "gt", "ge"],
    search_value: _Decimal | _Hexadecimal | _TXT | float | str,
    start_address: _Decimal | _Hexadecimal | _TXT,
    end_address: _Decimal | _Hexadecimal | _TXT,
    result_address: _DS | _DD,
    *,
    result_flag: _C,
    continuous: bool = False,
    oneshot: bool = False,
    one_shot: bool = False,
) -> None:
    """Find the first register of a range that meets a condition; both ends are searched.

    Example: search("==", ds.Target, ds[100], ds[200], ds.FoundAt, c.Found)
    """
@overload
def search(
    condition: Literal["==", "!=", "<", "<=", ">", ">=", "eq", "ne", "lt", "le", "gt", "ge"],
    search_value: _Decimal | _Hexadecimal | _TXT | float | str,
    start_address: _Decimal | _Hexadecimal | _TXT,
    end_address: _Decimal | _Hexadecimal | _TXT,
    result_address: _DS | _DD,
    *,
    found: _C,
    continuous: bool = False,
    oneshot: bool = False,
    one_shot: bool = False,
) -> None:
    """Find the first register of a range that meets a condition; both ends are searched.

    Example: search("==", ds.Target, ds[100], ds[200], ds.FoundAt, c.Found)
    """
@overload
def search(
    comparison: _RangeComparison | bool,
    result: _DS | _DD,
    found: _C,
    continuous: bool = False,
    oneshot: bool = False,
    *,
    one_shot: bool = False,
) -> None:
    """Find the first register of a range that meets a condition; both ends are searched.

    Example: search("==", ds.Target, ds[100], ds[200], ds.FoundAt, c.Found)
    """
@overload
def search(
    comparison: _RangeComparison | bool,
    *,
    result_address: _DS | _DD,
    found: _C,
    continuous: bool = False,
    oneshot: bool = False,
    one_shot: bool = False,
) -> None:
    """Find the first register of a range that meets a condition; both ends are searched.

    Example: search("==", ds.Target, ds[100], ds[200], ds.FoundAt, c.Found)
    """
@overload
def search(
    comparison: _RangeComparison | bool,
    result: _DS | _DD,
    *,
    flag: _C,
    continuous: bool = False,
    oneshot: bool = False,
    one_shot: bool = False,
) -> None:
    """Find the first register of a range that meets a condition; both ends are searched.

    Example: search("==", ds.Target, ds[100], ds[200], ds.FoundAt, c.Found)
    """
@overload
def search(
    comparison: _RangeComparison | bool,
    result: _DS | _DD,
    *,
    result_flag: _C,
    continuous: bool = False,
    oneshot: bool = False,
    one_shot: bool = False,
) -> None:
    """Find the first register of a range that meets a condition; both ends are searched.

    Example: search("==", ds.Target, ds[100], ds[200], ds.FoundAt, c.Found)
    """
@overload
def search(
    comparison: _RangeComparison | bool,
    result_address: _DS | _DD,
    *,
    flag: _C,
    continuous: bool = False,
    oneshot: bool = False,
    one_shot: bool = False,
) -> None:
    """Find the first register of a range that meets a condition; both ends are searched.

    Example: search("==", ds.Target, ds[100], ds[200], ds.FoundAt, c.Found)
    """
@overload
def search(
    comparison: _RangeComparison | bool,
    result_address: _DS | _DD,
    *,
    result_flag: _C,
    continuous: bool = False,
    oneshot: bool = False,
    one_shot: bool = False,
) -> None:
    """Find the first register of a range that meets a condition; both ends are searched.

    Example: search("==", ds.Target, ds[100], ds[200], ds.FoundAt, c.Found)
    """

@overload
def calc(formula: str, destination: _Decimal, oneshot: bool = False, *, one_shot: bool = False) -> None:
    """Decimal mathematics; a result too large for the destination wraps around.

    Example: calc("ds.Raw * 100 / 4095", df.Percent)
    """
@overload
def calc(formula: str, *, result_destination: _Decimal, oneshot: bool = False, one_shot: bool = False) -> None:
    """Decimal mathematics; a result too large for the destination wraps around.

    Example: calc("ds.Raw * 100 / 4095", df.Percent)
    """

@overload
def math_hex(formula: str, destination: _DH, oneshot: bool = False, *, one_shot: bool = False) -> None:
    """Hexadecimal mathematics and bit operations on 16-bit words.

    Example: math_hex("dh.Inputs AND 0x00FF", dh.LowByte)
    """
@overload
def math_hex(formula: str, *, result_destination: _DH, oneshot: bool = False, one_shot: bool = False) -> None:
    """Hexadecimal mathematics and bit operations on 16-bit words.

    Example: math_hex("dh.Inputs AND 0x00FF", dh.LowByte)
    """

class _EventDrumBox:
    """The inputs that can be chained after event_drum(...)."""
    def reset(self, condition: _Series, /, *more: _Series) -> _EventDrumBox: ...
    def jump(self, condition: _Series, /, *more: _Series, step: _DS | int) -> _EventDrumBox: ...
    def jog(self, condition: _Series, /, *more: _Series) -> _EventDrumBox: ...

def event_drum(
    outputs: Sequence[_Y | _C | _YRange | _CRange] | _Y | _C | _YRange | _CRange,
    events: Sequence[_Bit | _BitRange] | _Bit | _BitRange,
    pattern: Sequence[Sequence[Literal[0, 1] | bool]],
    current_step: _DS,
    completion_flag: _C,
    reset: _Pin = ...,
    jump: _Pin | None = None,
    jump_step: _DS | int | None = None,
    jog: _Pin | None = None,
) -> _EventDrumBox:
    """Drum sequencer: each step drives its row of the pattern until its event comes.

    Example: event_drum(outputs=[y.Fill, y.Mix], events=[x.Full, x.Mixed], pattern=[[1, 0], [0, 1]], current_step=ds.Step, completion_flag=c.Done, reset=lambda: c.Restart, jump=lambda: c.Skip, jump_step=2, jog=lambda: c.Next)
    """

class _TimeDrumBox:
    """The inputs that can be chained after time_drum(...)."""
    def reset(self, condition: _Series, /, *more: _Series) -> _TimeDrumBox: ...
    def jump(self, condition: _Series, /, *more: _Series, step: _DS | int) -> _TimeDrumBox: ...
    def jog(self, condition: _Series, /, *more: _Series) -> _TimeDrumBox: ...

@overload
def time_drum(
    outputs: Sequence[_Y | _C | _YRange | _CRange] | _Y | _C | _YRange | _CRange,
    presets: Sequence[_DS | int | _DSRange] | _DS | _DSRange,
    unit: _Unit,
    pattern: Sequence[Sequence[Literal[0, 1] | bool]],
    current_step: _DS,
    accumulator: _TD,
    completion_flag: _C,
    reset: _Pin = ...,
    jump: _Pin | None = None,
    jump_step: _DS | int | None = None,
    jog: _Pin | None = None,
) -> _TimeDrumBox:
    """Drum sequencer: each step drives its row of the pattern for its time.

    Example: time_drum(outputs=[y.Fill, y.Mix], presets=[20, 45], unit=Ts, pattern=[[1, 0], [0, 1]], current_step=ds.Step, accumulator=td.Elapsed, completion_flag=c.Done, reset=lambda: c.Restart, jump=lambda: c.Skip, jump_step=2, jog=lambda: c.Next)
    """
@overload
def time_drum(
    outputs: Sequence[_Y | _C | _YRange | _CRange] | _Y | _C | _YRange | _CRange,
    presets: Sequence[_DS | int | _DSRange] | _DS | _DSRange,
    *,
    pattern: Sequence[Sequence[Literal[0, 1] | bool]],
    current_step: _DS,
    accumulator: _TD,
    completion_flag: _C,
    reset: _Pin = ...,
    jump: _Pin | None = None,
    jump_step: _DS | int | None = None,
    jog: _Pin | None = None,
) -> _TimeDrumBox:
    """Drum sequencer: each step drives its row of the pattern for its time.

    Example: time_drum(outputs=[y.Fill, y.Mix], presets=[20, 45], unit=Ts, pattern=[[1, 0], [0, 1]], current_step=ds.Step, accumulator=td.Elapsed, completion_flag=c.Done, reset=lambda: c.Restart, jump=lambda: c.Skip, jump_step=2, jog=lambda: c.Next)
    """

def send(
    target: ModbusTcpTarget | ModbusRtuTarget,
    remote_start: ModbusAddress | str,
    source: _Bit | _Decimal | _Hexadecimal | _TXT | _BitRange | _DecimalRange | _HexadecimalRange | _TXTRange,
    sending: _C | None = None,
    success: _C | None = None,
    error: _C | None = None,
    exception_response: _DS | _DD | None = None,
    word_swap: bool = False,
) -> None:
    """Write to another device over Modbus.

    Example: send(ModbusTcpTarget(ip="192.168.1.10"), "DS1", ds[1:6], success=c.Sent)
    """

def receive(
    target: ModbusTcpTarget | ModbusRtuTarget,
    remote_start: ModbusAddress | str,
    dest: _Y | _C | _DS | _DD | _DH | _DF | _YD | _TD | _CTD | _TXT | _YRange | _CRange | _DSRange | _DDRange | _DHRange | _DFRange | _YDRange | _TDRange | _CTDRange | _TXTRange,
    receiving: _C | None = None,
    success: _C | None = None,
    error: _C | None = None,
    exception_response: _DS | _DD | None = None,
    word_swap: bool = False,
) -> None:
    """Read from another device over Modbus.

    Example: receive(ModbusRtuTarget(com_port="cpu2", device_id=5), ModbusAddress(address=400001), ds[1:6])
    """

@overload
def call(subroutine: _Subroutine | str) -> None:
    """Run a subroutine.

    Example: call(auto_mode)
    """
@overload
def call(*, subroutine_name: _Subroutine | str) -> None:
    """Run a subroutine.

    Example: call(auto_mode)
    """

def end() -> None:
    """End the scan of the program.

    Example: end()
    """

def next_loop() -> None:
    """Close the loop that a for opened.

    Example: next_loop()
    """

def raw(token: str) -> None:
    """An instruction that the language has no word for, as its ladder token.

    Example: raw("raw(Velocity,0x2735,1,222d=0,609b=1,609c=1,609d=1,222f=2,11f5=0,2231=0,60a2=,60a3=,60a4=,607b=C1,607d=C2,6083=DS1,3218=9744,0000=)")
    """

def not_imported(reason: str) -> None:
    """The place of a rung that `clickgen import` left out: a program that has it does not build.

    Example: not_imported("main.csv:45: the contacts are wired in too many ways")
    """

def range(count: _DS | int, /, *, oneshot: bool = False, one_shot: bool = False) -> Iterable[int]:
    """Run the rungs up to next_loop() several times in one scan.

    Example: for _ in range(ds.Count): pass
    """
