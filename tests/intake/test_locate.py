"""Tests of grader/intake/locate.py: files and folders."""

import gzip
import os
import socket
import tracemalloc
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from grader.errors import UsageError
from grader.intake.locate import locate
from grader.model.stages import Rejected, Submission
from tests.intake.archives import pax_record, tar_entry, tarred, zipped

CODE = b"void BVH::construct(const Mesh&) {}\n"
LIMIT = 1024 * 1024
NAME = "exercise03.cpp"


def accepted(path: Path) -> Submission:
    """Locate a file that must be found."""
    found = locate(path, LIMIT)
    assert isinstance(found, Submission)
    return found


def refused(path: Path) -> str:
    """Locate something that must be refused, and give the reason."""
    found = locate(path, LIMIT)
    assert isinstance(found, Rejected)
    assert found.reason.isprintable()
    assert "!" not in found.reason
    return found.reason


@pytest.mark.parametrize("name", [NAME, "loesung Müller (1).cpp", "main.cc", "A.CXX"])
def test_one_source_file_may_have_any_name(tmp_path: Path, name: str) -> None:
    """The name only names the student."""
    path = tmp_path / name
    path.write_bytes(CODE)
    found = accepted(path)
    assert (found.source, found.path) == (CODE, NAME)
    assert found.student == Path(name).stem
    assert len(found.sha256) == 64


@pytest.mark.parametrize("inside", [NAME, f"src/{NAME}", f"a/b/c/student_stub/src/{NAME}"])
def test_a_folder_is_searched(tmp_path: Path, inside: str) -> None:
    """The one file is found at any depth, beside whatever else lies there."""
    path = tmp_path / "s0427" / inside
    path.parent.mkdir(parents=True)
    path.write_bytes(CODE)
    (path.parent / "bvh.h").write_text("")
    found = accepted(tmp_path / "s0427")
    assert (found.student, found.path, found.source) == ("s0427", inside, CODE)


@pytest.mark.parametrize("inside", ["__MACOSX", ".git", ".history/src"])
def test_junk_is_not_a_second_file(tmp_path: Path, inside: str) -> None:
    """What macOS, git and editors keep is not looked at."""
    (tmp_path / NAME).write_bytes(CODE)
    (tmp_path / inside).mkdir(parents=True)
    (tmp_path / inside / NAME).write_bytes(b"old")
    assert accepted(tmp_path).source == CODE


def test_two_files_are_named(tmp_path: Path) -> None:
    """Which of them is meant is not guessed."""
    for folder in ("old", "new"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / NAME).write_text(folder)
    reason = refused(tmp_path)
    assert f"2 files are called {NAME}" in reason
    assert f"`old/{NAME}`" in reason
    assert f"`new/{NAME}`" in reason


def test_without_the_file_others_are_named(tmp_path: Path) -> None:
    """A student sees what was handed in instead."""
    (tmp_path / "Exercise03.cpp").write_bytes(CODE)
    (tmp_path / "notes.txt").write_bytes(CODE)
    assert refused(tmp_path) == f"no file is called {NAME}; there is `Exercise03.cpp`"


def test_an_empty_folder_is_refused(tmp_path: Path) -> None:
    """There is nothing else to name."""
    assert refused(tmp_path) == f"no file is called {NAME}"


@pytest.mark.parametrize(
    ("content", "expected"),
    [
        (b"", "the file is empty"),
        (b" \r\n\t", "the file is empty"),
        (b"\xef\xbb\xbf", "the file is empty"),
        (b"x" * (LIMIT + 1), "larger than 1,024 KiB"),
        (CODE.decode().encode("utf-16"), "saved as UTF-16"),
        (CODE.decode().encode("utf-16-le"), "saved as UTF-16"),
        (CODE.decode().encode("utf-16-be"), "saved as UTF-16"),
        (CODE.decode().encode("utf-32"), "saved as UTF-16"),
        (b"PK\x03\x04....", "this is an archive"),
        (b"Rar!....", "this is an archive"),
    ],
)
def test_files_that_cannot_be_compiled_are_refused(
    tmp_path: Path, content: bytes, expected: str
) -> None:
    """The reason names the file and says what to do."""
    path = tmp_path / NAME
    path.write_bytes(content)
    reason = refused(path)
    assert reason.startswith(f"{NAME}: ")
    assert expected in reason


@pytest.mark.parametrize(
    "content",
    [
        b"\xef\xbb\xbf" + CODE,
        CODE.replace(b"\n", b"\r\n"),
        b"// M\xfcller\n" + CODE,
        b"// \x00\n" + CODE,
        b"x" * LIMIT,
        b"x",
    ],
)
def test_what_a_compiler_accepts_is_accepted(tmp_path: Path, content: bytes) -> None:
    """A byte order mark, CRLF, Latin-1, one NUL, the largest and the smallest file."""
    path = tmp_path / NAME
    path.write_bytes(content)
    assert accepted(path).source == content


def test_a_link_is_not_followed(tmp_path: Path) -> None:
    """A planted link must not make us read a file of ours."""
    secret = tmp_path / "secret"
    secret.write_bytes(CODE)
    folder = tmp_path / "s1"
    folder.mkdir()
    (folder / NAME).symlink_to(secret)
    for path in (folder, folder / NAME):
        assert "this is a link" in refused(path)


def test_pipes_and_devices_do_not_make_us_wait(tmp_path: Path) -> None:
    """A pipe that nobody writes to is refused at once."""
    os.mkfifo(tmp_path / NAME)
    assert "a pipe" in refused(tmp_path / NAME)
    assert "a pipe" in refused(tmp_path)


@pytest.mark.parametrize("name", [NAME, "submission.zip"])
def test_sockets_and_devices_are_refused(tmp_path: Path, name: str) -> None:
    """Whatever is no regular file is not read, also where an archive is expected."""
    with socket.socket(socket.AF_UNIX) as server:
        here = Path.cwd()
        os.chdir(tmp_path)
        try:
            server.bind(name)
        finally:
            os.chdir(here)
        assert "a device" in refused(tmp_path / name)
    assert "a device" in refused(Path("/dev/null"))


@pytest.mark.parametrize(
    "name", ["none", "none.cpp", "none.zip", "file/none", "x" * 300, "a\0b"]
)
def test_a_path_that_is_not_there_is_the_callers_mistake(tmp_path: Path, name: str) -> None:
    """That is a typing error, not a submission."""
    (tmp_path / "file").write_bytes(CODE)
    with pytest.raises(UsageError, match=r"but a C\+\+ file, a folder"):
        locate(tmp_path / name, LIMIT)


@pytest.mark.parametrize("name", ["a.rar", "a.txt", "a.pdf", "a.c", "noending"])
def test_other_files_are_refused(tmp_path: Path, name: str) -> None:
    """The reason says what may be handed in."""
    (tmp_path / name).write_bytes(CODE)
    assert refused(tmp_path / name).startswith("neither a C++ file nor a folder")


@pytest.mark.parametrize(
    "name", ["a\nb", "\u202egpp.3", "x" * 250, "a\x1b[31m", os.fsdecode(b"\xff\xfe")]
)
def test_hostile_names_are_made_printable(tmp_path: Path, name: str) -> None:
    """New lines, bidirectional marks, escape sequences and long names reach no terminal."""
    folder = tmp_path / name
    folder.mkdir()
    (folder / NAME).write_bytes(CODE)
    student = accepted(folder).student
    assert student.isprintable()
    assert 0 < len(student) <= 120


def test_the_current_folder_has_a_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """`.` is called what the folder is called."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / NAME).write_bytes(CODE)
    assert accepted(Path()).student == tmp_path.name


WHOLE = [
    zipped([("a.h", b"int a;"), (NAME, CODE)]),
    zipped([(f"{number}/{NAME}", CODE) for number in range(3)]),
    tarred([("a.h", b"int a;"), (NAME, CODE)], mode=""),
    tarred([("long/" * 60 + NAME, CODE), ("a.h", b"int a;")], mode=""),
    tar_entry(b"x", pax_record(b"path", NAME.encode()), b"x") + tar_entry(b"y", CODE),
    tarred([("a.h", b"int a;"), (NAME, CODE)]),
]
Change = tuple[float, float, bytes]
changes = st.tuples(st.floats(0, 1), st.floats(0, 1), st.binary(max_size=12))


@given(st.sampled_from(WHOLE), st.lists(changes, min_size=1, max_size=8), st.booleans())
def test_damage_is_always_a_students_fault(
    tmp_path_factory: pytest.TempPathFactory, whole: bytes, cuts: list[Change], packed: bool
) -> None:
    """Pieces are overwritten, repeated, moved and lost: a value comes out and no exception."""
    content = whole
    for start, length, new in cuts:
        at = int(start * len(content))
        end = at + (len(new) if length < 0.8 else int((length - 0.8) * len(content)))
        content = content[:at] + new + content[end:]
    path = tmp_path_factory.getbasetemp() / "damaged"
    path.write_bytes(gzip.compress(content) if packed else content)
    assert isinstance(locate(path, LIMIT), Submission | Rejected)


@given(st.binary(max_size=2000), st.sampled_from(["", "PK\3\4", "PK\5\6", "\x1f\x8b\b\0"]))
def test_any_bytes_are_a_submission_or_are_refused(
    tmp_path_factory: pytest.TempPathFactory, content: bytes, start: str
) -> None:
    """Also behind the marks of archives."""
    for name in ("any", "any.cpp"):
        path = tmp_path_factory.getbasetemp() / name
        path.write_bytes(start.encode("latin-1") + content)
        assert isinstance(locate(path, LIMIT), Submission | Rejected)


LONG = "n" * 2000 + f"/{NAME}"
BOMBS = [
    zipped([(NAME, bytes(2**26))]),
    zipped([(f"{number}{LONG}", b"") for number in range(9000)]),
    tarred([(f"{number}/{NAME}", bytes(2**20)) for number in range(60)]),
    tarred([(NAME, bytes(2**26))]),
    gzip.compress(tar_entry(b"x", b"1" * 2**26, b"x"), mtime=0),
    gzip.compress(tar_entry(b"L", b"1" * 2**26, b"L"), mtime=0),
]


@pytest.mark.parametrize("bomb", BOMBS, ids=len)
def test_no_archive_takes_more_memory_than_a_few_copies(tmp_path: Path, bomb: bytes) -> None:
    """Gigabytes of content, thousands of candidates, headers without end."""
    path = tmp_path / "bomb"
    path.write_bytes(bomb)
    tracemalloc.start()
    try:
        assert isinstance(locate(path, LIMIT), Rejected)
        assert tracemalloc.get_traced_memory()[1] < 24 * 2**20
    finally:
        tracemalloc.stop()
