"""Tests of grader/intake/zip.py through `locate`: what a zip may claim."""

import io
import stat
import struct
import zipfile
import zlib
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grader.intake.candidates import MOST_ENTRIES
from grader.intake.zip import zip_entries
from grader.model.stages import Submission
from tests.intake.archives import (
    CODE,
    LIMIT,
    NAME,
    end_record,
    listed_entry,
    local_entry,
    located,
    reason,
    zip_of_kind,
    zipped,
)

LOCAL = local_entry(NAME.encode(), CODE)
LISTED = listed_entry(NAME.encode(), CODE)
END = end_record(1, len(LISTED), len(LOCAL))
WIDE_RECORD = struct.pack(
    "<4sQHHLLQQQQ", b"PK\6\6", 44, 45, 45, 0, 0, 1, 1, len(LISTED), len(LOCAL)
)
LOCATOR = struct.pack("<4sLQL", b"PK\6\7", 0, len(LOCAL) + len(LISTED), 1)
WIDE_END = end_record(0xFFFF, 0xFFFFFFFF, 0xFFFFFFFF)


def wide_entry(*numbers: int) -> bytes:
    """List the file with its sizes and its place in a ZIP64 field."""
    extra = struct.pack(f"<HH{len(numbers)}Q", 1, 8 * len(numbers), *numbers)
    return listed_entry(NAME.encode(), CODE, 0xFFFFFFFF, extra)


def cut_wide_entry(left: int) -> bytes:
    """List the file with a ZIP64 field of which only some bytes are there."""
    extra = struct.pack("<HH", 1, 16) + bytes(left)
    return listed_entry(NAME.encode(), CODE, 0xFFFFFFFF, extra)


def with_list(listed: bytes) -> bytes:
    """Pack the file with another list of contents."""
    return LOCAL + listed + end_record(1, len(listed), len(LOCAL))


@pytest.mark.parametrize(
    "content",
    [
        LOCAL + LISTED + END,
        LOCAL + LISTED + WIDE_RECORD + LOCATOR + WIDE_END,
        with_list(wide_entry(len(CODE), len(CODE), 0)),
        LOCAL + LISTED + end_record(0, len(LISTED), len(LOCAL)),
        LOCAL + LISTED + end_record(9999, len(LISTED), len(LOCAL)),
        LOCAL + LISTED + END + b"\r\n",
        LOCAL + LISTED + end_record(1, len(LISTED), len(LOCAL), b"PK\5\6 is no record"),
        LOCAL + LISTED + end_record(1, len(LISTED), len(LOCAL), b"x" * 0xFFFF),
        zipped([(NAME, CODE)], zipfile.ZIP_STORED),
    ],
)
def test_what_is_unusual_but_clear_is_read(tmp_path: Path, content: bytes) -> None:
    """ZIP64, a wrong number of entries, something after the end, marks in a comment."""
    found = located(tmp_path, content)
    assert isinstance(found, Submission)
    assert found.source == CODE


@pytest.mark.parametrize(
    "content",
    [
        LOCAL,
        LOCAL + LISTED,
        LOCAL + LISTED + END[:-1],
        LOCAL + LISTED + end_record(1, 2**32 - 1, len(LOCAL)),
        LOCAL + LISTED + end_record(1, len(LISTED), 2**31),
        LOCAL + LISTED + end_record(1, len(LISTED) + 1, len(LOCAL)),
        LOCAL + LISTED + WIDE_END,
        LOCAL + LISTED + WIDE_RECORD[:-1] + LOCATOR + WIDE_END,
        (LOCAL + LISTED + WIDE_RECORD + LOCATOR + WIDE_END) * 2,
        LOCAL + LISTED + WIDE_RECORD[:-16] + b"\xff" * 16 + LOCATOR + WIDE_END,
        LOCAL + LISTED + bytes(56) + LOCATOR + WIDE_END,
        LOCAL + LISTED + END + LOCAL + LISTED + END,
        with_list(LISTED[:-5]),
        with_list(bytes(50)),
        with_list(wide_entry()),
        with_list(wide_entry(1, len(CODE))),
        with_list(wide_entry(1, len(CODE), 2**63)),
        with_list(wide_entry(1, 2**64 - 1, 2**64 - 1)),
        *(with_list(cut_wide_entry(left)) for left in (0, 1, 4, 8, 12)),
        with_list(listed_entry(NAME.encode(), CODE, 2**31)),
        with_list(listed_entry(NAME.encode(), CODE, 1)),
        with_list(listed_entry(b"src/" + NAME.encode(), CODE)),
        with_list(listed_entry(NAME.encode(), CODE + b"x")),
        with_list(listed_entry(NAME.encode(), CODE[::-1])),
    ],
)
def test_lies_are_damage(tmp_path: Path, content: bytes) -> None:
    """Records cut or outside the file, two archives in one, another name, size or content."""
    assert "the archive is damaged" in reason(located(tmp_path, content))


@pytest.mark.parametrize("name", [f"{NAME}\0.txt", f"{NAME}\0", f"{NAME}\n", f"{NAME} "])
def test_a_name_is_compared_to_its_end(tmp_path: Path, name: str) -> None:
    """No NUL and no space at the end makes another name ours."""
    assert "no file is called" in reason(located(tmp_path, zipped([(name, CODE)])))


def test_a_name_in_no_encoding_is_shown(tmp_path: Path) -> None:
    """Bytes that are not UTF-8 are read as the oldest programs wrote them."""
    name = b"\xff\x81/" + NAME.encode()
    local, listed = local_entry(name, CODE), listed_entry(name, CODE)
    found = located(tmp_path, local + listed + end_record(1, len(listed), len(local)))
    assert isinstance(found, Submission)
    assert found.path == f"\\xa0ü/{NAME}"


def test_one_entry_listed_often_is_one_file(tmp_path: Path) -> None:
    """Entries may overlap: nothing adds up, because copies are read a few times only."""
    bomb = zipped([(NAME, b" " * 2**26)])
    start, end = bomb.index(b"PK\1\2"), bomb.index(b"PK\5\6")
    listed = bomb[start:end] * MOST_ENTRIES
    content = bomb[:start] + listed + end_record(0, len(listed), start)
    assert "20,000 files are called" in reason(located(tmp_path, content))


@pytest.mark.parametrize("wide", [False, True])
def test_a_hidden_list_is_not_read_to_its_end(tmp_path: Path, wide: bool) -> None:
    """The number of entries is counted and not believed, whichever record claims it."""
    listed = listed_entry(b"", b"") * (MOST_ENTRIES + 1)
    record = struct.pack("<4s36xQQ", b"PK\6\6", len(listed), len(LOCAL))
    locator = struct.pack("<4sLQL", b"PK\6\7", 0, len(LOCAL + listed), 1)
    end = record + locator + WIDE_END if wide else end_record(1, len(listed), len(LOCAL))
    assert "more than 20,000 files" in reason(located(tmp_path, LOCAL + listed + end))


@pytest.mark.parametrize(
    "kind",
    [stat.S_IFLNK, stat.S_IFIFO, stat.S_IFCHR, stat.S_IFBLK, stat.S_IFSOCK, stat.S_IFDIR],
)
def test_links_and_devices_are_refused(tmp_path: Path, kind: int) -> None:
    """What a Unix archive says not to be a file is not read as one."""
    assert "is a link" in reason(located(tmp_path, zip_of_kind(NAME, kind)))


def test_an_encrypted_entry_is_refused(tmp_path: Path) -> None:
    """Nobody asks for the password."""
    content = bytearray(zipped([(NAME, CODE)]))
    for mark, offset in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
        content[content.index(mark) + offset] |= 1
    assert "encrypted" in reason(located(tmp_path, bytes(content)))


@pytest.mark.parametrize("method", [zipfile.ZIP_LZMA, zipfile.ZIP_BZIP2, 9, 93, 0xFFFF])
def test_a_rare_packing_method_is_refused(tmp_path: Path, method: int) -> None:
    """LZMA may ask for gigabytes of memory before the first byte."""
    content = bytearray(zipped([(NAME, CODE)]))
    struct.pack_into("<H", content, content.index(b"PK\1\2") + 10, method)
    assert "rare method" in reason(located(tmp_path, bytes(content)))


@pytest.mark.parametrize("claimed", [0, 10, 2**32 - 2])
def test_a_bomb_is_read_to_the_limit_only(tmp_path: Path, claimed: int) -> None:
    """64 MiB of zeros, and a header that lies about it."""
    bomb = bytearray(zipped([(NAME, bytes(2**26))]))
    assert "larger than 64 KiB" in reason(located(tmp_path, bytes(bomb)))
    struct.pack_into("<I", bomb, bomb.index(b"PK\1\2") + 24, claimed)
    assert "larger than 64 KiB" in reason(located(tmp_path, bytes(bomb)))


@pytest.mark.parametrize("block", [b"\0\0\0\xff\xff", b"\x02\x00"])
def test_packed_bytes_that_give_nothing_end(tmp_path: Path, block: bytes) -> None:
    """Empty blocks without end would be unpacked without end."""
    packed = block * 2**20 + b"\x03\x00"
    local, listed = (
        bytearray(make(NAME.encode(), packed)) for make in (local_entry, listed_entry)
    )
    struct.pack_into("<H4xL", listed, 10, 8, zlib.crc32(b""))
    content = local + listed + end_record(1, len(listed), len(local))
    assert "damaged" in reason(located(tmp_path, bytes(content)))


names = st.text(st.characters(exclude_categories=["Cs"]))


@given(
    st.lists(st.tuples(names, st.binary()), max_size=5, unique_by=lambda entry: entry[0]),
    st.sampled_from([zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED]),
)
def test_it_reads_what_the_standard_library_packs(
    entries: list[tuple[str, bytes]], method: int
) -> None:
    """The same names with the same content, in the same order."""
    content = io.BytesIO(zipped(entries, method))
    assert [(entry.path, entry.read(LIMIT)) for entry in zip_entries(content)] == entries
