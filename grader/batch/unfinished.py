"""Whose folder does not hold what the class's store knows, as after a run that ended early?"""

from pathlib import Path

from grader.batch.files import is_written
from grader.batch.store import read_store
from grader.gradebook.results import Marked, ids_by_batch
from grader.output import STORE

AGAIN = "call `bvhgrade batch` again"


def unfinished(folder: Path) -> list[Marked]:
    """List the students of a class whose points are not to be taken from their folders.

    An earlier result may lie there, of a file that was replaced, or none.

    Args:
        folder: Of the class; nobody is listed if it is none that `bvhgrade batch` keeps.

    Raises:
        UsageError: A batch uses it right now.
    """
    if not (folder / STORE).is_file():
        return []
    found: list[Marked] = []
    with read_store(folder) as store:
        settings = store.current()
        for student in store.students():
            if settings is None or not is_written(student, folder, settings):
                state = "its points are withheld" if student.fault else "it is not finished"
                ids = ids_by_batch(student.name, student.id, student.email, student.layout)
                found.append(Marked(student.slug, ids, {}, f"{state}: {AGAIN}"))
    return found
