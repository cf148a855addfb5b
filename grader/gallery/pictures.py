"""What did the submission see of each scene, and how is that unlike Mitsuba's picture?"""

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from grader.gallery.hung import Exhibit, reference_picture
from grader.gallery.shading import shaded, shadow_rays
from grader.model.cases import ImageCase
from grader.model.mesh import Bytes, Floats, Mask, Rays
from grader.model.scene import Scene
from grader.model.stages import Stop
from grader.model.views import Drawing, Picture
from grader.run.job import Job
from grader.run.session import Allowance, Engine, run_job
from grader.run.transfer import on_tree, trace
from grader.run.trials import WORKERS
from grader.verify.images import wrong_pixels

SAME = 2
"""Levels of 255 by which a right pixel may differ from Mitsuba's and is shown as the same.

Mitsuba adds in float32 where `shading.py` has float64; shadows are another matter."""

REACH = 48
"""Pixels beyond which FLIP's filters see nothing, for a screen seen as usual (67 pixels a
degree): 20 of the widest, twice because filtered pictures are filtered."""

SHADOW_SECONDS = 2.0
"""CPU seconds of all shadow rays of a scene: ten times what the model solution takes."""


def pictures(
    exhibits: Sequence[Exhibit], engine: Engine, seconds: float
) -> tuple[Picture, ...]:
    """Draw scenes.

    Args:
        exhibits: Which, with what the submission delivered.
        engine: Traces the shadow rays.
        seconds: Wall time that they may take, all scenes together.
    """
    share = seconds / max(len(exhibits), 1)
    allowed = Allowance(min(SHADOW_SECONDS, share), share)
    # While a worker traces the shadows of one scene, the other is shaded.
    with ThreadPoolExecutor(WORKERS) as pool:
        return tuple(pool.map(lambda one: _picture(one, engine, allowed), exhibits))


def _picture(one: Exhibit, engine: Engine, allowed: Allowance) -> Picture:
    scene, reference = one.place.scene, reference_picture(one.place)
    case = one.seen
    drawn = None if case is None else _drawing(scene, case, reference, engine, allowed)
    return Picture(scene.name, scene.title, reference, drawn)


def _drawing(
    scene: Scene, case: ImageCase, reference: Bytes, engine: Engine, allowed: Allowance
) -> Drawing:
    pixels, rays = shadow_rays(case, scene)
    lit = _lit(case, rays, engine, allowed)
    bright = np.zeros(case.hits.t.size, np.bool_)
    bright[pixels] = True if lit is None else lit
    wrong = _as_rows(wrong_pixels(case).astype(np.uint8), scene)
    yours = _settled(_as_rows(shaded(case, scene, bright), scene), reference, wrong)
    error, mean = flip(reference, yours)
    boxes, triangles = case.tests.mean(axis=0, dtype=np.float64)
    return Drawing(
        yours=yours,
        difference=np.rint(255 * error).astype(np.uint8),
        wrong=wrong,
        tests=_as_rows(case.tests.sum(axis=1, dtype=np.int64), scene),
        flip=mean,
        box_tests=float(boxes),
        triangle_tests=float(triangles),
        without_shadows=lit is None,
    )


def _lit(case: ImageCase, rays: Rays, engine: Engine, allowed: Allowance) -> Mask | None:
    """Ask the submission which of its own hits see the light; None if it does not answer.

    Args:
        case: Its hits.
        rays: From K of them to the light.
        engine: Runs it.
        allowed: How long it may take.

    Returns:
        (K,) bool.
    """
    job = Job()
    read = trace(job, on_tree(job, case.trial.mesh, case.trial.tree), rays)
    ending, result = run_job(job, engine, allowed)
    if result is None or ending.stop is not Stop.FINISHED:
        return None
    return np.asarray(np.isinf(read(result).hits[0].t), np.bool_)


def _settled(yours: Bytes, reference: Bytes, wrong: Bytes) -> Bytes:
    """Take Mitsuba's colour where only rounding is between the two."""
    apart = np.abs(yours.astype(np.int16) - reference).max(axis=2) > SAME
    return np.where((apart | (wrong > 0))[..., None], yours, reference)


def flip(reference: Bytes, test: Bytes) -> tuple[Floats, float]:
    """Return the FLIP error of each pixel, (H, W) float32 from 0 to 1, and its mean.

    Args:
        reference: (H, W, 3) uint8, sRGB, as is `test`.
        test: Is compared with it.

    Source: P. Andersson et al., FLIP: A Difference Evaluator for Alternating Images,
    Proceedings of the ACM on Computer Graphics and Interactive Techniques 3(2), 2020.
    """
    error = np.zeros(reference.shape[:2], np.float32)
    apart = (reference != test).any(axis=2)
    if apart.any():
        import flip_evaluator

        window = tuple(_reach(apart.any(axis=1 - axis)) for axis in (0, 1))
        pair = [one[window].astype(np.float32) / np.float32(255) for one in (reference, test)]
        found, _, _ = flip_evaluator.evaluate(*pair, "LDR", applyMagma=False)
        error[window] = np.clip(found[..., 0], 0.0, 1.0)
    return error, float(error.mean(dtype=np.float64))


def _reach(apart: Mask) -> slice:
    """Return the rows or columns that FLIP could find different, and some more."""
    (places,) = np.nonzero(apart)
    return slice(max(0, int(places[0]) - REACH), int(places[-1]) + 1 + REACH)


def _as_rows(values: np.ndarray, scene: Scene) -> np.ndarray:
    return values.reshape(scene.height, scene.width, *values.shape[1:])
