"""A namespace ends with its first process, whether or not bubblewrap took care of that."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from grader.sandbox import bubblewrap
from grader.sandbox.box import Box
from grader.sandbox.selftest import proved_isolation
from tests.sandbox.boxes import Given, python_as_compiler
from tests.sandbox.census import zombies


@pytest.mark.usefixtures("cache")
def test_a_namespace_that_nobody_tied_to_us_ends(
    open_folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Bubblewrap may be killed before its child has asked to die with it."""
    isolation, arguments = proved_isolation("A"), bubblewrap.arguments

    def untied(
        version: tuple[int, ...], box: Box, interior: bubblewrap.Interior
    ) -> Iterator[str]:
        return (
            word for word in arguments(version, box, interior) if word != "--die-with-parent"
        )

    monkeypatch.setattr(bubblewrap, "arguments", untied)
    code = "import time; time.sleep(600)"
    outcome = python_as_compiler(isolation, open_folder / "own", code, Given(seconds=1.0))
    assert outcome.timed_out
    assert zombies() == set()
