"""Limits that a process sets for itself before a stranger's code is in it."""

import resource

import pytest

from grader.sandbox.inside import enter


@pytest.mark.parametrize(("hard", "core"), [(0, 0), (resource.RLIM_INFINITY, 1), (4096, 1)])
def test_a_limit_that_is_lower_already_is_not_raised(
    hard: int, core: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Only root may raise a hard limit: where core files are forbidden, no box would start."""
    wanted: dict[int, tuple[int, int]] = {}
    monkeypatch.setattr(resource, "getrlimit", lambda _: (0, hard))
    monkeypatch.setattr(resource, "setrlimit", wanted.__setitem__)
    enter.limit({})
    assert wanted[resource.RLIMIT_CORE] == (core, core)
