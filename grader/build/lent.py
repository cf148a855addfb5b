"""Is a node that a vector lends only read?

In `construct`, which may change the nodes, `nodes[i].facesEnd` calls the operator that lends a
node to be changed, even where it is only read. In the assembly text of a build without
optimisation, what happens to the address stands right behind the call. If there are nothing but
loads until the registers hold something else, or a box is asked something, nothing is changed.
Only x86-64 is understood; on other machines every node that is lent counts as changed.
"""

import re
from dataclasses import dataclass

from grader.build.pointers import code_of

_LENDING = re.compile(
    rb"^call\w*\s+_ZN(St6vectorIN3BVH4NodeESaIS1_EE(?:ixEm|2atEm|4backEv|5frontEv))(?:@PLT)?$"
)
_CHANGING, _READING = b"_ZN", b"_ZNK"
"""How both functions that lend a node begin: `operator[]`, and `operator[] const`."""

_REGISTER = re.compile(rb"%[re]([a-d]x|[sd]i)\b")
_COPY = re.compile(rb"^movq\s+%r(?:[a-d]x|[sd]i),\s*%r([a-d]x|[sd]i)$")
_INTO_REGISTER = re.compile(rb"^(\w+)\s+(\S.*),\s*(%\w+)$")
_LOAD = re.compile(rb"^(?:mov|cmp|add|sub|u?comis)\w*\s+-?\d*\(%r\w+\),")
_OVERWRITES = (b"mov", b"lea")
_ASKS = re.compile(rb"^call\w*\s+_ZNK4AABB")
_AWAY = re.compile(rb"^(?:j|call|ret|leave)")
_KEPT = b"bx"
"""This register holds the same after a call."""


@dataclass(slots=True)
class Lent:
    """The node that one function was lent last, until it is clear what for."""

    _lender: bytes = b""
    _holders: frozenset[bytes] = frozenset()
    """The registers that hold its address."""

    _is_read: bool = False
    """Whether there was a load from it. An address is for a load or to be passed on, not both:
    the compiler asks for it again, as the source does."""

    def lends(self, row: bytes) -> bool:
        """Tell whether a row asks for a node; it is listed when it is clear what for."""
        call = _LENDING.match(code_of(row)) if row.startswith(b"call") else None
        if call:
            self._lender, self._holders, self._is_read = call[1], frozenset({b"ax"}), False
        return call is not None

    def read(self, row: bytes) -> bytes:
        """Follow one row; the name of the function that lent the node once that is clear."""
        if not self._lender or row.startswith(b"."):
            return b""
        row = code_of(row)
        if self._changes(row):
            return self.end()
        return b"" if self._holders else self.end(_READING)

    def end(self, beginning: bytes = _CHANGING) -> bytes:
        """Name who lent the node of which nothing more is heard; nothing if there is none."""
        lender, self._lender = self._lender, b""
        return beginning + lender if lender else b""

    def _changes(self, row: bytes) -> bool:
        """Tell whether a row may change the node, or leads to where it is not followed."""
        if _AWAY.match(row):
            is_harmless = self._is_read or _ASKS.match(row)
            is_kept, self._holders = _KEPT in self._holders, frozenset()
            return is_kept or not is_harmless
        if not self._held(row):
            return False
        into = _INTO_REGISTER.match(row)
        return into is None or self._moves_on(row, *into.groups())

    def _moves_on(self, row: bytes, verb: bytes, source: bytes, target: bytes) -> bool:
        """Tell whether the address, which a row reads from or overwrites, gets lost by it."""
        if self._held(source):
            if copy := _COPY.match(row):
                self._holders |= {copy[1]}
                return False
            if not _LOAD.match(row):
                return True
            self._is_read = True
        over = self._held(target)
        self._holders -= over
        return bool(over) and not verb.startswith(_OVERWRITES)

    def _held(self, words: bytes) -> frozenset[bytes]:
        return self._holders.intersection(_REGISTER.findall(words))
