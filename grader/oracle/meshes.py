"""Which meshes is a submission tried on? Everything that is drawn comes from the run's seed.

Faces are always shuffled and there are never as many vertices as faces, so that a mistaken
index shows. Every vertex belongs to a face, so that the mesh's box is the faces' box.
"""

import zlib
from collections.abc import Callable, Mapping

import numpy as np

from grader.model.mesh import Doubles, Mesh
from grader.oracle import shapes
from grader.oracle.scenes import load_mesh
from grader.oracle.shapes import Soup
from grader.tolerances import FACES_PER_LEAF, MAX_DEPTH

Named = tuple[str, Mesh]
DEEP_VERTICES = 3_000
BEYOND_16_BITS = 2**16 + 3
"""In 16 bits so few that they fit into a leaf."""


def generator(seed: int, *names: str) -> np.random.Generator:
    """Return the random numbers that belong to a seed and to names."""
    return np.random.default_rng([seed, *(zlib.crc32(name.encode()) for name in names)])


def construct_meshes(seed: int) -> list[Named]:
    """Make the meshes that trees are built over, but for `depth_mesh`."""
    return [(name, mesh_named(seed, name)) for name in (*SHAPES, *STORED)]


def mesh_named(seed: int, name: str) -> Mesh:
    """Make one mesh by its name."""
    rng = generator(seed, name)
    if name in STORED:
        return _shuffled(load_mesh(STORED[name]), rng)
    return welded(SHAPES[name](rng), rng)


def depth_mesh(seed: int) -> Mesh:
    """Make the mesh whose tree ends at depth 20: eight faces more than fill that level."""
    rng = generator(seed, "depth")
    vertices = rng.uniform(-1, 1, (DEEP_VERTICES, 3)).astype(np.float32)
    count = (FACES_PER_LEAF << MAX_DEPTH) + 8
    faces = rng.integers(DEEP_VERTICES, size=(count, 3), dtype=np.uint32)
    return Mesh(vertices, faces)


def welded(soup: Soup, rng: np.random.Generator) -> Mesh:
    """Turn triangles into a mesh of shared vertices, in random order."""
    points = soup.astype(np.float32).reshape(-1, 3) + np.float32(0)  # -0.0 becomes 0.0
    vertices, faces = np.unique(points, axis=0, return_inverse=True)
    faces = faces.reshape(-1, 3)
    if len(vertices) == len(faces) > 0:
        vertices = np.concatenate([vertices, vertices[faces[0, :1]]])
        faces[0, 0] = len(vertices) - 1
    place = rng.permutation(len(vertices))
    mixed = np.empty_like(vertices)
    mixed[place] = vertices
    return _shuffled(Mesh(mixed, place[faces].astype(np.uint32)), rng)


def _shuffled(mesh: Mesh, rng: np.random.Generator) -> Mesh:
    """Put the faces into random order."""
    return Mesh(mesh.vertices, mesh.faces[rng.permutation(len(mesh.faces))])


def _at(place: tuple[float, float, float], scale: float = 1.0) -> Callable[[Soup], Soup]:
    """Return what scales a soup and then moves it."""
    offset: Doubles = np.array(place)
    return lambda soup: scale * soup + offset


def _stretched(rng: np.random.Generator) -> Soup:
    """Scatter small triangles in a bar of 1000 : 1 : 1."""
    soup = 0.05 * shapes.confetti(rng, 400)
    return soup + rng.uniform(-1, 1, (400, 1, 3)) * (1000.0, 1.0, 1.0)


def _clouds() -> Mapping[str, Callable[[np.random.Generator], Soup]]:
    """Return the small numbers of faces around which limits and halves go wrong."""

    def cloud(faces: int) -> Callable[[np.random.Generator], Soup]:
        return lambda rng: shapes.confetti(rng, faces)

    counts = (0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 16, 17, 18, 33, 37, 64)
    return {f"cloud-{faces}": cloud(faces) for faces in counts}


SHAPES: Mapping[str, Callable[[np.random.Generator], Soup]] = {
    **_clouds(),
    "terrain-600": lambda rng: shapes.terrain(rng, 20, 15),
    "terrain-1200": lambda rng: shapes.terrain(rng, 30, 20),
    "ball-1280": lambda _: shapes.ball(21, 32),
    "cloud-65539": lambda rng: shapes.confetti(rng, BEYOND_16_BITS),
    "strip-x": lambda _: shapes.strip(0, 37),
    "strip-y": lambda _: shapes.strip(1, 37),
    "strip-z": lambda _: shapes.strip(2, 37),
    "cube": lambda _: shapes.box((-1, -1, -1), (1, 1, 1)),
    "ell": lambda _: shapes.ell(),
    "exponential": lambda _: shapes.exponential(41),
    "outlier": shapes.outlier,
    "two-clusters": shapes.two_clusters,
    "identical-9": lambda rng: np.tile(shapes.confetti(rng, 1), (9, 1, 1)),
    "identical-64": lambda rng: np.tile(shapes.confetti(rng, 1), (64, 1, 1)),
    "identical-1000": lambda rng: np.tile(shapes.confetti(rng, 1), (1000, 1, 1)),
    "concentric": lambda _: shapes.concentric(50),
    "plane-xy": lambda rng: shapes.plane(2, rng.uniform(-1, 1)),
    "plane-yz": lambda rng: shapes.plane(0, rng.uniform(-1, 1)),
    "plane-xz": lambda rng: shapes.plane(1, rng.uniform(-1, 1)),
    "zero-area": lambda rng: shapes.with_degenerate(rng, 40, 1.0),
    "soup-degenerate": lambda rng: shapes.with_degenerate(rng, 500, 0.1),
    "huge-and-small": shapes.huge_and_small,
    "parallel-quads": shapes.parallel_quads,
    "touching-boxes": lambda _: shapes.boxes(3),
    "octant-positive": lambda rng: shapes.confetti(rng, 90) + 5.0,
    "octant-negative": lambda rng: shapes.confetti(rng, 90) - 5.0,
    "far-away": lambda rng: _at((1000.0, -2000.0, 500.0))(shapes.terrain(rng, 14, 12)),
    "scaled-small": lambda rng: 1e-3 * shapes.terrain(rng, 14, 12),
    "scaled-large": lambda rng: 1e4 * shapes.terrain(rng, 14, 12),
    "scaled-tiny": lambda rng: 1e-12 * shapes.terrain(rng, 14, 12),
    "scaled-huge": lambda rng: _at((3e31, -3e31, 3e31), 1e31)(shapes.terrain(rng, 14, 12)),
    "stretched": _stretched,
    "one-point": lambda rng: np.tile(rng.uniform(-1, 1, 3), (9, 3, 1)),
}
"""Shape by name, drawn from random numbers of its own."""

STORED: Mapping[str, str] = {
    "grid-10x10": "grid",
    "nested-spheres": "nested",
    "dragon-res4": "dragon-res4",
    "dragon-res2": "dragon-res2",
    "dragon": "dragon",
}
"""Name of a mesh -> name of the stored one whose faces are shuffled."""

TRACED = (
    "cloud-1",
    "cloud-4",
    "cloud-5",
    "identical-9",
    "cloud-37",
    "terrain-600",
    "terrain-1200",
    "ball-1280",
    "grid-10x10",
    "nested-spheres",
    "soup-degenerate",
    "parallel-quads",
    "touching-boxes",
    "strip-x",
    "plane-xy",
    "huge-and-small",
    "far-away",
    "scaled-small",
    "scaled-large",
    "dragon-res4",
)
"""Meshes on which hits differ between right and wrong solutions."""
