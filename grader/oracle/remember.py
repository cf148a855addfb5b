"""What was computed before? A cache on disk that is never trusted blindly.

Theory of operation. The name of an entry is a hash of all that it was computed from and of the
oracle's own source text and the records', so an entry can be unused but not out of date. An
entry is one file, which begins with a hash of the rest. It is written beside its place and
renamed, and it is read back only if the hash fits; anything else is computed again. Reading an
entry marks it as used; when all entries together are too large, those unused for the longest
time are dropped.
"""

import hashlib
import os
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from grader.entries import drop_oldest, write_entry
from grader.oracle.container import sealed, unsealed
from grader.resources import private_cache

Kept = TypeVar("Kept")
LARGEST = 2 << 30
"""Bytes of all entries together."""


def digest_of(*parts: object) -> str:
    """Hash the oracle's source and, as `hash_of` does, anything else."""
    return hash_of(_own_source(), *parts).hex()


def hash_of(*parts: object) -> bytes:
    """Hash arrays, with their shape and type, and anything with a `repr` that tells it all."""
    digest = hashlib.sha256()
    for part in parts:
        if isinstance(part, np.ndarray):
            digest.update(f"{part.dtype.str}{part.shape}".encode())
            digest.update(np.ascontiguousarray(part).data)
        else:
            digest.update(f"|{part!r}|".encode())
    return digest.digest()


def remember(key: str, compute: Callable[[], Kept]) -> Kept:
    """Return a value from the cache, or compute and keep it.

    Args:
        key: From `digest_of`, of everything that the value depends on.
        compute: Computes what `container.sealed` takes.
    """
    folder = private_cache("oracle")
    path = folder / key
    kept: Kept | None = _read(path)
    if kept is None:
        kept = compute()
        folder.mkdir(mode=0o700, exist_ok=True)
        write_entry(path, sealed(kept))
        drop_oldest(folder, LARGEST)
    return kept


@cache
def _own_source() -> bytes:
    """Hash the source of oracle and records: a change in it makes every entry unused."""
    digest = hashlib.sha256(np.__version__.encode())
    package = Path(__file__).parents[1]
    for pattern in ("oracle/*.py", "model/*.py", "tolerances.py"):
        for path in sorted(package.glob(pattern)):
            digest.update(path.read_bytes())
    return digest.digest()


def _read(path: Path) -> Any:  # noqa: ANN401 - whatever was kept
    """Read an entry; None if there is none that is whole."""
    try:
        kept = unsealed(np.fromfile(path, dtype=np.uint8))
    except OSError:
        return None
    if kept is not None:
        os.utime(path)
    return kept
