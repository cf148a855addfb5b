"""Which pictures does a submission have to reproduce, and where do they come from?"""

import hashlib
import tomllib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from grader.errors import OracleFault, UsageError
from grader.model.mesh import Answers, Bvh, Mesh
from grader.model.scene import Camera, Reference, Scene
from grader.model.trials import ImageTrial
from grader.oracle.brute import answers
from grader.oracle.exr import read_reference, write_reference
from grader.oracle.pictures import require_agreement
from grader.oracle.procedural import nested_spheres, primitive_grid
from grader.oracle.remember import digest_of, remember
from grader.oracle.storage import load_mesh_file, mesh_sha256
from grader.resources import scenes_folder

SEARCH_MARGIN = 1e-3
"""How far behind Mitsuba's hit the first search goes, relative to t; decides only its speed."""

GENERATORS: Mapping[str, Callable[[], Mesh]] = {
    "primitive_grid": lambda: primitive_grid(np.random.default_rng(10)),
    "nested_spheres": nested_spheres,
}
"""How the meshes came about that are not scanned."""


@dataclass(frozen=True, slots=True)
class StoredMesh:
    """One mesh in the repository."""

    name: str
    source: str
    """Name of a generator or of the file that was converted."""

    sha256: str
    """Of its vertices and faces as bytes."""


@dataclass(frozen=True, slots=True)
class SceneStatus:
    """One line of `bvhgrade scenes list`."""

    scene: Scene
    faces: int
    reference_mib: float
    """Size of the reference's file; 0 if there is none."""

    problem: str
    """Why the reference cannot be used; empty if it can."""

    made_with: tuple[tuple[str, str], ...]


def scenes() -> tuple[Scene, ...]:
    """List the picture scenes in the order of `scenes.toml`."""
    return tuple(_scene(table) for table in _described()["scene"])


def stored_meshes() -> tuple[StoredMesh, ...]:
    """List the meshes in the order of `scenes.toml`."""
    return tuple(StoredMesh(**table) for table in _described()["mesh"])


def scene_named(name: str) -> Scene:
    """Find a scene.

    Raises:
        UsageError: There is none of this name.
    """
    known = {scene.name: scene for scene in scenes()}
    if name not in known:
        raise UsageError(f"no scene is called {name}; there are {', '.join(known)}")
    return known[name]


def load_mesh(name: str) -> Mesh:
    """Load a stored mesh.

    Raises:
        OracleFault: The file is missing, damaged or holds another mesh.
    """
    stored = {mesh.name: mesh for mesh in stored_meshes()}[name]
    mesh = load_mesh_file(mesh_path(name))
    found = mesh_sha256(mesh)
    if found != stored.sha256:
        raise OracleFault(
            f"mesh {name}: its bytes hash to {found[:12]}, but scenes.toml says "
            f"{stored.sha256[:12]}; restore the file"
        )
    return mesh


def load_reference(scene: Scene, mesh: Mesh) -> Reference:
    """Load the stored picture of a scene.

    Raises:
        OracleFault: It is missing, damaged or stale.
    """
    return read_reference(reference_path(scene.name), scene, mesh)


def mesh_path(name: str) -> Path:
    """Where a mesh is stored."""
    return scenes_folder() / f"{name}.npz"


def reference_path(name: str) -> Path:
    """Where the picture of a scene is stored."""
    return scenes_folder() / "references" / f"{name}.exr"


def scenes_sha256() -> str:
    """Hash the descriptions, meshes and pictures that a grade depends on."""
    digest = hashlib.sha256()
    names = ["scenes.toml"]
    names += [f"{mesh.name}.npz" for mesh in stored_meshes()]
    names += [f"references/{scene.name}.exr" for scene in scenes()]
    for name in names:
        digest.update(hashlib.sha256((scenes_folder() / name).read_bytes()).digest())
    return digest.hexdigest()


def image_trials(trees: Callable[[Sequence[Mesh]], list[Bvh]]) -> list[ImageTrial]:
    """Prepare the pictures that a submission has to reproduce.

    Args:
        trees: Builds the reference's tree of each mesh.

    Raises:
        OracleFault: A mesh or picture is missing, damaged or stale, or contradicts the rule.
    """
    described = scenes()
    meshes = {scene.mesh: load_mesh(scene.mesh) for scene in described}
    built = dict(zip(meshes, trees(tuple(meshes.values())), strict=True))
    return [_trial(scene, meshes[scene.mesh], built[scene.mesh]) for scene in described]


def list_scenes() -> tuple[SceneStatus, ...]:
    """Say of each scene how big it is and whether its reference can be used."""
    return tuple(_status(scene) for scene in scenes())


def render_scenes(
    names: tuple[str, ...], progress: Callable[[str], None]
) -> tuple[SceneStatus, ...]:
    """Render references anew and store them.

    Args:
        names: Scenes to render; all if empty.
        progress: Gets a line before each slow step.

    Raises:
        UsageError: A name is no scene's.
        MissingTool: Mitsuba is not installed.
        OutputFault: A picture cannot be written.
    """
    from grader.oracle.render import render
    from grader.oracle.variant import working_variant

    chosen = tuple(scene_named(name) for name in names) or scenes()
    progress("looking for the fastest variant of Mitsuba")
    variant = working_variant()
    for scene in chosen:
        progress(f"rendering {scene.name}, {scene.width} x {scene.height}, by {variant.name}")
        picture = render(scene, load_mesh(scene.mesh), variant)
        write_reference(reference_path(scene.name), scene, picture)
    return tuple(_status(scene) for scene in chosen)


@cache
def _described() -> Mapping[str, Any]:
    """Read `scenes.toml`."""
    with (scenes_folder() / "scenes.toml").open("rb") as file:
        return tomllib.load(file)


def _scene(table: Mapping[str, Any]) -> Scene:
    """Turn one table of `scenes.toml` into a scene."""
    camera = table["camera"]
    return Scene(
        name=table["name"],
        title=table["title"],
        mesh=table["mesh"],
        camera=Camera(
            origin=tuple(camera["origin"]),
            target=tuple(camera["target"]),
            up=tuple(camera["up"]),
            fov=camera["fov"],
        ),
        light=tuple(table["light"]),
        albedo=tuple(table["albedo"]),
        width=table["width"],
        height=table["height"],
    )


def _trial(scene: Scene, mesh: Mesh, tree: Bvh) -> ImageTrial:
    """Prepare one picture."""
    picture = load_reference(scene, mesh)
    found = _answers(mesh, tree, picture)
    require_agreement(scene.name, found, picture.t)
    return ImageTrial(
        name=scene.name,
        mesh=mesh,
        tree=tree,
        width=scene.width,
        height=scene.height,
        rays=picture.rays,
        answers=found,
        mitsuba_t=picture.t,
    )


def _answers(mesh: Mesh, tree: Bvh, picture: Reference) -> Answers:
    """Apply the rule to each pixel, or remember what came out last time."""
    behind = picture.t.astype(np.float64) * (1 + SEARCH_MARGIN)
    rays = picture.rays
    # The key of a picture covers its mesh; the answers do not depend on the tree.
    key = digest_of("picture", picture.key, rays.origin, rays.direction, rays.t_min, rays.t_max)
    return Answers(**remember(key, lambda: _arrays(answers(mesh, rays, tree, behind))))


def _arrays(found: Answers) -> dict[str, np.ndarray[Any, Any]]:
    """Return the fields of a record by name."""
    return {field.name: getattr(found, field.name) for field in fields(found)}


def _status(scene: Scene) -> SceneStatus:
    """Try to use a scene's reference."""
    path = reference_path(scene.name)
    mesh = load_mesh(scene.mesh)
    made_with: tuple[tuple[str, str], ...] = ()
    problem = ""
    try:
        made_with = load_reference(scene, mesh).made_with
    except OracleFault as fault:
        problem = str(fault)
    return SceneStatus(
        scene=scene,
        faces=len(mesh.faces),
        reference_mib=path.stat().st_size / 2**20 if path.is_file() else 0.0,
        problem=problem,
        made_with=made_with,
    )
