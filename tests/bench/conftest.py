"""What is timed and counted is built once for all of its tests."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from grader.bench.libraries import Libraries, build_libraries
from grader.sandbox.scratch import scratch_folder


@pytest.fixture(scope="package", name="libraries")
def built_libraries(cache: Path) -> Iterator[Libraries]:
    """Build what is compared, once; where confined processes may read it."""
    del cache
    with scratch_folder() as folder:
        yield build_libraries(folder / "libraries")
