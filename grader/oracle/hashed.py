"""How does whoever reads a file know that it is whole? It begins with a hash of the rest."""

import hashlib
from collections.abc import Sequence

Piece = bytes | memoryview
DIGEST = hashlib.sha256().digest_size


def hashed(pieces: Sequence[Piece]) -> list[Piece]:
    """Put the hash of all pieces before them."""
    digest = hashlib.sha256()
    for piece in pieces:
        digest.update(piece)
    return [digest.digest(), *pieces]


def unbroken(content: Piece) -> memoryview | None:
    """Return what follows the hash; None if that is not what was hashed."""
    view = memoryview(content)
    body = view[DIGEST:]
    return body if hashlib.sha256(body).digest() == view[:DIGEST] else None
