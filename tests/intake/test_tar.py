"""Tests of grader/intake/tar.py through `locate`: what a tar may claim."""

import gzip
import io
import tarfile
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grader.intake.tar import MOST_EXTENDED, MOST_HEADERS, tar_entries
from grader.model.stages import Submission
from tests.intake.archives import (
    CODE,
    LIMIT,
    NAME,
    located,
    pax_record,
    reason,
    special_tar,
    tar_entry,
    tar_header,
    tarred,
)

FILE = tar_entry(NAME.encode(), CODE)
END = bytes(1024)


def pax(*records: tuple[bytes, bytes]) -> bytes:
    """Write a PAX header."""
    return tar_entry(b"PaxHeader", b"".join(pax_record(*record) for record in records), b"x")


@pytest.mark.parametrize(
    "content",
    [
        FILE + END,
        FILE,
        FILE + bytes(512) + b"left over",
        FILE + END + tar_entry(NAME.encode(), b"another archive"),
        tar_entry(b"x", b"y" * 700, b"V") + FILE,
        tar_entry(b"x", b"", b"5") + FILE + END,
        tar_header(b"link", 700, b"1") + FILE,
        tar_header(NAME.encode(), (b" %o " % len(CODE)).ljust(12, b"\0")) + FILE[512:],
        tar_header(NAME.encode(), b"\x80" + bytes(10) + bytes([len(CODE)])) + FILE[512:],
        tar_entry(NAME.encode(), CODE, b"\0"),
        tar_entry(NAME.encode(), CODE, b"7"),
        pax((b"path", NAME.encode())) + tar_entry(b"x" * 100, CODE),
        pax((b"comment", b"12 path=a.cpp\n" * 99)) + FILE,
        pax((b"path", b"a"), (b"path", NAME.encode())) + tar_entry(b"x", CODE),
        tar_entry(b"g", pax_record(b"path", b"a"), b"g") + FILE,
        tar_entry(b"L", b"long/" * 99 + NAME.encode() + b"\0", b"L") + tar_entry(b"x", CODE),
        tar_entry(b"K", b"target\0", b"K") + FILE,
    ],
)
def test_what_is_unusual_but_clear_is_read(tmp_path: Path, content: bytes) -> None:
    """No end, something after it, long names, kinds of files that nobody uses."""
    found = located(tmp_path, content, "s.tar")
    assert isinstance(found, Submission)
    assert found.source == CODE
    assert found.path.endswith(NAME)


@pytest.mark.parametrize(
    "content",
    [
        FILE[:700],
        FILE[:-1],
        FILE + b"x",
        FILE + b"x" * 512,
        tar_header(NAME.encode(), 0o77777777777),
        FILE + tar_header(b"b", b"\xff" * 12) + END,
        FILE + tar_header(b"b", b"\x80" + b"\xff" * 11) + END,
        FILE + tar_header(b"b", b"-0000000001\0") + END,
        FILE + tar_header(b"b", b"0x000000010\0") + END,
        FILE + tar_header(b"b", b"1_000000000\0") + END,
        tar_header(b"x", MOST_EXTENDED + 1, b"x") + bytes(MOST_EXTENDED + 512) + FILE,
        pax((b"a", b"b")) * (MOST_HEADERS + 1) + FILE,
        tar_entry(b"x", b"5 path=" + NAME.encode() + b"\n", b"x") + FILE,
        tar_entry(b"x", b"9 " + b"a" * 9999 + b"=\n", b"x") + FILE,
        tar_header(b"L", 9999, b"L"),
    ],
)
def test_lies_are_damage(tmp_path: Path, content: bytes) -> None:
    """Cut, of no or a negative or an endless size, extended without end."""
    assert "the archive is damaged" in reason(located(tmp_path, content, "s.tar"))


@pytest.mark.parametrize("digits", [10, 2**21])
def test_a_header_of_digits_takes_no_time(tmp_path: Path, digits: int) -> None:
    """A pattern of Python's reader needs the square of the length."""
    content = tar_entry(b"x", b"1" * digits, b"x") + FILE
    assert isinstance(located(tmp_path, content, "s.tar"), Submission)


@pytest.mark.parametrize("kind", [b"1", b"2", b"3", b"4", b"6", b"Z"])
def test_links_and_devices_are_refused(tmp_path: Path, kind: bytes) -> None:
    """Links, devices, a pipe and what nobody knows are no source file."""
    assert "is a link" in reason(located(tmp_path, special_tar(NAME, kind)))


@pytest.mark.parametrize(
    "content",
    [
        tar_header(NAME.encode(), 0, b"S") + END,
        pax((b"GNU.sparse.major", b"1"), (b"GNU.sparse.minor", b"0")) + FILE,
        pax((b"GNU.sparse.map", b"0,1" * 9999)) + FILE,
    ],
)
def test_files_with_holes_are_refused(tmp_path: Path, content: bytes) -> None:
    """A list of holes makes gigabytes of nothing, and no source file has any."""
    assert "with its holes left out" in reason(located(tmp_path, content, "s.tar"))


def test_other_files_with_holes_do_no_harm(tmp_path: Path) -> None:
    """What is said of one entry is not said of the next."""
    content = pax((b"GNU.sparse.major", b"1")) + tar_entry(b"x", b"") + FILE
    assert isinstance(located(tmp_path, content, "s.tar"), Submission)


def test_another_gzip_file_is_named(tmp_path: Path) -> None:
    """Who packs the file alone is told so; a tar in a tar is not opened."""
    assert "no tar" in reason(located(tmp_path, gzip.compress(CODE * 99), f"{NAME}.gz"))
    nested = tarred([("inner.tar.gz", tarred([(NAME, CODE)]))])
    assert "there is `inner.tar.gz`" in reason(located(tmp_path, nested))


names = st.text(st.characters(exclude_categories=["Cs"], exclude_characters="\0")).filter(
    lambda name: not name.endswith("/")
)


@given(
    st.lists(st.tuples(names, st.binary(max_size=2000)), max_size=5),
    st.sampled_from([tarfile.GNU_FORMAT, tarfile.PAX_FORMAT]),
)
def test_it_reads_what_the_standard_library_packs(
    entries: list[tuple[str, bytes]], form: int
) -> None:
    """The same names with the same content, in the same order."""
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w", format=form) as archive:
        for name, content in entries:
            info = tarfile.TarInfo(name)
            info.size = len(content)
            archive.addfile(info, io.BytesIO(content))
    packed.seek(0)
    assert [(entry.path, entry.read(LIMIT)) for entry in tar_entries(packed)] == entries
