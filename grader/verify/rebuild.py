"""Does a second call of `construct` leave anything of the first behind?"""

import numpy as np

from grader.model.cases import RebuildCase, TreeCase
from grader.model.mesh import Bvh, Mesh
from grader.model.trials import ConstructTrial
from grader.model.verdict import Evidence, Example
from grader.verify import bounds, split, structure
from grader.verify.check import check, one
from grader.verify.structure import unreadable
from grader.verify.tree import shape

TREE_CHECKS = (
    structure.root_holds_all_faces,
    structure.children_partition_their_parent,
    structure.leaves_hold_at_most_four,
    bounds.boxes_are_tight,
    split.splits_the_longest_axis,
    split.splits_at_the_median,
)
"""What a later tree must keep to, if the fresh one of its mesh did."""


@check(RebuildCase, "bvh.rebuild-starts-afresh")
def rebuild_starts_afresh(case: RebuildCase) -> Evidence:
    """A second `construct` leaves nothing of the first, and the mesh is not touched."""
    for name, given, after in case.meshes:
        if not _same_mesh(given, after):
            text = f"mesh {name} has changed, but construct may only read it"
            return one(Example(text, "the mesh as it was", "changed vertices or faces"))
    _, first, built = case.trees[0]
    second = case.trial.second
    fresh = {id(first): built, id(second): case.alone}
    known = {id(first): _flaws(first, built), id(second): _flaws(second, case.alone)}
    for label, mesh, bvh in case.trees[1:]:
        key = id(mesh)
        sound = not known[key] and not unreadable(mesh, fresh[key])
        difference = _difference(mesh, fresh[key], bvh, sound) or _new_flaw(
            mesh, bvh, known[key]
        )
        if difference:
            wanted = "the tree that the first call builds"
            return one(Example(f"{label}: {difference}", wanted, difference))
    return one(None)


def _same_mesh(a: Mesh, b: Mesh) -> bool:
    return np.array_equal(a.vertices.view(np.uint32), b.vertices.view(np.uint32)) and (
        np.array_equal(a.faces, b.faces)
    )


def _difference(mesh: Mesh, fresh: Bvh, later: Bvh, sound: bool) -> str:
    """Say how a later tree differs from a fresh one, `` if only the order of ties does.

    Nor does it matter on which side an odd face is, if the fresh one is `sound`: then whatever
    is wrong with the later one is a flaw.
    """
    flaw = unreadable(mesh, later)
    if flaw and not unreadable(mesh, fresh):
        return flaw.message
    if not np.array_equal(np.sort(later.order), np.sort(fresh.order)):
        return "faceIndices does not hold the same faces as in a new tree"
    if sound:
        return ""
    mine, yours = shape(later), shape(fresh)
    if not np.array_equal(mine.reached, yours.reached):
        return (
            f"{mine.reached.size:,} nodes are in use, but {yours.reached.size:,} in a new tree"
        )
    used = mine.reached
    if (later.begin[used] != fresh.begin[used]).any() or (
        later.end[used] != fresh.end[used]
    ).any():
        return "the nodes' ranges are not those of a new tree"
    return ""


def _new_flaw(mesh: Mesh, bvh: Bvh, known: set[str]) -> str:
    """Word the first mistake of a later tree that a fresh tree of its mesh does not have."""
    for each, evidence in _judged(mesh, bvh):
        if evidence.wrong and each not in known:
            return evidence.examples[0].message
    return ""


def _flaws(mesh: Mesh, bvh: Bvh) -> set[str]:
    return {each for each, evidence in _judged(mesh, bvh) if evidence.wrong}


def _judged(mesh: Mesh, bvh: Bvh) -> list[tuple[str, Evidence]]:
    if unreadable(mesh, bvh):
        return []
    case = TreeCase("rebuilt", ConstructTrial("rebuilt", mesh), bvh)
    return [(each.id, each.decide(case)) for each in TREE_CHECKS if each.when(case.trial)]
