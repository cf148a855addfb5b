"""What a window and a study do, where no window is needed."""

from dataclasses import replace
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest

from grader.cli.progress import silent
from grader.model.views import Step
from grader.options import Options
from grader.phrases import teller
from grader.view import window as window_module
from grader.view.desk import Desk, Mode
from grader.view.following import Place
from grader.view.panel import Panel
from grader.view.panes import Panes
from grader.view.stage import Stage, State
from grader.view.status import is_vain
from grader.view.study import Study
from grader.view.subject import of_file
from grader.view.walking import Followed, Walk, cut_off
from grader.view.window import Window, _hear_drops
from tests.verify.builder import build, soup
from tests.view.shown import confetti, of_mesh, until

WALK = Walk(Followed(np.zeros(8, np.float32), ""), (), 0, np.inf, None, None, "", -1)


class StandIn:
    """Takes the place of a desk, and remembers what was chosen."""

    stage: Any = None
    rival: Any = None
    size = 8, 8
    mode = Mode.SHADED
    is_loading = is_building = False

    def __init__(self) -> None:
        self.subject = confetti()
        self.orbit = self.subject.home
        self.chosen: list[Any] = []

    def choose(self, load: Any) -> None:  # noqa: ANN401 - the desk's own
        """Remember it."""
        self.chosen.append(load)

    def advance(self) -> bool:
        """Have nothing new."""
        return False


def window_on(desk: StandIn) -> Window:
    """Make a window of it, which is never opened."""
    study = Study(cast("Desk", desk))
    return Window(cast("Desk", desk), study, [], str)


def test_a_file_that_is_dropped_is_opened(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The last of several, and not in the frame in which it is heard."""
    from imgui_bundle import glfw_utils

    heard: list[Any] = []
    # By its name: under Wayland it must not be loaded before ImGui.
    monkeypatch.setattr("glfw.set_drop_callback", lambda _, call: heard.append(call))
    monkeypatch.setattr(glfw_utils, "glfw_window_hello_imgui", lambda: None)
    file = tmp_path / "two.obj"
    file.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n")
    desk = StandIn()
    window = window_on(desk)
    window.panel.remark = "saved"
    _hear_drops(window.drop)
    heard[0](None, [])
    heard[0](None, ["first.txt", str(file)])
    assert len(desk.chosen) == 1
    # Nothing was read yet.
    file.write_text(file.read_text() + "f 2 3 4\n")
    assert len(desk.chosen[0]().mesh.faces) == 3
    assert not window.panel.remark


@pytest.mark.usefixtures("cache")
def test_a_file_that_cannot_be_shown_leaves_what_there_is(tmp_path: Path) -> None:
    """It is said what was expected, until something else is shown."""
    text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
    (tmp_path / "one.obj").write_text(text)
    source = tmp_path / "a.cpp"
    source.write_text("")
    with Desk(source, Options(41, None, (), silent, isolated=False), confetti) as desk:
        study = Study(desk)
        window = Window(desk, study, [], str)
        until(lambda: desk.subjects == 1, desk.advance)
        window.drop([str(tmp_path / "notes.txt")])
        until(lambda: not desk.is_loading, desk.advance)
        assert "was expected" in str(desk.fault)
        assert "was expected" in window.status(10.0)
        assert not is_vain(desk)
        assert desk.subjects == 1
        window.drop([str(tmp_path / "one.obj")])
        until(lambda: desk.subjects == 2, desk.advance)
        assert "was expected" not in window.status(10.0)
        study.close()


def test_every_picture_is_a_file_of_its_own(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Also two within one second; what drew them is given back."""
    released: list[bool] = []
    drawing = SimpleNamespace(release=lambda: released.append(True))
    monkeypatch.setattr(window_module, "Preview", lambda _: drawing)
    monkeypatch.setattr(window_module, "panes", lambda *_: np.zeros((4, 4, 3), np.uint8))
    monkeypatch.chdir(tmp_path)
    window = window_on(StandIn())
    window._context = SimpleNamespace(screen=SimpleNamespace(use=lambda: None))
    window.save()
    window.save()
    assert len(list(tmp_path.glob("bvhgrade-few-*.png"))) == 2
    assert released == [True, True]


@pytest.mark.parametrize(
    ("moved", "told"),
    [(0.0, "has ended, so no ray"), (0.2, "of an earlier view: no ray")],
    ids=["same", "moved"],
)
def test_a_click_after_the_end_is_answered(moved: float, told: str) -> None:
    """No ray can be followed any more; that of an old picture would even be another one."""
    desk = StandIn()
    traced = SimpleNamespace(
        orbit=desk.orbit, t=np.zeros((8, 8)), seen=np.ones((8, 8), np.bool_)
    )
    subject = of_mesh(soup(3))
    desk.stage = SimpleNamespace(state=State.ENDED, subject=subject, tree=None, traced=traced)
    desk.orbit = desk.orbit.turned(moved, 0.0)
    study = Study(cast("Desk", desk))
    study._stage = desk.stage
    study.follow((1, 1))
    assert told in study.remark
    assert (study.walk is None) == bool(moved)
    study.close()


def test_where_the_program_ends_one_still_looks_at_the_same_node() -> None:
    """The next build ends in its first ray, before anybody looks, but its tree is there."""
    mesh, desk = soup(30), StandIn()
    stage = SimpleNamespace(state=State.ENDED, subject=of_mesh(mesh), tree=build(mesh))
    desk.stage = stage
    study = Study(cast("Desk", desk))
    study._stage = cast("Stage", stage)
    study._place = Place(mesh, 2, None)
    assert study._return(cast("Stage", stage))
    assert study.facts is not None
    assert study.facts.node == 2
    study.close()


def test_a_window_is_drawn_at_full_speed_as_long_as_something_is_looked_for() -> None:
    """The rays of a counterexample are passed over one in each frame, but not in vain."""
    desk = StandIn()
    window = window_on(desk)
    panes = cast(Panes, SimpleNamespace(is_settled=True))
    assert not window._is_busy(panes)
    window.study._hunting = True
    assert window._is_busy(panes)
    desk.is_building = True
    assert not window._is_busy(panes)
    window.study.close()


def test_a_long_way_says_where_it_is_cut_off() -> None:
    """Only the first steps are kept, so the last one cannot be reached."""
    assert not cut_off(WALK, str)
    assert cut_off(replace(WALK, total=871_414), str) == "Only the first 0 steps are kept."


def test_the_list_of_steps_follows_the_step() -> None:
    """Once for each step, so that whoever scrolls elsewhere is left there."""
    steps = tuple(Step(node, -1, True, np.inf) for node in range(50))
    walk = replace(WALK, steps=steps, total=50)
    study = SimpleNamespace(walk=walk, step=3)
    drawn: list[str] = []

    def selectable(name: str, _: bool) -> tuple[bool, bool]:
        drawn.append(name)
        return False, False

    scrolled: list[str] = []
    imgui = SimpleNamespace(
        begin_child=lambda *_: True,
        end_child=lambda: None,
        selectable=selectable,
        set_scroll_here_y=lambda: scrolled.append(drawn[-1].split(":")[0]),
    )
    panel = Panel(cast("Desk", StandIn()), cast("Study", study), str)
    for step in (3, 3, 40, 40):
        study.step = step
        panel._steps(cast("ModuleType", imgui))
    assert scrolled == ["node 2", "node 39"]


def test_why_a_ray_is_wrong_is_told_in_the_language_of_the_rest(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The sentence is the checks' own."""
    study = Study(cast("Desk", StandIn()), str, teller("de"))
    walk = replace(WALK, sentence="face 3 is in no leaf of this tree")
    monkeypatch.setattr(study._following, "take", lambda _: (walk.of, walk))
    assert study._take_walk(cast("Stage", None))
    assert study.walk is not None
    assert study.walk.sentence == "Dreieck 3 ist in keinem Blatt dieses Baums"
    study.close()


def test_what_was_made_of_a_mesh_is_told(tmp_path: Path) -> None:
    """Its coordinates are other ones now, and faces without an area are gone."""
    file = tmp_path / "two.obj"
    file.write_text("v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 2 3\nf 1 2 4\nf 1 1 2\n")
    origin = of_file(file).origin
    assert origin == (
        "the mesh was moved and scaled into the cube from -1 to 1; "
        "1 face without any area was left out"
    )
    assert teller("de")(origin) == (
        "das Netz wurde in den Würfel von -1 bis 1 verschoben und skaliert; "
        "1 Dreieck ohne Inhalt wurde weggelassen"
    )
