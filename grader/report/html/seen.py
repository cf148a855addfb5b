"""How do pictures and models get into a page? As texts of ours around packed data."""

import re
from collections.abc import Mapping, Sequence
from typing import Any

from grader.errors import OutputFault
from grader.language import Words
from grader.plain import one_line
from grader.report.colours import HEAT, MAGMA
from grader.report.counts import counted
from grader.report.views import MOST_PACKED

Json = Mapping[str, Any]

_BASE64 = re.compile(r"[A-Za-z0-9+/]*={0,2}")

STOPS = 12
"""Colours of a legend; between them a browser interpolates."""


def packed(text: str) -> str:
    """Return base64 as it is.

    Raises:
        OutputFault: It is something else, which a page would have to escape.
    """
    if not _BASE64.fullmatch(text):
        raise OutputFault("views.json holds an image or a mesh that is not base64.")
    return text


def pictures(views: Json, passed: bool, words: Words) -> list[dict[str, object]]:
    """Describe each scene's pictures, those with mistakes first.

    Args:
        views: Values of a `views.json`.
        passed: True if the check of pictures allows the pixels that are wrong in them.
        words: Translates.
    """
    most_wrong = sorted(views["pictures"], key=lambda one: not one.get("wrong"))
    made = [_picture(one, words) for one in most_wrong]
    for one in made:
        if one["wrong"] and passed:
            told = words("They are few enough to pass.")
            one |= {"summary": f"{one['summary']} {told}"}
        one["sign"] = "fail" if one["wrong"] and not passed else "pass"
    return made


def _picture(one: Json, words: Words) -> dict[str, object]:
    from markupsafe import Markup

    title = words(one_line(one["title"]))
    images = {
        # Base64 needs no escaping, and is longer than any text is allowed to be.
        name: Markup("data:image/webp;base64," + packed(data))  # noqa: S704 - checked
        for name, data in one["images"].items()
    }
    told = {"title": title, "width": one["width"], "height": one["height"], "images": images}
    if "yours" not in images:
        told |= {"summary": words("Your program brought no picture of this scene.")}
        return told | {"drawn": False, "wrong": None, "without_shadows": False}
    return told | _drawn(one, words)


def _drawn(one: Json, words: Words) -> dict[str, object]:
    boxes, triangles = one["cost_mean"]
    cost = words("On average {boxes} box tests and {triangles} triangle tests per ray.")
    return {
        "drawn": True,
        "summary": _summary(one, words),
        "wrong": one["wrong"],
        "ring": _ring(one),
        "without_shadows": one["without_shadows"],
        "error": words("Mean error: {error}.").format(error=f"{one['flip']:.4f}"),
        "scale": one["cost_scale"],
        "cost": cost.format(boxes=f"{boxes:.1f}", triangles=f"{triangles:.1f}"),
    }


def _summary(one: Json, words: Words) -> str:
    if not one["wrong"]:
        return words("All {pixels} pixels agree with Mitsuba's picture.").format(
            pixels=counted(one["pixels"], words)
        )
    told = words("{wrong} of {pixels} pixels differ, the first in column {x}, row {y}.")
    column, row = one["first_wrong"] or (0, 0)
    wrong, pixels = (counted(one[key], words) for key in ("wrong", "pixels"))
    return told.format(wrong=wrong, pixels=pixels, x=column, y=row)


def _ring(one: Json) -> dict[str, float] | None:
    """Where a ring leads the eye to the first wrong pixel, if few are wrong."""
    if not one["first_wrong"] or one["wrong"] > one["pixels"] // 100:
        return None
    column, row = one["first_wrong"]
    return {"x": column + 0.5, "y": row + 0.5, "r": one["width"] / 28}


def legends() -> dict[str, list[tuple[int, str]]]:
    """Return the colours of both scales: percent of the way and colour."""
    places = [round(255 * stop / (STOPS - 1)) for stop in range(STOPS)]
    return {
        name: [
            (round(100 * place / 255), "#" + bytes(table[place].tolist()).hex())
            for place in places
        ]
        for name, table in (("difference", MAGMA), ("cost", HEAT))
    }


def models(views: Json, words: Words, told: Words = str) -> list[dict[str, object]]:
    """Copy models for the script, with a name for each.

    Raises:
        OutputFault: They are too much for a page.
    """
    made = [_model(one, words, told) for one in views["models"]]
    total = sum(len(text) for one in views["models"] for text in _data(one))
    total += sum(len(text) for one in views["pictures"] for text in one["images"].values())
    if total > MOST_PACKED:
        message = f"views.json packs {total:,} characters; a page takes {MOST_PACKED:,}."
        raise OutputFault(message)
    return made


def _data(model: Json) -> Sequence[str]:
    return packed(model["mesh"]["data"]), packed(model["boxes"]["data"])


def _model(one: Json, words: Words, told: Words) -> dict[str, object]:
    ray = one["ray"]
    return {
        **{key: one[key] for key in ("faces", "node", "expected_box", "marked")},
        **{key: dict(one[key]) for key in ("mesh", "boxes")},
        "name": _name(one, words),
        "ray": None if ray is None else {**ray, "sentence": told(one_line(ray["sentence"]))},
    }


def _name(one: Json, words: Words) -> str:
    faces = words("{faces} faces").format(faces=counted(one["faces"], words))
    if one["check"]:
        return words("{check}: smallest example, {faces}").format(
            check=one_line(one["check"]), faces=faces
        )
    return f"{words(one_line(one['title']))}, {faces}"
