"""Every number that decides a grade, with its derivation and the mistake it must still catch."""

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

SPLIT_ULPS = 4
"""Units in the last place by which a centre or an extent may differ between right readings.

A centre is two float32 additions and one or three roundings of a quotient: at most 3 ulp of the
largest coordinate for every allowed formula, and 1 for the comparison. The smallest mistake to
catch moves a face by a whole position of a shuffled mesh, many thousand ulp.
"""

NODE_CAPACITY = 2**22
"""How many nodes of a tree are read: all 2^21 - 1 of depth 20 and one allocation twice as big."""


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
