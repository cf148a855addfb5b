"""Which mistake explains what is left of earlier calls, and what a ray costs?"""

import numpy as np

from grader.diagnose.hypothesis import NOTHING, Support, hypothesis
from grader.diagnose.notes import Notes
from grader.model.cases import RebuildCase, RepeatCase, WorkCase
from grader.model.mesh import Bvh, Hits
from grader.tolerances import WASTE
from grader.verify.rebuild import rebuild_starts_afresh
from grader.verify.work import takes_long

NEARLY_ALL = 0.9


def _same_tree(a: Bvh, b: Bvh) -> bool:
    return all(
        np.array_equal(one, other)
        for one, other in (
            (a.begin, b.begin),
            (a.end, b.end),
            (a.order, b.order),
            (a.low, b.low),
        )
    )


@hypothesis(RebuildCase, "rebuild.mesh-changed", least=1)
def mesh_changed(case: RebuildCase) -> Support:
    """`construct` changes the mesh, which it may only read."""
    changed = any(
        not np.array_equal(given.faces, after.faces)
        or not np.array_equal(given.vertices.view(np.uint32), after.vertices.view(np.uint32))
        for _, given, after in case.meshes
    )
    return Support(int(changed), int(not changed))


@hypothesis(RebuildCase, "rebuild.not-built-again", least=1)
def not_built_again(case: RebuildCase) -> Support:
    """Nothing is built where there seems to be a tree already, though it is another mesh's."""
    _, _, first = case.trees[0]
    again = [
        (mesh, bvh) for name, mesh, bvh in case.trees[1:] if name.startswith("second call")
    ]
    missing = any(len(mesh.faces) and not len(bvh.end) for _, mesh, bvh in case.trees[1:])
    unbuilt = missing or any(_same_tree(first, bvh) for _, bvh in again)
    return Support(int(unbuilt), 0)


@hypothesis(RebuildCase, "rebuild.something-left", least=1, general=True)
def something_left(case: RebuildCase) -> Support:
    """Something of the first call is still there in the second: static, or not emptied."""
    return Support(int(bool(rebuild_starts_afresh.decide(case).wrong)), 0)


def _differs(first: Hits, again: Hits) -> int:
    return int(np.count_nonzero(first.t.view(np.uint32) != again.t.view(np.uint32)))


def _by_circumstance(case: RepeatCase) -> tuple[int, int]:
    """Count the rays that differ from threads, and those that differ in any other order."""
    threads = sum(_differs(case.first, hits) for when, hits in case.again if "thread" in when)
    orders = sum(
        _differs(case.first, hits) for when, hits in case.again if "thread" not in when
    )
    return threads, orders


@hypothesis(RepeatCase, "state.shared-by-threads", least=10)
def shared_by_threads(case: RepeatCase) -> Support:
    """Several threads share a variable that each of them needs for itself."""
    threads, orders = _by_circumstance(case)
    return Support(threads, orders)


@hypothesis(RepeatCase, "state.kept-between-rays", least=1)
def kept_between_rays(case: RepeatCase) -> Support:
    """The result of a ray depends on the rays before it: something is kept between calls."""
    _, orders = _by_circumstance(case)
    return Support(orders, 0)


@hypothesis(RepeatCase, "state.kept-between-meshes", least=10)
def kept_between_meshes(case: RepeatCase) -> Support:
    """What was found on one mesh, or its tree, is used for another one."""
    threads, orders = _by_circumstance(case)
    if threads or orders:
        return NOTHING
    hit = np.isfinite(case.first.t) | np.isfinite(case.other.t)
    same = (case.first.t == case.other.t) | ~np.isfinite(case.other.t)
    return Support(int((same & hit).sum()), int((~same & hit).sum()))


@hypothesis(WorkCase, "work.every-face-tested", least=1)
def every_face_tested(case: WorkCase) -> Support:
    """Every face is tested for every ray: the boxes of the nodes decide nothing."""
    all_faces = case.triangle_tests >= NEARLY_ALL * len(case.trial.mesh.faces)
    found = all_faces and case.box_tests < 2
    return Support(int(found), int(not found))


@hypothesis(WorkCase, "work.boxes-exclude-nothing", least=1)
def boxes_exclude_nothing(case: WorkCase) -> Support:
    """Boxes are tested but exclude hardly anything: they are too large, or compared wrongly."""
    all_faces = case.triangle_tests >= NEARLY_ALL * len(case.trial.mesh.faces)
    found = all_faces and case.box_tests > case.trial.box_tests
    return Support(int(found), int(not found))


@hypothesis(WorkCase, "work.inner-boxes-not-tested", least=1)
def inner_boxes_not_tested(case: WorkCase) -> Support:
    """The boxes of some levels are not tested, so whole subtrees are not left out."""
    trial, faces = case.trial, len(case.trial.mesh.faces)
    leaves = int(np.count_nonzero(trial.tree.end)) // 2
    only_leaves = case.box_tests >= NEARLY_ALL * leaves and case.box_tests <= leaves + 2
    few_boxes = case.box_tests < trial.box_tests / 2
    only_upper = few_boxes and WASTE * trial.triangle_tests < case.triangle_tests < faces / 2
    found = bool(only_leaves or (only_upper and case.box_tests >= 2))
    return Support(int(found), int(not found))


@hypothesis(WorkCase, "work.boxes-tested-again", least=1)
def boxes_tested_again(case: WorkCase) -> Support:
    """The same box is tested again and again for one ray."""
    used = int(np.count_nonzero(case.trial.tree.end))
    found = case.box_tests > used and case.triangle_tests <= WASTE * case.trial.triangle_tests
    return Support(int(found), int(not found))


@hypothesis(Notes, "work.copies-per-ray", least=1)
def copies_per_ray(notes: Notes) -> Support:
    """Something as large as the mesh is copied, or made anew, for every ray."""
    cases = notes.of(WorkCase)
    # Who calls no given test may as well test every face by itself.
    wrong = [case for case in cases if takes_long(case) and case.triangle_tests]
    few = [
        case
        for case in cases
        if case.box_tests + case.triangle_tests
        <= WASTE * (case.trial.box_tests + case.trial.triangle_tests)
    ]
    return Support(len(wrong), len(cases) - len(few)) if wrong else NOTHING


STATES = (
    mesh_changed,
    not_built_again,
    something_left,
    shared_by_threads,
    kept_between_rays,
    kept_between_meshes,
    every_face_tested,
    boxes_exclude_nothing,
    inner_boxes_not_tested,
    boxes_tested_again,
    copies_per_ray,
)
