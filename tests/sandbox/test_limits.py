"""Each limit of a worker: just under it passes, just over it stops with its own words."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from grader.build.compile import compile_submission
from grader.build.compiler import find_compiler, sanitizer_runtime
from grader.model.mesh import Bvh, Mesh
from grader.model.stages import Build, Ending, Stop
from grader.run.job import Job
from grader.run.protocol import Op
from grader.run.session import Allowance, Engine, run_job
from grader.run.transfer import give_mesh, read_tree
from grader.sandbox.box import Box, Isolation
from grader.sandbox.confine import confined
from grader.sandbox.launch import Outcome
from grader.sandbox.nursery import Nursery
from grader.sandbox.streams import DROPPED
from grader.sandbox.target import Target
from tests.compiled import PATIENT, compilation, engine_of, submission_of
from tests.sandbox.boxes import counts_tasks

SOURCE = Path(__file__).with_name("limits.cpp")
SPIN, SPIN_TWICE, IGNORE, SLEEP, MEMORY, THREADS = range(1, 7)
FILES, STACK, PRINT, WRITE, NODES, OVERFLOW = range(7, 13)
"""What limits.cpp uses, by the number of faces."""

FINISHED = (Stop.FINISHED, "")


@pytest.fixture(scope="session")
def built(cache: Path, tmp_path_factory: pytest.TempPathFactory) -> Build:
    """Compile limits.cpp once, plain and with sanitizers."""
    folder = tmp_path_factory.mktemp("limits")
    build = compile_submission(submission_of(SOURCE.read_text()), compilation(folder / "x"))
    assert build.library, build.diagnostics
    assert build.sanitized
    return build


@pytest.fixture
def engine(isolation: Isolation, built: Build, open_folder: Path) -> Engine:
    """Give the plain library at each level, with the limits of the shipped rubric."""
    assert built.library
    return at_level(engine_of(built.library), isolation, open_folder)


@pytest.fixture
def sanitized(isolation: Isolation, built: Build, open_folder: Path) -> Engine:
    """Give the sanitized library at each level."""
    assert built.sanitized
    runtime = sanitizer_runtime(find_compiler())
    return at_level(engine_of(built.sanitized, runtime), isolation, open_folder)


def at_level(engine: Engine, isolation: Isolation, folder: Path) -> Engine:
    """Put a library where a box can see it."""
    library = folder / "graded.so"
    library.write_bytes(engine.library.read_bytes())
    library.chmod(0o644)
    return replace(engine, isolation=isolation, library=library)


def flat(faces: int, amount: float) -> Mesh:
    """Make a mesh of so many faces whose first vertex says how much to use."""
    vertices = np.array([[amount, 0, 0], [0, 1, 0], [0, 0, 1]], np.float32)
    return Mesh(vertices, np.tile(np.arange(3, dtype=np.uint32), (faces, 1)))


def used(engine: Engine, what: int, amount: float, allowed: Allowance = PATIENT) -> Ending:
    """Let `construct` use so much of something."""
    job = Job()
    slot = give_mesh(job, flat(what, amount))
    job.do(Op.CONSTRUCT, slot, slot)
    return run_job(job, engine, allowed)[0]


def limited(engine: Engine, **limits: int) -> Engine:
    """Change limits of an engine."""
    return replace(engine, limits=replace(engine.limits, **limits))  # type: ignore[arg-type]  # named by the test


def stop(ending: Ending) -> tuple[Stop, str]:
    """Give how a worker ended, and the words for it."""
    return ending.stop, ending.detail


def test_wall_time(engine: Engine) -> None:
    """Sleep is no computing, but it ends too."""
    assert stop(used(engine, SLEEP, 1, Allowance(60, 60))) == FINISHED
    ending = used(engine, SLEEP, 3600, Allowance(60, 2))
    assert stop(ending) == (Stop.TIMED_OUT, "stopped after 2 s")
    assert ending.cpu_seconds < 2


def test_computing_time(engine: Engine) -> None:
    """What was used is measured from outside."""
    ending = used(engine, SPIN, 0.7, Allowance(1, 90))
    assert stop(ending) == FINISHED
    assert 0.7 <= ending.cpu_seconds < 1.5
    ending = used(engine, SPIN, 3600, Allowance(1, 90))
    assert stop(ending) == (Stop.TIMED_OUT, "stopped after 1 s of computing time")
    assert 0.5 < ending.cpu_seconds < 2


def test_computing_time_of_two_threads_together(engine: Engine) -> None:
    """Neither thread uses two seconds, both together do."""
    ending = used(engine, SPIN_TWICE, 0.5, Allowance(2, 90))
    assert stop(ending) == FINISHED
    assert 1 <= ending.cpu_seconds < 2
    ending = used(engine, SPIN_TWICE, 1.6, Allowance(2, 90))
    assert stop(ending) == (Stop.TIMED_OUT, "stopped after 2 s of computing time")


@pytest.mark.parametrize(("seconds", "stopped"), [(0.9, False), (1.1, True)])
def test_computing_time_that_the_kernel_did_not_stop(
    engine: Engine, monkeypatch: pytest.MonkeyPatch, seconds: float, stopped: bool
) -> None:
    """Its own limit counts ticks and may come late; what was seen in the end decides."""

    def late(
        target: Target, box: Box, entry: Path, isolation: Isolation, _: Nursery | None
    ) -> Outcome:
        return replace(confined(target, box, entry, isolation), cpu_seconds=seconds)

    monkeypatch.setattr("grader.run.session.confined", late)
    ending = used(engine, STACK, 1, Allowance(1, 90))
    said = (Stop.TIMED_OUT, "stopped after 1 s of computing time")
    assert stop(ending) == (said if stopped else FINISHED)


def test_computing_time_of_who_ignores_the_signal(engine: Engine) -> None:
    """One second later it is killed, and called by the same name."""
    ending = used(engine, IGNORE, 3600, Allowance(1, 90))
    assert stop(ending) == (Stop.TIMED_OUT, "stopped after 1 s of computing time")
    assert 1 < ending.cpu_seconds < 3


def test_memory(engine: Engine) -> None:
    """The limit is the address space of the process, of which it has used a part before."""
    small = limited(engine, memory_mib=512)
    assert stop(used(small, MEMORY, 300)) == FINISHED
    ending = used(small, MEMORY, 512)
    assert ending.stop is Stop.OUT_OF_MEMORY
    assert ending.detail == "asked for more memory than there is (std::bad_alloc)"


def test_memory_beyond_what_a_sanitizer_reserves(sanitized: Engine) -> None:
    """Terabytes of shadow do not count, the submission's own memory does."""
    small = limited(sanitized, memory_mib=512)
    assert stop(used(small, MEMORY, 300)) == FINISHED
    ending = used(small, MEMORY, 513)
    assert stop(ending) == (Stop.OUT_OF_MEMORY, "asked for more memory than there is")


def test_a_sanitizer_speaks_as_without_a_box(sanitized: Engine) -> None:
    """It gets its options, and names the student's line although there is no /proc."""
    (line,) = [
        number
        for number, text in enumerate(SOURCE.read_text().splitlines(), start=1)
        if text.endswith("// overflow")
    ]
    ending = used(sanitized, OVERFLOW, 0)
    assert stop(ending) == (Stop.CRASHED, "ended by the sanitizer")
    assert (ending.finding, ending.line) == ("heap-buffer-overflow", line)


def test_threads(engine: Engine) -> None:
    """The limit counts the first thread, and no process of ours."""
    most = engine.limits.tasks
    ending = used(engine, THREADS, most - 1)
    assert stop(ending) == (Stop.CRASHED, f"threw an exception: {most - 1} threads")
    made = most - 1 if counts_tasks(engine.isolation) else most
    ending = used(engine, THREADS, most)
    assert ending.detail == f"threw an exception: {made} threads"


@pytest.mark.parametrize("most", [16, 32])
def test_open_files(engine: Engine, most: int) -> None:
    """Three streams, and the two files of a worker with the maps of them, count."""
    free = most - 7
    small = limited(engine, open_files=most)
    assert used(small, FILES, free).detail == f"threw an exception: {free} files"
    assert used(small, FILES, free + 1).detail == f"threw an exception: {free} files"


def test_stack(engine: Engine) -> None:
    """A recursion of 7 MiB fits into 8 MiB, one of 8 does not."""
    small = limited(engine, stack_mib=8)
    assert stop(used(small, STACK, 7)) == FINISHED
    assert stop(used(small, STACK, 8)) == (Stop.CRASHED, "ended by SIGSEGV")


def test_output(engine: Engine) -> None:
    """All of it is kept up to the byte; beyond, the middle is dropped and nobody is stopped."""
    small = limited(engine, output_kib=4)
    ending = used(small, PRINT, 4096)
    assert (stop(ending), ending.output) == (FINISHED, "x" * 4096)
    ending = used(small, PRINT, 4097)
    half = "x" * 2048
    assert (stop(ending), ending.output) == (FINISHED, half + DROPPED.decode() + half)
    assert stop(used(small, PRINT, 1 << 23)) == FINISHED


def test_a_debug_file(engine: Engine) -> None:
    """A worker writes no file at all, and whoever tries loses nothing."""
    assert stop(used(engine, WRITE, 0)) == FINISHED
    assert not Path("/tmp/debug").exists()  # noqa: S108 - where the submission would put it


def tree_of(engine: Engine, count: int) -> tuple[Ending, Bvh]:
    """Have a tree of so many nodes copied out."""
    job, mesh = Job(), flat(NODES, count)
    slot = give_mesh(job, mesh)
    job.do(Op.CONSTRUCT, slot, slot)
    read = read_tree(job, slot, mesh)
    ending, result = run_job(job, engine, PATIENT)
    assert result
    return ending, read(result)


def test_size_of_a_result(engine: Engine) -> None:
    """What does not fit is counted and not copied; a check says that it is too many."""
    for count, kept in ((1023, 1023), (1024, 1024), (1025, 1024), (100_000, 1024)):
        ending, tree = tree_of(engine, count)
        assert stop(ending) == FINISHED
        assert (tree.node_count, len(tree.begin), len(tree.low)) == (count, kept, kept)
