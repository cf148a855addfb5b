"""How does a result read in another language, before any format is made from it?

`result.json` is English, so that it is the same for everybody. Formats translate what they say
themselves; what the checks found is translated here.
"""

from grader.phrases import teller
from grader.report.as_json import Json


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
    return result | {"checks": checks}
