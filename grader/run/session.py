"""What became of one worker: how it ended, and its result if it finished."""

import math
import re
import signal
from dataclasses import dataclass, replace
from pathlib import Path

from grader.model.grade import Limits
from grader.model.stages import SOURCE_PATH, Ending, Stop
from grader.run.job import Job, Result
from grader.run.protocol import ERROR_CAPACITY, ERROR_OFFSET, Status
from grader.sandbox.box import Bounds, Box, Isolation
from grader.sandbox.confine import confined
from grader.sandbox.launch import Outcome
from grader.sandbox.nursery import Nursery
from grader.sandbox.stage import staged
from grader.sandbox.target import Target

MODULES = tuple(
    Path(__file__).with_name(f"{name}.py") for name in ("worker", "protocol", "abi")
)
"""What a worker is made of: `worker` is what it becomes once it is confined."""

_BY_TICKS = 0.75
"""The kernel's limit counts whole ticks, which on a busy machine are more than was used, or
less."""

FILE_BYTES = 1 << 20
"""A worker writes no file; the pages of its result do not count."""

PLAIN = {
    # Else each thread on a machine of many cores reserves memory that the limit counts.
    "MALLOC_ARENA_MAX": "4",
    # Else a library with two kilobytes of `thread_local` is refused: the counters' model of
    # access wants all of it in the room that glibc keeps for libraries, in each thread.
    "GLIBC_TUNABLES": f"glibc.rtld.optional_static_tls={1 << 20}",
}
"""The environment of a worker."""

_WITH_SHADOW = 1.25
"""Memory under a sanitizer, whose notes on eight bytes take one more. What it maps before the
limit of address space is set, that limit does not see."""

_TOO_MUCH = "asked for more memory than there is"

SANITIZER_EXIT = 86
SANITIZER_ENVIRONMENT = {
    # An assertion ends in abort: handled, it leaves a stack with the student's line.
    "ASAN_OPTIONS": f"detect_leaks=0:exitcode={SANITIZER_EXIT}:max_allocation_size_mb=2048:"
    "handle_abort=1:allocator_may_return_null=1:detect_odr_violation=0:"
    # References to local variables of a function that has returned. Each thread gets 256 KiB
    # for each of the eleven sizes of frames, and not up to a MiB, so that 64 have room.
    "detect_stack_use_after_return=1:max_uar_stack_size_log=18",
    "UBSAN_OPTIONS": f"print_stacktrace=1:exitcode={SANITIZER_EXIT}",
}

_FINDINGS = (
    # Memory that there is not is no memory error, and an abort without more is no finding.
    re.compile(r"ERROR: AddressSanitizer: (?!ABRT|out of |allocat)([\w-]+)"),
    re.compile(r"runtime error: (.{1,200})"),
    re.compile(r"(Assertion '.{1,120}') failed"),
)
# Bounded: one row of 128 KiB that begins a thousand reports would be read a thousand times.
_EXHAUSTED = re.compile(
    r"AddressSanitizer: "
    r"(.{0,200}out of memory|allocation-size-too-big|hard rss limit exhausted)"
)
# An address is another one in each run, and two runs with one seed say the same.
_ADDRESS = re.compile(r"\b0x[0-9a-f]{1,16}\b")
_OWN_LINE = re.compile(rf"{re.escape(SOURCE_PATH)}:(\d{{1,7}})")


@dataclass(frozen=True, slots=True)
class Engine:
    """A library to run workers on, and what a worker may use."""

    library: Path
    limits: Limits
    isolation: Isolation
    preload: str = ""
    """Shared sanitizer runtime; empty for a plain library."""

    nursery: Nursery | None = None
    """Keeps boxes from one job to the next; None to start one for each."""


@dataclass(frozen=True, slots=True)
class Allowance:
    """How long one worker may take."""

    cpu_seconds: float
    """Of all its threads together."""

    wall_seconds: float


def run_job(job: Job, engine: Engine, allowed: Allowance) -> tuple[Ending, Result | None]:
    """Carry out a job in a fresh process.

    Returns:
        How it ended, and the result if every row was carried out.

    Raises:
        WorkerFault: There is no memory for the input, or the process could not be confined.
        MissingTool: The interpreter cannot be started.
    """
    ending, result = carried_out(job, engine, allowed)
    return ending, result if ending.stop is Stop.FINISHED else None


def carried_out(job: Job, engine: Engine, allowed: Allowance) -> tuple[Ending, Result]:
    """Carry out as much of a job as the submission lets us, in a fresh process.

    Returns:
        How it ended, and the result, which is whole up to `rows_done`.
    """
    entry = staged(MODULES)
    environment, resident = dict(PLAIN), 0
    if engine.preload:
        environment |= {"LD_PRELOAD": engine.preload, **SANITIZER_ENVIRONMENT}
        resident = int(_WITH_SHADOW * (engine.limits.memory_mib << 20))
    with job.files() as (given, result_file):
        target = Target(
            program="worker",
            arguments=[str(engine.library)],
            seconds=allowed.wall_seconds,
            output_bytes=engine.limits.output_kib << 10,
            descriptors=(given, result_file),
            environment=environment,
            resident_bytes=resident,
        )
        box = Box((entry.parent, engine.library), bounds_of(engine, allowed))
        outcome = confined(target, box, entry, engine.isolation, engine.nursery)
        result = Result(result_file, job.result_size)
    ending = ending_of(outcome, job, result, allowed)
    if engine.preload and outcome.code == SANITIZER_EXIT:
        ending = _by_sanitizer(ending)
    return ending, result


def rows_done(job: Job, result: Result) -> int:
    """How many rows the worker says it finished: its word, within bounds."""
    return min(result.number(16), job.row_count)


def bounds_of(engine: Engine, allowed: Allowance) -> Bounds:
    """What a worker may use."""
    limits = engine.limits
    return Bounds(
        cpu_seconds=_whole(allowed),
        memory_bytes=limits.memory_mib << 20,
        file_bytes=FILE_BYTES,
        open_files=limits.open_files,
        tasks=limits.tasks,
        stack_bytes=limits.stack_mib << 20,
        beyond_reserved=bool(engine.preload),
    )


def ending_of(outcome: Outcome, job: Job, result: Result, allowed: Allowance) -> Ending:
    """Say how a worker ended, from what the kernel and its result tell."""
    finished, status = result.number(16), result.number(24)
    stop, detail = _stop(outcome, finished == job.row_count, status, result, allowed)
    text = outcome.err.decode("utf-8", errors="replace")
    finding, line = ("", 0) if stop is Stop.FINISHED else _read_finding(text)
    return Ending(
        stop=stop,
        detail=detail,
        seconds=outcome.seconds,
        cpu_seconds=outcome.cpu_seconds,
        output=outcome.out.decode("utf-8", errors="replace") + text,
        finding=finding,
        line=line,
        by_clock=outcome.timed_out,
        delayed_seconds=outcome.delayed_seconds,
    )


def _by_sanitizer(ending: Ending) -> Ending:
    """Tell exhausted memory, and a report that the submission kept from us, from other ends."""
    if not ending.finding and _EXHAUSTED.search(ending.output):
        return replace(ending, stop=Stop.OUT_OF_MEMORY, detail=_TOO_MUCH)
    if not ending.finding and "AddressSanitizer" not in ending.output:
        return replace(ending, finding="an error, whose report went to a closed stderr")
    return ending


def _stop(
    outcome: Outcome, complete: bool, status: int, result: Result, allowed: Allowance
) -> tuple[Stop, str]:
    if outcome.exhausted:
        return Stop.OUT_OF_MEMORY, _TOO_MUCH
    if outcome.timed_out:
        return Stop.TIMED_OUT, f"stopped after {allowed.wall_seconds:.3g} s"
    if outcome.code < 0 or outcome.cpu_seconds > _whole(allowed):
        return _killed(-outcome.code, outcome, allowed)
    if status != Status.OK:
        return _failed(status, result)
    if complete and outcome.code == 0:
        return Stop.FINISHED, ""
    by_itself = f"the program ended itself with exit status {outcome.code}"
    by_sanitizer = outcome.code == SANITIZER_EXIT
    return Stop.CRASHED, "ended by the sanitizer" if by_sanitizer else by_itself


def _killed(number: int, outcome: Outcome, allowed: Allowance) -> tuple[Stop, str]:
    # A submission may ignore SIGXCPU; one second later it is killed. And who reads the clock
    # often, in several threads, is stopped late or not at all.
    long = outcome.cpu_seconds >= _BY_TICKS * _whole(allowed)
    if number <= 0 or number == signal.SIGXCPU or (number == signal.SIGKILL and long):
        return _computed_too_long(allowed)
    if number == signal.SIGSYS:
        return Stop.FORBIDDEN, "stopped: it made a system call that no program here needs"
    return Stop.CRASHED, f"ended by {_signal_name(number)}"


def _whole(allowed: Allowance) -> int:
    """Seconds as the kernel counts them."""
    return max(1, math.ceil(allowed.cpu_seconds))


def _computed_too_long(allowed: Allowance) -> tuple[Stop, str]:
    return Stop.TIMED_OUT, f"stopped after {_whole(allowed)} s of computing time"


def _failed(status: int, result: Result) -> tuple[Stop, str]:
    """Word a status, which is the submission's word: none of them is taken for our fault.

    A worker that fails for our reason fails with the reference too, and says so there.
    """
    length = min(result.number(32), ERROR_CAPACITY)
    text = result.text(ERROR_OFFSET, length).decode("utf-8", errors="replace")
    match status:
        case Status.OUT_OF_MEMORY:
            return Stop.OUT_OF_MEMORY, f"asked for more memory than there is ({text})"
        case Status.NO_THREAD:
            return Stop.OUT_OF_MEMORY, f"left no memory for a second thread ({text})"
        case Status.NOT_WRITTEN:
            return Stop.FAILED_TO_START, text
        case Status.NOT_LOADED | Status.MISMATCH:
            return Stop.FAILED_TO_START, f"the library could not be loaded: {text}"
    return Stop.CRASHED, f"threw an exception: {text}"


def _signal_name(number: int) -> str:
    try:
        return signal.Signals(number).name
    except ValueError:
        return f"signal {number}"


def _read_finding(text: str) -> tuple[str, int]:
    """First finding of a sanitizer and the first own line that it names."""
    places = [match for pattern in _FINDINGS if (match := pattern.search(text))]
    if not places:
        return "", 0
    first = min(places, key=lambda match: match.start())
    line = _OWN_LINE.search(text, first.start())
    # UBSan names the place before its words, on the same line.
    head = _OWN_LINE.search(text[text.rfind("\n", 0, first.start()) + 1 : first.start()])
    chosen = head or line
    found = _ADDRESS.sub("0x...", first.group(1))
    return found, int(chosen.group(1)) if chosen else 0
