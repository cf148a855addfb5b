"""Each box has a user of its own, as long as there are any."""

import os
import subprocess
from pathlib import Path

import pytest

from grader.errors import WorkerFault
from grader.sandbox import slots
from grader.sandbox.reaping import adopt_orphans
from grader.sandbox.slots import SLOTS, own_user
from tests.sandbox.census import state_of

UID = slots.FIRST_UID + SLOTS
"""Just beyond the users of submissions."""


@pytest.mark.parametrize("fault", [None, RuntimeError])
def test_slots_are_given_back(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, fault: type[Exception] | None
) -> None:
    """Also after a fault, and no lock stays open."""
    monkeypatch.setattr(slots, "FOLDER", tmp_path)
    # Not those of boxes that live now: they are in other locks.
    monkeypatch.setattr(slots, "FIRST_UID", UID)
    before = len(list(Path("/proc/self/fd").iterdir()))
    users = []
    for _ in range(3):
        try:
            with own_user() as user:
                users.append(user)
                with own_user() as other:
                    assert not user or other != user
                if fault:
                    raise fault
        except RuntimeError:
            pass
    assert users == [users[0]] * 3
    assert len(list(Path("/proc/self/fd").iterdir())) == before


def test_too_many_graders_are_told(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """When all users are taken the sentence says what to do."""
    monkeypatch.setattr(slots, "is_root", lambda: True)
    monkeypatch.setattr(slots, "SLOTS", 1)
    monkeypatch.setattr(slots, "FOLDER", tmp_path / "slots")
    full = r"all 1 users .* grade fewer at a time"
    with own_user(), pytest.raises(WorkerFault, match=full), own_user():
        pass
    monkeypatch.setattr(slots, "FOLDER", tmp_path / "no" / "such")
    with pytest.raises(WorkerFault, match="No such file"), own_user():
        pass


def test_what_outlived_a_killed_grader_is_ended(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Its lock file is not empty: a process of that user would count against the next one.

    Ended and nobody's child, it is ours, and would count for ever if we took no note.
    """
    monkeypatch.setattr(slots, "is_root", lambda: True)
    monkeypatch.setattr(slots, "FOLDER", tmp_path)
    # A user of no box and of no other test, or our own process would be ended too.
    user = UID + 1 if os.geteuid() == 0 else os.geteuid()
    monkeypatch.setattr(slots, "FIRST_UID", user)
    orphan = orphan_of(user)
    processes = slots._processes_of
    monkeypatch.setattr(
        slots,
        "_processes_of",
        lambda uid: {pid: told for pid, told in processes(uid).items() if pid == orphan},
    )
    with own_user():
        assert (tmp_path / "0").read_bytes() == b"in use"
        assert state_of(orphan) not in {"", "Z"}
    assert (tmp_path / "0").read_bytes() == b""
    (tmp_path / "0").write_bytes(b"in use")
    with own_user() as given:
        assert given == user
        assert state_of(orphan) == ""


def orphan_of(user: int) -> int:
    """Start a process that this one adopts."""
    adopt_orphans()
    said = subprocess.run(
        ["/bin/sh", "-c", "sleep 600 >/dev/null 2>&1 & echo $!"],
        user=user if os.geteuid() == 0 else None,
        capture_output=True,
        check=True,
    )
    return int(said.stdout)


@pytest.mark.parametrize("is_zombie", [False, True])
def test_a_user_whose_processes_stay_is_passed_over(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, is_zombie: bool
) -> None:
    """What cannot be killed keeps its number, and so does what another has to reap."""
    monkeypatch.setattr(slots, "is_root", lambda: True)
    monkeypatch.setattr(slots, "FOLDER", tmp_path)
    # Nobody waits for what is over already.
    monkeypatch.setattr(slots, "PATIENCE_SECONDS", 3600.0 if is_zombie else 0.05)
    monkeypatch.setattr(slots, "_processes_of", lambda _: {os.getppid(): is_zombie})
    monkeypatch.setattr(slots, "_kill", lambda *_: None)
    (tmp_path / "0").write_bytes(b"in use")
    with own_user() as user:
        assert user == slots.FIRST_UID + 1
    assert (tmp_path / "0").read_bytes() == b"in use"
