"""Which mistake in an own box test explains the hits that are lost?"""

from collections.abc import Callable

import numpy as np

from grader.diagnose.hypothesis import NOTHING, Hypothesis, Support, hypothesis
from grader.diagnose.paths import passes, reached, slabs, through_leaves
from grader.diagnose.shots import Shots, limited, shots
from grader.diagnose.walks import of
from grader.model.cases import HitCase
from grader.model.mesh import Bvh, Doubles, Mask

Test = Callable[[Shots, Bvh], Mask]
"""(S, N) bool, True where a ray passes the mistaken test of a box."""


def _with(test: Test, spare_leaves: bool) -> Callable[[Shots, Bvh], Doubles]:
    """Return what a search finds with a box test.

    Args:
        test: The box test.
        spare_leaves: Whether the boxes of leaves are not tested at all.
    """

    def foretell(given: Shots, bvh: Bvh) -> Doubles:
        lets_pass = test(given, bvh) & passes(given, bvh)
        if spare_leaves:
            inner = np.zeros(len(bvh.end), dtype=np.bool_)
            inner[: len(bvh.end) // 2] = bvh.end[1 : 2 * (len(bvh.end) // 2) + 1 : 2] > 0
            lets_pass = lets_pass | ~inner
        return through_leaves(bvh, reached(bvh, lets_pass), limited(given)).closest()

    return foretell


def _flat(given: Shots, bvh: Bvh) -> Mask:
    thick = (bvh.high > bvh.low).all(axis=1)
    return np.broadcast_to(thick, (len(given.ray), len(bvh.end)))


def _from_outside(given: Shots, bvh: Bvh) -> Mask:
    enter, _ = slabs(given, bvh)
    return np.asarray(enter > given.t_min[:, None])


def _from_ahead(given: Shots, bvh: Bvh) -> Mask:
    enter, _ = slabs(given, bvh)
    return np.asarray(enter >= 0)


def _all(given: Shots, good: Mask, bvh: Bvh) -> Mask:
    return np.broadcast_to(good[:, None], (len(given.ray), len(bvh.end)))


def _slanted(given: Shots, bvh: Bvh) -> Mask:
    return _all(given, (given.direction != 0).all(axis=1), bvh)


def _no_negative_zero(given: Shots, bvh: Bvh) -> Mask:
    """The near side of a slab is taken for the far one where the direction is -0."""
    zero = (given.direction == 0) & np.signbit(given.direction)
    return _all(given, ~zero.any(axis=1), bvh)


def _nudged(given: Shots, bvh: Bvh) -> Mask:
    """A component of the direction that is 0 is replaced by something small."""
    direction = np.where(given.direction == 0, 1e-5, given.direction)
    near, far = given.t_min[:, None], given.t_max[:, None]
    for axis in range(3):
        origin, along = given.origin[:, axis, None], direction[:, axis, None]
        one, two = (
            (bvh.low[None, :, axis] - origin) / along,
            (bvh.high[None, :, axis] - origin) / along,
        )
        near, far = np.fmax(near, np.fmin(one, two)), np.fmin(far, np.fmax(one, two))
    return np.asarray(near <= far + 1e-6 * np.abs(far))


@hypothesis(HitCase, "slab.nan", least=10)
def in_a_plane(case: HitCase) -> Support:
    """Rays in the plane of a box's side are lost: there 0 times infinity is not a number."""
    given = shots(case)
    if given is None or given.right.all():
        return NOTHING
    low, high = case.trial.tree.low, case.trial.tree.high
    on_plane = np.zeros(len(given.ray), dtype=np.bool_)
    for axis in range(3):
        on_side = np.isin(given.origin[:, axis], np.concatenate([low[:, axis], high[:, axis]]))
        on_plane |= on_side & (given.direction[:, axis] == 0)
    wrong = ~given.right
    return Support(int((wrong & on_plane).sum()), int((wrong & ~on_plane).sum()))


def _both(id: str, sentence: str, test: Test) -> tuple[Hypothesis, ...]:
    return tuple(of(id, sentence, _with(test, spare)) for spare in (False, True))


SLABS = (
    *_both("slab.flat-boxes", "A flat box, without extent along some axis, is missed.", _flat),
    *_both(
        "slab.origin-inside",
        "A box that holds the origin of the ray counts as missed.",
        _from_outside,
    ),
    *_both(
        "slab.origin-inside",
        "A box that holds the origin of the ray counts as missed.",
        _from_ahead,
    ),
    *_both(
        "slab.parallel-rays",
        "A ray that is parallel to a side of a box counts as a miss.",
        _slanted,
    ),
    in_a_plane,
    *_both(
        "slab.negative-zero",
        "A direction of -0.0 is taken for a positive one, though its inverse is negative.",
        _no_negative_zero,
    ),
    *_both(
        "slab.zero-direction",
        "A component of the direction that is 0 is replaced by a small "
        "number in the own box test, which leads far rays astray.",
        _nudged,
    ),
)
