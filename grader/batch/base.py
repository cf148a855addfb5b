"""How is the data base of a class begun, opened and kept from others?"""

import fcntl
import os
import sqlite3
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from grader.batch.keys import carry_over
from grader.errors import OutputFault, UsageError
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
    """Open the data base of a folder, or begin one, and keep others away.

    Raises:
        UsageError: Another batch uses it, or what lies there is no store of ours.
        OutputFault: It cannot be written.
    """
    try:
        lock = os.open(folder / LOCK, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
    except OSError as fault:
        raise OutputFault(f"{folder / LOCK} cannot be written: {fault.strerror}") from fault
    try:
        _locked(lock, folder)
        with written():
            base = sqlite3.connect(folder / STORE, isolation_level=None)
        try:
            _prepared(base, folder)
            yield base
        finally:
            base.close()
    finally:
        os.close(lock)


def _locked(lock: int, folder: Path) -> None:
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError as fault:
        raise UsageError(
            f"{folder}: another batch writes there; wait for its end, or name another folder"
        ) from fault


def _prepared(base: sqlite3.Connection, folder: Path) -> None:
    with written():
        try:
            (version,) = base.execute("PRAGMA user_version").fetchone()
            base.execute("PRAGMA journal_mode = WAL")
        except sqlite3.DatabaseError as fault:
            if isinstance(fault, sqlite3.OperationalError):
                raise
            raise UsageError(
                f"{folder / STORE}: this is no store of results; name another folder with -o"
            ) from fault
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
        raise OutputFault(f"the store of results: {fault}; is the disk full?") from fault
