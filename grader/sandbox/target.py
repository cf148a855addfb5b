"""What runs in a box, and when is a failure before it ours?"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

ATTEMPTS = 2
"""A failure of ours before anything foreign ran is tried again."""

START_SECONDS = 15.0
"""How long our own part may take before the target begins; it takes some hundredths of one."""


@dataclass(frozen=True, slots=True)
class Target:
    """What a box runs."""

    program: str
    """A module beside enter.py, or the absolute path of a program."""

    arguments: Sequence[str]
    """A module gets the numbers of its descriptors after them, as they are in the box."""

    seconds: float
    """Wall time."""

    output_bytes: int
    folder: Path | None = None
    descriptors: tuple[int, ...] = ()
    environment: Mapping[str, str] | None = None
    """Added to the plain environment."""

    until: int | None = None
    """A descriptor of ours; once it can be read, the target is ended as if its time was over.
    For modules only."""

    resident_bytes: int = 0
    """Memory that it may hold, where no limit counts it; 0 for any. For modules only."""

    @property
    def is_module(self) -> bool:
        """Whether it is Python of ours, which runs in a copy of a waiting process."""
        return "/" not in self.program
