"""Does a second, independent ray tracer agree with the rule of closest hits?

Theory of operation. Embree in robust mode traces the same float32 rays. It starts every ray at
t = 0, so it can speak only on rays with the default `t_min`, and not where it finds something
before that. The rule is held to it where the rule leaves no choice. A disagreement there is our
own fault: the answers of that trial must not judge anybody.
"""

from typing import Any

import numpy as np

from grader.errors import MissingTool
from grader.model.mesh import SOLID, Answers, Doubles, Floats, Mask, Mesh, Rays
from grader.tolerances import EPSILON


def embree_t(mesh: Mesh, rays: Rays) -> Floats:
    """Return (R,) float32, Embree's closest hit from t = 0 up to `t_max`; infinite for a miss.

    Raises:
        MissingTool: embreex is not installed.
    """
    if len(mesh.faces) == 0 or len(rays.t_min) == 0:
        return np.full(len(rays.t_min), np.inf, dtype=np.float32)
    rtcore, construction = _embree()
    scene = rtcore.EmbreeScene(robust=True)
    # The scene only borrows the triangles.
    held = construction.TriangleMesh(scene, mesh.vertices, mesh.faces.astype(np.int32))
    found = scene.run(rays.origin, rays.direction, rays.t_max.copy(), output=1)
    del held
    t: Floats = np.where(found["primID"] >= 0, found["tfar"], np.float32(np.inf))
    return t


def witnessed(rays: Rays, answers: Answers, t: Floats) -> Mask:
    """Return (R,) bool, True where Embree can say whether the rule is right.

    Args:
        rays: The rays.
        answers: What the rule says of them.
        t: (R,) what Embree says.
    """
    clear = np.ones(t.size, dtype=np.bool_)
    owner = np.repeat(np.arange(t.size), np.diff(answers.first))
    clear[owner[answers.kind != SOLID]] = False
    fit: Mask = clear & (rays.t_min == np.float32(EPSILON)) & (t > 2 * EPSILON)
    return fit


def contradicted(rays: Rays, answers: Answers, t: Floats) -> Mask:
    """Return (R,) bool, True where Embree, as a fit witness, contradicts the rule.

    Args:
        rays: The rays.
        answers: What the rule says of them.
        t: (R,) float32, as `embree_t` returns it.
    """
    owner = np.repeat(np.arange(t.size), np.diff(answers.first))
    theirs: Doubles = t.astype(np.float64)
    agrees = ~np.isfinite(answers.limit) & (theirs == np.inf)
    solid = answers.kind == SOLID
    owner = owner[solid]
    near = np.abs(theirs[owner] - answers.t[solid]) <= answers.tolerance[solid]
    agrees[owner[near]] = True
    agrees &= ~(theirs > answers.limit)
    wrong: Mask = witnessed(rays, answers, t) & ~agrees
    return wrong


def _embree() -> tuple[Any, Any]:
    """Import embreex."""
    try:
        from embreex import mesh_construction, rtcore_scene
    except ImportError as fault:
        message = f"embreex cannot be imported ({fault}); install the Python package embreex"
        raise MissingTool(message) from fault
    return rtcore_scene, mesh_construction
