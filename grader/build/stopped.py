"""Why did a compiler end without a product and without an error in the source?"""

import signal

from grader.model.grade import CompileLimits
from grader.sandbox.launch import Outcome

_MEMORY = (b"out of memory", b"virtual memory exhausted", b"bad_alloc", b"Cannot allocate")
_FILE = (b"File size limit exceeded", b"File too large", b"file too large")
_CPU = (b"CPU time limit exceeded", b"signal terminated program cc1plus")


def why_stopped(outcome: Outcome, limits: CompileLimits) -> str:
    """Name the limit that ended a compiler, as well as it can be known from outside.

    What was printed only chooses between sentences of ours: it is the submission's text.
    """
    said = outcome.err
    if outcome.timed_out:
        return f"compiling took longer than {limits.wall_seconds} s"
    if any(words in said for words in _FILE) or outcome.code == -signal.SIGXFSZ:
        return f"the compiled file is larger than {limits.file_mib:,} MiB"
    if any(words in said for words in _MEMORY):
        return f"compiling needed more memory than {limits.memory_mib:,} MiB"
    if outcome.cpu_seconds >= limits.seconds or any(words in said for words in _CPU):
        return f"compiling took more than {limits.seconds} s of computing time"
    if outcome.code == 0:
        return f"the compiler made no library of at most {limits.file_mib:,} MiB"
    return f"compiling ended with status {outcome.code}"
