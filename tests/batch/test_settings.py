"""Stored results count for the settings that they came about with, and for no others."""

from dataclasses import replace
from pathlib import Path

import pytest

from grader.batch.settings import Settings, Wish, settled
from grader.score.rubric import SHIPPED
from tests.oracle.own import own_folder

WISH = Wish(41, None, None, isolated=False)


def test_the_same_wish_gives_the_same_settings() -> None:
    """Or nobody could go on where a batch was left."""
    assert settled(WISH) == settled(WISH)


def test_another_seed_gives_other_results() -> None:
    """And says so."""
    before, after = settled(WISH), settled(replace(WISH, seed=7))
    assert before.digest != after.digest
    assert before.changes(after) == ["seed: 41 -> 7"]


def test_an_own_scene_that_changes_gives_other_results(tmp_path: Path) -> None:
    """The rubric is the same file, but what it names is not."""
    folder = own_folder(tmp_path)
    rubric = tmp_path / "rubric.toml"
    rubric.write_text(SHIPPED.read_text() + '[scenes]\nfolder = "ours"\n')
    wish = replace(WISH, rubric=rubric)
    before = settled(wish)
    scenes = folder / "scenes.toml"
    scenes.write_text(scenes.read_text().replace("fov = 30", "fov = 31"))
    assert [line.partition(":")[0] for line in before.changes(settled(wish))] == [
        "scenes sha256"
    ]


def test_another_grader_of_the_same_version_gives_other_results(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """As while somebody works on it, or after an update of the compiler."""
    before: Settings = settled(WISH)
    monkeypatch.setattr("grader.batch.settings.grader_digest", lambda _: "0" * 16)
    assert [line.partition(":")[0] for line in before.changes(settled(WISH))] == ["grader"]
