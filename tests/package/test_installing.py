"""Installing and grading run no file of the student in whose folder the scripts are called."""

import os
import re
import subprocess
import zipfile
from pathlib import Path

import pytest

from grader.oracle import variant

FILES = Path(variant.__file__).parents[1] / "package" / "files"

STOLEN = """\
import pathlib
with pathlib.Path({owned!r}).open("a") as file:
    file.write({name!r} + "\\n")
"""

CLI = """\
import json, pathlib, sys

def main():
    if sys.argv[1] == "grade":
        result = {"score": 50, "max_score": 50, "checks": []}
        pathlib.Path(sys.argv[4], "result.json").write_text(json.dumps(result))
"""

MODULES = {
    "grader/__init__.py": "",
    "grader/cli.py": CLI,
    "grader/resources.py": "def reference_source():\n    return 'exercise03.cpp'\n",
}
"""Of a grader that only says that everything is right."""


def write_wheel(folder: Path, name: str, modules: dict[str, str]) -> None:
    """Write the smallest wheel that pip installs."""
    told = f"{name}-1.dist-info"
    files = modules | {
        f"{told}/METADATA": f"Metadata-Version: 2.1\nName: {name}\nVersion: 1\n",
        f"{told}/WHEEL": "Wheel-Version: 1.0\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
        f"{told}/entry_points.txt": "[console_scripts]\nbvhgrade = grader.cli:main\n",
    }
    files[f"{told}/RECORD"] = "".join(f"{each},,\n" for each in [*files, f"{told}/RECORD"])
    folder.mkdir(exist_ok=True)
    with zipfile.ZipFile(folder / f"{name}-1-py3-none-any.whl", "w") as wheel:
        for path, text in files.items():
            wheel.writestr(path, text)


@pytest.fixture
def kit(tmp_path: Path) -> Path:
    """Lay out what a package installs, with a tiny grader, and without a network."""
    kit = tmp_path / "kit"
    kit.mkdir()
    for name in ("install.sh", "grade.sh"):
        (kit / name).write_bytes((FILES / name).read_bytes())
        (kit / name).chmod(0o755)
    (kit / "settings.sh").write_text("chosen=()\n")
    (kit / "constraints.txt").touch()
    write_wheel(kit / "wheels", "bvhgrade", MODULES)
    write_wheel(kit / "wheels", "numpy", {"numpy/__init__.py": ""})
    return kit


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    """Write a student's repository whose files are called like parts of Python."""
    folder = tmp_path / "repository"
    folder.mkdir()
    for name in ("venv", "ensurepip", "json", "pip", "grader", "re", "sitecustomize"):
        stolen = STOLEN.format(owned=str(tmp_path / "owned"), name=name)
        (folder / f"{name}.py").write_text(stolen)
    return folder


@pytest.mark.parametrize("more", [False, True], ids=["as it is", "PYTHONPATH"])
def test_no_file_of_the_students_is_run(
    kit: Path, repository: Path, tmp_path: Path, more: bool
) -> None:
    """As the action of GitHub does it: from within the checkout."""
    search = {"PYTHONPATH": str(repository)} if more else {}
    for command in (["install.sh"], ["grade.sh", "exercise03.cpp", str(tmp_path)]):
        done = subprocess.run(
            [str(kit / command[0]), *command[1:]],
            cwd=repository,
            env={**os.environ, **search},
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, done.stdout + done.stderr
    assert not (tmp_path / "owned").exists(), (tmp_path / "owned").read_text()
    assert (tmp_path / "result.json").is_file()


def test_every_call_of_python_is_isolated() -> None:
    """A new one, too."""
    call = re.compile(r"(?:\bpython[0-9.]*|\$\{?(?:python|name)\}?)\"? +(\S+)")
    calls = [
        (path.name, line)
        for path in sorted(FILES.iterdir())
        for line in path.read_text().splitlines()
        for first in call.findall(line)
        if first.startswith(("-", '"$here', "/")) and first not in ("-I", "-dumpversion")
    ]
    assert not calls


def test_the_probe_of_mitsuba_runs_none_either(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """`doctor` and `grade` start it where they were started."""
    (tmp_path / "mitsuba.py").write_text("import os\nprint('works', flush=True)\nos._exit(0)\n")
    monkeypatch.chdir(tmp_path)
    assert not variant._works(tmp_path / "no-library.so")
