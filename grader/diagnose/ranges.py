"""Which mistake explains ranges, face indices, the root and the depth of a tree?"""

from collections.abc import Callable

import numpy as np

from grader.diagnose.hypothesis import NOTHING, Support, hypothesis, weighed
from grader.diagnose.readable import is_readable
from grader.model.cases import DepthCase, TreeCase
from grader.tolerances import FACES_PER_LEAF
from grader.verify.structure import ends_at_the_limit
from grader.verify.tree import shape


@hypothesis(TreeCase, "range.middle-is-a-count")
def middle_is_a_count(case: TreeCase) -> Support:
    """Half the number of faces is used as a place: the beginning of the node is not added."""
    bvh, held = case.bvh, case.bvh.end.astype(np.int64) - case.bvh.begin
    node = np.flatnonzero((held > FACES_PER_LEAF) & (2 * np.arange(len(held)) + 2 < len(held)))
    node = node[bvh.end[2 * node + 1] > 0]
    as_count = bvh.end[2 * node + 1] == held[node] // 2
    as_place = bvh.end[2 * node + 1] == bvh.begin[node] + held[node] // 2
    return weighed(np.asarray(as_count), np.asarray(as_place))


@hypothesis(TreeCase, "root.last-face-left-out")
def root_leaves_out_the_last(case: TreeCase) -> Support:
    """The root ends one face early, so the last face of the mesh is in no node."""
    faces = len(case.trial.mesh.faces)
    if not faces or not len(case.bvh.end):
        return NOTHING
    foretold = int(case.bvh.end[0]) == faces - 1
    return Support(int(foretold), int(not foretold))


@hypothesis(TreeCase, "root.box-of-one-face")
def root_box_of_one_face(case: TreeCase) -> Support:
    """The box of the root covers a single face, not the whole mesh."""
    mesh = case.trial.mesh
    if len(mesh.faces) < 2 or not len(case.bvh.end):
        return NOTHING
    corner = mesh.vertices[mesh.faces]
    low, high = corner.min(axis=1), corner.max(axis=1)
    root = (case.bvh.low[0] == low).all(axis=1) & (case.bvh.high[0] == high).all(axis=1)
    whole = bool((low.min(axis=0) == case.bvh.low[0]).all())
    whole = whole and bool((high.max(axis=0) == case.bvh.high[0]).all())
    return Support(int(root.any() and not whole), int(not root.any()))


@hypothesis(TreeCase, "root.without-a-box")
def root_without_a_box(case: TreeCase) -> Support:
    """The root never gets a box: it stays empty."""
    if not len(case.trial.mesh.faces) or not len(case.bvh.end):
        return NOTHING
    empty = bool((case.bvh.low[0] > case.bvh.high[0]).all())
    return Support(int(empty), int(not empty))


@hypothesis(TreeCase, "indices.never-filled")
def never_filled(case: TreeCase) -> Support:
    """The face indices are all 0: they are made room for, but never filled with 0, 1, 2, ..."""
    faces = len(case.trial.mesh.faces)
    if faces < 2:
        return NOTHING
    foretold = len(case.bvh.order) >= faces and not case.bvh.order.any()
    return Support(int(foretold), int(not foretold))


@hypothesis(TreeCase, "indices.one-too-many")
def one_too_many(case: TreeCase) -> Support:
    """There is one face index more than there are faces."""
    faces = len(case.trial.mesh.faces)
    foretold = len(case.bvh.order) == faces + 1
    return Support(int(foretold), int(not foretold))


@hypothesis(TreeCase, "indices.count-from-one")
def count_from_one(case: TreeCase) -> Support:
    """The face indices count from 1, as in an OBJ file, instead of from 0."""
    faces = len(case.trial.mesh.faces)
    if not faces:
        return NOTHING
    foretold = np.array_equal(np.sort(case.bvh.order), np.arange(1, faces + 1))
    return Support(int(foretold), int(not foretold))


@hypothesis(TreeCase, "indices.overwritten-at-the-split")
def overwritten(case: TreeCase) -> Support:
    """A face index beside the middle is overwritten by its neighbour when a node is split."""
    if not is_readable(case):
        return NOTHING
    form, bvh = shape(case.bvh), case.bvh
    node = form.inner[form.parted[form.inner]]
    if not node.size:
        return NOTHING
    middle = bvh.end[2 * node + 1].astype(np.int64)
    same = bvh.order[middle - 1] == bvh.order[middle]
    times = np.bincount(bvh.order, minlength=len(case.trial.mesh.faces))
    # A later split may move one of the two, so only all of them together are telling.
    missing = np.count_nonzero(times != 1)
    return Support(int(same.sum()), 0 if missing else node.size)


INDICES = (
    middle_is_a_count,
    root_leaves_out_the_last,
    root_box_of_one_face,
    root_without_a_box,
    never_filled,
    one_too_many,
    count_from_one,
    overwritten,
)


def _by_level(case: DepthCase, is_it: Callable[[int, int], bool]) -> Support:
    deepest = shape(case.bvh).depth
    foretold = not ends_at_the_limit(case) and is_it(deepest, case.max_depth)
    return Support(int(foretold), int(not foretold))


@hypothesis(DepthCase, "depth.one-too-deep")
def one_too_deep(case: DepthCase) -> Support:
    """Nodes on the deepest level that is allowed are split once more."""
    return _by_level(case, lambda deepest, limit: deepest == limit + 1)


@hypothesis(DepthCase, "depth.not-limited")
def not_limited(case: DepthCase) -> Support:
    """Nothing ends the splitting at maxDepth: nobody asks for it, or the depth never grows."""
    return _by_level(case, lambda deepest, limit: deepest > limit)


@hypothesis(DepthCase, "depth.too-early")
def too_early(case: DepthCase) -> Support:
    """Splitting ends some levels above maxDepth, though nodes there hold too many faces."""
    return _by_level(case, lambda deepest, limit: 2 < deepest < limit - 1)


RANGES = (*INDICES, one_too_deep, not_limited, too_early)
