"""What `bvhgrade view` says where it cannot show anything."""

import subprocess
import sys
from pathlib import Path

import pytest

from grader import resources
from grader.counterexample.written import to_text
from tests.cli.calls import Waiting, call
from tests.report.small_inputs import small
from tests.test_selection import hiding
from tests.view import sources

FILE = str(resources.reference_source())


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("--scene", "nowhere"), "no scene is called nowhere"),
        (("--scene", "soup", "--check", "x"), "give one of them"),
        (("--web", "--screenshot", "a.png"), "give one of them"),
        (("--check", "nothing.json"), "nothing.json"),
        (("--check", "hits.closest-win"), "perhaps hits.closest-wins"),
    ],
)
@pytest.mark.usefixtures("cache")
def test_a_wrong_call_is_told(words: tuple[str, ...], told: str) -> None:
    """With status 2."""
    result = call("view", FILE, *words)
    assert result.exit_code == 2
    assert told in result.output


@pytest.mark.usefixtures("cache")
def test_a_hidden_check_is_not_shown(tmp_path: Path) -> None:
    """Neither searched for nor opened from a file, which anybody can write."""
    rubric, file = str(hiding(tmp_path, small().check)), tmp_path / "input.json"
    file.write_text(to_text(small()))
    for named in (small().check, str(file)):
        result = call("view", FILE, "--check", named, "--rubric", rubric)
        assert result.exit_code == 2, result.output
        told = f"the rubric hides {small().check}, so it is not run here"
        assert told in " ".join(result.output.split())


def test_without_a_display_other_ways_are_named(
    cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With status 3, and no traceback."""
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    result = call("view", FILE, "--scene", "soup")
    assert result.exit_code == 3
    assert "--web" in result.output
    assert "--screenshot" in result.output
    assert "Traceback" not in result.output


@pytest.mark.parametrize("words", [(), ("--screenshot", "a.png")])
def test_without_the_extra_it_is_named(
    cache: Path, monkeypatch: pytest.MonkeyPatch, words: tuple[str, ...]
) -> None:
    """With status 3, and the command that installs it."""
    for name in ("imgui_bundle", "moderngl"):
        monkeypatch.setitem(sys.modules, name, None)
    result = call("view", FILE, "--scene", "soup", *words)
    assert result.exit_code == 3
    assert 'pip install "bvhgrade[view]"' in result.output


@pytest.mark.parametrize(
    ("words", "works"),
    [(("--screenshot", "a.png"), ["drawing the picture"]), (("--web",), [])],
)
def test_a_picture_that_takes_its_time_shows_that_it_goes_on(
    cache: Path, monkeypatch: pytest.MonkeyPatch, words: tuple[str, ...], works: list[str]
) -> None:
    """A page does so by itself."""
    waiting = Waiting()
    # The package has the command by that name.
    monkeypatch.setattr(sys.modules["grader.cli.view"], "shown", waiting.shown)
    monkeypatch.setattr("grader.view.opening.opening", lambda *_: "")
    assert call("view", FILE, "--scene", "soup", *words).exit_code == 0
    assert (waiting.works, waiting.is_over) == (works, bool(works))


def drawn(file: str, path: Path) -> subprocess.CompletedProcess[str]:
    """Run the whole command, in a process of its own: OpenGL stays in one until its end."""
    words = [sys.executable, "-m", "grader", "view", file, "--scene", "soup"]
    return subprocess.run(
        [*words, "--screenshot", str(path)],
        cwd=resources.stub_folder().parent,
        capture_output=True,
        text=True,
        check=False,
        timeout=600,
    )


@pytest.mark.parametrize(
    ("source", "told"),
    [
        (sources.CRASHES_AT_THE_RIGHT, "intersect, pixel ("),
        (sources.CRASHES_IN_CONSTRUCT, "construct: "),
    ],
    ids=["intersect", "construct"],
)
def test_a_picture_that_is_not_whole_says_why(
    cache: Path, tmp_path: Path, source: str, told: str
) -> None:
    """With status 1; what there is of it is in the file."""
    file, path = tmp_path / "exercise03.cpp", tmp_path / "both.png"
    file.write_text(source)
    done = drawn(str(file), path)
    assert done.returncode == 1, done.stderr
    assert told in done.stderr
    assert "Traceback" not in done.stderr
    assert path.is_file()


def test_a_picture_of_what_does_not_compile_says_why(cache: Path, tmp_path: Path) -> None:
    """With the compiler's first line, and status 1; there is no picture."""
    file, path = tmp_path / "exercise03.cpp", tmp_path / "both.png"
    file.write_text(sources.given() + "oops")
    done = drawn(str(file), path)
    assert done.returncode == 1, done.stderr
    line = len(sources.given().splitlines()) + 1
    assert f"It does not compile. {line}: " in done.stderr
    assert not path.exists()


def test_a_file_shows_both_panes(cache: Path, tmp_path: Path) -> None:
    """Side by side, with a gap between them."""
    path = tmp_path / "both.png"
    done = drawn(FILE, path)
    assert done.returncode == 0, done.stderr
    from PIL import Image

    with Image.open(path) as picture:
        assert picture.size == (1288, 640)
