"""How fast is a class graded, with how much memory, and with the same results everywhere?

`python -m tests.batch.scale --students 300 --into FOLDER` makes a class of right, wrong and
attacking submissions in Moodle's layout, each with its own number in it so that none is graded
twice, and grades it in four runs, each into a folder of its own:

    single    on this machine, one submission at a time
    double    on this machine, two at a time
    cluster   on a cluster of two workers, of one thread each
    killed    on a cluster again, with `kill -9` for the command three times, and for a worker

`--runs` names some of them; a run that FOLDER holds is not made again, so they may be made one
after the other. It prints Markdown tables of what was measured, and which results differ.
It asserts nothing: whether a machine was quiet is for people to say.
"""

import argparse
import json
import random
import signal
import sqlite3
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from dataclasses import asdict, dataclass, field
from itertools import cycle
from pathlib import Path
from typing import Any

from tests.batch.classes import comparable
from tests.batch.clusters import Machines, machines
from tests.batch.processes import cpu_seconds, descendants, memory_peak, memory_sum, named
from tests.cli.test_processes import environment
from tests.own_files import ROOT

RUNS = ("single", "double", "cluster", "killed")
SEED = 6
LOOK_SECONDS = 1.0
WORKERS = 2

KINDS = ("submissions/right", "submissions/wrong", "submissions/wrong", "attacks/submissions")
"""Folders from which a class takes turns."""


@dataclass
class Measured:
    """What one run took, in seconds and MiB."""

    run: str
    students: int
    seconds: float = 0.0
    status: int = 0
    kills: int = 0
    parent: list[tuple[int, float]] = field(default_factory=list)
    """How many results there were, and the memory of the command then."""

    clerk: float = 0.0
    """Most that one clerk took by itself."""

    boxes: float = 0.0
    """Most that a clerk took together with the boxes in which it ran and compiled."""

    worker: float = 0.0
    """Most that a Dask worker took by itself."""

    scheduler: float = 0.0
    own_seconds: float = 0.0
    """CPU time of the command itself, as often as it was begun."""

    stored: float = 0.0
    """MiB of all that was written."""

    def grown(self) -> tuple[float, float]:
        """Most memory of the command up to a quarter of the class, and after it."""
        early = [mib for done, mib in self.parent if 4 * done <= self.students]
        late = [mib for done, mib in self.parent if 4 * done > self.students]
        return max(early, default=0.0), max(late, default=0.0)


def make_class(folder: Path, students: int) -> Path:
    """Write submissions under made-up names, each in a folder as Moodle packs them."""
    chosen = random.Random(SEED)  # noqa: S311 - the same class every time
    folders = {}
    for kind in KINDS:
        files = sorted((ROOT / "tests" / kind).glob("*.cpp"))
        chosen.shuffle(files)
        folders[kind] = cycle(files)
    for number, kind in zip(range(1, students + 1), cycle(KINDS)):
        place = folder / f"Student {number:05}_{70_000 + number}_assignsubmission_file"
        place.mkdir(parents=True, exist_ok=True)
        text = next(folders[kind]).read_bytes()
        (place / "exercise03.cpp").write_bytes(text + f"\n// s{number:05}\n".encode())
    return folder


def finished(out: Path) -> int:
    """Count the results in a store."""
    store = out / "batch.sqlite"
    if not store.exists():
        return 0
    try:
        with closing(sqlite3.connect(f"file:{store}?mode=ro", uri=True)) as base:
            count: int = base.execute("SELECT count(*) FROM result").fetchone()[0]
            return count
    except sqlite3.OperationalError:
        return 0


@dataclass
class Watched:
    """A command that grades a class, and what is seen of it."""

    process: subprocess.Popen[bytes]
    out: Path
    measured: Measured
    cluster: Machines | None
    own_seconds: float = 0.0

    def until(self, claim: Callable[[int], bool]) -> None:
        """Look at it until so many results are there, or it has ended."""
        while self.process.poll() is None and not claim(finished(self.out)):
            self._look()
            time.sleep(LOOK_SECONDS)

    def _look(self) -> None:
        seen = self.measured
        seen.parent.append((finished(self.out), memory_peak(self.process.pid)))
        self.own_seconds = max(self.own_seconds, cpu_seconds(self.process.pid))
        grading = [self.process.pid]
        if self.cluster is not None:
            workers = [one.pid for one in self.cluster.workers if one.poll() is None]
            seen.worker = max([seen.worker, *map(memory_peak, workers)])
            if self.cluster.scheduler is not None:
                own = memory_peak(self.cluster.scheduler.pid)
                seen.scheduler = max(seen.scheduler, own)
            grading = workers
        for each in grading:
            for clerk in named("grader.sandbox.clerk", descendants(each)):
                seen.clerk = max(seen.clerk, memory_peak(clerk))
                seen.boxes = max(seen.boxes, memory_sum([clerk, *descendants(clerk)]))


def begun(class_: Path, out: Path, measured: Measured, cluster: Machines | None) -> Watched:
    """Type the command."""
    clerks = {"single": ["--jobs", "1"], "double": ["--jobs", "2"]}.get(measured.run, [])
    where = ["--scheduler", cluster.address] if cluster else clerks
    words = [sys.executable, "-m", "grader", "batch", str(class_), "-o", str(out), *where]
    with (out.parent / f"{measured.run}.log").open("ab") as log:
        process = subprocess.Popen(words, env=environment(), stdout=log, stderr=log)
    return Watched(process, out, measured, cluster)


def run_once(class_: Path, out: Path, measured: Measured, cluster: Machines | None) -> None:
    """Grade the class, killing the command and a worker on the way if that is asked for."""
    total = measured.students
    started = time.monotonic()
    if measured.run == "killed" and cluster is not None:
        for quarter in (1, 2, 3):
            command = begun(class_, out, measured, cluster)
            command.until(lambda done, least=quarter * total // 4: done >= least)  # type: ignore[misc]  # bound here
            if command.process.poll() is None:
                command.process.kill()
                measured.kills += 1
            command.process.wait()
            measured.own_seconds += command.own_seconds
        cluster.workers[0].send_signal(signal.SIGKILL)
        cluster.hire()
    command = begun(class_, out, measured, cluster)
    command.until(lambda _: False)
    measured.status = command.process.wait()
    measured.seconds = time.monotonic() - started
    measured.own_seconds += command.own_seconds
    files = [path.stat().st_size for path in out.rglob("*") if path.is_file()]
    measured.stored = sum(files) / (1 << 20)


@contextmanager
def place_of(run: str, into: Path) -> Iterator[Machines | None]:
    """Start a cluster for the runs that need one."""
    if run in ("single", "double"):
        yield None
        return
    with machines(into / f"{run}-machines", WORKERS) as cluster:
        yield cluster


def measure(run: str, class_: Path, into: Path, students: int) -> Measured:
    """Make one run, or read what it was when it was made before."""
    kept, out = into / f"{run}.json", into / run
    if kept.exists():
        told: dict[str, Any] = json.loads(kept.read_text())
        return Measured(**told | {"parent": [(a, b) for a, b in told["parent"]]})
    measured = Measured(run, students)
    with place_of(run, into) as cluster:
        run_once(class_, out, measured, cluster)
    kept.write_text(json.dumps(asdict(measured)))
    return measured


def differing(first: Path, second: Path) -> list[str]:
    """Name the students whose results differ in more than times and the processor's name."""
    before, after = comparable(first), comparable(second)
    names = sorted({*before, *after})
    return [name for name in names if before.get(name) != after.get(name)]


def tables(runs: list[Measured], into: Path) -> Iterator[str]:
    """Word what was measured."""
    yield "| run | graded | killed | status | minutes | an hour | each | the command | stored |"
    yield "|---|---:|---:|---:|---:|---:|---:|---:|---:|"
    for one in runs:
        graded = finished(into / one.run)
        hour = 3600 * graded / one.seconds if one.seconds else 0.0
        each, own, stored = (
            value / max(1, graded) for value in (one.seconds, one.own_seconds, one.stored)
        )
        yield (
            f"| {one.run} | {graded:,} | {one.kills} | {one.status} | {one.seconds / 60:.1f} "
            f"| {hour:,.0f} | {each:.1f} s | {1000 * own:.0f} ms | {stored:.2f} MiB |"
        )
    yield ""
    yield "| MiB, at most | " + " | ".join(one.run for one in runs) + " |"
    yield "|---|" + "---:|" * len(runs)
    rows: dict[str, Callable[[Measured], float]] = {
        "the command, first quarter of the class": lambda one: one.grown()[0],
        "the command, rest of the class": lambda one: one.grown()[1],
        "a clerk": lambda one: one.clerk,
        "a clerk and its boxes": lambda one: one.boxes,
        "a Dask worker, without its clerk": lambda one: one.worker,
        "the scheduler": lambda one: one.scheduler,
    }
    for name, value in rows.items():
        cells = (f"{value(one):,.0f}" if value(one) else "" for one in runs)
        yield f"| {name} | " + " | ".join(cells) + " |"
    yield ""
    for one in runs[1:]:
        names = differing(into / runs[0].run, into / one.run)
        named_ = ", ".join(names[:10]) + (", ..." if len(names) > 10 else "")
        yield f"- {runs[0].run} and {one.run}: " + (
            f"{len(names)} results differ: {named_}" if names else "the same results"
        )


def main() -> None:
    """Measure, and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--students", type=int, default=300)
    parser.add_argument("--into", type=Path, required=True)
    parser.add_argument("--runs", nargs="+", choices=RUNS, default=RUNS)
    given = parser.parse_args()
    # Or a cluster would be left behind.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("terminated"))
    into: Path = given.into
    class_ = make_class(into / "class", given.students)
    runs = [measure(run, class_, into, given.students) for run in given.runs]
    sys.stdout.write("\n".join(tables(runs, into)) + "\n")


if __name__ == "__main__":
    main()
