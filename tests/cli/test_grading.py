"""`check` and `grade`: results, exit statuses, and every way of calling them wrongly."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

from tests.cli.calls import FILE, WRITTEN, Pipeline, call
from tests.report import samples


@pytest.mark.parametrize(
    ("name", "status"),
    [
        ("perfect", 0),
        ("failing", 1),
        ("starter", 1),
        ("uncompiled", 1),
        ("rejected", 1),
        ("broken", 3),
    ],
)
def test_check_tells_full_marks_lost_points_and_our_fault_apart(
    pipeline: Pipeline, name: str, status: int
) -> None:
    """And writes a result in every case."""
    pipeline.answer = samples.EVERY[name]
    result = call("check", FILE)
    assert result.exit_code == status
    assert json.loads(Path(WRITTEN).read_text())["schema"] == 1
    assert "bvhgrade-out/report.html" in result.stdout
    assert "<!doctype html>" in Path("bvhgrade-out/report.html").read_text()


@pytest.mark.parametrize("name", samples.EVERY)
def test_grade_succeeds_whenever_there_is_a_grade(pipeline: Pipeline, name: str) -> None:
    """Only a withheld score is our fault, and even then the result is written."""
    pipeline.answer = samples.EVERY[name]
    result = call("grade", FILE, "-o", "deep/er")
    assert result.exit_code == (3 if name == "broken" else 0)
    written = json.loads(Path("deep/er/result.json").read_text())
    assert (written["score"] is None) == (name == "broken")
    assert Path("deep/er/counterexamples").exists() == (name == "failing")


def test_the_files_that_a_result_names_are_there_and_no_others(pipeline: Pipeline) -> None:
    """What an earlier grade left behind for a check that passes now is removed."""
    pipeline.answer = samples.failing
    call("grade", FILE)
    folder = Path("bvhgrade-out")
    named = [
        one["counterexample"]["file"]
        for one in json.loads(Path(WRITTEN).read_text())["checks"]
        if one["counterexample"]
    ]
    assert len(named) == 2
    for name in named:
        assert json.loads((folder / name).read_text())["meshes"][0]["faces"]
    pipeline.answer = samples.perfect
    call("check", FILE)
    assert not list((folder / "counterexamples").iterdir())
    assert [options.for_student for _, options in pipeline.asked] == [False, True]


def test_options_reach_the_pipeline(pipeline: Pipeline) -> None:
    """Nothing that was typed is lost."""
    Path("own.toml").write_text("")
    call("check", FILE, "--only", "a.b", "--only", "c.d", "--seed", "7", "--rubric", "own.toml")
    ((path, options),) = pipeline.asked
    assert path == Path(FILE)
    assert (options.seed, options.rubric) == (7, Path("own.toml"))
    assert options.only == ("a.b", "c.d")


def test_only_the_checks_that_were_asked_for_decide_the_status(pipeline: Pipeline) -> None:
    """A gate of the other part may run on the way and fail."""
    pipeline.answer = samples.failing
    assert call("check", FILE, "--only", "bvh.root-holds-all-faces").exit_code == 0
    assert call("check", FILE, "--only", "hits.closest-wins").exit_code == 1


def test_the_default_seed_is_the_same_for_both(pipeline: Pipeline) -> None:
    """A student sees at home what the course sees."""
    call("check", FILE)
    call("grade", FILE)
    assert {options.seed for _, options in pipeline.asked} == {41}


def test_check_finds_the_student_s_own_file(pipeline: Pipeline) -> None:
    """In the framework's folder, else in the stub beside the grader."""
    call("check")
    Path(FILE).unlink()
    Path("student_stub/src").mkdir(parents=True)
    Path("student_stub", FILE).write_text("")
    call("check")
    assert [path for path, _ in pipeline.asked] == [Path(FILE), Path("student_stub", FILE)]


def test_check_says_where_it_looked(pipeline: Pipeline) -> None:
    """Somebody in the wrong folder learns what to type."""
    Path(FILE).unlink()
    result = call("check")
    assert result.exit_code == 2
    assert FILE in result.stderr
    assert "bvhgrade check FILE" in result.stderr
    assert not pipeline.asked


def test_the_repeated_command_can_be_pasted(pipeline: Pipeline) -> None:
    """Also from a folder with a space in its name, with another seed and rubric."""
    pipeline.answer = samples.failing
    Path("my code").mkdir()
    Path("my code/own.toml").write_text("")
    Path(FILE).rename("my code/exercise03.cpp")
    result = call("check", "my code", "--seed", "3", "--rubric", "my code/own.toml")
    command = "bvhgrade check 'my code' --seed 3 --rubric 'my code/own.toml' --only hits."
    assert command in result.stdout


@pytest.mark.parametrize(
    "words",
    [
        ["check", "nowhere.cpp"],
        ["grade", "nowhere.cpp"],
        ["grade"],
        ["grade", FILE, "--seed", "minus"],
        ["grade", FILE, "--seed", "-1"],
        ["grade", FILE, "--seed", "4294967296"],
        ["grade", FILE, "--format", "pdf"],
        ["grade", FILE, "--rubric", "nowhere.toml"],
        ["grade", FILE, "--rubric", "src"],
        ["grade", FILE, "extra"],
        ["check", "--unknown"],
        ["check", "--only"],
        ["unknown"],
        ["grade", FILE, "-o", FILE],
        ["grade", FILE, "-o", f"{FILE}/below"],
        ["grade", FILE, "-o", "/dev/null/x"],
        ["grade", FILE, "-o", "/proc/nowhere"],
        ["grade", FILE, "-o", "a\nb" + "x" * 300],
    ],
)
def test_wrong_usage_is_found_before_grading(pipeline: Pipeline, words: list[str]) -> None:
    """Exit status 2, a sentence, no traceback."""
    result = call(*words)
    assert result.exit_code == 2
    assert result.stderr
    assert "Traceback" not in result.output
    assert not pipeline.asked


def test_a_result_that_is_a_folder_is_found_before_grading(pipeline: Pipeline) -> None:
    """It could not be replaced afterwards."""
    Path("out/result.json").mkdir(parents=True)
    result = call("grade", FILE, "-o", "out")
    assert result.exit_code == 2
    assert not pipeline.asked


@pytest.mark.parametrize("words", [["-o", "out"], ["-o", "link/out"], ["-o", "link"]])
@pytest.mark.parametrize("link", ["out/github", "link"])
def test_nothing_is_graded_through_a_link_that_was_handed_in(
    pipeline: Pipeline, tmp_path: Path, link: str, words: list[str]
) -> None:
    """It may lead into somebody else's folder, whose result would be replaced."""
    Path(link).parent.mkdir(exist_ok=True)
    other = tmp_path / "other"
    other.mkdir()
    Path(link).symlink_to(other)
    result = call("grade", FILE, *words, "--format", "github")
    through = words[1].startswith("link") == link.startswith("link")
    assert bool(pipeline.asked) == (result.exit_code == 0) == (not through)
    assert list(other.iterdir()) == []


def test_check_falls_back_on_the_cache_if_nothing_may_be_written_here(
    pipeline: Pipeline, tmp_path: Path
) -> None:
    """A student may grade from a medium that cannot be written."""
    Path("bvhgrade-out").write_text("in the way")
    result = call("check", FILE)
    assert result.exit_code == 0
    assert (tmp_path / "cache" / "bvhgrade-out" / "result.json").is_file()


def test_check_says_what_helps_if_it_may_write_nowhere(
    pipeline: Pipeline, tmp_path: Path
) -> None:
    """It has no -o."""
    (tmp_path / "cache").mkdir()
    for folder in (Path(), tmp_path / "cache"):
        (folder / "bvhgrade-out").write_text("in the way")
    result = call("check", FILE)
    assert result.exit_code == 2
    assert "cache/bvhgrade-out: File exists, but the result goes there; " in result.stderr
    assert "set BVHGRADE_CACHE" in result.stderr
    assert " -o" not in result.stderr
    assert not pipeline.asked


def test_check_names_no_option_that_it_lacks(pipeline: Pipeline) -> None:
    """What lies in its folder is found when the result is written."""
    pipeline.answer = samples.failing
    out = Path("bvhgrade-out")
    out.mkdir()
    for text in ("", "notes"):
        if text:
            (out / "counterexamples").write_text(text)
        else:
            (out / "counterexamples").symlink_to("src")
        result = call("check", FILE)
        assert result.exit_code == 2
        assert "; remove " in result.stderr
        assert " -o" not in result.stderr
        (out / "counterexamples").unlink()


@pytest.mark.parametrize(
    ("name", "line"),
    [
        ("failing", "10.5 of 50  s0427"),
        ("broken", "withheld of 50  s0427"),
        ("rejected", "0 of 50  s0428"),
    ],
)
def test_quiet_prints_one_line(pipeline: Pipeline, name: str, line: str) -> None:
    """Points first, so that no name of a student begins a line."""
    pipeline.answer = samples.EVERY[name]
    assert call("grade", FILE, "--quiet").stdout == line + "\n"


def test_a_grade_without_any_check_is_no_success(pipeline: Pipeline) -> None:
    """What examined nothing never passes."""
    pipeline.answer = lambda: replace(samples.perfect(), checks=())
    assert call("check", FILE).exit_code == 1
