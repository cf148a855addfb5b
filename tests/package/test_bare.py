"""The packages for Gradescope and PrairieLearn do in a bare Debian what they shall do there."""

import json
import subprocess
import sys
import tempfile
import zipfile
from collections.abc import Generator
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from grader.cli import cli
from grader.package.wheel import pinned
from tests.own_files import ROOT
from tests.package.bare import Container, bare_debian, in_memory, python_of, remove

# One root file system for all of them.
pytestmark = pytest.mark.xdist_group("bare")

WRONG = ROOT / "tests/submissions/wrong/first-hit-wins.cpp"

GRADESCOPE_MEMORY = 3 << 30
"""Bytes; docs/instructor.md tells the teacher to choose a container with 3 GB."""

LEAST_MEMORY = 100 << 20
"""Bytes that a grader, a compiler and a worker hold at least: less was not looked at."""

PRAIRIELEARN_MEMORY = 2 << 30
"""Bytes; what PrairieLearn gives a grading job."""


@pytest.fixture(scope="module")
def debian() -> Generator[Path]:
    """Build a bare Debian, outside of pytest's folders, which no stranger may enter."""
    place = in_memory()
    with tempfile.TemporaryDirectory(prefix="bvhgrade-bare-", dir=place) as folder:
        Path(folder).chmod(0o755)
        root = bare_debian(Path(folder))
        yield root
        remove(root)


@pytest.fixture(scope="module")
def wheels(debian: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Get the wheels of all that the grader needs, for the Python of the bare Debian."""
    folder = tmp_path_factory.mktemp("wheels")
    pins = folder / "constraints.txt"
    pins.write_text(pinned())
    pip = [sys.executable, "-m", "pip", "download", "--quiet", "--disable-pip-version-check"]
    only = ["--only-binary=:all:", "--no-deps", "--python-version", python_of(debian)]
    subprocess.run([*pip, *only, "-d", str(folder), "-r", str(pins)], check=True)
    return folder


def unpacked(host: str, wheels: Path, folder: Path) -> None:
    """Make a package, and unpack it as the host does: with the rights of its files."""
    folder.mkdir()
    archive = folder.with_suffix(".zip")
    made = CliRunner().invoke(
        cli, ["package", host, "-o", str(archive), "--wheels", str(wheels), "--seed", "41"]
    )
    assert made.exit_code == 0, made.output
    with zipfile.ZipFile(archive) as packed:
        for entry in packed.infolist():
            path = folder / entry.filename
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(packed.read(entry))
            path.chmod(entry.external_attr >> 16 & 0o777)


def graded_here(submission: Path, folder: Path, host: str) -> dict[str, Any]:
    """Grade a submission on this machine, in the host's format."""
    command = ["grade", str(submission), "-o", str(folder), "--format", host]
    done = CliRunner().invoke(cli, command)
    assert done.exit_code == 0, done.output
    told: dict[str, Any] = json.loads((folder / host / "results.json").read_text())
    return told


@pytest.fixture
def open_folder() -> Generator[Path]:
    """Give a folder that a stranger can enter."""
    place = in_memory()
    with tempfile.TemporaryDirectory(prefix="bvhgrade-host-", dir=place) as folder:
        Path(folder).chmod(0o755)
        yield Path(folder)


def test_gradescope(debian: Path, wheels: Path, open_folder: Path, tmp_path: Path) -> None:
    """Setup, then a submission in its folders: tests and points are as on this machine."""
    place = open_folder / "autograder"
    place.mkdir()
    unpacked("gradescope", wheels, place / "source")
    (place / "run_autograder").write_bytes((place / "source/run_autograder").read_bytes())
    (place / "run_autograder").chmod(0o755)
    (place / "results").mkdir()
    host = Container(debian, ((place, "/autograder"),))
    setup, _ = host.run("/autograder/source/setup.sh")
    assert setup.returncode == 0, setup.stdout
    # It has graded the model solution, and would have failed at anything but full marks.
    assert "50 of 50" in setup.stdout
    (place / "submission").mkdir()
    (place / "submission/exercise03.cpp").write_bytes(WRONG.read_bytes())
    ran, memory = host.run("/autograder/run_autograder")
    assert ran.returncode == 0, ran.stdout
    assert LEAST_MEMORY < memory < GRADESCOPE_MEMORY
    there = json.loads((place / "results/results.json").read_text())
    here = graded_here(WRONG, tmp_path / "here", "gradescope")
    assert there["score"] == here["score"] < 50
    assert points(there["tests"]) == points(here["tests"])


def points(tests: list[dict[str, Any]]) -> list[tuple[str, float, str]]:
    """Take of Gradescope's tests what a student sees first."""
    return [(one["name"], one["score"], one["output"]) for one in tests]


def test_prairielearn(debian: Path, wheels: Path, open_folder: Path, tmp_path: Path) -> None:
    """The image's steps, a submission, and a fault of ours: always status 0, always results."""
    unpacked("prairielearn", wheels, open_folder / "package")
    image, grade = open_folder / "package/image", open_folder / "grade"
    grade.mkdir()
    (image / "bvhgrade/entry.sh").write_bytes((image / "entry.sh").read_bytes())
    (image / "bvhgrade/entry.sh").chmod(0o755)
    host = Container(debian, ((image / "bvhgrade", "/bvhgrade"), (grade, "/grade")))
    built, _ = host.run("/bvhgrade/install.sh")
    assert built.returncode == 0, built.stdout
    question = open_folder / "package/questions/bvh/info.json"
    entry = json.loads(question.read_text())["externalGradingOptions"]["entrypoint"]
    (grade / "student").mkdir()
    (grade / "student/exercise03.cpp").write_bytes(WRONG.read_bytes())
    ran, memory = host.run(entry)
    assert ran.returncode == 0, ran.stdout
    assert LEAST_MEMORY < memory < PRAIRIELEARN_MEMORY
    there = json.loads((grade / "results/results.json").read_text())
    here = graded_here(WRONG, tmp_path / "here", "prairielearn")
    assert there["gradable"] is True
    assert (there["score"], there["tests"]) == (here["score"], here["tests"])
    # A grader that fails may not take an attempt away.
    (image / "bvhgrade/environment.sh").unlink()
    (grade / "results/results.json").unlink()
    ran, _ = host.run(entry)
    assert ran.returncode == 0
    assert json.loads((grade / "results/results.json").read_text())["gradable"] is False
