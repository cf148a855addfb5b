"""What is asked again and again, and may not be answered from memory?"""

from dataclasses import replace

import numpy as np

from grader.model.mesh import Bvh, Mesh, Rays
from grader.model.trials import RepeatTrial
from grader.oracle.brute import answers, chosen
from grader.oracle.tracing import answers_of
from grader.oracle.work import Trees, incoherent

REPEATED_RAYS = 5_000
"""So many that threads really run at the same time: several milliseconds."""

ALIKE = ("cloud-18", "cloud-17")
"""Two meshes whose trees have as many nodes, but not the same leaves."""

REPEATED = (("terrain-1200", "grid-10x10"), ("dragon-res4", "nested-spheres"), ALIKE)
TWIN = "cloud-37"
"""The mesh that has twins: one with its faces in another order, one reflected at its centre."""

GROWING = ("dragon-res4", "cloud-1")
"""A deep tree, and one of a single node, for which nothing of the other's size was prepared."""

SANITIZED_RAYS = 100

Scene = tuple[Mesh, Bvh]


def twins_of(mesh: Mesh) -> tuple[Mesh, Mesh]:
    """Return the same faces with reflected vertices, and the same triangles in reverse order.

    Sizes and boxes are alike, so only who looks at vertices, or at faces, sees a difference.
    """
    corners = mesh.vertices.astype(np.float64)
    # Exact at both ends: the sum of two float32 of like size fits a float64.
    reflected = corners.min(axis=0) + corners.max(axis=0) - corners
    return (
        Mesh(reflected.astype(np.float32), mesh.faces),
        Mesh(mesh.vertices, mesh.faces[::-1].copy()),
    )


def repeat_trials(
    seed: int, meshes: dict[str, Mesh], built: dict[str, Bvh], trees: Trees
) -> list[RepeatTrial]:
    """Lay out the trials that ask the same again, on the same and on another mesh.

    Args:
        seed: Of the run.
        meshes: By name.
        built: Trees over them.
        trees: Builds the reference's tree of each mesh.
    """
    twins = twins_of(meshes[TWIN])
    alike = trees([meshes[name] for name in ALIKE])
    built = {**built, **dict(zip(ALIKE, alike, strict=True))}
    pairs = [(name, "", (meshes[other], built[other])) for name, other in REPEATED]
    beside = (f" beside its {which}" for which in ("reflection", "reverse"))
    pairs += zip((TWIN, TWIN), beside, zip(twins, trees(twins), strict=True), strict=True)
    made = [
        _trial(
            f"{name}{label}, again and again",
            (meshes[name], built[name]),
            other,
            incoherent(seed, name, meshes[name], REPEATED_RAYS),
        )
        for name, label, other in pairs
    ]
    deep, first = GROWING
    growing = _trial(
        f"{deep} after {first}, sanitized",
        (meshes[deep], built[deep]),
        (meshes[first], built[first]),
        incoherent(seed, deep, meshes[deep], SANITIZED_RAYS),
    )
    return [*made, replace(growing, sanitized=True)]


def _trial(name: str, scene: Scene, other: Scene, rays: Rays) -> RepeatTrial:
    """Put a ray last that hits one of the meshes only: it tells who keeps the last answer."""
    found, theirs = (answers(mesh, rays, tree) for mesh, tree in (scene, other))
    tells = np.flatnonzero(np.isfinite(found.limit) != np.isfinite(theirs.limit))
    order = np.arange(len(rays.t_min))
    order[[-1, *tells[:1]]] = order[[*tells[:1], -1]]
    return RepeatTrial(
        name=name,
        mesh=scene[0],
        tree=scene[1],
        other_mesh=other[0],
        other_tree=other[1],
        rays=chosen(rays, order),
        answers=answers_of(found, order),
        other_answers=answers_of(theirs, order),
    )
