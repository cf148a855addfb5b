"""The preview program: pictures from good OBJ files, clear errors for the others."""

import zlib
from pathlib import Path

import pytest

from tests.student_stub.library import STUB, run

CUBE = STUB / "models" / "cube.obj"


def picture(build: Path, model: Path, tmp_path: Path) -> bytes:
    """Render `model` in 48 x 32 and return the grey values, row by row."""
    done = run(
        build / "preview", model, "-o", tmp_path / "a.ppm", "--width", "48", "--height", "32"
    )
    assert done.returncode == 0, done.stderr
    header, pixels = (tmp_path / "a.ppm").read_bytes().split(b"\n255\n", 1)
    assert header == b"P6\n48 32"
    return pixels[::3]


def test_the_cube_is_seen(reference_build: Path, tmp_path: Path) -> None:
    """The middle of the picture is bright, its corners are background, three sides differ."""
    pixels = picture(reference_build, CUBE, tmp_path)
    assert len(pixels) == 48 * 32
    assert pixels[16 * 48 + 24] > 150
    assert {pixels[0], pixels[47], pixels[-1]} == {24}
    assert 0.2 < sum(p != 24 for p in pixels) / len(pixels) < 0.8


def test_times_and_tests_are_printed(reference_build: Path, tmp_path: Path) -> None:
    """Construction and tracing have a time of their own, and tracing its tests per ray."""
    said = run(reference_build / "preview", CUBE, "-o", tmp_path / "a.png").stdout
    assert [line.split(":")[0] for line in said.splitlines()] == [
        "model",
        "construct",
        "trace",
        "picture",
    ]
    assert "box tests and" in said


def test_a_png_holds_the_same_picture(reference_build: Path, tmp_path: Path) -> None:
    """The PNG's checksums are right, and its pixels are those of the PPM."""
    pixels = picture(reference_build, CUBE, tmp_path)
    file = tmp_path / "a.png"
    run(reference_build / "preview", CUBE, "-o", file, "--width", "48", "--height", "32")
    rest, chunks = file.read_bytes()[8:], {}
    while rest:
        size, kind = int.from_bytes(rest[:4]), rest[4:8]
        chunks[kind] = rest[8 : 8 + size]
        assert zlib.crc32(rest[4 : 8 + size]) == int.from_bytes(rest[8 + size : 12 + size])
        rest = rest[12 + size :]
    rows = zlib.decompress(chunks[b"IDAT"])
    assert b"".join(rows[y * 49 + 1 : y * 49 + 49] for y in range(32)) == pixels


@pytest.mark.parametrize(
    ("faces", "count"),
    [
        ("f 1 2 3 4", 2),
        ("f 1 2 3 4 5", 3),
        ("f -1 -2 -3", 1),
        ("f 1/1 2/2 3/3", 1),
        ("f 1//1 2//2 3//3\r", 1),
        ("f 1/1/1 2/2/2 3/3/3 # a comment", 1),
        ("", 0),
    ],
)
def test_faces_are_read(faces: str, count: int, reference_build: Path, tmp_path: Path) -> None:
    """Polygons become fans; negative numbers and all four corner forms are understood."""
    model = tmp_path / "m.obj"
    model.write_text(f"vn 0 0 1\nv 0 0 0\nv 1 0 0 1\nv +1 1e0 0\nv 0 1 0\nv -1 .5 0\n{faces}\n")
    done = run(reference_build / "preview", model, "-o", tmp_path / "a.ppm", "--width", "8")
    assert f"model:     {count} faces" in done.stdout, done.stderr


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("v 0 0\n", ":1: coordinate 3 is '', but three finite numbers are expected"),
        ("v 0 0 0\nv 0 nan 0\n", ":2: coordinate 2 is 'nan', but three finite"),
        ("v 0 0 -inf\n", ":1: coordinate 3 is '-inf', but three finite"),
        ("v 0 0 1x\n", ":1: coordinate 3 is '1x', but"),
        ("f 1 2 3\nv 0 0 0\n", ":1: face uses vertex 1, but 0 vertices are given above"),
        ("v 0 0 0\nf 1 1 2\n", ":2: face uses vertex 2, but 1 vertices are given above"),
        ("v 0 0 0\nf 1 1 -2\n", ":2: face uses vertex -2, but 1 vertices"),
        ("v 0 0 0\nf 1 0 1\n", ":2: corner is '0', but a vertex number"),
        ("v 0 0 0\nf 1 a/b 1\n", ":2: corner is 'a/b', but a vertex number"),
        ("v 0 0 0\nf 1 1\n", ":2: face has 2 corners, but at least 3 are expected"),
        ("v \x1b[31m 0 0\n", ":1: coordinate 1 is '?[31m', but"),
        ("#include <vector>\nint main() {}\n", ": no vertices found, but an OBJ file has"),
        ("", ": no vertices found, but an OBJ file has"),
    ],
)
def test_an_error_says_where_and_what(
    text: str, message: str, reference_build: Path, tmp_path: Path
) -> None:
    """A file that is not usable is refused with its line and what was expected there."""
    model = tmp_path / "m.obj"
    model.write_text(text)
    done = run(reference_build / "preview", model, "-o", tmp_path / "a.ppm")
    assert done.returncode == 1
    assert f"m.obj{message}" in done.stderr
    assert not (tmp_path / "a.ppm").exists()


@pytest.mark.parametrize("name", ["absent.obj", "."])
def test_a_missing_file_is_named(name: str, reference_build: Path, tmp_path: Path) -> None:
    """A file that is not there, or a folder, gives one line and exit status 1."""
    done = run(reference_build / "preview", tmp_path / name)
    assert done.returncode == 1
    assert done.stderr.endswith("cannot be opened, but an OBJ file is expected\n")


@pytest.mark.parametrize(
    "arguments",
    [
        [],
        ["a.obj", "b.obj"],
        ["a.obj", "-o"],
        ["a.obj", "--width", "0"],
        ["a.obj", "--height", "3x"],
        ["a.obj", "--depth", "3"],
    ],
)
def test_bad_arguments_give_the_usage(arguments: list[str], reference_build: Path) -> None:
    """Arguments that make no sense give the usage and exit status 2."""
    done = run(reference_build / "preview", *arguments)
    assert done.returncode == 2
    assert done.stderr.startswith("usage: preview MODEL.obj")
