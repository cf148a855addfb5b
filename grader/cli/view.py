"""The command `view`: a submission's tree and rays, looked at from any side."""

from contextlib import nullcontext
from pathlib import Path
from typing import Any

import click

from grader.cli.interrupts import interruptible
from grader.cli.options import (
    SEED,
    language_option,
    rubric_option,
    submission_type,
    unsafe_option,
)
from grader.cli.progress import shown, silent
from grader.cli.replaying import require_shown
from grader.cli.status import stop
from grader.errors import UsageError
from grader.language import usual_language

NOT_WHOLE = 1
"""Status after a picture that the submission did not finish, or could not begin."""


@click.command()
@click.argument("submission", type=submission_type)
@click.option("--scene", metavar="NAME", help="Begin with this scene (default: the dragon).")
@click.option("--check", metavar="ID", help="Begin with the input that fails this check.")
@click.option("--web", is_flag=True, help="Show it in a browser; needs no display here.")
@click.option(
    "--screenshot",
    type=click.Path(dir_okay=False, path_type=Path),
    metavar="PNG",
    help="Draw both panes into a file instead of a window.",
)
@rubric_option
@language_option
@unsafe_option
def view(submission: Path, web: bool, **given: Any) -> None:  # noqa: ANN401 - click's own
    """Look at a submission's tree and at the picture that it traces.

    Needs pip install "bvhgrade[view]", but for --web.

    Exit status: 0 closed, 1 the submission does not compile, or ended before its picture in a
    file was whole, 2 wrong usage, or a check that does not fail, 3 nothing can be shown.
    """
    from grader.counterexample.reading import read
    from grader.options import Options
    from grader.view.opening import Wish, opening

    scene, check, screenshot = (given[name] for name in ("scene", "check", "screenshot"))
    require_one(scene, check, web, screenshot)
    if check:
        named = read(Path(check)).check if check.endswith(".json") else check
        require_shown(given["rubric"], named, f"--check {check}")
    isolated = not given["unsafe_no_isolation"]
    options = Options(SEED, given["rubric"], (), silent, isolated=isolated, for_student=True)
    language = given["language"] or usual_language()
    # A window and a page show by themselves that something goes on.
    waiting = shown("drawing the picture") if screenshot else nullcontext()
    with interruptible(), waiting:
        trouble = opening(Wish(submission, options, scene, check, language), web, screenshot)
    if trouble:
        stop(f"{submission}: {trouble}", NOT_WHOLE)


def require_one(
    scene: str | None, check: str | None, web: bool, screenshot: Path | None
) -> None:
    """Refuse two beginnings, and two places.

    Raises:
        UsageError: There are two.
    """
    if scene and check:
        raise UsageError("--scene and --check both say what to begin with; give one of them")
    if web and screenshot:
        raise UsageError("--web and --screenshot both say where to show it; give one of them")
