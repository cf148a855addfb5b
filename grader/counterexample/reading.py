"""How is the file of a counterexample read, which may come from a stranger?

It is bounded, and every value is held against what it may be; what is not expected is refused
with a sentence that names the place. Nothing in it is believed but the input itself: answers,
costs and what is gone from an altered tree are computed anew.
"""

import json
import math
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NoReturn, TypeVar

import numpy as np

from grader.counterexample.search import MOST_FACES, MOST_RAYS
from grader.counterexample.written import FORMAT, KINDS, VERSION
from grader.errors import UsageError
from grader.model.mesh import Bvh, Floats, Indices, Mesh, Rays
from grader.plain import one_line

Json = dict[str, Any]
Item = TypeVar("Item")

LARGEST = 1_000_000
"""Bytes; what is written has at most 900,000."""

LONGEST = 400
"""Characters of a check's message that are kept."""

FLOAT_MAX = float(np.finfo(np.float32).max)
MOST_VERTICES = 3 * MOST_FACES
MOST_NODES = 2**21 - 1
MOST_USED = 4 * MOST_FACES
KEYS = {
    "format", "version", "check", "kind", "name", "message", "expected", "got", "explanation",
    "sanitized", "full_levels", "special", "meshes", "trees", "rays",
}  # fmt: skip


class Content:
    """A file's input, checked value by value."""

    def __init__(self, given: Json) -> None:
        """Check everything.

        Raises:
            UsageError: Something is not as it may be.
        """
        self.check = text(given["check"], "check")
        self.kind = text(given["kind"], "kind")
        if self.kind not in KINDS.values():
            refuse("kind", f"one of {', '.join(KINDS.values())}")
        self.name = text(given["name"], "name")
        self.message = words(given["message"], "message")
        """What the check said of it when it was found."""

        self.sanitized = flag(given["sanitized"], "sanitized")
        self.full_levels = flag(given["full_levels"], "full_levels")
        self.special = flag(given["special"], "special")
        traced = self.kind not in ("construct", "rebuild")
        two = self.kind in ("rebuild", "repeat")
        self.meshes = listed(given["meshes"], "meshes", 2, mesh)
        self.trees = listed(given["trees"], "trees", 2, tree)
        if len(self.meshes) != 1 + two or len(self.trees) != (1 + two) * traced:
            refuse("meshes and trees", f"as many as {self.kind} needs")
        for one, of in zip(self.trees, self.meshes, strict=False):
            fitting(one, of)
        rows = listed(given["rays"], "rays", MOST_RAYS, ray)
        if bool(rows) != traced:
            refuse("rays", "some, but only in part b")
        table = np.array([row for row, _ in rows], np.float32).reshape(-1, 8)
        self.rays = Rays(table[:, 0:3], table[:, 3:6], table[:, 6], table[:, 7])
        self.families = [family for _, family in rows]


def read(path: Path) -> Content:
    """Read a file.

    Raises:
        UsageError: It cannot be read, or is none that this version writes.
    """
    try:
        with path.open("rb") as file:
            data = file.read(LARGEST + 1)
        if len(data) > LARGEST:
            raise UsageError(f"{path}: a counterexample has at most {LARGEST:,} bytes")
        given = json.loads(
            data.decode("utf-8"), object_pairs_hook=once, parse_constant=constant
        )
    except OSError as fault:
        raise UsageError(f"{path} cannot be read: {fault.strerror}") from fault
    except (ValueError, RecursionError) as fault:
        raise UsageError(f"{path} is no JSON file of a counterexample") from fault
    try:
        keys(given, KEYS, "the file")
        if given["format"] != FORMAT or given["version"] != VERSION:
            refuse("format and version", f"{FORMAT} {VERSION}")
        return Content(given)
    except UsageError as fault:
        raise UsageError(f"{path}: {fault}") from fault


def once(pairs: Sequence[tuple[str, Any]]) -> Json:
    """Make an object whose keys are all different.

    Raises:
        ValueError: Two are the same.
    """
    made = dict(pairs)
    if len(made) != len(pairs):
        raise ValueError("a key stands twice")
    return made


def constant(name: str) -> NoReturn:
    """Refuse NaN and Infinity, which JSON does not have.

    Raises:
        ValueError: Always.
    """
    raise ValueError(name)


def refuse(place: str, wanted: str) -> NoReturn:
    """Say what is wrong where.

    Raises:
        UsageError: Always.
    """
    raise UsageError(f"{place} must be {wanted}")


def keys(given: object, wanted: set[str], place: str) -> Json:
    """Return an object with exactly these keys."""
    if not isinstance(given, dict) or set(given) != wanted:
        refuse(place, f"an object with {', '.join(sorted(wanted))}")
    return given


def listed(
    given: object, place: str, most: int, item: Callable[[Any, str], Item]
) -> list[Item]:
    """Read a list, entry by entry."""
    if not isinstance(given, list) or len(given) > most:
        refuse(place, f"a list of at most {most:,} entries")
    return [item(one, f"{place}[{number}]") for number, one in enumerate(given)]


def text(given: object, place: str) -> str:
    """Read a short text, which is made harmless."""
    if not isinstance(given, str) or len(given) > 200:
        refuse(place, "a text of at most 200 characters")
    return one_line(given)


def words(given: object, place: str) -> str:
    """Read what a check said, which is made harmless and cut if it is long."""
    if not isinstance(given, str):
        refuse(place, "a text")
    return one_line(given, LONGEST)


def flag(given: object, place: str) -> bool:
    """Read a truth value."""
    if not isinstance(given, bool):
        refuse(place, "true or false")
    return given


def real(given: object, place: str) -> float:
    """Read a number that float32 has room for."""
    if isinstance(given, bool) or not isinstance(given, int | float):
        refuse(place, "a number")
    if not abs(given) <= FLOAT_MAX:
        refuse(place, "a number within float32")
    return float(given)


def whole(given: object, place: str, most: int) -> int:
    """Read a number from 0 to a limit."""
    if isinstance(given, bool) or not isinstance(given, int) or not 0 <= given <= most:
        refuse(place, f"a whole number from 0 to {most:,}")
    return given


def triple(given: object, place: str) -> list[float]:
    """Read three numbers."""
    numbers = listed(given, place, 3, real)
    return numbers if len(numbers) == 3 else refuse(place, "three numbers")


def mesh(given: object, place: str) -> Mesh:
    """Read a mesh."""
    fields = keys(given, {"vertices", "faces"}, place)
    vertices = listed(fields["vertices"], f"{place}.vertices", MOST_VERTICES, triple)

    def corner(one: object, where: str) -> int:
        return whole(one, where, len(vertices) - 1)

    def face(one: object, where: str) -> list[int]:
        corners = listed(one, where, 3, corner)
        return corners if len(corners) == 3 else refuse(where, "three vertices")

    faces = listed(fields["faces"], f"{place}.faces", MOST_FACES, face)
    return Mesh(_floats(vertices), np.array(faces, np.uint32).reshape(-1, 3))


def tree(given: object, place: str) -> Bvh:
    """Read a tree; nodes that are not named are empty slots."""
    fields = keys(given, {"count", "nodes", "face_indices"}, place)
    count = whole(fields["count"], f"{place}.count", MOST_NODES)
    low = np.full((count, 3), np.inf, np.float32)
    high, span = -low, np.zeros((2, count), np.uint32)

    def entry(one: object, where: str) -> int:
        return whole(one, where, MOST_FACES)

    def node(one: object, where: str) -> None:
        named = keys(one, {"index", "low", "high", "faces"}, where)
        index = whole(named["index"], f"{where}.index", count - 1)
        low[index], high[index] = triple(named["low"], where), triple(named["high"], where)
        held = listed(named["faces"], f"{where}.faces", 2, entry)
        span[:, index] = held if len(held) == 2 else refuse(where, "a range of two numbers")

    listed(fields["nodes"], f"{place}.nodes", MOST_USED, node)
    order: Indices = np.array(
        listed(fields["face_indices"], f"{place}.face_indices", MOST_FACES, entry), np.uint32
    )
    return Bvh(low, high, span[0].copy(), span[1].copy(), order, count)


def fitting(one: Bvh, of: Mesh) -> None:
    """Refuse a tree whose ranges or face indices lie outside of its mesh."""
    faces = len(of.faces)
    ranges = (one.begin <= one.end).all() and (one.end <= faces).all()
    if not (len(one.end) and one.end[0] and len(one.order) == faces and ranges):
        refuse("a tree", "one over all faces of its mesh")
    if (np.sort(one.order) != np.arange(faces)).any():
        refuse("face_indices", "a permutation of the faces")


def ray(given: object, place: str) -> tuple[list[float], str]:
    """Read a ray and the name of its family; a t_max of null is infinite."""
    fields = keys(given, {"origin", "direction", "t_min", "t_max", "family"}, place)
    far = fields["t_max"]
    limits = [
        real(fields["t_min"], f"{place}.t_min"),
        math.inf if far is None else real(far, f"{place}.t_max"),
    ]
    origin = triple(fields["origin"], f"{place}.origin")
    direction = triple(fields["direction"], f"{place}.direction")
    return [*origin, *direction, *limits], text(fields["family"], f"{place}.family")


def _floats(rows: list[list[float]]) -> Floats:
    return np.array(rows, np.float32).reshape(-1, 3)
