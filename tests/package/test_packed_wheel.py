"""The wheel that a course gets is the one that the project's own build makes."""

import base64
import csv
import hashlib
import io
import zipfile
from importlib.metadata import distribution, version

import pytest

from grader.errors import GraderError
from grader.package import wheel
from grader.package.wheel import own_wheel, pinned
from tests.built_wheel import built_wheel


@pytest.fixture(scope="module")
def packed() -> zipfile.ZipFile:
    """Pack the grader that runs here."""
    return zipfile.ZipFile(io.BytesIO(own_wheel().data))


@pytest.mark.xdist_group("wheel")
def test_it_holds_what_the_projects_own_build_packs(
    packed: zipfile.ZipFile, tmp_path_factory: pytest.TempPathFactory
) -> None:
    """File for file: what is forgotten here would be missing at a host only."""
    with zipfile.ZipFile(built_wheel(tmp_path_factory.mktemp("built"))) as built:
        names = {name for name in built.namelist() if ".dist-info/" not in name}
        assert names == {name for name in packed.namelist() if ".dist-info/" not in name}
        assert all(built.read(name) == packed.read(name) for name in names)


def test_its_record_names_every_file_with_its_hash(packed: zipfile.ZipFile) -> None:
    """That is how pip knows that a wheel is whole."""
    record = f"bvhgrade-{version('bvhgrade')}.dist-info/RECORD"
    rows = list(csv.reader(io.StringIO(packed.read(record).decode())))
    assert sorted(row[0] for row in rows) == sorted(packed.namelist())
    for name, told, size in rows:
        if name != record:
            digest = hashlib.sha256(packed.read(name)).digest()
            assert told == f"sha256={base64.urlsafe_b64encode(digest).decode().rstrip('=')}"
            assert int(size) == packed.getinfo(name).file_size


def test_it_installs_the_command(packed: zipfile.ZipFile) -> None:
    """Without entry points there would be a package, and nothing to call."""
    information = f"bvhgrade-{version('bvhgrade')}.dist-info"
    assert b"bvhgrade = grader.cli:main" in packed.read(f"{information}/entry_points.txt")
    assert b"Name: bvhgrade\n" in packed.read(f"{information}/METADATA")


def test_every_requirement_is_pinned_and_nothing_of_an_extra() -> None:
    """At the version that is installed here, with what the requirements require."""
    pins = dict(line.split("==") for line in pinned().splitlines())
    for name in ("numpy", "click", "rich", "trimesh", "embreex", "openexr", "markupsafe"):
        assert pins[name] == distribution(name).version
    assert not {"pytest", "mypy", "mitsuba", "bvhgrade"} & pins.keys()


def test_a_grader_that_is_not_installed_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    """A copied folder can run, but knows neither its version nor what it needs."""
    monkeypatch.setattr(wheel, "NAME", "nobody-has-this")
    with pytest.raises(GraderError, match="not installed as a package"):
        pinned()
