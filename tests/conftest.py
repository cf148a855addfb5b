"""What holds for every test: a test that cannot run is red."""

import os
from collections.abc import Generator
from pathlib import Path

import pytest
from hypothesis import settings

# No deadline, because a loaded machine is no bug; the same examples in every run.
settings.register_profile("grader", deadline=None, derandomize=True)
settings.load_profile("grader")


@pytest.fixture(scope="session")
def cache(tmp_path_factory: pytest.TempPathFactory) -> Generator[Path]:
    """Give an empty cache of the grader, shared by all tests and all processes of this run."""
    own = tmp_path_factory.getbasetemp()
    # Each process of pytest-xdist has a folder of its own below that of the run.
    shared = own.parent if "PYTEST_XDIST_WORKER" in os.environ else own
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("BVHGRADE_CACHE", str(shared / "cache"))
        yield shared / "cache"


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[None]
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Turn a skip into a failure; an expected failure stays one."""
    report = yield
    if report.skipped and not hasattr(report, "wasxfail"):
        report.outcome = "failed"
        report.longrepr = (
            f"{item.nodeid} was skipped, but a test that cannot run proves nothing"
        )
    return report


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report() -> Generator[None, pytest.CollectReport, pytest.CollectReport]:
    """Turn a skipped file into an error."""
    report = yield
    if report.skipped:
        report.outcome = "failed"
        report.longrepr = (
            f"{report.nodeid} was skipped, but a test that cannot run proves nothing"
        )
    return report
