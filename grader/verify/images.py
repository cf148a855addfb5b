"""Does `intersect` see the same picture as Mitsuba?"""

import numpy as np

from grader.model.cases import ImageCase
from grader.model.mesh import Answers, Doubles, Mask
from grader.model.verdict import Evidence, Example
from grader.tolerances import PICTURE_PIXELS, PICTURE_RELATIVE, PICTURE_SHARE
from grader.verify.check import check, judged
from grader.verify.closest import Judgement, closest_sure, judge


@check(ImageCase, "image.equals-mitsuba", needs=("work.uses-the-tree",))
def picture_equals_mitsubas(case: ImageCase) -> Evidence:
    """Every pixel of the picture sees the same surface as Mitsuba 3 does.

    Each pixel is held to the rule of closest hits; there is no window around it and no blur, so
    that a hole of one pixel counts. Where the rule allows two answers, as on an edge, Mitsuba's
    is expected but for a handful of pixels.
    Source: exercise sheet, part b, "render the same image".
    """
    judgement = judge(case.trial.answers, case.hits.t)
    wrong = _wrong(case, judgement)
    return judged(
        wrong,
        lambda pixel: _example(case, judgement, pixel),
        examined=int(np.count_nonzero(~judgement.uncounted | wrong)),
    )


def wrong_pixels(case: ImageCase) -> Mask:
    """Return (R,) bool, True at each pixel that `picture_equals_mitsubas` counts as wrong."""
    return _wrong(case, judge(case.trial.answers, case.hits.t))


def _wrong(case: ImageCase, judgement: Judgement) -> Mask:
    against_rule = judgement.missed_closer | judgement.no_surface
    against_mitsuba = ~against_rule & _differs(case, judgement)
    pixels = against_rule.size
    if np.count_nonzero(against_mitsuba) <= max(PICTURE_PIXELS, PICTURE_SHARE * pixels):
        against_mitsuba[:] = False
    return against_rule | against_mitsuba


def _differs(case: ImageCase, judgement: Judgement) -> Mask:
    """Return (R,) bool, True where the submission and Mitsuba disagree."""
    ours = case.hits.t.astype(np.float64)
    theirs = case.trial.mitsuba_t.astype(np.float64)
    room = PICTURE_RELATIVE * theirs + _tolerance(case.trial.answers, judgement)
    with np.errstate(invalid="ignore"):
        near = np.abs(ours - theirs) <= room
    both_miss = (ours == np.inf) & (theirs == np.inf)
    agrees: Mask = both_miss | (np.isfinite(ours) & np.isfinite(theirs) & near)
    return ~agrees


def _tolerance(answers: Answers, judgement: Judgement) -> Doubles:
    """Return (R,) float64, the bound of the accepted candidate, 0 where there is none."""
    found = judgement.accepted >= 0
    tolerance = np.zeros(found.size)
    tolerance[found] = answers.tolerance[judgement.accepted[found]]
    return tolerance


def _example(case: ImageCase, judgement: Judgement, pixel: int) -> Example:
    """Word one wrong pixel."""
    y, x = divmod(pixel, case.trial.width)
    got = _told(float(case.hits.t[pixel]))
    mitsuba = _told(float(case.trial.mitsuba_t[pixel]))
    if judgement.missed_closer[pixel]:
        expected = _closest(case.trial.answers, pixel)
        reason = f"but {expected} is closer"
    elif judgement.no_surface[pixel]:
        expected = mitsuba
        reason = f"but no face is there; Mitsuba sees {mitsuba}"
    else:
        expected = mitsuba
        reason = f"but Mitsuba sees {mitsuba}, as on too many other pixels"
    return Example(f"pixel ({x}, {y}): {got}, {reason}", expected=expected, got=got)


def _closest(answers: Answers, pixel: int) -> str:
    """Name the surface that a ray surely hits first."""
    nearest = closest_sure(answers, pixel)
    return f"face {answers.face[nearest]} at t = {np.float32(answers.t[nearest]):.9g}"


def _told(t: float) -> str:
    """Say what a returned distance means."""
    if t == np.inf:
        return "no hit"
    return f"a hit at t = {t:.9g}"
