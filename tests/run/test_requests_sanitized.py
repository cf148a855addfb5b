"""What a worker of the sanitized build does for trials of several meshes."""

from grader.model.cases import MemoryCase
from grader.model.stages import Stop
from grader.model.trials import RebuildTrial, RepeatTrial
from grader.run.requests import request
from grader.run.session import Engine, run_job
from grader.verify.planned import kinds_of
from tests.compiled import PATIENT
from tests.verify.builder import soup
from tests.verify.trials import rebuilds, repeats


def test_sanitized_workers_are_looked_at_when_they_end(reference: Engine) -> None:
    """What they deliver is not compared: one job, and no case but its end."""
    of_two: tuple[RebuildTrial | RepeatTrial, ...] = (*rebuilds(soup(1)), *repeats(soup(37)))
    for trial in (each for each in of_two if each.sanitized):
        asked = request(trial)
        (job,) = asked.jobs
        ending, result = run_job(job, reference, PATIENT)
        assert ending.stop is Stop.FINISHED
        assert result is not None
        assert asked.read([result], ending) == ()
        assert kinds_of(trial) == (MemoryCase,)
