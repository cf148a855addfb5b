"""Does a class of a thousand cost a thousand times one submission? Goal 8."""

import json
import sys
from pathlib import Path

from grader.bench import goals
from grader.bench.programs import program
from grader.bench.record import Reading
from grader.bench.statistics import ratios
from grader.model.stages import SOURCE_NAME

FIRST = 2
"""Files of the class whose time is taken off: one for each process, so that all have begun."""

_SOURCE = "// {number}\nint main( {{\n"
"""Does not compile, and is nobody else's: only what a class costs besides is timed."""


def measured(folder: Path, small: int, large: int) -> list[Reading]:
    """Grade a small and a large class of files that end at the compiler.

    Each file is another one, so none is graded for two; a whole grade would hide what the
    class itself costs behind some seconds a file. What the first files take is taken off both:
    the start of a class would make each file of a small one look dear.
    """
    first, few, many = (
        _graded(folder / f"class-{count}", count) for count in (FIRST, small, large)
    )
    each, other = (
        (some[0] - first[0]) / (count - FIRST) for some, count in ((many, large), (few, small))
    )
    detail = f"{1000 * each:.0f} ms of {large:,} / {1000 * other:.0f} ms of {small}"
    memory = f"{many[1]:.0f} MiB / {few[1]:.0f} MiB"
    return [
        Reading(goals.CLASS_TIME, ratios([each], [other]), detail),
        Reading(goals.CLASS_MEMORY, ratios([many[1]], [few[1]]), memory),
    ]


def _graded(folder: Path, count: int) -> tuple[float, float]:
    """Grade a class of so many; seconds, and the parent's largest memory in MiB."""
    for number in range(count):
        own = folder / "class" / f"s{number:04}"
        own.mkdir(parents=True)
        (own / SOURCE_NAME).write_text(_SOURCE.format(number=number))
    words = ["batch", str(folder / "class"), "-o", str(folder / "out"), "--jobs", str(FIRST)]
    outcome = program([sys.executable, "-m", "grader.bench.peers.memory", *words])
    own_kib, _ = json.loads(outcome.out.splitlines()[-1])
    return outcome.seconds, own_kib / 1024
