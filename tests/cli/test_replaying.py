"""`check --replay` speaks German, runs nothing hidden, and ignores no option."""

from dataclasses import replace
from pathlib import Path

import pytest
from rich.console import Console

import grader.replay
from grader.counterexample.written import to_text
from grader.model.counterexample import Counterexample, Replay
from grader.options import Options
from grader.replay import CHANGED
from grader.report.sheet import MAX_LINES, Sheet
from tests.cli.calls import FILE, Pipeline, call
from tests.report import samples
from tests.report.small_inputs import small, small_trace
from tests.test_selection import hiding

CHECK = small().check


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> list[Options]:
    """Answer every replay with a failure, and keep what was asked."""
    kept: list[Options] = []

    def answer(_: Path, __: Path, options: Options) -> Replay:
        kept.append(options)
        found = small_trace()
        return Replay(found.check, "Boxes are tight", found)

    monkeypatch.setattr(grader.replay, "replay", answer)
    monkeypatch.chdir(tmp_path)
    Path(FILE).parent.mkdir()
    Path(FILE).write_text("int main() {}\n")
    written(small())
    return kept


def written(found: Counterexample) -> None:
    """Write the file of a counterexample."""
    Path("file.json").write_text(to_text(found))


def test_a_replay_is_told_in_german(asked: list[Options]) -> None:
    """Labels, messages and where the hit was lost; the seed of the command is accepted."""
    result = call("check", FILE, "--replay", "file.json", "--language", "de", "--seed", "3")
    assert result.exit_code == 1, result.output
    for words in ("✗ nicht bestanden", "Eingabe", "5 Dreiecke, 1 Strahl", "nie besucht"):
        assert words in result.output
    assert asked[0].for_student


@pytest.mark.parametrize(
    ("undecided", "words"),
    [
        ("", f"{CHECK} ist mit dieser Eingabe jetzt bestanden."),
        ("it did not come back within 30 s", "es kam nicht innerhalb von 30 s zurück"),
        ("the build that this check runs could not be made", "ließ sich nicht bauen"),
        (f"it cannot be decided, because {CHECK} fails on this input", "weil " + CHECK),
        ("it does not compile; bvhgrade check says why", "bvhgrade check sagt, warum"),
        ("there is nothing here to decide it by", "hier ist nichts, woran"),
    ],
)
@pytest.mark.usefixtures("asked")
def test_what_became_of_it_is_told_in_german(
    monkeypatch: pytest.MonkeyPatch, undecided: str, words: str
) -> None:
    """A pass, and each way in which nothing is decided."""
    told = Replay(CHECK, "Boxes are tight", None, undecided)
    monkeypatch.setattr(grader.replay, "replay", lambda *_: told)
    result = call("check", FILE, "--replay", "file.json", "--language", "de")
    assert words in " ".join(result.output.split())
    assert result.exit_code == bool(undecided)
    assert ("blockiert" in result.output) == bool(undecided)
    assert "✗" not in result.output


@pytest.mark.usefixtures("asked")
def test_what_is_nobody_s_fault_is_told_in_german(monkeypatch: pytest.MonkeyPatch) -> None:
    """No check mark, no cross, and the status of a run that concludes nothing."""
    told = Replay(CHECK, "Boxes are tight", None, CHANGED, is_ours=True)
    monkeypatch.setattr(grader.replay, "replay", lambda *_: told)
    result = call("check", FILE, "--replay", "file.json", "--language", "de")
    output = " ".join(result.output.split())
    assert (result.exit_code, "auch die Musterlösung besteht" in output) == (3, True), output
    assert "Über die Abgabe sagt das nichts." in output
    assert not any(word in output for word in ("✗", "bestanden"))


@pytest.mark.parametrize(
    "option",
    [["--watch"], ["--quick"], ["--only", CHECK], ["--hints", "1"], ["--time-limit", "60"]],
)
def test_an_option_that_would_be_ignored_is_refused(
    asked: list[Options], option: list[str]
) -> None:
    """Wrong usage in one sentence, and nothing is run."""
    result = call("check", FILE, "--replay", "file.json", *option)
    assert (result.exit_code, asked) == (2, [])
    assert f"leave out {option[0]}" in " ".join(result.output.split())


def test_a_hidden_check_is_not_run_from_a_file(asked: list[Options], tmp_path: Path) -> None:
    """Anybody can write such a file; a check that the rubric shows is run."""
    rubric = str(hiding(tmp_path, CHECK))
    result = call("check", FILE, "--replay", "file.json", "--rubric", rubric)
    assert (result.exit_code, asked) == (2, [])
    assert f"the rubric hides {CHECK}, so it is not run here" in " ".join(result.output.split())
    written(replace(small(), check="bvh.root-holds-all-faces"))
    assert call("check", FILE, "--replay", "file.json", "--rubric", rubric).exit_code == 1


def test_the_quick_run_and_the_watch_speak_german(
    pipeline: Pipeline, monkeypatch: pytest.MonkeyPatch
) -> None:
    """And so does what stands for the lines that were left out."""
    pipeline.answer = samples.perfect
    result = call("check", FILE, "--quick", "--language", "de")
    assert "Dies war der schnelle Lauf" in result.output
    monkeypatch.setattr("grader.cli.watching.watch", lambda *_: None)
    result = call("check", FILE, "--watch", "--language", "de")
    assert f"Beobachtet wird {FILE}; Strg-C beendet es." in result.output
    sheet = Sheet(Console(width=80), lambda text: text.replace("lines", "Zeilen"))
    assert "[... 9 Zeilen ...]" in sheet.wrapped("\n".join("x" * (MAX_LINES + 8)), 80)
