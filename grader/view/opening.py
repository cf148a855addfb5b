"""What is opened, and where: a window, a page or a file."""

from dataclasses import dataclass, replace
from datetime import datetime
from pathlib import Path

from grader.errors import UsageError
from grader.language import Words, translator
from grader.model.grade import CheckScore
from grader.model.verdict import Verdict
from grader.options import Options
from grader.output import OUTPUT
from grader.phrases import teller
from grader.plain import as_name, one_line
from grader.report.facts import counterexample_file
from grader.selection import require_check
from grader.view.desk import Desk, Load
from grader.view.status import is_vain
from grader.view.study import Study
from grader.view.subject import (
    Subject,
    of_file,
    of_scene,
    of_trial,
    own_scenes,
    scene_folder,
    scene_folders,
)

USUAL_SCENE = "dragon"


@dataclass(frozen=True, slots=True)
class Wish:
    """What somebody wants to look at."""

    path: Path
    options: Options
    scene: str | None
    check: str | None
    """Id of a check, or the file of a counterexample."""

    language: str = "en"

    @property
    def words(self) -> Words:
        """What translates into it."""
        return translator(self.language)


def opening(wish: Wish, web: bool, picture: Path | None) -> str:
    """Show what is wished for, until it is closed.

    Returns:
        What the submission did, if a picture is not all its own; otherwise empty.

    Raises:
        UsageError: The scene, the check or the path is wrong.
        MissingTool: The packages are not installed, or there is no display.
        GraderError: Our own fault; nothing is concluded about the submission.
    """
    first = wanted(wish)
    with Desk(wish.path, wish.options, first) as desk:
        study = Study(desk, wish.words, teller(wish.language))
        try:
            return _shown(wish, study, desk, web, picture)
        finally:
            study.close()


def _shown(wish: Wish, study: Study, desk: Desk, web: bool, picture: Path | None) -> str:
    names = list(scene_folders(own_scenes(wish.options)))
    if picture is not None:
        from grader.view.screenshot import screenshot

        return screenshot(desk, study, picture)
    if web:
        from grader.view.server import served

        served(desk, study, names, wish.language)
    else:
        from grader.view.window import Window, opened

        opened(
            Window(desk, study, names, wish.words), f"bvhgrade view {as_name(wish.path.name)}"
        )
    if is_vain(desk) and desk.fault is not None:
        raise desk.fault
    return ""


def wanted(wish: Wish) -> Load:
    """Say what is shown first.

    Raises:
        UsageError: There is no such scene, check or counterexample.
    """
    if wish.check is None:
        name, own = wish.scene or USUAL_SCENE, own_scenes(wish.options)
        scene_folder(name, own)
        return lambda: of_scene(name, own)
    if wish.check.endswith(".json"):
        named = of_file(Path(wish.check))
        return lambda: named
    require_check(wish.options.rubric, wish.check, "--check")
    for folder in (wish.path, wish.path.parent / OUTPUT, Path(OUTPUT)):
        file = folder / counterexample_file(wish.check)
        if file.is_file() and (found := _found(file, wish.words)).check == wish.check:
            return lambda: found
    return lambda: _searched(wish, wish.check or "")


def _found(file: Path, words: Words) -> Subject:
    """Open a counterexample that lies there, and say so: it may be an old one."""
    written = datetime.fromtimestamp(file.stat().st_mtime)
    text = words("The counterexample is {file} of {when}.")
    told = text.format(file=file, when=f"{written:%Y-%m-%d %H:%M}")
    return replace(of_file(file), origin=told)


def _searched(wish: Wish, check: str) -> Subject:
    """Grade for this check alone, and show the smallest input that fails it.

    Raises:
        UsageError: It does not fail, cannot be decided, or only on inputs that are not small.
    """
    from grader.pipeline import grade_one

    grade = grade_one(wish.path, replace(wish.options, only=(check,), counterexamples=True))
    (one,) = (one for one in grade.checks if one.check == check)
    if one.counterexample is None:
        raise UsageError(f"{check}: {_why_none(one)}")
    return of_trial(check, one.counterexample.trial, one.counterexample.message)


def _why_none(one: CheckScore) -> str:
    """Say why there is no input to show."""
    if one.verdict is Verdict.PASS:
        return "it passes, so there is no input that fails it"
    if one.verdict is Verdict.FAIL:
        return f"it fails, but no small input was found: {one_line(one.message)}"
    if one.blocked_by:
        return f"it is not decided, because {one.blocked_by} fails first"
    return f"it is not decided: {one_line(one.message)}"
