"""Classes for the tests: the same one as a folder and as a zip, and what is known of it."""

import json
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any

from grader.batch.job import Job
from grader.batch.layouts import Arrangement, arranged
from grader.batch.records import Student
from grader.batch.runner import Batch
from grader.batch.sources import opened_class
from grader.batch.store import opened_store
from grader.batch.table import Totals
from grader.intake.handed_in import handed_in
from grader.model.stages import Submission
from tests.intake.archives import zipped

Json = dict[str, Any]
Files = Mapping[str, str | bytes]
Found = dict[str, tuple[str, str, str]]

Made = Callable[[Path, str, Files], Path]
"""Makes a class of a name and files, in a folder."""

CODE = "void BVH::construct(const Mesh&) {}\n"


def folder_of(parent: Path, name: str, files: Files) -> Path:
    """Write a class as a folder."""
    for path, content in files.items():
        place = parent / name / path
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_bytes(content.encode() if isinstance(content, str) else content)
    return parent / name


def zip_of(parent: Path, name: str, files: Files) -> Path:
    """Write a class as a zip."""
    (parent / f"{name}.zip").write_bytes(packed(files))
    return parent / f"{name}.zip"


def packed(files: Files) -> bytes:
    """Pack a zip."""
    return zipped(
        [
            (path, text.encode() if isinstance(text, str) else text)
            for path, text in files.items()
        ]
    )


@contextmanager
def class_of(path: Path) -> Iterator[Arrangement]:
    """Open a class."""
    with opened_class(path) as source:
        yield arranged(source, path.name)


def found_in(path: Path) -> tuple[str, Found]:
    """The layout; and per name the id, the e-mail address, the text or why there is none."""
    found: Found = {}
    with class_of(path) as class_:
        for place in class_.places:
            entries = partial(place.entries, class_.source)
            given = handed_in(place.name, entries, 1 << 16)
            text = given.source.decode() if isinstance(given, Submission) else given.reason
            found[place.name] = (place.id, place.email, text)
    return class_.layout, found


class Seen:
    """Remembers what a watch is told."""

    def __init__(self) -> None:
        self.notices: list[str] = []
        self.troubles: list[str] = []
        self.finished_names: list[str] = []
        self.stages: set[str] = set()

    def reading(self, done: int, total: int) -> None:
        """Forget it."""

    def grading(self, total: int) -> None:
        """Forget it."""

    def stage(self, student: Student, stage: str) -> None:
        """Keep the name of the stage."""
        self.stages.add(stage)

    def finished(self, student: Student, score: float | None, most: float) -> None:
        """Keep the name."""
        self.finished_names.append(student.name)

    def notice(self, sentence: str) -> None:
        """Keep the sentence."""
        self.notices.append(sentence)

    def trouble(self, sentence: str) -> None:
        """Keep the sentence."""
        self.troubles.append(sentence)


def grade(path: Path, job: Job) -> tuple[Totals, Seen]:
    """Grade a class in this process."""
    seen = Seen()
    job.folder.mkdir(exist_ok=True)
    with class_of(path) as class_, opened_store(job.folder) as store:
        store.know(job.settings)
        batch = Batch(job, store, seen)
        batch.read(class_)
        batch.grade()
        return batch.write(), seen


def results(folder: Path) -> dict[str, Json]:
    """The result of each student's folder."""
    found = sorted((folder / "students").glob("*/result.json"))
    return {path.parent.name: json.loads(path.read_text()) for path in found}


def comparable(folder: Path) -> dict[str, Json]:
    """What has to be the same in the results, wherever and whenever a class is graded."""
    found = results(folder)
    for result in found.values():
        del result["timing"], result["provenance"]["cpu"]
    return found


def points(folder: Path) -> dict[str, float | None]:
    """The score in each student's folder."""
    return {slug: result["score"] for slug, result in results(folder).items()}
