"""How do hits become colours, from wherever one looks? The preview shades alike."""

import numpy as np

from grader.model.mesh import Bytes, Doubles, Floats, Indices, Mask
from grader.view.camera import Frame

BACKGROUND = (24, 26, 31)
"""sRGB of what no ray hits."""

DARKEST = 0.28
"""Of a face that is seen edge-on."""

APART = 1e-4
"""Two distances are told apart from here on, relative to the larger one: the rule of closest
hits decides grades, this only colours a picture."""


def light_of(frame: Frame) -> Doubles:
    """Return the unit vector to the lamp, which is carried along, above the right shoulder.

    It is (3,) float64, in world space.
    """
    lamp = frame.back + 0.5 * frame.up + 0.3 * frame.right
    return np.asarray(lamp / np.linalg.norm(lamp))


def brightness(hits: Floats, frame: Frame) -> Bytes:
    """Shade hits.

    Args:
        hits: (K, 7) float32, point, t and normal.
        frame: Of the camera.

    Returns:
        (K,) uint8, 0 where nothing is hit, 1 to 255 from edge-on to full light.
    """
    light = light_of(frame).astype(np.float32)
    with np.errstate(invalid="ignore", over="ignore"):
        cosine = np.abs(hits[:, 4:7] @ light)
    steps = 1 + np.rint(254 * np.nan_to_num(np.clip(cosine, 0, 1))).astype(np.uint8)
    return np.where(is_hit(hits[:, 3]), steps, np.uint8(0))


def coloured(bright: Bytes, albedo: tuple[float, float, float]) -> Bytes:
    """Colour what was shaded.

    Args:
        bright: (...) uint8, from `brightness`.
        albedo: Of the surface, 0 to 1.

    Returns:
        (..., 3) uint8, sRGB.
    """
    share = DARKEST + (1 - DARKEST) * np.arange(-1, 255)[:, None] / 254
    table = np.rint(share * tint(albedo)).clip(0, 255).astype(np.uint8)
    table[0] = BACKGROUND
    return np.asarray(table.take(bright, axis=0))


def tint(albedo: tuple[float, float, float]) -> Floats:
    """Return (3,) float32, 0 to 255, the colour of a surface in full light on a screen."""
    return np.asarray(255 * np.array(albedo) ** (1 / 2.2), np.float32)


def is_hit(t: Floats) -> Mask:
    """(...) bool, what `Intersection` says of a t, (...) float32: it is below infinity."""
    with np.errstate(invalid="ignore"):
        return np.asarray(t < np.inf)


def differing(one: Floats, other: Floats) -> Mask:
    """(K,) bool, True where one t is finite and the other not, or both are apart.

    Both are (K,) float32.
    """
    with np.errstate(invalid="ignore", over="ignore"):
        near = np.abs(one - other) <= APART * np.maximum(np.abs(one), np.abs(other))
    both = np.isfinite(one) & np.isfinite(other)
    return np.asarray(np.where(both, ~near, is_hit(one) != is_hit(other)))


def heat(tests: Indices, scale: int, colours: Bytes) -> Bytes:
    """Colour costs.

    Args:
        tests: (...) uint32, box tests and triangle tests together.
        scale: The cost at the bright end.
        colours: (256, 3) uint8, from the dark end to the bright one.
    """
    place = np.minimum(tests, scale).astype(np.int64) * 255 // max(scale, 1)
    return np.asarray(colours.take(place, axis=0))
