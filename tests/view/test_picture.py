"""What the two pictures of a desk say of each other, while the camera moves."""

from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest

from grader.view.desk import Desk
from grader.view.picture import Comparison, comparison, next_wrong
from grader.view.stage import State
from tests.view.shown import confetti

HOME = confetti().home


def stage(t: float) -> Any:  # noqa: ANN401 - takes the place of a stage
    """Have a whole picture of one distance, of a process that has ended."""
    shape = 4, 8
    traced = SimpleNamespace(
        t=np.full(shape, t, np.float32),
        bright=np.full(shape, 9, np.uint8),
        fine=np.ones(shape, np.bool_),
        orbit=HOME,
        is_done=True,
    )
    return SimpleNamespace(traced=traced, state=State.ENDED)


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
    desk = SimpleNamespace(
        stage=stage(1.0),
        rival=stage(2.0),
        orbit=HOME.turned(moved, 0.0),
        size=size,
        is_loading=False,
        is_building=False,
        lacks_tree=False,
    )
    assert next_wrong(cast("Desk", desk), (-1, -1)) == pixel
    assert comparison(cast("Desk", desk)) is state
