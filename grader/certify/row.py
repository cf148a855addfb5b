"""What does the grader say of one submission of the corpus with one seed?"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

from grader.certify.corpus import digest_of, name_of
from grader.errors import GraderError
from grader.model.grade import Grade
from grader.model.verdict import Verdict
from grader.options import Options
from grader.pipeline import grade_with

LONGEST = 300
"""Characters of a message that are kept."""


@dataclass(frozen=True, slots=True)
class Row:
    """One submission, graded once."""

    name: str
    """Folder and file: `wrong/axis-always-x.cpp`."""

    digest: str
    """Start of the file's SHA-256: a row says nothing of a file that has changed."""

    seed: int
    scores: tuple[float, ...]
    """Points of part a and part b."""

    failed: tuple[str, ...]
    """Checks that failed, in the order of the report."""

    broken: tuple[str, ...] = ()
    """What our own fault kept from being decided."""

    because: str = field(default="", compare=False)
    """What the first failed check says."""


def graded_row(path: Path, seed: int) -> Row:
    """Grade one submission of the corpus."""
    return graded_rows(path, (seed,))[0]


def graded_rows(path: Path, seeds: Sequence[int]) -> list[Row]:
    """Grade one submission of the corpus with several seeds; a row for each."""
    name, digest = name_of(path), digest_of(path)
    try:
        grades = grade_with(path, Options(0, None, (), lambda *_: None), seeds)
    except GraderError as fault:
        broken = (str(fault).splitlines()[0],)
        return [Row(name, digest, seed, (), (), broken) for seed in seeds]
    return [_row(name, digest, seed, grade) for seed, grade in zip(seeds, grades, strict=True)]


def _row(name: str, digest: str, seed: int, grade: Grade) -> Row:
    scores = tuple(part.score for part in grade.parts)
    failed, broken = _with(grade, Verdict.FAIL), _with(grade, Verdict.BROKEN)
    because = next((one.message for one in grade.checks if one.verdict is Verdict.FAIL), "")
    return Row(name, digest, seed, scores, failed, broken, because[:LONGEST])


def _with(grade: Grade, verdict: Verdict) -> tuple[str, ...]:
    return tuple(one.check for one in grade.checks if one.verdict is verdict)
