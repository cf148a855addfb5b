"""What of a course travels to where submissions are graded? Its rubric, and its own scenes."""

import tomllib
from pathlib import Path, PurePath

from grader.errors import UsageError
from grader.package.archive import Member, below, files_of
from grader.score.rubric import load_rubric

RUBRIC = "rubric.toml"

KINDS = {".toml", ".npz", ".exr", ".answers"}
"""Files of a folder of scenes that a grade looks at."""


def course_files(rubric: Path) -> tuple[Member, ...]:
    """Read a rubric and the scenes that it names, each where the rubric will look for it.

    Raises:
        UsageError: The rubric is wrong, or its scenes lie where no archive can hold them.
    """
    content = rubric.read_bytes()
    folder = load_rubric(rubric).scenes
    own = Member(RUBRIC, content)
    if folder is None:
        return (own,)
    inside = PurePath(tomllib.loads(content.decode())["scenes"]["folder"])
    if inside.is_absolute() or not inside.parts or ".." in inside.parts:
        raise UsageError(
            f"{rubric}: its scenes lie in {folder}, but they have to travel with it; put that "
            "folder beside the rubric, and name it there without .. and /"
        )
    scenes = [one for one in files_of(folder) if PurePath(one.name).suffix in KINDS]
    return (own, *below(inside.as_posix(), scenes))
