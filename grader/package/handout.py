"""What do students get? The exercise, what it is worth, and meshes and pictures to try it on.

Nothing of the reference is in it, nothing of the tests, and of scenes and checks only what
students are to see.
"""

import io
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from grader.errors import UsageError
from grader.gallery.shading import displayed
from grader.model.grade import Criterion, Rubric
from grader.model.mesh import Mesh
from grader.model.scene import Reference, Scene
from grader.oracle.scenes import load_mesh, scenes, usable_reference
from grader.package.archive import Member, below
from grader.package.exercise import exercise
from grader.package.kit import Choices
from grader.score.rubric import load_rubric
from grader.verify import every_check

FOLDER = "exercise03"
VISIBLE = "visible"

SOURCE_OF_THE_DRAGON = """\
The dragon was scanned and reconstructed at the Stanford Computer Graphics Laboratory and is
published in the Stanford 3D Scanning Repository, which asks to be named as the source, allows
free use in teaching and research but no commercial use without permission, and asks to keep
the dragon out of tasteless use.
"""


def members(choices: Choices) -> tuple[Member, ...]:
    """Collect the archive's files.

    Raises:
        UsageError: The rubric or its scenes are wrong, choices only fit a grader, or a file of
            the exercise is not the one to be handed out.
        OracleFault: A mesh or its picture is missing or damaged.
    """
    if choices.seed is not None or choices.wheels is not None:
        raise UsageError("a handout holds no grader, so --seed and --wheels say nothing there")
    rubric = load_rubric(choices.rubric)
    shown = [
        (scene, folder)
        for folder in dict.fromkeys([None, rubric.scenes])
        for scene in scenes(folder)
        if scene.visibility == VISIBLE
    ]
    told = (
        Member("POINTS.md", points(rubric).encode()),
        Member("models/README.md", models(shown).encode()),
    )
    return below(FOLDER, (*exercise(), *told, *_models(shown)))


def points(rubric: Rubric) -> str:
    """Write what is worth how much; checks that students are not to see are one line."""
    titles = {check.id: check.title for check in every_check()}
    lines = ["# What is worth how much", ""]
    for part, title in rubric.titles:
        mine = [one for one in rubric.criteria if one.part == part]
        lines += [f"## {part}) {title}: {_total(mine)} points", "", "| points | what holds |"]
        lines += ["| ---: | --- |"]
        seen = [one for one in mine if one.visibility == VISIBLE]
        lines += [f"| {_worth(one)} | {titles[one.check]} (`{one.check}`) |" for one in seen]
        if rest := [one for one in mine if one.visibility != VISIBLE]:
            lines += [f"| {_total(rest)} | what is not shown before the due date, or at all |"]
        lines += [""]
    if any(one.gate and one.visibility == VISIBLE for one in rubric.criteria):
        lines += ["If a gate passes nowhere, its part earns nothing.", ""]
    return "\n".join(lines)


def models(shown: list[tuple[Scene, Path | None]]) -> str:
    """Write which models there are, and where they come from."""
    lines = [
        "# Models to try your code on",
        "",
        "Each `.obj` has a picture beside it, rendered by Mitsuba 3 with a camera and a light",
        "of its own; `preview` chooses its own camera, so compare shapes, not pixels.",
        "",
        *[f"- `{scene.name}.obj`: {scene.title}" for scene, _ in shown],
    ]
    if any(folder is None and scene.name.startswith("dragon") for scene, folder in shown):
        lines += ["", SOURCE_OF_THE_DRAGON.rstrip()]
    return "\n".join([*lines, ""])


def _models(shown: list[tuple[Scene, Path | None]]) -> Iterator[Member]:
    for scene, folder in shown:
        mesh = load_mesh(scene.mesh, folder)
        picture = as_png(scene, usable_reference(scene, mesh, folder))
        yield Member(f"models/{scene.name}.obj", as_obj(mesh))
        yield Member(f"models/{scene.name}.png", picture)


def as_obj(mesh: Mesh) -> bytes:
    """Write a mesh as OBJ; nine digits give each float32 back as it was."""
    corners, faces = mesh.vertices.ravel().tolist(), (mesh.faces.ravel() + 1).tolist()
    # One format for all lines: `numpy.savetxt`, line by line, takes four times as long.
    text = "v %.9g %.9g %.9g\n" * len(mesh.vertices) + "f %d %d %d\n" * len(mesh.faces)
    return (text % (*corners, *faces)).encode()


def as_png(scene: Scene, reference: Reference) -> bytes:
    """Write Mitsuba's picture of a scene."""
    from PIL import Image

    pixels = displayed(reference.shaded, np.isfinite(reference.t))
    image = Image.fromarray(pixels.reshape(scene.height, scene.width, 3))
    written = io.BytesIO()
    image.save(written, "png", optimize=True)
    return written.getvalue()


def _worth(criterion: Criterion) -> str:
    """Write what a check is worth as docs/student.md does: `3`, `gate`, `2, gate`."""
    gate = ["gate"] if criterion.gate else []
    return ", ".join([*([f"{criterion.points:g}"] if criterion.points else []), *gate]) or "0"


def _total(criteria: list[Criterion]) -> str:
    return f"{sum(one.points for one in criteria):g}"
