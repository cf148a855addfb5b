"""How a process ends, what is kept of its output, and what it gets to see of ours."""

import os
import signal
import sys
import textwrap
import time
from pathlib import Path

import pytest

from grader.errors import MissingTool
from grader.sandbox import launch as module
from grader.sandbox.launch import PLAIN_ENVIRONMENT, Order, Outcome, launch
from grader.sandbox.streams import DROPPED

PATIENT = 60.0


def python(code: str, seconds: float = PATIENT, **bounds: object) -> Outcome:
    """Run some Python lines in a child."""
    argv = [sys.executable, "-I", "-S", "-c", textwrap.dedent(code)]
    return launch(Order(argv, seconds, **bounds))  # type: ignore[arg-type]  # named by the test


def wait_until_gone(pid: int) -> bool:
    """Wait until a process that is not our child has ended; False after ten seconds."""
    for _ in range(1000):
        try:
            state = Path(f"/proc/{pid}/stat").read_text().rpartition(") ")[2][0]
        except (FileNotFoundError, ProcessLookupError):
            return True
        if state in "ZX":
            return True
        time.sleep(0.01)
    return False


@pytest.mark.parametrize("code", [0, 1, 2, 86, 255])
def test_the_exit_status_comes_back(code: int) -> None:
    """A regular end has its own status."""
    outcome = python(f"raise SystemExit({code})")
    assert (outcome.code, outcome.timed_out) == (code, False)


@pytest.mark.parametrize("number", [signal.SIGSEGV, signal.SIGABRT, signal.SIGKILL])
def test_a_signal_comes_back_as_a_negative_number(number: signal.Signals) -> None:
    """An end by a signal can be told from every exit status."""
    outcome = python(f"import os; os.kill(os.getpid(), {int(number)})")
    assert (outcome.code, outcome.timed_out) == (-number, False)


def test_both_streams_come_back_apart() -> None:
    """What was printed is there, also what was printed right before the end."""
    outcome = python("import os; os.write(1, b'to out'); os.write(2, b'to err'); os._exit(3)")
    assert (outcome.out, outcome.err, outcome.code) == (b"to out", b"to err", 3)


def test_closed_streams_do_not_end_the_child() -> None:
    """A child that closes its output is waited for all the same."""
    outcome = python("import os, time; os.close(1); os.close(2); time.sleep(0.2); os._exit(7)")
    assert outcome.code == 7


def test_the_deadline_kills_the_child() -> None:
    """A child that sleeps is over long before it would wake up."""
    outcome = python("import time; time.sleep(600)", seconds=0.3)
    assert (outcome.timed_out, outcome.code) == (True, -signal.SIGKILL)
    assert 0.3 <= outcome.seconds < 60


def test_the_deadline_kills_whoever_ignores_everything() -> None:
    """Signals that can be ignored do not matter, and output before the deadline is kept."""
    outcome = python(
        """
        import os, signal, time
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGXCPU):
            signal.signal(number, signal.SIG_IGN)
        os.write(1, b"ready")
        while True:
            time.sleep(1)
        """,
        seconds=2.0,
    )
    assert (outcome.timed_out, outcome.code, outcome.out) == (True, -signal.SIGKILL, b"ready")


FORK = """
    import os, time
    child = os.fork()
    if child == 0:
        time.sleep(600)
    os.write(1, str(child).encode())
"""


def test_the_deadline_kills_the_whole_group() -> None:
    """A grandchild does not outlive the deadline."""
    outcome = python(FORK + "    time.sleep(600)", seconds=2.0)
    assert outcome.timed_out
    assert wait_until_gone(int(outcome.out))


def test_a_grandchild_that_holds_the_pipe_delays_nothing() -> None:
    """The child's end counts, not that of the pipe, and the rest of the group is killed."""
    outcome = python(FORK + "    os._exit(5)")
    assert (outcome.code, outcome.timed_out) == (5, False)
    assert outcome.seconds < PATIENT / 2
    assert wait_until_gone(int(outcome.out))


def test_a_grandchild_in_another_session_delays_nothing() -> None:
    """One that left the group and floods the pipe is not read to its end, which never comes."""
    outcome = python(
        """
        import os, time
        ready, tell = os.pipe()
        child = os.fork()
        if child == 0:
            os.setsid()
            os.write(2, str(os.getpid()).encode())
            os.write(tell, b"x")
            until = time.monotonic() + 20
            while time.monotonic() < until:
                os.write(1, bytes(65536))
        os.read(ready, 1)
        os._exit(5)
        """
    )
    os.kill(int(outcome.err), signal.SIGKILL)
    assert outcome.code == 5
    assert outcome.seconds < 15


def test_a_flood_is_read_and_dropped() -> None:
    """A quarter of a gigabyte neither blocks the child nor stays in memory."""
    outcome = python(
        """
        import os
        os.write(1, b"first")
        for _ in range(256):
            os.write(1, bytes(1 << 20))
        os.write(1, b"last")
        """,
        output_bytes=1000,
    )
    assert outcome.code == 0
    assert len(outcome.out) == 1000 + len(DROPPED)
    assert outcome.out.startswith(b"first\0")
    assert outcome.out.endswith(b"\0last")
    assert DROPPED in outcome.out


@pytest.mark.parametrize(
    ("printed", "kept"),
    [
        ("", ""),
        ("abcdef", "abcdef"),
        ("abcdefgh", "abcdefgh"),
        ("abcdefghi", "abcd\n[...]\nfghi"),
        ("a" * 70000 + "wxyz", "aaaa\n[...]\nwxyz"),
    ],
)
def test_the_middle_is_dropped_beyond_the_cap(printed: str, kept: str) -> None:
    """Exactly the cap is kept as it is; one byte more loses the middle and shows a mark."""
    outcome = python(f"print({printed!r}, end='')", output_bytes=8)
    assert outcome.out.decode() == kept


def test_the_environment_is_only_what_is_given(monkeypatch: pytest.MonkeyPatch) -> None:
    """The caller's variables, tokens among them, do not reach a child."""
    monkeypatch.setenv("SECRET_TOKEN", "x")
    show = Order(["/usr/bin/env"], PATIENT)
    lines = launch(show).out.decode().splitlines()
    assert dict(line.split("=", 1) for line in lines) == PLAIN_ENVIRONMENT
    own = launch(Order(["/usr/bin/env"], PATIENT, environment={"A": "b"}))
    assert own.out == b"A=b\n"
    assert launch(Order(["/usr/bin/env"], PATIENT, environment={})).out == b""


OPEN = """
import os
for number in range(256):
    try:
        os.fstat(number)
        print(number, end=" ")
    except OSError:
        pass
"""


def test_only_the_named_descriptors_are_open() -> None:
    """Files of ours stay ours, even inheritable ones, except for those that are passed."""
    ours, passed = os.memfd_create("ours", 0), os.memfd_create("passed")
    try:
        assert python(OPEN).out.split() == [b"0", b"1", b"2"]
        given = python(OPEN, descriptors=(passed,)).out.decode().split()
        assert given == ["0", "1", "2", str(passed)]
    finally:
        os.close(ours)
        os.close(passed)


def test_there_is_nothing_to_read() -> None:
    """Standard input is empty, whatever lies in ours, so that nobody waits for a key."""
    ours, (reading, writing) = os.dup(0), os.pipe()
    os.write(writing, b"for us")
    os.dup2(reading, 0)
    try:
        assert python("import sys; print(repr(sys.stdin.read()))").out == b"''\n"
    finally:
        os.dup2(ours, 0)
        for each in (ours, reading, writing):
            os.close(each)


def test_the_child_runs_where_it_is_told(tmp_path: Path) -> None:
    """The folder of an order is the child's working folder."""
    outcome = python("import os; print(os.getcwd())", folder=tmp_path)
    assert outcome.out.decode().strip() == str(tmp_path.resolve())


def test_the_child_has_a_session_of_its_own() -> None:
    """A child has no terminal of ours, and signals to its group do not reach us."""
    outcome = python("import os; print(os.getsid(0) == os.getpid() == os.getpgrp())")
    assert outcome.out == b"True\n"


@pytest.mark.parametrize("program", ["no-such-program-here", "/no/such/program", "/etc/passwd"])
def test_a_program_that_cannot_be_started_is_a_missing_tool(program: str) -> None:
    """The sentence names the program and asks whether it is installed."""
    with pytest.raises(MissingTool, match=f"{program} cannot be started: .*; is it installed"):
        launch(Order([program], PATIENT))


def test_cpu_seconds_are_those_of_the_child() -> None:
    """Work counts, sleep does not; the two are told apart by an order of magnitude."""
    busy = python("import time\nwhile time.process_time() < 0.5: pass")
    idle = python("import time; time.sleep(0.5)")
    assert 0.4 < busy.cpu_seconds < 5
    assert idle.cpu_seconds < 0.4
    assert idle.seconds >= 0.5


@pytest.mark.parametrize("error", [KeyboardInterrupt, OSError, MemoryError])
def test_whatever_ends_the_watch_ends_the_child(
    error: type[BaseException], monkeypatch: pytest.MonkeyPatch
) -> None:
    """An interrupt while watching leaves neither a process nor a zombie behind."""
    seen: list[int] = []

    def interrupted(pid: int, *_: object) -> bool:
        seen.append(pid)
        raise error

    monkeypatch.setattr(module, "_watch", interrupted)
    with pytest.raises(error):
        python("import time; time.sleep(600)")
    with pytest.raises(ProcessLookupError):
        os.kill(seen[0], 0)


def test_no_descriptor_is_left_open() -> None:
    """Pipes and process descriptors are closed again, also after a deadline."""
    before = len(list(Path("/proc/self/fd").iterdir()))
    python("pass")
    python("import time; time.sleep(600)", seconds=0.1)
    assert len(list(Path("/proc/self/fd").iterdir())) == before
