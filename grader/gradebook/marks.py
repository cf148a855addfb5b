"""What do platforms write before the name of a student's file? The first mark is theirs.

Whatever follows is a stranger's text, which may hold a mark as well. Sources: Moodle,
mod/assign/locallib.php (`Ada Lovelace_123_assignsubmission_file`, 123 being what the worksheet
calls Participant 123); Canvas, `Download Submissions` (`lovelaceada_LATE_9001_55_exercise03`,
9001 being the user's ID).
"""

import re
from dataclasses import dataclass

_MOODLE = re.compile(
    r"(?P<full_name>.+?)_(?P<participant>\d+)_assignsubmission_(?P<rest>.*)", re.DOTALL
)
_OF_CANVAS = re.compile(r"_\d+_\d+_|^(?:LATE_)?anon_[A-Za-z0-9]+_\d+_")

ARCHIVES = (".zip", ".tar", ".tar.gz", ".tgz")
HANDED_IN = (".cpp", ".cc", ".cxx", *ARCHIVES)
"""How the name of a file may end that somebody handed in; none of the grader's own does."""

MEANT = (
    *(".rar", ".7z", ".gz", ".bz2", ".xz", ".tar.bz2", ".tar.xz"),
    *(".c", ".c++", ".cpp.txt", ".cc.txt", ".cxx.txt"),
)
"""How one ends that was meant as a submission, but is packed or called otherwise."""


@dataclass(frozen=True, slots=True)
class Mark:
    """What Moodle tells of a file or a folder."""

    full_name: str
    participant: str
    plugin: str
    """`file` or `onlinetext`: how it was handed in."""

    file: str
    """What it was called then; empty for a folder."""


def moodle_mark(name: str) -> Mark | None:
    """Read Moodle's mark; None if there is none, or if one of Canvas comes before it."""
    found = _MOODLE.match(name)
    if found is None or _OF_CANVAS.search(f"{found['full_name']}_"):
        return None
    plugin, _, file = found["rest"].partition("_")
    return Mark(found["full_name"], found["participant"], plugin, file)
