"""Are the boxes right, and does memory stay in bounds?"""

from grader.model.cases import MemoryCase, TreeCase
from grader.model.mesh import Bvh, Integers, Mask, Mesh
from grader.model.stages import Stop
from grader.model.verdict import Evidence, Example
from grader.verify.check import check, judged, one, vector
from grader.verify.structure import READABLE, calls_construct, needs_a_split
from grader.verify.tree import on_any_axis, shape, spans


@check(TreeCase, "bvh.boxes-are-tight", needs=READABLE, when=needs_a_split)
def boxes_are_tight(case: TreeCase) -> Evidence:
    """Every node's box is exactly the box of its own triangles.

    No tolerance: a union only picks minima and maxima, and neither rounds. The root's box is
    given by the mesh and judged by `bvh.root-holds-all-faces`.
    Source: exercise sheet, part a, "Compute their bounding boxes".
    """
    bvh, true = case.bvh, spans(case.trial.mesh, case.bvh)
    used, wrong = _below_the_root(case.trial.mesh, bvh)

    def describe(k: int) -> Example:
        node = used[k]
        got = f"{vector(bvh.low[node])} to {vector(bvh.high[node])}"
        wanted = f"{vector(true.low[node])} to {vector(true.high[node])}"
        text = f"node {node}: box is {got}, but its triangles span {wanted}"
        return Example(text, wanted, got)

    return judged(wrong, describe)


def loose_nodes(mesh: Mesh, bvh: Bvh) -> Integers:
    """Return (K,) int64, the nodes that `boxes_are_tight` finds wrong; the tree is readable."""
    used, wrong = _below_the_root(mesh, bvh)
    return used[wrong]


def _below_the_root(mesh: Mesh, bvh: Bvh) -> tuple[Integers, Mask]:
    """Return (K,) int64 used nodes, and (K,) bool, True where a box is not its faces' box."""
    true, used = spans(mesh, bvh), shape(bvh).reached[1:]
    used = used[bvh.begin[used] < bvh.end[used]]
    return used, on_any_axis((bvh.low != true.low) | (bvh.high != true.high))[used]


@check(MemoryCase, "bvh.memory-is-safe", when=calls_construct)
def construct_memory_is_safe(case: MemoryCase) -> Evidence:
    """Sanitizers find no memory error and no undefined behaviour in `construct`."""
    return safe(case)


def safe(case: MemoryCase) -> Evidence:
    """Judge what the sanitizers said of one worker.

    A worker that ended early without a finding proves nothing: it is not examined here.
    """
    ending = case.ending
    if ending.finding:
        where = f" in line {ending.line}" if ending.line else ""
        example = Example(f"{ending.finding}{where}", "no finding", ending.finding)
        return Evidence(1, 1, (example,), ending.stop, ending.line)
    return one(None) if ending.stop is Stop.FINISHED else Evidence(0, 0, stop=ending.stop)
