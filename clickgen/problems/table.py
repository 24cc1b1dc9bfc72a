"""Every code: severity, on or off, the rule that declares it, title. scripts/docs.py makes this from the rules."""

TABLE = """\
CG101 error   on  - the file is not readable as Python
CG102 error   on  - this statement has no place at the top level of a program
CG103 error   on  - a routine holds only rungs
CG104 error   on  - a rung has no else or elif
CG105 error   on  - and, or, not, &, | and ~ are not part of the language
CG106 error   on  - comparisons do not chain
CG107 error   on  - this is not a condition
CG108 error   on  - no such instruction
CG109 error   on  - the instruction has no such argument
CG110 error   on  - an argument is missing
CG111 error   on  - an argument is given twice
CG112 error   on  - this statement has no place in a rung
CG113 error   on  - this is not an address or a constant
CG114 error   on  - a routine is written def name(): with no parameters, subroutines under @sub
CG115 error   on  - an argument is of the wrong kind
CG116 error   on  - the formula cannot be read
CG117 error   on  - the formula has no such function
CG118 error   on  - the program is nested too deeply
CG119 error   on  - a for loop is written for _ in range(n):
CG120 error   on  - this import cannot be read
CG121 error   on  - the file of an import is missing
CG122 error   on  - files import each other in a circle
CG123 error   on  - the imported file has no such subroutine
CG140 error   on  - the program could not be judged
CG201 error   on  - the bank has no such address
CG202 error   on  - the range is empty, reversed or crosses a gap
CG203 error   on  - CLICK does not take this nickname
CG204 error   on  - one nickname is used for two banks
CG205 error   on  - two sources disagree about an address
CG206 error   on  - no such system nickname
CG207 error   on  - no timer or counter has this name
CG208 error   on  - the bank is full
CG209 error   on  - a name has no address and the table is frozen
CG210 warning on  - an input or output was given an address by clickgen
CG211 warning on  - ClickNick mishandles nicknames of XD and YD
CG212 error   on  - a pointer goes through a DS register
CG213 error   on  - this bank cannot be pointed into
CG214 error   on  - this is no member of a block
CG215 error   on  - one of CLICK's own names may mean two addresses
CG301 error   on  errors.operands the instruction does not take this operand
CG302 error   on  errors.operands the constant is out of range
CG303 error   on  errors.comparisons values of different kinds cannot be compared
CG304 error   on  errors.unwritable this address cannot be written
CG305 error   on  errors.copies CLICK cannot copy between these
CG306 error   on  errors.copies the range has the wrong length
CG307 error   on  errors.operands a pointer has no place here
CG308 error   on  errors.contacts immediate has no place here
CG309 error   on  errors.formulas hexadecimal and decimal values are mixed in one formula
CG310 error   on  - parentheses are nested more than 8 deep
CG311 error   on  - the formula has more than 68 operands
CG312 warning on  errors.copies sources disagree whether CLICK takes this
CG313 error   on  errors.operands oneshot has no place here
CG314 error   on  errors.copies this option has no place here
CG315 warning on  - a decimal number in a hexadecimal formula
CG316 error   on  errors.drums the lists of a drum do not fit together
CG317 error   on  errors.kept_tokens the ladder token cannot be kept
CG401 error   on  errors.no_main the program has no main
CG402 error   on  errors.routines two routines have the same name
CG403 error   on  errors.endings main has no unconditional end
CG404 error   on  errors.endings a subroutine does not end in an unconditional return
CG405 error   on  errors.calls no such subroutine
CG406 error   on  errors.calls a subroutine calls a subroutine
CG407 error   on  errors.loops a loop stands inside a loop
CG408 error   on  errors.loops a loop is not closed
CG409 error   on  errors.loops a loop is closed that is not open
CG410 error   on  errors.endings end belongs in main
CG411 error   on  errors.endings return belongs in a subroutine
CG412 error   on  errors.owners a timer or counter has two owners
CG413 error   on  errors.comments the rung comment is too long for CLICK
CG415 error   on  - a routine is too long for one CLICK file
CG416 error   on  errors.routines too many subroutines
CG417 error   on  errors.routines CLICK does not take this subroutine name
CG418 warning on  errors.pins a counter has no reset
CG419 warning on  errors.pins a shift register has no clock or no reset
CG420 info    on  errors.retentive_off_delay rtof is emulated
CG421 warning on  errors.comments CLICK shows part of this comment as styled text
CG422 error   on  errors.loops the end of a loop is not alone in an unconditional rung
CG423 warning on  errors.loops a timer stands inside a loop
CG424 warning on  - main is too long for one CLICK file and is split
CG425 error   on  errors.loops an action comes after the opening of a loop in its rung
CG426 error   on  errors.left_out a rung was left out by import
CG427 warning on  errors.loops a loop calls a subroutine with a loop
CG428 warning on  lowered.scratch_bits a pointer may write a scratch bit
CG429 warning on  - a block and a nickname have one name
CG430 warning on  errors.overruns a text can run past the last TXT address
CG431 warning on  errors.overruns a copy can run past its block or over another name
CG432 warning on  errors.chosen_points a word holds an input or output that clickgen chose
CG501 warning on  advice.double_coils an output coil is driven in two places
CG502 warning on  advice.set_never_reset a bit is set and never reset
CG503 warning on  advice.reset_never_set a bit is reset and never set
CG504 info    off advice.read_never_written an address is read and never written
CG505 info    off advice.written_never_read an address is written and never read
CG506 info    on  advice.unused_nickname a declared nickname is never used
CG507 warning on  advice.never_true a condition can never be true
CG508 warning on  advice.always_true a condition is always true
CG509 warning on  advice.repeated_terms a condition repeats a term
CG510 warning on  advice.overwritten_value a value is overwritten before anything reads it
CG511 warning on  advice.timer_equality a running value is compared for equality
CG512 warning on  advice.zero_setpoints a timer's setpoint is 0
CG513 warning on  advice.counter_edges a counter counts without an edge
CG514 warning on  advice.missed_edges an edge may be missed in a subroutine that does not always run
CG515 warning on  advice.uncalled_subroutine a subroutine is never called
CG516 warning on  advice.unreached_rung a rung is never reached
CG517 warning on  advice.zero_divisors a formula divides by zero
CG518 warning on  advice.lost_pointers a pointer may lead to no address
CG519 warning on  advice.short_slices a range looks one address short
CG520 warning on  advice.float_equality floating-point values are compared for equality
CG521 warning on  advice.ownerless_timer a timer's or counter's bit is used without its instruction
CG522 warning on  advice.scattered_output an output is driven from several routines
CG523 info    off advice.state_numbers a state number is repeated
CG524 info    on  advice.comparison_words a comparison is written as a word
CG525 warning on  - a suppression suppresses nothing
CG526 warning on  advice.range_alternatives a range among alternatives means all of its bits
CG527 warning on  advice.repeated_call a subroutine with timers or edges may run twice in a scan
CG528 warning on  advice.loop_counts a loop's count may be 0 or less
CG540 warning on  advice.misspelled_name a name looks like a misspelling of another
CG541 warning on  - a name left the program and its value stays behind
CG542 warning on  advice.stale_branch a branch looks at what its own rung writes
CG543 warning on  advice.coil_and_latch out and set or reset drive one bit
CG544 warning on  advice.undone_toggle a rung undoes in the same scan what a rung before it did
CG545 warning on  advice.frozen_output an output or timer may freeze in a subroutine that does not always run
CG546 warning on  advice.contending_messages two messages may want one port at the same time
CG550 warning on  - the initial value of a retentive address is masked
CG551 warning on  errors.modbus a Modbus number means a coil here and another register in a manual
CG552 warning on  advice.clock_values the clock has no such value
CG553 warning on  advice.impossible_maths a formula has no result
CG554 warning on  advice.unset_pointers a pointer is still 0 when it is used
CG555 warning on  advice.walking_pointers a pointer can walk over cells of other names
CG556 warning on  advice.lasting_steps a step is never left
CG557 warning on  advice.cleared_at_start a value that is to be kept is cleared in the first scan
CG558 warning on  advice.long_shifts a shift is longer than the word
CG601 error   on  - a row of the address table is malformed
CG602 error   on  - the address table gives a nickname or an address twice
CG603 error   on  - the address table holds a nickname that CLICK does not take
CG604 warning on  - part of a row of the workbook is left out
CG605 error   on  - the workbook and the address table beside it disagree
CG606 warning on  - marks of blocks in the address table do not fit
CG607 warning on  - a Modbus number in the address table is not that of its address
CG618 info    on  - rows of the workbook without a nickname are passed over
CG619 error   on  - a name of the program stands for spare points in the workbook
CG701 error   on  - a ladder file is damaged
CG702 error   on  - a rung cannot be kept as it is
CG703 error   on  - an imported rung would not do the same
CG704 warning on  - a rung is written otherwise than it is drawn
CG705 info    on  - something that does nothing is left out
CG706 warning on  - a nickname is left out
CG707 warning on  - what is imported is a part of a program
CG708 error   on  - what is read of a rung is not what its bytes say
CG709 warning on  - part of the comment of a rung is left out
CG710 error   on  - a capture holds a rung that the codec cannot decode
"""
