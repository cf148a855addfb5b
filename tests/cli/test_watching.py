"""`check --watch` as a real process: every way of saving, one problem at a time, Ctrl-C."""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

import pytest

from grader.certify.corpus import corpus_folder
from grader.intake.saved import GONE, state_of
from grader.resources import reference_source
from tests.cli.test_processes import environment, stand_in

FILE = "exercise03.cpp"
PATIENCE = 400.0
"""Seconds until a hang is called one; a first run also builds the framework and the plan."""


def renamed_over(path: Path, text: str) -> None:
    """Save as most editors do: write beside it, then rename."""
    beside = path.with_suffix(".tmp")
    beside.write_text(text)
    beside.replace(path)


def away_for_a_moment(path: Path, text: str) -> None:
    """Save as old editors do: the old file goes first, the new one comes later."""
    path.unlink()
    time.sleep(0.6)
    path.write_text(text)


def in_two_pieces(path: Path, text: str) -> None:
    """Save slowly, in place."""
    with path.open("w") as file:
        file.write(text[:3])
        file.flush()
        time.sleep(0.1)
        file.write(text[3:])


SAVES = (Path.write_text, renamed_over, away_for_a_moment, in_two_pieces)


def until(holds: Callable[[], bool], what: str) -> None:
    """Wait for something."""
    deadline = time.monotonic() + PATIENCE
    while not holds():
        assert time.monotonic() < deadline, what
        time.sleep(0.05)


def asked(here: Path) -> list[str]:
    """What the stand-in pipeline was asked so far."""
    path = here / "asked"
    return path.read_text().splitlines() if path.exists() else []


def is_running(words: str) -> bool:
    """Whether there is a process of these words."""
    wanted = words.encode().replace(b" ", b"\0") + b"\0"
    for folder in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):
            if (folder / "cmdline").read_bytes() == wanted:
                return True
    return False


@contextmanager
def watching(here: Path, words: list[str]) -> Iterator[Path]:
    """Run a watch; yields the file of what it prints, and ends it by Ctrl-C."""
    printed = here / "printed"
    with printed.open("wb") as out:
        process = subprocess.Popen(
            [*words, "--watch"], cwd=here, env=environment(), stdout=out, stderr=out
        )
    try:
        yield printed
    finally:
        process.send_signal(signal.SIGINT)
        status = process.wait(timeout=PATIENCE)
    assert status == 130
    told = printed.read_bytes()
    assert told.endswith(b"bvhgrade: interrupted; the last finished run is kept\n")
    assert b"Traceback" not in told


@pytest.mark.parametrize("save", SAVES)
def test_every_way_of_saving_runs_again(
    tmp_path: Path, save: Callable[[Path, str], object]
) -> None:
    """The failed check first; when it passes, everything, until nothing is wrong."""
    (tmp_path / FILE).write_text("failing")
    with watching(tmp_path, stand_in("content", "check", FILE)) as printed:
        until(lambda: b"more checks fail" in printed.read_bytes(), "the first report")
        save(tmp_path / FILE, "perfect")
        until(lambda: b"Everything passes" in printed.read_bytes(), "the last report")
    first, second, third = asked(tmp_path)
    assert first == "failing all"
    assert second.startswith(("perfect hits.", "perfect bvh."))
    assert third == "perfect all"


def test_one_problem_is_told_at_a_time(tmp_path: Path) -> None:
    """Others that fail are counted; a check that still fails is all that is run."""
    (tmp_path / FILE).write_text("failing")
    with watching(tmp_path, stand_in("content", "check", FILE)) as printed:
        until(lambda: printed.read_bytes().count(b"---") >= 2, "the first report")
        (tmp_path / FILE).write_text("starter")
        until(lambda: b"is not started" in printed.read_bytes(), "the second report")
        (tmp_path / FILE).write_text("failing")
        until(lambda: len(asked(tmp_path)) >= 4, "the third run")
    assert asked(tmp_path)[0] == "failing all"
    assert asked(tmp_path)[-1] == "failing all"


def test_a_save_ends_the_run_before(tmp_path: Path) -> None:
    """Processes of the old run end at once, and its result is not told."""
    (tmp_path / FILE).write_text("long")
    with watching(tmp_path, stand_in("content", "check", FILE)) as printed:
        until(lambda: asked(tmp_path) == ["long all"], "the first run")
        renamed_over(tmp_path / FILE, "perfect")
        until(lambda: b"Everything passes" in printed.read_bytes(), "the report")
    assert asked(tmp_path) == ["long all", "perfect all"]
    assert printed.read_bytes().count(b"---") == 2


def test_ctrl_c_ends_a_run_with_its_processes(tmp_path: Path) -> None:
    """Nobody waits for what was started."""
    (tmp_path / FILE).write_text("long")
    with watching(tmp_path, stand_in("content", "check", FILE)):
        words = tmp_path / "waits"
        until(lambda: words.exists() and is_running(words.read_text()), "the first run")
    until(lambda: not is_running(words.read_text()), "its end, long before it ends by itself")


def test_a_reader_that_goes_away_ends_the_watch(tmp_path: Path) -> None:
    """There is nobody left to tell."""
    (tmp_path / FILE).write_text("perfect")
    read, write = os.pipe()
    os.close(read)
    words = [*stand_in("content", "check", FILE), "--watch"]
    process = subprocess.run(
        words,
        cwd=tmp_path,
        env=environment(),
        stdout=write,
        stderr=subprocess.PIPE,
        check=False,
        timeout=PATIENCE,
    )
    os.close(write)
    assert process.returncode == 1
    assert process.stderr == b""


def test_states_tell_what_would_be_graded(tmp_path: Path) -> None:
    """The content counts, not the time or the file behind a name; results do not count."""
    file = tmp_path / "src" / FILE
    assert state_of(file) == GONE
    file.parent.mkdir()
    file.write_text("int a;\n")
    state = state_of(file)
    renamed_over(file, "int a;\n")
    assert state_of(file) == state
    (tmp_path / "bvhgrade-out").mkdir()
    assert state_of(tmp_path) == state
    (tmp_path / "bvhgrade-out" / "result.json").write_text("{}")
    assert state_of(tmp_path) == state
    file.write_text("int b;\n")
    assert state_of(file) != state
    file.unlink()
    assert state_of(tmp_path).startswith("rejected: ")


def test_a_real_run_follows_a_real_save(tmp_path: Path, cache: Path) -> None:
    """A mistake is explained, mended and found to be mended, by the whole grader."""
    wrong = corpus_folder() / "wrong" / "boxes-padded.cpp"
    (tmp_path / FILE).write_bytes(wrong.read_bytes())
    words = [sys.executable, "-m", "grader", "check", FILE, "--only", "bvh.boxes-are-tight"]
    with watching(tmp_path, ["env", f"BVHGRADE_CACHE={cache}", *words]) as printed:
        until(lambda: b"its triangles span" in printed.read_bytes(), "the first report")
        renamed_over(tmp_path / FILE, reference_source().read_text())
        until(lambda: b"checks of this run pass" in printed.read_bytes(), "the second report")
    assert (tmp_path / "bvhgrade-out" / "result.json").is_file()
