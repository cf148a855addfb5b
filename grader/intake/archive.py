"""What does a zip or tar.gz hold, without ever extracting it?

Theory of operation: an archive is a stranger's claim. Names are compared, never used as paths;
one entry is read, at most a given number of bytes; what a header says about sizes is not
believed. A tar.gz has to be unpacked to be searched, so that is capped. The archive is in
memory, so every `OSError` in here comes from its content and none from a disk of ours.
"""

import gzip
import io
import lzma
import stat
import struct
import tarfile
import zipfile
import zlib
from collections.abc import Callable

from grader.intake.candidates import MOST_ENTRIES, Candidate, Fault, choose, is_source

LARGEST_TAR = 256 * 2**20
"""Unpacked bytes of a tar.gz that are searched: about a second of work."""

_DAMAGE = (
    zipfile.BadZipFile,
    tarfile.TarError,
    zlib.error,
    lzma.LZMAError,
    struct.error,
    EOFError,
    IndexError,
    KeyError,
    NotImplementedError,
    OSError,
    OverflowError,
    RuntimeError,
    ValueError,
)
"""What zipfile, tarfile and gzip raise on bytes that are not what they claim to be."""

_DAMAGED = Fault("the archive is damaged; pack it again and open it once before handing it in")
_TOO_MANY = Fault(f"more than {MOST_ENTRIES:,} files; hand in only exercise03.cpp")
_END_RECORD = b"PK\x05\x06"
_END_SIZE = 22
_LONGEST_COMMENT = 0xFFFF
_PLAIN = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
_ENCRYPTED = 0x1


def from_zip(file: io.BytesIO) -> Candidate | Fault:
    """Find the one source file in a zip archive."""
    try:
        if not _few_entries(file):
            return _TOO_MANY
        archive = zipfile.ZipFile(file)
    except _DAMAGE:
        return _DAMAGED
    entries = [entry for entry in archive.infolist() if not entry.is_dir()]
    found = [
        Candidate(entry.filename, _zip_reader(archive, entry))
        for entry in entries
        if is_source(entry.filename)
    ]
    return choose(found, (entry.filename for entry in entries))


def _few_entries(file: io.BytesIO) -> bool:
    """The list of contents is short enough to be read: its end record is looked at first.

    ZIP64 archives, made for more than 65,535 files or 4 GB, carry their maximum here.
    """
    size = file.seek(0, 2)
    file.seek(max(0, size - _END_SIZE - _LONGEST_COMMENT))
    tail = file.read()
    place = tail.rfind(_END_RECORD)
    if place < 0:
        raise zipfile.BadZipFile
    count, listing = struct.unpack_from("<HI", tail, place + 10)
    zip64 = tail[max(0, place - 20) : place].startswith(b"PK\x06\x07")
    return count <= MOST_ENTRIES and listing <= MOST_ENTRIES * 512 and not zip64


def _zip_reader(
    archive: zipfile.ZipFile, entry: zipfile.ZipInfo
) -> Callable[[int], bytes | Fault]:
    def read(most: int) -> bytes | Fault:
        mode = entry.external_attr >> 16
        if entry.flag_bits & _ENCRYPTED:
            return Fault("the archive is encrypted; pack it again without a password")
        if stat.S_IFMT(mode) not in {0, stat.S_IFREG}:
            return Fault("this is a link and not a file; hand in the file itself")
        if entry.compress_type not in _PLAIN:
            return Fault("packed by a rare method; pack it again as an ordinary zip")
        try:
            with archive.open(entry) as file:
                return file.read(most)
        except _DAMAGE:
            return _DAMAGED

    return read


class _Capped(io.RawIOBase):
    """A stream that ends with an error once too much has come out of it."""

    def __init__(self, file: io.BytesIO | gzip.GzipFile, most: int) -> None:
        super().__init__()
        self._file = file
        self.left = most

    def read(self, size: int = -1, /) -> bytes:
        """Give up to `size` bytes; all that may still come if `size` is negative."""
        data = self._file.read(min(size, self.left + 1) if size >= 0 else self.left + 1)
        self.left -= len(data)
        if self.left < 0:
            raise EOFError
        return data


def from_tar(file: io.BytesIO, most: int, largest: int = LARGEST_TAR) -> Candidate | Fault:
    """Find the one source file in a tar.gz, or in a tar.

    Args:
        file: The archive.
        most: How many bytes of the source file are kept.
        largest: Unpacked bytes after which the search ends.
    """
    packed = file.read(2) == b"\x1f\x8b"
    file.seek(0)
    stream = _Capped(gzip.GzipFile(fileobj=file) if packed else file, largest)
    try:
        return _from_tar_stream(stream, most)
    except _DAMAGE:
        if stream.left < 0:
            return Fault(
                f"unpacks to more than {largest // 2**20} MiB; hand in only exercise03.cpp"
            )
        return _DAMAGED


def _from_tar_stream(stream: _Capped, most: int) -> Candidate | Fault:
    found: list[Candidate] = []
    others: list[str] = []
    with tarfile.open(fileobj=stream, mode="r|") as archive:
        for count, entry in enumerate(archive):
            if count >= MOST_ENTRIES:
                return _TOO_MANY
            if not entry.isdir():
                others.append(entry.name)
            if is_source(entry.name) and not entry.isdir():
                found.append(_kept(archive, entry, most))
    return choose(found, others)


def _kept(archive: tarfile.TarFile, entry: tarfile.TarInfo, most: int) -> Candidate:
    """Read the entry at once: a stream has no way back."""
    content: bytes | Fault = Fault("this is a link and not a file; hand in the file itself")
    if entry.isreg():
        file = archive.extractfile(entry)
        content = file.read(most) if file else _DAMAGED
    return Candidate(entry.name, lambda _: content)
