"""What is to be done with a class?"""

from dataclasses import dataclass
from pathlib import Path

from grader.batch.settings import Settings, Wish
from grader.batch.work import ENTRY


@dataclass(frozen=True, slots=True)
class Job:
    """A class to be graded."""

    folder: Path
    """Where the results go."""

    settings: Settings
    wish: Wish
    clerks: int | None
    """How many submissions at a time; None for as many as are good where they are graded."""

    language: str = "en"
    """Of the pages."""

    entry: str = ENTRY
    """What a clerk does with a submission; only tests name something else."""

    scheduler: str | None = None
    """Address of a cluster that grades; None for this machine."""

    preview: bool = False
    """Keep the results in the store only, beside those of the class."""
