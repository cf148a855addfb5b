"""Times trimesh and Mitsuba on the rays of the bench: `python -m ... NAME FILE`.

FILE is the .npz that `against_embree.py` lays out. Prints CPU seconds of the scene and
microseconds a ray of each bundle as JSON; where the package cannot do it, it fails.
"""

import json
import sys
import time
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

Arrays = Mapping[str, Any]
"""`vertices` (V, 3) float32, `faces` (F, 3) uint32, `camera` and `scattered` (R, 8) float32."""

MOST_RAYS = 65_536


def with_trimesh(arrays: Arrays) -> dict[str, float]:
    """Ask `trimesh.ray`, which stands on embreex, for the first face of each ray."""
    import trimesh

    begun = time.process_time()
    mesh = trimesh.Trimesh(arrays["vertices"], arrays["faces"], process=False)
    caster = trimesh.ray.ray_pyembree.RayMeshIntersector(mesh)
    caster.intersects_first(arrays["camera"][:1, 0:3], arrays["camera"][:1, 3:6])
    return _timed(
        arrays, begun, lambda rays: caster.intersects_first(rays[:, 0:3], rays[:, 3:6])
    )


def with_mitsuba(arrays: Arrays) -> dict[str, float]:
    """Ask Mitsuba's scalar variant, ray by ray: what a grader in Python would call."""
    import mitsuba as mi

    mi.set_variant("scalar_rgb")
    begun = time.process_time()
    mesh = mi.Mesh("mesh", len(arrays["vertices"]), len(arrays["faces"]))
    parameters = mi.traverse(mesh)
    parameters["vertex_positions"] = np.asarray(arrays["vertices"], np.float32).ravel()
    parameters["faces"] = np.asarray(arrays["faces"], np.uint32).ravel()
    parameters.update()
    scene = mi.load_dict({"type": "scene", "mesh": mesh})

    def trace(rays: Any) -> None:  # noqa: ANN401 - an array of any origin
        for row in rays.tolist():
            scene.ray_intersect_preliminary(mi.Ray3f(row[0:3], row[3:6]))

    return _timed(arrays, begun, trace)


def _timed(arrays: Arrays, begun: float, trace: Callable[[Any], object]) -> dict[str, float]:
    found = {"construct": time.process_time() - begun}
    for name in ("camera", "scattered"):
        rays = arrays[name][:MOST_RAYS]
        begun = time.process_time()
        trace(rays)
        found[name] = (time.process_time() - begun) / len(rays) * 1e6
    return found


def main() -> None:
    """Time one of them."""
    name, given = sys.argv[1:3]
    with np.load(given) as file:
        arrays = dict(file)
    print(json.dumps({"trimesh": with_trimesh, "mitsuba": with_mitsuba}[name](arrays)))  # noqa: T201 - it is a program


if __name__ == "__main__":
    main()
