"""Archives for the tests of the intake, right and hostile ones."""

import io
import struct
import tarfile
import zipfile
import zlib
from collections.abc import Sequence
from pathlib import Path

from grader.intake.locate import locate
from grader.model.stages import Rejected, Submission

Entries = Sequence[tuple[str, bytes]]

CODE = b"void BVH::construct(const Mesh&) {}\n"
LIMIT = 64 * 1024
NAME = "exercise03.cpp"


def located(folder: Path, content: bytes, name: str = "s0427.zip") -> Submission | Rejected:
    """Locate in an archive with these bytes."""
    path = folder / name
    path.write_bytes(content)
    return locate(path, LIMIT)


def reason(found: Submission | Rejected) -> str:
    """The reason of a refusal, which is fit to be shown."""
    assert isinstance(found, Rejected)
    assert found.reason.isprintable()
    return found.reason


def zipped(entries: Entries, method: int = zipfile.ZIP_DEFLATED) -> bytes:
    """Pack a zip; the same name may come twice."""
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", method) as archive:
        for name, content in entries:
            archive.writestr(_info(name), content, method)
    return packed.getvalue()


def _info(name: str) -> zipfile.ZipInfo:
    # Through a second step, because the constructor cuts names at a NUL.
    info = zipfile.ZipInfo("x")
    info.filename = name
    return info


def zip_of_kind(name: str, kind: int) -> bytes:
    """Pack a zip whose only entry is of a file type of Unix: a link, a pipe, a device."""
    packed = io.BytesIO()
    info = zipfile.ZipInfo(name)
    info.create_system = 3
    info.external_attr = (kind | 0o777) << 16
    with zipfile.ZipFile(packed, "w") as archive:
        archive.writestr(info, "/etc/passwd")
    return packed.getvalue()


def tarred(entries: Entries, mode: str = "gz") -> bytes:
    """Pack a tar.gz, or with another mode a tar or tar.xz."""
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode=f"w:{mode}") as archive:  # type: ignore[call-overload]  # the mode is put together
        for name, content in entries:
            info = tarfile.TarInfo(name)
            info.size = len(content)
            archive.addfile(info, io.BytesIO(content))
    return packed.getvalue()


def special_tar(name: str, kind: bytes) -> bytes:
    """Pack a tar.gz whose only entry is a link, a pipe or a device."""
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w:gz") as archive:
        info = tarfile.TarInfo(name)
        info.type, info.linkname = kind, "/etc/passwd"
        archive.addfile(info)
    return packed.getvalue()


def local_entry(name: bytes, content: bytes) -> bytes:
    """Write what stands in front of an entry in a zip, and the entry, stored."""
    sizes = zlib.crc32(content), len(content), len(content), len(name), 0
    return struct.pack("<4s5HLLLHH", b"PK\3\4", 20, 0, 0, 0, 33, *sizes) + name + content


def listed_entry(name: bytes, content: bytes, place: int = 0, extra: bytes = b"") -> bytes:
    """Write what the list of contents of a zip says of a stored entry."""
    size = 0xFFFFFFFF if extra else len(content)
    start = struct.pack("<4s6H", b"PK\1\2", 20, 20, 0, 0, 0, 33)
    sizes = struct.pack("<LLLHHH", zlib.crc32(content), size, size, len(name), len(extra), 0)
    return start + sizes + struct.pack("<HHLL", 0, 0, 0, place) + name + extra


def end_record(count: int, length: int, place: int, comment: bytes = b"") -> bytes:
    """Write the last record of a zip."""
    numbers = 0, 0, count, count, length, place, len(comment)
    return struct.pack("<4s4HLLH", b"PK\5\6", *numbers) + comment


def tar_header(name: bytes, size: int | bytes, kind: bytes = b"0") -> bytes:
    """Write one block of a tar with a right checksum; the size may be no number."""
    block = bytearray(512)
    block[: len(name)] = name
    block[124:136] = size if isinstance(size, bytes) else b"%011o\0" % size
    block[148:156] = b" " * 8
    block[156:157] = kind
    block[257:265] = b"ustar\00000"
    block[148:156] = b"%06o\0 " % sum(block)
    return bytes(block)


def tar_entry(name: bytes, content: bytes, kind: bytes = b"0") -> bytes:
    """Write a header and its content, filled up to whole blocks."""
    return tar_header(name, len(content), kind) + content + bytes(-len(content) % 512)


def pax_record(key: bytes, value: bytes) -> bytes:
    """Write a record of a PAX header, which starts with its own length."""
    rest = b" " + key + b"=" + value + b"\n"
    length = len(rest)
    while length != len(rest) + len(str(length)):
        length = len(rest) + len(str(length))
    return str(length).encode() + rest
