"""Who cannot have a window is told the reason that is theirs."""

from types import SimpleNamespace
from typing import Any, cast

import pytest

from grader.errors import MissingTool
from grader.view import window as window_module
from grader.view.needed import lacking
from grader.view.window import Window, opened


@pytest.mark.parametrize(
    ("fault", "told"),
    [
        (ModuleNotFoundError("No module named 'moderngl'"), "pip install"),
        (ImportError("libGL.so.1: cannot open \x1b shared object file"), "libGL.so.1: "),
    ],
    ids=["missing", "broken"],
)
def test_only_a_package_that_is_missing_is_to_be_installed(
    fault: ImportError, told: str
) -> None:
    """What keeps one that is there from loading is told in its own words."""
    said = str(lacking(fault))
    assert told in said
    assert ("pip install" in said) == isinstance(fault, ModuleNotFoundError)
    assert "\x1b" not in said


@pytest.mark.parametrize(("frames", "raised"), [(0, MissingTool), (3, RuntimeError)])
def test_a_fault_of_an_open_window_is_no_missing_display(
    monkeypatch: pytest.MonkeyPatch, frames: int, raised: type[Exception]
) -> None:
    """Whoever has seen it is not told that there can be none."""
    from imgui_bundle import immapp

    def fails(_: Any) -> None:  # noqa: ANN401 - ImGui's own
        raise RuntimeError("on purpose")

    monkeypatch.setattr(window_module, "runner", lambda *_: None)
    monkeypatch.setattr(immapp, "run", fails)
    monkeypatch.setenv("DISPLAY", ":77")
    window = cast("Window", SimpleNamespace(frames=frames))
    with pytest.raises(raised) as found:
        opened(window, "x")
    assert ("no window can be opened" in str(found.value)) == (not frames)
