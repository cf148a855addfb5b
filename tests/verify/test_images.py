"""Pictures against Mitsuba's, on a wall seen pixel by pixel."""

from dataclasses import replace

import numpy as np
import pytest

from grader.model.cases import ImageCase
from grader.model.mesh import EDGE, SOLID, WILD, Answers, Bvh, Floats, Hits, Mesh, Rays
from grader.model.trials import ImageTrial
from grader.verify.images import picture_equals_mitsubas

WIDTH, HEIGHT = 200, 100
PIXELS = WIDTH * HEIGHT
WALL = 3.0
TOLERANCE = 1e-5
ODD = (5, 7 * WIDTH + 3, PIXELS - 1)
"""Some pixels that a test makes special."""


def wall_case(t: Floats, kinds: dict[int, int] | None = None, void: bool = False) -> ImageCase:
    """See a wall at distance 3 in every pixel, or nothing at all, and claim the given t.

    Args:
        t: (R,) float32, what the submission returned.
        kinds: Pixels whose candidate is not SOLID.
        void: No pixel sees anything.
    """
    kind = np.full(PIXELS, SOLID, dtype=np.uint8)
    for pixel, value in (kinds or {}).items():
        kind[pixel] = value
    limit = np.where(kind == SOLID, WALL + TOLERANCE, np.inf)
    solid = Answers(
        limit=np.full(PIXELS, np.inf) if void else limit,
        first=np.zeros(PIXELS + 1, dtype=np.int64) if void else np.arange(PIXELS + 1),
        face=np.zeros(PIXELS, dtype=np.int64)[: 0 if void else PIXELS],
        t=np.full(0 if void else PIXELS, WALL),
        tolerance=np.full(0 if void else PIXELS, TOLERANCE),
        kind=kind[: 0 if void else PIXELS],
    )
    no_vectors = np.zeros((PIXELS, 3), dtype=np.float32)
    trial = ImageTrial(
        name="wall",
        mesh=Mesh(
            vertices=np.zeros((0, 3), dtype=np.float32), faces=np.zeros((0, 3), dtype=np.uint32)
        ),
        tree=no_tree(),
        width=WIDTH,
        height=HEIGHT,
        rays=Rays(origin=no_vectors, direction=no_vectors, t_min=t, t_max=t),
        answers=solid,
        mitsuba_t=np.full(PIXELS, np.inf if void else WALL, dtype=np.float32),
    )
    hits = Hits(point=no_vectors, t=t, normal=no_vectors)
    return ImageCase("wall", trial, hits, np.zeros((PIXELS, 2), dtype=np.uint32))


def no_tree() -> Bvh:
    """Return a tree without nodes; the check never looks at it."""
    none = np.zeros((0, 3), dtype=np.float32)
    empty = np.zeros(0, dtype=np.uint32)
    return Bvh(low=none, high=none, begin=empty, end=empty, order=empty, node_count=0)


def seen(value: float = WALL, places: tuple[int, ...] = (), other: float = 0.0) -> Floats:
    """Return one t per pixel: `value`, and `other` at some places."""
    t = np.full(PIXELS, value, dtype=np.float32)
    t[list(places)] = other
    return t


def test_the_same_picture_passes() -> None:
    """Every pixel within the rule's bound: all are examined, none is wrong."""
    evidence = picture_equals_mitsubas.decide(
        wall_case(seen(float(np.nextafter(np.float32(WALL), np.float32(9)))))
    )
    assert (evidence.examined, evidence.wrong) == (PIXELS, 0)


@pytest.mark.parametrize("other", [np.inf, 3.1, 2.9, np.nan, -np.inf, 0.0, -3.0])
@pytest.mark.parametrize("place", ODD)
def test_one_wrong_pixel_is_caught(place: int, other: float) -> None:
    """A hole of one pixel is far below what the witness forgives, and is still wrong."""
    evidence = picture_equals_mitsubas.decide(wall_case(seen(WALL, (place,), other)))
    assert evidence.wrong == 1
    y, x = divmod(place, WIDTH)
    assert evidence.examples[0].message.startswith(f"pixel ({x}, {y}): ")


def test_a_hole_names_the_face_that_was_missed() -> None:
    """The message says what is there and what was expected."""
    (example,) = picture_equals_mitsubas.decide(
        wall_case(seen(WALL, (WIDTH + 2,), np.inf))
    ).examples
    assert example.message == "pixel (2, 1): no hit, but face 0 at t = 3 is closer"
    assert (example.expected, example.got) == ("face 0 at t = 3", "no hit")


def test_a_hit_in_the_void_is_wrong() -> None:
    """Where nothing is, a finite t is wrong, and the message says that Mitsuba misses too."""
    evidence = picture_equals_mitsubas.decide(wall_case(seen(np.inf, (0,), 2.0), void=True))
    assert evidence.wrong == 1
    message = "pixel (0, 0): a hit at t = 2, but no face is there; Mitsuba sees no hit"
    assert evidence.examples[0].message == message


@pytest.mark.parametrize(("count", "wrong"), [(4, 0), (5, 5)])
def test_a_handful_of_edges_may_differ_from_mitsuba(count: int, wrong: int) -> None:
    """On an edge the rule allows a miss; four such pixels pass, the fifth makes all count."""
    places = tuple(range(10, 10 + count))
    case = wall_case(seen(WALL, places, np.inf), dict.fromkeys(places, EDGE))
    evidence = picture_equals_mitsubas.decide(case)
    assert evidence.wrong == wrong


def test_holes_do_not_use_up_what_edges_may_differ() -> None:
    """Five holes are five wrong pixels; the one edge beside them is still forgiven."""
    holes, edge = (20, 21, 22, 23, 24), 90
    case = wall_case(seen(WALL, (*holes, edge), np.inf), {edge: EDGE})
    assert picture_equals_mitsubas.decide(case).wrong == len(holes)


def test_an_undecidable_pixel_is_not_counted() -> None:
    """A hit that only an edge-on face explains is neither right nor wrong."""
    case = wall_case(seen(WALL, (8,), 1.0), {8: WILD})
    evidence = picture_equals_mitsubas.decide(case)
    assert (evidence.examined, evidence.wrong) == (PIXELS - 1, 0)


def test_a_swapped_picture_is_wrong() -> None:
    """A submission that turns hits into misses and back fails in every pixel."""
    case = wall_case(seen(np.inf))
    assert picture_equals_mitsubas.decide(case).wrong == PIXELS
    void = wall_case(seen(WALL), void=True)
    assert picture_equals_mitsubas.decide(void).wrong == PIXELS


def test_mitsuba_decides_beyond_a_handful() -> None:
    """Where the rule's bounds are wide, t must still be within 1e-4 of Mitsuba's."""
    case = wall_case(seen(3.01))
    wide = replace(
        case.trial.answers,
        limit=np.full(PIXELS, 3.1),
        tolerance=np.full(PIXELS, 0.1),
    )
    near = replace(case, trial=replace(case.trial, answers=wide))
    assert picture_equals_mitsubas.decide(near).wrong == 0
    far = replace(near, trial=replace(near.trial, mitsuba_t=seen(3.2)))
    evidence = picture_equals_mitsubas.decide(far)
    assert evidence.wrong == PIXELS
    assert "but Mitsuba sees a hit at t = 3.2" in evidence.examples[0].message
