"""Which ratios are aimed at? The numbers are the list's in issue 8, the bounds too."""

from grader.bench.record import Goal

WALL = Goal("1", "complete grade / the same builds and runs by hand, wall", 1.10)
CPU = Goal("1b", "complete grade / the same builds and runs by hand, CPU", 1.5)
PLAIN_WALL = Goal("1c", "complete grade / by hand without sanitizers, wall", 1.10)
PLAIN_CPU = Goal("1d", "complete grade / by hand without sanitizers, CPU", 1.5)
CHECK = Goal("2", "all checks of a tree / textbook's construct", 0.20)
PYTEST = Goal("3", "trivial submission, ours / pytest, wall", 0.6)
CHECK50 = Goal("3b", "trivial submission, ours / check50, wall", 0.35)
SANITIZED = Goal("4", "sanitizer compile / plain -O2 compile", 1.15)
PRECOMPILED = Goal("5", "compile with precompiled header / without", 0.65)
UNCHANGED = Goal("5b", "unchanged file / compile without precompiled header", 0.02)
FAST_BUILD = Goal("6", "fast construct / Embree's medium build", 0.9)
FAST_CAMERA = Goal("6b", "fast camera rays / Embree's, rays per second", 0.6, at_most=False)
FAST_SCATTERED = Goal("6c", "fast scattered rays / Embree's", 0.45, at_most=False)
CLEAR_BUILD = Goal("6d", "clear construct / textbook's", 0.6)
COUNTED = Goal("7", "rays with counted tests / without", 0.95, at_most=False)
CLASS_TIME = Goal("8", "class overhead: time for files that end at the compiler", 1.1)
CLASS_MEMORY = Goal("8b", "memory of the parent, large class / small class", 1.1)
