"""A box is used again where nothing of the last case can be left in it, and only there."""

import os
import select
import signal
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from subprocess import Popen

import pytest

from grader.errors import WorkerFault
from grader.sandbox import kept, nursery
from grader.sandbox.box import Box, Isolation
from grader.sandbox.confine import confined
from grader.sandbox.inside import channel
from grader.sandbox.launch import Order, Outcome, begin
from grader.sandbox.nursery import Nursery
from grader.sandbox.selftest import unconfined
from grader.sandbox.stage import staged
from grader.sandbox.target import Target
from tests.sandbox.boxes import SNIPPET, WORKER_BOUNDS, Given, bounded
from tests.sandbox.census import all_gone, state_of, zombies


@pytest.fixture
def boxes(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """List the processes that begin boxes from now on."""
    seen: list[int] = []

    def counted(order: Order) -> Popen[bytes]:
        child = begin(order)
        seen.append(child.pid)
        return child

    monkeypatch.setattr(nursery, "begin", counted)
    return seen


@pytest.fixture
def own() -> Iterator[Nursery]:
    """Give a nursery for one test."""
    with Nursery() as made:
        yield made


def ran(
    isolation: Isolation,
    own: Nursery,
    code: str,
    given: Given | None = None,
    writable: Path | None = None,
) -> Outcome:
    """Run lines of Python in a box that may be kept."""
    given = given or Given()
    entry = staged(SNIPPET)
    bounds = given.bounds or WORKER_BOUNDS
    box = Box((entry.parent,), bounds, writable, starts_programs=writable is not None)
    target = Target(
        "snippet",
        [code],
        given.seconds,
        4096,
        descriptors=given.descriptors,
        resident_bytes=given.resident_bytes,
    )
    return confined(target, box, entry, isolation, own)


def test_the_next_case_finds_the_box(
    isolation: Isolation, own: Nursery, boxes: list[int]
) -> None:
    """Each is a process of its own, and a child of the same one."""
    said = [
        ran(isolation, own, "print(os.getpid(), os.getppid())").out.split() for _ in range(3)
    ]
    assert len(boxes) == 1
    assert len({process for process, _ in said}) == 3
    assert len({parent for _, parent in said}) == 1


def test_nothing_of_a_case_is_left(isolation: Isolation, own: Nursery) -> None:
    """No memory, no handler, no limit, no folder, no open file."""
    show = """
print(library.mark if hasattr(library, "mark") else 0, signal.getsignal(signal.SIGUSR1),
      resource.getrlimit(resource.RLIMIT_CPU), os.getcwd(), os.environ.get("MARK"),
      [fcntl.fcntl(descriptor, fcntl.F_GETFL) for descriptor in range(3)])
for descriptor in range(20):
    try: print(descriptor, os.fstat(descriptor).st_mode)
    except OSError: pass
"""
    before = ran(isolation, own, show).out
    changed = """
library.mark = 1
os.environ["MARK"] = "1"
signal.signal(signal.SIGUSR1, signal.SIG_IGN)
os.dup(1)
for descriptor in range(3):
    fcntl.fcntl(descriptor, fcntl.F_SETFL, os.O_NONBLOCK | os.O_APPEND)
print("changed")
"""
    assert ran(isolation, own, changed).out == b"changed\n"
    assert ran(isolation, own, show).out == before


@pytest.mark.parametrize(
    ("code", "status"),
    [
        ("os._exit(3)", 3),
        ("os.abort()", -signal.SIGABRT),
        ("os.kill(os.getpid(), 9)", -signal.SIGKILL),
        ("raise OSError('no')", 1),
        ("os.closerange(0, 64); os._exit(0)", 0),
    ],
)
def test_it_is_kept_however_a_case_ends(
    isolation: Isolation, own: Nursery, boxes: list[int], code: str, status: int
) -> None:
    """The ending is that case's own."""
    assert ran(isolation, own, code).code == status
    assert ran(isolation, own, "print(1)").out == b"1\n"
    assert len(boxes) == 1


def test_a_case_that_is_stopped_tells_its_time(
    isolation: Isolation, own: Nursery, boxes: list[int]
) -> None:
    """Computing and sleeping are told apart, and the box is kept."""
    busy = ran(isolation, own, "while True: pass", Given(seconds=0.7))
    idle = ran(isolation, own, "time.sleep(600)", Given(seconds=0.7))
    assert (busy.timed_out, idle.timed_out, busy.code) == (True, True, -signal.SIGKILL)
    # Others may use the processors too, but somebody got the time that it did not get.
    assert busy.cpu_seconds + busy.delayed_seconds > 0.4
    assert idle.cpu_seconds < 0.2
    assert len(boxes) == 1


def test_a_case_that_holds_too_much_memory_is_ended(
    isolation: Isolation, own: Nursery, boxes: list[int]
) -> None:
    """Also what no limit counts, because it was mapped before; the box is kept."""
    fill = "import time; held = bytearray({} << 20); time.sleep({})"
    most = Given(resident_bytes=300 << 20)
    well = ran(isolation, own, fill.format(200, 0.2), most)
    assert (well.code, well.exhausted) == (0, False)
    ended = ran(isolation, own, fill.format(400, 600), most)
    assert (ended.code, ended.exhausted, ended.timed_out) == (-signal.SIGKILL, True, False)
    assert ran(isolation, own, fill.format(400, 0.2)).code == 0
    assert len(boxes) == 1


def test_each_case_has_its_own_limit_of_time(
    isolation: Isolation, own: Nursery, boxes: list[int]
) -> None:
    """What others used in the box before does not count."""
    spin = "until = time.process_time() + 0.8\nwhile time.process_time() < until: pass"
    for _ in range(3):
        assert ran(isolation, own, spin, bounded(WORKER_BOUNDS, cpu_seconds=2)).code == 0
    hurried = bounded(WORKER_BOUNDS, cpu_seconds=1)
    assert ran(isolation, own, "while True: pass", hurried).code == -signal.SIGXCPU
    assert len(boxes) == 1


def test_two_at_once_have_two_boxes(
    isolation: Isolation, own: Nursery, boxes: list[int]
) -> None:
    """Both are kept for the next two."""
    code = "print(os.getppid()); sys.stdout.flush(); time.sleep(0.5)"
    with ThreadPoolExecutor(2) as pool:
        for _ in range(2):
            list(pool.map(lambda _: ran(isolation, own, code), range(2)))
    assert len(boxes) == 2


def test_the_one_that_waits_is_out_of_reach(isolation: Isolation, own: Nursery) -> None:
    """No signal, no look into its memory, and the socket is closed."""
    code = f"""
parent = os.getppid()
def tried(attempt):
    try: return attempt()
    except OSError: return "refused"
print(tried(lambda: os.kill(parent, 0)), tried(lambda: os.kill(parent, 9)))
print(called(101, 16, parent, 0, 0), called(310, parent, 0, 0, 0, 0, 0), called(434, parent, 0))
for descriptor in range(3, {WORKER_BOUNDS.open_files}):
    try: print(descriptor, os.fstat(descriptor))
    except OSError: pass
"""
    refused = b"refused refused\n-1 -1 -1\n"
    assert ran(isolation, own, code).out == refused
    assert ran(isolation, own, "print(2)").out == b"2\n"


def test_a_box_is_not_kept_where_a_target_may_do_more(
    isolation: Isolation, own: Nursery, boxes: list[int], open_folder: Path
) -> None:
    """A compiler may start processes and write; without isolation everybody may."""
    for number in range(2):
        folder = open_folder / str(number)
        folder.mkdir(mode=0o700)
        assert ran(isolation, own, "print(1)", None, folder).out == b"1\n"
    for _ in range(2):
        assert ran(unconfined(), own, "print(1)").out == b"1\n"
    assert len(boxes) == 4


def test_a_box_that_is_gone_is_replaced(
    isolation: Isolation, own: Nursery, boxes: list[int]
) -> None:
    """Whatever ended it while it waited, the case runs once, in a new one."""
    assert ran(isolation, own, "print(1)").out == b"1\n"
    os.kill(boxes[0], signal.SIGKILL)
    [[waiting]] = own._idle.values()
    assert select.select([waiting._control], [], [], 30)[0]
    assert ran(isolation, own, "print(2)").out == b"2\n"
    assert len(boxes) == 2


@pytest.mark.parametrize(("lost", "ending"), [(1, (0, b"2\n")), (2, (-signal.SIGKILL, b""))])
def test_a_case_whose_box_is_ended_is_run_once_more(
    isolation: Isolation, own: Nursery, boxes: list[int], lost: int, ending: tuple[int, bytes]
) -> None:
    """Once it can be somebody else's fault; what ends two boxes is the case's own."""
    begun, tell = os.pipe()
    pace, set_pace = os.pipe()
    lines = """
again = os.read(int(arguments[1]), 1) == b"s"
os.write(int(arguments[0]), b"x")
if again: time.sleep(600)
print(2)
"""
    os.write(set_pace, b"s" * lost + b"g")
    given = Given(descriptors=(tell, pace))
    with ThreadPoolExecutor(1) as pool:
        running = pool.submit(ran, isolation, own, lines, given)
        for box in range(lost):
            assert os.read(begun, 1) == b"x"
            os.kill(boxes[box], signal.SIGKILL)
        outcome = running.result()
    for each in (begun, tell, pace, set_pace):
        os.close(each)
    assert (outcome.code, outcome.out) == ending
    assert not outcome.timed_out
    assert ran(isolation, own, "print(3)").out == b"3\n"


def children(pid: int) -> list[str]:
    """Child processes of a process."""
    return Path(f"/proc/{pid}/task/{pid}/children").read_text().split()


def test_a_word_that_came_too_late_is_ignored(
    isolation: Isolation, own: Nursery, boxes: list[int]
) -> None:
    """The case that it was meant for ended by itself at that moment."""
    assert ran(isolation, own, "print(1)").out == b"1\n"
    [[waiting]] = own._idle.values()
    waiting._control.send(channel.STOP)
    assert ran(isolation, own, "print(2)").out == b"2\n"
    assert len(boxes) == 1


def test_a_box_that_does_not_begin_is_our_fault(
    isolation: Isolation, own: Nursery, boxes: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is tried twice, and said with the level."""
    monkeypatch.setattr(kept, "START_SECONDS", 1e-6)
    with pytest.raises(WorkerFault, match=r"could not be confined .*: no process came to wait"):
        ran(isolation, own, "print(1)")
    assert len(boxes) == 2


def test_all_boxes_end_with_the_nursery(isolation: Isolation, boxes: list[int]) -> None:
    """Nothing of them is left: no process and no zombie."""
    with Nursery() as own, ThreadPoolExecutor(2) as pool:
        code = "time.sleep(0.3)"
        list(pool.map(lambda _: ran(isolation, own, code), range(2)))
        within = {int(child) for box in boxes for child in children(box)}
        assert len(boxes) == 2
        assert all(state_of(box) not in {"", "Z"} for box in boxes)
    assert all_gone({*boxes, *within})
    assert zombies() == set()
