"""Hits of a right solution pass; each single mistake fails the check that names it."""

from dataclasses import replace

import numpy as np
import pytest

from grader.model.cases import HitCase, RepeatCase
from grader.model.mesh import Bvh, Hits, Mesh, Rays
from grader.model.trials import RepeatTrial, TraceTrial
from grader.oracle.brute import answers, chosen
from grader.oracle.rays import Request, rays_on
from grader.verify import hits as checks
from grader.verify.check import Check
from tests.oracle.tracer import trace
from tests.oracle.treebuilder import planted

CHECKS = (
    checks.closest_wins,
    checks.misses_stay_infinite,
    checks.special_rays,
    checks.record_is_complete,
)


def a_case(special: bool = False, name: str = "terrain-600") -> HitCase:
    """Trace a mesh rightly."""
    mesh, tree = planted(name)
    family = rays_on(Request(2, name, special, count=40), mesh, tree)
    trial = TraceTrial(
        name=name,
        mesh=mesh,
        tree=tree,
        rays=family.rays,
        answers=answers(mesh, family.rays, tree),
        families=family.names,
        family=family.index,
        special=special,
    )
    return HitCase(name, trial, trace(mesh, family.rays, tree))


def failing(case: HitCase) -> set[str]:
    """Return the ids of the checks that find something wrong, of those that look."""
    return {check.id for check in CHECKS if check.when(case.trial) and check.decide(case).wrong}


def spoiled(case: HitCase, **arrays: np.ndarray) -> HitCase:
    """Replace some arrays of the hits."""
    return replace(case, hits=replace(case.hits, **arrays))


@pytest.mark.parametrize("special", [False, True])
@pytest.mark.parametrize("name", ["terrain-600", "touching-boxes", "soup-degenerate"])
def test_a_right_solution_passes(name: str, special: bool) -> None:
    """No check finds anything, and every one that looks has something to look at."""
    case = a_case(special, name)
    assert failing(case) == set()
    for check in CHECKS:
        if check.when(case.trial):
            assert check.decide(case).examined > 10


@pytest.mark.parametrize("t", [np.nan, -np.inf, -1.0, 0.0, 1e30])
def test_nonsense_is_wrong_everywhere(t: float) -> None:
    """Not-a-number, minus infinity and other nonsense in t are no hit and no miss."""
    case = a_case()
    size = case.hits.t.size
    nonsense = spoiled(case, t=np.full(size, t, np.float32))
    found = {check.id: check.decide(nonsense) for check in CHECKS[:2]}
    assert all(evidence.wrong == evidence.examined > 0 for evidence in found.values())


def test_one_farther_hit_is_named() -> None:
    """The message names ray, family, both distances and the face that was missed."""
    case = a_case()
    ray = int(np.flatnonzero(np.isfinite(case.trial.answers.limit))[5])
    t = case.hits.t.copy()
    t[ray] *= np.float32(1.5)
    evidence = checks.closest_wins.decide(spoiled(case, t=t))
    assert evidence.wrong == 1
    (example,) = evidence.examples
    assert example.message.startswith(f"ray {ray} (")
    assert f"t is {t[ray]:.9g}, but face " in example.message
    assert example.expected.startswith("a hit on face")
    assert example.got == f"t is {t[ray]:.9g}"


def test_a_hit_in_front_of_the_surface_is_named() -> None:
    """A t where no face is fails too, though no closer hit was missed."""
    case = a_case()
    ray = int(np.flatnonzero(np.isfinite(case.trial.answers.limit))[0])
    t = case.hits.t.copy()
    t[ray] *= np.float32(0.9)
    (example,) = checks.closest_wins.decide(spoiled(case, t=t)).examples
    assert "but no face is there; the closest is face" in example.message


@pytest.mark.parametrize("t", [np.nan, 1.0, 3e38, -np.inf])
def test_a_miss_is_nothing_but_infinite(t: float) -> None:
    """A single expected miss with another t fails, and only that check does."""
    case = a_case()
    ray = int(np.flatnonzero(np.diff(case.trial.answers.first) == 0)[3])
    changed = case.hits.t.copy()
    changed[ray] = t
    assert failing(spoiled(case, t=changed)) == {"hits.misses-stay-infinite"}


def test_special_rays_have_a_check_of_their_own() -> None:
    """A wrong special ray, hit or miss, costs nothing in the checks of ordinary ones."""
    case = a_case(special=True)
    for where in (
        np.isfinite(case.trial.answers.limit),
        np.diff(case.trial.answers.first) == 0,
    ):
        t = case.hits.t.copy()
        t[np.flatnonzero(where)[0]] = np.float32(0.125)
        evidence = checks.special_rays.decide(spoiled(case, t=t))
        assert evidence.wrong == 1
        assert failing(spoiled(case, t=t)) == {"hits.special-rays"}


def test_t_limits_are_told_where_they_matter() -> None:
    """A ray with limits is described with them."""
    case = a_case(special=True)
    interval = case.trial.family == case.trial.families.index("t-interval")
    t = case.hits.t.copy()
    t[interval] = np.float32(np.nan)
    (example, *_) = checks.special_rays.decide(spoiled(case, t=t)).examples
    assert " with t in (" in example.message


@pytest.mark.parametrize("factor", [-1.0, 0.0, 2.0, 1 + 1e-5, np.nan])
def test_a_wrong_normal_fails(factor: float) -> None:
    """Turned round, missing, too long by a hundred-thousandth, or not a number."""
    case = a_case()
    normal = (case.hits.normal * factor).astype(np.float32)
    evidence = checks.record_is_complete.decide(spoiled(case, normal=normal))
    assert evidence.wrong == evidence.examined > 0
    assert failing(spoiled(case, normal=normal)) == {"hits.record-is-complete"}
    assert "normal is (" in evidence.examples[0].message


def test_the_normal_of_a_neighbour_fails() -> None:
    """A unit normal of another face is no normal of this one."""
    case = a_case()
    normal = np.roll(case.hits.normal, 1, axis=1)
    assert failing(spoiled(case, normal=normal)) == {"hits.record-is-complete"}


@pytest.mark.parametrize("offset", [1e-3, np.nan, np.inf])
def test_a_wrong_point_fails(offset: float) -> None:
    """A point that is a thousandth of the mesh off, or not a number."""
    case = a_case()
    moved = spoiled(case, point=case.hits.point + np.float32(offset))
    evidence = checks.record_is_complete.decide(moved)
    # A ray that grazes its face may be off by more.
    assert evidence.wrong >= evidence.examined - 2 > 50
    assert "intersection_point is (" in evidence.examples[0].message
    assert failing(moved) == {"hits.record-is-complete"}


@pytest.mark.parametrize("family", ["t-interval", "any-length", "along-axes"])
def test_special_hits_need_point_and_normal_too(family: str) -> None:
    """A ray with a limit, say a shadow ray, is answered as completely as any other."""
    case = a_case(special=True)
    where = case.trial.family == case.trial.families.index(family)
    for field in ("point", "normal"):
        array = getattr(case.hits, field).copy()
        array[where] = 0
        assert failing(spoiled(case, **{field: array})) == {"hits.record-is-complete"}


def test_points_of_misses_do_not_matter() -> None:
    """Nobody says what a miss's point and normal are."""
    case = a_case()
    miss = ~np.isfinite(case.hits.t)
    point, normal = case.hits.point.copy(), case.hits.normal.copy()
    point[miss], normal[miss] = np.nan, 7
    assert failing(spoiled(case, point=point, normal=normal)) == set()


def test_either_face_of_a_shared_edge_lends_its_normal() -> None:
    """Where two faces explain t, both normals are right."""
    case = a_case(name="touching-boxes")
    answer = case.trial.answers
    owner = np.repeat(np.arange(case.hits.t.size), np.diff(answer.first))
    corners = case.trial.mesh.vertices[case.trial.mesh.faces[answer.face]].astype(np.float64)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    for order in (slice(None), slice(None, None, -1)):
        normal = case.hits.normal.copy()
        near = np.abs(case.hits.t[owner] - answer.t) <= answer.tolerance
        picked = np.flatnonzero(near)[order]
        normal[owner[picked]] = normals[picked]
        assert failing(spoiled(case, normal=normal)) == set()


def repeated(first: Hits, **again: Hits) -> RepeatCase:
    """Make a case in which rays were traced again."""
    mesh, tree = planted("cloud-5")
    drawn = rays_on(Request(1, "cloud-5", False, count=5), mesh, tree).rays
    rays = chosen(drawn, np.arange(first.t.size))
    found = answers(mesh, rays, tree)
    trial = RepeatTrial("again", mesh, tree, mesh, tree, rays, found, found)
    return RepeatCase("again", trial, first, tuple(again.items()), trace(mesh, rays, tree))


def three_hits() -> Hits:
    """Make a hit, a miss and a hit."""
    return Hits(
        np.arange(9, dtype=np.float32).reshape(3, 3),
        np.array([1, np.inf, 2], np.float32),
        np.eye(3, dtype=np.float32),
    )


@pytest.mark.parametrize("field", ["t", "point", "normal"])
def test_one_bit_makes_a_call_dependent(field: str) -> None:
    """The last bit of any number of a hit counts; the message says in which circumstance."""
    first = three_hits()
    changed = getattr(first, field).copy()
    changed.view(np.uint32).reshape(-1)[-1] ^= 1
    case = repeated(first, backwards=first, threads=replace(first, **{field: changed}))
    evidence = checks.calls_are_independent.decide(case)
    assert (evidence.examined, evidence.wrong) == (6 + case.other.t.size, 1)
    assert evidence.examples[0].message.startswith("ray 2: ")
    assert " threads, but " in evidence.examples[0].message


def test_the_same_bits_are_the_same() -> None:
    """Equal hits pass, and so do misses with different points."""
    first = three_hits()
    point = first.point.copy()
    point[1] = np.nan
    case = repeated(first, again=replace(first, point=point))
    assert checks.calls_are_independent.decide(case).wrong == 0


def test_a_second_mesh_is_not_answered_from_the_first() -> None:
    """Repeating the same wrong hit is wrong too: on another mesh other faces are there."""
    t = np.full(3, 0.125, np.float32)
    case = repeated(replace(three_hits(), t=t), again=replace(three_hits(), t=t))
    alike = replace(case, other=replace(case.other, t=t))
    # The same mistake twice, where both meshes have the same answers.
    assert checks.calls_are_independent.decide(alike).wrong == 0
    first = replace(case.trial.answers, limit=np.full(3, 7.0))
    taken_over = replace(alike, trial=replace(case.trial, answers=first))
    evidence = checks.calls_are_independent.decide(taken_over)
    assert evidence.wrong == case.other.t.size
    assert " on a second mesh, " in evidence.examples[0].message


def test_another_mistake_on_a_second_mesh_is_not_a_matter_of_repetition() -> None:
    """A wrong hit that is not the first mesh's is what the other checks are for."""
    t = np.full(3, 0.125, np.float32)
    case = repeated(three_hits(), again=three_hits())
    elsewhere = replace(case, other=replace(case.other, t=t))
    assert checks.calls_are_independent.decide(elsewhere).wrong == 0


@pytest.mark.parametrize("check", [*CHECKS, checks.calls_are_independent])
def test_hits_need_a_solution_that_uses_the_tree(check: Check) -> None:
    """A solution that ignores the tree earns nothing here."""
    assert check.needs == ("work.uses-the-tree",)


def test_empty_meshes_are_left_to_special_rays() -> None:
    """Where nothing can be hit, no check waits for a hit."""
    mesh: Mesh
    tree: Bvh
    mesh, tree = planted("cloud-0")
    family = rays_on(Request(1, "cloud-0", False, count=5), mesh, tree)
    rays: Rays = family.rays
    trial = TraceTrial(
        "empty", mesh, tree, rays, answers(mesh, rays, tree), family.names, family.index, False
    )
    looking = {check.id for check in CHECKS if check.when(trial)}
    assert looking == {"hits.misses-stay-infinite"}
