"""What is left of a trial if only some faces and some rays are kept?

Trees and answers are those of the smaller mesh: the tree is the model solution's, in the form
that the trial gave its tree, and the answers are the oracle's.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TypeVar

import numpy as np

from grader.model.cases import HitCase, ImageCase
from grader.model.mesh import Bvh, Hits, Integers, Mesh
from grader.model.trials import (
    AlteredTrial,
    ConstructTrial,
    ImageTrial,
    RebuildTrial,
    RepeatTrial,
    TraceTrial,
    Trial,
    WorkTrial,
)
from grader.oracle.altered import altered_trials
from grader.oracle.balanced import balanced_tree
from grader.oracle.brute import answers, chosen
from grader.oracle.costs import plain_costs
from grader.oracle.forms import other_form
from grader.oracle.tracing import answers_of

Trees = Callable[[Sequence[Mesh]], Sequence[Bvh]]
Tracing = TraceTrial | AlteredTrial | WorkTrial | ImageTrial
TracingT = TypeVar("TracingT", bound=Tracing)

SMALLEST_ALTERED = 5
"""Faces below which a tree has one leaf, and none that could be replaced by another."""


def cut_mesh(mesh: Mesh, faces: Integers) -> Mesh:
    """Keep some faces, (K,) int64, and the vertices that they use."""
    used, place = np.unique(mesh.faces[faces], return_inverse=True)
    return Mesh(mesh.vertices[used], place.reshape(-1, 3).astype(np.uint32))


def has_own_tree(trial: Trial) -> bool:
    """Tell whether a trial is about its tree, which no smaller mesh has."""
    return trial.name.startswith("spines")


def mesh_name(trial: Trial) -> str:
    """Name of the mesh that a trial was drawn on."""
    return trial.name.partition(",")[0]


def cut_construct(trial: ConstructTrial, subsets: Sequence[Integers]) -> list[ConstructTrial]:
    """Keep some faces of a trial of part a, once for each subset, (K,) int64."""
    return [replace(trial, mesh=cut_mesh(trial.mesh, faces)) for faces in subsets]


def cut_faces(trial: Tracing, subsets: Sequence[Integers], trees: Trees) -> list[Tracing]:
    """Keep some faces of a trial of part b, once for each subset, (K,) int64.

    Subsets of too few faces for the trial are left out.
    """
    least = SMALLEST_ALTERED if isinstance(trial, AlteredTrial) else 1
    subsets = [one for one in subsets if one.size >= least]
    meshes = [cut_mesh(trial.mesh, faces) for faces in subsets]
    built = [other_form(mesh_name(trial), tree) for tree in trees(meshes)]
    pairs = zip(meshes, built, strict=True)
    return [one for mesh, tree in pairs for one in _moved(trial, mesh, tree)]


def _moved(trial: Tracing, mesh: Mesh, tree: Bvh) -> Sequence[Tracing]:
    """Ask the same of a smaller mesh, if that makes sense."""
    if isinstance(trial, AlteredTrial):
        smaller = altered_trials(0, trial.name, mesh, tree)[:1]
        return [replace(one, sound=None) for one in smaller]
    if isinstance(trial, WorkTrial):
        boxes, triangles = plain_costs(tree, trial.rays)
        return [replace(trial, mesh=mesh, tree=tree, box_tests=boxes, triangle_tests=triangles)]
    found = answers(mesh, trial.rays, balanced_tree(mesh))
    if isinstance(trial, ImageTrial):
        t = found.limit.astype(np.float32)
        return [replace(trial, mesh=mesh, tree=tree, answers=found, mitsuba_t=t)]
    return [replace(trial, mesh=mesh, tree=tree, answers=found)]


def cut_rays(trial: TracingT, rays: Integers) -> TracingT:
    """Keep some rays, (K,) int64."""
    kept = chosen(trial.rays, rays)
    if isinstance(trial, WorkTrial):
        boxes, triangles = plain_costs(trial.tree, kept)
        return replace(trial, rays=kept, box_tests=boxes, triangle_tests=triangles)
    found = answers_of(trial.answers, rays)
    if isinstance(trial, AlteredTrial):
        return replace(trial, rays=kept, answers=found, lost=trial.lost[rays])
    if isinstance(trial, ImageTrial):
        t, width = trial.mitsuba_t[rays], rays.size
        return replace(trial, rays=kept, answers=found, mitsuba_t=t, width=width, height=1)
    return replace(trial, rays=kept, answers=found, family=trial.family[rays])


def cut_case(case: HitCase | ImageCase, rays: Integers) -> HitCase | ImageCase:
    """Keep some rays, (K,) int64, of what was delivered, without asking again."""
    hits = Hits(case.hits.point[rays], case.hits.t[rays], case.hits.normal[rays])
    if isinstance(case, ImageCase):
        tests = case.tests[rays]
        return replace(case, trial=cut_rays(case.trial, rays), hits=hits, tests=tests)
    return replace(case, trial=cut_rays(case.trial, rays), hits=hits)


def cut_rebuild(trial: RebuildTrial, first: Integers, second: Integers) -> RebuildTrial:
    """Keep some faces of both meshes, (K,) int64 each."""
    a, b = cut_mesh(trial.first, first), cut_mesh(trial.second, second)
    return replace(trial, first=a, second=b)


def cut_repeat(
    trial: RepeatTrial, faces: tuple[Integers, Integers], rays: Integers, trees: Trees
) -> RepeatTrial:
    """Keep some faces of both meshes and some rays, (K,) int64 each."""
    mesh, other = cut_mesh(trial.mesh, faces[0]), cut_mesh(trial.other_mesh, faces[1])
    tree, other_tree = trees([mesh, other])
    kept = chosen(trial.rays, rays)
    return replace(
        trial,
        mesh=mesh,
        tree=tree,
        other_mesh=other,
        other_tree=other_tree,
        rays=kept,
        answers=answers(mesh, kept, balanced_tree(mesh)),
        other_answers=answers(other, kept, balanced_tree(other)),
    )
