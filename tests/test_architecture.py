"""Who may import whom: import-linter's contracts hold, and they would notice."""

import ast
import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.own_files import ROOT, python_files

STARTERS = {"fork", "forkpty", "posix_spawn", "posix_spawnp", "system", "popen", "startfile"}
"""Functions of `os` that start a process, beside those whose names begin with exec or spawn."""


def linted(folder: Path) -> subprocess.CompletedProcess[str]:
    """Run import-linter on the package in a folder, with the project's contracts."""
    environment = {**os.environ, "PYTHONPATH": str(folder)}
    lint = "from importlinter.cli import lint_imports_command as main; main()"
    options = ["--config", str(ROOT / "pyproject.toml"), "--no-cache"]
    return subprocess.run(
        [sys.executable, "-P", "-c", lint, *options],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )


def with_line(folder: Path, name: str, line: str) -> Path:
    """Copy the package and append a line to one of its files, which may be new."""
    for path in (ROOT / "grader").rglob("*.py"):
        copied = folder / path.relative_to(ROOT)
        copied.parent.mkdir(parents=True, exist_ok=True)
        copied.write_bytes(path.read_bytes())
    with (folder / "grader" / name).open("a") as file:
        file.write(f"\n{line}\n")
    return folder


def test_the_contracts_hold() -> None:
    """Nothing imports what it may not."""
    result = linted(ROOT)
    assert result.returncode == 0, result.stdout + result.stderr


@pytest.mark.parametrize(
    ("name", "line", "contract"),
    [
        ("score/points.py", "import grader.verify.engine", "stages do not know each other"),
        ("model/mesh.py", "import grader.score.points", "stages do not know each other"),
        ("score/points.py", "import grader.diagnose.causes", "stages do not know each other"),
        ("diagnose/causes.py", "import grader.score.points", "a likely cause comes from cases"),
        ("helpers.py", '"""A new module."""', "stages do not know each other"),
        ("verify/engine.py", "import subprocess", "only sandbox starts processes"),
        ("report/facts.py", "import multiprocessing", "only sandbox starts processes"),
        ("build/compile.py", "import ctypes", "only run.worker, run.abi and the sandbox call"),
        ("verify/closest.py", "import mitsuba", "only oracle talks to other ray tracers"),
        ("run/worker.py", "import grader.verify.closest", "the worker knows no answers"),
        ("run/worker.py", "import numpy", "the worker knows no answers"),
    ],
)
def test_a_forbidden_import_is_noticed(
    tmp_path: Path, name: str, line: str, contract: str
) -> None:
    """One made-up line breaks exactly the contract that forbids it."""
    result = linted(with_line(tmp_path, name, line))
    assert result.returncode == 1, result.stdout + result.stderr
    broken = [shown for shown in result.stdout.splitlines() if " BROKEN" in shown]
    assert any(contract in shown for shown in broken), result.stdout


def started_processes(tree: ast.AST) -> list[str]:
    """Name what starts a process without importing `subprocess`."""
    found: list[str] = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and getattr(node.value, "id", "") == "os":
            names = [node.attr]
        elif isinstance(node, ast.ImportFrom) and node.module == "os":
            names = [alias.name for alias in node.names]
        else:
            names = ["ProcessPoolExecutor"] if is_pool(node) else []
        found += [n for n in names if n in STARTERS or n.startswith(("exec", "spawn", "Proc"))]
    return found


def is_pool(node: ast.AST) -> bool:
    """This names a pool of processes."""
    name = getattr(node, "attr", getattr(node, "id", getattr(node, "name", "")))
    return name == "ProcessPoolExecutor"


def test_only_the_sandbox_forks() -> None:
    """No other module reaches the functions of `os` that start a process."""
    for path in python_files("grader"):
        if "sandbox" not in path.parts:
            assert not started_processes(ast.parse(path.read_bytes())), path


@pytest.mark.parametrize(
    "line",
    [
        "os.fork()",
        "from os import execv",
        "os.spawnl(1)",
        "os.system('x')",
        "from concurrent.futures import ProcessPoolExecutor",
    ],
)
def test_a_fork_is_noticed(line: str) -> None:
    """Each way of starting a process is seen."""
    assert started_processes(ast.parse(line))
