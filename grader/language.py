"""In which language is a message told? Catalogues in gettext's format, read without its tools.

The English text is the key, as gettext has it. `grader/locale/de.po` lies in the package as it
is edited; reading it takes some milliseconds, so nobody compiles it. Words of submissions and
of compilers are never looked up.
"""

import ast
import os
from collections.abc import Callable, Mapping
from functools import cache
from importlib.resources import files

LANGUAGES = ("en", "de")

Words = Callable[[str], str]
"""From an English text to the text that is shown."""


def translator(language: str) -> Words:
    """Return what translates English texts; those that the catalogue lacks stay English."""
    known = {} if language == "en" else catalogue(language)
    return lambda text: known.get(text, text)


def usual_language(environment: Mapping[str, str] = os.environ) -> str:
    """Choose a language as gettext does: by LC_ALL, else LC_MESSAGES, else LANG."""
    for name in ("LC_ALL", "LC_MESSAGES", "LANG"):
        if locale := environment.get(name):
            language = locale.partition("_")[0].partition(".")[0].lower()
            return language if language in LANGUAGES else "en"
    return "en"


@cache
def catalogue(language: str, context: str = "") -> Mapping[str, str]:
    """Read the catalogue of a language: English text to translation.

    Args:
        language: Not English.
        context: `check` for what checks found; empty for what reports say of it.
    """
    path = files("grader").joinpath("locale", f"{language}.po")
    return parsed(path.read_text(encoding="utf-8"), context)


def parsed(text: str, context: str = "") -> dict[str, str]:
    """Read the entries of a context, each with `msgid` and `msgstr` of one or more strings."""
    entries: list[dict[str, str]] = []
    keyword = known = ""
    for line in map(str.strip, text.splitlines()):
        if line.startswith("msgctxt "):
            known = ast.literal_eval(line.removeprefix("msgctxt "))
        elif line.startswith("msgid "):
            entries.append({"context": known, "msgid": "", "msgstr": ""})
            known = ""
        if line.startswith(("msgid ", "msgstr ")):
            keyword, _, line = line.partition(" ")
        if line.startswith('"'):
            entries[-1][keyword] += ast.literal_eval(line)
    found = [each for each in entries if each["context"] == context and each["msgid"]]
    return {each["msgid"]: each["msgstr"] for each in found}
