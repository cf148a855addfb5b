"""An archive's bytes depend on the names and the bytes of its files, and on nothing else."""

import io
import os
import zipfile
from pathlib import Path

import pytest

from grader.package.archive import Member, below, files_of, zipped

MEMBERS = (Member("b/run", b"#!/bin/sh\n", executable=True), Member("a.txt", b"text"))


def test_the_order_in_which_files_are_named_does_not_matter() -> None:
    """Two lists of the same files give the same bytes."""
    assert zipped(MEMBERS) == zipped(reversed(MEMBERS))


def test_a_file_comes_out_as_it_went_in() -> None:
    """Name, bytes, and whether it can be run; the time is the same for all."""
    with zipfile.ZipFile(io.BytesIO(zipped(MEMBERS))) as archive:
        assert archive.namelist() == ["a.txt", "b/run"]
        assert archive.read("b/run") == b"#!/bin/sh\n"
        modes = [entry.external_attr >> 16 for entry in archive.infolist()]
        assert modes == [0o100644, 0o100755]
        assert {entry.date_time for entry in archive.infolist()} == {(1980, 1, 1, 0, 0, 0)}


def test_two_files_of_one_name_are_refused() -> None:
    """Whoever unpacks it would get one of them, and not know which."""
    with pytest.raises(ValueError, match=r"a\.txt is packed twice"):
        zipped([*MEMBERS, Member("a.txt", b"other")])


def test_a_folder_is_read_without_what_tools_left_behind(tmp_path: Path) -> None:
    """Caches and what the caller names stay out."""
    for name in (
        "kept.py",
        "deep/kept.sh",
        "__pycache__/x.pyc",
        ".DS_Store",
        "build/x.o",
    ):
        path = tmp_path / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(name)
    (tmp_path / "deep/kept.sh").chmod(0o755)
    found = files_of(tmp_path, ("build",))
    assert [(one.name, one.executable) for one in found] == [
        ("deep/kept.sh", True),
        ("kept.py", False),
    ]
    assert found[1].data == b"kept.py"


def test_the_time_of_a_file_does_not_matter(tmp_path: Path) -> None:
    """A checkout of another day gives the same archive."""
    (tmp_path / "file").write_text("text")
    before = zipped(below("folder", files_of(tmp_path)))
    os.utime(tmp_path / "file", (1, 1))
    assert zipped(below("folder", files_of(tmp_path))) == before
