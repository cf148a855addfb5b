"""Work is judged by what the tree leads to, by counted tests, and by the model's time."""

from dataclasses import replace

import numpy as np
import pytest

from grader.model.cases import AlteredCase, SurvivalCase, WorkCase
from grader.model.mesh import Hits
from grader.model.stages import Ending, Stop
from grader.model.trials import WorkTrial
from grader.oracle.altered import altered_trials
from grader.oracle.brute import NOTHING
from grader.oracle.bundle import stage_for
from grader.oracle.ordinary import inbound
from grader.verify import work as module
from grader.verify.work import excludes_most_triangles, unproven, uses_the_tree
from tests.oracle.tracer import trace
from tests.oracle.treebuilder import planted


def altered(kind: int) -> tuple[AlteredCase, np.ndarray]:
    """Return a case whose hits are all found, and t of a right traversal."""
    mesh, tree = planted("terrain-1200")
    trial = altered_trials(8, "terrain-1200", mesh, tree)[kind]
    hits = trace(mesh, trial.rays, tree)
    right = np.where(trial.lost, np.float32(np.inf), hits.t)
    return AlteredCase(trial.name, trial, hits), right


def with_t(case: AlteredCase, t: np.ndarray) -> AlteredCase:
    """Replace the distances."""
    return replace(case, hits=replace(case.hits, t=t))


@pytest.mark.parametrize("kind", [0, 1])
def test_ignoring_the_tree_fails(kind: int) -> None:
    """Every hit that the tree does not lead to any more is counted."""
    case, right = altered(kind)
    evidence = uses_the_tree.decide(case)
    assert evidence.wrong == evidence.examined == np.count_nonzero(case.trial.lost)
    assert "cannot be reached in a tree where" in evidence.examples[0].message
    assert uses_the_tree.decide(with_t(case, right)).wrong == 0


@pytest.mark.parametrize("kind", [0, 1])
def test_one_hit_too_many_fails(kind: int) -> None:
    """A single lost ray that still hits is enough."""
    case, right = altered(kind)
    ray = np.flatnonzero(case.trial.lost)[4]
    right[ray] = case.hits.t[ray]
    evidence = uses_the_tree.decide(with_t(case, right))
    assert evidence.wrong == 1
    assert evidence.examples[0].message.startswith(f"ray {ray} from ")


@pytest.mark.parametrize("nothing", [np.inf, np.nan])
def test_hitting_nothing_proves_nothing(nothing: float) -> None:
    """Whoever returns no hit at all has not used the tree."""
    case, right = altered(0)
    evidence = uses_the_tree.decide(with_t(case, np.full_like(right, nothing)))
    assert evidence.wrong == 1
    assert "their faces are all still in it" in evidence.examples[0].message


def test_another_hit_on_a_lost_ray_is_not_the_lost_one() -> None:
    """A farther surface may well be hit once the closest is gone."""
    case, right = altered(0)
    right[case.trial.lost] = case.hits.t[case.trial.lost] * np.float32(1.5)
    assert uses_the_tree.decide(with_t(case, right)).wrong == 0


def with_sound(case: AlteredCase, t: np.ndarray) -> AlteredCase:
    """Say what the same rays hit on the tree as it was."""
    return replace(case, sound=replace(case.hits, t=t))


def test_another_answer_than_the_true_one_may_come_from_the_tree() -> None:
    """Who counts t otherwise still changes those of rays whose faces are gone, and no more."""
    case, right = altered(0)
    twice = with_sound(with_t(case, 2 * right), 2 * case.hits.t)
    assert uses_the_tree.decide(twice).wrong == 0


def test_the_same_answer_to_everything_proves_nothing() -> None:
    """Neither one constant, nor a number for each ray that no tree changes."""
    case, right = altered(0)
    constant = np.full_like(right, 1e20)
    each = constant * np.arange(1, right.size + 1, dtype=np.float32)
    for made_up in (constant, each):
        evidence = uses_the_tree.decide(with_sound(with_t(case, made_up), made_up))
        assert (evidence.examined, evidence.wrong) == (1, 1)
        assert "the same t" in evidence.examples[0].message


def test_other_answers_on_another_tree_prove_nothing() -> None:
    """A number that is made of the tree's bytes changes where nothing is gone, too."""
    case, right = altered(0)
    made_up = with_sound(with_t(case, np.full_like(right, 1e20)), np.full_like(right, 2e20))
    assert "none of" in uses_the_tree.decide(made_up).examples[0].message


def work(boxes: float, triangles: float, seconds: float, model: float = 0.1) -> WorkCase:
    """Make a case; a plain traversal takes 60 and 10 tests."""
    mesh, tree = planted("terrain-600")
    rays = inbound(stage_for(mesh, np.random.default_rng(1), lambda _: NOTHING), 50)
    trial = WorkTrial("work", mesh, tree, rays, box_tests=60, triangle_tests=10)
    empty = np.zeros((50, 3), np.float32)
    hits = Hits(empty, np.zeros(50, np.float32), empty.copy())
    return WorkCase("work", trial, hits, boxes, triangles, seconds, model, hits.t)


@pytest.mark.parametrize(
    ("case", "wrong"),
    [
        (work(60, 10, 0.1), 0),
        (work(200, 80, 0.1), 0),
        (work(200, 81, 0.1), 1),
        (work(0, 600, 0.1), 1),
        (work(0, 0, 0.1), 0),
        (work(0, 0, 1.19), 0),
        (work(0, 0, 1.21), 1),
        (work(60, 10, 1.21), 1),
        (work(60, 10, 1.21, model=0.2), 0),
        (work(600, 10, 9.0), 2),
    ],
)
def test_tests_and_time_have_limits(case: WorkCase, wrong: int) -> None:
    """Four times a plain traversal's tests, and 0.2 s + 10 times the model's time."""
    evidence = excludes_most_triangles.decide(case)
    assert evidence.examined == 50
    assert len(evidence.examples) == wrong
    assert evidence.wrong == (50 if wrong else 0)


@pytest.mark.parametrize(
    ("got", "true", "words"),
    [
        ([1.0] * 30 + [np.inf] * 20, [2.0] * 30 + [np.inf] * 20, ""),
        ([1.0] * 27 + [np.inf] * 23, [1.0] * 30 + [np.inf] * 20, ""),
        ([1.0] * 26 + [np.inf] * 24, [1.0] * 30 + [np.inf] * 20, "30 rays have a hit"),
        ([np.nan] * 30 + [np.inf] * 20, [1.0] * 30 + [np.inf] * 20, "30 of them get no hit"),
        ([1.0] * 33 + [np.inf] * 17, [1.0] * 30 + [np.inf] * 20, "20 rays have no hit"),
        ([1.0] * 50, [1.0] * 31 + [np.inf] * 19, ""),
    ],
    ids=["other t", "a tenth lost", "more lost", "no number", "more found", "few misses"],
)
def test_rays_are_answered_by_a_search(
    got: list[float], true: list[float], words: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """`return {}` tests nothing and takes no time; whoever finds a wrong face has searched."""
    case = work(60, 10, 0.1)
    hits = replace(case.hits, t=np.array(got, np.float32))
    case = replace(case, hits=hits, reference_t=np.array(true, np.float32))
    monkeypatch.setattr(module, "LARGE_MESH", len(case.trial.mesh.faces) - 1)
    evidence = excludes_most_triangles.decide(case)
    assert evidence.forfeits == bool(words)
    assert [words in each.message for each in evidence.examples] == [True] * bool(words)
    # Where all faces can be tested in time, other checks say what is wrong with the hits.
    monkeypatch.setattr(module, "LARGE_MESH", len(case.trial.mesh.faces))
    assert not excludes_most_triangles.decide(case).examples


def test_measured_seconds_are_not_told() -> None:
    """Two runs with the same seed give the same report."""
    (example,) = excludes_most_triangles.decide(work(0, 0, 7.654321)).examples
    assert "7." not in example.message + example.got + example.expected


@pytest.mark.parametrize(
    ("case", "forfeits"),
    [
        (work(0, 280, 0.1), False),
        (work(20, 281, 0.1), True),
        (work(600, 10, 0.1), True),
        (work(0, 0, 9.0), False),
    ],
)
def test_a_twentieth_of_the_faces_costs_all_points(case: WorkCase, forfeits: bool) -> None:
    """Of 600 faces 30 are a twentieth, but what a plain traversal takes is always allowed."""
    evidence = excludes_most_triangles.decide(case)
    assert evidence.forfeits is forfeits
    assert ("costs all points" in "".join(one.message for one in evidence.examples)) is forfeits


@pytest.mark.parametrize(
    ("stop", "large", "judged"),
    [
        (Stop.CRASHED, True, True),
        (Stop.TIMED_OUT, True, True),
        (Stop.FINISHED, True, False),
        (Stop.CRASHED, False, False),
    ],
)
def test_who_dies_on_the_large_mesh_has_shown_nothing(
    stop: Stop, large: bool, judged: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Or a search of all faces had only to end where it would take long."""
    trial = work(60, 10, 0.1).trial
    monkeypatch.setattr(module, "LARGE_MESH", len(trial.mesh.faces) - large)
    evidence = unproven(SurvivalCase("work", trial, Ending(stop, "", 1.0, 1.0, "")))
    assert (evidence is not None) is judged
    if evidence is not None:
        assert (evidence.wrong, evidence.forfeits, evidence.stop) == (1, True, stop)
