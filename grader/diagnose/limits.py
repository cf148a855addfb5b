"""Which mistake about t, its limits and its unit explains the distances that were returned?"""

from functools import partial

import numpy as np

from grader.diagnose.hypothesis import Hypothesis
from grader.diagnose.paths import ORDERS, passes, reached, sequence, through_leaves
from grader.diagnose.shots import Shots, all_met, limited, within
from grader.diagnose.walks import of
from grader.model.mesh import Bvh, Doubles
from grader.tolerances import EPSILON


def _unlimited(
    given: Shots, bvh: Bvh, t_min: float | None = None, t_max: float | None = None
) -> Doubles:
    """Return the closest hit with other limits than the ray's."""
    low = given.t_min if t_min is None else t_min
    high = given.t_max if t_max is None else t_max
    return within(given, all_met(given), low, high).closest()


def _behind(given: Shots, bvh: Bvh) -> Doubles:
    """Return the smallest t, also a negative one, of the leaves that the ray comes to."""
    through = reached(bvh, passes(given, bvh))
    met = within(given, all_met(given), -np.inf, given.t_max)
    met = met.only(np.abs(met.t) > given.t_min[met.ray])
    return through_leaves(bvh, through, met).closest()


def _tighter(given: Shots, bvh: Bvh, t_min: float, t_max: float) -> Doubles:
    """Return the closest hit that also lies between two more limits."""
    return within(given, limited(given), t_min, t_max).closest()


def _early(given: Shots, bvh: Bvh, epsilon: float) -> Doubles:
    return within(given, limited(given), -np.inf, given.t_max - epsilon).closest()


def _length(given: Shots) -> Doubles:
    return np.asarray(np.sqrt((given.direction**2).sum(axis=1)))


def _as_length(given: Shots, bvh: Bvh) -> Doubles:
    return limited(given).closest() * _length(given)


def _limited_as_length(given: Shots, bvh: Bvh) -> Doubles:
    """The limits of t are compared with lengths, and a length is returned."""
    length = _length(given)
    return within(
        given, all_met(given), given.t_min / length, given.t_max / length
    ).closest() * (length)


def _back_in_t(given: Shots, bvh: Bvh) -> Doubles:
    """The limits of t are compared with lengths, but t is returned."""
    length = _length(given)
    return within(given, all_met(given), given.t_min / length, given.t_max / length).closest()


def _from_t_min(given: Shots, bvh: Bvh) -> Doubles:
    return limited(given).closest() - given.t_min


def _any_of_finite(given: Shots, bvh: Bvh, order: str) -> Doubles:
    first = sequence(given, bvh, order).t[:, 0]
    return np.where(np.isfinite(given.t_max), first, limited(given).closest())


T_MIN = "t_min is ignored: hits before it, or behind the origin, are accepted."
T_MAX = "t_max is ignored: hits beyond it are accepted."
LENGTH = "A length is taken for t, which counts in multiples of the direction's own length."
FAR = "Far hits are lost: some large number is used where t may be as large as infinity."
ANY = "A ray with a finite t_max ends at any hit, not at the closest one."

LIMITS: tuple[Hypothesis, ...] = (
    of("limits.t-min-ignored", T_MIN, partial(_unlimited, t_min=0.0)),
    of("limits.t-min-ignored", T_MIN, partial(_unlimited, t_min=EPSILON)),
    of("limits.t-min-ignored", T_MIN, partial(_unlimited, t_min=-np.inf)),
    of("limits.t-min-ignored", T_MIN, _behind),
    of("limits.t-max-ignored", T_MAX, partial(_unlimited, t_max=np.inf)),
    of(
        "limits.both-ignored",
        "t_min and t_max of the ray are lost: it is made anew from origin and direction.",
        partial(_unlimited, t_min=EPSILON, t_max=np.inf),
    ),
    of(
        "limits.t-min-at-least-epsilon",
        "t also has to be larger than epsilon, though t_min may be smaller.",
        partial(_tighter, t_min=EPSILON, t_max=np.inf),
    ),
    of(
        "limits.t-max-less-epsilon",
        "A hit is rejected that lies before t_max by less than epsilon.",
        partial(_early, epsilon=EPSILON),
    ),
    *(
        of("limits.far-hits-lost", FAR, partial(_tighter, t_min=-np.inf, t_max=most))
        for most in (1e3, 1e4, 1e5, 1e6, 1e9)
    ),
    of("limits.length-instead-of-t", LENGTH, _as_length),
    of("limits.length-instead-of-t", LENGTH, _limited_as_length),
    of("limits.length-instead-of-t", LENGTH, _back_in_t),
    of(
        "limits.t-from-t-min",
        "t is counted from t_min on instead of from the origin.",
        _from_t_min,
    ),
    *(
        of("limits.any-hit-of-finite-rays", ANY, partial(_any_of_finite, order=order))
        for order in ORDERS
    ),
)
