"""Does Mitsuba agree with the rule of closest hits on a picture?

A picture that contradicts the rule on clear pixels is our own fault, and nothing may be graded
with it. On an edge the rule allows two answers, so Mitsuba may give either.
"""

import numpy as np

from grader.errors import OracleFault
from grader.model.mesh import SOLID, Answers, Floats, Mask
from grader.tolerances import PICTURE_PIXELS, PICTURE_RELATIVE, PICTURE_SHARE


def require_agreement(name: str, answers: Answers, mitsuba_t: Floats) -> None:
    """Let a picture pass only if Mitsuba agrees with the rule on clear pixels.

    Args:
        name: Of the scene.
        answers: What the rule says of the picture's rays.
        mitsuba_t: (R,) float32, infinite for a miss.

    Raises:
        OracleFault: They disagree on more than a handful.
    """
    wrong = np.flatnonzero(_contradicts(answers, mitsuba_t))
    allowed = max(PICTURE_PIXELS, PICTURE_SHARE * mitsuba_t.size)
    if wrong.size > allowed:
        raise OracleFault(
            f"scene {name}: Mitsuba's picture contradicts the rule of closest hits on "
            f"{wrong.size} clear pixels, the first is pixel {wrong[0]}, where Mitsuba has t = "
            f"{mitsuba_t[wrong[0]]:.9g}; render it anew with `bvhgrade scenes render {name}`"
        )


def _contradicts(answers: Answers, mitsuba_t: Floats) -> Mask:
    """Return (R,) bool, True where a clear pixel has another t than the rule allows."""
    pixels = mitsuba_t.size
    ray = np.repeat(np.arange(pixels), np.diff(answers.first))
    clear = np.ones(pixels, dtype=np.bool_)
    clear[ray[answers.kind != SOLID]] = False
    theirs = mitsuba_t.astype(np.float64)
    room = PICTURE_RELATIVE * theirs[ray] + answers.tolerance
    explained = ~np.isfinite(answers.limit) & (theirs == np.inf)
    with np.errstate(invalid="ignore"):
        explained[ray[np.abs(theirs[ray] - answers.t) <= room]] = True
    # A farther candidate explains a hit, but the nearest one must not lie before it.
    wrong: Mask = ~explained | (theirs * (1 - PICTURE_RELATIVE) > answers.limit)
    return clear & wrong
