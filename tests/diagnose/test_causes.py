"""A known mistake is named; whoever is right, or wrong in an unknown way, hears nothing."""

from collections.abc import Callable

import numpy as np
import pytest

from grader import errors
from grader.certify.matrix import stored_lines
from grader.diagnose import every_hypothesis
from grader.diagnose.causes import likely_causes
from grader.diagnose.notes import Notes
from grader.diagnose.patterns import explained, likeness, patterns
from grader.model.cases import MemoryCase, TreeCase
from grader.model.mesh import Bvh, Floats
from grader.model.stages import Ending, Stop
from grader.model.trials import ConstructTrial
from grader.verify import every_check
from tests.diagnose import table
from tests.verify.builder import Reading, build, soup

AXIS, MEDIAN, BOXES = (
    "bvh.splits-the-longest-axis",
    "bvh.splits-at-the-median",
    "bvh.boxes-are-tight",
)
MEMORY = "hits.memory-is-safe"
ARRAY = "A local array is used beyond its end."
STACK = (
    "The stack of nodes that wait is too small for deep trees, and is written beyond its end."
)
LEAVES = "bvh.leaves-hold-at-most-four"


def noted(make: Callable[[int], Bvh]) -> Notes:
    """Keep the trees of three meshes."""
    notes = Notes()
    for seed, faces in enumerate((9, 37, 100)):
        trial = ConstructTrial(f"mesh {seed}", soup(faces, seed))
        notes.note(TreeCase(trial.name, trial, make(seed)))
    return notes


def trees(reading: Reading | None) -> Notes:
    """Keep trees that are built in a certain way."""
    return noted(lambda seed: build(soup((9, 37, 100)[seed], seed), reading))


def first_vertex(a: Floats, b: Floats, c: Floats) -> Floats:
    """Take a vertex for the centre."""
    return a


def upwards(a: Floats, b: Floats, c: Floats) -> Floats:
    """Take what falls where the centre rises."""
    return -(a + b + c)


@pytest.mark.parametrize(
    ("reading", "check", "misconception"),
    [
        (Reading(axis=lambda _: 0), AXIS, "axis.always-the-same"),
        (Reading(centre=first_vertex), MEDIAN, "order.single-vertex"),
        (Reading(centre=upwards), MEDIAN, "order.descending"),
        (Reading(leaf=3), LEAVES, "split.four-faces"),
        (Reading(leaf=5), LEAVES, "split.five-faces-stay"),
    ],
)
def test_a_known_mistake_is_named(reading: Reading, check: str, misconception: str) -> None:
    """Built by hand, not one of the corpus."""
    causes = likely_causes(trees(reading), [check])
    assert causes[check].id == misconception
    assert causes[check].fits == causes[check].places > 0


def test_a_right_tree_has_no_cause() -> None:
    """Even if somebody says that all checks failed."""
    assert not likely_causes(trees(None), [each.id for each in every_check()])


def test_only_checks_that_a_mistake_can_make_fail_get_it_as_a_cause() -> None:
    """Boxes that a test says are wrong are not explained by an axis."""
    notes = trees(Reading(axis=lambda _: 0))
    assert set(likely_causes(notes, [AXIS, BOXES])) == {AXIS}


@pytest.mark.parametrize(
    ("finding", "sentence"),
    [
        ("index 8 out of bounds for type 'unsigned int [8]'", STACK),
        ("index 16 out of bounds for type 'Node[16]'", STACK),
        ("index 7 out of bounds for type 'float [7]'", ARRAY),
        ("index 3 out of bounds for type 'int [3][64]'", ARRAY),
        ("stack-buffer-overflow", ARRAY),
    ],
)
def test_an_array_is_called_a_stack_only_if_it_has_room(finding: str, sentence: str) -> None:
    """As compilers word it; AddressSanitizer does not say how long it is."""
    trial, notes = ConstructTrial("deep", soup(9), sanitized=True), Notes()
    notes.note(MemoryCase("deep", trial, Ending(Stop.CRASHED, "", 0, 0, "", finding)))
    assert likely_causes(notes, [MEMORY])[MEMORY].sentence == sentence


def test_a_mistake_that_nobody_knows_is_not_named() -> None:
    """Boxes of random size."""

    def at_random(seed: int) -> Bvh:
        tree, rng = build(soup((9, 37, 100)[seed], seed)), np.random.default_rng(seed)
        low = (tree.low - rng.uniform(-1, 1, tree.low.shape)).astype(np.float32)
        return Bvh(low, tree.high, tree.begin, tree.end, tree.order, tree.node_count)

    assert not likely_causes(noted(at_random), [BOXES])


def garbage(seed: int) -> Bvh:
    """Fill a tree with random bytes."""
    words = np.random.default_rng(seed).integers(2**32, size=(40, 8), dtype=np.uint32)
    box = words[:, :6].copy().view(np.float32)
    return Bvh(box[:, :3], box[:, 3:], words[:, 6], words[:, 7], words[:9, 0], 40)


def with_random_boxes(seed: int) -> Bvh:
    """Build a tree whose ranges are right, so that it is looked into."""
    right, words = build(soup((9, 37, 100)[seed], seed)), garbage(seed)
    box = np.resize(words.low, right.low.shape), np.resize(words.high, right.high.shape)
    return Bvh(*box, right.begin, right.end, right.order, right.node_count)


@pytest.mark.parametrize("make", [garbage, with_random_boxes])
def test_garbage_is_no_fault_of_ours(make: Callable[[int], Bvh]) -> None:
    """Random bytes have no cause, and no hypothesis stumbles over them."""
    failed = {check for each in every_hypothesis() for check in explained(each.id)}
    assert errors.STRICT
    assert not likely_causes(noted(make), failed)


def test_the_shipped_table_is_that_of_the_corpus() -> None:
    """Whoever changes the matrix or the misconceptions writes it anew."""
    assert table.PATTERNS.read_text(encoding="utf-8") == table.table()


def test_misconceptions_are_of_submissions_that_exist() -> None:
    """One without a line, or with an empty one, has no cause that would be right."""
    assert set(table.misconceptions()) <= set(stored_lines())


def test_every_hypothesis_is_of_a_misconception_of_the_corpus() -> None:
    """What no wrong submission shows was never seen to work."""
    assert {each.id for each in every_hypothesis()} <= set(patterns())


def test_likeness_is_one_for_the_very_pattern() -> None:
    """And less for every check too many or too few."""
    assert likeness("axis.by-depth", [AXIS]) == 1
    assert likeness("axis.by-depth", [AXIS, BOXES]) == 0.5
    assert likeness("no.such-misconception", [AXIS]) == 0
