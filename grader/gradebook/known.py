"""Whose folders are those of a class? Its store says it, and nothing that lies on the disk.

A folder may be left of somebody who is no longer part of the class, with old points in it.
"""

import sqlite3
from contextlib import closing
from pathlib import Path

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


def known_folders(folder: Path) -> set[str]:
    """List the names of the students' folders of a class.

    Only these names are read here; all else about its store is known by who keeps it.

    Raises:
        UsageError: It has no store that can be read.
    """
    try:
        with closing(sqlite3.connect(folder / STORE)) as base:
            return {name for (name,) in base.execute("SELECT slug FROM student")}
    except sqlite3.Error as fault:
        raise UsageError(
            f"{folder / STORE}: {fault}, but it says who is part of the class; call "
            "`bvhgrade batch` again"
        ) from fault
