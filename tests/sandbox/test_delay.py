"""Standing in line for a processor is told from sleeping."""

import os
import sys
import threading

from grader.sandbox.delay import seconds_in_line
from grader.sandbox.launch import Order, launch

SLEEPS = "import time; time.sleep(1.2)"
STARVES = """
import os, time
os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
children = [os.fork() for _ in range(4)]
end = time.monotonic() + 2.5
while time.monotonic() < end:
    pass
os._exit(0)
"""


def test_a_sleeper_does_not_stand_in_line() -> None:
    """Of many processes that compute on one processor, most wait at any time."""
    sleeps, starves = (
        launch(Order([sys.executable, "-c", code], 60.0)).delayed_seconds
        for code in (SLEEPS, STARVES)
    )
    assert sleeps < starves


def test_threads_and_children_count_and_the_dead_do_not() -> None:
    """The longest wait of all threads is told; a process that is gone waited for nothing."""
    own = seconds_in_line(os.getpid())
    thread = threading.Thread(target=sum, args=(range(100_000),))
    thread.start()
    thread.join()
    assert seconds_in_line(os.getpid()) >= own >= 0
    code = "import os; print(os.getpid())"
    gone = int(launch(Order([sys.executable, "-c", code], 60.0)).out)
    assert seconds_in_line(gone) == 0
