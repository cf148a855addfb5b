"""What does a zip hold, without ever extracting it?

Theory of operation: an archive is a stranger's claim. A name is compared and never used as a
path. The list of contents at the end is walked entry by entry, so that its length costs what it
really is and not what it says; the one file is unpacked until it has given as many bytes as
are wanted, whatever size it claims. Python's `zipfile` reads the whole list first: a list of
2.7 million entries took gigabytes.
"""

import stat
import struct
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from typing import BinaryIO

from grader.intake.candidates import DAMAGED, NOT_A_FILE, Damage, Entry, Fault
from grader.intake.gunzip import MOST_OVERHEAD

ZIP_MARKS = (b"PK\x03\x04", b"PK\x05\x06")

_END = struct.Struct("<4s8xLLH")
_END64 = struct.Struct("<4s36xQQ")
_LOCATOR_SIZE = 20
_LISTED = struct.Struct("<4s4xHH4xLLLHHH4xLL")
_LOCAL = struct.Struct("<4s22xHH")
_FIELD = struct.Struct("<HH")
_LONGEST_COMMENT = 0xFFFF
_IN_EXTRA = 0xFFFFFFFF
_ZIP64 = 1
_ENCRYPTED = 0x1
_STORED, _DEFLATED = 0, 8


@dataclass(frozen=True, slots=True)
class _Listed:
    """One entry of the list of contents; its sizes and its place are claims."""

    name: bytes
    flags: int
    method: int
    checksum: int
    packed: int
    place: int
    kind: int
    """File type of Unix, 0 if the archive was made on another system."""

    @property
    def path(self) -> str:
        """Not all programs say that they write UTF-8."""
        try:
            return self.name.decode()
        except UnicodeDecodeError:
            return self.name.decode("cp437")


def zip_entries(file: BinaryIO) -> Iterator[Entry]:
    """Everything that a zip lists.

    Raises:
        Damage: It is no zip, or not all of it is there.
    """
    for listed in _listing(file):
        yield Entry(listed.path, partial(_content, file, listed))


def _listing(file: BinaryIO) -> Iterator[_Listed]:
    place, end = _bounds(file)
    while place < end:
        file.seek(place)
        listed, length = _listed(file)
        place += length
        yield listed
    if place != end:
        raise Damage


def _bounds(file: BinaryIO) -> tuple[int, int]:
    """Where the list of contents starts and ends, as the end record claims.

    It has to lie right in front of that record: of two archives in one file, or of one behind
    another program, it is not clear what is handed in.
    """
    size = file.seek(0, 2)
    start = max(0, size - _LOCATOR_SIZE - _END.size - _LONGEST_COMMENT)
    file.seek(start)
    tail = file.read()
    at = _last_record(tail)
    _, length, place, _ = _END.unpack_from(tail, at)
    end = start + at
    if at >= _LOCATOR_SIZE and tail.startswith(b"PK\x06\x07", at - _LOCATOR_SIZE):
        end -= _LOCATOR_SIZE + _END64.size
        file.seek(max(0, end))
        mark, length, place = _END64.unpack(_exactly(file, _END64.size))
        if mark != b"PK\x06\x06":
            raise Damage
    if place + length != end:
        raise Damage
    return place, end


def _last_record(tail: bytes) -> int:
    """Where the end record is: the last one whose comment ends with the file, or the last.

    The first rule lets a comment hold the mark of a record, the second forgives what some
    systems append to a file.
    """
    places = []
    at = len(tail)
    while (at := tail.rfind(b"PK\x05\x06", 0, at)) >= 0:
        if at + _END.size <= len(tail):
            places.append(at)
            if at + _END.size + _END.unpack_from(tail, at)[3] == len(tail):
                return at
    if not places:
        raise Damage
    return places[0]


def _listed(file: BinaryIO) -> tuple[_Listed, int]:
    """Read one entry of the list, and how long it was."""
    fields = _LISTED.unpack(_exactly(file, _LISTED.size))
    mark, flags, method, checksum, packed, size, *lengths, attributes, place = fields
    if mark != b"PK\x01\x02":
        raise Damage
    name, extra = _exactly(file, lengths[0]), _exactly(file, lengths[1])
    wide = _wide_numbers(extra)
    if size == _IN_EXTRA:
        next(wide)
    packed = next(wide) if packed == _IN_EXTRA else packed
    place = next(wide) if place == _IN_EXTRA else place
    kind = stat.S_IFMT(attributes >> 16)
    listed = _Listed(name, flags, method, checksum, packed, place, kind)
    return listed, _LISTED.size + sum(lengths)


def _wide_numbers(extra: bytes) -> Iterator[int]:
    """Give the 64-bit numbers of an entry's ZIP64 field, and damage after the last one."""
    at = 0
    while at + _FIELD.size <= len(extra):
        name, length = _FIELD.unpack_from(extra, at)
        at += _FIELD.size
        if name == _ZIP64:
            # A field may be cut off by the end of all of them.
            whole = min(length, len(extra) - at) // 8 * 8
            for (number,) in struct.iter_unpack("<Q", extra[at : at + whole]):
                yield number
        at += length
    raise Damage


def _content(file: BinaryIO, listed: _Listed, most: int) -> bytes | Fault:
    if listed.flags & _ENCRYPTED:
        return Fault("the archive is encrypted; pack it again without a password")
    if listed.kind not in {0, stat.S_IFREG}:
        return NOT_A_FILE
    if listed.method not in {_STORED, _DEFLATED}:
        return Fault("packed by a rare method; pack it again as an ordinary zip")
    try:
        _seek_content(file, listed)
        if listed.method == _STORED:
            data, whole = file.read(min(listed.packed, most)), listed.packed <= most
        else:
            packed = file.read(min(listed.packed, most + MOST_OVERHEAD))
            data, whole = _inflated(packed, most)
    except (Damage, zlib.error):
        return DAMAGED
    if whole and zlib.crc32(data) != listed.checksum:
        return DAMAGED
    return data


def _seek_content(file: BinaryIO, listed: _Listed) -> None:
    """Go to the first packed byte of an entry, which has to have the name it is listed by."""
    if listed.place > file.seek(0, 2):
        raise Damage
    file.seek(listed.place)
    mark, name, extra = _LOCAL.unpack(_exactly(file, _LOCAL.size))
    if mark != b"PK\x03\x04" or _exactly(file, name) != listed.name:
        raise Damage
    _exactly(file, extra)


def _inflated(packed: bytes, most: int) -> tuple[bytes, bool]:
    """Unpack up to `most` bytes, and tell whether these are all."""
    inflate = zlib.decompressobj(-zlib.MAX_WBITS)
    data = inflate.decompress(packed, most)
    if not inflate.eof and len(data) < most:
        raise Damage
    return data, inflate.eof


def _exactly(file: BinaryIO, size: int) -> bytes:
    data = file.read(size)
    if len(data) != size:
        raise Damage
    return data
