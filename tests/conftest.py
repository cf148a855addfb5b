"""What holds for every test: a test that cannot run is red."""

from collections.abc import Generator

import pytest
from hypothesis import settings

# No deadline, because a loaded machine is no bug; the same examples in every run.
settings.register_profile("grader", deadline=None, derandomize=True)
settings.load_profile("grader")


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
