"""Which faults are ours, and never a student's.

GraderError                      shown as one sentence; exit status 3
|-- UsageError                   the call was wrong: a path, an option, a rubric; exit status 2
|-- MissingTool                  a compiler, a package or a variant is not installed
|-- BuildFault                   our own framework or reference did not build
|-- WorkerFault                  the process around a submission failed for our own reason
|-- OracleFault                  two of our own witnesses disagree, or a reference is stale
|-- OutputFault                  a result could not be written
`-- Interrupted                  the grader was asked to stop

A student's fault is a value (`Rejected`, `Build`, `Stop`, `Finding`), so no `except` in this
code base can turn one into the other.
"""


class GraderError(Exception):
    """Our own fault; the message says what was tried, on what, and what to do."""


class UsageError(GraderError):
    """The caller asked for something that does not exist or cannot be read."""


class MissingTool(GraderError):
    """A program or package that the grader needs is not installed."""


class BuildFault(GraderError):
    """The framework or the reference, both ours, did not compile."""


class WorkerFault(GraderError):
    """A worker could not be started or fed; the submission has not been judged."""


class OracleFault(GraderError):
    """Our own references contradict each other or do not belong to this scene."""


class OutputFault(GraderError):
    """A result could not be written where it was asked for."""


class Interrupted(GraderError):
    """The grader was asked to stop while it worked; nothing is concluded."""


FAILED_HERE = "The grader itself failed here{kind}; it costs no points."
"""What people read where a fault of ours leaves something undecided."""


def failed_here(fault: Exception) -> str:
    """Word a fault that nobody foresaw by its kind alone: its text may name our files."""
    return FAILED_HERE.format(kind=f" ({type(fault).__name__})")


STRICT = False
"""Tests turn it on, so that no guard hides a fault of ours from them."""


def let_go(fault: Exception) -> None:
    """Let a fault of ours cost what nothing hangs on: a hint, an example, a picture.

    Raises:
        Interrupted: That is no fault.
        Exception: The fault itself, in tests.
    """
    if STRICT or isinstance(fault, Interrupted):
        raise fault
