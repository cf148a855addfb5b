"""How do the findings of a run become a grade, with its provenance and its times?"""

import time
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import grader
from grader.diagnose.causes import causes_by_part
from grader.diagnose.notes import Notes
from grader.model.cases import (
    AlteredCase,
    Case,
    ImageCase,
    MemoryCase,
    SurvivalCase,
    TreeCase,
    WorkCase,
)
from grader.model.grade import Grade, Provenance, Timing
from grader.model.stages import PARTS, Build, Rejected, Stop, Submission
from grader.model.trials import ImageTrial, Trial, part_of
from grader.model.verdict import Finding, Verdict
from grader.options import Options, Progress
from grader.oracle.scenes import scenes_sha256
from grader.sandbox.streams import DROPPED
from grader.score.points import (
    crashes_earn_nothing,
    final_score,
    score_checks,
    score_parts,
)
from grader.selection import Selection
from grader.tolerances import FACES_PER_LEAF
from grader.verify.engine import NOTHING, Examiner, looks_at
from grader.verify.planned import kinds_of, planned_cases
from grader.verify.tree import shape
from grader.verify.work import excludes_most_triangles, unproven

Stages = list[tuple[str, float]]
"""Name and wall seconds of each stage so far."""


@contextmanager
def timed(name: str, progress: Progress, stages: Stages) -> Iterator[None]:
    """Take the wall time of one stage and show that it has begun."""
    progress(name, 0, 0)
    started = time.monotonic()
    yield
    stages.append((name, time.monotonic() - started))


class Summary:
    """What is known of one submission so far."""

    def __init__(
        self,
        selection: Selection,
        options: Options,
        isolation: str,
        before: Sequence[tuple[str, float]] = (),
    ) -> None:
        """Begin with nothing.

        Args:
            selection: The checks and what they are worth.
            options: How to grade.
            isolation: Name of the level that submissions run at.
            before: Stages that are over. They are the grader's own work, and take nothing of
                the submission's time.
        """
        self.selection, self.options = selection, options
        self._isolation = isolation
        self._examiner = Examiner(selection.checks)
        self._notes = Notes()
        self._findings: list[Finding] = []
        self._untouched: set[str] = set()
        self._touched: set[str] = set()
        self._dead: set[str] = set()
        self._begun = time.monotonic()
        self._stages = list(before)
        self._seconds_before = sum(spent for _, spent in before)
        self._worker_seconds = 0.0
        self._flooded = 0
        self.plan_seconds = 0.0
        """Wall seconds that the plan of the trials took."""

    def elapsed(self) -> float:
        """Wall seconds of the submission's time: what was before it is left out."""
        return time.monotonic() - self._begun

    @contextmanager
    def stage(self, name: str) -> Iterator[None]:
        """Take the wall time of one stage and show that it has begun."""
        with timed(name, self.options.progress, self._stages):
            yield

    def examine(self, cases: Iterable[Case]) -> None:
        """Decide the checks on cases as they come in; none of them is kept."""
        for case in cases:
            if isinstance(case, SurvivalCase | MemoryCase) and case.ending.crowded:
                self._crowded(case.trial)
                continue
            self._note(case)
            self._notes.note(case)
            found = list(self._examiner.examine([case]))
            if isinstance(case, SurvivalCase):
                found += self._unproven(case)
            if isinstance(case, SurvivalCase | MemoryCase | ImageCase):
                found = [self._placed(each, case.trial) for each in found]
            self._findings += found

    def _placed(self, finding: Finding, trial: Trial) -> Finding:
        """Add to a finding what a picture weighs, and whether students see where it was."""
        weight = trial.weight if isinstance(trial, ImageTrial) else finding.weight
        return replace(finding, weight=weight, shown=not self.selection.is_secret(trial))

    def _unproven(self, case: SurvivalCase) -> list[Finding]:
        """Judge what a worker that died has left unproven."""
        evidence = unproven(case)
        check = excludes_most_triangles
        if evidence is None or check not in self.selection.checks:
            return []
        return [Finding(check.id, case.name, Verdict.FAIL, evidence)]

    def _crowded(self, trial: Trial) -> None:
        """Conclude nothing from a worker that had to wait for others than itself."""
        reason = "it stood in line for a processor for too long; grade it again"
        self._findings += [
            self._placed(Finding(each.id, trial.name, Verdict.BROKEN, NOTHING, reason), trial)
            for each in self.selection.checks
            if each.kind in kinds_of(trial) and each.when(trial)
        ]

    def broken(self, faults: Iterable[tuple[str, str]]) -> None:
        """Take note of our own faults: the name of a trial and what went wrong there.

        They are answers that contradict each other, so all checks that compare with answers
        are undecided, whichever trial it was.
        """
        for name, reason in faults:
            self._findings += [
                Finding(each.id, name, Verdict.BROKEN, NOTHING, reason)
                for each in self.selection.checks
                if each.id.startswith(("hits.", "image.")) or each.kind is AlteredCase
            ]

    def failed_to_judge(self, reason: str) -> None:
        """Conclude nothing at all: we failed before or between the checks."""
        self._findings = [
            Finding(each.id, "grader", Verdict.BROKEN, NOTHING, reason)
            for each in self.selection.checks
        ]

    def closed(self, gate: str) -> bool:
        """Tell whether a gate has been decided and has passed nowhere."""
        verdicts = {one.verdict for one in self._findings if one.check == gate}
        return bool(verdicts) and verdicts <= {Verdict.FAIL, Verdict.BLOCKED}

    def failed(self, check: str) -> bool:
        """Tell whether a check has failed anywhere so far."""
        return any(one.check == check and one.verdict is Verdict.FAIL for one in self._findings)

    def grade(
        self, given: Submission | Rejected, build: Build | None, trials: Sequence[Trial]
    ) -> Grade:
        """Score what was found."""
        build = self._remarked(build)
        rubric, checks = self.selection.rubric, self.selection.checks
        started = self._started()
        scores = score_checks(
            rubric,
            [(each.id, each.title) for each in checks],
            self._findings,
            planned_cases(checks, trials),
            started,
        )
        scores = crashes_earn_nothing(scores, started & {"a"} & self._untouched - self._touched)
        causes = causes_by_part(self._notes, self._notes.only(self._is_told), scores)
        seconds = self._examiner.seconds
        scores = tuple(
            replace(one, seconds=seconds[one.check], cause=causes.get(one.check))
            for one in scores
        )
        parts = score_parts(rubric, scores, started)
        total = final_score(scores)
        return Grade(
            submission=given,
            build=build,
            parts=parts,
            checks=scores,
            score=total,
            max_score=sum(one.max_score for one in scores),
            needs_review=total is None,
            provenance=self._provenance(build),
            timing=self.timing(build),
            traceback=self._traceback(),
        )

    def _traceback(self) -> str:
        """Put together how each check broke in the first case where it did."""
        broken = {one.check: one for one in reversed(self._findings) if one.traceback}
        return "\n".join(
            f"{one.check} in {one.case}:\n{one.traceback}" for one in broken.values()
        )

    def _is_told(self, case: Case) -> bool:
        """Tell whether a student may hear of a case."""
        trial, secret = getattr(case, "trial", None), self.selection.secret
        looking = (each.id for each in self.selection.checks if looks_at(each, case))
        is_secret = trial is not None and self.selection.is_secret(trial)
        return not is_secret and not secret.issuperset(looking)

    def _started(self) -> set[str]:
        """Tell which parts no longer do what the given code does.

        Testing every face of a tree that it walks is a mistake; the given loop has no tree.
        """
        started = self._touched | self._dead | (set(PARTS) - self._untouched)
        return started if self.closed("work.uses-the-tree") else started | {"b"}

    def _note(self, case: Case) -> None:
        """See whether a part still does what the given code does."""
        if isinstance(case, SurvivalCase | MemoryCase):
            self._worker_seconds += case.ending.seconds
            self._flooded += DROPPED.decode() in case.ending.output
            if case.ending.finding or case.ending.stop is Stop.CRASHED:
                # The given code does neither, even where a tree is still only its root.
                self._dead.add(part_of(case.trial))
        elif isinstance(case, TreeCase) and len(case.trial.mesh.faces) > FACES_PER_LEAF:
            split = shape(case.bvh).inner.size > 0
            (self._touched if split else self._untouched).add("a")
        elif isinstance(case, WorkCase):
            every_face = case.triangle_tests >= len(case.trial.mesh.faces)
            given_loop = case.box_tests == 0 and every_face
            (self._untouched if given_loop else self._touched).add("b")

    def _remarked(self, build: Build | None) -> Build | None:
        """Add what is worth knowing of the run and costs nothing."""
        if build is None:
            return None
        remarks = list(build.remarks)
        if self._flooded:
            limit = self.selection.rubric.limits.output_kib
            remarks.append(f"it prints more than {limit} KiB in one run; the rest was dropped")
        if hidden := self.selection.hidden:
            names = ", ".join(hidden)
            remarks.append(f"the rubric hides these checks, so they were not run: {names}")
        return replace(build, remarks=tuple(remarks))

    def _provenance(self, build: Build | None) -> Provenance:
        return Provenance(
            grader=grader.__version__,
            rubric_sha256=self.selection.rubric.sha256,
            scenes_sha256=scenes_sha256(self.selection.rubric.scenes),
            seed=self.options.seed,
            compiler=build.compiler if build else "",
            flags=build.flags if build else (),
            isolation=self._isolation,
            cpu=cpu_name(),
        )

    def timing(self, build: Build | None) -> Timing:
        """Say where the time went until now."""
        before, checks = self._seconds_before, sum(self._examiner.seconds.values())
        return Timing(
            compile=build.seconds if build else 0.0,
            submission=self._worker_seconds,
            grader=before + self.plan_seconds + checks,
            total=before + self.elapsed(),
            stages=tuple(self._stages),
        )


def cpu_name() -> str:
    """Name of the processor, as the kernel tells it; empty if it does not."""
    try:
        lines = Path("/proc/cpuinfo").read_text(errors="replace").splitlines()
    except OSError:
        return ""
    names = (line.partition(":")[2].strip() for line in lines if line.startswith("model name"))
    return next(names, "")
