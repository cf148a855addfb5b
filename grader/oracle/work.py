"""How much may a ray cost? Trials whose tests are counted, and whose time is taken."""

from collections.abc import Callable, Sequence
from dataclasses import replace

from grader.model.mesh import Bvh, Mesh, Rays
from grader.model.trials import WorkTrial
from grader.oracle.brute import NOTHING
from grader.oracle.bundle import around, beams, stage_for, within
from grader.oracle.costs import plain_costs
from grader.oracle.meshes import generator
from grader.oracle.ordinary import from_inside
from grader.oracle.rays import joined
from grader.oracle.scenes import load_mesh
from grader.oracle.special import along_axes

Trees = Callable[[Sequence[Mesh]], list[Bvh]]

WORK = (("dragon-res4", 10_000), ("dragon-res2", 20_000))
"""Meshes and how many rays: on 11,102 faces, too, so many that testing all of them shows in the
time, for who tests by itself is not counted."""

ODD = 1_500
"""Rays of each kind in the trial of odd rays."""

ODD_SLACK = 3.0
"""Measured: the least sharp right submission takes 4.3 times the tests of a plain traversal;
who tests all faces for a sixth of the rays takes 19 times as many."""


def work_trials(seed: int, trees: Trees) -> list[WorkTrial]:
    """Lay out the trials, on stored meshes of 11,102 and 202,520 faces.

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
    rays = _unusual(seed, meshes[0])
    odd = _work_trial(f"work on {WORK[0][0]}, odd rays", meshes[0], built[0], rays)
    return [*trials, replace(odd, slack=ODD_SLACK)]


def _work_trial(name: str, mesh: Mesh, tree: Bvh, rays: Rays) -> WorkTrial:
    boxes, triangles = plain_costs(tree, rays)
    return WorkTrial(name, mesh, tree, rays, boxes, triangles)


def incoherent(seed: int, name: str, mesh: Mesh, count: int) -> Rays:
    """Draw rays from all around to anywhere in the box of a mesh, whose name is given."""
    stage = stage_for(mesh, generator(seed, name, "work"), lambda _: NOTHING)
    origin = around(stage, count, 1.0)
    return beams(origin, within(stage, count) - origin)


def _unusual(seed: int, mesh: Mesh) -> Rays:
    """Draw rays for which somebody may have done without the tree, a third of each kind.

    Together, and with slack, so that nobody fails whose own box test is less sharp for some
    of them, or who looks at a ray's limits later: testing all faces for one kind costs more.
    """
    stage = stage_for(mesh, generator(seed, "work", "odd rays"), lambda _: NOTHING)
    start = within(stage, ODD)
    t_min = stage.rng.choice([0.0, 0.05], ODD)
    between = beams(start, within(stage, ODD) - start, t_min, t_max=1.0)
    return joined([from_inside(stage, ODD), along_axes(stage, ODD), between])
