"""What did a compiler make of the same file before? Products by content, on disk.

Theory of operation. The name of an entry is a hash of the source, of the command and of the
workspace, whose own name is a hash of the stub, the compiler and the options: an entry may be
unused, but not out of date. Only what came out whole is kept, with the compiler's messages;
what failed is tried again. An entry is one file in a folder of our own, written beside its
place and renamed; it begins with a hash of the rest, so that half of one is no entry. Using an
entry marks it; when all are too large, those unused for the longest time are dropped.
"""

import hashlib
import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from grader.entries import drop_oldest, write_entry
from grader.resources import private_cache

LARGEST = 256 << 20
"""Bytes of all entries together: some hundred submissions."""

LARGEST_ONE = 16 << 20
"""Bytes of one; right files make at most 1.6 MB. A file that makes a huge one would
drive those of a class out, and what no stage reads to its end is not worth keeping."""

_DIGEST = 32
_LENGTH = 8


@dataclass(frozen=True, slots=True)
class Product:
    """What a compiler made, and what it said; both are the submission's bytes."""

    content: bytes
    messages: bytes


def name_of(source: bytes, command: Sequence[str], workspace: Path, product: str) -> str:
    """Name the entry of a product.

    Args:
        source: The submission's file.
        command: Compiler and words, without the paths of this run.
        workspace: Its name tells the stub, the compiler and the options.
        product: Name of the file that is made.
    """
    digest = hashlib.sha256(repr((list(command), workspace.name, product)).encode())
    digest.update(source)
    return digest.hexdigest()


def recalled(name: str) -> Product | None:
    """Return a product that was kept; None if there is none that is whole."""
    path = private_cache("products") / name
    try:
        entry = path.read_bytes()
        os.utime(path)
    except OSError:
        return None
    digest, rest = entry[:_DIGEST], entry[_DIGEST:]
    if hashlib.sha256(rest).digest() != digest:
        return None
    size = int.from_bytes(rest[:_LENGTH], "little")
    return Product(rest[_LENGTH : _LENGTH + size], rest[_LENGTH + size :])


def keep(name: str, product: Product) -> None:
    """Keep a product that is not huge; a full disk only costs the entry."""
    if len(product.content) > LARGEST_ONE:
        return
    rest = len(product.content).to_bytes(_LENGTH, "little") + product.content + product.messages
    folder = private_cache("products")
    write_entry(folder / name, (hashlib.sha256(rest).digest(), rest))
    drop_oldest(folder, LARGEST)
