"""How is the data base of a class begun, opened and kept from others?"""

import fcntl
import os
import sqlite3
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path

from grader.batch.keys import carry_over
from grader.errors import OutputFault, UsageError
from grader.gradebook.known import read_only
from grader.output import STORE

LOCK = ".batch.lock"
VERSION = 2
"""1 had other keys."""

_SCHEMA = """
CREATE TABLE settings (digest TEXT PRIMARY KEY, text TEXT NOT NULL, current INTEGER NOT NULL)
    STRICT;
CREATE TABLE source (sha256 TEXT PRIMARY KEY, bytes BLOB NOT NULL) STRICT;
CREATE TABLE student (
    key BLOB PRIMARY KEY,
    slug TEXT NOT NULL UNIQUE,
    name TEXT NOT NULL,
    id TEXT NOT NULL,
    email TEXT NOT NULL,
    layout TEXT NOT NULL,
    path TEXT,
    sha256 TEXT REFERENCES source (sha256),
    reason TEXT NOT NULL,
    fault TEXT NOT NULL,
    written TEXT NOT NULL
) STRICT;
CREATE TABLE result (
    sha256 TEXT NOT NULL REFERENCES source (sha256),
    settings TEXT NOT NULL REFERENCES settings (digest),
    text TEXT NOT NULL,
    PRIMARY KEY (sha256, settings)
) STRICT;
CREATE TABLE attachment (
    sha256 TEXT NOT NULL,
    settings TEXT NOT NULL,
    name TEXT NOT NULL,
    text TEXT NOT NULL,
    PRIMARY KEY (sha256, settings, name)
) STRICT;
CREATE INDEX same ON student (sha256);
"""


@contextmanager
def opened_base(folder: Path) -> Iterator[sqlite3.Connection]:
    """Open the data base of a folder, or begin one, and keep all others away.

    Raises:
        UsageError: Another batch uses it, or what lies there is no store of ours.
        OutputFault: It cannot be written.
    """
    try:
        lock = os.open(folder / LOCK, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o644)
    except OSError as fault:
        raise OutputFault(f"{folder / LOCK} cannot be written: {fault.strerror}") from fault
    try:
        _locked(lock, folder, fcntl.LOCK_EX)
        with written():
            base = sqlite3.connect(folder / STORE, isolation_level=None)
        try:
            _prepared(base, folder)
            yield base
        finally:
            base.close()
    finally:
        os.close(lock)


@contextmanager
def read_base(folder: Path) -> Iterator[sqlite3.Connection]:
    """Open the data base of a folder to read it, with others who read, and keep a batch away.

    Whoever may only read the folder can do this, too.

    Raises:
        UsageError: A batch uses it, or what lies there is no store of this grader's.
        OutputFault: It cannot be read.
    """
    with ExitStack() as stack:
        try:
            lock = os.open(folder / LOCK, os.O_RDONLY | os.O_CLOEXEC)
        except (FileNotFoundError, PermissionError):
            lock = None  # a copy, or somebody else's, who would have to let us see the lock
        if lock is not None:
            stack.callback(os.close, lock)
            _locked(lock, folder, fcntl.LOCK_SH)
        with written():
            base = sqlite3.connect(read_only(folder), uri=True, isolation_level=None)
        stack.callback(base.close)
        with written():
            version = _version(base, folder)
        if version != VERSION:
            raise UsageError(
                f"{folder / STORE}: its schema is version {version}, but this grader reads "
                f"{VERSION}; call `bvhgrade batch` again, which carries an older one over"
            )
        yield base


def _version(base: sqlite3.Connection, folder: Path) -> int:
    try:
        (version,) = base.execute("PRAGMA user_version").fetchone()
    except sqlite3.DatabaseError as fault:
        if isinstance(fault, sqlite3.OperationalError):
            raise
        raise _no_store(folder) from fault
    return int(version)


def _no_store(folder: Path) -> UsageError:
    return UsageError(
        f"{folder / STORE}: this is no store of results; name another folder with -o"
    )


def _locked(lock: int, folder: Path, how: int) -> None:
    try:
        fcntl.flock(lock, how | fcntl.LOCK_NB)
    except BlockingIOError as fault:
        raise UsageError(
            f"{folder}: another batch uses it; wait for its end, or name another folder"
        ) from fault


def _prepared(base: sqlite3.Connection, folder: Path) -> None:
    with written():
        version = _version(base, folder)
        if version == 0 and base.execute("SELECT 1 FROM sqlite_schema").fetchone():
            raise _no_store(folder)
        base.execute("PRAGMA journal_mode = WAL")
        base.execute("PRAGMA synchronous = FULL")
        if version == 0:
            base.executescript(f"BEGIN; {_SCHEMA} PRAGMA user_version = {VERSION}; COMMIT;")
        elif version == 1:
            base.execute("BEGIN IMMEDIATE")
            carry_over(base)
            base.execute(f"PRAGMA user_version = {VERSION}")
            base.execute("COMMIT")
        elif version != VERSION:
            raise UsageError(
                f"{folder / STORE}: its schema is version {version}, but this grader reads "
                f"{VERSION}; use the grader that wrote it, or name another folder with -o"
            )


@contextmanager
def written() -> Iterator[None]:
    """Word what SQLite raises.

    Raises:
        OutputFault: Something could not be written, or read.
    """
    try:
        yield
    except sqlite3.Error as fault:
        full = getattr(fault, "sqlite_errorcode", 0) & 0xFF in {
            sqlite3.SQLITE_FULL,
            sqlite3.SQLITE_IOERR,
        }
        remedy = "; is the disk full?" if full else ""
        raise OutputFault(f"the store of results: {fault}{remedy}") from fault
