"""Nothing outlives its box, and no box outlives the grader."""

import os
import signal
import subprocess
import sys
import textwrap
import uuid
from collections.abc import Generator
from pathlib import Path

import pytest

from grader.sandbox import words
from grader.sandbox.box import Isolation
from grader.sandbox.selftest import proved_isolation
from tests.sandbox.boxes import Given, as_worker, python_as_compiler
from tests.sandbox.census import all_gone, wait_for_words, with_word, zombies

PATH = os.pathsep.join([str(Path(__file__).parents[2]), os.environ.get("PYTHONPATH", "")])

DAEMON = """
import os, signal, time
token = "{token}"
for number in (signal.SIGHUP, signal.SIGTERM, signal.SIGINT):
    signal.signal(number, signal.SIG_IGN)
done, tell = os.pipe()
if os.fork() == 0:
    try:
        os.setsid()
    except OSError:
        pass
    for _ in range(3):
        if os.fork() == 0:
            {work}
            os.write(tell, b"x")
            time.sleep(600)
    os._exit(0)
os.wait()
for _ in range(3):
    os.read(done, 1)
{then}
print("started")
"""
SPIN = """until = time.process_time() + 0.3
            while time.process_time() < until: pass
            os.write(tell, b"x")
            os._exit(0)"""


@pytest.fixture
def token() -> Generator[str]:
    """Give a word for command lines; whatever has it in the end is killed."""
    word = uuid.uuid4().hex
    yield word
    for pid in with_word(word):
        os.kill(pid, signal.SIGKILL)


def marked(open_folder: Path, token: str) -> Given:
    """Have a word in the command line of a box: it is told which folders may be read."""
    folder = open_folder / token
    folder.mkdir(exist_ok=True)
    return Given(readable=(folder,))


def test_a_daemon_ends_with_its_box(
    isolation: Isolation, open_folder: Path, token: str
) -> None:
    """Forked twice, deaf to signals: gone when the box is, without waiting for it."""
    code = DAEMON.format(token=token, work="pass", then="")
    outcome = python_as_compiler(isolation, open_folder / "own", code)
    assert (outcome.code, outcome.out, outcome.timed_out) == (0, b"started\n", False)
    assert with_word(token) == set()
    assert zombies() == set()


@pytest.mark.usefixtures("cache")
def test_a_daemon_with_a_session_ends_with_its_namespace(
    open_folder: Path, token: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Level A holds it without the filter, which refuses `setsid` at all levels.

    Level B holds it by that alone: what is in no other group ends with its group.
    """
    monkeypatch.setattr(words, "compiler_filter", lambda: b"")
    code = DAEMON.format(token=token, work="pass", then="")
    own = open_folder / "own"
    outcome = python_as_compiler(proved_isolation("A"), own, code)
    assert outcome.out == b"started\n"
    assert with_word(token) == set()
    assert zombies() == set()


def test_time_of_daemons_is_counted(
    isolation: Isolation, open_folder: Path, token: str
) -> None:
    """Nobody inside waited for them; from outside their time is seen once they ended.

    The kernel forgets the time of those that a namespace kills in its own end.
    """
    code = DAEMON.format(token=token, work=SPIN, then="time.sleep(0.5)")
    outcome = python_as_compiler(isolation, open_folder / "own", code)
    assert outcome.out == b"started\n", outcome
    assert 0.9 <= outcome.cpu_seconds < 3


def test_time_of_a_worker_is_counted(isolation: Isolation) -> None:
    """That of all its threads, and not that of bubblewrap."""
    busy = as_worker(isolation, "while time.process_time() < 0.6: pass")
    idle = as_worker(isolation, "time.sleep(0.6)")
    assert 0.6 <= busy.cpu_seconds < 3
    assert idle.cpu_seconds < 0.5


def test_no_zombie_is_left(isolation: Isolation, open_folder: Path, token: str) -> None:
    """Bubblewrap's first process of a namespace included, however the worker ends."""
    for code in ("pass", "os._exit(3)", "os.abort()", "os.kill(os.getpid(), 9)"):
        as_worker(isolation, code, marked(open_folder, token))
    assert zombies() == set()
    assert with_word(token) == set()


FORKED = """
import os
from grader.sandbox.selftest import proved_isolation
from tests.sandbox.boxes import as_worker
from tests.sandbox.census import zombies
isolation = proved_isolation("A")
if (child := os.fork()) == 0:
    outcome = as_worker(isolation, "while time.process_time() < 0.3: pass")
    os._exit(0 if outcome.cpu_seconds >= 0.3 else 1)
print(os.waitpid(child, 0)[1], zombies())
"""


def test_a_fork_of_a_grader_reaps_its_own_boxes(cache: Path) -> None:
    """Else zombies stay with its parent, count against others, and nobody learns their time."""
    process = subprocess.run(
        [sys.executable, "-c", FORKED],
        env={**os.environ, "BVHGRADE_CACHE": str(cache), "PYTHONPATH": PATH},
        capture_output=True,
        text=True,
        check=True,
    )
    assert process.stdout == "0 set()\n"


GRADER = """
import os, sys, threading, time
from pathlib import Path
from grader.errors import Interrupted
from grader.sandbox.launch import stop_everything
from grader.sandbox.selftest import proved_isolation
from tests.sandbox.boxes import Given, as_worker
isolation = proved_isolation(sys.argv[1])
ready, tell = os.pipe()
outcomes = []
code = "os.write(int(arguments[0]), b'x')\\ntime.sleep(600)"
given = Given(seconds=900.0, descriptors=(tell,), readable=(Path(sys.argv[2]),))
def run():
    try:
        outcomes.append(as_worker(isolation, code, given))
    except Interrupted as fault:
        outcomes.append(fault)
threads = [threading.Thread(target=run) for _ in range(2)]
for each in threads: each.start()
for each in threads: os.read(ready, 1)
print("running", flush=True)
sys.stdin.readline()
stop_everything()
for each in threads: each.join()
print(*outcomes, sep="\\n")
try:
    as_worker(isolation, "pass")
except Interrupted as fault:
    print(fault)
"""


def grader(isolation: Isolation, folder: Path, cache: Path) -> "subprocess.Popen[str]":
    """Start a grader that runs two workers, which may read a folder."""
    letter = "A" if isolation.level.value.startswith("bubblewrap") else "B"
    folder.mkdir()
    process = subprocess.Popen(
        [sys.executable, "-c", textwrap.dedent(GRADER), letter, str(folder)],
        env={**os.environ, "BVHGRADE_CACHE": str(cache), "PYTHONPATH": PATH},
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    assert process.stdout
    assert process.stdout.readline() == "running\n"
    return process


def test_everything_can_be_stopped(
    isolation: Isolation, open_folder: Path, token: str, cache: Path
) -> None:
    """Boxes that run end at once, and no other begins."""
    process = grader(isolation, open_folder / token, cache)
    said, _ = process.communicate("\n")
    assert said.splitlines() == ["the grader was asked to stop"] * 3
    assert with_word(token) == set()


def test_no_box_outlives_a_grader_that_is_killed(
    isolation: Isolation, open_folder: Path, token: str, cache: Path
) -> None:
    """Nothing of the grader runs any more that could tidy up."""
    process = grader(isolation, open_folder / token, cache)
    running = with_word(token) - {process.pid}
    assert len(running) >= 2
    process.kill()
    process.communicate()
    assert all_gone(running)
    assert with_word(token) == set()


BEGIN = '#include "bvh.h"\n#include "intersection.h"\n#include "mesh.h"\n'
LOOP = "void BVH::construct(const Mesh&) { for (volatile int i = 0; i == 0;) {} }\n"
LONG = """constexpr long work(long n) { long s = 0; while (s < n) s += 1; return s; }
template <int N> constexpr long all = work(30000 + N) + all<N - 1>;
template <> constexpr long all<0> = 0;
static_assert(all<800> != 0);
"""


PHASES = {
    "runs": (LOOP, ("={folder}", "\0worker\0", "filter=")),
    "compiles": (LONG, ("cc1plus",)),
}
"""A submission that stays there for ever, and words of its process, not of one of ours."""


@pytest.mark.parametrize(
    ("phase", "number", "level"),
    [
        ("runs", signal.SIGTERM, "A"),
        ("runs", signal.SIGINT, "B"),
        ("compiles", signal.SIGINT, "A"),
        ("compiles", signal.SIGTERM, "B"),
    ],
)
@pytest.mark.usefixtures("cache")
def test_a_grader_that_is_asked_to_end_takes_all_with_it(
    phase: str, number: signal.Signals, level: str, open_folder: Path
) -> None:
    """In the middle of a submission that never ends: no process, no result, no folder."""
    temporary, submission = open_folder / "temporary", open_folder / "exercise03.cpp"
    temporary.mkdir(mode=0o711)
    source, words = PHASES[phase]
    submission.write_text(BEGIN + source)
    process = subprocess.Popen(
        [sys.executable, "-m", "grader", "grade", str(submission), "-o", "out"],
        cwd=open_folder,
        env={
            **os.environ,
            "BVHGRADE_ISOLATION": level,
            "PYTHONPATH": PATH,
            "TMPDIR": str(temporary),
        },
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    started = [each.format(folder=temporary) for each in words]
    running = wait_for_words(process, str(temporary), *started)
    process.send_signal(number)
    _, said = process.communicate()
    assert (process.returncode, b"Traceback" in said) == (128 + number, False), said
    assert all_gone(running)
    assert with_word(str(temporary)) == set()
    assert list(temporary.iterdir()) == []
    assert not list((open_folder / "out").glob("*.json"))
