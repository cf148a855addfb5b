"""What does every host say about a result? Decided once: what is shown, worst first, in words.

A host without a way to hide a check gets one entry for all that are hidden or wait for the due
date: their points belong to the sum, and nothing else of them is told. A fault of the grader is
told in one fixed sentence, since its message may name files of a machine.
"""

from collections.abc import Iterator
from dataclasses import dataclass

from grader.errors import FAILED_HERE
from grader.language import Words
from grader.report.as_json import Json
from grader.report.facts import costs
from grader.report.hints import cause_in, misconception

VISIBLE = "visible"

NOT_SHOWN = "checks.not-shown"
"""Id of the entry for everything that is not shown."""


@dataclass(frozen=True, slots=True)
class Entry:
    """One line of a host's table: a check, or all those that are not shown."""

    id: str
    part: str
    title: str
    verdict: str
    score: float | None
    """None if withheld."""

    max_score: float
    text: str
    """What a student reads about it; empty if there is nothing to say. Still a stranger's."""

    cause: str = ""
    """Equal for checks that likely fail for the same reason; empty if unsure."""

    visibility: str = VISIBLE
    stop: str = "finished"
    line: int = 0
    """Line of the student's file; 0 if none is known."""

    blocked_by: str | None = None
    """Id of the check that it waits for."""


def entries(result: Json, words: Words = str) -> list[Entry]:
    """List the checks that are shown, and what the others are worth together."""
    hidden = [one for one in result["checks"] if one["visibility"] != VISIBLE]
    shown = [entry for entry in every_entry(result, words) if entry.visibility == VISIBLE]
    return [*shown, not_shown(hidden, words)] if hidden else shown


def every_entry(result: Json, words: Words = str) -> list[Entry]:
    """List all checks, for a host that hides what it is told to hide."""
    secret = {one["id"] for one in result["checks"] if one["visibility"] != VISIBLE}
    return [entry_of(one, secret, words) for one in result["checks"]]


def entry_of(check: Json, secret: set[str], words: Words) -> Entry:
    """Turn a check into a entry."""
    place = check["location"]
    return Entry(
        check["id"],
        check["part"],
        words(check["title"]),
        check["verdict"],
        check["score"],
        check["max_score"],
        "\n".join(explained(check, secret, words)),
        misconception(check["hint"])[0] if check["verdict"] == "fail" else "",
        check["visibility"],
        check["stop"],
        (place and place["line"]) or 0,
        check["blocked_by"],
    )


def not_shown(hidden: list[Json], words: Words) -> Entry:
    """Add up the checks that are not shown; nothing tells which of them holds."""
    scores = [one["score"] for one in hidden]
    broken = any(score is None for score in scores)
    holds = all(one["verdict"] == "pass" for one in hidden)
    return Entry(
        NOT_SHOWN,
        "both",
        words("Checks that are not shown here"),
        "broken" if broken else "pass" if holds else "fail",
        None if broken else sum(scores),
        sum(one["max_score"] for one in hidden),
        undecided(words) if broken else "",
    )


def undecided(words: Words) -> str:
    """Say that a fault of ours decided nothing, and costs nothing."""
    return words(FAILED_HERE).format(kind="")


def explained(check: Json, secret: set[str], words: Words) -> Iterator[str]:
    """Word what a student reads about a check, line by line."""
    if check["verdict"] == "fail":
        yield from failure(check, words)
    elif check["verdict"] == "broken":
        yield undecided(words)
    elif check["blocked_by"] in secret:
        yield words("waits for a check that is not shown")
    elif check["blocked_by"] is not None:
        yield words("waits for {check}").format(check=check["blocked_by"])
    elif check["verdict"] != "pass" or ":" in check["message"]:
        # Of what passes, only names are worth telling: there a student looks for the dragon.
        yield from filter(None, [check["message"]])


def failure(check: Json, words: Words) -> Iterator[str]:
    """Word a failure as the terminal does: what, where, and what likely is misunderstood."""
    if check["message"]:
        yield check["message"]
    for label in ("expected", "got"):
        if check[label]:
            yield f"{words(label)}: {check[label]}"
    others = [one["message"] for one in check["examples"]]
    for message in others:
        if message not in check["message"]:
            yield f"{words('example')}: {message}"
    if check["location"] is not None:
        yield f"{words('look at')}: {where(check['location'], words)}"
    if check["hint"]:
        yield f"{words('cause')}: {cause_in(check['hint'], words)}"


def where(location: Json, words: Words) -> str:
    """Word a place in the student's file."""
    place: str = location["file"] + (f":{location['line']}" if location["line"] else "")
    if not location["function"]:
        return place
    return words("{place} in {function}").format(place=place, function=location["function"])


def worst_first(given: list[Entry]) -> list[Entry]:
    """Order the failures by what they cost, with what waits for them and is shown."""
    cost = costs((entry.id, entry.blocked_by, lost(entry)) for entry in given)
    failed = [entry for entry in given if entry.verdict == "fail"]
    return sorted(failed, key=lambda entry: -cost[entry.id])


def lost(entry: Entry) -> float:
    """Count the points that a entry lost for sure."""
    return 0 if entry.score is None else entry.max_score - entry.score


def headline(result: Json, words: Words = str) -> str:
    """Word the score, or that nobody knows it."""
    if result["score"] is None:
        return withheld(words)
    score = words("{score} of {possible}")
    score = score.format(score=f"{result['score']:g}", possible=f"{result['max_score']:g}")
    return words("{score} points").format(score=score)


def withheld(words: Words = str) -> str:
    """Say that there is no score, and that this is nobody's loss."""
    return words(
        "The score is withheld: the grader itself failed, which costs no points. "
        "Somebody of the course has to look."
    )


def worth(entry: Entry, words: Words = str) -> str:
    """Word what a entry is worth."""
    if entry.score is None:
        return words("withheld")
    if not entry.max_score:
        return words("gate")
    score = words("{score} of {possible}")
    return score.format(score=f"{entry.score:g}", possible=f"{entry.max_score:g}")


def unbuilt(result: Json, words: Words = str) -> str:
    """Say why nothing could be graded; empty if there was a program to judge."""
    if result["build"]["ok"]:
        return ""
    said = result["build"]["diagnostics"]
    if result["submission"]["sha256"] is None:
        heading = words("There is no file to grade")
    elif not said:
        return ""
    else:
        heading = words("The file does not compile")
    return "\n".join([heading, *(diagnostic(one) for one in said)])


def diagnostic(given: Json) -> str:
    """Word one message of the compiler."""
    place = f"{given['line']}:{given['column']}: " if given["line"] else ""
    told: str = f"{given['severity']}: {given['text']}"
    return place + told


def summary(result: Json, words: Words = str) -> str:
    """Say the score, the points of each part, and why nothing was graded if so."""
    told = [headline(result, words)]
    for part in whole_parts(result):
        entry = Entry("", part["id"], "", "", part["score"], part["max_score"], "")
        told.append(f"{part['id']}) {words(part['title'])}: {worth(entry, words)}")
    return "\n".join([*told, *filter(None, [unbuilt(result, words)])])


def whole_parts(result: Json) -> list[Json]:
    """List the parts whose points may be told: all, or none where something is not shown.

    Beside the checks that are shown they would give away how each part fares in the others.
    """
    parts: list[Json] = result["parts"]
    return parts if is_open(result) else []


def is_open(result: Json) -> bool:
    """Tell whether everything of a result is shown to students."""
    return all(one["visibility"] == VISIBLE for one in result["checks"])
