"""Generated meshes have the size that was asked for, and scenes of them are decided."""

import numpy as np
import pytest

from grader.model.mesh import SOLID
from grader.oracle.generated import GENERATED, landscape
from grader.oracle.noise import drawn, hills
from grader.oracle.scenes import answers_path, load_mesh, load_reference, scene_named
from grader.oracle.shipped import read_answers
from grader.oracle.storage import mesh_sha256

LEAST_DECIDED = 0.97
"""Share of the pixels that see something and have one right answer."""


@pytest.mark.parametrize("faces", [1, 2, 3, 37, 1729, 1735, 20_001])
@pytest.mark.parametrize("name", list(GENERATED))
def test_there_are_as_many_faces_as_asked_for(name: str, faces: int) -> None:
    """Exactly so many, with an area each, over vertices that exist and are finite."""
    mesh = GENERATED[name](faces, 7)
    assert mesh.faces.shape == (faces, 3)
    assert mesh.faces.max() < len(mesh.vertices)
    corners = mesh.vertices[mesh.faces].astype(np.float64)
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert np.linalg.norm(normal, axis=1).min() > 0
    assert np.abs(mesh.vertices).max() < 2


@pytest.mark.parametrize("name", list(GENERATED))
def test_a_seed_is_a_mesh(name: str) -> None:
    """Made again it is the same to the last bit; another seed's is another."""
    one, again, other = (mesh_sha256(GENERATED[name](3000, seed)) for seed in (1, 1, 2))
    assert one == again != other


def test_a_landscape_has_no_gaps() -> None:
    """Each inner edge belongs to two faces, and the border is the square's."""
    mesh = landscape(2 * 30 * 30, 3)
    edges = np.sort(mesh.faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    _, counts = np.unique(edges, axis=0, return_counts=True)
    assert np.count_nonzero(counts == 1) == 4 * 30
    assert counts.max() == 2
    assert (mesh.vertices[:, 2] > 0.1).any()
    border = np.abs(mesh.vertices[:, :2]).max(axis=1) == 1
    assert (mesh.vertices[border, 2] == 0).all()


@pytest.mark.parametrize("name", ["soup", "thin", "landscape", "dragon-res2", "dragon-res4"])
def test_most_pixels_are_decided(name: str) -> None:
    """The rule of closest hits allows one answer only, also where triangles are thin."""
    scene = scene_named(name)
    picture = load_reference(scene, load_mesh(scene.mesh))
    found = read_answers(answers_path(name), picture)
    assert found is not None
    clear = np.ones(picture.t.size, dtype=np.bool_)
    clear[np.repeat(np.arange(picture.t.size), np.diff(found.first))[found.kind != SOLID]] = 0
    assert clear[np.isfinite(picture.t)].mean() > LEAST_DECIDED


def test_noise_is_what_it_is_said_to_be() -> None:
    """Numbers from 0 to 1 that streams do not share; hills without a step, 0 on the lattice."""
    numbers = drawn(1, 0, 100_000)
    assert 0 <= numbers.min() < 1e-3
    assert 0.999 < numbers.max() < 1
    assert abs(numbers.mean() - 0.5) < 0.01
    assert abs(np.corrcoef(numbers, drawn(1, 1, 100_000))[0, 1]) < 0.02
    x = np.linspace(-3, 3, 6001)
    heights = hills(1, 0, x, np.full_like(x, 0.3))
    assert np.abs(np.diff(heights)).max() < 0.01
    assert np.abs(heights).max() > 0.1
    assert (hills(1, 0, np.arange(-3.0, 4), np.zeros(7)) == 0).all()
