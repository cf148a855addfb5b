"""How does Gradescope read a result? As `results.json` in /autograder/results.

Source: gradescope/autograder_samples, docs/specs.md; the harness 0.15.0 cuts every output of
more than 100,000 characters in the middle, and takes what is no JSON for a score of 0.

A score that is withheld is written nowhere: neither for the whole, nor for a check. The
specification wants one or the other, so the run should count as failed, which it is, and an
instructor can start it again; what the closed site does was not tried. A score of the other
checks alone would count as the grade.
"""

from grader.language import Words
from grader.report.as_json import Json
from grader.report.escape import for_json
from grader.report.hosts.told import VISIBLE, Entry, every_entry, summary, unbuilt, withheld

STATUS = {"pass": "passed", "fail": "failed", "blocked": "failed"}
"""Only a check that moves points has one; a gate of 0 points would else count as passed."""


def to_text(result: Json, words: Words = str) -> str:
    """Write `results.json`; what is not visible is hidden by Gradescope itself."""
    known = result["score"] is not None
    told = {
        "output": output(result, words),
        # By itself Gradescope would turn empty lines into paragraphs, and `<` into markup.
        "output_format": "text",
        "test_output_format": "text",
        "test_name_format": "text",
        "stdout_visibility": "hidden",
        "execution_time": result["timing"]["total"],
        "extra_data": provenance(result),
        "tests": [test(entry, known) for entry in every_entry(result, words)],
    }
    return for_json({"score": result["score"], **told} if known else told) + "\n"


def output(result: Json, words: Words) -> str:
    """Word what is said of the whole; no sum if the rubric hides a check.

    Gradescope hides the total then, but not this text, and whoever takes the points that are
    seen from a sum has those that are not.
    """
    if all(one["visibility"] == VISIBLE for one in result["checks"]):
        return summary(result, words)
    fault = withheld(words) if result["score"] is None else ""
    return "\n".join(filter(None, [fault, unbuilt(result, words)]))


def test(entry: Entry, known: bool) -> Json:
    """Write one check.

    Args:
        entry: The check.
        known: Whether the score of the whole is; else that of a check would make one up.
    """
    scored = {"score": entry.score, "status": STATUS[entry.verdict]} if known else {}
    return {
        # Names are sentences, and two of them might be equal; ids never are.
        "name": f"{entry.id}: {entry.title}",
        **scored,
        "max_score": entry.max_score,
        "output": entry.text,
        "visibility": entry.visibility,
        "tags": [entry.id, entry.part],
    }


def provenance(result: Json) -> Json:
    """Say what made this score; a later run finds it in submission_metadata.json."""
    made = result["provenance"]
    names = ("grader", "seed", "rubric_sha256", "scenes_sha256")
    return {
        **{name: made[name] for name in names},
        "submission_sha256": result["submission"]["sha256"],
        "needs_review": result["needs_review"],
    }
