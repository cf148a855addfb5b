"""`export` and `--format`: files, exit statuses, and what is said about them."""

import json
import sys
from pathlib import Path

import pytest

from grader.report.formats import FORMATS
from tests.cli.calls import FILE, Pipeline, Waiting, call
from tests.gradebook import rules, sheets
from tests.gradebook.folders import CLASS, write_class
from tests.report import samples


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Start in an empty folder, in English."""
    monkeypatch.setenv("LC_ALL", "C.UTF-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_a_worksheet_is_filled_in_place() -> None:
    """It keeps its rights; nothing else is left beside it, and what is missing is told."""
    write_class(Path("class"), CLASS)
    sheet = Path("sheet.csv")
    sheet.write_bytes(sheets.ENGLISH.encode())
    sheet.chmod(0o600)
    result = call("export", "moodle", "class", "--worksheet", "sheet.csv")
    assert result.exit_code == 1
    assert result.stdout == "4 of 7 rows filled: sheet.csv\n"
    assert "no result: row 5: Participant 999, Ada Lovelace\n" in result.stderr
    assert "look at this: Our Fault_106_assignsubmission_file: row 2 is left" in result.stderr
    assert rules.moodle_worksheet(sheet.read_bytes(), "en")[101][0] == 50
    assert sheet.stat().st_mode & 0o777 == 0o600
    assert sorted(each.name for each in Path().iterdir()) == ["class", "sheet.csv"]


def test_a_large_class_shows_that_it_goes_on(monkeypatch: pytest.MonkeyPatch) -> None:
    """The line is gone before anything is told."""
    waiting = Waiting()
    # The package has the command by that name.
    module = sys.modules["grader.cli.export"]
    monkeypatch.setattr(module, "shown", waiting.shown)
    monkeypatch.setattr(module, "tell", lambda *_: waiting.works.append("told"))
    write_class(Path("class"), {"ada": "right"})
    assert call("export", "csv", "class").exit_code == 0
    assert (waiting.works, waiting.is_over) == (["reading the results", "told"], True)


def test_a_student_who_handed_in_nothing_is_told_and_is_no_failure() -> None:
    """Every result is in the file, which is what the status says."""
    write_class(Path("class"), {"Ada Lovelace_101_assignsubmission_file": "right"})
    Path("sheet.csv").write_bytes(sheets.GERMAN.encode())
    words = ("export", "moodle", "class", "--worksheet", "sheet.csv", "-o", "new.csv")
    result = call(*words)
    assert result.exit_code == 0
    assert result.stderr == "no result: row 2: Teilnehmer/in102, Grace Hopper\n"
    assert Path("sheet.csv").read_bytes() == sheets.GERMAN.encode()
    assert rules.moodle_worksheet(Path("new.csv").read_bytes(), "de", ";")[101][0] == 50


def test_a_link_to_a_worksheet_stays_a_link() -> None:
    """The file behind it is filled."""
    write_class(Path("class"), {"ada": "right"})
    Path("real.csv").write_text("student,score\nada,\n")
    Path("sheet.csv").symlink_to("real.csv")
    assert call("export", "csv", "class", "--worksheet", "sheet.csv").exit_code == 0
    assert Path("sheet.csv").is_symlink()
    assert Path("real.csv").read_text() == "student,score\nada,50\n"


def test_a_list_is_made_from_nothing() -> None:
    """In the words of the language that was asked for."""
    write_class(Path("class"), {"ada": "right"})
    result = call("export", "csv", "class", "--language", "de")
    assert (result.exit_code, result.stdout) == (0, "1 of 1 rows filled: grades.csv\n")
    assert "50 von 50" in Path("grades.csv").read_text()


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["canvas", "class"], "Export Entire Gradebook"),
        (["csv", "empty"], "no result.json below it"),
        (["csv", "damaged"], "damaged/eve/result.json: it is not JSON"),
        (["csv", "class", "--worksheet", "sheet.csv"], "sheet.csv: no columns may be the one"),
        (["csv", "class", "--worksheet", "sheet.csv", "--grade-column", "b"], "no row has any"),
        (["csv", "class", "--worksheet", "class"], "class"),
        (["csv", "class", "--worksheet", "nowhere.csv"], "nowhere.csv"),
        (["csv", "nowhere"], "nowhere"),
        (["excel", "class"], "excel"),
        (["csv"], "DIR"),
    ],
)
def test_wrong_usage_writes_nothing(words: list[str], said: str) -> None:
    """Exit status 2, a sentence that says where, no traceback, no file."""
    write_class(Path("class"), {"ada": "right"})
    write_class(Path("damaged"), {"ada": "right"})
    Path("empty").mkdir()
    Path("damaged/eve").mkdir()
    Path("damaged/eve/result.json").write_text('{"schema": 1,')
    Path("sheet.csv").write_text("student,b\nbob,\n")
    before = sorted(Path().rglob("*"))
    result = call("export", *words)
    assert result.exit_code == 2
    assert said in result.stderr
    assert "Traceback" not in result.output
    assert sorted(Path().rglob("*")) == before
    assert Path("sheet.csv").read_text() == "student,b\nbob,\n"


def test_a_file_that_cannot_be_written_leaves_the_old_one() -> None:
    """The folder takes no new file, so there is no half of one either."""
    write_class(Path("class"), {"ada": "right"})
    Path("sheet.csv").write_text("student,score\nada,\n")
    words = ("export", "csv", "class", "--worksheet", "sheet.csv", "-o", "/proc/sheet.csv")
    result = call(*words)
    assert result.exit_code == 3
    assert "name another file with -o" in result.stderr


def test_a_hostile_name_of_a_folder_is_only_text() -> None:
    """On a terminal, and in a workflow's log."""
    name = "a\x1b[31m\n::error::fooled"
    write_class(Path("class"), {name: "right", "ada": "right"})
    Path("sheet.csv").write_text("student,score\nada,\n")
    result = call("export", "csv", "class", "--worksheet", "sheet.csv")
    assert result.exit_code == 1
    assert "\x1b" not in result.output
    assert "\n::error" not in result.output


def test_every_format_is_written_beside_the_result(pipeline: Pipeline) -> None:
    """Each into its own file, from what is in result.json; json alone adds nothing."""
    pipeline.answer = samples.failing
    names = [word for name in FORMATS for word in ("--format", name)]
    assert call("grade", FILE, "-o", "out", *names).exit_code == 0
    result = json.loads(Path("out/result.json").read_text())
    for written in (each for files in FORMATS.values() for each in files):
        assert Path("out", written.path).read_text() == written.write(result, str)
    assert call("grade", FILE, "-o", "plain", "--format", "json").exit_code == 0
    always = {"counterexamples", "result.json", "report.html"}
    assert {each.name for each in Path("plain").iterdir()} == always


def test_a_format_is_written_in_the_language_that_was_asked_for(pipeline: Pipeline) -> None:
    """Of the command line, with the words of the checks."""
    pipeline.answer = samples.failing
    call("grade", FILE, "-o", "out", "--format", "junit", "--language", "de")
    german = Path("out/junit.xml").read_text()
    assert "erwartet: " in german
    assert "expected: " not in german


def test_a_withheld_score_is_written_too(pipeline: Pipeline) -> None:
    """The status says that it is our fault; the host gets its file all the same."""
    pipeline.answer = samples.broken
    result = call("grade", FILE, "-o", "out", "--format", "prairielearn")
    assert result.exit_code == 3
    told = json.loads(Path("out/prairielearn/results.json").read_text())
    assert told["gradable"] is False


@pytest.mark.parametrize("name", ["excel", "html,json", ""])
def test_an_unknown_format_is_found_before_grading(pipeline: Pipeline, name: str) -> None:
    """With the names that there are."""
    result = call("grade", FILE, "--format", name)
    assert result.exit_code == 2
    assert "gradescope" in result.stderr
    assert not pipeline.asked


def test_a_format_that_cannot_be_written_is_found_before_grading(pipeline: Pipeline) -> None:
    """A file stands where its folder belongs."""
    Path("out").mkdir()
    Path("out/gradescope").write_text("in the way")
    result = call("grade", FILE, "-o", "out", "--format", "gradescope")
    assert result.exit_code == 2
    assert not pipeline.asked
