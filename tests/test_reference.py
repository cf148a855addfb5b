"""The fast model solution builds the clear one's trees, bit by bit, and finds the same hits."""

import ctypes
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest

from grader import resources
from grader.bench.rays import camera_rays, scattered_rays
from grader.model.mesh import Mesh
from grader.oracle.meshes import SHAPES, depth_mesh, mesh_named
from grader.run.transfer import ray_table
from tests.compiled import library_of
from tests.student_stub.library import MeshInLibrary, load

pytestmark = [pytest.mark.usefixtures("cache"), pytest.mark.xdist_group("reference")]

Libraries = Mapping[str, ctypes.CDLL]


@pytest.fixture(scope="module", name="libraries")
def loaded_libraries(cache: Path, tmp_path_factory: pytest.TempPathFactory) -> Libraries:
    """Build both solutions, with the graded flags."""
    del cache
    folder = tmp_path_factory.mktemp("solutions")
    sources = {"clear": resources.reference_source(), "fast": resources.fast_source()}
    return {
        name: load(library_of(source.read_text(), folder / name))
        for name, source in sources.items()
    }


def require_same_trees(libraries: Libraries, mesh: Mesh) -> None:
    """Compare every byte: minus zero is not zero, and the order in a leaf counts."""
    clear, fast = (
        MeshInLibrary(libraries[name], mesh.vertices, mesh.faces).construct()
        for name in ("clear", "fast")
    )
    assert clear[0].tobytes() == fast[0].tobytes()
    assert clear[1].tobytes() == fast[1].tobytes()


@pytest.mark.parametrize("name", [*SHAPES, "grid-10x10", "dragon-res4"])
def test_trees_are_equal(libraries: Libraries, name: str) -> None:
    """On every mesh of a grade: without faces, of equal faces, of faces without area."""
    require_same_trees(libraries, mesh_named(41, name))


@pytest.mark.parametrize("faces", [5, 64, 1000, 5000])
def test_trees_are_equal_where_centres_tie(libraries: Libraries, faces: int) -> None:
    """Corners on a lattice of three points an axis, signed zeros among them."""
    random = np.random.default_rng(faces)
    vertices = random.choice(np.array([-1, -0.0, 0.0], np.float32), (60, 3))
    mesh = Mesh(vertices, random.integers(60, size=(faces, 3), dtype=np.uint32))
    require_same_trees(libraries, mesh)


def test_trees_are_equal_at_the_depth_limit(libraries: Libraries) -> None:
    """Four million faces: the last level holds more than four a leaf."""
    require_same_trees(libraries, depth_mesh(41))


@pytest.mark.parametrize(
    "name", ["cloud-0", "cloud-1", "cloud-9", "terrain-1200", "identical-64", "dragon-res4"]
)
def test_hits_are_equal(libraries: Libraries, name: str) -> None:
    """The same t and point, bit by bit; where two faces are equally near, either normal."""
    mesh = mesh_named(41, name)
    empty = len(mesh.faces) == 0
    seen = mesh_named(41, "cloud-9") if empty else mesh
    rays = np.concatenate(
        [ray_table(camera_rays(seen, 40)), ray_table(scattered_rays(seen, 2_000))]
    )
    rays[::7, 4] = 0.0  # along slabs
    found = []
    for library in libraries.values():
        loaded = MeshInLibrary(library, mesh.vertices, mesh.faces)
        loaded.construct()
        found.append(loaded.trace(rays).hits)
    for part in ("t", "point"):
        assert found[0][part].tobytes() == found[1][part].tobytes()
    assert empty or np.isfinite(found[0]["t"]).any()
