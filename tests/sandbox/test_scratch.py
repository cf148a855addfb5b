"""A scratch folder goes with its grader, or with the first one after it."""

import fcntl
import os
import time
from pathlib import Path

import pytest

from grader.sandbox.scratch import OLD_SECONDS, scratch_folder, sweep

LEFT = "bvhgrade-abc_0123"


def left(parent: Path, name: str = LEFT, age: float = OLD_SECONDS + 60) -> Path:
    """Make a folder with something in it, as a killed grader leaves it."""
    folder = parent / name
    (folder / "src").mkdir(parents=True)
    (folder / "src" / "exercise03.cpp").write_text("x")
    then = time.time() - age
    os.utime(folder, (then, then))
    return folder


def test_it_is_gone_afterwards(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Others may enter it but not list it; the next grader also removes an old one."""
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    old = left(tmp_path)
    with scratch_folder() as folder:
        assert folder.parent == tmp_path
        assert folder.stat().st_mode & 0o777 == 0o711
        assert not old.exists()
    assert list(tmp_path.iterdir()) == []


def test_a_folder_in_use_stays(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """However old it is, and whatever lies in it."""
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    with scratch_folder() as folder:
        os.utime(folder, (0, 0))
        sweep(tmp_path)
        assert folder.is_dir()


def test_only_what_is_surely_left_is_removed(tmp_path: Path) -> None:
    """Neither a young folder nor another name, a locked one, a file or a link's target."""
    young = left(tmp_path, "bvhgrade-young_01", age=60)
    other = left(tmp_path, "bvhgrade-tests-abcdefgh")
    locked = left(tmp_path, "bvhgrade-locked_1")
    target = left(tmp_path, "target")
    link = tmp_path / "bvhgrade-linked_1"
    link.symlink_to(target)
    file = tmp_path / "bvhgrade-a_file_1"
    file.write_text("x")
    os.utime(file, (0, 0))
    held = os.open(locked, os.O_RDONLY | os.O_DIRECTORY)
    try:
        fcntl.flock(held, fcntl.LOCK_EX)
        sweep(tmp_path)
    finally:
        os.close(held)
    for path in (young, other, locked, target):
        assert (path / "src" / "exercise03.cpp").exists()
    assert link.is_symlink()
    assert file.exists()
    sweep(tmp_path)
    assert not locked.exists()


def test_a_link_below_is_not_followed(tmp_path: Path) -> None:
    """What a submission's compiler left may be a link to anywhere."""
    kept = left(tmp_path, "kept")
    folder = left(tmp_path)
    (folder / "out").symlink_to(kept)
    os.utime(folder, (0, 0))
    sweep(tmp_path)
    assert not folder.exists()
    assert (kept / "src" / "exercise03.cpp").exists()
