"""The C ABI and the reference, on meshes and trees made by hand."""

import ctypes
from typing import Any

import numpy as np
import pytest

from tests.student_stub.library import HIT, NODE, Indices, MeshInLibrary, Trace

EVERY_SIZE = [0, 1, 2, 3, 4, 5, 8, 9, 10, 12, 16, 17, 18, 33, 37, 64, 600, 1200]


def soup(library: ctypes.CDLL, faces: int, seed: int = 7) -> MeshInLibrary:
    """Make a mesh of small triangles at random places, with as many vertices as corners."""
    rng = np.random.default_rng(seed)
    corners = rng.uniform(-1, 1, (faces, 1, 3)) + rng.uniform(-0.2, 0.2, (faces, 3, 3))
    return MeshInLibrary(library, corners, np.arange(3 * faces))


def rays(count: int = 400) -> np.ndarray[Any, np.dtype[np.float32]]:
    """Make (R, 8) rays from a sphere around the soup to points in it."""
    rng = np.random.default_rng(11)
    out = np.zeros((count, 8), np.float32)
    out[:, :3] = rng.normal(size=(count, 3)) * 3
    out[:, 3:6] = rng.uniform(-1, 1, (count, 3)) - out[:, :3]
    out[:, 7] = np.inf
    return out


def by_brute_force(mesh: MeshInLibrary) -> Trace:
    """Trace with a tree of one leaf, which tests every face."""
    whole = ((-9, -9, -9), (9, 9, 9), 0, mesh.faces)
    mesh.set_tree(np.array([whole], NODE), np.arange(mesh.faces))
    return mesh.trace(rays())


def test_sizes_and_constants(library: ctypes.CDLL) -> None:
    """Records have the sizes that the grader's arrays have; an unknown record has none."""
    assert [library.ex03_size_of(k) for k in range(8)] == [12, 12, 32, 32, 28, 60, 0, 0]
    assert NODE.itemsize == 32
    assert HIT.itemsize == 28
    assert library.ex03_abi_version() == 3
    assert (library.ex03_max_depth(), library.ex03_faces_per_leaf()) == (20, 4)


@pytest.mark.parametrize("faces", EVERY_SIZE)
def test_the_reference_splits_by_the_rules(library: ctypes.CDLL, faces: int) -> None:
    """Halves of equal size, at most four faces in a leaf, tight boxes, unused slots empty."""
    mesh = soup(library, faces)
    nodes, order = mesh.construct()
    vertices = np.zeros((3 * faces, 3), np.float32)
    library.ex03_copy_vertices(mesh.mesh, vertices.ctypes.data, len(vertices))
    assert sorted(order.tolist()) == list(range(faces))
    assert (nodes[0]["begin"], nodes[0]["end"]) == (0, faces)
    for i, node in enumerate(nodes):
        used = int(node["end"]) - int(node["begin"])
        children = nodes[2 * i + 1 : 2 * i + 3]
        if used <= 4:
            assert not children["end"].any()
        else:
            assert children["begin"].tolist() == [node["begin"], node["begin"] + used // 2]
            assert children["end"].tolist() == [node["begin"] + used // 2, node["end"]]
        if used:
            own = vertices.reshape(-1, 3, 3)[order[node["begin"] : node["end"]]]
            assert (own.min((0, 1)) == node["low"]).all()
            assert (own.max((0, 1)) == node["high"]).all()


@pytest.mark.parametrize("faces", EVERY_SIZE)
def test_the_reference_finds_what_brute_force_finds(library: ctypes.CDLL, faces: int) -> None:
    """With gaps, one face or none: all hits are bit for bit those of a single leaf."""
    mesh = soup(library, faces)
    expected = by_brute_force(mesh)
    mesh.construct()
    traced = mesh.trace(rays())
    assert (traced.hits == expected.hits).all()
    assert traced.done == 400
    if faces >= 64:
        assert traced.tests[:, 1].mean() < 0.5 * faces


def test_a_leaf_with_an_empty_range_hides_its_faces(library: ctypes.CDLL) -> None:
    """The range [k, k) with k > 0 is a leaf without faces; its parent is none."""
    mesh = soup(library, 9)
    nodes, order = mesh.construct()
    nodes[2]["begin"] = nodes[2]["end"]
    nodes[5:]["end"] = 0
    mesh.set_tree(nodes, order)
    left = MeshInLibrary(library, *faces_of(mesh, order[:4]))
    assert (mesh.trace(rays()).hits["t"] == by_brute_force(left).hits["t"]).all()


def faces_of(mesh: MeshInLibrary, chosen: Indices) -> tuple[object, object]:
    """Give the vertices of a soup, and only the chosen ones of its faces."""
    vertices = np.zeros((3 * mesh.faces, 3), np.float32)
    mesh.library.ex03_copy_vertices(mesh.mesh, vertices.ctypes.data, len(vertices))
    return vertices, np.arange(3 * mesh.faces).reshape(-1, 3)[chosen]


def test_a_second_construction_starts_afresh(library: ctypes.CDLL) -> None:
    """Building again gives the same tree, and the mesh is as it was."""
    mesh = soup(library, 37)
    first, second = mesh.construct(), mesh.construct()
    assert (first[0] == second[0]).all()
    assert (first[1] == second[1]).all()


def test_copies_respect_the_capacity(library: ctypes.CDLL) -> None:
    """A buffer that is too small gets its share, and the true count is returned."""
    mesh = soup(library, 9)
    mesh.construct()
    buffer = np.full(12, 77, np.uint32)
    assert library.ex03_copy_face_indices(mesh.bvh, buffer.ctypes.data, 3) == 9
    assert (buffer[3:] == 77).all()
    assert (buffer[:3] < 9).all()


def test_a_tree_is_read_where_it_lies(library: ctypes.CDLL) -> None:
    """The views are the memory of the tree itself, and a tree of its own lies elsewhere."""
    mesh = soup(library, 37)
    nodes, order = mesh.construct()
    at = library.ex03_nodes(mesh.bvh), library.ex03_face_indices(mesh.bvh)
    assert ctypes.string_at(at[0], nodes.nbytes) == nodes.tobytes()
    assert ctypes.string_at(at[1], order.nbytes) == order.tobytes()
    mesh.set_tree(nodes, order[::-1])
    seen = ctypes.string_at(library.ex03_face_indices(mesh.bvh), order.nbytes)
    assert seen == order[::-1].tobytes()

    other = library.ex03_bvh_create()
    assert library.ex03_construct(other, mesh.mesh) == 0
    assert library.ex03_nodes(other) != library.ex03_nodes(mesh.bvh)
    assert ctypes.string_at(library.ex03_face_indices(other), order.nbytes) == order.tobytes()
    library.ex03_bvh_destroy(other)
    library.ex03_mesh_destroy(mesh.mesh)


def test_the_given_tests_are_counted_until_they_are_reset(library: ctypes.CDLL) -> None:
    """Box tests, then triangle tests, of all that this thread traced."""
    mesh = soup(library, 600)
    mesh.construct()
    counted = np.zeros(2, np.uint64)
    library.ex03_reset_counters()
    library.ex03_read_counters(counted.ctypes.data)
    assert counted.tolist() == [0, 0]
    expected = mesh.trace(rays()).tests.sum(0).tolist() + mesh.trace(rays(), 2).tests.sum(0)
    library.ex03_read_counters(counted.ctypes.data)
    assert counted.tolist() == expected.tolist()
    assert counted.min() > 0


@pytest.mark.parametrize("threads", [1, 2, 5])
def test_threads_all_trace_everything(library: ctypes.CDLL, threads: int) -> None:
    """Each thread's slice holds the same bits as a single thread's result."""
    mesh = soup(library, 600)
    mesh.construct()
    alone, together = mesh.trace(rays()), mesh.trace(rays(), threads)
    assert together.done == 400 * threads
    for part in np.split(together.hits, threads):
        assert (part == alone.hits).all()
    for tests in np.split(together.tests, threads):
        assert (tests == alone.tests).all()


def test_no_memory_is_not_a_crash(library: ctypes.CDLL) -> None:
    """A mesh that cannot fit gives NULL and leaves a reason."""
    assert library.ex03_mesh_create(None, 2**61, None, 0) is None
    reason = np.zeros(64, np.uint8)
    assert library.ex03_last_error(reason.ctypes.data, 64) > 0
