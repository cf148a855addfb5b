"""Builds the stub and calls its C ABI, without the grader in between."""

import ctypes
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

ROOT = Path(__file__).resolve().parents[2]
STUB = ROOT / "student_stub"
REFERENCE = ROOT / "reference" / "src" / "exercise03.cpp"
STARTER = STUB / "src" / "exercise03.cpp"

Floats = npt.NDArray[np.float32]
Indices = npt.NDArray[np.uint32]

NODE = np.dtype([("low", "<f4", 3), ("high", "<f4", 3), ("begin", "<u4"), ("end", "<u4")])
HIT = np.dtype([("point", "<f4", 3), ("t", "<f4"), ("normal", "<f4", 3)])


def run(*command: str | Path, cwd: Path | None = None) -> subprocess.CompletedProcess[str]:
    """Run one of our own programs to its end, with its output as text."""
    return subprocess.run(
        [str(word) for word in command], cwd=cwd, capture_output=True, text=True, check=False
    )


def build(folder: Path, *options: str) -> str:
    """Configure and build the stub in `folder`; return everything the tools said."""
    configured = run("cmake", "-G", "Unix Makefiles", "-S", STUB, "-B", folder, *options)
    assert configured.returncode == 0, configured.stderr
    built = run("cmake", "--build", folder)
    assert built.returncode == 0, built.stdout + built.stderr
    return configured.stderr + built.stdout + built.stderr


class Batch(ctypes.Structure):
    """`ex03_batch` of the C header."""

    _fields_ = (
        ("rays", ctypes.c_void_p),
        ("count", ctypes.c_uint64),
        ("hits", ctypes.c_void_p),
        ("tests", ctypes.c_void_p),
        ("done", ctypes.c_void_p),
    )


@dataclass(frozen=True, slots=True, eq=False)
class Trace:
    """What came back for a batch of rays."""

    hits: npt.NDArray[np.void]
    tests: Indices
    done: int


def load(path: Path) -> ctypes.CDLL:
    """Open the library and declare the functions that do not return an int."""
    library = ctypes.CDLL(str(path))
    pointer, u64 = ctypes.c_void_p, ctypes.c_uint64
    for name in ("mesh_create", "mesh_bvh", "bvh_create", "nodes", "face_indices"):
        getattr(library, f"ex03_{name}").restype = pointer
    for name in ("size_of", "copy_nodes", "copy_face_indices", "copy_vertices", "last_error"):
        getattr(library, f"ex03_{name}").restype = u64
    library.ex03_mesh_create.argtypes = [pointer, u64, pointer, u64]
    for name in ("mesh_bvh", "nodes", "face_indices", "mesh_destroy", "bvh_destroy", "read_counters"):
        getattr(library, f"ex03_{name}").argtypes = [pointer]
    for name in ("construct", "intersect", "intersect_threads"):
        getattr(library, f"ex03_{name}").argtypes = [pointer, pointer]
    library.ex03_intersect_threads.argtypes = [pointer, pointer, ctypes.c_uint32]
    for name in ("copy_nodes", "copy_face_indices", "copy_vertices"):
        getattr(library, f"ex03_{name}").argtypes = [pointer, pointer, u64]
    library.ex03_set_tree.argtypes = [pointer, pointer, u64, pointer, u64]
    library.ex03_last_error.argtypes = [pointer, u64]
    return library


class MeshInLibrary:
    """A mesh that lives in the library, with its own tree."""

    def __init__(self, library: ctypes.CDLL, vertices: object, faces: object) -> None:
        self.library = library
        v = np.ascontiguousarray(vertices, dtype=np.float32).reshape(-1, 3)
        f = np.ascontiguousarray(faces, dtype=np.uint32).reshape(-1, 3)
        self.faces = len(f)
        self.mesh = library.ex03_mesh_create(v.ctypes.data, len(v), f.ctypes.data, len(f))
        self.bvh = library.ex03_mesh_bvh(self.mesh)

    def construct(self) -> tuple[npt.NDArray[np.void], Indices]:
        """Build the tree and return its (N,) nodes and (F,) face indices."""
        assert self.library.ex03_construct(self.bvh, self.mesh) == 0
        nodes = np.zeros(self.library.ex03_copy_nodes(self.bvh, None, 0), NODE)
        order = np.zeros(self.faces, np.uint32)
        self.library.ex03_copy_nodes(self.bvh, nodes.ctypes.data, len(nodes))
        count = self.library.ex03_copy_face_indices(self.bvh, order.ctypes.data, len(order))
        assert count == self.faces
        return nodes, order

    def set_tree(self, nodes: npt.NDArray[np.void], order: object) -> None:
        """Put a tree in that was made by hand."""
        o = np.ascontiguousarray(order, dtype=np.uint32)
        status = self.library.ex03_set_tree(
            self.bvh, nodes.ctypes.data, len(nodes), o.ctypes.data, len(o)
        )
        assert status == 0

    def trace(self, rays: object, threads: int = 0) -> Trace:
        """Trace (R, 8) rays: origin, direction, t_min, t_max; 0 threads is the plain call."""
        r = np.ascontiguousarray(rays, dtype=np.float32).reshape(-1, 8)
        hits = np.zeros(len(r) * max(threads, 1), HIT)
        tests = np.zeros((len(hits), 2), np.uint32)
        done = np.zeros(1, np.uint64)
        arrays = (a.ctypes.data for a in (hits, tests, done))
        batch = Batch(r.ctypes.data, len(r), *arrays)
        if threads:
            status = self.library.ex03_intersect_threads(
                self.mesh, ctypes.byref(batch), threads
            )
        else:
            status = self.library.ex03_intersect(self.mesh, ctypes.byref(batch))
        assert status == 0
        return Trace(hits, tests, int(done[0]))
