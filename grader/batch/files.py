"""What lies in each student's folder? What the store holds, under the student's own name."""

import json
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path, PurePosixPath

from grader.batch.records import Result, Student
from grader.batch.settings import Settings, Wish
from grader.batch.store import Store
from grader.batch.work import kept
from grader.errors import OutputFault, UsageError
from grader.output import RESULT, ready, write_whole
from grader.pipeline import grade_located, withheld_grade
from grader.report import as_json
from grader.report.escape import for_json
from grader.report.facts import FOLDER

STUDENTS = "students"


class Results:
    """The results of a class with some settings."""

    def __init__(self, store: Store, settings: Settings, wish: Wish) -> None:
        """Take where they are kept, and how they came about."""
        self._store, self._settings, self._wish = store, settings, wish

    def of(self, student: Student) -> Result | None:
        """The result of a student; None if the submission waits to be graded."""
        given = student.submission(b"")
        if student.sha256 is not None:
            found = self._store.result(student.sha256, self._settings)
            if found is not None:
                renamed = json.loads(found.text) | {"submission": as_json.submission(given)}
                return Result(for_json(renamed) + "\n", found.attachments)
        options = self._wish.options()
        if student.fault:
            return kept(withheld_grade(given, options, student.fault))
        # Nothing is compiled of what holds no file.
        return kept(grade_located(given, options)) if student.sha256 is None else None

    def write(self, folder: Path, student: Student) -> bool:
        """Write a student's folder; False if there is nothing to write yet.

        Raises:
            OutputFault: It could not be written.
        """
        result = self.of(student)
        if result is None:
            return False
        write_folder(folder / STUDENTS / student.slug, result)
        # What we failed to grade is written anew each time, as it is graded anew.
        self._store.mark_written(student, "" if student.fault else self._settings.digest)
        return True


def write_folder(folder: Path, result: Result) -> None:
    """Write a result and its attachments, and remove those of an earlier result.

    Raises:
        OutputFault: They could not be written.
    """
    try:
        ready(folder)
        wanted = {PurePosixPath(name) for name, _ in result.attachments}
        for old in _old(folder):
            if PurePosixPath(old.relative_to(folder).as_posix()) not in wanted:
                old.unlink()
        for name, text in result.attachments:
            path = folder / name
            path.parent.mkdir(exist_ok=True)
            write_whole(path, text)
    except (UsageError, OSError) as fault:
        raise OutputFault(str(fault)) from fault
    # Last, so that a result is never beside the attachments of another one.
    write_whole(folder / RESULT, result.text)


def _old(folder: Path) -> Iterator[Path]:
    with suppress(OSError):
        yield from list((folder / FOLDER).glob("*.json"))
