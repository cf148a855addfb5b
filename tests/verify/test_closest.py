"""The rule of closest hits, on candidate lists made by hand."""

import numpy as np
import pytest

from grader.model.mesh import EDGE, SOLID, WILD, Answers, Floats
from grader.verify.closest import is_ambiguous, judge


def one_ray(*candidates: tuple[float, float, int]) -> Answers:
    """Make the answers of one ray from (t, tolerance, kind) of each candidate."""
    solid = [t + tolerance for t, tolerance, kind in candidates if kind == SOLID]
    return Answers(
        limit=np.array([min(solid, default=np.inf)]),
        first=np.array([0, len(candidates)]),
        face=np.arange(len(candidates)),
        t=np.array([c[0] for c in candidates]),
        tolerance=np.array([c[1] for c in candidates]),
        kind=np.array([c[2] for c in candidates], dtype=np.uint8),
    )


def at(t: float) -> Floats:
    """Make the claim of one ray."""
    return np.array([t], dtype=np.float32)


NEAR, FAR = (1.0, 1e-5, SOLID), (2.0, 1e-5, SOLID)


@pytest.mark.parametrize(
    ("candidates", "t", "verdict"),
    [
        ((NEAR,), 1.0, "right"),
        ((NEAR,), 1.000005, "right"),
        ((NEAR,), 1.00002, "missed_closer"),
        ((NEAR,), 0.99998, "no_surface"),
        ((NEAR, FAR), 2.0, "missed_closer"),
        ((FAR, NEAR), 1.0, "right"),
        ((NEAR,), np.inf, "missed_closer"),
        ((), np.inf, "right"),
        ((), 1.0, "no_surface"),
        (((1.0, 1e-5, EDGE),), np.inf, "right"),
        (((1.0, 1e-5, EDGE),), 1.0, "right"),
        (((1.0, 1e-5, EDGE),), 1.1, "no_surface"),
        (((1.0, np.inf, WILD),), 0.5, "uncounted"),
        (((1.0, np.inf, WILD),), np.inf, "right"),
        (((1.0, np.inf, WILD), NEAR), 3.0, "missed_closer"),
        ((NEAR, (1.0 + 2e-6, 1e-5, EDGE)), 1.000003, "right"),
        ((), np.nan, "no_surface"),
        ((NEAR,), np.nan, "no_surface"),
        (((1.0, np.inf, WILD),), np.nan, "no_surface"),
        ((NEAR,), -np.inf, "no_surface"),
        (((1.0, np.inf, WILD),), -np.inf, "no_surface"),
    ],
)
def test_each_claim_gets_one_verdict(
    candidates: tuple[tuple[float, float, int], ...], t: float, verdict: str
) -> None:
    """A claim misses, is unexplained, is not counted or is right, and never two of these."""
    judgement = judge(one_ray(*candidates), at(t))
    verdicts = {
        name
        for name in ("missed_closer", "no_surface", "uncounted")
        if getattr(judgement, name)
    }
    assert verdicts == ({verdict} - {"right"})


@pytest.mark.parametrize(
    ("candidates", "t", "accepted"),
    [
        ((NEAR,), 1.0, 0),
        ((NEAR, FAR), 2.0, 1),
        ((FAR, NEAR), 1.0, 1),
        ((NEAR, (1.0 + 2e-6, 1e-5, EDGE)), 1.000003, 1),
        (((1.0 + 2e-6, 1e-5, EDGE), NEAR), 1.000003, 0),
        ((NEAR,), 1.00002, -1),
        ((NEAR,), np.nan, -1),
        ((NEAR,), np.inf, -1),
        (((1.0, np.inf, WILD),), 1.0, -1),
    ],
)
def test_the_nearest_explanation_is_accepted(
    candidates: tuple[tuple[float, float, int], ...], t: float, accepted: int
) -> None:
    """Of several triangles that explain a hit the nearest in t is named."""
    assert judge(one_ray(*candidates), at(t)).accepted.tolist() == [accepted]


def test_every_explanation_of_a_hit_is_listed() -> None:
    """Two triangles that share the hit edge both explain it, the WILD one between does not."""
    answers = one_ray(NEAR, (1.0, np.inf, WILD), (1.0, 1e-5, EDGE))
    assert judge(answers, at(1.0)).near.tolist() == [True, False, True]


def test_rays_do_not_borrow_candidates() -> None:
    """Of three rays only the middle one has a triangle."""
    middle = one_ray(NEAR)
    answers = Answers(
        limit=np.array([np.inf, middle.limit[0], np.inf]),
        first=np.array([0, 0, 1, 1]),
        face=middle.face,
        t=middle.t,
        tolerance=middle.tolerance,
        kind=middle.kind,
    )
    judgement = judge(answers, np.array([1, 1, 1], dtype=np.float32))
    assert judgement.no_surface.tolist() == [True, False, True]
    assert judgement.accepted.tolist() == [-1, 0, -1]


def test_only_undecidable_candidates_make_a_ray_ambiguous() -> None:
    """A SOLID hit alone is clear; an EDGE or WILD one beside it is not."""
    assert not is_ambiguous(one_ray(NEAR)).any()
    assert is_ambiguous(one_ray(NEAR, (1.0, 1e-5, EDGE))).all()
    assert is_ambiguous(one_ray(NEAR, (1.0, np.inf, WILD))).all()
