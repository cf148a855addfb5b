"""The window on a display that nobody sees: what hands do to it, and what it survives."""

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.view import sources

DRIVER = Path(__file__).with_name("driver.py")


def driven(display: str, folder: Path, source: str, *deeds: str) -> dict[str, Any]:
    """Open the window on a source in a process of its own, do things, and say what was seen."""
    file = folder / "exercise03.cpp"
    file.write_text(source)
    told = folder / "told.json"
    environment = {**os.environ, "DISPLAY": display, "LIBGL_ALWAYS_SOFTWARE": "1"}
    environment.pop("WAYLAND_DISPLAY", None)
    words = [sys.executable, "-P", str(DRIVER), str(file), str(told), *deeds]
    done = subprocess.run(
        words,
        env={**environment, "PYTHONPATH": str(Path(__file__).parents[2])},
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
        timeout=600,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    seen: dict[str, Any] = json.loads(told.read_text())
    return seen


@pytest.mark.usefixtures("cache")
def test_hands_do_what_they_should(display: str, tmp_path: Path) -> None:
    """Drag, slider, combo, heatmap, keys, a click on each pane, and a saved picture."""
    deeds = ["drag", "slider", "heat", "keys", "click", "save", "combo"]
    seen = driven(display, tmp_path, sources.reference(), *deeds)
    assert seen["agreement"] >= 0.99
    assert seen["drag"]["turned"]
    assert seen["drag"]["waited"]
    assert seen["slider"]["level"] != seen["slider"]["before"]
    assert seen["heat"]["scale"] > 0
    assert seen["keys"]["turned"]
    assert seen["click"]["steps"] > 0
    assert seen["click"]["node"] >= 0
    assert seen["save"]["files"] == 1
    assert seen["combo"]["subject"] == "nested"


@pytest.mark.usefixtures("cache")
@pytest.mark.parametrize(
    ("source", "told"),
    [
        (sources.CRASHES_AT_THE_RIGHT, "SIGSEGV"),
        (sources.HANGS_AT_THE_RIGHT, "did not come back"),
        (sources.CRASHES_IN_CONSTRUCT, "construct: "),
    ],
    ids=["crash", "hang", "construct"],
)
def test_the_window_outlives_the_submission(
    display: str, tmp_path: Path, source: str, told: str
) -> None:
    """It says what happened, goes on drawing, and shows the next build once that is saved."""
    seen = driven(display, tmp_path, source, "trouble", "rebuild")
    assert told in seen["trouble"]["text"]
    assert seen["rebuild"]["text"] == ""
    assert seen["rebuild"]["share"] == 1.0


@pytest.mark.usefixtures("cache")
def test_a_file_that_does_not_compile_is_told(display: str, tmp_path: Path) -> None:
    """The line is named, and the window stays until the file is mended."""
    seen = driven(display, tmp_path, sources.given() + "oops", "broken", "rebuild")
    assert seen["broken"]["lines"]
    assert seen["rebuild"]["share"] == 1.0
