"""What lies in each student's folder? What the store holds, under the student's own name."""

import json
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path, PurePosixPath

from grader.batch.job import Job
from grader.batch.records import Result, Student
from grader.batch.store import Store
from grader.batch.work import kept
from grader.errors import OutputFault, UsageError
from grader.output import PAGE, RESULT, STUDENT, STUDENTS, VIEWS, ready, write_whole
from grader.pipeline import grade_located, withheld_grade
from grader.report import as_json
from grader.report.escape import for_json
from grader.report.facts import FOLDER
from grader.report.html.submission import to_html


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
        write_folder(folder, result, self._job.language)
        write_whole(folder / STUDENT, _known(student))
        # What we failed to grade is written anew each time, as it is graded anew.
        written = "" if student.fault else self._job.settings.digest
        self._store.mark_written(student, written)
        return True


def write_folder(folder: Path, result: Result, language: str) -> None:
    """Write a result, its attachments and its page, and remove what belongs to an earlier one.

    Raises:
        OutputFault: They could not be written.
    """
    attached = dict(result.attachments)
    try:
        ready(folder)
        wanted = {PurePosixPath(name) for name in attached}
        for old in _old(folder):
            if PurePosixPath(old.relative_to(folder).as_posix()) not in wanted:
                old.unlink()
        for name, text in attached.items():
            path = folder / name
            path.parent.mkdir(exist_ok=True)
            write_whole(path, text)
    except (UsageError, OSError) as fault:
        raise OutputFault(str(fault)) from fault
    views = json.loads(attached[VIEWS]) if VIEWS in attached else None
    write_whole(folder / PAGE, to_html(json.loads(result.text), views, language))
    # Last, so that a result is never beside what belongs to another one.
    write_whole(folder / RESULT, result.text)


def _old(folder: Path) -> Iterator[Path]:
    with suppress(OSError):
        yield from [*(folder / FOLDER).glob("*.json"), *folder.glob(VIEWS)]


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
