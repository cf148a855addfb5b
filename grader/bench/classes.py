"""Does a class of a thousand cost a thousand times one submission? Goal 8."""

import json
import sys
from pathlib import Path

from grader.bench import goals
from grader.bench.programs import program
from grader.bench.record import Reading, Spread

_SOURCE = "// {number}\nint main( {{\n"
"""Does not compile, and is nobody else's: only what a class costs besides is timed."""


def measured(folder: Path, small: int, large: int) -> list[Reading]:
    """Grade a small and a large class of files that end at the compiler.

    Each file is another one, so none is graded for two; a whole grade would hide what the
    class itself costs behind some seconds a file.
    """
    few, many = (_graded(folder / f"class-{count}", count) for count in (small, large))
    each, other = many[0] / large, few[0] / small
    detail = f"{1000 * each:.0f} ms of {large:,} / {1000 * other:.0f} ms of {small}"
    memory = f"{many[1]:.0f} MiB / {few[1]:.0f} MiB"
    return [
        Reading(goals.CLASS_TIME, _once(each / other), detail),
        Reading(goals.CLASS_MEMORY, _once(many[1] / few[1]), memory),
    ]


def _once(value: float) -> Spread:
    return Spread(value, value, value, 1)


def _graded(folder: Path, count: int) -> tuple[float, float]:
    """Grade a class of so many; seconds, and the parent's largest memory in MiB."""
    for number in range(count):
        own = folder / "class" / f"s{number:04}"
        own.mkdir(parents=True)
        (own / "exercise03.cpp").write_text(_SOURCE.format(number=number))
    words = ["batch", str(folder / "class"), "-o", str(folder / "out"), "--jobs", "2"]
    outcome = program([sys.executable, "-m", "grader.bench.peers.memory", *words])
    own_kib, _ = json.loads(outcome.out.splitlines()[-1])
    return outcome.seconds, own_kib / 1024
