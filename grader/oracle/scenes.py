"""Which pictures does a submission have to reproduce, and where do they come from?

Scenes lie in folders: the shipped one, and perhaps a course's own, which a rubric names. Where
a function takes a folder, None is the shipped one.
"""

import hashlib
import shlex
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import numpy as np

from grader.errors import OracleFault, UsageError
from grader.model.mesh import Bvh, Mesh
from grader.model.scene import Reference, Scene
from grader.model.trials import ImageTrial
from grader.oracle.described import FILE, StoredMesh, described
from grader.oracle.exr import read_reference, scene_key
from grader.oracle.generated import GENERATED
from grader.oracle.pictures import require_agreement
from grader.oracle.procedural import nested_spheres, primitive_grid
from grader.oracle.remember import digest_of, remember
from grader.oracle.shipped import picture_answers
from grader.oracle.storage import load_mesh_file, mesh_sha256
from grader.resources import scenes_folder

GENERATORS: Mapping[str, Callable[[], Mesh]] = {
    "primitive_grid": lambda: primitive_grid(np.random.default_rng(10)),
    "nested_spheres": nested_spheres,
}
"""How the stored meshes came about that are not scanned."""


def scenes(folder: Path | None = None) -> tuple[Scene, ...]:
    """List the picture scenes in the order of `scenes.toml`.

    Raises:
        UsageError: A line of that file is wrong.
    """
    return described(folder).scenes


def stored_meshes(folder: Path | None = None) -> tuple[StoredMesh, ...]:
    """List the meshes in the order of `scenes.toml`.

    Raises:
        UsageError: A line of that file is wrong.
    """
    return described(folder).meshes


def scene_named(name: str, folder: Path | None = None) -> Scene:
    """Find a scene.

    Raises:
        UsageError: There is none of this name.
    """
    known = {scene.name: scene for scene in scenes(folder)}
    if name not in known:
        raise UsageError(f"no scene is called {name}; there are {', '.join(known)}")
    return known[name]


def load_mesh(name: str, folder: Path | None = None) -> Mesh:
    """Load or generate a mesh that `scenes.toml` describes.

    Raises:
        OracleFault: The file is missing or damaged, or it is another mesh.
    """
    stored = {mesh.name: mesh for mesh in stored_meshes(folder)}[name]
    recipe = stored.recipe
    if recipe is None:
        mesh, what = load_mesh_file(mesh_path(name, folder)), mesh_path(name, folder).name
    else:
        mesh = GENERATED[recipe.generator](recipe.faces, recipe.seed)
        what = f"generator {recipe.generator}"
    found = mesh_sha256(mesh)
    if found != stored.sha256:
        raise OracleFault(
            f"{stored.place}: sha256 is {stored.sha256[:12]}, but {what} gives another mesh; "
            f'undo the change, or write sha256 = "{found}" if it is meant'
        )
    return mesh


def load_reference(scene: Scene, mesh: Mesh, folder: Path | None = None) -> Reference:
    """Load the stored picture of a scene.

    Raises:
        OracleFault: It is missing, damaged or stale.
    """
    command = ["bvhgrade", "scenes", "render", scene.name]
    if folder is not None:
        command += ["--scenes", str(folder)]
    path = reference_path(scene.name, folder)
    return read_reference(path, scene, mesh, shlex.join(command))


def usable_reference(scene: Scene, mesh: Mesh, folder: Path | None = None) -> Reference:
    """Load the stored picture of a scene, or render it anew, into the cache.

    Raises:
        OracleFault: It is missing, damaged or stale, and Mitsuba is not at hand.
    """
    from grader.oracle.render import mitsuba_version, render
    from grader.oracle.variant import working_variant

    try:
        return load_reference(scene, mesh, folder)
    except OracleFault as fault:
        version = mitsuba_version()
        if version is None:
            message = f"{fault}, which needs Mitsuba: pip install 'bvhgrade[render]'"
            raise OracleFault(message) from fault
    key = digest_of("reference", scene_key(scene, mesh), version)
    return remember(key, lambda: render(scene, mesh, working_variant()))


def mesh_path(name: str, folder: Path | None = None) -> Path:
    """Where a mesh is stored."""
    return (folder or scenes_folder()) / f"{name}.npz"


def reference_path(name: str, folder: Path | None = None) -> Path:
    """Where the picture of a scene is stored."""
    return (folder or scenes_folder()) / "references" / f"{name}.exr"


def answers_path(name: str, folder: Path | None = None) -> Path:
    """Where the rule's answers of the picture of a scene are stored."""
    return (folder or scenes_folder()) / "references" / f"{name}.answers"


def scenes_sha256(own: Path | None = None) -> str:
    """Hash the descriptions, meshes and pictures that a grade depends on.

    The stored answers are left out: they follow from the rest.

    Args:
        own: A course's own folder, which then is covered, too.
    """
    shipped = folder_sha256()
    if own is None:
        return shipped
    return hashlib.sha256(f"{shipped} {folder_sha256(own)}".encode()).hexdigest()


def folder_sha256(folder: Path | None = None) -> str:
    """Hash one folder; a file that is missing counts as one, and whoever needs it will tell."""
    here = described(folder)
    names = [FILE]
    names += [f"{mesh.name}.npz" for mesh in here.meshes if mesh.recipe is None]
    names += [f"references/{scene.name}.exr" for scene in here.scenes]
    digest = hashlib.sha256()
    for name in names:
        path = (folder or scenes_folder()) / name
        content = path.read_bytes() if path.is_file() else b"missing"
        digest.update(hashlib.sha256(content).digest())
    return digest.hexdigest()


def image_trials(
    trees: Callable[[Sequence[Mesh]], list[Bvh]], folder: Path | None = None
) -> list[ImageTrial]:
    """Prepare the pictures that a submission has to reproduce.

    Args:
        trees: Builds the reference's tree of each mesh.
        folder: Where the scenes are.

    Raises:
        OracleFault: A mesh or picture is missing, damaged or stale, or contradicts the rule.
    """
    here = scenes(folder)
    meshes = {scene.mesh: load_mesh(scene.mesh, folder) for scene in here}
    built = dict(zip(meshes, trees(tuple(meshes.values())), strict=True))
    return [image_trial(scene, meshes[scene.mesh], built[scene.mesh], folder) for scene in here]


def image_trial(scene: Scene, mesh: Mesh, tree: Bvh, folder: Path | None = None) -> ImageTrial:
    """Prepare one picture, as `image_trials` does."""
    picture = usable_reference(scene, mesh, folder)
    found = picture_answers(answers_path(scene.name, folder), mesh, tree, picture)
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
        weight=scene.weight,
        shown=scene.visibility == "visible",
    )
