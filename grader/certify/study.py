"""What becomes of one mutant? Cheap questions first: most are answered by one compilation.

A mutant is compiled once. If its library is the original's, byte for byte, it is the same
program. Otherwise trials are run until the first point is lost, those on meshes of some hundred
faces first. What loses none there is built with sanitizers and asked what only those builds
tell; and then it is compared with the original, result by result, on trials that were not used
to grade it.
"""

import hashlib
import math
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

from grader.build.compile import compile_trusted
from grader.build.compiler import find_compiler
from grader.build.workspace import GRADED, workspace
from grader.certify.fates import Fate, Studied
from grader.certify.mutants import Mutant, originals
from grader.certify.row import LONGEST
from grader.errors import GraderError
from grader.model.cases import Case, MemoryCase, SurvivalCase, WorkCase
from grader.model.stages import SOURCE_NAME, Stop, Submission
from grader.model.trials import RebuildTrial, Trial
from grader.model.verdict import Verdict
from grader.options import Options
from grader.oracle.plan import deeper_trials, make_plan
from grader.pipeline import grade_one
from grader.resources import private_cache
from grader.run.protocol import DATA_OFFSET
from grader.run.requests import request
from grader.run.session import Allowance, Engine, run_job
from grader.run.trials import Budget, Engines, is_sanitized, run_trials
from grader.sandbox.scratch import scratch_folder
from grader.sandbox.selftest import unconfined
from grader.score.rubric import load_rubric
from grader.selection import Selection, select
from grader.solution import GENEROUS, Solution, beside
from grader.verify.engine import Examiner

HURRIED = replace(GENEROUS, small_seconds=2.0, large_seconds=20.0, total_seconds=240.0)
"""Right submissions use 0.1 s on small meshes: who needs 2 s there does not come back."""

FIRST = 600
"""Meshes of about so many faces come first: small, and large enough for most mistakes."""

OTHER_SEED = 1
"""Added to the seed of grading: what is compared beyond what was graded."""

REST = (
    "source.construct-loops",
    "bvh.depth-is-limited",
    "bvh.memory-is-safe",
    "hits.memory-is-safe",
)
"""Checks that look at other builds, or at the call graph, and not at the graded library."""

ATTEMPTS = 3
"""A busy machine decides nothing."""


def study_or_none(mutant: Mutant, seed: int) -> Studied | None:
    """Find out what becomes of a mutant; None if the machine is too busy to tell."""
    try:
        return studied(mutant, seed)
    except GraderError:
        return None


def studied(mutant: Mutant, seed: int) -> Studied:
    """Find out what becomes of a mutant.

    Args:
        mutant: What to study.
        seed: What it is graded with.

    Raises:
        GraderError: Our own fault, or the machine is too busy.
    """
    with scratch_folder() as folder:
        fate, by = _fate(mutant, seed, folder)
    return Studied(
        mutant.digest,
        seed,
        mutant.original,
        mutant.kind,
        mutant.line,
        mutant.change,
        fate.value,
        by,
    )


def _fate(mutant: Mutant, seed: int, folder: Path) -> tuple[Fate, str]:
    library = compile_trusted(_submission(mutant.source), folder / "mutant")
    if library is None:
        return Fate.INVALID, ""
    original = _original(mutant.original)
    if library.read_bytes() == original.read_bytes():
        return Fate.SAME_CODE, ""
    by = _first_loss(library, seed) or _other_loss(mutant, seed, folder)
    if by:
        return Fate.CAUGHT, by
    difference = _first_difference(library, original, seed + OTHER_SEED)
    return (Fate.SURVIVED, difference) if difference else (Fate.SAME_RESULTS, "")


def _submission(source: bytes) -> Submission:
    return Submission("mutant", SOURCE_NAME, source, hashlib.sha256(source).hexdigest())


@cache
def _original(name: str) -> Path:
    """Build the library of an original, once for this grader and compiler."""
    source = originals()[name].read_bytes()
    framework = repr(workspace(find_compiler(), GRADED)).encode()
    kept = (
        private_cache("certify") / f"{hashlib.sha256(source + framework).hexdigest()[:24]}.so"
    )
    if not kept.exists():
        with TemporaryDirectory(dir=kept.parent) as scratch:
            library = compile_trusted(_submission(source), Path(scratch))
            if library is None:
                raise AssertionError(f"{name} is right, but does not compile")
            library.replace(kept)
    return kept


def _first_loss(library: Path, seed: int) -> str:
    """Run trials until a point is lost; the check and the trial, or nothing."""
    examiner = Examiner(_selection().checks)
    scored = {one.check for one in _selection().rubric.criteria}
    for case in _cases(library, seed):
        if isinstance(case, SurvivalCase | MemoryCase) and case.ending.crowded:
            continue
        for finding in examiner.examine([case]):
            if finding.verdict is Verdict.FAIL and finding.check in scored:
                return f"{finding.check}, {case.name}"
    return ""


def _cases(library: Path, seed: int) -> Iterator[Case]:
    engines = Engines(Engine(library, HURRIED, unconfined()))
    budget = Budget(HURRIED, HURRIED.total_seconds)
    reference = _reference_work(seed)
    for delivered in run_trials(_trials(seed), engines, budget, lambda *_: None):
        for case in delivered:
            if isinstance(case, WorkCase):
                yield beside(case, reference[case.name])
            else:
                yield case


@cache
def _selection() -> Selection:
    return select(None, ())


@cache
def _trials(seed: int) -> tuple[Trial, ...]:
    """Lay out the trials of the graded build, the telling and cheap ones first."""
    plan = make_plan(seed, Solution().trees)
    every = _selection().useful((*plan.trials, *deeper_trials(seed)))
    plain = [trial for trial in every if not is_sanitized(trial)]
    return tuple(sorted(plain, key=_distance))


def _distance(trial: Trial) -> float:
    mesh = trial.first if isinstance(trial, RebuildTrial) else trial.mesh
    return abs(math.log((len(mesh.faces) + 1) / FIRST))


@cache
def _reference_work(seed: int) -> dict[str, WorkCase]:
    return Solution().work(_trials(seed))


def _other_loss(mutant: Mutant, seed: int, folder: Path) -> str:
    """Grade what no trial of the graded library tells; what is lost first, or nothing."""
    path = folder / SOURCE_NAME
    path.write_bytes(mutant.source)
    for _ in range(ATTEMPTS):
        grade = grade_one(path, Options(seed, None, REST, lambda *_: None))
        if not grade.needs_review:
            lost = (one for one in grade.checks if one.score < one.max_score)
            return next((f"{one.check}, {one.message[:LONGEST]}" for one in lost), "")
    raise GraderError("the machine is too busy to grade a mutant; try again later")


def _first_difference(library: Path, original: Path, seed: int) -> str:
    """Name a trial in which two libraries do not return the same bytes; else nothing."""
    known = _bytes_of_original(original, seed)
    differing = (one for one in _trials(seed) if _bytes_of(library, one) != known[one.name])
    return next((f"{trial.name}, seed {seed}" for trial in differing), "")


@cache
def _bytes_of_original(library: Path, seed: int) -> dict[str, bytes]:
    return {trial.name: _bytes_of(library, trial) for trial in _trials(seed)}


def _bytes_of(library: Path, trial: Trial) -> bytes:
    """Digest of all that a library returns in a trial: trees, hits and counts of tests."""
    engine = Engine(library, load_rubric(None).limits, unconfined())
    digest = hashlib.sha256()
    for job in request(trial).jobs:
        ending, result = run_job(job, engine, Allowance(40.0, 120.0))
        if result is None or ending.stop is not Stop.FINISHED:
            return ending.detail.encode()
        digest.update(result.text(DATA_OFFSET, job.result_size - DATA_OFFSET))
    return digest.digest()
