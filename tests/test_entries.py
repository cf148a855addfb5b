"""What a cache keeps is whole, and what does not fit into it leaves nothing behind."""

import os
from collections.abc import Iterator
from pathlib import Path

from grader.entries import drop_oldest, write_entry


def test_an_entry_is_written_whole(tmp_path: Path) -> None:
    """All pieces, in place of an older one, and no other file."""
    write_entry(tmp_path / "entry", [b"old"])
    write_entry(tmp_path / "entry", [b"ab", memoryview(b"cd")])
    assert (tmp_path / "entry").read_bytes() == b"abcd"
    assert [path.name for path in tmp_path.iterdir()] == ["entry"]


def test_a_full_disk_costs_the_entry_and_leaves_no_half_of_one(tmp_path: Path) -> None:
    """What was there before stays."""

    def pieces() -> Iterator[bytes]:
        yield b"half"
        raise OSError(28, "No space left on device")

    write_entry(tmp_path / "entry", [b"old"])
    write_entry(tmp_path / "entry", pieces())
    assert (tmp_path / "entry").read_bytes() == b"old"
    assert [path.name for path in tmp_path.iterdir()] == ["entry"]
    write_entry(tmp_path / "missing" / "entry", [b"new"])
    assert not (tmp_path / "missing").exists()


def test_the_longest_unused_entries_go(tmp_path: Path) -> None:
    """As many as are needed, and no more."""
    for age, name in enumerate(("new", "middle", "old")):
        (tmp_path / name).write_bytes(bytes(10))
        os.utime(tmp_path / name, (1000 - age, 1000 - age))
    drop_oldest(tmp_path, 20)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["middle", "new"]
