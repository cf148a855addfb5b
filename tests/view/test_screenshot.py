"""Both panes in one picture, whatever size the traced one has."""

from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

from grader.view.desk import Desk, Mode
from grader.view.preview import Preview
from grader.view.screenshot import GAP, panes, stretched
from grader.view.stage import State
from grader.view.study import Study
from tests.view.shown import confetti


class Blank:
    """Takes the place of OpenGL, and draws nothing."""

    tint = None
    _size = 0, 0

    def load(self, *_: object) -> None:
        """Take no mesh."""

    load_tree = load

    def draw(self, _: object, size: tuple[int, int], *__: object, **___: object) -> None:
        """Remember the size."""
        self._size = size

    def pixels(self) -> np.ndarray:
        """Give an empty picture of that size."""
        return np.zeros((*self._size[::-1], 3), np.uint8)


@pytest.mark.parametrize("traced", [(16, 24), (40, 10), (9, 70)], ids=str)
def test_a_picture_of_an_earlier_size_is_stretched(traced: tuple[int, int]) -> None:
    """A process that has ended traces none of the size that the pane has now."""
    subject = confetti()
    picture = SimpleNamespace(
        bright=np.full(traced, 200, np.uint8),
        seen=np.ones(traced, np.bool_),
        t=np.ones(traced, np.float32),
        orbit=subject.home,
    )
    stage = SimpleNamespace(subject=subject, traced=picture, tree=None, state=State.ENDED)
    desk = SimpleNamespace(
        subject=subject,
        orbit=subject.home,
        size=(16, 24),
        stage=stage,
        rival=None,
        mode=Mode.SHADED,
        level=0,
        deepest=-1,
        only=False,
    )
    study = SimpleNamespace(strokes=list)
    drawn = panes(cast("Desk", desk), cast("Study", study), cast("Preview", Blank()))
    assert drawn.shape == (24, 2 * 16 + GAP, 3)
    assert drawn[:, -16:].any(axis=2).all()


def test_every_pixel_is_the_nearest_one() -> None:
    """Also at the edges; a picture of the same size stays as it is."""
    small = np.arange(12, dtype=np.uint8).reshape(2, 2, 3)
    assert (stretched(small, 2, 2) == small).all()
    wide = stretched(small, 4, 6)
    assert (wide[:3, :2] == small[0, 0]).all()
    assert (wide[3:, 2:] == small[1, 1]).all()
