"""What is the least that a grade can take, and how far is the program from it?"""

from grader.bench.record import Floor

PROFILED = """## Profiled by hand

On 2026-11-29, at commit 5e29f94; `bvhgrade bench` does not measure it again. Where the time
of a warm grade of the model solution goes, in CPU seconds (on a busy machine, so a little too
much of each):

| what | CPU s |
|---|---:|
| compile the graded library, with the precompiled header | 0.9 |
| compile with sanitizers, twice, and for the graph of calls | 3.0 |
| 159 workers: trees, rays, and the start of each process (8 ms) | 3.0 |
| decide the checks; half of it every node's box | 1.0 |
| pictures: shading, FLIP, shadow rays, models | 0.8 |
| our side of the workers: fill and read their memory | 0.6 |
| read and verify the plan of the trials (60 MB) from the cache | 0.4 |
| the rest of the grader's process: Python, numpy, calls from assembly text, isolation | 1.3 |

Not profiled is what comes after the grade: pictures are encoded and the report is written.

By hand, the graded library and one process for all plain trials take 3 s. What a grade
cannot do without are the sanitized builds, and a process for each trial, so that one that
crashes costs only itself: 0.9 + 3.0 + 3.0 s, half of that on the clock of two cores. The rest
is the distance from the floor. Of it were removed:

- a file that was compiled before is not compiled again (`grader/build/remembered.py`);
- pictures are shaded and encoded two at a time, beside the worker that traces their shadows;
- a run of `build.compiles` or `source.construct-loops` alone draws no plan;
- `bvhgrade check --quick` builds nothing with sanitizers, draws nothing, and runs few checks:
  2.7 s on the clock for the model solution, of which 1.1 s go by while it compiles and 0.5 s
  are its workers'.

The fast model solution is not the engine of the reference trees, although its trees are the
same to the bit (`tests/test_reference.py`): its `construct` was not faster than the clear
one's, compiling it takes 1.5 s, and the trees are read from the cache ever after.
"""


def floor_of(floor: Floor) -> str:
    """Word how far the program is from the least that it can take."""
    return (
        "## The floor\n\n"
        "The same compilers with the precompiled headers, and the same trees and rays, one\n"
        f"process for all trials of a build, and nothing else, on {floor.cores} cores that\n"
        f"are never idle: {floor.least:.2f} s. The program takes {floor.program:.2f} s, "
        f"{floor.program / floor.least:.2f} times that.\n"
    )
