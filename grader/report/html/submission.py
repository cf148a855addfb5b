"""How does one submission look on a page? What to fix first, then what was seen, then facts."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from grader.language import Words, translator
from grader.model.stages import SOURCE_PATH
from grader.phrases import teller
from grader.report.facts import BEGIN, FUNCTIONS, NOT_STARTED
from grader.report.hosts.told import VISIBLE, withheld
from grader.report.html.findings import failures, idle_parts, points, spoken
from grader.report.html.page import SIGNS, page
from grader.report.html.seen import legends, models, pictures
from grader.report.spoken import messages

Json = Mapping[str, Any]

NOTHING: Json = {"schema": 1, "pictures": [], "models": []}
"""Views of a submission that was not run."""


def to_html(result: Json, views: Json | None, language: str, hints: bool = True) -> str:
    """Write `report.html`, one file that needs nothing else.

    Args:
        result: Values of a `result.json`, which validate against the schema.
        views: Values of its `views.json`; None if nothing was drawn.
        language: `en` or `de`.
        hints: Whether causes, questions and things to try are told.

    Raises:
        OutputFault: The views are too large, or packed otherwise than they should be.
    """
    words, told, seen = translator(language), teller(language), views or NOTHING
    shown = models(seen, words, told)
    failed = [spoken(one, told) for one in failures(result, seen, words)]
    if not hints:
        failed = [replace(one, cause="", hints=()) for one in failed]
    idle = [not_started(part, words) for part in idle_parts(result)]
    if idle and hints and not failed:
        idle.append(words(BEGIN))
    values = {
        **head(result, words),
        "failures": failed,
        "idle": idle,
        "broken": [
            one | {"message": told(one["message"])}
            for one in result["checks"]
            if one["verdict"] == "broken"
        ],
        "groups": groups(result, words),
        "pictures": pictures(seen, not wrong_pictures(result), words),
        "legends": legends(),
        "messages": [message(one) for one in messages(result, told)],
        "facts": facts(result, words),
        "has_models": bool(shown),
    }
    data = {"models": shown, "words": script_words(words)}
    return page("report", language, values, {"data": data})


def wrong_pictures(result: Json) -> bool:
    """Say whether a check of pictures failed."""
    return any(
        one["verdict"] == "fail" for one in result["checks"] if one["id"].startswith("image.")
    )


def head(result: Json, words: Words) -> dict[str, object]:
    """Say whose it is, what it scored and how it ended."""
    given, score = result["submission"], result["score"]
    return {
        "title": words("BVH exercise: {name}").format(name=given["name"]),
        "name": given["name"],
        "path": "" if given["path"] == given["name"] else given["path"] or "",
        "score": None if score is None else f"{score:g}",
        "most": f"{result['max_score']:g}",
        "full": score is not None and score == result["max_score"],
        "exposed": given["sha256"] is not None
        # Also where it did not compile: the compiler read it without isolation.
        and result["provenance"]["isolation"] == "none",
        "secret": any(one["visibility"] != VISIBLE for one in result["checks"]),
        "review": result["needs_review"],
        "summary": summary(result, words),
        "parts": [_part(one, words) for one in result["parts"]],
    }


def _part(one: Json, words: Words) -> dict[str, object]:
    share = (one["score"] or 0) / one["max_score"] if one["max_score"] else 0
    return {
        "id": one["id"],
        "title": words(one["title"]),
        "points": points(one["score"], one["max_score"], words),
        "percent": round(100 * share),
    }


def summary(result: Json, words: Words) -> str:
    """Say in one sentence how it ended."""
    if not result["build"]["ok"]:
        if result["score"] is None:
            # We failed before there was anything to look at: nobody knows whether it compiles.
            return withheld(words)
        refused = result["submission"]["path"] is None
        return (
            words("There is no file to grade")
            if refused
            else words("The file does not compile")
        )
    verdicts = [one["verdict"] for one in result["checks"]]
    failed, waiting = verdicts.count("fail"), verdicts.count("blocked")
    if verdicts.count("pass") == len(verdicts):
        return words("All {checks} checks pass.").format(checks=len(verdicts))
    told = []
    if failed:
        told.append(words("{failed} of {checks} checks failed."))
    if waiting:
        told.append(words("{waiting} of {checks} checks could not be decided."))
    return " ".join(told).format(failed=failed, waiting=waiting, checks=len(verdicts))


def not_started(part: str, words: Words) -> str:
    """Say that a part still does what the given code does."""
    function = FUNCTIONS.get(part, words("the function"))
    return words(NOT_STARTED).format(part=part, function=function)


def groups(result: Json, words: Words) -> list[tuple[str, list[dict[str, str]]]]:
    """Sort the checks into parts; those of no part come first."""
    titles = {one["id"]: f"{one['id']}) {words(one['title'])}" for one in result["parts"]}
    made: dict[str, list[dict[str, str]]] = {}
    for one in result["checks"]:
        title = titles.get(one["part"], words("Both parts"))
        made.setdefault(title, []).append(_line(one, words))
    return list(made.items())


def _line(one: Json, words: Words) -> dict[str, str]:
    remark, (style, sign) = "", SIGNS[one["verdict"]]
    if one["verdict"] == "blocked" and one["blocked_by"]:
        remark = words("waits for {check}").format(check=one["blocked_by"])
    return {
        "id": one["id"],
        "title": words(one["title"]),
        "verdict": one["verdict"],
        "sign": sign,
        "style": style,
        "word": words(one["verdict"]),
        "remark": remark,
        "points": points(one["score"], one["max_score"], words),
    }


def message(given: Json) -> dict[str, str]:
    """Write where the compiler saw something."""
    column = f":{given['column']}" if given["column"] else ""
    where = f"{SOURCE_PATH}:{given['line']}{column}" if given["line"] else ""
    return {"where": where, "severity": given["severity"], "text": given["text"]}


def facts(result: Json, words: Words) -> list[tuple[str, str]]:
    """Say with what it was graded, and how long that took."""
    made, spent = result["provenance"], result["timing"]
    alone = made["isolation"] == "none"
    times = words(
        "{total} s on the clock; compiling {compile}, workers {submission} in all, "
        "grader {grader}, partly at once"
    )
    return [
        (words("grader"), made["grader"]),
        (words("seed"), str(made["seed"])),
        (words("compiler"), " ".join([made["compiler"], *made["flags"]])),
        (words("isolation"), words("none") if alone else made["isolation"]),
        (words("processor"), made["cpu"]),
        (words("time"), times.format(**{key: f"{spent[key]:.1f}" for key in TIMES})),
        (words("file"), f"SHA-256 {result['submission']['sha256'] or '-'}"),
        (words("rubric"), f"SHA-256 {made['rubric_sha256']}"),
        (words("scenes"), f"SHA-256 {made['scenes_sha256']}"),
    ]


TIMES: Sequence[str] = ("total", "compile", "submission", "grader")


def script_words(words: Words) -> dict[str, str]:
    """Return what the page's script says."""
    return {
        "box": words("box of node {node}"),
        "triangle": words("triangle of face {face}"),
        "unknown": words("a box or triangle that is not in the tree"),
        "hit": words("hit"),
        "missed": words("missed"),
        "lost": words("here the hit is lost"),
        "deep": words("deeper than the boxes that are kept here"),
        "outcome": words("expected t = {expected}, got t = {got}"),
        "none": words("no hit"),
        "group": words(","),
        "coarse": words("shown with {faces} faces"),
        "wrong": words(
            "The box of node {node} is wrong: red is what was built, dashed green what it "
            "should be"
        ),
        "node": words("Something is wrong with node {node}"),
        "step": words("step {step} of {steps}"),
    }
