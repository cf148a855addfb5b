"""What does isolation cost a worker? `python -m tests.sandbox.cost` measures it.

For each level, with a box of its own and in a kept one: the wall time from the order to the
result of a worker that constructs a tree over 37 faces. The kinds take turns, so that other
work on the machine meets all of them alike. It asserts nothing.
"""

import statistics
import tempfile
import time
from contextlib import ExitStack
from pathlib import Path

import numpy as np

from grader.model.mesh import Mesh
from grader.model.stages import Stop
from grader.resources import reference_source
from grader.run.job import Job
from grader.run.protocol import Op
from grader.run.session import Allowance, Engine, run_job
from grader.run.transfer import give_mesh
from grader.sandbox.nursery import Nursery
from grader.sandbox.selftest import proved_isolation, unconfined
from grader.score.rubric import load_rubric
from tests.compiled import library_of

ROUNDS = 41
FACES = 37


def main() -> None:
    """Print medians and minima in milliseconds."""
    limits = load_rubric(None).limits
    with tempfile.TemporaryDirectory(prefix="bvhgrade-cost-") as folder, ExitStack() as held:
        Path(folder).chmod(0o711)
        library = library_of(reference_source().read_text(), Path(folder))
        kinds = {}
        for name, isolation in (
            ("none", unconfined()),
            ("B", proved_isolation("B")),
            ("A", proved_isolation("A")),
        ):
            kinds[f"{name}, a box of its own"] = Engine(library, limits, isolation)
            nursery = held.enter_context(Nursery())
            kinds[f"{name}, kept"] = Engine(library, limits, isolation, nursery=nursery)
        # Nothing is kept without isolation.
        del kinds["none, kept"]
        taken: dict[str, list[float]] = {name: [] for name in kinds}
        for _ in range(ROUNDS):
            for name, engine in kinds.items():
                taken[name].append(_seconds(engine))
        for name, seconds in taken.items():
            middle, least = statistics.median(seconds) * 1000, min(seconds) * 1000
            print(f"{name:22} median {middle:5.1f} ms, least {least:5.1f} ms")  # noqa: T201 - its result


def _seconds(engine: Engine) -> float:
    begun = time.monotonic()
    job = Job()
    slot = give_mesh(job, _mesh())
    job.do(Op.CONSTRUCT, slot, slot)
    ending, _ = run_job(job, engine, Allowance(20, 60))
    if ending.stop is not Stop.FINISHED:
        raise SystemExit(f"the worker did not finish: {ending}")
    return time.monotonic() - begun


def _mesh() -> Mesh:
    random = np.random.default_rng(1)
    vertices = random.random((3 * FACES, 3), np.float32)
    return Mesh(vertices, np.arange(3 * FACES, dtype=np.uint32).reshape(-1, 3))


if __name__ == "__main__":
    main()
