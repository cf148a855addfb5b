"""What a desk keeps, lets go of and says, without any compiler."""

import time
from collections.abc import Callable
from pathlib import Path

import pytest

from grader.cli.progress import silent
from grader.errors import UsageError, WorkerFault
from grader.options import Options
from grader.sandbox.launch import Order, is_stopped, launch
from grader.view import desk as desk_module
from grader.view.desk import Desk
from grader.view.subject import Subject
from grader.view.workshop import Product
from tests.view.shown import confetti, until

OPTIONS = Options(41, None, (), silent, isolated=False)
LONG = 120.0
"""Seconds; nobody waits for so long."""

Made = Callable[[Path], Product]


@pytest.fixture
def making(monkeypatch: pytest.MonkeyPatch) -> Callable[[Made], None]:
    """Give what takes the compiler's place."""

    def take(made: Made) -> None:
        monkeypatch.setattr(desk_module, "built", lambda _, folder, *__: made(folder))

    return take


def nothing(_: Path) -> Product:
    """Make what cannot be run."""
    return Product(None, "nothing is there")


def done(desk: Desk) -> None:
    """Wait for what is under way."""
    until(lambda: not desk.is_building and not desk.is_loading, desk.advance)


def test_a_right_build_ends_the_fault_of_the_last(
    tmp_path: Path, making: Callable[[Made], None]
) -> None:
    """What could not be built is forgotten as soon as something could."""

    def fails(_: Path) -> Product:
        raise WorkerFault("no room")

    making(fails)
    with Desk(tmp_path / "a.cpp", OPTIONS, confetti) as desk:
        done(desk)
        assert str(desk.fault) == "no room"
        making(nothing)
        desk.rebuild()
        done(desk)
        assert desk.fault is None


def test_a_build_hides_no_fault_of_loading(
    tmp_path: Path, making: Callable[[Made], None]
) -> None:
    """That there is nothing to look at stays true, whatever is compiled."""

    def load() -> Subject:
        raise UsageError("no such scene")

    making(nothing)
    with Desk(tmp_path / "a.cpp", OPTIONS, load) as desk:
        done(desk)
        desk.rebuild()
        done(desk)
        assert str(desk.fault) == "no such scene"
        desk.choose(confetti)
        done(desk)
        assert desk.fault is None


def test_only_the_folder_of_the_last_build_is_kept(
    tmp_path: Path, making: Callable[[Made], None]
) -> None:
    """Whoever saves a hundred times fills no disk."""
    folders: list[Path] = []

    def made(folder: Path) -> Product:
        folders.append(folder)
        return nothing(folder)

    making(made)
    with Desk(tmp_path / "a.cpp", OPTIONS, confetti) as desk:
        done(desk)
        for _ in range(3):
            desk.rebuild()
            done(desk)
        assert [folder.exists() for folder in folders] == [False, False, False, True]
    assert not folders[-1].exists()


def test_closing_waits_for_nobody(tmp_path: Path, making: Callable[[Made], None]) -> None:
    """What is still searched for is ended, and others can be started afterwards."""
    begun: list[bool] = []

    def load() -> Subject:
        begun.append(True)
        launch(Order(["sleep", str(LONG)], LONG))
        return confetti()

    making(nothing)
    with Desk(tmp_path / "a.cpp", OPTIONS, load):
        until(lambda: bool(begun), lambda: None)
        time.sleep(0.1)
        closing = time.monotonic()
    assert time.monotonic() - closing < LONG / 2
    assert not is_stopped()
