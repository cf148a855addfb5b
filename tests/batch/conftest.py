"""What tests of a class start with."""

from pathlib import Path

import pytest

from tests.batch.classes import Made, folder_of, zip_of
from tests.batch.stand_in import LOG


@pytest.fixture
def log(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Name the file in which the stand-in writes down what it grades."""
    path = tmp_path / "log"
    monkeypatch.setenv(LOG, str(path))
    return path


@pytest.fixture(params=[folder_of, zip_of], ids=["folder", "zip"])
def made(request: pytest.FixtureRequest) -> Made:
    """Make a class as a folder, and as a zip."""
    make: Made = request.param
    return make
