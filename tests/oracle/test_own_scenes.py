"""A course's own scenes are used beside the shipped ones, and never with a stale picture."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from grader.errors import OracleFault, UsageError
from grader.model.mesh import Bvh, Mesh
from grader.model.scene import Reference
from grader.oracle import render as renderer
from grader.oracle import scenes as module
from grader.oracle.album import list_scenes, render_scenes
from grader.oracle.exr import read_reference, write_reference
from grader.oracle.plan import _kept_pictures
from grader.oracle.scenes import (
    image_trials,
    load_mesh,
    load_reference,
    reference_path,
    scene_named,
    scenes_sha256,
    usable_reference,
)
from grader.oracle.variant import Variant
from tests.oracle.own import TOML, own_folder
from tests.oracle.treebuilder import tree_of


def trees(meshes: Sequence[Mesh]) -> list[Bvh]:
    """Build trees over meshes."""
    return [tree_of(mesh) for mesh in meshes]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Make an own folder, with a cache of its own and the renderer that always works."""
    monkeypatch.setenv("BVHGRADE_CACHE", str(tmp_path / "cache"))
    scalar = Variant("scalar_rgb", None, "always works")
    monkeypatch.setattr("grader.oracle.variant.working_variant", lambda: scalar)
    return own_folder(tmp_path)


@pytest.fixture
def rendered(folder: Path) -> Path:
    """Make an own folder with references."""
    render_scenes((), lambda _: None, folder)
    return folder


def edited(folder: Path, old: str, new: str) -> None:
    """Change a line of the folder's description."""
    path = folder / "scenes.toml"
    before = path.read_text(encoding="utf-8")
    assert old in before
    path.write_text(before.replace(old, new), encoding="utf-8")


def without_mitsuba(monkeypatch: pytest.MonkeyPatch) -> None:
    """Pretend that Mitsuba is not installed."""
    monkeypatch.setattr(renderer, "mitsuba_version", lambda: None)


def test_what_was_rendered_is_graded(rendered: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each scene becomes a trial with its size, weight and visibility, without Mitsuba."""
    without_mitsuba(monkeypatch)
    few, made = image_trials(trees, rendered)
    assert (few.name, few.width, few.height, few.weight, few.shown) == (
        "our-few", 16, 20, 2.5, False,
    )  # fmt: skip
    assert (made.name, made.weight, made.shown) == ("our-made", 1.0, True)
    assert np.isfinite(few.mitsuba_t).any()
    assert [status.problem for status in list_scenes(rendered)] == ["", ""]


def test_weight_and_visibility_leave_a_picture_fresh(rendered: Path) -> None:
    """They say nothing of what is to be seen, nor does the title."""
    edited(rendered, 'weight = 2.5\nvisibility = "hidden"', "weight = 4")
    edited(rendered, "a few triangles", "not many")
    assert [status.problem for status in list_scenes(rendered)] == ["", ""]


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("fov = 30", "fov = 31"),
        ("light = [0.0", "light = [0.5"),
        ("albedo = [0.5", "albedo = [0.6"),
        ("width = 16", "width = 17"),
    ],
)
def test_a_stale_picture_is_refused_or_rendered_anew(
    rendered: Path, monkeypatch: pytest.MonkeyPatch, old: str, new: str
) -> None:
    """Without Mitsuba the sentence says what to do; with it, the cache gets another picture."""
    edited(rendered, old, new)
    assert "was rendered of scene" in list_scenes(rendered)[0].problem
    scene = scene_named("our-few", rendered)
    mesh = load_mesh("few", rendered)
    with monkeypatch.context() as patch:
        without_mitsuba(patch)
        with pytest.raises(OracleFault, match=r"render our-few --scenes .* pip install"):
            usable_reference(scene, mesh, rendered)
    before = reference_path("our-few", rendered).read_bytes()
    fresh = usable_reference(scene, mesh, rendered)
    assert fresh.t.size == scene.width * scene.height
    assert fresh.key == usable_reference(scene, mesh, rendered).key
    assert reference_path("our-few", rendered).read_bytes() == before


def test_a_picture_is_rendered_once_for_the_cache(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The second grade reads it, bit by bit the same."""
    scene, mesh = scene_named("our-few", folder), load_mesh("few", folder)
    first = usable_reference(scene, mesh, folder)

    def asked(*_: object) -> Reference:
        raise AssertionError

    monkeypatch.setattr(renderer, "render", asked)
    again = usable_reference(scene, mesh, folder)
    assert again.t.tobytes() == first.t.tobytes()
    assert again.made_with == first.made_with


@pytest.mark.parametrize(
    ("version", "trusted"),
    [("3.9.0", True), ("3.10.2", True), ("3.8.9", False), ("4.0.0", False), ("unknown", False)],
)
def test_a_picture_by_another_mitsuba_is_refused(
    rendered: Path, version: str, trusted: bool
) -> None:
    """On every machine alike, whatever is installed there."""
    scene, mesh = scene_named("our-few", rendered), load_mesh("few", rendered)
    picture = load_reference(scene, mesh, rendered)
    path = rendered / "other.exr"
    write_reference(path, scene, replace(picture, made_with=(("mitsuba", version),)))
    if trusted:
        read_reference(path, scene, mesh, "again")
    else:
        with pytest.raises(OracleFault, match=f"rendered by Mitsuba {version}, but only 3.9"):
            read_reference(path, scene, mesh, "again")


@pytest.mark.parametrize("kind", ["few.npz", "generator soup"])
def test_another_mesh_is_refused_with_its_hash(folder: Path, kind: str) -> None:
    """The sentence names the table, and what to write if the change is meant."""
    name = "few" if kind == "few.npz" else "made"
    sha256 = TOML.split('sha256 = "')[1][:64]
    edited(folder, sha256, "0" * 64)
    expected = rf'\[\[mesh\]\] {name}: sha256 is 0{{12}}, but {kind} .* sha256 = "{sha256}"'
    with pytest.raises(OracleFault, match=expected):
        load_mesh(name, folder)
    assert "few.npz" in list_scenes(folder)[0].problem


def test_the_hash_covers_an_own_folder(rendered: Path) -> None:
    """Description, mesh and picture; a missing picture counts as well."""
    seen = [scenes_sha256(), scenes_sha256(rendered)]
    edited(rendered, "weight = 2.5", "weight = 2")
    seen.append(scenes_sha256(rendered))
    reference_path("our-few", rendered).unlink()
    seen.append(scenes_sha256(rendered))
    (rendered / "few.npz").write_bytes(b"other")
    seen.append(scenes_sha256(rendered))
    assert len(set(seen)) == 5


def test_kept_pictures_belong_to_what_lies_in_the_folder(
    rendered: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """They are read back until a file changes, and then are made again."""
    _kept_pictures(trees, "these", rendered)
    with monkeypatch.context() as patch:
        patch.setattr(module, "load_reference", None)
        few, _ = _kept_pictures(trees, "these", rendered)
        assert few.weight == 2.5
    edited(rendered, "weight = 2.5", "weight = 3")
    few, _ = _kept_pictures(trees, "these", rendered)
    assert few.weight == 3


def test_an_unknown_own_scene_is_named(folder: Path) -> None:
    """Only scenes of this folder are offered."""
    with pytest.raises(UsageError, match="there are our-few, our-made"):
        scene_named("dragon", folder)
