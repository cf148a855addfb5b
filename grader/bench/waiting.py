"""How long does somebody wait who asks for little? Goal 9: these are seconds, and no ratios."""

import json
from pathlib import Path

from grader.bench import goals
from grader.bench.programs import grader_cost
from grader.bench.record import Reading
from grader.bench.statistics import spread
from grader.bench.whole import unseen
from grader.output import OUTPUT, RESULT
from grader.resources import reference_source


def measured(folder: Path, rounds: int) -> list[Reading]:
    """Check the model solution quickly, and ask for help, in turns."""
    own, helped, parts = [], [], []
    for _ in range(rounds):
        parts.append(_quick(folder))
        whole, compilers, workers = parts[-1]
        own.append(whole - compilers - workers)
        helped.append(grader_cost("--help").wall)
    middle = (spread(each).median for each in zip(*parts, strict=True))
    told = "{:.2f} s, of which compilers {:.2f} s and workers {:.2f} s".format(*middle)
    return [
        Reading(goals.QUICK, spread(own), told),
        Reading(goals.HELP, spread(helped), "Python starts, and lists the commands"),
    ]


def _quick(folder: Path) -> tuple[float, float, float]:
    """Seconds of a whole quick check, of its compilers, and of all its workers together."""
    grader_cost("check", unseen(reference_source(), folder), "--quick", folder=folder)
    timing = json.loads((folder / OUTPUT / RESULT).read_text())["timing"]
    return timing["total"], timing["compile"], timing["submission"]
