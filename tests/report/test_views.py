"""What `views.json` holds can be decoded to what was seen, and never is too large."""

import base64
import io
import json
import zlib
from dataclasses import replace
from typing import cast

import numpy as np
import pytest
from PIL import Image

from grader.model.mesh import Bytes, Mesh
from grader.model.views import Views
from grader.report import views as module
from grader.report.as_json import to_json as as_json
from grader.report.html.submission import to_html
from grader.report.views import to_json, to_text
from tests.gallery.shown import SIDE, model, picture
from tests.report import samples
from tests.report.small_inputs import small
from tests.verify.builder import soup


def decoded(text: str) -> Bytes:
    """Open a picture of the file."""
    return np.asarray(Image.open(io.BytesIO(base64.b64decode(text))))


def test_pictures_come_back_bit_by_bit() -> None:
    """Mitsuba's picture with the submission's over it is the submission's picture."""
    given = picture("wall", wrong_pixel=(30, 60))
    (made,) = to_json(Views((given,), ()))["pictures"]
    reference, over = decoded(made["images"]["reference"]), decoded(made["images"]["yours"])
    assert given.drawing is not None
    assert (reference == given.reference).all()
    seen = np.where(over[..., 3:] > 0, over[..., :3], reference)
    assert (seen == given.drawing.yours).all()
    assert made["wrong"] == 1
    assert made["first_wrong"] == [30, 60]
    assert made["cost_scale"] == 7
    assert made["cost_mean"] == [5.0, 2.0]


def test_a_scene_without_a_submission_shows_mitsubas_picture() -> None:
    """Nothing is claimed of a picture that is not there."""
    (made,) = to_json(Views((replace(picture("wall"), drawing=None),), ()))["pictures"]
    assert set(made["images"]) == {"reference"}
    assert "wrong" not in made


def test_too_many_pictures_become_smaller_but_not_the_wrong_one(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The scene with a mistake keeps its pixels, others lose theirs first."""
    given = (picture("a"), picture("b", wrong_pixel=(0, 0)), picture("c"))
    monkeypatch.setattr(module, "LARGEST", 300_000)
    made = to_json(Views(given, ()))["pictures"]
    sides = [len(decoded(one["images"]["reference"])) for one in made]
    assert sides == [SIDE // 2, SIDE, SIDE // 2]
    assert [one["width"] for one in made] == [SIDE] * 3


def test_a_hole_of_one_pixel_is_seen_in_a_smaller_picture(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Of four pixels that become one the worst is shown."""
    monkeypatch.setattr(module, "LARGEST", 1_000)
    (made,) = to_json(Views((picture("wall", wrong_pixel=(31, 61)),), ()))["pictures"]
    difference = decoded(made["images"]["difference"])
    side = len(difference)
    assert side < SIDE
    lit = np.argwhere(difference.max(axis=2) > 100)
    step = SIDE // side
    assert lit.tolist() == [[61 // step, 31 // step]]


def test_a_mesh_comes_back_within_its_grid() -> None:
    """Places are rounded to 65,535 steps along each side; faces are exact."""
    mesh = soup(40)
    (made,) = to_json(Views((), (model(mesh),)))["models"]
    packed = zlib.decompress(base64.b64decode(made["mesh"]["data"]))
    count = made["mesh"]["vertices"]
    places = np.frombuffer(packed, "<u2", 3 * count).reshape(-1, 3)
    faces = np.frombuffer(packed, "<u4", offset=6 * count).reshape(-1, 3)
    low, high = np.array(made["mesh"]["low"]), np.array(made["mesh"]["high"])
    back = low + places / 65535 * (high - low)
    assert np.abs(back - mesh.vertices).max() <= (high - low).max() / 65535
    assert (faces == mesh.faces).all()


def crowded_views(scenes: int) -> Views:
    """Make 27 inputs of checks, and so many pictures, of which the last has a mistake."""
    pictures = [picture(f"{k}") for k in range(scenes - 1)]
    sizes = (1000, 20, *[900] * 25)
    inputs = [replace(model(soup(faces)), check=f"c{faces}") for faces in sizes]
    scene = replace(model(soup(2000)), check="")
    return Views((*pictures, picture("wall", (0, 0))), (*inputs, scene))


def test_the_largest_inputs_that_a_page_cannot_take_are_left_out() -> None:
    """Pictures, the scene and small inputs stay, and the page can be written."""
    views = to_json(crowded_views(scenes=2))
    left = [one["check"] for one in views["models"]]
    assert (left[0], left[-1], len(views["pictures"])) == ("c20", None, 2)
    assert 10 < left.count("c900") < 25
    assert to_html(as_json(samples.failing()), views, "en")


def test_pictures_that_a_page_cannot_take_are_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    """As with many scenes that cannot be halved; the one with a mistake stays."""
    monkeypatch.setattr(module, "SMALLEST", SIDE)
    views = to_json(crowded_views(scenes=8))
    assert [one["check"] for one in views["models"]] == [None]
    assert (len(views["pictures"]), views["pictures"][-1]["scene"]) == (5, "wall")
    assert to_html(as_json(samples.failing()), views, "en")


def test_boxes_and_the_ray_are_told() -> None:
    """Empty slots are NaN in the bytes; what JSON lacks is null."""
    (made,) = to_json(Views((), (model(soup(5)),)))["models"]
    boxes = np.frombuffer(zlib.decompress(base64.b64decode(made["boxes"]["data"])), "<f4")
    assert boxes[:6].tolist() == [0, 0, 0, 1, 1, 1]
    assert np.isnan(boxes[6:]).all()
    assert made["marked"] == [1, 2, 4, 1]
    assert made["node"] == 0
    assert made["ray"]["t_max"] is None
    assert made["ray"]["expected_t"] is None
    assert made["ray"]["got_t"] == 2.5
    assert [step["face"] for step in made["ray"]["steps"]] == [None, 2]


def test_a_small_tree_is_told_node_by_node() -> None:
    """With the node in which it differs first."""
    table = small().table
    assert table is not None
    (made,) = to_json(Views((), (), (("bvh.boxes-are-tight", table),)))["tables"]
    assert made["check"] == "bvh.boxes-are-tight"
    assert made["columns"][1] == [1, "[0,9)", "[0,9)"]
    assert made["first_difference"] == 1
    assert made["got_faces"] == "0 4 | 1 2 3"


def test_a_mesh_without_faces_can_be_told() -> None:
    """The smallest example of a crash may be empty."""
    empty = Mesh(np.zeros((0, 3), np.float32), np.zeros((0, 3), np.uint32))
    (made,) = to_json(Views((), (replace(model(empty), marked=np.zeros(0, np.int64)),)))[
        "models"
    ]
    assert made["mesh"]["vertices"] == 0
    assert made["mesh"]["low"] == made["mesh"]["high"] == [0.0, 0.0, 0.0]
    assert made["marked"] == []


def test_numbers_of_numpy_are_written() -> None:
    """Arithmetic leaves them behind where nobody looks."""
    given = picture("wall", wrong_pixel=(1, 1))
    assert given.drawing is not None
    drawn = replace(given.drawing, flip=cast("float", np.float32(0.25)))
    views = Views((replace(given, drawing=drawn),), ())
    assert to_text(views) == to_text(Views((given,), ()))


def test_the_text_is_strict_json_and_the_same_twice() -> None:
    """No NaN, no measured time, no random order."""
    views = Views((picture("wall", wrong_pixel=(1, 1)),), (model(soup(9)),))
    assert to_text(views) == to_text(views)
    assert json.loads(to_text(views))["schema"] == 1
