"""A file that is dropped onto a page is bounded, kept in a folder of ours, and read once."""

import tempfile
from collections.abc import Callable
from io import BytesIO
from pathlib import Path

import pytest

from grader.counterexample.written import to_text
from grader.errors import UsageError
from grader.model.counterexample import Counterexample
from grader.model.trials import ConstructTrial
from grader.view import dropped
from grader.view.asked import Unanswered
from grader.view.dropped import kept, most_bytes
from tests.verify.builder import soup

TWO = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n"
CHECK = "hits.closest-wins"


@pytest.fixture(autouse=True)
def room(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Have temporary files in a folder of their own."""
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    return tmp_path


def in_text() -> bytes:
    """Write a counterexample."""
    trial = ConstructTrial("x", soup(5))
    return to_text(Counterexample(CHECK, trial, 5, 0, "x", "", "", "")).encode()


@pytest.mark.parametrize(
    ("name", "data", "called"),
    [
        ("two.obj", TWO, "two"),
        ("../../b\\c/Zwei Dächer.OBJ", TWO, "Zwei_Dächer"),
        ("x" * 500 + ".obj", TWO, "x" * 56),
        ("found.json", in_text(), CHECK),
    ],
    ids=["mesh", "folders", "long", "counterexample"],
)
def test_a_file_is_read_and_removed(room: Path, name: str, data: bytes, called: str) -> None:
    """Of its name only the last part is used, as far as it is harmless."""
    body = BytesIO(data + b"rest")
    load = kept(name, len(data), body)
    assert body.read() == b"rest"
    (folder,) = room.iterdir()
    assert folder.stat().st_mode & 0o777 == 0o700
    assert load().name == called
    assert not list(room.iterdir())


@pytest.mark.parametrize(
    ("name", "data", "told"),
    [
        ("notes.txt", b"nothing", r"^notes.txt: a mesh .* was expected"),
        ("a.json", b"{", "^a.json is no JSON file of a counterexample"),
        ("a.obj", b"nothing", "^a.obj: "),
        ("\x00..", b"", "^_: a mesh"),
    ],
    ids=["kind", "json", "mesh", "name"],
)
def test_what_cannot_be_read_is_told_without_our_folder(
    room: Path, name: str, data: bytes, told: str
) -> None:
    """And nothing of it stays."""
    load = kept(name, len(data), BytesIO(data))
    with pytest.raises(UsageError, match=told) as found:
        load()
    assert str(room) not in str(found.value)
    assert not list(room.iterdir())


@pytest.mark.parametrize("name", ["a.json", "a.JSON", "a.obj", "a"])
def test_a_file_that_is_too_large_is_not_kept(room: Path, name: str) -> None:
    """It is refused before anything of it is read."""
    most = most_bytes(name)
    assert most == (1_000_000 if "j" in name.lower()[2:3] else 200_000_000)
    body = BytesIO(b"x")
    with pytest.raises(UsageError, match=f"{name}: a file of its kind may have {most:,} bytes"):
        kept(name, most + 1, body)
    assert body.read() == b"x"
    assert not list(room.iterdir())


def test_a_file_that_does_not_arrive_is_not_kept(room: Path) -> None:
    """Whoever goes away in the middle leaves nothing behind."""
    with pytest.raises(UsageError, match=r"a\.obj did not arrive whole"):
        kept("a.obj", 99, BytesIO(TWO))
    assert not list(room.iterdir())


def test_a_full_disk_is_told(room: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It is nobody's fault but this machine's."""

    def fails(*_: object) -> Callable[[], None]:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(dropped, "_copy", fails)
    with pytest.raises(Unanswered, match=r"a\.obj cannot be kept here: No space left"):
        kept("a.obj", len(TWO), BytesIO(TWO))
    assert not list(room.iterdir())
