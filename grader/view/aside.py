"""What comes of a thread of ours: a value, or a fault that is shown; never a window's end."""

from concurrent.futures import Future
from typing import TypeVar

from grader.errors import GraderError, WorkerFault
from grader.plain import one_line

Value = TypeVar("Value")


def outcome(done: "Future[Value]") -> Value | GraderError:
    """Take what is finished.

    Raises:
        BaseException: Somebody wants the whole program to end.
    """
    fault = done.exception()
    if fault is None:
        return done.result()
    if isinstance(fault, GraderError):
        return fault
    if not isinstance(fault, Exception):
        raise fault
    return failed(fault)


def failed(fault: Exception) -> WorkerFault:
    """Word a fault of the viewer itself."""
    kind = one_line(f"{type(fault).__name__}: {fault}", 200)
    made = WorkerFault(f"the viewer itself failed ({kind})")
    made.__cause__ = fault
    return made
