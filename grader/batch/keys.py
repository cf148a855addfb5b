"""What tells a student from all others of a class, in every download?

The platform's own number or word, where it has one: names change, and so does what Gradescope
calls the folder of each upload. The layout stands before it, since the participant 12 of Moodle
is not the file `12.cpp`.
"""

import sqlite3
import unicodedata

from grader.gradebook.marks import HANDED_IN, MEANT
from grader.plain import as_name


def key_of(layout: str, word: str) -> str:
    """Name a student; one system writes an umlaut as one character, another one as two."""
    return f"{layout}/{unicodedata.normalize('NFC', word)}"


def anonymous_key(word: str) -> str:
    """Name somebody whom Canvas does not; the word may look like somebody's number."""
    return key_of("Canvas", f"anon_{word}")


def gradescope_key(id: str, email: str, place: str) -> str:
    """Name somebody in Gradescope.

    Args:
        id: Of the student; it may be empty.
        email: So may this.
        place: Folder and name, if nothing else is known.
    """
    known = (("id", id), ("email", email), ("folder", place))
    kind, word = next((kind, word) for kind, word in known if word)
    return key_of("Gradescope", f"{kind}/{word}")


def stem_of(name: str) -> str:
    """Take the ending from the name of a file that somebody handed in."""
    known = (*HANDED_IN, *MEANT)
    ending = max((e for e in known if name.lower().endswith(e)), key=len, default="")
    return name[: len(name) - len(ending)] or name


def carry_over(base: sqlite3.Connection) -> None:
    """Give the students of a store of version 1 the keys of today.

    Of several that are one now, the one that was written down last gets it. The others stay,
    under keys that no download has any more: which of them counts is the instructor's to say.
    """
    query = "SELECT key, layout, name, id, email FROM student ORDER BY rowid DESC"
    taken: set[bytes] = set()
    for old, *said in base.execute(query).fetchall():
        new = _today(old.decode(errors="surrogateescape"), *said)
        key = new.encode(errors="surrogateescape")
        if key not in taken:
            base.execute("UPDATE student SET key = ? WHERE key = ?", (key, old))
            taken.add(key)


def _today(old: str, layout: str, name: str, id: str, email: str) -> str:
    if layout == "Gradescope":
        return gradescope_key(id, email, old)
    if layout == "Canvas" and name == f"anon_{id}":
        return anonymous_key(id)
    if layout in {"Moodle", "Canvas"}:
        return key_of(layout, id)
    if layout == "plain" and name != as_name(old):
        return key_of(layout, stem_of(old))
    return key_of(layout, old)
