"""The scripts name in one sentence what a bare machine lacks, and cost nothing otherwise."""

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from tests.own_files import ROOT

TOOLS = ["bash", "basename", "cut", "dirname", "env", "flock", "rm", "sha256sum"]
COMPILERS = ["g++", "cmake", "make"]


def checkout(folder: Path, programs: list[str], python: str) -> Path:
    """Lay out a checkout and a `bin` that holds only these programs and such a Python."""
    shutil.copytree(ROOT / "scripts", folder / "scripts")
    shutil.copy(ROOT / "pyproject.toml", folder)
    programs_folder = folder / "bin"
    programs_folder.mkdir()
    for name in [*TOOLS, *programs]:
        found = shutil.which(name)
        assert found, name
        (programs_folder / name).symlink_to(found)
    if python:
        fake = programs_folder / "python3"
        fake.write_text(f"#!/bin/bash\n{python}\n")
        fake.chmod(0o755)
    return folder


def graded(folder: Path) -> subprocess.CompletedProcess[str]:
    """Call `scripts/grade` with nothing but that `bin` to be found."""
    return subprocess.run(
        ["bash", folder / "scripts" / "grade", "--help"],
        env={"PATH": str(folder / "bin")},
        capture_output=True,
        text=True,
        check=False,
    )


NO_VENV = 'case "$2" in *ensurepip*) exit 1 ;; esac'
NO_NETWORK = (
    'if [ "$2" = venv ]; then mkdir -p "$4/bin"; cp "$0" "$4/bin/python"; fi; [ "$2" != pip ]'
)


@pytest.mark.parametrize(
    ("programs", "python", "expected"),
    [
        (["cmake", "make"], "", "apt-get install g++"),
        (["g++", "make"], "", "apt-get install cmake"),
        (["g++", "cmake"], "", "apt-get install make"),
        (COMPILERS, "", "no Python 3.11 or newer was found"),
        (COMPILERS, "exit 1", "no Python 3.11 or newer was found"),
        (COMPILERS, NO_VENV, "apt-get install python3-venv"),
        ([*COMPILERS, "mkdir", "cp"], NO_NETWORK, "is there a network?"),
    ],
)
def test_what_is_missing_is_named(
    tmp_path: Path, programs: list[str], python: str, expected: str
) -> None:
    """One sentence, and the package that helps."""
    result = graded(checkout(tmp_path, programs, python))
    assert result.returncode == 3
    assert expected in result.stderr.splitlines()[-1]
    assert not list(tmp_path.glob(".venv/ready-*"))


def test_a_ready_environment_is_used_at_once(tmp_path: Path) -> None:
    """With an unchanged pyproject.toml no Python and no pip is started before the grader."""
    folder = checkout(tmp_path, COMPILERS, "")
    (folder / ".venv" / "bin").mkdir(parents=True)
    program = folder / ".venv" / "bin" / "bvhgrade"
    program.write_text('#!/bin/bash\necho "called: $*"\n')
    program.chmod(0o755)
    stamp = "source scripts/environment.sh; install() { printf '%s' \"$2\"; }; set_up run"
    content = subprocess.run(
        ["bash", "-c", stamp], cwd=folder, capture_output=True, text=True, check=True
    ).stdout
    (folder / ".venv" / "ready-run").write_text(content)
    assert graded(folder).stdout == "called: grade --help\n"
    with (folder / "pyproject.toml").open("a") as file:
        file.write("# changed\n")
    assert "no Python 3.11" in graded(folder).stderr


@pytest.mark.xdist_group("together")
def test_tests_of_one_group_share_a_process(request: pytest.FixtureRequest) -> None:
    """Else each process builds the wheel and compiles the attacks anew: xdist marks the id."""
    grouped = "PYTEST_XDIST_WORKER" in os.environ
    assert request.node.nodeid.endswith("@together") == grouped
