"""Which shapes of meshes tell right solutions from wrong ones? Each as corners of triangles."""

import numpy as np

from grader.model.mesh import Doubles

SLIVER = 50.0
"""Flatness from which on a drawn triangle is replaced; `NEEDLE` is twenty times that."""

Soup = Doubles
"""(F, 3, 3) float64 corners of triangles; faces that share a corner repeat it."""


def confetti(rng: np.random.Generator, faces: int) -> Soup:
    """Scatter triangles in the cube from -1 to 1, of such a size that some overlap.

    Slivers are replaced: on needles float32 is right about nothing.
    """
    centre = rng.uniform(-1, 1, (faces, 1, 3))
    size = 0.8 / max(1, faces) ** (1 / 3)
    corners = rng.uniform(-1, 1, (faces, 3, 3))
    corners[flatness(corners) > SLIVER] = np.eye(3) - 0.5
    soup: Soup = centre + size * corners
    return soup


def flatness(soup: Soup) -> Doubles:
    """Return (F,) float64, L^2 / |n| of each triangle, L the longest edge, n = e1 x e2."""
    e1, e2 = soup[:, 1] - soup[:, 0], soup[:, 2] - soup[:, 0]
    longest = np.max([(edge * edge).sum(axis=1) for edge in (e1, e2, e2 - e1)], axis=0)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio: Doubles = longest / np.linalg.norm(np.cross(e1, e2), axis=1)
    return ratio


def terrain(rng: np.random.Generator, columns: int, rows: int) -> Soup:
    """Make a closed height field of 2 x columns x rows triangles without gaps."""
    x, y = np.meshgrid(np.linspace(-1, 1, columns + 1), np.linspace(-0.7, 0.7, rows + 1))
    phase = rng.uniform(0, 2 * np.pi, 4)
    z = 0.25 * np.sin(5 * x + phase[0]) * np.cos(4 * y + phase[1])
    z += 0.1 * np.sin(13 * x * y + phase[2]) + 0.05 * np.cos(9 * y + phase[3])
    return sheet(np.stack([x, y, z], axis=-1))


def sheet(points: Doubles) -> Soup:
    """Split the cells of a net of points into two triangles each.

    Args:
        points: (rows + 1, columns + 1, 3) float64.
    """
    a, b = points[:-1, :-1], points[:-1, 1:]
    c, d = points[1:, 1:], points[1:, :-1]
    halves = np.stack([np.stack([a, b, c], axis=-2), np.stack([a, c, d], axis=-2)])
    return halves.reshape(-1, 3, 3)


def plane(normal_axis: int, height: float, tiles: int = 10) -> Soup:
    """Make a square of 2 x tiles x tiles triangles, flat along an axis."""
    steps = tiles + 1
    u, v = np.meshgrid(np.linspace(-1, 1, steps), np.linspace(-0.8, 0.8, steps))
    return np.roll(
        sheet(np.stack([u, v, np.full_like(u, height)], axis=-1)), normal_axis - 2, -1
    )


def ball(rings: int, segments: int) -> Soup:
    """Make a sphere of radius 1 with 2 x segments x (rings - 1) triangles."""
    polar, around = np.linspace(0, np.pi, rings + 1), np.linspace(0, 2 * np.pi, segments + 1)
    around[-1] = 0.0
    p, a = np.meshgrid(polar, around, indexing="ij")
    points = np.stack([np.sin(p) * np.cos(a), np.sin(p) * np.sin(a), np.cos(p)], axis=-1)
    points[0], points[-1] = (0.0, 0.0, 1.0), (0.0, 0.0, -1.0)
    faces = sheet(points)
    return faces[flatness(faces) < SLIVER]


def strip(axis: int, cells: int, width: float = 0.05) -> Soup:
    """Make a narrow band of 2 x cells triangles along an axis."""
    along, across = np.meshgrid(np.linspace(-1, 1, cells + 1), [-width / 2, width / 2])
    twist = 0.1 * np.sin(3 * along)
    return np.roll(sheet(np.stack([along, across, twist], axis=-1)), axis, -1)


def box(low: tuple[float, float, float], high: tuple[float, float, float]) -> Soup:
    """Make a box of 12 triangles that look outwards."""
    corner = np.array([low, high])
    quads = []
    for axis in range(3):
        one, two = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, 1):
            quad = np.empty((2, 2, 3))
            quad[..., axis] = corner[side, axis]
            quad[..., one] = corner[:, one][:, None] if not side else corner[:, one][None, :]
            quad[..., two] = corner[:, two][None, :] if not side else corner[:, two][:, None]
            quads.append(sheet(quad))
    return np.concatenate(quads)


def boxes(count: int) -> Soup:
    """Make count^3 unit cubes that touch: every inner wall is there twice."""
    spots = [(x, y, z) for x in range(count) for y in range(count) for z in range(count)]
    return np.concatenate([box((x, y, z), (x + 1, y + 1, z + 1)) for x, y, z in spots])


def ell() -> Soup:
    """Make a flat L of 160 triangles: the box's middle is not the faces' middle."""
    points = np.stack(np.meshgrid(np.linspace(0, 1, 13), np.linspace(0, 1, 13)), axis=-1)
    cells = sheet(np.concatenate([points, 0.02 * points[..., :1] ** 2], axis=-1))
    centre = cells.mean(axis=1)
    kept: Soup = cells[(centre[:, 0] < 1 / 3) | (centre[:, 1] < 1 / 3)]
    return kept


def exponential(faces: int) -> Soup:
    """Make triangles at x = 2^k, each half as big as its distance: means are not medians."""
    size = 2.0 ** (np.arange(faces) - faces / 2)
    corners = np.array([[1.0, -0.2, 0.0], [1.3, 0.2, 0.1], [1.1, 0.1, 0.3]])
    soup: Soup = size[:, None, None] * corners
    return soup


def outlier(rng: np.random.Generator) -> Soup:
    """Make 100 small triangles and one far away."""
    soup = confetti(rng, 101)
    soup[100, :, 0] += 1e4
    return soup


def two_clusters(rng: np.random.Generator) -> Soup:
    """Make two clouds of 64 and 41 triangles, 2,000 apart along y."""
    far = np.array([0.0, 1e3, 0.0])
    return np.concatenate([confetti(rng, 64) - far, confetti(rng, 41) + far])


def concentric(faces: int) -> Soup:
    """Make triangles of growing size around one centre: every centre ties."""
    corners = np.array([[2.0, 0.0, 0.0], [-1.0, 2.0, 0.5], [-1.0, -2.0, -0.5]])
    soup: Soup = np.arange(1, faces + 1)[:, None, None] * corners
    return soup


def with_degenerate(rng: np.random.Generator, faces: int, share: float) -> Soup:
    """Make a cloud in which some triangles have two or three equal corners."""
    soup = confetti(rng, faces)
    bad = rng.choice(faces, round(share * faces), replace=False)
    soup[bad, 1] = soup[bad, 0]
    soup[bad[::2], 2] = soup[bad[::2], 0]
    return soup


def huge_and_small(rng: np.random.Generator) -> Soup:
    """Make one triangle behind 500 small ones, larger than all of them together."""
    huge = np.array([[[-9.0, -8.0, 1.5], [9.0, -8.0, 1.6], [0.0, 12.0, 1.7]]])
    return np.concatenate([huge, 0.6 * confetti(rng, 500)])


def parallel_quads(rng: np.random.Generator) -> Soup:
    """Make 100 tilted quads one behind another, of random size and order of corners."""
    quads = []
    for height in np.linspace(-1, 1, 100):
        u, v = np.meshgrid([-1.0, 1.0], [-1.0, 1.0])
        scale = rng.uniform(0.5, 1.0)
        net = np.stack([scale * u, scale * v, height + 0.05 * u], axis=-1)
        quads.append(sheet(net if rng.random() < 0.5 else net.swapaxes(0, 1)))
    return np.concatenate(quads)
