"""What each stage before the verdict hands on: the submission, its build, a worker's end."""

from dataclasses import dataclass
from enum import Enum
from pathlib import Path

PARTS = ("a", "b")
"""Part a is `BVH::construct`, part b is `intersect(mesh, ray)`."""

SOURCE_NAME = "exercise03.cpp"
"""The one file of the exercise that a student edits."""

SOURCE_PATH = f"src/{SOURCE_NAME}"
"""Where it lies in the exercise, and its name in every message, wherever it really lies."""


@dataclass(frozen=True, slots=True)
class Submission:
    """The one file of a student, as bytes."""

    student: str
    """Name of the file, folder or archive, made printable."""

    path: str
    """Where the file lay inside the submission, made printable; `exercise03.cpp` if alone."""

    source: bytes
    sha256: str


@dataclass(frozen=True, slots=True)
class Rejected:
    """What was handed in holds no gradable file: a student's fault, worth 0 points."""

    student: str
    reason: str


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """One message of the compiler or linker, as hostile text."""

    line: int
    """1-based line of the student's file; 0 if the message has none."""

    column: int
    severity: str
    """`error`, `warning` or `note`."""

    text: str


@dataclass(frozen=True, slots=True)
class Call:
    """One function that calls another, both as mangled names."""

    caller: str
    callee: str


@dataclass(frozen=True, slots=True)
class CallGraph:
    """Who calls whom in the student's translation unit, as the compiler sees it."""

    calls: tuple[Call, ...]
    lines: tuple[tuple[str, int], ...]
    """Mangled name and 1-based line in `src/exercise03.cpp` of each function defined there."""

    taken: tuple[Call, ...] = ()
    """Who takes the address of which function or table, and what stands in each table."""

    selves: tuple[str, ...] = ()
    """Functions that fill a `std::function` with a lambda that holds this very object."""


class Further(Enum):
    """What may be made of a submission beside its graded library."""

    SANITIZED = "sanitized"
    DEEP = "deep"
    CALLS = "calls"


@dataclass(frozen=True, slots=True)
class Build:
    """What the compiler made of a submission; `library` is None if it did not compile."""

    library: Path | None
    """Shared library with the graded flags."""

    sanitized: Path | None
    """The same with sanitizers and a small depth limit; None if it could not be made.

    This and the next two are None, too, if nothing of the run looks at them.
    """

    deep: Path | None
    """The same with sanitizers and the real depth limit, which trees of part b may need."""

    calls: CallGraph | None
    diagnostics: tuple[Diagnostic, ...]
    compiler: str
    """Name and version, `g++ 12.2.0`."""

    flags: tuple[str, ...]
    seconds: float
    remarks: tuple[str, ...] = ()
    """What is worth knowing of the runs of this build, and costs nothing."""

    own_seconds: float = 0.0
    """What its compilers had of the processors, however long they stood in line for them."""


class Stop(Enum):
    """How a worker ended; every value is something that a submission did."""

    FINISHED = "finished"
    CRASHED = "crashed"
    TIMED_OUT = "timed_out"
    OUT_OF_MEMORY = "out_of_memory"
    FORBIDDEN = "forbidden"
    FAILED_TO_START = "failed_to_start"


@dataclass(frozen=True, slots=True)
class Ending:
    """How and where one worker ended."""

    stop: Stop
    detail: str
    """One sentence for the student, `` if finished: `SIGSEGV in construct`."""

    seconds: float
    """Wall time of the worker."""

    cpu_seconds: float
    """CPU time of the worker, measured from outside."""

    output: str
    """Tail of what was printed: the student's words, hostile text."""

    finding: str = ""
    """First finding of a sanitizer: `heap-buffer-overflow in BVH::construct`."""

    line: int = 0
    """Line of the student's file that the finding names; 0 if none."""

    by_clock: bool = False
    """True if its wall time was over, and not its CPU time."""

    delayed_seconds: float = 0.0
    """How much of its time the worker stood in line for a processor."""

    crowded: bool = False
    """True if the clock ended it because it stood in line for too long: our fault."""
