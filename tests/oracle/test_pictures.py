"""What the rule of closest hits says of a stored picture, of right and of wrong copies."""

from dataclasses import replace

import numpy as np
import pytest

from grader.errors import OracleFault
from grader.model.cases import ImageCase
from grader.model.mesh import Bvh, Floats, Hits, Mesh, Rays
from grader.model.scene import Reference
from grader.model.trials import ImageTrial
from grader.oracle.brute import answers
from grader.oracle.pictures import require_agreement
from grader.oracle.scenes import load_mesh, load_reference, scene_named
from grader.verify.closest import judge
from grader.verify.images import picture_equals_mitsubas

STEP = 211
"""Every 211th pixel of a picture: a prime, so that all columns are met."""


def flat_tree(mesh: Mesh) -> Bvh:
    """Return a tree that is one leaf; the search takes any tree."""
    faces = np.uint32(len(mesh.faces))
    return Bvh(
        low=mesh.vertices.min(axis=0, keepdims=True),
        high=mesh.vertices.max(axis=0, keepdims=True),
        begin=np.zeros(1, dtype=np.uint32),
        end=np.array([faces], dtype=np.uint32),
        order=np.arange(faces, dtype=np.uint32),
        node_count=1,
    )


def plane_test_t(mesh: Mesh, rays: Rays) -> Floats:
    """Return (R,) float32, the closest hit by the exercise's own triangle test in float32."""
    a, b, c = (mesh.vertices[mesh.faces[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    t = np.full(len(rays.origin), np.inf, dtype=np.float32)
    for k, (origin, direction) in enumerate(zip(rays.origin, rays.direction, strict=True)):
        with np.errstate(divide="ignore", invalid="ignore"):
            there = ((a - origin) * normal).sum(axis=1) / (normal @ direction)
            point = origin + there[:, None] * direction
            inside = (there > rays.t_min[k]) & (there < rays.t_max[k])
            for start, stop in ((a, b), (b, c), (c, a)):
                inside &= (np.cross(stop - start, point - start) * normal).sum(axis=1) >= 0
        t[k] = np.min(there[inside], initial=np.inf)
    return t


def thinned(picture: Reference) -> Reference:
    """Return every 211th pixel of a picture."""
    rays = picture.rays
    return replace(
        picture,
        rays=Rays(
            origin=rays.origin[::STEP],
            direction=rays.direction[::STEP],
            t_min=rays.t_min[::STEP],
            t_max=rays.t_max[::STEP],
        ),
        t=picture.t[::STEP],
    )


@pytest.fixture(scope="module")
def nested() -> ImageTrial:
    """Judge a part of the nested spheres by the rule."""
    mesh = load_mesh("nested")
    tree = flat_tree(mesh)
    picture = thinned(load_reference(scene_named("nested"), mesh))
    return ImageTrial(
        name="nested",
        mesh=mesh,
        tree=tree,
        width=256,
        height=256,
        rays=picture.rays,
        answers=answers(mesh, picture.rays, tree),
        mitsuba_t=picture.t,
    )


def claim(trial: ImageTrial, t: Floats) -> ImageCase:
    """Claim distances for the pixels of a picture."""
    none = np.zeros((t.size, 3), dtype=np.float32)
    untold = np.zeros((t.size, 2), dtype=np.uint32)
    return ImageCase(trial.name, trial, Hits(point=none, t=t, normal=none), untold)


def test_the_exercises_own_test_sees_mitsubas_picture(nested: ImageTrial) -> None:
    """Float32 by brute force is right in every pixel."""
    evidence = picture_equals_mitsubas.decide(
        claim(nested, plane_test_t(nested.mesh, nested.rays))
    )
    assert evidence.examined > 300
    assert evidence.wrong == 0, evidence.examples


def test_mitsuba_itself_is_right(nested: ImageTrial) -> None:
    """The stored distances agree with the rule, so nothing is refused."""
    require_agreement("nested", nested.answers, nested.mitsuba_t)
    assert not judge(nested.answers, nested.mitsuba_t).missed_closer.any()


def test_one_hole_in_the_picture_is_caught(nested: ImageTrial) -> None:
    """One pixel that looks through the outer sphere is below the witness's tolerance."""
    t = nested.mitsuba_t.copy()
    t[np.flatnonzero(np.isfinite(t))[100]] = np.inf
    assert picture_equals_mitsubas.decide(claim(nested, t)).wrong == 1


def test_a_picture_that_contradicts_the_rule_is_our_fault(nested: ImageTrial) -> None:
    """Four clear pixels are forgiven, and are not forgiven to be five."""
    clear = np.flatnonzero(np.isfinite(nested.mitsuba_t) & (np.diff(nested.answers.first) == 1))
    for other in (np.inf, 0.5, 100.0):
        t = nested.mitsuba_t.copy()
        t[clear[:4]] = other
        require_agreement("nested", nested.answers, t)
        t[clear[4]] = other
        with pytest.raises(OracleFault, match="contradicts the rule"):
            require_agreement("nested", nested.answers, t)
