"""What a faultless submission sees of a stored scene, without any submission."""

import numpy as np

from grader.model.cases import ImageCase
from grader.model.mesh import Bvh, Floats, Hits
from grader.model.scene import Reference, Scene
from grader.model.trials import ImageTrial
from grader.oracle.scenes import answers_path, load_mesh, load_reference, scene_named
from grader.oracle.shipped import picture_answers
from tests.verify.builder import build


def scene_and_reference(name: str) -> tuple[Scene, Reference]:
    """Load a scene and Mitsuba's picture of it."""
    scene = scene_named(name)
    return scene, load_reference(scene, load_mesh(scene.mesh))


def case_of(name: str, tree: Bvh | None = None) -> ImageCase:
    """See what Mitsuba sees, with one box test and two triangle tests for each pixel."""
    scene, picture = scene_and_reference(name)
    mesh = load_mesh(scene.mesh)
    tree = tree or build(mesh)
    trial = ImageTrial(
        name=scene.name,
        mesh=mesh,
        tree=tree,
        width=scene.width,
        height=scene.height,
        rays=picture.rays,
        answers=picture_answers(answers_path(scene.name), mesh, tree, picture),
        mitsuba_t=picture.t,
    )
    hits = Hits(picture.point, picture.t, picture.normal)
    return ImageCase(name, trial, hits, ones_and_twos(picture.t))


def ones_and_twos(t: Floats) -> "np.ndarray[tuple[int, ...], np.dtype[np.uint32]]":
    """Count one test of a box and two of triangles for each ray."""
    return np.tile(np.array([1, 2], np.uint32), (t.size, 1))
