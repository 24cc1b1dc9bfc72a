"""Finds the known word that somebody meant: it corrects only slips of the keyboard, never a word of another meaning.

A suggestion in a control program gets followed. So it has to be the only word that is near, its numbers have to be the
same, and a word that is spelled correctly is no misspelling of another: ``Start`` is never taken for ``Restart``, nor
``Pump1_Run`` for ``Pump2_Run``.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

_LONG = 8
"""From this many characters on, a word may differ in two places."""
_SHORT = 3
"""Changing one letter turns words of this many letters into other words."""
_MOST = 3
"""Up to this many words are named when they are equally near; if there are more, none is."""

_PART = re.compile(r"[^\W\d_]+|\d+")
_CAMEL = re.compile(r"[A-Z]+(?=[A-Z][a-z])|[A-Z]?[a-z]+|[A-Z]+|[^\W\d_A-Za-z]+")
_NUMBER = re.compile(r"\d+")

_OPPOSITES = """
    all/any/none and/or/not on/off set/reset set/clear start/stop run/stop open/close opened/closed opening/closing
    enable/disable enabled/disabled up/down left/right forward/reverse forward/backward fwd/rev in/out inlet/outlet
    input/output high/low upper/lower top/bottom front/back front/rear max/min first/last begin/end auto/manual/hand
    automatic/manual local/remote lock/unlock locked/unlocked load/unload loaded/unloaded fill/drain fill/empty
    full/empty inc/dec increment/decrement increase/decrease raise/lower rise/fall rising/falling extend/retract
    extended/retracted advance/retract push/pull clamp/unclamp latch/unlatch grip/release heat/cool heating/cooling
    hot/cold supply/return suction/discharge north/south east/west normal/fault ok/fault ready/fault good/bad
    pass/fail accept/reject true/false yes/no read/write send/receive tx/rx push/pop before/after old/new prev/next
    previous/next source/destination src/dst actual/setpoint value/limit day/night summer/winter lead/lag
    master/slave client/server primary/secondary main/standby inner/outer inside/outside above/below plus/minus
    add/sub mul/div increasing/decreasing engage/disengage connect/disconnect connected/disconnected attach/detach
    active/inactive valid/invalid complete/incomplete ton/tof/rton/rtof ctu/ctd/ctud re/fe nc/no
"""
_OTHER_WORDS = """
    stat state status step steps stage cycle count counter counts timer time timeout delay alarm alarms warning error
    errors trip tripped request requested command feedback position speed level flow temp temperature pressure motor
    pump valve fan belt conveyor door gate guard tank hopper mixer heater cooler sensor switch button lamp light horn
    beacon relay contactor drive brake axis servo robot arm part parts pallet box bottle batch recipe mode hold pause
    resume home jog index abort estop safe safety test text total sum average rate ratio scale offset gain spare copy
    call calc mov move mask bit byte word data flag index pointer out done busy idle wait waiting work working
    sent send end add and area air oil water steam gas acid base feed feeder seed weed heed need reel real reed deal
    dial seal steel steam stem item limit limits line lane lamp damp ramp camp clamp cramp tramp stamp hand band
    land sand bend lend mend head lead load road roll poll pool tool cool heat meat seat beat peak leak weak week
    rate gate date late lift left loft shift shaft draft craft hose nose rose dose dosing closing losing moving
    form from farm firm film fill full fell felt belt bolt boil coil soil foil toil foot boot root room boom broom
    press pressed present preset reset resets units unit until under order border number lumber
"""

_WORDS = frozenset(re.findall(r"\w+", _OPPOSITES + _OTHER_WORDS))
"""Words that people spell correctly: one of them in place of another is another meaning, not a slip."""

_GROUPS = [frozenset(group.split("/")) for group in _OPPOSITES.split()]
_PREFIXES = ("re", "un", "de", "dis", "in", "im", "non", "not", "no", "anti", "pre", "post", "over", "under", "a", "n")


def near_words(word: str, known: Iterable[str]) -> list[str]:
    """The known words that this one may be a misspelling of: one, a few that are equally near, or none."""
    spelled = {name.lower(): name for name in known}
    lower = word.lower()
    if lower in spelled:
        return [spelled[lower]]
    limit = 1 if len(word) < _LONG else 2
    best: list[str] = []
    for candidate in spelled:
        distance = _distance(lower, candidate, limit)
        if distance < limit:
            # A nearer one displaces those before it.
            best, limit = [candidate], distance
        elif distance == limit:
            best.append(candidate)
    near = [spelled[candidate] for candidate in best]
    if not near or len(near) > _MOST or not all(is_slip(word, name) for name in near):
        return []
    return sorted(near)


def is_slip(written: str, meant: str) -> bool:
    """True if one word may be a misspelling of the other, and cannot be a word of another meaning."""
    numbers, others = (_NUMBER.findall(text) for text in (written, meant))
    if [number.lstrip("0") for number in numbers] != [number.lstrip("0") for number in others]:
        return False
    parts, wanted = _parts(written), _parts(meant)
    if "".join(parts) == "".join(wanted):
        return True
    if len(parts) != len(wanted):
        # One word in two, or two in one: nothing may have been added.
        extra = [part for part in parts if part not in wanted] + [part for part in wanted if part not in parts]
        joined, other = "".join(parts), "".join(wanted)
        return all(len(part) > 2 and part not in _WORDS for part in extra) and _is_misspelled(joined, other)
    return all(one == other or _is_misspelled(one, other) for one, other in zip(parts, wanted, strict=True))


def are_opposed(one: str, other: str) -> bool:
    """True for two words of opposite meaning, such as set and reset."""
    one, other = one.lower(), other.lower()
    if one == other:
        return False
    if any(one in group and other in group for group in _GROUPS):
        return True
    short, long = sorted((one, other), key=len)
    return long.endswith(short) and long.removesuffix(short) in _PREFIXES


def _is_misspelled(written: str, meant: str) -> bool:
    """True if a single word may be a slip for another: its first letter is correct, and it is no word itself."""
    if are_opposed(written, meant):
        return False
    if len(meant) <= 2 or len(written) <= 2:
        # Two letters are too few to tell, unless one was typed twice or one of three was left out.
        doubled = len(meant) == 2 and len(written) == 3 and set(written) == set(meant) and written[0] == meant[0]
        return doubled or (len(meant) == 3 and meant.startswith(written) and len(written) == 2)
    if f"{meant}s" == written or f"{written}s" == meant:
        return True
    if len(meant) <= _SHORT and not _is_mistyped(written, meant):
        return False
    return written not in _WORDS and written[:1] == meant[:1]


def _is_mistyped(written: str, meant: str) -> bool:
    """True if letters of a short word were exchanged, doubled or left out: with another letter it is another word.

    ``ANB``, ``RND`` and ``SIGN`` of other machines are no misspellings of any, RAD and SIN.
    """
    if len(written) == len(meant):
        return sorted(written) == sorted(meant)
    return set(written) == set(meant) if len(written) > len(meant) else set(written) < set(meant)


def _parts(name: str) -> list[str]:
    """Split ``Pump1_RunFast`` into pump, run and fast; the numbers are compared separately."""
    letters = (part for part in _PART.findall(name) if not part.isdigit())
    return [word.lower() for part in letters for word in _CAMEL.findall(part)]


def _distance(one: str, other: str, limit: int) -> int:
    """How many letters were added, left out, changed or exchanged with their neighbour; ``limit + 1`` for more."""
    if abs(len(one) - len(other)) > limit:
        return limit + 1
    start, stop = 0, min(len(one), len(other))
    while start < stop and one[start] == other[start]:
        start += 1
    end = 0
    while end < stop - start and one[-1 - end] == other[-1 - end]:
        end += 1
    one, other = one[start : len(one) - end], other[start : len(other) - end]
    if limit == 1 or max(len(one), len(other)) < 2:
        if len(one) == len(other) == 2 and one == other[::-1]:
            return 1
        return max(len(one), len(other)) if max(len(one), len(other)) <= limit else limit + 1
    before: list[int] = []
    row = list(range(len(other) + 1))
    for index, letter in enumerate(one, 1):
        older, before, row = before, row, [index]
        for at, wanted in enumerate(other, 1):
            cost = min(before[at] + 1, row[at - 1] + 1, before[at - 1] + (letter != wanted))
            if index > 1 and at > 1 and letter == other[at - 2] and one[index - 2] == wanted:
                cost = min(cost, older[at - 2] + 1)
            row.append(cost)
        if min(row) > limit:
            return limit + 1
    return min(row[-1], limit + 1)
