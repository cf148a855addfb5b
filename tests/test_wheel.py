"""An installed wheel, without a checkout, can do everything that a checkout can."""

import json
import os
import subprocess
import sys
import sysconfig
import venv
from collections.abc import Sequence
from pathlib import Path

import pytest

from tests.built_wheel import built_wheel
from tests.own_files import ROOT

Command = Sequence[str | Path]

# All in one process of xdist, so that the wheel is built once.
pytestmark = pytest.mark.xdist_group("wheel")


def run(command: Command, folder: Path) -> subprocess.CompletedProcess[str]:
    """Run a command with nothing of this checkout in its environment."""
    kept = {
        name: os.environ[name]
        for name in ("PATH", "HOME", "CXX", "BVHGRADE_CACHE")
        if name in os.environ
    }
    return subprocess.run(
        [str(word) for word in command],
        cwd=folder,
        env=kept,
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of an empty environment into which the wheel was installed.

    Its dependencies are taken from the environment of the tests, so that no network is needed.
    """
    folder = tmp_path_factory.mktemp("wheel")
    wheel = built_wheel(folder)
    venv.create(folder / "env", symlinks=True)
    python = folder / "env" / "bin" / "python"
    pip: Command = [
        sys.executable,
        "-m",
        "pip",
        "--python",
        python,
        "install",
        "--no-index",
        "--no-deps",
    ]
    quiet: Command = ["--quiet", "--disable-pip-version-check", wheel]
    done = run([*pip, *quiet], folder)
    assert done.returncode == 0, done.stdout + done.stderr
    (site,) = (folder / "env" / "lib").glob("python3*/site-packages")
    # A folder named in a .pth is searched, but its own .pth files (the checkout) are not read.
    (site / "dependencies.pth").write_text(sysconfig.get_path("purelib"))
    return folder / "env"


def ask(installed: Path, question: str) -> str:
    """Evaluate an expression in that environment."""
    code = f"from pathlib import Path; from grader import resources; print({question})"
    result = run([installed / "bin" / "python", "-I", "-c", code], installed)
    assert result.returncode == 0, result.stderr
    return result.stdout.strip()


@pytest.mark.parametrize("name", ["stub_folder", "reference_source", "scenes_folder"])
def test_everything_is_shipped(installed: Path, name: str) -> None:
    """The exercise, the reference and the scenes lie inside the wheel."""
    place = Path(ask(installed, f"resources.{name}()"))
    assert place.exists()
    assert place.is_relative_to(installed)


def test_every_file_is_shipped(installed: Path) -> None:
    """What git keeps below those folders and the package is in the wheel."""
    package = Path(ask(installed, "Path(resources.__file__).parent"))
    git = ["git", "ls-files", "grader", "student_stub", "reference", "scenes"]
    listed = run(list(git), ROOT)
    assert listed.returncode == 0, listed.stderr
    for name in listed.stdout.split():
        inside = name.removeprefix("grader/")
        place = package / inside if inside != name else package / "data" / name
        assert place.is_file(), name


def test_the_reference_scores_full_marks(installed: Path, tmp_path: Path) -> None:
    """Built, run and compared from the wheel alone."""
    reference = ask(installed, "resources.reference_source()")
    command: Command = [
        installed / "bin" / "bvhgrade",
        "grade",
        reference,
        "-o",
        tmp_path / "out",
    ]
    result = run(command, tmp_path)
    assert result.returncode == 0, result.stdout + result.stderr
    told = json.loads((tmp_path / "out" / "result.json").read_text())
    assert (told["score"], told["max_score"], told["needs_review"]) == (50, 50, False)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("scenes", "list"), "dragon"),
        (("doctor",), "isolation"),
        (("schema",), "max_score"),
        (("check", "--only", "build.compiles"), "build.compiles"),
    ],
)
def test_commands_do_their_work(
    installed: Path, tmp_path: Path, words: Sequence[str], told: str
) -> None:
    """Scenes, the compiler, the schema and the checks of a student are all in the wheel."""
    file = (ask(installed, "resources.reference_source()"),) if words[0] == "check" else ()
    result = run([installed / "bin" / "bvhgrade", *words, *file], tmp_path)
    assert result.returncode == 0, result.stdout + result.stderr
    assert told in result.stdout.lower()


def test_every_command_has_a_help(installed: Path, tmp_path: Path) -> None:
    """The command line is complete without a checkout."""
    for command in ("check", "grade", "scenes", "doctor", "schema", "certify"):
        result = run([installed / "bin" / "bvhgrade", command, "--help"], tmp_path)
        assert result.returncode == 0, result.stderr
