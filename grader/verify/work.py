"""Does `intersect` use the tree, and is it much faster for it?"""

import numpy as np

from grader.model.cases import AlteredCase, SurvivalCase, WorkCase
from grader.model.mesh import Integers, Mask
from grader.model.stages import Stop
from grader.model.trials import WorkTrial
from grader.model.verdict import Evidence, Example
from grader.tolerances import (
    ANSWERED,
    FEW,
    FORFEIT,
    LARGE_MESH,
    SLOWEST,
    SPECIAL_WASTE,
    START_SECONDS,
    WASTE,
)
from grader.verify.check import check, judged, one, vector
from grader.verify.closest import judge


@check(AlteredCase, "work.uses-the-tree")
def uses_the_tree(case: AlteredCase) -> Evidence:
    """Hits are found through the tree: what is taken out of the tree is not hit any more.

    Source: exercise sheet, part b, "Traverse the BVH's Nodes".
    """
    lost = np.flatnonzero(case.trial.lost)
    control = np.flatnonzero(~case.trial.lost & np.isfinite(case.trial.answers.limit))
    if not np.isfinite(case.hits.t[control]).any():
        return one(
            Example(
                f"none of {control.size} rays hits anything on a tree where "
                f"{case.trial.change}, but their faces are all still in it",
                expected="hits on the faces that are left",
                got="no hit",
            )
        )
    if example := _is_untouched(case, lost, control):
        return Evidence(1, 1, (example,), bypassed=True)
    still = _finds_what_is_gone(case)[lost]
    return judged(still, lambda k: _example(case, int(lost[k])))


@check(WorkCase, "work.excludes-most-triangles")
def excludes_most_triangles(case: WorkCase) -> Evidence:
    """Few boxes and triangles are tested for a ray; its time hardly grows with the mesh.

    Counted are the calls of the two given tests. Time decides where a submission tests by
    itself, or copies the tree or the mesh for every ray.
    Source: exercise sheet, part b, "to quickly exclude the majority of triangles".
    """
    unanswered, wasteful, slow = _unanswered(case), _wasteful(case), takes_long(case)
    examples = [each for each in (unanswered, wasteful, slow) if each]
    return Evidence(
        examined=case.hits.t.size,
        wrong=case.hits.t.size if examples else 0,
        examples=tuple(examples),
        forfeits=bool(unanswered) or (bool(wasteful) and _excludes_nothing(case)),
    )


def unproven(case: SurvivalCase) -> Evidence | None:
    """Judge who does not come back from the large mesh: without it no growth is seen.

    Otherwise a submission that tests all faces, fast enough for small meshes, had only to die.
    """
    trial = case.trial
    if case.ending.stop is Stop.FINISHED or not isinstance(trial, WorkTrial):
        return None
    faces = len(trial.mesh.faces)
    if faces <= LARGE_MESH:
        return None
    example = Example(
        f"no answer on {faces:,} faces: nothing shows that most of them are "
        "excluded, which costs all points",
        expected="an answer for every ray",
        got="none",
    )
    return Evidence(1, 1, (example,), case.ending.stop, forfeits=True)


def _is_untouched(case: AlteredCase, lost: Integers, control: Integers) -> Example | None:
    """Word answers that do not come from the tree, whatever else may be wrong with them.

    Through the tree, some hit of what is left stays the same to the bit, and some answer of a
    ray whose face is gone becomes another one.
    """
    if case.sound is None:
        return None
    same = (case.hits.t == case.sound.t) & np.isfinite(case.hits.t)
    if not same[control].any():
        return Example(
            f"none of {control.size} rays gets the same t on a tree where {case.trial.change}, "
            "but the faces that they hit are all still in it",
            expected="the same t for rays whose faces are left",
            got="another t for every ray",
        )
    if lost.size and same[lost].all():
        return Example(
            f"all of {lost.size} rays get the same t on a tree where {case.trial.change}, but "
            "the faces that they hit cannot be reached in it",
            expected="another t for rays whose faces are gone",
            got="the same t for every ray",
        )
    return None


def _finds_what_is_gone(case: AlteredCase) -> Mask:
    """Return (R,) bool, True where the hit on the unaltered tree is reported."""
    judgement = judge(case.trial.answers, case.hits.t)
    return (judgement.accepted >= 0) & ~judgement.missed_closer


def _example(case: AlteredCase, ray: int) -> Example:
    """Word one hit that the tree does not lead to."""
    rays, t = case.trial.rays, case.hits.t[ray]
    face = case.trial.answers.face[case.trial.answers.first[ray]]
    return Example(
        f"ray {ray} from {vector(rays.origin[ray])} along {vector(rays.direction[ray])}: t is "
        f"{t:.9g}, but face {face} cannot be reached in a tree where {case.trial.change}",
        expected=f"no hit on face {face}",
        got=f"t is {t:.9g}",
    )


def _unanswered(case: WorkCase) -> Example | None:
    """Word that rays were not traced: an answer without a search costs no test and no time.

    Only hit or miss counts here, and only on a mesh where testing all faces takes too long.
    Which face is hit, other checks say, and whoever takes a wrong one has searched, too.
    """
    faces = len(case.trial.mesh.faces)
    if faces <= LARGE_MESH:
        return None
    got, true = np.isfinite(case.hits.t), np.isfinite(case.reference_t)
    for rays, what, other in ((true, "a hit", "no hit"), (~true, "no hit", "a hit")):
        if rays.sum() < FEW:
            continue
        share = (got == true)[rays].mean()
        if share < ANSWERED:
            return Example(
                f"{rays.sum():,} rays have {what} among {faces:,} faces, but "
                f"{(got != true)[rays].sum():,} of them get {other}: nothing shows that most "
                "faces are excluded, which costs all points",
                expected=f"{what} for nearly all of these rays",
                got=f"{what} for {share:.0%} of them",
            )
    return None


def _tests(case: WorkCase) -> float:
    """Return how many boxes and triangles are tested for a ray, on average."""
    return case.box_tests + case.triangle_tests


def _excludes_nothing(case: WorkCase) -> bool:
    """Tell whether the tests are so many that the check is worth no point at all."""
    return _tests(case) > FORFEIT * len(case.trial.mesh.faces)


def _wasteful(case: WorkCase) -> Example | None:
    """Compare the counted tests with a plain traversal's."""
    tests = _tests(case)
    plain = case.trial.box_tests + case.trial.triangle_tests
    allowed = (SPECIAL_WASTE if case.trial.special else WASTE) * plain
    if tests <= allowed:
        return None
    faces = len(case.trial.mesh.faces)
    far = [f"; a twentieth of {faces:,} faces costs all points"] * _excludes_nothing(case)
    return Example(
        f"a ray takes {case.box_tests:.1f} box tests and {case.triangle_tests:.1f} triangle "
        f"tests on average, but a plain traversal takes "
        f"{case.trial.box_tests:.1f} and {case.trial.triangle_tests:.1f}{''.join(far)}",
        expected=f"at most {allowed:.0f} tests per ray",
        got=f"{tests:.0f} tests per ray",
    )


def takes_long(case: WorkCase) -> Example | None:
    """Compare the time with the reference's; names no seconds, which differ from run to run.

    Compared is the time on each mesh, of 9,800, 11,102 and 202,520 faces, and not how it grows
    from one to the next. That is stricter with who is slow on all of them, and lets pass whose
    time grows faster than the reference's but stays within 10 times of it. Who tests all faces
    does not stay there: 20,000 rays among 202,520 faces are 4 x 10^9 tests, and the limit
    leaves 0.3 ns for each.
    """
    allowed = START_SECONDS + SLOWEST * case.reference_cpu_seconds
    if case.cpu_seconds <= allowed:
        return None
    rays, faces = case.hits.t.size, len(case.trial.mesh.faces)
    return Example(
        f"{rays:,} rays among {faces:,} faces take more than {SLOWEST:.0f} times as long as "
        "the model solution takes; does every ray copy the tree or the mesh?",
        expected=f"at most {SLOWEST:.0f} times the model solution's time",
        got=f"more than {SLOWEST:.0f} times",
    )
