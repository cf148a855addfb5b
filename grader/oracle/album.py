"""How are references listed, rendered and stored? What `bvhgrade scenes` does."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from grader.errors import OracleFault
from grader.model.mesh import Mesh
from grader.model.scene import Scene
from grader.oracle.balanced import balanced_tree
from grader.oracle.exr import write_reference
from grader.oracle.scenes import (
    answers_path,
    load_mesh,
    load_reference,
    reference_path,
    scene_named,
    scenes,
)
from grader.oracle.shipped import computed_answers, write_answers

Progress = Callable[[str], None]
"""Gets a line before each slow step."""


@dataclass(frozen=True, slots=True)
class SceneStatus:
    """One line of `bvhgrade scenes list`."""

    scene: Scene
    faces: int
    """0 if the mesh cannot be used."""

    reference_mib: float
    """Size of the reference's file; 0 if there is none."""

    problem: str
    """Why the mesh or the reference cannot be used; empty if both can."""

    made_with: tuple[tuple[str, str], ...]


def list_scenes(folder: Path | None = None) -> tuple[SceneStatus, ...]:
    """Say of each scene how big it is and whether its reference can be used.

    Raises:
        UsageError: A line of the folder's `scenes.toml` is wrong.
    """
    return tuple(status_of(scene, folder) for scene in scenes(folder))


def render_scenes(
    names: tuple[str, ...], progress: Progress, folder: Path | None = None
) -> tuple[SceneStatus, ...]:
    """Render references anew, and store them with the rule's answers.

    Args:
        names: Scenes to render; all if empty.
        progress: Is told what is done.
        folder: Where the scenes are; None for the shipped ones.

    Raises:
        UsageError: A name is no scene's.
        OracleFault: A mesh is missing or damaged.
        MissingTool: Mitsuba is not installed.
        OutputFault: A picture or its answers cannot be written.
    """
    chosen = tuple(scene_named(name, folder) for name in names) or scenes(folder)
    for scene in chosen:
        render_scene(scene, load_mesh(scene.mesh, folder), progress, folder)
    return tuple(status_of(scene, folder) for scene in chosen)


def render_scene(
    scene: Scene, mesh: Mesh, progress: Progress, folder: Path | None = None
) -> None:
    """Render one reference, and store it with the rule's answers, as `render_scenes` does."""
    from grader.oracle.render import render
    from grader.oracle.variant import working_variant

    progress("looking for the fastest variant of Mitsuba")
    variant = working_variant()
    progress(f"rendering {scene.name}, {scene.width} x {scene.height}, by {variant.name}")
    picture = render(scene, mesh, variant)
    write_reference(reference_path(scene.name, folder), scene, picture)
    _store(scene, mesh, progress, folder)


def store_answers(
    names: tuple[str, ...], progress: Progress, folder: Path | None = None
) -> None:
    """Apply the rule to stored references, and store its answers beside them.

    Args:
        names: Scenes whose answers are stored; all if empty.
        progress: Is told what is done.
        folder: Where the scenes are; None for the shipped ones.

    Raises:
        UsageError: A name is no scene's.
        OracleFault: A mesh or picture is missing, damaged or stale.
        OutputFault: The answers cannot be written.
    """
    for scene in tuple(scene_named(name, folder) for name in names) or scenes(folder):
        _store(scene, load_mesh(scene.mesh, folder), progress, folder)


def _store(scene: Scene, mesh: Mesh, progress: Progress, folder: Path | None) -> None:
    """Store the answers of one reference."""
    progress(f"answering {scene.name}, {scene.width} x {scene.height}")
    picture = load_reference(scene, mesh, folder)
    found = computed_answers(mesh, balanced_tree(mesh), picture)
    write_answers(answers_path(scene.name, folder), picture, found)


def status_of(scene: Scene, folder: Path | None) -> SceneStatus:
    """Try to use a scene's mesh and reference."""
    path = reference_path(scene.name, folder)
    made_with: tuple[tuple[str, str], ...] = ()
    problem, faces = "", 0
    try:
        mesh = load_mesh(scene.mesh, folder)
        faces = len(mesh.faces)
        made_with = load_reference(scene, mesh, folder).made_with
    except OracleFault as fault:
        problem = str(fault)
    return SceneStatus(
        scene=scene,
        faces=faces,
        reference_mib=path.stat().st_size / 2**20 if path.is_file() else 0.0,
        problem=problem,
        made_with=made_with,
    )
