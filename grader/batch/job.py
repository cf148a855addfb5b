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
    clerks: int
    language: str = "en"
    """Of the pages."""

    entry: str = ENTRY
    """What a clerk does with a submission; only tests name something else."""

    preview: bool = False
    """Keep the results in the store only, beside those of the class."""
