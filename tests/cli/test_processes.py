"""The command line as a real process: speed, signals, pipes, encodings, terminals."""

import os
import pty
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from grader.output import RESULT
from tests.report.readers import commands

CHECKOUT = Path(__file__).parents[2]
FILE = "exercise03.cpp"


@pytest.fixture
def here(tmp_path: Path) -> Path:
    """A folder with something that looks like a submission."""
    (tmp_path / FILE).write_text("")
    return tmp_path


def environment(**more: str) -> dict[str, str]:
    """Take over what a process needs, and nothing that would change what it prints."""
    kept = {name: os.environ[name] for name in ("PATH", "HOME", "TMPDIR") if name in os.environ}
    return {**kept, "PYTHONPATH": str(CHECKOUT), "COLUMNS": "80", **more}


def stand_in(sample: str, *words: str) -> list[str]:
    """Word the call of a process with a stand-in pipeline."""
    return [sys.executable, "-m", "tests.cli.stand_in", sample, *words]


def run(here: Path, words: list[str], **more: str) -> subprocess.CompletedProcess[bytes]:
    """Run a process to its end."""
    return subprocess.run(
        words, cwd=here, env=environment(**more), capture_output=True, check=False, timeout=60
    )


def test_help_imports_nothing_heavy(here: Path) -> None:
    """The help appears at once because nothing is imported before it is needed."""
    code = (
        "import sys, grader.cli\n"
        "print({'numpy', 'rich', 'mitsuba', 'trimesh', 'subprocess'} & set(sys.modules))"
    )
    assert run(here, [sys.executable, "-c", code]).stdout == b"set()\n"


@pytest.mark.parametrize(("sample", "status"), [("perfect", 0), ("failing", 1), ("broken", 3)])
def test_the_status_leaves_the_process(here: Path, sample: str, status: int) -> None:
    """As a shell and a workflow see it."""
    assert run(here, stand_in(sample, "check", FILE)).returncode == status


def test_without_a_compiler_grading_says_what_to_install(here: Path, tmp_path: Path) -> None:
    """It is nobody's mistake: no result is written."""
    (here / FILE).write_text('#include "bvh.h"\n')
    nowhere = {"PATH": str(tmp_path / "bin"), "BVHGRADE_CACHE": str(tmp_path / "cache")}
    words = [sys.executable, "-m", "grader", "grade", FILE, "--unsafe-no-isolation"]
    ended = run(here, words, **nowhere)
    assert ended.returncode == 3
    assert b"install the Debian package g++" in ended.stderr
    assert b"Traceback" not in ended.stderr
    assert not (here / "bvhgrade-out" / RESULT).exists()


def test_an_interruption_ends_with_130_and_leaves_no_result(here: Path) -> None:
    """Ctrl-C in the middle of a grading."""
    process = subprocess.Popen(
        stand_in("sleep", "grade", FILE, "-o", "out"),
        cwd=here,
        env=environment(),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    deadline = time.monotonic() + 30
    while not (here / "ready").exists() and time.monotonic() < deadline:
        time.sleep(0.02)
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=30)
    assert process.returncode == 130
    assert b"Traceback" not in said
    assert list((here / "out").iterdir()) == []


def test_a_reader_that_goes_away_changes_nothing(here: Path) -> None:
    """`bvhgrade check | head -0` still ends with the status of the grade."""
    read, write = os.pipe()
    os.close(read)
    process = subprocess.run(
        stand_in("failing", "check", FILE),
        cwd=here,
        env=environment(),
        stdout=write,
        stderr=subprocess.PIPE,
        check=False,
        timeout=60,
    )
    os.close(write)
    assert process.returncode == 1
    assert process.stderr == b""
    assert (here / "bvhgrade-out" / RESULT).is_file()


@pytest.mark.parametrize(
    "words", [["schema"], ["--help"], ["schema", "--help"], ["grade", FILE, "--quiet"]]
)
def test_a_full_standard_output_is_said_to_be_full(here: Path, words: list[str]) -> None:
    """It is no fault of the grader, and what is in files stays there."""
    with Path("/dev/full").open("wb") as full:
        ended = subprocess.run(
            stand_in("perfect", *words),
            cwd=here,
            env=environment(),
            stdout=full,
            stderr=subprocess.PIPE,
            check=False,
            timeout=60,
        )
    assert ended.returncode == 3
    (said,) = ended.stderr.decode().splitlines()
    assert said.startswith(
        "bvhgrade: standard output cannot be written: No space left on device"
    )
    assert (here / "bvhgrade-out" / RESULT).is_file() == (words[0] == "grade")


def test_the_status_says_it_where_nothing_else_can(here: Path) -> None:
    """Not 1, which would mean that points are lost."""
    with Path("/dev/full").open("wb") as full:
        words = stand_in("perfect", "check", FILE)
        ended = subprocess.run(
            words,
            cwd=here,
            env=environment(),
            stdout=full,
            stderr=full,
            check=False,
            timeout=60,
        )
    assert ended.returncode == 3


def test_a_reader_of_a_schema_may_go_away(here: Path) -> None:
    """Nothing is said, and nothing is kept for a maintainer."""
    read, write = os.pipe()
    os.close(read)
    process = subprocess.run(
        stand_in("perfect", "schema"),
        cwd=here,
        env=environment(BVHGRADE_CACHE=str(here / "cache")),
        stdout=write,
        stderr=subprocess.PIPE,
        check=False,
        timeout=60,
    )
    os.close(write)
    assert process.stderr == b""
    assert not (here / "cache").exists()


def test_an_old_encoding_gets_words(here: Path) -> None:
    """A pipe of another age."""
    result = run(here, stand_in("failing", "check", FILE), PYTHONIOENCODING="cp1252")
    assert result.returncode == 1
    assert b"FAIL hits.closest-wins" in result.stdout
    assert result.stdout.isascii()


def test_a_name_that_is_no_utf_8_is_a_name(here: Path) -> None:
    """Somebody's archive was made long ago."""
    odd = os.fsdecode(b"gr\xf6\xdfe.cpp")
    (here / odd).write_text("")
    result = run(here, stand_in("failing", "check", odd))
    assert result.returncode == 1
    assert b"Traceback" not in result.stderr
    missing = run(here, stand_in("failing", "check", odd + "x"))
    assert missing.returncode == 2


def test_progress_is_shown_in_a_terminal_only(here: Path) -> None:
    """A stage's name is text, not markup; the line vanishes before the report."""
    ours, theirs = pty.openpty()
    process = subprocess.Popen(
        stand_in("perfect", "grade", FILE),
        cwd=here,
        env=environment(TERM="xterm-256color"),
        stdout=subprocess.PIPE,
        stderr=theirs,
    )
    out, _ = process.communicate(timeout=60)
    os.close(theirs)
    shown = os.read(ours, 65536).decode()
    os.close(ours)
    assert "tracing [red]rays[/red]" in shown
    assert b"tracing" not in out
    assert run(here, stand_in("perfect", "grade", FILE)).stderr == b""


@pytest.mark.parametrize(
    "words", [["check", "\u6f22.cpp"], ["grade", "none\u6f22"], ["doctor"]]
)
def test_what_the_encoding_lacks_is_written_as_its_code(here: Path, words: list[str]) -> None:
    """Neither a report nor a complaint ends with a fault of encoding."""
    (here / "\u6f22.cpp").write_text("")
    cache = str(here / "cache-\u6f22")
    result = run(
        here, stand_in("failing", *words), PYTHONIOENCODING="cp1252", BVHGRADE_CACHE=cache
    )
    assert b"\\u6f22" in result.stdout + result.stderr
    assert b"itself failed" not in result.stderr


@pytest.mark.parametrize(
    "words",
    [
        ["--\x1b]0;x\x07\n::error::x"],
        ["grade", "--\x1b[2J\n::error::x"],
        ["grade", FILE, "##[error]x\x1b[2J", "\n::stop-commands::x"],
        ["grade", "\x1b[2J\n::error::x"],
        ["\x1b[2J\n::error::x ##[group]"],
    ],
)
def test_what_a_shell_found_in_a_folder_does_not_act(here: Path, words: list[str]) -> None:
    """`bvhgrade grade *` quotes a stranger's file names in its complaint."""
    result = run(here, stand_in("failing", *words))
    assert result.returncode == 2
    assert not commands(result.stderr.decode())
    assert b"\x1b" not in result.stderr
