"""Files of counterexamples come back bit for bit; a stranger's are refused in a sentence."""

import contextlib
import copy
import json
from collections.abc import Callable
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from grader.counterexample.cutting import cut_repeat
from grader.counterexample.probe import sizes
from grader.counterexample.reading import LARGEST, read
from grader.counterexample.revived import trial_of
from grader.counterexample.written import to_text
from grader.errors import UsageError
from grader.model.trials import ConstructTrial, Trial
from grader.verify.planned import kinds_of
from tests.report.small_inputs import small
from tests.verify.builder import build, soup
from tests.verify.trials import every_trial, repeats


def largest(trial: Trial) -> int:
    """How many faces a trial has."""
    return sizes(trial)[0]


SMALL: list[Trial] = [one for one in every_trial() if largest(one) < 100]


def written(trial: Trial) -> str:
    """Write a counterexample with this trial."""
    return to_text(replace(small(), trial=trial))


def back(text: str, folder: Path) -> Trial:
    """Read it again."""
    path = folder / "file.json"
    path.write_text(text)
    return trial_of(read(path))


@pytest.mark.parametrize("trial", SMALL, ids=lambda one: one.name)
def test_every_kind_of_trial_comes_back(trial: Trial, tmp_path: Path) -> None:
    """Meshes, trees and rays bit for bit; answers are computed anew."""
    again = back(written(trial), tmp_path)
    assert type(again) is type(trial)
    for name in ("mesh", "first", "second", "other_mesh", "tree", "other_tree", "rays"):
        mine, yours = getattr(trial, name, None), getattr(again, name, None)
        for field in fields(mine) if mine is not None else ():
            one, other = getattr(mine, field.name), getattr(yours, field.name)
            assert np.asarray(one).tobytes() == np.asarray(other).tobytes(), (name, field.name)
    assert getattr(trial, "sanitized", None) == getattr(again, "sanitized", None)
    assert kinds_of(again) == kinds_of(trial)


def test_a_smaller_repeated_trial_runs_on_the_same_build() -> None:
    """A memory error of the build with sanitizers stays one."""
    for trial in repeats(soup(9)):
        few = np.arange(2)
        cut = cut_repeat(trial, (few, few), few, lambda meshes: [build(one) for one in meshes])
        assert (cut.name, cut.sanitized, len(cut.mesh.faces)) == (
            trial.name,
            trial.sanitized,
            2,
        )


def test_odd_floats_come_back(tmp_path: Path) -> None:
    """Negative zero, the smallest number and the largest."""
    mesh = soup(5)
    odd = mesh.vertices.copy()
    odd[0] = np.array([0x80000000, 1, 0x7F7FFFFF], np.uint32).view(np.float32)
    trial = ConstructTrial("odd", replace(mesh, vertices=odd))
    again = back(written(trial), tmp_path)
    assert isinstance(again, ConstructTrial)
    assert again.mesh.vertices.tobytes() == odd.tobytes()


KINDS = ("altered", "image", "work")
CONTENT: dict[str, Any] = json.loads(written(next(one for one in SMALL if one.name in KINDS)))


def places(value: Any, here: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:  # noqa: ANN401 - JSON
    """Every place in a JSON value."""
    inside: list[tuple[Any, Any]] = list(enumerate(value)) if isinstance(value, list) else []
    if isinstance(value, dict):
        inside = list(value.items())
    return [here, *(place for key, one in inside for place in places(one, (*here, key)))]


PLACES = places(CONTENT)
VALUES = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(-(2**70), 2**70),
    st.floats(allow_nan=False, allow_infinity=False),
    st.text(max_size=5),
    st.just([]),
    st.just({}),
    st.just([[0] * 3] * 2000),
)


@settings(max_examples=150)
@given(st.sampled_from(PLACES), VALUES)
def test_one_other_value_is_refused_or_read(
    tmp_path_factory: pytest.TempPathFactory, place: tuple[Any, ...], value: object
) -> None:
    """Whatever stands anywhere in the file: a trial, or a sentence."""
    changed = copy.deepcopy(CONTENT)
    holder: Any = {"": changed}
    way = ("", *place)
    for key in way[:-1]:
        holder = holder[key]
    holder[way[-1]] = value
    path = tmp_path_factory.getbasetemp() / "changed.json"
    path.write_text(json.dumps(changed if place else value))
    with contextlib.suppress(UsageError):
        trial_of(read(path))


@pytest.mark.parametrize(
    "make",
    [
        lambda text: "",
        lambda text: "[" * 100_000,
        lambda text: text.replace('"t_min": 0.0', '"t_min": NaN', 1),
        lambda text: text.replace('"version": 1', '"version": 2'),
        lambda text: text.replace('"check"', '"version": 1, "check"', 1),
        lambda text: text.replace('"check"', '"chek"', 1),
        lambda text: text + " " * LARGEST,
        lambda text: "\ud800",
        lambda text: '{"format": ' + "9" * 5000 + "}",
    ],
)
def test_what_is_no_such_file_is_refused(tmp_path: Path, make: Callable[[str], str]) -> None:
    """One sentence with the path, for anything that was not written by this version."""
    path = tmp_path / "file.json"
    path.write_text(make(json.dumps(CONTENT)), errors="surrogatepass")
    with pytest.raises(UsageError, match=r"file\.json"):
        read(path)


def test_a_folder_is_refused(tmp_path: Path) -> None:
    """And so is what does not exist."""
    with pytest.raises(UsageError, match="cannot be read"):
        read(tmp_path)
