"""What a desk keeps, lets go of and says, without any compiler."""

import threading
import time
from collections.abc import Callable
from concurrent.futures import Future
from pathlib import Path
from typing import cast

import pytest

from grader.cli.progress import silent
from grader.errors import UsageError, WorkerFault
from grader.options import Options
from grader.run.session import Engine
from grader.sandbox.launch import Order, is_stopped, launch
from grader.view import builds as builds_module
from grader.view import desk as desk_module
from grader.view.aside import outcome
from grader.view.desk import Desk, Mode
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
        monkeypatch.setattr(builds_module, "built", lambda _, folder, *__: made(folder))

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


def test_another_wish_ends_the_fault_of_the_last(
    tmp_path: Path, making: Callable[[Made], None]
) -> None:
    """While it is loaded nobody is told any more what was wrong with the one before."""
    free = threading.Event()

    def fails() -> Subject:
        raise UsageError("no such scene")

    def late() -> Subject:
        free.wait(LONG)
        return confetti()

    making(nothing)
    with Desk(tmp_path / "a.cpp", OPTIONS, fails) as desk:
        done(desk)
        assert str(desk.fault) == "no such scene"
        desk.choose(late)
        desk.advance()
        assert desk.fault is None
        free.set()
        done(desk)


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
    """Whoever saves a hundred times fills no disk; what does not compile takes no place."""
    folders: list[Path] = []
    compiles = [True, False, True, True, False]

    def made(folder: Path) -> Product:
        folders.append(folder)
        good = compiles[len(folders) - 1]
        return Product(cast("Engine", object())) if good else nothing(folder)

    def load() -> Subject:
        raise UsageError("nothing is to run")

    making(made)
    with Desk(tmp_path / "a.cpp", OPTIONS, load) as desk:
        done(desk)
        for _ in compiles[1:]:
            desk.rebuild()
            done(desk)
        kept = [folder.exists() for folder in folders]
        assert kept == [False, False, False, True, False]
    assert not any(folder.exists() for folder in folders)


def test_the_model_solution_is_compiled_aside(
    tmp_path: Path, making: Callable[[Made], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Who draws does not wait for it; whatever it ends with is told."""
    ready = threading.Event()

    def fails(_: object) -> Engine:
        ready.wait(LONG)
        raise MemoryError("no room")

    making(nothing)
    monkeypatch.setattr(desk_module, "our_own", fails)
    with Desk(tmp_path / "a.cpp", OPTIONS, confetti) as desk:
        done(desk)
        desk.compare(Mode.DIFFERENCE)
        desk.advance()
        assert desk.is_loading
        assert desk.fault is None
        ready.set()
        done(desk)
        assert "MemoryError: no room" in str(desk.fault)


@pytest.mark.parametrize("what", ["loading", "building"])
def test_a_fault_that_nobody_knows_is_shown(
    tmp_path: Path, making: Callable[[Made], None], what: str
) -> None:
    """It costs what was wished for, and not the window."""

    def load() -> Subject:
        if what == "loading":
            raise MemoryError("no room")
        return confetti()

    def made(_: Path) -> Product:
        if what == "building":
            raise MemoryError("no room")
        return Product(None)

    making(made)
    with Desk(tmp_path / "a.cpp", OPTIONS, load) as desk:
        done(desk)
        assert "MemoryError: no room" in str(desk.fault)


def test_who_wants_the_end_gets_it() -> None:
    """What ends the whole program is no fault to be shown."""
    future: Future[int] = Future()
    future.set_exception(KeyboardInterrupt())
    with pytest.raises(KeyboardInterrupt):
        outcome(future)


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


def test_a_process_that_cannot_be_started_is_told(
    tmp_path: Path, making: Callable[[Made], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The window lives, and the next try may have what this one had not."""

    def full(*_: object) -> None:
        raise WorkerFault("no room for the mesh")

    monkeypatch.setattr(desk_module, "Stage", full)
    making(lambda _: Product(cast("Engine", object()), ""))
    with Desk(tmp_path / "a.cpp", OPTIONS, confetti) as desk:
        done(desk)
        assert desk.stage is None
        assert str(desk.fault) == "no room for the mesh"
