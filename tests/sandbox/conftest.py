"""Levels of isolation as this machine has them; a level that is missing is a failure."""

import os
import tempfile
from collections.abc import Generator
from contextlib import suppress
from pathlib import Path

import pytest

from grader.sandbox.box import Isolation
from grader.sandbox.selftest import proved_isolation
from tests.sandbox.boxes import LEVELS
from tests.sandbox.census import zombies


@pytest.fixture(autouse=True)
def nothing_of_others() -> None:
    """Reap what earlier tests of this process left: what they killed has orphaned it to us."""
    for pid in zombies():
        with suppress(ChildProcessError):
            os.waitpid(pid, os.WNOHANG)


@pytest.fixture(params=LEVELS)
def isolation(request: pytest.FixtureRequest, cache: Path) -> Isolation:
    """Give each level in turn."""
    return proved_isolation(request.param)


@pytest.fixture
def open_folder() -> Generator[Path]:
    """Give a folder like the grader's: not below pytest's own, which no box can enter."""
    with tempfile.TemporaryDirectory(prefix="bvhgrade-") as name:
        Path(name).chmod(0o711)
        yield Path(os.path.realpath(name))
