"""What a faultless submission sees of a stored scene, without any submission."""

import numpy as np

from grader.gallery.hung import Hung, hung
from grader.model.cases import ImageCase
from grader.model.mesh import Floats, Hits, Indices
from grader.model.scene import Reference, Scene
from grader.oracle.scenes import image_trial, load_mesh, load_reference, scene_named
from tests.verify.builder import build


def scene_and_reference(name: str) -> tuple[Scene, Reference]:
    """Load a scene and Mitsuba's picture of it."""
    scene = scene_named(name)
    return scene, load_reference(scene, load_mesh(scene.mesh))


def place_of(name: str) -> Hung:
    """Say where a shipped scene is."""
    return next(one for one in hung(None) if one.scene.name == name)


def case_of(name: str) -> ImageCase:
    """See what Mitsuba sees, with one box test and two triangle tests for each pixel."""
    scene, picture = scene_and_reference(name)
    mesh = load_mesh(scene.mesh)
    trial = image_trial(scene, mesh, build(mesh))
    hits = Hits(picture.point, picture.t, picture.normal)
    return ImageCase(name, trial, hits, ones_and_twos(picture.t))


def ones_and_twos(t: Floats) -> Indices:
    """Count one test of a box and two of triangles for each ray."""
    return np.tile(np.array([1, 2], np.uint32), (t.size, 1))
