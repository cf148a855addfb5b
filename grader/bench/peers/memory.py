"""Runs `bvhgrade` and prints the largest resident memory: `python -m ... WORDS`.

Two numbers in KiB, as JSON in the last line: of this process, and of the largest one of all
that it started and waited for.
"""

import json
import resource
import runpy
import sys


def main() -> None:
    """Run the command line in this process, then look."""
    status: object = 0
    sys.argv[0] = "bvhgrade"
    try:
        runpy.run_module("grader", run_name="__main__")
    except SystemExit as ending:
        status = ending.code
    who = (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    peaks = [resource.getrusage(each).ru_maxrss for each in who]
    print(json.dumps(peaks))  # noqa: T201 - it is a program
    sys.exit(status)  # type: ignore[arg-type]  # what the command line ended with


if __name__ == "__main__":
    main()
