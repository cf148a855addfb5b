"""How does PrairieLearn read a result? As `results.json` in /grade/results.

Source: PrairieLearn, docs/externalGrading.md and elements/pl-external-grader-results. A file of
more than 1,048,576 bytes fails as a whole; `for_json` writes at most 900,000. If one test lacks
`points` or `max_points`, no test shows any.

A score that is withheld makes the submission not gradable: PrairieLearn then uses up no attempt
and takes no points, and shows why. There are no tests then, since each would need points.
"""

from grader.language import Words
from grader.report.as_json import Json
from grader.report.escape import for_json
from grader.report.hosts.told import Entry, entries, headline, summary, withheld


def to_text(result: Json, words: Words = str) -> str:
    """Write `results.json`."""
    if result["score"] is None:
        return for_json({"gradable": False, "format_errors": [withheld(words)]}) + "\n"
    told = {
        "gradable": True,
        "score": share(result),
        "message": headline(result, words),
        "output": summary(result, words),
        "tests": [test(entry) for entry in entries(result, words)],
    }
    return for_json(told) + "\n"


def share(result: Json) -> float:
    """Turn points into the share of all points, 0 to 1; of a rubric without points, none."""
    possible: float = result["max_score"]
    return result["score"] / possible if possible else 0.0


def test(entry: Entry) -> Json:
    """Write one check; points and maximum are always there, 0 of 0 for a gate."""
    return {
        "name": entry.id,
        "description": entry.title,
        "points": entry.score,
        "max_points": entry.max_score,
        "output": entry.text,
    }
