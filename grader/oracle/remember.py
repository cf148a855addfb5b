"""Which arrays were computed before? A cache on disk that is never trusted blindly.

Theory of operation. The name of an entry is a hash of all that it was computed from and of the
oracle's own source text, so an entry can be unused but not out of date. An entry is one file:
a hash of what follows, then the arrays. It is written beside its place and renamed, and it is
read back only if the hash fits; anything else is computed again. Reading an entry marks it as
used; when all entries together are too large, those unused for the longest time are dropped.
"""

import hashlib
import io
import os
import tempfile
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from grader.resources import private_cache

Arrays = Mapping[str, npt.NDArray[Any]]
LARGEST = 2 << 30
"""Bytes of all entries together."""

DIGEST = hashlib.sha256().digest_size


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


def remember(key: str, compute: Callable[[], Arrays]) -> Arrays:
    """Return arrays from the cache, or compute and keep them.

    Args:
        key: From `digest_of`, of everything that the arrays depend on.
        compute: Computes the arrays.
    """
    folder = private_cache("oracle")
    path = folder / key
    arrays = _read(path)
    if arrays is None:
        arrays = compute()
        folder.mkdir(mode=0o700, exist_ok=True)
        _write(path, arrays)
        _drop_oldest(folder)
    return arrays


def sealed(arrays: Arrays, compress: bool = False) -> bytes:
    """Turn arrays into bytes that `unsealed` can tell from damaged ones.

    Args:
        arrays: Arrays by name.
        compress: Deflate them.
    """
    body = io.BytesIO()
    save = np.savez_compressed if compress else np.savez
    save(body, **dict(arrays))  # type: ignore[arg-type]  # numpy's stub takes no mapping
    content = body.getvalue()
    return hashlib.sha256(content).digest() + content


def unsealed(content: bytes) -> Arrays | None:
    """Return the arrays of `sealed`; None if the bytes are not whole."""
    body = memoryview(content)[DIGEST:]
    if hashlib.sha256(body).digest() != content[:DIGEST]:
        return None
    with np.load(io.BytesIO(body), allow_pickle=False) as stored:
        return {name: stored[name] for name in stored.files}


@cache
def _own_source() -> bytes:
    """Hash the oracle's source, so that a change in it makes every entry unused."""
    digest = hashlib.sha256(np.__version__.encode())
    for path in sorted(Path(__file__).parent.glob("*.py")):
        digest.update(path.read_bytes())
    digest.update((Path(__file__).parents[1] / "tolerances.py").read_bytes())
    return digest.digest()


def _read(path: Path) -> Arrays | None:
    """Read an entry; None if there is none that is whole."""
    try:
        arrays = unsealed(path.read_bytes())
    except OSError:
        return None
    if arrays is not None:
        os.utime(path)
    return arrays


def _write(path: Path, arrays: Arrays) -> None:
    """Write an entry in one step; a full disk only costs the entry."""
    try:
        with tempfile.NamedTemporaryFile(dir=path.parent, delete=False) as file:
            file.write(sealed(arrays))
        Path(file.name).replace(path)
    except OSError:
        return


def _drop_oldest(folder: Path) -> None:
    """Delete what was not used for the longest time until the rest is small enough."""
    entries = []
    for path in folder.iterdir():
        try:
            status = path.stat()
        except FileNotFoundError:  # another process was faster
            continue
        entries.append((status.st_mtime, status.st_size, path))
    total = 0
    for _, size, path in sorted(entries, reverse=True):
        total += size
        if total > LARGEST:
            path.unlink(missing_ok=True)
