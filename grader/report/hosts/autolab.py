"""How does Autolab read a result? As the last two lines that the grading job prints.

Source: Autolab, docs/lab.md, docs/features/formatted-feedback.md and
app/helpers/assessment_autograde_core.rb. The last line holds the scores by the name of a
problem, which must be defined on the site: here, the titles of the rubric's parts. The line
before it is the formatted feedback. Whatever goes wrong with the last line, an empty list of
scores included, gives 0 points for every problem that has none yet.

So a score that is withheld is null, under the name of each problem: the line is read, and no
problem has a score until somebody gives it one. A part alone would look like a grade. The page
of the formatted feedback adds the scores up and fails at a null (parseScore in
app/controllers/assessments_controller.rb), so there is a plain sentence in its place then.
"""

from grader.language import Words
from grader.report.as_json import Json
from grader.report.escape import for_autolab, line_for_terminal
from grader.report.hosts.told import Entry, entries, headline, unbuilt, withheld, worth


def to_text(result: Json, words: Words = str) -> str:
    """Write both lines."""
    if result["score"] is None:
        return f"{line_for_terminal(withheld(words))}\n{for_autolab(scores(result))}\n"
    return f"{for_autolab(feedback(result, words))}\n{for_autolab(scores(result))}\n"


def scores(result: Json) -> Json:
    """Give each problem its points; its name is not translated, since the site knows it."""
    parts = result["parts"]
    titles = [part["title"] for part in parts]
    unknown = result["score"] is None
    return {
        "scores": {
            part["title"] if titles.count(part["title"]) == 1 else part["id"]: (
                None if unknown else part["score"]
            )
            for part in parts
        }
    }


def feedback(result: Json, words: Words) -> Json:
    """Write the formatted feedback: a stage for each part, in it a line for each check."""
    shown = entries(result, words)
    parts = {part["id"]: f"{part['id']}) {words(part['title'])}" for part in result["parts"]}
    told: Json = {"bvhgrade": whole(result, words)}
    for part, stage in [*parts.items(), ("", words("Both parts"))]:
        mine = [
            entry for entry in shown if entry.part == part or not (part or entry.part in parts)
        ]
        if mine:
            told[stage] = {entry.id: case(entry, words) for entry in mine}
    return {"_presentation": "semantic", "stages": list(told), **told}


def whole(result: Json, words: Words) -> Json:
    """Write the stage that tells the score, and why nothing was graded if so."""
    built = result["build"]["ok"]
    told = {words("points"): headline(result, words)}
    return told if built else {**told, words("error"): unbuilt(result, words)}


def case(entry: Entry, words: Words) -> Json:
    """Write one check."""
    told = "\n".join(filter(None, [f"{entry.title} ({worth(entry, words)})", entry.text]))
    return {"passed": entry.verdict == "pass", "hint": told}
