"""Was a submission saved? However an editor does it, only what lies there counts."""

from pathlib import Path

from grader.errors import UsageError
from grader.intake.locate import locate
from grader.model.stages import Submission

GLANCE_SECONDS = 0.25
"""Between two looks; two of them have to agree, so a save is noticed within 0.5 s."""

LARGEST = 1 << 20
"""Bytes of a source file that are looked at; the grade itself applies the rubric's limit."""

GONE = ""
"""State of a path where nothing is at the moment."""


def state_of(path: Path) -> str:
    """Return a hash of what would be graded, or `GONE`."""
    try:
        found = locate(path, LARGEST)
    except UsageError:
        return GONE
    return found.sha256 if isinstance(found, Submission) else f"rejected: {found.reason}"
