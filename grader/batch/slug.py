"""What is the folder of a student called? Something that no system and no shell acts on."""

import hashlib
import re
import unicodedata
from collections.abc import Callable

from grader.gradebook.results import USUAL_OUTPUT

LONGEST = 60
_OTHER = re.compile(r"[^a-z0-9]+")
_RESERVED = re.compile(rf"con|prn|aux|nul|com\d|lpt\d|{USUAL_OUTPUT}")
"""Devices that Windows sees in any folder, and a folder that belongs to who is above it."""


def slug(name: str, id: str, key: str, is_taken: Callable[[str], bool]) -> str:
    """Name a folder after a student.

    Lower case, because some file systems take `Ada` and `ada` for one; a name that is taken, or
    of which nothing is left, gets some digits that depend on nobody else.

    Args:
        name: A stranger's.
        id: What the learning system calls the student; it may be empty.
        key: Tells the submission from all others of the class.
        is_taken: Whether a folder belongs to somebody else already.
    """
    plain = "-".join(filter(None, (_plain(name), "" if id == name else _plain(id))))
    base = plain[:LONGEST].strip("-")
    if base and not _RESERVED.fullmatch(base) and not is_taken(base):
        return base
    digest = hashlib.sha256(key.encode(errors="surrogateescape")).hexdigest()
    ends = (digest[:length] for length in range(6, len(digest) + 1))
    tried = (f"{base or 'submission'}-{end}" for end in ends)
    return next(one for one in tried if not is_taken(one))


def _plain(text: str) -> str:
    flat = text.replace("ß", "ss").replace("ẞ", "SS")
    spelled = unicodedata.normalize("NFKD", flat).encode("ascii", "ignore").decode()
    return _OTHER.sub("-", spelled.lower()).strip("-")
