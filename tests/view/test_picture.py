"""What the two pictures of a desk say of each other, while the camera moves."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from grader.language import translator
from grader.phrases import teller
from grader.view.desk import Mode
from grader.view.picture import Comparison, comparison, is_old, next_wrong, shown
from grader.view.stage import State
from grader.view.status import status
from tests.view.shown import confetti

HOME = confetti().home


def stage(t: float) -> Any:  # noqa: ANN401 - takes the place of a stage
    """Have a whole picture of one distance, of a process that has ended."""
    shape = 4, 8
    traced = SimpleNamespace(
        t=np.full(shape, t, np.float32),
        bright=np.full(shape, 9, np.uint8),
        seen=np.ones(shape, np.bool_),
        fine=np.ones(shape, np.bool_),
        orbit=HOME,
        is_done=True,
        seconds=0.0,
        share=1.0,
    )
    return SimpleNamespace(
        traced=traced,
        state=State.ENDED,
        subject=confetti(),
        tree=None,
        trouble="intersect, pixel (3, 4): ended by SIGSEGV",
        construct_seconds=0.0,
    )


def desk_of(moved: float, size: tuple[int, int], mode: Mode) -> Any:  # noqa: ANN401 - takes the place of a desk
    """Have two pictures of the first camera, after which it was moved and resized."""
    return SimpleNamespace(
        stage=stage(1.0),
        rival=stage(2.0),
        orbit=HOME.turned(moved, 0.0),
        size=size,
        mode=mode,
        subject=None,
        product=None,
        fault=None,
        is_loading=False,
        is_building=False,
        lacks_tree=False,
    )


@pytest.mark.parametrize(
    ("moved", "size", "pixel", "state"),
    [
        (0.0, (8, 4), (0, 0), Comparison.DONE),
        (0.1, (8, 4), None, Comparison.CUT_SHORT),
        (0.0, (4, 8), None, Comparison.CUT_SHORT),
    ],
    ids=["same", "turned", "resized"],
)
def test_pictures_of_an_earlier_camera_name_no_pixel(
    moved: float, size: tuple[int, int], pixel: tuple[int, int] | None, state: Comparison
) -> None:
    """Its ray would be another one now; nor do they say that none differs."""
    desk = desk_of(moved, size, Mode.DIFFERENCE)
    assert next_wrong(desk, (-1, -1)) == pixel
    assert comparison(desk) is state


@pytest.mark.parametrize("mode", [Mode.SHADED, Mode.REFERENCE])
def test_a_picture_of_an_earlier_camera_is_dim(mode: Mode) -> None:
    """Of a process that has ended none will follow, and the status says so."""
    now, old = desk_of(0.0, (8, 4), mode), desk_of(0.1, (8, 4), mode)
    bright, dim = shown(now), shown(old)
    assert bright is not None
    assert dim is not None
    assert not is_old(now)
    assert is_old(old)
    assert (dim.pixels == bright.pixels // 3).all()
    old.stage.state = old.rival.state = State.TRACING
    assert not is_old(old)
    told = status(desk_of(0.1, (8, 4), mode), translator("de"), teller("de"))
    assert "Pixel (3, 4): beendet durch SIGSEGV" in told
    assert "frühere Ansicht" in told
