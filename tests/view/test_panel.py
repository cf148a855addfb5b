"""What the panel of the window does without a window."""

from pathlib import Path

import numpy as np
import pytest

from grader.view.panel import saved


@pytest.mark.parametrize("name", ["dragon", "out/../../evil", "/etc/evil", "..", "a\\..\\b"])
def test_a_picture_is_saved_where_the_program_was_started(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    """Whatever a counterexample says that its check is called."""
    here = tmp_path / "a" / "b"
    (here / "bvhgrade-out").mkdir(parents=True)
    monkeypatch.chdir(here)
    told = saved(np.zeros((2, 2, 3), np.uint8), name, str)
    (picture,) = tmp_path.rglob("*.png")
    assert picture.parent == here
    assert picture.name in told
