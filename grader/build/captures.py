"""Which function objects are filled with a lambda that holds the object's own address?

`std::function<void(int)> f = [&](int i) { ... f(i + 1); };` captures `f` only because its body
uses it. In the assembly text of a build without optimisation, the closure is laid out on the
stack before the call that fills the object: one pointer beside the other, and one of them is
the address that the call gets as its first argument. Only x86-64 is understood; on other
machines nothing is found, and nobody is blamed for that.
"""

import re
from dataclasses import dataclass, field

_MOVE = re.compile(rb"^\s*(lea|mov)q\s+([^,#\s][^,#]*),\s*([^,#\s]+)")
_SLOT = re.compile(rb"^(-\d{1,9})\(%rbp\)$")
_FILL = re.compile(rb"^\s*callq?\s+(_ZNSt8functionI[\w.$\x80-\xff]{1,4096})")
_FILLING = re.compile(rb"E(?:C[12]I|aSI)")
_POINTER_BYTES = 8


@dataclass(slots=True)
class Frame:
    """What registers and stack slots of one function hold, as far as it is an address of it."""

    _held: dict[bytes, int | None] = field(default_factory=dict)
    _stored: dict[int, int | None] = field(default_factory=dict)

    def read(self, row: bytes) -> bytes:
        """Follow one row; the name of the called function if it fills such an object."""
        if move := _MOVE.match(row):
            self._move(*move.groups())
        elif (call := _FILL.match(row)) and _FILLING.search(call[1]):
            return call[1] if self._holds_itself() else b""
        return b""

    def _move(self, how: bytes, source: bytes, target: bytes) -> None:
        slot = _SLOT.match(source)
        if how == b"lea":
            value = int(slot[1]) if slot else None
        else:
            value = self._stored.get(int(slot[1])) if slot else self._held.get(source)
        if into := _SLOT.match(target):
            self._stored[int(into[1])] = value
        else:
            self._held[target] = value

    def _holds_itself(self) -> bool:
        """Tell whether the closure, given second, holds the address that is given first."""
        filled, place = self._held.get(b"%rdi"), self._held.get(b"%rsi")
        found = False
        while filled is not None and place is not None and place in self._stored:
            found |= self._stored.pop(place) == filled
            place += _POINTER_BYTES
        return found
