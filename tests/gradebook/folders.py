"""Folders of a class, one for each student, with real results in them."""

import json
import sqlite3
from collections.abc import Mapping
from contextlib import closing
from pathlib import Path

from tests.report import real

CLASS = {
    "Ada Lovelace_101_assignsubmission_file": "right",
    "Grace Hopper_102_assignsubmission_file": "first-hit-wins",
    "Jörg Müller_103_assignsubmission_file": "boxes-of-the-parent",
    "Lin Tan_104_assignsubmission_file": "uncompiled",
    "No File_105_assignsubmission_file": "rejected",
    "Our Fault_106_assignsubmission_file": "withheld",
}

POINTS = {101: 50, 102: 38.25, 103: 46.25, 104: 0, 105: 0}
"""Of each participant; nobody knows those of 106."""


def write_batch(
    folder: Path, layout: str, students: Mapping[str, tuple[str, str, str]]
) -> Path:
    """Write what `bvhgrade batch` writes of a class of right submissions.

    Args:
        folder: Where; it is made.
        layout: Of the download.
        students: Name of a folder; and name, id and e-mail address of the student.
    """
    write_class(folder / "students", dict.fromkeys(students, "right"))
    with closing(sqlite3.connect(folder / "batch.sqlite", isolation_level=None)) as store:
        store.execute("CREATE TABLE student (slug TEXT)")
        store.executemany("INSERT INTO student VALUES (?)", [(slug,) for slug in students])
    for slug, (name, id, email) in students.items():
        known = {"schema": 1, "name": name, "id": id, "email": email, "layout": layout}
        (folder / "students" / slug / "student.json").write_text(json.dumps(known))
    return folder


def write_class(folder: Path, students: Mapping[str, str]) -> Path:
    """Write a real result for each student.

    Args:
        folder: Where; it is made.
        students: Name of a folder, and of a real result.
    """
    results = real.every_result()
    for student, name in students.items():
        below = folder / student
        below.mkdir(parents=True)
        (below / "result.json").write_text(json.dumps(results[name]), encoding="utf-8")
    return folder
