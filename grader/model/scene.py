"""What a picture scene is, and what Mitsuba's picture of it holds."""

from dataclasses import dataclass

from grader.model.mesh import Floats, FrozenArrays, Indices, Rays

NO_FACE = 2**32 - 1
"""Face index of a pixel that sees nothing."""


@dataclass(frozen=True, slots=True)
class Camera:
    """A pinhole camera, world space."""

    origin: tuple[float, float, float]
    target: tuple[float, float, float]
    up: tuple[float, float, float]
    fov: float
    """Vertical angle of view in degrees."""


@dataclass(frozen=True, slots=True)
class Scene:
    """One mesh, one camera, one directional light; `scenes.toml` lists them."""

    name: str
    title: str
    mesh: str
    """Name of the stored mesh."""

    camera: Camera
    light: tuple[float, float, float]
    """Where the light shines to, world space; needs no unit length."""

    albedo: tuple[float, float, float]
    width: int
    height: int
    weight: float = 1.0
    """How many ordinary cases it counts for where the points of a check are shared."""

    visibility: str = "visible"
    """`visible`, `hidden` or `after_due_date`; students see no other than visible ones."""


@dataclass(frozen=True, slots=True, eq=False)
class Reference(FrozenArrays):
    """Mitsuba's picture of a scene, row by row from the top left pixel."""

    key: str
    """Hash of everything that the picture depends on; another key means a stale picture."""

    made_with: tuple[tuple[str, str], ...]
    """Program and version that rendered it: `("mitsuba", "3.9.1")`."""

    rays: Rays
    t: Floats
    """(R,) float32, hit distance along the ray; infinite for a miss."""

    point: Floats
    """(R, 3) float32, world space; 0 for a miss."""

    normal: Floats
    """(R, 3) float32, unit normal of the face, not turned to the ray; 0 for a miss."""

    face: Indices
    """(R,) uint32, index of the face hit; `NO_FACE` for a miss."""

    shaded: Floats
    """(R, 3) float32, linear RGB under the scene's light with shadows; 0 for a miss."""
