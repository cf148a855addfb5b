"""What are the rays and answers of one mesh? Drawn and answered."""

from collections.abc import Sequence

import numpy as np

from grader.model.mesh import Answers, Bvh, Integers, Mesh
from grader.model.trials import ImageTrial, TraceTrial
from grader.oracle.brute import NOTHING, answers, chosen, nearest
from grader.oracle.rays import Request, families_of, rays_on

DEEPEST_STEP = 701
"""One of so many pixels, not in line with the picture's rows."""

KIND = {False: "ordinary rays", True: "special rays"}


def traced(request: Request, mesh: Mesh, tree: Bvh) -> TraceTrial:
    """Make the trial of one mesh and one kind of rays."""
    family = rays_on(request, mesh, tree)
    return TraceTrial(
        name=f"{request.mesh}, {KIND[request.special]}",
        mesh=mesh,
        tree=tree,
        rays=family.rays,
        answers=answers(mesh, family.rays, tree),
        families=families_of(request, mesh),
        family=family.index,
        special=request.special,
    )


def sample(trial: TraceTrial, step: int, name: str) -> TraceTrial:
    """Return every `step`-th ray as a trial of the sanitized build."""
    kept = np.arange(0, trial.family.size, step)
    return TraceTrial(
        name=name,
        mesh=trial.mesh,
        tree=trial.tree,
        rays=chosen(trial.rays, kept),
        answers=answers_of(trial.answers, kept),
        families=trial.families,
        family=trial.family[kept],
        special=trial.special,
        sanitized=True,
    )


def deepest_tree(pictures: Sequence[ImageTrial]) -> list[TraceTrial]:
    """Lay out some pixels of the largest picture for the sanitized build: the deepest tree."""
    if not pictures:
        return []
    picture = max(pictures, key=lambda each: len(each.mesh.faces))
    rays = chosen(picture.rays, np.arange(0, len(picture.rays.t_min), DEEPEST_STEP))
    count = len(rays.t_min)
    trial = TraceTrial(
        name=f"{picture.name}, sanitized",
        mesh=picture.mesh,
        tree=picture.tree,
        rays=rays,
        # A sanitized worker is judged by how it ends, so nobody asks what it should have hit.
        answers=nearest(NOTHING, count),
        families=("pixels",),
        family=np.zeros(count, dtype=np.int64),
        special=False,
        sanitized=True,
    )
    return [trial]


def answers_of(given: Answers, kept: Integers) -> Answers:
    """Return the answers of (K,) int64 rays."""
    counts = np.diff(given.first)[kept]
    place = np.repeat(given.first[kept] - np.cumsum(counts) + counts, counts)
    place = place + np.arange(place.size)
    return Answers(
        limit=given.limit[kept],
        first=np.concatenate([[0], np.cumsum(counts)]),
        face=given.face[place],
        t=given.t[place],
        tolerance=given.tolerance[place],
        kind=given.kind[place],
    )
