"""The rule of closest hits, on scenes whose answers are known without it."""

import numpy as np
import pytest

from grader.model.mesh import EDGE, SOLID, WILD, Answers, Mask, Mesh, Rays
from grader.oracle.brute import answers, candidates, classified, nearest
from grader.oracle.culling import all_pairs
from grader.oracle.hierarchy import leaves_of
from grader.oracle.rays import Request, rays_on
from grader.verify.closest import is_ambiguous, judge
from tests.oracle.tracer import trace_all
from tests.oracle.treebuilder import planted, tree_of

JUDGED = (
    "cloud-1",
    "cloud-5",
    "identical-9",
    "cloud-37",
    "terrain-600",
    "terrain-1200",
    "ball-1280",
    "nested-spheres",
    "soup-degenerate",
    "parallel-quads",
    "touching-boxes",
    "strip-x",
    "plane-xy",
    "huge-and-small",
    "far-away",
    "scaled-small",
    "scaled-large",
    "dragon-res4",
)


def one_ray(
    origin: tuple[float, float, float],
    direction: tuple[float, float, float],
    t_min: float = 1e-5,
    t_max: float = np.inf,
) -> Rays:
    """Make one ray."""
    return Rays(
        np.array([origin], np.float32),
        np.array([direction], np.float32),
        np.array([t_min], np.float32),
        np.array([t_max], np.float32),
    )


def triangle() -> Mesh:
    """Make the triangle (0,0,0) (4,0,0) (0,4,0)."""
    corners = np.array([[0, 0, 0], [4, 0, 0], [0, 4, 0]], np.float32)
    return Mesh(corners, np.array([[0, 1, 2]], np.uint32))


DOWN = (0.0, 0.0, -2.0)


@pytest.mark.parametrize(
    ("rays", "kinds"),
    [
        (one_ray((1, 1, 4), DOWN), [SOLID]),
        (one_ray((1, 1, -4), (0, 0, 2)), [SOLID]),
        (one_ray((1, 0, 4), DOWN), [EDGE]),
        (one_ray((0, 0, 4), DOWN), [EDGE]),
        (one_ray((2, 2, 4), DOWN), [EDGE]),
        (one_ray((1, -0.001, 4), DOWN), []),
        (one_ray((1, 1, 4), (0, 0, 2)), []),
        (one_ray((1, 1, 4), DOWN, t_max=2), [EDGE]),
        (one_ray((1, 1, 4), DOWN, t_max=1.999), []),
        (one_ray((1, 1, 4), DOWN, t_min=2), [EDGE]),
        (one_ray((1, 1, 4), DOWN, t_min=1.999), [SOLID]),
        (one_ray((1, 1, 4), DOWN, t_min=2.001), []),
        (one_ray((1, 1, 0), DOWN), []),
        (one_ray((-1, 1, 0), (1, 0, 0)), [WILD]),
        (one_ray((-1, 1, 1), (1, 0, 0)), []),
        (one_ray((-1, 1, 0), (1, 0, 0), t_max=0.5), []),
    ],
)
def test_a_triangle_answers_as_geometry_says(rays: Rays, kinds: list[int]) -> None:
    """Inside, on the border, past it, behind, at the limits, and in the triangle's plane."""
    mesh = triangle()
    found = candidates(mesh, rays, tree_of(mesh))
    assert found.kind.tolist() == kinds
    if kinds == [SOLID]:
        assert found.t[0] == 2.0
        assert found.tolerance[0] < 2e-5


def test_a_ball_is_hit_where_its_sphere_is() -> None:
    """Rays to the middle of a fine sphere hit it at its radius, less the facets' depth."""
    mesh, tree = planted("ball-1280")
    rng = np.random.default_rng(5)
    away = rng.standard_normal((500, 3))
    away /= np.linalg.norm(away, axis=1, keepdims=True)
    rays = Rays(
        (3 * away).astype(np.float32),
        (-away).astype(np.float32),
        np.full(500, 1e-5, np.float32),
        np.full(500, np.inf, np.float32),
    )
    limit = answers(mesh, rays, tree).limit
    clear = np.isfinite(limit)
    assert np.count_nonzero(clear) > 480
    assert (np.abs(limit[clear] - 2) < 0.02).all()


def equal(one: Answers, other: Answers) -> bool:
    """Tell whether two answers are the same bit by bit."""
    exact = ("limit", "first", "face", "tolerance", "kind")
    same_t = np.array_equal(one.t, other.t, equal_nan=True)
    return same_t and all(np.array_equal(getattr(one, n), getattr(other, n)) for n in exact)


@pytest.mark.parametrize("special", [False, True])
@pytest.mark.parametrize("name", [*JUDGED[3:], "zero-area", "stretched", "identical-1000"])
def test_culling_loses_nothing(name: str, special: bool) -> None:
    """The tree finds what testing every pair finds, to the last bit."""
    mesh, tree = planted(name)
    family = rays_on(
        Request(3, name, special, count=8 if len(mesh.faces) < 4000 else 2), mesh, tree
    )
    count = len(family.rays.t_min)
    every = classified(mesh, family.rays, all_pairs(len(mesh.faces), count))
    assert equal(answers(mesh, family.rays, tree), nearest(every, count))


@pytest.mark.parametrize("factor", [0.5, 1.0, 1.001, 3.0])
def test_a_cut_changes_nothing(factor: float) -> None:
    """However good or bad the guess of the closest hit, the answers are the same."""
    mesh, tree = planted("nested-spheres")
    rays = rays_on(Request(4, "nested-spheres", False, count=50), mesh, tree).rays
    plain = answers(mesh, rays, tree)
    assert equal(plain, answers(mesh, rays, tree, plain.limit * factor))


def test_a_mesh_without_faces_is_missed() -> None:
    """No faces, no candidates, and a tree with an empty root does no harm."""
    mesh, tree = planted("cloud-0")
    assert leaves_of(tree).tolist() == [True]
    rays = rays_on(Request(1, "cloud-0", False, count=5), mesh, tree).rays
    found = answers(mesh, rays, tree)
    assert found.face.size == 0
    assert (found.limit == np.inf).all()


@pytest.mark.parametrize("special", [False, True])
@pytest.mark.parametrize("name", JUDGED)
def test_the_given_test_is_never_rejected(name: str, special: bool) -> None:
    """The exercise's float32 triangle test is right on every ray of every family."""
    wrong = 0
    for seed in (1, 2):
        mesh, tree = planted(name, seed)
        rays = rays_on(Request(seed, name, special, count=100), mesh, tree).rays
        found = answers(mesh, rays, tree)
        hits, _ = trace_all(mesh, rays, tree)
        judgement = judge(found, hits.t)
        wrong += int(np.count_nonzero(judgement.missed_closer | judgement.no_surface))
    assert wrong == 0


def clear_hits(found: Answers) -> Mask:
    """Return (R,) bool, True for rays with one sure answer that is a hit."""
    return np.isfinite(found.limit) & ~is_ambiguous(found)


@pytest.mark.parametrize(
    "name", ["terrain-1200", "nested-spheres", "dragon-res4", "scaled-large"]
)
def test_wrong_distances_are_rejected(name: str) -> None:
    """A t off by 1e-4, the second closest hit, and a miss are wrong on every clear ray."""
    mesh, tree = planted(name)
    rays = rays_on(Request(5, name, False, count=100), mesh, tree).rays
    found = answers(mesh, rays, tree)
    hits, second = trace_all(mesh, rays, tree)
    clear = clear_hits(found) & (rays.t_max == np.inf)
    tolerance = np.full(len(hits.t), np.inf)
    owner = np.repeat(np.arange(len(hits.t)), np.diff(found.first))
    np.minimum.at(tolerance, owner, found.tolerance)
    # A tolerance of half of 1e-4 is exceptional: grazing rays.
    sharp = clear & (tolerance < 4e-5 * hits.t)
    assert np.count_nonzero(sharp) > 0.8 * np.count_nonzero(clear)
    for factor in (1 - 1e-4, 1 + 1e-4):
        off = judge(found, (hits.t * factor).astype(np.float32))
        assert (off.missed_closer | off.no_surface)[sharp].all()
    behind = clear & (second > 1.001 * hits.t)
    assert judge(found, second).missed_closer[behind].all()
    missed = judge(found, np.full(len(hits.t), np.inf, np.float32))
    assert missed.missed_closer[clear].all()


def test_few_ordinary_rays_are_ambiguous() -> None:
    """Of the ordinary rays on the dragon nearly all have exactly one answer."""
    mesh, tree = planted("dragon-res4")
    rays = rays_on(Request(6, "dragon-res4", False, count=200), mesh, tree).rays
    assert is_ambiguous(answers(mesh, rays, tree)).mean() < 0.02
