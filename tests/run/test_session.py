"""How workers with right, wrong and hostile libraries end, in processes as in a grade."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from grader.model.mesh import Mesh, Rays
from grader.model.stages import Ending, Stop
from grader.run import session
from grader.run.job import Job
from grader.run.protocol import Op
from grader.run.session import Allowance, Engine, run_job
from grader.run.transfer import give_mesh, trace
from tests.compiled import PATIENT
from tests.verify.builder import soup

ODD = "load of misaligned address 0x... for type 'uint32_t', which requires 4 byte alignment"


def constructed(engine: Engine, faces: int, allowed: Allowance = PATIENT) -> Ending:
    """Call `construct` on a mesh of so many faces."""
    job = Job()
    slot = give_mesh(job, soup(faces))
    job.do(Op.CONSTRUCT, slot, slot)
    ending, result = run_job(job, engine, allowed)
    assert (result is not None) == (ending.stop is Stop.FINISHED)
    return ending


@pytest.mark.parametrize(
    ("faces", "stop", "detail"),
    [
        (2, Stop.CRASHED, "ended by SIGSEGV"),
        (3, Stop.CRASHED, "ended by SIGABRT"),
        (4, Stop.CRASHED, "threw an exception: own words"),
        (5, Stop.OUT_OF_MEMORY, "asked for more memory than there is"),
        (6, Stop.CRASHED, "the program ended itself with exit status 0"),
        (8, Stop.CRASHED, "ended by SIGSEGV"),
        (9, Stop.CRASHED, "threw an exception: an exception that is not a std::exception"),
        (13, Stop.CRASHED, "ended by the sanitizer"),
        (20, Stop.CRASHED, "the program ended itself with exit status 7"),
    ],
)
def test_every_bad_end_is_the_submissions(
    hostile: tuple[Engine, Engine], faces: int, stop: Stop, detail: str
) -> None:
    """Signals, exceptions, exhausted memory and exits are values with words for the student."""
    ending = constructed(hostile[0], faces)
    assert ending.stop is stop
    assert ending.detail.startswith(detail)
    assert ending.finding == ""


@pytest.mark.parametrize(
    ("faces", "stop"),
    [
        (15, Stop.CRASHED),
        (16, Stop.FAILED_TO_START),
        (17, Stop.OUT_OF_MEMORY),
        (18, Stop.FAILED_TO_START),
        (19, Stop.CRASHED),
    ],
)
def test_a_forged_result_is_no_fault_of_ours(
    hostile: tuple[Engine, Engine], faces: int, stop: Stop
) -> None:
    """Whatever a submission writes into the header, nothing is raised and nothing is passed."""
    assert constructed(hostile[0], faces).stop is stop


def test_an_endless_loop_is_stopped(hostile: tuple[Engine, Engine]) -> None:
    """The time limit ends it, and the words name the limit."""
    ending = constructed(hostile[0], 1, Allowance(60.0, 1.5))
    assert (ending.stop, ending.detail) == (Stop.TIMED_OUT, "stopped after 1.5 s")
    assert ending.cpu_seconds > 0.1


def test_too_much_processor_time_is_a_time_out(hostile: tuple[Engine, Engine]) -> None:
    """The limit on processor time holds beside that on wall time."""
    ending = constructed(hostile[0], 1, Allowance(0.4, 60.0))
    assert ending.stop is Stop.TIMED_OUT
    assert ending.detail == "stopped after 1 s of computing time"


def test_a_flood_of_output_is_no_mistake(hostile: tuple[Engine, Engine]) -> None:
    """Thirty megabytes on both streams cost time, not points, and are not kept."""
    ending = constructed(hostile[0], 7)
    assert ending.stop is Stop.FINISHED
    assert len(ending.output) < 200_000


def test_a_long_exception_is_cut(hostile: tuple[Engine, Engine]) -> None:
    """The words of an exception have room for 512 bytes."""
    ending = constructed(hostile[0], 21)
    assert ending.detail == f"threw an exception: {'y' * 512}"


def test_a_library_that_crashes_when_it_is_loaded_crashed(crashing_at_load: Engine) -> None:
    """A static constructor runs before anything is asked, and inside the worker."""
    ending = constructed(crashing_at_load, 9)
    assert (ending.stop, ending.detail) == (Stop.CRASHED, "ended by SIGSEGV")


def test_a_function_that_is_missing_is_named(half: Engine) -> None:
    """A submission may define one of the two functions only."""
    ending = constructed(half, 9)
    assert ending.stop is Stop.FAILED_TO_START
    assert ending.detail == "not defined in this file"


def test_a_library_that_is_none_fails_to_start(half: Engine, tmp_path: Path) -> None:
    """What cannot be loaded is said in the loader's words."""
    path = tmp_path / "none.so"
    path.write_text("no library")
    ending = constructed(replace(half, library=path), 9)
    assert ending.stop is Stop.FAILED_TO_START
    assert ending.detail.startswith("the library could not be loaded: ")


@pytest.mark.parametrize(
    ("faces", "finding", "line"),
    [
        (10, "heap-buffer-overflow", 57),
        (11, "shift exponent 40 is too large for 32-bit type 'int'", 58),
        (12, "Assertion '__n < this->size()'", 59),
        (14, "heap-buffer-overflow", 61),
        (2, "SEGV", 49),
        (8, "stack-overflow", 0),
        (23, ODD, 70),
    ],
)
def test_sanitizers_name_the_finding_and_the_students_line(
    hostile: tuple[Engine, Engine], faces: int, finding: str, line: int
) -> None:
    """Overflow, undefined shift, failed assertion; also behind a flood of output.

    No address is told: it would be another one in the next run.
    """
    ending = constructed(hostile[1], faces)
    assert ending.stop is Stop.CRASHED
    assert ending.finding == finding
    assert ending.line == line or not line


def test_a_finding_without_its_report_is_still_one(hostile: tuple[Engine, Engine]) -> None:
    """Who closes stderr keeps the words from us, not that the sanitizer ended the process."""
    ending = constructed(hostile[1], 22)
    assert ending.stop is Stop.CRASHED
    assert ending.finding == "an error, whose report went to a closed stderr"


@pytest.mark.parametrize("faces", [3, 4, 6, 9])
def test_other_ends_of_the_sanitized_build_are_no_findings(
    hostile: tuple[Engine, Engine], faces: int
) -> None:
    """An abort, an exception or an exit says nothing about memory."""
    ending = constructed(hostile[1], faces)
    assert ending.stop is Stop.CRASHED
    assert ending.finding == ""


def test_memory_that_there_is_not_is_no_memory_error(hostile: tuple[Engine, Engine]) -> None:
    """The sanitizer's allocator refuses 200 GB; that is exhausted memory, not a finding."""
    ending = constructed(hostile[1], 5)
    assert (ending.stop, ending.finding) == (Stop.OUT_OF_MEMORY, "")


def test_a_row_of_reports_takes_no_time() -> None:
    """Twice as long takes twice as long, not four times: this one would take minutes."""
    report = "AddressSanitizer: "
    ending = Ending(Stop.CRASHED, "ended by the sanitizer", 1.0, 1.0, report * 100_000)
    assert session._by_sanitizer(ending) == ending
    ended = replace(ending, output=f"{report}requested 9 bytes: out of memory")
    assert session._by_sanitizer(ended).stop is Stop.OUT_OF_MEMORY


def test_a_clean_run_under_sanitizers_finishes(hostile: tuple[Engine, Engine]) -> None:
    """A library without mistakes ends regularly, and nothing is found."""
    ending = constructed(hostile[1], 30)
    assert (ending.stop, ending.finding, ending.detail) == (Stop.FINISHED, "", "")


def greedy(threads: int) -> Job:
    """Trace a ray that takes all memory, then others in some threads."""
    job, mesh = Job(), soup(9)
    slot = give_mesh(job, mesh)
    job.do(Op.CONSTRUCT, slot, slot)
    for t_max, count in ((-1, 1), (1, threads)):
        ends = np.full(1, t_max, np.float32)
        trace(
            job,
            slot,
            Rays(np.zeros((1, 3), np.float32), np.ones((1, 3), np.float32), 0 * ends, ends),
            count,
        )
    return job


def test_a_thread_for_which_no_memory_is_left_is_the_submissions(
    hostile: tuple[Engine, Engine],
) -> None:
    """A submission that leaks for every ray cannot end the whole grade."""
    ending, _ = run_job(greedy(2), hostile[0], PATIENT)
    assert ending.stop in (Stop.OUT_OF_MEMORY, Stop.CRASHED)


def test_a_mesh_for_which_no_memory_is_left_is_exhausted_memory(reference: Engine) -> None:
    """A mesh that does not fit into the limit ends the worker, not the grader."""
    vertices = np.zeros((40_000_000, 3), np.float32)
    job, limits = Job(), replace(reference.limits, memory_mib=600)
    give_mesh(job, Mesh(vertices, np.zeros((1, 3), np.uint32)))
    ending, _ = run_job(job, replace(reference, limits=limits), PATIENT)
    assert ending.stop is not Stop.FINISHED
