"""What the tests of the oracle compute is kept apart from what the user's runs computed."""

from pathlib import Path

import pytest


@pytest.fixture(scope="session", autouse=True)
def own_cache(cache: Path) -> Path:
    """Give the tests the cache folder of this run."""
    return cache
