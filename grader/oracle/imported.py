"""How does a course's own model become a scene? Read, cleaned, seen well and rendered.

Theory of operation. Whatever a model's units are, it is moved and scaled into the cube from -1
to 1, in float64, before it is rounded to float32: far from the origin, or large, float32 would
tell fewer of its triangles apart. The line in `scenes.toml` is written last and in one step, so
that an import that fails leaves no scene behind.
"""

import re
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np

from grader.errors import GraderError, MissingTool, OutputFault, UsageError
from grader.model.mesh import Doubles, Integers, Mesh
from grader.model.scene import Scene
from grader.oracle.album import Progress, SceneStatus, render_scene, status_of
from grader.oracle.described import FILE, NAME, described
from grader.oracle.fitted import fitted_camera, fitted_light
from grader.oracle.generated import MOST_FACES
from grader.oracle.obj import read_obj
from grader.oracle.render import mitsuba_version
from grader.oracle.scenes import mesh_path
from grader.oracle.storage import mesh_sha256, save_mesh

FORMATS = ("obj", "ply", "stl", "gltf", "glb")
UPWARD = {"stl": "z"}
"""The axis that points up by custom, where it is not y."""

LARGEST_FILE = 1 << 30
SIZE = 256
ALBEDO = (0.75, 0.75, 0.72)

Part = tuple[Doubles, Integers]
"""(V, 3) float64 vertices in the model's space, and (F, 3) int64 faces, each in [0, V)."""


@dataclass(frozen=True, slots=True)
class Wish:
    """What is imported, and how."""

    model: Path
    folder: Path
    """Of the course's scenes; made if it is not there."""

    name: str | None
    """Of the scene; None takes the file's."""

    up: str | None
    """The axis that points up, `y` or `z`; None takes the usual one of the format."""


def import_scene(wish: Wish, progress: Progress) -> tuple[SceneStatus, str]:
    """Make a scene of a model and render its reference.

    Args:
        wish: What is imported, and how.
        progress: Is told what is done.

    Returns:
        The new scene, and what was left out of the model; empty if nothing was.

    Raises:
        UsageError: The model, its name or the folder will not do.
        MissingTool: Mitsuba is not installed.
        OutputFault: The scene cannot be written.
    """
    name = _free_name(wish)
    if mitsuba_version() is None:
        raise MissingTool(
            "a scene needs a reference by Mitsuba, which is not installed: "
            "pip install 'bvhgrade[render]'"
        )
    progress(f"reading {wish.model.name}")
    mesh, remark = read_model(wish.model)
    up = wish.up or UPWARD.get(_format(wish.model), "y")
    scene = Scene(
        name=name,
        title=name.replace("-", " "),
        mesh=name,
        camera=fitted_camera(mesh, up),
        light=fitted_light(up),
        albedo=ALBEDO,
        width=SIZE,
        height=SIZE,
    )
    try:
        wish.folder.mkdir(parents=True, exist_ok=True)
        save_mesh(mesh_path(name, wish.folder), mesh)
        render_scene(scene, mesh, progress, wish.folder)
        _append(wish.folder / FILE, _entry(scene, mesh, wish.model))
    except OSError as fault:
        message = f"{wish.folder}: the scene cannot be written ({fault.strerror})"
        raise OutputFault(f"{message}; name another folder with --into") from fault
    return status_of(scene, wish.folder), remark


def read_model(path: Path) -> tuple[Mesh, str]:
    """Read a model as one mesh in the cube from -1 to 1, and say what was left out.

    Raises:
        UsageError: It cannot be read, is empty or too large, or its vertices are no numbers.
    """
    vertices, faces = _joined(_loaded(path))
    if not len(faces):
        raise UsageError(f"{path}: holds no faces, but a scene needs triangles")
    if len(faces) > MOST_FACES:
        raise UsageError(
            f"{path}: holds {len(faces):,} faces, but at most {MOST_FACES:,} can be graded; "
            "simplify the model"
        )
    used, inverse = np.unique(faces, return_inverse=True)
    vertices, faces = vertices[used], inverse.reshape(-1, 3)
    wrong = np.count_nonzero(~np.isfinite(vertices).all(axis=1))
    if wrong:
        some = "1 vertex is no number" if wrong == 1 else f"{wrong:,} vertices are no numbers"
        raise UsageError(f"{path}: {some} (NaN or infinite); export it again")
    return _cleaned(path, _in_cube(path, vertices), faces)


def _loaded(path: Path) -> list[Part]:
    """Read the parts of a model, each with triangles of its own vertices."""
    if _format(path) not in FORMATS:
        raise UsageError(f"{path}: not a model; expected is one of {', '.join(FORMATS)}")
    try:
        if path.stat().st_size > LARGEST_FILE:
            raise UsageError(f"{path}: more than 1 GiB; simplify the model")
        return [read_obj(path)] if _format(path) == "obj" else _parts(path)
    except GraderError:
        raise
    except Exception as fault:  # trimesh raises whatever its readers stumble over
        reason = f"{type(fault).__name__}: {fault}"
        raise UsageError(f"{path}: cannot be read as {_format(path)} ({reason})") from fault


def _parts(path: Path) -> list[Part]:
    """Let trimesh read a file, flatten its scene graph and cut polygons into triangles."""
    import trimesh

    beside = trimesh.resolvers.FilePathResolver(path)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        loaded: Any = trimesh.load_scene(
            BytesIO(_in_utf8(path.read_bytes())), _format(path), beside, process=False
        )
        parts = [part for part in loaded.dump() if isinstance(part, trimesh.Trimesh)]
    return [_checked(path, part.vertices, part.faces) for part in parts]


def _in_utf8(content: bytes) -> bytes:
    """Replace bytes of a text that are not UTF-8: they stand in comments and names.

    trimesh would guess their encoding, with a package that is not installed. A PLY is a text up
    to `end_header`; what holds a zero byte, as binary STL and GLB do, is none.
    """
    text, mark, rest = content.partition(b"end_header")
    if b"\0" not in text:
        text = text.decode(errors="replace").encode()
    return text + mark + rest


def _checked(path: Path, vertices: object, faces: object) -> Part:
    """Return the arrays of a part, if each vertex has three coordinates that faces can use."""
    points, corners = np.asarray(vertices, np.float64), np.asarray(faces, np.int64)
    for what, array in (("vertices", points), ("faces", corners)):
        if array.ndim != 2 or array.shape[1] != 3:
            found = " x ".join(map(str, array.shape))
            raise UsageError(
                f"{path}: {what} hold {found} numbers, but three each are expected"
            )
    wrong = corners[(corners < 0) | (corners >= len(points))]
    if len(wrong):
        raise UsageError(
            f"{path}: a face uses vertex {wrong[0]}, but {len(points):,} are given, "
            "counted from 0; export it again"
        )
    return points, corners


def _joined(parts: Sequence[Part]) -> Part:
    """Put the parts of a model into one."""
    starts = np.cumsum([0, *(len(vertices) for vertices, _ in parts)])
    vertices = [np.zeros((0, 3)), *(vertices for vertices, _ in parts)]
    faces = [part + start for (_, part), start in zip(parts, starts, strict=False)]
    return np.concatenate(vertices), np.concatenate([np.zeros((0, 3), np.int64), *faces])


def _in_cube(path: Path, vertices: Doubles) -> Doubles:
    """Move and scale vertices into the cube from -1 to 1."""
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    with np.errstate(over="ignore"):
        half = float((high - low).max()) / 2
    if not 0 < half < np.inf:
        raise UsageError(f"{path}: all vertices are in one place, or endlessly far apart")
    return np.asarray((vertices - low / 2 - high / 2) / half)


def _cleaned(path: Path, vertices: Doubles, faces: Integers) -> tuple[Mesh, str]:
    """Round to float32, and leave out the faces that have no area."""
    points = vertices.astype(np.float32) + np.float32(0)  # -0.0 becomes 0.0
    corners = points[faces].astype(np.float64)
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    kept = normal.any(axis=1)
    if not kept.any():
        raise UsageError(f"{path}: no face has an area, so there is nothing to see")
    used, inverse = np.unique(faces[kept], return_inverse=True)
    remark = _left_out(int(np.count_nonzero(~kept)))
    return Mesh(points[used], inverse.reshape(-1, 3).astype(np.uint32)), remark


def _left_out(faces: int) -> str:
    """Say how many faces were left out; nothing if none was."""
    if faces == 1:
        return "1 face without any area was left out"
    return f"{faces:,} faces without any area were left out" if faces else ""


def _free_name(wish: Wish) -> str:
    """Return the name of the new scene, if no other has it."""
    stem = re.sub(r"[^a-z0-9]+", "-", wish.model.stem.lower()).strip("-")[:40]
    name = wish.name if wish.name is not None else stem
    if not NAME.fullmatch(name):
        raise UsageError(f'"{name}" is no name of a scene; --name takes a to z, 0 to 9 and -')
    known = [scene.name for scene in described().scenes]
    if (wish.folder / FILE).exists():
        here = described(wish.folder)
        known += [scene.name for scene in here.scenes]
        known += [mesh.name for mesh in here.meshes]
    if name in known:
        raise UsageError(f"there is a scene {name} already; choose another with --name")
    return name


def _format(path: Path) -> str:
    """Return the ending of a file's name."""
    return path.suffix.lower().lstrip(".")


def _entry(scene: Scene, mesh: Mesh, model: Path) -> str:
    """Word the two tables of a scene; nothing in them needs to be escaped."""
    source = re.sub(r"[^A-Za-z0-9._-]", "_", model.name)
    camera = scene.camera
    view = f"origin = {_listed(camera.origin)}, target = {_listed(camera.target)}"
    return f"""[[mesh]]
name = "{scene.mesh}"
source = "{source}"
sha256 = "{mesh_sha256(mesh)}"

[[scene]]
name = "{scene.name}"
title = "{scene.title}"
mesh = "{scene.mesh}"
width = {scene.width}
height = {scene.height}
camera = {{ {view}, up = {_listed(camera.up)}, fov = {camera.fov} }}
light = {_listed(scene.light)}
albedo = {_listed(scene.albedo)}
weight = {scene.weight}
visibility = "{scene.visibility}"
"""


def _listed(numbers: Sequence[float]) -> str:
    """Word numbers as TOML does."""
    return f"[{', '.join(repr(float(one)) for one in numbers)}]"


def _append(path: Path, entry: str) -> None:
    """Put an entry at the end of a file, which is replaced as a whole."""
    before = path.read_text(encoding="utf-8") if path.exists() else ""
    unfinished = path.with_name(f".{path.name}-unfinished")
    unfinished.write_text(f"{before.rstrip()}\n\n{entry}".lstrip(), encoding="utf-8")
    unfinished.replace(path)
