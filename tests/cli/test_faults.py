"""`check` and `grade` when we are at fault: one sentence, and nothing is lost."""

from dataclasses import replace
from errno import ENOSPC
from pathlib import Path
from typing import NoReturn

import pytest

from grader.errors import BuildFault, MissingTool, UsageError
from tests.cli.calls import FILE, WRITTEN, Pipeline, call
from tests.report import samples


@pytest.mark.parametrize(
    ("fault", "status"),
    [
        (UsageError("hits.closest is no check; did you mean hits.closest-wins"), 2),
        (MissingTool("a C++ compiler is not installed"), 3),
        (BuildFault("the framework did not build:\n::error::x\n\x1b[31mred"), 3),
    ],
)
def test_known_faults_end_with_a_sentence(
    pipeline: Pipeline, fault: Exception, status: int
) -> None:
    """Only the first kind is the caller's, and no text in them acts."""
    pipeline.fail(fault)
    result = call("grade", FILE)
    assert result.exit_code == status
    assert all(line.startswith("bvhgrade: ") for line in result.stderr.splitlines())
    assert "\x1b" not in result.output
    assert not Path(WRITTEN).exists()


def test_an_unforeseen_fault_keeps_its_traceback_in_a_file(
    pipeline: Pipeline, tmp_path: Path
) -> None:
    """One sentence is shown, with the place of the rest."""
    pipeline.fail(KeyError("secret detail"))
    result = call("check", FILE)
    assert result.exit_code == 3
    assert "KeyError" in result.stderr
    assert "secret detail" not in result.output
    assert "Traceback" not in result.output
    (kept,) = (tmp_path / "cache" / "faults").iterdir()
    assert str(kept) in result.stderr
    assert "secret detail" in kept.read_text()


@pytest.mark.parametrize("command", ["check", "grade"])
def test_the_traceback_of_a_check_that_broke_is_kept_in_a_file(
    pipeline: Pipeline, tmp_path: Path, command: str
) -> None:
    """Whoever ran the command is told where, and the result tells nobody."""
    broken = replace(samples.broken(), traceback="Traceback: secret detail")
    pipeline.answer = lambda: broken
    result = call(command, FILE)
    assert result.exit_code == 3
    (noted,) = (tmp_path / "cache" / "faults").iterdir()
    assert noted.read_text() == "Traceback: secret detail"
    assert result.stderr == f"bvhgrade: What a maintainer needs is in {noted}\n"
    assert "secret" not in result.stdout
    for written in Path("bvhgrade-out").iterdir():
        assert "secret" not in written.read_text()


def test_a_traceback_survives_without_a_cache(
    pipeline: Pipeline, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The temporary folder holds it then."""
    monkeypatch.setenv("BVHGRADE_CACHE", f"{FILE}/cache")
    pipeline.fail(ZeroDivisionError())
    result = call("grade", FILE)
    assert result.exit_code == 3
    kept = Path(result.stderr.rsplit(" ", 1)[1].strip())
    assert "ZeroDivisionError" in kept.read_text()
    kept.unlink()


@pytest.mark.parametrize("step", ["tempfile.mkstemp", "grader.faults.printable"])
def test_a_full_disk_costs_the_traceback_alone(
    pipeline: Pipeline, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, step: str
) -> None:
    """Before it is written or in between: that is said, and no rest is left."""

    def full(*_: object, **__: object) -> NoReturn:
        raise OSError(ENOSPC, "No space left on device")

    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    monkeypatch.setattr(step, full)
    pipeline.fail(ZeroDivisionError())
    result = call("grade", FILE)
    assert result.exit_code == 3
    assert result.exception is None or isinstance(result.exception, SystemExit)
    assert result.stderr.splitlines()[1:] == [
        "bvhgrade: What a maintainer needs could not be kept: No space left on device"
    ]
    assert not list(tmp_path.rglob("fault-*"))


@pytest.mark.parametrize("fault", [KeyboardInterrupt(), SystemExit(7)])
def test_an_interruption_leaves_the_old_result(
    pipeline: Pipeline, fault: BaseException
) -> None:
    """Nothing is half written."""
    call("grade", FILE)
    before = Path(WRITTEN).read_bytes()
    pipeline.fail(fault)
    result = call("grade", FILE, "--seed", "9")
    assert result.exit_code == (130 if isinstance(fault, KeyboardInterrupt) else 7)
    assert Path(WRITTEN).read_bytes() == before
    assert {each.name for each in Path("bvhgrade-out").iterdir()} == {
        "result.json",
        "report.html",
    }


def test_a_result_that_cannot_be_replaced_is_our_fault(
    pipeline: Pipeline, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A full disk leaves the old result and no rest of the new one."""

    def full(self: Path, target: Path) -> Path:
        raise OSError(28, "No space left on device", str(target))

    call("grade", FILE)
    before = Path(WRITTEN).read_bytes()
    monkeypatch.setattr(Path, "replace", full)
    result = call("grade", FILE, "--seed", "9")
    assert result.exit_code == 3
    assert "No space left" in result.stderr
    assert Path(WRITTEN).read_bytes() == before
    assert {each.name for each in Path("bvhgrade-out").iterdir()} == {
        "result.json",
        "report.html",
    }
