"""What does the right pane show of a desk? Colours, and the scale that belongs to them."""

from dataclasses import dataclass, replace
from enum import Enum
from typing import Any

import numpy as np

from grader.language import Words
from grader.model.mesh import Bytes, Mask
from grader.report.colours import HEAT
from grader.view.desk import Desk, Mode
from grader.view.inspector import next_of
from grader.view.shades import BACKGROUND, coloured, differing, heat, is_hit
from grader.view.stage import Stage, State
from grader.view.traced import Traced

BRIGHTEST = 99
"""Percentile of the cost at the bright end: a few rays cost ten times as much as all others."""

WRONG = (250, 62, 62)
DIMMED = 3
"""By so much darker is a picture of an earlier view."""

SHADE = 8
"""Steps of 255 by which the shades of two hits may be apart: rounded normals are not."""


class Comparison(Enum):
    """How far your picture and the model solution's are."""

    GOES_ON = "goes on"
    DONE = "done"
    CUT_SHORT = "cut short"
    """One of them never becomes whole."""


@dataclass(frozen=True, slots=True)
class Shown:
    """A picture, (H, W, 3) uint8 sRGB, and what is to be said of it."""

    pixels: Bytes
    scale: int = 0
    """Cost at the bright end; 0 where no cost is shown."""

    wrong: int = -1
    """Pixels that differ from the model solution's; -1 where that is not shown."""


def titles(words: Words) -> dict[Mode, str]:
    """Name what the right pane can show."""
    return {
        Mode.SHADED: words("your picture"),
        Mode.COST: words("cost of each ray"),
        Mode.REFERENCE: words("model solution"),
        Mode.DIFFERENCE: words("pixels that differ"),
    }


def shown(desk: Desk) -> Shown | None:
    """Make the picture of a desk; None if nothing is traced yet.

    An old one is dim, or it would be taken for what is on the left.
    """
    found = _picture(desk)
    if found is None or not is_old(desk):
        return found
    return replace(found, pixels=found.pixels // DIMMED)


def is_old(desk: Desk) -> bool:
    """Whether the picture is of an earlier view, since its process traces no more."""
    stage = _on_the_right(desk)
    if stage is None or stage.state is not State.ENDED or _is_current(desk, stage):
        return False
    return bool(stage.traced.seen.any())


def _on_the_right(desk: Desk) -> Stage | None:
    return desk.rival if desk.mode is Mode.REFERENCE else desk.stage


def _picture(desk: Desk) -> Shown | None:
    stage = _on_the_right(desk)
    if stage is None or not stage.traced.seen.any():
        return None
    traced = stage.traced
    if desk.mode is Mode.COST:
        return _costs(traced)
    pixels = coloured(traced.bright, stage.subject.albedo)
    if desk.mode is not Mode.DIFFERENCE:
        return Shown(pixels)
    mask = wrong_pixels(desk)
    if mask is None:
        return Shown(pixels)
    grey = pixels.mean(axis=2, keepdims=True).astype(np.uint8) // 2 + 20
    pixels = np.repeat(grey, 3, axis=2)
    pixels[mask] = WRONG
    return Shown(pixels, wrong=int(mask.sum()))


def wrong_pixels(desk: Desk) -> np.ndarray | None:
    """(H, W) bool, where both have painted and t or the shade differs.

    The shade tells of the normal. None if the pictures are not comparable.
    """
    if desk.stage is None or desk.rival is None:
        return None
    yours, ours = desk.stage.traced, desk.rival.traced
    if yours.t.shape != ours.t.shape or yours.orbit != ours.orbit:
        return None
    return _other(yours, ours, ...)


def _other(yours: Traced, ours: Traced, where: Any) -> Mask:  # noqa: ANN401 - numpy's index
    """(...) bool, where t or the shade differs and both have painted as finely as can be."""
    t = yours.t[where], ours.t[where]
    both = is_hit(t[0]) & is_hit(t[1])
    step = np.abs(yours.bright[where].astype(np.int16) - ours.bright[where])
    apart = differing(*t) | (both & (step > SHADE))
    return np.asarray(apart & yours.fine[where] & ours.fine[where])


def next_wrong(desk: Desk, after: tuple[int, int]) -> tuple[int, int] | None:
    """Return the next pixel that differs so far, from the start if need be.

    Args:
        desk: What is shown.
        after: Column and row; negative to begin at the start.
    """
    mask = wrong_pixels(desk)
    # Right after a move the picture is still the one before, seen from elsewhere.
    if mask is None or not _is_current(desk, desk.stage):
        return None
    column, row = after
    place = next_of(np.flatnonzero(mask), row * mask.shape[1] + column if column >= 0 else -1)
    return (place % mask.shape[1], place // mask.shape[1]) if place >= 0 else None


def comparison(desk: Desk) -> Comparison:
    """Tell whether more pixels may still turn out to differ."""
    stages = [one for one in (desk.stage, desk.rival) if one is not None]
    if desk.is_loading or desk.is_building or desk.lacks_tree:
        return Comparison.GOES_ON
    if len(stages) < 2 or any(
        one.state is State.ENDED and not (one.traced.is_done and _is_current(desk, one))
        for one in stages
    ):
        return Comparison.CUT_SHORT
    done = all(one.traced.is_done for one in stages)
    return Comparison.DONE if done else Comparison.GOES_ON


def remark_of(state: Comparison, words: Words) -> str:
    """Say that no pixel differs, as far as it is known."""
    if state is Comparison.GOES_ON:
        return words("looking for a pixel that differs ...")
    if state is Comparison.CUT_SHORT:
        return words("no pixel differs so far")
    return words("no pixel differs")


def compared(desk: Desk, pixel: tuple[int, int], words: Words) -> tuple[float | None, str]:
    """Return the model solution's t of a pixel, and what else is wrong there.

    Args:
        desk: What is shown.
        pixel: Column and row.
        words: Translates our own texts.

    Returns:
        None and nothing, as long as that is not known.
    """
    if desk.stage is None or desk.rival is None:
        return None, ""
    yours, ours, place = desk.stage.traced, desk.rival.traced, pixel[::-1]
    if not _is_current(desk, desk.rival) or not ours.fine[place]:
        return None, ""
    note, t = "", (yours.t[place], ours.t[place])
    if _is_current(desk, desk.stage) and _other(yours, ours, place) and not differing(*t):
        note = words("t is right, but the normal is not the model solution's")
    return float(ours.t[place]), note


def _is_current(desk: Desk, stage: Stage | None) -> bool:
    """Tell whether what is traced is the view that is wanted."""
    traced = stage.traced if stage else None
    return bool(traced and traced.orbit == desk.orbit and traced.t.shape == desk.size[::-1])


def _costs(traced: Traced) -> Shown:
    known = traced.tests[traced.seen]
    scale = max(1, int(np.percentile(known, BRIGHTEST)))
    pixels = heat(traced.tests, scale, HEAT)
    pixels[~traced.seen] = BACKGROUND
    return Shown(pixels, scale=scale)
