"""What does a folder of scenes say of itself, and is every line of it one that we understand?

Strict, as the rubric is: a misspelt key that is silently ignored would show another picture.
"""

import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from grader.model.grade import VISIBILITIES
from grader.model.scene import Camera, Scene
from grader.oracle.generated import GENERATED, MOST_FACES
from grader.resources import scenes_folder
from grader.table import Table, read_table

FILE = "scenes.toml"
FARTHEST = 1e3
"""Of any coordinate of a camera: Mitsuba's far plane lies at 10,000."""

SMALLEST_PICTURE, LARGEST_PICTURE = 16, 1024
LEAST_WEIGHT, MOST_WEIGHT = 0.01, 100
NAME = re.compile(r"[a-z0-9][a-z0-9-]{0,39}")
SCENE_KEYS = ("name", "title", "mesh", "width", "height", "camera", "light", "albedo")

Three = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Recipe:
    """What a generator is told."""

    generator: str
    faces: int
    seed: int


@dataclass(frozen=True, slots=True)
class StoredMesh:
    """One mesh of a folder of scenes."""

    name: str
    source: str
    """Name of the file that was converted, or of a maker in `scenes.GENERATORS`; empty if it
    is generated anew each time."""

    recipe: Recipe | None
    """How it is generated; None if it is stored."""

    sha256: str
    """Of its vertices and faces as bytes."""

    place: str
    """File and table that describe it, for messages."""


@dataclass(frozen=True, slots=True)
class Described:
    """All that a folder's `scenes.toml` describes, in its order."""

    meshes: tuple[StoredMesh, ...]
    scenes: tuple[Scene, ...]


def described(folder: Path | None = None) -> Described:
    """Read the `scenes.toml` of a folder and reject whatever is not understood.

    Args:
        folder: A course's own; None takes the one that is shipped.

    Raises:
        UsageError: With the file, the place in it, what is there and what was expected.
    """
    shipped = scenes_folder()
    own = folder is not None and folder.resolve() != shipped.resolve()
    path = (folder or shipped) / FILE
    root, _ = read_table(path, f"the {FILE} of a folder of scenes")
    root.only("mesh", "scene")
    meshes = tuple(_mesh(table, str(path)) for table in _once(root, "mesh"))
    taken = [scene.name for scene in described().scenes] if own else []
    scenes = tuple(
        _scene(table, [mesh.name for mesh in meshes]) for table in _once(root, "scene", taken)
    )
    return Described(meshes, scenes)


def _once(root: Table, key: str, taken: Iterable[str] = ()) -> list[Table]:
    """Return tables that have a good name each, and each another."""
    known = dict.fromkeys(taken, "a scene of the grader has this name")
    found = root.tables(key)
    for table in found:
        name = table.text("name")
        if not NAME.fullmatch(name):
            expected = "at most 40 of a to z, 0 to 9 and -, the first no -"
            raise table.fault("name", f'"{name}"', expected)
        if name in known:
            raise table.fault("name", f'"{name}" again', f"another one: {known[name]}")
        known[name] = f"each {key} has its own"
    return found


def _mesh(table: Table, path: str) -> StoredMesh:
    """Read one `[[mesh]]`."""
    table.only("name", "source", "generator", "sha256")
    if table.has("source") == table.has("generator"):
        there = "there beside generator" if table.has("source") else "missing"
        expected = "one of the two: source for a stored mesh, generator for a made one"
        raise table.fault("source", there, expected)
    sha256 = table.text("sha256")
    if not re.fullmatch(r"[0-9a-f]{64}", sha256):
        raise table.fault("sha256", f'"{sha256[:16]}"', "64 digits of 0 to 9 and a to f")
    name = table.text("name")
    return StoredMesh(
        name=name,
        source=table.text("source") if table.has("source") else "",
        recipe=_recipe(table.table("generator")) if table.has("generator") else None,
        sha256=sha256,
        place=f"{path}: [[mesh]] {name}",
    )


def _recipe(table: Table) -> Recipe:
    """Read the table `generator` of a mesh."""
    table.only("name", "faces", "seed")
    return Recipe(
        generator=table.choice("name", GENERATED),
        faces=table.whole("faces", 1, MOST_FACES),
        seed=table.whole("seed", 0, 2**32 - 1),
    )


def _scene(table: Table, meshes: list[str]) -> Scene:
    """Read one `[[scene]]`."""
    table.only(*SCENE_KEYS, "weight", "visibility")
    mesh = table.text("mesh")
    if mesh not in meshes:
        raise table.fault("mesh", f'"{mesh}"', f"a [[mesh]] of this file: {', '.join(meshes)}")
    weighed = table.has("weight")
    return Scene(
        name=table.text("name"),
        title=table.text("title"),
        mesh=mesh,
        camera=_camera(table.table("camera")),
        light=_direction(table, "light"),
        albedo=_three(table, "albedo", 0, 1),
        width=table.whole("width", SMALLEST_PICTURE, LARGEST_PICTURE),
        height=table.whole("height", SMALLEST_PICTURE, LARGEST_PICTURE),
        weight=table.number("weight", LEAST_WEIGHT, MOST_WEIGHT) if weighed else 1.0,
        visibility=table.choice("visibility", VISIBILITIES, absent="visible"),
    )


def _camera(table: Table) -> Camera:
    """Read the table `camera` of a scene."""
    table.only("origin", "target", "up", "fov")
    camera = Camera(
        origin=_three(table, "origin", -FARTHEST, FARTHEST),
        target=_three(table, "target", -FARTHEST, FARTHEST),
        up=_direction(table, "up"),
        fov=table.number("fov", 1, 170),
    )
    ahead = tuple(b - a for a, b in zip(camera.origin, camera.target, strict=True))
    if not any(ahead):
        raise table.fault("target", "the same as origin", "a place to look at")
    if _size(_cross(ahead, camera.up)) <= 1e-6 * _size(ahead) * _size(camera.up):
        raise table.fault("up", "along the line of sight", "a direction across it")
    return camera


def _three(table: Table, key: str, least: float, most: float) -> Three:
    """Read three numbers."""
    a, b, c = table.numbers(key, 3, least, most)
    return a, b, c


def _direction(table: Table, key: str) -> Three:
    """Read three numbers that are not all 0."""
    found = _three(table, key, -FARTHEST, FARTHEST)
    if not any(found):
        raise table.fault(key, "of no length", "a direction")
    return found


def _cross(a: tuple[float, ...], b: tuple[float, ...]) -> Three:
    """Return the cross product."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def _size(vector: tuple[float, ...]) -> float:
    """Return the largest coordinate."""
    return max(abs(one) for one in vector)
