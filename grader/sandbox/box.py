"""What may a confined process see, write and use, and at which level is it confined?"""

from dataclasses import dataclass
from enum import Enum
from pathlib import Path


class Level(Enum):
    """How far a submission is kept from this machine, best first.

    The value is what the result names; a level is only used once it has been proved.
    """

    NAMESPACES = "bubblewrap+landlock+seccomp"
    """A: namespaces of its own, an empty root, no privileges; inside it all of the next."""

    NAMESPACES_ALONE = "bubblewrap+seccomp"
    """A on a kernel without Landlock: the second of two walls around the files is missing."""

    PROCESS = "landlock+seccomp"
    """B: no namespaces; another user if the grader is root, Landlock, filtered system calls."""

    USER = "uid+seccomp"
    """C: no Landlock either; another user, filtered system calls; only for root."""

    NONE = "none"
    """D: resource limits only, for code that the caller trusts."""


LETTERS = {
    "A": (Level.NAMESPACES, Level.NAMESPACES_ALONE),
    "B": (Level.PROCESS,),
    "C": (Level.USER,),
}
"""How an operator names levels, best first."""

BUBBLES = LETTERS["A"]
"""Levels at which bubblewrap makes namespaces."""


@dataclass(frozen=True, slots=True)
class Bounds:
    """Resource limits of one process; 0 leaves the caller's own."""

    cpu_seconds: int
    memory_bytes: int
    """Address space."""

    file_bytes: int = 0
    open_files: int = 0
    tasks: int = 0
    """Processes and threads of the box together."""

    stack_bytes: int = 0
    beyond_reserved: bool = False
    """Whether the memory counts from what the process has when it is confined."""


@dataclass(frozen=True, slots=True)
class Box:
    """One confinement; what is not named here is neither seen nor written."""

    readable: tuple[Path, ...]
    """Files and folders of ours, besides the system's libraries."""

    bounds: Bounds
    writable: Path | None = None
    """A fresh, empty folder of ours, which the process gets for itself."""

    starts_programs: bool = False
    """True for a compiler: it sees the system's programs and headers too, and may fork."""


@dataclass(frozen=True, slots=True)
class Isolation:
    """A level, and what it needs on this machine."""

    level: Level
    interpreter: Path
    """A Python that the confined process can read."""

    unproved: tuple[str, ...] = ()
    """Why the better levels are not used, one sentence each."""

    uid: int = 0
    """User of one box, if the grader is root; 0 for the grader's own."""
