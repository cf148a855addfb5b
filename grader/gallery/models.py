"""Which meshes, trees and rays of a grade can be turned in three dimensions?

First the small inputs that fail a check, in the order of the checks; then one scene, with the
submission's own tree over it and the first pixel that it got wrong.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from grader.counterexample.describe import explanation
from grader.counterexample.explain import Setting
from grader.counterexample.shown import (
    MOST_BOXES,
    boxes,
    faces_of,
    loose_node,
    right_box,
    with_ray,
)
from grader.gallery.coarse import coarsened
from grader.gallery.hung import Exhibit, Hung, key_of
from grader.model.cases import ImageCase
from grader.model.grade import Grade
from grader.model.mesh import Bvh, Integers, Mesh
from grader.model.verdict import Verdict
from grader.model.views import Model, ShownRay
from grader.oracle.remember import remember
from grader.run.job import Job
from grader.run.session import Allowance, Engine, run_job
from grader.run.transfer import on_tree, record
from grader.verify.images import wrong_pixels

MOST_FACES = 20_000
"""Faces of a scene's mesh that a report carries: about 120 kB."""


Loose = tuple[int, tuple[float, ...], Integers]
"""A node whose box is not right, its right box, and its faces."""

NOTHING_LOOSE: Loose = (-1, (), np.zeros(0, np.int64))


def models(
    grade: Grade, exhibits: Sequence[Exhibit], engine: Engine, allowed: Allowance
) -> tuple[Model, ...]:
    """Collect what can be turned.

    Args:
        grade: Its failed checks bring their counterexamples.
        exhibits: The scenes, with what the submission delivered.
        engine: Records the path of a ray.
        allowed: How long that may take.
    """
    found = [score.counterexample for score in grade.checks if score.counterexample]
    small = [one.model for one in found if one.model is not None]
    if not exhibits:
        return tuple(small)
    chosen = max(exhibits, key=_telling)
    # To see that every box of a right tree is right takes as long as the check itself.
    doubtful = any(one.part == "a" and one.verdict is not Verdict.PASS for one in grade.checks)
    ray = None if chosen.seen is None else _wrong_ray(chosen.seen, engine, allowed)
    return (*small, _scene(chosen, doubtful, ray))


def _telling(one: Exhibit) -> tuple[float, int]:
    """Order scenes: first the one with most of its pixels wrong, then the one of most faces."""
    share = 0.0 if one.seen is None else float(wrong_pixels(one.seen).mean())
    return share, len(one.trial.mesh.faces)


def _scene(one: Exhibit, doubtful: bool, ray: ShownRay | None) -> Model:
    """Show a scene with the submission's tree, or with ours if it has none."""
    built, trial = one.built, one.trial
    mesh, tree = (trial.mesh, trial.tree) if built is None else (built.trial.mesh, built.bvh)
    small, kept = _coarse(one.place, mesh)
    looked = built is not None and doubtful
    node, box, marked = _loose(mesh, tree) if looked else NOTHING_LOOSE
    return Model(
        check="",
        title=one.place.scene.title,
        mesh=small,
        faces=len(mesh.faces),
        low=boxes(tree)[0],
        high=boxes(tree)[1],
        node=node,
        right_box=box,
        marked=np.flatnonzero(np.isin(kept, marked)),
        ray=ray,
    )


def _coarse(place: Hung, mesh: Mesh) -> tuple[Mesh, Integers]:
    """Coarsen a mesh once for all submissions; the order of faces is part of it."""
    key = key_of(place, "coarse", MOST_FACES, mesh.faces)
    small, kept = remember(key, lambda: coarsened(mesh, MOST_FACES))
    return small, kept


def _loose(mesh: Mesh, tree: Bvh) -> Loose:
    """Return the first node whose box is not right, its right box and its faces."""
    node = loose_node(mesh, tree)
    if not 0 <= node < MOST_BOXES:
        return NOTHING_LOOSE
    return node, right_box(mesh, tree, node), faces_of(mesh, tree, node)


def _wrong_ray(case: ImageCase, engine: Engine, allowed: Allowance) -> ShownRay | None:
    """Record the way of the first wrong pixel's ray; None if every pixel is right."""
    wrong = np.flatnonzero(wrong_pixels(case))
    if not wrong.size:
        return None
    job, pixel = Job(), int(wrong[0])
    trial = case.trial
    read = record(job, on_tree(job, trial.mesh, trial.tree), trial.rays, pixel)
    _, result = run_job(job, engine, allowed)
    if result is None:
        return None
    setting = Setting(trial.mesh, trial.tree, read(result))
    found = explanation(setting, trial, pixel)
    shown = with_ray("", setting, trial, pixel, found).ray
    return None if shown is None else replace(shown, face=-1)
