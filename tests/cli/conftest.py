"""What tests of the command line start with."""

import sys
from pathlib import Path

import pytest

# What imports the real pipeline has to do so before a test replaces it.
import grader.batch.comparison
import grader.batch.settings  # noqa: F401 - for what it imports
from tests.cli.calls import FILE, Pipeline


@pytest.fixture
def pipeline(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Pipeline:
    """Replace the pipeline, and start in a student's folder with a cache of its own."""
    stand_in = Pipeline()
    monkeypatch.setitem(sys.modules, "grader.pipeline", stand_in)
    monkeypatch.setenv("BVHGRADE_CACHE", str(tmp_path / "cache"))
    here = tmp_path / "here"
    (here / "src").mkdir(parents=True)
    (here / FILE).write_text("int main() {}\n")
    monkeypatch.chdir(here)
    return stand_in
