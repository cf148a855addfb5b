"""Where in the tree was a hit lost, or where does a hit come from that is not there?

Theory of operation. The face that should have been hit lies in one leaf; on the way from the
root to it something went wrong. The recorded tests tell how far the ray came: a node was
entered if its own box was tested and hit, or if anything below it was tested. The first node
of the way that was not entered is where the hit was lost. All of it is the submission's word,
and a submission with tests of its own tells nothing; then only the way is told.
"""

from dataclasses import dataclass

import numpy as np

from grader.model.mesh import Bvh, Floats, Indices, Integers, Mask, Mesh
from grader.model.path import NO_NODE, Path

FAR = np.float32(1e-3)
"""Two distances are told apart from here on, relative to the larger one."""


@dataclass(frozen=True, slots=True)
class Explanation:
    """Why a ray has a wrong result, in a sentence, and the node that it is about."""

    text: str
    node: int = -1
    """-1 if it is about none."""


@dataclass(frozen=True, slots=True, eq=False)
class Setting:
    """A tree, and what one ray tested in it."""

    mesh: Mesh
    tree: Bvh
    path: Path

    @property
    def is_cut(self) -> bool:
        """Whether more was tested than recorded: then a missing test proves nothing."""
        return self.path.total > len(self.path.hit)

    def nodes(self) -> Integers:
        """(S,) int64, the node of each box test; -1 where it is no node's box.

        A box that was copied is recognised by its corners; of several equal ones the first.
        """
        known = self.path.node.astype(np.int64)
        copied = np.flatnonzero(self.path.is_box & (self.path.node == NO_NODE))
        if copied.size:
            known[copied] = _first_alike(self.tree, self.path.corners[copied, :6])
        known[~self.path.is_box | (known >= len(self.tree.end))] = -1
        return known

    def tests_of(self, face: int) -> Integers:
        """(K,) int64, the steps that tested a face, in whatever order of its corners."""
        wanted = self.mesh.vertices[self.mesh.faces[face]]
        given = self.path.corners.reshape(-1, 3, 3)
        turned = [np.roll(wanted, turn, axis=0) for turn in range(3)]
        turned += [one[::-1] for one in turned]
        same = np.any([(given == one).all(axis=(1, 2)) for one in turned], axis=0)
        return np.flatnonzero(same & ~self.path.is_box)


def way_to(tree: Bvh, face: int) -> list[int]:
    """Nodes from the root to the leaf that holds a face; empty if no leaf in reach does."""
    count = len(tree.end)
    waiting = [[0]] if count else []
    while waiting:
        way = waiting.pop()
        node = way[-1]
        if face not in tree.order[tree.begin[node] : tree.end[node]].tolist():
            continue
        children = [child for child in (2 * node + 1, 2 * node + 2) if child < count]
        if not children or not all(tree.end[child] for child in children):
            return way
        waiting += [[*way, child] for child in children]
    return []


def lost_hit(setting: Setting, face: int, t: float) -> Explanation:
    """Say where the hit on a face was lost.

    Args:
        setting: The tree and the recorded path.
        face: Face that should have been hit.
        t: Where.
    """
    way = way_to(setting.tree, face)
    if not way:
        return Explanation(f"face {face} is in no leaf of this tree")
    if not setting.path.total:
        nodes = " -> ".join(map(str, way))
        return Explanation(
            f"face {face} is in leaf {way[-1]}, on the way {nodes}; neither of the given tests "
            "was called, so nobody saw where the ray went",
            way[-1],
        )
    tests = setting.tests_of(face)
    if tests.size:
        # Whoever tests a face again, with the ray that its hit has shortened, has hit it.
        hits = tests[setting.path.hit[tests]]
        return _tested(setting, face, int((hits if hits.size else tests)[-1]), way[-1])
    if setting.is_cut:
        return Explanation(
            f"only the first {len(setting.path.hit)} of {setting.path.total} tests were "
            f"recorded, and none of them is of face {face}, which is in leaf {way[-1]}"
        )
    return _not_tested(setting, face, t, way)


def _tested(setting: Setting, face: int, step: int, leaf: int) -> Explanation:
    """The face was tested, and yet it is not the result."""
    path = setting.path
    if not path.hit[step]:
        limits = f"t in ({path.t_min[step]:.9g}, {path.t_max[step]:.9g})"
        text = f"face {face} was tested in leaf {leaf}, but with {limits}, and was not hit"
        return Explanation(text, leaf)
    t = path.t[step]
    others = np.flatnonzero(~path.is_box & path.hit & _apart(path.t, t))
    same = others[~_apart(path.t[others], np.float32(path.found))]
    hit = f"face {face} was hit at t = {t:.9g}"
    if same.size and same[-1] > step:
        text = f"{hit}, but was then overwritten by a hit at t = {path.found:.9g}"
    elif same.size:
        text = f"{hit}, but the hit at t = {path.found:.9g} from before was kept"
    else:
        text = f"{hit}, but that hit was not returned"
    return Explanation(f"{text} (leaf {leaf})", leaf)


def _apart(t: Floats, other: np.float32) -> Mask:
    with np.errstate(invalid="ignore", over="ignore"):
        near = np.abs(t - other) <= FAR * np.maximum(np.abs(t), np.abs(other))
    return np.asarray(~near & (t != other))


def _not_tested(setting: Setting, face: int, t: float, way: list[int]) -> Explanation:
    """The ray did not come as far as the face."""
    nodes, path = setting.nodes(), setting.path
    entered = [node for node in way if _is_entered(setting, nodes, node)]
    last = entered[-1] if entered else -1
    if last == way[-1]:
        return Explanation(
            f"leaf {last} was entered, but face {face}, which is in it, was not tested there",
            last,
        )
    node = way[way.index(last) + 1] if entered else way[0]
    tests = np.flatnonzero(nodes == node)
    if tests.size:
        limit = path.t_max[tests[0]]
        reason = f"tested with t_max = {limit:.9g}" if limit < t else "not hit"
        return Explanation(
            f"node {node}, on the way to face {face}: its box was {reason}, so it was not "
            f"entered, but face {face} is hit at t = {t:.9g}",
            node,
        )
    before = f" after node {last}" if entered else ""
    text = f"node {node}, on the way to face {face}, was never visited{before}"
    return Explanation(text, node)


def _is_entered(setting: Setting, nodes: Integers, node: int) -> bool:
    """Tell whether a node's box was hit, or anything below it was tested."""
    if (setting.path.hit & (nodes == node)).any():
        return True
    below = nodes[nodes > node]
    while below.size:
        if (below == node).any():
            return True
        below = (below[below > node] - 1) // 2
    held = setting.tree.order[setting.tree.begin[node] : setting.tree.end[node]]
    leaf = 2 * node + 1 >= len(setting.tree.end) or not setting.tree.end[2 * node + 1]
    return bool(leaf and any(setting.tests_of(int(face)).size for face in held))


def false_hit(setting: Setting) -> Explanation:
    """Say where a hit comes from that is not there."""
    path = setting.path
    found = np.float32(path.found)
    hits = np.flatnonzero(~path.is_box & path.hit)
    if not path.total:
        return Explanation("neither of the given tests was called")
    same = hits[~_apart(path.t[hits], found)]
    if not same.size and setting.is_cut:
        return Explanation(
            f"none of the first {len(path.hit)} of {path.total} tests gave t = {found:.9g}; "
            "later ones were not recorded"
        )
    if not same.size:
        return Explanation(f"no test of a face gave t = {found:.9g}; where does it come from?")
    step = int(same[-1])
    limits = f"({path.t_min[step]:.9g}, {path.t_max[step]:.9g})"
    return Explanation(f"t = {found:.9g} is from a face that was tested with t in {limits}")


def _first_alike(tree: Bvh, sought: Floats) -> list[int]:
    """Find the first node with each box of (K, 6) float32, bit by bit; -1 if there is none."""
    sides = [*tree.low.T, *tree.high.T]
    # One coordinate after the other leaves few nodes of a large tree to be looked at.
    likely = np.arange(len(tree.end))
    for side, wanted in zip(sides, sought.T, strict=True):
        likely = likely[np.isin(_bits(side[likely]), _bits(wanted))]
    boxes = np.concatenate([tree.low[likely], tree.high[likely]], axis=1)
    # Whoever sets no box leaves all of them alike.
    fresh = np.ones(len(likely), np.bool_)
    fresh[1:] = (_bits(boxes[1:]) != _bits(boxes[:-1])).any(axis=1)
    likely, boxes = likely[fresh], boxes[fresh]
    # Backwards, so that the first of several equal ones stays.
    first = dict(zip(reversed(_as_bytes(boxes)), reversed(likely.tolist()), strict=True))
    return [first.get(each, -1) for each in _as_bytes(sought)]


def _bits(values: Floats) -> Indices:
    """(...) uint32, by which NaN equals itself, and zeros of other signs do not."""
    return np.ascontiguousarray(values, dtype=np.float32).view(np.uint32)


def _as_bytes(rows: Floats) -> list[bytes]:
    """Give each row of (N, 6) float32 as its bytes, so that equal means the same bits."""
    return [row.tobytes() for row in np.ascontiguousarray(rows, dtype=np.float32)]
