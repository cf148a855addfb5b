"""Tests of grader/intake/candidates.py through `locate`, with zip and tar.gz."""

from collections.abc import Callable
from itertools import count, islice
from pathlib import Path

import pytest

from grader.intake.candidates import (
    LONGEST_PATH,
    MOST_COPIES,
    MOST_ENTRIES,
    TOO_MANY,
    Entry,
    Fault,
    choose,
    is_source,
    parts,
)
from grader.intake.locate import locate
from grader.model.stages import Submission
from tests.intake.archives import CODE, LIMIT, NAME, Entries, located, reason, tarred, zipped

Packer = Callable[[Entries], bytes]
PACKERS = [zipped, tarred]
OTHERS = [(f"{number}.cpp", b"") for number in range(5)]


@pytest.mark.parametrize("pack", PACKERS)
@pytest.mark.parametrize(
    "inside",
    [NAME, f"src/{NAME}", f"../../{NAME}", f"/etc/{NAME}", f"C:\\src\\{NAME}", f"a\nb/{NAME}"],
)
@pytest.mark.parametrize("name", ["s0427.zip", "s0427.tar.gz", "s0427.tgz", "s0427"])
def test_the_one_file_is_read(tmp_path: Path, pack: Packer, inside: str, name: str) -> None:
    """The content decides how it is packed, and no name in it is used as a path."""
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
        ([("a.zip", b""), ("Exercise03.cpp", b"")], "there is `Exercise03.cpp`, `a.zip`"),
        ([*(OTHERS), ("exercise03 (1).cpp", b"")], "`exercise03 (1).cpp`, `0.cpp`, `1.cpp`"),
        ([(f"{NAME}/", b""), (f"{NAME}.txt", b"")], f"there is `{NAME}.txt`"),
        ([(f"{NAME}\\", b""), (f"{NAME}/x", b"")], f"no file is called {NAME}"),
        ([("a/" + NAME, CODE), ("b/" + NAME, b"x")], f"(`a/{NAME}`, `b/{NAME}`)"),
        ([(NAME, b"")], "the file is empty"),
        ([("x/" + NAME, CODE.decode().encode("utf-16"))], f"x/{NAME}: the file is saved as"),
        ([(NAME, b"x" * (LIMIT + 1))], "larger than 64 KiB"),
        ([("x" * 300 + "/" + NAME, b"")], f"…{'x' * 44}/{NAME}: the file is empty"),
    ],
)
def test_what_is_packed_wrongly_is_said(
    tmp_path: Path, pack: Packer, entries: Entries, expected: str
) -> None:
    """None, two, empty, UTF-16, too large."""
    assert expected in reason(located(tmp_path, pack(entries)))


@pytest.mark.parametrize("pack", PACKERS)
@pytest.mark.filterwarnings("ignore:Duplicate name")
def test_copies_are_one_file(tmp_path: Path, pack: Packer) -> None:
    """Whoever hands in the same bytes twice has left nothing to choose."""
    found = located(tmp_path, pack([(f"a/{NAME}", CODE), (f"b/{NAME}", CODE)]))
    assert isinstance(found, Submission)
    assert (found.path, found.source) == (f"a/{NAME}", CODE)
    twice = pack([(NAME, CODE), (NAME, b"x")])
    assert "2 files are called" in reason(located(tmp_path, twice))


@pytest.mark.parametrize("pack", PACKERS)
def test_copies_are_not_compared_without_end(tmp_path: Path, pack: Packer) -> None:
    """A few are read, so that thousands cost neither time nor memory."""
    copies = [(f"{number}/{NAME}", CODE) for number in range(MOST_COPIES + 1)]
    assert isinstance(located(tmp_path, pack(copies[:-1])), Submission)
    assert f"{MOST_COPIES + 1} files are called" in reason(located(tmp_path, pack(copies)))


@pytest.mark.parametrize("pack", PACKERS)
def test_a_whole_project_is_searched(tmp_path: Path, pack: Packer) -> None:
    """What a compiler and an editor leave behind does not stand in the way."""
    beside = ["CMakeLists.txt", "src/bvh.cpp", "abi/exercise03_abi.cpp", ".vs/exercise03.cpp"]
    build = [
        "build/CMakeFiles/stub.dir/src/exercise03.cpp.o",
        "build/CMakeFiles/stub.dir/src/exercise03.cpp.o.d",
        "build/libexercise03.so",
        "build/",
    ]
    names = [f"student_stub/{name}" for name in [*beside, *build]]
    entries = [(name, b"" if name.endswith("/") else b"\x7fELF") for name in names]
    found = located(tmp_path, pack([*entries, (f"student_stub/src/{NAME}", CODE)]))
    assert isinstance(found, Submission)
    assert (found.path, found.source) == (f"student_stub/src/{NAME}", CODE)


def test_too_many_entries_are_refused() -> None:
    """With the most, the search ends with an answer; without an end, it ends as well."""
    endless = (Entry(f"{number}", lambda _: b"") for number in count())
    no_file, too_many = choose(islice(endless, MOST_ENTRIES), LIMIT), choose(endless, LIMIT)
    assert isinstance(no_file, Fault)
    assert no_file.reason == f"no file is called {NAME}"
    assert too_many == TOO_MANY


@pytest.mark.parametrize("pack", PACKERS)
@pytest.mark.parametrize("keep", [0.1, 0.5, 0.9])
def test_a_cut_archive_is_no_fault_of_ours(tmp_path: Path, pack: Packer, keep: float) -> None:
    """An upload that broke off is refused in words."""
    content = pack([("noise", bytes(range(256)) * 40), (NAME, CODE * 50)])
    assert reason(located(tmp_path, content[: int(len(content) * keep)]))


def test_an_archive_larger_than_memory_should_hold_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its size is looked at first; a file full of holes may claim any."""
    monkeypatch.setattr("grader.intake.locate.LARGEST_ARCHIVE", 2**20)
    path = tmp_path / "huge.zip"
    path.write_bytes(zipped([(NAME, CODE)]))
    with path.open("r+b") as file:
        file.truncate(2**40)
    assert "larger than 1 MiB" in reason(locate(path, LIMIT))


@pytest.mark.parametrize("path", ["/" * 65_535, "a/" * 32_000 + NAME])
def test_only_the_end_of_an_endless_path_is_read(path: str) -> None:
    """Dividing all of it for thousands of entries would take seconds."""
    assert len(parts(path)) <= LONGEST_PATH + 1
    assert is_source(path) == path.endswith(NAME)
