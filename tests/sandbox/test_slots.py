"""Each box has a user of its own, as long as there are any."""

from pathlib import Path

import pytest

from grader.errors import WorkerFault
from grader.sandbox import slots
from grader.sandbox.slots import own_user


@pytest.mark.parametrize("fault", [None, RuntimeError])
def test_slots_are_given_back(fault: type[Exception] | None) -> None:
    """Also after a fault, and no lock stays open."""
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
