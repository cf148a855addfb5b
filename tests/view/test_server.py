"""The page of this machine alone: who may ask, and what is answered."""

import html
import http.client
import socket
import struct
import threading
from contextlib import suppress
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest

from grader.language import translator
from grader.model.scene import Scene
from grader.oracle.scenes import scenes
from grader.view import server
from grader.view.camera import Orbit, frame_of, orbit_of
from grader.view.desk import Desk
from grader.view.page import HERE, invitation, written
from grader.view.service import DEEPEST_SENT, Service
from grader.view.study import Study
from grader.view.subject import Subject
from tests.verify.builder import soup
from tests.view.served import Open
from tests.view.shown import until


def test_the_page_is_given_to_who_knows_the_secret(house: Open) -> None:
    """With a policy that lets nothing of a stranger run."""
    status, text = house.ask("GET", house.at(""))
    assert status == 200
    told = html.unescape(text.decode())
    assert "connect-src 'self'" in told
    assert "default-src 'none'" in told


def test_the_whole_page_speaks_the_language_that_was_asked_for() -> None:
    """Whatever LANG says: the words of the template and those of the script."""
    text = html.unescape(written(Path("a.cpp"), ["soup"], "de"))
    assert '<html lang="de">' in text
    german = translator("de")
    for told in ("Next failing ray", "The program has ended; start it again."):
        assert german(told) in text
        assert told not in text


@pytest.mark.parametrize("host", ["evil.example", "evil.example:80", "", "127.0.0.1.evil:1"])
def test_another_host_is_refused(house: Open, host: str) -> None:
    """A page that gives its own name our address learns nothing."""
    assert house.ask("GET", house.at("state"), Host=host) == (403, b"")
    assert house.ask("POST", house.at("do"), {"what": "next-node"}, Host=host)[0] == 403


@pytest.mark.parametrize("token", ["", "x", "%C3%A9", "x" * 5000])
def test_another_secret_is_refused(house: Open, token: str) -> None:
    """Nobody finds it by trying."""
    assert house.ask("GET", f"/{token}/state") == (404, b"")


@pytest.mark.parametrize(
    "body",
    [
        "",
        "[]",
        "{",
        "[" * 60_000,
        {"what": "nothing"},
        {"what": "node", "node": "7"},
        {"what": "node", "node": 1e300},
        {"what": "mode", "mode": "wrong"},
        {"what": "follow", "at": [1]},
        {"what": "follow", "at": [True, 0]},
        "x" * 70_000,
    ],
    ids=str,
)
def test_what_cannot_be_asked_is_refused(house: Open, body: Any) -> None:  # noqa: ANN401 - JSON
    """And the program goes on."""
    status, told = house.ask("POST", house.at("do"), body)
    assert status == 400
    assert told
    assert house.ask("GET", house.at("state"))[0] == 200


TWO = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n"


def test_a_file_that_is_sent_is_shown(house: Open) -> None:
    """With what was made of it; one that cannot be read leaves what is there."""
    before = house.ask("GET", house.at("state"))[1]["subject"]
    status, told = house.ask("POST", house.at("drop?name=two.obj"), TWO)
    assert (status, told["subject"]) == (200, before)
    until(lambda: house.ask("GET", house.at("state"))[1]["subject"] > before, lambda: None)
    told = house.ask("GET", house.at("state"))[1]
    assert told["scene"] == "two"
    assert "scaled into the cube" in told["remark"]
    root = {"what": "node", "node": 0}
    until(lambda: bool(house.ask("POST", house.at("do"), root)[1]["node"]), lambda: None)
    assert house.ask("POST", house.at("do"), root)[1]["node"]["faces"] == [0, 2]
    assert house.ask("POST", house.at("drop?name=notes.txt"), "x")[0] == 200
    until(lambda: bool(house.ask("GET", house.at("state"))[1]["trouble"]), lambda: None)
    trouble = house.ask("GET", house.at("state"))[1]["trouble"]
    assert trouble.startswith("notes.txt: a mesh")
    wish = {"what": "scene", "scene": "soup"}
    assert house.ask("POST", house.at("do"), wish)[0] == 200
    until(lambda: house.service._desk.subjects > before + 1, lambda: None)


@pytest.mark.parametrize(
    ("place", "headers", "status"),
    [
        ("drop?name=a.obj", {"Content-Length": "200000001"}, 400),
        ("drop?name=a.json", {"Content-Length": "1000001"}, 400),
        ("drop?name=a.obj", {"Content-Length": "x"}, 400),
        ("drop?name=a.obj", {"Host": "evil.example"}, 403),
        ("look", {"Content-Length": "200000"}, 400),
    ],
    ids=str,
)
def test_no_file_is_taken_that_is_too_large_or_somebody_else_s(
    house: Open, place: str, headers: dict[str, str], status: int
) -> None:
    """It is refused by what is said of it, before it is read."""
    subject = house.service._desk.subjects
    assert house.ask("POST", house.at(place), "x", **headers)[0] == status
    other = house.at(place).replace(house.door.token, "x" * 22)
    assert house.ask("POST", other, "x")[0] == 404
    assert house.ask("GET", house.at("state"))[0] == 200
    assert house.service._desk.subjects == subject
    assert not house.service._desk.is_loading


def test_where_there_is_no_display_the_way_to_one_is_named(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """With the port, so that the address holds there, too."""
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    monkeypatch.setenv("DISPLAY", ":0")
    assert "ssh" not in invitation(4321, str)
    monkeypatch.delenv("DISPLAY")
    assert "ssh -L 4321:127.0.0.1:4321 " in invitation(4321, translator("de"))


def test_a_fault_of_ours_costs_one_answer(house: Open, monkeypatch: pytest.MonkeyPatch) -> None:
    """It is told in a sentence, and the next question is answered."""

    def state() -> None:
        raise ValueError("on purpose")

    with monkeypatch.context() as patch:
        patch.setattr(house.service, "state", state)
        status, told = house.ask("GET", house.at("state"))
        assert status == 500
        assert "on purpose" in told
        assert house.ask("POST", house.at("do"), {"what": "next-node"})[0] == 500
    assert house.ask("GET", house.at("state"))[0] == 200


def test_a_browser_that_goes_away_leaves_no_traceback(
    house: Open, capfd: pytest.CaptureFixture[str]
) -> None:
    """Whoever closes a page does so in the middle of an answer."""
    for _ in range(3):
        with socket.create_connection((HERE, house.door.port)) as line:
            # Nothing is read, and what is left unsent is dropped with a reset.
            line.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
            path = house.at("model")
            line.sendall(f"GET {path} HTTP/1.1\r\nHost: {HERE}:1\r\n\r\n".encode())
    assert house.ask("GET", house.at("state"))[0] == 200
    assert "Traceback" not in capfd.readouterr().err


def test_what_comes_with_a_refused_question_is_no_question(house: Open) -> None:
    """It was not read: its bytes could ask for something in the name of who is let in."""
    inner = f"GET {house.at('state')} HTTP/1.1\r\nHost: {HERE}:{house.door.port}\r\n\r\n"
    outer = f"POST /x/do HTTP/1.1\r\nHost: {HERE}:{house.door.port}\r\n"
    with silent(house) as line:
        line.sendall(f"{outer}Content-Length: {len(inner)}\r\n\r\n{inner}".encode())
        with suppress(ConnectionResetError):
            assert b"".join(iter(lambda: line.recv(4096), b"")).count(b"HTTP/1.1 ") == 1


def silent(house: Open) -> socket.socket:
    """Connect, and say nothing."""
    line = socket.create_connection((HERE, house.door.port))
    line.settimeout(60)
    return line


def test_who_says_nothing_is_not_waited_for(
    house: Open, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Neither for a question nor for the rest of one."""
    monkeypatch.setattr(server._Handler, "timeout", 0.2)
    body = f"POST {house.at('do')} HTTP/1.1\r\nHost: {HERE}:1\r\nContent-Length: 9\r\n\r\n"
    for said in ("", "GET /", body):
        with silent(house) as line:
            line.sendall(said.encode())
            assert line.recv(1) == b""


def test_strangers_cannot_take_all_connections(house: Open) -> None:
    """The oldest of them go; who has named the secret stays."""
    known = http.client.HTTPConnection(HERE, house.door.port, timeout=120)
    known.request("GET", house.at("state"))
    assert known.getresponse().read()
    before = threading.active_count()
    lines = [silent(house) for _ in range(3 * server.MOST_STRANGERS)]
    assert lines[0].recv(1) == b""
    assert house.ask("GET", house.at("state"))[0] == 200
    known.request("GET", house.at("state"))
    assert known.getresponse().status == 200
    until(lambda: threading.active_count() <= before + server.MOST_STRANGERS, lambda: None)
    known.close()
    for line in lines:
        line.close()


def test_a_fault_of_the_desk_costs_nothing(
    house: Open, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is told until somebody wants something else, and the next questions are answered."""

    def advance() -> bool:
        raise ValueError("on purpose")

    with monkeypatch.context() as patch:
        patch.setattr(house.service._desk, "advance", advance)
        until(lambda: bool(house.service._own_fault), lambda: None)
    assert "on purpose" in house.ask("GET", house.at("state"))[1]["trouble"]
    status, told = house.ask("POST", house.at("do"), {"what": "step", "step": 0})
    assert status == 200
    assert "on purpose" not in told["trouble"]


def test_no_level_is_chosen_that_a_page_is_not_given(house: Open) -> None:
    """A click must find only boxes that are drawn."""
    told = house.ask("POST", house.at("do"), {"what": "level", "level": 15})[1]
    assert told["level"] == DEEPEST_SENT
    house.service._desk.level = 14
    until(lambda: house.service._desk.level == DEEPEST_SENT, lambda: None)
    assert house.ask("POST", house.at("do"), {"what": "level", "level": 6})[1]["level"] == 6


def looked_at(home: Orbit) -> tuple[Any, Service]:
    """Give what takes the place of a desk, and the service of it."""
    desk = SimpleNamespace(
        subject=Subject("few", "few", soup(30), home),
        light=None,
        stage=None,
        size=(8, 8),
        orbit=home,
    )
    desk.look = lambda orbit: setattr(desk, "orbit", orbit)
    return desk, Service(cast("Desk", desk), cast("Study", None), str)


@pytest.mark.parametrize(
    ("size", "traced"),
    [
        ([1380, 1094], (1024, 811)),
        ([500, 2048], (250, 1024)),
        ([640, 480], (640, 480)),
        ([0, 3], (16, 16)),
        ([-5, -9], (16, 16)),
    ],
    ids=str,
)
def test_a_large_picture_is_traced_in_the_same_shape(
    size: list[float], traced: tuple[int, int]
) -> None:
    """Or both halves would show something else; what is small enough is left alone."""
    desk, service = looked_at(orbit_of(scenes()[0].camera, 1.0))
    begun = (service.model() or {})["home"]
    service.look({**begun, "size": size})
    assert desk.size == traced


@pytest.mark.parametrize("scene", scenes(), ids=lambda one: one.name)
def test_a_page_begins_where_the_scene_does(scene: Scene) -> None:
    """With the same axes, whatever its up is, and the same point in the middle."""
    home = orbit_of(scene.camera, 1.0)
    desk, service = looked_at(home)
    begun = (service.model() or {})["home"]
    service.look({**begun, "size": [16, 16]})
    assert desk.orbit != home
    seen, wanted = frame_of(desk.orbit), frame_of(home)
    for one, other in (
        (seen.right, wanted.right),
        (seen.up, wanted.up),
        (seen.back, wanted.back),
    ):
        assert one == pytest.approx(other, abs=1e-9)
    assert desk.orbit.target == pytest.approx(home.target, abs=1e-6)
    east, up, north = begun["axes"]
    assert np.cross(up, north) == pytest.approx(np.array(east), abs=1e-9)
    assert up == pytest.approx(home.up)
