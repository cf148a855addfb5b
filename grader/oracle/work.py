"""How much may a ray cost? Trials whose tests are counted, and whose time is taken."""

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from grader.model.mesh import Bvh, Mesh, Rays
from grader.model.trials import WorkTrial
from grader.oracle.brute import NOTHING
from grader.oracle.bundle import around, beams, stage_for, within
from grader.oracle.costs import plain_costs
from grader.oracle.meshes import generator, welded
from grader.oracle.ordinary import from_inside
from grader.oracle.rays import joined
from grader.oracle.scenes import load_mesh
from grader.oracle.shapes import plane

Trees = Callable[[Sequence[Mesh]], list[Bvh]]

WORK = (("dragon-res4", 10_000), ("dragon-res2", 20_000))
"""Meshes and how many rays: on 11,102 faces, too, so many that testing all of them shows in the
time, for who tests by itself is not counted."""

FLOOR_TILES, FLOOR_RAYS = 70, 2_000
"""Of a level floor, whose boxes are all flat: who does without their test has 9,800 faces."""

SPECIAL_RAYS = 1_500
"""Of each kind in the trial of special rays."""


def work_trials(seed: int, trees: Trees) -> list[WorkTrial]:
    """Lay out the trials, on stored meshes of 11,102 and 202,520 faces and on a floor.

    Args:
        seed: Of the run.
        trees: Builds the reference's tree of each mesh.
    """
    meshes = [load_mesh(name) for name, _ in WORK]
    built = trees(meshes)
    trials = [
        _work_trial(f"work on {name}", mesh, tree, incoherent(seed, name, mesh, count))
        for (name, count), mesh, tree in zip(WORK, meshes, built, strict=True)
    ]
    rays = _special(seed, meshes[0])
    special = _work_trial(f"work on {WORK[0][0]}, special rays", meshes[0], built[0], rays)
    return [*trials, replace(special, special=True), _floor(seed, trees)]


def _floor(seed: int, trees: Trees) -> WorkTrial:
    name = "level floor"
    rng = generator(seed, name)
    mesh = welded(plane(2, rng.uniform(-1, 1), FLOOR_TILES), rng)
    return _work_trial(
        f"work on a {name}", mesh, trees([mesh])[0], incoherent(seed, name, mesh, FLOOR_RAYS)
    )


def _work_trial(name: str, mesh: Mesh, tree: Bvh, rays: Rays) -> WorkTrial:
    boxes, triangles = plain_costs(tree, rays)
    return WorkTrial(name, mesh, tree, rays, boxes, triangles)


def incoherent(seed: int, name: str, mesh: Mesh, count: int) -> Rays:
    """Draw rays from all around to anywhere in the box of a mesh, whose name is given."""
    stage = stage_for(mesh, generator(seed, name, "work"), lambda _: NOTHING)
    origin = around(stage, count, 1.0)
    return beams(origin, within(stage, count) - origin)


def _special(seed: int, mesh: Mesh) -> Rays:
    """Draw rays for which somebody may have done without the tree, a third of each kind.

    Together, so that nobody fails who looks at a ray's limits later than the given box test
    does: that costs little on average, and testing all faces for one kind a lot.
    """
    stage = stage_for(mesh, generator(seed, "work", "special rays"), lambda _: NOTHING)
    count = SPECIAL_RAYS
    axis = np.eye(3)[stage.rng.integers(3, size=count)]
    axis *= stage.rng.choice([-1, 1], (count, 1))
    parallel = beams(within(stage, count) - 2 * stage.radius * axis, axis)
    start = within(stage, count)
    t_min = stage.rng.choice([0.0, 0.05], count)
    between = beams(start, within(stage, count) - start, t_min, t_max=1.0)
    return joined([from_inside(stage, count), parallel, between])
