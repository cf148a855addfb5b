"""What is known of a student?"""

from dataclasses import dataclass

from grader.model.stages import Rejected, Submission


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

    def submission(self, source: bytes) -> Submission | Rejected:
        """Give back what intake made of it."""
        if self.sha256 is None or self.path is None:
            return Rejected(self.name, self.reason or self.fault)
        return Submission(self.name, self.path, source, self.sha256)
