"""A plan holds every kind of trial, belongs to its seed, and blames itself if it must."""

from collections.abc import Sequence
from dataclasses import fields, is_dataclass
from pathlib import Path

import numpy as np
import pytest

from grader.model.mesh import Bvh, Mesh
from grader.model.trials import (
    AlteredTrial,
    ConstructTrial,
    RebuildTrial,
    RepeatTrial,
    TraceTrial,
    WorkTrial,
)
from grader.oracle import plan as module
from grader.oracle import repeated, witness, work
from grader.oracle.hierarchy import leaves_of
from grader.oracle.meshes import SHAPES
from grader.oracle.plan import Plan, kept_plan, make_plan
from tests.oracle.treebuilder import tree_of

SMALL = (
    "cloud-0",
    "cloud-1",
    "cloud-4",
    "cloud-5",
    "cloud-9",
    "cloud-37",
    "cloud-64",
    "terrain-1200",
)


def fingerprint(value: object) -> object:
    """Turn records and arrays into something that can be compared."""
    if isinstance(value, np.ndarray):
        return value.dtype.str, value.shape, value.tobytes()
    if is_dataclass(value):
        return tuple(fingerprint(getattr(value, field.name)) for field in fields(value))
    if isinstance(value, tuple):
        return tuple(fingerprint(item) for item in value)
    return value


def trees(meshes: Sequence[Mesh]) -> list[Bvh]:
    """Build trees over meshes."""
    return [tree_of(mesh) for mesh in meshes]


def refusing(_: Sequence[Mesh]) -> list[Bvh]:
    """Stand in for another builder of trees."""
    raise RuntimeError("asked for trees")


@pytest.fixture
def _small(monkeypatch: pytest.MonkeyPatch) -> None:
    """Leave the large meshes and the pictures out of plans."""
    shapes = {name: SHAPES[name] for name in SMALL}
    monkeypatch.setattr("grader.oracle.meshes.SHAPES", shapes)
    monkeypatch.setattr("grader.oracle.meshes.STORED", {})
    monkeypatch.setattr(module, "TRACED", ("cloud-1", "cloud-5", "cloud-37", "terrain-1200"))
    monkeypatch.setattr(module, "SANITIZED", ("cloud-0", "cloud-5"))
    monkeypatch.setattr(module, "REBUILT", (("cloud-9", "cloud-0"),))
    monkeypatch.setattr(module, "ALTERED", ("terrain-1200",))
    monkeypatch.setattr(repeated, "REPEATED", (("terrain-1200", "cloud-5"),))
    monkeypatch.setattr(repeated, "ALIKE", ("terrain-1200", "cloud-5"))
    monkeypatch.setattr(repeated, "REPEATED_RAYS", 50)
    monkeypatch.setattr(repeated, "GROWING", ("terrain-1200", "cloud-1"))
    monkeypatch.setattr(work, "WORK", (("nested", 50),))
    monkeypatch.setattr(work, "SPECIAL_RAYS", 10)
    monkeypatch.setattr("grader.oracle.thicket.FACES", 200)
    monkeypatch.setattr(module, "DEEPEST", 6)
    monkeypatch.setattr(module, "image_trials", lambda *_: [])


@pytest.mark.usefixtures("_small")
def test_a_seed_is_a_plan() -> None:
    """Drawn again it is the same; another seed's differs."""
    one, again, other = make_plan(1, trees), make_plan(1, trees), make_plan(2, trees)
    assert fingerprint(one) == fingerprint(again)
    assert [trial.name for trial in one.trials] == [trial.name for trial in other.trials]
    assert fingerprint(one) != fingerprint(other)


@pytest.mark.usefixtures("_small")
def test_a_kept_plan_is_the_plan(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Kept, then read back without drawing anything, then of another seed and builder."""
    monkeypatch.setenv("BVHGRADE_CACHE", str(tmp_path))
    wanted = fingerprint(make_plan(1, trees))
    assert fingerprint(kept_plan(1, trees, "these")) == wanted
    with monkeypatch.context() as patch:
        patch.setattr(module, "drawn", None)
        patch.setattr(module, "image_trials", None)
        assert fingerprint(kept_plan(1, trees, "these")) == wanted
    assert fingerprint(kept_plan(2, trees, "these")) == fingerprint(make_plan(2, trees))
    with pytest.raises(RuntimeError, match="asked"):
        kept_plan(1, refusing, "others")


@pytest.mark.usefixtures("_small")
def test_a_kept_plan_shares_what_trials_share(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What is worked out for a mesh is kept with it, so equal meshes must stay one."""
    monkeypatch.setenv("BVHGRADE_CACHE", str(tmp_path))
    plans = [kept_plan(1, trees, "these") for _ in range(2)]
    first, again = ([id(getattr(t, "mesh", t)) for t in plan.trials] for plan in plans)
    assert [first.index(each) for each in first] == [again.index(each) for each in again]


def kinds(plan: Plan) -> set[type]:
    """Return the kinds of trials in a plan."""
    return {type(trial) for trial in plan.trials}


@pytest.mark.usefixtures("_small")
def test_every_kind_of_trial_occurs() -> None:
    """Each kind that a check looks at is planned, sanitized ones included."""
    plan = make_plan(3, trees)
    assert plan.faults == ()
    assert kinds(plan) == {
        ConstructTrial,
        RebuildTrial,
        TraceTrial,
        AlteredTrial,
        WorkTrial,
        RepeatTrial,
    }
    names = [trial.name for trial in plan.trials]
    assert len(set(names)) == len(names)
    traces = [trial for trial in plan.trials if isinstance(trial, TraceTrial)]
    assert {(trial.special, trial.sanitized) for trial in traces} == {
        (False, False),
        (True, False),
        (False, True),
        (True, True),
    }
    for trial in traces:
        assert trial.family.size == trial.answers.limit.size == len(trial.rays.t_min)
        assert trial.answers.first[-1] == trial.answers.face.size


@pytest.mark.usefixtures("_small")
def test_trees_come_in_both_legal_forms() -> None:
    """Empty slots at the end are left out or added, and the tree means the same."""
    plan = make_plan(3, trees)
    by_mesh = {t.name: t for t in plan.trials if isinstance(t, TraceTrial)}
    trimmed = by_mesh["cloud-5, ordinary rays"].tree
    assert trimmed.end[-1] != 0
    padded = by_mesh["cloud-37, ordinary rays"].tree
    plain = tree_of(by_mesh["cloud-37, ordinary rays"].mesh)
    assert padded.end.size > plain.end.size
    assert not padded.end[plain.end.size :].any()
    assert leaves_of(padded)[: plain.end.size].tolist() == leaves_of(plain).tolist()


@pytest.mark.usefixtures("_small")
def test_a_contradiction_of_the_witnesses_is_our_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    """If Embree disagreed, the plan would name the trial and the first ray."""
    monkeypatch.setattr(
        witness, "embree_t", lambda _, rays: np.full(len(rays.t_min), 0.5, np.float32)
    )
    plan = make_plan(5, trees)
    faults = dict(plan.faults)
    assert "contradict each other" in faults["terrain-1200, ordinary rays"]
    kinds = {type(trial) for trial in plan.trials if trial.name in faults}
    assert kinds == {TraceTrial, AlteredTrial, RepeatTrial}
