"""Results of real submissions as files: `python -m tests.report.real` grades them anew."""

import json
import tempfile
from pathlib import Path

from grader.certify.corpus import corpus_folder
from grader.options import Options
from grader.pipeline import grade_one
from grader.report.as_json import Json, to_text
from grader.report.escape import for_json
from grader.resources import reference_source

FOLDER = Path(__file__).with_name("results")

WRONG = ("first-hit-wins", "boxes-of-the-parent", "crash-on-a-miss")

MADE = ("right", *WRONG, "uncompiled", "rejected")

OVERLOADED = "overloaded"
"""Of a machine that had no time for an endless loop to use up its own; not made anew."""

ENDINGS = (*MADE, OVERLOADED)
"""One file for each."""


def real(name: str) -> Json:
    """Read a stored result."""
    result: Json = json.loads((FOLDER / f"{name}.json").read_text(encoding="utf-8"))
    return result


def withheld() -> Json:
    """Take a real result of which one check broke: what it decides is known to nobody."""
    result = real("first-hit-wins")
    fault = 'Traceback (most recent call last):\n  File "/opt/grader/verify/hits.py", line 7'
    for check in result["checks"]:
        if check["id"] == "image.equals-mitsuba":
            check.update(verdict="broken", score=None, message=fault, examined=0)
    result["parts"][1]["score"] = None
    result.update(score=None, needs_review=True)
    return result


def partly_hidden(name: str) -> Json:
    """Take a real result whose closest hits are hidden, and its pictures until the due date."""
    result = real(name)
    for check in result["checks"]:
        if check["id"] == "hits.closest-wins":
            check["visibility"] = "hidden"
        if check["id"] == "image.equals-mitsuba":
            check["visibility"] = "after_due_date"
    return result


def every_result() -> dict[str, Json]:
    """Name all real results, and those that are made of them."""
    results = {name: real(name) for name in ENDINGS}
    results["withheld"] = withheld()
    results["hidden"] = partly_hidden("first-hit-wins")
    results["hidden, right"] = partly_hidden("right")
    return results


def no_progress(*_: object) -> None:
    """Show nothing."""


def main() -> None:
    """Grade each submission and store its result, without the name of this processor."""
    FOLDER.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as made:
        bad, empty = Path(made, "uncompiled.cpp"), Path(made, "rejected")
        source = reference_source().read_text(encoding="utf-8")
        bad.write_text(source.replace("return", "retrun", 2), encoding="utf-8")
        empty.mkdir()
        Path(empty, "notes.txt").write_text("nothing to grade")
        paths = {name: corpus_folder() / "wrong" / f"{name}.cpp" for name in WRONG}
        paths |= {"right": reference_source(), "uncompiled": bad, "rejected": empty}
        for name, path in paths.items():
            grade = grade_one(path, Options(41, None, (), no_progress, counterexamples=True))
            result = json.loads(to_text(grade))
            result["provenance"]["cpu"] = "A processor"
            (FOLDER / f"{name}.json").write_text(for_json(result) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
