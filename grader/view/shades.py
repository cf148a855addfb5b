"""How do hits become colours, from wherever one looks? The preview shades alike."""

import numpy as np

from grader.model.mesh import Bytes, Doubles, Floats, Integers, Mask
from grader.view.camera import Frame

BACKGROUND = (24, 26, 31)
"""sRGB of what no ray hits."""

DARKEST = 0.28
"""Of a face that is seen edge-on."""

APART = 1e-4
"""Two distances are told apart from here on, relative to the larger one: the rule of closest
hits decides grades, this only colours a picture."""


def light_of(frame: Frame) -> Doubles:
    """Return the unit vector to the lamp, which is carried along, above the right shoulder."""
    lamp = frame.back + 0.5 * frame.up + 0.3 * frame.right
    return np.asarray(lamp / np.linalg.norm(lamp))


def shaded(hits: Floats, frame: Frame, albedo: tuple[float, float, float]) -> Bytes:
    """Shade hits.

    Args:
        hits: (K, 7) float32, point, t and normal.
        frame: Of the camera.
        albedo: Of the surface, 0 to 1.

    Returns:
        (K, 3) uint8, sRGB.
    """
    light = light_of(frame).astype(np.float32)
    with np.errstate(invalid="ignore", over="ignore"):
        cosine = np.abs(hits[:, 4:7] @ light)
    bright = DARKEST + (1 - DARKEST) * np.nan_to_num(np.clip(cosine, 0, 1))
    colour = np.rint(bright[:, None] * tint(albedo)).astype(np.uint8)
    return np.where(is_hit(hits)[:, None], colour, np.array(BACKGROUND, np.uint8))


def tint(albedo: tuple[float, float, float]) -> Floats:
    """Return (3,) float32, 0 to 255, the colour of a surface in full light on a screen."""
    return np.asarray(255 * np.array(albedo) ** (1 / 2.2), np.float32)


def is_hit(hits: Floats) -> Mask:
    """(K,) bool, what `Intersection` itself says: a t that is below infinity."""
    with np.errstate(invalid="ignore"):
        return np.asarray(hits[:, 3] < np.inf)


def differing(one: Floats, other: Floats) -> Mask:
    """(K,) bool, True where one t is finite and the other not, or both are apart."""
    with np.errstate(invalid="ignore", over="ignore"):
        same = np.abs(one - other) <= APART * np.maximum(np.abs(one), np.abs(other))
        return np.asarray(~(same | ((one >= np.inf) & (other >= np.inf))))


def heat(tests: Integers, scale: int, colours: Bytes) -> Bytes:
    """Colour costs.

    Args:
        tests: (K,) int64, box tests and triangle tests together.
        scale: The cost at the bright end.
        colours: (256, 3) uint8, from the dark end to the bright one.
    """
    place = np.minimum(255 * tests // max(scale, 1), 255)
    return np.asarray(colours[place])
