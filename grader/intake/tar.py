"""What does a tar hold, without ever extracting it?

Theory of operation: a tar has no list of contents, so it is read from its start to its end, in
blocks of 512 bytes. Only three things are believed of an entry: its name, its kind and how far
the next one is. Python's `tarfile` believes more and paid for it: an extended header of two
megabytes kept it busy for hours, and lists of the holes in a sparse file took all memory.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from typing import BinaryIO

from grader.intake.candidates import DAMAGED, NOT_A_FILE, Damage, Entry, Fault
from grader.model.stages import SOURCE_NAME

BLOCK = 512
TAR_MARK = b"ustar"
TAR_MARK_PLACE = 257

MOST_EXTENDED = 4 * 2**20
"""Bytes of all extended headers together: 200 for each of 20,000 files."""

MOST_HEADERS = 8
"""Extended headers in front of one entry; programs write up to four."""

_NUMBER = re.compile(rb" *([0-7]*)[ \0]*")
_RECORD = re.compile(rb"([1-9][0-9]{0,8}) ([^=\n]*)=")
_CHUNK = 2**18
_NO_TAR = Fault(f"what is packed in it is no tar; hand in {SOURCE_NAME} or a .zip with it")
_SPARSE = Fault("packed with its holes left out; pack it again as an ordinary archive")

_FILES = (b"0", b"\0", b"7")
_WITHOUT_CONTENT = (b"1", b"2", b"3", b"4", b"5", b"6")
_LONG_NAME, _PAX, _SPARSE_FILE = b"L", b"x", b"S"
_SKIPPED = (b"K", b"g")
"""A long target of a link, and what PAX says of all files, which is never a name."""


@dataclass(frozen=True, slots=True)
class _Header:
    """What is believed of an entry."""

    name: bytes
    kind: bytes
    size: int


def tar_entries(stream: BinaryIO) -> Iterator[Entry]:
    """Everything in a tar.

    Args:
        stream: The archive; it is only read forward.

    Raises:
        Damage: It is no tar, or it is cut off.
    """
    return _Tar(stream).entries()


class _Tar:
    """Where the reading is, and what extended headers said of the next entry."""

    def __init__(self, stream: BinaryIO) -> None:
        self._stream = stream
        self._headers = 0
        self._left = 0
        self._extended = 0
        self._name = b""
        self._is_sparse = False

    def entries(self) -> Iterator[Entry]:
        headers = 0
        while header := self._header():
            headers += 1
            if headers > MOST_HEADERS:
                raise Damage
            if header.kind in _SKIPPED:
                self._skip()
            elif header.kind == _LONG_NAME:
                self._name = self._extension(header).split(b"\0")[0]
            elif header.kind == _PAX:
                self._believe(self._extension(header))
            else:
                path = (self._name or header.name).decode("utf-8", "surrogateescape")
                yield Entry(path, partial(self._content, header))
                self._name, self._is_sparse, headers = b"", False, 0
                self._skip()

    def _header(self) -> _Header | None:
        """Read a header; None at the end of the archive."""
        block = self._stream.read(BLOCK)
        if not block.strip(b"\0"):
            return None
        self._headers += 1
        header = _parsed(block)
        if header is None:
            raise Damage(_NO_TAR if self._headers == 1 else DAMAGED)
        if header.kind == _SPARSE_FILE:
            raise Damage(_SPARSE)
        content = 0 if header.kind in _WITHOUT_CONTENT else header.size
        self._left = content + -content % BLOCK
        return header

    def _extension(self, header: _Header) -> bytes:
        self._extended += header.size
        if self._extended > MOST_EXTENDED:
            raise Damage
        data = self._taken(header.size)
        self._skip()
        return data

    def _believe(self, pax: bytes) -> None:
        """Take the name from the records of a PAX header, `13 path=a.cpp` and a new line."""
        at = 0
        while record := _RECORD.match(pax, at):
            at += int(record[1])
            if record.end() >= at:
                raise Damage
            if record[2] == b"path":
                self._name = pax[record.end() : at - 1]
            self._is_sparse |= record[2].startswith(b"GNU.sparse.")

    def _content(self, header: _Header, most: int) -> bytes | Fault:
        if header.kind not in _FILES:
            return NOT_A_FILE
        return _SPARSE if self._is_sparse else self._taken(min(header.size, most))

    def _taken(self, size: int) -> bytes:
        data = self._stream.read(size)
        if len(data) != size:
            raise Damage
        self._left -= size
        return data

    def _skip(self) -> None:
        while self._left:
            self._taken(min(self._left, _CHUNK))


def _parsed(block: bytes) -> _Header | None:
    checksum, size = _number(block[148:156]), _number(block[124:136])
    if len(block) != BLOCK or checksum is None or size is None:
        return None
    if checksum != sum(block) - sum(block[148:156]) + 8 * ord(" "):
        return None
    name = _text(block[:100])
    if block[TAR_MARK_PLACE:].startswith(TAR_MARK + b"\0") and (
        folder := _text(block[345:500])
    ):
        name = folder + b"/" + name
    return _Header(name, block[156:157], size)


def _number(field: bytes) -> int | None:
    """Read a number: octal, or binary after a byte that says so; None if it is neither."""
    if field.startswith(b"\x80"):
        return int.from_bytes(field[1:])
    octal = _NUMBER.fullmatch(field)
    return int(octal[1] or b"0", 8) if octal else None


def _text(field: bytes) -> bytes:
    return field.split(b"\0")[0]
