"""What does a student read beside the points in a gradebook? The parts, then what failed."""

from collections.abc import Iterator

from grader.language import Words
from grader.report.as_json import Json
from grader.report.escape import for_csv, for_moodle
from grader.report.hosts.told import entries, summary, worst_first, worth


def feedback_cell(result: Json, host: str, words: Words) -> str:
    """Write the cell; Moodle shows it as HTML."""
    lines = list(feedback(result, words))
    return for_moodle(lines) if host == "moodle" else for_csv(" / ".join(lines))


def feedback(result: Json, words: Words) -> Iterator[str]:
    """Word the points of each part, and then each failure by what it costs."""
    yield from summary(result, words).split("\n")
    if not result["build"]["ok"]:
        return
    for entry in worst_first(entries(result, words)):
        first = entry.text.partition("\n")[0]
        yield f"{entry.title} ({worth(entry, words)})" + (f": {first}" if first else "")
