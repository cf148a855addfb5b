"""Only the bytes of a regular, bounded file are taken from a folder of a submission."""

import os
import stat
from pathlib import Path

import pytest

from grader.build.product import adopted

MOST = 1000


def test_a_regular_file_is_taken(tmp_path: Path) -> None:
    """Up to the limit, byte for byte."""
    for size in (0, 1, MOST - 1, MOST):
        (tmp_path / "x.so").write_bytes(b"\x7f" * size)
        assert adopted(tmp_path, "x.so", MOST) == b"\x7f" * size


def test_a_file_that_is_too_large_is_not(tmp_path: Path) -> None:
    """Also if it has a terabyte that is not there."""
    file = tmp_path / "x.so"
    for size in (MOST + 1, 1 << 40):
        with file.open("wb") as sparse:
            sparse.truncate(size)
        assert adopted(tmp_path, "x.so", MOST) is None


def test_a_file_that_grows_behind_our_back_is_not(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The limit holds for what is read, not for what was said before."""
    file = tmp_path / "x.so"
    file.write_bytes(b"x" * MOST)
    real = os.fstat

    def grown(handle: int) -> os.stat_result:
        state = real(handle)
        if stat.S_ISREG(state.st_mode):
            with file.open("ab") as more:
                more.write(b"y" * MOST)
        return state

    monkeypatch.setattr("grader.build.product.os.fstat", grown)
    assert adopted(tmp_path, "x.so", MOST) is None
    assert file.stat().st_size > MOST


def test_nothing_is_followed(tmp_path: Path) -> None:
    """Links to files, to folders, to nothing, to themselves, and out of the folder."""
    secret = tmp_path / "secret"
    secret.write_bytes(b"ours")
    own = tmp_path / "own"
    own.mkdir()
    for target in (secret, "../secret", tmp_path, "nothing", "x.so", "/dev/zero", "/proc/self"):
        link = own / "x.so"
        link.symlink_to(target)
        assert adopted(own, "x.so", MOST) is None
        link.unlink()


def test_what_is_no_file_is_not_taken(tmp_path: Path) -> None:
    """A folder, a pipe that nobody writes to, a socket: none of them blocks."""
    (tmp_path / "folder").mkdir()
    os.mkfifo(tmp_path / "pipe")
    os.mknod(tmp_path / "socket", stat.S_IFSOCK | 0o600)
    for name in ("folder", "pipe", "socket", "missing"):
        assert adopted(tmp_path, name, MOST) is None


@pytest.mark.parametrize("name", ["null", "zero", "random", "tty"])
def test_a_device_is_not_taken(name: str) -> None:
    """An endless one neither."""
    assert adopted(Path("/dev"), name, MOST) is None


def test_a_folder_that_became_a_link_is_a_fault_of_ours(tmp_path: Path) -> None:
    """No submission can exchange it: it lies in a folder of ours."""
    (tmp_path / "real").mkdir()
    (tmp_path / "own").symlink_to(tmp_path / "real")
    with pytest.raises(OSError, match="own"):
        adopted(tmp_path / "own", "x.so", MOST)


def test_no_descriptor_is_left_open(tmp_path: Path) -> None:
    """Whatever was found."""
    (tmp_path / "x.so").write_bytes(b"x")
    os.mkfifo(tmp_path / "pipe")
    before = len(list(Path("/proc/self/fd").iterdir()))
    (tmp_path / "folder").mkdir()
    for name in ("x.so", "pipe", "missing", "folder"):
        adopted(tmp_path, name, MOST)
    assert len(list(Path("/proc/self/fd").iterdir())) == before
