"""How are the files of a cache written and dropped? Whole, and the longest unused one first."""

import secrets
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path

Piece = bytes | bytearray | memoryview


def write_entry(path: Path, pieces: Iterable[Piece]) -> None:
    """Write an entry in one step; a full disk only costs the entry."""
    unfinished = path.with_name(f".{secrets.token_hex(8)}")
    with suppress(OSError):
        with unfinished.open("xb") as file:
            file.writelines(pieces)
        unfinished.replace(path)
        return
    with suppress(OSError):
        unfinished.unlink()


def drop_oldest(folder: Path, most: int) -> None:
    """Delete what was not used for the longest time until the rest is small enough.

    Args:
        folder: Of the entries; using one has to set its time.
        most: Bytes of all entries together.
    """
    entries = []
    for path in folder.iterdir():
        # Another process may be faster.
        with suppress(FileNotFoundError):
            status = path.stat()
            entries.append((status.st_mtime, status.st_size, path))
    total = 0
    for _, size, path in sorted(entries, reverse=True):
        total += size
        if total > most:
            path.unlink(missing_ok=True)
