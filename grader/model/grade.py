"""What a whole grade is: the record that every report is written from."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from grader.model.stages import Build, Rejected, Stop, Submission
from grader.model.verdict import Example, Verdict

if TYPE_CHECKING:
    # They hold arrays, and `bvhgrade --help` does without numpy.
    from grader.model.counterexample import Counterexample
    from grader.model.views import Views

VISIBILITIES = ("visible", "hidden", "after_due_date")
"""Of a criterion and of a scene; `check` runs visible ones only."""


@dataclass(frozen=True, slots=True)
class Criterion:
    """What one check is worth: a row of the rubric."""

    check: str
    part: str
    points: float
    gate: bool
    """If no case passes, or it is bypassed in most, the whole part earns nothing."""

    visibility: str
    """`visible`, `hidden` or `after_due_date`."""


@dataclass(frozen=True, slots=True)
class CompileLimits:
    """How much compiling one submission once may use."""

    seconds: int
    """CPU seconds of each process."""

    wall_seconds: int
    memory_mib: int
    """Address space of each process."""

    file_mib: int
    """Largest file that may be written."""

    tasks: int
    output_kib: int
    """How much of the messages is kept."""


@dataclass(frozen=True, slots=True)
class Limits:
    """How much one worker may use."""

    small_seconds: float
    """CPU seconds of a worker on meshes below 20,000 faces, all its threads together."""

    large_seconds: float
    """CPU seconds of a worker on larger meshes and of pictures."""

    wall_factor: float
    """Wall time of a worker in multiples of its CPU time: load is nobody's fault."""

    total_seconds: float
    """Wall time of a whole grade."""

    memory_mib: int
    """Address space of a worker; of a sanitized one, beyond what the sanitizer reserves."""

    tasks: int
    """Threads of a worker, its first one included."""

    open_files: int
    stack_mib: int
    output_kib: int
    """How much of the printed output is kept."""

    source_kib: int
    """Largest source file that is accepted."""

    compiler: CompileLimits


@dataclass(frozen=True, slots=True)
class Rubric:
    """Points, visibility, limits and readings; the only place with points."""

    criteria: tuple[Criterion, ...]
    titles: tuple[tuple[str, str], ...]
    """Part id and title: `("a", "BVH construction")`."""

    limits: Limits
    leaf_rule: str
    """`sheet` or `full-levels`."""

    sha256: str
    scenes: Path | None = None
    """A course's own folder of scenes, used beside the shipped one."""


@dataclass(frozen=True, slots=True)
class Cause:
    """The misconception that likely made a check fail; it moves no point."""

    id: str
    sentence: str
    """In English, the key of its translations."""

    fits: int
    """Places that are as this misconception foretells."""

    places: int
    """All places that can tell."""


@dataclass(frozen=True, slots=True)
class CheckScore:
    """One check over all its cases, with what it earned."""

    check: str
    part: str
    title: str
    verdict: Verdict
    score: float
    max_score: float
    visibility: str
    examined: int
    """How many single things were looked at, over all cases."""

    wrong: int
    message: str
    expected: str
    got: str
    examples: tuple[Example, ...]
    blocked_by: str | None
    stop: Stop
    line: int
    """Line of the student's file that the evidence points at; 0 if none."""

    cases: tuple[tuple[str, Verdict], ...]
    seconds: float
    cause: Cause | None = None
    """None if nothing failed, or if nobody can be sure why."""
    counterexample: "Counterexample | None" = None
    """The smallest input that fails the check, if one was looked for and found."""


@dataclass(frozen=True, slots=True)
class PartScore:
    """One part of the exercise."""

    part: str
    title: str
    score: float
    max_score: float
    started: bool
    """False if the part still does what the unedited starter does."""


@dataclass(frozen=True, slots=True)
class Provenance:
    """Everything that makes two results comparable."""

    grader: str
    rubric_sha256: str
    scenes_sha256: str
    seed: int
    compiler: str
    flags: tuple[str, ...]
    isolation: str
    """Name of the level that was proved; `none` says that the run was not isolated."""

    cpu: str


@dataclass(frozen=True, slots=True)
class Timing:
    """Where the time went, wall seconds."""

    compile: float
    submission: float
    """Sum of the workers' wall time."""

    grader: float
    """Intake, the proof of isolation, the plan of the trials and all checks; the latter two
    overlap with the other times."""

    total: float
    stages: tuple[tuple[str, float], ...]
    """Name and wall seconds of each stage of the pipeline."""


@dataclass(frozen=True, slots=True)
class Grade:
    """The result of one submission."""

    submission: Submission | Rejected
    build: Build | None
    """None if there was nothing to build."""

    parts: tuple[PartScore, ...]
    checks: tuple[CheckScore, ...]
    score: float | None
    """None if withheld because some check is BROKEN."""

    max_score: float
    needs_review: bool
    provenance: Provenance
    timing: Timing
    traceback: str = ""
    """Of the checks of ours that broke, for a maintainer; no report shows it."""

    views: "Views | None" = None
    """What a report shows; None if nobody asked for it, or nothing ran."""
