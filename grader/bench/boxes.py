"""What do `construct` and `intersect` cost? Timed from outside, in boxes as in a grade.

A worker reports no time, and its own clock would be believed by nobody. So a worker is run with
and without the calls in question, and the difference of its CPU time is theirs. `construct` is
called often enough that the rest hardly shows.
"""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from grader.bench.record import Cost
from grader.errors import WorkerFault
from grader.model.grade import Limits
from grader.model.mesh import Bvh, Mesh, Rays
from grader.model.stages import Stop
from grader.run.job import Job
from grader.run.protocol import Op
from grader.run.session import Allowance, Engine, run_job
from grader.run.transfer import give_mesh, read_tree, trace
from grader.sandbox.nursery import Nursery
from grader.sandbox.selftest import proved_isolation
from grader.solution import GENEROUS

CALLS = 3
"""Calls of `construct` of which the mean is taken."""

_ALLOWED = Allowance(300.0, 1800.0)
Fill = Callable[[Job, int], None]


@dataclass(frozen=True, slots=True)
class Timer:
    """Runs workers on libraries of ours, in the boxes that submissions run in."""

    nursery: Nursery
    mesh: Mesh
    limits: Limits = GENEROUS

    def construct(self, library: Path) -> Cost:
        """Return the cost of one call of `construct`."""
        most = self._run(library, lambda job, slot: _construct(job, slot, 1 + CALLS))
        least = self._run(library, lambda job, slot: _construct(job, slot, 1))
        return _mean(most, least, CALLS)

    def trace(self, library: Path, rays: Rays, times: int = 1) -> Cost:
        """Return the cost of tracing rays on the tree that the library builds."""
        with_rays = self.traced(library, rays, times)
        without = self._run(library, lambda job, slot: _construct(job, slot, 1))
        return _mean(with_rays, without, times)

    def traced(self, library: Path, rays: Rays, times: int = 1) -> Cost:
        """Return the cost of a worker that builds a tree and traces rays."""

        def fill(job: Job, slot: int) -> None:
            _construct(job, slot, 1)
            for _ in range(times):
                trace(job, slot, rays)

        return self._run(library, fill)

    def tree(self, library: Path) -> Bvh:
        """Return the tree that a library builds.

        Raises:
            WorkerFault: It built none.
        """
        job = Job()
        slot = give_mesh(job, self.mesh)
        _construct(job, slot, 1)
        read = read_tree(job, slot, self.mesh)
        ending, result = run_job(job, self._engine(library), _ALLOWED)
        if result is None:
            raise WorkerFault(f"a solution of ours did not build a tree: {ending.detail}")
        return read(result)

    def _run(self, library: Path, fill: Fill) -> Cost:
        job = Job()
        fill(job, give_mesh(job, self.mesh))
        ending, _ = run_job(job, self._engine(library), _ALLOWED)
        if ending.stop is not Stop.FINISHED:
            raise WorkerFault(f"a solution of ours did not come back: {ending.detail}")
        return Cost(ending.cpu_seconds, ending.seconds)

    def _engine(self, library: Path) -> Engine:
        return Engine(library, self.limits, proved_isolation(), nursery=self.nursery)


def _mean(most: Cost, least: Cost, times: int) -> Cost:
    """Return what one of so many calls cost; 0 if that was lost in the noise."""
    cpu, wall = (most.cpu - least.cpu) / times, (most.wall - least.wall) / times
    return Cost(max(cpu, 0.0), max(wall, 0.0))


def _construct(job: Job, slot: int, times: int) -> None:
    """Build the mesh's own tree, and others beside it: each in memory that is fresh."""
    job.do(Op.CONSTRUCT, slot, slot)
    for _ in range(times - 1):
        job.do(Op.CONSTRUCT, job.make(Op.TREE), slot)
