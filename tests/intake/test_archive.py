"""Tests of grader/intake/archive.py through `locate`: zip and tar.gz."""

import io
import struct
import tarfile
import zipfile
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grader.intake import archive
from grader.intake.candidates import MOST_ENTRIES, Candidate, Fault
from grader.intake.locate import locate
from grader.model.stages import Rejected, Submission
from tests.intake.archives import Entries, linked_zip, special_tar, tarred, zipped

CODE = b"void BVH::construct(const Mesh&) {}\n"
LIMIT = 64 * 1024
NAME = "exercise03.cpp"
PACKERS = [zipped, tarred]


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


@pytest.mark.parametrize("pack", PACKERS)
@pytest.mark.parametrize(
    "inside",
    [NAME, f"src/{NAME}", f"../../{NAME}", f"/etc/{NAME}", f"C:\\src\\{NAME}", f"a\nb/{NAME}"],
)
@pytest.mark.parametrize("name", ["s0427.zip", "s0427.tar.gz", "s0427.tgz", "s0427"])
def test_the_one_file_is_read(tmp_path: Path, pack: object, inside: str, name: str) -> None:
    """The content decides how it is packed, and no name in it is used as a path."""
    assert callable(pack)
    junk = [("__MACOSX/._" + NAME, b"x"), (f".git/{NAME}", b"x"), ("notes.txt", b"x")]
    found = located(tmp_path, pack([*junk, (inside, CODE)]), name)
    assert isinstance(found, Submission)
    assert (found.student, found.source) == ("s0427", CODE)
    assert found.path.isprintable()
    assert found.path.endswith(NAME)
    assert [path.name for path in tmp_path.iterdir()] == [name]


def test_a_plain_tar_is_read(tmp_path: Path) -> None:
    """A tar that nobody compressed."""
    found = located(tmp_path, tarred([(NAME, CODE)], mode=""), "a.tar")
    assert isinstance(found, Submission)


@pytest.mark.parametrize("pack", PACKERS)
@pytest.mark.parametrize(
    ("entries", "expected"),
    [
        ([], f"no file is called {NAME}"),
        ([("src/", b"")], f"no file is called {NAME}"),
        ([("a.zip", b"x"), ("b.txt", b"")], "there is `a.zip`"),
        ([("\u202ea\x1b.cpp", b"x")], "there is `\\u202ea\\x1b.cpp`"),
        ([("a/" + NAME, CODE), ("b/" + NAME, CODE)], f"(`a/{NAME}`, `b/{NAME}`)"),
        ([(NAME, b"")], "the file is empty"),
        ([("x/" + NAME, CODE.decode().encode("utf-16"))], f"x/{NAME}: the file is saved as"),
        ([(NAME, b"x" * (LIMIT + 1))], "larger than 64 KiB"),
        ([("x" * 300 + "/" + NAME, b"")], f"…{'x' * 44}/{NAME}: the file is empty"),
    ],
)
def test_what_is_packed_wrongly_is_said(
    tmp_path: Path, pack: object, entries: Entries, expected: str
) -> None:
    """None, two, empty, UTF-16, too large."""
    assert callable(pack)
    assert expected in reason(located(tmp_path, pack(entries)))


@pytest.mark.filterwarnings("ignore:Duplicate name")
def test_one_name_twice_is_two_files(tmp_path: Path) -> None:
    """Unpackers differ in which one wins, so we do not choose."""
    assert "2 files are called" in reason(
        located(tmp_path, zipped([(NAME, CODE), (NAME, b"x")]))
    )


def test_links_in_archives_are_refused(tmp_path: Path) -> None:
    """A link, a pipe and a device are no source file."""
    assert "is a link" in reason(located(tmp_path, linked_zip(NAME, "/etc/passwd")))
    for kind in (tarfile.SYMTYPE, tarfile.LNKTYPE, tarfile.FIFOTYPE, tarfile.CHRTYPE):
        assert "is a link" in reason(located(tmp_path, special_tar(NAME, kind)))


def test_an_encrypted_entry_is_refused(tmp_path: Path) -> None:
    """Nobody asks for the password."""
    content = bytearray(zipped([(NAME, CODE)]))
    for mark, offset in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
        content[content.index(mark) + offset] |= 1
    assert "encrypted" in reason(located(tmp_path, bytes(content)))


def test_a_zip_bomb_is_read_to_the_limit_only(tmp_path: Path) -> None:
    """64 MiB of zeros, and a header that lies about it."""
    honest = zipped([(NAME, bytes(2**26))])
    assert "larger than 64 KiB" in reason(located(tmp_path, honest))
    lying = bytearray(honest)
    struct.pack_into("<I", lying, lying.index(b"PK\x01\x02") + 24, 10)
    assert isinstance(located(tmp_path, bytes(lying)), Rejected)


def test_a_tar_bomb_is_unpacked_to_the_limit_only() -> None:
    """The search ends where the cap is."""
    bomb = tarred([("zeros", bytes(2**22)), (NAME, CODE)])
    found = archive.from_tar(io.BytesIO(bomb), LIMIT, largest=2**20)
    assert isinstance(found, Fault)
    assert found.reason.startswith("unpacks to more than 1 MiB")
    assert isinstance(archive.from_tar(io.BytesIO(bomb), LIMIT, largest=2**23), Candidate)


def test_too_many_entries_are_not_listed(tmp_path: Path) -> None:
    """A long list of contents is refused before it is read."""
    many = [(f"{number}", b"") for number in range(MOST_ENTRIES + 1)]
    assert "more than 20,000 files" in reason(located(tmp_path, zipped(many)))
    assert "more than 20,000 files" in reason(located(tmp_path, tarred(many)))


@pytest.mark.parametrize("claim", ["zip64", "long"])
def test_a_claim_of_a_huge_list_is_refused(tmp_path: Path, claim: str) -> None:
    """The end record says how much would be read, and that is looked at first."""
    content = bytearray(zipped([(NAME, CODE)]))
    end = content.index(b"PK\x05\x06")
    if claim == "zip64":
        content[end:end] = b"PK\x06\x07" + bytes(16)
    else:
        struct.pack_into("<I", content, end + 12, 2**30)
    assert "more than 20,000 files" in reason(located(tmp_path, bytes(content)))


def test_a_rare_packing_method_is_refused(tmp_path: Path) -> None:
    """LZMA may ask for gigabytes of memory before the first byte."""
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_LZMA) as made:
        made.writestr(NAME, CODE)
    assert "rare method" in reason(located(tmp_path, packed.getvalue()))


@pytest.mark.parametrize("pack", PACKERS)
@pytest.mark.parametrize("keep", [0.1, 0.5, 0.9])
def test_a_cut_archive_is_no_fault_of_ours(tmp_path: Path, pack: object, keep: float) -> None:
    """An upload that broke off is refused in words."""
    assert callable(pack)
    content = pack([("noise", bytes(range(256)) * 40), (NAME, CODE * 50)])
    assert isinstance(located(tmp_path, content[: int(len(content) * keep)]), Rejected)


def test_an_archive_larger_than_memory_should_hold_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is not read to its end."""
    monkeypatch.setattr("grader.intake.locate.LARGEST_ARCHIVE", 100)
    assert "larger than 0 MiB" in reason(located(tmp_path, zipped([(NAME, CODE)])))


DAMAGED = [
    zipped([("a.h", b"int a;"), (NAME, CODE)]),
    tarred([("a.h", b"int a;"), (NAME, CODE)], mode=""),
]


@given(
    st.sampled_from(DAMAGED),
    st.lists(st.tuples(st.integers(0, 2000), st.integers(0, 255)), min_size=1, max_size=12),
)
def test_damage_is_always_a_students_fault(
    tmp_path_factory: pytest.TempPathFactory, content: bytes, damage: list[tuple[int, int]]
) -> None:
    """Whatever bytes are changed, there is a submission or a refusal, and no exception."""
    damaged = bytearray(content)
    for place, value in damage:
        damaged[place % len(damaged)] = value
    folder = tmp_path_factory.getbasetemp()
    found = located(folder, bytes(damaged))
    assert isinstance(found, Submission | Rejected)
