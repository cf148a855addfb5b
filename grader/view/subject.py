"""What can be looked at: scenes, meshes from files, and the inputs that fail a check."""

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from grader.errors import UsageError
from grader.language import Words
from grader.model.mesh import Bvh, FrozenArrays, Mesh, Rays
from grader.model.trials import ConstructTrial, RebuildTrial, Trial
from grader.options import Options
from grader.plain import one_line
from grader.view.camera import Orbit, orbit_around, orbit_of

ALBEDO = (0.75, 0.72, 0.64)
SCALED = "the mesh was moved and scaled into the cube from -1 to 1"
"""Said of every mesh from a file: coordinates that are shown are not those of the file."""


@dataclass(frozen=True, slots=True, eq=False)
class Subject(FrozenArrays):
    """One thing that is looked at."""

    name: str
    title: str
    mesh: Mesh
    home: Orbit
    """Where the camera begins."""

    albedo: tuple[float, float, float] = ALBEDO
    tree: Bvh | None = None
    """A tree of ours that rays are traced on; None to have the submission make one."""

    before: tuple[Mesh, ...] = ()
    """Meshes for which the same tree is made first."""

    rays: Rays | None = None
    """Rays that a counterexample is about."""

    trial: Trial | None = None
    """What a counterexample asks; None if it is none."""

    check: str = ""
    """Id of the check that it fails; empty if it is none."""

    told: str = ""
    """What the check said of a counterexample when it was found; a stranger's words."""

    origin: str = ""
    """Where it was found, if nobody said where, or what was made of it; for people."""


def own_scenes(options: Options) -> Path | None:
    """Find a course's own folder of scenes, which a rubric names.

    Raises:
        UsageError: The rubric is wrong.
    """
    from grader.score.rubric import load_rubric

    return load_rubric(options.rubric).scenes


def scene_folders(own: Path | None) -> dict[str, Path | None]:
    """List the scenes by name, each with its folder; the shipped ones come first.

    Args:
        own: A course's own folder, beside the shipped one.

    Raises:
        UsageError: A `scenes.toml` is wrong.
    """
    from grader.oracle.scenes import scenes

    folders = [None] if own is None else [None, own]
    return {scene.name: folder for folder in folders for scene in scenes(folder)}


def scene_folder(name: str, own: Path | None) -> Path | None:
    """Find the folder of a scene; None is the shipped one.

    Raises:
        UsageError: There is no scene of this name.
    """
    known = scene_folders(own)
    if name not in known:
        raise UsageError(f"no scene is called {name}; there are {', '.join(known)}")
    return known[name]


def of_scene(name: str, own: Path | None = None) -> Subject:
    """Load a stored scene.

    Args:
        name: Of the scene.
        own: A course's own folder, beside the shipped one.

    Raises:
        UsageError: There is none of this name.
        OracleFault: Its mesh is missing or damaged.
    """
    from grader.oracle.scenes import load_mesh, scene_named

    folder = scene_folder(name, own)
    scene = scene_named(name, folder)
    mesh = load_mesh(scene.mesh, folder)
    home = orbit_of(scene.camera, extent(mesh))
    return Subject(name, scene.title, mesh, home, scene.albedo)


def of_trial(check: str, trial: Trial, told: str = "") -> Subject:
    """Show what a counterexample asks.

    Args:
        check: Id of the check that fails.
        trial: Its input.
        told: What the check said of it.
    """
    if isinstance(trial, RebuildTrial):
        asked = _asked(check, trial, trial.first, told)
        return replace(asked, before=(trial.first, trial.second))
    asked = _asked(check, trial, trial.mesh, told)
    if isinstance(trial, ConstructTrial):
        return asked
    return replace(asked, tree=trial.tree, rays=trial.rays)


def of_file(path: Path) -> Subject:
    """Open a mesh or a stored counterexample.

    Raises:
        UsageError: It is neither, or cannot be read.
        MissingTool: A package that reads meshes is not installed.
    """
    if path.suffix.lower() == ".json":
        from grader.counterexample.reading import read
        from grader.counterexample.revived import trial_of

        content = read(path)
        return of_trial(content.check, trial_of(content), content.message)
    from grader.oracle.imported import FORMATS, read_model

    if path.suffix.lower() not in {f".{each}" for each in FORMATS}:
        meshes = ", ".join(f".{each}" for each in FORMATS)
        raise UsageError(f"{path}: a mesh ({meshes}) or a counterexample (.json) was expected")
    mesh, remark = read_model(path)
    origin = "; ".join(filter(None, (SCALED, remark)))
    return Subject(path.stem, path.stem, mesh, around(mesh), origin=origin)


def told_of(subject: Subject, words: Words, messages: Words = str) -> str:
    """Say what the check said of a counterexample, which may have been of another build.

    Args:
        subject: What is looked at.
        words: Translates our own texts.
        messages: Translates those of checks.
    """
    if not subject.told:
        return ""
    text = words("{check}, when this was found: {message}")
    said = one_line(messages(subject.told))
    told = text.format(check=one_line(subject.check), message=said)
    if getattr(subject.trial, "sanitized", False):
        other = words("That was a build with sanitizers, which is not the one that runs here.")
        told = f"{told} ({other})"
    return told


def extent(mesh: Mesh) -> float:
    """Return the length of the diagonal of a mesh; 1 if it has none."""
    if not len(mesh.vertices):
        return 1.0
    with np.errstate(over="ignore", invalid="ignore"):
        size = float(np.linalg.norm(np.ptp(mesh.vertices.astype(np.float64), axis=0)))
    return size if np.isfinite(size) and size > 0 else 1.0


def around(mesh: Mesh) -> Orbit:
    """Look at a mesh from where all of it is seen."""
    points = mesh.vertices.astype(np.float64)
    if not len(points):
        points = np.zeros((1, 3))
    return orbit_around(points.min(axis=0), points.max(axis=0))


def cube(mesh: Mesh) -> tuple[np.ndarray, float]:
    """Return middle and scale by which a page moves a mesh into a cube of side 2.

    The middle is (3,) float64, in world space.
    """
    points = mesh.vertices.astype(np.float64)
    if not len(points):
        return np.zeros(3), 2.0
    low, high = points.min(axis=0), points.max(axis=0)
    return (low + high) / 2, 2 / (float((high - low).max()) or 1.0)


def _asked(check: str, trial: Trial, mesh: Mesh, told: str) -> Subject:
    return Subject(check, check, mesh, around(mesh), trial=trial, check=check, told=told)
