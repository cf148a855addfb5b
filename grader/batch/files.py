"""What lies in each student's folder? What the store holds, under the student's own name."""

import json
import os
import shutil
from pathlib import Path

from grader.batch.job import Job
from grader.batch.records import Student
from grader.batch.settings import Settings
from grader.batch.store import Store
from grader.errors import OutputFault, UsageError
from grader.kept import Result, kept, write_result
from grader.output import RESULT, STUDENT, STUDENTS, ready, write_whole
from grader.pipeline import grade_located, withheld_grade
from grader.report import as_json
from grader.report.escape import for_json


class Results:
    """The results of a class with some settings."""

    def __init__(self, store: Store, job: Job) -> None:
        """Take where they are kept, and how they came about."""
        self._store, self._job = store, job

    def of(self, student: Student) -> Result | None:
        """The result of a student; None if the submission waits to be graded."""
        given = student.submission(b"")
        if student.sha256 is not None:
            found = self._store.result(student.sha256, self._job.settings)
            if found is not None:
                renamed = json.loads(found.text) | {"submission": as_json.submission(given)}
                return Result(for_json(renamed) + "\n", found.attachments)
        options = self._job.wish.options()
        if student.fault:
            return kept(withheld_grade(given, options, student.fault))
        # Nothing is compiled of what holds no file.
        return kept(grade_located(given, options)) if student.sha256 is None else None

    def write(self, student: Student) -> bool:
        """Write a student's folder; False if there is nothing to write yet.

        Raises:
            OutputFault: It could not be written.
        """
        result = self.of(student)
        if result is None:
            return False
        folder = self._job.folder / STUDENTS / student.slug
        try:
            write_result(ready(folder), result, self._job.language)
        except UsageError as fault:
            raise OutputFault(str(fault)) from fault
        write_whole(folder / STUDENT, _known(student))
        try:
            _on_disk(folder)
        except OSError as fault:
            raise OutputFault(f"{folder} could not be written: {fault.strerror}") from fault
        # What we failed to grade is written anew each time, as it is graded anew.
        written = "" if student.fault else self._job.settings.digest
        self._store.mark_written(student, written)
        return True


def is_written(student: Student, folder: Path, settings: Settings) -> bool:
    """Whether a student's folder holds the result of these settings.

    Args:
        student: Whose folder.
        folder: Of the class; somebody may have removed files in it.
        settings: Of the class.
    """
    own = folder / STUDENTS / student.slug
    return student.written == settings.digest and all(
        (own / name).is_file() and (own / name).stat().st_size for name in (RESULT, STUDENT)
    )


def _on_disk(folder: Path) -> None:
    """Wait until a student's files are on disk: the store will say that they are written."""
    for path in (folder / RESULT, folder / STUDENT, folder):
        handle = os.open(path, os.O_RDONLY | os.O_CLOEXEC | os.O_NOFOLLOW)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def remove_folder(job: Job, student: Student) -> None:
    """Remove a student's folder.

    Raises:
        OutputFault: It is there, and cannot be removed.
    """
    folder = job.folder / STUDENTS / student.slug
    try:
        shutil.rmtree(folder)
    except FileNotFoundError:
        return
    except OSError as fault:
        raise OutputFault(f"{folder} cannot be removed: {fault.strerror}") from fault


def _known(student: Student) -> str:
    """Say whose folder it is, for who brings the points into a gradebook."""
    names = {
        "schema": 1,
        "name": student.name,
        "id": student.id,
        "email": student.email,
        "layout": student.layout,
    }
    return for_json(names) + "\n"
