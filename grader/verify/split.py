"""Is every node split at the median of the triangle centres, along its longest axis?"""

import numpy as np

from grader.model.cases import TreeCase
from grader.model.verdict import Evidence, Example
from grader.verify.axis import judge, tells
from grader.verify.check import check, judged
from grader.verify.halves import splits
from grader.verify.structure import READABLE, needs_a_split
from grader.verify.tree import on_any_axis, spans

AXES = "xyz"
MEDIAN = "bvh.splits-at-the-median"


@check(
    TreeCase,
    "bvh.splits-the-longest-axis",
    needs=READABLE,
    when=needs_a_split,
    blames=(MEDIAN,),
)
def splits_the_longest_axis(case: TreeCase) -> Evidence:
    """Every node is divided along the axis on which its box is largest.

    A tree whose faces are not ordered is judged by its large nodes only, and if they tell
    nothing either, `bvh.splits-at-the-median` says what is wrong.
    """
    found = splits(case.trial.mesh, case.bvh)
    seen = judge(case.trial.mesh, case.bvh, found)
    examined = int((seen.right | seen.wrong).sum())
    if found.node.size and not examined:
        large = tells(case.bvh, found)
        return Evidence(0, 0, hidden_by=MEDIAN if large else "", too_small=not large)

    def describe(k: int) -> Example:
        axes = np.flatnonzero(found.ordered[k])
        got = " or ".join(AXES[axis] for axis in axes) or "another axis"
        wanted = " or ".join(AXES[axis] for axis in np.flatnonzero(found.longest[k]))
        node = found.node[k]
        text = f"node {node} is divided along {got}, but its box is largest along {wanted}"
        return Example(text, wanted, got)

    return judged(seen.wrong, describe, examined=examined)


@check(TreeCase, MEDIAN, needs=READABLE, when=needs_a_split)
def splits_at_the_median(case: TreeCase) -> Evidence:
    """Both halves are equally large, and the smaller triangle centres are on the left."""
    bvh, found = case.bvh, splits(case.trial.mesh, case.bvh)
    left, right = 2 * found.node + 1, 2 * found.node + 2
    held_left = bvh.end[left].astype(np.int64) - bvh.begin[left]
    held_right = bvh.end[right].astype(np.int64) - bvh.begin[right]
    unequal = np.abs(held_left - held_right) > 1
    mixed = ~on_any_axis(found.ordered)

    def describe(k: int) -> Example:
        node = int(found.node[k])
        if unequal[k]:
            got = f"{held_left[k]:,} and {held_right[k]:,} faces"
            text = f"node {node} is divided into {got}, but the halves must be equal"
            return Example(text, "halves that differ by at most one face", got)
        axis = int(np.flatnonzero(found.longest[k])[0])
        true = spans(case.trial.mesh, bvh)
        most, least = true.centre_high[2 * node + 1, axis], true.centre_low[2 * node + 2, axis]
        text = (
            f"node {node}: the left half reaches to centre {AXES[axis]} = {most:.9g}, but the "
            f"right half begins at {least:.9g}"
        )
        return Example(text, "all left centres before all right ones", "mixed centres")

    wrong = unequal | mixed
    return judged(np.asarray(wrong), describe)
