"""Runs `bvhgrade` and prints the largest resident memory: `python -m ... WORDS`.

Two numbers in KiB, as JSON in the last line: of this process, and of the largest one of all
that it started and waited for.
"""

import json
import re
import resource
import runpy
import sys
from pathlib import Path


def own_peak() -> int:
    """Return the largest resident memory of this program, in KiB.

    Not `ru_maxrss`: that remembers the process which this one was forked from.
    """
    found = re.search(
        r"^VmHWM:\s+(\d+) kB", Path("/proc/self/status").read_text(), re.MULTILINE
    )
    return int(found[1]) if found else 0


def main() -> None:
    """Run the command line in this process, then look."""
    status: object = 0
    sys.argv[0] = "bvhgrade"
    try:
        runpy.run_module("grader", run_name="__main__")
    except SystemExit as ending:
        status = ending.code
    child = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    print(json.dumps([own_peak(), child]))  # noqa: T201 - it is a program
    sys.exit(status)  # type: ignore[arg-type]  # what the command line ended with


if __name__ == "__main__":
    main()
