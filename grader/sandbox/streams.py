"""What is kept of an output stream that never ends?"""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

CHUNK = 65536
PIPE_LIMIT = 1 << 20
"""Largest size of a pipe without privileges. Source: fs.pipe-max-size in proc(5)."""

DROPPED = b"\n[...]\n"


class Stream:
    """One output pipe: keeps the beginning and the end up to a cap, and drops the middle.

    A compiler's first error comes early, a sanitizer's report last.
    """

    def __init__(self, descriptor: int, cap: int) -> None:
        os.set_blocking(descriptor, False)
        self.descriptor = descriptor
        self._half = cap // 2
        self._head = bytearray()
        self._tail = bytearray()
        self._dropped = False

    @property
    def kept(self) -> bytes:
        """What was printed, with a mark where something was dropped."""
        return bytes(self._head) + DROPPED * self._dropped + bytes(self._tail)

    def drain(self) -> int | None:
        """Read what is there; the number of bytes, 0 at the end, None if nothing waits."""
        try:
            chunk = os.read(self.descriptor, CHUNK)
        except BlockingIOError:
            return None
        room = self._half - len(self._head)
        self._head += chunk[:room]
        self._tail += chunk[room:]
        surplus = len(self._tail) - self._half
        if surplus > 0:
            del self._tail[:surplus]
            self._dropped = True
        return len(chunk)

    def drain_all(self) -> None:
        """Take what a dead child left in the pipe, and no more than a pipe can hold.

        A process that left the group may still write, as fast as this reads.
        """
        for _ in range(PIPE_LIMIT // CHUNK):
            if not self.drain():
                return


@dataclass(slots=True)
class Pipe:
    """Both ends of a pipe, of which a child gets the one to write."""

    read: int
    write: int

    def close_write(self) -> None:
        """Close our copy of the child's end."""
        if self.write >= 0:
            os.close(self.write)
            self.write = -1


@contextmanager
def pipe() -> Iterator[Pipe]:
    """Make a pipe, and close what is left of it."""
    made = Pipe(*os.pipe())
    try:
        yield made
    finally:
        os.close(made.read)
        made.close_write()
