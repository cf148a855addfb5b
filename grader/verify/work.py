"""Does `intersect` use the tree, and is it much faster for it?"""

import numpy as np

from grader.model.cases import AlteredCase, WorkCase
from grader.model.mesh import Integers, Mask
from grader.model.verdict import Evidence, Example
from grader.tolerances import SLOWEST, SPECIAL_WASTE, START_SECONDS, WASTE
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
        return one(example)
    still = _finds_what_is_gone(case)[lost]
    return judged(still, lambda k: _example(case, int(lost[k])))


@check(WorkCase, "work.excludes-most-triangles")
def excludes_most_triangles(case: WorkCase) -> Evidence:
    """Few boxes and triangles are tested for a ray; its time hardly grows with the mesh.

    Counted are the calls of the two given tests. Time decides where a submission tests by
    itself, or copies the tree or the mesh for every ray.
    Source: exercise sheet, part b, "to quickly exclude the majority of triangles".
    """
    wasteful, slow = _wasteful(case), _slow(case)
    examples = [each for each in (wasteful, slow) if each]
    return Evidence(
        examined=case.hits.t.size,
        wrong=case.hits.t.size if examples else 0,
        examples=tuple(examples),
    )


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


def _wasteful(case: WorkCase) -> Example | None:
    """Compare the counted tests with a plain traversal's."""
    tests = case.box_tests + case.triangle_tests
    plain = case.trial.box_tests + case.trial.triangle_tests
    allowed = (SPECIAL_WASTE if case.trial.special else WASTE) * plain
    if tests <= allowed:
        return None
    return Example(
        f"a ray takes {case.box_tests:.1f} box tests and {case.triangle_tests:.1f} triangle "
        f"tests on average, but a plain traversal takes "
        f"{case.trial.box_tests:.1f} and {case.trial.triangle_tests:.1f}",
        expected=f"at most {allowed:.0f} tests per ray",
        got=f"{tests:.0f} tests per ray",
    )


def _slow(case: WorkCase) -> Example | None:
    """Compare the time with the reference's; names no seconds, which differ from run to run."""
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
