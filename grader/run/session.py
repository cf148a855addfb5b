"""What became of one worker: how it ended, and its result if it finished."""

import math
import re
import signal
import sys
from dataclasses import dataclass
from pathlib import Path

from grader.model.stages import Ending, Stop
from grader.run.job import Job, Result
from grader.run.protocol import ERROR_CAPACITY, ERROR_OFFSET, Status
from grader.sandbox.launch import PLAIN_ENVIRONMENT, Order, Outcome, launch

WORKER = Path(__file__).with_name("worker.py")
MIB = 1 << 20
CPU_SECONDS_PER_SECOND = 3
"""CPU limit as a multiple of the wall limit: submissions may use threads."""

SANITIZER_EXIT = 86
SANITIZER_ENVIRONMENT = {
    # An assertion ends in abort: handled, it leaves a stack with the student's line.
    "ASAN_OPTIONS": f"detect_leaks=0:exitcode={SANITIZER_EXIT}:max_allocation_size_mb=2048:"
    "handle_abort=1:"
    "hard_rss_limit_mb=3072:allocator_may_return_null=1:detect_odr_violation=0",
    "UBSAN_OPTIONS": f"print_stacktrace=1:exitcode={SANITIZER_EXIT}",
}

_FINDINGS = (
    # Memory that there is not is no memory error, and an abort without more is no finding.
    re.compile(r"ERROR: AddressSanitizer: (?!ABRT|out of |allocat)([\w-]+)"),
    re.compile(r"runtime error: (.{1,200})"),
    re.compile(r"(Assertion '.{1,120}') failed"),
)
_EXHAUSTED = re.compile(
    r"AddressSanitizer: (.*out of memory|allocation-size-too-big|hard rss limit exhausted)"
)
_OWN_LINE = re.compile(r"src/exercise03\.cpp:(\d{1,7})")


@dataclass(frozen=True, slots=True)
class Engine:
    """A library to run workers on, and what a worker may use."""

    library: Path
    memory_mib: int
    """Address space; 0 for a sanitized library, which reserves terabytes."""

    output_bytes: int
    preload: str = ""
    """Shared sanitizer runtime; empty for a plain library."""


def run_job(job: Job, engine: Engine, seconds: float) -> tuple[Ending, Result | None]:
    """Carry out a job in a fresh process.

    Returns:
        How it ended, and the result if every row was carried out.

    Raises:
        WorkerFault: There is no memory for the input.
        MissingTool: The interpreter cannot be started.
    """
    with job.files() as (given, result_file):
        cpu_seconds = math.ceil(seconds * CPU_SECONDS_PER_SECOND)
        argv = [sys.executable, "-I", "-S", str(WORKER), str(engine.library)]
        argv += [str(given), str(result_file), str(engine.memory_mib), str(cpu_seconds)]
        environment = dict(PLAIN_ENVIRONMENT)
        if engine.preload:
            environment |= {"LD_PRELOAD": engine.preload, **SANITIZER_ENVIRONMENT}
        order = Order(
            argv,
            seconds,
            engine.output_bytes,
            descriptors=(given, result_file),
            environment=environment,
        )
        outcome = launch(order)
        result = Result(result_file, job.result_size)
    ending = _ending(outcome, job, result, seconds)
    return ending, result if ending.stop is Stop.FINISHED else None


def _ending(outcome: Outcome, job: Job, result: Result, seconds: float) -> Ending:
    finished, status = result.number(16), result.number(24)
    stop, detail = _stop(outcome, finished == job.row_count, status, result, seconds)
    text = outcome.err.decode("utf-8", errors="replace")
    finding, line = ("", 0) if stop is Stop.FINISHED else _read_finding(text)
    if outcome.code == SANITIZER_EXIT and not finding and _EXHAUSTED.search(text):
        stop, detail = Stop.OUT_OF_MEMORY, "asked for more memory than there is"
    return Ending(
        stop=stop,
        detail=detail,
        seconds=outcome.seconds,
        cpu_seconds=outcome.cpu_seconds,
        output=outcome.out.decode("utf-8", errors="replace") + text,
        finding=finding,
        line=line,
    )


def _stop(
    outcome: Outcome, complete: bool, status: int, result: Result, seconds: float
) -> tuple[Stop, str]:
    if outcome.timed_out:
        return Stop.TIMED_OUT, f"stopped after {seconds:g} s"
    if outcome.code < 0:
        return _killed(-outcome.code)
    if status != Status.OK:
        return _failed(status, result)
    if complete and outcome.code == 0:
        return Stop.FINISHED, ""
    if outcome.code == SANITIZER_EXIT:
        return Stop.CRASHED, "ended by the sanitizer"
    return Stop.CRASHED, f"the program ended itself with exit status {outcome.code}"


def _killed(number: int) -> tuple[Stop, str]:
    if number == signal.SIGXCPU:
        return Stop.TIMED_OUT, "stopped: too much CPU time"
    return Stop.CRASHED, f"ended by {_signal_name(number)}"


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
    return first.group(1), int(chosen.group(1)) if chosen else 0
