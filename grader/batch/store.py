"""What is kept of a class? One SQLite file that is whole after every single submission.

Theory of operation. A submission is written down before it is graded, with its bytes, and its
result in one transaction when it comes; with a write-ahead log on disk before that is called
done. So whatever ends the process costs only what was being graded. A result belongs to bytes
and settings, not to a student: the same bytes are graded once. Results are never changed, and
none is removed that has a score; `current` says which settings' results are those of the class.
A lock that the kernel drops with the process keeps a second batch away.
"""

import sqlite3
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from grader.batch.base import opened_base, read_base, written
from grader.batch.records import Student
from grader.batch.settings import Settings, read_settings
from grader.errors import UsageError
from grader.kept import Result


class Store:
    """The results of a class, in a folder that nobody else writes to meanwhile."""

    def __init__(self, base: sqlite3.Connection) -> None:
        """Take an open data base."""
        self._base = base

    @contextmanager
    def changes(self) -> Iterator[None]:
        """Make several changes one: all of them are kept, or none.

        Raises:
            OutputFault: They could not be written.
        """
        with written():
            self._base.execute("BEGIN IMMEDIATE")
            try:
                yield
                self._base.execute("COMMIT")
            except BaseException:
                if self._base.in_transaction:
                    self._base.execute("ROLLBACK")
                raise

    def current(self) -> Settings | None:
        """The settings whose results are those of the class; None before the first."""
        row = self._one("SELECT text FROM settings WHERE current = 1")
        return read_settings(row[0]) if row else None

    def know(self, settings: Settings) -> None:
        """Take note of settings; the first ones become current."""
        with self.changes():
            first = self._one("SELECT 1 FROM settings WHERE current = 1") is None
            self._base.execute(
                "INSERT INTO settings VALUES (?, ?, ?) ON CONFLICT DO NOTHING",
                (settings.digest, settings.to_text(), int(first)),
            )

    def make_current(self, settings: Settings) -> None:
        """Let the results of other settings be those of the class."""
        with self.changes():
            chosen = (settings.digest,)
            self._base.execute("UPDATE settings SET current = (digest = ?)", chosen)

    def student(self, key: str) -> Student | None:
        """Look somebody up."""
        row = self._one("SELECT * FROM student WHERE key = ?", (_packed(key),))
        return _student(row) if row else None

    def is_taken(self, slug: str) -> bool:
        """Whether a folder belongs to somebody already."""
        return self._one("SELECT 1 FROM student WHERE slug = ?", (slug,)) is not None

    def put(self, student: Student, source: bytes) -> None:
        """Write down what somebody handed in, in place of what was known before."""
        values = (_packed(student.key), *_values(student))
        with self.changes():
            if student.sha256 is not None:
                self._base.execute(
                    "INSERT INTO source VALUES (?, ?) ON CONFLICT DO NOTHING",
                    (student.sha256, source),
                )
            marks = ", ".join("?" * len(values))
            self._base.execute(f"INSERT OR REPLACE INTO student VALUES ({marks})", values)  # noqa: S608 - question marks only

    def drop(self, student: Student) -> None:
        """Let somebody be no part of the class any more; files and results stay."""
        with self.changes():
            self._base.execute("DELETE FROM student WHERE key = ?", (_packed(student.key),))

    def source(self, sha256: str) -> bytes:
        """The bytes of a submission.

        Raises:
            UsageError: Nobody of the class handed them in.
        """
        row = self._one("SELECT bytes FROM source WHERE sha256 = ?", (sha256,))
        if row is None:
            raise UsageError("this class holds no submission with that content")
        return bytes(row[0])

    def ungraded(self, settings: Settings) -> Iterator[Student]:
        """One student for each file that has no result yet."""
        yield from self._students(
            "sha256 IS NOT NULL AND "
            "sha256 NOT IN (SELECT sha256 FROM result WHERE settings = ?) AND NOT "
            "EXISTS (SELECT 1 FROM student AS other WHERE other.sha256 = student.sha256 AND "
            "other.slug < student.slug)",
            settings.digest,
        )

    def without_points(self, settings: Settings) -> Iterator[Student]:
        """Everybody who has no points with these settings, because of us."""
        yield from self._students(
            "CASE WHEN sha256 IS NULL THEN fault != '' ELSE sha256 NOT IN (SELECT sha256 "
            "FROM result WHERE settings = ? AND json_extract(text, '$.score') IS NOT NULL) END",
            settings.digest,
        )

    def students(self) -> Iterator[Student]:
        """All of them."""
        yield from self._students("1")

    def same(self, sha256: str) -> Iterator[Student]:
        """Everybody who handed in these bytes."""
        yield from self._students("sha256 = ?", sha256)

    def forgive(self, settings: Settings) -> None:
        """Drop what went wrong before with files that are graded now."""
        with self.changes():
            # Asked for each such student, of whom there are few; not for all results there are.
            self._base.execute(
                "UPDATE student SET fault = '', written = '' WHERE fault != '' AND EXISTS "
                "(SELECT 1 FROM result WHERE sha256 = student.sha256 AND settings = ?)",
                (settings.digest,),
            )

    def keep(self, sha256: str, settings: Settings, result: Result) -> None:
        """Write down a result; one that is there stays."""
        with self.changes():
            self._base.execute(
                "INSERT INTO result VALUES (?, ?, ?) ON CONFLICT DO NOTHING",
                (sha256, settings.digest, result.text),
            )
            self._base.executemany(
                "INSERT INTO attachment VALUES (?, ?, ?, ?) ON CONFLICT DO NOTHING",
                [(sha256, settings.digest, name, text) for name, text in result.attachments],
            )

    def forget_withheld(self, settings: Settings) -> None:
        """Drop the results whose score was withheld, so that these files are graded again.

        Nothing of a student's is lost: such a result says that the grader failed. A folder that
        holds one holds nothing of these settings any more, whenever this process ends.
        """
        withheld = (
            "= ? AND sha256 IN (SELECT sha256 FROM result WHERE settings = ? "
            "AND json_extract(text, '$.score') IS NULL)"
        )
        changes = (
            f"UPDATE student SET written = '' WHERE written {withheld}",  # noqa: S608 - our own words
            f"DELETE FROM attachment WHERE settings {withheld}",  # noqa: S608 - our own words
            f"DELETE FROM result WHERE settings {withheld}",  # noqa: S608 - our own words
        )
        with self.changes():
            for change in changes:
                self._base.execute(change, (settings.digest, settings.digest))

    def result(self, sha256: str, settings: Settings) -> Result | None:
        """The result of these bytes, if they were graded."""
        where = (sha256, settings.digest)
        row = self._one("SELECT text FROM result WHERE sha256 = ? AND settings = ?", where)
        if row is None:
            return None
        query = "SELECT name, text FROM attachment WHERE sha256 = ? AND settings = ?"
        return Result(row[0], tuple(self._base.execute(query, where).fetchall()))

    def mark_written(self, student: Student, settings: str) -> None:
        """Take note that a student's folder holds a result."""
        values = (settings, _packed(student.key))
        with self.changes():
            self._base.execute("UPDATE student SET written = ? WHERE key = ?", values)

    def _students(self, condition: str, *values: str) -> Iterator[Student]:
        """Read rows in the order of their folders, a page at a time.

        Between two pages nothing is being read, so that the log of writes can be emptied.
        """
        query = (
            f"SELECT * FROM student WHERE {condition} AND slug > ? "  # noqa: S608 - our own words
            "ORDER BY slug LIMIT 50"
        )
        last = ""
        while True:
            with written():
                page = [_student(row) for row in self._base.execute(query, (*values, last))]
            yield from page
            if not page:
                return
            last = page[-1].slug

    def _one(self, query: str, values: Sequence[object] = ()) -> tuple[Any, ...] | None:
        with written():
            row: tuple[Any, ...] | None = self._base.execute(query, values).fetchone()
            return row


@contextmanager
def opened_store(folder: Path) -> Iterator[Store]:
    """Open the store of a folder, or begin one, and keep others away.

    Raises:
        UsageError: Another batch uses it, or what lies there is no store of ours.
        OutputFault: It cannot be written.
    """
    with opened_base(folder) as base:
        yield Store(base)


@contextmanager
def read_store(folder: Path) -> Iterator[Store]:
    """Open the store of a folder, in which there is one, only to read it.

    Raises:
        UsageError: A batch uses it, or what lies there is no store of this grader's.
        OutputFault: It cannot be read.
    """
    with read_base(folder) as base:
        yield Store(base)


def _packed(key: str) -> bytes:
    """Names of files may be no text at all."""
    return key.encode(errors="surrogateescape")


def _values(student: Student) -> tuple[str | None, ...]:
    return (
        student.slug,
        student.name,
        student.id,
        student.email,
        student.layout,
        student.path,
        student.sha256,
        student.reason,
        student.fault,
        student.written,
    )


def _student(row: Sequence[object]) -> Student:
    key, *values = row
    if not isinstance(key, bytes):
        raise AssertionError("keys are stored as bytes")
    return Student(key.decode(errors="surrogateescape"), *values)  # type: ignore[arg-type]  # columns of the schema
