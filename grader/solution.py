"""What our own solution says: its trees, and the time that it takes for a trial."""

import shutil
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from grader.build.compiling import TRUSTED
from grader.build.reference import reference_library
from grader.errors import WorkerFault
from grader.model.cases import Case, SurvivalCase, TreeCase, WorkCase
from grader.model.grade import Limits
from grader.model.mesh import Bvh, Mesh
from grader.model.stages import Stop
from grader.model.trials import ConstructTrial, Trial, WorkTrial
from grader.oracle.plan import Plan, kept_plan
from grader.oracle.remember import digest_of, remember
from grader.oracle.scenes import scenes_sha256
from grader.run.batches import run_batch
from grader.run.session import Allowance, Engine
from grader.run.trials import Budget, Engines, run_trials
from grader.sandbox.selftest import unconfined

GENEROUS = Limits(
    small_seconds=60.0,
    large_seconds=300.0,
    wall_factor=3.0,
    total_seconds=3600.0,
    memory_mib=4096,
    tasks=64,
    open_files=64,
    stack_mib=16,
    output_kib=64,
    source_kib=1024,
    compiler=TRUSTED,
)
"""The reference is ours: these limits only end a machine's bad day."""


MOST_PLANS = 12
"""How many plans stay in memory. One has 60 MB, and only who certifies needs more than one."""


def beside(case: WorkCase, reference: WorkCase) -> WorkCase:
    """Put what the reference did for the same trial beside what a submission did."""
    return replace(
        case, reference_cpu_seconds=reference.cpu_seconds, reference_t=reference.hits.t
    )


_FACE = Mesh(np.eye(3, dtype=np.float32), np.arange(3, dtype=np.uint32)[None])

_kept: dict[tuple[int, Path, str], Plan] = {}
"""The last plans, by what they were drawn from."""


class Solution:
    """The reference's library, built once for a grade."""

    def __init__(self) -> None:
        self._library = reference_library()

    def trees(self, meshes: Sequence[Mesh]) -> list[Bvh]:
        """Build the reference's tree of each mesh, or take it from the cache.

        Raises:
            WorkerFault: The reference did not come back.
        """
        return [self._tree(mesh) for mesh in meshes]

    def plan(self, seed: int, own: Path | None = None) -> Plan:
        """Draw the trials of a seed, with our trees in them; the last plans are kept in memory.

        They say nothing of a submission, so whoever grades a second one need not draw again.

        Args:
            seed: Two plans of one seed are equal.
            own: A course's own folder of scenes, used beside the shipped one.

        Raises:
            OracleFault: A stored mesh or picture is missing, damaged or stale.
            MissingTool: embreex is not installed.
            UsageError: A line of the own folder's `scenes.toml` is wrong.
        """
        key = (seed, self._library, scenes_sha256(own))
        if key not in _kept:
            while len(_kept) >= MOST_PLANS:
                del _kept[next(iter(_kept))]
            _kept[key] = kept_plan(seed, self.trees, self._library.name, own)
        return _kept[key]

    def fresh_trees(self, meshes: Sequence[Mesh]) -> list[Bvh]:
        """Build the reference's trees of small meshes in one process, past the cache.

        Raises:
            WorkerFault: The reference did not come back.
        """
        trials = [ConstructTrial("reference", mesh) for mesh in meshes]
        allowed = Allowance(GENEROUS.small_seconds, GENEROUS.total_seconds)
        delivery = run_batch(trials, Engine(self._library, GENEROUS, unconfined()), allowed)
        if delivery.ending.stop is not Stop.FINISHED:
            message = f"the reference failed on small meshes: {delivery.ending.detail}"
            raise WorkerFault(message)
        cases = [case for delivered in delivery.cases for case in delivered]
        return [case.bvh for case in cases if isinstance(case, TreeCase)]

    def cases(self, trial: Trial) -> list[Case]:
        """What the reference delivers for one trial.

        Raises:
            WorkerFault: The reference did not come back.
        """
        return self._run([trial])

    def work(self, trials: Sequence[Trial]) -> dict[str, WorkCase]:
        """What the reference delivers for each trial that counts work, now and here.

        Raises:
            WorkerFault: The reference did not come back.
        """
        work = [trial for trial in trials if isinstance(trial, WorkTrial)]
        return {case.name: case for case in self._run(work) if isinstance(case, WorkCase)}

    def vouch(self, engine: Engine) -> None:
        """Run our own library as a submission's is run, and from where it lies.

        Raises:
            WorkerFault: It cannot be put there, or does not come back either.
        """
        own = engine.library.with_name("vouching.so")
        try:
            shutil.copyfile(self._library, own)
        except OSError as fault:
            raise WorkerFault(f"{own} cannot be written: {fault.strerror}") from fault
        allowed = Allowance(GENEROUS.small_seconds, GENEROUS.total_seconds)
        here = replace(engine, library=own, nursery=None)
        ending = run_batch([ConstructTrial("reference", _FACE)], here, allowed).ending
        if ending.stop is not Stop.FINISHED:
            raise WorkerFault(
                f"the reference cannot be run from {own.parent} either: {ending.detail}; set "
                "TMPDIR to a folder from which programs may be run"
            )

    def _tree(self, mesh: Mesh) -> Bvh:
        key = digest_of("tree", self._library.name, mesh.vertices, mesh.faces)
        return remember(key, lambda: self._build(mesh))

    def _build(self, mesh: Mesh) -> Bvh:
        cases = self._run([ConstructTrial("reference", mesh)])
        return next(case.bvh for case in cases if isinstance(case, TreeCase))

    def _run(self, trials: Sequence[Trial]) -> list[Case]:
        engine = Engine(self._library, GENEROUS, unconfined())
        cases: list[Case] = []
        for delivered in run_trials(
            trials, Engines(engine), Budget(GENEROUS, GENEROUS.total_seconds), _silent
        ):
            cases += delivered
        for case in cases:
            if isinstance(case, SurvivalCase) and case.ending.stop is not Stop.FINISHED:
                message = f"the reference failed on {case.name}: {case.ending.detail}"
                raise WorkerFault(message)
        return cases


def _silent(done: int, total: int) -> None:
    """Say nothing: the reference's workers are not what anyone waits for."""
