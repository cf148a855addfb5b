"""How do costs grow with the mesh? From a thousand faces to four million."""

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from grader.bench.boxes import Timer
from grader.bench.rays import scattered_rays
from grader.bench.record import Growth, Size
from grader.bench.solutions import check_cost
from grader.bench.statistics import exponent
from grader.oracle.generated import MOST_FACES, landscape
from grader.sandbox.nursery import Nursery

RAYS = 20_000
FACES = (1_000, 4_000, 16_000, 64_000, 256_000, 1_000_000, MOST_FACES)
QUICK_FACES = FACES[1:5]
SMALLEST_FITTED = 16_000
"""Below this the constant cost of a worker hides how a cost grows."""

SEED = 3


@dataclass(frozen=True, slots=True)
class _Cost:
    """One column of the table."""

    what: str
    of: Callable[[Size], float]


COSTS = (
    _Cost("construct", lambda size: size.construct),
    _Cost("check", lambda size: size.check),
    _Cost("rays", lambda size: size.rays),
    _Cost("together", lambda size: size.together),
)


def measured(library: Path, faces: int) -> Size:
    """Build, check and trace a landscape of so many faces."""
    mesh = landscape(faces, SEED)
    rays = scattered_rays(mesh, RAYS)
    begun = time.monotonic()
    with Nursery() as nursery:
        timer = Timer(nursery, mesh)
        tree = timer.tree(library)
        check = check_cost(mesh, tree).cpu
        timer.traced(library, rays)
        together = time.monotonic() - begun
        return Size(
            faces=faces,
            construct=timer.construct(library).cpu,
            check=check,
            rays=timer.trace(library, rays).cpu,
            together=together,
        )


def growths(sizes: tuple[Size, ...]) -> tuple[Growth, ...]:
    """Fit how each cost grows, on meshes that are large enough to tell."""
    large = [size for size in sizes if size.faces >= SMALLEST_FITTED]
    return tuple(
        Growth(cost.what, exponent([size.faces for size in told], list(map(cost.of, told))))
        for cost in COSTS
        # A cost of 0 was lost in the noise, and would bend every line.
        if len(told := [size for size in large if cost.of(size) > 0]) > 1
    )
