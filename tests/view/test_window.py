"""The window on a display that nobody sees: what hands do to it, and what it survives."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from grader.counterexample.written import to_text
from grader.model.counterexample import Counterexample
from grader.model.trials import TraceTrial
from grader.view.steering import TURN
from tests.view import sources
from tests.view.found import middle, trials

DRIVER = Path(__file__).with_name("driver.py")
ROOT = Path(__file__).parents[2]


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
        env={**environment, "PYTHONPATH": str(ROOT)},
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
        timeout=600,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    seen: dict[str, Any] = json.loads(told.read_text())
    return seen


def test_the_packages_load_in_a_session_of_wayland() -> None:
    """Where glfw would load a library of its own, with which ImGui does not load."""
    code = "from grader.view.window import Window, runner; runner(Window.__new__(Window), 'x')"
    environment = {**os.environ, "XDG_SESSION_TYPE": "wayland", "PYTHONPATH": str(ROOT)}
    # ImGui sets it, if a test before this one has loaded that here.
    environment.pop("PYGLFW_LIBRARY", None)
    done = subprocess.run(
        [sys.executable, "-P", "-c", code],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
        timeout=600,
    )
    assert done.returncode == 0, done.stderr


@pytest.mark.usefixtures("cache")
def test_hands_do_what_they_should(display: str, tmp_path: Path) -> None:
    """Drag, slider, combo, heatmap, keys, clicks, a saved picture, and a file dropped there."""
    deeds = ["drag", "slider", "heat", "keys", "click", "save", "combo", "drop"]
    seen = driven(display, tmp_path, sources.reference(), *deeds)
    assert seen["agreement"] >= 0.99
    assert seen["drag"]["yaw"] == pytest.approx(-80 * TURN, abs=0.1)
    assert seen["drag"]["pitch"] == pytest.approx(24 * TURN, abs=0.1)
    assert seen["slider"]["level"] == 2
    assert seen["heat"]["scale"] == seen["heat"]["expected"]
    assert seen["heat"]["coloured"] > 0.1
    assert seen["heat"]["back"]
    assert not seen["keys"].pop("list")
    assert all(seen["keys"].values()), seen["keys"]
    assert seen["click"] == {"first": 0, "node": 0}
    assert seen["save"]["files"] == 1
    assert seen["combo"] == {"faces": 11_008, "share": 1.0}
    assert 0.01 < seen["drop"]["hit"] < 0.9


@pytest.mark.usefixtures("cache")
def test_a_counterexample_is_gone_through(display: str, tmp_path: Path) -> None:
    """It opens at its first wrong ray; the keys go to the next one, and along it."""
    trial = next(one for one in trials() if isinstance(one, TraceTrial))
    folder = tmp_path / "bvhgrade-out" / "counterexamples"
    folder.mkdir(parents=True)
    check = "hits.closest-wins"
    count = len(trial.rays.t_min)
    text = to_text(Counterexample(check, trial, 30, count, "x", "", "", ""))
    (folder / f"{check}.json").write_text(text)
    forgets = f"    if (ray.direction.y > {middle()}) {{ return {{}}; }}\n{sources.END}"
    source = sources.given().replace(sources.END, forgets)
    seen = driven(display, tmp_path, source, "counterexample")
    told = seen["counterexample"]
    lost = np.flatnonzero(trial.rays.direction[:, 1] > middle())
    assert (told["first"], told["next"]) == (f"ray {lost[0]}", f"ray {lost[1]}")
    begun, after, before = told["steps"]
    assert (after, before) == (begun + 1, begun)
    assert told["remark"] == "the tree is the model solution's"
    assert f"{check}.json" in told["origin"]


@pytest.mark.usefixtures("cache")
def test_all_of_the_bar_is_seen_in_a_narrow_window(display: str, tmp_path: Path) -> None:
    """In German, whose words are longer."""
    seen = driven(display, tmp_path, sources.given(), "bar")
    assert seen["bar"]["right"] <= seen["bar"]["room"] <= 900
    assert seen["bar"]["rows"] == 2


@pytest.mark.usefixtures("cache")
@pytest.mark.parametrize(
    ("source", "told"),
    [
        (sources.CRASHES_AT_THE_RIGHT, r"intersect, pixel \(\d+, \d+\): .*SIGSEGV"),
        (sources.HANGS_AT_THE_RIGHT, r"intersect, pixel \(\d+, \d+\): did not come back"),
        (sources.CRASHES_IN_CONSTRUCT, "construct: .*SIGSEGV"),
    ],
    ids=["crash", "hang", "construct"],
)
def test_the_window_outlives_the_submission(
    display: str, tmp_path: Path, source: str, told: str
) -> None:
    """It says what happened, goes on drawing, and shows the next build once that is saved."""
    seen = driven(display, tmp_path, source, "trouble", "rebuild")
    assert re.match(told, seen["trouble"]["text"])
    assert ("earlier view" in seen["trouble"]["old"]) == told.startswith("intersect")
    assert seen["rebuild"]["text"] == ""
    assert seen["rebuild"]["share"] == 1.0


@pytest.mark.usefixtures("cache")
def test_a_file_that_does_not_compile_is_told(display: str, tmp_path: Path) -> None:
    """The line is named, and the window stays until the file is mended."""
    seen = driven(display, tmp_path, sources.given() + "oops", "broken", "rebuild")
    assert seen["broken"]["lines"]
    assert seen["rebuild"]["share"] == 1.0
