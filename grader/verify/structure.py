"""Is the tree readable, complete and rightly shaped?"""

import numpy as np

from grader.model.cases import DepthCase, SurvivalCase, TreeCase
from grader.model.mesh import Bvh, Mesh
from grader.model.stages import Stop
from grader.model.trials import ConstructTrial, Trial, part_of
from grader.model.verdict import Evidence, Example
from grader.tolerances import FACES_PER_LEAF, NODE_CAPACITY, depth_limit
from grader.verify.check import check, judged, one, vector
from grader.verify.tree import shape

READABLE = ("bvh.is-readable",)


def has_faces(trial: ConstructTrial) -> bool:
    """Tell whether there is anything to put into a node."""
    return len(trial.mesh.faces) > 0


def needs_a_split(trial: ConstructTrial) -> bool:
    """Tell whether the root of every right tree has children."""
    allowed = 2 * FACES_PER_LEAF + 1 if trial.full_levels else FACES_PER_LEAF
    return len(trial.mesh.faces) > allowed


def calls_construct(trial: Trial) -> bool:
    """Tell whether a trial is one of part a."""
    return part_of(trial) == "a"


@check(TreeCase, "bvh.is-readable")
def is_readable(case: TreeCase) -> Evidence:
    """The nodes' ranges and the face indices lie within the mesh."""
    return one(unreadable(case.trial.mesh, case.bvh))


def unreadable(mesh: Mesh, bvh: Bvh) -> Example | None:
    """Say what makes a tree unreadable, or None."""
    faces = len(mesh.faces)
    if faces and not len(bvh.end):
        return Example("there are no nodes at all", "a root node at index 0", "0 nodes")
    if bvh.node_count > NODE_CAPACITY:
        most = f"at most {NODE_CAPACITY:,} nodes"
        text = (
            f"there are {bvh.node_count:,} nodes, but {most} are read; "
            "depth 20 has room for 2,097,151"
        )
        return Example(text, most, f"{bvh.node_count:,} nodes")
    if len(bvh.order) < faces:
        text = f"faceIndices has {len(bvh.order):,} entries, but the mesh has {faces:,} faces"
        return Example(text, f"{faces:,} entries", f"{len(bvh.order):,} entries")
    used = shape(bvh).reached
    begin, end = bvh.begin[used], bvh.end[used]
    if (bad := np.flatnonzero((end > faces) | (begin > end))).size:
        k = int(bad[0])
        return Example(
            f"node {used[k]}: its range is [{begin[k]}, {end[k]}), but the mesh has "
            f"{faces:,} faces",
            f"0 <= facesBegin <= facesEnd <= {faces}",
            f"[{begin[k]}, {end[k]})",
        )
    if (bad := np.flatnonzero(bvh.order[:faces] >= faces)).size:
        k = int(bad[0])
        text = f"faceIndices[{k}] is {bvh.order[k]}, but the last face is {faces - 1}"
        return Example(text, f"at most {faces - 1}", str(bvh.order[k]))
    return None


@check(TreeCase, "bvh.root-holds-all-faces", needs=READABLE)
def root_holds_all_faces(case: TreeCase) -> Evidence:
    """Node 0 holds all faces and has the mesh's box."""
    mesh, bvh = case.trial.mesh, case.bvh
    faces = len(mesh.faces)
    if not faces:
        held = not len(bvh.end) or bvh.begin[0] == bvh.end[0]
        return one(None if held else Example("node 0 holds faces of an empty mesh"))
    # Along rows, which is five times as fast.
    columns = np.ascontiguousarray(mesh.vertices.T)
    low, high = columns.min(axis=1), columns.max(axis=1)
    if (bvh.begin[0], bvh.end[0]) != (0, faces):
        got = f"[{bvh.begin[0]}, {bvh.end[0]})"
        text = f"node 0: its range is {got}, but it must hold all {faces:,} faces"
        return one(Example(text, f"[0, {faces})", got))
    if (bvh.low[0] != low).any() or (bvh.high[0] != high).any():
        got = f"{vector(bvh.low[0])} to {vector(bvh.high[0])}"
        wanted = f"{vector(low)} to {vector(high)}"
        return one(Example(f"node 0: box is {got}, but the mesh spans {wanted}", wanted, got))
    return one(None)


@check(TreeCase, "bvh.face-indices-are-a-permutation", needs=READABLE)
def face_indices_are_a_permutation(case: TreeCase) -> Evidence:
    """`faceIndices` holds every face of the mesh exactly once."""
    faces = len(case.trial.mesh.faces)
    if len(case.bvh.order) > faces:
        text = f"faceIndices has more than {faces:,} entries, but the mesh has {faces:,} faces"
        return one(Example(text, f"{faces:,} entries", f"at least {faces + 1:,}"))
    times = np.bincount(case.bvh.order, minlength=faces) if faces else np.ones(1, np.int64)
    return judged(
        times != 1,
        lambda face: Example(
            f"face {face} is in faceIndices {times[face]} times, but it must be there once",
            "once",
            f"{times[face]} times",
        ),
    )


@check(TreeCase, "bvh.children-partition-their-parent", needs=READABLE, when=needs_a_split)
def children_partition_their_parent(case: TreeCase) -> Evidence:
    """The nodes 2i+1 and 2i+2 share out the faces of node i, and nothing is lost or doubled."""
    bvh, form = case.bvh, shape(case.bvh)

    def describe(k: int) -> Example:
        node = int(form.inner[k])
        parent = f"[{bvh.begin[node]}, {bvh.end[node]})"
        got = " and ".join(_range(bvh, child) for child in (2 * node + 1, 2 * node + 2))
        return Example(
            f"node {node} holds {parent}, but its children {2 * node + 1} and "
            f"{2 * node + 2} hold {got}",
            f"two halves that make up {parent}",
            got,
        )

    wrong = ~form.parted[form.inner]
    return judged(wrong, describe)


def _range(bvh: Bvh, node: int) -> str:
    if node >= len(bvh.end):
        return "nothing (no such node)"
    return f"[{bvh.begin[node]}, {bvh.end[node]})"


@check(TreeCase, "bvh.leaves-hold-at-most-four", needs=READABLE, when=has_faces)
def leaves_hold_at_most_four(case: TreeCase) -> Evidence:
    """A node is split if and only if it holds more than four faces.

    Nodes on the last level that the depth limit allows are not split either.
    """
    bvh, form = case.bvh, shape(case.bvh)
    if case.trial.full_levels and _stops_at_a_full_level(case):
        return one(None)
    held = bvh.end[form.reached].astype(np.int64) - bvh.begin[form.reached]
    split = np.isin(form.reached, form.inner, assume_unique=True)
    wrong = split != (held > FACES_PER_LEAF)
    limit = depth_limit(case.trial.sanitized)
    if limit - 1 <= form.depth <= limit:
        # Level k begins with node 2^k - 1.
        wrong &= form.reached < (1 << form.depth) - 1

    def describe(k: int) -> Example:
        node, done = int(form.reached[k]), "is split" if split[k] else "is a leaf"
        rule = "at most 4 are not split" if split[k] else "more than 4 are split"
        return Example(
            f"node {node} holds {held[k]:,} faces and {done}, but nodes of {rule}",
            f"a leaf of at most {FACES_PER_LEAF} faces",
            f"node {node} with {held[k]:,} faces {done}",
        )

    return judged(wrong, describe)


def _stops_at_a_full_level(case: TreeCase) -> bool:
    """Tell whether all leaves lie on one level, the last on which every node is that large.

    Source: the rubric's reading `full-levels`; a node that could still be split in two leaves
    of four holds at most nine faces.
    """
    bvh, form = case.bvh, shape(case.bvh)
    held = bvh.end.astype(np.int64) - bvh.begin
    one_level = form.leaves.size == 2**form.depth
    small_leaves = held[form.leaves].max(initial=0) <= 2 * FACES_PER_LEAF + 1
    needed = held[form.inner].min(initial=FACES_PER_LEAF + 1) > FACES_PER_LEAF
    return bool(one_level and small_leaves and needed)


@check(DepthCase, "bvh.depth-is-limited")
def depth_is_limited(case: DepthCase) -> Evidence:
    """Splitting goes on down to `maxDepth` and stops there."""
    if ends_at_the_limit(case):
        return one(_unsplit(case))
    depth = shape(case.bvh).depth
    text = (
        f"the deepest node is on level {depth}, but with {len(case.trial.mesh.faces):,} faces "
        f"it must be on level {case.max_depth - 1} or {case.max_depth}"
    )
    return one(Example(text, f"level {case.max_depth}", f"level {depth}"))


def _unsplit(case: DepthCase) -> Example | None:
    """Word a large leaf above the last level; no other check looks at trees of this size."""
    if case.trial.sanitized:
        return None
    form = shape(case.bvh)
    above = form.leaves[form.leaves < (1 << form.depth) - 1]
    held = case.bvh.end[above].astype(np.int64) - case.bvh.begin[above]
    large = np.flatnonzero(held > FACES_PER_LEAF)
    if not large.size:
        return None
    node, faces = int(above[large[0]]), int(held[large[0]])
    return Example(
        f"node {node} holds {faces:,} faces and is not split, though others are split down to "
        f"level {form.depth}",
        "every large node above the last level is split",
        f"node {node} with {faces:,} faces is a leaf",
    )


def ends_at_the_limit(case: DepthCase) -> bool:
    """Tell whether the deepest level is the last allowed one, the root being level 0 or 1."""
    return case.max_depth - 1 <= deepest_level(case) <= case.max_depth


def deepest_level(case: DepthCase) -> int:
    """Return the level of the deepest node, the root being level 0."""
    return shape(case.bvh).depth


@check(SurvivalCase, "bvh.survives-every-mesh", when=calls_construct)
def survives_every_mesh(case: SurvivalCase) -> Evidence:
    """`construct` comes back from every mesh: no crash, no time-out, no exhausted memory."""
    return survived(case)


def survived(case: SurvivalCase) -> Evidence:
    """Judge the end of one worker."""
    ending = case.ending
    if ending.stop is Stop.FINISHED:
        return one(None)
    example = Example(ending.detail, "it returns", ending.detail)
    return Evidence(1, 1, (example,), ending.stop, ending.line)
