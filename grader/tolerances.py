"""Every number that decides a grade, with its derivation and the mistake it must catch."""

UNIT_ROUNDOFF = 2.0**-24
"""u of float32: the relative error of one rounded operation. Source: IEEE 754-2019."""

EPSILON = 1e-5
"""Default `t_min` of a ray. Source: exercise interface, common.h."""

FACES_PER_LEAF = 4
"""Source: exercise sheet, part a, `numFacesPerLeaf = 4`."""

MAX_DEPTH = 20
"""Source: exercise sheet, part a, `maxDepth = 20`."""

SMALL_MAX_DEPTH = 6
"""Depth limit of the sanitized build, so that meshes of a few hundred faces reach it."""


def depth_limit(small: bool) -> int:
    """Return the depth limit that a build has, the small one or the real one."""
    return SMALL_MAX_DEPTH if small else MAX_DEPTH


def reaches_the_limit(faces: int, small: bool) -> bool:
    """Tell whether only the depth limit of a build ends the tree over so many faces."""
    return faces > FACES_PER_LEAF << depth_limit(small)


SPLIT_ULPS = 4
"""Units in the last place by which a centre or an extent may differ between right readings.

A centre is two float32 additions and one or three roundings of a quotient: at most 3 ulp of the
largest coordinate for every allowed formula, and 1 for the comparison. The smallest mistake to
catch moves a face by a whole position of a shuffled mesh, many thousand ulp.
"""

NODE_CAPACITY = 2**22
"""How many nodes of a tree are read: the 2^21 - 1 of depth 20, in a vector twice as big."""


PICTURE_RELATIVE = 1e-4
"""How far t may be from Mitsuba's, relative to t, in addition to the rule's bound.

Measured on the dragon, 512 x 512: a float32 plane test differs by more than 1e-5 on 2 pixels
and by more than 1e-4 on none. The smallest mistake to catch is a hit on the next surface.
"""

PICTURE_PIXELS, PICTURE_SHARE = 4, 1e-4
"""At most max(4, 1e-4 of the pixels) may differ from Mitsuba where the rule allows both.

Such pixels look at an edge, where Embree and the given test may see different faces. A hole of
one pixel is caught by the rule, not by this count.
"""

TRIANGLE_ERROR = 12.0
"""Rounding errors of a float32 plane test, in units of u |e1||e2||d| / |den|, relative to t.

Two subtractions per edge, two products and a difference per component of the normal, and the
sums of two dot products. Measured on 10 meshes x 17 ray families with eleven ways to write the
test: the largest error was 0.15 of the resulting tolerance. Median tolerance: 3e-6 t. The
smallest mistake to catch is a hit on another surface, or `t` off by 1e-4.
"""

PLANE_ERROR = 4.0
"""Rounding errors of a plane test n . v - n . o, in units of u |n| (|o| + |v|) / |den|.

Textbooks write the plane as n . p = c. Then v - o, which hardly rounds, is not formed: each
dot product of three terms errs by at most 3u |n||o| or 3u |n||v|, v being the corner farthest
from the world's origin, and these errors do not cancel. Rounded up, because the difference
rounds too. Near the origin the median tolerance grows from 3e-6 t to 4e-6 t; at (1000, -2000,
500) it is 9e-4 t, nine float32 steps of such a coordinate. The smallest mistake to catch is a
hit on another surface. docs/closest-hits.md tells what was measured.
"""

EDGE_ON = 0.25
"""Relative error of the denominator from which on float32 cannot tell its sign: WILD."""

EDGE_ERROR = 40.0
"""Rounding errors of the edge tests, as a distance in units of u L^2/|e|; measured as above."""

WILD_PADDING = 16.0
"""A WILD triangle's box grows by this x u(|o| + |v1| + |e1| + |e2|); measured as above."""

EDGE_PADDING = 128.0
"""An EDGE triangle's box grows by this x u(|o| + |v1| + |e1| + |e2|) x flatness.

Farther away no float32 hit can be: 24 for the plane, 80 for an acute corner, rounded up.
"""

NEEDLE = 1000.0
"""Flatness L^2/|n| beyond which triangles are not used to judge hits: there some right ways to
write the edge tests (dot products of edges) err more than any useful tolerance allows."""

POINT_ERROR = 4.0
"""A hit's point may be off o + t d by this x (tolerance of t along the ray + rounding).

o + t d itself rounds to 2u (|o| + |t||d|); a point made of barycentric coordinates adds their
errors, each at most the tolerance of t along the ray, for two coordinates. The smallest mistake
to catch is the point of another hit, or one in other units; both are off by whole edges.
"""

NORMAL_ERROR = 16.0
"""A unit normal may be off by this x u (1 + L^2/|n|), L the longest edge, n = e1 x e2.

An edge rounds to u|e| per component, a component of the cross product adds three roundings of
products below L^2: |dn| <= sqrt(3) (2 + 2 + 3) u L^2 = 12.1 u L^2, and normalising 4u.
The smallest mistake to catch is a normal of another face, turned round, or not normalised.
"""

UNIT_LENGTH = 1e-6
"""How far a normal's length may be from 1: 17u; normalising in float32 errs by at most 4u."""

WASTE = 4.0
"""How many times the tests of a plain traversal, boxes and triangles together, a ray may take.

The plain traversal tests every node whose parent was entered and has no early out. Testing a
node's children before entering it, and again when they are entered, costs up to 3 times that.
The smallest mistake to catch, a box test that is forgotten, costs a hundred times as many.
"""

ANSWERED, FEW = 0.9, 20
"""Of the rays that hit something, and of the others, if there are at least so many, this
share has to be answered so where work is measured: who answers without a search does no work.
"""

LARGE_MESH = 20_000
"""Meshes of more faces get the rubric's larger limit of time, and show how work grows."""

FORFEIT = 0.05
"""Whoever wastes tests on more than this share of the faces excludes nothing: zero points.

A plain traversal costs 1.1 % of 11,102 faces (seed 77) and 0.08 % of 202,520.
"""

SPECIAL_WASTE = 12.0
"""The same for rays from inside, along axes and with limits, a third of each.

Measured on 11,102 faces: a right solution whose own box test leaves out the slabs along which
a ray does not move takes 7 times as many, who tests all faces for a sixth of the rays 21 times.
"""

SLOWEST, START_SECONDS = 10.0, 0.2
"""A submission may take 0.2 s + 10 times the model solution's CPU time, start of the worker
included in both.

Measured on 202,520 faces, 20,000 rays: the model solution takes 0.1 s, so 1.2 s are allowed;
the slowest right solution of 27 takes 0.25 s. A copy of all faces for every ray (2.4 MB) costs
2.5 s, one of the nodes (4.2 MB) or of the tree more.
"""
