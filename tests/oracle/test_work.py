"""Work is measured on rays of all kinds, and brute force for one kind shows on average."""

import numpy as np
import pytest

from grader.model.mesh import Rays
from grader.model.trials import WorkTrial
from grader.oracle import work
from grader.oracle.brute import chosen
from grader.oracle.costs import plain_costs
from grader.tolerances import SPECIAL_WASTE, WASTE
from tests.oracle.treebuilder import tree_of


@pytest.fixture(scope="module", name="trials")
def trials_on_small_meshes() -> list[WorkTrial]:
    """Draw the trials, without the larger of the stored meshes."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(work, "WORK", (("dragon-res4", 50),))
        return work.work_trials(3, lambda meshes: [tree_of(one) for one in meshes])


@pytest.fixture(scope="module", name="special")
def trial_of_special_rays(trials: list[WorkTrial]) -> WorkTrial:
    """Give the only one of its kind."""
    (special,) = (each for each in trials if each.special)
    return special


def kinds(trial: WorkTrial) -> list[Rays]:
    """Take the rays apart, by kind."""
    count = work.SPECIAL_RAYS
    return [chosen(trial.rays, np.arange(k * count, (k + 1) * count)) for k in range(3)]


def test_every_kind_is_what_its_name_says(special: WorkTrial) -> None:
    """From inside the box, along one axis, and between two points of the box."""
    inside, parallel, between = kinds(special)
    low, high = special.tree.low[0], special.tree.high[0]
    for rays in (inside, between):
        assert ((rays.origin >= low) & (rays.origin <= high)).all()
    assert (np.count_nonzero(parallel.direction, axis=1) == 1).all()
    assert not ((parallel.origin >= low) & (parallel.origin <= high)).all(axis=1).any()
    assert (between.t_max == 1).all()
    assert set(between.t_min.tolist()) == {0.0, float(np.float32(0.05))}


def test_brute_force_for_half_of_a_kind_is_too_much(special: WorkTrial) -> None:
    """A sixth of all rays tests every face; the others take what a plain traversal takes."""
    plain = sum(plain_costs(special.tree, special.rays))
    assert plain == special.box_tests + special.triangle_tests
    assert len(special.mesh.faces) / 6 > 1.5 * SPECIAL_WASTE * plain


def test_looking_at_limits_later_is_not(special: WorkTrial) -> None:
    """A box test without the ray's limits costs little more."""
    rays = special.rays
    endless = Rays(
        rays.origin, rays.direction, np.zeros_like(rays.t_min), np.full_like(rays.t_max, np.inf)
    )
    plain = special.box_tests + special.triangle_tests
    assert sum(plain_costs(special.tree, endless)) < 2 * plain


def test_a_floor_is_flat_and_its_tree_excludes_most_of_it(trials: list[WorkTrial]) -> None:
    """Who takes every flat box for hit does many times as many tests as are allowed."""
    floor = trials[-1]
    used = floor.tree.end > floor.tree.begin
    assert (floor.tree.low[used, 2] == floor.tree.high[used, 2]).all()
    assert len(floor.mesh.faces) > 10 * WASTE * (floor.box_tests + floor.triangle_tests)
