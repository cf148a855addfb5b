"""How the grader and a worker talk: one sealed input, one result of fixed size.

The input file holds arrays, then rows of eight numbers: an operation and its arguments, which
are slots, counts and byte offsets into the input or the result. The result file begins with a
header that says how far the worker came; the arrays lie where the grader reserved them. The
worker decides nothing and knows no answer: everything it writes is the submission's word, and
the grader reads it only after the worker is dead.

This file is read by the worker too, so it uses the standard library only, and of that not
`enum`: importing it would cost every worker 10 ms.
"""

import struct

MAGIC = 0x33304558
VERSION = 1
ROW = struct.Struct("<8Q")
HEADER = struct.Struct("<8Q")
"""Input: magic, version, offset of the rows, their number. Result: magic, version, number of
finished operations, status, length of the error text."""

CONSTRUCT_NS, TRACE_NS, TURN = 40, 48, 56
"""Of a worker that stays (`live.py`), in the result's header: nanoseconds in `construct`,
nanoseconds in `intersect`, and the turn that the grader is at: rows of another are skipped."""

ERROR_OFFSET = 64
ERROR_CAPACITY = 512
DATA_OFFSET = 1024
"""Where the reserved arrays of the result begin."""


class Op:
    """Numbers of what a worker can do; arguments in the order of the row."""

    MESH = 1
    """Make a mesh and its own tree, the next slot: vertices, count, faces, count."""
    TREE = 2
    """Make a tree without a mesh, the next slot."""
    CONSTRUCT = 3
    """Call `construct`: slot of the tree, slot of the mesh."""
    READ_TREE = 4
    """Copy a tree out: slot, nodes, capacity, face indices, capacity, two counts."""
    READ_MESH = 5
    """Copy a mesh out: slot, vertices, capacity, faces, capacity, two counts."""
    SET_TREE = 6
    """Replace a tree: slot, nodes, count, face indices, count."""
    TRACE = 7
    """Call `intersect`: slot, rays, count, hits, tests or 0, finished rays, threads."""
    RECORD = 8
    """Call `intersect` and record its tests: slot, one ray, hit, steps, capacity, count."""
    REPLACE = 9
    """Put other arrays where a mesh lies, and no tree: slot, vertices, count, faces, count."""


class Status:
    """Numbers of how the last operation ended; the first five are the library's own words."""

    OK = 0
    THREW = 1
    OUT_OF_MEMORY = 2
    NO_THREAD = 3
    NOT_WRITTEN = 4
    NOT_LOADED = 100
    """The library could not be loaded."""
    MISMATCH = 101
    """The library is not one that this worker knows: our own fault."""
