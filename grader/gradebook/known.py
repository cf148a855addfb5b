"""Whose folders are those of a class? Its store says it, and nothing that lies on the disk.

A folder may be left of somebody who is no longer part of the class, with old points in it.
"""

import os
import sqlite3
from contextlib import closing
from pathlib import Path
from urllib.parse import quote

from grader.errors import UsageError
from grader.output import STORE, STUDENTS


def is_students(folder: Path) -> bool:
    """Whether a folder holds those of the students of a class."""
    here = folder.resolve()
    return here.name == STUDENTS and (here.parent / STORE).is_file()


def class_of(folder: Path) -> Path | None:
    """Find the class that has a folder among those of its students; None if there is none."""
    above = folder.resolve().parents
    return next((each.parent for each in above if is_students(each)), None)


def read_only(folder: Path) -> str:
    """Name the data base of a class for SQLite, to be read even where nothing can be written.

    SQLite keeps a note of readers beside the file, and has to be told if it cannot.
    """
    how = "mode=ro" if os.access(folder, os.W_OK) else "mode=ro&immutable=1"
    name = quote(str((folder / STORE).absolute()).encode(errors="surrogateescape"))
    return f"file:{name}?{how}"


def known_folders(folder: Path) -> set[str]:
    """List the names of the students' folders of a class.

    Only these names are read here; all else about its store is known by who keeps it.

    Raises:
        UsageError: It has no store that can be read.
    """
    try:
        with closing(sqlite3.connect(read_only(folder), uri=True)) as base:
            return {name for (name,) in base.execute("SELECT slug FROM student")}
    except sqlite3.Error as fault:
        raise UsageError(
            f"{folder / STORE}: {fault}, but it says who is part of the class; call "
            "`bvhgrade batch` again"
        ) from fault
