"""Tests of grader/resources.py."""

import stat
from pathlib import Path

import pytest

from grader import resources
from grader.errors import GraderError, OutputFault, UsageError


def made(root: Path, *, checkout: bool) -> Path:
    """Lay out a checkout or an installed wheel with empty files; gives the package's folder."""
    package = root / "grader"
    parent = root if checkout else package / "data"
    for name in ("student_stub", "reference", "scenes"):
        (parent / name).mkdir(parents=True)
    package.mkdir(exist_ok=True)
    if checkout:
        (root / "pyproject.toml").touch()
    return package


def test_a_checkout_has_everything() -> None:
    """Here, the folders beside the package are taken."""
    root = Path(__file__).parent.parent
    assert resources.stub_folder() == root / "student_stub"
    assert resources.reference_source() == root / "reference" / "src" / "exercise03.cpp"
    assert resources.reference_source().is_file()
    assert resources.scenes_folder() == root / "scenes"


@pytest.mark.parametrize("checkout", [True, False])
def test_both_layouts_are_found(tmp_path: Path, checkout: bool) -> None:
    """In a checkout beside the package, in a wheel below it."""
    package = made(tmp_path, checkout=checkout)
    parent = tmp_path if checkout else package / "data"
    assert resources.stub_folder(package) == parent / "student_stub"
    assert resources.scenes_folder(package) == parent / "scenes"
    reference = parent / "reference" / "src" / "exercise03.cpp"
    assert resources.reference_source(package) == reference


def test_a_folder_beside_an_installed_package_is_not_ours(tmp_path: Path) -> None:
    """Some other package's `scenes` in site-packages is not taken for a checkout."""
    package = made(tmp_path, checkout=False)
    (tmp_path / "scenes").mkdir()
    assert resources.scenes_folder(package) == package / "data" / "scenes"


def test_a_damaged_installation_is_named(tmp_path: Path) -> None:
    """Our own fault, with what to do."""
    with pytest.raises(GraderError, match="install bvhgrade again"):
        resources.stub_folder(tmp_path / "grader")


@pytest.mark.parametrize(
    ("variables", "expected"),
    [
        ({"BVHGRADE_CACHE": "own"}, "own"),
        ({"BVHGRADE_CACHE": "own", "XDG_CACHE_HOME": "xdg"}, "own"),
        ({"BVHGRADE_CACHE": "beside/../own"}, "own"),
        ({"XDG_CACHE_HOME": "xdg"}, "xdg/bvhgrade"),
        ({"BVHGRADE_CACHE": "", "XDG_CACHE_HOME": ""}, "home/.cache/bvhgrade"),
    ],
)
def test_the_cache_is_where_the_user_wants_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, variables: dict[str, str], expected: str
) -> None:
    """Own variable first, then the usual one, then the home; nobody else may list it."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    for name in ("BVHGRADE_CACHE", "XDG_CACHE_HOME"):
        monkeypatch.delenv(name, raising=False)
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr(resources, "is_root", lambda: False)
    folder = resources.cache_folder()
    assert folder == tmp_path / expected
    assert stat.S_IMODE(folder.stat().st_mode) == 0o711
    assert resources.cache_folder() == folder


def test_a_cache_that_cannot_be_made_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A file in its place: the sentence says which variable helps."""
    (tmp_path / "file").touch()
    monkeypatch.setenv("BVHGRADE_CACHE", str(tmp_path / "file" / "cache"))
    with pytest.raises(OutputFault, match="set BVHGRADE_CACHE"):
        resources.cache_folder()


def test_who_has_no_home_is_told_what_to_set(monkeypatch: pytest.MonkeyPatch) -> None:
    """A user of a container whom no file of passwords knows."""

    def homeless() -> Path:
        raise RuntimeError("Could not determine home directory.")

    for name in ("BVHGRADE_CACHE", "XDG_CACHE_HOME"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(resources, "is_root", lambda: False)
    monkeypatch.setattr(Path, "home", homeless)
    with pytest.raises(OutputFault, match="set BVHGRADE_CACHE to a folder"):
        resources.cache_folder()


def test_the_cache_of_root_can_be_entered(monkeypatch: pytest.MonkeyPatch) -> None:
    """Another user compiles for root, and the home of root is closed."""
    monkeypatch.delenv("BVHGRADE_CACHE", raising=False)
    monkeypatch.setenv("XDG_CACHE_HOME", "/srv/caches")
    monkeypatch.setattr(resources, "is_root", lambda: True)
    monkeypatch.setattr(resources, "_made", lambda folder, _: folder)
    assert resources.cache_folder() == Path("/var/cache/bvhgrade")


def test_the_parts_of_the_cache_are_open_or_closed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Answers are for the grader alone, also where an older version left the folder open."""
    monkeypatch.setenv("BVHGRADE_CACHE", str(tmp_path))
    (tmp_path / "oracle").mkdir(mode=0o755)
    modes = [
        stat.S_IMODE(folder.stat().st_mode)
        for folder in (resources.private_cache("oracle"), resources.shared_cache("framework"))
    ]
    assert modes == [0o700, 0o755]


def test_a_cache_that_others_can_write_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What lies there is run and believed."""
    monkeypatch.setenv("BVHGRADE_CACHE", str(tmp_path))
    tmp_path.chmod(0o777)
    with pytest.raises(UsageError, match="others may write to it"):
        resources.cache_folder()
