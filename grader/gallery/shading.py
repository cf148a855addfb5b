"""How does what `intersect` found become a picture like Mitsuba's, shadows included?

The light is a direction, the surface scatters alike in all directions and on both sides, and
nothing is reflected twice: what Mitsuba's integrator `direct` computes for such a scene.
"""

import numpy as np

from grader.model.cases import ImageCase
from grader.model.mesh import Bytes, Doubles, Floats, Integers, Mask, Rays
from grader.model.scene import Scene

IRRADIANCE = 3.0
"""Of the light, on a face that looks into it; `oracle/render.py` gives Mitsuba the same."""

BACKGROUND = (0.011, 0.012, 0.016)
"""Linear RGB of a pixel that sees nothing."""

LIFT = 1500 * 2.0**-24
"""How far a shadow ray begins above the surface, times 1 + the largest coordinate there.

As in Mitsuba (`RayEpsilon` of float32, and `SurfaceInteraction::offset_p`): with another lift,
pixels at the edge of a shadow come out differently.
"""


def shadow_rays(case: ImageCase, scene: Scene) -> tuple[Integers, Rays]:
    """Aim from every hit that could be lit at the light.

    Returns:
        (K,) int64 pixels, and the rays that begin there.
    """
    pixels = np.flatnonzero(_faces_the_light(case, scene))
    count, point = pixels.size, _points(case)[pixels]
    normal, light = case.hits.normal[pixels].astype(np.float64), _light(scene)
    lift = LIFT * (1 + np.abs(point).max(axis=1, initial=0.0))
    up = -np.sign(normal @ light)
    return pixels, Rays(
        origin=(point + (lift * up)[:, None] * normal).astype(np.float32),
        direction=np.broadcast_to(-light, (count, 3)).astype(np.float32),
        t_min=np.zeros(count, np.float32),
        t_max=np.full(count, np.inf, np.float32),
    )


def shaded(case: ImageCase, scene: Scene, lit: Mask) -> Bytes:
    """Shade what a submission found.

    Args:
        case: Its hits.
        scene: Light and colour.
        lit: (R,) bool, True where the light is seen.

    Returns:
        (R, 3) uint8, sRGB.
    """
    with np.errstate(invalid="ignore", over="ignore"):
        cosine = np.abs(case.hits.normal.astype(np.float64) @ _light(scene))
    bright = np.where(lit, np.nan_to_num(np.clip(cosine, 0, 1)), 0.0)
    colour = np.array(scene.albedo) * (IRRADIANCE / np.pi)
    return displayed(bright[:, None] * colour, np.isfinite(case.hits.t))


def displayed(linear: Floats | Doubles, hit: Mask) -> Bytes:
    """Encode colours for a screen.

    Args:
        linear: (R, 3) linear RGB.
        hit: (R,) bool, False where the background is seen.

    Returns:
        (R, 3) uint8, sRGB.

    Source: IEC 61966-2-1, the transfer function of sRGB.
    """
    colour = np.clip(np.where(hit[:, None], linear, BACKGROUND), 0.0, 1.0)
    bent = 1.055 * colour ** (1 / 2.4) - 0.055
    encoded = np.where(colour <= 0.0031308, 12.92 * colour, bent)
    return np.asarray(np.rint(255 * encoded), np.uint8)


def _faces_the_light(case: ImageCase, scene: Scene) -> Mask:
    """Return (R,) bool: the surface is seen from the side that the light comes from."""
    normal = case.hits.normal.astype(np.float64)
    with np.errstate(invalid="ignore", over="ignore"):
        seen = (normal * case.trial.rays.direction).sum(axis=1)
        same_side = seen * (normal @ _light(scene)) > 0
        known = np.isfinite(case.hits.t) & np.isfinite(_points(case)).all(axis=1)
    return np.asarray(known & same_side, np.bool_)


def _points(case: ImageCase) -> Doubles:
    """Return (R, 3) float64, where the rays end by the submission's own t."""
    rays = case.trial.rays
    with np.errstate(invalid="ignore", over="ignore"):
        along = rays.direction.astype(np.float64) * case.hits.t[:, None]
        return rays.origin + along


def _light(scene: Scene) -> Doubles:
    """Return the unit vector that the light shines along."""
    direction = np.array(scene.light, np.float64)
    unit: Doubles = direction / np.linalg.norm(direction)
    return unit
