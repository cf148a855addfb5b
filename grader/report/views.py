"""How do pictures and models become `views.json`, which a report is made from?

Pictures are lossless WebP: a wrong pixel must not be invented or lost by the encoding. What a
submission sees as Mitsuba does is transparent in its picture, which lies over Mitsuba's.
Scenes are halved, those without a mistake first, until all fit into `LARGEST`. What a page
cannot take even then is left out.
"""

import base64
import io
import json
import zlib
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np

from grader.model.counterexample import NodeTable
from grader.model.mesh import Bytes, Floats, Integers
from grader.model.views import Drawing, Model, Picture, ShownRay, Views
from grader.report.colours import HEAT, MAGMA
from grader.report.escape import plain_number

Json = dict[str, Any]

SCHEMA_VERSION = 1

LARGEST = 330_000
"""Bytes of all pictures together, as text. With a mesh of 20,000 faces a report stays below
600,000."""

MOST_PACKED = 900_000
"""Characters of packed data that a page takes; a browser gets slow, and mail refuses it."""

ENCODERS = 2
"""Pictures that are encoded at the same time."""

SMALLEST = 96
"""Pixels of a picture's longer side below which it is not halved."""

BRIGHTEST = 99
"""Percentile of the cost of a ray at the bright end of the scale: a few rays cost ten times
as much as all others."""


def to_text(views: Views) -> str:
    """Write views as the text of `views.json`."""
    values, marks = to_json(views), (",", ":")
    return json.dumps(values, separators=marks, allow_nan=False, default=plain_number) + "\n"


def to_json(views: Views) -> Json:
    """Turn views into the values of `views.json`."""
    models = [model_json(one) for one in views.models]
    pictures, models = _fitted(_pictures(views.pictures), models)
    return {
        "schema": SCHEMA_VERSION,
        "pictures": pictures,
        "models": models,
        "tables": [_table(check, table) for check, table in views.tables],
    }


def _fitted(pictures: list[Json], models: list[Json]) -> tuple[list[Json], list[Json]]:
    """Leave out what a page cannot take: inputs of checks first, then pictures, then scenes."""
    while sum(map(packed_size, (*pictures, *models))) > MOST_PACKED:
        inputs = [one for one in models if one["check"]]
        dropped = max(
            inputs or pictures or models,
            key=lambda one: (not one.get("wrong"), packed_size(one)),
        )
        pictures = [one for one in pictures if one is not dropped]
        models = [one for one in models if one is not dropped]
    return pictures, models


def packed_size(one: Json) -> int:
    """Return the characters of packed data in a picture or a model."""
    if "images" in one:
        return _size(one)
    return len(one["mesh"]["data"]) + len(one["boxes"]["data"])


def _table(check: str, table: NodeTable) -> Json:
    """Write a small tree as the sheet's figure shows one."""
    return {
        "check": check,
        "columns": [[one.node, one.expected, one.got] for one in table.columns],
        "expected_faces": table.expected_faces,
        "got_faces": table.got_faces,
        "first_difference": table.first_difference,
    }


def _pictures(given: tuple[Picture, ...]) -> list[Json]:
    """Encode pictures, as large as there is room for."""
    steps = [1] * len(given)
    # Encoding lets other threads run, and takes longest for the large ones.
    with ThreadPoolExecutor(ENCODERS) as pool:
        made = list(pool.map(lambda one: _picture(one, 1), given))
    while sum(map(_size, made)) > LARGEST:
        able = [place for place, one in enumerate(given) if _side(one, steps[place]) > SMALLEST]
        if not able:
            break
        place = max(able, key=lambda one: (not _is_wrong(given[one]), _size(made[one])))
        steps[place] *= 2
        made[place] = _picture(given[place], steps[place])
    return made


def _side(picture: Picture, step: int) -> int:
    height, width, _ = picture.reference.shape
    return int(max(height, width)) // step


def _is_wrong(picture: Picture) -> bool:
    return picture.drawing is not None and bool(picture.drawing.wrong.any())


def _size(picture: Json) -> int:
    return sum(len(text or "") for text in picture["images"].values())


def _picture(given: Picture, step: int) -> Json:
    """Encode a picture, one of so many rows and columns."""
    height, width = given.reference.shape[:2]
    drawn = given.drawing
    told: Json = {
        "scene": given.scene,
        "title": given.title,
        "width": width,
        "height": height,
        "pixels": width * height,
        "images": {"reference": _webp(given.reference[::step, ::step])},
    }
    return told if drawn is None else told | _drawn(given, drawn, step)


def _drawn(given: Picture, drawn: Drawing, step: int) -> Json:
    scale = max(1, int(np.percentile(drawn.tests, BRIGHTEST)))
    rows, columns = np.nonzero(drawn.wrong)
    small = slice(None, None, step), slice(None, None, step)
    cost = np.minimum(255 * drawn.tests[small] // scale, 255) & 0xFC
    return {
        "wrong": int(rows.size),
        "first_wrong": [int(columns[0]), int(rows[0])] if rows.size else None,
        "flip": round(drawn.flip, 6),
        "cost_scale": scale,
        "cost_mean": [round(drawn.box_tests, 2), round(drawn.triangle_tests, 2)],
        "without_shadows": drawn.without_shadows,
        "images": {
            "reference": _webp(given.reference[small]),
            "yours": _webp(_overlay(drawn.yours[small], given.reference[small])),
            "difference": _webp(MAGMA[_largest(drawn.difference, step) & 0xFC]),
            "cost": _webp(HEAT[cost]),
        },
    }


def _overlay(yours: Bytes, reference: Bytes) -> Bytes:
    """Return (H, W, 4) uint8, transparent where both are the same."""
    apart = (yours != reference).any(axis=2, keepdims=True)
    return np.concatenate([yours * apart, apart * np.uint8(255)], axis=2)


def _largest(error: Bytes, step: int) -> Bytes:
    """Make a picture smaller without losing a hole of one pixel."""
    height, width = (side // step * step for side in error.shape)
    blocks = error[:height, :width].reshape(height // step, step, width // step, step)
    return np.asarray(blocks.max(axis=(1, 3)))


def _webp(pixels: Bytes) -> str:
    """Encode (H, W, 3) or (H, W, 4) uint8 without loss."""
    from PIL import Image

    made = io.BytesIO()
    Image.fromarray(np.ascontiguousarray(pixels)).save(
        made, "WEBP", lossless=True, quality=40, method=2
    )
    return base64.b64encode(made.getvalue()).decode("ascii")


def model_json(given: Model) -> Json:
    """Write a model: positions as 16-bit numbers, packed."""
    vertices = given.mesh.vertices.astype(np.float64)
    corners_of_all = vertices if len(vertices) else np.zeros((1, 3))
    low, size = corners_of_all.min(axis=0), np.ptp(corners_of_all, axis=0)
    places = np.rint((vertices - low) / np.where(size > 0, size, 1.0) * 65535).astype("<u2")
    packed = zlib.compress(places.tobytes() + given.mesh.faces.astype("<u4").tobytes(), 9)
    corners = np.concatenate([given.low, given.high], axis=1).astype("<f4")
    return {
        "check": given.check or None,
        "title": given.title,
        "faces": given.faces,
        "mesh": {
            "vertices": len(vertices),
            "faces": len(given.mesh.faces),
            "low": _numbers(low),
            "high": _numbers(low + size),
            "data": base64.b64encode(packed).decode("ascii"),
        },
        "boxes": {
            "count": len(corners),
            "data": base64.b64encode(zlib.compress(corners.tobytes(), 9)).decode("ascii"),
        },
        "node": given.node if given.node >= 0 else None,
        "expected_box": _numbers(np.array(given.right_box)) if given.right_box else None,
        "marked": runs(given.marked),
        "ray": None if given.ray is None else ray_json(given.ray),
    }


def runs(faces: Integers) -> list[int]:
    """Write (K,) int64 faces as pairs: where a run begins, and how long it is."""
    faces = np.unique(faces)
    starts = np.flatnonzero(np.diff(faces, prepend=-2) != 1)
    lengths = np.diff(starts, append=faces.size)
    return np.stack([faces[starts], lengths], axis=1).ravel().tolist()


def ray_json(given: ShownRay) -> Json:
    """Write a ray and its steps."""
    return {
        "origin": _numbers(np.array(given.origin)),
        "direction": _numbers(np.array(given.direction)),
        "t_min": _finite(given.t_min),
        "t_max": _finite(given.t_max),
        "expected_t": _finite(given.expected),
        "got_t": _finite(given.got),
        "face": given.face if given.face >= 0 else None,
        "lost": given.lost if given.lost >= 0 else None,
        "sentence": given.sentence,
        "steps": [
            {
                "node": step.node if step.node >= 0 else None,
                "face": step.face if step.face >= 0 else None,
                "hit": step.hit,
                "t_max": _finite(step.t_max),
            }
            for step in given.steps
        ],
    }


def _numbers(values: Floats | np.ndarray) -> list[float | None]:
    return [_finite(value) for value in np.asarray(values).tolist()]


def _finite(value: float) -> float | None:
    """Write what JSON cannot carry as null; float32 needs nine digits."""
    return float(f"{value:.9g}") if np.isfinite(value) else None
