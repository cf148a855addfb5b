"""Are nodes given up too early, or lost? Looked for only where nothing more exact is found."""

import numpy as np

from grader.diagnose.hypothesis import NOTHING, Hypothesis, Support
from grader.diagnose.notes import Notes
from grader.diagnose.shots import clear, limited, same, shots
from grader.model.cases import HitCase
from grader.verify.tree import shape

SHALLOW = 5
"""A stack that is too small for trees of fewer levels than this would be no stack."""


def _missed(case: HitCase) -> tuple[int, int, int]:
    """Count clear rays: farther hits returned, hits lost altogether, anything else wrong."""
    given = shots(case)
    if given is None:
        return 0, 0, 0
    met, wrong = limited(given), ~given.right & clear(given)
    with np.errstate(invalid="ignore"):
        fits = same(given.got[met.ray], met.t)
    on_a_face = np.zeros(met.shots, dtype=np.bool_)
    on_a_face[met.ray[fits]] = True
    lost = np.isinf(given.got) & (given.got > 0)
    return (
        int((wrong & on_a_face).sum()),
        int((wrong & lost).sum()),
        int((wrong & ~on_a_face & ~lost).sum()),
    )


def too_early(case: HitCase) -> Support:
    """Only rays that meet several faces are wrong, and they return a farther one of them."""
    farther, lost, other = _missed(case)
    return Support(farther, lost + other)


def drops_nodes(notes: Notes) -> Support:
    """Only trees of some depth and more lose hits."""
    by_depth: dict[int, int] = {}
    wrong = bad = 0
    for case in notes.of(HitCase):
        farther, lost, other = _missed(case)
        depth = shape(case.trial.tree).depth
        by_depth[depth] = by_depth.get(depth, 0) + farther + lost
        wrong, bad = wrong + farther + lost, bad + other
    spared = max((depth for depth, count in by_depth.items() if not count), default=0)
    hit = min((depth for depth, count in by_depth.items() if count), default=0)
    return Support(wrong, bad) if SHALLOW <= spared < hit else NOTHING


PRUNING = (
    Hypothesis(
        "stack.drops-nodes",
        Notes,
        "The stack of nodes that wait is too small for deep "
        "trees, and what does not fit is lost.",
        drops_nodes,
        general=True,
    ),
    Hypothesis(
        "walk.gives-up-too-early",
        HitCase,
        "Nodes are given up too early: what is in them "
        "may be closer than the hit that is known.",
        too_early,
        10,
        general=True,
    ),
)
