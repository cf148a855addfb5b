"""What is known of a student?"""

from collections.abc import Iterable
from dataclasses import dataclass

from grader.model.stages import Rejected, Submission
from grader.report.people import named, told_apart


@dataclass(frozen=True, slots=True)
class Student:
    """One row of the class."""

    key: str
    slug: str
    name: str
    id: str
    email: str
    layout: str
    """Of the download, which says what kind of id it is."""

    path: str | None
    """Where the file lay in the submission; None if there is no gradable file."""

    sha256: str | None
    reason: str
    """Why there is no gradable file: the student's fault; empty if there is one."""

    fault: str
    """Why it could not be read: ours; empty if it could."""

    written: str
    """Settings of the result that lies in the student's folder; empty if none does."""

    @property
    def told(self) -> str:
        """Name, and id where one is known."""
        return named(self.name, self.id)

    def submission(self, source: bytes) -> Submission | Rejected:
        """Give back what intake made of it."""
        if self.sha256 is None or self.path is None:
            return Rejected(self.name, self.reason or self.fault)
        return Submission(self.name, self.path, source, self.sha256)


def names_of(students: Iterable[Student]) -> dict[str, str]:
    """Map the folders of a class to the names of their students, no two of them alike."""
    people = [(one.name, one.id, one.slug) for one in students]
    return dict(zip((slug for *_, slug in people), told_apart(people), strict=True))
