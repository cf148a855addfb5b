"""Each limit of a compiler: just under it compiles, just over it is said in words of ours."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from grader.build import compile as module
from grader.build.compile import prepared
from grader.build.compiler import find_compiler
from grader.build.compiling import Compilation
from grader.build.workspace import GRADED, workspace
from grader.model.stages import Diagnostic
from grader.sandbox.box import Isolation, Level
from grader.sandbox.streams import DROPPED
from grader.score.rubric import load_rubric
from tests.compiled import BEGIN, CONSTRUCT, INTERSECT, submission_of
from tests.sandbox.boxes import (
    COMPILER_BOUNDS,
    Given,
    bounded,
    counts_tasks,
    python_as_compiler,
)

SHIPPED = load_rubric().limits.compiler
PLAIN = BEGIN + CONSTRUCT + INTERSECT
ENDLESS = """template <int N> struct Deep : Deep<N - 1> {};
template <> struct Deep<0> {};
constexpr int work(int n) { int s = 0; for (int i = 0; i < n; ++i) s += i % 7; return s; }
template <int N> constexpr int all = work(30000 + N) + all<N - 1>;
template <> constexpr int all<0> = 0;
static_assert(all<800> != 0);
"""
"""Tens of seconds of computing, in little memory."""

Compiled = Callable[..., tuple[bool, list[str]]]


@pytest.fixture
def compiled(isolation: Isolation, open_folder: Path) -> Compiled:
    """Give a function that compiles a source once with some limits."""

    def compile_once(source: str, **limits: int) -> tuple[bool, list[str]]:
        order = Compilation(open_folder, isolation, replace(SHIPPED, **limits))
        work = prepared(submission_of(source), order)
        linked = module._link(workspace(find_compiler(), GRADED), work, GRADED.name)
        return linked.library is not None, [words(each) for each in linked.diagnostics]

    return compile_once


def words(message: Diagnostic) -> str:
    """Give the text of an error, and of nothing else."""
    return message.text if message.severity == "error" else ""


def test_an_ordinary_file_compiles(compiled: Compiled) -> None:
    """With the limits of the shipped rubric."""
    assert compiled(PLAIN) == (True, [])


def test_computing_time(compiled: Compiled) -> None:
    """The driver waits, the compiler computes; the limit is that of each process."""
    done, messages = compiled(PLAIN + ENDLESS, seconds=1)
    assert (done, messages[-1]) == (False, "compiling took more than 1 s of computing time")


def test_wall_time(compiled: Compiled) -> None:
    """Also when each process is within its own limit."""
    done, messages = compiled(PLAIN + ENDLESS, wall_seconds=4)
    assert (done, messages) == (False, ["compiling took longer than 4 s"])


def test_memory(compiled: Compiled) -> None:
    """A file without end is read until there is no memory."""
    done, messages = compiled('#include "/dev/zero"\n', memory_mib=256)
    assert (done, messages[-1]) == (False, "compiling needed more memory than 256 MiB")


@pytest.mark.parametrize(("mebibytes", "enough"), [(3, True), (5, False)])
def test_size_of_a_file(compiled: Compiled, mebibytes: int, enough: bool) -> None:
    """Four MiB are allowed."""
    array = f"char big[{mebibytes} << 20] = {{1}};\n"
    done, messages = compiled(PLAIN + array, file_mib=4)
    assert done == enough
    said = [] if enough else ["the compiled file is larger than 4 MiB"]
    assert messages[-1:] == said


def test_messages(compiled: Compiled) -> None:
    """The flood is cut, and what came first and last is still read."""
    flood = "".join(f"int f{i}() {{ return unknown_{i}; }}\n" for i in range(18))
    done, messages = compiled(PLAIN + flood, output_kib=1)
    assert not done
    assert any("unknown_0" in text for text in messages)
    assert not any("unknown_9" in text for text in messages)


SPAWN = """
import os, sys, time
made = 0
try:
    for made in range(100):
        if os.fork() == 0:
            time.sleep(600)
except OSError as fault:
    print(made + 1, fault.strerror)
"""


@pytest.mark.parametrize("most", [4, 8])
def test_processes_are_counted_exactly(
    isolation: Isolation, open_folder: Path, most: int
) -> None:
    """The first process counts, none of ours does; those that it started are ended with it."""
    outcome = python_as_compiler(
        isolation, open_folder / "own", SPAWN, bounded(COMPILER_BOUNDS, tasks=most)
    )
    full = f"{most} Resource temporarily unavailable\n"
    assert outcome.out.decode() == (full if counts_tasks(isolation) else ""), outcome


LIMITS = """
import resource
names = "CPU AS FSIZE NOFILE STACK CORE MEMLOCK NPROC".split()
print([resource.getrlimit(getattr(resource, "RLIMIT_" + name))[0] for name in names])
"""


def test_the_kernel_holds_what_was_asked_for(isolation: Isolation, open_folder: Path) -> None:
    """Every number of the limits arrives; namespaces count one process of bubblewrap's."""
    outcome = python_as_compiler(isolation, open_folder / "own", LIMITS)
    bounds, more = COMPILER_BOUNDS, isolation.level is Level.NAMESPACES
    *limits, tasks = eval(outcome.out)  # noqa: S307 - a test's own
    assert tasks == bounds.tasks + more or not counts_tasks(isolation)
    assert limits == [
        bounds.cpu_seconds,
        bounds.memory_bytes,
        bounds.file_bytes,
        bounds.open_files,
        bounds.stack_bytes,
        1,
        0,
    ]


def test_output_of_a_program_is_kept_to_the_byte(
    isolation: Isolation, open_folder: Path
) -> None:
    """Both streams have a cap of their own."""
    for number, (printed, kept) in enumerate(
        [("x" * 64, b"x" * 64), ("x" * 65, b"x" * 32 + DROPPED + b"x" * 32)]
    ):
        outcome = python_as_compiler(
            isolation,
            open_folder / str(number),
            f"import os; os.write(1, b'{printed}'); os.write(2, b'{printed}')",
            Given(output_bytes=64),
        )
        assert (outcome.out, outcome.err) == (kept, kept)
