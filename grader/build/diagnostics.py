"""What did the compiler and linker say, in a student's line numbers?

The text is hostile: a student chooses names, file names by `#line`, and message texts by
`#error`. Nothing here interprets it beyond splitting lines by a fixed pattern.
"""

import re

from grader.model.stages import SOURCE_PATH, Diagnostic

MAX_DIAGNOSTICS = 40
MAX_TEXT = 2000

_MESSAGE = re.compile(
    r"^(?P<file>[^:\n]{1,200}):(?P<line>\d{1,7}):(?:(?P<column>\d{1,6}):)? "
    r"(?P<severity>fatal error|error|warning|note): (?P<text>.*)$"
)
_REQUIRED = re.compile(
    rf"^{re.escape(SOURCE_PATH)}:(\d{{1,7}}):(\d{{1,6}}):   required from here$"
)
_NO_PLACE = re.compile(r"^(?:cc1plus|clang[-+.\w]{0,20}): (?:fatal )?error: (?P<text>.*)$")
"""What the compiler itself cannot do, such as reading a file that is out of reach."""

_ASSEMBLER = re.compile(r"^[^:\n]{1,200}\.s:\d{1,9}: Error: (?P<text>.*)$")
"""What only the assembler notices; its own file's name is another one each time."""

_QUOTED = re.compile(r"^ *\d* \|")
"""A line of the student's that the compiler quotes, and what it draws below."""

_LINKER = re.compile(r"(?P<text>(multiple definition of|undefined reference to) [^;]*)")


def read_diagnostics(stderr: bytes) -> tuple[Diagnostic, ...]:
    """Split a compiler's output into messages: 40 of them, errors before all others."""
    found: list[Diagnostic] = []
    required = (0, 0)
    for line in stderr.decode("utf-8", errors="replace").split("\n"):
        place = _REQUIRED.match(line)
        diagnostic = _read_line(line[: 2 * MAX_TEXT], required)
        if place:
            required = int(place[1]), int(place[2])
        if diagnostic:
            found.append(diagnostic)
            required = (0, 0)
    errors = [each for each in found if each.severity == "error"][:MAX_DIAGNOSTICS]
    others = [each for each in found if each.severity != "error"]
    kept = {id(each) for each in errors + others[: MAX_DIAGNOSTICS - len(errors)]}
    return tuple(each for each in found if id(each) in kept)


def _read_line(line: str, required: tuple[int, int]) -> Diagnostic | None:
    """Read one line; `required` is the own place that a message elsewhere is due to."""
    match = _MESSAGE.match(line)
    if match:
        own = match["file"] == SOURCE_PATH
        where = "" if own else f"{match['file'].rsplit('/', 1)[-1]}:{match['line']}: "
        place = (int(match["line"]), int(match["column"] or 0)) if own else required
        return Diagnostic(
            line=place[0],
            column=place[1],
            severity="error" if "error" in match["severity"] else match["severity"],
            text=(where + match["text"])[:MAX_TEXT],
        )
    match = _NO_PLACE.match(line)
    if match:
        return Diagnostic(*required, "error", match["text"][:MAX_TEXT])
    match = _ASSEMBLER.match(line)
    if match:
        return Diagnostic(0, 0, "error", f"assembler: {match['text']}"[:MAX_TEXT])
    match = _LINKER.search(line)
    if match and not _QUOTED.match(line):
        return Diagnostic(0, 0, "error", f"link: {match['text']}"[:MAX_TEXT])
    return None
