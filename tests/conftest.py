"""What holds for every test: a test that cannot run is red."""

import os
import shutil
import signal
import tempfile
from collections.abc import Generator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from hypothesis import settings

from grader import errors
from tests.browser import SOFTWARE, chromium

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Playwright

# No deadline, because a loaded machine is no bug; the same examples in every run.
settings.register_profile("grader", deadline=None, derandomize=True)
settings.load_profile("grader")


SHARED = "BVHGRADE_TESTS_SHARE"
"""Names the cache of a run to all processes of pytest-xdist, which inherit the environment."""


def pytest_configure() -> None:
    """Make the cache of this run, outside of pytest's folders, which no box can enter."""
    # A shell that runs us in the background has it ignored, and so would all our children.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    errors.STRICT = True
    if SHARED not in os.environ:
        os.environ[SHARED] = tempfile.mkdtemp(prefix="bvhgrade-tests-")


def pytest_unconfigure() -> None:
    """Remove it once the process that made it ends."""
    if "PYTEST_XDIST_WORKER" not in os.environ and SHARED in os.environ:
        shutil.rmtree(os.environ.pop(SHARED), ignore_errors=True)


@pytest.fixture(scope="session")
def cache() -> Generator[Path]:
    """Give an empty cache of the grader, shared by all tests and all processes of this run."""
    shared = Path(os.environ[SHARED])
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("BVHGRADE_CACHE", str(shared))
        yield shared


@pytest.fixture
def forgiving(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let guards swallow faults of ours, as they do for everybody else."""
    monkeypatch.setattr(errors, "STRICT", False)


@pytest.fixture(scope="session")
def playwright() -> Generator["Playwright"]:
    """Start what drives browsers; a process can have it once only."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as started:
        yield started


@pytest.fixture(scope="session")
def browser(playwright: "Playwright") -> Generator["Browser"]:
    """Start the browser of all tests of this process."""
    opened = playwright.chromium.launch(executable_path=chromium(), args=SOFTWARE)
    yield opened
    opened.close()


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
