"""Tests of grader/intake/folder.py through `locate`: folders, also ones that change."""

import os
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import pytest

from grader.errors import UsageError
from grader.intake import folder as module
from grader.intake.candidates import MOST_ENTRIES
from grader.intake.folder import DEEPEST, folder_entries
from grader.intake.locate import locate
from grader.model.stages import Rejected, Submission
from tests.intake.archives import CODE, LIMIT, NAME, reason


@pytest.fixture
def handed_in(tmp_path: Path) -> Path:
    """A folder as students hand it in, with the file in `src`."""
    source = tmp_path / "s1" / "src" / NAME
    source.parent.mkdir(parents=True)
    source.write_bytes(CODE)
    return tmp_path / "s1"


@pytest.fixture
def secret(tmp_path: Path) -> Path:
    """A folder of ours with a file that must not be read."""
    source = tmp_path / "secret" / NAME
    source.parent.mkdir()
    source.write_bytes(b"secret")
    return source.parent


def test_a_linked_folder_is_not_entered(handed_in: Path, secret: Path) -> None:
    """A link to a folder with the file, and one that leads back, are left alone."""
    (handed_in / "src" / NAME).unlink()
    (handed_in / "linked").symlink_to(secret)
    (handed_in / "loop").symlink_to(handed_in)
    (handed_in / "dangling").symlink_to("nowhere")
    assert "no file is called" in reason(locate(handed_in, LIMIT))


@pytest.mark.parametrize("target", [f"src/{NAME}", "nowhere", NAME, "src"])
def test_a_link_beside_the_file_is_not_a_second_one(handed_in: Path, target: str) -> None:
    """A link for comfort, a dangling one and one to itself are not followed and not counted."""
    (handed_in / NAME).symlink_to(target)
    found = locate(handed_in, LIMIT)
    assert isinstance(found, Submission)
    assert (found.path, found.source) == (f"src/{NAME}", CODE)
    (handed_in / "src" / NAME).unlink()
    assert f"{NAME}: this is a link" in reason(locate(handed_in, LIMIT))


def test_a_linked_submission_is_refused(tmp_path: Path, handed_in: Path) -> None:
    """Also where the link is what the grader was called with."""
    (tmp_path / "s2").symlink_to(handed_in)
    assert "this is a link" in reason(locate(tmp_path / "s2", LIMIT))


Swap = Callable[[Path, Path], None]


def swap_folder(handed_in: Path, secret: Path) -> None:
    """Put a link to a folder of ours where a folder was."""
    (handed_in / "src").rename(handed_in.parent / "away")
    (handed_in / "src").symlink_to(secret)


def swap_file(handed_in: Path, secret: Path) -> None:
    """Put a link to a file of ours where a file was."""
    (handed_in / "src" / NAME).unlink()
    (handed_in / "src" / NAME).symlink_to(secret / NAME)


def swap_pipe(handed_in: Path, _: Path) -> None:
    """Put a pipe where a file was."""
    (handed_in / "src" / NAME).unlink()
    os.mkfifo(handed_in / "src" / NAME)


class Racing:
    """The module `os` of the code under test, with somebody else at work between two calls."""

    def __init__(self, moment: int, swap: Callable[[], None]) -> None:
        self.calls = 0
        self._moment = moment
        self._swap = swap

    def __getattr__(self, name: str) -> object:
        """Give what `os` has, and swap before the call whose turn it is."""
        if name in {"open", "stat", "fstat", "scandir"}:
            if self.calls == self._moment:
                self._swap()
            self.calls += 1
        return getattr(os, name)


@pytest.mark.parametrize("swap", [swap_folder, swap_file, swap_pipe])
@pytest.mark.parametrize("moment", range(1, 9))
def test_what_changes_meanwhile_leads_nowhere(
    handed_in: Path, secret: Path, swap: Swap, moment: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The swap comes before each step in turn, and no step follows it."""
    racing = Racing(moment, lambda: swap(handed_in, secret))
    monkeypatch.setattr(module, "os", racing)
    with suppress(UsageError):
        found = locate(handed_in, LIMIT)
        assert isinstance(found, Rejected) or found.source == CODE
    assert racing.calls > moment


def test_folders_are_searched_to_a_depth(tmp_path: Path) -> None:
    """A file below that depth does not exist for us, and no depth is a strain."""
    deep = tmp_path.joinpath(*["d"] * DEEPEST)
    deep.mkdir(parents=True)
    (deep / NAME).write_bytes(CODE)
    assert isinstance(locate(tmp_path, LIMIT), Submission)
    (deep / NAME).rename(tmp_path / "x")
    deep.joinpath(*["d"] * 300).mkdir(parents=True)
    (deep / "d" / NAME).write_bytes(CODE)
    assert "no file is called" in reason(locate(tmp_path, LIMIT))


@pytest.mark.parametrize("name", ["{}.txt", ".{}", "{}/"])
def test_endless_folders_are_refused(
    tmp_path: Path, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Files, hidden files and empty folders count; one folder is not listed to its end."""
    monkeypatch.setattr("grader.intake.candidates.MOST_ENTRIES", 10)
    monkeypatch.setattr("grader.intake.folder.MOST_ENTRIES", 10)
    for number in range(10):
        path = tmp_path / name.format(number)
        path.mkdir() if name.endswith("/") else path.touch()
    assert "no file is called" in reason(locate(tmp_path, LIMIT))
    (tmp_path / "more").touch()
    assert f"more than {MOST_ENTRIES:,} files" in reason(locate(tmp_path, LIMIT))


def test_a_full_folder_is_not_listed_to_its_end(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """One name more than the most shows that there are too many."""
    monkeypatch.setattr("grader.intake.folder.MOST_ENTRIES", 10)
    for number in range(30):
        (tmp_path / f"{number}").touch()
    handle = os.open(tmp_path, os.O_RDONLY)
    try:
        assert len(list(folder_entries(handle, []))) == 11
    finally:
        os.close(handle)


@pytest.fixture
def refusing(monkeypatch: pytest.MonkeyPatch) -> Callable[[str], None]:
    """Let the system refuse to open one name, which it would not refuse to root."""

    def refuse(wanted: str) -> None:
        real = os.open

        def opener(
            path: str, flags: int, mode: int = 0o777, *, dir_fd: int | None = None
        ) -> int:
            if path == wanted:
                raise PermissionError(13, "Permission denied")
            return real(path, flags, mode, dir_fd=dir_fd)

        monkeypatch.setattr(os, "open", opener)

    return refuse


def test_a_file_that_may_not_be_read_is_the_callers_mistake(
    handed_in: Path, refusing: Callable[[str], None]
) -> None:
    """Nothing is concluded about the student, and the file is named."""
    refusing(NAME)
    with pytest.raises(UsageError, match=f"s1: src/{NAME} in it: Permission denied, but"):
        locate(handed_in, LIMIT)


def test_a_folder_that_may_not_be_read_is_no_answer(
    handed_in: Path, refusing: Callable[[str], None]
) -> None:
    """If the file is elsewhere, it is graded; if not, it might be in there."""
    refusing("closed")
    (handed_in / "closed").mkdir()
    assert isinstance(locate(handed_in, LIMIT), Submission)
    (handed_in / "src" / NAME).unlink()
    with pytest.raises(UsageError, match="s1: closed in it: Permission denied, but"):
        locate(handed_in, LIMIT)


def test_no_descriptor_is_left_open(handed_in: Path) -> None:
    """Whatever the end of the search is."""
    before = [*Path("/proc/self/fd").iterdir()]
    locate(handed_in, LIMIT)
    (handed_in / "src" / NAME).unlink()
    os.mkfifo(handed_in / NAME)
    locate(handed_in, LIMIT)
    assert [*Path("/proc/self/fd").iterdir()] == before
