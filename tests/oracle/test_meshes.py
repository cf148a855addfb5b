"""Every mesh keeps what the tests of submissions rely on."""

import numpy as np
import pytest

from grader.model.mesh import Mesh
from grader.oracle.meshes import SHAPES, TRACED, depth_mesh, mesh_named
from grader.oracle.shapes import flatness
from grader.tolerances import FACES_PER_LEAF, MAX_DEPTH, NEEDLE

DRAWN = (*SHAPES, "grid-10x10", "nested-spheres", "dragon-res4")


def corners_of(mesh: Mesh) -> np.ndarray:
    """Return (F, 3, 3) float64 corners."""
    return mesh.vertices[mesh.faces].astype(np.float64)


@pytest.mark.parametrize("name", DRAWN)
def test_a_mesh_is_sound(name: str) -> None:
    """Finite float32, indices in range, other counts of vertices than of faces."""
    mesh = mesh_named(11, name)
    assert mesh.vertices.dtype == np.float32
    assert mesh.faces.dtype == np.uint32
    assert np.isfinite(mesh.vertices).all()
    assert mesh.faces.max(initial=0) < max(1, len(mesh.vertices))
    assert len(mesh.vertices) != len(mesh.faces) or len(mesh.faces) == 0


@pytest.mark.parametrize("name", [*DRAWN[1:], "dragon-res2"])
def test_the_box_of_all_vertices_is_the_box_of_all_faces(name: str) -> None:
    """No stray vertex makes the root's box larger than its triangles."""
    mesh = mesh_named(12, name)
    used = mesh.vertices[mesh.faces.ravel()]
    assert (used.min(axis=0) == mesh.vertices.min(axis=0)).all()
    assert (used.max(axis=0) == mesh.vertices.max(axis=0)).all()


@pytest.mark.parametrize("name", DRAWN)
def test_a_mesh_belongs_to_its_seed(name: str) -> None:
    """The same seed draws the same bytes, another seed at least another order of faces."""
    one, same, other = (mesh_named(seed, name) for seed in (1, 1, 2))
    assert one.vertices.tobytes() == same.vertices.tobytes()
    assert one.faces.tobytes() == same.faces.tobytes()
    if len(one.faces) > 12 and not name.startswith("identical"):
        assert one.faces.tobytes() != other.faces.tobytes()


@pytest.mark.parametrize("name", TRACED)
def test_rays_meet_no_needles(name: str) -> None:
    """Hits are judged on triangles that float32 can decide, or on none at all."""
    ratio = flatness(corners_of(mesh_named(13, name)))
    assert (~np.isfinite(ratio) | (ratio < NEEDLE)).all()


@pytest.mark.parametrize(
    ("name", "faces"),
    [*((f"cloud-{n}", n) for n in (0, 1, 4, 5, 64)), ("terrain-600", 600), ("ball-1280", 1280)],
)
def test_the_number_of_faces_is_in_the_name(name: str, faces: int) -> None:
    """Numbers around which limits and halves go wrong are exact."""
    assert len(mesh_named(14, name).faces) == faces


def test_shapes_are_what_they_are_called() -> None:
    """Flat, identical, degenerate, far away, and beyond 16 bits."""
    flat = mesh_named(1, "plane-yz").vertices
    assert np.ptp(flat, axis=0)[0] == 0
    assert len(np.unique(mesh_named(1, "identical-64").faces, axis=0)) == 1
    area = flatness(corners_of(mesh_named(1, "soup-degenerate")))
    assert np.count_nonzero(~np.isfinite(area)) == 50
    assert not np.isfinite(flatness(corners_of(mesh_named(1, "zero-area")))).any()
    assert mesh_named(1, "octant-negative").vertices.max() < 0
    assert len(mesh_named(1, "cloud-65539").faces) > 2**16
    assert np.ptp(mesh_named(1, "scaled-small").vertices) < 1e-2
    assert np.ptp(mesh_named(1, "scaled-tiny").vertices) < 1e-11
    assert np.abs(mesh_named(1, "scaled-huge").vertices).min() > 1e12
    one = mesh_named(1, "one-point")
    assert (len(one.faces), len(one.vertices)) == (9, 1)


def test_the_deep_mesh_overfills_the_last_level() -> None:
    """More faces than 2^20 leaves of four can hold, on few vertices."""
    mesh = depth_mesh(1)
    assert len(mesh.faces) == (FACES_PER_LEAF << MAX_DEPTH) + 8
    assert len(mesh.vertices) == 3_000
