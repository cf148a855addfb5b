"""Work is measured on rays of all kinds, and brute force for one kind shows on average."""

import numpy as np
import pytest

from grader.model.mesh import Rays
from grader.model.trials import WorkTrial
from grader.oracle import work
from grader.oracle.brute import chosen
from grader.oracle.costs import plain_costs
from grader.tolerances import SPECIAL_WASTE
from tests.oracle.treebuilder import tree_of


@pytest.fixture(scope="module", name="special")
def trial_of_special_rays() -> WorkTrial:
    """Draw the trials on the small mesh only, and give the last one."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(work, "WORK", (("dragon-res4", 50),))
        ordinary, special = work.work_trials(3, lambda meshes: [tree_of(one) for one in meshes])
    assert (ordinary.special, special.special) == (False, True)
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
