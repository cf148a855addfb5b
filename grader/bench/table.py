"""In which order is everything measured, and what becomes of what is not installed?"""

import os
import platform
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path

from grader.bench import classes, compiling, others, scale, solutions, trivial, waiting, whole
from grader.bench.libraries import TEXTBOOK, Libraries, build_libraries
from grader.bench.programs import grader_peak
from grader.bench.record import Peak, Reading, Size, Table
from grader.build.compiler import find_compiler
from grader.oracle.scenes import load_mesh
from grader.sandbox.scratch import scratch_folder
from grader.summary import cpu_name

Progress = Callable[[str], None]
"""Is told what is measured next."""

PEERS = ("embreex", "mitsuba", "trimesh", "pytest", "check50")


@dataclass(frozen=True, slots=True)
class Effort:
    """How long a run may take."""

    mesh: str
    side: int
    """Camera rays are side x side."""

    scattered: int
    rounds: int
    faces: tuple[int, ...]
    classes: tuple[int, int]
    """Submissions of the small and of the large class."""

    grades: int
    """Rounds of whole grades."""


FULL = Effort("dragon", 512, 65_536, 5, scale.FACES, (10, 1_000), 5)
QUICK = Effort("dragon-res2", 128, 8_192, 2, scale.QUICK_FACES, (6, 18), 1)


def made(effort: Effort, progress: Progress) -> Table:
    """Measure everything.

    Args:
        effort: On what, and how often.
        progress: Is told what is measured next; it takes minutes.

    Raises:
        GraderError: Something of ours does not build or does not come back.
    """
    machine = _machine()
    with scratch_folder() as folder:
        progress("building the solutions that are compared")
        libraries = build_libraries(folder / "libraries")
        progress("grading, against compiling and running by hand")
        graded, floor = whole.measured(folder, effort.grades)
        readings = [*graded, *_readings(effort, libraries, folder, progress)]
        sizes = tuple(_sizes(effort, libraries.clear, progress))
        peaks = _peaks(effort, folder, progress)
        progress("other ray tracers")
        peers, failed = others.measured(folder)
    numbered = sorted(readings, key=lambda each: each.goal.number)
    return Table(
        machine=machine,
        is_quick=effort is QUICK,
        readings=tuple(numbered),
        sizes=sizes,
        growths=scale.growths(sizes),
        peaks=peaks,
        peers=peers,
        remarks=(*_missing(), *failed),
        floor=floor,
    )


def _readings(
    effort: Effort, libraries: Libraries, folder: Path, progress: Progress
) -> Iterator[Reading]:
    """Measure every goal but the first."""
    progress("solutions, checks and Embree")
    mesh = load_mesh(effort.mesh)
    course = solutions.course_on(mesh, effort.side, effort.scattered, effort.rounds)
    yield from solutions.measured(course, libraries, folder)
    progress("compilers")
    yield from compiling.measured(folder, effort.rounds)
    progress("what a program costs before it does anything")
    yield from trivial.measured(folder, effort.rounds)
    progress("what a quick check and the help take")
    yield from waiting.measured(folder, effort.rounds)
    small, large = effort.classes
    progress(f"classes of {small} and of {large:,}")
    yield from classes.measured(folder, small, large)


def _sizes(effort: Effort, library: Path, progress: Progress) -> Iterator[Size]:
    """Measure every size of a mesh."""
    for faces in effort.faces:
        progress(f"a landscape of {faces:,} faces")
        yield scale.measured(library, faces)


def _peaks(effort: Effort, folder: Path, progress: Progress) -> tuple[Peak, ...]:
    """Grade one that is asked for the mesh of four million faces: it says 20, not maxDepth."""
    if effort is QUICK:
        return ()
    progress("memory of a grade with 4,194,312 faces")
    source = folder / "literal.cpp"
    source.write_text(TEXTBOOK.read_text().replace("maxDepth", "20"))
    words = ("grade", source, "-o", folder / "literal", "--quiet")
    return (grader_peak("grade with 4,194,312 faces", *words),)


def _missing() -> list[str]:
    return [f"{name} is not installed" for name in PEERS if find_spec(name) is None]


def _machine() -> str:
    """Call it before anything is measured: the load is what others do."""
    cores = len(os.sched_getaffinity(0))
    busy = f"{cores} cores, load {os.getloadavg()[0]:.2f} at the start"
    versions = f"{find_compiler().title}, Python {platform.python_version()}"
    return f"{cpu_name()}, {busy}, {versions}"
