"""What tests of a class start with."""

from pathlib import Path

import pytest

from tests.batch.stand_in import LOG


@pytest.fixture
def log(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Name the file in which the stand-in writes down what it grades."""
    path = tmp_path / "log"
    monkeypatch.setenv(LOG, str(path))
    return path
