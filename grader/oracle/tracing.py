"""What are the rays and answers of one mesh? Drawn, answered and witnessed."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from grader.model.mesh import Answers, Bvh, Floats, Integers, Mesh
from grader.model.trials import ImageTrial, TraceTrial
from grader.oracle.brute import NOTHING, answers, chosen, nearest
from grader.oracle.embree import contradicted, embree_t
from grader.oracle.rays import Request, families_of, rays_on

DEEPEST_STEP = 701
"""One of so many pixels, not in line with the picture's rows."""

KIND = {False: "ordinary rays", True: "special rays"}


@dataclass(frozen=True, slots=True)
class Traced:
    """A trial, and what is wrong with its answers."""

    trial: TraceTrial
    fault: str
    """Empty if Embree agrees; otherwise what it contradicts."""


def traced(request: Request, mesh: Mesh, tree: Bvh) -> Traced:
    """Make the trial of one mesh and one kind of rays."""
    family = rays_on(request, mesh, tree)
    trial = TraceTrial(
        name=f"{request.mesh}, {KIND[request.special]}",
        mesh=mesh,
        tree=tree,
        rays=family.rays,
        answers=answers(mesh, family.rays, tree),
        families=families_of(request, mesh),
        family=family.index,
        special=request.special,
    )
    theirs = embree_t(mesh, family.rays)
    wrong = np.flatnonzero(contradicted(family.rays, trial.answers, theirs))
    return Traced(trial, _fault(trial, wrong, theirs[wrong]))


def _fault(trial: TraceTrial, wrong: Integers, embree: Floats) -> str:
    """Word a contradiction between the rule and Embree."""
    if wrong.size == 0:
        return ""
    ray = int(wrong[0])
    family = trial.families[trial.family[ray]]
    return (
        f"{trial.name}: the rule of closest hits and Embree contradict each other on "
        f"{wrong.size} clear rays; the first is ray {ray} ({family}), where the rule says at "
        f"most t = {trial.answers.limit[ray]:.9g} and Embree {embree[0]:.9g}"
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
    """Return the answers of some of the rays."""
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
