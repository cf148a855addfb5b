"""A coarsened mesh is small, looks the same, and remembers where its faces come from."""

import numpy as np
import pytest

from grader.gallery.coarse import coarsened
from grader.model.mesh import Mesh
from grader.oracle.scenes import load_mesh


@pytest.mark.parametrize("most", [200, 3_000])
def test_a_large_mesh_becomes_small_enough(most: int) -> None:
    """It has at most as many faces as asked for, and not many fewer."""
    small, _ = coarsened(load_mesh("dragon-res4"), most)
    assert most / 4 <= len(small.faces) <= most


def test_a_coarse_mesh_fills_the_same_box() -> None:
    """Vertices are pulled together by at most the size of a cell."""
    mesh = load_mesh("dragon-res4")
    small, _ = coarsened(mesh, 3_000)
    size = np.ptp(mesh.vertices, axis=0).max()
    for end in (np.min, np.max):
        assert (
            np.abs(end(mesh.vertices, axis=0) - end(small.vertices, axis=0)).max() < size / 20
        )


def test_each_coarse_face_lies_near_the_face_that_it_was() -> None:
    """`kept` names, for each face of the result, one of the faces before."""
    mesh = load_mesh("dragon-res4")
    small, kept = coarsened(mesh, 3_000)
    assert len(kept) == len(small.faces)
    middle = mesh.vertices[mesh.faces[kept]].mean(axis=1)
    away = np.abs(small.vertices[small.faces].mean(axis=1) - middle).max(axis=1)
    assert away.max() < np.ptp(mesh.vertices, axis=0).max() / 10


def test_no_face_is_left_that_is_no_triangle() -> None:
    """Faces whose corners were pulled together are gone, and no face is there twice."""
    small, _ = coarsened(load_mesh("dragon-res4"), 500)
    ordered = np.sort(small.faces, axis=1)
    assert (np.diff(ordered.astype(np.int64), axis=1) > 0).all()
    assert len(np.unique(ordered, axis=0)) == len(ordered)


def test_a_small_mesh_stays_as_it_is() -> None:
    """Nothing is lost where nothing has to be."""
    mesh = load_mesh("grid")
    same, kept = coarsened(mesh, len(mesh.faces))
    assert same is mesh
    assert (kept == np.arange(len(mesh.faces))).all()


def test_neighbours_in_the_list_are_neighbours_in_space() -> None:
    """Else a report would be larger: the steps between faces are short."""
    small, _ = coarsened(load_mesh("dragon-res4"), 3_000)
    middle = small.vertices[small.faces].mean(axis=1)
    steps = np.linalg.norm(np.diff(middle, axis=0), axis=1)
    assert np.median(steps) < np.ptp(small.vertices, axis=0).max() / 20


@pytest.mark.parametrize("far", [False, True])
def test_of_loose_faces_smaller_than_a_cell_some_are_left(far: bool) -> None:
    """No grid keeps them, or only the one that is far away."""
    rng = np.random.default_rng(5)
    middle = rng.uniform(-1, 1, (5_000, 1, 3))
    corners = middle + rng.uniform(-1e-6, 1e-6, (5_000, 3, 3))
    if far:
        corners[0] = [[1e3, 0, 0], [2e3, 0, 0], [1e3, 1e3, 0]]
    faces = np.arange(15_000, dtype=np.uint32).reshape(-1, 3)
    mesh = Mesh(corners.reshape(-1, 3).astype(np.float32), faces)
    small, kept = coarsened(mesh, 400)
    assert 200 <= len(small.faces) == len(kept) <= 400
    assert (small.vertices[small.faces[:, 0]] == mesh.vertices[mesh.faces[kept, 0]]).all()
