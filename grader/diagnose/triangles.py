"""Which mistake in an own triangle test explains the distances that were returned?"""

from collections.abc import Callable

import numpy as np

from grader.diagnose.hypothesis import NOTHING, Hypothesis, Support, hypothesis
from grader.diagnose.paths import passes, reached, through_leaves
from grader.diagnose.shots import Shots, met_where, same, shots, within
from grader.diagnose.walks import of
from grader.model.cases import HitCase
from grader.model.mesh import Bvh, Doubles, Mask

Test = Callable[[Shots], Mask]
"""(S, F) bool, True where a point in the plane of a face is taken for one of the face."""


def _with(test: Test) -> Callable[[Shots, Bvh], Doubles]:
    def foretell(given: Shots, bvh: Bvh) -> Doubles:
        # What lies beyond the boxes of a leaf is not even tested.
        through = reached(bvh, passes(given, bvh))
        met = through_leaves(bvh, through, met_where(given, test(given)))
        return within(given, met, given.t_min, given.t_max).closest()

    return foretell


def _inside(given: Shots, slack: float = 0.0) -> Mask:
    u, v = given.u, given.v
    with np.errstate(invalid="ignore"):
        return np.asarray((u >= -slack) & (v >= -slack) & (u + v <= 1 + slack))


def _front(given: Shots) -> Mask:
    return np.asarray(_inside(given) & (given.side > 0))


def _back(given: Shots) -> Mask:
    return np.asarray(_inside(given) & (given.side < 0))


def _parallelogram(given: Shots) -> Mask:
    u, v = given.u, given.v
    return np.asarray((u >= 0) & (v >= 0) & (u <= 1) & (v <= 1))


def _determinant(least: float) -> Test:
    return lambda given: _inside(given) & (np.abs(given.side) >= least)


def _grown(given: Shots) -> Mask:
    return _inside(given, 1e-4)


def _on_edges(case: HitCase, found: Callable[[Shots], Mask]) -> Support:
    """Count wrong rays near an edge of a face as fitting, others as not."""
    given = shots(case)
    if given is None or given.right.all():
        return NOTHING
    wrong, near = ~given.right, found(given)
    return Support(int((wrong & near).sum()), int((wrong & ~near).sum()))


def _lost_at_an_edge(given: Shots) -> Mask:
    """(S,) bool, True where a hit at an edge was missed, and what lies behind returned."""
    inner = met_where(given, _inside(given, -1e-4))
    outer = met_where(given, _inside(given, 1e-6))
    closer = within(given, inner, given.t_min, given.t_max).closest()
    at_edge = within(given, outer, given.t_min, given.t_max).closest()
    # Along an axis a box test is as likely to be wrong.
    slanted = (given.direction != 0).all(axis=1)
    return np.asarray((at_edge < closer) & same(given.got, closer) & slanted)


@hypothesis(HitCase, "triangle.shrunk", least=10)
def shrunk(case: HitCase) -> Support:
    """Rays slip through the edges between faces: the own triangle test leaves them out."""
    return _on_edges(case, _lost_at_an_edge)


BOTH = "Faces are seen from one side only: the sign of the determinant excludes the other."
EPSILON = "Faces vanish whose determinant is below an epsilon: small ones, or of short rays."

TRIANGLES: tuple[Hypothesis, ...] = (
    of("triangle.one-side-only", BOTH, _with(_front)),
    of("triangle.one-side-only", BOTH, _with(_back)),
    of(
        "triangle.parallelogram",
        "The own triangle test asks for u and v, not for their sum, so "
        "the face is a parallelogram.",
        _with(_parallelogram),
    ),
    *(
        of("triangle.determinant-epsilon", EPSILON, _with(_determinant(least)))
        for least in (1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-12)
    ),
    of(
        "triangle.grown",
        "The own triangle test accepts points beside the face, by a fixed tolerance.",
        _with(_grown),
    ),
    shrunk,
)
