"""Who calls whom in a submission, read from what the compiler makes of it.

The assembly text of a build without optimisation holds every call: nothing is inlined yet, and
overloads, templates and lambdas are already resolved to mangled names. A call through a pointer
is a call of `ANYTHING`, which in turn calls every function whose address is taken or stands in
a table. The text is the compiler's, but the names in it are the student's; they are compared
and never used for anything else.
"""

import re
from collections.abc import Iterator

from grader.build.diagnostics import SOURCE_NAME
from grader.model.stages import Call, CallGraph

ANYTHING = b"*"
"""Stands for whatever a pointer points to."""

MAX_CALLS = 200_000
"""A textbook solution has about 1,000; more than this is cut."""

_FUNCTION = re.compile(rb'^\s*\.type\s+"?([\w.$\x80-\xff]{1,4096})"?,\s*[@%]function')
_LABEL = re.compile(rb'^"?([\w.$\x80-\xff]{1,4096})"?:')
_NAME = re.compile(rb"[A-Za-z_\x80-\xff][\w.$\x80-\xff]{1,4096}")
_CALL = re.compile(rb"^(call|jmp|bl?$|b[lr]+$)")
_POINTER_CALL = re.compile(rb"^(call\w*\s+\*|blr\s)")
_TABLE = re.compile(rb"^\.(?:quad|xword|8byte)\s+([\w.$\x80-\xff]{1,4096})")
_FILE = re.compile(rb'^\s*\.file\s+(\d+)\s+(?:"[^"\n]*"\s+)?"([^"\n]*)"')
_LINE = re.compile(rb"^\s*\.loc\s+(\d+)\s+(\d{1,7})\b")


def read_assembly(text: bytes) -> CallGraph:
    """List the calls, and the line of the student's file at which each function begins."""
    rows = text.split(b"\n")
    functions = {match[1] for row in rows if (match := _FUNCTION.match(row))}
    own = {match[1] for row in rows if (match := _FILE.match(row)) and _is_own(match[2])}
    calls: dict[tuple[bytes, bytes], None] = {}
    lines: dict[bytes, int] = {}
    for caller, row in _placed(rows, functions):
        if (place := _LINE.match(row)) and caller and place[1] in own:
            lines.setdefault(caller, int(place[2]))
        elif len(calls) < MAX_CALLS:
            calls |= dict.fromkeys(_called(caller, row, functions))
    return CallGraph(
        calls=tuple(Call(_text(a), _text(b)) for a, b in calls),
        lines=tuple((_text(name), line) for name, line in lines.items()),
    )


def _placed(rows: list[bytes], functions: set[bytes]) -> Iterator[tuple[bytes, bytes]]:
    """Each row with the function it lies in; nothing for data."""
    caller = b""
    for row in rows:
        if label := _LABEL.match(row):
            caller = label[1] if label[1] in functions else caller
        elif row.lstrip().startswith(b".size"):
            caller = b""
        else:
            yield caller, row


def _is_own(name: bytes) -> bool:
    return name.decode(errors="replace").endswith(SOURCE_NAME)


def _called(caller: bytes, row: bytes, functions: set[bytes]) -> list[tuple[bytes, bytes]]:
    """Calls in one row: of functions of this file, and of any C++ one elsewhere."""
    row = row.strip()
    if not caller or row.startswith(b"."):
        entry = _TABLE.match(row)
        return [(ANYTHING, entry[1])] if entry and entry[1] in functions else []
    if _POINTER_CALL.match(row):
        return [(caller, ANYTHING)]
    words = row.split(None, 1)
    names = _NAME.findall(words[1]) if len(words) > 1 else []
    known = [name for name in names if name in functions or name.startswith(b"_Z")]
    direct = [(caller, name) for name in known]
    if words and _CALL.match(words[0]):
        return direct
    return direct + [(ANYTHING, name) for name in known if name in functions]


def _text(name: bytes) -> str:
    return name.decode("utf-8", errors="backslashreplace")
