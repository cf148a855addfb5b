"""What does the rule of closest hits say of a picture, and does Mitsuba agree?

Theory of operation. Looking for candidates is much faster if it may stop behind Mitsuba's hit.
Where nothing sure was found up to there, the search is done again without a bound, so that the
answers never depend on Mitsuba. Then Mitsuba is held to them: a picture that contradicts the
rule on clear pixels is our own fault, and nothing may be graded with it.
"""

from typing import Protocol

import numpy as np

from grader.errors import OracleFault
from grader.model.mesh import SOLID, Answers, Bvh, Doubles, Floats, Integers, Mask, Mesh, Rays
from grader.model.scene import Reference
from grader.tolerances import PICTURE_PIXELS, PICTURE_RELATIVE, PICTURE_SHARE

CUT_MARGIN = 1e-3
"""How far behind Mitsuba's hit the first search goes, relative to t."""


class FindsAnswers(Protocol):
    """Applies the rule of closest hits; `cut` bounds t of what each ray looks for."""

    def __call__(
        self, mesh: Mesh, rays: Rays, tree: Bvh, cut: Doubles | None = None
    ) -> Answers:
        """Return the candidates of each ray."""


def picture_answers(find: FindsAnswers, mesh: Mesh, tree: Bvh, picture: Reference) -> Answers:
    """Return the candidates of each pixel."""
    seen = picture.t.astype(np.float64)
    answers = find(mesh, picture.rays, tree, seen * (1 + CUT_MARGIN))
    again = np.flatnonzero(np.isfinite(seen) & ~np.isfinite(answers.limit))
    if again.size == 0:
        return answers
    return _replaced(answers, again, find(mesh, _chosen(picture.rays, again), tree))


def require_agreement(name: str, answers: Answers, mitsuba_t: Floats) -> None:
    """Let a picture pass only if Mitsuba agrees with the rule on clear pixels.

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


def _chosen(rays: Rays, places: Integers) -> Rays:
    """Return some of the rays."""
    return Rays(
        origin=rays.origin[places],
        direction=rays.direction[places],
        t_min=rays.t_min[places],
        t_max=rays.t_max[places],
    )


def _replaced(old: Answers, places: Integers, new: Answers) -> Answers:
    """Return `old` with the answers at `places` taken from `new`."""
    ray = np.repeat(np.arange(old.limit.size), np.diff(old.first))
    kept = ~np.isin(ray, places)
    rays = np.concatenate([ray[kept], np.repeat(places, np.diff(new.first))])
    order = np.argsort(rays, kind="stable")
    limit = old.limit.copy()
    limit[places] = new.limit
    counts = np.bincount(rays, minlength=limit.size)
    return Answers(
        limit=limit,
        first=np.concatenate([[0], np.cumsum(counts)]),
        face=np.concatenate([old.face[kept], new.face])[order],
        t=np.concatenate([old.t[kept], new.t])[order],
        tolerance=np.concatenate([old.tolerance[kept], new.tolerance])[order],
        kind=np.concatenate([old.kind[kept], new.kind])[order],
    )
