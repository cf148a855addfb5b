"""What has every host that grades? The grader, how to install it, and the course's choices."""

import shlex
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path, PurePath

from grader.errors import UsageError
from grader.package.archive import Member, below
from grader.package.course import RUBRIC, course_files
from grader.package.wheel import own_wheel, pinned

FOLDER = "bvhgrade"
"""Of the kit in an archive."""

KEPT_NAMES = ("install.sh", "grade.sh", "environment.sh", "settings.sh", "constraints.txt")
"""Files of the kit, and of what it makes; a course's folder of scenes cannot be called so."""

KEPT_FOLDERS = ("wheels", "venv", "cache")


@dataclass(frozen=True, slots=True)
class Choices:
    """What a course decides about the grader that it installs elsewhere."""

    rubric: Path | None = None
    """Instead of the built-in one; its own scenes come along."""

    seed: int | None = None
    wheels: Path | None = None
    """Wheels of all that the grader needs (`pip download`), for a host without PyPI."""


def kit(choices: Choices, *options: str) -> tuple[Member, ...]:
    """Collect the kit.

    Args:
        choices: The course's.
        options: The host's, for every call of `bvhgrade grade`.

    Raises:
        UsageError: The rubric is wrong, its scenes lie outside of its folder, or the folder of
            wheels holds none.
        GraderError: The installation is damaged.
    """
    return below(FOLDER, _members(choices, options))


def ours(name: str, as_name: str = "") -> Member:
    """Read a script of this package."""
    data = Path(__file__).with_name("files").joinpath(name).read_bytes()
    return Member(as_name or name, data, executable=not name.endswith(".yml"))


def _members(choices: Choices, options: tuple[str, ...]) -> Iterator[Member]:
    yield ours("install.sh")
    yield ours("grade.sh")
    yield Member("constraints.txt", pinned().encode())
    yield Member("settings.sh", _settings(choices, options).encode())
    yield from below("wheels", [own_wheel(), *_wheels(choices.wheels)])
    if choices.rubric:
        yield from _course(choices.rubric)


def _settings(choices: Choices, options: tuple[str, ...]) -> str:
    """Write the list of options that grade.sh adds to every call."""
    chosen = list(options)
    if choices.seed is not None:
        chosen += ["--seed", str(choices.seed)]
    words = [shlex.quote(word) for word in chosen]
    if choices.rubric:
        words += ["--rubric", f'"$here/{RUBRIC}"']
    return f"# Options of `bvhgrade grade` for this course.\nchosen=({' '.join(words)})\n"


def _course(rubric: Path) -> tuple[Member, ...]:
    """Read what belongs to a course.

    Raises:
        UsageError: The rubric is wrong, or its scenes are called like a part of the kit.
    """
    files = course_files(rubric)
    for one in files:
        first = PurePath(one.name).parts[0]
        if first in (*KEPT_NAMES, *KEPT_FOLDERS):
            raise UsageError(
                f"{rubric}: its scenes lie in {first}, but the package has something else of "
                "that name; rename the folder"
            )
    return files


def _wheels(folder: Path | None) -> tuple[Member, ...]:
    if folder is None:
        return ()
    found = tuple(
        Member(path.name, path.read_bytes())
        for path in sorted(folder.glob("*.whl"))
        if not path.name.startswith("bvhgrade-")
    )
    if not any(one.name.startswith("numpy-") for one in found):
        raise UsageError(
            f"{folder}: no wheel of numpy is there, but --wheels names a folder with all that "
            "the grader needs; docs/instructor.md says how to fill it"
        )
    return found
