"""The harness sees what an attack would leave behind: a blind witness proves nothing."""

import os
import socket
import subprocess
from collections.abc import Generator
from pathlib import Path

import pytest

from grader.sandbox.reaping import adopt_orphans
from tests.attacks.witness import Witness, census, survivors, witnessed


@pytest.fixture
def witness(cache: Path) -> Generator[Witness]:
    """One place with bait."""
    with witnessed() as witness:
        yield witness


def test_an_untouched_place_says_nothing(witness: Witness) -> None:
    """Reading is no touching."""
    before = witness.state()
    Path(witness.words["secret"]).read_bytes()
    assert not witness.changes(before)
    assert not [*witness.callers(), *witness.remains()]


@pytest.mark.parametrize("word", ["canary", "secret", "home", "beside", "neighbour"])
def test_a_changed_file_is_seen(witness: Witness, word: str) -> None:
    """By its content, even of the same length and at the same time."""
    before = witness.state()
    path = Path(witness.words[word])
    times = path.stat()
    path.write_bytes(bytes(path.stat().st_size))
    os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns))
    assert witness.changes(before) == [f"{path} was touched"]


def test_a_new_and_a_lost_file_are_seen(witness: Witness) -> None:
    """A link counts as a file."""
    before = witness.state()
    Path(witness.words["created"]).symlink_to("/nowhere")
    Path(witness.words["canary"]).unlink()
    assert len(witness.changes(before)) >= 2


def test_a_file_elsewhere_is_seen(witness: Witness) -> None:
    """Where all may write."""
    path = Path("/tmp", witness.mark)  # noqa: S108 - where an attack would write
    path.touch()
    try:
        assert list(witness.remains()) == [f"{path} was left"]
    finally:
        path.unlink()


@pytest.mark.parametrize("number", [0, 1, 2])
def test_a_caller_is_seen(witness: Witness, number: int) -> None:
    """On each socket."""
    listener = witness.listeners[number]
    with socket.socket(listener.family) as line:
        line.connect(listener.getsockname())
        assert len(list(witness.callers())) == 1


def test_a_survivor_is_seen() -> None:
    """A child, and what a child left behind when it ended."""
    adopt_orphans()
    before = census()
    script = "sleep 20 >/dev/null & echo $!"
    pid = int(subprocess.run(["sh", "-c", script], stdout=subprocess.PIPE, check=True).stdout)
    assert survivors(before) == [f"process {pid} lives"]
    os.kill(pid, 9)
    os.waitpid(pid, 0)
    assert survivors(before) == []
