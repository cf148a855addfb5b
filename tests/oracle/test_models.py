"""A model in any format becomes a mesh, or a sentence that says what is wrong with it."""

import base64
import json
from pathlib import Path

import numpy as np
import pytest
import trimesh

from grader.errors import UsageError
from grader.oracle import imported
from grader.oracle.imported import read_model

QUAD = "v 0 0 0\nv 4 0 0\nv 4 2 0\nv 0 2 0\n"


def model(folder: Path, text: str, name: str = "model.obj") -> Path:
    """Write a model."""
    (folder / name).write_text(text, encoding="utf-8")
    return folder / name


def as_ply(vertices: list[str], faces: list[str]) -> str:
    """Write a model in another format: one that trimesh reads."""
    axes = "xyz"[: len(vertices[0].split())]
    return "\n".join(
        [
            "ply\nformat ascii 1.0\ncomment Körper",
            f"element vertex {len(vertices)}",
            *(f"property float {axis}" for axis in axes),
            f"element face {len(faces)}",
            "property list uchar int vertex_indices\nend_header",
            *vertices,
            *(f"{len(face.split())} {face}" for face in faces),
            "",
        ]
    )


def as_gltf(kind: str, *used: int) -> str:
    """Write a model of four vertices of one `kind`, VEC2 or VEC3, and one part for each use."""
    places = np.eye(4, int(kind[-1]), dtype="<f4").tobytes()
    faces = [np.array([0, 1, last], "<u2").tobytes() for last in used]
    views, start = [], 0
    for piece in (places, *faces):
        views.append({"buffer": 0, "byteOffset": start, "byteLength": len(piece)})
        start += len(piece)
    data = base64.b64encode(b"".join([places, *faces])).decode()
    parts = [{"attributes": {"POSITION": 0}, "indices": 1 + one} for one in range(len(used))]
    index = {"componentType": 5123, "count": 3, "type": "SCALAR"}
    buffer = {"byteLength": start, "uri": f"data:application/octet-stream;base64,{data}"}
    whole = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": "Körper"}],
        "meshes": [{"primitives": parts}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": kind},
            *(index | {"bufferView": 1 + one} for one in range(len(used))),
        ],
        "bufferViews": views,
        "buffers": [buffer],
    }
    return json.dumps(whole, ensure_ascii=False)


CORNERS = ["0 0 0", "4 0 0", "4 2 0", "0 2 0"]
FACET = "facet normal 0 0 1\nouter loop\n{}\nendloop\nendfacet"
STL = f"solid Körper\n{FACET}\nendsolid Körper\n"


@pytest.mark.parametrize("ending", ["obj", "ply", "stl", "glb", "gltf"])
def test_every_format_is_read(tmp_path: Path, ending: str) -> None:
    """Scene graphs are flattened with their transforms, whatever the units and the place."""
    moved = np.diag([1000.0, 2000.0, 1000.0, 1.0])
    moved[:3, 3] = (5e6, 0, -7e6)
    solid = trimesh.creation.box()
    if ending in ("glb", "gltf"):
        graph = trimesh.Scene()
        graph.add_geometry(solid, transform=moved)
        graph.export(tmp_path / f"box.{ending}")
    else:
        solid.apply_transform(moved).export(tmp_path / f"box.{ending}")
    mesh, remark = read_model(tmp_path / f"box.{ending}")
    assert (len(mesh.faces), remark) == (12, "")
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    assert np.allclose([low, high], [(-0.5, -1, -0.5), (0.5, 1, 0.5)], atol=1e-4)


def test_polygons_are_cut_and_flat_faces_left_out(tmp_path: Path) -> None:
    """What was left out is said, and no vertex stays without a face."""
    path = model(tmp_path, QUAD + "v 9 9 9\nv 9 9 9\nf 1 2 3 4\nf 1 2 2\nf 5 6 1\n")
    mesh, remark = read_model(path)
    assert (len(mesh.faces), len(mesh.vertices)) == (2, 4)
    assert remark == "2 faces without any area were left out"
    _, remark = read_model(model(tmp_path, QUAD + "f 1 2 3 4\nf 1 2 2\n"))
    assert remark == "1 face without any area was left out"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", "no faces"),
        (QUAD, "no faces"),
        (QUAD + "f 1 2 9\n", "model.obj:5: face uses vertex 9, but 4 vertices are given"),
        ("v 0 0\nv 1 0\nv 1 1\nf 1 2 3\n", "model.obj:1: coordinate 3 is ''"),
        ("v 1 1 1\nf 1 1 1\n", "in one place"),
        ("v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "no face has an area"),
        ("v 1e308 0 0\nv -1e308 0 0\nv 0 1e308 0\nf 1 2 3\n", "endlessly far apart"),
    ],
)
def test_what_cannot_be_graded_is_refused(tmp_path: Path, text: str, expected: str) -> None:
    """The sentence names the file and what is wrong with it."""
    path = model(tmp_path, text)
    with pytest.raises(UsageError, match=expected) as caught:
        read_model(path)
    assert str(caught.value).startswith(str(path))


@pytest.mark.parametrize(
    ("name", "text", "expected"),
    [
        ("m.ply", as_ply([*CORNERS, "nan 0 0"], ["0 1 4"]), "1 vertex is no number"),
        ("m.ply", as_ply([*CORNERS, "nan 0 0", "0 inf 0"], ["0 5 4"]), "2 vertices are no num"),
        ("m.ply", as_ply(CORNERS, ["0 1 9"]), "a face uses vertex 9, but 4 are given, counted"),
        ("m.ply", as_ply(CORNERS, ["0 1 -1"]), "a face uses vertex -1, but 4 are given"),
        ("m.ply", as_ply(CORNERS, ["0 1", "0 2"]), "three each are expected"),
        ("m.ply", as_ply(["0 0", "1 0", "1 1"], ["0 1 2"]), "cannot be read as ply"),
        ("m.gltf", as_gltf("VEC2", 2), "vertices hold 4 x 2 numbers, but three each are"),
        ("m.gltf", as_gltf("VEC3", 4, 2), "a face uses vertex 4, but 4 are given"),
    ],
)
def test_wrong_arrays_of_other_formats_are_refused(
    tmp_path: Path, name: str, text: str, expected: str
) -> None:
    """Whatever trimesh lets through; a part's face never takes a vertex of the next part."""
    with pytest.raises(UsageError, match=expected):
        read_model(model(tmp_path, text, name))


@pytest.mark.parametrize("encoding", ["latin-1", "utf-8"])
@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("m.obj", "# Körper\no Körper\n" + QUAD + "f 1 2 3\n"),
        ("m.ply", as_ply(CORNERS, ["0 1 2"])),
        ("m.gltf", as_gltf("VEC3", 2)),
        ("m.stl", STL.format("\n".join(f"vertex {corner}" for corner in CORNERS[:3]))),
    ],
)
def test_names_in_any_encoding_are_let_through(
    tmp_path: Path, name: str, text: str, encoding: str
) -> None:
    """They stand in comments and names, which no scene needs."""
    (tmp_path / name).write_bytes(text.encode(encoding))
    assert len(read_model(tmp_path / name)[0].faces) == 1


def test_binary_formats_keep_every_byte(tmp_path: Path) -> None:
    """A header may hold what is not UTF-8, and numbers are not text."""
    solid = trimesh.creation.icosphere(subdivisions=2)
    ply = solid.export(file_type="ply", encoding="binary")
    stl = solid.export(file_type="stl")
    for ending, content in (
        ("ply", ply.replace(b"element vertex", b"comment \xf6\nelement vertex", 1)),
        ("stl", b"K\xf6rper".ljust(80) + stl[80:]),
    ):
        (tmp_path / f"ball.{ending}").write_bytes(content)
        mesh, _ = read_model(tmp_path / f"ball.{ending}")
        assert len(mesh.faces) == len(solid.faces)
        assert np.allclose(np.linalg.norm(mesh.vertices, axis=1), 1, atol=1e-5)


def test_a_model_that_is_too_large_is_told_the_limit(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """By its faces, or by its file before anything is read."""
    path = model(tmp_path, QUAD + "f 1 2 3 4\n")
    with monkeypatch.context() as patch:
        patch.setattr(imported, "MOST_FACES", 1)
        with pytest.raises(UsageError, match="holds 2 faces, but at most 1 can be graded"):
            read_model(path)
    monkeypatch.setattr(imported, "LARGEST_FILE", 10)
    with pytest.raises(UsageError, match="more than 1 GiB"):
        read_model(path)


@pytest.mark.parametrize("name", ["model.glb", "model.stl", "model.ply", "model.txt"])
def test_what_is_no_model_is_refused(tmp_path: Path, name: str) -> None:
    """No reader's fault reaches anyone as a traceback."""
    with pytest.raises(UsageError, match=r"cannot be read as|not a model|no faces"):
        read_model(model(tmp_path, "nonsense", name))
