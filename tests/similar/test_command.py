"""`bvhgrade similar` reads a class where `batch` keeps it, and writes one page."""

from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from grader.batch.base import opened_base
from grader.batch.records import Student
from grader.batch.store import Store
from grader.cli import cli
from grader.output import STORE
from grader.similar.pairs import Compared
from tests.own_files import ROOT

RIGHT = ROOT / "tests" / "submissions" / "right"


@pytest.fixture
def class_folder(tmp_path: Path) -> Path:
    """Keep a class of five: two handed in one file, a third one hid that it is the same."""
    copied = (RIGHT / "bottom-up-boxes.cpp").read_bytes()
    other = (RIGHT / "cramers-rule.cpp").read_bytes()
    handed_in = {
        "Ada": copied,
        "Ben <b>": copied,
        "Cy": copied.replace(b"node", b"knoten"),
        "Di": other,
        "Ed": None,
    }
    (tmp_path / STORE).touch()
    with opened_base(tmp_path) as base:
        store = Store(base)
        for name, source in handed_in.items():
            store.put(student(name, source), source or b"")
    return tmp_path


def student(name: str, source: bytes | None) -> Student:
    """Make a student."""
    import hashlib

    return Student(
        key=name,
        slug=name[:2].lower(),
        name=name,
        id="",
        email="",
        layout="plain",
        path="exercise03.cpp" if source else None,
        sha256=hashlib.sha256(source).hexdigest() if source else None,
        reason="" if source else "nothing was handed in",
        fault="",
        written="",
    )


def similar(*arguments: str) -> Result:
    """Call the command."""
    return CliRunner().invoke(cli, ["similar", *arguments, "--language", "en"])


def test_copies_stand_side_by_side(class_folder: Path) -> None:
    """Identical files are one; the hidden copy is the only pair."""
    done = similar(str(class_folder))
    assert done.exit_code == 0, done.output
    assert "3 different files, 1 pairs from 50 % on" in done.output
    page = (class_folder / "similar.html").read_text()
    assert "4 submissions, 3 different files" in page
    assert "<li><bdi>Ada</bdi>, <bdi>Ben &lt;b&gt;</bdi></li>" in page
    assert page.count('<section class="pair"') == 1
    assert "<mark>" in page
    assert "cramer" not in page.lower()


def test_who_was_not_compared_is_named(
    class_folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """On the page and in the terminal, with everybody who handed that file in."""
    monkeypatch.setattr("grader.similar.alike.compared", lambda _: Compared((), (0,)))
    done = similar(str(class_folder))
    assert done.exit_code == 0, done.output
    assert "not compared, because it takes too long: Ada, Ben <b>\n" in done.stderr
    page = (class_folder / "similar.html").read_text()
    assert page.index("Not compared") < page.rindex("<li><bdi>Ada</bdi>, <bdi>Ben &lt;b&gt;")


def test_a_folder_without_a_class_is_refused(tmp_path: Path) -> None:
    """Submissions alone were never read, and nobody's name is known."""
    done = similar(str(tmp_path))
    assert done.exit_code == 2
    assert "name the folder that it wrote to" in " ".join(done.output.split())
    assert list(tmp_path.iterdir()) == []


def test_a_class_of_one_is_alike_to_nobody(tmp_path: Path) -> None:
    """No pair, no division by their number."""
    (tmp_path / STORE).touch()
    with opened_base(tmp_path) as base:
        Store(base).put(student("Ada", b"int main() {}"), b"int main() {}")
    done = similar(str(tmp_path))
    assert done.exit_code == 0, done.output
    assert "None." in (tmp_path / "similar.html").read_text()
