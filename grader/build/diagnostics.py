"""What did the compiler and linker say, in a student's line numbers?

The text is hostile: a student chooses names, file names by `#line`, and message texts by
`#error`. Nothing here interprets it beyond splitting lines by a fixed pattern.
"""

import re

from grader.model.stages import Diagnostic

SOURCE_NAME = "src/exercise03.cpp"
MAX_DIAGNOSTICS = 40
MAX_TEXT = 2000

_MESSAGE = re.compile(
    r"^(?P<file>[^:\n]{1,200}):(?P<line>\d{1,7}):(?:(?P<column>\d{1,6}):)? "
    r"(?P<severity>fatal error|error|warning|note): (?P<text>.*)$"
)
_LINKER = re.compile(r"(?P<text>(multiple definition of|undefined reference to) .*)$")


def read_diagnostics(stderr: bytes) -> tuple[Diagnostic, ...]:
    """Split a compiler's output into messages, the first 40 of them."""
    found: list[Diagnostic] = []
    for line in stderr.decode("utf-8", errors="replace").split("\n"):
        diagnostic = _read_line(line[: 2 * MAX_TEXT])
        if diagnostic:
            found.append(diagnostic)
        if len(found) == MAX_DIAGNOSTICS:
            break
    return tuple(found)


def _read_line(line: str) -> Diagnostic | None:
    match = _MESSAGE.match(line)
    if match:
        own = match["file"] == SOURCE_NAME
        where = "" if own else f"{match['file'].rsplit('/', 1)[-1]}:{match['line']}: "
        return Diagnostic(
            line=int(match["line"]) if own else 0,
            column=int(match["column"] or 0) if own else 0,
            severity="error" if "error" in match["severity"] else match["severity"],
            text=(where + match["text"])[:MAX_TEXT],
        )
    match = _LINKER.search(line)
    if match:
        return Diagnostic(0, 0, "error", f"link: {match['text']}"[:MAX_TEXT])
    return None
