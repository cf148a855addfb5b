"""How does the content of a file become the trial that it was written from?"""

import numpy as np

from grader.counterexample.reading import Content
from grader.model.mesh import Answers, Bvh, Mask, Mesh, Rays
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
from grader.oracle.balanced import balanced_tree
from grader.oracle.brute import answers
from grader.oracle.costs import given_box_test, plain_costs
from grader.oracle.hierarchy import leaves_of, traverse
from grader.verify.closest import closest_sure


def trial_of(given: Content) -> Trial:
    """Make the trial, with answers that are computed now."""
    with np.errstate(all="ignore"):
        # A stranger's numbers may be as large as they like; then nothing is hit.
        return _made(given)


def _made(given: Content) -> Trial:
    name, mesh = given.name, given.meshes[0]
    if given.kind == "construct":
        return ConstructTrial(name, mesh, given.sanitized, given.full_levels)
    if given.kind == "rebuild":
        return RebuildTrial(name, mesh, given.meshes[1], given.sanitized)
    rays, tree = given.rays, given.trees[0]
    if given.kind == "work":
        return WorkTrial(name, mesh, tree, rays, *plain_costs(tree, rays), given.special)
    found = _answers(mesh, rays)
    if given.kind == "repeat":
        other, other_tree = given.meshes[1], given.trees[1]
        both = (found, _answers(other, rays))
        return RepeatTrial(
            name, mesh, tree, other, other_tree, rays, *both, sanitized=given.sanitized
        )
    return _traced(given, mesh, tree, found)


def _traced(given: Content, mesh: Mesh, tree: Bvh, found: Answers) -> Trial:
    name, rays = given.name, given.rays
    if given.kind == "altered":
        lost = out_of_reach(tree, rays, found)
        return AlteredTrial(name, mesh, tree, rays, found, lost, "leaves or boxes were altered")
    if given.kind == "image":
        t = found.limit.astype(np.float32)
        return ImageTrial(name, mesh, tree, len(t), 1, rays, found, t)
    families, index = np.unique(given.families, return_inverse=True)
    return TraceTrial(
        name=name,
        mesh=mesh,
        tree=tree,
        rays=rays,
        answers=found,
        families=tuple(families.tolist()),
        family=index.astype(np.int64),
        special=given.special,
        sanitized=given.sanitized,
    )


def _answers(mesh: Mesh, rays: Rays) -> Answers:
    return answers(mesh, rays, balanced_tree(mesh))


def out_of_reach(tree: Bvh, rays: Rays, found: Answers) -> Mask:
    """Return (R,) bool, True where a plain traversal never comes to the closest sure hit."""
    nearest = np.array([closest_sure(found, ray) for ray in range(len(rays.t_min))], np.int64)
    sure = nearest >= 0
    place = np.empty_like(tree.order, np.int64)
    place[tree.order] = np.arange(len(tree.order))
    # Asked is where in the order one face stands, not for each face of each leaf: a stranger's
    # leaves may all hold all faces.
    wanted = np.full(len(nearest), -1)
    wanted[sure] = place[found.face[nearest[sure]]]
    lost: Mask = sure.copy()
    for visits in traverse(leaves_of(tree), lost.size, given_box_test(tree, rays)):
        at = wanted[visits.ray]
        holds = (tree.begin[visits.leaf] <= at) & (at < tree.end[visits.leaf])
        lost[visits.ray[holds]] = False
    return lost
