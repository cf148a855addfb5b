"""The answers stored beside the pictures are the rule's, and are never trusted blindly."""

from collections.abc import Callable
from dataclasses import fields, replace
from pathlib import Path

import numpy as np
import pytest

from grader.errors import OutputFault
from grader.model.mesh import WILD, Answers, Bvh, Integers, Mesh
from grader.model.scene import Reference
from grader.oracle import album, scenes, shipped
from grader.oracle.balanced import balanced_tree
from grader.oracle.brute import RULE_VERSION, answers, chosen
from grader.oracle.shipped import (
    computed_answers,
    deflated,
    picture_answers,
    read_answers,
    write_answers,
)
from tests.oracle.treebuilder import tree_of

SAMPLE = 2000
"""Pixels of the dragon that are asked again."""


def stored(name: str) -> tuple[Mesh, Reference]:
    """Load mesh and picture of a scene."""
    scene = scenes.scene_named(name)
    mesh = scenes.load_mesh(scene.mesh)
    return mesh, scenes.load_reference(scene, mesh)


def require_same(one: Answers | None, two: Answers) -> None:
    """Compare every array bit by bit, with type and shape."""
    assert one is not None
    for field in fields(Answers):
        first, second = getattr(one, field.name), getattr(two, field.name)
        assert (first.dtype, first.shape) == (second.dtype, second.shape), field.name
        assert first.tobytes() == second.tobytes(), field.name


def taken(found: Answers, which: Integers) -> Answers:
    """Return the answers of some of the rays."""
    counts = np.diff(found.first)[which]
    places = [np.arange(found.first[ray], found.first[ray + 1]) for ray in which]
    place = np.concatenate(places)
    return Answers(
        limit=found.limit[which],
        first=np.concatenate([[0], np.cumsum(counts)]),
        face=found.face[place],
        t=found.t[place],
        tolerance=found.tolerance[place],
        kind=found.kind[place],
    )


@pytest.fixture(scope="module")
def small() -> tuple[Mesh, Bvh, Reference]:
    """A thousand pixels of the nested spheres, of which many hit."""
    mesh, picture = stored("nested")
    rays = chosen(picture.rays, np.arange(0, picture.t.size, 61))
    return mesh, balanced_tree(mesh), replace(picture, rays=rays, t=picture.t[::61])


@pytest.mark.parametrize("name", ["grid", "nested"])
def test_the_rule_gives_what_is_stored(name: str) -> None:
    """All pixels of the small pictures, asked with a tree of another shape."""
    mesh, picture = stored(name)
    found = read_answers(scenes.answers_path(name), picture)
    require_same(found, computed_answers(mesh, tree_of(mesh), picture))


def test_the_rule_gives_what_is_stored_of_the_dragon() -> None:
    """Pixels drawn at random, asked without a guess of the closest hit."""
    mesh, picture = stored("dragon")
    found = read_answers(scenes.answers_path("dragon"), picture)
    assert found is not None
    drawn = np.random.default_rng(20).choice(picture.t.size, SAMPLE, replace=False)
    again = answers(mesh, chosen(picture.rays, drawn), balanced_tree(mesh))
    require_same(taken(found, drawn), again)


def test_answers_survive_storing(tmp_path: Path, small: tuple[Mesh, Bvh, Reference]) -> None:
    """Also where the rule has no number, and where a pixel has 300 candidates."""
    mesh, tree, picture = small
    true = computed_answers(mesh, tree, picture)
    many = replace(
        true,
        limit=np.full(picture.t.size, np.inf),
        first=np.concatenate([[0], np.full(picture.t.size, 300)]),
        face=np.arange(300) + 2**31,
        t=np.full(300, np.nan),
        tolerance=np.full(300, np.inf),
        kind=np.full(300, WILD, dtype=np.uint8),
    )
    for found in (true, many):
        write_answers(tmp_path / "some.answers", picture, found)
        require_same(read_answers(tmp_path / "some.answers", picture), found)


def empty(_: bytes) -> bytes:
    """Leave nothing."""
    return b""


def cut(content: bytes) -> bytes:
    """End early."""
    return content[: len(content) // 2]


def flipped(content: bytes) -> bytes:
    """Turn one bit."""
    middle = len(content) // 2
    return content[:middle] + bytes([content[middle] ^ 1]) + content[middle + 1 :]


def foreign(_: bytes) -> bytes:
    """Whole, but not a file of answers."""
    return deflated({"t": np.zeros(3)})


def other_pictures(_: bytes) -> bytes:
    """Whole, but of another picture."""
    return scenes.answers_path("grid").read_bytes()


@pytest.mark.parametrize("damage", [None, empty, cut, flipped, foreign, other_pictures])
def test_a_wrong_file_costs_only_time(
    tmp_path: Path,
    small: tuple[Mesh, Bvh, Reference],
    damage: Callable[[bytes], bytes] | None,
) -> None:
    """Without a file, or with one that is damaged or foreign, the rule is asked."""
    mesh, tree, picture = small
    path = tmp_path / "small.answers"
    true = computed_answers(mesh, tree, picture)
    if damage:
        write_answers(path, picture, true)
        path.write_bytes(damage(path.read_bytes()))
    assert read_answers(path, picture) is None
    require_same(picture_answers(path, mesh, tree, picture), true)


def test_a_stored_file_is_used(tmp_path: Path, small: tuple[Mesh, Bvh, Reference]) -> None:
    """What the file says is returned, even where the rule would say otherwise."""
    mesh, tree, picture = small
    true = computed_answers(mesh, tree, picture)
    write_answers(tmp_path / "a", picture, replace(true, face=true.face + 1))
    found = picture_answers(tmp_path / "a", mesh, tree, picture)
    assert np.array_equal(found.face, true.face + 1)


def test_the_stored_files_spare_the_rule(monkeypatch: pytest.MonkeyPatch) -> None:
    """The pictures of a grade are prepared without asking it, and without a tree."""

    def asked(*_: object) -> Answers:
        raise AssertionError

    monkeypatch.setattr(shipped, "answers", asked)
    no_tree = balanced_tree(Mesh(np.zeros((0, 3), np.float32), np.zeros((0, 3), np.uint32)))
    trials = scenes.image_trials(lambda meshes: [no_tree] * len(meshes))
    assert [trial.name for trial in trials] == [scene.name for scene in scenes.scenes()]


def test_answers_belong_to_one_picture_and_one_rule(
    tmp_path: Path, small: tuple[Mesh, Bvh, Reference], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Another key, other rays, another version or another layout make a file stale."""
    mesh, tree, picture = small
    path = tmp_path / "small.answers"
    write_answers(path, picture, computed_answers(mesh, tree, picture))
    direction = picture.rays.direction.copy()
    direction[0, 0] = np.nextafter(direction[0, 0], np.float32(1))
    turned = replace(picture.rays, direction=direction)
    assert read_answers(path, picture) is not None
    assert read_answers(path, replace(picture, key="0" * 64)) is None
    assert read_answers(path, replace(picture, rays=turned)) is None
    for name, other in (("RULE", (RULE_VERSION + 1, *shipped.RULE[1:])), ("FORMAT", 0)):
        with monkeypatch.context() as patch:
            patch.setattr(shipped, name, other)
            assert read_answers(path, picture) is None


def test_answers_are_stored_beside_the_picture(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Storing them anew needs no renderer, tells what it does, and gives the stored bytes."""
    there = scenes.answers_path("grid").read_bytes()
    monkeypatch.setattr(album, "answers_path", lambda name, _: tmp_path / name)
    told: list[str] = []
    album.store_answers(("grid",), told.append)
    assert told == ["answering grid, 256 x 256"]
    _, picture = stored("grid")
    (tmp_path / "there").write_bytes(there)
    found = read_answers(tmp_path / "there", picture)
    assert found is not None
    require_same(read_answers(tmp_path / "grid", picture), found)


def test_an_unwritable_place_is_said(
    tmp_path: Path, small: tuple[Mesh, Bvh, Reference]
) -> None:
    """The sentence names the file."""
    mesh, tree, picture = small
    with pytest.raises(OutputFault, match="the answers cannot be written"):
        write_answers(tmp_path / "no" / "a", picture, computed_answers(mesh, tree, picture))


def test_a_balanced_tree_holds_every_face_once() -> None:
    """Ranges halve down to leaves of at most four faces, also without faces."""
    mesh, _ = stored("nested")
    for count in (0, 1, 4, 5, 17, 1000):
        tree = balanced_tree(Mesh(vertices=mesh.vertices, faces=mesh.faces[:count]))
        leaves = slice(tree.node_count // 2, None)
        assert sorted(tree.order.tolist()) == list(range(count))
        assert (tree.end - tree.begin)[leaves].max() <= 4
        assert np.array_equal(tree.begin[leaves][1:], tree.end[leaves][:-1])
        assert (int(tree.begin[0]), int(tree.end[0])) == (0, count)
