"""The probe sees each hole: with a protection taken away, exactly what it held is named."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from grader import resources
from grader.errors import WorkerFault
from grader.resources import is_root
from grader.sandbox import bubblewrap, confine, kept, words
from grader.sandbox import selftest as module
from grader.sandbox.box import Box, Isolation, Level
from grader.sandbox.launch import PLAIN_ENVIRONMENT
from grader.sandbox.selftest import flaws_of, proved_isolation, unconfined

Without = Callable[..., None]
FAMILIES = ("AF_INET", "AF_INET6", "AF_UNIX", "AF_NETLINK", "AF_VSOCK")


@pytest.fixture
def without(monkeypatch: pytest.MonkeyPatch) -> Without:
    """Give a function that takes protections away.

    Its words are keys of the specification that enter.py gets, and options of bubblewrap.
    """

    def take(*names: str) -> None:
        specification, arguments = words.specification, bubblewrap.arguments

        def fewer_words(box: Box, level: Isolation, waits: bool) -> Iterator[str]:
            given = specification(box, level, waits)
            return (word for word in given if word.split("=")[0] not in names)

        def fewer_options(
            version: tuple[int, ...], box: Box, interior: bubblewrap.Interior
        ) -> Iterator[str]:
            return (word for word in arguments(version, box, interior) if word not in names)

        for module_of_ours in (confine, kept):
            monkeypatch.setattr(module_of_ours, "specification", fewer_words)
        monkeypatch.setattr(bubblewrap, "arguments", fewer_options)

    return take


def flaws(isolation: Isolation) -> tuple[set[str], set[str]]:
    """Say what the probe could do as a worker, and what as a compiler."""
    found = flaws_of(isolation)
    worker = {flaw.removeprefix("a worker ") for flaw in found if flaw.startswith("a worker ")}
    compiler = {flaw.removeprefix("a compiler ") for flaw in found} - {*found}
    return worker, compiler


def kinds(found: set[str]) -> set[str]:
    """Drop the paths from what the probe said."""
    return {flaw.partition(" /")[0] for flaw in found}


def test_a_level_that_holds_has_no_hole(isolation: Isolation) -> None:
    """Neither for a worker nor for a compiler."""
    assert flaws_of(isolation) == []


SOCKETS = {f"opens a socket {family}" for family in FAMILIES}
WITHOUT_FILTER = {*SOCKETS, "traces processes", "shares memory by a key"}
ALONE = {"starts a process", "makes a file in memory"}
"""Of a worker only: a compiler may."""

ROOT_FOLDER = "opens the root folder"
NAMESPACE = "makes a namespace"
FILES_OPEN = {"reads", "writes to", "changes", ROOT_FOLDER}


def of_root(*flaws: str) -> set[str]:
    """What only a grader that is root can leave open."""
    return set(flaws) if is_root() else set()


@pytest.mark.usefixtures("cache")
def test_without_a_box_everything_is_open() -> None:
    """The list of attempts is worth something: each one succeeds here."""
    open_to_both = {*WITHOUT_FILTER, *FILES_OPEN, NAMESPACE, "sees the grader's process"}
    open_to_both |= of_root("runs as root", "becomes root", "changes the root")
    worker, compiler = flaws(unconfined())
    assert kinds(compiler) == open_to_both
    assert kinds(worker) == {*open_to_both, *ALONE, "starts a program", "lists a folder"}


def test_without_the_filter(isolation: Isolation, without: Without) -> None:
    """Sockets, tracing, shared memory and children are what the filter alone holds."""
    without("filter")
    worker, compiler = flaws(isolation)
    expected = set(WITHOUT_FILTER)
    if isolation.level is Level.PROCESS:
        expected.add(NAMESPACE)
        # Landlock holds signals since its version 6; another user always does.
        seen = set() if is_root() else {"sees the grader's process"}
        compiler, worker = compiler - seen, worker - seen
    assert compiler == expected
    assert worker == expected | ALONE


@pytest.mark.usefixtures("cache")
def test_without_the_ban_on_namespaces(without: Without) -> None:
    """Bubblewrap holds it too, so that both have to go."""
    without("filter", "--disable-userns")
    worker, compiler = flaws(proved_isolation("A"))
    assert compiler == {*WITHOUT_FILTER, NAMESPACE}
    assert worker == compiler | ALONE


def test_without_landlock(isolation: Isolation, without: Without) -> None:
    """In a namespace only the empty root can be opened then; without one, every file."""
    without("landlock")
    worker, compiler = flaws(isolation)
    if isolation.level is Level.NAMESPACES:
        assert worker == compiler == {ROOT_FOLDER}
        return
    assert {"reads", ROOT_FOLDER} <= kinds(worker)
    assert kinds(worker) <= {"reads", ROOT_FOLDER, "lists a folder"}
    assert {"reads", "writes to", ROOT_FOLDER} <= kinds(compiler) <= FILES_OPEN


@pytest.mark.usefixtures("cache")
def test_without_another_user(without: Without) -> None:
    """A grader that is root stays root, and says so; any other never was."""
    without("uid")
    assert flaws(proved_isolation("B")) == (of_root("runs as root"),) * 2


@pytest.mark.usefixtures("cache")
def test_without_all_of_level_b(without: Without) -> None:
    """A signal to the grader is kept by all three: user, filter, Landlock's scope."""
    without("uid", "filter", "landlock")
    worker, compiler = flaws(proved_isolation("B"))
    for found in (worker, compiler):
        assert {"sees the grader's process", NAMESPACE} <= found
        assert kinds(found) >= of_root("becomes root", "changes the root")


@pytest.mark.parametrize(
    ("word", "flaw"),
    [
        ("memory", "takes more memory than the limit"),
        ("files", "opens more files than the limit"),
    ],
)
def test_without_a_limit(isolation: Isolation, without: Without, word: str, flaw: str) -> None:
    """Limits are tried, not only asked for."""
    without(word)
    assert flaws(isolation) == ({flaw}, {flaw})


def test_a_variable_of_ours(isolation: Isolation, monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever is not plain is seen."""
    more = {**PLAIN_ENVIRONMENT, "BVHGRADE_TOKEN": "x"}
    for module_of_ours in (confine, kept):
        monkeypatch.setattr(module_of_ours, "PLAIN_ENVIRONMENT", more)
    flaw = {"sees the grader's environment"}
    assert flaws(isolation) == (flaw, flaw)


def test_one_path_too_many(isolation: Isolation, monkeypatch: pytest.MonkeyPatch) -> None:
    """A box that shows a folder of ours is one that shows the secret in it."""
    make = module._box

    def wider(kind: str, folder: Path) -> Box:
        box = make(kind, folder)
        return replace(box, readable=(*box.readable, resources.reference_source().parent))

    monkeypatch.setattr(module, "_box", wider)
    answer = f"reads {resources.reference_source()}"
    assert flaws(isolation) == ({answer}, {answer})


@pytest.mark.usefixtures("cache")
def test_a_probe_that_does_not_answer_is_a_flaw(monkeypatch: pytest.MonkeyPatch) -> None:
    """Silence proves nothing."""
    monkeypatch.setattr(module, "PROBE_MEMORY", 24 << 20)
    assert all("does not start" in flaw for flaw in flaws_or_fault(proved_isolation("B")))


def flaws_or_fault(isolation: Isolation) -> list[str]:
    """What the probe found, or why it could not even be confined."""
    try:
        return flaws_of(isolation)
    except WorkerFault as fault:
        return [f"does not start: {fault}"]
