"""Which pictures does a submission have to reproduce, and where do they come from?"""

import hashlib
import tomllib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from grader.errors import OracleFault, UsageError
from grader.model.mesh import Bvh, Mesh
from grader.model.scene import Camera, Reference, Scene
from grader.model.trials import ImageTrial
from grader.oracle.balanced import balanced_tree
from grader.oracle.exr import read_reference, write_reference
from grader.oracle.pictures import require_agreement
from grader.oracle.procedural import nested_spheres, primitive_grid
from grader.oracle.shipped import computed_answers, picture_answers, write_answers
from grader.oracle.storage import load_mesh_file, mesh_sha256
from grader.resources import scenes_folder

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


def answers_path(name: str) -> Path:
    """Where the rule's answers of the picture of a scene are stored."""
    return scenes_folder() / "references" / f"{name}.answers"


def scenes_sha256() -> str:
    """Hash the descriptions, meshes and pictures that a grade depends on.

    The stored answers are left out: they follow from the rest.
    """
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
    """Render references anew, and store them with the rule's answers.

    Args:
        names: Scenes to render; all if empty.
        progress: Gets a line before each slow step.

    Raises:
        UsageError: A name is no scene's.
        MissingTool: Mitsuba is not installed.
        OutputFault: A picture or its answers cannot be written.
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
    store_answers(tuple(scene.name for scene in chosen), progress)
    return tuple(_status(scene) for scene in chosen)


def store_answers(names: tuple[str, ...], progress: Callable[[str], None]) -> None:
    """Apply the rule to stored references, and store its answers beside them.

    Args:
        names: Scenes whose answers are stored; all if empty.
        progress: Gets a line before each slow step.

    Raises:
        UsageError: A name is no scene's.
        OracleFault: A mesh or picture is missing, damaged or stale.
        OutputFault: The answers cannot be written.
    """
    for scene in tuple(scene_named(name) for name in names) or scenes():
        progress(f"answering {scene.name}, {scene.width} x {scene.height}")
        mesh = load_mesh(scene.mesh)
        picture = load_reference(scene, mesh)
        found = computed_answers(mesh, balanced_tree(mesh), picture)
        write_answers(answers_path(scene.name), picture, found)


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
    found = picture_answers(answers_path(scene.name), mesh, tree, picture)
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
