"""A real scheduler and real workers, as processes on this machine that nobody else reaches."""

import json
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

from tests.cli.test_processes import environment

PATIENCE = 300.0
TIDYING = 20.0
"""Seconds that a worker may take to end."""

HERE = ("--host", "127.0.0.1", "--dashboard-address", "127.0.0.1:0")

Process = subprocess.Popen[bytes]


@dataclass
class Machines:
    """A cluster, whose processes a test may kill."""

    folder: Path
    given: dict[str, str]
    """What workers find in their environment."""

    address: str = ""
    scheduler: Process | None = None
    workers: list[Process] = field(default_factory=list)

    def begin(self, before: str = "") -> None:
        """Start the scheduler, after a line of Python, in place of the one before."""
        if self.scheduler is not None:
            self.scheduler.kill()
            self.scheduler.wait()
        told = self.folder / "scheduler.json"
        told.unlink(missing_ok=True)
        code = f"{before}\nfrom distributed.cli.dask_scheduler import main; main()"
        self.scheduler = self._started(code, "--port", "0", "--scheduler-file", str(told))
        deadline = time.monotonic() + PATIENCE
        while not told.exists() or not told.read_text():
            assert time.monotonic() < deadline, self.said()
            time.sleep(0.05)
        self.address = json.loads(told.read_text())["address"]

    def hire(self, count: int = 1, **more: str) -> None:
        """Start workers of one thread each."""
        for _ in range(count):
            scratch = ("--local-directory", str(self.folder))
            words = (self.address, "--nthreads", "1", "--no-nanny", *scratch)
            code = "from distributed.cli.dask_worker import main; main()"
            self.workers.append(self._started(code, *words, **more))

    def said(self) -> str:
        """What all of them printed."""
        return (self.folder / "said").read_text(errors="replace")

    def end(self) -> None:
        """End all that are left; a worker that may end by itself tidies up."""
        # The scheduler last: a worker says goodbye to it, and waits if nobody hears that.
        for together in (self.workers, [each for each in (self.scheduler,) if each]):
            for process in together:
                process.terminate()
            for process in together:
                try:
                    process.wait(TIDYING)
                except subprocess.TimeoutExpired:
                    process.kill()
                    process.wait()

    def _started(self, code: str, *words: str, **more: str) -> Process:
        with (self.folder / "said").open("ab") as said:
            return subprocess.Popen(
                [sys.executable, "-P", "-c", code, *HERE, *words],
                env=environment(**self.given, **more),
                stdin=subprocess.DEVNULL,
                stdout=said,
                stderr=said,
            )


@contextmanager
def machines(folder: Path, workers: int = 2, /, **given: str) -> Iterator[Machines]:
    """Start a cluster, and end it with the block."""
    folder.mkdir(exist_ok=True)
    cluster = Machines(folder, given)
    try:
        cluster.begin()
        cluster.hire(workers)
        yield cluster
    finally:
        cluster.end()
