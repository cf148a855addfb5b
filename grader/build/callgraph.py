"""Who calls whom in a submission, read from the compiler's own front end.

g++ writes its call graph by `-fcallgraph-info`; clang++ writes its intermediate code, whose
calls are listed here. Both run without optimisation, so nothing is inlined yet and overloads,
templates and lambdas are already resolved to mangled names.
"""

import re

from grader.model.stages import Call, CallGraph

MAX_CALLS = 200_000
"""A textbook solution has about 600; more than this is cut."""

_EDGE = re.compile(rb'^edge: \{ sourcename: "([^"\n]{1,4096})" targetname: "([^"\n]{1,4096})"')
_NODE = re.compile(
    rb'^node: \{ title: "([^"\n]{1,4096})" label: "[^"\n]*\\nsrc/exercise03\.cpp:(\d{1,7}):'
)
_DEFINE = re.compile(rb'^define [^@\n]*@"?([\w.$]{1,4096})"?\(')
_CALL = re.compile(rb'\b(?:call|invoke) [^@\n]*@"?([\w.$]{1,4096})"?\(')


def read_vcg(text: bytes) -> CallGraph:
    """Read the file that g++ writes for `-fcallgraph-info`."""
    calls: list[Call] = []
    lines: list[tuple[str, int]] = []
    for row in text.split(b"\n"):
        if (edge := _EDGE.match(row)) and len(calls) < MAX_CALLS:
            calls.append(Call(_symbol(edge[1]), _symbol(edge[2])))
        elif node := _NODE.match(row):
            lines.append((_symbol(node[1]), int(node[2])))
    return CallGraph(tuple(calls), tuple(lines))


def read_llvm(text: bytes) -> CallGraph:
    """Read the textual intermediate code of clang++; it names no lines without debug info."""
    calls: list[Call] = []
    caller = ""
    for row in text.split(b"\n"):
        if define := _DEFINE.match(row):
            caller = _symbol(define[1])
        elif row.startswith(b"}"):
            caller = ""
        elif caller and (call := _CALL.search(row)) and len(calls) < MAX_CALLS:
            calls.append(Call(caller, _symbol(call[1])))
    return CallGraph(tuple(calls), ())


def _symbol(name: bytes) -> str:
    """Take the mangled name; g++ puts the file before the names of local functions."""
    return name.decode("ascii", errors="replace").rsplit(":", 1)[-1]
