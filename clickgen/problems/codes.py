"""Every problem code, once: its severity and its title. Codes are stable; a retired one is never given again.

CG1xx syntax, CG2xx names and addresses, CG3xx operands and types, CG4xx program structure and hardware limits,
CG5xx logic worth a second look, CG6xx the address table, CG7xx bringing a project in.
"""

from __future__ import annotations

from enum import Enum
from typing import NamedTuple


class Severity(Enum):
    """ERROR stops the build; WARNING and INFO are said and the build goes on."""

    ERROR = "error"
    WARNING = "warning"
    INFO = "info"


class Code(NamedTuple):
    severity: Severity
    title: str
    is_on: bool = True
    """False for a rule that says something only when it is asked for."""


_E, _W, _I = Severity.ERROR, Severity.WARNING, Severity.INFO

CODES: dict[str, Code] = {
    # -- syntax ---------------------------------------------------------------------------------------------------
    "CG101": Code(_E, "the file is not readable as Python"),
    "CG102": Code(_E, "this statement has no place at the top level of a program"),
    "CG103": Code(_E, "a routine holds only rungs"),
    "CG104": Code(_E, "a rung has no else or elif"),
    "CG105": Code(_E, "and, or, not, &, | and ~ are not part of the language"),
    "CG106": Code(_E, "comparisons do not chain"),
    "CG107": Code(_E, "this is not a condition"),
    "CG108": Code(_E, "no such instruction"),
    "CG109": Code(_E, "the instruction has no such argument"),
    "CG110": Code(_E, "an argument is missing"),
    "CG111": Code(_E, "an argument is given twice"),
    "CG112": Code(_E, "this statement has no place in a rung"),
    "CG113": Code(_E, "this is not an address or a constant"),
    "CG114": Code(_E, "a routine is written def name(): with no parameters, subroutines under @sub"),
    "CG115": Code(_E, "an argument is of the wrong kind"),
    "CG116": Code(_E, "the formula cannot be read"),
    "CG117": Code(_E, "the formula has no such function"),
    "CG118": Code(_E, "the program is nested too deeply"),
    "CG119": Code(_E, "a for loop is written for _ in range(n):"),
    "CG120": Code(_E, "this import cannot be read"),
    "CG121": Code(_E, "the file of an import is missing"),
    "CG122": Code(_E, "files import each other in a circle"),
    "CG123": Code(_E, "the imported file has no such subroutine"),
    "CG140": Code(_E, "the program could not be judged"),
    # -- names and addresses --------------------------------------------------------------------------------------
    "CG201": Code(_E, "the bank has no such address"),
    "CG202": Code(_E, "the range is empty, reversed or crosses a gap"),
    "CG203": Code(_E, "CLICK does not take this nickname"),
    "CG204": Code(_E, "one nickname is used for two banks"),
    "CG205": Code(_E, "two sources disagree about an address"),
    "CG206": Code(_E, "no such system nickname"),
    "CG207": Code(_E, "no timer or counter has this name"),
    "CG208": Code(_E, "the bank is full"),
    "CG209": Code(_E, "a name has no address and the table is frozen"),
    "CG210": Code(_W, "an input or output was given an address by clickgen"),
    "CG211": Code(_W, "ClickNick mishandles nicknames of XD and YD"),
    "CG212": Code(_E, "a pointer goes through a DS register"),
    "CG213": Code(_E, "this bank cannot be pointed into"),
    "CG214": Code(_E, "this is no member of a block"),
    "CG215": Code(_E, "one of CLICK's own names may mean two addresses"),
    # -- operands and types ---------------------------------------------------------------------------------------
    "CG301": Code(_E, "the instruction does not take this operand"),
    "CG302": Code(_E, "the constant is out of range"),
    "CG303": Code(_E, "values of different kinds cannot be compared"),
    "CG304": Code(_E, "this address cannot be written"),
    "CG305": Code(_E, "CLICK cannot copy between these"),
    "CG306": Code(_E, "the range has the wrong length"),
    "CG307": Code(_E, "a pointer has no place here"),
    "CG308": Code(_E, "immediate has no place here"),
    "CG309": Code(_E, "hexadecimal and decimal values are mixed in one formula"),
    "CG310": Code(_E, "parentheses are nested more than 8 deep"),
    "CG311": Code(_E, "the formula has more than 68 operands"),
    "CG312": Code(_W, "sources disagree whether CLICK takes this"),
    "CG313": Code(_E, "oneshot has no place here"),
    "CG314": Code(_E, "this option has no place here"),
    "CG315": Code(_W, "a decimal number in a hexadecimal formula"),
    "CG316": Code(_E, "the lists of a drum do not fit together"),
    "CG317": Code(_E, "the ladder token cannot be kept"),
    # -- structure and limits -------------------------------------------------------------------------------------
    "CG401": Code(_E, "the program has no main"),
    "CG402": Code(_E, "two routines have the same name"),
    "CG403": Code(_E, "main has no unconditional end()"),
    "CG404": Code(_E, "a subroutine does not end in an unconditional return"),
    "CG405": Code(_E, "no such subroutine"),
    "CG406": Code(_E, "a subroutine calls a subroutine"),
    "CG407": Code(_E, "a loop stands inside a loop"),
    "CG408": Code(_E, "a loop is not closed"),
    "CG409": Code(_E, "next_loop() without an open loop"),
    "CG410": Code(_E, "end() belongs in main"),
    "CG411": Code(_E, "return belongs in a subroutine"),
    "CG412": Code(_E, "a timer or counter has two owners"),
    "CG413": Code(_E, "the rung comment is too long for CLICK"),
    "CG415": Code(_E, "a routine is too long for one CLICK file"),
    "CG416": Code(_E, "too many subroutines"),
    "CG417": Code(_E, "CLICK does not take this subroutine name"),
    "CG418": Code(_W, "a counter has no reset"),
    "CG419": Code(_W, "a shift register has no clock or no reset"),
    "CG420": Code(_I, "rtof is emulated"),
    "CG421": Code(_W, "CLICK shows part of this comment as styled text"),
    "CG422": Code(_E, "next_loop() stands alone in an unconditional rung"),
    "CG423": Code(_W, "a timer stands inside a loop"),
    "CG424": Code(_W, "main is too long for one CLICK file and is split"),
    "CG425": Code(_E, "a loop that next_loop() closes is opened by the last action of its rung"),
    "CG426": Code(_E, "a rung was left out by import"),
    "CG427": Code(_W, "a loop calls a subroutine with a loop"),
    "CG428": Code(_W, "a pointer may write a scratch bit"),
    "CG429": Code(_W, "a block and a nickname have one name"),
    "CG430": Code(_W, "a text can run past the last TXT address"),
    "CG431": Code(_W, "a copy can run past its block or over another name"),
    "CG432": Code(_W, "a word holds an input or output that clickgen chose"),
    # -- logic worth a second look ---------------------------------------------------------------------------------
    "CG501": Code(_W, "an output coil is driven in two places"),
    "CG502": Code(_W, "a bit is set and never reset"),
    "CG503": Code(_W, "a bit is reset and never set"),
    "CG504": Code(_I, "an address is read and never written", is_on=False),
    "CG505": Code(_I, "an address is written and never read", is_on=False),
    "CG506": Code(_I, "a declared nickname is never used"),
    "CG507": Code(_W, "a condition can never be true"),
    "CG508": Code(_W, "a condition is always true"),
    "CG509": Code(_W, "a condition repeats a term"),
    "CG510": Code(_W, "a value is overwritten before anything reads it"),
    "CG511": Code(_W, "a running value is compared for equality"),
    "CG512": Code(_W, "a timer's setpoint is 0"),
    "CG513": Code(_W, "a counter counts without an edge"),
    "CG514": Code(_W, "an edge may be missed in a subroutine that does not always run"),
    "CG515": Code(_W, "a subroutine is never called"),
    "CG516": Code(_W, "a rung is never reached"),
    "CG517": Code(_W, "a formula divides by zero"),
    "CG518": Code(_W, "a pointer may lead to no address"),
    "CG519": Code(_W, "a slice looks one address short"),
    "CG520": Code(_W, "floating-point values are compared for equality"),
    "CG521": Code(_W, "a timer's or counter's bit is used without its instruction"),
    "CG522": Code(_W, "an output is driven from several routines"),
    "CG523": Code(_I, "a state number is repeated", is_on=False),
    "CG524": Code(_I, "a comparison is written as a word"),
    "CG525": Code(_W, "a suppression suppresses nothing"),
    "CG526": Code(_W, "a range in any(...) means all of its bits"),
    "CG527": Code(_W, "a subroutine with timers or edges may run twice in a scan"),
    "CG528": Code(_W, "a loop's count may be 0 or less"),
    "CG540": Code(_W, "a name looks like a misspelling of another"),
    "CG541": Code(_W, "a name left the program and its value stays behind"),
    "CG542": Code(_W, "a branch looks at what its own rung writes"),
    "CG543": Code(_W, "out and set or reset drive one bit"),
    "CG544": Code(_W, "a rung undoes in the same scan what a rung before it did"),
    "CG545": Code(_W, "an output or timer may freeze in a subroutine that does not always run"),
    "CG546": Code(_W, "two messages may want one port at the same time"),
    "CG550": Code(_W, "the initial value of a retentive address is masked"),
    "CG551": Code(_W, "a Modbus number means a coil here and another register in a manual"),
    "CG552": Code(_W, "the clock has no such value"),
    "CG553": Code(_W, "a formula has no result"),
    "CG554": Code(_W, "a pointer is still 0 when it is used"),
    "CG555": Code(_W, "a pointer can walk over cells of other names"),
    "CG556": Code(_W, "a step is never left"),
    "CG557": Code(_W, "a value that is to be kept is cleared in the first scan"),
    "CG558": Code(_W, "a shift is longer than the word"),
    # -- the address table ----------------------------------------------------------------------------------------
    "CG601": Code(_E, "a row of the address table is malformed"),
    "CG602": Code(_E, "the address table gives a nickname or an address twice"),
    "CG603": Code(_E, "the address table holds a nickname that CLICK does not take"),
    "CG604": Code(_W, "part of a row of the workbook is left out"),
    "CG605": Code(_E, "the workbook and the address table beside it disagree"),
    "CG606": Code(_W, "marks of blocks in the address table do not fit"),
    "CG607": Code(_W, "a Modbus number in the address table is not that of its address"),
    "CG618": Code(_I, "rows of the workbook without a nickname are passed over"),
    "CG619": Code(_E, "a name of the program stands for spare points in the workbook"),
    # -- bringing a project in ------------------------------------------------------------------------------------
    "CG701": Code(_E, "a ladder file is damaged"),
    "CG702": Code(_E, "a rung cannot be kept as it is"),
    "CG703": Code(_E, "an imported rung would not do the same"),
    "CG704": Code(_W, "a rung is written otherwise than it is drawn"),
    "CG705": Code(_I, "something that does nothing is left out"),
    "CG706": Code(_W, "a nickname is left out"),
    "CG707": Code(_W, "what is imported is a part of a program"),
    "CG708": Code(_E, "what is read of a rung is not what its bytes say"),
    "CG709": Code(_W, "part of the comment of a rung is left out"),
    "CG710": Code(_E, "a capture holds a rung that the codec cannot decode"),
}

LEFT = "CG541"
"""The code of a name that left its program: only a look at the other programs of its table settles it."""
