"""Through which pointer does a function call, as far as it can be told?

A virtual function is called by its place in a table: an object begins with the address of a
table, and what stands at some distance in there is called. In the assembly text of a build
without optimisation the loads stand right before the call, so they are followed from row to
row. Only x86-64 is understood; on other machines a pointer may be for anything.
"""

import re
from dataclasses import dataclass, field

ANYTHING = b"*"
"""Stands for whatever a pointer points to; with a number behind it, for what has been loaded
at that distance, as from a table of virtual functions."""

MOST_PLACES = 64
"""A class with more virtual functions is not told from other tables."""

POINTER_CALL = re.compile(rb"^(call\w*\s+\*|blr\s)")
_MEMORY = rb"(-?\d{1,9}|)\((%r\w{1,3})\)"
_CALLED = re.compile(rb"^call\w*\s+\*(?:(%r\w{1,3})|" + _MEMORY + rb")$")
_MOVE = re.compile(
    rb"^movq\s+(?:(%r\w{1,3})|" + _MEMORY + rb"),\s*(?:(%r\w{1,3})|(-\d{1,9})\(%rbp\))$"
)
_ADD = re.compile(rb"^addq\s+\$(\d{1,9}),\s*(%r\w{1,3})$")
_CHANGED = re.compile(rb"(%r\w{1,3})$")
_CATCH = re.compile(rb"^call\w*\s+__cxa_begin_catch\b")

_POINTER_BYTES = 8
_CAUGHT = -1 << 40
"""Stands where a way begins at what a handler caught; no distance is as long."""

_Way = tuple[int, ...]
"""At what distances the last loads were that led to an address; empty if that is not known."""

_WHAT = (_CAUGHT, 0, 2 * _POINTER_BYTES)
"""The way to the third virtual function of what was caught: `std::exception::what`."""


def at_place(distance: int) -> bytes:
    """Name what stands at some distance in a table; just anything if it is none of a table."""
    place, rest = divmod(distance, _POINTER_BYTES)
    return ANYTHING + b"%d" % distance if 0 <= place < MOST_PLACES and not rest else ANYTHING


@dataclass(slots=True)
class Pointers:
    """What the registers of one function hold, as far as it was loaded or caught."""

    _held: dict[bytes, tuple[_Way, int]] = field(default_factory=dict)
    """How an address was found, and what has been added to it."""

    _caught: set[bytes] = field(default_factory=set)
    """Where on the stack the address of what a handler caught lies."""

    def called(self, row: bytes) -> bytes:
        """Name what a call through a pointer may call; nothing if it is `what` of an error."""
        call = _CALLED.match(code_of(row))
        way = self._moved(*call.groups()) if call else ()
        if way == _WHAT:
            return b""
        # What was loaded once may be a pointer to a function; an object has a table first.
        return at_place(way[-1]) if len(way) > 1 else ANYTHING

    def read(self, row: bytes) -> None:
        """Follow one row. Who jumps to a label brings other registers; a call leaves none."""
        row = code_of(row)
        if move := _MOVE.match(row):
            *source, register, slot = move.groups()
            self._move(self._moved(*source), register, slot)
        elif add := _ADD.match(row):
            way, added = self._held.get(add[2], ((), 0))
            self._held[add[2]] = (way, added + int(add[1]))
        elif row.endswith(b":") or row.startswith(b"call"):
            self._held.clear()
            if _CATCH.match(row):
                self._held[b"%rax"] = ((_CAUGHT,), 0)
        elif changed := _CHANGED.search(row):
            self._held.pop(changed[1], None)

    def _move(self, way: _Way, register: bytes, slot: bytes) -> None:
        if register:
            self._held[register] = (way, 0)
        elif way == (_CAUGHT,):
            self._caught.add(slot)
        else:
            self._caught.discard(slot)

    def _moved(self, register: bytes, distance: bytes, base: bytes) -> _Way:
        """Tell how that was found which a register holds, or memory at some distance."""
        if base == b"%rbp":
            return (_CAUGHT,) if distance in self._caught else ()
        way, added = self._held.get(base or register, ((), 0))
        if base:
            return (*way, int(distance or 0) + added)[-len(_WHAT) :]
        return () if added else way


def code_of(row: bytes) -> bytes:
    """Take the remarks of clang away."""
    return row.partition(b"#")[0].strip()
