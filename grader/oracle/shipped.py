"""What does the rule of closest hits say of a stored picture? That is stored beside it.

Theory of operation. To apply the rule to every pixel takes longer than all else in a first
grade, and gives the same on every machine. A file of answers begins with the hash of the rest.
The rest names what the answers belong to: the version of the rule, the picture's key and the
picture's rays. Numbers are stored as planes of bytes, and the rays' limits are left out,
because the candidates give them. A file that is not whole or belongs to something else counts
as absent, and the answers are computed: nothing but time depends on the file.
"""

import io
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from grader.errors import OutputFault
from grader.model.mesh import Answers, Bvh, Bytes, Doubles, Mesh
from grader.model.scene import Reference
from grader.oracle.brute import RULE_VERSION, Candidates, answers, nearest
from grader.oracle.hashed import hashed, unbroken
from grader.oracle.remember import digest_of, hash_of, remember
from grader.oracle.storage import packed, unpacked
from grader.tolerances import (
    EDGE_ERROR,
    EDGE_ON,
    EDGE_PADDING,
    NEEDLE,
    PLANE_ERROR,
    TRIANGLE_ERROR,
    WILD_PADDING,
)

Arrays = Mapping[str, npt.NDArray[Any]]
FORMAT = 1
"""Goes up with every change in what the arrays of a file mean."""

RULE = (
    RULE_VERSION,
    TRIANGLE_ERROR,
    PLANE_ERROR,
    EDGE_ON,
    EDGE_ERROR,
    EDGE_PADDING,
    WILD_PADDING,
    NEEDLE,
)
"""The rule, as far as a change of it can be seen without asking it: version and numbers."""

SEARCH_MARGIN = 1e-3
"""How far behind Mitsuba's hit the first search goes, relative to t; decides only its speed."""


def picture_answers(path: Path, mesh: Mesh, tree: Bvh, picture: Reference) -> Answers:
    """Return the rule's answers of a picture, as quickly as they are to be had.

    Args:
        path: File of answers; it may be missing, damaged or of something else.
        mesh: The picture's mesh.
        tree: Any tree over the mesh.
        picture: Its rays are asked, its t only says where to look first.
    """
    found = read_answers(path, picture)
    if found is not None:
        return found
    # The key of a picture covers its mesh; the answers do not depend on the tree.
    key = digest_of("picture", _belongs_to(picture))
    return remember(key, lambda: computed_answers(mesh, tree, picture))


def computed_answers(mesh: Mesh, tree: Bvh, picture: Reference) -> Answers:
    """Apply the rule to each pixel.

    Args:
        mesh: The picture's mesh.
        tree: Any tree over the mesh.
        picture: As for `picture_answers`.
    """
    behind = picture.t.astype(np.float64) * (1 + SEARCH_MARGIN)
    return answers(mesh, picture.rays, tree, behind)


def write_answers(path: Path, picture: Reference, found: Answers) -> None:
    """Store the answers of a picture.

    Raises:
        OutputFault: The file cannot be written.
    """
    counts = np.diff(found.first)
    arrays = {
        "belongs_to": _belongs_to(picture),
        "counts": counts.astype(np.min_scalar_type(counts.max(initial=0))),
        "face": packed(found.face.astype(np.uint32)),
        "t": _planes(found.t),
        "tolerance": _planes(found.tolerance),
        "kind": found.kind,
    }
    try:
        path.write_bytes(deflated(arrays))
    except OSError as fault:
        raise OutputFault(f"{path}: the answers cannot be written ({fault})") from fault


def read_answers(path: Path, picture: Reference) -> Answers | None:
    """Read the answers of a picture; None if there are none that are whole and its own."""
    try:
        arrays = _inflated(path.read_bytes())
    except OSError:
        return None
    if arrays is None or not np.array_equal(arrays.get("belongs_to", 0), _belongs_to(picture)):
        return None
    return _restored(arrays)


def deflated(arrays: Arrays) -> bytes:
    """Turn arrays into the bytes of a file, which begin with a hash of the rest."""
    body = io.BytesIO()
    np.savez_compressed(body, **dict(arrays))  # type: ignore[arg-type]  # numpy's stub takes no mapping
    return b"".join(hashed([body.getvalue()]))


def _inflated(content: bytes) -> Arrays | None:
    """Undo `deflated`; None if the bytes are not whole."""
    body = unbroken(content)
    if body is None:
        return None
    with np.load(io.BytesIO(body), allow_pickle=False) as stored:
        return {name: stored[name] for name in stored.files}


def _belongs_to(picture: Reference) -> Bytes:
    """Return (32,) bytes, a hash of all that the answers and their file depend on."""
    rays = picture.rays
    arrays = (rays.origin, rays.direction, rays.t_min, rays.t_max)
    return np.frombuffer(hash_of(FORMAT, RULE, picture.key, *arrays), dtype=np.uint8)


def _restored(arrays: Arrays) -> Answers:
    """Undo what `write_answers` did to the arrays."""
    counts = arrays["counts"].astype(np.int64)
    ray = np.repeat(np.arange(counts.size), counts)
    # What `nearest` kept once it keeps again, and the limits follow from it.
    kept = Candidates(
        ray=ray,
        face=unpacked(arrays["face"]).astype(np.int64),
        t=_numbers(arrays["t"]),
        tolerance=_numbers(arrays["tolerance"]),
        kind=arrays["kind"],
        entry=np.full(ray.size, -np.inf),
    )
    return nearest(kept, counts.size)


def _planes(numbers: Doubles) -> Bytes:
    """Turn (n,) float64 into (8, n) bytes, so that bytes that change little stand together."""
    return np.ascontiguousarray(numbers.astype("<f8").view(np.uint8).reshape(-1, 8).T)


def _numbers(planes: Bytes) -> Doubles:
    """Undo `_planes`."""
    return np.ascontiguousarray(planes.T).view("<f8").ravel().astype(np.float64)
