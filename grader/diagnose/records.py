"""Which mistake explains what is returned for a miss, and beside t for a hit?"""

from collections.abc import Callable

import numpy as np

from grader.diagnose.hypothesis import NOTHING, Hypothesis, Support, weighed
from grader.diagnose.paths import passes
from grader.diagnose.shots import MOST_FACES, shots
from grader.model.cases import HitCase
from grader.model.mesh import Doubles, Mask
from grader.verify.closest import is_ambiguous, judge, owners
from grader.verify.shading import normal_errors, point_errors

LARGE = 1e5

Missed = Callable[[HitCase, np.ndarray], Mask]
"""From the rays that meet nothing: where a mistake explains what was returned."""


def _misses(case: HitCase, explains: Missed) -> Support:
    ray = np.flatnonzero(np.diff(case.trial.answers.first) == 0)
    if not ray.size or shots(case) is None:
        return NOTHING
    return weighed(explains(case, ray), case.hits.t[ray] == np.inf)


def _is_negative(case: HitCase, ray: np.ndarray) -> Mask:
    return np.asarray(case.hits.t[ray] == -1)


def _is_a_start(case: HitCase, ray: np.ndarray) -> Mask:
    """What a search may begin with: t_max, or one large number for all rays."""
    t, t_max = case.hits.t[ray], case.trial.rays.t_max[ray]
    largest = t[np.isfinite(t)].max(initial=0)
    return np.asarray(((t == largest) | (t == t_max)) & (largest > LARGE))


def _is_in_a_box(case: HitCase, ray: np.ndarray) -> Mask:
    """Something finite where, and only where, the ray meets the box of the mesh."""
    given = shots(case)
    if given is None:
        return np.zeros(ray.size, dtype=np.bool_)
    meets = passes(given, case.trial.tree)[:, 0]
    missing = np.isin(given.ray, ray)
    finite = np.isfinite(given.got)
    told_apart = missing.any() and (finite == meets)[missing].mean() > 0.99
    sure = np.isfinite(given.limit)
    hits_are_right = given.right[sure].mean() > 0.9 if sure.any() else True
    return np.full(ray.size, bool(told_apart and hits_are_right))


def _missed(id: str, sentence: str, explains: Missed) -> Hypothesis:
    return Hypothesis(id, HitCase, sentence, lambda case: _misses(case, explains))


Part = tuple[Doubles, Doubles]
"""(K, 3) float64 twice: what was returned, and what a right submission returns."""


Explains = Callable[[HitCase, np.ndarray, np.ndarray], Mask]


def _hit(case: HitCase, explains: Explains, sometimes: bool) -> Support:
    """Look at the hits whose t is right, at the face that t means.

    Args:
        case: The case.
        explains: From rays and faces: where a mistake explains normal and point.
        sometimes: Whether some hits may be right in spite of the mistake.
    """
    if len(case.trial.mesh.faces) > 4 * MOST_FACES:
        return NOTHING
    answers = case.trial.answers
    judgement = judge(answers, case.hits.t)
    # Where several faces may be meant, nobody knows which one it was.
    times = np.bincount(owners(answers)[judgement.near], minlength=case.hits.t.size)
    ray = np.flatnonzero((times == 1) & ~judgement.missed_closer & ~is_ambiguous(answers))
    if not ray.size:
        return NOTHING
    candidate = judgement.accepted[ray]
    with np.errstate(all="ignore"):
        error, allowed = normal_errors(case, candidate, ray)
        off, most = point_errors(case, judgement.accepted)
        right = (error <= allowed) & (off[ray] <= most[ray])
        explained = explains(case, ray, answers.face[candidate])
        return weighed(explained | right if sometimes else explained, right)


def _cross(case: HitCase, face: np.ndarray) -> Doubles:
    a, b, c = (
        case.trial.mesh.vertices[case.trial.mesh.faces[face]]
        .astype(np.float64)
        .transpose(1, 0, 2)
    )
    return np.asarray(np.cross(b - a, c - a))


def _unit(vectors: Doubles) -> Doubles:
    return np.asarray(vectors / np.sqrt((vectors**2).sum(axis=1, keepdims=True)))


def _near(a: Doubles, b: Doubles) -> Mask:
    size = np.abs(b).max(axis=1, keepdims=True)
    return np.asarray((np.abs(a - b) <= 1e-3 * size + 1e-30).all(axis=1))


def _normal(case: HitCase, ray: np.ndarray) -> Doubles:
    return np.asarray(case.hits.normal[ray].astype(np.float64))


def _flipped(case: HitCase, ray: np.ndarray, face: np.ndarray) -> Mask:
    return _near(_normal(case, ray), -_unit(_cross(case, face)))


def _long(case: HitCase, ray: np.ndarray, face: np.ndarray) -> Mask:
    cross = _cross(case, face)
    return _near(_normal(case, ray), cross) | _near(_normal(case, ray), -cross)


def _turned(case: HitCase, ray: np.ndarray, face: np.ndarray) -> Mask:
    normal = _unit(_cross(case, face))
    along = (normal * case.trial.rays.direction[ray]).sum(axis=1, keepdims=True)
    return _near(_normal(case, ray), np.where(along > 0, -normal, normal))


def _point_is(
    make: Callable[[HitCase, np.ndarray], Doubles], normal_too: bool = False
) -> Explains:
    """Explain a point, and whether the normal is lost with it."""

    def explains(case: HitCase, ray: np.ndarray, face: np.ndarray) -> Mask:
        wanted, got = make(case, ray), case.hits.point[ray].astype(np.float64)
        true = _without_origin(case, ray) + case.trial.rays.origin[ray]
        good = _near(got, wanted) | (got == wanted).all(axis=1)
        lost = (case.hits.normal[ray] == 0).all(axis=1)
        told_apart = normal_too | ~_near(true, wanted) | _near(got, true)
        return np.asarray(good & (lost == normal_too) & told_apart)

    return explains


def _zero(case: HitCase, ray: np.ndarray) -> Doubles:
    return np.zeros((ray.size, 3))


def _without_origin(case: HitCase, ray: np.ndarray) -> Doubles:
    return np.asarray(
        case.hits.t[ray, None].astype(np.float64) * case.trial.rays.direction[ray]
    )


def _from_t_min(case: HitCase, ray: np.ndarray) -> Doubles:
    rays = case.trial.rays
    t = (case.hits.t[ray].astype(np.float64) - rays.t_min[ray])[:, None]
    return np.asarray(rays.origin[ray] + t * rays.direction[ray])


def _of_another(case: HitCase, ray: np.ndarray, face: np.ndarray) -> Mask:
    """The normal is that of some face, though not of the one that t means."""
    mesh = case.trial.mesh
    normals = _unit(_cross(case, np.arange(len(mesh.faces))))
    normals = np.unique(np.round(normals[np.isfinite(normals).all(axis=1)], 3), axis=0)
    got = np.round(_normal(case, ray), 3)
    known = {tuple(each) for each in (normals + 0.0).tolist()}
    other = [tuple(each) in known for each in (got + 0.0).tolist()]
    own = _near(_normal(case, ray), _unit(_cross(case, face)))
    return np.array(other, dtype=np.bool_) & ~own


def _kept(id: str, sentence: str, explains: Explains, sometimes: bool = False) -> Hypothesis:
    return Hypothesis(id, HitCase, sentence, lambda case: _hit(case, explains, sometimes))


RECORDS = (
    _missed("miss.minus-one", "A miss has t = -1, where it has to be infinite.", _is_negative),
    _missed(
        "miss.keeps-the-start",
        "A miss keeps the number that the search begins with as its t, not infinity.",
        _is_a_start,
    ),
    _missed(
        "miss.distance-to-a-box",
        "A ray that meets a box but no triangle gets a finite t, though it hits nothing.",
        _is_in_a_box,
    ),
    _kept(
        "record.normal-flipped",
        "The normal points to the other side: the edges of the cross product are exchanged.",
        _flipped,
    ),
    _kept("record.normal-not-normalised", "The normal is not of length 1.", _long),
    _kept("record.normal-turned", "The normal is turned towards the ray.", _turned),
    _kept(
        "record.only-t",
        "Only t of the closest hit is kept; its point and its normal are lost.",
        _point_is(_zero, normal_too=True),
        sometimes=True,
    ),
    _kept("record.point-missing", "The intersection point is never set.", _point_is(_zero)),
    _kept(
        "record.point-without-origin",
        "The intersection point is t times the direction: the origin is not added.",
        _point_is(_without_origin),
    ),
    _kept(
        "record.point-from-t-min",
        "The intersection point is computed from t - t_min instead of from t.",
        _point_is(_from_t_min),
    ),
    _kept(
        "record.of-another-face",
        "Point or normal are those of another face than the one that t belongs to.",
        _of_another,
        sometimes=True,
    ),
)
