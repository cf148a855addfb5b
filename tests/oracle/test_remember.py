"""The cache on disk: used when whole, ignored when not, and never larger than allowed."""

import os
from pathlib import Path

import numpy as np
import pytest

from grader.oracle import remember as module
from grader.oracle.remember import digest_of, remember


class Counting:
    """Computes the same arrays again and counts how often."""

    def __init__(self) -> None:
        self.calls = 0

    def __call__(self) -> tuple[np.ndarray, np.ndarray]:
        """Return two small arrays."""
        self.calls += 1
        return np.arange(5, dtype=np.uint32), np.array([[1.5, np.inf]])


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Give a test an empty cache."""
    monkeypatch.setenv("BVHGRADE_CACHE", str(tmp_path))
    return tmp_path / "oracle"


def test_arrays_come_back_bit_by_bit(folder: Path) -> None:
    """The second time nothing is computed, and type, shape and values are the same."""
    compute = Counting()
    first, again = remember("key", compute), remember("key", compute)
    assert compute.calls == 1
    assert len(list(folder.iterdir())) == 1
    for one, other in zip(first, again, strict=True):
        assert (one.dtype, one.shape) == (other.dtype, other.shape)
        assert np.array_equal(one, other)


@pytest.mark.parametrize("damage", ["empty", "cut", "flipped", "other"])
def test_a_damaged_entry_is_computed_again(folder: Path, damage: str) -> None:
    """Truncated, altered or foreign bytes are never taken for arrays."""
    compute = Counting()
    remember("key", compute)
    content = (folder / "key").read_bytes()
    middle = len(content) // 2
    (folder / "key").write_bytes(
        {
            "empty": b"",
            "cut": content[:middle],
            "flipped": content[:middle] + bytes([content[middle] ^ 1]) + content[middle + 1 :],
            "other": b"something else altogether",
        }[damage]
    )
    assert remember("key", compute)[0].tolist() == [0, 1, 2, 3, 4]
    assert compute.calls == 2
    assert (folder / "key").read_bytes() == content


def test_what_was_not_used_for_long_is_dropped(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With room for two entries, the one that was used longest ago goes."""
    compute = Counting()
    remember("old", compute)
    size = (folder / "old").stat().st_size
    remember("new", compute)
    for age, name in ((100, "new"), (200, "old")):
        stamp = (folder / name).stat().st_mtime - age
        os.utime(folder / name, (stamp, stamp))
    monkeypatch.setattr(module, "LARGEST", 2 * size)
    remember("old", compute)
    remember("newest", compute)
    assert {path.name for path in folder.iterdir()} == {"old", "newest"}


def test_a_digest_tells_apart_what_differs() -> None:
    """Values, shape, type, order and names all count."""
    numbers = np.arange(6, dtype=np.uint32)
    digests = {
        digest_of("a", numbers),
        digest_of("b", numbers),
        digest_of("a", numbers.reshape(2, 3)),
        digest_of("a", numbers.astype(np.int64)),
        digest_of("a", numbers[::-1]),
        digest_of(numbers, "a"),
        digest_of("a", numbers, numbers),
    }
    assert len(digests) == 7
    assert digest_of("a", numbers) == digest_of("a", numbers.copy())
