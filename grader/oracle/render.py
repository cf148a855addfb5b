"""What does Mitsuba see? Renders the reference picture of a scene.

Theory of operation. Rays are Mitsuba's own, one through each pixel's centre, and are stored
with the picture, so that no second camera model has to agree with Mitsuba's. Mitsuba starts
its rays at the near plane and measures depth from there; with a near plane of 1e-10 that is
the camera's position to the last bit, and a depth is the `t` of the stored ray. Embree's
default intersector loses hits on edges, so the robust one is asked for.
"""

import os
from collections.abc import Mapping
from importlib.metadata import PackageNotFoundError, version
from typing import Any

import numpy as np

from grader.errors import MissingTool
from grader.model.mesh import Mesh, Rays
from grader.model.scene import NO_FACE, Reference, Scene
from grader.oracle.exr import scene_key
from grader.oracle.variant import LIBRARY_VARIABLE, Variant
from grader.tolerances import EPSILON

NEAR, FAR = 1e-10, 1e4
LIGHT = 3.0
"""Irradiance that shades a white face, lit head-on, with 3 / pi."""

CHANNELS = "t:depth,point:position,normal:geo_normal,face:prim_index"
"""In the picture they follow the three colours in this order: 1, 3, 3 and 1 channels."""


def render(scene: Scene, mesh: Mesh, variant: Variant) -> Reference:
    """Render a scene with Mitsuba.

    Raises:
        MissingTool: Mitsuba is not installed.
    """
    mi = _mitsuba(variant)
    world = mi.load_dict(_description(mi, scene, mesh))
    picture = np.array(mi.render(world, spp=1), dtype=np.float32)
    pixels = picture.reshape(scene.height * scene.width, -1)
    hit = pixels[:, 3] > 0
    face = np.where(hit, pixels[:, 10], 0).astype(np.uint32)
    return Reference(
        key=scene_key(scene, mesh),
        made_with=_versions(variant),
        rays=_sensor_rays(mi, world.sensors()[0], scene),
        t=np.where(hit, pixels[:, 3], np.float32(np.inf)),
        point=np.where(hit[:, None], pixels[:, 4:7], np.float32(0)),
        normal=np.where(hit[:, None], pixels[:, 7:10], np.float32(0)),
        face=np.where(hit, face, np.uint32(NO_FACE)),
        shaded=np.where(hit[:, None], pixels[:, 0:3], np.float32(0)),
    )


def mitsuba_version() -> str | None:
    """Return the version of Mitsuba that is installed; None if there is none."""
    try:
        return version("mitsuba")
    except PackageNotFoundError:
        return None


def _mitsuba(variant: Variant) -> Any:  # noqa: ANN401 - Mitsuba's types depend on the variant
    """Import Mitsuba and select the variant."""
    if variant.library is not None:
        os.environ[LIBRARY_VARIABLE] = str(variant.library)
    try:
        import mitsuba as mi
    except ImportError as fault:
        message = f"Mitsuba cannot be imported ({fault}); install the Python package mitsuba"
        raise MissingTool(message) from fault
    mi.set_variant(variant.name)
    return mi


def _versions(variant: Variant) -> tuple[tuple[str, str], ...]:
    """Name the programs behind a picture."""
    return (
        ("mitsuba", version("mitsuba")),
        ("drjit", version("drjit")),
        ("variant", variant.name),
    )


def _description(mi: Any, scene: Scene, mesh: Mesh) -> Mapping[str, object]:  # noqa: ANN401 - as above
    """Describe a scene as Mitsuba's `load_dict` takes it."""
    camera = scene.camera
    to_world = mi.ScalarTransform4f().look_at(
        list(camera.origin), list(camera.target), list(camera.up)
    )
    film = {
        "type": "hdrfilm",
        "width": scene.width,
        "height": scene.height,
        "pixel_format": "rgb",
        "component_format": "float32",
        "rfilter": {"type": "box"},
    }
    return {
        "type": "scene",
        "embree_use_robust_intersections": True,
        "mesh": _mitsuba_mesh(mi, scene, mesh),
        "light": {
            "type": "directional",
            "direction": list(scene.light),
            "irradiance": {"type": "rgb", "value": LIGHT},
        },
        "sensor": {
            "type": "perspective",
            "fov": camera.fov,
            "fov_axis": "y",
            "near_clip": NEAR,
            "far_clip": FAR,
            "to_world": to_world,
            "film": film,
            "sampler": {"type": "stratified", "sample_count": 1, "jitter": False},
        },
        "integrator": {
            "type": "aov",
            "aovs": CHANNELS,
            "colours": {"type": "direct", "hide_emitters": True},
        },
    }


def _mitsuba_mesh(mi: Any, scene: Scene, mesh: Mesh) -> Any:  # noqa: ANN401 - as above
    """Hand the same float32 arrays to Mitsuba that a submission gets."""
    colour = {"type": "rgb", "value": list(scene.albedo)}
    properties = mi.Properties()
    properties["bsdf"] = mi.load_dict(
        {"type": "twosided", "side": {"type": "diffuse", "reflectance": colour}}
    )
    shape = mi.Mesh(scene.name, len(mesh.vertices), len(mesh.faces), props=properties)
    parameters = mi.traverse(shape)
    parameters["vertex_positions"] = mesh.vertices.ravel()
    parameters["faces"] = mesh.faces.ravel()
    parameters.update()
    return shape


def _sensor_rays(mi: Any, sensor: Any, scene: Scene) -> Rays:  # noqa: ANN401 - as above
    """Ask the sensor for the ray through each pixel's centre, as the sampler does."""
    pixels = scene.width * scene.height
    y, x = np.divmod(np.arange(pixels), scene.width)
    across = ((x + 0.5) / scene.width).astype(np.float32)
    down = ((y + 0.5) / scene.height).astype(np.float32)
    if mi.variant().startswith("scalar"):
        pairs = [
            _one_ray(mi, sensor, *place)
            for place in zip(across.tolist(), down.tolist(), strict=True)
        ]
        both = np.array(pairs, dtype=np.float32).transpose(1, 0, 2)
    else:
        both = np.array(_one_ray(mi, sensor, mi.Float(across), mi.Float(down)))
        both = both.transpose(0, 2, 1)
    return Rays(
        origin=np.ascontiguousarray(both[0]),
        direction=np.ascontiguousarray(both[1]),
        t_min=np.full(pixels, EPSILON, dtype=np.float32),
        t_max=np.full(pixels, np.inf, dtype=np.float32),
    )


def _one_ray(mi: Any, sensor: Any, across: Any, down: Any) -> tuple[Any, Any]:  # noqa: ANN401 - as above
    """Return origin and direction through a place on the film, both from 0 to 1.

    Of an LLVM variant `across` and `down` hold many places, and all rays come at once.
    """
    ray, _ = sensor.sample_ray(0.0, 0.0, mi.Point2f(across, down), mi.Point2f(0.5, 0.5))
    return np.array(ray.o), np.array(ray.d)
