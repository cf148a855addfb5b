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
        ("v 0 1e50 0\n", ":1: coordinate 2 is '1e50', but three finite"),
        ("v 0 0 1e-50x\n", ":1: coordinate 3 is '1e-50x', but"),
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


@pytest.mark.parametrize("tiny", ["1e-50", "-1e-50", "1e-40", "1e-400", "0.0000001e-44"])
def test_a_tiny_coordinate_is_the_nearest_float(
    tiny: str, reference_build: Path, tmp_path: Path
) -> None:
    """Zero or a denormal, as the compiler reads it, so the picture is that of zero.

    Other programs write such numbers.
    """
    for name, number in (("tiny", tiny), ("zero", "0")):
        model = tmp_path / f"{name}.obj"
        model.write_text(f"v {number} 0 0\nv 1 {number} 0\nv 0 1 0\nf 1 2 3\n")
        output = tmp_path / f"{name}.ppm"
        done = run(reference_build / "preview", model, "-o", output, "--width", "64")
        assert done.returncode == 0, done.stderr
    picture = (tmp_path / "tiny.ppm").read_bytes()
    assert picture == (tmp_path / "zero.ppm").read_bytes()
    assert len(set(picture)) > 10


@pytest.mark.parametrize("output", ["absent/a.png", "taken.png"])
def test_a_picture_that_cannot_be_written_is_refused_first(
    output: str, reference_build: Path, tmp_path: Path
) -> None:
    """Before anything is rendered, with what would help."""
    (tmp_path / "taken.png").mkdir()
    done = run(reference_build / "preview", CUBE, "-o", tmp_path / output)
    assert done.returncode == 1
    assert done.stdout == ""
    assert f"{output}: cannot be written, but the picture goes there; name a " in done.stderr
    assert "usage" not in done.stderr


@pytest.mark.parametrize("before", [b"an older picture", None])
def test_a_picture_is_replaced_by_a_whole_one_only(
    before: bytes | None, reference_build: Path, tmp_path: Path
) -> None:
    """What ends before it is done leaves the folder as it was."""
    file = tmp_path / "a.png"
    if before is not None:
        file.write_bytes(before)
    assert run(reference_build / "preview", tmp_path / "no.obj", "-o", file).returncode == 1
    assert (file.read_bytes() if file.exists() else None) == before


@pytest.mark.parametrize(
    ("arguments", "why"),
    [
        ([], "no model is named"),
        (["a.obj", "b.obj"], "'b.obj' is a second model, but one is expected"),
        (["a.obj", "-o"], "-o stands last, but its value is expected after it"),
        (["a.obj", "-o", "a.jpg"], "-o is 'a.jpg', but a name that ends in .png or .ppm"),
        (["a.obj", "-o", "png"], "-o is 'png', but a name that ends in .png or .ppm"),
        (["a.obj", "--width", "0"], "--width is '0', but a number of pixels from 1 to 16384"),
        (["a.obj", "--width", "16385"], "--width is '16385', but a number of pixels from 1 to"),
        (["a.obj", "--height", "3x"], "--height is '3x', but a number of pixels from 1 to 16384"),
        (["a.obj", "--height", "-3"], "--height is '-3', but a number of pixels from 1 to 16384"),
        (["a.obj", "--depth", "3"], "there is no option '--depth'"),
        (["a.obj", "--depth"], "there is no option '--depth'"),
    ],
)
def test_bad_arguments_are_named(
    arguments: list[str], why: str, reference_build: Path
) -> None:
    """What makes no sense, what would, and the usage; exit status 2."""
    done = run(reference_build / "preview", *arguments)
    assert done.returncode == 2
    first, second, *_ = done.stderr.splitlines()
    assert first.startswith(f"preview: {why}")
    assert second.startswith("usage: preview MODEL.obj")
