"""How does a result read in another language, before any format is made from it?

`result.json` is English, so that it is the same for everybody. Formats translate what they say
themselves; what the checks found, why a file was refused, and our remarks are translated here.
"""

from collections.abc import Mapping
from typing import Any

from grader.language import Words
from grader.report.as_json import Json
from grader.report.counts import teller


def in_language(result: Json, language: str) -> Json:
    """Return a result whose checks tell in a language what they found; the given one stays.

    Args:
        result: Values of a `result.json`.
        language: `en` or `de`.
    """
    told = teller(language)

    def words(given: Json) -> Json:
        return given | {name: told(given[name]) for name in ("message", "expected", "got")}

    checks = [
        words(one) | {"examples": [words(each) for each in one["examples"]]}
        for one in result["checks"]
    ]
    build = result["build"] | {"diagnostics": messages(result, told)}
    return result | {"checks": checks, "build": build}


def messages(result: Mapping[str, Any], told: Words) -> list[Json]:
    """Return what is said of the build, with our own words told; a compiler's stay.

    Args:
        result: Values of a `result.json`.
        told: Tells our messages in a language.
    """
    refused = result["submission"]["sha256"] is None
    return [
        one | {"text": told(one["text"])} if refused or _is_remark(one) else one
        for one in result["build"]["diagnostics"]
    ]


def _is_remark(message: Json) -> bool:
    return bool(message["severity"] == "note" and not message["line"])
