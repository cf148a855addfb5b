"""Does `intersect` return the closest hit, completely, and the same one every time?

Rays are judged by the rule of closest hits (`closest.py`); the answers come with the trial.
"""

import numpy as np

from grader.model.cases import HitCase, RepeatCase
from grader.model.mesh import Answers, Hits, Mask, Rays
from grader.model.trials import TraceTrial
from grader.model.verdict import Evidence, Example
from grader.tolerances import EPSILON, UNIT_LENGTH
from grader.verify.check import MAX_EXAMPLES, check, judged, vector
from grader.verify.closest import Judgement, closest_sure, is_ambiguous, judge, owners
from grader.verify.shading import normal_errors, point_errors

USES_THE_TREE = ("work.uses-the-tree",)


UNTOLD = Evidence(0, 0, too_small=True)


def leaves_out_borders(case: HitCase) -> bool:
    """Tell whether all hits are on borders, which the submission takes for outside."""
    return case.trial.on_borders and not np.isfinite(case.hits.t).any()


def expects_hits(trial: TraceTrial) -> bool:
    """Tell whether ordinary rays of a trial surely hit something."""
    return not trial.special and bool(np.isfinite(trial.answers.limit).any())


def expects_records(trial: TraceTrial) -> bool:
    """Tell whether rays of a trial surely hit something, ordinary or not."""
    return bool((np.isfinite(trial.answers.limit) & ~is_ambiguous(trial.answers)).any())


def expects_misses(trial: TraceTrial) -> bool:
    """Tell whether ordinary rays of a trial surely miss everything."""
    return not trial.special and bool((np.diff(trial.answers.first) == 0).any())


def is_special(trial: TraceTrial) -> bool:
    """Tell whether a trial has the rays of `hits.special-rays`."""
    return trial.special and trial.answers.limit.size > 0


@check(HitCase, "hits.closest-wins", needs=USES_THE_TREE, when=expects_hits)
def closest_wins(case: HitCase) -> Evidence:
    """Every ray that meets a surface reports the closest hit.

    Source: exercise sheet, part b, "Return the closest found intersection".
    """
    return _judged(case, np.diff(case.trial.answers.first) > 0)


@check(HitCase, "hits.misses-stay-infinite", needs=USES_THE_TREE, when=expects_misses)
def misses_stay_infinite(case: HitCase) -> Evidence:
    """The t of a ray that meets no surface stays infinite.

    Source: exercise sheet, part b, "the value t ... needs to remain at infinity".
    """
    ray = np.flatnonzero(np.diff(case.trial.answers.first) == 0)
    t = case.hits.t[ray]
    return judged(
        t != np.inf,
        lambda k: Example(
            f"{_named(case.trial, ray[k])}: {_told(t[k])}, but the ray meets no face",
            expected="t = inf",
            got=_told(t[k]),
        ),
    )


@check(HitCase, "hits.special-rays", needs=USES_THE_TREE, when=is_special)
def special_rays(case: HitCase) -> Evidence:
    """Rays with limits, odd directions and origins, and through edges and corners are right.

    Source: exercise interface, "accepts t_min < t < t_max", "directions need not be unit".
    """
    if leaves_out_borders(case):
        return UNTOLD
    return _judged(case, np.ones(case.hits.t.size, dtype=np.bool_))


@check(HitCase, "hits.record-is-complete", needs=USES_THE_TREE, when=expects_records)
def record_is_complete(case: HitCase) -> Evidence:
    """A hit comes with its point and with the unit normal of the face that was hit.

    Looked at are hits whose t is right, of special rays only those without a doubtful face.
    Where several faces lie within the tolerance of t, the normal of any of them is.
    Source: exercise interface, "`normal` is n normalised, not turned towards the ray".
    """
    if leaves_out_borders(case):
        return UNTOLD
    answers = case.trial.answers
    judgement = judge(answers, case.hits.t)
    ray = np.flatnonzero((judgement.accepted >= 0) & ~judgement.missed_closer)
    if case.trial.special:
        ray = ray[~is_ambiguous(answers)[ray]]
    off, allowed = point_errors(case, judgement.accepted)
    turned = _normals_are_wrong(case, judgement)
    # Written as what is right, so that a NaN is wrong.
    misplaced = ~(off <= allowed)

    def example(k: int) -> Example:
        if misplaced[ray[k]]:
            return _misplaced(case, int(ray[k]))
        return _turned(case, int(ray[k]), int(answers.face[judgement.accepted[ray[k]]]))

    return judged((misplaced | turned)[ray], example)


@check(RepeatCase, "hits.calls-are-independent", needs=USES_THE_TREE)
def calls_are_independent(case: RepeatCase) -> Evidence:
    """The same ray gives the same bits in any order, repeated and from several threads.

    Of a miss only t has a meaning. On another mesh the same ray finds that mesh's faces.
    """
    repeated, elsewhere = _repeated(case), _elsewhere(case)
    return Evidence(
        examined=repeated.examined + elsewhere.examined,
        wrong=repeated.wrong + elsewhere.wrong,
        examples=(repeated.examples + elsewhere.examples)[:MAX_EXAMPLES],
    )


def _repeated(case: RepeatCase) -> Evidence:
    """Compare later records of a ray with its first one."""
    ray = np.tile(np.arange(case.first.t.size), len(case.again))
    wrong = [_differ(case.first, hits) for _, hits in case.again]

    def example(k: int) -> Example:
        when, hits = case.again[k // case.first.t.size]
        expected, got = _record(case.first, int(ray[k])), _record(hits, int(ray[k]))
        text = f"ray {ray[k]}: {got} {when}, but {expected} the first time"
        return Example(text, expected=expected, got=got)

    return judged(np.concatenate(wrong) if wrong else np.zeros(0, np.bool_), example)


def _elsewhere(case: RepeatCase) -> Evidence:
    """Look for answers on the other mesh that are wrong because of the first one.

    They are if all was right on the first mesh, or if they are the first mesh's own; whatever
    else is wrong there is another mistake, and other checks see it.
    """
    judgement = judge(case.trial.other_answers, case.other.t)
    ray = np.flatnonzero(~judgement.uncounted)
    before = judge(case.trial.answers, case.first.t)
    was_right = not (before.missed_closer | before.no_surface).any()
    # Where both meshes have the same answer, the same mistake is no sign of anything.
    told_apart = case.trial.answers.limit != case.trial.other_answers.limit
    taken_over = told_apart & np.isfinite(case.first.t) & (case.first.t == case.other.t)
    wrong = (judgement.missed_closer | judgement.no_surface) & (taken_over | was_right)

    def example(k: int) -> Example:
        got = _told(case.other.t[ray[k]])
        face, t = _closest(case.trial.other_answers, int(ray[k]))
        expected = f"a hit on face {face} at t = {t:.9g}" if face >= 0 else "t = inf"
        text = f"ray {ray[k]}: {got} on a second mesh, after the same ray on a first one, "
        return Example(f"{text}but {expected} is right there", expected=expected, got=got)

    return judged(wrong[ray], example)


def _judged(case: HitCase, looked_at: Mask) -> Evidence:
    """Apply the rule of closest hits to some of the rays."""
    judgement = judge(case.trial.answers, case.hits.t)
    ray = np.flatnonzero(looked_at & ~judgement.uncounted)
    wrong = judgement.missed_closer | judgement.no_surface
    return judged(wrong[ray], lambda k: _wrong_ray(case, judgement, int(ray[k])))


def _wrong_ray(case: HitCase, judgement: Judgement, ray: int) -> Example:
    """Word one ray with a wrong t."""
    got = _told(case.hits.t[ray])
    face, t = _closest(case.trial.answers, ray)
    expected = f"a hit on face {face} at t = {t:.9g}" if face >= 0 else "t = inf"
    if judgement.missed_closer[ray]:
        reason = f"but face {face} is hit at {t:.9g}"
    elif face >= 0:
        reason = f"but no face is there; the closest is face {face} at {t:.9g}"
    else:
        reason = "but no face is there"
    text = f"{_named(case.trial, ray)}: {got}, {reason}"
    return Example(text, expected=expected, got=got)


def _closest(answers: Answers, ray: int) -> tuple[int, np.float32]:
    """Return face and t of the closest sure hit; face -1 if there is none."""
    nearest = closest_sure(answers, ray)
    if nearest < 0:
        return -1, np.float32(np.inf)
    return int(answers.face[nearest]), np.float32(answers.t[nearest])


def _named(trial: TraceTrial, ray: int) -> str:
    """Say which ray is meant, so that it can be typed into a test."""
    rays: Rays = trial.rays
    family = trial.families[trial.family[ray]]
    text = f"ray {ray} ({family}) from {vector(rays.origin[ray])}"
    text += f" along {vector(rays.direction[ray])}"
    if rays.t_min[ray] != np.float32(EPSILON) or rays.t_max[ray] != np.inf:
        text += f" with t in ({rays.t_min[ray]:.9g}, {rays.t_max[ray]:.9g})"
    return text


def _told(t: np.float32) -> str:
    """Say what was returned."""
    return f"t is {t:.9g}"


def _normals_are_wrong(case: HitCase, judgement: Judgement) -> Mask:
    """Return (R,) bool, True where no face that explains t has the returned normal."""
    candidate = np.flatnonzero(judgement.near)
    ray = owners(case.trial.answers)[candidate]
    error, allowed = normal_errors(case, candidate, ray)
    right = np.zeros(case.hits.t.size, dtype=np.bool_)
    right[ray[error <= allowed]] = True
    with np.errstate(invalid="ignore", over="ignore"):
        length = np.sqrt((case.hits.normal.astype(np.float64) ** 2).sum(axis=1))
        unit = np.abs(length - 1) <= UNIT_LENGTH
    wrong: Mask = ~(right & unit)
    return wrong


def _misplaced(case: HitCase, ray: int) -> Example:
    """Word a point that is not on the ray at t."""
    rays, t = case.trial.rays, case.hits.t[ray]
    point = rays.origin[ray].astype(np.float64) + np.float64(t) * rays.direction[ray]
    expected, got = vector(point), vector(case.hits.point[ray])
    text = f"{_named(case.trial, ray)}: intersection_point is {got}, but at t = {t:.9g} is "
    return Example(text + expected, expected=expected, got=got)


def _turned(case: HitCase, ray: int, face: int) -> Example:
    """Word a wrong normal."""
    mesh = case.trial.mesh
    a, b, c = mesh.vertices[mesh.faces[face]].astype(np.float64)
    normal = np.cross(b - a, c - a)
    expected = vector(normal / np.linalg.norm(normal))
    got = vector(case.hits.normal[ray])
    text = f"{_named(case.trial, ray)}: normal is {got}, but face {face} has {expected}"
    return Example(text, expected=expected, got=got)


def _differ(first: Hits, again: Hits) -> Mask:
    """Return (R,) bool, True where two records of the same ray differ in a bit."""
    differ: Mask = first.t.view(np.uint32) != again.t.view(np.uint32)
    hit = np.isfinite(first.t)
    for one, other in ((first.point, again.point), (first.normal, again.normal)):
        differ |= hit & (one.view(np.uint32) != other.view(np.uint32)).any(axis=1)
    return differ


def _record(hits: Hits, ray: int) -> str:
    """Write a whole record."""
    point, normal = vector(hits.point[ray]), vector(hits.normal[ray])
    return f"t = {hits.t[ray]:.9g}, point {point}, normal {normal}"
