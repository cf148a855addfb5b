"""Which level is chosen on which machine, and what happens where none holds."""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import textwrap
from collections.abc import Generator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from grader.errors import MissingTool, UsageError
from grader.resources import is_root
from grader.sandbox import selftest as module
from grader.sandbox.box import Isolation, Level
from grader.sandbox.bubblewrap import find_bubblewrap
from grader.sandbox.selftest import VARIABLE, proved_isolation
from grader.sandbox.slots import FIRST_UID, SLOTS
from tests.sandbox.boxes import LEVELS, SYSTEM_PYTHON, as_worker

PACKAGE = Path(module.__file__).parents[1]
NOBODY = 65534


@pytest.fixture(autouse=True)
def _forget() -> Generator[None]:
    """Let each test prove its own level."""
    proved_isolation.cache_clear()
    yield
    proved_isolation.cache_clear()


@pytest.mark.usefixtures("cache")
def test_the_best_level_is_chosen(monkeypatch: pytest.MonkeyPatch) -> None:
    """This machine has all that level A needs, and nothing better was missed."""
    monkeypatch.delenv(VARIABLE, raising=False)
    isolation = proved_isolation()
    assert isolation.level is Level.NAMESPACES
    assert isolation.unproved == ()


@pytest.mark.usefixtures("cache")
@pytest.mark.parametrize(("letter", "level"), [("B", Level.PROCESS), ("b", Level.PROCESS)])
def test_an_operator_chooses(
    monkeypatch: pytest.MonkeyPatch, letter: str, level: Level
) -> None:
    """The variable names one level; no other is tried."""
    monkeypatch.setenv(VARIABLE, letter)
    assert proved_isolation().level is level


@pytest.mark.parametrize("letter", ["D", "none", "AB", "1"])
def test_there_is_no_other_letter(monkeypatch: pytest.MonkeyPatch, letter: str) -> None:
    """No isolation is an option of the command line, not a level."""
    monkeypatch.setenv(VARIABLE, letter)
    with pytest.raises(UsageError, match=r"there is no such level, but A, B, C"):
        proved_isolation()


@pytest.mark.usefixtures("cache")
def test_a_chosen_level_that_does_not_hold_is_an_error(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Asking for more than there is never gives less."""
    empty = tmp_path / "bin"
    empty.mkdir()
    monkeypatch.setenv("PATH", str(empty))
    find_bubblewrap.cache_clear()
    try:
        with pytest.raises(MissingTool, match="bubblewrap is not installed"):
            proved_isolation("A")
        fallen = proved_isolation()
    finally:
        find_bubblewrap.cache_clear()
    assert fallen.level is Level.PROCESS
    assert "bubblewrap is not installed" in fallen.unproved[0]


def test_a_cache_that_no_user_can_enter_is_said(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Not the level is wrong but the folder, and the sentence names the variable."""
    tmp_path.chmod(0o700)
    monkeypatch.setenv("BVHGRADE_CACHE", str(tmp_path / "cache"))
    monkeypatch.setattr(module, "is_root", lambda: True)
    with pytest.raises(MissingTool, match="set BVHGRADE_CACHE to a folder below others"):
        proved_isolation()


@pytest.fixture
def everywhere() -> Generator[Path]:
    """A copy of the package, without answers beside it, that every user may read."""
    with tempfile.TemporaryDirectory(prefix="bvhgrade-") as name:
        folder = Path(name)
        folder.chmod(0o755)
        skip = shutil.ignore_patterns("__pycache__")
        shutil.copytree(PACKAGE, folder / "grader", ignore=skip)
        answers = folder / "grader" / "data" / "reference" / "src"
        answers.mkdir(parents=True)
        (answers / "exercise03.cpp").write_text("int answer;\n")
        (folder / "grader" / "data" / "scenes").mkdir()
        for path in folder.rglob("*"):
            path.chmod(0o755 if path.is_dir() else 0o644)
        yield folder


CONTAINER = """
    import ctypes, errno, os, struct, sys
    from grader.sandbox.inside import enter
    from grader.sandbox.filters import (
        _ALLOW, _ERRNO, _UNKNOWN, _REFUSE, _CLONE_NEW, _answer, _program, _unless_bits, _when)
    from grader.sandbox.syscalls import architecture
    of = architecture()
    refused = "unshare mount umount2 setns pivot_root open_tree move_mount fsopen".split()
    parts = [_when(of, name, [_answer(_REFUSE)]) for name in refused]
    parts.append(_when(of, "clone", _unless_bits(0, _CLONE_NEW, _ALLOW)))
    parts.append(_when(of, "clone3", [_answer(_UNKNOWN)]))
    if "no landlock" in sys.argv:
        parts += [[(0x15, 0, 1, call), _answer(_UNKNOWN)] for call in (444, 445, 446)]
    code = _program(of, parts, _ALLOW)
    held = ctypes.create_string_buffer(code)
    program = enter.Program(len(code) // 8, ctypes.addressof(held))
    library = ctypes.CDLL(None, use_errno=True)
    enter.control(library, enter.PR_SET_NO_NEW_PRIVS, 1)
    enter.control(library, enter.PR_SET_SECCOMP, 2, ctypes.addressof(program))
"""
"""What Docker's default profile refuses, without its profile: source is moby's default.json."""

PROVE = """
    import json
    from grader.errors import GraderError
    from grader.sandbox.selftest import proved_isolation
    try:
        isolation = proved_isolation()
        print(json.dumps([isolation.level.value, list(isolation.unproved)]))
    except GraderError as fault:
        print(json.dumps([type(fault).__name__, str(fault).splitlines()]))
"""


def proved_in(
    folder: Path,
    *words: str,
    plain: bool = False,
    path: str = "/usr/bin:/bin",
    forced: str = "",
) -> tuple[str, str]:
    """Prove a level in another process.

    Args:
        folder: With a copy of the package.
        words: `no namespaces`, `no landlock`: what a container lacks.
        plain: Whether to be a user without any rights.
        path: Where programs are found.
        forced: Level that the operator demands.

    Returns:
        Its name and the reasons against better ones; or the fault and its words.
    """
    prelude = textwrap.dedent(CONTAINER) if words else ""
    uid = NOBODY if plain and is_root() else os.geteuid()
    cache = folder / f"cache-{uid}"
    cache.mkdir(exist_ok=True)
    os.chown(cache, uid, uid)
    done = subprocess.run(
        [SYSTEM_PYTHON, "-c", prelude + textwrap.dedent(PROVE), *words],
        env={
            "BVHGRADE_CACHE": str(cache),
            "BVHGRADE_ISOLATION": forced,
            "PATH": path,
            "PYTHONPATH": str(folder),
        },
        cwd=folder,
        user=uid,
        group=uid,
        extra_groups=[] if is_root() else None,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    level, reasons = json.loads(done.stdout)
    return str(level), "\n".join(reasons)


@pytest.mark.parametrize("plain", [False, True])
def test_every_user_of_this_machine_is_isolated(everywhere: Path, plain: bool) -> None:
    """A lecturer on a server has no rights, a service is root; both get the best level."""
    assert proved_in(everywhere, plain=plain) == (Level.NAMESPACES.value, "")
    assert proved_in(everywhere, plain=plain, forced="B") == (Level.PROCESS.value, "")


@pytest.mark.parametrize("plain", [False, True])
def test_without_bubblewrap_there_is_level_b(everywhere: Path, plain: bool) -> None:
    """What is missing is said."""
    level, reasons = proved_in(everywhere, plain=plain, path="/nowhere")
    assert level == Level.PROCESS.value
    assert "bubblewrap is not installed (Debian package bubblewrap)" in reasons


@pytest.mark.parametrize("plain", [False, True])
def test_in_a_container_there_is_level_b(everywhere: Path, plain: bool) -> None:
    """Docker's default profile refuses namespaces and allows Landlock."""
    level, reasons = proved_in(everywhere, "no namespaces", plain=plain)
    assert level == Level.PROCESS.value
    assert "Operation not permitted" in reasons or "No permissions" in reasons


def test_without_landlock_answers_must_be_out_of_reach(everywhere: Path) -> None:
    """Another user alone may read what everyone may read."""
    level, reasons = proved_in(everywhere, "no namespaces", "no landlock")
    assert level == "MissingTool"
    assert "no way to isolate submissions holds on this machine; nothing is run" in reasons
    assert "landlock 444: Function not implemented" in reasons
    assert "pass --unsafe-no-isolation for code that you would run yourself" in reasons
    answer = everywhere / "grader" / "data" / "reference" / "src" / "exercise03.cpp"
    if is_root():
        assert f"uid+seccomp: a worker reads {answer}; a compiler reads {answer}" in reasons
        (everywhere / "grader" / "data").chmod(0o700)
        level, _ = proved_in(everywhere, "no namespaces", "no landlock")
        assert level == Level.USER.value
    else:
        assert "only root can become another user" in reasons


def test_a_plain_user_without_landlock_grades_nothing(everywhere: Path) -> None:
    """There is nobody else to become."""
    (everywhere / "grader" / "data").chmod(0o711)
    level, reasons = proved_in(everywhere, "no namespaces", "no landlock", plain=True)
    assert level == "MissingTool"
    assert "uid+seccomp: only root can become another user" in reasons


def test_nobody_is_root_inside_and_nobody_is_two(isolation: Isolation) -> None:
    """Boxes that run at the same time are different users, if the grader may choose."""
    code = "print(os.getuid(), os.geteuid(), os.getgid(), flush=True); time.sleep(1)"
    with ThreadPoolExecutor(3) as pool:
        said = [pool.submit(as_worker, isolation, code) for _ in range(3)]
        rows = [future.result().out.decode().split() for future in said]
    users = {row[0] for row in rows}
    assert "0" not in users
    if is_root():
        assert len(users) == 3
        assert all(FIRST_UID <= int(user) < FIRST_UID + SLOTS for user in users)
        assert all(len(set(row)) == 1 for row in rows)


GROUPS = """
import sys
from pathlib import Path
from grader.sandbox.selftest import proved_isolation
from tests.sandbox.boxes import as_compiler
isolation, own = proved_isolation(sys.argv[1]), Path(sys.argv[2])
print(as_compiler(isolation, own, ["/usr/bin/id", "-G"]).out.decode())
"""


@pytest.mark.parametrize("level", LEVELS)
@pytest.mark.usefixtures("cache")
def test_no_group_of_ours_comes_along(level: str, open_folder: Path) -> None:
    """Files of the group root or docker stay closed; a user of his own keeps what is his."""
    said = subprocess.run(
        [sys.executable, "-c", GROUPS, level, str(open_folder / "own")],
        env={**os.environ, "PYTHONPATH": os.pathsep.join([str(PACKAGE.parent), *sys.path])},
        extra_groups=[1, 27, 4000] if is_root() else None,
        capture_output=True,
        text=True,
        check=True,
    )
    groups = set(map(int, said.stdout.split()))
    assert groups
    if is_root():
        assert {group for group in groups if group < FIRST_UID} == set()
        assert len(groups) == 1
