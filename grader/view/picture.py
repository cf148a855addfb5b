"""What does the right pane show of a desk? Colours, and the scale that belongs to them."""

from dataclasses import dataclass

import numpy as np

from grader.language import Words
from grader.model.mesh import Bytes
from grader.report.colours import HEAT
from grader.view.desk import Desk, Mode
from grader.view.shades import BACKGROUND, coloured, differing, heat
from grader.view.traced import Traced

BRIGHTEST = 99
"""Percentile of the cost at the bright end: a few rays cost ten times as much as all others."""

WRONG = (250, 62, 62)


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
    """Make the picture of a desk; None if nothing is traced yet."""
    stage = desk.rival if desk.mode is Mode.REFERENCE else desk.stage
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
    """(H, W) bool, where both have painted and t differs; None if they are not comparable."""
    if desk.stage is None or desk.rival is None:
        return None
    yours, ours = desk.stage.traced, desk.rival.traced
    if yours.t.shape != ours.t.shape or yours.orbit != ours.orbit:
        return None
    apart = differing(yours.t, ours.t)
    # Blocks that not both have painted as finely are not comparable yet.
    fine = yours.fine & ours.fine
    return np.asarray(apart & fine)


def _costs(traced: Traced) -> Shown:
    known = traced.tests[traced.seen]
    scale = max(1, int(np.percentile(known, BRIGHTEST)))
    pixels = heat(traced.tests, scale, HEAT)
    pixels[~traced.seen] = BACKGROUND
    return Shown(pixels, scale=scale)
