"""Who calls whom in a submission, read from what the compiler makes of it.

The assembly text of a build without optimisation holds every call: nothing is inlined yet, and
overloads, templates and lambdas are already resolved to mangled names. A call through a pointer
is a call of `ANYTHING`, which in turn calls every function whose address is taken or stands in a table. The text is
the compiler's, but the names in it are the student's; they are compared and never used for
anything else.
"""

import re

from grader.build.diagnostics import SOURCE_NAME
from grader.model.stages import Call, CallGraph

ANYTHING = b"*"
"""Stands for whatever a pointer points to."""

MAX_CALLS = 200_000
"""A textbook solution has about 1,000; more than this is cut."""

_FUNCTION = re.compile(rb'^\s*\.type\s+"?([\w.$]{1,4096})"?,\s*[@%]function')
_LABEL = re.compile(rb'^"?([\w.$]{1,4096})"?:')
_NAME = re.compile(rb"[A-Za-z_][\w.$]{1,4096}")
_CALL = re.compile(rb"^(call|jmp|bl?$|b[lr]+$)")
_POINTER_CALL = re.compile(rb"^(call\w*\s+\*|blr\s)")
_TABLE = re.compile(rb"^\s*\.(?:quad|xword|8byte)\s+([\w.$]{1,4096})")
_FILE = re.compile(rb'^\s*\.file\s+(\d+)\s+(?:"[^"\n]*"\s+)?"([^"\n]*)"')
_LINE = re.compile(rb"^\s*\.loc\s+(\d+)\s+(\d{1,7})\b")


def read_assembly(text: bytes) -> CallGraph:
    """List the calls, and the line of the student's file at which each function begins."""
    rows = text.split(b"\n")
    functions = {match[1] for row in rows if (match := _FUNCTION.match(row))}
    own = {match[1] for row in rows if (match := _FILE.match(row)) and _is_own(match[2])}
    calls: dict[tuple[bytes, bytes], None] = {}
    lines: dict[bytes, int] = {}
    caller = b""
    for row in rows:
        if (label := _LABEL.match(row)) and label[1] in functions:
            caller = label[1]
        elif row.lstrip().startswith(b".size"):
            caller = b""
        elif not caller and (entry := _TABLE.match(row)) and entry[1] in functions:
            calls[ANYTHING, entry[1]] = None
        elif caller and (place := _LINE.match(row)):
            if place[1] in own:
                lines.setdefault(caller, int(place[2]))
        elif caller and len(calls) < MAX_CALLS:
            for call in _called(caller, row, functions):
                calls[call] = None
    return CallGraph(
        calls=tuple(Call(_text(a), _text(b)) for a, b in calls),
        lines=tuple((_text(name), line) for name, line in lines.items()),
    )


def _is_own(name: bytes) -> bool:
    return name.decode(errors="replace").endswith(SOURCE_NAME)


def _called(caller: bytes, row: bytes, functions: set[bytes]) -> list[tuple[bytes, bytes]]:
    """Calls in one instruction: of functions of this file, and of any C++ one elsewhere."""
    row = row.strip()
    if row.startswith(b"."):
        return []
    if _POINTER_CALL.match(row):
        return [(caller, ANYTHING)]
    words = row.split(None, 1)
    names = _NAME.findall(words[1]) if len(words) > 1 else []
    known = [name for name in names if name in functions or name.startswith(b"_Z")]
    direct = [(caller, name) for name in known]
    if _CALL.match(words[0] if words else b""):
        return direct
    return direct + [(ANYTHING, name) for name in known if name in functions]


def _text(name: bytes) -> str:
    return name.decode("ascii", errors="replace")
