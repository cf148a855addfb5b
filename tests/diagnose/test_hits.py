"""A mistaken search through a tree is named by the distances that it returns."""

from collections.abc import Callable

import numpy as np
import pytest

from grader.diagnose.causes import likely_causes
from grader.diagnose.notes import Notes
from grader.model.cases import HitCase
from grader.model.mesh import Doubles, Hits, Rays
from grader.model.trials import TraceTrial
from grader.oracle.brute import answers, candidates
from tests.verify.builder import build, soup

CLOSEST = "hits.closest-wins"
RAYS = 200


def trial(seed: int) -> TraceTrial:
    """Trace rays from all around to points in a cloud of large faces."""
    mesh, rng = soup(60, seed, scale=0.3), np.random.default_rng(seed)
    origin = rng.normal(size=(RAYS, 3)) * 2
    direction = (rng.uniform(-0.3, 0.3, (RAYS, 3)) - origin).astype(np.float32)
    t_min, t_max = np.zeros(RAYS, np.float32), np.full(RAYS, np.inf, np.float32)
    rays, tree = Rays(origin.astype(np.float32), direction, t_min, t_max), build(mesh)
    found = answers(mesh, rays, tree)
    family = np.zeros(RAYS, np.int64)
    return TraceTrial(f"cloud {seed}", mesh, tree, rays, found, ("any",), family, special=False)


def table(given: TraceTrial) -> Doubles:
    """(R, F) float64, where each ray hits each face; infinite if it does not."""
    found = candidates(given.mesh, given.rays, given.tree)
    t = np.full((RAYS, len(given.mesh.faces)), np.inf)
    t[found.ray, found.face] = found.t
    return t


Search = Callable[[TraceTrial, Doubles], Doubles]


def right(given: TraceTrial, t: Doubles) -> Doubles:
    """The closest."""
    return np.asarray(t.min(axis=1))


def farthest(given: TraceTrial, t: Doubles) -> Doubles:
    """The farthest."""
    last = np.where(np.isfinite(t), t, -np.inf).max(axis=1)
    return np.where(np.isfinite(last), last, np.inf)


def first_in_order(given: TraceTrial, t: Doubles) -> Doubles:
    """The first in the order of the face indices: a walk that goes left first."""
    t = t[:, given.tree.order]
    return np.asarray(t[np.arange(len(t)), np.isfinite(t).argmax(axis=1)])


def without_last_of_leaves(given: TraceTrial, t: Doubles) -> Doubles:
    """The closest of all faces but the last one of each leaf."""
    tree, t = given.tree, t.copy()
    count = len(tree.end)
    for node in np.flatnonzero(tree.end):
        if 2 * node + 1 >= count or tree.end[2 * node + 1] == 0:
            t[:, tree.order[tree.end[node] - 1]] = np.inf
    return np.asarray(t.min(axis=1))


def at_random(given: TraceTrial, t: Doubles) -> Doubles:
    """Anything."""
    return np.random.default_rng(5).uniform(0, 3, RAYS)


def noted(search: Search) -> Notes:
    """Keep what a search returns on three meshes."""
    notes = Notes()
    for seed in range(3):
        given, nothing = trial(seed), np.zeros((RAYS, 3), np.float32)
        t = search(given, table(given)).astype(np.float32)
        notes.note(HitCase(given.name, given, Hits(nothing, t, nothing)))
    return notes


@pytest.mark.parametrize(
    ("search", "misconception"),
    [
        (farthest, "keeps.farthest"),
        (first_in_order, "keeps.first"),
        (without_last_of_leaves, "leaf.last-face-skipped"),
    ],
)
def test_a_mistaken_search_is_named(search: Search, misconception: str) -> None:
    """By what it returns alone; nobody looks at the code."""
    assert likely_causes(noted(search), [CLOSEST])[CLOSEST].id == misconception


@pytest.mark.parametrize("search", [right, at_random])
def test_nothing_is_named_without_need(search: Search) -> None:
    """Neither where all is right nor where nothing is foretold."""
    assert not likely_causes(noted(search), [CLOSEST])
