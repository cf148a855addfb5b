"""What comes out of a gzip stream, a piece at a time and not without end.

Python's `gzip` reads a header byte by byte and takes any number of empty streams in a row:
both kept it busy for a minute.
"""

import io
import zlib
from typing import TYPE_CHECKING, BinaryIO

from grader.intake.candidates import Damage, Fault
from grader.model.stages import SOURCE_NAME

if TYPE_CHECKING:
    from _typeshed import WriteableBuffer

GZIP_MARK = b"\x1f\x8b"

MOST_MEMBERS = 100
"""Streams one after the other in one file; every ordinary program writes one."""

MOST_OVERHEAD = 2**20
"""Bytes by which what is packed may be longer than what comes out of it."""

_CHUNK = 2**16


class Gunzip(io.RawIOBase):
    """A stream that ends with `Damage` if it is cut, or once too much has come out of it."""

    def __init__(self, file: BinaryIO, most: int) -> None:
        """Start to unpack.

        Args:
            file: The gzip stream from its start.
            most: Bytes after which it is given up.
        """
        super().__init__()
        self._file = file
        self._most = most
        self._packed = self._given = self._members = 0
        self._start(b"")

    def _start(self, packed: bytes) -> None:
        self._waiting = packed
        self._inflate = zlib.decompressobj(zlib.MAX_WBITS | 16)

    def readable(self) -> bool:
        """It is made to be read."""
        return True

    def readinto(self, buffer: "WriteableBuffer", /) -> int:
        """Fill a part of a buffer; nothing at the end."""
        view = memoryview(buffer).cast("B")
        data = b""
        while not data and (not self._inflate.eof or self._goes_on()):
            data = self._some(len(view))
        view[: len(data)] = data
        return len(data)

    def _some(self, size: int) -> bytes:
        packed = self._waiting or self._taken()
        try:
            data = self._inflate.decompress(packed, size)
        except zlib.error:
            raise Damage from None
        ended = self._inflate.eof
        self._waiting = self._inflate.unused_data if ended else self._inflate.unconsumed_tail
        self._given += len(data)
        if self._given > self._most:
            much = f"unpacks to more than {self._most // 2**20} MiB"
            raise Damage(Fault(f"{much}; hand in only {SOURCE_NAME}"))
        is_cut = not (data or packed or ended)
        if is_cut or self._packed > self._given + MOST_OVERHEAD:
            raise Damage
        return data

    def _taken(self) -> bytes:
        packed = self._file.read(_CHUNK)
        self._packed += len(packed)
        return packed

    def _goes_on(self) -> bool:
        """Start to unpack the next stream if one follows; anything else is left alone."""
        if len(self._waiting) < len(GZIP_MARK):
            self._waiting += self._taken()
        if not self._waiting.startswith(GZIP_MARK):
            return False
        self._members += 1
        if self._members >= MOST_MEMBERS:
            raise Damage
        self._start(self._waiting)
        return True
