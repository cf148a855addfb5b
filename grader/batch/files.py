"""What lies in each student's folder? What the store holds, under the student's own name."""

import json
import os
import shutil
from pathlib import Path
from stat import S_ISREG

from grader.batch.job import Job
from grader.batch.records import Student
from grader.batch.settings import Settings
from grader.batch.store import Store
from grader.errors import OutputFault, UsageError
from grader.gradebook.results import read_result
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
        if student.sha256 is not None:
            found = self._store.result(student.sha256, self._job.settings)
            if found is not None:
                given = as_json.submission(student.submission(b""))
                renamed = json.loads(found.text) | {"submission": given}
                return Result(for_json(renamed) + "\n", found.attachments)
        is_waiting = student.sha256 is not None and not student.fault
        return None if is_waiting else self._made(student)

    def _made(self, student: Student) -> Result | None:
        """Make what the store does not keep, since nothing is compiled for it."""
        given, options = student.submission(b""), self._job.wish.options()
        if student.fault:
            return kept(withheld_grade(given, options, student.fault))
        return kept(grade_located(given, options))

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


class Standing(Results):
    """The results that a class has, with whatever it was graded: no result is made here."""

    def _made(self, student: Student) -> Result | None:
        found = standing(student, self._job.folder, self._job.settings)
        return None if found is None else Result(for_json(found) + "\n", ())


def standing(student: Student, folder: Path, settings: Settings) -> as_json.Json | None:
    """Read the result of who handed in no file: the store has none, but the folder does.

    Args:
        student: Whose folder.
        folder: Of the class.
        settings: Of the class.
    """
    try:
        found = read_result(folder / STUDENTS / student.slug / RESULT)
    except UsageError:
        return None
    # A folder with points that are withheld is never marked as written.
    counts = found["needs_review"] if student.fault else student.written == settings.digest
    return found if counts else None


def is_written(student: Student, folder: Path, settings: Settings) -> bool:
    """Whether a student's folder holds the result of these settings.

    Args:
        student: Whose folder.
        folder: Of the class; somebody may have removed files in it.
        settings: Of the class.
    """
    own = folder / STUDENTS / student.slug
    return student.written == settings.digest and all(
        _is_there(own / name) for name in (RESULT, STUDENT)
    )


def _is_there(path: Path) -> bool:
    """Whether a file is there that holds something; power that fails can leave an empty one."""
    try:
        found = path.stat()
    except OSError:
        return False
    return S_ISREG(found.st_mode) and found.st_size > 0


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
